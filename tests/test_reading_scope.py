"""What belongs to what: lists in which things are told of, what lies with others, what is denied of what."""

import pytest

from tests.test_reading_turns import counted, related
from thinkblox.assets import kind_of
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "On the table is a mirror, a lamp to the left of the mirror and a measuring tape in front of it.",
            "1 table_lamp on dining_table; 1 table_lamp left_of mirror; 1 measuring_tape on dining_table",
        ),
        (
            "A steel table carries a tote, a scanner to the right of the tote and a label printer.",
            "1 storage_bin on dining_table; 1 label_printer on dining_table",
        ),
        (
            "In the middle a table with a vase, a book to the left of the vase, and a bowl with three lemons in it.",
            "1 book on dining_table; 1 book left_of vase; 1 bowl on dining_table; 3 lemon inside bowl",
        ),
        (
            "A desk with a monitor in the middle of it, a keyboard in front of the monitor and a mouse.",
            "1 keyboard on desk; 1 keyboard in_front_of monitor; 1 mouse on desk",
        ),
        ("A table with a tray, a cup on the tray and a vase.", "1 cup on tray; 1 vase on dining_table"),
        ("A desk without a chair stands against the wall.", "1 desk against_wall wall"),
        (
            "One table, six chairs on each long side. For each person: a plate with a napkin on it and two glasses.",
            "12 plate on dining_table; 12 napkin on plate; 24 glass on dining_table",
        ),
        (
            "A counter with nine stools in front of it. Per stool a plate, plus one teapot for every three stools.",
            "9 plate on counter; 3 teapot on counter",
        ),
        ("Eight lockers along the wall, and one bench for every two lockers.", "4 bench near locker"),
        ("A table with a turkey on it and three candles on either side of the turkey.", "6 candle on dining_table"),
        ("A desk: a laptop, a lamp and a mug.", "1 laptop on desk; 1 desk_lamp on desk; 1 cup on desk"),
        ("Workbench against the wall: a vise and a saw.", "1 vise on workbench; 1 saw on workbench"),
        ("A big table covered in stuff: fifteen hats.", "15 hat on dining_table"),
        ("Two shelving units: nine teapots. A sofa.", "9 teapot inside shelving_unit"),
        ("A dining table: six plates and six chairs.", "6 plate on dining_table; 6 chair around dining_table"),
        ("Two 3D printers on a desk.", "2 thing_3d_printer on desk"),
        (
            "A table with two cars, ten wagons and fifteen trees on it, surrounded by four stools.",
            "10 wagon on dining_table; 15 potted_plant on dining_table; 4 stool around dining_table",
        ),
        ("Three rows of five desks. Each row shares a printer on a trolley.", "3 printer on serving_trolley"),
        ("Four rows of chairs. Each row is facing the stage.", "12 chair facing stage"),
        (
            "Four workstations, all against the wall. Each is a desk with two monitors and a chair in front of it.",
            "4 desk against_wall wall; 8 monitor on desk; 4 chair in_front_of desk",
        ),
        (
            "Behind the counter, on which there are a cash register and a jar, stands a shelf.",
            "1 cash_register on counter; 1 jar on counter; 1 shelving_unit behind counter",
        ),
        (
            "Ten desks in two rows. Per desk: one monitor and one office chair.",
            "10 monitor on desk; 10 office_chair at desk",
        ),
        (
            "The washer and the dryer stand against the wall, the dryer directly to the right of the washer.",
            "1 washing_machine against_wall wall; 1 dryer right_of washing_machine",
        ),
        ("The bed, a black iron one, is in the corner.", "1 bed in_corner corner"),
        ("Pool table dead centre with three balls on it.", "3 ball on pool_table"),
        ("A low table. It's got four magazines on it.", "4 magazine on coffee_table"),
        ("Two server racks with three servers in each.", "6 server inside server_rack"),
        (
            "A bench is under the window; it is of maple, and on it he keeps three chisels.",
            "1 bench under window; 3 chisel on bench",
        ),
        (
            "A cabinet in the corner holds four rocks, and far from it, next to the door, stands a coat rack.",
            "1 cabinet in_corner corner; 1 coat_rack far cabinet; 1 coat_rack next_to door",
        ),
        (
            "Three stands, each carries four buckets; in every bucket is a bouquet, half of the bouquets red.",
            "6 bouquet inside bucket; 6 bouquet-2 inside bucket",
        ),
        ("On the desk a lamp and, behind it, a plant.", "1 desk_lamp on desk; 1 potted_plant on desk"),
        (
            "Two round tables, on each of these one plate and two glasses.",
            "2 plate on dining_table; 4 glass on dining_table",
        ),
        ("A TV on the wall. The screen faces the sofa.", "1 wall_tv facing sofa"),
        ("Two armchairs, one green and one blue, facing the sofa.", "1 armchair facing sofa; 1 armchair-2 facing sofa"),
        (
            "Three armchairs: one is red, the others are grey. A low table stands in front of the red one.",
            "1 coffee_table in_front_of armchair",
        ),
        (
            "Three armchairs, one orange and two grey. A low table stands in front of the orange one.",
            "1 coffee_table in_front_of armchair",
        ),
        ("Three umbrellas in the stand by the door.", "3 umbrella inside umbrella_stand"),
        (
            "Two lab benches, each with a microscope and a rack with three test tubes in it.",
            "2 test_tube_rack on lab_bench; 6 test_tube inside test_tube_rack",
        ),
        (
            "A vocal booth, 2 x 3 m, with a mic on a mic stand right in the middle.",
            "1 microphone_stand in_centre centre",
        ),
    ],
)
def test_so_things_are_related(prompt: str, relations: str) -> None:
    found = related(read_brief(prompt, fill="named"))
    assert set(relations.split("; ")) <= found


