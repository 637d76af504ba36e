"""What a brief asks for besides the usual: planned, placed by the expert, measured, and said in the last line."""

import numpy as np
import pytest

from thinkblox import printing
from thinkblox.assets.make import fit_asset, make_asset
from thinkblox.assets.showing import realised
from thinkblox.assets.states import shows_state, words_for
from thinkblox.brief import Brief, OpeningRequest, Relation, RelationKind, Request
from thinkblox.furnishing import Generation
from thinkblox.generate import generate_room
from thinkblox.headline import shortfalls
from thinkblox.placing import Effort
from thinkblox.plan import Plan
from thinkblox.planning import plan_brief
from thinkblox.scene.corners import corners_of
from thinkblox.scene.room import Room, rectangle
from thinkblox.verdict import Demand


class Told:
    """A briefer that has been told the brief."""

    def __init__(self, brief: Brief) -> None:
        self._brief = brief

    def brief(self, prompt: str) -> Brief:
        return self._brief


def made(brief: Brief, *, room: Room | None = None) -> Generation:
    return generate_room(brief.prompt, seed=1, room=room, briefer=Told(brief), effort=Effort(restarts=1))


def request(category: str, count: int = 1, *, key: str = "", **said: object) -> Request:
    return Request(key=key or category, category=category, count=count, **said)  # type: ignore[arg-type]


def relation(kind: RelationKind, subject: str, *anchors: str, **said: object) -> Relation:
    return Relation(kind=kind, subject=subject, anchors=anchors, **said)  # type: ignore[arg-type]


def brief(*parts: Request | Relation, **said: object) -> Brief:
    return Brief(
        prompt="told",
        requests=tuple(p for p in parts if isinstance(p, Request)),
        relations=tuple(p for p in parts if isinstance(p, Relation)),
        **said,  # type: ignore[arg-type]
    )


WHOLE = {
    "dining": brief(
        request("dining_table"),
        request("chair", 4),
        request("chair", 2, key="heads"),
        request("candle"),
        relation("at_long_side", "chair", "dining_table"),
        relation("at_short_side", "heads", "dining_table"),
        relation("in_centre", "candle", "dining_table"),
        room_type="dining_room",
    ),
    "inside": brief(
        request("shelving_unit", 2),
        request("jar", 8),
        request("basket"),
        request("toy", 2),
        request("book"),
        request("fridge"),
        request("bottle", 2),
        relation("inside", "jar", "shelving_unit"),
        relation("inside", "toy", "basket"),
        relation("outside", "book", "basket"),
        relation("inside", "bottle", "fridge"),
    ),
    "walls": brief(
        request("bed", 2, attributes=("single",)),
        request("desk", 2),
        request("pendant_lamp"),
        request("bookcase", 2),
        relation("against_wall", "bed", "one_wall"),
        relation("against_wall", "desk", "opposite_wall"),
        relation("against_wall", "bookcase", "wall", spread=2),
        relation("on", "pendant_lamp", "ceiling"),
        width=6.0,
        depth=5.0,
    ),
    "denied": brief(
        request("sofa", 2),
        request("plant"),
        request("floor_lamp"),
        relation("back_to_back", "sofa", "sofa"),
        relation("in_corner", "plant", "corner", negated=True),
        relation("near", "floor_lamp", "door", negated=True),
        relation("far", "floor_lamp", "plant"),
        excluded=("tv",),
        width=7.0,
        depth=6.0,
    ),
    "office": brief(
        request("desk", states=("empty",)),
        request("office_chair"),
        request("armchair", 2),
        relation("facing", "desk", "door"),
        relation("behind", "office_chair", "desk"),
        relation("in_front_of", "armchair", "desk"),
        width=5.0,
        depth=5.0,
    ),
    "mounted": brief(
        request("shelving_unit", attributes=("wall-mounted",)),
        request("chair", 2, least=1, most=4, attributes=("red", "wooden")),
        request("laptop", states=("open",)),
        request("table", attributes=("round",)),
        relation("on", "shelving_unit", "wall"),
        openings=(OpeningRequest(kind="window", count=0),),
    ),
}


