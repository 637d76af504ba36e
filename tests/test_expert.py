"""The expert's taste, piece by piece: what it wants of the floor, of rows, of seats and of what stands on tables."""

import math
from functools import cache
from itertools import combinations

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from thinkblox.assets import make_asset
from thinkblox.assets.source import ProceduralAssets
from thinkblox.furnishing import Generation
from thinkblox.generate import generate_room
from thinkblox.knowledge.uses import MAIN_WAY, SIDE_WAY, uses
from thinkblox.observe import Observation, kinds_of, observe
from thinkblox.placing import Effort
from thinkblox.plan import Plan, Target, Tie
from thinkblox.planning import plan_brief
from thinkblox.policies.expert import ExpertPolicy, hung
from thinkblox.policies.expert.followers import follower_costs
from thinkblox.policies.expert.ground import ground_costs, used_costs
from thinkblox.policies.expert.imagine import ELSEWHERE, from_ties
from thinkblox.policies.expert.judge import ranked
from thinkblox.policies.expert.needs import need
from thinkblox.policies.expert.row_layout import layouts
from thinkblox.policies.expert.sight import sight_costs
from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.ways import CLOSED, gap_cost, imbalance, moment
from thinkblox.reading import read_brief
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects, outside, overlap_depth, separation
from thinkblox.scene.relations import measure
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at
from thinkblox.scene.zones import beside

ONCE = Effort(restarts=0)


def seen(scene: Scene, plan: Plan, target: Target, *, seed: int) -> Observation:
    kinds = kinds_of(plan, ProceduralAssets())
    return observe(scene, plan, target, make_asset(target.category, seed=seed), kinds=kinds)


def situation(category: str, *ties: Tie, stands: tuple[tuple[str, float, float, float], ...] = ()) -> Situation:
    """A room of 6 m by 5 m in which some things stand (category, x, y, yaw) and one is to be placed."""
    scene = Scene(prompt="", seed=0, room=rectangle(6.0, 5.0))
    for number, (kind, x, y, yaw) in enumerate(stands, 1):
        asset = make_asset(kind, seed=1)
        scene = scene.with_placement(
            placed_at(scene, asset, id=f"{kind}_{number}", position=(x, y, 0.0), yaw=yaw), asset
        )
    target = Target(id=f"{category}_9", category=category, request=category, ties=ties)
    plan = Plan(brief=read_brief("A room with a chair."), targets=(target,))
    return Situation(seen(scene, plan, target, seed=1))


def boxes(s: Situation, *poses: tuple[float, float, float]) -> Rects:
    return Rects.of([((x, y), s.size[:2], yaw, 0.0, s.size[2]) for x, y, yaw in poses])


@cache
def room(prompt: str, seed: int = 0) -> Generation:
    return generate_room(prompt, seed=seed, effort=ONCE)


def of(generation: Generation, category: str) -> list[Placement]:
    return [p for p in generation.scene.placements if p.category == category]


def gap(a: Placement, b: Placement) -> float:
    return float(separation(Rects.of_placements((a,)), Rects.of_placements((b,)))[0, 0])


# ---------------------------------------------------------------- floor


def test_a_pool_table_needs_floor_all_round_and_a_wide_bed_on_both_sides():
    pool, wide, narrow = (uses(c, s, "one", 0.6) for c, s in (
        ("pool_table", (1.4, 2.5, 0.8)), ("bed", (2.0, 1.6, 0.9)), ("bed", (2.0, 0.9, 0.9))
    ))  # fmt: skip
    assert [(len(u.sides), u.number, u.depth) for u in pool] == [(4, 4, 1.2)]
    assert [u.number for u in wide if "left" in u.sides] == [2]
    assert [u.number for u in narrow if "left" in u.sides] == [1]
    assert uses("chair", (0.5, 0.5, 0.8), "one", 0.5) == ()


def test_floor_that_is_missing_for_use_costs_more_the_more_is_missing():
    s = situation("pool_table")
    free, near, nearer = used_costs(s, boxes(s, (3.0, 2.5, 90.0), (1.9, 2.5, 90.0), (1.5, 2.5, 90.0)))
    assert free == pytest.approx(0.0)
    assert 0.0 < near < nearer


