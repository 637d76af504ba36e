"""Saving any scene, generated or edited, with its report, its formats and its pictures."""

import re
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.errors import InputError
from thinkblox.exporters.credits import credits_of
from thinkblox.exporters.folder import check_folder, made_parents, sweep_pictures, whole_folder
from thinkblox.exporters.formats import DEFAULT, ExportFormat, formats_named
from thinkblox.exporters.manifest import MANIFEST, PICTURES, FileKind, Manifest, ManifestFile
from thinkblox.holding import note_placed, signals_held
from thinkblox.png import png_of
from thinkblox.scene.asset_files import asset_files
from thinkblox.scene.scene import Scene, scene_given
from thinkblox.value import to_json
from thinkblox.verdict import Report
from thinkblox.whole_file import write_whole
from thinkblox.workplace import workplace

if TYPE_CHECKING:
    from PIL.Image import Image

    from thinkblox.exporters.inventory import Inventory
    from thinkblox.sim.verdict.settle import SettledState

_EXTRA = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,99}")


def save_scene(
    scene: Scene,
    out: str | Path,
    report: Report | None = None,
    *,
    formats: Sequence[str] = DEFAULT,
    pictures: bool = True,
    overwrite: bool = False,
    extra: Mapping[str, bytes] | None = None,
) -> Path:
    """Write a scene to the folder `out` with all its files; returns its path.

    The files are written beside it first and then moved into place, so that `out` is complete or, after any failure
    or interruption, as it was before.

    Args:
        scene: any: generated, edited, mended, or changed by hand.
        out: the folder, made together with its parents.
        report: what was measured of this very scene; the scene is verified when there is none.
        formats: names of export formats, as `thinkblox.exporters.formats` lists them.
        pictures: with preview.png and top.png.
        overwrite: replace a room that we wrote there earlier.
        extra: more files, by name, that are kept with the room as they are.

    Raises:
        InputError: `out` cannot be written, or is a file or a folder that is not one of ours, or one of ours without
            `overwrite`; a format that does not exist; a report on other objects; an extra file whose name is taken;
            a mesh or texture that nobody has loaded.
    """
    scene, chosen, extra = scene_given(scene), formats_named(formats), dict(extra or {})
    _check_report(scene, report)
    for name in extra:
        _check_extra(name, chosen)
    check_folder(out, overwrite=overwrite)
    beside = asset_files(scene.assets.values())
    with whole_folder(out, overwrite=overwrite) as room:
        from thinkblox.exporters.stocktaking import inventory_of

        inventory = inventory_of(scene)
        writing = FolderWriting(room)
        writing.add("scene.json", to_json(scene), "scene", "the room, every placement and every asset")
        for name, data in beside.items():
            writing.add(name, data, "asset")
        checked = report or _verified(inventory)
        writing.add("report.json", to_json(checked), "report", "what was measured of each object and of the whole")
        for kind in chosen:
            writing.export(kind, inventory)
        for name, data in extra.items():
            writing.add(name, data, "extra")
        if pictures:
            says = ("a three-quarter view", "a plan with names")
            for (name, data), what in zip(_drawn(scene, inventory.state).items(), says, strict=True):
                writing.add(name, data, "picture", what)
        writing.finish(inventory, chosen)
    return Path(out)


def save_pictures(scene: Scene, out: str | Path, *, size: int = 1024) -> tuple[Path, ...]:
    """Write preview.png and top.png of a scene, `size` pixels square, into the folder `out`; returns their paths.

    Raises:
        InputError: the folder cannot be written.
    """
    return write_pictures(draw_pictures(scene, size=size), Path(out))


def draw_pictures(scene: Scene, *, size: int = 1024) -> dict[str, bytes]:
    """preview.png and top.png of a scene as it rests, `size` pixels square, by name."""
    from thinkblox.sim.verdict.settle import settle

    return _drawn(scene, settle(scene), size)


def write_pictures(pictures: Mapping[str, bytes], out: Path) -> tuple[Path, ...]:
    """Write what `draw_pictures` drew into the folder `out`, which is made; returns their paths.

    Raises:
        InputError: the folder cannot be written.
    """
    try:
        with made_parents(out / PICTURES[0]):
            sweep_pictures(out)
            with workplace(out / PICTURES[0]) as work:
                for name, data in pictures.items():
                    (work / name).write_bytes(data)
                _put_pictures(work, out, tuple(pictures))
    except OSError as error:
        raise InputError(f"{error.filename or out}: cannot be written: {error.strerror}") from error
    return tuple(out / name for name in pictures)


def _put_pictures(work: Path, out: Path, names: Sequence[str]) -> None:
    with signals_held():
        for name in names:
            (work / name).replace(out / name)
            note_placed(out / name)


def write_scene(scene: Scene, path: Path) -> None:
    """Write a scene as one scene.json, with the meshes and textures that it names beside it, if there are any.

    Raises:
        InputError: it cannot be written, or a mesh or texture is not known.
    """
    write_files(scene_files(scene, path.name), path.parent)


