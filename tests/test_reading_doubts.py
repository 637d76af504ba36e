"""Words that point at others, lists and sides: what is read for what it says, and what is said not to be sure."""

import pytest

from tests.test_reading_turns import counted, related
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        # "It" is one thing, and goes on about what the sentence before was about.
        ("Four floor cushions around a low table, a tea set on it.", ["1 tea_set on coffee_table"]),
        ("The sofa is against the wall; above it hang prints. The lamp stands to its left. In front of it is a rug.",
         ["1 floor_lamp left_of sofa", "1 rug in_front_of sofa"]),
        ("A table in the middle, a scale by the door, a cabinet against the back wall; above it two wall cupboards.",
         ["2 wall_cabinet above cabinet"]),
        ("To the left of the laptop is a notebook with a pen on it. To the right, a mug.", ["1 cup right_of laptop"]),
        ("The sink has a dishwasher on its right. A trash can stands on the other side. A base cabinet.",
         ["1 dishwasher right_of sink", "1 waste_bin left_of sink"]),
        ("Three beakers on a table; to their right is a flask and to their left a box.", ["1 box left_of beaker"]),
        ("A washbasin left of the toilet, a mirror over the former, a shelf over the latter.",
         ["1 mirror above washbasin", "1 wall_shelf above toilet"]),
        ("An island; on it a cutting board with a loaf of bread, left of it two tomatoes.",
         ["2 tomato left_of cutting_board"]),
        # What a pronoun means is weighed: what can bear the relation, how lately it was named, and as what.
        ("A sink, a bath and a counter with a sponge, a stove and a kettle on it.", ["1 kettle on base_cabinet"]),
        ("A counter, a mannequin beside the counter, a spool rack above it.", ["1 shelving_unit above counter"]),
        ("A laboratory with two workbenches, a washbasin between the benches and a first aid kit above it.",
         ["1 first_aid_kit above washbasin"]),
        ("Twin beds with a nightstand between them and a lamp on it.", ["1 table_lamp on nightstand"]),
        ("A pinball machine and a jukebox along the left wall, a table tennis table opposite them.",
         ["1 table_tennis opposite pinball_machine jukebox"]),
        ("A bench, four hooks above it with coats, three pairs of boots under it.", ["3 boots under bench"]),
        ("A bed against the left wall and a wardrobe on the same wall as the bed.",
         ["1 wardrobe against_wall left_wall"]),
        ("A fridge with a sign on its door.", ["1 sign on fridge"]),
        ("A car in the middle, a bench with a saw and a hammer to the right of the car.",
         ["1 bench right_of car", "1 hammer on bench"]),
        ("A small altar with a bell and a candle opposite the door.", ["1 altar opposite door", "1 candle on altar"]),
        ("A boiler in the corner, a mop and a bucket beside it.", ["1 mop next_to boiler", "1 bucket next_to boiler"]),
        ("A sorting table, three crates with apples under it.", ["3 crate under sorting_table"]),
        ("A table with a bowl with apples on it.", ["1 bowl on dining_table"]),
        ("An island; on the island are a cutting board with a knife on it and a bowl of lemons.",
         ["1 bowl on kitchen_island", "3 lemon inside bowl"]),
        ("Three tables, each with a lamp, two chairs and a crate of bottles.", ["3 crate_of_bottles on dining_table"]),
        ("A vanity with a lit mirror.", ["1 mirror above dressing_table"]),
        ("A bed, a dresser with a mirror above it opposite the bed.", ["1 dresser opposite bed"]),
        # Where a whole list is, and where only its last thing.
        ("A nightstand with an alarm clock on the right of the bed.", ["1 nightstand right_of bed"]),
        ("A shelf with six stuffed animals above the dresser.", ["1 wall_shelf above dresser"]),
        ("A shelf full of fabric rolls on the opposite wall.", ["1 wall_shelf on opposite_wall"]),
        ("A scale and a height chart next to the door.", ["1 scale next_to door", "1 height_chart next_to door"]),
        ("Two candlesticks and a cross on the altar.", ["2 candlestick on altar", "1 cross on altar"]),
        ("A table with four chairs on a rug.", ["1 rug under dining_table"]),
        ("A fridge, a stove and a desk in one line.", ["1 stove next_to fridge", "1 desk next_to stove"]),
        ("A table, a chair, and two lamps wall-mounted above the table.", ["2 pendant_lamp above dining_table"]),
        ("A desk with a computer at the front.", ["1 desk against_wall near_wall", "1 computer on desk"]),
        ("Two washers and two dryers side by side along one wall.", ["2 washing_machine against_wall one_wall"]),
        ("A rack of dumbbells, a bench in front of the rack.", ["1 bench in_front_of dumbbell_rack"]),
        ("Four racks, back to back.", ["4 shelving_unit back_to_back shelving_unit"]),
        ("Two sofas facing away from each other.", ["2 sofa back_to_back sofa"]),
        ("A sofa that faces away from the window.", ["1 sofa facing_away window"]),
        ("An armchair with its back to a fireplace.", ["1 armchair facing_away fireplace"]),
        ("Two desks with their backs to the door.", ["2 desk facing_away door"]),
        ("A desk with its back to the wall.", ["1 desk against_wall wall"]),
        ("A throw draped across an armchair.", ["1 blanket on armchair"]),
        ("Someone has thrown a coat over the back of the chair.", ["1 coat on chair"]),
        ("A sofa with a throw over one arm.", ["1 blanket on sofa"]),
        ("A mirror placed over a sink, a chandelier that hangs over a dining table.",
         ["1 mirror above sink", "1 chandelier above dining_table"]),
        ("A bed with a nightstand on the left side and one on the right.",
         ["1 nightstand left_of bed", "1 nightstand-2 right_of bed"]),
        ("The nightstand to the left of the bed has a lamp, the one on the right a clock.",
         ["1 table_lamp on nightstand", "1 clock on nightstand-2"]),
        ("A nightstand is left of the bed and another to the right. The left one has a lamp, the right one a book.",
         ["1 table_lamp on nightstand", "1 book on nightstand-2"]),
        ("A bathtub and a towel rail next to the shower.", ["1 towel_rail next_to shower_cabin"]),
        ("A sofa with a table on each side.", ["1 side_table left_of sofa", "1 side_table-2 right_of sofa"]),
        ("Three windows and a desk under each of them.", ["3 desk under window"]),
        ("A plant by both windows.", ["2 plant next_to window"]),
        ("A sculpture on a pedestal in each corner.", ["4 sculpture on pedestal", "4 pedestal in_corner corner"]),
        # Sides and parts.
        ("A bed, two nightstands (one each side).", ["1 nightstand left_of bed", "1 nightstand-2 right_of bed"]),
        ("A table with three chairs each long side, one at each end.",
         ["6 chair at_long_side dining_table", "2 chair-2 at_short_side dining_table"]),
        ("A bench along the left wall and a sofa along the right one.", ["1 sofa against_wall right_wall"]),
        ("A desk, shelves on the wall to the right.", ["2 wall_shelf on right_wall"]),
        ("A console table halfway down the left wall.", ["1 console_table in_centre left_wall"]),
        ("Front: a whiteboard. Back: two cabinets.",
         ["1 whiteboard against_wall near_wall", "2 cabinet against_wall far_wall"]),
        ("Six pews in two columns facing an altar.", ["6 pew in_rows", "6 pew facing altar"]),
        ("A sofa in each front corner.", ["2 sofa in_corner near_wall"]),
        # Some of several.
        ("Two beds, each with a nightstand. On the nightstand by the door is a clock; the other one has a lamp.",
         ["1 nightstand next_to door", "1 clock on nightstand", "1 table_lamp on nightstand-2"]),
        ("Two sofas, a side table at either end of a desk, a book on one of them and a lamp on the other.",
         ["1 book on side_table", "1 table_lamp on side_table-2"]),
        ("Three chairs. A trolley stands between the first and the second chair.",
         ["1 serving_trolley between chair chair-2"]),
        ("Six benches. Every bench has a microscope except the last one, which holds a scale.",
         ["5 microscope on bench-2", "1 scale on bench"]),
        ("Three workbenches, a clock on the first two, and one stool at each.", ["3 stool at workbench workbench-2"]),
        ("A water cooler between the two beds and the door.", ["1 water_dispenser next_to door"]),
        ("A microwave, a toaster next to it, a mug on the other side of the microwave. A counter.",
         ["1 toaster left_of microwave", "1 cup right_of microwave"]),
        ("The bed is in the middle of the back wall.", ["1 bed in_centre far_wall"]),
    ],
)  # fmt: skip
def test_it_is_read_for_what_it_says(prompt: str, relations: list[str]) -> None:
    brief = read_brief(prompt, fill="named")
    assert set(relations) <= related(brief)
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("Twenty desks, each with a chair behind it, the teacher's desk at the front.", {"desk": 21, "chair": 20}),
        ("Four desks, each with a monitor, a keyboard and a mouse, and an office chair.", {"office_chair": 4}),
        ("A bench and kettlebells (4).", {"kettlebell": 4}),
        ("A counter with four mirrors above it, each surrounded by bulbs, four stools in front of the counter.",
         {"bar_stool": 4}),
        ("A bean bag in front of the TV, TV on the wall.", {"tv": 0, "wall_tv": 1}),
        ("A rail instead of a wardrobe, kettle and hot plate on a fridge.", {"kettle": 1, "hot_plate": 1}),
        ("A bench for four stands by the door.", {"stand": 0}),
        ("A sofa, no TV. A bench? No. She doesn't want a rug.", {"bench": 0, "rug": 0, "sofa": 1}),
        ("A large, round table and a big, soft, red sofa.", {"dining_table": 1, "sofa": 1}),
        ("Two beds, at the end of each a toy box, one red, one yellow.", {"toy_box": 2}),
        ("The dining table stands by the door, the sofa in front of the coffee table.",
         {"dining_table": 1, "coffee_table": 1}),
        ("The first cabinet holds vases, the second toolboxes. Two cabinets.", {"toolbox": 3}),
    ],
)  # fmt: skip
def test_so_many_are_meant(prompt: str, counts: dict[str, int]) -> None:
    found = counted(read_brief(prompt, fill="named"))
    desks = found.get("desk", 0) + found.get("school_desk", 0)
    found["desk"] = desks
    assert {category: found.get(category, 0) for category in counts} == counts


