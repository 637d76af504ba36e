"""Things said the way people say them in passing: tasks, what is left empty, what is on or off, loose numbers."""

import pytest

from tests.test_reading_plain_words import _asked
from tests.test_reading_turns import related
from thinkblox.brief import Brief, Request
from thinkblox.reading import read_brief


def _of(brief: Brief, category: str) -> Request:
    return next(request for request in brief.requests if request.category == category)


@pytest.mark.parametrize(
    ("prompt", "category"),
    [
        ("A bedroom with a bed and a bookcase. Leave the bookcase empty.", "bookcase"),
        ("An office with a desk. Keep the desk clear.", "desk"),
        ("An office with a desk. The desk is clear.", "desk"),
        ("A library with three shelving units. Leave the last one empty.", "shelving_unit"),
        ("An office with a desk. There is nothing on the desk.", "desk"),
        ("A kitchen with a table and two stools by the window. Nothing on the table.", "kitchen_table"),
        ("A desk with nothing on it and a chair.", "desk"),
        ("A shelf, nothing on it.", "shelving_unit"),
        ("The table has nothing on it.", "dining_table"),
    ],
)
def test_a_thing_that_is_left_empty_empties_no_room(prompt: str, category: str) -> None:
    brief = read_brief(prompt)
    assert _of(brief, category).states == ("empty",)
    assert "filled" not in _of(brief, category).attributes
    assert not brief.empty
    assert brief.unknown == ()


@pytest.mark.parametrize("said", ["The desk is clear.", "Nothing on the desk.", "The desk has nothing on it."])
def test_nothing_is_assumed_on_what_is_to_be_clear(said: str) -> None:
    asked, unsaid = (read_brief(f"An office with a desk. {more}") for more in ("", said))
    assert "monitor" in {request.category for request in asked.requests}
    assert {request.category for request in unsaid.requests} == {"desk", "office_chair"}


def test_the_middle_of_a_room_is_still_left_clear() -> None:
    assert read_brief("Keep the center of the room clear. A table by the wall.").free == ("centre",)


@pytest.mark.parametrize("said", ["Leave the bottom shelf empty.", "The top shelf is empty."])
def test_a_shelf_that_is_left_empty_is_told(said: str) -> None:
    brief = read_brief(f"A pantry with a shelving unit. {said}")
    assert brief.unknown == (said[:-1],)
    assert not brief.empty


@pytest.mark.parametrize(
    ("prompt", "category", "state"),
    [
        ("A bed and a lamp. The lamp is on.", "floor_lamp", "switched on"),
        ("A bed and a TV that is off.", "tv", "switched off"),
        ("A bed, and a desk with the lamp on.", "desk_lamp", "switched on"),
        ("A nightstand with a lamp which is on.", "table_lamp", "switched on"),
        ("Two screens, both off, on a desk.", "monitor", "switched off"),
        ("Two screens which are off on a desk.", "monitor", "switched off"),
    ],
)
def test_what_is_on_or_off(prompt: str, category: str, state: str) -> None:
    assert _of(read_brief(prompt), category).states == (state,)


def test_one_on_and_one_off() -> None:
    states = [r.states for r in read_brief("Two lamps, one on and one off.").requests]
    assert states == [("switched on",), ("switched off",)]


@pytest.mark.parametrize("prompt", ["The table the lamp is on. A vase.", "Two lamps, one on the desk and one on it."])
def test_what_is_on_a_thing_is_not_switched_on(prompt: str) -> None:
    assert not any(request.states for request in read_brief(prompt).requests)


@pytest.mark.parametrize(
    ("prompt", "attributes", "style", "unknown"),
    [
        ("A bedroom with a bed, nothing modern.", (), (), ("nothing modern",)),
        ("A living room with a sofa, nothing too big.", ("small",), (), ()),
        ("A living room with a sofa, not too big.", ("small",), (), ()),
    ],
)
def test_nothing_of_a_look(
    prompt: str, attributes: tuple[str, ...], style: tuple[str, ...], unknown: tuple[str, ...]
) -> None:
    brief = read_brief(prompt)
    assert brief.requests[0].attributes == attributes
    assert (brief.style, brief.unknown) == (style, unknown)


