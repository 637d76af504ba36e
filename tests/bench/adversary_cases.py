"""Families of cases that try to fool the verdict: a room, what stands in it, and one thing more."""

import math
from collections.abc import Callable
from typing import NamedTuple

from tests.bench.adversary_things import Genes, anything, block, board, made_of, pole, slab
from tests.sim_rooms import asset, box, put, scene
from thinkblox.assets import CATALOGUE, make_asset
from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene

MIDDLE = (2.0, 2.0)
SMALL, LOW = (0.03, 0.3), (0.02, 0.6)
FURNITURE = ("desk", "table", "bookcase", "nightstand", "stool", "coat_rack", "bed", "tv_stand", "side_table", "sofa")


class Case(NamedTuple):
    """What stands in a room, and a candidate among it."""

    scene: Scene
    placement: Placement
    asset: Asset


def alone(genes: Genes) -> Case:
    """One thin, tall, odd or heavy thing on the floor of a room of some size."""
    kind = anything(genes, "new", wide=(0.03, 0.8), tall=(0.05, 2.3))
    side = genes.between(2.5, 9.0)
    place = put(kind, side / 2, side / 2, genes.gap(), genes.between(0.0, 360.0))
    return Case(scene(rectangle(side, side)), place, kind)


def unequal(genes: Genes) -> Case:
    """Something on a thing of quite another weight, in the middle or towards its rim."""
    under = slab(genes, "under", wide=(0.08, 0.6), thick=(0.005, 0.5))
    kind = anything(genes, "new", wide=(0.05, 0.6), tall=(0.05, 1.0))
    reach = genes.between(0.0, 0.5)
    return _upon(genes, scene(None, (put(under, *MIDDLE), under)), under.size, kind, reach)


def stack(genes: Genes) -> Case:
    """The last of a stack of two to six slabs that do not lie quite over each other."""
    return _stacked(genes, gaps=False)


def apart(genes: Genes) -> Case:
    """The same where each lies up to 9 mm over the one below: what stands there is not yet at rest."""
    return _stacked(genes, gaps=True)


def _stacked(genes: Genes, *, gaps: bool) -> Case:
    room, height, lean = scene(), 0.0, genes.between(0.0, 0.06)
    x, y = MIDDLE
    for number in range(genes.among((1, 2, 3, 4, 5))):
        kind = slab(genes, f"slab{number}", wide=(0.08, 0.4), thick=(0.005, 0.15))
        lift = genes.between(0.0, 0.009) if gaps else 0.0
        room = room.with_placement(put(kind, x, y, height + lift, genes.between(0.0, 90.0), id=f"slab_{number}"), kind)
        height += lift + kind.size[2]
        x, y = x + genes.between(-lean, lean), y + genes.between(-lean, lean)
    kind = anything(genes, "new", wide=SMALL, tall=LOW)
    return Case(room, put(kind, x, y, height + genes.gap(), genes.between(0.0, 360.0)), kind)


def edge(genes: Genes) -> Case:
    """Something over the edge of a table on four legs, or of a board on one foot."""
    wide, high = genes.between(0.25, 1.2), genes.between(0.2, 1.1)
    mass = genes.magnitude(0.5, 60.0)
    top = box((wide, wide, 0.03), (0.0, 0.0, high - 0.015))
    leg, out, foot = 0.05, wide / 2 - 0.04, high - 0.03
    if genes.share() < 0.5:
        under = [box((leg, leg, foot), (sx * out, sy * out, foot / 2)) for sx in (-1, 1) for sy in (-1, 1)]
    else:
        broad = wide * genes.between(0.3, 0.9)
        under = [box((broad, broad, foot), (0.0, 0.0, foot / 2))]
    table = asset("table", (wide, wide, high), top, *under, mass=mass)
    kind = anything(genes, "new", wide=SMALL, tall=LOW)
    return _upon(genes, scene(None, (put(table, *MIDDLE), table)), table.size, kind, genes.between(0.3, 0.55))


