"""What all of a list look like and face, ends of tops, and where a thing is to be without the word for a place."""

import pytest

from tests.test_reading_turns import related
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("Two armchairs and a sofa, all red.", "2 armchair red, 1 sofa red"),
        ("Two armchairs and a sofa, all of them red.", "2 armchair red, 1 sofa red"),
        ("A sofa and an armchair, both made of leather.", "1 sofa leather, 1 armchair leather"),
        ("A table, six chairs and a cabinet, all oak.", "1 dining_table oak, 6 chair oak, 1 cabinet oak"),
        (
            "A table, six chairs and a cabinet, all painted white.",
            "1 dining_table white, 6 chair white, 1 cabinet white",
        ),
        ("A table and six chairs. All of them are made of oak.", "1 dining_table oak, 6 chair oak"),
        ("A room with a sofa, all red.", "1 sofa red"),
        ("A bed with all white pillows.", "1 bed, 2 pillow white"),
    ],
)
def test_all_of_a_list_look_as_is_said_of_all(prompt: str, asked: str) -> None:
    brief = read_brief(prompt)
    found = {" ".join([str(r.count), r.category, *r.attributes]) for r in brief.requests if r.asked}
    assert found == set(asked.split(", "))
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A TV and three sofas, all facing the TV.", "3 sofa facing tv"),
        ("A counter, five stools and a jukebox, all facing the counter.", "1 jukebox facing counter"),
        ("Two desks pushed together front to front.", "2 desk facing desk, 2 desk next_to desk"),
        (
            "A long table. A vase stands at the far end of the table.",
            "1 vase on dining_table, 1 vase left_of dining_table",
        ),
        ("A long table. A vase stands on the table's far end.", "1 vase on dining_table, 1 vase left_of dining_table"),
        ("A long table. A vase at its far end.", "1 vase left_of dining_table"),
        ("A long table. A chair stands at the far end of the table.", "1 chair at_short_side dining_table"),
        ("A sofa at the far end of the room.", "1 sofa against_wall far_wall"),
        ("A bed. A nightstand on the far side of the bed.", "1 nightstand next_to bed"),
        ("A bed. A picture hangs over the head of the bed.", "1 picture above bed"),
        ("A sofa and a lamp within arm's reach of it.", "1 floor_lamp near sofa"),
        (
            "A couch. A tissue box within reach of the couch on a side table.",
            "1 tissue_box near sofa, 1 tissue_box on side_table",
        ),
        ("A deli with a glass display case with four steaks inside.", "4 steak inside display_case"),
        ("Two bunk beds. Between them under the window a desk.", "1 desk between bunk_bed, 1 desk under window"),
        (
            "A sofa. In front of it on a rug a coffee table.",
            "1 coffee_table in_front_of sofa, 1 rug under coffee_table",
        ),
        ("A lobby with a seating group of two sofas facing each other.", "2 sofa facing sofa"),
        ("A lobby with a seating area of four armchairs around a low table.", "4 armchair around coffee_table"),
        (
            "An office. A cart with a monitor and keyboard stands by the window.",
            "1 keyboard on serving_trolley, 1 serving_trolley next_to window",
        ),
    ],
)
def test_what_is_said_of_where_things_are_is_related(prompt: str, relations: str) -> None:
    brief = read_brief(prompt)
    assert set(relations.split(", ")) <= set(related(brief))
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "said", "asked"),
    [
        ("A long table. A lamp hangs over one end of the table.", "over one end of the table", "pendant_lamp"),
        ("A table. A projector hangs over the table's far end.", "over the table's far end", "ceiling_projector"),
        ("A school hall. A clock hangs where the pupils can see it.", "where the pupils can see it", "clock"),
        ("A desk and a lamp where it gives good light.", "where it gives good light", "desk_lamp"),
        ("A gym with a treadmill. No machine near the door.", "No machine near the door", "treadmill"),
        ("A gym with a treadmill, no machines.", "no machines", "treadmill"),
        ("An easel placed so that light falls on it from the left.", "from the left", "easel"),
        ("Six crates stacked in pairs.", "stacked in pairs", "crate"),
        ("A desk. A book is inside the desk.", "inside the desk", "book"),
    ],
)
def test_a_place_that_nobody_follows_is_told_and_makes_nothing(prompt: str, said: str, asked: str) -> None:
    brief = read_brief(prompt)
    assert said in brief.unknown
    assert [r.category for r in brief.requests if r.category == asked] == [asked]
    assert len([r for r in brief.requests if r.asked]) <= 2