@pytest.mark.parametrize("name", WHOLE)
def test_all_as_asked(name: str) -> None:
    result = made(WHOLE[name])
    assert shortfalls(result.report) == ()
    assert result.report.complete
    assert printing.outcome(result.report) == "all as asked"


SHORT = {
    "attribute": (brief(request("bathtub", unshown=("clawfoot",))), "not shown: clawfoot bathtub"),
    "state": (brief(request("dishwasher", states=("dirty",))), "noted, not shown: dirty dishwasher"),
    "carrying": (
        brief(request("desk", states=("empty",)), request("cup"), relation("on", "cup", "desk")),
        "noted, not shown: empty desk",
    ),
    "unknown": (brief(request("table"), unknown=("sprocketed",)), "not understood: sprocketed"),
    "missing": (brief(request("table"), missing=("two dragons",)), "not made: two dragons"),
    "size": (brief(request("table", size=(None, 30.0, None))), "table: "),
    "inside": (
        brief(request("table"), request("cup"), relation("inside", "cup", "table")),
        "not so: cup_1 inside table_1",
    ),
    "excluded": (brief(request("office_chair"), excluded=("chair",)), "not wanted, but there: office_chair_1"),
}


@pytest.mark.parametrize("name", SHORT)
def test_what_is_not_as_asked_is_said_in_the_last_line(name: str) -> None:
    asked, says = SHORT[name]
    report = made(asked).report
    assert report.valid
    assert not report.complete
    assert says in printing.outcome(report)
    assert printing.outcome(report).startswith("passed, but not all as asked: ")


def test_a_room_that_is_given_is_held_against_the_prompt() -> None:
    asked = brief(request("table"), width=5.0, depth=4.0)
    assert "room: 4 m by 3 m, asked for 5 m by 4 m" in printing.outcome(made(asked, room=rectangle(4.0, 3.0)).report)
    assert made(asked, room=rectangle(4.0, 5.0)).report.complete


@pytest.mark.slow
def test_at_least_is_enough_even_where_more_were_planned() -> None:
    small = rectangle(3.2, 2.6)
    few = made(brief(request("bed", 3, least=1)), room=small).report
    demand = next(d for d in few.demands if d.kind == "count")
    assert demand.holds
    assert demand.wanted == "at least 1"
    assert any(absence.asked for absence in few.absent)
    all_asked = made(brief(request("bed", 3)), room=small).report
    assert not all_asked.complete
    assert any(phrase.startswith("bed: ") and phrase.endswith("asked for 3") for phrase in shortfalls(all_asked))


def test_the_middle_stays_free() -> None:
    asked = brief(request("sofa"), request("table"), request("plant", 3), free=("centre",), width=5.0, depth=5.0)
    free = next(d for d in made(asked).report.demands if d.kind == "free")
    assert free.holds, free.measured


def test_a_wall_stays_free_but_for_what_is_called_there() -> None:
    asked = brief(
        request("projector_screen"),
        request("bookcase", 3),
        request("sofa"),
        relation("on", "projector_screen", "north_wall"),
        free=("north_wall",),
        width=5.0,
        depth=5.0,
    )
    free = next(d for d in made(asked).report.demands if d.kind == "free")
    assert free.holds, free.measured


def plan(asked: Brief) -> Plan:
    return plan_brief(asked, rectangle(5.0, 4.0))


def test_what_is_excluded_is_not_assumed() -> None:
    asked = brief(
        request("sofa"), request("wall_tv", asked=False), relation("facing", "sofa", "wall_tv"), excluded=("tv",)
    )
    assert [target.id for target in plan(asked).targets] == ["sofa_1"]
    assert plan(asked).target("sofa_1").ties == plan(brief(request("sofa"))).target("sofa_1").ties