def rug(genes: Genes) -> Case:
    """Something partly on a mat of 1 to 12 mm that can be stood on, or on a rug that cannot be felt."""
    thick, felt = genes.between(0.001, 0.012), genes.share() < 0.8
    mat = asset("mat", (0.8, 0.8, thick), box((0.8, 0.8, thick), (0.0, 0.0, thick / 2), collide=felt), mass=2.0)
    kind = anything(genes, "new", wide=(0.05, 0.6), tall=(0.05, 1.8))
    x, y = MIDDLE[0] + genes.between(-0.6, 0.6), MIDDLE[1] + genes.between(-0.6, 0.6)
    lift = thick if felt and genes.share() < 0.8 else 0.0
    place = put(kind, x, y, lift + genes.gap(), genes.between(0.0, 360.0))
    return Case(scene(None, (put(mat, *MIDDLE), mat)), place, kind)


def slope(genes: Genes) -> Case:
    """Something on a ramp of up to 25 degrees, put down just over it."""
    degrees = genes.between(0.2, 25.0)
    rise = math.tan(math.radians(degrees))
    corners = tuple((x, y, z) for y in (-0.4, 0.4) for x, z in ((-0.5, 0.0), (0.5, 0.0), (-0.5, rise)))
    wedge = Shape(kind="hull", size=(1.0, 0.8, rise), position=(0.0, 0.0, 0.0), points=corners)
    ramp = asset("ramp", (1.0, 0.8, rise), wedge, mass=60.0, friction=genes.between(0.2, 0.9))
    kind = anything(genes, "new", wide=(0.05, 0.3), tall=(0.03, 0.6))
    x = genes.between(-0.2, 0.2)
    height = rise * (0.5 - x) + kind.size[0] / 2 * rise * genes.between(0.9, 1.1)
    return Case(scene(None, (put(ramp, *MIDDLE), ramp)), put(kind, MIDDLE[0] + x, MIDDLE[1], height), kind)


def mounted(genes: Genes) -> Case:
    """On a shelf on the wall, or a thing on the wall or ceiling that touches what stands there."""
    deep, along = genes.between(0.1, 0.35), genes.between(0.3, 1.0)
    shelf = asset("shelf", (deep, along, 0.02), mass=3.0, mount="wall")
    high = genes.between(0.3, 1.6)
    there = put(shelf, 2.0, 5.0 - deep / 2, high, 270.0, on="north_wall")
    if genes.share() < 0.6:
        kind = anything(genes, "new", wide=(0.03, 0.3), tall=LOW)
        x, y = 2.0 + genes.between(-0.5, 0.5) * along, 5.0 - deep * genes.between(0.0, 0.9)
        place = put(kind, x, y, high + 0.02 + genes.gap(), genes.between(0.0, 360.0))
        return Case(scene(None, (there, shelf)), place, kind)
    tall = anything(genes, "tall", wide=(0.03, 0.3), tall=(high - 0.01, high))
    y = 5.0 - genes.between(0.0, deep + 0.1) - tall.size[1] / 2
    room = scene(None, (put(tall, 2.0, y), tall))
    return Case(room, there, shelf)


def beside(genes: Genes) -> Case:
    """Something that touches, or nearly touches, a pole, a board or a tall box."""
    form = genes.among((pole, board, block))
    x, y, z = genes.magnitude(0.03, 0.3), genes.magnitude(0.03, 0.3), genes.magnitude(0.2, 1.8)
    tall = made_of("tall", form(genes, x, y, z), mass=genes.magnitude(0.05, 100.0), friction=genes.between(0.2, 1.0))
    kind = anything(genes, "new", wide=(0.05, 0.5), tall=(0.05, 1.8))
    near = (tall.size[0] + kind.size[0]) / 2 + genes.between(-0.0011, 0.003)
    side = MIDDLE[1] + genes.between(-0.5, 0.5) * tall.size[1]
    place = put(kind, MIDDLE[0] + near, side, genes.gap())
    return Case(scene(None, (put(tall, *MIDDLE), tall)), place, kind)