def test_what_stands_free_keeps_a_way_or_closes_the_gap():
    s = situation("wardrobe", stands=(("bookcase", 3.0, 0.2, 90.0),))
    other = s.scene.placements[0]
    x = other.position[0] + (other.size[1] + s.size[1]) / 2
    y = s.size[0] / 2 + 0.02
    flush, narrow, wide = ground_costs(s, boxes(s, (x + 0.01, y, 90.0), (x + 0.3, y, 90.0), (x + 1.0, y, 90.0)))
    assert flush < narrow
    assert wide < narrow


@given(st.floats(0.0, 3.0), st.floats(0.0, 3.0))
def test_a_wider_gap_never_costs_more_once_it_is_a_gap(one: float, other: float):
    low, high = sorted((one, other))
    costs = gap_cost(np.array([low, high]))
    assert (costs >= 0.0).all()
    if low > CLOSED:
        assert costs[0] >= costs[1]
    if low >= MAIN_WAY or high <= CLOSED:
        assert costs[1] == 0.0
    assert gap_cost(np.array([SIDE_WAY / 2]))[0] > gap_cost(np.array([SIDE_WAY]))[0]


def test_weight_on_the_other_side_balances_a_room():
    s = situation("wardrobe", stands=(("wardrobe", 0.4, 2.5, 0.0),))
    same, other = imbalance(s, moment(s.room, boxes(s, (0.4, 1.0, 0.0), (5.6, 2.5, 180.0))))
    assert other < same


def test_the_side_of_a_box_is_beside_it():
    box = Rects.of([((1.0, 1.0), (0.4, 1.0), 90.0, 0.0, 1.0)])
    ahead, left = beside(box, "front", 0.5), beside(box, "left", 0.5, width=0.2)
    assert ahead.centre[0] == pytest.approx((1.0, 1.45))
    assert left.centre[0] == pytest.approx((0.25, 1.0))
    assert overlap_depth(box, ahead).max() == pytest.approx(0.0, abs=1e-9)


def test_desks_are_faced_from_behind_and_seats_from_before():
    follower = Target(id="desk_2", category="desk", request="desk")
    tie = Tie(kind="facing", anchors=("desk_1",))
    of_desk, of_sofa = (need(follower, tie, of=kind, size=(0.7, 1.4, 0.75)) for kind in ("desk", "sofa"))
    assert of_desk is not None
    assert of_sofa is not None
    assert (of_desk.sides, of_sofa.sides) == (("back",), ("front",))


@given(st.lists(st.tuples(st.floats(-1, 7), st.floats(-1, 6), st.floats(0, 360)), min_size=1, max_size=8))
def test_the_share_outside_a_rectangle_is_the_area_outside(poses):
    rects = Rects.of([((x, y), (0.8, 0.5), yaw, 0.0, 1.0) for x, y, yaw in poses])
    plain = rectangle(6.0, 5.0).polygon
    quick = outside(rects, plain)
    slow = [1.0 - p.intersection(plain).area / p.area for p in map(_polygon, rects.corners)]
    assert quick == pytest.approx(slow, abs=1e-6)


def _polygon(corners):
    from shapely import Polygon

    return Polygon(corners)


# ---------------------------------------------------------------- rows


@given(st.integers(2, 12), st.integers(1, 3))
def test_every_layout_of_rows_has_a_slot_for_each_and_none_overlap(count: int, rows: int):
    tie = Tie(kind="in_rows", count=count, rows=min(rows, count))
    s = situation("chair", tie)
    for layout in layouts(s, tie, facing=(), mutual=False):
        assert len(layout.slots) == len(layout.yaws) == count
        rects = Rects.of([(c, s.size[:2], yaw, 0.0, 1.0) for c, yaw in zip(layout.slots, layout.yaws, strict=True)])
        depth = overlap_depth(rects, rects)
        np.fill_diagonal(depth, 0.0)
        assert depth.max() <= 1e-9


@given(st.integers(4, 16))
def test_many_desks_stand_in_blocks_back_to_back(count: int):
    s = situation("desk", Tie(kind="in_rows", count=count, rows=2, asked=False))
    s = Situation(msgspec.structs.replace(s.observation, target=msgspec.structs.replace(s.target, count=count)))
    for layout in layouts(s, s.target.ties[0], facing=(), mutual=False):
        assert len(layout.slots) == len(layout.yaws) == count
        assert len({round(yaw) for yaw in layout.yaws}) == 2
        rects = Rects.of([(c, s.size[:2], yaw, 0.0, 1.0) for c, yaw in zip(layout.slots, layout.yaws, strict=True)])
        depth = overlap_depth(rects, rects)
        np.fill_diagonal(depth, 0.0)
        assert depth.max() <= 1e-9