def scene_files(scene: Scene, name: str) -> dict[str, bytes]:
    """A scene as the file `name`, after the meshes and textures that it needs beside it, by relative path.

    Raises:
        InputError: a mesh or texture is not known.
    """
    return {**asset_files(scene.assets.values()), name: to_json(scene)}


def write_files(files: Mapping[str, bytes], home: Path) -> None:
    """Write files of a scene into a folder, each whole or not at all, the last one last; raises InputError."""
    for name, data in files.items():
        file = home / name
        if file.parent != home:
            try:
                file.parent.mkdir(exist_ok=True)
            except OSError as error:
                raise InputError(f"{file.parent}: cannot be made: {error.strerror}") from error
        write_whole(file, data)


def _check_report(scene: Scene, report: Report | None) -> None:
    if report is None:
        return
    ids = {placement.id for placement in scene.placements}
    other = sorted(ids ^ {verdict.id for verdict in report.objects})
    if other:
        raise InputError(
            f"the report is not on this scene: only one of the two has {', '.join(other[:5])}; leave it out, and the"
            " scene is verified"
        )


def _check_extra(name: str, chosen: Sequence[ExportFormat]) -> None:
    taken = {"scene.json", "report.json", MANIFEST, *PICTURES, *(kind.file for kind in chosen)}
    if not _EXTRA.fullmatch(name) or name.lower() in taken:
        raise InputError(f"an extra file cannot be called {name!r}; use a plain name that no other file has")


def _verified(inventory: "Inventory") -> Report:
    from thinkblox.sim.verdict.verify import verify

    return verify(inventory.scene, physics=inventory.physics, state=inventory.state)


def _drawn(scene: Scene, settled: "SettledState", size: int = 1024) -> dict[str, bytes]:
    from thinkblox.sim.render import render_preview, render_top

    def drawn(render: Callable[..., "Image"]) -> bytes:
        return png_of(render(scene, size=size, poses=settled.poses))

    # Each waits for itself now and then, which is when the other is drawn.
    with ThreadPoolExecutor() as painters:
        return dict(zip(PICTURES, painters.map(drawn, (render_preview, render_top)), strict=True))


THUMBS, _SMALL = ".thumbs/256x256", 256
"""Where viewers of USD look for small pictures of files, and how wide and high these are [pixels]."""


def thumbnail(scene: Scene, settled: "SettledState") -> bytes:
    """A small picture of a scene as it rests, as PNG."""
    from thinkblox.sim.render import render_preview

    return png_of(render_preview(scene, size=_SMALL, poses=settled.poses))


class FolderWriting:
    """A folder being filled, and what its manifest will say of it."""

    def __init__(self, room: Path) -> None:
        self._room = room
        self._files: dict[str, ManifestFile] = {}

    def add(self, name: str, data: bytes, kind: FileKind, says: str = "") -> None:
        """Write one file; raises InputError when a format has written one of that name."""
        if name in self._files:
            raise InputError(f"an extra file cannot be called {name!r}: a format has written that file")
        file = self._room / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(data)
        self._files[name] = ManifestFile(name=name, kind=kind, says=says)

    def found(self, kind: FileKind, says: Mapping[str, str], format: str | None = None) -> None:
        """Take account of the files that came since; `says` by name."""
        every = (path for path in self._room.rglob("*") if not path.is_dir())
        for name in sorted(path.relative_to(self._room).as_posix() for path in every):
            if name not in self._files:
                self._files[name] = ManifestFile(name=name, kind=kind, format=format, says=says.get(name, ""))

    def export(self, format: ExportFormat, inventory: "Inventory") -> None:
        """Write one format; raises InputError when its writer did not write its file, or changed one that was there."""
        before = {name: self._state(name) for name in self._files}
        format.write(inventory, self._room / format.file)
        for name, state in before.items():
            if self._state(name) != state:
                raise InputError(f"the format {format.name!r} changed {name}, which is not its own")
        if not (self._room / format.file).is_file():
            raise InputError(f"the format {format.name!r} wrote no {format.file}; its writer is given that path")
        self.found("format", {format.file: format.says}, format.name)

    def _state(self, name: str) -> tuple[int, ...]:
        """What changes when a file is written again; nothing for one that is gone."""
        try:
            found = (self._room / name).stat()
        except FileNotFoundError:
            return ()
        return (found.st_ino, found.st_size, found.st_mtime_ns)

    def finish(self, inventory: "Inventory", chosen: Sequence[ExportFormat]) -> None:
        """Write the manifest."""
        from thinkblox.sim.build import package_version

        manifest = Manifest(
            thinkblox=package_version(),
            files=tuple(self._files.values()),
            formats=tuple(kind.name for kind in chosen),
            credits=credits_of(inventory.scene),
        )
        (self._room / MANIFEST).write_bytes(to_json(manifest))
