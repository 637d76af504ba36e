"""`thinkblox export`: a scene as files of other programs."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.cli.terminal import say

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands

STATUS = "exit status: 0 written; 2 the scene cannot be used, or nothing can be written there; 70 a fault of ours"


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    from thinkblox.exporters.formats import DEFAULT, formats

    parser = commands.add_parser("export", help="write a scene as MJCF, USD, glTF, URDF or SDF", epilog=STATUS)
    parser.add_argument("scene", metavar="SCENE", type=Path, help="an output folder or a scene.json")
    names = f"formats, any of {', '.join(known.name for known in formats())} ({','.join(DEFAULT)})"
    parser.add_argument("--to", metavar="A,B", default=",".join(DEFAULT), help=names)
    parser.add_argument("--out", metavar="DIR", type=Path, required=True, help="folder for the files, which is made")
    parser.add_argument("--flavor", metavar="NAME", help="of the MJCF: robosuite (its groups and sites) or mjx")
    parser.add_argument("--doors", action="store_true", help="with leaves on hinges in the doors, panes in the windows")
    parser.add_argument("--thumbnails", action="store_true", help="small pictures of USD stages, for viewers of files")
    parser.add_argument("--overwrite", action="store_true", help="replace a folder that we wrote there earlier")
    parser.add_argument("--json", action="store_true", help="print the paths as JSON")
    parser.set_defaults(run=_export)


def _export(arguments: argparse.Namespace) -> int:
    import json

    from thinkblox.errors import InputError
    from thinkblox.exporters.exporting import export_scene
    from thinkblox.exporters.formats import flavored, formats_named
    from thinkblox.scene.scene import load_scene

    names = [name.strip() for name in arguments.to.split(",") if name.strip()]
    if not names:
        raise InputError("no format is named; --to mjcf,usd writes both")
    chosen = formats_named(flavored(names, arguments.flavor))
    scene = load_scene(arguments.scene)
    out = export_scene(
        scene, arguments.out, formats=names, flavor=arguments.flavor, doors=arguments.doors,
        thumbnails=arguments.thumbnails, overwrite=arguments.overwrite,
    )  # fmt: skip
    paths = [out / kind.file for kind in chosen]
    if arguments.json:
        print(json.dumps([str(path) for path in paths]))
    else:
        say("\n".join(f"written to {path}" for path in paths))
    return 0
