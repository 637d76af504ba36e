"""Kitchens as a planner draws them: runs that fill their walls, filled corners, the order in which one cooks."""

import itertools

import pytest

from thinkblox import generate_room
from thinkblox.assets.make import make_thing
from thinkblox.planning import plan_room, with_run
from thinkblox.policies.expert.run_layouts import GAP, RunLayout, layouts
from thinkblox.policies.expert.run_orders import RunMember, order_cost, ways_cost
from thinkblox.reading import read_brief
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.stretches import is_inner_corner, stretches

WALLS = frozenset(range(4))
DOOR = Opening(id="door_1", kind="door", wall=1, offset=0.2, width=0.9, height=2.1)
ROOM = rectangle(4.0, 3.4, openings=(DOOR,))


def member(
    name: str, *, width: float = 0.6, tall: bool = False, hot: bool = False, wet: bool = False, open_: bool = False
) -> RunMember:
    size = (0.62, width, 1.8 if tall else 0.9)
    return RunMember(name, size, not tall, WALLS, window=False, hot=hot, wet=wet, open=open_)


def corner(name: str) -> RunMember:
    return RunMember(name, (0.9, 0.9, 0.9), True, WALLS, window=False, corner=True)


RUN = [member("sink", wet=True), member("hob", hot=True), member("fridge", width=0.64, tall=True)]
PLAIN = [member(f"unit_{n}", open_=True) for n in range(3)]


def best(members: list[RunMember], meant: str = "") -> RunLayout:
    return min(layouts(ROOM, members, meant), key=lambda layout: layout.cost)


def test_a_wall_is_free_between_its_corners_its_doors_and_those_that_swing_there() -> None:
    assert [*stretches(ROOM, 0, depth=0.64, height=0.9)[0]] == pytest.approx([0.0, 3.1])
    first, second = stretches(ROOM, 1, depth=0.64, height=0.9)
    assert [*first, *second] == pytest.approx([0.0, 0.16, 1.14, 3.4])
    low = Opening(id="window_1", kind="window", wall=2, offset=1.0, width=1.2, height=1.2, sill=0.5)
    lit = rectangle(4.0, 3.4, openings=(low,))
    assert [end for span in stretches(lit, 2, depth=0.64, height=0.9) for end in span] == pytest.approx([0, 1, 2.2, 4])
    assert stretches(lit, 2, depth=0.64, height=0.6) == [(0.0, 4.0)]
    assert all(is_inner_corner(ROOM, number) for number in range(4))


def test_a_run_fills_its_wall() -> None:
    found = best([*RUN, *PLAIN])
    widths = [slot.member.size[1] for slot in found.slots]
    assert len({slot.wall for slot in found.slots}) == 1
    assert sum(widths) > 3.9 or sum(widths) > 3.3
    assert found.slots[0].member.is_tall or found.slots[-1].member.is_tall


def test_a_run_goes_round_as_many_corners_as_it_has_units_for() -> None:
    one = best([*RUN, *PLAIN, corner("corner_1")], "corner")
    two = best([*RUN, *PLAIN, corner("corner_1"), corner("corner_2")], "sides")
    assert [len({slot.wall for slot in found.slots}) for found in (one, two)] == [2, 3]
    unit = next(slot for slot in one.slots if slot.member.corner)
    beside = next(slot for slot in one.slots if slot.wall == unit.wall and not slot.member.corner)
    gap = beside.along - unit.along - (beside.member.size[1] + unit.member.size[1]) / 2
    assert gap == pytest.approx(GAP, abs=0.003)


def test_one_cooks_between_worktops_and_fetches_what_is_cold_past_the_sink() -> None:
    sink, hob, fridge, a, b = (*RUN, *PLAIN[:2])
    assert order_cost([sink, a, hob, b]) < order_cost([a, sink, hob, b]) < order_cost([a, b, sink, hob])
    assert ways_cost([fridge, sink, a, hob, b]) == 0.0 < ways_cost([fridge, a, hob, b, sink])


