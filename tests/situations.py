"""The gallery: situations as a person would set them up, each with the verdict that a person would give.

Every row is one object put into a small room of 4 m by 5 m unless it says otherwise.
"""

# ruff: noqa: E501 (a row of the table is one line)

import math
from collections.abc import Callable
from dataclasses import dataclass

from msgspec import structs

from tests.sim_rooms import asset, box, put, scene, table, vase, wardrobe
from thinkblox.assets import make_asset
from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.verdict import Reason

Objects = tuple[tuple[Placement, Asset], ...]
Setting = tuple[Scene, Placement, Asset]
FALLS: frozenset[Reason] = frozenset({"drift", "drop", "tilt", "pushes"})
"""What gives way under an object shows in one or more of these."""


@dataclass(frozen=True)
class Situation:
    """One row.

    Attributes:
        name: in words.
        build: the scene, the object and where it is put.
        reasons: of the verdict, all of them; nothing for what a person finds in order.
        falls: instead of `reasons`: it does not stay where it is put.
        supports: who carries it.
        blocked: what it stands in the way of.
        pending: why the verdict is not yet what it should be.
    """

    name: str
    build: Callable[[], Setting]
    reasons: tuple[Reason, ...] = ()
    falls: bool = False
    supports: tuple[str, ...] | None = None
    blocked: tuple[str, ...] = ()
    pending: str = ""


L_ROOM = Room(floor=((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)))
DOOR = Opening(id="door_1", kind="door", wall=0, offset=1.0, width=0.9, height=2.05)
WINDOW = Opening(id="window_1", kind="window", wall=2, offset=1.2, width=1.5, height=1.2, sill=0.9)
OPEN_ROOM = rectangle(4.0, 5.0, openings=(DOOR, WINDOW))
CRATE = asset("crate", (0.5, 0.5, 0.5))
BOOK = asset("book", (0.2, 0.14, 0.03), mass=0.5, mount="surface")
UPRIGHT_BOOK = asset("book", (0.14, 0.03, 0.2), mass=0.5, mount="surface")
PLATE = asset("plate", (0.24, 0.24, 0.02), Shape(kind="cylinder", size=(0.24, 0.24, 0.02), position=(0.0, 0.0, 0.01)),
              mass=0.5, mount="surface")  # fmt: skip
MUG = asset("mug", (0.08, 0.08, 0.1), Shape(kind="cylinder", size=(0.08, 0.08, 0.1), position=(0.0, 0.0, 0.05)),
            mass=0.3, mount="surface")  # fmt: skip
BALL = asset("ball", (0.2, 0.2, 0.2), Shape(kind="sphere", size=(0.2, 0.2, 0.2), position=(0.0, 0.0, 0.1)), mass=0.5)
PICTURE = asset("picture", (0.03, 0.8, 0.6), mount="wall", mass=2.0)
SCREEN = asset("screen", (0.04, 0.8, 1.6), mass=8.0)
PENDANT = asset("pendant_lamp", (0.3, 0.3, 0.6), mount="ceiling", mass=2.0)
RUG = asset("rug", (2.0, 1.4, 0.01), box((2.0, 1.4, 0.01), (0.0, 0.0, 0.005), collide=False))
DESK = (put(table(), 2.0, 2.0), table())


def among(placement: Placement, kind: Asset, *others: tuple[Placement, Asset], room: Room | None = None) -> Setting:
    return scene(room, *others), placement, kind


def on(base: tuple[Placement, Asset], kind: Asset, x: float = 0.0, y: float = 0.0, *, surface: int = 0,
       above: float = 0.0, yaw: float = 0.0, id: str = "") -> Placement:  # fmt: skip
    """On a support surface of a placed asset, `x` to its front and `y` to its left from the surface's middle [m]."""
    under, their = base
    if not their.surfaces:
        at, height = (x, y), under.top
    else:
        cx, cy, cz = their.surfaces[surface].position
        at, height = (cx + x, cy + y), under.position[2] + cz
    px, py = under.to_room(at)
    return put(kind, px, py, height + above, under.yaw + yaw, on=under.id, id=id)