def test_rows_of_bookcases_keep_their_aisle_and_the_table_its_way_round():
    done = room("A bookstore, 8x6 m: rows of bookcases with aisles between them and a display table in the middle.")
    table, cases = of(done, "display_table")[0], of(done, "bookcase")
    assert all(gap(table, case) >= 0.6 for case in cases)
    gaps = [gap(a, b) for a, b in combinations(cases, 2)]
    assert all(g < 0.05 or g >= 0.85 for g in gaps)


def test_seats_in_rows_are_exactly_in_line():
    chairs = of(room("A waiting room with two rows of five chairs facing each other."), "chair")
    assert len({round(c.position[0], 2) for c in chairs}) in (2, 5)
    assert len({round(c.position[1], 2) for c in chairs}) in (2, 5)


# ---------------------------------------------------------------- groups


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_a_sofa_looks_at_the_screen_from_a_good_distance(seed: int):
    done = generate_room(
        "A living room with a sofa facing a TV on a TV stand and a coffee table between them.", seed=seed
    )
    sofa, stand, table = (of(done, c)[0] for c in ("sofa", "tv_stand", "coffee_table"))
    assert 1.7 <= gap(sofa, stand) <= 3.6
    assert gap(sofa, table) >= 0.3
    ahead = stand.to_local((sofa.position[0], sofa.position[1]))
    assert ahead[0] > 0.0
    assert abs(ahead[1]) < 0.5


def test_seats_gather_about_the_table_and_leave_the_screen_in_sight():
    done = room("A living room, 6 by 6 metres, with a sofa facing a TV, two armchairs and a coffee table.", 3)
    sofa, screen, table = (of(done, c)[0] for c in ("sofa", "tv", "coffee_table"))
    ahead, aside = sofa.to_local(screen.position[:2])
    assert 1.5 < ahead - sofa.size[0] / 2 < 3.6
    assert abs(aside) < 0.3
    for seat in of(done, "armchair"):
        assert gap(seat, table) < 0.8
        assert seat.to_local(screen.position[:2])[0] > 0.0
        assert abs(sofa.to_local(seat.position[:2])[1]) > sofa.size[1] / 4


def test_sofas_around_a_low_table_leave_room_for_legs_and_none_has_its_back_to_the_screen():
    done = room("A living room, 5 by 5 metres, with a sofa and two armchairs around a coffee table and a TV.", 5)
    screen, table = of(done, "tv")[0], of(done, "coffee_table")[0]
    for seat in (*of(done, "sofa"), *of(done, "armchair")):
        assert 0.3 <= gap(seat, table) <= 0.6
        assert seat.to_local(screen.position[:2])[0] > 0.0
    assert measure(done.scene, "around", [p.id for p in of(done, "armchair")], [table.id]).holds


def test_two_desks_that_face_each_other_stand_back_to_back():
    one, other = of(room("A small office with two desks facing each other, each with an office chair."), "desk")
    assert abs((one.yaw - other.yaw) % 360.0 - 180.0) < 1.0
    assert gap(one, other) < 0.7
    assert one.to_local((other.position[0], other.position[1]))[0] < 0.0


def test_each_window_has_a_desk_of_its_own():
    done = room("A study with three windows and a desk under each of them.")
    desks, windows = of(done, "desk"), [o.id for o in done.scene.room.openings if o.kind == "window"]
    assert len(windows) == 3
    for window in windows:
        assert sum(measure(done.scene, "next_to", desk.id, [window]).holds for desk in desks) == 1


def test_a_sofa_has_its_back_to_what_it_faces_away_from():
    done = room("A living room with a sofa that faces away from the window, and a TV opposite it.")
    assert measure(done.scene, "facing_away", "sofa_1", ["window"]).holds


def test_chairs_at_one_table_are_drawn_up_alike():
    done = room("A dining room with a long table with six chairs around it.")
    table = of(done, "dining_table")[0]
    across = [abs(table.to_local((c.position[0], c.position[1]))[0]) for c in of(done, "chair")]
    assert max(across) - min(across) < 0.02


