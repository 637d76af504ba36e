"""`thinkblox render`: draw a scene."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.cli.options import seconds, whole
from thinkblox.cli.terminal import say

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands

STATUS = "exit status: 0 drawn; 2 the scene cannot be used; 70 a fault of ours; 130 stopped"


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    parser = commands.add_parser("render", help="draw preview.png and top.png of a scene", epilog=STATUS)
    parser.add_argument("scene", metavar="SCENE", type=Path, help="an output folder or a scene.json")
    parser.add_argument("--out", metavar="DIR", type=Path, help="folder for the pictures (that of the scene)")
    parser.add_argument("--size", metavar="PX", type=_picture_size, default=1024, help="pixels along a side (1024)")
    parser.add_argument(
        "--timeout", metavar="S", type=seconds, default=600.0, help="for reading and drawing (600), once started"
    )
    parser.add_argument("--json", action="store_true", help="print the paths as JSON")
    parser.set_defaults(run=_render)


def _picture_size(text: str) -> int:
    return whole(text, 64, 8192)


def _drawn(scene: str, size: int) -> dict[str, bytes]:
    from thinkblox.exporters.saving import draw_pictures
    from thinkblox.scene.scene import load_scene

    return draw_pictures(load_scene(scene), size=size)


def _render(arguments: argparse.Namespace) -> int:
    import json

    from thinkblox.exporters.folder import check_pictures
    from thinkblox.sim.workers.guard import guarded

    home = arguments.scene if arguments.scene.is_dir() else arguments.scene.parent
    check_pictures(arguments.out or home)
    pictures = guarded(
        _drawn, str(arguments.scene), arguments.size, seconds=arguments.timeout, doing=f"drawing {arguments.scene}"
    )
    from thinkblox.exporters.saving import write_pictures

    paths = write_pictures(pictures, arguments.out or home)
    if arguments.json:
        print(json.dumps([str(path) for path in paths]))
    else:
        say("\n".join(f"written to {path}" for path in paths))
    return 0