def test_a_whiteboard_is_not_the_screen_that_was_named() -> None:
    brief = read_brief("A screen on the wall. The whiteboard should not be on the wall.", fill="named")
    assert counted(brief) == {"wall_tv": 1, "whiteboard": 1}


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("Three armchairs: one is orange, the others are grey.", {"armchair": 3}),
        ("The chair is orange, the table is glass.", {"chair": 1, "dining_table": 1}),
        ("Two bowls and one orange.", {"bowl": 2, "orange": 1}),
    ],
)
def test_a_colour_that_is_a_fruit_is_one_where_it_describes(prompt: str, counts: dict[str, int]) -> None:
    assert counted(read_brief(prompt, fill="named")) == counts


def test_what_is_denied_of_two_places_is_denied_of_both() -> None:
    brief = read_brief("The bed is neither in a corner nor next to the window.", fill="named")
    assert {(r.kind, r.negated) for r in brief.relations} == {("in_corner", True), ("next_to", True)}


@pytest.mark.parametrize(
    ("prompt", "size"),
    [
        ("Vocal booth 1.8 x 2.1 m, a stool in the corner.", (1.8, 2.1)),
        ("Ticket booth at a fairground, 1.6 by 1.8 m: a counter.", (1.6, 1.8)),
        ("A purifier near the bed, nothing closer than half a metre.", (None, None)),
        ("Bed 2 m by 1.6 m, wardrobe.", (None, None)),
    ],
)
def test_whose_a_size_is(prompt: str, size: tuple[float | None, float | None]) -> None:
    brief = read_brief(prompt, fill="named")
    assert (brief.width, brief.depth) == size