def test_each_seat_has_its_plate_before_it():
    done = room("A dining room with a table with four chairs around it and four plates on it.")
    chairs, plates = of(done, "chair"), of(done, "plate")
    assert len(plates) == 4
    before = [min(abs(c.to_local(p.position[:2])[1]) for c in chairs) for p in plates]
    nearest = {min(chairs, key=lambda c: math.dist(c.position[:2], p.position[:2])).id for p in plates}
    assert len(nearest) == 4
    assert max(before) < 0.05


def test_what_hangs_above_two_things_hangs_between_them():
    done = room("A laundry room with a washing machine beside a dryer and a shelf above them with two boxes.")
    shelf = of(done, "wall_shelf")[0]
    machines = [*of(done, "washing_machine"), *of(done, "dryer")]
    centre = np.mean([p.position[:2] for p in machines], axis=0)
    assert math.dist(shelf.position[:2], centre) < 0.5
    assert {p.support for p in of(done, "box")} == {shelf.id}


def test_a_pool_table_in_the_middle_is_played_from_every_side():
    done = room("A game room with a pool table in the centre, a sofa and two arcade cabinets side by side.")
    pool = of(done, "pool_table")[0]
    assert all(gap(pool, p) >= 0.9 for p in done.scene.placements if p.support == "floor" and p.id != pool.id)


# ---------------------------------------------------------------- speech


def test_the_same_generator_gives_the_same_texts():
    brief = read_brief("A bedroom with a bed and a wardrobe.")
    scene = Scene(prompt="", seed=0, room=rectangle(4.0, 4.0))
    plan = plan_brief(brief, scene.room)
    target = plan.targets[0]
    observation = seen(scene, plan, target, seed=0)
    one, two = (ExpertPolicy().propose(observation, 8, np.random.default_rng(5)) for _ in range(2))
    assert one == two
    assert len(set(one)) == 8


def test_what_comes_onto_a_shelf_keeps_clear_of_what_is_there():
    scene = Scene(prompt="", seed=0, room=rectangle(6.0, 5.0))
    case, row = make_asset("bookcase", seed=1), make_asset("book_row", seed=1)
    scene = scene.with_placement(placed_at(scene, case, id="bookcase_1", position=(3.0, 0.2, 0.0), yaw=90.0), case)
    shelves = [s for s in case.surfaces if s.headroom is not None]
    for number, shelf in enumerate(shelves, 1):
        at = (3.0 - shelf.position[1], 0.2, shelf.position[2])
        scene = scene.with_placement(placed_at(scene, row, id=f"book_row_{number}", position=at, yaw=90.0), row)
    assert {p.support for p in scene.placements} == {"floor", "bookcase_1"}
    target = Target(
        id="vase_1", category="vase", request="vase", asked=False, ties=(Tie(kind="on", anchors=("bookcase_1",)),)
    )
    plan = Plan(brief=read_brief("A room with a chair."), targets=(target,))
    s = Situation(seen(scene, plan, target, seed=1))
    (_, best), *_ = ranked(s, from_ties(s), np.random.default_rng(0))
    own = Rects.of([(best.position[:2], s.size[:2], best.yaw, best.position[2], best.position[2] + s.size[2])])
    assert float(overlap_depth(own, Rects.of_placements(scene.placements[1:])).max()) == 0.0
    assert best.position[2] < case.size[2] - 0.1


def test_nothing_is_hung_over_a_window_unless_it_is_asked_to_be_at_one():
    room = rectangle(6.0, 5.0)
    windows = tuple(
        Opening(id=f"window_{n}", kind="window", wall=n, offset=0.1, width=wall.length - 0.2, height=1.4, sill=0.8)
        for n, wall in enumerate(room.walls)
    )
    scene = Scene(prompt="", seed=0, room=msgspec.structs.replace(room, openings=windows))
    at_window = Tie(kind="near", anchors=("window",))
    for asked, ties, hangs in ((True, (), False), (False, (), False), (True, (at_window,), True)):
        target = Target(id="picture_1", category="picture", request="picture", asked=asked, ties=ties)
        plan = Plan(brief=read_brief("A room with a chair."), targets=(target,))
        texts = ExpertPolicy().propose(seen(scene, plan, target, seed=1), 6, np.random.default_rng(1))
        assert bool(texts) == hangs