def test_what_is_asked_to_stand_by_the_fridge_does_so_and_on_the_side_that_is_said() -> None:
    hob = member("hob", hot=True)._replace(beside=frozenset(("fridge", "sink")))
    line = [slot.member.id for slot in best([RUN[0], hob, RUN[2], *PLAIN]).slots]
    assert {line[line.index("hob") - 1], line[line.index("hob") + 1]} == {"fridge", "sink"}
    by = frozenset(("hob",))
    beside = RUN[2]._replace(beside=by)
    for cold, first in ((beside._replace(left_of=by), "fridge"), (beside._replace(right_of=by), "hob")):
        line = [slot.member.id for slot in best([*RUN[:2], cold, *PLAIN]).slots]
        at = line.index(first)
        assert {*line[at : at + 2]} == {"fridge", "hob"}


@pytest.mark.parametrize("seed", [0, 1])
def test_a_stove_between_fridge_and_dishwasher_has_its_hood(seed: int) -> None:
    done = generate_room(
        "This kitchen has a stove between a refrigerator and a dishwasher, all of them along one wall. "
        "Mounted above the stove is a range hood.",
        seed=seed,
    )
    assert all(relation.holds for relation in done.report.relations)


@pytest.mark.parametrize(
    ("prompt", "corners", "least"),
    [
        ("A 5 by 4 m kitchen", 0, 6),
        ("A kitchen of 2.4 x 2.6 m", 1, 3),
        ("A U-shaped kitchen, 3.2 by 3.6 m", 2, 4),
        ("An L-shaped kitchen, 4 by 3.5 m", 1, 5),
        ("A 5 by 4 m kitchen with two kitchen cabinets", 0, 2),
    ],
)
def test_a_kitchen_has_as_many_cabinets_as_its_walls_take(prompt: str, corners: int, least: int) -> None:
    brief = read_brief(prompt)
    run = with_run(brief, plan_room(brief, rng=0), 0)
    counts = {request.category: request.count for request in run.requests}
    assert counts.get("corner_cabinet", 0) == corners
    assert counts["base_cabinet"] >= least
    assert counts["base_cabinet"] == 2 or least > 2


def test_what_a_kitchen_is_called_by_is_understood() -> None:
    kinds = {
        "An L-shaped kitchen": "corner_kitchen",
        "A U-shaped kitchen with a table": "u_kitchen",
        "A kitchen with L-shaped cabinets and a fridge": "corner_kitchen",
        "The kitchenette of a small office": "kitchenette",
    }
    for prompt, kind in kinds.items():
        brief = read_brief(prompt)
        assert (brief.room_type, brief.unknown, brief.shape) == (kind, (), "rectangle")


def test_worktops_of_a_room_are_one() -> None:
    names = ("base_cabinet", "corner_cabinet", "dishwasher", "oven")
    for seed in range(3):
        tops = {
            shape.colour
            for name in names
            for link in make_thing(name, seed=seed).links
            for shape in link.shapes
            if shape.position[2] > 0.87
        }
        assert len(tops) == 1


@pytest.mark.slow
def test_wall_cabinets_hang_in_line_over_the_run_and_the_hood_over_the_hob() -> None:
    scene = generate_room("A kitchen", seed=0).scene
    hob, hood = scene["hob_1"], scene["range_hood_1"]
    assert max(abs(a - b) for a, b in zip(hob.position[:2], hood.position[:2], strict=True)) < 0.3
    uppers = [p for p in scene.placements if p.category == "wall_cabinet"]
    units = [p for p in scene.placements if p.category == "base_cabinet"]
    assert uppers
    assert len({round(p.position[2], 2) for p in uppers}) == 1
    for upper in uppers:
        below = [u for u in units if abs(upper.to_local((u.position[0], u.position[1]))[1]) < upper.size[1] / 2]
        assert below
        assert all(u.yaw == upper.yaw for u in below)
    line = sorted(units, key=lambda u: u.to_local((0.0, 0.0))[1])
    for one, other in itertools.pairwise(line):
        along = abs(one.to_local((other.position[0], other.position[1]))[1])
        assert along < (one.size[1] + other.size[1]) / 2 + 0.75