def real(category: str, x: float, y: float, z: float = 0.0, yaw: float = 0.0, *, id: str = "", words: tuple[str, ...] = ()) -> tuple[Placement, Asset]:  # fmt: skip
    kind = make_asset(category, seed=0, attributes=words)
    return put(kind, x, y, z, yaw, id=id), kind


def on_desk(kind: Asset, x: float = 0.0, y: float = 0.0, above: float = 0.0) -> Setting:
    return among(on(DESK, kind, x, y, above=above), kind, DESK)


def on_real(category: str, carrier: str, x: float = 0.0, y: float = 0.0, *, surface: int = 0) -> Setting:
    base = real(carrier, 2.0, 2.0, yaw=30.0)
    kind = make_asset(category, seed=0)
    return among(on(base, kind, x, y, surface=surface), kind, base)


def fifth_book(shift: float) -> Setting:
    objects: Objects = (DESK,)
    for number in range(4):
        below = objects[-1]
        objects = (*objects, (on(below, BOOK, shift if number else 0.0, id=f"book_{number + 1}"), BOOK))
    return among(on(objects[-1], BOOK, shift, id="book_5"), BOOK, *objects)


def between_books(thickness: float) -> Setting:
    kind = asset("book", (0.14, thickness, 0.2), mass=0.5, mount="surface")
    row = tuple((on(DESK, UPRIGHT_BOOK, 0.0, y, id=f"book_{i}"), UPRIGHT_BOOK) for i, y in enumerate((-0.031, 0.031)))
    return among(on(DESK, kind, id="book_9"), kind, DESK, *row)


def slope(degrees: float) -> tuple[Placement, Asset]:
    rise = math.tan(math.radians(degrees)) * 1.0
    corners = tuple((x, y, z) for y in (-0.4, 0.4) for x, z in ((-0.5, 0.0), (0.5, 0.0), (-0.5, rise)))
    wedge = Shape(kind="hull", size=(1.0, 0.8, rise), position=(0.0, 0.0, 0.0), points=corners)
    kind = asset("ramp", (1.0, 0.8, rise), wedge, mass=60.0)
    return put(kind, 2.0, 2.0), kind


def ball_on_slope(degrees: float) -> Setting:
    middle = math.tan(math.radians(degrees)) * 0.5 + 0.1 / math.cos(math.radians(degrees)) - 0.1
    return among(put(BALL, 2.0, 2.0, middle, on="ramp_1"), BALL, slope(degrees))


def television(feet: float, stand: float) -> Setting:
    """A television on two feet, on a stand of some width."""
    kind = asset(
        "tv", (0.2, 1.2, 0.7), box((0.04, 1.2, 0.65), (0.0, 0.0, 0.375)),
        *[box((0.2, 0.03, 0.05), (0.0, side * feet / 2, 0.025)) for side in (-1, 1)], mass=15.0, mount="surface",
    )  # fmt: skip
    low = asset("tv_stand", (0.4, stand, 0.5), mass=20.0)
    base = (put(low, 2.0, 2.0), low)
    return among(on(base, kind), kind, base)


def table_on_rug() -> Setting:
    return among(put(table(), 2.6, 2.0), table(), (put(RUG, 3.0, 2.5), RUG))


def table_on_book(z: float) -> Setting:
    return among(put(table(), 2.0, 2.0, z), table(), (put(BOOK, 2.56, 2.36), BOOK))


def heavy_on_light() -> Setting:
    light, heavy = asset("box", (0.5, 0.5, 0.4), mass=1.0), asset("safe", (0.4, 0.4, 0.4), mass=80.0, mount="surface")
    base = (put(light, 2.0, 2.0), light)
    return among(on(base, heavy), heavy, base)