@pytest.mark.parametrize(
    ("prompt", "unsure"),
    [
        ("Four chairs, a table and a lamp next to the chair.", "the chair (which of 4?)"),
        ("A double vanity and a mirror above each basin.", "each"),
        (
            "A table in a room. A laptop in the centre of the room and a lamp next to the wardrobe, a wardrobe.",
            "laptop",
        ),
        ("A pegboard wall with hammers on it. Posters on every wall but the one with the window.", "but the one"),
        ("A sofa. A cushion in the corner of the sofa.", "in the corner of the sofa"),
        ("On the top shelf of the rack are gloves.", "top shelf"),
        ("A chair is pushed back from the desk.", "from the desk"),
        ("A toilet behind a half wall.", "behind a half wall"),
        ("Three display cases forming a U.", "forming a U"),
        ("Four desks in pairs; between the pairs a row of plants.", "between the pairs"),
        ("Sixty chairs, an aisle in the middle.", "an aisle in the middle"),
        ("A microphone on stands, a desk.", "on stands"),
        ("A bedroom with a desk facing the window and a bed facing the other window.", "the other window"),
        ("A table with three chairs. A laptop at each of the nine seats.", "nine seats"),
    ],
)
def test_what_is_not_sure_is_said(prompt: str, unsure: str) -> None:
    assert unsure in "; ".join(read_brief(prompt).unknown)


