"""Where things are that are told together, of which words are left out, or that are told after their names."""

import pytest

from tests.briefs import asked, related, told
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "A table, a desk and two vases. The vases stand on the table and the desk.",
            {"dining_table": 1, "desk": 1, "vase": 1, "vase-2": 1},
            {"vase on dining_table", "vase-2 on desk"},
        ),
        (
            "There are lamps on the table and the desk.",
            {"table_lamp": 1, "desk_lamp": 1, "dining_table": 1, "desk": 1},
            {"desk_lamp on desk", "table_lamp on dining_table"},
        ),
        (
            "There are books on the table and on the desk.",
            {"book": 1, "book-2": 1, "dining_table": 1, "desk": 1},
            {"book on dining_table", "book-2 on desk"},
        ),
        (
            "Put a lamp on the desk and the nightstand.",
            {"desk_lamp": 1, "table_lamp": 1, "desk": 1, "nightstand": 1},
            {"desk_lamp on desk", "table_lamp on nightstand"},
        ),
        (
            "On the desk, the shelf and the sideboard stand three vases.",
            {"vase": 1, "vase-2": 1, "vase-3": 1, "desk": 1, "shelving_unit": 1, "sideboard": 1},
            {"vase on desk", "vase-2 on shelving_unit", "vase-3 on sideboard"},
        ),
        (
            "A sofa, a desk. A plant stands next to the sofa and the desk.",
            {"sofa": 1, "desk": 1, "plant": 1},
            {"plant next_to desk", "plant next_to sofa"},
        ),
        (
            (
                "Three workbenches and two violins. The violins lie one apiece on the first and second "
                "bench, while the third bench carries a cello."
            ),
            {"workbench": 1, "workbench-2": 1, "workbench-3": 1, "violin": 1, "violin-2": 1, "cello": 1},
            {"cello on workbench-3", "violin on workbench", "violin-2 on workbench-2"},
        ),
        (
            ("Three benches and two violins. One violin lies on the left bench and one on the right bench."),
            {"bench": 1, "bench-2": 1, "bench-3": 1, "violin": 1, "violin-2": 1},
            {"violin on bench", "violin-2 on bench-2"},
        ),
    ],
)
def test_at_each_of_those_that_are_listed(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "A desk with a monitor on it. On the desk to the left of the monitor is a lamp.",
            {"desk": 1, "monitor": 1, "desk_lamp": 1},
            {"desk_lamp left_of monitor", "desk_lamp on desk", "monitor on desk"},
        ),
        (
            "A desk with a monitor on it. On the desk to its left is a lamp.",
            {"desk": 1, "monitor": 1, "desk_lamp": 1},
            {"desk_lamp left_of monitor", "desk_lamp on desk", "monitor on desk"},
        ),
        (
            (
                "A desk. On the desk there is a monitor, and on the desk to its left and to its right are "
                "two speakers, one on each side."
            ),
            {"desk": 1, "monitor": 1, "speaker": 1, "speaker-2": 1},
            {
                "monitor on desk",
                "speaker left_of monitor",
                "speaker on desk",
                "speaker-2 on desk",
                "speaker-2 right_of monitor",
            },
        ),
        (
            "A sofa. To its left and right are a lamp and a plant.",
            {"sofa": 1, "floor_lamp": 1, "plant": 1},
            {"floor_lamp left_of sofa", "plant right_of sofa"},
        ),
        (
            "A bed by the wall. To its left and right are two nightstands.",
            {"bed": 1, "nightstand": 1, "nightstand-2": 1},
            {"bed against_wall wall", "nightstand left_of bed", "nightstand-2 right_of bed"},
        ),
        (
            ("There is a fireplace. Two armchairs flank the fireplace, one on its left and one on its right."),
            {"fireplace": 1, "armchair": 1, "armchair-2": 1},
            {"armchair left_of fireplace", "armchair-2 right_of fireplace"},
        ),
        (
            "On the bench stand an enlarger and, to the right of it, three trays.",
            {"bench": 1, "enlarger": 1, "tray": 3},
            {"enlarger on bench", "tray on bench", "tray right_of enlarger"},
        ),
        (
            "A bench. On the bench, an enlarger and to the right of that three trays.",
            {"bench": 1, "enlarger": 1, "tray": 3},
            {"enlarger on bench", "tray on bench", "tray right_of enlarger"},
        ),
        (
            "A desk with a lamp on the left, a printer on the right and a laptop between them.",
            {"desk": 1, "desk_lamp": 1, "printer": 1, "laptop": 1},
            {
                "desk_lamp left_of desk",
                "desk_lamp on desk",
                "laptop between desk_lamp printer",
                "laptop on desk",
                "printer on desk",
                "printer right_of desk",
            },
        ),
        (
            "A round table has on it two microphones and, between them, a pair of headphones.",
            {"dining_table": 1, "microphone": 2, "headphones": 1},
            {"headphones between microphone", "headphones on dining_table", "microphone on dining_table"},
        ),
    ],
)
def test_two_places_told_first(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "The desk, the white one, has a lamp on it.",
            {"desk": 1, "desk_lamp": 1},
            {"desk_lamp on desk"},
        ),
        (
            "A shelf with books, six of them.",
            {"bookcase": 1, "book": 6},
            {"book inside bookcase"},
        ),
        (
            "A stove and a table. The stove itself is a cast-iron one.",
            {"stove": 1, "dining_table": 1},
            set(),
        ),
        (
            "There's a sofa against the wall, and in front of it the coffee table.",
            {"sofa": 1, "coffee_table": 1},
            {"coffee_table in_front_of sofa", "sofa against_wall wall"},
        ),
        (
            "There are two sofas, a red one facing a green one.",
            {"sofa": 1, "sofa-2": 1},
            {"sofa facing sofa-2"},
        ),
        (
            (
                "A desk. Lying on it: a stapler and three pens. Also on it is a red mug with a spoon in "
                "it, to the left of the stapler."
            ),
            {"desk": 1, "stapler": 1, "pens": 3, "cup": 1, "spoon": 1},
            {"cup left_of stapler", "cup on desk", "pens on desk", "spoon inside cup", "stapler on desk"},
        ),
    ],
)
def test_told_after_the_name(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "The coat rack is near the shelf on which three hats lie.",
            {"coat_rack": 1, "shelving_unit": 1, "hat": 3},
            {"coat_rack near shelving_unit", "hat on shelving_unit"},
        ),
        (
            "A shelf on which eight mugs are drying stands next to the kiln.",
            {"shelving_unit": 1, "cup": 8, "kiln": 1},
            {"cup on shelving_unit", "shelving_unit next_to kiln"},
        ),
        (
            "Next to the table on which the computer stands is a bin.",
            {"computer": 1, "dining_table": 1, "waste_bin": 1},
            {"computer on dining_table", "waste_bin next_to dining_table"},
        ),
        (
            "A low shelf holding four dumbbells and two foam rollers runs along the wall.",
            {"shelving_unit": 1, "dumbbell": 4, "foam_roller": 2},
            {"dumbbell inside shelving_unit", "foam_roller inside shelving_unit", "shelving_unit against_wall wall"},
        ),
        (
            (
                "A bed flanked by two nightstands. On each nightstand there is a lamp, and the left "
                "nightstand also has a book on it."
            ),
            {"bed": 1, "nightstand": 1, "nightstand-2": 1, "table_lamp": 2, "book": 1},
            {
                "book on nightstand",
                "nightstand left_of bed",
                "nightstand-2 right_of bed",
                "table_lamp on nightstand nightstand-2 each",
            },
        ),
        (
            (
                "A round mirror flanked by two sconces. Under the console: two baskets. The left one has "
                "three umbrellas in it; the right one is empty."
            ),
            {
                "mirror": 1,
                "wall_lamp": 1,
                "wall_lamp-2": 1,
                "console_table": 1,
                "basket": 1,
                "basket-2": 1,
                "umbrella": 3,
            },
            {
                "basket under console_table",
                "basket-2 under console_table",
                "umbrella inside basket",
                "wall_lamp left_of mirror",
                "wall_lamp-2 right_of mirror",
            },
        ),
        (
            "A table. On it, a plate with a sandwich, a glass of water.",
            {"dining_table": 1, "plate": 1, "sandwich": 1, "glass": 1},
            {"glass on dining_table", "plate on dining_table", "sandwich on plate"},
        ),
    ],
)
def test_which_of_them(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            (
                "Two beds with a nightstand between them. On the nightstand is an alarm clock. Each bed "
                "has one pillow and one stuffed animal on it."
            ),
            {"bed": 2, "nightstand": 1, "alarm_clock": 1, "pillow": 2, "stuffed_animal": 2},
            {"alarm_clock on nightstand", "nightstand between bed", "pillow on bed each", "stuffed_animal on bed each"},
        ),
        (
            ("A restaurant with three tables. Every table has a candle on it and two chairs that face each other."),
            {"dining_table": 3, "candle": 3, "chair": 6},
            {"candle on dining_table each", "chair around dining_table each", "chair facing chair"},
        ),
        (
            (
                "Seven stools stand in front of the counter, and on the counter there are seven bowls, "
                "each bowl with a pair of chopsticks and a spoon next to it."
            ),
            {"bar_stool": 7, "counter": 1, "bowl": 7, "chopsticks": 7, "spoon": 7},
            {
                "bar_stool in_front_of counter",
                "bowl on counter",
                "chopsticks next_to bowl each",
                "chopsticks on counter",
                "spoon next_to bowl each",
                "spoon on counter",
            },
        ),
        (
            "Five cages, each with a food bowl and a blanket inside.",
            {"cage": 5, "food_bowl": 5, "blanket": 5},
            {"blanket inside cage each", "food_bowl inside cage each"},
        ),
        (
            "Five cages, each with a blanket inside. All but one of them have a toy mouse in it.",
            {"cage": 1, "cage-2": 4, "blanket": 5, "toy_mouse": 4},
            {"blanket inside cage cage-2 each", "toy_mouse inside cage-2 each"},
        ),
        (
            "Five desks. On each desk is a lamp, on two of them also a monitor.",
            {"desk": 2, "desk-2": 3, "desk_lamp": 5, "monitor": 2},
            {"desk_lamp on desk desk-2 each", "monitor on desk each"},
        ),
        (
            "Six desks. Four of them have a lamp, each of the remaining two a vase.",
            {"desk": 4, "desk-2": 2, "desk_lamp": 4, "vase": 2},
            {"desk_lamp on desk each", "vase on desk-2 each"},
        ),
        (
            ("Seven bicycles, four of which hang on the wall; next to each of the remaining three is a repair stand."),
            {"wall_bicycle": 4, "bicycle": 3, "repair_stand": 3},
            {"repair_stand next_to bicycle each", "wall_bicycle on wall"},
        ),
        (
            "A table and a desk. The table and the desk have a lamp each.",
            {"dining_table": 1, "desk": 1, "desk_lamp": 2},
            {"desk_lamp on dining_table desk each"},
        ),
        (
            "Three desks. Each desk has a computer, and each computer has a mouse next to it.",
            {"desk": 3, "computer": 3, "mouse": 3},
            {"computer on desk each", "mouse next_to computer each", "mouse on desk each"},
        ),
        (
            "Two bunk beds, each with a pillow on it, a ladder next to them.",
            {"bunk_bed": 2, "pillow": 2, "ladder": 1},
            {"ladder next_to bunk_bed", "pillow on bunk_bed each"},
        ),
        (
            "A kitchen with a kitchen island. There is a bowl of apples on the island.",
            {"kitchen_island": 1, "bowl": 1, "apple": 3},
            {"apple inside bowl", "bowl on kitchen_island"},
        ),
        (
            "Three tables. For every table there is a shelf against the wall.",
            {"dining_table": 3, "shelving_unit": 3},
            {"shelving_unit against_wall wall"},
        ),
        (
            "Five benches, each with two cushions, one red and one blue.",
            {"bench": 5, "pillow": 5, "pillow-2": 5},
            {"pillow on bench each", "pillow-2 on bench each"},
        ),
        (
            "The stove is flanked by two cabinets, and each has a plant on top.",
            {"stove": 1, "cabinet": 1, "cabinet-2": 1, "potted_plant": 2},
            {"cabinet left_of stove", "cabinet-2 right_of stove", "potted_plant on cabinet cabinet-2 each"},
        ),
    ],
)
def test_of_each_of_them(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "A red rug lies under the table, a blue one in front of the sofa.",
            {"rug": 1, "dining_table": 1, "rug-2": 1, "sofa": 1},
            {"rug under dining_table", "rug-2 in_front_of sofa"},
        ),
        (
            "A table with a red vase and a blue one on it.",
            {"dining_table": 1, "vase": 1, "vase-2": 1},
            {"vase on dining_table", "vase-2 on dining_table"},
        ),
        (
            "The fridge is to the left of the stove, the dishwasher to its right.",
            {"fridge": 1, "stove": 1, "dishwasher": 1},
            {"dishwasher right_of stove", "fridge left_of stove"},
        ),
        (
            "The first shelf holds six books, the second three boxes and the third a plant.",
            {"bookcase": 1, "book": 6, "shelving_unit": 1, "box": 3, "shelving_unit-2": 1, "plant": 1},
            {"book inside bookcase", "box inside shelving_unit", "plant inside shelving_unit-2"},
        ),
        (
            "A clock above the door and a fire extinguisher next to it.",
            {"clock": 1, "fire_extinguisher": 1},
            {"clock above door", "fire_extinguisher next_to door"},
        ),
        (
            "The door is in the north wall; a coat rack stands to the right of it.",
            {"coat_rack": 1},
            {"coat_rack right_of door"},
        ),
        (
            "A large window lets in light; below it is a bench.",
            {"bench": 1},
            {"bench under window"},
        ),
    ],
)
def test_another_of_them(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    "said",
    [
        "Leave out a pool table, a television, a dartboard.",
        "Not needed: a pool table, a television, a dartboard.",
        "Don't include: a pool table, a television and a dartboard.",
        "What we can do without: a pool table, a television, a dartboard.",
        "No pool table, television or dartboard.",
        "We don't want a pool table, a television, or a dartboard, just the sofas.",
    ],
)
def test_a_list_that_is_not_wanted_is_left_out_to_its_end(said: str) -> None:
    brief = read_brief(f"A common room with two sofas. {said}")
    assert brief.excluded == ("dart_board", "pool_table", "tv")
    assert asked(brief) == {"sofa": 2}


