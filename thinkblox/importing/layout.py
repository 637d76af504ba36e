"""A layout of another generator as one of our scenes."""

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from thinkblox.errors import InputError
from thinkblox.importing.body import ItemBody, body_of
from thinkblox.importing.ceiling import assumed_height, corded
from thinkblox.importing.document import Document, plain, read_document
from thinkblox.importing.doubts import doubts
from thinkblox.importing.draft import Item, LayoutDraft
from thinkblox.importing.formats import FORMATS
from thinkblox.importing.holodeck import read_holodeck
from thinkblox.importing.idesign import read_idesign
from thinkblox.importing.il3d import read_il3d
from thinkblox.importing.layoutgpt import read_layoutgpt
from thinkblox.importing.layoutvlm import read_layoutvlm
from thinkblox.importing.library import Library
from thinkblox.importing.mounting import mounts_of
from thinkblox.importing.outline import origin_of, room_of
from thinkblox.importing.rugs import off_rugs
from thinkblox.importing.sceneeval import read_sceneeval
from thinkblox.importing.signatures import detect
from thinkblox.importing.sizes import Sizes, read_sizes, size_in
from thinkblox.scene.asset import Mount
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import MAX_PLACEMENTS, Scene
from thinkblox.value import Value, Vec3

FRONTS = (
    "Whether what hangs on a wall has its front to the room is not judged: no layout says that its meshes face"
    " the way its format wants."
)

RENAMED = 5
"""How many ids that are not the layout's own names are told."""
_MEANT_FOR = {
    "room": ("holodeck", "layoutgpt", "sceneeval"),
    "short_side": ("layoutgpt",),
    "room_size": ("idesign", "metaspatial"),
}
"""The formats that know each of these options."""


class ForeignLayout(Value, frozen=True, kw_only=True):
    """What was read.

    Attributes:
        scene: the room with its objects, at the poses of the layout.
        format: whose layout it is, one of FORMATS.
        substituted: ids of objects that are measured as boxes, for want of a mesh.
        unplaced: names of objects that the layout lists without a pose.
        notes: what a reader should know besides, in sentences.
    """

    scene: Scene
    format: str
    substituted: tuple[str, ...] = ()
    unplaced: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def read_layout(
    path: str | Path,
    *,
    format: str | None = None,
    assets: str | Path | None = None,
    height: float | None = None,
    room: str | None = None,
    short_side: float | None = None,
    sizes: str | Path | None = None,
    room_size: Sequence[float] | None = None,
) -> ForeignLayout:
    """Read a layout of another generator.

    Args:
        path: its JSON file.
        format: one of FORMATS; None to tell by its keys.
        assets: the folder with the meshes and annotations that it names; those beside the file are found without.
        height: of the room where the layout has none [m]; None for the usual one, or more where something is higher.
        room: which one, of a file that holds several: a room's id, or LayoutGPT's query_id.
        short_side: of the room, for a layout in pixels [m].
        sizes: a JSON file that maps names of objects to (along the front, across, up) [m]; it goes before the layout's.
        room_size: (east, north) or (east, north, up) of the room [m], for a scene graph without walls.

    Raises:
        InputError: the file is not such a layout, or what it says cannot be; names file and JSON path.
    """
    path = Path(path)
    document = read_document(path)
    name = _format_of(document, format)
    _check_options(path, assets, height, short_side)
    given = {"room": room, "short_side": short_side, "room_size": room_size}
    roots = ((Path(assets),) if assets is not None else ()) + (path.absolute().parent,)
    library = Library(roots=roots, sizes=read_sizes(Path(sizes)) if sizes is not None else {})
    draft = _draft(document, name, library, room, short_side, _room_size(room_size))
    unused = _unused(name, given, draft, height, library.sizes)
    return _layout(document, replace(_sized(draft, library), notes=(*unused, *draft.notes)), name, height)


def _format_of(document: Document, format: str | None) -> str:
    if format is None:
        try:
            return detect(document.raw)
        except InputError as error:
            raise InputError(f"{document.path}: {error}") from error
    if format not in FORMATS:
        raise InputError(f"no layout format {format!r}; there are {', '.join(FORMATS)}")
    return format


def _check_options(path: Path, assets: str | Path | None, height: float | None, short_side: float | None) -> None:
    if assets is not None and not Path(assets).is_dir():
        raise InputError(f"{assets}: is no folder; name the one that holds the meshes of {path.name}")
    if height is not None and not 1.5 <= height <= 50.0:
        raise InputError(f"a room {height:g} m high; it must be 1.5 to 50 m")
    if short_side is not None and not 0.5 <= short_side <= 100.0:
        raise InputError(f"a room whose short side is {short_side:g} m; it must be 0.5 to 100 m")


def _room_size(size: Sequence[float] | None) -> Sequence[float] | None:
    if size is not None and (len(size) not in (2, 3) or not all(0.5 <= length <= 100.0 for length in size)):
        raise InputError(f"a room of {' x '.join(map(str, size))} m; give two or three lengths of 0.5 to 100 m")
    return size


def _unused(
    format: str, given: Mapping[str, object], draft: LayoutDraft, height: float | None, sizes: Sizes
) -> tuple[str, ...]:
    """Notes on what was given to read a layout and changed nothing."""
    notes = [
        f"The option {name.replace('_', '-')} was not used: it is for {' and '.join(_MEANT_FOR[name])}, not {format}."
        for name, value in given.items()
        if value is not None and format not in _MEANT_FOR[name]
    ]
    if height is not None and draft.outline.height is not None:
        notes.append(f"The option height was not used: the layout says {draft.outline.height:.4g} m.")
    # SceneEval puts the library before the name, and its reader looks for what follows.
    if sizes and not any(size_in(sizes, *_names(item), item.sought.partition(".")[2]) for item in draft.items):
        notes.append("The table of sizes was not used: it names nothing that the layout places.")
    return tuple(notes)


