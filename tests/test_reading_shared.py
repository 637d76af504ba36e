"""What is said of all together, of all but some, or of each of several, and of nothing besides."""

import pytest

from tests.briefs import asked, related, told
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "The four stuffed animals are all in a basket.",
            {"stuffed_animal": 4, "basket": 1},
            {"stuffed_animal inside basket"},
        ),
        ("Two chairs, both at a desk.", {"chair": 2, "desk": 1}, {"chair at desk"}),
        ("Six chairs, all at a table.", {"chair": 6, "dining_table": 1}, {"chair around dining_table"}),
        ("Two lamps, each on a table.", {"table_lamp": 2, "dining_table": 2}, {"table_lamp on dining_table"}),
    ],
)
def test_all_share_one_thing(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "Everything but the easel stands against the walls: a daybed, a chest and two shelving units.",
            {"daybed against_wall wall", "chest against_wall wall", "shelving_unit against_wall wall"},
        ),
        (
            "A sofa, a bed and a desk with a lamp on it. Everything except the desk is against the wall.",
            {"sofa against_wall wall", "bed against_wall wall", "desk_lamp on desk"},
        ),
        (
            "There is a bed. There is a stove and a fridge. Everything is against the wall.",
            {"bed against_wall wall", "stove against_wall wall", "fridge against_wall wall"},
        ),
    ],
)
def test_everything_but_what_is_excepted(prompt: str, relations: set[str]) -> None:
    assert told(prompt)[1] == relations


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A cash register and a jar of treats on the counter.",
            {"cash_register on counter", "jar on counter", "treats inside jar"},
        ),
        (
            "A vase with roses, a tray with two cups and a lamp on the sideboard.",
            {
                "vase on sideboard",
                "cut_flower inside vase",
                "tray on sideboard",
                "cup on tray",
                "table_lamp on sideboard",
            },
        ),
        ("A balance board and two dumbbells on a mat.", {"door_mat under balance_board", "dumbbell on door_mat"}),
        (
            "Five sacks next to the counter; two cages on a table with a wheel in each.",
            {"sack next_to counter", "cage on dining_table", "wheel inside cage each"},
        ),
    ],
)
def test_what_is_listed_lies_together(prompt: str, relations: set[str]) -> None:
    assert told(prompt)[1] == relations


@pytest.mark.parametrize(
    "words",
    ["up to the ceiling", "that reach to the ceiling", "going all the way up to the ceiling", "that reach the ceiling"],
)
def test_what_reaches_the_ceiling_hangs_from_none(words: str) -> None:
    brief = read_brief(f"A big table and shelves {words}.")
    looks = {r.category: r.attributes for r in brief.requests if r.asked}
    assert looks == {"dining_table": ("large",), "shelving_unit": ("full-height",)}
    assert not related(brief)


def test_a_square_room_makes_no_table_square() -> None:
    brief = read_brief("A round table in the centre of a dining room, five metres square, and six chairs around it.")
    assert (brief.width, brief.depth) == (5.0, 5.0)
    assert brief.request("dining_table").attributes == ("round", "for-6")


@pytest.mark.parametrize(
    ("prompt", "look"),
    [
        ("Over the table hangs a lantern.", "hanging"),
        ("A table against the wall. Over the table hangs a lantern.", "wall-mounted"),
        ("A lantern hangs over the bed.", "wall-mounted"),
    ],
)
def test_what_is_over_a_table_hangs_from_the_ceiling(prompt: str, look: str) -> None:
    assert read_brief(prompt).request("lantern").attributes == (look,)


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        (
            "A long table with eight place settings with a plate and a fork each.",
            {"dining_table": 1, "plate": 8, "fork": 8},
        ),
        (
            "Four place settings on the table: a plate, a fork and a knife each.",
            {"plate": 4, "fork": 4, "knife": 4, "dining_table": 1},
        ),
        (
            "An oval table with place settings for six, each with a plate and a glass.",
            {"dining_table": 1, "plate": 6, "glass": 6},
        ),
        (
            "A table is laid for six, with a plate and a glass at each setting.",
            {"dining_table": 1, "plate": 6, "glass": 6},
        ),
        (
            "The table is laid for two: a plate and a napkin at every place.",
            {"dining_table": 1, "plate": 2, "napkin": 2},
        ),
        ("Two tables, each seating six. At every seat there is a glass.", {"dining_table": 2, "glass": 12}),
        (
            "A table for four with a vase in the middle and a plate at each place.",
            {"dining_table": 1, "vase": 1, "plate": 4},
        ),
        ("A table with four chairs and a plate at each place.", {"dining_table": 1, "chair": 4, "plate": 4}),
        ("Two benches at a table with a plate at each place.", {"bench": 2, "dining_table": 1, "plate": 2}),
        ("A dining table that seats six. One of the chairs is red.", {"dining_table": 1, "chair": 1, "chair-2": 5}),
    ],
)
def test_so_many_are_laid_as_sit_there(prompt: str, things: dict[str, int]) -> None:
    assert told(prompt)[0] == things


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A sofa stands against the wall, opposite a low TV bench with a television on it.",
            {"sofa against_wall wall", "sofa opposite tv_stand", "tv on tv_stand"},
        ),
        ("A desk, next to a cabinet with a printer on it.", {"desk next_to cabinet", "printer on cabinet"}),
        (
            "A counter with a rack behind it; five barrels, each with two glasses and a candle on it.",
            {"shelving_unit behind counter", "glass on barrel each", "candle on barrel each"},
        ),
    ],
)
def test_it_is_what_has_what_is_listed(prompt: str, relations: set[str]) -> None:
    assert told(prompt)[1] == relations


