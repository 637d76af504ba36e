"""Which of several things words are about: looks, pronouns, "another", "both", what each has, and second mentions."""

import pytest

from tests.test_reading_turns import related
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("A lamp stands next to a chair made of oak.", "1 floor_lamp, 1 chair oak"),
        ("A TV is on a TV stand made of oak, and the sofa faces the TV.", "1 tv, 1 tv_stand oak, 1 sofa"),
        ("A rug lies under a table painted white.", "1 rug, 1 dining_table white"),
        ("A bench faces an armchair upholstered in blue velvet.", "1 bench, 1 armchair blue fabric"),
        ("Place a bench to the left of an armchair made of oak.", "1 bench, 1 armchair oak"),
        ("A lamp stands on a desk, made of brass.", "1 desk_lamp brass, 1 desk"),
        ("The chair at the desk is red.", "1 chair red, 1 desk"),
        ("The armchair next to the bench is painted white.", "1 armchair white, 1 bench"),
        ("An armchair covered in black leather stands next to a bench.", "1 armchair black leather, 1 bench"),
        ("Two armchairs face a bench; they are red.", "2 armchair red, 1 bench"),
        ("A sofa and a lamp. They are red.", "1 sofa red, 1 floor_lamp red"),
        ("Three chairs, orange and made of plastic, stand in a row.", "3 chair orange plastic"),
        ("A sofa, orange in color, is against the wall.", "1 sofa orange"),
        ("Six chairs: four black, two orange.", "4 chair black, 2 chair orange"),
        ("A plate holds an apple, an orange and a banana.", "1 plate, 1 apple, 1 orange, 1 banana"),
        ("An apple, orange, and banana are on the table.", "1 apple, 1 orange, 1 banana, 1 dining_table"),
    ],
)
def test_looks_are_of_what_they_are_said_of(prompt: str, asked: str) -> None:
    brief = read_brief(f"This is a room. {prompt}")
    looks = {r.key: frozenset(look for look in r.attributes if not look.startswith("for-")) for r in brief.requests}
    found = [(r.count, r.category, looks[r.key]) for r in brief.requests if r.asked]
    wanted = [(int(n), what, frozenset(told)) for n, what, *told in (words.split() for words in asked.split(", "))]
    assert sorted(found, key=str) == sorted(wanted, key=str)
    assert brief.unknown == ()


WASHING = (
    "1 basket on dryer, 1 washing_machine next_to dryer, 1 dryer against_wall wall, 1 washing_machine against_wall wall"
)


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "A canvas is on the easel, which is beside the window and has a stool in front of it.",
            "1 picture on easel, 1 easel next_to window, 1 stool in_front_of easel",
        ),
        (
            "A rug lies under the table, which has a bowl on it and six chairs around it.",
            "1 rug under dining_table, 1 bowl on dining_table, 6 chair around dining_table",
        ),
        (
            "A lamp stands beside the bed, which has a bench at its foot and faces the window.",
            "1 floor_lamp next_to bed, 1 bench at_foot_of bed, 1 bed facing window",
        ),
        ("A canvas is on the easel with a stool in front of it.", "1 picture on easel, 1 stool in_front_of easel"),
        (
            "A vanity. A towel rack is fixed to the wall, and two towels hang on it.",
            "1 towel_rail on wall, 2 towels on towel_rail",
        ),
        ("A desk is next to a coat stand and a hat hangs on it.", "1 desk next_to coat_rack, 1 hat on coat_rack"),
        (
            "To the left of the fireplace stands an armchair, and to the right of it stands a matching one.",
            "1 armchair left_of fireplace, 1 armchair-2 right_of fireplace",
        ),
        (
            "To the left of the bed is a nightstand. To its right is another.",
            "1 nightstand left_of bed, 1 nightstand-2 right_of bed",
        ),
        (
            "A plant is left of the sofa, and another is right of it.",
            "1 plant left_of sofa, 1 plant-2 right_of sofa",
        ),
        (
            "Two chairs, one to the left of the desk and one to the right of it.",
            "1 chair left_of desk, 1 chair-2 right_of desk",
        ),
        ("Two chairs, one left and one right of the desk.", "1 chair left_of desk, 1 chair-2 right_of desk"),
        (
            "Nightstands: two, one left of the bed, one right of it.",
            "1 nightstand left_of bed, 1 nightstand-2 right_of bed",
        ),
        ("Chairs: two, one by the window and one by the door.", "1 chair next_to window, 1 chair-2 next_to door"),
        ("Chairs (4): around the table.", "4 chair around dining_table"),
        (
            "Nightstands: left and right of the bed.",
            "1 nightstand left_of bed, 1 nightstand-2 right_of bed",
        ),
        (
            "On the dryer is a basket; beside the dryer is a washing machine. Both machines are against the wall.",
            WASHING,
        ),
        (
            "A vanity stands against the wall with a toilet right beside it, also against the wall.",
            "1 dressing_table against_wall wall, 1 toilet next_to dressing_table, 1 toilet against_wall wall",
        ),
        (
            "A play tent in one of the corners and a toy kitchen in a different one.",
            "1 play_tent in_corner corner, 1 play_kitchen in_corner corner",
        ),
        ("A dresser faces the bed from across the room.", "1 dresser facing bed, 1 dresser opposite bed"),
        (
            "One bed and two nightstands. The bed has a nightstand to its left and a nightstand to its right.",
            "1 nightstand left_of bed, 1 nightstand-2 right_of bed",
        ),
        (
            "Two lamps and a desk. A lamp is on the desk and a lamp is on the floor.",
            "1 desk_lamp on desk, 1 floor_lamp on floor",
        ),
        ("A chair, a desk and a lamp. A lamp is on the desk.", "1 desk_lamp on desk"),
        ("A sofa and two chairs. A chair is by the window.", "1 chair-2 next_to window"),
        (
            "Objects: table (1), chairs (6), lamp (1). Constraints: chairs around the table; lamp above the table.",
            "6 chair around dining_table, 1 pendant_lamp above dining_table",
        ),
        (
            "Objects: 2 armchairs, table, lamp. Rules: an armchair on each side of the table; lamp near an armchair.",
            "1 armchair left_of dining_table, 1 armchair-2 right_of dining_table, 1 floor_lamp near armchair",
        ),
        (
            "A bed, two nightstands, two lamps. A nightstand is on each side of the bed, a lamp on each nightstand.",
            "1 nightstand left_of bed, 1 nightstand-2 right_of bed, 2 table_lamp on nightstand nightstand-2",
        ),
        ("A cafe has 3 tables and 6 chairs. Two chairs at each table.", "6 chair around dining_table"),
        ("There are books on the shelf. There are ten books.", "10 book on bookcase"),
        ("Four chairs with cushions around a table.", "4 chair around dining_table, 4 pillow on chair"),
        ("Two sofas with cushions facing each other.", "2 sofa facing sofa, 2 pillow on sofa"),
        ("Two desks with computers next to each other.", "2 desk next_to desk, 2 computer on desk"),
        (
            "Two sofas facing each other with a coffee table between them and a rug underneath.",
            "2 sofa facing sofa, 1 coffee_table between sofa, 1 rug under coffee_table",
        ),
        ("Five sculptures on pedestals. There's one sculpture per pedestal.", "5 sculpture on pedestal"),
    ],
)
def test_relations_are_of_what_they_are_said_of(prompt: str, relations: str) -> None:
    brief = read_brief(f"This is a room. {prompt}")
    assert related(brief) == set(relations.split(", "))
    assert brief.unknown == ()