def _sized(draft: LayoutDraft, library: Library) -> LayoutDraft:
    """The draft with the sizes of the user's own table."""
    return replace(draft, items=tuple(_given(item, library.sizes) for item in draft.items))


def _given(item: Item, sizes: Sizes) -> Item:
    size = size_in(sizes, *_names(item))
    if size is None:
        return item
    x, y, z = (length * factor for length, factor in zip(size, item.scale, strict=True))
    return replace(item, size=(x, y, z))


def _names(item: Item) -> tuple[str, ...]:
    """By which a table of sizes may speak of it."""
    return (item.name, item.called, item.kind, item.sought)


def _draft(
    document: Document,
    format: str,
    library: Library,
    room: str | None,
    short_side: float | None,
    room_size: Sequence[float] | None,
) -> LayoutDraft:
    if format == "layoutgpt":
        return read_layoutgpt(document, room=room, short_side=short_side)
    if format == "holodeck":
        return read_holodeck(document, library, room=room)
    if format == "sceneeval":
        return read_sceneeval(document, library, room=room)
    if format == "il3d":
        return read_il3d(document, library)
    if format == "layoutvlm":
        return read_layoutvlm(document, library)
    return read_idesign(document, library, room_size=room_size)


def _layout(document: Document, draft: LayoutDraft, format: str, height: float | None) -> ForeignLayout:
    _check_items(document, draft.items)
    shift = origin_of(draft.outline)
    bodies = [body_of(document, _shifted(item, shift)) for item in draft.items]
    known = draft.outline.height if draft.outline.height is not None else height
    up = assumed_height(bodies) if known is None else known
    room, notes = room_of(document, draft.outline, height=up)
    mounts = mounts_of(room, bodies, ceiling=known is not None)
    if known is None:
        notes = (f"The room's height is not in the file; it was taken to be {up:.4g} m.", *notes)
        bodies = [corded(b, up) if m == "ceiling" else b for b, m in zip(bodies, mounts, strict=True)]
    if "wall" in mounts:
        notes = (*notes, FRONTS)
    ids = _ids(room, draft.items)
    bodies, lowered = off_rugs(bodies, mounts)
    if lowered:
        names = ", ".join(ids[k] for k in lowered[:RENAMED]) + (" and more" if len(lowered) > RENAMED else "")
        notes = (*notes, f"On a rug, which nothing collides with, and so measured on the floor under it: {names}.")
    return ForeignLayout(
        scene=_scene(document, room, bodies, ids, mounts, plain(draft.prompt)),
        format=format,
        substituted=tuple(id for id, body in zip(ids, bodies, strict=True) if body.boxed),
        unplaced=tuple(plain(name) for name in draft.unplaced),
        notes=(
            *doubts(room, draft.items, bodies, shift),
            *draft.notes,
            *notes,
            *_renamed(draft.items, ids),
            *(note for body in bodies for note in body.notes),
        ),
    )


def _check_items(document: Document, items: Sequence[Item]) -> None:
    if len(items) > MAX_PLACEMENTS:
        document.fail("$", f"{len(items)} objects; at most {MAX_PLACEMENTS} are read")
    seen: dict[str, str] = {}
    for item in items:
        if item.name in seen:
            document.fail(item.at, f"a second object {plain(item.name)!r}, as at `{seen[item.name]}`; ids must differ")
        seen[item.name] = item.at


def _shifted(item: Item, shift: Vec3) -> Item:
    x, y, z = (p + s for p, s in zip(item.position, shift, strict=True))
    return replace(item, position=(x, y, z))


def _ids(room: Room, items: Iterable[Item]) -> list[str]:
    """Ids for the names: letters, digits, dots and dashes kept, the rest underscores; all different."""
    taken = {"floor", "ceiling"} | {wall.name for wall in room.walls} | {opening.id for opening in room.openings}
    ids = []
    for item in items:
        name = unicodedata.normalize("NFKD", item.name).encode("ascii", "ignore").decode() or item.name
        stem = re.sub(r"[^A-Za-z0-9_.-]+", "_", name[:100]).strip("_.-")
        stem = stem if stem[:1].isalpha() else f"object_{stem}".rstrip("_")
        id, number = stem, 2
        while id in taken:
            id, number = f"{stem}_{number}", number + 1
        taken.add(id)
        ids.append(id)
    return ids


def _renamed(items: Sequence[Item], ids: Sequence[str]) -> tuple[str, ...]:
    """Which ids do not show by themselves whose they are, in a sentence."""
    pairs = [
        f"{plain(item.name)[:40]!r} is {id[:40]}"
        for item, id in zip(items, ids, strict=True)
        if [c for c in item.name if c.isalnum()] != [c for c in id if c.isalnum()]
    ]
    if not pairs:
        return ()
    more = f", and {len(pairs) - RENAMED} more" if len(pairs) > RENAMED else ""
    return (f"Called otherwise here: {', '.join(pairs[:RENAMED])}{more}.",)


def _scene(
    document: Document, room: Room, bodies: Sequence[ItemBody], ids: Sequence[str], mounts: Sequence[Mount], prompt: str
) -> Scene:
    assets = [body.asset(document, mount) for body, mount in zip(bodies, mounts, strict=True)]
    placements = tuple(
        Placement(
            id=id,
            category=asset.category,
            asset=asset.id,
            position=body.position,
            yaw=body.yaw,
            size=asset.size,
        )
        for id, body, asset in zip(ids, bodies, assets, strict=True)
    )
    return Scene(room=room, prompt=prompt, placements=placements, assets={asset.id: asset for asset in assets})