@pytest.mark.parametrize(
    ("words", "chairs"),
    [
        ("two chairs on each side", 8),
        ("a chair on each side", 4),
        ("two chairs on each of two sides", 4),
        ("two chairs on all four sides", 8),
        ("eight chairs on all four sides", 8),
        ("two chairs on either side", 2),
    ],
)
def test_a_square_table_has_four_sides(words: str, chairs: int) -> None:
    assert told(f"A square table with {words}.")[0] == {"dining_table": 1, "chair": chairs}


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "Along the right wall, from front to back: a bookcase, a desk and a plant.",
            {
                "bookcase against_wall right_wall",
                "desk against_wall right_wall",
                "desk right_of bookcase",
                "plant against_wall right_wall",
                "plant right_of desk",
            },
        ),
        (
            "On the left wall stand a wardrobe and a dresser, from back to front.",
            {"wardrobe against_wall left_wall", "dresser against_wall left_wall", "dresser right_of wardrobe"},
        ),
    ],
)
def test_in_the_order_that_is_told(prompt: str, relations: set[str]) -> None:
    assert told(prompt)[1] == relations


def test_an_order_that_is_not_kept_is_told() -> None:
    assert read_brief("A bed and a desk on the left wall. From left to right.").unknown == ("From left to right",)


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("Six desks facing the teacher's desk at the front.", {"desk facing desk-2", "desk-2 against_wall near_wall"}),
        ("Ten chairs, facing the altar in the corner.", {"chair facing altar", "altar in_corner corner"}),
        (
            "Two shelves one above the other on the wall.",
            {"wall_shelf above wall_shelf-2", "wall_shelf on wall", "wall_shelf-2 on wall"},
        ),
        ("An armchair with a footrest in front of it.", {"ottoman in_front_of armchair"}),
        ("The bathtub stands lengthwise along the back wall.", {"bathtub against_wall far_wall"}),
        ("A guitar stands upright in the corner.", {"guitar in_corner corner"}),
    ],
)
def test_where_it_is_said_to_be(prompt: str, relations: set[str]) -> None:
    assert told(prompt)[1] == relations


