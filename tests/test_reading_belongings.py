"""What each of several lies on, what is a thing's own, what is in front of what has it, and what comes next."""

import pytest

from tests.test_reading_turns import related
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A table with six chairs and a glass on a coaster in front of each chair.",
            "6 glass on coaster each, 6 coaster on dining_table",
        ),
        (
            "A table with six chairs. In front of each chair there is a glass on a coaster.",
            "6 glass on coaster each, 6 coaster on dining_table",
        ),
        ("Three desks. On each desk stands a lamp on a book.", "3 book on desk each, 3 table_lamp on book each"),
        ("Three desks, a monitor on a box on each desk.", "3 monitor on box each, 3 box on desk each"),
        (
            "Two armchairs, each with a lamp on a side table next to it.",
            "2 table_lamp on side_table each, 2 side_table next_to armchair each",
        ),
        (
            "Two sofas, a vase on a side table beside each.",
            "2 vase on side_table each, 2 side_table next_to sofa each",
        ),
        ("A sofa with a lamp on a side table next to it.", "1 table_lamp on side_table, 1 side_table next_to sofa"),
    ],
)
def test_what_each_of_several_lies_on_is_as_many(prompt: str, relations: str) -> None:
    brief = read_brief(prompt)
    shared = {f"{b.subject} {b.kind} {b.anchors[0]}" for b in brief.relations if b.each}
    told = set(relations.split(", "))
    assert {one.removesuffix(" each") for one in told} <= related(brief)
    assert {one.partition(" ")[2].removesuffix(" each") for one in told if one.endswith(" each")} <= shared
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A piano, its bench and a lamp.", "1 bench at piano"),
        ("A desk, its chair and a lamp.", "1 chair at desk, 1 desk_lamp on desk"),
        ("A bed, its two nightstands and a wardrobe.", "2 nightstand next_to bed"),
        (
            "A round table and its four chairs stand in the centre.",
            "4 chair around dining_table, 1 dining_table in_centre centre",
        ),
        ("A computer and its monitor on the desk.", "1 computer on desk, 1 monitor on desk"),
        ("A bunk bed with its ladder facing the window.", "1 bunk_bed facing window"),
    ],
)
def test_what_is_a_things_own_is_with_it(prompt: str, relations: str) -> None:
    assert related(read_brief(prompt)) == set(relations.split(", "))
    assert read_brief(prompt).unknown == ()


def test_a_ladder_of_a_bed_is_no_thing_and_its_side_is_not_understood() -> None:
    brief = read_brief("A bunk bed, its ladder on the left side, and a desk.")
    assert {r.category for r in brief.requests} == {"bunk_bed", "desk"}
    assert brief.unknown == ("its ladder on the left side",)


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A desk with a chair in front and a bookcase behind.", "1 chair in_front_of desk, 1 bookcase behind desk"),
        ("A sofa with a rug in front.", "1 rug in_front_of sofa"),
        ("A counter has three stools in front.", "3 bar_stool in_front_of counter"),
        ("A room with a sofa in front.", "1 sofa against_wall near_wall"),
    ],
)
def test_what_a_thing_has_in_front_is_at_no_side_of_the_room(prompt: str, relations: str) -> None:
    assert related(read_brief(prompt)) == set(relations.split(", "))
    assert read_brief(prompt).unknown == ()


def test_what_comes_next_is_in_no_list() -> None:
    ordered = "A sofa by the window with a lamp at each end, then a television on the opposite wall."
    assert "1 wall_tv next_to sofa" not in related(read_brief(ordered))
    along = "Along the left wall stand a wardrobe, then a desk."
    assert "1 desk next_to wardrobe" in related(read_brief(along))


@pytest.mark.parametrize(
    ("prompt", "count"),
    [("A bedroom with a queen bed. Each nightstand has a lamp.", 2), ("A kitchen: each chair has a cushion.", 4)],
)
def test_each_of_what_such_a_room_has_are_as_many_as_it_has(prompt: str, count: int) -> None:
    brief = read_brief(prompt)
    assert {r.count for r in brief.requests if r.category in ("nightstand", "table_lamp", "chair", "pillow")} == {count}
    assert brief.unknown == ()


def test_each_of_what_nobody_named_is_told_once() -> None:
    assert read_brief("A living room with a sofa. A lamp on each side table.").unknown == (
        "each side table (none named)",
    )


@pytest.mark.parametrize(
    ("prompt", "things", "told"),
    [
        ("A sofa facing the TV three metres away.", "sofa, tv", "three metres"),
        ("A sofa three metres away from the TV.", "sofa, tv", "three metres away from"),
        ("A bed two metres from the door.", "bed", "two metres from"),
        ("A table two metres long.", "dining_table", ""),
        ("A shelf one and a half metres above the desk.", "desk, wall_shelf", "1.5 metres"),
    ],
)
def test_a_length_in_words_ends_the_name_before_it(prompt: str, things: str, told: str) -> None:
    brief = read_brief(prompt)
    assert sorted(r.category for r in brief.requests if r.asked) == things.split(", ")
    assert brief.unknown == ((told,) if told else ())


