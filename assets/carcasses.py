"""Cabinets: a box of boards divided into bays of open shelves, drawers and doors that really open."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from msgspec import structs

from thinkblox.assets.palette import GLASS, IRON, STEEL
from thinkblox.assets.part import Build, Finish, MovingParts, Part, Range
from thinkblox.assets.shapes import around, box, inner_surface, leg, panel, top_surface
from thinkblox.assets.sizing import counted
from thinkblox.assets.spec import Spec
from thinkblox.scene.asset import Joint, Surface

BOARD = 0.018
"""Thickness of boards, doors and drawer fronts [m]."""
GAP = 0.002
"""Free space about what moves [m]."""
HANDLE = 0.022
"""How far a handle stands out [m]."""


@dataclass(frozen=True)
class Cell:
    """One opening of a bay.

    Attributes:
        kind: "door" is hinged at the outer side, "glass" a glazed one, "flap" is hinged at the bottom.
        weight: its share of the bay's height.
        shelves: boards inside.
        shows: whether things can be put on its floor and boards though a door is before them.
    """

    kind: Literal["open", "drawer", "door", "glass", "flap"]
    weight: float = 1.0
    shelves: int = 0
    shows: bool = False


@dataclass(frozen=True)
class _Face:
    """Where one cell's front is: inside front plane x, clear ranges, and finishes."""

    x: Range
    y: Range
    z: Range
    finish: Finish
    handle: Finish
    name: str


def cabinet(
    spec: Spec,
    bays: Sequence[Sequence[Cell]],
    *,
    plinth: float = 0.0,
    legs: float = 0.0,
    worktop: Finish | None = None,
    finish: Finish | None = None,
    fronts: Finish | None = None,
) -> Build:
    """Return a cabinet that fills the spec's box: `bays` from right (-y) to left, cells from the bottom up.

    It stands on a recessed `plinth` or on feet `legs` high [m]; a `worktop` is thicker and stands over the front.
    """
    x, y, z = spec.size
    bays = _as_asked(spec, bays)
    finish = finish or spec.paint
    top_z = z - (0.034 if worktop else 0.0)
    edge = x / 2 - (0.004 if worktop else 0.0)
    build = cabinet_parts(
        spec, (-x / 2, edge), (-y / 2, y / 2), (legs, top_z), bays, plinth=plinth, finish=finish, fronts=fronts
    )
    if worktop:
        build.body.append(box(worktop, (-x / 2, x / 2), (-y / 2, y / 2), (top_z, z)))
    if legs:
        build.body += _feet(spec, legs)
    reach = x / 2 if worktop or not _closed(bays) else x / 2 - HANDLE
    build.surfaces.insert(
        len(build.surfaces) if z > 1.4 else 0, top_surface("top", (-x / 2, reach), (-y / 2, y / 2), z)
    )
    build.surfaces.sort(key=lambda surface: surface.within)
    return build