def test_what_a_shop_does_not_sell_is_not_there() -> None:
    brief = read_brief("A bike shop with a counter. We don't do scooters and don't sell helmets, so leave those out.")
    assert (asked(brief), brief.excluded, brief.unknown) == ({"counter": 1}, ("helmet", "scooter"), ())


@pytest.mark.parametrize(
    "said",
    [
        "Earthy, hushed, a little imperfect.",
        "It used to be a broom cupboard.",
        "A stove that is always too hot stands in the corner.",
        "Completing the space, a clock hangs on the wall.",
    ],
)
def test_what_tells_a_mood_or_a_past_asks_for_nothing(said: str) -> None:
    assert not read_brief(f"A living room around 1930 with a sofa. {said}").unknown


def test_what_leans_against_furniture_stands_beside_it() -> None:
    assert told("A ladder leans on a bookcase. A tall mirror leans against the wall.") == (
        {"ladder": 1, "bookcase": 1, "standing_mirror": 1},
        {"ladder next_to bookcase", "standing_mirror against_wall wall"},
    )


def test_a_sink_by_the_window_is_in_the_counter_that_is_asked_for() -> None:
    """No second cabinet is made for it where nothing says that the counter stands elsewhere."""
    brief = read_brief("A kitchen with an island. A sink is near the window. A toaster is on the counter.")
    assert sum(r.count for r in brief.requests if r.category in ("base_cabinet", "counter")) == 1


