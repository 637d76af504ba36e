"""What is asked for in number and place is there in that number and place, and not by a hair or by chance."""

import msgspec
import pytest
from msgspec.structs import replace

from thinkblox.assets import make_asset
from thinkblox.assets.showing import realised
from thinkblox.generate import generate_room
from thinkblox.scene.asset import Asset
from thinkblox.scene.relations import measure


def _held(prompt: str, kind: str, subject: str) -> list[bool]:
    """Whether each relation of a kind and of a category of subjects holds in the room of a prompt."""
    report = generate_room(prompt, seed=0).report
    return [r.holds for r in report.relations if r.kind == kind and r.subject.startswith(subject)]


def test_what_is_between_two_beds_is_next_to_both() -> None:
    prompt = "A sickroom with two beds. Between the two beds is a white cabinet. A folding screen is in the corner."
    assert _held(prompt, "next_to", "cabinet") == [True, True]


def test_hooks_hang_over_the_bench_and_not_beside_it() -> None:
    room = generate_room(
        "A hall with a bench against the wall and five coat hooks on the wall above the bench.", seed=0
    )
    bench = room.scene["bench_1"]
    hooks = [p for p in room.scene.placements if p.category == "coat_hooks"]
    assert len(hooks) == 5
    assert all(abs(bench.to_local(hook.position[:2])[1]) <= bench.size[1] / 2 for hook in hooks)


def test_a_chair_next_to_each_desk_is_drawn_up_to_it() -> None:
    room = generate_room("A classroom with six student desks, each with a blue chair next to it.", seed=0)
    chairs = [p.id for p in room.scene.placements if p.category == "chair"]
    desks = [p.id for p in room.scene.placements if p.category == "school_desk"]
    taken = [[desk for desk in desks if measure(room.scene, "at", chair, (desk,)).holds] for chair in chairs]
    assert sorted(found[0] for found in taken) == sorted(desks)


def test_chairs_of_two_colours_have_a_desk_each() -> None:
    prompt = (
        "A loft with four desks; next to each desk is a swivel chair. Two of the swivel chairs are orange, "
        "the other two grey."
    )
    report = generate_room(prompt, seed=0).report
    desks = [r.anchors for r in report.relations if r.kind == "next_to" and r.subject.startswith("office_chair")]
    assert len(set(desks)) == len(desks) == 4
    assert report.complete


@pytest.mark.parametrize(("share", "shown"), [(1.0, True), (1.35, False)])
def test_a_narrow_desk_that_was_made_wider_is_not_narrow(share: float, shown: bool) -> None:
    desk = make_asset("desk", seed=1, attributes=("narrow",))
    wider = replace(desk, size=(desk.size[0] * share, desk.size[1] * share, desk.size[2]))
    assert realised(wider, "narrow") is shown


def test_a_long_lamp_is_a_bar() -> None:
    lamp = make_asset("pendant_lamp", seed=1, attributes=("long",))
    assert realised(lamp, "long")
    assert not realised(make_asset("pendant_lamp", seed=1), "long")


def test_a_lying_tyre_is_one_solid() -> None:
    tyre = make_asset("tire", seed=1)
    assert sum(shape.collide for link in tyre.links for shape in link.shapes) == 1
    assert msgspec.json.encode(tyre)


def test_a_thing_inside_another_calls_for_nothing_to_lie_on() -> None:
    prompt = "A bathroom with a wall cabinet. Two towels are inside the wall cabinet."
    asked = {p.category for p in generate_room(prompt, seed=0, fill="named").scene.placements}
    assert asked == {"wall_cabinet", "towels"}


@pytest.mark.parametrize("pattern", ["striped", "checked"])
@pytest.mark.parametrize("category", ["rug", "pillow", "sofa", "blanket"])
@pytest.mark.parametrize("colour", ["red", "white", "yellow"])
def test_cloth_has_the_pattern_and_keeps_its_colour(category: str, pattern: str, colour: str) -> None:
    made = make_asset(category, seed=3, attributes=(colour, pattern))
    assert realised(made, pattern)
    assert realised(made, colour)
    plain = make_asset(category, seed=3, attributes=(colour,))
    assert _touched(made) == _touched(plain)


def _touched(asset: Asset) -> int:
    """How many of its shapes collide."""
    return sum(shape.collide for link in asset.links for shape in link.shapes)


def test_a_wooden_table_cannot_be_striped() -> None:
    assert not realised(make_asset("table", seed=1, attributes=("striped",)), "striped")


def test_a_table_seats_all_whom_it_is_said_to() -> None:
    room = generate_room("A boardroom with a table that seats twelve people.", seed=0)
    assert sum(p.category == "office_chair" for p in room.scene.placements) == 12
    assert [d.measured for d in room.report.demands if d.subject == "seat"] == ["12 of 12"]


def test_what_is_not_to_be_opposite_a_window_is_before_none() -> None:
    room = generate_room("A living room where the TV is not opposite a window.", seed=0)
    windows = [opening.id for opening in room.scene.room.openings if opening.kind == "window"]
    assert room.report.complete
    assert all(measure(room.scene, "opposite", "tv_1", (id,), negated=True).holds for id in windows)


def test_nothing_hangs_on_walls_that_are_to_be_bare() -> None:
    room = generate_room("A student room with a desk and nothing on the walls.", seed=0)
    hung = {p.category for p in room.scene.placements if room.scene.asset_of(p).mount == "wall"}
    assert hung == set()


def test_who_faces_the_wall_has_it_before_them() -> None:
    room = generate_room("A chair in the corner that faces the wall.", seed=0)
    assert room.report.complete
    assert not measure(room.scene, "facing", "chair_1", ("wall",), negated=True).holds


def test_a_lectern_carries_a_laptop() -> None:
    report = generate_room("A hall. A lectern with a laptop on it.", seed=0).report
    assert report.complete
    assert [r.holds for r in report.relations if r.subject == "laptop_1"] == [True]


def test_what_is_not_to_be_at_a_wall_is_in_no_corner_by_habit() -> None:
    assert (
        _held("A lounge with two beanbags, neither of them against a wall.", "against_wall", "bean_bag") == [True] * 2
    )


def test_the_third_desk_is_not_of_oak_where_one_of_three_is() -> None:
    prompt = "Three desks. The first is made of oak. The second is glass. A printer stands on the third."
    scenes = [generate_room(prompt, seed=seed).scene for seed in (0, 1)]
    desks = [[scene.asset_of(p) for p in scene.placements if p.category == "desk"] for scene in scenes]
    assert [sum(realised(desk, "oak") for desk in found) for found in desks] == [1, 1]