@pytest.mark.parametrize(
    "prompt",
    [
        "There are no more than five plants but at least three.",
        "At least three plants and at most five.",
        "At least three but no more than five plants.",
    ],
)
def test_a_number_has_both_bounds(prompt: str) -> None:
    brief = read_brief(prompt)
    assert not brief.unknown
    assert brief.request("plant").bounds == (3, 5)


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "Six chairs around a table. The armchair stands in the corner.",
            {"chair": 6, "dining_table": 1, "armchair": 1},
            {"chair around dining_table", "armchair in_corner corner"},
        ),
        (
            "Step 1: put the workbench under the window. Step 2: place a stool in front of the workbench.",
            {"workbench": 1, "stool": 1},
            {"workbench under window", "stool in_front_of workbench"},
        ),
        (
            "sofa: against north wall, coffee table: in front of sofa, remote: on coffee table",
            {"sofa": 1, "coffee_table": 1, "remote_control": 1},
            {"sofa against_wall north_wall", "coffee_table in_front_of sofa", "remote_control on coffee_table"},
        ),
        (
            "Six stools, two of which are red; two shelves, one above the other.",
            {"stool": 2, "stool-2": 4, "wall_shelf": 1, "wall_shelf-2": 1},
            {"wall_shelf above wall_shelf-2"},
        ),
        (
            "Six desks, each with a cup with two pencils and a chair.",
            {"desk": 6, "cup": 6, "pencils": 12, "chair": 6},
            {"cup on desk each", "pencils inside cup each", "chair at desk each"},
        ),
        (
            "Four tables, on each of them a basket with three apples, and two chairs at each.",
            {"dining_table": 4, "basket": 4, "apple": 12, "chair": 8},
            {"basket on dining_table each", "apple inside basket each", "chair around dining_table each"},
        ),
    ],
)
def test_nothing_else_is_meant(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "Two shelves, one above the other, with nine bottles on each.",
            {"wall_shelf": 1, "wall_shelf-2": 1, "bottle": 18},
            {"wall_shelf above wall_shelf-2", "bottle on wall_shelf wall_shelf-2 each"},
        ),
        (
            "Two shelves. On each stand nine bottles.",
            {"shelving_unit": 2, "bottle": 18},
            {"bottle on shelving_unit each"},
        ),
        (
            "On the left stood three suits of armour, on the right hung three portraits.",
            {"suit_of_armour": 3, "picture": 3},
            {"suit_of_armour against_wall left_wall", "picture against_wall right_wall"},
        ),
        ("On the left wall hung two posters.", {"poster": 2}, {"poster on left_wall"}),
        (
            "Shelves on the left and the right wall",
            {"wall_shelf": 1, "wall_shelf-2": 1},
            {"wall_shelf on left_wall", "wall_shelf-2 on right_wall"},
        ),
    ],
)
def test_so_many_on_each(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


def test_a_text_that_breaks_off_is_read() -> None:
    brief = read_brief("Start with the piano: it's against the wall. A metronome is on it and, to the left of that, a")
    assert asked(brief) == {"piano": 1, "metronome": 1}


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("Two mirrors that used to be mine and a bed.", {"mirror": 2, "bed": 1}),
        ("A table which used to be a door.", {"dining_table": 1}),
        ("The piano that used to be here is gone. A bed.", {"bed": 1}),
    ],
)
def test_what_a_thing_once_was(prompt: str, things: dict[str, int]) -> None:
    assert told(prompt)[0] == things


def test_what_was_told_of_them_stays_when_they_are_counted() -> None:
    brief = read_brief("The chairs are white. There are four wooden chairs.")
    assert asked(brief) == {"chair": 4}
    assert set(brief.request("chair").attributes) == {"white", "wooden"}
    assert told("All of the cups are on a tray. There are six cups.")[0] == {"cup": 6, "tray": 1}


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "A rug lies between the beds, and a chest stands on that.",
            {"rug": 1, "bed": 2, "chest": 1},
            {"rug between bed", "rug under chest"},
        ),
        (
            "Four desks with a lamp on each. My own desk is in the corner with a plant on it.",
            {"desk": 4, "desk_lamp": 4, "desk-2": 1, "potted_plant": 1},
            {"desk_lamp on desk each", "desk-2 in_corner corner", "potted_plant on desk-2"},
        ),
        ("Both beds have a pillow.", {"bed": 2, "pillow": 2}, {"pillow on bed each"}),
    ],
)
def test_which_of_them_is_meant(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("A bookcase and a cabinet with a lamp between them.", "floor_lamp between bookcase cabinet"),
        ("A desk and a bed stand by the window, with a lamp between them.", "desk_lamp between desk bed"),
        ("Two armchairs by the window, with a side table between them.", "side_table between armchair"),
        ("Two armchairs by the fireplace, with a side table between them.", "side_table between armchair"),
        (
            "Two beds along the left wall with a ladder each, four lockers along the right wall, a table between them.",
            "dining_table between bed locker",
        ),
    ],
)
def test_what_is_between_them_is_in_none(prompt: str, relation: str) -> None:
    assert relation in told(prompt)[1]


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "Over the workbench a pegboard, tires stacked in the back corner, and a bike by the door.",
            {"pegboard above workbench", "tire in_corner far_wall", "bicycle next_to door"},
        ),
        (
            "On the left wall a shelf, and a lamp hanging from the ceiling.",
            {"wall_shelf on left_wall", "pendant_lamp on ceiling"},
        ),
        ("Above the sofa a clock and a picture hanging by the door.", {"clock above sofa", "picture next_to door"}),
    ],
)
def test_front_is_not_said_of_what_has_a_place_of_its_own(prompt: str, relations: set[str]) -> None:
    assert told(prompt)[1] == relations


