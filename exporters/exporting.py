"""Scenes as files of other programs: one file by its ending, or a folder of several formats; whole or not at all."""

import os
from collections.abc import Sequence
from pathlib import Path

from thinkblox.errors import InputError
from thinkblox.exporters.folder import check_folder, made_parents, whole_folder
from thinkblox.exporters.formats import DEFAULT, flavored, format_for, formats_named
from thinkblox.exporters.saving import THUMBS, FolderWriting, thumbnail
from thinkblox.given import names_given
from thinkblox.holding import note_placed, signals_held
from thinkblox.scene.asset_files import asset_files
from thinkblox.scene.scene import Scene, scene_given
from thinkblox.value import read_json, to_json
from thinkblox.whole_file import check_name, check_writable
from thinkblox.workplace import workplace

_STAGES = (".usda", ".usdc")
_OF_ROOMS = ("report.json", "trace.jsonl")
"""What a room has that no export writes."""


def export_file(scene: Scene, path: str | Path, *, doors: bool = False, overwrite: bool = False) -> Path:
    """Write a scene as one file, in the format that its ending tells; returns its path.

    The meshes and textures that a format needs are put into `assets` beside it, by their content.

    Args:
        scene: any.
        path: such as "room.xml", "room.usdz" or "room.glb"; a ".usd" is binary from 21 objects on.
        doors: as of `export_scene`.
        overwrite: replace a file that is there.

    Raises:
        InputError: no format's file ends so; a file is there, without `overwrite`; a mesh or texture of an asset is
            gone; or it cannot be written, and then nothing is.
    """
    path = Path(path)
    kind = format_for(path)
    check_name(path)
    if os.path.lexists(path) and (path.is_symlink() or not path.is_file()):
        raise InputError(f"{path}: is there and is no file; choose another name")
    if path.exists() and not overwrite:
        raise InputError(f"{path}: is there already; choose another name, or ask for it to be overwritten")
    check_writable(path)
    asset_files(scene.assets.values())
    from thinkblox.exporters.stocktaking import inventory_of

    try:
        with made_parents(path), workplace(path) as work:
            kind.write(inventory_of(scene, doors=doors), work / path.name)
            _put_in_place(work, path)
    except OSError as error:
        raise InputError(f"{error.filename or path}: cannot be written: {error.strerror}") from error
    return path


def _put_in_place(work: Path, path: Path) -> None:
    """Move what was made to where it belongs, the file itself last; after a failure what came is taken away again."""
    placed: list[Path] = []
    made = sorted(file.relative_to(work) for file in work.rglob("*") if file.is_file())
    if Path(path.name) not in made:
        raise InputError(f"{path}: the format wrote no file of that name")
    try:
        with signals_held():
            for name in (*(name for name in made if name != Path(path.name)), Path(path.name)):
                target = path.parent / name
                target.parent.mkdir(exist_ok=True)
                if not target.exists():
                    placed.append(target)
                elif target != path:
                    continue  # its name is its content
                (work / name).replace(target)
            note_placed(path)
    except OSError:
        for target in placed:
            target.unlink(missing_ok=True)
        if (path.parent / "assets").is_dir() and not any((path.parent / "assets").iterdir()):
            (path.parent / "assets").rmdir()
        raise


def export_scene(
    scene: Scene,
    out: str | Path,
    *,
    formats: Sequence[str] = DEFAULT,
    flavor: str | None = None,
    doors: bool = False,
    thumbnails: bool = False,
    overwrite: bool = False,
) -> Path:
    """Write a scene in several formats to the folder `out`, with its scene.json and a manifest; returns its path.

    Nothing is verified again, and no pictures are drawn but thumbnails: `save_scene` does both.

    Args:
        scene: any.
        out: the folder, made together with its parents.
        formats: names of export formats.
        flavor: of those formats that have it: "robosuite" or "mjx", of "mjcf".
        doors: with leaves on hinges in its doors, and panes in its windows, which what was measured has not.
        thumbnails: of USD stages, where viewers of such files look for them.
        overwrite: replace a folder that we wrote there earlier.

    Raises:
        InputError: as of `save_scene`; a flavor that none of the formats has; or `out` holds this very scene with its
            report, which an export has none of.
    """
    scene, chosen = scene_given(scene), formats_named(flavored(names_given(formats, "formats"), flavor))
    check_folder(out, overwrite=overwrite)
    _check_no_room_of(scene, Path(out))
    beside = asset_files(scene.assets.values())
    with whole_folder(out, overwrite=overwrite) as room:
        from thinkblox.exporters.stocktaking import inventory_of

        inventory, writing = inventory_of(scene, doors=doors), FolderWriting(room)
        writing.add("scene.json", to_json(scene), "scene", "the room, every placement and every asset")
        for name, data in beside.items():
            writing.add(name, data, "asset")
        for kind in chosen:
            writing.export(kind, inventory)
        if thumbnails and (stages := [kind.file for kind in chosen if kind.suffix in _STAGES]):
            picture = thumbnail(scene, inventory.state)
            for name in stages:
                writing.add(f"{THUMBS}/{name}.png", picture, "picture", f"a small picture for {name}")
        writing.finish(inventory, chosen)
    return Path(out)


def _check_no_room_of(scene: Scene, out: Path) -> None:
    """Make sure that a scene's export takes the place of no room of it, which holds more than can be written anew."""
    kept = [name for name in _OF_ROOMS if (out / name).is_file()]
    if kept and read_json(out / "scene.json", Scene) == scene:
        raise InputError(
            f"{out}: is the room itself, and an export would take away its {', '.join(kept)}; choose another folder"
        )