def _as_asked(spec: Spec, bays: Sequence[Sequence[Cell]]) -> Sequence[Sequence[Cell]]:
    """The bays with as many drawers and doors as the words ask for, where they do."""
    drawers, doors = counted(spec.words, "drawer"), counted(spec.words, "door")
    if not (drawers or doors):
        return bays
    column = [Cell("drawer")] * drawers
    if doors:
        return [*([column] if drawers else []), *([[Cell("door", 1.0, 1)]] * doors)]
    if all(cell.kind == "drawer" for bay in bays for cell in bay) or len(bays) == 1:
        halves = len(bays) == 2 and drawers % 2 == 0
        return [[Cell("drawer")] * (drawers // 2)] * 2 if halves else [column]
    return [column, *([[Cell("open" if bay[0].kind == "open" else "door", 1.0, 1)] for bay in bays[1:]])]


def _closed(bays: Sequence[Sequence[Cell]]) -> bool:
    return any(cell.kind != "open" for bay in bays for cell in bay)


def _feet(spec: Spec, height: float) -> list[Part]:
    x, y = spec.size[0] / 2 - 0.055, spec.size[1] / 2 - 0.06
    finish = spec.style.wood if spec.rng.random() < 0.6 else spec.style.metal
    ends = [(sx * x - 0.02, sy * y) for sx in (-1, 1) for sy in (-1, 1)]
    return [leg(finish, at, at, (0, height), 0.022, 0.038) for at in ends]


def cabinet_parts(
    spec: Spec,
    x: Range,
    y: Range,
    z: Range,
    bays: Sequence[Sequence[Cell]],
    *,
    plinth: float = 0.0,
    finish: Finish | None = None,
    fronts: Finish | None = None,
) -> Build:
    """Return the boards, shelves, doors and drawers of a cabinet over three ranges [m]; handles end at x[1]."""
    finish = finish or spec.paint
    closed = _closed(bays)
    front = x[1] - (HANDLE + BOARD + GAP if closed else 0.0)
    build = Build(body=_box_of_boards(finish, (x[0], front), y, (z[0] + plinth, z[1])))
    if plinth:
        build.body.append(box(finish, (x[0], front - 0.05), (y[0] + 0.01, y[1] - 0.01), (z[0], z[0] + plinth)))
    width = (y[1] - y[0]) / len(bays)
    trays = all(cell.kind == "drawer" for bay in bays for cell in bay)
    for number, bay in enumerate(bays):
        span = (y[0] + number * width, y[0] + (number + 1) * width)
        if number:
            build.body.append(
                box(finish, (x[0] + 0.008, front), around(span[0], BOARD), (z[0] + plinth + BOARD, z[1] - BOARD))
            )
        left_hung = number % 2 == 1 or (len(bays) % 2 == 1 and number == len(bays) - 1 and number > 0)
        _fill_bay(
            build,
            spec,
            bay,
            (x[0], front, x[1]),
            span,
            (z[0] + plinth, z[1]),
            finish,
            fronts or finish,
            left_hung,
            number,
        )
    if trays:
        build.surfaces += [_in_drawer(moving) for moving in build.moving]
    return build


def _box_of_boards(finish: Finish, x: Range, y: Range, z: Range) -> list[Part]:
    inner = (y[0] + BOARD, y[1] - BOARD)
    return [
        box(finish, x, (y[0], y[0] + BOARD), z),
        box(finish, x, (y[1] - BOARD, y[1]), z),
        box(finish, x, inner, (z[0], z[0] + BOARD)),
        box(finish, x, inner, (z[1] - BOARD, z[1])),
        box(finish, (x[0], x[0] + 0.008), inner, (z[0] + BOARD, z[1] - BOARD)),
    ]


def _fill_bay(
    build: Build,
    spec: Spec,
    bay: Sequence[Cell],
    depth: tuple[float, float, float],
    y: Range,
    z: Range,
    finish: Finish,
    fronts: Finish,
    left_hung: bool,
    number: int,
) -> None:
    total = sum(cell.weight for cell in bay)
    low = z[0]
    back, front, outer = depth
    inner = (y[0] + BOARD, y[1] - BOARD)
    for index, cell in enumerate(bay):
        high = low + (z[1] - z[0]) * cell.weight / total
        clear = (low + BOARD / (1 if index == 0 else 2), high - BOARD / (1 if index == len(bay) - 1 else 2))
        if index:
            build.body.append(box(finish, (back + 0.008, front), inner, around(low, BOARD)))
        name = f"{cell.kind} {number + 1}.{index + 1}"
        shelves = _shelves(build, finish, cell, (back + 0.008, front), inner, clear)
        if cell.kind == "open" or cell.shows:
            build.surfaces += _named(shelves, name)
        if cell.kind != "open":
            if cell.kind in ("door", "glass") and not cell.shows:
                build.surfaces += [structs.replace(s, within=True) for s in _named(shelves, name)]
            face = _Face(
                (front + GAP, outer),
                (y[0] + GAP / 2, y[1] - GAP / 2),
                (low + GAP / 2, high - GAP / 2),
                fronts,
                STEEL if finish.material == "metal" else spec.style.metal,
                name,
            )
            build.moving.append(_front(cell, face, back, inner, clear, left_hung))
        low = high


def _shelves(
    build: Build, finish: Finish, cell: Cell, x: Range, y: Range, z: Range
) -> list[tuple[Range, Range, Range]]:
    """Add boards inside a cell; return the free boxes above each floor."""
    step = (z[1] - z[0] + BOARD) / (cell.shelves + 1)
    levels = [z[0] + k * step for k in range(cell.shelves + 1)]
    inset = 0.0 if cell.kind == "open" else 0.02
    for level in levels[1:]:
        build.body.append(box(finish, (x[0], x[1] - inset), y, (level - BOARD, level)))
    return [((x[0], x[1] - inset), y, (level, level + step - BOARD)) for level in levels]


def _named(spaces: Sequence[tuple[Range, Range, Range]], name: str) -> list[Surface]:
    return [
        top_surface(f"{name} shelf {k + 1}", x, y, z[0], headroom=z[1] - z[0]) for k, (x, y, z) in enumerate(spaces)
    ]


def _front(cell: Cell, face: _Face, back: float, inner: Range, clear: Range, left_hung: bool) -> MovingParts:
    if cell.kind == "drawer":
        return drawer(face, back, inner, clear)
    if cell.kind == "flap":
        return flap(face)
    return door(face, left_hung, glazed=cell.kind == "glass")


def drawer(face: _Face, back: float, inner: Range, clear: Range) -> MovingParts:
    """Return a drawer with a real tray, that slides out three quarters of its depth."""
    x0 = face.x[0]
    slab = (x0, x0 + BOARD)
    y, z = (inner[0] + 0.004, inner[1] - 0.004), (clear[0] + 0.004, max(clear[0] + 0.03, clear[1] - 0.02))
    tail = back + 0.03
    parts = [box(face.finish, slab, face.y, face.z), *_bar_handle(face, along_y=True)]
    parts += [
        box(face.finish, (tail, x0), y, (z[0], z[0] + 0.008)),
        box(face.finish, (tail, x0), (y[0], y[0] + 0.012), (z[0] + 0.008, z[1])),
        box(face.finish, (tail, x0), (y[1] - 0.012, y[1]), (z[0] + 0.008, z[1])),
        box(face.finish, (tail, tail + 0.012), (y[0] + 0.012, y[1] - 0.012), (z[0] + 0.008, z[1])),
    ]
    centre = (x0, sum(face.y) / 2, sum(face.z) / 2)
    joint = Joint(kind="slide", axis=(1.0, 0.0, 0.0), anchor=centre, lower=0.0, upper=round(0.75 * (x0 - tail), 3))
    return MovingParts(face.name, tuple(parts), joint)


def _in_drawer(moving: MovingParts) -> Surface:
    """The bottom of the tray of a drawer that is shut."""
    floor, left, _, back = moving.parts[-4:]
    x, y = (back.hi[0], floor.hi[0]), (floor.lo[1] + 0.012, floor.hi[1] - 0.012)
    return inner_surface(moving.name, x, y, floor.hi[2], headroom=left.hi[2] - floor.hi[2])


def _bar_handle(face: _Face, *, along_y: bool, at: float | None = None) -> list[Part]:
    x = (face.x[0] + BOARD, face.x[1])
    y_mid, z_mid = sum(face.y) / 2, sum(face.z) / 2
    if along_y:
        length = min(0.16, 0.45 * (face.y[1] - face.y[0]))
        height = z_mid if at is None else at
        return [box(face.handle, x, around(y_mid, length), around(height, 0.012))]
    length = min(0.18, 0.4 * (face.z[1] - face.z[0]))
    return [box(face.handle, x, around(at if at is not None else y_mid, 0.012), around(z_mid, length))]


def door(face: _Face, left_hung: bool, *, glazed: bool = False) -> MovingParts:
    """Return a door hinged at its left (+y) or right side, that opens to 100 degrees."""
    x = (face.x[0], face.x[0] + BOARD)
    hinge_y, handle_y = (face.y[1], face.y[0] + 0.035) if left_hung else (face.y[0], face.y[1] - 0.035)
    parts = panel(face.finish, x, face.y, face.z, 0.05, GLASS) if glazed else [box(face.finish, x, face.y, face.z)]
    parts += _bar_handle(face, along_y=False, at=handle_y)
    joint = Joint(
        kind="hinge",
        axis=(0.0, 0.0, 1.0 if left_hung else -1.0),
        anchor=(x[1], hinge_y, sum(face.z) / 2),
        lower=0.0,
        upper=100.0,
    )
    return MovingParts(face.name, tuple(parts), joint)


def flap(face: _Face, *, window: bool = False) -> MovingParts:
    """Return a door hinged at the bottom, that opens to 90 degrees."""
    x = (face.x[0], face.x[0] + BOARD)
    parts = panel(face.finish, x, face.y, face.z, 0.06, GLASS) if window else [box(face.finish, x, face.y, face.z)]
    parts += _bar_handle(face, along_y=True, at=face.z[1] - 0.035)
    anchor = (x[1], sum(face.y) / 2, face.z[0])
    return MovingParts(
        face.name, tuple(parts), Joint(kind="hinge", axis=(0.0, 1.0, 0.0), anchor=anchor, lower=0.0, upper=90.0)
    )


def face_of(name: str, x: Range, y: Range, z: Range, finish: Finish, handle: Finish = IRON) -> _Face:
    """Return the place of a door whose back is at x[0] and whose handle ends at x[1] [m]."""
    return _Face(x, y, z, finish, handle, name)
