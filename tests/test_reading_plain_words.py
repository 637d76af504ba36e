"""Plain sentences as people type them: what is asked for, and how it is to stand."""

import pytest

from tests.test_reading_turns import related
from thinkblox.brief import Brief
from thinkblox.reading import read_brief


def _asked(brief: Brief) -> str:
    """What the prompt asks for: "2 chair, 1 desk"."""
    counts: dict[str, int] = {}
    for request in brief.requests:
        if request.asked:
            counts[request.category] = counts.get(request.category, 0) + request.count
    return ", ".join(f"{count} {category}" for category, count in sorted(counts.items()))


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("A gym with a bench press. Can the bench press be far from the door?", "1 weight_bench"),
        ("Can you do a study with two desks?", "2 desk"),
        ("can each desk have a lamp? Three desks.", "3 desk, 3 desk_lamp"),
        ("A pantry with a can, a jar and a bottle on a shelf.", "1 bottle, 1 jar, 1 shelving_unit, 1 tin_can"),
        ("My robot has to find the keys. Give me a console table, the keys are on it.", "1 console_table, 3 key"),
        ("A bowl on a table. Leave some space so it can drive through.", "1 bowl, 1 dining_table"),
        ("A table which can hold six plates.", "1 dining_table, 6 plate"),
    ],
)
def test_what_can_be_or_has_to_be_done_asks_for_nothing(prompt: str, asked: str) -> None:
    assert _asked(read_brief(prompt)) == asked


def test_an_ability_is_told() -> None:
    brief = read_brief("A lamp that can rotate next to a desk.")
    assert _asked(brief) == "1 desk, 1 floor_lamp"
    assert brief.unknown == ("that can rotate",)


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("A square table. A white bowl is centered on the table.", "1 bowl in_centre dining_table"),
        ("A desk with a monitor centred on it.", "1 monitor in_centre desk"),
        ("A vase stands centrally on the table.", "1 vase in_centre dining_table"),
        ("A tray centered on the ottoman holds two cups.", "1 tray in_centre ottoman"),
        ("A coffee table centred on a rug.", "1 rug under coffee_table"),
        ("A bench is by a sofa, and a stack of at least three books lies on it.", "1 book on bench"),
        ("A desk by a bookcase, and a pile of up to six folders sits on it.", "6 folder on desk"),
    ],
)
def test_what_lies_in_the_middle_or_in_a_pile(prompt: str, relation: str) -> None:
    brief = read_brief(prompt)
    assert relation in related(brief)
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("A treadmill and a bike. Both of them face a mirror.", "1 bicycle, 1 mirror, 1 treadmill"),
        ("Two chairs. Both face a mirror with a lamp above it.", "2 chair, 1 mirror, 1 wall_lamp"),
        ("A sofa and an armchair. They both face a TV.", "1 armchair, 1 sofa, 1 tv"),
        ("Two chairs. Both chairs are next to a lamp and have a cushion.", "2 chair, 1 floor_lamp, 2 pillow"),
        ("Two beds. Both of them have a pillow.", "2 bed, 2 pillow"),
    ],
)
def test_what_both_stand_by_is_one_and_what_both_have_are_two(prompt: str, asked: str) -> None:
    found = _asked(read_brief(prompt))
    assert sorted(found.split(", ")) == sorted(asked.split(", "))


def test_they_are_the_things_that_were_joined() -> None:
    assert related(read_brief("A table and a chair. They stand by the window.")) == {
        "1 dining_table next_to window",
        "1 chair next_to window",
    }
    brief = read_brief("A bed with a pillow and a blanket. They are white.")
    looks = {request.category: request.attributes for request in brief.requests if request.asked}
    assert looks == {"bed": (), "pillow": ("white",), "blanket": ("white",)}


def test_a_keyboard_stands_on_a_stand_of_its_own() -> None:
    assert "1 electric_piano on keyboard_stand" in related(read_brief("A music studio with a keyboard on a stand."))


@pytest.mark.parametrize(
    ("prompt", "kept", "barred"),
    [
        ("A garage with a bike. Car should NOT be in there, just a shelf.", "1 bicycle, 1 shelving_unit", "car"),
        ("A kitchen with a table. Chairs must not be there and a lamp hangs over it.", "1 kitchen_table", "chair"),
        ("Carpets should never be in this bathroom. A bath.", "1 bathtub", "rug"),
        ("A den with a sofa and a TV. The TV should not be in here.", "1 sofa", "tv"),
        ("An office with a desk and a printer. The printer leaks, get rid of it.", "1 desk", "printer"),
        ("A sofa and a rug. The rug looks old, remove it.", "1 sofa", "rug"),
    ],
)
def test_what_is_not_to_be_in_the_room_is_left_out(prompt: str, kept: str, barred: str) -> None:
    brief = read_brief(prompt)
    assert set(kept.split(", ")) <= set(_asked(brief).split(", "))
    assert barred not in _asked(brief).replace(",", "").split()
    assert brief.excluded == (barred,)