def test_stands_after_what_is_made_of_two_words_may_still_be_a_thing() -> None:
    brief = read_brief("A shop with two lamps and plant stands by the window.")
    assert [r.category for r in brief.requests if r.asked] == ["floor_lamp", "plant_stand"]


@pytest.mark.parametrize("prompt", ["A bedroom with a desk where she reads.", "An office where three people work."])
def test_what_people_do_somewhere_asks_for_nothing(prompt: str) -> None:
    assert read_brief(prompt).unknown == ()


def test_a_seating_group_is_what_is_listed_of_it() -> None:
    brief = read_brief("A lobby with a seating group: two armchairs around a coffee table.")
    assert {r.category for r in brief.requests if r.asked} == {"armchair", "coffee_table"}


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("A dining room with a table for six, no chairs but two benches.", {"dining_table": 1, "bench": 2}),
        ("A dining room with a table for six. Benches instead of chairs.", {"dining_table": 1, "bench": 2}),
        ("A table for six and no chairs.", {"dining_table": 1}),
    ],
)
def test_seats_that_are_barred_are_not_assumed_at_a_table(prompt: str, asked: dict[str, int]) -> None:
    brief = read_brief(prompt)
    assert {r.category: r.count for r in brief.requests} == asked


def test_what_hangs_low_hangs_from_the_ceiling() -> None:
    (lamp,) = (r for r in read_brief("A low-hanging lamp over a table.").requests if r.category == "pendant_lamp")
    assert lamp.attributes == ("low",)


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "On the left three washbasins, on the right four desks.",
            "3 washbasin against_wall left_wall, 4 desk against_wall right_wall",
        ),
        ("At the back four lockers.", "4 locker against_wall far_wall"),
        ("In the middle two tables.", "2 dining_table in_centre centre"),
        (
            "A desk. On the left two monitors, on the right a printer.",
            "2 monitor left_of desk, 1 printer right_of desk",
        ),
        ("Four chairs. A lamp stands next to the left two chairs.", "1 floor_lamp next_to chair"),
        ("A long table, seven chairs a side and one at the head.", "14 chair around dining_table"),
        ("A table with ten chairs, a bottle at all seats.", "10 bottle on dining_table"),
        ("A gallery. Each wall has two paintings.", "8 picture on wall"),
        ("A hall. Each corner holds a plant.", "4 plant in_corner corner"),
        ("A hall. Each window has a curtain.", "2 curtain next_to window"),
    ],
)
def test_so_many_at_sides_seats_walls_and_corners_are_there(prompt: str, relations: str) -> None:
    brief = read_brief(prompt)
    assert set(relations.split(", ")) <= set(related(brief))
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "said"),
    [
        ("A sofa. Opposite the sofa, at 2.5 meters, a TV.", "2.5 meters"),
        ("A kids room with a bunk bed. A teddy bear on the lower bunk.", "on the lower bunk"),
        ("A deli with a glass counter with four steaks inside.", "inside"),
        ("A deli. Inside the glass counter are four steaks.", "Inside the glass counter"),
        ("A gallery. Two paintings on each wall except the door wall.", "except the door wall"),
    ],
)
def test_exact_distances_and_walls_left_out_are_told(prompt: str, said: str) -> None:
    assert said in read_brief(prompt).unknown