@pytest.mark.parametrize(
    ("prompt", "counts", "excluded"),
    [
        (
            "A bed, and instead of a nightstand a wooden chair with an alarm clock on it.",
            "bed chair alarm_clock",
            "nightstand",
        ),
        ("Instead of a bed or a sofa, a futon and a rug.", "futon rug", "bed sofa"),
        ("A desk. Neither plants nor a telephone.", "desk", "plant telephone"),
    ],
)
def test_only_what_is_replaced_is_excluded(prompt: str, counts: str, excluded: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert set(counted(brief)) == set(counts.split())
    assert set(brief.excluded) == set(excluded.split())


def test_what_an_animal_lies_on_is_asked_for() -> None:
    brief = read_brief("A sofa and the cat asleep on the ironing board.", fill="named")
    assert counted(brief) == {"sofa": 1, "ironing_board": 1}
    assert any("cat" in unknown for unknown in brief.unknown)


def test_what_lacks_something_is_still_spoken_of() -> None:
    brief = read_brief("A large aquarium without any fish stands against the wall.", fill="named")
    assert counted(brief) == {"aquarium": 1}
    assert "fish" in brief.excluded
    assert not brief.unknown


@pytest.mark.parametrize(
    ("prompt", "gone"),
    [
        ("A man cave, but my wife vetoed the pool table and the bar.", {"pool_table", "bar_counter"}),
        ("A games room. The landlord forbids candles and a fireplace. A sofa.", {"candle", "fireplace"}),
        ("A bedroom with a bed. Dad won't allow a TV in it.", {"tv"}),
        ("An office with a desk. The filing cabinet was thrown out last week.", {"filing_cabinet"}),
        ("A bedroom with a bed. The wardrobe has been moved to the hallway.", {"wardrobe"}),
        ("A room with two armchairs. The old sideboard was sold, and so was the clock.", {"sideboard", "clock"}),
        ("A lounge with a sofa. We're not keen on plants. There's a lamp.", {"plant"}),
        ("A lounge with a sofa. I'd rather not have a rug or curtains.", {"rug", "curtain"}),
        ("A lounge with a sofa. The dog basket has to go.", {"pet_bed"}),
        ("A lounge with a sofa. Rugs are a no-go, and so are curtains.", {"rug", "curtain"}),
        ("A dining room with a table. A chandelier is the last thing I want.", {"chandelier"}),
        ("A classroom with ten desks. A projector is not something we have.", {"projector"}),
        ("A kitchen with a stove. The dishwasher belongs elsewhere.", {"dishwasher"}),
        ("A gym with a treadmill. Mirrors? Absolutely not.", {"mirror"}),
        ("A barn with a ladder. A bench? None needed.", {"bench"}),
        ("A dining room with a table. No chairs whatsoever.", {"chair"}),
    ],
)
def test_what_is_refused_is_not_there(prompt: str, gone: set[str]) -> None:
    brief = read_brief(prompt, fill="named")
    assert gone <= set(brief.excluded)
    assert not gone & set(counted(brief))


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("A desk and a bed. The desk can't stand beside the bed.", "next_to"),
        ("A desk and a bookcase. The bookcase is not to stand next to the desk.", "next_to"),
        ("A gym with a treadmill and a bench; the bench mustn't go in front of the treadmill.", "in_front_of"),
        ("A sofa and a piano. The piano cannot be near the sofa.", "near"),
        ("A bed and a desk. The desk wouldn't fit beside the bed.", "next_to"),
    ],
)
def test_where_a_thing_cannot_be_it_is_not(prompt: str, kind: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert [(r.kind, r.negated) for r in brief.relations] == [(kind, True)]
    assert len(counted(brief)) == 2


@pytest.mark.parametrize(
    "prompt",
    [
        "A living room with a sofa and a coffee table, no rug under the coffee table.",
        "A bedroom with a bed and a desk, no lamp on the desk.",
        "A kitchen with an island and no stools at the island.",
        "A hall with a bench, without a mirror above the bench.",
    ],
)
def test_where_something_is_not_is_no_place_of_another_thing(prompt: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert not brief.relations
    assert not brief.unknown
    assert set(counted(brief).values()) == {1}


def test_what_has_to_go_somewhere_is_there() -> None:
    brief = read_brief("A desk and a lamp. The lamp has to go next to the desk.", fill="named")
    assert related(brief) == {"1 floor_lamp next_to desk"}
    assert not brief.excluded


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A kitchen with a stove and a fridge, the fridge not next to the stove.",
            {("next_to", "fridge", "stove", True)},
        ),
        (
            "Two shelves on the wall; one holds three mugs, the other five plates.",
            {("on", "cup", "wall_shelf", False), ("on", "plate", "wall_shelf-2", False)},
        ),
        (
            "Three boxes. One of them contains a ball, another one two books, and the remaining one is empty.",
            {("inside", "ball", "box", False), ("inside", "book", "box-2", False)},
        ),
        ("A glass cabinet; its neighbour is a desk.", {("next_to", "desk", "china_cabinet", False)}),
        ("A kettle's on the stove. The broom's in the corner.", {("on", "kettle", "stove", False)}),
        (
            "A telescope next to the window, wooden crate in the middle with a lantern on it.",
            {("in_centre", "crate", "centre", False), ("on", "lantern", "crate", False)},
        ),
        ("A clock in the corner and a long way from the door.", {("far", "clock", "door", False)}),
        (
            "A hall with nothing in the middle of the floor apart from the table.",
            {("in_centre", "table", "centre", False)},
        ),
        ("A library with nothing in the corner except a globe.", {("in_corner", "globe", "corner", False)}),
    ],
)
def test_so_it_stands(prompt: str, relations: set[tuple[str, str, str, bool]]) -> None:
    brief = read_brief(prompt, fill="named")
    found = {(r.kind, r.subject, r.anchors[0] if r.anchors else "", r.negated) for r in brief.relations}
    assert relations <= found
    assert not brief.unknown


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("A lighthouse. The kettle's on the stove.", {"kettle": 1, "stove": 1}),
        ("Picture a lighthouse keeper's room with a bed.", {"bed": 1}),
        ("A shelf on the wall holds nine pairs of shoes, that is eighteen.", {"wall_shelf": 1, "shoes": 9}),
        ("A hall with two small tables, hence six chairs.", {"dining_table": 2, "chair": 6}),
        ("A hall with a wall-mounted clock and a small wall-mounted desk.", {"clock": 1, "desk": 1}),
    ],
)
def test_so_many_are_asked_for(prompt: str, counts: dict[str, int]) -> None:
    brief = read_brief(prompt, fill="named")
    assert counted(brief) == counts
    assert not brief.unknown