def test_some_of_several_are_taken_away() -> None:
    brief = read_brief("Four chairs around a table. One of the chairs broke, take it out.")
    assert (sorted(_asked(brief).split(", ")), brief.unknown) == (["1 dining_table", "3 chair"], ())
    assert read_brief("A desk with a lamp. It broke, remove it.").unknown == ("broke", "remove it")


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("2 washers, sorry, one washer and one dryer on top of it.", "1 dryer, 1 washing_machine"),
        ("A desk with a monitor, sorry, two monitors and a keyboard on it.", "1 desk, 1 keyboard, 2 monitor"),
        ("A red sofa, no, a blue sofa with two cushions on it.", "1 sofa, 2 pillow"),
        ("A room with four chairs. Actually, make that six chairs around a table.", "1 dining_table, 6 chair"),
        ("A sofa. Sorry, two sofas facing each other.", "2 sofa"),
        ("A bathroom with a toilet, a bathtub - no wait, skip the bathtub.", "1 toilet"),
    ],
)
def test_what_is_put_right_replaces_what_was_said(prompt: str, asked: str) -> None:
    brief = read_brief(prompt)
    assert sorted(_asked(brief).split(", ")) == sorted(asked.split(", "))
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A red chair and a blue chair. The red one is by the window.", {"1 chair next_to window"}),
        ("Three lamps and a red chair. The red one is in the corner.", {"1 chair in_corner corner"}),
        ("A wooden desk and a glass desk. On the glass one is a laptop.", {"1 laptop on desk-2"}),
        (
            "Two desks. Anna's is by the window, Tom's is in the corner.",
            {"1 desk next_to window", "1 desk-2 in_corner corner"},
        ),
        ("Two beds. Mia's has a blanket. Mia's is by the door.", {"1 blanket on bed", "1 bed next_to door"}),
    ],
)
def test_one_is_told_by_its_look_or_its_owner(prompt: str, relations: set[str]) -> None:
    brief = read_brief(prompt)
    assert related(brief) == relations
    assert brief.unknown == ()


def test_what_somebodys_looks_like() -> None:
    brief = read_brief("A bedroom with two beds. Mrs Olsen's is the green one.", fill="named")
    assert sorted(r.attributes for r in brief.requests) == [(), ("green",)]
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "looks"),
    [
        (
            "Six chairs are set against the wall, four of them gray and the other two orange.",
            {(4, "grey"), (2, "orange")},
        ),
        ("Two bowls, one gold, the other orange.", {(1, "gold"), (1, "orange")}),
        ("Five cups, three of them white, the rest orange.", {(3, "white"), (2, "orange")}),
    ],
)
def test_the_others_are_orange_and_are_no_fruit(prompt: str, looks: set[tuple[int, str]]) -> None:
    brief = read_brief(prompt, fill="named")
    assert {(r.count, *r.attributes) for r in brief.requests if r.asked} == looks


@pytest.mark.parametrize(
    "prompt",
    [
        "On each side of the bed is a nightstand, and each of them has a lamp on it.",
        "A bed with a nightstand on each side, each with a lamp on it.",
        "There is a nightstand on either side of the bed, each holding a lamp.",
    ],
)
def test_what_each_of_two_at_the_sides_has_is_on_both(prompt: str) -> None:
    brief = read_brief(prompt, fill="named")
    on = [(r.subject, r.anchors) for r in brief.relations if r.kind == "on"]
    assert {anchor for _, anchors in on for anchor in anchors} == {"nightstand", "nightstand-2"}
    assert "2 table_lamp" in _asked(brief)
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("My father repairs watches and clocks, and this is to be his workshop. A workbench.", "1 workbench"),
        ("My wife bakes bread, the oven is next to the fridge.", "1 fridge, 1 oven"),
        ("A waiting room. One fish tank, but not near the door, the kids bump into it.", "1 aquarium"),
        ("Guests complain about room 12 of my hotel, so I want it redone. It gets two beds.", "2 bed"),
        ("A record shop run by an old hippie, with two crates.", "2 crate"),
        ("A kindergarten with a rug. The piano we used to have is gone, so don't add one.", "1 rug"),
        ("A dorm room with one whiteboard nobody has wiped since october.", "1 whiteboard"),
        ("A kitchen with a stove. No rug, the wheels get stuck.", "1 stove"),
        ("A mail room for a parcel-sorting robot: a steel table.", "1 table"),
        ("An assistive robot will work in this bedroom. It has a bed.", "1 bed"),
        ("A workshop with a workbench. It stands under the window because he needs the light.", "1 workbench"),
        ("A parlour straight out of 1962, a jukebox, that sugary smell.", "1 jukebox"),
        ("A den for a retired sea captain to sulk in. A leather armchair.", "1 armchair"),
        ("A bedroom for somebody with a dust allergy, so no rug. A bed.", "1 bed"),
        (
            "Object-goal navigation episode in a living room. The target is a backpack on the sofa.",
            "1 backpack, 1 sofa",
        ),
        ("An 80s arcade. Soft light, six arcade cabinets, wherever you look.", "6 arcade_cabinet"),
        ("Meeting room, to contain: a table; eight chairs.", "8 chair, 1 conference_table"),
        ("A garage. A ladder leans against the wall.", "1 ladder"),
    ],
)
def test_what_people_do_or_are_asks_for_nothing(prompt: str, asked: str) -> None:
    brief = read_brief(prompt)
    assert _asked(brief) == asked
    assert brief.unknown == ()