@pytest.mark.parametrize(
    "prompt",
    [
        "On either side of the bed is a nightstand with a lamp on it.",
        "A bed. A nightstand holding a lamp stands on each side of it.",
        "A bed, and on either side of it stands a nightstand bearing a lamp.",
        "Two nightstands, one left of the bed and one right of it, with one lamp apiece.",
    ],
)
def test_what_each_of_two_has_is_there_twice(prompt: str) -> None:
    brief = read_brief(f"This is a room. {prompt}")
    counts = {request.key: request.count for request in brief.requests if request.asked}
    assert counts == {"bed": 1, "nightstand": 1, "nightstand-2": 1, "table_lamp": 2}
    lamps = next(relation for relation in brief.relations if relation.subject == "table_lamp")
    assert set(lamps.anchors) == {"nightstand", "nightstand-2"}


def test_more_of_the_same_list_are_others() -> None:
    counts = [r.count for r in read_brief("Two lamps, a desk, a lamp on the desk and a lamp by the door.").requests]
    assert sum(counts) == 5


@pytest.mark.parametrize(
    ("prompt", "openings", "relations"),
    [
        (
            "On the left wall is a whiteboard, and on the right wall is a window.",
            {("window", "right_wall", 1)},
            {"1 whiteboard on left_wall"},
        ),
        ("On the right wall are two windows. A sofa.", {("window", "right_wall", 2)}, set()),
        ("There's a window to the right of the bed.", {("window", "", 1)}, {"1 bed left_of window"}),
        (
            "To the left of the window is a wardrobe, to the right a dresser.",
            set(),
            {"1 wardrobe left_of window", "1 dresser right_of window"},
        ),
        (
            "A sofa. Three windows, two on the left wall and one on the back wall.",
            {("window", "left_wall", 2), ("window", "far_wall", 1)},
            set(),
        ),
        (
            "A sofa. Two windows are on the left wall and one is on the back wall.",
            {("window", "left_wall", 2), ("window", "far_wall", 1)},
            set(),
        ),
        ("There is a window on either side of the bed.", {("window", "", 2)}, {"1 bed next_to window"}),
    ],
)
def test_windows_are_where_they_are_said_to_be(
    prompt: str, openings: set[tuple[str, str, int]], relations: set[str]
) -> None:
    brief = read_brief(f"This is a room. {prompt}")
    assert {(o.kind, o.wall, o.count) for o in brief.openings} == openings
    assert related(brief) == relations
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "chairs"),
    [("A dining table for six with chairs.", 6), ("A table for eight people with chairs around it.", 8)],
)
def test_as_many_chairs_as_a_table_seats(prompt: str, chairs: int) -> None:
    assert [r.count for r in read_brief(prompt).requests if r.category == "chair"] == [chairs]


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("An office for three people with a desk and a chair for each.", {"desk": 3, "chair": 3}),
        ("An office with a desk and a chair for each of three people.", {"desk": 3, "chair": 3}),
        ("A classroom with a desk and a chair for each of the 12 students.", {"school_desk": 12, "chair": 12}),
        ("A room for two kids with a bed for each, and a wardrobe.", {"bed": 2, "wardrobe": 1}),
        ("An office for four people: a desk for each and a printer by the door.", {"desk": 4, "printer": 1}),
    ],
)
def test_what_is_for_each_person_is_there_for_all(prompt: str, counts: dict[str, int]) -> None:
    brief = read_brief(prompt)
    assert {r.category: r.count for r in brief.requests if r.asked} == counts
    assert brief.unknown == ()