def test_a_pair_of_glasses_beside_a_water_glass_is_to_see_with() -> None:
    brief = read_brief("A bedroom. A pill bottle, a water glass and a pair of glasses are on the nightstand.")
    assert {r.category: r.count for r in brief.requests if r.category in ("glass", "eyeglasses")} == {
        "glass": 1,
        "eyeglasses": 1,
    }


def test_what_stands_beside_a_stand_is_not_put_on_it() -> None:
    brief = read_brief("A studio. A keyboard synthesizer on its stand is to the left of the mixing desk.")
    assert not [r for r in brief.relations if r.kind == "on" and r.subject == "mixing_desk"]


@pytest.mark.parametrize(
    "prompt",
    [
        "A dining room with a table and four chairs, the two chairs by the window are blue.",
        "A dining room with a table and four chairs, two of the chairs by the window are blue.",
    ],
)
def test_a_colour_of_some_is_not_that_of_all(prompt: str) -> None:
    brief = read_brief(prompt)
    found = [(r.category, r.count, r.attributes) for r in brief.requests if r.asked]
    assert [(c, n, "blue" in a) for c, n, a in found] == [
        ("dining_table", 1, False),
        ("chair", 2, True),
        ("chair", 2, False),
    ]


def test_each_table_has_all_that_is_listed_with_what_each_has() -> None:
    brief = read_brief("A café with six tables with a vase and two cups on them.")
    assert {r.category: r.count for r in brief.requests if r.category in ("vase", "cup")} == {"vase": 6, "cup": 12}


