"""Things on, in, under and above others: what carries, holds and has room below it, and how large it is."""

from functools import cache

import pytest
from msgspec import structs

from thinkblox.assets import make_asset, make_thing, room_under
from thinkblox.assets.levels import found_surfaces
from thinkblox.furnishing import Generation
from thinkblox.generate import generate_room
from thinkblox.headline import shortfalls
from thinkblox.knowledge.dressing import dressing
from thinkblox.placing import Effort
from thinkblox.plan import Plan, Target
from thinkblox.planning import plan_brief
from thinkblox.reading import read_brief
from thinkblox.scene.asset import Joint, Link, Shape, Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import rectangle
from thinkblox.scene.windows import hangs_at_window

pytestmark = pytest.mark.slow

ONCE = Effort(restarts=0)


@cache
def room(prompt: str) -> Generation:
    return generate_room(prompt, seed=0, effort=ONCE)


def of(done: Generation, category: str) -> list[Placement]:
    return [p for p in done.scene.placements if p.category == category]


def holds(done: Generation, kind: str) -> bool:
    found = [r for r in done.report.relations if r.kind == kind]
    return bool(found) and all(r.holds for r in found)


def plan(prompt: str) -> Plan:
    return plan_brief(read_brief(prompt), rectangle(6.0, 5.0))


def target(prompt: str, id: str) -> Target:
    return plan(prompt).target(id)


def block(size: tuple[float, float, float], at: tuple[float, float, float]) -> Shape:
    return Shape(kind="box", size=size, position=at)


def tray(rim: float) -> tuple[Link, ...]:
    """A board of 0.6 m by 0.4 m with a wall of some height around it [m]."""
    low = 0.02 + rim / 2
    sides = [block((0.02, 0.4, rim), (s * 0.29, 0.0, low)) for s in (-1, 1)]
    ends = [block((0.56, 0.02, rim), (0.0, s * 0.19, low)) for s in (-1, 1)]
    return (Link(name="body", shapes=(block((0.6, 0.4, 0.02), (0.0, 0.0, 0.01)), *sides, *ends)),)


# What carries, read off the shape.


def test_block_top() -> None:
    links = (Link(name="body", shapes=(block((0.5, 0.8, 0.6), (0.0, 0.0, 0.3)),)),)
    (top,) = found_surfaces(links, (0.5, 0.8, 0.6), small=False)
    assert top.position == pytest.approx((0.0, 0.0, 0.6))
    assert top.size == pytest.approx((0.5, 0.8))
    assert not top.inner


@pytest.mark.parametrize(("rim", "within"), [(0.03, False), (0.2, True)])
def test_edge_or_wall(rim: float, within: bool) -> None:
    (floor,) = found_surfaces(tray(rim), (0.6, 0.4, 0.02 + rim), small=False)
    assert floor.within == within
    assert floor.position[2] == pytest.approx(0.02)
    assert floor.size[0] <= 0.56


def test_drawer_no_shelf() -> None:
    slide = Joint(kind="slide", axis=(1.0, 0.0, 0.0), anchor=(0.0, 0.0, 0.1), lower=0.0, upper=0.3)
    (link,) = tray(0.2)
    moving = Link(name="drawer", shapes=link.shapes, joint=slide)
    body = Link(name="body", shapes=(block((0.02, 0.4, 0.2), (-0.4, 0.0, 0.1)),))
    assert not found_surfaces((body, moving), (0.8, 0.4, 0.22), small=False)


@pytest.mark.parametrize("category", ["water_dispenser", "treadmill", "bathtub", "changing_table", "kiln", "beer_keg"])
def test_catalogue_carries(category: str) -> None:
    assert make_thing(category, seed=0).surfaces


@pytest.mark.parametrize("category", ["floor_lamp", "plant", "table_lamp", "bicycle"])
def test_no_table(category: str) -> None:
    assert not make_thing(category, seed=0).surfaces


@pytest.mark.parametrize(
    ("category", "words"),
    [
        ("bucket", ()),
        ("crate", ()),
        ("umbrella_stand", ("empty",)),
        ("laundry_basket", ("empty",)),
        ("display_fridge", ("empty",)),
        ("display_fridge", ("tall", "empty")),
    ],
)
def test_holds(category: str, words: tuple[str, ...]) -> None:
    assert any(s.within for s in make_asset(category, seed=0, attributes=words).surfaces)


