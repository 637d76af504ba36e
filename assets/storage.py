"""Cabinets of every room, as rows of cells for the carcass generator."""

from math import ceil, cos, pi, sin

from msgspec import structs

from thinkblox.assets.carcasses import BOARD, GAP, HANDLE, Cell, cabinet, door, face_of
from thinkblox.assets.goods import is_filled, put_goods
from thinkblox.assets.open_forms import lidded
from thinkblox.assets.palette import GREY_METAL, IRON, SPINES, STEEL
from thinkblox.assets.part import Build, Finish, MovingParts, Part, Range, moved
from thinkblox.assets.shapes import around, box, cushion, cylinder, prism, rod, top_surface
from thinkblox.assets.spec import Spec
from thinkblox.assets.tables import is_round, side_table
from thinkblox.scene.asset import Joint

_AT_HAND = 1.1
"""Height of the board on which things stand beside the books [m]."""
_SHOWN = 0.52
"""Share of that board that books take."""
_RUN_DEPTH, _WIDEST_DOOR = 0.62, 0.62
"""Depth of the units beside one for a corner, and width of the doors of those on the wall at most [m]."""
_BOOK = 0.05
"""Where less is left of a board than a book is thick, nothing stands there [m]."""
_CHEST_RIM = 0.55
"""Share of its height at which the rim of a chest is whose lid stands open."""


def nightstand(spec: Spec) -> Build:
    """Return a bedside cabinet: a drawer above an open shelf, on legs; a small table when round."""
    if is_round(spec):
        return side_table(spec)
    finish = spec.wood if spec.rng.random() < 0.7 else spec.paint
    return cabinet(spec, [[Cell("open", 1.3), Cell("drawer")]], legs=0.14, finish=finish)


def wardrobe(spec: Spec) -> Build:
    """Return a wardrobe of hinged doors, one for every half metre."""
    bays = max(1, round(spec.size[1] / 0.5))
    wood = spec.has("wooden") or spec.rng.random() < 0.3
    cells = [[Cell("door", 1.0, 1)] for _ in range(bays)]
    return cabinet(spec, cells, plinth=0.06, finish=spec.wood if wood else spec.paint)


def dresser(spec: Spec) -> Build:
    """Return a chest of drawers: rows of about 0.22 m, two columns when broad."""
    rows = max(2, min(5, round((spec.size[2] - 0.12) / 0.21)))
    columns = 2 if spec.size[1] > 1.0 else 1
    return cabinet(spec, [[Cell("drawer")] * rows] * columns, legs=0.1, finish=spec.wood)


def bookcase(spec: Spec) -> Build:
    """Return open shelves; with "filled" the books are part of it."""
    rows = max(1, round((spec.size[2] - 0.08) / 0.36))
    bays = max(1, round(spec.size[1] / 1.0))
    finish = spec.wood if spec.rng.random() < 0.65 else spec.paint
    build = cabinet(spec, [[Cell("open", 1.0, rows - 1)]] * bays, plinth=0.06, finish=finish)
    if spec.has("filled", "full", "full-of-books", "full of books"):
        _fill_with_books(build, spec)
    return build


def _fill_with_books(build: Build, spec: Spec) -> None:
    """Fill most of every board, that at hand less; what is left free of it carries things."""
    boards = [surface for surface in build.surfaces if surface.headroom is not None]
    at_hand = min(boards, key=lambda surface: abs(surface.position[2] - _AT_HAND), default=None)
    for surface in boards:
        (x, mid, z), (deep, width) = surface.position, surface.size
        share = spec.between(0.6, 0.92)
        span = (mid - width / 2 + 0.01, mid - width / 2 + width * (_SHOWN if surface is at_hand else share))
        front = x + deep / 2 - 0.03
        end = _row_of_books(build, spec, (front - min(0.2, deep - 0.05), front), span, z, surface.headroom or 0.0)
        free = mid + width / 2 - end
        left = structs.replace(surface, position=(x, mid + width / 2 - free / 2, z), size=(deep, free))
        build.surfaces = [left if s is surface else s for s in build.surfaces if s is not surface or free > _BOOK]