def test_what_must_not_be_beside_something_comes_after_it() -> None:
    asked = brief(request("wardrobe"), request("stool"), relation("next_to", "wardrobe", "stool", negated=True))
    targets = plan(asked).targets
    assert [target.id for target in targets] == ["stool_1", "wardrobe_1"]
    assert targets[1].denied[0].anchors == ("stool_1",)
    assert not any(tie.kind == "next_to" for tie in targets[1].ties)


def test_two_that_must_not_be_beside_each_other_are_placed_all_the_same() -> None:
    asked = brief(
        request("wardrobe"),
        request("stool"),
        relation("next_to", "wardrobe", "stool", negated=True),
        relation("near", "stool", "wardrobe", negated=True),
    )
    assert sorted(target.id for target in plan(asked).targets) == ["stool_1", "wardrobe_1"]


def test_opposite_walls_are_opposite() -> None:
    sides = {tie.anchors[0] for target in plan(WHOLE["walls"]).targets for tie in target.ties if tie.asked}
    assert {"north_wall", "south_wall"} <= sides or {"east_wall", "west_wall"} <= sides


@pytest.mark.parametrize(
    ("category", "word", "shown"),
    [
        ("chair", "red", True),
        ("fridge", "red", True),
        ("plant", "red", False),
        ("plant", "green", True),
        ("bench", "metal", True),
        ("table", "wooden", True),
        ("table", "round", True),
        ("mirror", "round", True),
        ("wardrobe", "round", False),
        ("table", "rectangular", True),
        ("floor_lamp", "tall", True),
        ("sofa", "three-seat", True),
        ("sofa", "for-12", False),
        ("dining_table", "for-8", True),
        ("coffee_table", "for-12", False),
        ("play_table", "for-2", True),
        ("sofa", "leather", True),
        ("wardrobe", "sliding", False),
        ("office_chair", "swivel", True),
        ("bookcase", "filled", True),
        ("bookcase", "empty", True),
        ("chair", "haunted", False),
        ("mirror", "oval", True),
        ("side_table", "oval", True),
        ("wardrobe", "oval", False),
        ("dining_table", "hexagonal", True),
        ("coffee_table", "octagonal", True),
        ("desk", "hexagonal", False),
        ("side_table", "rectangular", True),
        ("stool", "square", True),
        ("chair", "folding", True),
        ("stool", "folding", True),
        ("wardrobe", "folding", False),
        ("stool", "swivel", True),
        ("bar_stool", "swivel", True),
        ("plant_stand", "round", True),
        ("stage_platform", "round", True),
        ("hopscotch_mat", "round", True),
        ("poker_table", "oval", True),
        ("potted_plant", "ceramic", True),
        ("potted_plant", "terracotta", True),
        ("chair", "striped", True),
        ("sofa", "dark", True),
        ("vanity", "dark", True),
        ("sink", "double", True),
        ("laundry_sink", "double", True),
        ("school_desk", "double", True),
        ("school_desk", "single", True),
        ("sofa", "single", False),
        ("shelving_unit", "open", True),
        ("wardrobe", "open", True),
        ("dresser", "open", False),
        ("waste_bin", "open", True),
        ("washing_machine", "front-loading", True),
        ("dishwasher", "front-loading", False),
    ],
)
def test_whether_an_attribute_is_seen(category: str, word: str, shown: bool) -> None:
    assert realised(make_asset(category, seed=3, attributes=(word,)), word) is shown


def test_a_long_table_seats_six_without_being_made_for_them() -> None:
    assert realised(make_asset("dining_table", seed=0, attributes=("long", "for-6")), "for-6")
    assert not realised(make_asset("dining_table", seed=0, attributes=("small",)), "for-6")


def test_a_square_table_for_four_stays_square() -> None:
    width, depth, _ = make_asset("square_table", seed=0, attributes=("for-4",)).size
    assert width == pytest.approx(depth, rel=0.1)