def test_where_nothing_is_to_stand_is_said_not_to_be_understood() -> None:
    brief = read_brief("A hall with a globe and nothing by the window.", fill="named")
    assert brief.unknown == ("nothing by the window",)
    assert not brief.relations


def test_a_number_of_nobody_knows_what_changes_none() -> None:
    brief = read_brief("A vase on a shelf, that is three.", fill="named")
    assert counted(brief) == {"vase": 1, "shelving_unit": 1}
    assert brief.unknown == ("that is three",)


def test_what_hangs_from_the_ceiling_is_on_no_wall() -> None:
    cage = read_brief("Five hanging cages from the ceiling.", fill="named").request("cage")
    assert cage.attributes == ("hanging",)
    assert kind_of(read_brief("Five hanging baskets.", fill="named").requests[0].category).mount == "ceiling"


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        (
            "Two desks. The larger one has a laptop on it and the smaller one a globe. A clock hangs above the former.",
            ("above", "clock", "desk"),
        ),
        (
            "Two tables: the bigger one carries a cup, the smaller one only a globe. A chair faces the latter.",
            ("facing", "chair", "dining_table-2"),
        ),
        ("An abacus on a low table, with three beanbags around it.", ("around", "bean_bag", "coffee_table")),
        ("A globe on a desk. Three stools stand around it.", ("around", "stool", "desk")),
    ],
)
def test_it_is_furniture_that_others_stand_to(prompt: str, relation: tuple[str, str, str]) -> None:
    brief = read_brief(prompt, fill="named")
    assert relation in {(r.kind, r.subject, r.anchors[0]) for r in brief.relations if r.anchors}


@pytest.mark.parametrize(
    ("prompt", "red"),
    [
        ("A vase and a bowl on a table. The former is red.", "vase"),
        ("A vase and two bowls on a table. The latter are red.", "bowl"),
        ("A sofa and a desk. The former is red.", "sofa"),
    ],
)
def test_which_of_two_is_meant(prompt: str, red: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert [r.key for r in brief.requests if "red" in r.attributes] == [red]


@pytest.mark.parametrize(
    ("prompt", "asked", "excluded"),
    [
        ("There are two tables. None of them has a lamp.", {"dining_table": 2}, "any_lamp"),
        ("None of the tables has a lamp. There are two tables.", {"dining_table": 2}, "any_lamp"),
        ("There are two tables. No table has a lamp.", {"dining_table": 2}, "any_lamp"),
        ("Four desks, none of which has a monitor on it.", {"desk": 4}, "monitor"),
        ("Four desks, none of which has a monitor.", {"desk": 4}, "monitor"),
        ("A bed. None of the walls has a painting.", {"bed": 1}, "picture"),
    ],
)
def test_what_none_of_them_has_is_not_there(prompt: str, asked: dict[str, int], excluded: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert {r.category: r.count for r in brief.requests if r.asked} == asked
    assert excluded in brief.excluded
    assert brief.unknown == ()


def test_none_of_the_walls_has_a_window() -> None:
    brief = read_brief("A bed. None of the four walls has a window.")
    assert [(o.kind, o.count) for o in brief.openings] == [("window", 0)]


def test_what_none_of_them_has_and_others_have_is_told() -> None:
    brief = read_brief("A lamp on a desk and two tables. None of the tables has a lamp.", fill="named")
    assert {r.category: r.count for r in brief.requests if r.asked} == {"desk_lamp": 1, "desk": 1, "dining_table": 2}
    assert brief.unknown == ("None of the tables has a lamp",)