def leaning(genes: Genes) -> Case:
    """A thing on top of another that is tall and stands lightly."""
    under = anything(genes, "under", wide=(0.05, 0.4), tall=(0.3, 1.8))
    kind = anything(genes, "new", wide=(0.03, 0.5), tall=(0.02, 0.5))
    return _upon(genes, scene(None, (put(under, *MIDDLE), under)), under.size, kind, genes.between(0.0, 0.4))


def catalogue(genes: Genes) -> Case:
    """A thing of the catalogue on furniture of the catalogue, maybe with another thing there already."""
    base = make_asset(genes.among(FURNITURE), seed=genes.among(range(8)))
    base_at = put(base, *MIDDLE, id="base_1", yaw=genes.between(0.0, 360.0))
    room = scene(rectangle(4.0, 4.0), (base_at, base))
    category = genes.among(_small())
    if genes.share() < 0.5:
        other = make_asset(genes.among(_small()), seed=genes.among(range(8)))
        room = room.with_placement(_on_surface(genes, base_at, base, other, "other_1", exact=True), other)
        if genes.share() < 0.6:
            base_at, base = room["other_1"], other
    kind = make_asset(category, seed=genes.among(range(8)))
    return Case(room, _on_surface(genes, base_at, base, kind, "new_1"), kind)


def furnished(genes: Genes) -> Case:
    """A thing of the catalogue on the floor among others."""
    side = genes.between(2.5, 7.0)
    room = scene(rectangle(side, side))
    for number in range(genes.among((0, 1, 2, 3))):
        there = make_asset(genes.among(_standing()), seed=genes.among(range(8)))
        x, y = genes.between(0.2, 0.8) * side, genes.between(0.2, 0.8) * side
        room = room.with_placement(put(there, x, y, 0.0, genes.between(0.0, 360.0), id=f"there_{number}"), there)
    kind = make_asset(genes.among(_standing()), seed=genes.among(range(8)))
    x, y = genes.between(0.2, 0.8) * side, genes.between(0.2, 0.8) * side
    # A rug is not let go: one that floats is refused, and no simulation would say so.
    gap = genes.gap()
    return Case(room, put(kind, x, y, gap if kind.collides else 0.0, genes.between(0.0, 360.0), id="new_1"), kind)


FAMILIES: dict[str, Callable[[Genes], Case]] = {
    family.__name__: family
    for family in (alone, unequal, stack, apart, edge, rug, slope, mounted, beside, leaning, catalogue, furnished)
}


def _upon(genes: Genes, room: Scene, size: tuple[float, float, float], kind: Asset, reach: float) -> Case:
    """The thing on top of what stands in the middle, `reach` of its width away from there."""
    angle = genes.between(0.0, 2 * math.pi)
    x, y = MIDDLE[0] + reach * size[0] * math.cos(angle), MIDDLE[1] + reach * size[1] * math.sin(angle)
    return Case(room, put(kind, x, y, size[2] + genes.gap(), genes.between(0.0, 360.0)), kind)


def _on_surface(genes: Genes, under: Placement, base: Asset, kind: Asset, id: str, *, exact: bool = False) -> Placement:
    if base.surfaces:
        surface = genes.among(base.surfaces)
        cx, cy, cz = surface.position
        x, y = cx + genes.between(-0.5, 0.5) * surface.size[0], cy + genes.between(-0.5, 0.5) * surface.size[1]
    else:
        cz, x, y = base.size[2], genes.between(-0.3, 0.3) * base.size[0], genes.between(-0.3, 0.3) * base.size[1]
    lift = genes.gap()
    there = under.to_room((x, y))
    height = under.position[2] + cz + (0.0 if exact else lift)
    return put(kind, *there, height, genes.between(0.0, 360.0), id=id, on=under.id)


def _small() -> list[str]:
    return sorted(name for name, category in CATALOGUE.items() if category.mount == "surface" and not category.plain)


def _standing() -> list[str]:
    return sorted(name for name, category in CATALOGUE.items() if category.mount == "floor" and not category.plain)