def test_what_hangs_beside_a_door_keeps_off_its_frame():
    room = rectangle(2.4, 4.0)
    door = Opening(id="door_1", kind="door", wall=0, offset=0.75, width=0.9, height=2.1)
    scene = Scene(prompt="", seed=0, room=msgspec.structs.replace(room, openings=(door,)))
    clock = Target(id="clock_1", category="clock", request="clock")
    s = Situation(seen(scene, Plan(brief=read_brief("A room with a chair."), targets=(clock,)), clock, seed=1))
    half, wall = s.size[1] / 2, room.walls[0]
    places = [hung.hang(s, wall, door.offset - half - gap, 1.7, why="it hangs", cost=0.0) for gap in (0.02, 0.15)]
    costs = {idea.position: cost for cost, idea in ranked(s, places, np.random.default_rng(1))}
    assert costs[places[0].position] > costs[places[1].position] + 2.0


def test_what_usually_stands_beside_a_sofa_is_not_put_before_it():
    stands = (("sofa", 1.2, 0.5, 90.0),)
    tie = Tie(kind="next_to", anchors=("sofa_1",), asked=False)
    asked = Tie(kind="next_to", anchors=("sofa_1",))

    def cheapest(s: Situation) -> float:
        sofa = s.scene.placements[0]
        return min(i.cost for i in from_ties(s) if sofa.to_local(i.position[:2])[0] > sofa.size[0] / 2)

    assert (
        cheapest(situation("plant", tie, stands=stands))
        > ELSEWHERE
        > cheapest(situation("plant", asked, stands=stands))
    )


def test_what_usually_stands_beside_a_desk_is_not_put_where_visitors_sit():
    tie = Tie(kind="next_to", anchors=("desk_1",), asked=False)
    s = situation("filing_cabinet", tie, stands=(("desk", 3.0, 2.5, 90.0),))
    desk = s.scene.placements[0]
    across = [i.cost for i in from_ties(s) if desk.to_local(i.position[:2])[0] < -desk.size[0] / 2]
    assert across
    assert min(across) > ELSEWHERE


def test_a_sofa_stands_where_the_wall_before_it_is_not_too_far():
    tie = Tie(kind="opposite", anchors=("sofa_9",), asked=False)
    sofa = Target(id="sofa_9", category="sofa", request="sofa")
    stand = Target(id="tv_stand_1", category="tv_stand", request="tv_stand", ties=(tie,))
    plan = Plan(brief=read_brief("A room with a chair."), targets=(sofa, stand))
    scene = Scene(prompt="", seed=0, room=rectangle(5.0, 6.2))
    s = Situation(seen(scene, plan, sofa, seed=1))
    deep = s.size[0] / 2 + 0.02
    along, across = follower_costs(s, boxes(s, (2.5, deep, 90.0), (deep, 3.1, 0.0)))
    assert across + 0.5 < along


def test_a_sofa_looks_where_its_screen_has_a_place():
    tie = Tie(kind="opposite", anchors=("sofa_9",), asked=False)
    sofa = Target(id="sofa_9", category="sofa", request="sofa")
    stand = Target(id="tv_stand_1", category="tv_stand", request="tv_stand", ties=(tie,))
    plan = Plan(brief=read_brief("A room with a chair."), targets=(sofa, stand))
    door = Opening(id="door_1", kind="door", wall=2, offset=3.2, width=0.9, height=2.1)
    scene = Scene(prompt="", seed=0, room=rectangle(6.0, 4.0, openings=(door,)))
    s = Situation(seen(scene, plan, sofa, seed=1))
    deep = s.size[0] / 2 + 0.02
    free, at_door = sight_costs(s, boxes(s, (4.5, deep, 90.0), (2.3, deep, 90.0)))
    assert free + 1.0 < at_door


def test_a_wardrobe_of_a_studio_stands_by_the_bed():
    stands = (("bed", 1.2, 1.2, 0.0), ("sofa", 5.0, 4.0, 180.0))
    s = situation("wardrobe", stands=stands)
    plan = msgspec.structs.replace(
        s.observation.plan,
        targets=(*s.observation.plan.targets, *(Target(id=f"{c}_1", category=c, request=c) for c, *_ in stands)),
    )
    mixed = Situation(msgspec.structs.replace(s.observation, plan=plan))
    deep = s.size[0] / 2 + 0.02
    poses = ((deep, 3.0, 0.0), (6.0 - deep, 1.0, 180.0))
    alone, apart = ground_costs(s, boxes(s, *poses)), ground_costs(mixed, boxes(mixed, *poses))
    assert apart[1] - apart[0] > alone[1] - alone[0] + 1.0


