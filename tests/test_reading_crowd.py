"""Sentences as many hands write them: labels, lists, flowery verbs, words left out, and which of several is meant."""

import pytest

from tests.briefs import asked, related, told
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "counts", "relations"),
    [
        # Which of several the place tells.
        (
            (
                "Two desks. One is against the wall and the other is in the middle of the room. "
                "A chair is near the desk that is against the wall. A lamp is on the desk in the middle of the room."
            ),
            {"desk": 1, "desk-2": 1, "chair": 1, "desk_lamp": 1},
            {"desk against_wall wall", "desk-2 in_centre centre", "chair near desk", "desk_lamp on desk-2"},
        ),
        (
            (
                "There are two sofas. One is under the window and the other is in the corner. "
                "A rug is in front of the sofa under the window."
            ),
            {"sofa": 1, "sofa-2": 1, "rug": 1},
            {"sofa under window", "sofa-2 in_corner corner", "rug in_front_of sofa"},
        ),
        # One for each of so many is those that were counted.
        (
            "There are two sinks and two oval mirrors. A mirror hangs above each sink.",
            {"sink": 2, "mirror": 2},
            {"mirror above sink each"},
        ),
        (
            "Two nightstands and two lamps. Each nightstand has one lamp on it.",
            {"nightstand": 2, "table_lamp": 2},
            {"table_lamp on nightstand each"},
        ),
        # Some of several, and the others.
        (
            "Four chairs, exactly one of which is red, are placed against the wall.",
            {"chair": 1, "chair-2": 3},
            {"chair against_wall wall", "chair-2 against_wall wall"},
        ),
        (
            "A vase and two candles on a shelf, one candle to the left of the vase and one to the right.",
            {"vase": 1, "candle": 1, "candle-2": 1, "shelving_unit": 1},
            {
                "vase on shelving_unit",
                "candle on shelving_unit",
                "candle-2 on shelving_unit",
                "candle left_of vase",
                "candle-2 right_of vase",
            },
        ),
        (
            (
                "There are three bookcases. The first is white. The second, a black one, has a globe on top. "
                "The third holds four boxes."
            ),
            {"bookcase": 1, "bookcase-2": 1, "bookcase-3": 1, "globe": 1, "box": 4},
            {"globe on bookcase-2", "box inside bookcase-3"},
        ),
        (
            (
                "Two workbenches, a long one and a short one. The former is against the wall and carries a vise; "
                "the latter, which is in the middle of the room, a lamp."
            ),
            {"workbench": 1, "workbench-2": 1, "vise": 1, "desk_lamp": 1},
            {
                "workbench against_wall wall",
                "vise on workbench",
                "workbench-2 in_centre centre",
                "desk_lamp on workbench-2",
            },
        ),
        (
            "Six bicycles hang on the wall and four stand in the middle of the room.",
            {"wall_bicycle": 6, "bicycle": 4},
            {"wall_bicycle on wall", "bicycle in_centre centre"},
        ),
        # Who it is told of.
        (
            "A clock hangs on the wall, and a trolley holding two boxes stands near the door.",
            {"clock": 1, "serving_trolley": 1, "box": 2},
            {"clock on wall", "box on serving_trolley", "serving_trolley near door"},
        ),
        (
            "A step stool in front of the sofa and, hung on the wall next to the door, a mirror.",
            {"step_stool": 1, "sofa": 1, "mirror": 1},
            {"step_stool in_front_of sofa", "mirror on wall", "mirror next_to door"},
        ),
        (
            "Three books lie on the floor, none of them in the bookcase, which is against the wall.",
            {"book": 3, "bookcase": 1},
            {"book on floor", "book not inside bookcase", "bookcase against_wall wall"},
        ),
        (
            "A framed map hangs above the sofa and a coat rack next to the door.",
            {"wall_map": 1, "sofa": 1, "coat_hooks": 1},
            {"wall_map above sofa", "coat_hooks next_to door", "coat_hooks on wall"},
        ),
        (
            "A big table takes up the middle; a train set is on it, and so is a toy car.",
            {"dining_table": 1, "train_set": 1, "toy_car": 1},
            {"dining_table in_centre centre", "train_set on dining_table", "toy_car on dining_table"},
        ),
        (
            "Two laundry baskets next to a dryer, every one of them blue.",
            {"laundry_basket": 2, "dryer": 1},
            {"laundry_basket next_to dryer"},
        ),
        (
            "The bed has a nightstand on its left but none on its right.",
            {"bed": 1, "nightstand": 1},
            {"nightstand left_of bed"},
        ),
        (
            "The table by the window has three things on it: a lantern, a notebook and a pair of binoculars.",
            {"dining_table": 1, "lantern": 1, "notebook": 1, "binoculars": 1},
            {
                "dining_table next_to window",
                "lantern on dining_table",
                "notebook on dining_table",
                "binoculars on dining_table",
            },
        ),
        (
            "Two stoves, each with three pots and two frying pans on it and a range hood above it.",
            {"stove": 2, "cooking_pot": 6, "frying_pan": 4, "range_hood": 2},
            {"cooking_pot on stove each", "frying_pan on stove each", "range_hood above stove each"},
        ),
        # Labels, lists, and verbs that only say that something is there.
        (
            "Home office\n1) one desk in the corner of the room\n2) one office chair facing the desk\n3) two monitors",
            {"desk": 1, "office_chair": 1, "monitor": 2},
            {"desk in_corner corner", "office_chair facing desk"},
        ),
        (
            "Walking into the gallery, you see a long bench in the middle of the room.",
            {"bench": 1},
            {"bench in_centre centre"},
        ),
        (
            "Push two beds against the wall. Fit a nightstand between the beds.",
            {"bed": 2, "nightstand": 1},
            {"bed against_wall wall", "nightstand between bed"},
        ),
        (
            "A slender bench against the wall cradles a bonsai. A folding screen stands demurely in the corner.",
            {"bench": 1, "bonsai": 1, "room_divider": 1},
            {"bench against_wall wall", "bonsai on bench", "room_divider in_corner corner"},
        ),
        (
            "A velvet sofa holds court against the wall of this sitting room; upon the rug a round table gleams.",
            {"sofa": 1, "rug": 1, "coffee_table": 1},
            {"sofa against_wall wall", "rug under coffee_table"},
        ),
    ],
)
def test_what_is_said_is_asked_for(prompt: str, counts: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (counts, relations)


@pytest.mark.parametrize(
    ("prompt", "room"),
    [
        ("Three black stools are by a counter. The room is a kitchen.", "kitchen"),
        ("Eight student desks fill the classroom.", "classroom"),
        ("I repair clocks for a living, and this is my shop.", "shop"),
        ("1985 arcade (5 x 4 m)!! three arcade cabinets", "arcade"),
        ("A newsroom of the seventies with nine desks.", "office"),
        ("Flower shop with a Parisian feel, zinc buckets.", "florist"),
        ("boxing gym like in the movies, two punching bags", "boxing_gym"),
        ("A lobby with a plant and hardly anything else.", "reception"),
    ],
)
def test_the_room_is_known_and_all_understood(prompt: str, room: str) -> None:
    brief = read_brief(prompt)
    assert (brief.room_type, brief.unknown) == (room, ())


@pytest.mark.parametrize(
    ("prompt", "category", "looks"),
    [
        ("Break room: vending machine, saggy brown couch, coffee machine.", "sofa", {"brown"}),
        ("Fifteen chairs. Ten of the chairs are blue and the remaining ones orange.", "chair", {"blue", "orange"}),
        ("Two mirrored wardrobes against the wall.", "wardrobe", set()),
    ],
)
def test_an_adjective_is_no_thing(prompt: str, category: str, looks: set[str]) -> None:
    requests = [r for r in read_brief(prompt).requests if r.category == category and r.asked]
    assert requests
    assert {look for r in requests for look in r.attributes} == looks
    assert "orange" not in asked(read_brief(prompt))


def test_a_rug_hangs_on_a_wall_as_a_tapestry_and_a_television_that_does_not_stands():
    assert related(read_brief("The rug hangs on the wall.")) == {"tapestry on wall"}
    stands = read_brief("The television is not on the wall but on a low cabinet.")
    assert "tv on sideboard" in related(stands)


def test_a_denied_neighbour_is_any_of_those_that_were_named():
    brief = read_brief("Two benches. The bin must not be next to a bench.")
    assert asked(brief) == {"bench": 2, "waste_bin": 1}
    assert "waste_bin not next_to bench" in related(brief)


@pytest.mark.parametrize(
    ("prompt", "name"),
    [("A model of an eye on a desk.", "eye_model"), ("Four toilet paper rolls on a shelf.", "toilet_paper_roll")],
)
def test_a_thing_has_the_name_that_is_said(prompt: str, name: str) -> None:
    assert name in asked(read_brief(prompt))


def test_four_bookshelves_are_called_so():
    (request,) = (r for r in read_brief("A library with four bookshelves.").requests if r.asked)
    assert request.called == "bookshelf"


@pytest.mark.parametrize(
    ("prompt", "things", "barred"),
    [
        (
            "A living room with a sofa. I don't want a TV, a rug, or any plants in it.",
            {"sofa": 1},
            {"plant", "rug", "tv"},
        ),
        ("A kids room with a toy chest. No rug, they'd only spill on it.", {"toy_box": 1}, {"rug"}),
    ],
)
def test_what_is_not_wanted_is_not_made(prompt: str, things: dict[str, int], barred: set[str]) -> None:
    brief = read_brief(prompt)
    assert asked(brief) == things
    assert set(brief.excluded) == barred


def test_the_one_table_that_differs_is_one_of_them():
    brief = read_brief("A café with six tables. All tables have two chairs, except one table that has four chairs.")
    assert sum(r.count for r in brief.requests if r.category == "dining_table") == 6
    assert sum(r.count for r in brief.requests if r.category == "chair") == 14