@pytest.mark.parametrize(
    ("prompt", "counts", "relation"),
    [
        (
            "A bed, two nightstands, each with a lamp and a phone only on the right one; a rug.",
            {"table_lamp": 2, "phone": 1, "rug": 1},
            "phone on nightstand",
        ),
        (
            "Two desks with a lamp each, and a phone on the one by the window.",
            {"desk_lamp": 2, "phone": 1},
            "phone on desk",
        ),
        (
            "Three shelves with two boxes each, and a vase on the last one.",
            {"box": 6, "vase": 1},
            "vase on shelving_unit",
        ),
        (
            "Two of the four desks have a monitor, the others only a lamp; all four have a chair.",
            {"monitor": 2, "desk_lamp": 2, "chair": 4},
            "desk_lamp on desk-2 each",
        ),
    ],
)
def test_what_one_has_is_not_what_each_has(prompt: str, counts: dict[str, int], relation: str) -> None:
    things, relations = told(prompt)
    assert counts.items() <= things.items()
    assert relation in relations


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A bed and two nightstands. A phone on the right nightstand.",
            {"nightstand right_of bed", "nightstand-2 left_of bed", "phone on nightstand"},
        ),
        (
            "A sofa, two side tables, a lamp on the left side table.",
            {"side_table left_of sofa", "side_table-2 right_of sofa", "table_lamp on side_table"},
        ),
        (
            "A bed, two nightstands by the window. A phone on the left one.",
            {"nightstand next_to window", "nightstand-2 next_to window", "phone on nightstand"},
        ),
    ],
)
def test_left_one_is_at_the_left_of_what_such_things_flank(prompt: str, relations: set[str]) -> None:
    assert told(prompt)[1] == relations


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "Eight desks. There is a lamp on half of the desks.",
            {"desk": 4, "desk-2": 4, "desk_lamp": 4},
            {"desk_lamp on desk each"},
        ),
        (
            "Eight cots with a pillow on each and a teddy bear on half of them.",
            {"crib": 4, "crib-2": 4, "pillow": 8, "teddy_bear": 4},
            {"pillow on crib crib-2 each", "teddy_bear on crib each"},
        ),
        (
            "Nine desks. There is a lamp on a third of the desks.",
            {"desk": 3, "desk-2": 6, "desk_lamp": 3},
            {"desk_lamp on desk each"},
        ),
        ("There is a lamp on half of the eight desks.", {"desk_lamp": 4, "desk": 4, "desk-2": 4}, set()),
        (
            "Five desks. Each desk has one chair next to it and a pencil, an eraser and a bottle on it.",
            {"desk": 5, "chair": 5, "pencil": 5, "eraser": 5, "bottle": 5},
            {"eraser on desk each", "bottle on desk each"},
        ),
        ("Each of the four desks has a chair.", {"desk": 4, "chair": 4}, {"chair at desk each"}),
        (
            "There are two shelves. One has books, the other vases.",
            {"bookcase": 1, "shelving_unit": 1, "book": 3, "vase": 3},
            {"book inside bookcase", "vase inside shelving_unit"},
        ),
        (
            "There are two cupboards. One of them holds ten tins, the other one four teapots.",
            {"cabinet": 1, "cabinet-2": 1, "tin_can": 10, "teapot": 4},
            {"tin_can inside cabinet", "teapot inside cabinet-2"},
        ),
        (
            "Stools instead of chairs, exactly four, all next to the big worktable.",
            {"stool": 4, "dining_table": 1},
            {"stool next_to dining_table"},
        ),
        (
            "A barbershop with three chairs along one wall and a mirror in front of each customer.",
            {"barber_chair": 3, "mirror": 3},
            {"barber_chair in_front_of mirror"},
        ),
        (
            "A ward with four beds and a drip stand for each patient.",
            {"hospital_bed": 4, "drip_stand": 4},
            {"drip_stand next_to hospital_bed each"},
        ),
        (
            "A call centre with eight desks; every employee has a headset and a monitor.",
            {"desk": 8, "headphones": 8, "monitor": 8},
            {"monitor on desk each"},
        ),
        (
            "A sofa and a coffee table on a rug.",
            {"sofa": 1, "coffee_table": 1, "rug": 1},
            {"rug under sofa", "rug under coffee_table"},
        ),
        (
            "Two sofas are against the wall with a painting above them.",
            {"sofa": 2, "picture": 1},
            {"picture above sofa"},
        ),
        (
            "Eight desks. On half of them stands a lamp, on the others a vase.",
            {"desk": 4, "desk-2": 4, "desk_lamp": 4, "vase": 4},
            {"desk_lamp on desk each", "vase on desk-2 each"},
        ),
        (
            "A kitchen with a toaster on the counter and a fridge to the left of it.",
            {"toaster": 1, "base_cabinet": 1, "fridge": 1},
            {"toaster on base_cabinet", "fridge left_of base_cabinet"},
        ),
    ],
)
def test_shares_and_what_each_has(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    counts, found = told(prompt)
    assert (counts, relations - found) == (things, set())


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "The bookcase and the wardrobe stand against the north and the east wall, respectively.",
            {"bookcase": 1, "wardrobe": 1},
            {"bookcase against_wall north_wall", "wardrobe against_wall east_wall"},
        ),
        (
            "A desk and a bed against the north and south walls respectively.",
            {"desk": 1, "bed": 1},
            {"desk against_wall north_wall", "bed against_wall south_wall"},
        ),
        (
            "There are two side tables. A lamp and a vase stand on the left and the right table respectively.",
            {"side_table": 1, "side_table-2": 1, "table_lamp": 1, "vase": 1},
            {"table_lamp on side_table", "vase on side_table-2"},
        ),
        (
            "A sofa and a bed are on the left and on the right, respectively.",
            {"sofa": 1, "bed": 1},
            {"sofa against_wall left_wall", "bed against_wall right_wall"},
        ),
        (
            "A lamp, a cup and a book on the desk, the shelf and the bed respectively.",
            {"desk_lamp": 1, "desk": 1, "cup": 1, "shelving_unit": 1, "book": 1, "bed": 1},
            {"desk_lamp on desk", "cup on shelving_unit", "book on bed"},
        ),
        (
            "A bedroom has a bed and two nightstands, each of which holds a lamp.",
            {"bed": 1, "nightstand": 2, "table_lamp": 2},
            {"table_lamp on nightstand each"},
        ),
        (
            "A bed and two armchairs, each of which faces the window.",
            {"bed": 1, "armchair": 2},
            {"armchair facing window"},
        ),
    ],
)
def test_one_by_one(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize("words", ["each white", "each of which is white", "both white"])
def test_what_each_of_two_is_like_is_said_of_no_more(words: str) -> None:
    looks = {r.category: r.attributes for r in read_brief(f"A bed and two chairs, {words}.").requests if r.asked}
    assert looks == {"bed": (), "chair": ("white",)}


def test_the_chair_and_the_desk_are_red_and_blue_respectively() -> None:
    looks = {
        r.category: r.attributes for r in read_brief("The chair and the desk are red and blue respectively.").requests
    }
    assert looks["chair"] == ("red",)
    assert looks["desk"] == ("blue",)


def test_what_is_respectively_told_of_nothing_is_told() -> None:
    assert read_brief("Two chairs and a bed respectively.").unknown == ("respectively",)


@pytest.mark.parametrize(
    ("share", "counts"),
    [
        ("Half of the ten chairs", {5}),
        ("50% of the ten chairs", {5}),
        ("A third of the nine chairs", {3, 6}),
        ("30 percent of the ten chairs", {3, 7}),
    ],
)
def test_a_share_of_a_number_is_a_number(share: str, counts: set[int]) -> None:
    brief = read_brief(f"{share} are blue.")
    assert {r.count for r in brief.requests if r.asked} == counts
    assert sum(r.count for r in brief.requests if "blue" in r.attributes) == min(counts)


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "There is a bed, to the left of which is a nightstand and to the right of which is a wardrobe.",
            {"bed": 1, "nightstand": 1, "wardrobe": 1},
            {"nightstand left_of bed", "wardrobe right_of bed"},
        ),
        (
            "The bed is flanked on both sides by nightstands.",
            {"bed": 1, "nightstand": 1, "nightstand-2": 1},
            {"nightstand left_of bed", "nightstand-2 right_of bed"},
        ),
        ("The desk is oriented so that it faces the door.", {"desk": 1}, {"desk facing door"}),
        ("A book is resting on the arm of the sofa.", {"book": 1, "sofa": 1}, {"book on sofa"}),
        ("A wardrobe hugs the east wall.", {"wardrobe": 1}, {"wardrobe against_wall east_wall"}),
        ("A red rug adorns the floor.", {"rug": 1}, {"rug on floor"}),
        (
            "Upon entering, you see a coat rack on the left.",
            {"coat_rack": 1},
            {"coat_rack against_wall left_wall"},
        ),
    ],
)
def test_turns_of_plain_speech(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A sofa is along the north wall, with a TV stand along the south wall.",
            {"sofa against_wall north_wall", "tv_stand against_wall south_wall"},
        ),
        (
            "A bed in the left corner with a dresser in the right corner.",
            {"bed in_corner left_wall", "dresser in_corner right_wall"},
        ),
        (
            "A desk by the window with a bookcase next to the door.",
            {"desk next_to window", "bookcase next_to door"},
        ),
        ("A sofa and an armchair are separated by a side table.", {"side_table between sofa armchair"}),
        ("A sofa and an armchair, separated by a side table.", {"side_table between sofa armchair"}),
        ("Two armchairs separated by a side table.", {"side_table between armchair"}),
        ("A nightstand is sandwiched between the bed and the wardrobe.", {"nightstand between bed wardrobe"}),
        ("A rug stretches from the sofa to the TV stand.", {"rug between sofa tv_stand"}),
        ("Each side of the bed has a nightstand.", {"nightstand left_of bed", "nightstand-2 right_of bed"}),
        ("Both sides of the bed have nightstands.", {"nightstand left_of bed", "nightstand-2 right_of bed"}),
        ("The bed's headboard is against the north wall.", {"bed against_wall north_wall"}),
        ("The back of the sofa is against the wall.", {"sofa against_wall wall"}),
        ("A desk faces north.", {"desk facing north_wall"}),
        ("A sofa facing east.", {"sofa facing east_wall"}),
        ("Curtains hang from the window.", {"curtain next_to window"}),
        (
            "There is a sofa with a cushion at each end.",
            {"pillow on sofa", "pillow-2 on sofa", "pillow left_of sofa", "pillow-2 right_of sofa"},
        ),
        ("The table accommodates six chairs.", {"chair around dining_table"}),
    ],
)
def test_each_has_its_own_place(prompt: str, relations: set[str]) -> None:
    assert told(prompt)[1] == relations