@pytest.mark.parametrize(
    "prompt", ["This is for my nursery. A crib.", "need nursery fast, a crib", "A nursery. Nothing but a crib."]
)
def test_the_kind_of_room_is_read(prompt: str) -> None:
    assert read_brief(prompt).room_type == "nursery"


@pytest.mark.parametrize(
    ("prompt", "asked", "attributes"),
    [
        ("A hall with a clock, or rather two.", "2 clock", {()}),
        ("A study with a pine desk, no, an oak one.", "1 desk", {("oak",)}),
        (
            "Two desks with two lamps, one lamp red and the other blue.",
            "2 desk, 2 desk_lamp",
            {(), ("red",), ("blue",)},
        ),
    ],
)
def test_second_thoughts_and_two_of_a_kind(prompt: str, asked: str, attributes: set[tuple[str, ...]]) -> None:
    brief = read_brief(prompt, fill="named")
    assert _asked(brief) == asked
    assert {request.attributes for request in brief.requests} == attributes


@pytest.mark.parametrize("none", ["not a single", "no", "but not one", "not even a"])
def test_nothing_of_a_list_is_wanted(none: str) -> None:
    brief = read_brief(f"An office with two desks, each with a laptop on it, and {none} chair, stool or sofa.")
    assert set(brief.excluded) == {"chair", "stool", "sofa"}
    assert brief.unknown == ()


def test_exactly_one_of_more_is_one_of_them() -> None:
    brief = read_brief("Two socks lie on the floor of a study, exactly one sock under the desk.", fill="named")
    assert _asked(brief) == "1 desk, 2 sock"


def test_benches_named_again_stand_where_they_are_said_to() -> None:
    brief = read_brief("A dining room. We eat on benches: two pine benches, one on each long side of the table.")
    assert "2 bench at_long_side dining_table" in related(brief)


def test_what_is_inside_something_needs_nothing_to_lie_on() -> None:
    brief = read_brief("A laundry room with a washing machine. Two detergent bottles are in the white wall cabinet.")
    assert not any(request.category == "base_cabinet" for request in brief.requests)


def test_no_more_of_what_is_counted_is_assumed() -> None:
    brief = read_brief("A kitchen with a fridge, a stove and a cabinet.")
    assert [r.category for r in brief.requests if r.category.endswith("cabinet")] == ["cabinet"]


def test_what_a_sack_holds_is_in_its_name() -> None:
    brief = read_brief("A shed with a soil sack.")
    assert [(r.category, r.unshown) for r in brief.requests if r.asked] == [("soil_sack", ())]