def test_the_left_two_of_four_are_two_of_them() -> None:
    brief = read_brief("A room with four chairs. The left two chairs are red.")
    assert [(r.count, r.attributes) for r in brief.requests] == [(2, ("red",)), (2, ())]


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A dining table surrounded by six chairs, a chandelier hanging above the table, and a china cabinet.",
            "6 chair around dining_table, 1 chandelier above dining_table",
        ),
        (
            "Two beds separated by a nightstand with a phone, a desk with a chair against the wall.",
            "1 nightstand between bed, 1 phone on nightstand, 1 chair at desk, 1 desk against_wall wall",
        ),
        (
            "Two nightstands each holding a lamp, a bench at the foot of the bed.",
            "2 table_lamp on nightstand, 1 bench at_foot_of bed",
        ),
        (
            "A living room with a sofa, a bookshelf in the corner with a plant next to it.",
            "1 bookcase in_corner corner, 1 plant next_to bookcase",
        ),
        (
            "A fountain surrounded by benches, trees and lamps.",
            "2 bench around fountain, 3 plant around fountain, 2 floor_lamp around fountain",
        ),
    ],
)
def test_lists_end_where_something_else_is_told(prompt: str, relations: str) -> None:
    brief = read_brief(prompt)
    assert set(related(brief)) == set(relations.split(", "))
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A bedroom with a bed and a desk against the opposite wall.",
            "1 bed against_wall one_wall, 1 desk against_wall opposite_wall",
        ),
        (
            "A bedroom with a bed in the corner, a nightstand to its right and a desk on the other side of the room.",
            "1 bed in_corner corner, 1 nightstand right_of bed, 1 desk far bed, 1 desk against_wall wall",
        ),
        ("A bed, a nightstand to its right and a desk against the opposite wall.", "1 desk against_wall opposite_wall"),
    ],
)
def test_the_opposite_wall_is_across_from_the_furniture_that_leads(prompt: str, relations: str) -> None:
    brief = read_brief(prompt)
    assert set(relations.split(", ")) <= set(related(brief))
    assert not any(r.kind == "opposite" for r in brief.relations)