@pytest.mark.parametrize("words", ["accommodates six people", "can accommodate six", "can accommodate six people"])
def test_whom_a_table_accommodates_it_seats(words: str) -> None:
    [table] = [r for r in read_brief(f"The table {words}.").requests if r.asked]
    assert table.attributes == ("for-6",)


def test_hours_of_a_clock_are_no_clocks() -> None:
    brief = read_brief("A sofa stands at the wall, and the desk at 12 o'clock.")
    assert asked(brief) == {"sofa": 1, "desk": 1}
    assert "at 12 o clock" in brief.unknown
    assert asked(read_brief("The bed's headboard faces the door.")) == {"bed": 1}


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "The first desk is by the window and the second desk is against the wall.",
            {"desk": 1, "desk-2": 1},
            {"desk next_to window", "desk-2 against_wall wall"},
        ),
        (
            "The lamp is on the left nightstand and the book is on the right nightstand.",
            {"table_lamp": 1, "nightstand": 1, "nightstand-2": 1, "book": 1},
            {"table_lamp on nightstand", "book on nightstand-2"},
        ),
        (
            "The lamp is on the left nightstand, the book on the right one.",
            {"table_lamp": 1, "nightstand": 1, "nightstand-2": 1, "book": 1},
            {"table_lamp on nightstand", "book on nightstand-2"},
        ),
        (
            "The red chair is by the window and the blue chair is by the door.",
            {"chair": 1, "chair-2": 1},
            {"chair next_to window", "chair-2 next_to door"},
        ),
        (
            "A red chair and a blue chair. The red chair is by the window and the blue chair is by the door.",
            {"chair": 1, "chair-2": 1},
            {"chair next_to window", "chair-2 next_to door"},
        ),
        (
            "The left wall has a shelf and the right wall has a mirror.",
            {"wall_shelf": 1, "mirror": 1},
            {"wall_shelf on left_wall", "mirror on right_wall"},
        ),
        (
            "The table on which the lamp stands is next to the sofa.",
            {"side_table": 1, "table_lamp": 1, "sofa": 1},
            {"table_lamp on side_table", "side_table next_to sofa"},
        ),
        (
            "The room has a bed to the left of which stands a nightstand.",
            {"bed": 1, "nightstand": 1},
            {"nightstand left_of bed"},
        ),
    ],
)
def test_what_is_told_apart_is_several(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


def test_the_larger_and_the_smaller_are_two() -> None:
    brief = read_brief("The larger table is round and the smaller table is square.")
    looks = {r.attributes for r in brief.requests if r.category == "dining_table"}
    assert looks == {("large", "round"), ("small", "square")}


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("Objects: bed (1), nightstand (2), lamp (2).", {"bed": 1, "nightstand": 2, "table_lamp": 2}),
        ("Chairs (4), tables (2).", {"chair": 4, "dining_table": 2}),
        ("Lamps frame the bed on both sides.", {"floor_lamp": 1, "floor_lamp-2": 1, "bed": 1}),
        ("Inside are two beds and a wardrobe.", {"bed": 2, "wardrobe": 1}),
    ],
)
def test_numbers_told_after_and_on_both_sides(prompt: str, things: dict[str, int]) -> None:
    assert told(prompt)[0] == things