@pytest.mark.parametrize(
    ("prompt", "attributes"),
    [
        ("A table and a chair. Use oak for the table.", {"dining_table": "oak"}),
        (
            "A desk and a chair. Use dark wood for the desk and leather for the chair.",
            {"desk": "wooden", "chair": "leather"},
        ),
    ],
)
def test_what_is_used_for_things(prompt: str, attributes: dict[str, str]) -> None:
    brief = read_brief(prompt)
    assert brief.unknown == ()
    for category, attribute in attributes.items():
        assert attribute in _of(brief, category).attributes


def test_what_must_not_block_the_door_leaves_it_free() -> None:
    brief = read_brief("Bedroom with a wardrobe. The wardrobe must not block the door.")
    assert brief.free == ("door",)
    assert brief.excluded == ()


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("A sofa. Her old chair can stay.", "1 chair, 1 sofa"),
        ("A desk and a toy box. The toy box can stay on the floor.", "1 desk, 1 toy_box"),
        ("The trash can stands by the door.", "1 waste_bin"),
        ("A kitchen table. A red can is on it.", "1 kitchen_table, 1 tin_can"),
    ],
)
def test_what_can_stay_is_no_can(prompt: str, asked: str) -> None:
    assert _asked(read_brief(prompt)) == asked


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("Task: clear the table. Dining table with two plates.", "1 dining_table, 2 plate"),
        ("Please wipe down the desk. There is a desk with a lamp on it.", "1 desk, 1 desk_lamp"),
        ("Pick up the mug. A counter with a mug and a plate.", "1 counter, 1 cup, 1 plate"),
        ("Grab the red mug. A table with a red mug and a blue mug.", "2 cup, 1 dining_table"),
        ("The sofa faces the TV. A sofa stands by the window.", "2 sofa, 1 tv"),
        ("A reading room. Lamps not on the tables. Three tables.", "3 dining_table, 3 table_lamp"),
        ("Put a plate on the tables. There are four round tables.", "4 dining_table, 1 plate"),
    ],
)
def test_what_is_pointed_at_first_and_told_of_later_is_one_thing(prompt: str, asked: str) -> None:
    assert _asked(read_brief(prompt)) == asked


@pytest.mark.parametrize(
    "prompt", ["Home office, nothing fancy: desk, chair.", "A home office, not too fancy, with a desk and a chair."]
)
def test_a_look_that_is_denied_is_no_style(prompt: str) -> None:
    brief = read_brief(prompt)
    assert brief.style == ()
    assert _asked(brief) == "1 chair, 1 desk"


def test_one_or_two() -> None:
    plant = _of(read_brief("A chair, a plant or two."), "plant")
    assert (plant.least, plant.most) == (1, 2)


def test_any_of_the_desks() -> None:
    brief = read_brief("Two desks, a chair and a printer. The printer isn't next to any of the desks.")
    assert [r.negated for r in brief.relations if r.subject == "printer"] == [True]
    assert "1 printer next_to desk" in related(brief)
    assert brief.unknown == ()


def test_what_is_optional_and_left_out() -> None:
    brief = read_brief("A sofa and a clothes rack. The clothes rack is optional, so leave it out.")
    assert _asked(brief) == "1 sofa"
    assert brief.excluded == ("clothes_rack",)


def test_what_is_to_be_pictured_is_no_picture() -> None:
    assert _asked(read_brief("OK so picture a grocery with a counter.")) == "1 counter"


@pytest.mark.parametrize(
    ("prompt", "category", "states"),
    [
        (
            "A dishwasher and a table. The dishwasher is right of the table and its door is open.",
            "dishwasher",
            ("open",),
        ),
        ("A toolbox on the table, its lid is open.", "toolbox", ("open",)),
        ("A cupboard by the wall and its door is ajar.", "cabinet", ("ajar",)),
        ("Four chairs tucked in. A dining table.", "chair", ("pushed in",)),
        ("The drawer of the desk is open.", "desk", ("open",)),
        ("The doors of the wardrobe are slightly open.", "wardrobe", ("slightly open",)),
        ("The wardrobe's doors are open.", "wardrobe", ("open",)),
        ("A fridge with the door open.", "fridge", ("open",)),
        ("A wardrobe with open doors.", "wardrobe", ("open",)),
        ("Leave the drawers of the dresser open.", "dresser", ("open",)),
        ("A bed with a neatly folded towel on it.", "towels", ("folded",)),
        ("A blanket is neatly folded on the bed.", "blanket", ("folded",)),
        ("A book lies face down on the bed.", "book", ("face down",)),
        ("The blinds are half closed.", "curtain", ("half closed",)),
        ("A cereal box stands upright and a milk carton lies on its side.", "milk_carton", ("on its side",)),
        ("A table with a bottle lying on its side.", "bottle", ("on its side",)),
        ("There are no objects on the table.", "dining_table", ("empty",)),
        ("No items on the desk.", "desk", ("empty",)),
    ],
)
def test_a_state_told_of_a_part(prompt: str, category: str, states: tuple[str, ...]) -> None:
    brief = read_brief(prompt)
    assert _of(brief, category).states == states
    assert brief.free == ()
    assert not any(request.category in ("lid", "door") for request in brief.requests)