def test_a_screen_is_not_put_before_a_window_and_a_bookcase_shows_its_back_to_the_wall():
    stand = Target(id="tv_stand_1", category="tv_stand", request="tv_stand")
    screen = Target(id="tv_1", category="tv", request="tv", ties=(Tie(kind="on", anchors=("tv_stand_1",)),))
    plan = Plan(brief=read_brief("A room with a chair."), targets=(stand, screen))
    window = Opening(id="window_1", kind="window", wall=0, offset=0.5, width=1.6, height=1.3, sill=0.9)
    scene = Scene(prompt="", seed=0, room=rectangle(6.0, 5.0, openings=(window,)))
    s = Situation(seen(scene, plan, stand, seed=1))
    deep = s.size[0] / 2 + 0.02
    before, beside_it = follower_costs(s, boxes(s, (1.3, deep, 90.0), (4.0, deep, 90.0)))
    assert before > beside_it + 1.0
    case = situation("bookcase", Tie(kind="near", anchors=("armchair_1",), asked=False), stands=())
    deep = case.size[0] / 2 + 0.02
    at_wall, amid = ground_costs(case, boxes(case, (3.0, deep, 90.0), (3.0, 2.5, 90.0)))
    assert amid > at_wall + 1.0


def test_a_sofa_does_not_look_at_its_screen_against_a_window():
    tie = Tie(kind="opposite", anchors=("sofa_9",), asked=False)
    sofa = Target(id="sofa_9", category="sofa", request="sofa")
    stand = Target(id="tv_stand_1", category="tv_stand", request="tv_stand", ties=(tie,))
    screen = Target(id="tv_1", category="tv", request="tv", ties=(Tie(kind="on", anchors=("tv_stand_1",)),))
    window = Opening(id="window_1", kind="window", wall=2, offset=1.5, width=1.5, height=1.3, sill=0.9)
    scene = Scene(prompt="", seed=0, room=rectangle(4.5, 4.5, openings=(window,)))
    costs = []
    for targets in ((sofa, stand), (sofa, stand, screen)):
        plan = Plan(brief=read_brief("A room with a chair."), targets=targets)
        s = Situation(seen(scene, plan, sofa, seed=1))
        deep = s.size[0] / 2 + 0.02
        costs.append(follower_costs(s, boxes(s, (2.25, deep, 90.0), (2.25, 4.5 - deep, 270.0))))
    (before, after), (lit, free) = costs
    assert lit > before
    assert free == after


def test_screen_and_keyboard_are_straight_before_who_works_at_the_desk():
    done = room("An office with two desks, each with a drawer pedestal, an office chair, a monitor and a keyboard.", 2)
    for chair in of(done, "office_chair"):
        for name in ("monitor", "keyboard"):
            ahead, aside = min((chair.to_local(p.position[:2]) for p in of(done, name)), key=lambda at: abs(at[1]))
            assert ahead > 0.0
            assert abs(aside) < 0.08


def test_a_toilet_has_elbow_room_and_a_rug_at_two_beds_lies_between_them():
    (toilet,) = of(done := room("A small bathroom with a shower, a toilet and a washbasin.", 3), "toilet")
    for other in done.scene.placements:
        ahead, aside = toilet.to_local(other.position[:2])
        if other.id != toilet.id and other.position[2] < 0.1 and abs(ahead) < toilet.size[0] / 2:
            assert abs(aside) - max(other.size[:2]) / 2 > 0.2 or gap(toilet, other) > 0.15
    done = room("A guest bedroom with two single beds, a nightstand between them and a rug under the beds.", 3)
    (one, other), (rug,) = of(done, "bed"), of(done, "rug")
    assert abs(one.to_local(rug.position[:2])[1] - one.to_local(other.position[:2])[1] / 2) < 0.1


@pytest.mark.parametrize("seed", [0, 1])
def test_what_something_hangs_above_stands_at_a_wall_that_has_a_place_for_it(seed: int):
    done = room(
        "A living room with a couch facing a television. The television is on a TV stand against the wall. "
        "Two framed pictures hang on the wall above the couch.",
        seed,
    )
    assert len(of(done, "picture")) == 2
    assert all(measure(done.scene, "above", picture.id, ["sofa_1"]).holds for picture in of(done, "picture"))