def _row_of_books(build: Build, spec: Spec, x: Range, y: Range, z: float, headroom: float) -> float:
    """Put books side by side over a span; returns where they end [m]."""
    at = y[0]
    while at < y[1]:
        thick, tall = spec.between(0.035, 0.085), min(headroom - 0.03, spec.between(0.19, 0.29))
        depth = spec.between(0.0, 0.03)
        build.body.append(box(spec.choice(SPINES), (x[0], x[1] - depth), (at, at + thick), (z, z + tall)))
        at += thick + 0.002
    return at


def shelving_unit(spec: Spec) -> Build:
    """Return boards between four metal posts, open on all sides; with "filled" the goods are part of it."""
    x, y, z = spec.size
    rows = max(2, round(z / 0.42))
    metal, board = spec.main(spec.style.metal), spec.style.wood
    build = Build()
    for sx in (-1, 1):
        for sy in (-1, 1):
            build.body.append(
                box(metal, around(sx * (x / 2 - 0.0125), 0.025), around(sy * (y / 2 - 0.0125), 0.025), (0, z))
            )
    area = ((-x / 2 + 0.005, x / 2 - 0.005), (-y / 2 + 0.025, y / 2 - 0.025))
    step = (z - 0.14) / (rows - 1)
    for k in range(rows):
        level = 0.12 + k * step
        build.body.append(box(board, *area, (level - 0.02, level)))
        build.surfaces.append(
            top_surface(f"shelf {k + 1}", *area, level, headroom=step - 0.02 if k < rows - 1 else None)
        )
    if is_filled(spec):
        put_goods(build, spec)
    return build


def wall_shelf(spec: Spec) -> Build:
    """Return one board on two brackets; a tall one is a stack of boards between two sides."""
    x, y, z = spec.size
    if z > 0.4:
        rows = max(1, round(z / 0.33))
        return cabinet(spec, [[Cell("open", 1.0, rows - 1)]], finish=spec.wood)
    thick = min(0.03, 0.3 * z)
    build = Build(body=[box(spec.wood, (-x / 2, x / 2), (-y / 2, y / 2), (z - thick, z))])
    for side in (-1, 1):
        at = around(side * (y / 2 - 0.12), 0.02)
        build.body.append(box(spec.style.metal, (-x / 2, -x / 2 + 0.008), at, (0, z - thick)))
        build.body.append(box(spec.style.metal, (-x / 2 + 0.008, x / 2 - 0.04), at, (z - thick - 0.008, z - thick)))
    build.surfaces = [top_surface("top", (-x / 2, x / 2), (-y / 2, y / 2), z)]
    return build


def tv_stand(spec: Spec) -> Build:
    """Return a low board with doors at its ends and open shelves between."""
    end = Cell("drawer") if spec.rng.random() < 0.4 else Cell("door")
    return cabinet(spec, [[end], [Cell("open", 1.0, 1)], [end]], legs=0.12, finish=spec.wood)


def sideboard(spec: Spec) -> Build:
    """Return doors on both sides of a row of drawers."""
    bays = [[Cell("door", 1.0, 1)], [Cell("drawer")] * 3, [Cell("door", 1.0, 1)]]
    if spec.size[1] > 1.7:
        bays.insert(1, [Cell("door", 1.0, 1)])
    return cabinet(spec, bays, legs=0.15, finish=spec.wood)


def credenza(spec: Spec) -> Build:
    """Return a low office sideboard with four doors on a plinth."""
    count = max(2, round(spec.size[1] / 0.45))
    return cabinet(spec, [[Cell("door", 1.0, 1)]] * count, plinth=0.06, finish=spec.wood)


def cupboard(spec: Spec) -> Build:
    """Return a cabinet with two doors, and a drawer above each when it is low."""
    count = max(1, round(spec.size[1] / 0.45))
    bay = [Cell("door", 3.0, 1)] + ([Cell("drawer", 1.0)] if 0.6 < spec.size[2] < 1.1 else [])
    if spec.size[2] > 1.3:
        bay = [Cell("door", 1.0, 3)]
    return cabinet(spec, [bay] * count, plinth=0.06)