def test_mini_fridge_takes_bottles() -> None:
    rooms = [s for s in make_asset("fridge", seed=0, attributes=("mini",)).surfaces if s.within]
    assert max(s.headroom or 0.0 for s in rooms) > make_asset("bottle", seed=0).size[2] + 0.02


def test_foot() -> None:
    arm = make_asset("robot_arm", seed=0)
    foot = arm.card.foot
    assert foot is not None
    assert foot[2] - foot[0] < 0.6 * arm.size[0]
    assert make_asset("box", seed=0).card.foot is None


# Variants for what is on, in or under them.


@pytest.mark.parametrize(
    ("prompt", "id", "word"),
    [
        ("A music room with a grand piano and a vase on the piano.", "grand_piano_1", "closed"),
        ("A hall with an umbrella stand that holds two umbrellas.", "umbrella_stand_1", "empty"),
        ("A hall with an umbrella stand that holds two umbrellas.", "umbrella_1", "upright"),
        ("A child's room with a loft bed and a desk under the bed.", "bunk_bed_1", "loft"),
        ("An office with a desk and a mini fridge under the desk.", "desk_1", "open"),
        ("A bedroom with a bed and a suitcase under the bed.", "suitcase_1", "lying"),
        ("A bedroom with a chest and a book on the chest.", "chest_1", "flat"),
    ],
)
def test_form(prompt: str, id: str, word: str) -> None:
    assert word in target(prompt, id).attributes


def test_usual_form() -> None:
    alone = plan("A hall with an umbrella stand, a grand piano and a chest.")
    assert all(not t.attributes for t in alone.targets)


def test_loft_has_room_for_desk() -> None:
    loft = make_asset("bunk_bed", seed=0, attributes=("loft",))
    place = room_under(loft.links, make_asset("desk", seed=0).size[2])
    assert place is not None
    assert min(place) > 0.7


# Sizes.


def test_counter_grows() -> None:
    few = target("A bakery with a counter with two cakes on it.", "counter_1")
    many = target("A bakery with a counter with twelve croissants, eight donuts and six cakes on it.", "counter_1")
    assert few.size == (None, None, None)
    assert many.size[1] is not None
    assert many.size[1] > 2.0


def test_oval_stays_longer_than_wide() -> None:
    prompt = "An oval dining table with eight plates, eight glasses, eight bowls and a vase on it."
    table = target(prompt, "dining_table_1")
    assert table.size[0] is not None
    assert table.size[1] is not None
    assert table.size[1] > 1.5 * table.size[0]


def test_said_size_stays() -> None:
    asked = target("A bakery with a counter 1.2 m wide with twelve croissants and six cakes on it.", "counter_1")
    assert asked.size[1] == pytest.approx(1.2)


def test_cabinet_grows_along_wall() -> None:
    prompt = "A kitchen with a base cabinet with a toaster, a kettle, a microwave and six jars on it."
    width = target(prompt, "base_cabinet_1").size[1]
    assert width is not None
    assert width > 0.7


def test_fridge_fits_under_desk() -> None:
    done = target("An office with a desk and a fridge under the desk.", "fridge_1")
    assert done.size[2] is not None
    assert done.size[2] < 0.75


# Rooms.


@pytest.mark.parametrize(
    ("prompt", "thing", "carrier"),
    [
        ("A laundromat with a folding table and a laundry basket on it.", "laundry_basket", "folding_table"),
        ("A cellar with a barrel and a lantern on the barrel.", "lantern", "barrel"),
        ("A music room with a grand piano with a vase on top.", "vase", "grand_piano"),
        ("A living room with a bookcase and a trophy on top of the bookcase.", "trophy", "bookcase"),
        ("An art room with an easel with a painting on it.", "picture", "easel"),
    ],
)
def test_on_top(prompt: str, thing: str, carrier: str) -> None:
    done = room(prompt)
    (upper,), (lower,) = of(done, thing), of(done, carrier)
    assert upper.support == lower.id
    surfaces: tuple[Surface, ...] = done.scene.asset_of(lower).surfaces
    assert upper.position[2] == pytest.approx(max(s.position[2] for s in surfaces), abs=0.005)
    assert done.report.valid


@pytest.mark.parametrize("category", ["serving_trolley", "workbench", "coffee_table", "emergency_cart"])
def test_on_it_is_on_its_top(category: str) -> None:
    surfaces = make_asset(category, seed=0).surfaces
    top = max(s.position[2] for s in surfaces)
    assert [s.position[2] for s in surfaces if not s.within] == [top]
    assert len(surfaces) > 1