def chest_on_stool(x: float) -> Setting:
    stool, chest = asset("stool", (0.3, 0.3, 0.45), mass=4.0), asset("chest", (1.0, 0.5, 0.4), mass=25.0)
    base = (put(stool, 2.0, 2.0), stool)
    return among(on(base, chest, x), chest, base)


def seesaw() -> Setting:
    """A light plank that lies on a block and reaches far over it, and a heavy box put on its end."""
    block, plank = asset("block", (0.4, 0.4, 0.4), mass=40.0), asset("plank", (1.6, 0.3, 0.03), mass=3.0)
    base = (put(block, 2.0, 2.0), block)
    across = (on(base, plank), plank)
    weight = asset("box", (0.25, 0.25, 0.25), mass=20.0, mount="surface")
    return among(on(across, weight, 0.6), weight, base, across)


def tippy_table() -> Setting:
    """A heavy box at the rim of a light table on one foot."""
    foot, stem, top = box((0.3, 0.3, 0.02), (0.0, 0.0, 0.01)), box((0.05, 0.05, 0.7), (0.0, 0.0, 0.36)), box((0.8, 0.8, 0.02), (0.0, 0.0, 0.72))  # fmt: skip
    kind = asset("side_table", (0.8, 0.8, 0.73), foot, stem, top, mass=5.0)
    weight = asset("box", (0.15, 0.15, 0.2), mass=8.0, mount="surface")
    base = (put(kind, 2.0, 2.0), kind)
    return among(on(base, weight, 0.3), weight, base)


def chair_at(gap: float, kind: Asset | None = None) -> Setting:
    """A chair that faces a dining table, its front edge `gap` from the table's edge; less than 0 is under it."""
    kind = kind or make_asset("chair", seed=0)
    dining, eating = real("dining_table", 2.0, 2.0)
    x = 2.0 - eating.size[0] / 2 - gap - kind.size[0] / 2
    return among(put(kind, x, 2.0), kind, (dining, eating))


def chair_into_leg() -> Setting:
    """A chair whose front is 5 mm in the leg of a desk."""
    kind = asset("chair", (0.5, 0.45, 0.45), mass=6.0)
    return among(put(kind, 1.44, 1.615 + 0.005 - 0.25, yaw=90.0), kind, DESK)


def hung(kind: Asset, along: float, height: float, *others: tuple[Placement, Asset], gap: float = 0.0, yaw: float = 270.0, id: str = "") -> Setting:  # fmt: skip
    """On the north wall, `along` from the west [m]."""
    there = put(kind, along, 5.0 - kind.size[0] / 2 - gap, height, yaw, on="north_wall", id=id)
    return among(there, kind, *others, room=OPEN_ROOM)


def over_the_door(height: float) -> Setting:
    return among(put(PICTURE, 1.45, 0.015, height, 90.0, on="south_wall"), PICTURE, room=OPEN_ROOM)


def from_ceiling(gap: float, *others: tuple[Placement, Asset], kind: Asset = PENDANT) -> Setting:
    return among(put(kind, 2.0, 2.0, 2.6 - kind.size[2] - gap, on="ceiling"), kind, *others)


def behind_wardrobe(gap: float) -> Setting:
    big = wardrobe()
    return hung(PICTURE, 0.8, 1.2, (put(big, 0.8, 4.7 - gap, yaw=270.0), big))


def bunk_bed(into_wall: float) -> Setting:
    """A bunk bed whose ladder, on its left, is next to the north wall."""
    kind = make_asset("bunk_bed", seed=0)
    return among(put(kind, 2.0, 5.0 - kind.size[1] / 2 + into_wall), kind)


def bed_leaves_no_way() -> Setting:
    narrow = rectangle(
        2.0, 6.0, openings=(Opening(id="door_1", kind="door", wall=0, offset=0.5, width=0.9, height=2.0),)
    )
    desk = real("desk", 1.0, 5.5, yaw=270.0)
    kind = asset("bed", (1.9, 1.4, 0.5), mass=50.0)
    return among(put(kind, 1.0, 3.0), kind, desk, room=narrow)