def china_cabinet(spec: Spec) -> Build:
    """Return glazed doors above wooden ones."""
    count = max(2, round(spec.size[1] / 0.5))
    return cabinet(
        spec, [[Cell("door", 1.0), Cell("glass", 1.7, 2, shows=True)]] * count, plinth=0.06, finish=spec.wood
    )


def display_cabinet(spec: Spec) -> Build:
    """Return a cabinet of glazed doors from the plinth to the top, its shelves seen."""
    count = max(1, round(spec.size[1] / 0.5))
    rows = max(1, round(spec.size[2] / 0.42))
    return cabinet(spec, [[Cell("glass", 1.0, rows - 1, shows=True)]] * count, plinth=0.06, finish=spec.wood)


def filing_cabinet(spec: Spec) -> Build:
    """Return steel drawers, one for every third of a metre."""
    rows = max(2, round(spec.size[2] / 0.34))
    return cabinet(spec, [[Cell("drawer")] * rows], plinth=0.03, finish=spec.main(GREY_METAL))


def tool_cabinet(spec: Spec) -> Build:
    """Return a red workshop cabinet of shallow drawers."""
    rows = max(3, round(spec.size[2] / 0.16))
    return cabinet(spec, [[Cell("drawer")] * rows], plinth=0.05, finish=spec.main(Finish((0.68, 0.18, 0.15), "metal")))


def locker(spec: Spec) -> Build:
    """Return tall narrow steel doors side by side."""
    count = max(1, round(spec.size[1] / 0.32))
    finish = spec.main(spec.choice((GREY_METAL, Finish((0.36, 0.48, 0.58), "metal"))))
    return cabinet(spec, [[Cell("door", 1.0, 1)]] * count, plinth=0.08, finish=finish)


def base_cabinet(spec: Spec) -> Build:
    """Return a kitchen unit with a worktop: doors, or drawers when made so, in modules of about 0.6 m."""
    count = max(1, round(spec.size[1] / 0.6))
    door = [Cell("door", 3.0, 1), Cell("drawer", 1.0)]
    drawers = [Cell("drawer", 1.6), Cell("drawer", 1.6), Cell("drawer", 1.0)]
    bays = [drawers if spec.has("drawers") or (k % 3 == 1) else door for k in range(count)]
    return cabinet(spec, bays, plinth=0.1, worktop=spec.style.worktop)


def wall_cabinet(spec: Spec) -> Build:
    """Return a kitchen cabinet for the wall, with a door for every unit of 0.6 m below."""
    count = max(1, ceil(spec.size[1] / _WIDEST_DOOR))
    return cabinet(spec, [[Cell("glass" if spec.has("glass") else "door", 1.0, 1)]] * count)


def corner_cabinet(spec: Spec) -> Build:
    """Return a kitchen unit for the corner at its back and left, between two runs at right angles.

    Its worktop goes round the corner; in the angle that is left open is a door beside a fixed front.
    """
    x, y, z = spec.size
    back, left, low, high = -x / 2, y / 2, 0.1, z - 0.034
    deep = min(_RUN_DEPTH, 0.8 * x, 0.8 * y)
    front = deep - 0.004 - HANDLE - BOARD - GAP
    carcass, top = spec.paint, spec.style.worktop
    foot = front - 0.05
    build = Build(
        body=[
            box(top, (back, back + deep), (-y / 2, left), (high, z)),
            box(top, (back + deep, x / 2), (left - deep, left), (high, z)),
            box(carcass, (back, back + front), (-y / 2, -y / 2 + BOARD), (low, high)),
            box(carcass, (x / 2 - BOARD, x / 2), (left - front, left), (low, high)),
            box(carcass, (back, back + 0.008), (-y / 2 + BOARD, left), (low, high)),
            box(carcass, (back + 0.008, x / 2 - BOARD), (left - 0.008, left), (low, high)),
            box(carcass, (back + 0.008, back + front), (-y / 2 + BOARD, left - 0.008), (low, low + BOARD)),
            box(carcass, (back + front, x / 2 - BOARD), (left - front, left - 0.008), (low, low + BOARD)),
            box(carcass, (back, back + foot), (-y / 2 + 0.01, left), (0, low)),
            box(carcass, (back + foot, x / 2 - 0.01), (left - foot, left), (0, low)),
            box(carcass, (back + front, x / 2 - GAP / 2), (left - front - BOARD, left - front), (low, high)),
        ],
        surfaces=[
            top_surface("top", (back, back + deep), (-y / 2, left), z),
            top_surface("side", (back + deep, x / 2), (left - deep, left), z),
        ],
    )
    opening = (-y / 2 + GAP / 2, left - front - BOARD - HANDLE)
    face = face_of(
        "door", (back + front + GAP, back + deep - 0.004), opening, (low, high - GAP / 2), carcass, spec.style.metal
    )
    build.moving.append(door(face, left_hung=False))
    return build


