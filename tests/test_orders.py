import pytest

from thinkblox.errors import InputError
from thinkblox.generate import generate_room
from thinkblox.plan import Plan, Target, Tie, in_order
from thinkblox.planning import ExpertPlanner, reordered
from thinkblox.reading import GrammarBriefer
from thinkblox.scene.asset import Mount
from thinkblox.scene.room import rectangle
from thinkblox.value import Vec3

PROMPT = "A study with a desk, an office chair at the desk, a lamp and a vase on the desk, a wardrobe and a stool."


def plan() -> Plan:
    return ExpertPlanner().plan(GrammarBriefer("named").brief(PROMPT), rectangle(5.0, 4.0))


def usual(target: Target) -> tuple[Vec3, Mount]:
    from thinkblox.assets.source import ProceduralAssets

    return ProceduralAssets().usual(target.category)


def respected(targets: tuple[Target, ...]) -> bool:
    ids = [target.id for target in targets]
    return all(ids.index(anchor) < n for n, target in enumerate(targets) for anchor in target.depends_on)


def test_by_size_the_largest_that_waits_for_nothing_comes_first():
    planned = plan()
    by_size = reordered(planned, "size", usual, 0)
    assert by_size.targets[0].category == "wardrobe"
    assert {t.id for t in by_size.targets} == {t.id for t in planned.targets}
    assert respected(by_size.targets)


def test_by_chance_every_seed_has_its_order_and_none_breaks_what_depends_on_what():
    orders = {tuple(t.id for t in reordered(plan(), "random", usual, seed).targets) for seed in range(8)}
    assert len(orders) > 4
    assert all(respected(reordered(plan(), "random", usual, seed).targets) for seed in range(8))
    again = reordered(plan(), "random", usual, 3)
    assert again == reordered(plan(), "random", usual, 3)


def test_what_waits_for_itself_is_refused():
    a = Target(id="box_1", category="box", request="box", ties=(Tie(kind="near", anchors=("box_2",)),))
    b = Target(id="box_2", category="box", request="box", ties=(Tie(kind="near", anchors=("box_1",)),))
    with pytest.raises(InputError, match="wait for each other"):
        in_order([a, b])


def test_a_room_is_placed_in_the_order_that_is_wanted():
    room = generate_room("A study with a stool, a desk and a wardrobe.", fill="named", order="size")
    assert next(p.category for p in room.scene.placements) == "wardrobe"
    with pytest.raises(InputError, match="order is 'big'"):
        generate_room("A desk.", order="big")  # type: ignore[arg-type]