@pytest.mark.parametrize("category", ["bookcase", "shoe_rack", "bakery_rack", "shelving_unit"])
def test_all_boards_of_shelves_carry(category: str) -> None:
    assert len([s for s in make_asset(category, seed=0).surfaces if not s.within]) > 1


@pytest.mark.parametrize(
    ("prompt", "carrier", "things"),
    [
        ("A crash cart carries a monitor and, in front of the monitor, a keyboard.", "instrument_cart", 2),
        ("A workbench carries a lathe, a desk lamp and a small tray in the middle of the bench.", "workbench", 3),
        ("A shoe shop with ten shoe boxes on a trolley.", "serving_trolley", 10),
    ],
)
def test_all_have_room_on_the_top(prompt: str, carrier: str, things: int) -> None:
    done = room(prompt)
    (lower,) = of(done, carrier)
    top = lower.position[2] + max(s.position[2] for s in done.scene.asset_of(lower).surfaces)
    on_top = [p for p in done.scene.placements if p.support == lower.id]
    assert len(on_top) >= things
    assert all(p.position[2] == pytest.approx(top, abs=0.005) for p in on_top)
    assert not shortfalls(done.report)


def test_one_counter_of_a_kitchen_is_one_and_has_room_for_all() -> None:
    done = room(
        "A kitchen with a long counter against the wall. On the counter there are a toaster, a blender, an electric "
        "kettle and a bread box, and the toaster is between the blender and the kettle."
    )
    (counter,) = of(done, "base_cabinet")
    assert {p.category for p in done.scene.resting_on(counter.id)} >= {
        "toaster",
        "blender",
        "kettle",
        "bread_box",
        "sink",
    }
    (toaster,), (kettle,) = of(done, "toaster"), of(done, "kettle")
    assert measure(done.scene, "next_to", toaster.id, (kettle.id,)).holds
    assert not shortfalls(done.report)


def test_a_camera_on_a_tripod_is_a_camera_and_a_tripod_that_looks_its_way() -> None:
    done = room("A studio with a stool in the corner. A camera on a tripod faces the stool.")
    (tripod,), (camera,) = of(done, "tripod"), of(done, "camera")
    assert camera.support == tripod.id
    assert measure(done.scene, "facing", tripod.id, ("stool_1",)).holds
    assert not shortfalls(done.report)


def test_two_with_a_third_between_stand_as_far_apart_as_that_needs() -> None:
    done = room("A tea shop with two cupboards against the wall. Between the two stands a small round table.")
    cupboards = of(done, "cabinet")
    (table,) = of(done, "display_table")
    assert len(cupboards) == 2
    assert all(measure(done.scene, "next_to", table.id, (cupboard.id,)).holds for cupboard in cupboards)


def test_what_has_no_room_on_the_top_is_told() -> None:
    done = room("A canteen kitchen with a serving trolley with eight microwaves on it.")
    assert [said for said in shortfalls(done.report) if "on serving_trolley_1" in said]


@pytest.mark.slow
@pytest.mark.parametrize(
    "prompt",
    [
        "A hotel room with a wardrobe and a safe inside the wardrobe.",
        "A hall with an umbrella stand that holds two umbrellas.",
        "A sauna with a bucket with a ladle in it.",
        "A shop with a crate with eight apples in it.",
        "A playroom with a bin with five balls in it.",
        "A dressing room with a mini fridge with six bottles inside it.",
    ],
)
def test_inside(prompt: str) -> None:
    assert holds(room(prompt), "inside")


@pytest.mark.slow
@pytest.mark.parametrize(
    "prompt",
    [
        "A child's room with a loft bed and a desk under the bed.",
        "A workshop with a workbench and a toolbox under it.",
        "A hall with a shoe bench and a pair of boots under the bench.",
        "An office with a desk and a mini fridge under the desk.",
        "A shop with a counter and a small fridge under the counter.",
        "A pub with a bar and two crates under the bar.",
        "A salon with a mirror on the wall and a small cabinet under the mirror.",
    ],
)
def test_under(prompt: str) -> None:
    done = room(prompt)
    assert holds(done, "under")
    assert done.report.valid