@pytest.mark.parametrize("prompt", ["A striped rug.", "Three cushions, two of them striped."])
def test_a_pattern_is_asked_of_the_thing(prompt: str) -> None:
    assert any("striped" in request.attributes for request in read_brief(prompt, fill="named").requests)


def test_a_stack_says_how_things_lie() -> None:
    (bowls,) = (r for r in read_brief("A stack of three glass bowls on a table.").requests if r.category == "bowl")
    assert (bowls.count, bowls.states) == (3, ("stacked",))


@pytest.mark.parametrize(
    "prompt",
    [
        "A bench between two stools, an amp on the right of the bench, a stack of boxes left of a table, a drum on it.",
        "A desk under the window, a chair next to a cabinet, a plant behind it.",
        "A room with a fireplace, an armchair and a bookcase beside it.",
        "A bench, two stools and a coat rack above them.",
    ],
)
def test_what_may_mean_either_of_two_is_said(prompt: str) -> None:
    assert any(" or " in said for said in read_brief(prompt).unknown)


@pytest.mark.parametrize(
    ("prompt", "denied"),
    [
        ("A television. The sofa faces the fireplace, not the television.", ("facing", "sofa", ("tv",))),
        ("A chair that faces the desk rather than the window.", ("facing", "chair", ("window",))),
        ("The bed stands by the window and not the door.", ("next_to", "bed", ("door",))),
        ("A shelf, a desk and a lamp on the desk but not the shelf.", ("on", "desk_lamp", ("shelving_unit",))),
    ],
)
def test_what_is_left_out_before_what_is_denied_is_said_again(prompt: str, denied: tuple[str, str, tuple[str]]) -> None:
    brief = read_brief(prompt, fill="named")
    assert [(r.kind, r.subject, r.anchors) for r in brief.relations if r.negated] == [denied]
    assert brief.unknown == ()


@pytest.mark.parametrize("who", ["the teacher", "him", "the visitors"])
def test_what_is_behind_somebody_is_behind_nothing(who: str) -> None:
    brief = read_brief(f"A study with a desk, a chair behind it and a bookcase behind {who}.")
    assert brief.unknown == (f"behind {who}",)
    assert [r.category for r in brief.requests if r.asked] == ["executive_desk", "chair", "bookcase"]