def test_shelves_of_nothing_are_shelves() -> None:
    said = "The upper shelf holds books and the lower shelf holds boxes."
    brief = read_brief(said, fill="named")
    assert {r.category for r in brief.requests} == {"bookcase", "book", "shelving_unit", "box"}
    assert {w for r in brief.requests for w in r.unshown} == {"upper", "lower"}
    brief = read_brief(f"A bookcase. {said}", fill="named")
    assert related(brief) == {"book inside bookcase", "box inside bookcase"}
    assert brief.unknown == ("The upper shelf", "the lower shelf")


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "One lamp is on the desk and one is on the floor.",
            {"desk_lamp": 1, "desk": 1, "floor_lamp": 1},
            {"desk_lamp on desk", "floor_lamp on floor"},
        ),
        (
            "A lamp stands on the desk. A second one hangs from the ceiling.",
            {"desk_lamp": 1, "desk": 1, "pendant_lamp": 1},
            {"desk_lamp on desk", "pendant_lamp on ceiling"},
        ),
        (
            "There are three lamps. One is on the desk, one is on the floor and a third hangs from the ceiling.",
            {"desk_lamp": 1, "desk": 1, "floor_lamp": 1, "pendant_lamp": 1},
            {"desk_lamp on desk", "floor_lamp on floor", "pendant_lamp on ceiling"},
        ),
        (
            "There is one table per four chairs; there are eight chairs.",
            {"dining_table": 2, "chair": 8},
            set(),
        ),
        ("All but one of the six chairs face the door.", {"chair": 5, "chair-2": 1}, {"chair facing door"}),
    ],
)
def test_one_more_and_all_but_one(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "Surrounded by six chairs, the dining table is in the centre.",
            {"dining_table": 1, "chair": 6},
            {"chair around dining_table", "dining_table in_centre centre"},
        ),
        (
            "Flanked by two nightstands, the bed is against the wall.",
            {"bed": 1, "nightstand": 1, "nightstand-2": 1},
            {"nightstand left_of bed", "nightstand-2 right_of bed", "bed against_wall wall"},
        ),
        (
            "Filled with toys, a chest is at the foot of the bed.",
            {"chest": 1, "toy": 3, "bed": 1},
            {"toy inside chest", "chest at_foot_of bed"},
        ),
        (
            "Standing next to the sofa, a floor lamp lights the corner.",
            {"sofa": 1, "floor_lamp": 1},
            {"floor_lamp next_to sofa"},
        ),
    ],
)
def test_what_is_told_before_a_thing_is_of_it(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


def test_both_of_which_are_the_two_that_were_joined() -> None:
    brief = read_brief("A shelf hangs between the stove and the fridge, both of which are white.", fill="named")
    assert {r.category for r in brief.requests if "white" in r.attributes} == {"stove", "fridge"}


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        (
            "Eight desks (on each: two monitors, a keyboard and a lamp; at each: an office chair), a plotter.",
            {"desk": 8, "monitor": 16, "keyboard": 8, "desk_lamp": 8, "office_chair": 8, "plotter": 1},
        ),
        (
            "Eight desks (two monitors, a keyboard and a lamp on each, an office chair at each), a plotter.",
            {"desk": 8, "monitor": 16, "keyboard": 8, "desk_lamp": 8, "office_chair": 8, "plotter": 1},
        ),
        (
            "Eight desks, two monitors, a keyboard and a lamp on each.",
            {"desk": 8, "monitor": 16, "keyboard": 8, "desk_lamp": 8},
        ),
        (
            "Six beds (a pillow, a blanket and a teddy bear on each), a clock on the wall.",
            {"bed": 6, "pillow": 6, "blanket": 6, "teddy_bear": 6, "clock": 1},
        ),
        (
            "Six tables (per table: four chairs, a vase and a menu), a bar and a piano.",
            {"dining_table": 6, "chair": 24, "vase": 6, "menu": 6, "bar_counter": 1, "piano": 1},
        ),
    ],
)
def test_lists_in_brackets_are_of_each(prompt: str, things: dict[str, int]) -> None:
    assert told(prompt)[0] == things


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("There are six chairs. Two chairs are by the window.", {"chair": 2, "chair-2": 4}),
        (
            "There are four paintings. Two paintings hang above the sofa and two paintings hang by the door.",
            {"picture": 2, "picture-2": 2, "sofa": 1},
        ),
        (
            "There are four chairs. Two chairs are next to the window, one chair is by the door.",
            {"chair": 2, "chair-2": 1, "chair-3": 1},
        ),
        ("Six chairs are by the door. Two chairs are by the window.", {"chair": 6, "chair-2": 2}),
        ("Three tables with four chairs each, twelve chairs in all.", {"dining_table": 3, "chair": 12}),
        ("Three tables with four chairs each, for a total of twelve chairs.", {"dining_table": 3, "chair": 12}),
        (
            "Two benches with two backpacks on each, so that makes four backpacks altogether.",
            {"bench": 2, "backpack": 4},
        ),
        ("A table with six cups in total.", {"dining_table": 1, "cup": 6}),
    ],
)
def test_some_of_several_and_sums_are_no_more_of_them(prompt: str, things: dict[str, int]) -> None:
    assert told(prompt)[0] == things