def test_what_is_folded_against_a_wall_is_asked_to_be_folded() -> None:
    brief = read_brief("A laundry room with an ironing board folded against the wall.")
    assert brief.request("ironing_board").states == ("folded",)


def test_a_wall_without_windows_takes_no_window_from_the_room() -> None:
    brief = read_brief("A living room with a sofa facing the window and a piano along the wall without windows.")
    assert not [o for o in brief.openings if o.kind == "window" and not o.count]
    assert "windowless wall" in " ".join(brief.unknown)


def test_each_chair_has_its_own_mirror() -> None:
    brief = read_brief("A barber shop with two barber chairs, each in front of its own mirror.")
    assert {r.category: r.count for r in brief.requests if r.asked} == {"barber_chair": 2, "mirror": 2}


def test_chairs_of_different_colours_are_not_passed_over() -> None:
    brief = read_brief("A library with four round tables, each with four chairs of a different colour.")
    assert brief.unknown


def test_one_of_which_is_one_of_what_lies_there() -> None:
    brief = read_brief("A hobby room with two workbenches. The second one has three lamps on it, one of which is red.")
    assert [r.count for r in brief.requests if "red" in r.attributes] == [1]
    assert not [r for r in brief.requests if r.category == "workbench" and "red" in r.attributes]