def kitchen_island(spec: Spec) -> Build:
    """Return a worktop over cabinets, that stands out at the back for the knees of whoever sits there."""
    x, y, z = spec.size
    depth = x - min(0.3, 0.34 * x)
    inner = Spec(spec.category, (depth, y - 0.1, z - 0.04), spec.words, spec.style, spec.rng)
    count = max(2, round(y / 0.55))
    bays = [[Cell("drawer")] * 3 if k % 2 else [Cell("door", 1.0, 1)] for k in range(count)]
    build = cabinet(inner, bays, plinth=0.1)
    build = shifted(build, ((x - depth) / 2 - 0.02, 0.0, 0.0))
    top = spec.style.worktop
    build.body.append(box(top, (-x / 2, x / 2), (-y / 2, y / 2), (z - 0.04, z)))
    build.surfaces = [top_surface("top", (-x / 2, x / 2), (-y / 2, y / 2), z)]
    return build


def shifted(build: Build, offset: tuple[float, float, float]) -> Build:
    """`build` moved by `offset` [m], without its surfaces."""

    def shift(p: tuple[float, float, float]) -> tuple[float, float, float]:
        return (p[0] + offset[0], p[1] + offset[1], p[2] + offset[2])

    moving = [
        MovingParts(
            m.name, tuple(moved(p, offset) for p in m.parts), structs.replace(m.joint, anchor=shift(m.joint.anchor))
        )
        for m in build.moving
    ]
    return Build(body=[moved(p, offset) for p in build.body], moving=moving)


def shoe_rack(spec: Spec) -> Build:
    """Return slatted shelves between two sides."""
    x, y, z = spec.size
    rows = max(2, round(z / 0.22))
    build = Build(body=[box(spec.wood, (-x / 2, x / 2), (s * (y / 2 - BOARD), s * y / 2), (0, z)) for s in (-1, 1)])
    inner = (-y / 2 + BOARD, y / 2 - BOARD)
    for k in range(rows):
        level = 0.1 + k * (z - 0.1 - 0.004) / (rows - 1)
        for slat in (-1, 0, 1):
            build.body.append(box(spec.wood, around(slat * 0.33 * x, 0.26 * x), inner, (level - 0.016, level)))
        room = (z - 0.104) / (rows - 1) - 0.016 if k < rows - 1 else None
        build.surfaces.insert(0, top_surface(f"shelf {k + 1}", (-0.46 * x, 0.46 * x), inner, level, headroom=room))
    return build