def before_wardrobe(gap: float, kind: Asset) -> Setting:
    """Something before the doors of a wardrobe that stands at the west wall."""
    big, closet = real("wardrobe", 0.32, 2.5)
    return among(put(kind, 0.32 + closet.size[0] / 2 + gap + kind.size[0] / 2, 2.5), kind, (big, closet))


def wardrobe_before(gap: float) -> Setting:
    bed = make_asset("bed", seed=0)
    kind = make_asset("wardrobe", seed=0)
    return among(put(kind, 0.32, 2.5), kind, (put(bed, 0.32 + kind.size[0] / 2 + gap + bed.size[0] / 2, 2.5), bed))


def dresser_before_bed(gap: float) -> Setting:
    bed, kind = make_asset("bed", seed=0), make_asset("dresser", seed=0)
    there = (put(bed, 2.5, 2.5, yaw=90.0), bed)
    return among(put(kind, 2.5 - bed.size[1] / 2 - gap - kind.size[0] / 2, 2.5), kind, there)


def facing_wall(category: str, gap: float) -> Setting:
    kind = make_asset(category, seed=0)
    return among(put(kind, 4.0 - gap - kind.size[0] / 2, 2.5), kind)


def wardrobe_in_corner() -> Setting:
    kind = make_asset("wardrobe", seed=0)
    return among(put(kind, kind.size[0] / 2 + 0.01, kind.size[1] / 2 + 0.01), kind)


def nightstand_beside_bed() -> Setting:
    bed, kind = make_asset("bed", seed=0), make_asset("nightstand", seed=0)
    there = (put(bed, bed.size[0] / 2 + 0.01, 2.0), bed)
    return among(put(kind, kind.size[0] / 2 + 0.01, 2.0 + bed.size[1] / 2 + 0.02 + kind.size[1] / 2), kind, there)


def box_on_the_bed_before_a_wardrobe() -> Setting:
    """The bed keeps the doors shut already; the box is set back on it by 5 cm."""
    bed, heavy = asset("bed", (2.0, 1.4, 0.5), mass=60.0), asset("box", (0.5, 0.5, 0.5), mass=20.0, mount="surface")
    _, placed, kind = before_wardrobe(0.2, bed)
    there = real("wardrobe", 0.32, 2.5)
    return among(on((placed, kind), heavy, -0.7), heavy, there, (placed, kind))


def diagonal(x: float) -> Setting:
    """A square cabinet turned by 45 degrees in the corner at the origin."""
    return among(put(CRATE, x, x, yaw=45.0), CRATE)


def before_window(category: str) -> Setting:
    kind = make_asset(category, seed=0)
    return among(put(kind, 2.05, 5.0 - kind.size[0] / 2 - 0.01, yaw=270.0), kind, room=OPEN_ROOM)


def before_door() -> Setting:
    kind = make_asset("bookcase", seed=0)
    return among(put(kind, 1.45, kind.size[0] / 2 + 0.01, yaw=90.0), kind, room=OPEN_ROOM)


def mug_on_wall_shelf(x: float) -> Setting:
    kind = make_asset("wall_shelf", seed=0)
    shelf = (put(kind, 2.0, 5.0 - kind.size[0] / 2, 1.3, 270.0, on="north_wall"), kind)
    return among(on(shelf, MUG, x), MUG, shelf)


def in_bookcase(kind: Asset, above: float = 0.0) -> Setting:
    base = real("bookcase", 2.0, 2.0)
    return among(on(base, kind, 0.0, 0.1, surface=1, above=above), kind, base)


def pole() -> Setting:
    kind = asset("coat_rack", (0.3, 0.3, 2.7), mass=8.0)
    return among(put(kind, 2.0, 2.0), kind)


def wrong_size() -> Setting:
    return scene(), structs.replace(put(CRATE, 2.0, 2.0), size=(0.5, 0.7, 0.5)), CRATE