def test_a_sum_that_is_wrong_is_told() -> None:
    assert read_brief("Two benches with two backpacks on each, five backpacks altogether.").unknown == (
        "five backpacks",
    )


@pytest.mark.parametrize(
    ("prompt", "count", "relation"),
    [
        (
            "A dorm with two beds; each bed has a nightstand and a lamp on the nightstand.",
            {"table_lamp": 2},
            "table_lamp on nightstand each",
        ),
        ("Three desks, each with a chair and a cushion on the chair.", {"pillow": 3}, "pillow on chair each"),
        (
            "Three desks. Each desk has a monitor and a keyboard in front of the monitor.",
            {"keyboard": 3},
            "keyboard in_front_of monitor each",
        ),
        ("Two shelves, each with a vase and a book next to the vase.", {"book": 2}, "book next_to vase each"),
    ],
)
def test_what_each_has_by_what_it_has_is_by_each_of_these(prompt: str, count: dict[str, int], relation: str) -> None:
    things, relations = told(prompt)
    assert count.items() <= things.items()
    assert relation in relations


@pytest.mark.parametrize(
    ("prompt", "counts", "relation"),
    [
        (
            "A conference table with ten chairs, a notepad and a pen in front of each chair.",
            {"chair": 10, "notebook": 10, "pen": 10},
            "notebook on conference_table",
        ),
        (
            "A table with six chairs, with a plate, a fork and a glass in front of each chair.",
            {"plate": 6, "fork": 6, "glass": 6},
            "fork on dining_table",
        ),
        (
            "A row of six lockers with a bench in front of every two lockers.",
            {"locker": 6, "bench": 3},
            "bench in_front_of locker",
        ),
        ("Every second desk has a plant; there are eight desks.", {"potted_plant": 4}, "potted_plant on desk each"),
        ("Every third chair has a book on it. There are nine chairs.", {"book": 3}, "book on chair each"),
        ("On both nightstands is a lamp.", {"nightstand": 2, "table_lamp": 2}, "table_lamp on nightstand each"),
        ("There is a lamp on both nightstands.", {"nightstand": 2}, "table_lamp on nightstand each"),
    ],
)
def test_what_each_or_every_other_one_has_is_counted(prompt: str, counts: dict[str, int], relation: str) -> None:
    things, relations = told(prompt)
    assert counts.items() <= things.items()
    assert relation in relations