@pytest.mark.parametrize(
    ("prompt", "category", "look"),
    [
        ("A living room with a sofa and an armchair. Both pieces are grey.", ("sofa", "armchair"), "grey"),
        ("A bedroom with a bed and a wardrobe. The furniture is white.", ("bed", "wardrobe"), "white"),
        ("A bedroom with a bed and a desk. Each piece is white.", ("bed", "desk"), "white"),
        ("There are a bench and two stools. These seats are made of wood.", ("bench", "stool"), "wooden"),
        ("A sofa, two armchairs and a coffee table. The seating is grey.", ("sofa", "armchair"), "grey"),
        ("A kitchen with a table, a fridge and a stove. The appliances are white.", ("fridge", "stove"), "white"),
        ("A desk with a laptop and a printer. Both devices are black.", ("laptop", "printer"), "black"),
        ("On the table are a plate, a fork and a glass. The tableware is blue.", ("plate", "fork", "glass"), "blue"),
        ("A cup and a plate on a table. Both items are blue.", ("cup", "plate"), "blue"),
        ("A sofa, a rug and a lamp. All three items are red.", ("sofa", "rug", "floor_lamp"), "red"),
        ("A dresser and a wardrobe. Both storage pieces are oak.", ("dresser", "wardrobe"), "oak"),
        ("A bedroom with white furniture: a bed and a wardrobe.", ("bed", "wardrobe"), "white"),
        ("A living room with wooden furniture including a desk and a chair.", ("desk", "chair"), "wooden"),
        ("Black devices such as a laptop and a printer on a desk.", ("laptop", "printer"), "black"),
    ],
)
def test_what_a_word_for_many_kinds_means_was_named(prompt: str, category: tuple[str, ...], look: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert {r.category for r in brief.requests if look in r.attributes} == {*category}
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "subjects", "relation"),
    [
        (
            "The kitchen has a fridge, a stove and a dishwasher. All three appliances stand against the north wall.",
            {"fridge", "stove", "dishwasher"},
            ("against_wall", "north_wall"),
        ),
        ("A bench, two stools and a TV. All three seats face the TV.", {"bench", "stool"}, ("facing", "tv")),
        ("A teddy bear and a doll. Both toys sit on the bed.", {"teddy_bear", "doll"}, ("on", "bed")),
        ("A bed and a desk. A rug lies between the two pieces.", {"rug"}, ("between", "bed", "desk")),
        (
            "A washing machine and a dryer. A basket is on each machine.",
            {"basket"},
            ("on", "washing_machine", "dryer"),
        ),
        (
            "A treadmill and a rowing machine. Both machines face the mirror.",
            {"treadmill", "rowing_machine"},
            ("facing", "mirror"),
        ),
        (
            "Three boxes, two crates and a barrel. All six items are along the north wall.",
            {"box", "crate", "barrel"},
            ("against_wall", "north_wall"),
        ),
    ],
)
def test_what_stands_so_was_named_before(prompt: str, subjects: set[str], relation: tuple[str, ...]) -> None:
    brief = read_brief(prompt, fill="named")
    assert {r.subject for r in brief.relations if (r.kind, *r.anchors) == relation} == subjects
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "unknown"),
    [
        ("A fridge, a stove and an oven. All four appliances stand against the wall.", "All four appliances"),
        ("The furniture is made of oak. There is a bed and a desk.", "The furniture is made of oak"),
    ],
)
def test_a_word_for_many_kinds_that_means_nothing_named_is_told(prompt: str, unknown: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert unknown in brief.unknown
    assert not {r.category for r in brief.requests} & {"appliance", "furniture"}


@pytest.mark.parametrize("rest", ["and the rest are blue", ", the rest are blue", "and the others are blue"])
def test_the_rest_are_the_others(rest: str) -> None:
    brief = read_brief(f"There are five chairs. Two of them are red {rest}.".replace(" ,", ","))
    assert {(r.count, r.attributes) for r in brief.requests if r.asked} == {(2, ("red",)), (3, ("blue",))}


@pytest.mark.parametrize(
    ("prompt", "states", "unshown"),
    [
        ("A desk that is made of oak.", (), ()),
        ("The table is made of crates.", (), ("made of crates",)),
        ("The shelf is made from pallets.", (), ("made of pallets",)),
        ("A bed that is made.", ("made",), ()),
    ],
)
def test_what_a_thing_is_made_of_is_no_other_thing(
    prompt: str, states: tuple[str, ...], unshown: tuple[str, ...]
) -> None:
    [request] = [r for r in read_brief(prompt).requests if r.asked]
    assert (request.states, request.unshown) == (states, unshown)


@pytest.mark.parametrize(
    ("prompt", "looks"),
    [
        ("A black and white rug lies under the coffee table.", {"rug": ("black", "white"), "coffee_table": ()}),
        ("Two red and white chairs.", {"chair": ("red", "white")}),
        (
            "A wooden table, painted green, and two metal chairs.",
            {"dining_table": ("wooden", "green"), "chair": ("metal",)},
        ),
        ("A dresser, painted light blue.", {"dresser": ("light-blue",)}),
        ("A desk of solid oak.", {"desk": ("oak",)}),
        ("The sofa is grey, the armchairs are too.", {"sofa": ("grey",), "armchair": ("grey",)}),
        ("The bed is white and the desk is as well.", {"bed": ("white",), "desk": ("white",)}),
    ],
)
def test_looks_of_two_colours_and_told_in_other_words(prompt: str, looks: dict[str, tuple[str, ...]]) -> None:
    brief = read_brief(prompt, fill="named")
    assert {r.category: r.attributes for r in brief.requests if r.asked} == looks
    assert brief.unknown == ()


def test_two_colours_before_two_nouns_are_of_two_things() -> None:
    brief = read_brief("A green and a black chair, and two red and two white stools.", fill="named")
    assert {(r.category, r.count, r.attributes) for r in brief.requests} == {
        ("chair", 1, ("green",)),
        ("chair", 1, ("black",)),
        ("stool", 2, ("red",)),
        ("stool", 2, ("white",)),
    }


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("There are twice as many chairs as tables. There are three tables.", {"chair": 6, "dining_table": 3}),
        ("There are three tables and three times as many chairs.", {"chair": 9, "dining_table": 3}),
        ("There are three tables. There are four times as many chairs as tables.", {"chair": 12, "dining_table": 3}),
    ],
)
def test_so_many_times_as_many(prompt: str, counts: dict[str, int]) -> None:
    brief = read_brief(prompt, fill="named")
    assert {r.category: r.count for r in brief.requests if r.asked} == counts
    assert brief.unknown == ()


@pytest.mark.parametrize(
    "prompt",
    [
        "Two lamps on the wall above the bed.",
        "Mounted on the wall above the bed are two lamps.",
        "Two lights are mounted on the wall above the bed.",
    ],
)
def test_lamps_on_a_wall_hang_from_no_ceiling(prompt: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert {r.category: r.count for r in brief.requests} == {"wall_lamp": 2, "bed": 1}


@pytest.mark.parametrize(
    ("floor", "laying"),
    [
        ("a black and white tiled floor", "checker"),
        ("black and white floor tiles", "checker"),
        ("black floor tiles", "tiles"),
    ],
)
def test_a_floor_of_two_colours_paints_no_walls(floor: str, laying: str) -> None:
    brief = read_brief(f"A kitchen with {floor}.")
    assert [(s.part, s.laying) for s in brief.surfaces] == [("floor", laying)]
    assert brief.unknown == ()


def test_walls_of_the_room_are_its_walls() -> None:
    [walls] = read_brief("The walls of the room are painted in a light green.").surfaces
    assert (walls.part, walls.laying) == ("walls", "paint")