SITUATIONS = (
    # On a table
    Situation("vase in the middle of a table", lambda: on_desk(vase()), supports=("table_1",)),
    Situation("vase 1 cm over the edge of a table", lambda: on_desk(vase(), 0.55), supports=("table_1",)),
    Situation("vase with its middle 1 cm past the edge", lambda: on_desk(vase(), 0.61), falls=True),
    Situation("vase 1 mm above a table", lambda: on_desk(vase(), above=0.001), supports=("table_1",)),
    Situation("lamp sunk into a table by 3 mm", lambda: on_desk(vase(), above=-0.003), ("collision",)),
    Situation("lamp sunk into a table by half a millimetre", lambda: on_desk(vase(), above=-0.0005), supports=("table_1",)),
    Situation("monitor floating 5 cm above a desk", lambda: on_desk(make_asset("monitor", seed=0), above=0.05), ("drop",)),
    Situation("keyboard that reaches 3 cm over the edge", lambda: on_desk(make_asset("keyboard", seed=0), 0.6 - 0.04), supports=("table_1",)),
    Situation("laptop half over the edge and a bit", lambda: on_desk(make_asset("laptop", seed=0), 0.66), falls=True),
    Situation("vase on the floor under a table", lambda: among(put(vase(), 2.0, 2.0), vase(), DESK), supports=("floor",)),
    Situation("mug half inside a vase", lambda: among(on(DESK, MUG, 0.05), MUG, DESK, (on(DESK, vase()), vase())), ("collision",)),
    # Stacks and rows
    Situation("the fifth book of a stack", lambda: fifth_book(0.0), supports=("book_4",)),
    Situation("the fifth book of a stack that leans by 1 cm a book", lambda: fifth_book(0.01), supports=("book_4",)),
    Situation("the fifth book of a stack that leans too far", lambda: fifth_book(0.07), falls=True),
    Situation("book between two others", lambda: between_books(0.03), supports=("table_1",)),
    Situation("book too thick for the gap between two others", lambda: between_books(0.038), ("collision",)),
    Situation("plate on a plate", lambda: among(on((on(DESK, PLATE), PLATE), PLATE, id="plate_2"), PLATE, DESK, (on(DESK, PLATE), PLATE)), supports=("plate_1",)),
    Situation("heavy safe on a light box", heavy_on_light, supports=("box_1",)),
    Situation("long chest balanced on a stool", lambda: chest_on_stool(0.0), supports=("stool_1",)),
    Situation("long chest on a stool, out of balance", lambda: chest_on_stool(0.3), falls=True),
    Situation("heavy box on the end of a plank over a block", seesaw, falls=True),
    Situation("heavy box at the rim of a light table on one foot", tippy_table, falls=True),
    Situation("television on a stand that is wide enough", lambda: television(0.8, 1.2), supports=("tv_stand_1",)),
    Situation("television on a stand too narrow for its feet", lambda: television(0.8, 0.6), falls=True),
    # On the floor
    Situation("box on the floor", lambda: among(put(CRATE, 2.0, 2.0), CRATE), supports=("floor",)),
    Situation("box 10 cm in the air", lambda: among(put(CRATE, 2.0, 2.0, 0.1), CRATE), ("drop",)),
    Situation("box 2 cm in the floor", lambda: among(put(CRATE, 2.0, 2.0, -0.02), CRATE), ("outside",)),
    Situation("ball on level floor", lambda: among(put(BALL, 2.0, 2.0), BALL), supports=("floor",)),
    Situation("ball on a slope", lambda: ball_on_slope(15.0), falls=True),
    Situation("standing screen on its edge", lambda: among(put(SCREEN, 2.0, 2.0), SCREEN), supports=("floor",)),
    Situation("table with one leg over a rug", table_on_rug, supports=("floor",)),
    Situation("table with one leg in a book", lambda: table_on_book(0.0), ("collision",)),
    Situation("table with one leg on a book", lambda: table_on_book(0.03), falls=True),
    Situation("rug under everything", lambda: among(put(RUG, 2.0, 2.0), RUG, DESK), supports=("floor",)),
    Situation("rug on a rug", lambda: among(put(RUG, 2.2, 2.4, id="rug_2"), RUG, (put(RUG, 2.0, 2.0), RUG)), supports=("floor",)),
    Situation("rug under a wall", lambda: among(put(RUG, 0.9, 2.0), RUG), ("outside",)),
    Situation("chair under a table", lambda: chair_at(-0.3), supports=("floor",)),
    Situation("armchair whose arms are in the table top", lambda: chair_at(-0.15, asset("armchair", (0.8, 0.7, 0.73), mass=20.0)), ("collision",)),
    Situation("chair pushed 5 mm into the leg of a desk", chair_into_leg, ("collision",)),
    Situation("nightstand beside a bed", nightstand_beside_bed, supports=("floor",)),
    Situation("crate side by side with a crate", lambda: among(put(CRATE, 2.5, 2.0, id="crate_2"), CRATE, (put(CRATE, 2.0, 2.0), CRATE)), supports=("floor",)),
    # On and in furniture
    Situation("cushion on a sofa", lambda: on_real("pillow", "sofa"), supports=("sofa_1",)),
    Situation("table lamp on a nightstand", lambda: on_real("table_lamp", "nightstand"), supports=("nightstand_1",)),
    Situation("bowl of fruit on a dining table", lambda: on_real("fruit_bowl", "dining_table"), supports=("dining_table_1",)),
    Situation("cup on a stack of books", lambda: on_real("cup", "book_stack"), supports=("book_stack_1",)),
    Situation("aquarium on a sideboard", lambda: on_real("aquarium", "sideboard"), supports=("sideboard_1",)),
    Situation("mug in a bookcase", lambda: in_bookcase(MUG), supports=("bookcase_1",)),
    Situation("vase too high for its shelf", lambda: in_bookcase(asset("vase", (0.12, 0.12, 0.5), mass=1.0, mount="surface")), ("collision",)),
    Situation("mug on a wall shelf", lambda: mug_on_wall_shelf(0.0), supports=("wall_shelf_1",)),
    Situation("mug 2 cm over the edge of a wall shelf", lambda: mug_on_wall_shelf(0.115 - 0.02), supports=("wall_shelf_1",)),
    Situation("mug more than half over the edge of a wall shelf", lambda: mug_on_wall_shelf(0.13), falls=True),
    # Walls, corners and ceiling
    Situation("box against a wall", lambda: among(put(CRATE, 0.25, 2.0), CRATE), supports=("floor",)),
    Situation("box half through a wall", lambda: among(put(CRATE, 0.0, 2.0), CRATE), ("outside",)),
    Situation("box outside the room", lambda: among(put(CRATE, -3.0, 2.0), CRATE), ("outside",)),
    Situation("box in the outer corner of an L room", lambda: among(put(CRATE, 0.25, 0.25), CRATE, room=L_ROOM), supports=("floor",)),
    Situation("box 1 cm into the inner corner of an L room", lambda: among(put(CRATE, 1.76, 1.76), CRATE, room=L_ROOM), ("outside",)),
    Situation("box in the notch of an L room", lambda: among(put(CRATE, 3.5, 3.5), CRATE, room=L_ROOM), ("outside",)),
    Situation("cabinet diagonally in a corner", lambda: diagonal(0.36), supports=("floor",)),
    Situation("cabinet diagonally too far in a corner", lambda: diagonal(0.34), ("outside",)),
    Situation("bunk bed along a wall", lambda: bunk_bed(-0.01), supports=("floor",)),
    Situation("bunk bed with its ladder in the wall", lambda: bunk_bed(0.02), ("outside",)),
    Situation("coat rack higher than the room", pole, ("outside",)),
    Situation("box through the ceiling", lambda: among(put(CRATE, 2.0, 2.0, 2.3), CRATE), ("outside",)),
    Situation("lamp hanging from the ceiling", lambda: from_ceiling(0.0), supports=("ceiling",)),
    Situation("lamp hanging 3 cm below the ceiling", lambda: from_ceiling(0.03), ("unsupported",), supports=()),
    Situation("lamp hanging into a vase on the table", lambda: from_ceiling(0.0, DESK, (on(DESK, vase()), vase()), kind=asset("pendant_lamp", (0.3, 0.3, 1.6), mount="ceiling", mass=2.0)), ("collision",)),
    Situation("picture on a wall", lambda: hung(PICTURE, 0.6, 1.4), supports=("north_wall",)),
    Situation("picture with its front to the wall", lambda: hung(PICTURE, 0.6, 1.4, yaw=90.0), ("faces_wall",), supports=("north_wall",)),
    Situation("picture 2 cm off the wall", lambda: hung(PICTURE, 0.6, 1.4, gap=0.02), ("unsupported",), supports=()),
    Situation("picture 1 cm in the wall", lambda: hung(PICTURE, 0.6, 1.4, gap=-0.01), ("outside",)),
    Situation("two pictures that overlap", lambda: hung(PICTURE, 0.9, 1.5, (put(PICTURE, 0.6, 4.985, 1.4, 270.0, on="north_wall"), PICTURE), id="picture_2"), ("collision",)),
    Situation("picture over a window", lambda: hung(PICTURE, 2.05, 1.2), ("blocks_window",), blocked=("window_1",), pending="what is mounted may cover windows, as curtains do"),
    Situation("picture above a window", lambda: hung(asset("picture", (0.03, 0.8, 0.3), mount="wall", mass=2.0), 2.05, 2.2), supports=("north_wall",)),
    Situation("picture over a door", lambda: over_the_door(1.2), ("blocks_door",), blocked=("door_1",)),
    Situation("picture inside a wardrobe before the same wall", lambda: behind_wardrobe(0.0), ("collision",)),
    Situation("picture behind a wardrobe that stands off the wall", lambda: behind_wardrobe(0.04), supports=("north_wall",)),
    # Doors, windows and ways of the room
    Situation("bookcase before the door", before_door, ("blocks_door",), blocked=("door_1",)),
    Situation("bookcase before a window", lambda: before_window("bookcase"), ("blocks_window",), blocked=("window_1",)),
    Situation("sofa before a window", lambda: before_window("sofa"), supports=("floor",)),
    Situation("floor lamp before a window", lambda: before_window("floor_lamp"), supports=("floor",)),
    Situation("bed that leaves no way to the desk", bed_leaves_no_way, ("blocks_way",), blocked=("desk_1",)),
    # Doors and drawers of furniture
    Situation("bed before the doors of a wardrobe", lambda: before_wardrobe(0.2, make_asset("bed", seed=0)), ("blocks_opening",)),
    Situation("bed well before the doors of a wardrobe", lambda: before_wardrobe(0.75, make_asset("bed", seed=0)), supports=("floor",)),
    Situation("wardrobe whose doors meet a bed", lambda: wardrobe_before(0.2), ("blocks_opening",)),
    Situation("chair before the doors of a wardrobe", lambda: before_wardrobe(0.1, make_asset("chair", seed=0)), supports=("floor",)),
    Situation("dresser whose drawers meet a bed", lambda: dresser_before_bed(0.1), ("blocks_opening",)),
    Situation("dresser with room to pull its drawers out", lambda: dresser_before_bed(0.4), supports=("floor",)),
    Situation("box on a bed that keeps a wardrobe shut already", box_on_the_bed_before_a_wardrobe, supports=("bed_1",)),
    Situation("fridge that opens against a wall", lambda: facing_wall("fridge", 0.15), ("blocks_opening",)),
    Situation("washing machine with room before it", lambda: facing_wall("washing_machine", 0.9), supports=("floor",)),
    Situation("wardrobe in a corner, its door opening to the wall", wardrobe_in_corner, supports=("floor",)),
    Situation("thing of a size it cannot have", wrong_size, ("size",)),
)  # fmt: skip