def shoe_bench(spec: Spec) -> Build:
    """Return a cushioned bench over slatted shelves for shoes; an "open" one has none."""
    x, y, z = spec.size
    seat, inner = z - 0.06, (-y / 2 + BOARD, y / 2 - BOARD)
    build = Build(
        body=[
            *(box(spec.wood, (-x / 2, x / 2), (s * (y / 2 - BOARD), s * y / 2), (0, seat)) for s in (-1, 1)),
            box(spec.wood, (-x / 2, x / 2), inner, (seat - BOARD, seat)),
            cushion(spec.main(spec.style.accent), (-x / 2, x / 2), (-y / 2, y / 2), (seat, z), radius=0.02),
        ],
        surfaces=[top_surface("seat", (-x / 2 + 0.02, x / 2 - 0.02), (-y / 2 + 0.02, y / 2 - 0.02), z)],
    )
    if spec.has("open"):
        return build
    count = max(1, round((seat - 0.1) / 0.19))
    pitch = (seat - BOARD - 0.08) / count
    for k in range(count):
        level = 0.08 + k * pitch
        for slat in (-1, 0, 1):
            build.body.append(box(spec.wood, around(slat * 0.33 * x, 0.26 * x), inner, (level - 0.016, level)))
        shelf = top_surface(f"shelf {k + 1}", (-0.46 * x, 0.46 * x), inner, level, headroom=pitch - 0.02)
        build.surfaces.append(shelf)
    return build


def server_rack(spec: Spec) -> Build:
    """Return a black rack filled with servers, whose glass door opens."""
    x, y, z = spec.size
    front = x / 2 - 0.042
    black = spec.main(IRON)
    build = Build(body=[box(black, (-x / 2, front), (s * (y / 2 - 0.03), s * y / 2), (0, z)) for s in (-1, 1)])
    inner = (-y / 2 + 0.03, y / 2 - 0.03)
    build.body += [box(black, (-x / 2, front), inner, (0, 0.06)), box(black, (-x / 2, front), inner, (z - 0.04, z))]
    units = max(3, int((z - 0.2) / 0.16))
    for k in range(units):
        low = 0.07 + k * (z - 0.13) / units
        high = low + (z - 0.13) / units - 0.012
        build.body.append(box(GREY_METAL if k % 3 else STEEL, (-x / 2 + 0.05, front - 0.03), inner, (low, high)))
        lamp = Finish((0.35, 0.85, 0.55) if k % 2 else (0.30, 0.60, 0.95), "light")
        build.body.append(
            box(
                lamp,
                (front - 0.03, front - 0.028),
                (inner[0] + 0.04, inner[0] + 0.1),
                around((low + high) / 2, 0.012),
                collide=False,
            )
        )
    face = face_of("door", (front + 0.002, x / 2), (-y / 2 + 0.002, y / 2 - 0.002), (0.01, z - 0.005), black)
    build.moving.append(door(face, left_hung=True, glazed=True))
    build.surfaces = [top_surface("top", (-x / 2, front), (-y / 2, y / 2), z)]
    return build


def toy_box(spec: Spec) -> Build:
    """Return a chest whose lid opens; "open" with the lid up."""
    x, y, z = spec.size
    finish = spec.main(spec.choice((spec.style.paint, spec.style.accent)))
    if finish.material == "fabric":
        finish = Finish(finish.colour, "wood")
    if spec.has("open"):
        return lidded(spec.size, finish, spec.style.wood, _CHEST_RIM * z)
    sides = (0.03, z - 0.024)
    build = Build(
        body=[
            box(finish, (-x / 2, x / 2), (-y / 2, y / 2), (0.015, 0.03)),
            *(box(finish, (-x / 2, x / 2), (s * (y / 2 - BOARD), s * y / 2), sides) for s in (-1, 1)),
            *(box(finish, (s * x / 2, s * (x / 2 - BOARD)), (-y / 2 + BOARD, y / 2 - BOARD), sides) for s in (-1, 1)),
            *(
                box(spec.style.wood, around(sx * (x / 2 - 0.05), 0.05), around(sy * (y / 2 - 0.05), 0.05), (0, 0.015))
                for sx in (-1, 1)
                for sy in (-1, 1)
            ),
        ]
    )
    lid = box(spec.style.wood, (-x / 2, x / 2), (-y / 2, y / 2), (z - 0.022, z))
    joint = Joint(kind="hinge", axis=(0.0, -1.0, 0.0), anchor=(-x / 2, 0.0, z), lower=0.0, upper=80.0)
    build.moving = [MovingParts("lid", (lid,), joint)]
    build.surfaces = [top_surface("lid", (-x / 2, x / 2), (-y / 2, y / 2), z)]
    return build