@pytest.mark.parametrize(
    ("prompt", "asked", "unknown"),
    [
        (
            "A sideboard and two toy cars. All drawers of the sideboard are closed except the top one.",
            "1 sideboard, 2 toy_car",
            ("except the top one",),
        ),
        (
            "A dining room. The table seats eight, but only six chairs are there; the two missing ones are stacked.",
            "6 chair, 1 dining_table",
            ("the two missing ones",),
        ),
        (
            "Crates of oranges, lemons and apples by the window, one crate each.",
            "3 apple, 3 crate, 3 lemon, 3 orange",
            ("one crate each",),
        ),
        ("A tripod faces the backdrop at a distance of 3 m.", "1 backdrop, 1 tripod", ("at a distance of 3 m",)),
    ],
)
def test_what_is_not_understood_changes_nothing_else(prompt: str, asked: str, unknown: tuple[str, ...]) -> None:
    brief = read_brief(prompt)
    assert sorted(_asked(brief).split(", ")) == sorted(asked.split(", "))
    assert brief.unknown == unknown
    assert brief.excluded == ()
    assert all(request.size == (None, None, None) and not request.unshown for request in brief.requests)


@pytest.mark.parametrize(
    ("prompt", "related_"),
    [
        ("Six beds. An IV stand next to all but two of the beds.", "4 drip_stand next_to bed-2"),
        ("Four desks. Chairs at all of them except one.", "3 chair at desk-2"),
        ("Four desks. A lamp on all but one of the desks.", "3 desk_lamp on desk-2"),
        ("A bedroom with a queen bed whose headboard is against the wall.", "1 bed against_wall wall"),
        ("A workbench carries a robot arm at its left end.", "1 robot_arm left_of workbench"),
        (
            "A workbench with a vise, a truing stand, two screwdrivers and a tin of grease.",
            "2 screwdriver on workbench",
        ),
        ("A workbench with a vise, a truing stand, two screwdrivers and a tin of grease.", "1 tin_can on workbench"),
        ("A desk with a laptop, a mug full of pens and a stack of notebooks.", "1 cup on desk"),
        ("Four desks. Each desk has a mug with two pens and a laptop.", "4 laptop on desk"),
        ("Six benches. Every bench carries a microscope, a rack holding 4 test tubes.", "6 test_tube_rack on bench"),
        (
            "Six benches. Every bench carries a microscope, a rack holding 4 test tubes and a box of gloves.",
            "6 box_of_gloves on bench",
        ),
        ("A table with a bowl holding two apples and a melon.", "1 melon inside bowl"),
    ],
)
def test_where_what_is_listed_belongs(prompt: str, related_: str) -> None:
    assert related_ in related(read_brief(prompt))


@pytest.mark.parametrize(
    ("prompt", "category", "attributes"),
    [
        ("In the room is one big table from glass.", "dining_table", ("large", "glass")),
        ("A desk with a lamp (hers is yellow), a pencil cup and a globe.", "desk_lamp", ("yellow",)),
    ],
)
def test_looks_told_afterwards(prompt: str, category: str, attributes: tuple[str, ...]) -> None:
    brief = read_brief(prompt)
    assert {*attributes} <= {*_of(brief, category).attributes}
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "denied", "told"),
    [
        (
            "Don't put any lamps on the tables - they should stand on the floor instead, two of them. Two tables.",
            ("floor_lamp", "on", "dining_table"),
            "2 floor_lamp on floor",
        ),
        (
            "A kitchen with a counter and a table. Do not put a toaster on the counter, it should go on the table.",
            ("toaster", "on", "base_cabinet"),
            "1 toaster on kitchen_table",
        ),
        (
            "Two chairs. Don't place a plant in the corner, but it should be near the window.",
            ("plant", "in_corner", "corner"),
            "1 plant near window",
        ),
        (
            "A sofa and a desk. No lamp on the desk, it stands on the floor.",
            ("floor_lamp", "on", "desk"),
            "1 floor_lamp on floor",
        ),
    ],
)
def test_what_is_barred_from_one_place_is_at_another(prompt: str, denied: tuple[str, str, str], told: str) -> None:
    brief = read_brief(prompt)
    assert told in related(brief)
    assert denied in [(r.subject, r.kind, *r.anchors) for r in brief.relations if r.negated]
    assert brief.excluded == ()
    assert brief.unknown == ()