@pytest.mark.parametrize(
    "prompt",
    [
        "A cabin without a sofa, a television or any plants.",
        "Don't give the cabin a sofa, a television or any plants.",
        "A cabin with no sofa, television or plants.",
    ],
)
def test_all_of_a_denied_list_is_denied(prompt: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert (set(brief.excluded), brief.requests, brief.unknown) == ({"sofa", "tv", "plant"}, (), ())


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("A bench. The hats are not on the bench, which stands in the middle of the room.", "1 bench in_centre centre"),
        ("Five tables, each with two benches by it and, on it, a menu and a candle.", "5 candle on dining_table"),
        ("Six consoles. Each has a keyboard on it, plus a chair that faces it.", "6 chair facing console_table"),
        ("A flag stands to the left of the sofa, a second one to its right.", "1 flag-2 right_of sofa"),
        ("A chapel has an altar, flanked by two lamps, one on its left and one on its right.", "1 altar"),
        ("An office. What's on her desk? Two mugs.", "2 cup on desk"),
        ("A study. And where is the desk? By the window.", "1 desk next_to window"),
        ("A hall with a bench; someone's left a rucksack on it.", "1 backpack on bench"),
        ("There's a globe in the office. It stands on a chest, and so does a clock.", "1 clock on chest"),
        ("Six crates are on two tables, three to a table.", "6 crate on"),
        ("Three desks. Each of the three has a lamp on it and a stool in front of it.", "3 stool in_front_of desk"),
        ("A room with four plants, two of them against the wall, the rest near the window.", "2 plant-2 near window"),
    ],
)  # fmt: skip
def test_turns_of_speech_are_read(prompt: str, relation: str) -> None:
    brief = read_brief(prompt, fill="named")
    counted = {f"{brief.request(r.key).count} {r.key}" for r in brief.requests}
    assert any(found.startswith(relation) for found in related(brief) | counted)
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("A child's room for a girl who hates pink. A bed.", "who hates pink"),
        ("A guest room for a couple who can't stand blue, with a bed.", "who can't stand blue"),
        ("A lounge with a fish tank that all the chairs can see. Two chairs.", "that all the chairs can see"),
        ("A bedroom under a skylight, with a bed.", "under a skylight"),
        ("A bedroom with a bed, and the mirror reflects the window.", "and the mirror reflects the window"),
        ("A dining room with a table and no two chairs of the same colour.", "and no two chairs of the same colour"),
    ],
)
def test_what_cannot_be_followed_is_told_and_stands_in_the_account(prompt: str, told: str) -> None:
    brief = read_brief(prompt)
    assert told in brief.unknown
    fates = {word.text: word.fate for word in brief.account}
    assert fates[told.split()[-1]] == "not_understood"
    assert "chair" not in brief.excluded


def test_every_word_is_accounted_for_where_words_are_read_as_others() -> None:
    prompt = "This is for my bedroom, run by an old hippie: a bed."
    words = [word.text for word in read_brief(prompt).account]
    assert words == ["This", "is", "for", "my", "bedroom", "run", "by", "an", "old", "hippie", "a", "bed"]


def test_words_written_as_one_are_two() -> None:
    brief = read_brief("A lounge with 2 sofas facing eachother, coffe table inbetween.")
    assert {"2 sofa facing sofa", "1 coffee_table between sofa"} <= related(brief)


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        (
            "On the desk: two microphones, a lamp between the microphones, and a cup to the left of the lamp.",
            {"1 desk_lamp on desk", "1 cup on desk", "1 cup left_of desk_lamp"},
        ),
        ("A cabinet against the wall containing six jars and three books.", {"6 jar inside cabinet"}),
        ("A bookcase with forty books in it. A table carries twelve more.", {"12 book-2 on dining_table"}),
        ("Two racks against the wall hold ten boxes between them.", {"10 box inside shelving_unit"}),
        (
            "Four tables: six plants on each of two of them, three vases on each of the other two.",
            {"12 potted_plant on dining_table", "6 vase on dining_table-2"},
        ),
        (
            "Three beds. Two of the beds have a pink blanket on them, the third a yellow one.",
            {"2 blanket on bed", "1 blanket-2 on bed-2"},
        ),
        (
            "Eight lockers along each of two opposite walls, half of all the lockers blue and half white.",
            {"8 locker against_wall wall", "8 locker-2 against_wall wall"},
        ),
        (
            "A pottery workshop with six wheels, each with a stool in front of it.",
            {"6 stool in_front_of pottery_wheel"},
        ),
        (
            "A classroom. Five desks, two chairs at each, a book for every chair. Four chairs are red.",
            {"6 chair-2 at school_desk"},
        ),
    ],
)
def test_numbers_and_places_are_shared_out(prompt: str, relations: set[str]) -> None:
    brief = read_brief(prompt, fill="named")
    assert relations <= related(brief)
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "unknown"),
    [
        ("A cafe in Paris with two tables.", ()),
        ("A flat in New York, with two tables.", ()),
        ("An office in Oslo, Norway, with two tables.", ()),
        ("a loft in berlin with two tables", ("berlin",)),
    ],
)
def test_a_town_is_no_thing(prompt: str, unknown: tuple[str, ...]) -> None:
    brief = read_brief(prompt, fill="named")
    assert {request.category.rpartition("_")[2] for request in brief.requests} == {"table"}
    assert brief.unknown == unknown