def test_people_who_share_desks_are_no_desks() -> None:
    brief = read_brief("Six students sit at three desks, two at each desk.")
    assert asked(brief) == {"desk": 3}
    assert brief.unknown == ("two at each desk",)


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("The chair is 1 m away from the table.", "near"),
        ("The sofa is three meters away from the TV.", "far"),
    ],
)
def test_what_is_a_step_away_is_not_far(prompt: str, kind: str) -> None:
    brief = read_brief(prompt)
    assert [r.kind for r in brief.relations if r.asked] == [kind]
    assert len(brief.unknown) == 1


@pytest.mark.parametrize(
    ("prompt", "counts", "relation"),
    [
        ("A classroom with 20 desks and chairs.", {"school_desk": 20, "chair": 20}, "chair at school_desk each"),
        (
            "A classroom with 20 desks and chairs and a teacher's desk.",
            {"school_desk": 20, "chair": 20, "desk": 1},
            "chair at school_desk each",
        ),
        ("A room with six tables and chairs.", {"dining_table": 6, "chair": 24}, "chair around dining_table each"),
    ],
)
def test_so_many_desks_and_chairs_are_desks_with_chairs(prompt: str, counts: dict[str, int], relation: str) -> None:
    things, relations = told(prompt)
    assert things == counts
    assert relations == {relation}


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("A plant in two corners and a lamp in the other two.", {"plant": 2, "floor_lamp": 2}),
        ("A sofa on one wall and shelves on the other three walls.", {"sofa": 1, "wall_shelf": 3}),
        ("Each student has a desk with a laptop. There are eight students.", {"desk": 8, "laptop": 8}),
        ("Each child has a bed and a desk. There are three children.", {"bed": 3, "desk": 3}),
    ],
)
def test_what_other_words_count_is_counted(prompt: str, counts: dict[str, int]) -> None:
    assert told(prompt)[0] == counts