@pytest.mark.parametrize("words", [("red",), ("red", "wooden"), ("black", "metal"), ("leather", "green")])
def test_colour_and_material_are_both_seen(words: tuple[str, ...]) -> None:
    for category in ("chair", "sofa", "bench", "wardrobe", "table", "fridge"):
        asset = make_asset(category, seed=2, attributes=words)
        assert [word for word in words if not realised(asset, word)] == []


def test_states_that_are_seen() -> None:
    assert shows_state(make_asset("laptop", seed=1), "open")
    assert not shows_state(make_asset("dishwasher", seed=1), "open")
    assert shows_state(make_asset("dishwasher", seed=1), "closed")
    assert shows_state(make_asset("book", seed=1), "shut")
    assert not shows_state(make_asset("laptop", seed=1), "closed")
    assert shows_state(make_asset("picture", seed=1), "framed")
    assert not shows_state(make_asset("poster", seed=1), "framed")
    assert not shows_state(make_asset("bookcase", seed=1, attributes=("filled",)), "empty")


@pytest.mark.parametrize("category", ["dining_table", "bookcase", "vanity"])
def test_what_is_of_dark_wood_is_both(category: str) -> None:
    for seed in range(4):
        asset = make_asset(category, seed=seed, attributes=("dark", "wooden"))
        assert [realised(asset, word) for word in ("dark", "wooden")] == [True, True]


def test_a_double_sink_has_two_bowls() -> None:
    bowls = [s for s in make_asset("sink", seed=1, attributes=("double",)).surfaces if s.within]
    assert len(bowls) == 2
    assert bowls[0].position[1] + bowls[0].size[1] / 2 < bowls[1].position[1] - bowls[1].size[1] / 2


@pytest.mark.parametrize(("share", "shown"), [(1.0, True), (1.1, True), (1.5, False)])
def test_a_small_table_that_was_made_larger_is_not_small(share: float, shown: bool) -> None:
    small = make_asset("side_table", seed=3, attributes=("small",))
    x, y, z = small.size
    assert realised(fit_asset(small, (share * x, share * y, z)), "small") is shown


def test_what_is_always_made_so_is_as_asked_though_it_is_no_look() -> None:
    machines = request("washing_machine", 2, unshown=("front-loading", "haunted"))
    found = {d.wanted: d.holds for d in made(brief(machines)).report.demands if d.kind == "attribute"}
    assert found == {"front-loading": True, "haunted": False}


@pytest.mark.parametrize(("category", "word"), [("dining_table", "oval"), ("mirror", "oval"), ("table", "hexagonal")])
def test_what_is_of_another_outline_is_not_rectangular(category: str, word: str) -> None:
    assert realised(make_asset(category, seed=3), "rectangular")
    assert not realised(make_asset(category, seed=3, attributes=(word,)), "rectangular")


@pytest.mark.parametrize("category", ["stool", "folding_table"])
def test_the_legs_of_a_round_thing_stand_under_its_top(category: str) -> None:
    asset = make_asset(category, seed=3, attributes=("round",))
    points = np.vstack([corners_of(shape) for link in asset.links for shape in link.shapes])
    assert np.hypot(points[:, 0], points[:, 1]).max() <= asset.size[0] / 2 + 0.003


@pytest.mark.parametrize(
    ("category", "state", "other"),
    [
        ("towels", "rolled up", "folded"),
        ("book", "open", "closed"),
        ("spell_book", "open", "closed"),
        ("laptop", "closed", "open"),
        ("wall_map", "framed", ""),
        ("poster", "framed", ""),
        ("toy_box", "opened", "closed"),
        ("box", "empty", "closed"),
        ("wardrobe", "open", "closed"),
        ("fridge", "open", "shut"),
        ("dishwasher", "open", "closed"),
        ("locker", "open", "closed"),
        ("safe", "open", "closed"),
        ("cabinet", "open", "closed"),
        ("washing_machine", "open", "closed"),
    ],
)
def test_what_is_made_in_a_state_shows_it_and_no_other(category: str, state: str, other: str) -> None:
    usual = make_asset(category, seed=1)
    made_so = make_asset(category, seed=1, attributes=tuple(words_for(category, (state,))))
    assert [shows_state(asset, state) for asset in (usual, made_so)] == [False, True]
    assert not other or [shows_state(asset, other) for asset in (usual, made_so)] == [True, False]