def test_so_many_and_half_are_one_number() -> None:
    brief = read_brief("A bedroom of four and a half by five metres.")
    assert (brief.width, brief.depth) == (4.5, 5.0)


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("Two beds along the right wall, a window between them, and a desk.", "2 bed against_wall right_wall"),
        ("Two armchairs with a window between them and a plant in the corner.", "1 plant in_corner corner"),
    ],
)
def test_a_window_between_things_puts_nothing_else_there(prompt: str, relations: str) -> None:
    brief = read_brief(prompt)
    assert related(brief) == set(relations.split(", "))
    assert brief.unknown == ("between them",)


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A table with a chair tucked under it.", "1 chair at dining_table"),
        ("Two sofas in the middle, backs to each other.", "2 sofa in_centre centre, 2 sofa back_to_back sofa"),
        ("Two beds, their heads against the left wall, and a rug.", "2 bed against_wall left_wall"),
        ("Two rows of three desks, backs to the window.", "6 desk in_rows, 6 desk facing_away window"),
    ],
)
def test_how_things_are_turned_is_said_without_a_verb(prompt: str, relations: str) -> None:
    brief = read_brief(prompt)
    assert related(brief) == set(relations.split(", "))
    assert brief.unknown == ()


def test_nothing_is_assumed_where_the_prompt_has_something_else() -> None:
    brief = read_brief("A game room with a foosball table in the middle.")
    assert "pool_table" not in {r.category for r in brief.requests}


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A bed at the back wall with nightstands on both sides, a lamp on the left one and a clock on the right.",
            "1 table_lamp on nightstand",
        ),
        (
            "A sofa along the back wall with two side tables, a lamp on the left one and a vase on the right one.",
            "1 table_lamp on side_table, 1 vase on side_table-2",
        ),
        ("Shelves along the back wall and a bench along the left one.", "1 bench against_wall left_wall"),
        ("Two tables, a shelf on the back wall and a poster on the left one.", "1 poster on left_wall"),
    ],
)
def test_the_left_one_is_a_thing_where_it_carries_such_things_and_else_a_wall(prompt: str, relations: str) -> None:
    assert set(relations.split(", ")) <= related(read_brief(prompt))


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A dresser with a mirror on the south wall.", "1 mirror above dresser, 1 dresser against_wall south_wall"),
        ("A sofa with a painting on the back wall.", "1 picture above sofa, 1 sofa against_wall far_wall"),
        ("A desk with a clock on the left wall.", "1 clock on left_wall"),
        ("A bed with three pictures on the left wall.", "3 picture on left_wall"),
    ],
)
def test_what_hangs_over_furniture_by_nature_hangs_at_its_wall(prompt: str, relations: str) -> None:
    assert related(read_brief(prompt)) == set(relations.split(", "))


def test_a_table_stands_between_things_with_its_chairs() -> None:
    brief = read_brief(
        "A sofa along the left wall, a bed along the right wall and a table with two chairs between them."
    )
    assert {"2 chair around dining_table", "1 dining_table between sofa bed"} <= related(brief)


def test_a_stand_is_called_after_what_is_on_it() -> None:
    brief = read_brief("A TV on a stand with two speakers.")
    assert {"1 tv on tv_stand", "2 speaker on tv_stand"} == related(brief)


def test_what_hangs_is_not_in_the_middle_of_the_room() -> None:
    assert read_brief("A sofa and a wall shelf in the middle.").unknown == ("a wall shelf in the middle (of what?)",)


def test_one_seats_so_many_is_a_verb() -> None:
    brief = read_brief("Two small tables; one seats two people, the other four, hence six chairs.")
    assert [r.count for r in brief.requests if r.category == "chair"] == [6]
    assert {a for r in brief.requests for a in r.attributes if a.startswith("for-")} == {"for-2"}