def test_a_lamp_over_what_is_high_is_as_short_as_it_can_be_made():
    done = room(
        "A garage of 7 m by 6 m with a car in the center. A fluorescent lamp hangs from the ceiling above the car."
    )
    (lamp,), (car,) = of(done, "fluorescent_lamp"), of(done, "car")
    assert measure(done.scene, "above", lamp.id, [car.id]).holds
    assert lamp.position[2] > car.top


def test_two_that_hang_next_to_a_door_have_a_place_by_it_each():
    done = room("A music studio with an upright piano. Two electric guitars hang on the wall next to the door.")
    guitars = of(done, "wall_guitar")
    assert len(guitars) == 2
    assert all(measure(done.scene, "next_to", guitar.id, ["door"]).holds for guitar in guitars)


def test_a_small_thing_by_the_window_has_its_desk_there_or_stands_on_the_floor():
    done = room(
        "A study, 6.5 by 5 m, with a desk against the wall and a chair in front of it. A globe is near the window."
    )
    (globe,), (desk,) = of(done, "globe"), of(done, "desk")
    assert globe.support == desk.id
    assert measure(done.scene, "near", globe.id, ["window"]).holds
    done = room(
        "A study, 6.5 by 5 m, with a desk in the corner next to the door and a chair. A globe is near the window."
    )
    (globe,) = of(done, "globe")
    assert measure(done.scene, "near", globe.id, ["window"]).holds


def test_a_sink_that_has_a_counter_for_itself_is_beside_what_it_is_asked_to_be_beside():
    done = room(
        "A laundry room with a washing machine, a dryer and a sink next to the dryer. "
        "A cabinet hangs on the wall above the washing machine."
    )
    (sink,), (dryer,), (counter,) = of(done, "sink"), of(done, "dryer"), of(done, "counter")
    assert sink.support == counter.id
    assert gap(sink, dryer) < 0.5
    assert counter.yaw == dryer.yaw
    assert abs(dryer.to_local(counter.position[:2])[0]) < 0.1
    assert counter.size[1] < 1.2


@pytest.mark.parametrize(
    ("prompt", "category", "count"),
    [
        ("A tailor's workshop, 5 m by 4.2 m, with nine fabric rolls in a shelf.", "fabric_roll", 9),
        ("A bike workshop, 9 m by 7 m. A steel shelf holds twenty helmets.", "helmet", 20),
    ],
)
def test_a_shelf_holds_all_that_is_asked_to_be_in_it(prompt: str, category: str, count: int):
    done = room(prompt)
    held = of(done, category)
    assert len(held) == count
    assert all(measure(done.scene, "inside", p.id, ["shelving_unit_1"]).holds for p in held)


def test_a_shelf_grows_only_for_what_has_room_then():
    few, many = (room(f"A bike workshop, 9 m by 7 m. A steel shelf holds {n} helmets.") for n in ("three", "twenty"))
    (short,), (long,) = of(few, "shelving_unit"), of(many, "shelving_unit")
    assert long.size[1] > short.size[1] + 0.15


def test_large_things_leave_the_place_by_a_door_to_what_is_asked_to_be_there():
    bed = Target(id="bed_1", category="bed", request="bed")
    beside_it = Tie(kind="next_to", anchors=("door",))
    locker = Target(id="wardrobe_1", category="wardrobe", request="wardrobe", ties=(beside_it,))
    door = Opening(id="door_1", kind="door", wall=0, offset=0.2, width=0.9, height=2.1)
    scene = Scene(prompt="", seed=0, room=rectangle(4.0, 4.0, openings=(door,)))
    costs = []
    for targets in ((bed,), (bed, locker)):
        plan = Plan(brief=read_brief("A room with a chair."), targets=targets)
        s = Situation(seen(scene, plan, bed, seed=1))
        costs.append(follower_costs(s, boxes(s, (2.2, s.size[0] / 2 + 0.02, 90.0), (2.2, 3.98 - s.size[0] / 2, 270.0))))
    alone, waited_for = costs
    assert waited_for[0] > alone[0] + 5.0
    assert waited_for[1] == alone[1]


def test_a_tiny_cabin_has_all_that_is_asked_for():
    done = room(
        "Single cabin on a cargo ship, 2.2 m by 3 m: a bunk against the wall with a drawer unit under it and a wall "
        "lamp above it, a small desk with a chair, a steel locker next to the door."
    )
    assert done.report.complete