@pytest.mark.parametrize(
    ("told", "kind", "number"),
    [("two of them armchairs", "armchair", 2), ("one of them a high chair", "high_chair", 1)],
)
def test_some_of_them_are_what_they_are_called(told: str, kind: str, number: int) -> None:
    brief = read_brief(f"A dining table with five chairs, {told}.")
    seats = {r.category: r.count for r in brief.requests if r.category in ("chair", kind)}
    assert seats == {"chair": 5 - number, kind: number}


def test_each_corner_at_the_front_is_two_corners() -> None:
    brief = read_brief("A room with a speaker in each corner at the front.")
    assert brief.request("speaker").count == 2


def test_the_rest_with_a_coat_on_each_are_not_all() -> None:
    brief = read_brief("A bar with eight stools, two of them empty and the rest with a coat on each.")
    assert brief.request("coat").count == 6


def test_a_second_easel_with_its_own_stool_has_another_stool() -> None:
    brief = read_brief(
        "A studio with an easel near the window and a stool in front of it; a second easel, with its own stool, near "
        "the door."
    )
    assert sum(r.count for r in brief.requests if r.category == "stool") == 2


def test_things_in_an_order_along_a_wall_may_follow_another_with_and() -> None:
    brief = read_brief(
        "A garage with a car in the middle and, along the back wall, from left to right, a bench and a fridge."
    )
    assert related(brief) == {
        "car in_centre centre",
        "bench against_wall far_wall",
        "fridge against_wall far_wall",
        "fridge right_of bench",
    }


def test_rows_of_so_many_by_so_many_measure_nothing() -> None:
    brief = read_brief("A yoga studio with rows of mats, four by three, and a speaker.")
    assert brief.request("yoga_mat").count == 12
    assert (brief.width, brief.depth) == (None, None)


def test_behind_every_other_one_is_behind_half_of_them() -> None:
    brief = read_brief("A reading room with four armchairs, a floor lamp behind every other one.")
    assert brief.request("floor_lamp").count == 2