def test_under_a_desk_round_a_corner_is_under_one_of_its_tops() -> None:
    done = room("An office with one L-shaped desk and a paper shredder under the desk.")
    (desk,), (shredder,) = of(done, "corner_desk"), of(done, "shredder")
    x, y = desk.to_local(shredder.position[:2])
    tops = done.scene.asset_of(desk).surfaces
    assert any(
        abs(x - s.position[0]) <= s.size[0] / 2 and abs(y - s.position[1]) <= s.size[1] / 2 for s in tops if not s.inner
    )
    aside = done.scene.with_placement(
        structs.replace(shredder, position=(*desk.to_room((0.3, 0.4)), 0.0)), done.scene.asset_of(shredder)
    )
    assert not measure(aside, "under", "shredder_1", ("corner_desk_1",)).holds


def test_row_above() -> None:
    done = room("A lounge with a sofa and four posters above the sofa.")
    (sofa,) = of(done, "sofa")
    posters = of(done, "poster")
    assert len(posters) == 4
    assert all(abs(sofa.to_local((p.position[0], p.position[1]))[1]) <= sofa.size[1] / 2 for p in posters)


def test_rack_above_is_hooks() -> None:
    done = room("An entryway with a bench and a coat rack above the bench.")
    assert holds(done, "above")
    assert len(of(done, "coat_hooks")) == 1


def test_on_desk_under_bed() -> None:
    done = room("A child's room with a loft bed, a desk under the bed and a globe on the desk.")
    (globe,) = of(done, "globe")
    assert globe.support == "desk_1"


def test_no_stealing() -> None:
    done = room("A bathroom with a stool and two towels on the stool, and a cloche on a tray on the floor.")
    assert {p.support for p in of(done, "towels")} == {"stool_1"}


def test_raised_bed_has_room_for_case() -> None:
    case = make_asset("suitcase", seed=0, attributes=("lying",))
    for seed in range(4):
        bed = make_asset("bed", seed=seed, attributes=("raised",))
        assert room_under(bed.links, case.size[2] + 0.02) is not None


def test_towels_pile_in_basket() -> None:
    done = room("A laundry room with a laundry basket with five towels in it.")
    assert sum(r.holds for r in done.report.relations if r.kind == "inside") >= 4


@pytest.mark.slow
def test_cake_stays_amid_crowd() -> None:
    done = room(
        "A party room with a table with a cake in the middle of the table, and ten plates and ten cups on the table."
    )
    assert holds(done, "in_centre")


def test_a_bookshop_has_books_on_its_shelves() -> None:
    usual = [thing.category for thing in dressing().on("bookcase", "bookstore")]
    assert "book_row" in usual
    assert "bottle" not in usual


def test_what_is_kept_on_a_tall_bookcase_stands_at_hand() -> None:
    done = room("A study with a desk, a tall bookcase and a globe.")
    assert 0.5 < done.scene["globe_1"].position[2] < 1.6


def test_what_is_asked_on_a_cabinet_comes_before_a_sink_that_is_only_assumed() -> None:
    done = room(
        "Office kitchenette for a drawer-opening benchmark: a base cabinet with three drawers, a microwave on top of "
        "it with a mug inside, a refrigerator to the right of the cabinet, and a trash can and a recycling bin next to "
        "each other. Mop bucket in the corner."
    )
    assert done.scene["microwave_1"].support.startswith("base_cabinet")


@pytest.mark.slow
def test_a_sink_under_a_window_stays_on_its_cabinet() -> None:
    done = generate_room(
        "Small L-shaped kitchen with fridge, oven, sink under the window, dishwasher, a toaster and a kettle on the "
        "counter, and a little breakfast table for two",
        seed=41,
        effort=ONCE,
    )
    assert done.scene["sink_1"].support.startswith("base_cabinet")


def test_curtains_hang_at_the_window_over_the_bed_before_it() -> None:
    done = generate_room(
        "Business hotel room with twin beds, a luggage rack, desk with chair, a minibar, TV on the wall opposite the "
        "beds, curtains and an armchair with a floor lamp",
        seed=44,
        effort=ONCE,
    )
    assert all(hangs_at_window(done.scene, id) for id in ("curtain_1", "curtain_2"))


@pytest.mark.slow
def test_nothing_that_nobody_asked_for_lies_on_top_of_a_tall_bookcase() -> None:
    done = generate_room("A reading room with a tall bookcase and an armchair.", seed=0, effort=ONCE, fill="lived-in")
    tall = {p.id for p in done.scene.placements if p.category == "bookcase" and p.top > 1.7}
    assert tall
    assert all(p.position[2] < done.scene[p.support].top - 0.1 for p in done.scene.placements if p.support in tall)


def test_nothing_stands_under_what_is_only_seen() -> None:
    assert room_under(make_asset("rug", seed=0).links, 0.01) is None