def test_small_things_near_a_door_lie_before_it_where_the_walls_are_full():
    done = room("A gym, 9 by 6 m, with a barre on the wall. Five gym bags lie near the door.")
    bags = of(done, "gym_bag")
    assert len(bags) == 5
    assert all(measure(done.scene, "near", bag.id, ["door"]).holds for bag in bags)


def test_several_small_things_in_the_corner_are_in_one():
    done = room("A storage room, 4 by 3 m, with three boxes in the corner.")
    boxes_ = of(done, "box")
    assert len(boxes_) == 3
    assert all(measure(done.scene, "in_corner", p.id, ["corner"]).holds for p in boxes_)
    assert max(gap(a, b) for a, b in combinations(boxes_, 2)) < 1.0


def test_mirrors_of_a_named_wall_hang_side_by_side_on_it():
    done = room("A dance studio with two mirrors on the front wall.")
    assert [m.support for m in of(done, "studio_mirror")] == ["south_wall", "south_wall"]


def test_mirrors_over_basins_that_are_close_come_small_enough_for_one_each():
    done = room("In the bathroom, against the wall is a vanity with two sinks on it. Above each sink hangs a mirror.")
    basins, mirrors = of(done, "washbasin") or of(done, "sink"), of(done, "mirror")
    assert len(basins) == len(mirrors) == 2
    for basin in basins:
        assert sum(measure(done.scene, "above", mirror.id, [basin.id]).holds for mirror in mirrors) == 1


def test_a_mirror_over_what_is_high_comes_small_enough_for_the_wall_that_is_left():
    scene = Scene(prompt="", seed=0, room=rectangle(4.0, 3.0, height=2.4))
    high = make_asset("wardrobe", seed=1, size=(0.6, 1.2, 1.75))
    scene = scene.with_placement(placed_at(scene, high, id="wardrobe_1", position=(2.0, 0.32, 0.0), yaw=90.0), high)
    target = Target(
        id="mirror_1", category="mirror", request="mirror", ties=(Tie(kind="above", anchors=("wardrobe_1",)),)
    )
    s = Situation(seen(scene, Plan(brief=read_brief("A room."), targets=(target,)), target, seed=1))
    _, best = ranked(s, from_ties(s), np.random.default_rng(0))[0]
    assert best.position[2] >= 1.75
    assert best.position[2] + (best.size or s.size)[2] <= 2.4


@pytest.mark.parametrize(
    ("prompt", "category", "count"),
    [
        ("A playroom with a basket containing three toys.", "toy", 3),
        ("A bedroom with a basket holding four blankets.", "blanket", 4),
    ],
)
def test_a_basket_holds_all_that_is_asked_to_be_in_it(prompt: str, category: str, count: int):
    held = of(done := room(prompt), category)
    assert len(held) == count
    assert all(measure(done.scene, "inside", p.id, ["basket_1"]).holds for p in held)


def test_what_is_between_a_sofa_and_what_it_faces_is_next_to_both():
    done = room(
        "A studio apartment, 6 meters by 5 meters. A two-seat sofa faces a TV stand. Between the sofa and the TV stand "
        "is a round coffee table."
    )
    (table,), (sofa,), (stand,) = (of(done, name) for name in ("coffee_table", "sofa", "tv_stand"))
    assert gap(table, sofa) <= 0.5
    assert gap(table, stand) <= 0.5


def test_a_square_table_is_as_wide_as_deep_whatever_its_size():
    for seed in range(3):
        (table,) = of(room("A kitchen with a square table in the corner.", seed), "kitchen_table")
        assert table.size[0] == pytest.approx(table.size[1], abs=0.02)


def test_a_long_bench_has_a_wall_in_a_greenhouse():
    done = room("Greenhouse with a long potting bench against the wall.")
    (bench,) = of(done, "potting_bench")
    assert measure(done.scene, "against_wall", bench.id, ["wall"]).holds


def test_bean_bags_lie_on_the_rug_in_the_middle_of_the_room():
    done = room("A reading room, 4 m x 5 m. A round rug lies in the middle of the room with three beanbags on it.", 1)
    (rug,) = of(done, "rug")
    assert measure(done.scene, "under", rug.id, [p.id for p in of(done, "bean_bag")]).holds


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_a_bunk_of_a_night_train_leaves_its_window_and_its_door_free(seed):
    prompt = (
        "Sleeping compartment of a night train, 1.8 m x 2.3 m. A bunk bed against the wall, a table under the window."
    )
    done = room(prompt, seed)
    assert done.report.valid
    assert of(done, "bunk_bed")