@pytest.mark.parametrize("words", [("open",), ("open", "four-door"), ("open", "single")])
def test_open_doors_stand_before_what_they_close(words: tuple[str, ...]) -> None:
    shut, opened = (make_asset("wardrobe", seed=4, attributes=said) for said in (words[1:], words))
    assert opened.size[1:] == pytest.approx(shut.size[1:], abs=0.15)
    assert opened.size[0] > shut.size[0] + 0.25
    doors = [link for link in opened.links if link.joint is not None and link.joint.lower < 0.0]
    assert 1 <= len(doors) <= 2
    for door in doors:
        points = np.vstack([corners_of(shape) for shape in door.shapes])
        assert points[:, 0].max() == pytest.approx(opened.size[0] / 2, abs=0.02)
    assert all(surface.position[0] < 0.0 for surface in opened.surfaces)
    assert opened.mass == pytest.approx(shut.mass, rel=0.2)


def test_an_open_dishwasher_stands_in_the_line_of_cabinets() -> None:
    line = (request("dishwasher", states=("open",)), request("base_cabinet", 2))
    generation = made(brief(*line, relation("next_to", "dishwasher", "base_cabinet"), room_type="kitchen"))
    assert generation.report.complete
    assert generation.report.valid


@pytest.mark.parametrize(
    ("category", "word", "seen"),
    [
        ("basket", "empty", True),
        ("wall_shelf", "bare", True),
        ("dining_table", "bare", True),
        ("bed", "empty", True),
        ("bed", "bare", False),
        ("bottle", "empty", False),
        ("bird_cage", "empty", False),
        ("drying_rack", "empty", False),
        ("box", "empty", False),
        ("mirror", "empty", False),
    ],
)
def test_only_what_has_a_place_for_things_is_seen_to_be_empty(category: str, word: str, seen: bool) -> None:
    assert shows_state(make_asset(category, seed=1), word) is seen


def state_of(generation: Generation, subject: str) -> Demand:
    return next(d for d in generation.report.demands if d.kind == "state" and d.subject == subject)


def test_what_lies_on_an_empty_table_is_counted() -> None:
    table = request("dining_table", states=("bare",))
    demand = state_of(made(brief(table)), "dining table")
    assert (demand.holds, demand.measured) == (True, "0 in or on it")
    laid = brief(table, request("bowl", 2), relation("on", "bowl", "dining_table"))
    demand = state_of(made(laid), "dining table")
    assert (demand.holds, demand.measured) == (False, "2 in or on it")


def test_what_is_stacked_lies_on_another_of_its_kind() -> None:
    boxes = (request("box"), request("box", key="other", states=("stacked",)))
    demand = state_of(made(brief(*boxes, relation("on", "other", "box"))), "box")
    assert (demand.holds, demand.measured) == (True, "1 of 1 on or under another one")
    demand = state_of(made(brief(request("tyre", 2, states=("stacked",)))), "tyre")
    assert (demand.holds, demand.measured) == (False, "0 of 2 on or under another one")


def test_a_long_list_is_cut_short() -> None:
    report = made(brief(request("table", unshown=("a", "b", "c", "d", "e", "f")))).report
    assert printing.outcome(report).endswith("; and 2 more")
    assert all(isinstance(demand, Demand) for demand in report.demands)


def test_a_room_that_seats_fewer_than_it_is_for_says_so() -> None:
    asked = (request("table"), request("chair", count=2))
    assert "seat: 2 of 3, asked for 3" in shortfalls(made(brief(*asked, room_type="dining_room", people=3)).report)