def trunk(spec: Spec) -> Build:
    """Return a wooden chest with iron bands and a lid that opens: vaulted, or "flat"; "open" with the lid up."""
    x, y, z = spec.size
    if spec.has("open"):
        return lidded(spec.size, spec.wood, spec.wood, _CHEST_RIM * z)
    flat = spec.has("flat")
    finish, rim = spec.wood, (z - 0.05 if flat else 0.66 * z)
    build = Build(
        body=[
            box(finish, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.02)),
            *(box(finish, (-x / 2, x / 2), (s * (y / 2 - BOARD), s * y / 2), (0.02, rim)) for s in (-1, 1)),
            *(
                box(finish, (s * x / 2, s * (x / 2 - BOARD)), (-y / 2 + BOARD, y / 2 - BOARD), (0.02, rim))
                for s in (-1, 1)
            ),
            *(box(IRON, around(x / 2, 0.004), around(s * 0.3 * y, 0.05), (0, rim), collide=False) for s in (-1, 1)),
        ]
    )
    vault = [(-x / 2, rim + GAP), (x / 2, rim + GAP)]
    vault += [(0.5 * x * cos(k * pi / 8), rim + GAP + (z - rim - GAP) * sin(k * pi / 8) ** 0.7) for k in range(1, 8)]
    lid: list[Part] = [prism(finish, vault, (-y / 2, y / 2), axis=1, smooth=True)]
    if flat:
        lid = [box(finish, (-x / 2, x / 2), (-y / 2, y / 2), (rim + GAP, z))]
    lid.append(box(IRON, around(x / 2, 0.012), around(0, 0.09), (rim + GAP, min(z, rim + 0.06))))
    joint = Joint(kind="hinge", axis=(0.0, -1.0, 0.0), anchor=(-x / 2, 0.0, rim + GAP), lower=0.0, upper=80.0)
    build.moving = [MovingParts("lid", tuple(lid), joint)]
    top = 0.48 * x if flat else 0.22 * x
    build.surfaces = [top_surface("lid", (-top, top), (-y / 2 + 0.02, y / 2 - 0.02), z)]
    return build


def luggage_rack(spec: Spec) -> Build:
    """Return a folding rack with a cloth between its bars for a suitcase."""
    x, y, z = spec.size
    bar = 0.03
    build = Build()
    for s in (-1, 1):
        at = s * (y / 2 - bar)
        build.body += [
            rod(
                spec.wood,
                (-a * (x / 2 - bar), at - a * 0.01, 0.015),
                (a * (x / 2 - bar), at - a * 0.01, z - bar),
                0.014,
            )
            for a in (-1, 1)
        ]
        build.body.append(
            box(spec.wood, (s * (x / 2 - bar) - 0.02, s * (x / 2 - bar) + 0.02), (-y / 2, y / 2), (z - bar, z))
        )
        build.body.append(cylinder(spec.wood, around(s * (x / 2 - bar), 0.03), (-y / 2, y / 2), (0, 0.03), axis=1))
    cloth = Finish((0.25, 0.21, 0.19), "fabric")
    build.body.append(box(cloth, around(0, x - 4 * bar), around(0, 0.64 * y), (z - 0.006, z)))
    build.surfaces = [top_surface("cloth", around(0, x - 4 * bar), around(0, 0.6 * y), z)]
    return build


def safe(spec: Spec) -> Build:
    """Return a steel safe with a thick door, which "locked" does not open."""
    build = cabinet(spec, [[Cell("door", 1.0, 1)]], finish=spec.main(Finish((0.27, 0.30, 0.32), "metal")))
    if spec.has("locked"):
        shut = [part for door in build.moving for part in door.parts]
        return Build(body=build.body + shut, surfaces=[s for s in build.surfaces if not s.within])
    return build