@pytest.mark.parametrize(
    ("prompt", "lamps"),
    [
        ("A bed flanked by two nightstands with a lamp each.", 2),
        ("A bed flanked by two nightstands with lamps.", 2),
        ("A sofa flanked by two side tables with lamps on them.", 2),
        ("A sofa flanked by two side tables with a lamp on top.", 2),
        ("A bed flanked by two nightstands with a lamp on the left one.", 1),
        ("A bed with a nightstand on the left and a nightstand on the right, each with a lamp on it.", 2),
        ("A bed with a nightstand to its left and another to its right, each with a lamp on it.", 2),
        ("A nightstand on the left and a nightstand on the right of the bed, each with a lamp on it.", 2),
    ],
)
def test_what_flanks_has_its_own_on_both_sides(prompt: str, lamps: int) -> None:
    brief = read_brief(prompt)
    on = [r for r in brief.relations if r.kind == "on" and r.asked]
    assert [r.count for r in brief.requests if r.category == "table_lamp"] == [lamps]
    assert [len(r.anchors) for r in on] == [lamps]
    assert not brief.unknown


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("An armchair in each corner facing the center of the room.", "4 armchair facing centre"),
        ("A sofa facing the middle of the room.", "1 sofa facing centre"),
        ("A table pushed against the wall with three chairs around the other sides.", "3 chair around dining_table"),
    ],
)
def test_what_faces_the_middle_is_not_in_it(prompt: str, relation: str) -> None:
    found = related(read_brief(prompt))
    assert relation in found
    assert not any("in_centre" in said for said in found)


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A tray with two cups on the coffee table.", "2 cup on tray, 1 tray on coffee_table"),
        ("A tray with a teapot and two cups on the table.", "1 teapot on tray, 2 cup on tray, 1 tray on dining_table"),
        ("A plate with an apple on the table.", "1 apple on plate, 1 plate on dining_table"),
        (
            "A plate with a sandwich and a glass on the table.",
            "1 sandwich on plate, 1 plate on dining_table, 1 glass on dining_table",
        ),
        ("A cup with two toothbrushes on the shelf.", "2 toothbrush inside cup, 1 cup on shelving_unit"),
        ("A toolbox with a hammer on the workbench.", "1 hammer inside toolbox, 1 toolbox on workbench"),
        ("A shoebox with three books under the bed.", "3 book inside box, 1 box under bed"),
        ("A pan with two eggs on the stove.", "2 egg on frying_pan, 1 frying_pan on stove"),
        ("A keyboard with a mouse on the desk.", "1 keyboard on desk, 1 mouse on desk"),
    ],
)
def test_what_lies_on_a_tray_stays_on_it_where_the_tray_is_told_to_be(prompt: str, relations: str) -> None:
    assert related(read_brief(prompt)) == set(relations.split(", "))
    assert read_brief(prompt).unknown == ()


@pytest.mark.parametrize(
    ("prompt", "plants"),
    [
        ("A plant pot with a cactus.", {"cactus": 1}),
        ("Two pots with cacti on the shelf.", {"cactus": 2}),
        ("A fern in a pot.", {"plant": 1}),
        ("Two plants in pots.", {"plant": 2}),
        ("A cactus in a clay pot on the windowsill.", {"cactus": 1}),
    ],
)
def test_a_plant_and_its_pot_are_one_thing(prompt: str, plants: dict[str, int]) -> None:
    brief = read_brief(prompt)
    asked = {r.category: r.count for r in brief.requests if r.asked and r.category != "shelving_unit"}
    assert asked == plants
    assert brief.unknown == ()
    unshown = [look for r in brief.requests for look in r.unshown]
    assert unshown == (["in a clay pot"] if "clay" in prompt else [])


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A chair on the left and a plant on the right of the desk.",
            {"1 chair left_of desk", "1 plant right_of desk"},
        ),
        (
            "A statue in the corner with a plant and a bench next to it.",
            {"1 plant next_to statue", "1 bench next_to statue"},
        ),
    ],
)
def test_sides_and_places_told_last_are_of_both(prompt: str, relations: set[str]) -> None:
    assert relations <= related(read_brief(prompt))
    assert not read_brief(prompt).unknown


def test_triplets_with_three_beds_have_three() -> None:
    brief = read_brief("We have triplets, so their bedroom needs three small beds, each with a pillow.")
    assert {r.category: r.count for r in brief.requests if r.asked} == {"bed": 3, "pillow": 3}


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A plate with a fork on its left and a knife on its right.", "1 fork left_of plate, 1 knife right_of plate"),
        ("A tray with a cup to its right and a bowl to its left.", "1 cup right_of tray, 1 bowl left_of tray"),
        ("A mug hangs from a mug tree.", "1 cup on mug_tree"),
        ("A coat hangs from the hook by the door.", "1 coat on coat_hooks, 1 coat_hooks next_to door"),
        ("The drawer of the cabinet contains a spoon and a knife.", "1 spoon inside cabinet, 1 knife inside cabinet"),
        ("The cabinet's drawer holds a spoon.", "1 spoon inside cabinet"),
    ],
)
def test_what_is_beside_on_and_in_small_things_and_drawers(prompt: str, relations: str) -> None:
    assert related(read_brief(prompt)) == set(relations.split(", "))
    assert read_brief(prompt).unknown == ()


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "The left side of the desk has a lamp, the right side a phone.",
            "1 desk_lamp on desk, 1 desk_lamp left_of desk, 1 phone on desk, 1 phone right_of desk",
        ),
        (
            "A lamp on the left and a plant on the right of the sofa.",
            "1 floor_lamp left_of sofa, 1 plant right_of sofa",
        ),
        (
            "A bed on the left and a desk on the right.",
            "1 bed against_wall left_wall, 1 desk against_wall right_wall",
        ),
        ("Four chairs, one on each side of the table.", "4 chair around dining_table"),
        ("A table with four chairs, one on each side.", "4 chair around dining_table"),
        ("Eight chairs around a table, two on each side.", "8 chair around dining_table"),
        (
            "A bathroom with two sinks, each with a mirror above it and a cabinet below.",
            "2 mirror above washbasin, 2 cabinet under washbasin",
        ),
    ],
)
def test_both_sides_and_all_sides_have_what_is_told_of_them(prompt: str, relations: str) -> None:
    assert related(read_brief(prompt)) == set(relations.split(", "))
    assert read_brief(prompt).unknown == ()