def test_what_is_barred_from_a_place_and_told_nowhere_else_is_not_there() -> None:
    assert read_brief("A bedroom with two nightstands. Don't put lamps on the nightstands.").excluded == ("any_lamp",)


def test_no_seat_is_assumed_where_one_was_left_out() -> None:
    brief = read_brief("Office with four desks. Chairs at all of them except one.")
    assert sum(r.count for r in brief.requests if "chair" in r.category) == 3


def test_a_table_in_a_nook_for_two_is_for_two() -> None:
    brief = read_brief("A breakfast nook for two with a bench and a round table.")
    assert "for-2" in _of(brief, "dining_table").attributes


def test_what_each_has_may_be_something_unknown() -> None:
    brief = read_brief("Four tables. Each table gets six chairs, a power strip and a desk lamp.")
    assert _asked(brief) == "24 chair, 4 desk_lamp, 4 dining_table, 4 power_strip"
    assert brief.unknown == ()


def test_in_front_from() -> None:
    brief = read_brief("In front from the wardrobe is lying a soft carpet. To the left from it is a lamp.")
    assert related(brief) == {"1 rug in_front_of wardrobe", "1 floor_lamp left_of rug"}


def test_what_people_own_is_there() -> None:
    assert _asked(read_brief("A bedroom for a musician who owns three guitars and a piano.")) == "3 guitar, 1 piano"


@pytest.mark.parametrize(
    ("prompt", "hung"),
    [
        (
            "A whiteboard is on the wall, and to the left of it hangs a fire extinguisher.",
            "1 wall_extinguisher on wall",
        ),
        ("A fire extinguisher hangs by the door.", "1 wall_extinguisher on wall"),
        ("A shelf hangs next to the window.", "1 wall_shelf on wall"),
        ("A guitar hangs beside the bed.", "1 wall_guitar on wall"),
    ],
)
def test_what_hangs_beside_something_hangs_on_the_wall(prompt: str, hung: str) -> None:
    brief = read_brief(prompt)
    assert hung in related(brief)
    assert brief.unknown == ()


def test_what_hangs_and_cannot_is_told() -> None:
    assert read_brief("Four plants hang next to the window.").unknown == ("Four plants hang",)


def test_an_opposite_corner_is_told() -> None:
    assert read_brief("A bed in one corner and a desk in the opposite corner.").unknown == ("the opposite corner",)


@pytest.mark.parametrize(
    ("prompt", "asked", "doubt"),
    [
        ("The drawer of the desk is red.", "1 desk", "The drawer of the desk is red"),
        ("A shopping cart full of groceries.", "1 shopping_cart", "groceries"),
        ("A basket with a blanket, full of laundry.", "1 basket, 1 blanket", "laundry"),
    ],
)
def test_how_a_part_looks_and_what_matter_is_in_things_is_told(prompt: str, asked: str, doubt: str) -> None:
    brief = read_brief(prompt)
    assert _asked(brief) == asked
    assert brief.room_type == "room"
    assert brief.unknown == (doubt,)


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("An empty bowl and a full glass stand on the table.", "1 bowl, 1 dining_table, 1 glass"),
        ("A mug and a glass stand on the shelf.", "1 cup, 1 glass, 1 shelving_unit"),
        ("A guitar and a music stand in the corner.", "1 guitar, 1 music_stand"),
    ],
)
def test_what_two_things_do_is_no_name(prompt: str, asked: str) -> None:
    assert _asked(read_brief(prompt)) == asked


@pytest.mark.parametrize(
    "prompt",
    [
        "A book standing upright on the shelf between two bookends.",
        "A book stands on the shelf between two bookends.",
    ],
)
def test_small_things_are_between_what_stands_there_too(prompt: str) -> None:
    brief = read_brief(prompt)
    assert ("book", ("bookend",)) in {(r.subject, r.anchors) for r in brief.relations if r.kind == "between"}
    assert brief.unknown == ()
