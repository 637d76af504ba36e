"""Prompts and what must be read from them: every object with its count, and its relations."""

from typing import get_args

import pytest

from thinkblox.assets import CATALOGUE, GENERAL_WORDS
from thinkblox.assets.stand_ins import stand_in
from thinkblox.brief import Brief, Place
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import room_types
from thinkblox.knowledge.senses import senses_of
from thinkblox.knowledge.things import things
from thinkblox.reading import read_brief
from thinkblox.reading.lexicon import LANGUAGES, load

PLACES = set(get_args(Place))

SHARED = {
    "A calm bedroom, 4 m by 5 m, with a double bed against the long wall, two nightstands with a lamp on each, "
    "a wardrobe, and a small desk with a chair by the window.": (
        "1 bed, 2 nightstand, 2 table_lamp, 1 wardrobe, 1 desk, 1 chair",
        "bed against_wall long_wall, table_lamp on nightstand, desk next_to window, chair at desk",
    ),
    "A child's room with a bunk bed, a low bookcase full of books, a toy box in the corner, a round rug and a play "
    "table with two small chairs.": (
        "1 bunk_bed, 1 bookcase, 1 toy_box, 1 rug, 1 play_table, 2 child_chair",
        "toy_box in_corner corner, child_chair around play_table",
    ),
    "A living room where a three-seat sofa faces a TV on a TV stand, with a coffee table on a rug between them, two "
    "armchairs, a floor lamp and a tall plant.": (
        "1 sofa, 1 tv, 1 tv_stand, 1 coffee_table, 1 rug, 2 armchair, 1 floor_lamp, 1 plant",
        "sofa facing tv, tv on tv_stand, coffee_table between sofa tv, rug under coffee_table",
    ),
    "A small studio of 18 square metres: a single bed, a sofa, a kitchen table with two chairs, a fridge and a "
    "wardrobe.": ("1 bed, 1 sofa, 1 kitchen_table, 2 chair, 1 fridge, 1 wardrobe", "chair around kitchen_table"),
    "A dining room for six: a long table with six chairs around it, a sideboard against the wall with a vase on it, "
    "and a pendant lamp above the table.": (
        "1 dining_table, 6 chair, 1 sideboard, 1 vase, 1 pendant_lamp",
        "chair around dining_table, sideboard against_wall wall, vase on sideboard, pendant_lamp above dining_table",
    ),
    "A bookstore, 8x6 m: rows of bookcases with aisles between them, a display table with stacks of books in the "
    "middle, a cash counter near the door and a reading chair with a side table and a lamp.": (
        "6 bookcase, 1 display_table, 3 book_stack, 1 counter, 1 armchair, 1 side_table, 1 floor_lamp, 1 cash_register",
        (
            "bookcase in_rows, display_table in_centre centre, book_stack on display_table, counter near door, "
            "cash_register on counter, side_table next_to armchair, floor_lamp next_to armchair"
        ),
    ),
    "A buffet restaurant with a long buffet counter carrying food trays, plates and bowls, five square tables with "
    "four chairs each, and a water dispenser.": (
        "1 counter, 3 food_tray, 3 plate, 3 bowl, 5 dining_table, 20 chair, 1 water_dispenser",
        "food_tray on counter, plate on counter, bowl on counter, chair around dining_table",
    ),
    "A classroom with twelve school desks in three rows facing a whiteboard, a teacher's desk with a chair and a "
    "computer, a bookshelf and a globe on it.": (
        "12 school_desk, 1 whiteboard, 1 desk, 13 chair, 1 computer, 1 monitor, 1 keyboard, 1 bookcase, 1 globe",
        "school_desk in_rows, school_desk facing whiteboard, chair at desk, computer on desk, globe on bookcase",
    ),
    "A computer room: four desks along the walls, each with a monitor, a keyboard, a mouse and an office chair; a "
    "printer on a cabinet and a server rack in a corner.": (
        "4 desk, 4 monitor, 4 keyboard, 4 mouse, 4 office_chair, 1 printer, 1 cabinet, 1 server_rack",
        (
            "desk against_wall wall, monitor on desk, keyboard on desk, mouse on desk, office_chair at desk, "
            "printer on cabinet, server_rack in_corner corner"
        ),
    ),
    "A deli with a glass display fridge, a counter with a cash register and a scale, three high tables with two stools "
    "each, shelves with jars and bottles, and a menu board on the wall.": (
        (
            "1 display_fridge, 1 counter, 1 cash_register, 1 scale, 3 high_table, 6 bar_stool, 2 shelving_unit, 3 jar, "
            "3 bottle, 1 menu_board"
        ),
        (
            "cash_register on counter, scale on counter, bar_stool around high_table, jar inside shelving_unit, "
            "bottle inside shelving_unit, menu_board on wall"
        ),
    ),
    "A florist's shop full of plants: fifteen potted plants on three tiered tables, buckets of flowers on the floor, a "
    "wooden counter with a register, and a bench.": (
        "15 potted_plant, 3 tiered_table, 3 flower_bucket, 1 counter, 1 cash_register, 1 bench",
        "potted_plant on tiered_table, cash_register on counter",
    ),
    "A game room with a pool table in the centre, a table football, two arcade cabinets side by side, a dart board on "
    "the wall, a sofa and a low table with a games console.": (
        "1 pool_table, 1 table_football, 2 arcade_cabinet, 1 dart_board, 1 sofa, 1 coffee_table, 1 games_console",
        (
            "pool_table in_centre centre, arcade_cabinet next_to arcade_cabinet, dart_board on wall, "
            "games_console on coffee_table"
        ),
    ),
    "A home office, L-shaped, with a corner desk, an office chair, two bookcases, a filing cabinet, a desk lamp, a "
    "laptop and a picture on the wall.": (
        "1 corner_desk, 1 office_chair, 2 bookcase, 1 filing_cabinet, 1 desk_lamp, 1 laptop, 1 picture",
        "picture on wall",
    ),
    "A kitchen with base cabinets along one wall carrying a sink, a stove and a microwave, a fridge at the end, an "
    "island with three stools and a bowl of fruit on it.": (
        "3 base_cabinet, 1 sink, 1 hob, 1 microwave, 1 fridge, 1 kitchen_island, 3 bar_stool, 1 fruit_bowl",
        (
            "base_cabinet against_wall one_wall, sink on base_cabinet, hob on base_cabinet, microwave on base_cabinet, "
            "fridge next_to base_cabinet, bar_stool at kitchen_island, fruit_bowl on kitchen_island"
        ),
    ),
    "A hospital room: a bed with its head against the wall, a bedside cabinet with a water glass on it, a visitor's "
    "chair facing the bed, a curtain rail and a waste bin by the door.": (
        "1 hospital_bed, 1 nightstand, 1 glass, 1 visitor_chair, 1 curtain_rail, 1 waste_bin",
        (
            "hospital_bed against_wall wall, glass on nightstand, visitor_chair facing hospital_bed, "
            "waste_bin next_to door"
        ),
    ),
    "A 12 ft x 15 ft master bedroom with a king-size bed, a bench at its foot, two bedside tables, a dresser with a "
    "mirror above it, an armchair in the corner and a rug under the bed.": (
        "1 bed, 1 bench, 2 nightstand, 1 dresser, 1 mirror, 1 armchair, 1 rug",
        "bench at_foot_of bed, mirror above dresser, armchair in_corner corner, rug under bed",
    ),
    "A meeting room with an oval table, ten chairs around it, a screen on the short wall, a whiteboard opposite and a "
    "credenza with a coffee machine.": (
        "1 conference_table, 10 chair, 1 projector_screen, 1 whiteboard, 1 credenza, 1 coffee_machine",
        (
            "chair around conference_table, projector_screen on short_wall, "
            "whiteboard opposite projector_screen, coffee_machine on credenza"
        ),
    ),
    "A laundry room with a washing machine beside a dryer, a shelf above them with two boxes, a laundry basket and an "
    "ironing board.": (
        "1 washing_machine, 1 dryer, 1 wall_shelf, 2 box, 1 laundry_basket, 1 ironing_board",
        "washing_machine next_to dryer, wall_shelf above washing_machine dryer, box on wall_shelf",
    ),
    "Ein kleines Schlafzimmer mit einem Bett, einem Schrank und einem Schreibtisch.": (
        "1 bed, 1 wardrobe, 1 desk, 1 office_chair",
        "",
    ),
    "An empty room with nothing in it but a chair.": ("1 chair", ""),
    "A waiting room with two rows of five chairs facing each other, a low table with magazines between them and a "
    "plant in each corner.": (
        "10 chair, 1 coffee_table, 3 magazine, 4 plant",
        (
            "chair in_rows, chair facing chair, coffee_table between chair, magazine on coffee_table, "
            "plant in_corner corner"
        ),
    ),
}

OWN = {
    "bed, desk, chair": ("1 bed, 1 desk, 1 chair", ""),
    "Kids' bedroom with twin beds, a nightstand between them, and a toy chest at the foot of each bed.": (
        "2 bed, 1 nightstand, 2 toy_box",
        "nightstand between bed, toy_box at_foot_of bed",
    ),
    "A cafe with six round tables, each with two chairs, and a menu board behind the counter.": (
        "6 dining_table, 12 chair, 1 menu_board, 1 counter, 1 cash_register",
        "chair around dining_table, menu_board behind counter",
    ),
    "A library with a reading table with eight chairs around it, and a globe on the table.": (
        "1 dining_table, 8 chair, 1 globe, 4 bookcase, 2 table_lamp, 1 desk, 1 computer, 1 monitor, 1 keyboard",
        "chair around dining_table, globe on dining_table, bookcase in_rows",
    ),
    "A bathroom with a toilet, a sink with a mirror above it, and a towel rack.": (
        "1 toilet, 1 washbasin, 1 mirror, 1 towel_rail",
        "mirror above washbasin",
    ),
    "On the desk there is a laptop and a lamp. The desk is by the window. Next to the desk stands a bookcase.": (
        "1 desk, 1 laptop, 1 desk_lamp, 1 bookcase",
        "laptop on desk, desk_lamp on desk, desk next_to window, bookcase next_to desk",
    ),
    "Two beds, two desks with a lamp on each, and a wardrobe at the foot of each bed.": (
        "2 bed, 2 desk, 2 desk_lamp, 2 wardrobe",
        "desk_lamp on desk, wardrobe at_foot_of bed",
    ),
    "A bedroom with a bed, two nightstands on either side of the bed, each with a lamp and an alarm clock.": (
        "1 bed, 2 nightstand, 2 table_lamp, 2 alarm_clock",
        "nightstand left_of bed, nightstand right_of bed, table_lamp on nightstand, alarm_clock on nightstand",
    ),
    "A sofa with two cushions, a floor lamp to the left of the sofa and a side table to the right of it.": (
        "1 sofa, 2 pillow, 1 floor_lamp, 1 side_table",
        "pillow on sofa, floor_lamp left_of sofa, side_table right_of sofa",
    ),
    "Place a lamp on each of the two nightstands next to the bed.": (
        "2 table_lamp, 2 nightstand, 1 bed",
        "table_lamp on nightstand, nightstand next_to bed",
    ),
    "A supermarket with four rows of shelves, three checkout counters with a cash register on each, and a fridge.": (
        "12 shelving_unit, 3 counter, 3 cash_register, 1 fridge",
        "shelving_unit in_rows, cash_register on counter",
    ),
    "A lecture hall with five rows of eight chairs facing a blackboard.": (
        "40 chair, 1 blackboard",
        "chair in_rows, chair facing blackboard",
    ),
    "A sofa, a loveseat and an armchair around a square coffee table; a floor lamp behind the sofa.": (
        "2 sofa, 1 armchair, 1 coffee_table, 1 floor_lamp",
        "sofa around coffee_table, armchair around coffee_table, floor_lamp behind sofa",
    ),
    "A bed, to its left a nightstand with a lamp, to its right a wardrobe.": (
        "1 bed, 1 nightstand, 1 table_lamp, 1 wardrobe",
        "nightstand left_of bed, table_lamp on nightstand, wardrobe right_of bed",
    ),
    "A lamp on the floor, a bicycle hanging on the wall and a guitar on the wall.": (
        "1 floor_lamp, 1 wall_bicycle, 1 wall_guitar",
        "floor_lamp on floor, wall_bicycle on wall, wall_guitar on wall",
    ),
    "A bicycle against the wall.": (
        "1 bicycle",
        "bicycle against_wall wall",
    ),
    "A sofa with a side table on each side and a lamp on each side table.": (
        "1 sofa, 2 side_table, 2 table_lamp",
        "side_table left_of sofa, side_table right_of sofa, table_lamp on side_table",
    ),
    "Two armchairs by the fireplace with a small round table between them, and on the table two cups.": (
        "2 armchair, 1 fireplace, 1 coffee_table, 2 cup",
        "armchair next_to fireplace, coffee_table between armchair, cup on coffee_table",
    ),
    "A living room. There is a sofa against the north wall. In front of the sofa is a coffee table. A TV stands on a "
    "stand opposite the sofa. Two plants are in the corners.": (
        "1 sofa, 1 coffee_table, 1 tv, 1 tv_stand, 2 plant",
        "sofa against_wall north_wall, coffee_table in_front_of sofa, tv on tv_stand, tv_stand opposite sofa",
    ),
    "A spacious living room with two sofas facing each other, a coffee table between them with a bowl of fruit on it, "
    "a TV on a low cabinet against the north wall, and a floor lamp next to each sofa.": (
        "2 sofa, 1 coffee_table, 1 fruit_bowl, 1 tv, 1 sideboard, 2 floor_lamp",
        (
            "sofa facing sofa, coffee_table between sofa, fruit_bowl on coffee_table, tv on sideboard, "
            "floor_lamp next_to sofa"
        ),
    ),
    "A hair salon with four chairs each facing a mirror.": ("4 salon_chair, 4 mirror", "salon_chair facing mirror"),
    "Ein Büro mit drei Schreibtischen, jeder mit einem Monitor und einem Bürostuhl, und einem Drucker auf einem "
    "Aktenschrank neben der Tür.": (
        "3 desk, 3 monitor, 3 office_chair, 1 printer, 1 filing_cabinet",
        "monitor on desk, office_chair at desk, printer on filing_cabinet, filing_cabinet near door",
    ),
    "A bedroom with a bed between two nightstands.": ("1 bed, 2 nightstand", "nightstand next_to bed"),
    "Four chairs at a round table, with a vase in the middle of the table.": (
        "4 chair, 1 dining_table, 1 vase",
        "chair around dining_table, vase on dining_table",
    ),
    "Two dozen chairs, a couple of plants and half a dozen cushions on a sofa": (
        "24 chair, 2 plant, 6 pillow, 1 sofa",
        "pillow on sofa",
    ),
    "A restaurant with 8 tables for four.": ("8 dining_table, 32 chair", "chair around dining_table"),
    "Une chambre avec un grand lit, deux tables de chevet avec une lampe sur chacune et une armoire contre le mur.": (
        "1 bed, 2 nightstand, 2 table_lamp, 1 wardrobe",
        "table_lamp on nightstand, wardrobe against_wall wall",
    ),
    "Ein Schlafzimmer mit zwei Nachttischen mit je einer Lampe und einem Teppich unter dem Bett.": (
        "2 nightstand, 2 table_lamp, 1 rug, 1 bed",
        "table_lamp on nightstand, rug under bed",
    ),
    "Un salón con un sofá gris contra la pared, una mesa de centro delante del sofá y una alfombra redonda.": (
        "1 sofa, 1 coffee_table, 1 rug",
        "sofa against_wall wall, coffee_table in_front_of sofa",
    ),
}


def counted(brief: Brief) -> dict[str, int]:
    counts: dict[str, int] = {}
    for request in brief.requests:
        counts[request.category] = counts.get(request.category, 0) + request.count
    return counts


def related(brief: Brief) -> set[str]:
    category = {request.key: request.category for request in brief.requests}
    return {
        " ".join([category[r.subject], r.kind, *dict.fromkeys(category.get(a, a) for a in r.anchors)])
        for r in brief.relations
        if r.kind != "in_rows"
    } | {f"{category[r.subject]} in_rows" for r in brief.relations if r.kind == "in_rows"}


@pytest.mark.parametrize(("prompt", "expected"), (SHARED | OWN).items())
def test_objects_are_counted_and_related(prompt: str, expected: tuple[str, str]) -> None:
    objects, relations = expected
    brief = read_brief(prompt)
    wanted = {category: int(count) for count, category in (item.split() for item in objects.split(", "))}
    assert counted(brief) == wanted
    missing = {relation for relation in relations.split(", ") if relation} - related(brief)
    assert not missing, sorted(related(brief))


@pytest.mark.parametrize("prompt", SHARED)
def test_every_word_of_the_shared_prompts_is_understood(prompt: str) -> None:
    brief = read_brief(prompt)
    assert brief.unknown == ()
    assert brief.missing == ()


def test_a_bare_room_is_filled_and_says_so() -> None:
    brief = read_brief("A cosy reading corner.")
    assert brief.room_type == "reading_corner"
    assert brief.style == ("cosy",)
    assert {"armchair", "floor_lamp", "bookcase"} <= {r.category for r in brief.requests}
    assert not any(r.asked for r in brief.requests)


def test_named_objects_are_not_added_to() -> None:
    assert all(r.asked for r in read_brief("A bedroom with a bed and a chair.").requests)


def test_an_empty_room_stays_empty() -> None:
    assert read_brief("An empty room.").requests == ()
    assert read_brief("A bedroom with nothing in it.").empty


@pytest.mark.parametrize(
    ("prompt", "size"),
    [
        ("a bedroom, 4 m by 5 m", (4.0, 5.0, None)),
        ("a 4x5m bedroom", (4.0, 5.0, None)),
        ("a 400 x 500 cm bedroom", (4.0, 5.0, None)),
        ("a 12 ft x 15 ft bedroom", (3.6576, 4.572, None)),
        ("a bedroom, 12'6\" x 15'", (3.81, 4.572, None)),
        ("a bedroom of four by five metres", (4.0, 5.0, None)),
        ("a room 3 meters wide and 4 meters long with a bed", (3.0, 4.0, None)),
        ("a studio of 18 square metres", (None, None, 18.0)),
        ("a 20 sqm studio", (None, None, 20.0)),
        ("a studio of 20 m² with a bed", (None, None, 20.0)),
        ("ein Zimmer, 4,5 m mal 5 m, mit einem Bett", (4.5, 5.0, None)),
        ("une chambre de 12 m2 avec un lit", (None, None, 12.0)),
    ],
)
def test_sizes(prompt: str, size: tuple[float | None, ...]) -> None:
    brief = read_brief(prompt)
    assert (brief.width, brief.depth, brief.area) == pytest.approx(size)


def test_a_size_of_an_object_is_not_the_rooms() -> None:
    brief = read_brief("A living room with a 2 m sofa and a rug of 2 x 3 m.")
    assert (brief.width, brief.area) == (None, None)
    assert brief.unknown == ()
    assert {r.category: r.size for r in brief.requests if r.asked} == {
        "sofa": (None, 2.0, None),
        "rug": (2.0, 3.0, None),
    }


def test_openings() -> None:
    brief = read_brief("A bedroom with a bed, a window on the north wall, two doors and no rug.")
    assert [(o.kind, o.wall, o.count) for o in brief.openings] == [("window", "north_wall", 1), ("door", "", 2)]
    assert [o.count for o in read_brief("A bedroom without windows.").openings] == [0]


def test_what_is_refused_is_neither_asked_nor_assumed() -> None:
    categories = {r.category for r in read_brief("A living room without a TV.").requests}
    assert "sofa" in categories
    assert not categories & {"tv", "wall_tv"}
    assert counted(read_brief("A bedroom with a bed but no rug, and a desk.")).keys() == {"bed", "desk", "office_chair"}


def test_unknown_things_are_things_under_their_own_names() -> None:
    brief = read_brief("A bedroom with a bed, a frobnicator and two gizmotrons.")
    assert brief.missing == ()
    assert counted(brief) == {"bed": 1, "frobnicator": 1, "gizmotron": 2}
    assert brief.request("bed").unshown == ()
    assert read_brief("A bedroom with a squibbly bed.").request("bed").unshown == ("squibbly",)


def test_too_many_are_listed_not_lost() -> None:
    brief = read_brief("A room with 1000 chairs.")
    assert counted(brief) == {"chair": 200}
    assert (brief.missing, brief.beyond) == ((), ("800 more of '1000 chairs'",))


def test_every_category_is_in_the_catalogue() -> None:
    habits = load_habits()
    nouns = {e.value for code in LANGUAGES for es in load(code).phrases.values() for e in es if e.sort == "object"}
    nouns |= {anchor for noun in habits.known() for habit in habits.of(noun) for anchor in habit.anchors}
    nouns |= set(habits.known()) | {sense.category for noun in things() for sense in senses_of(noun)}
    assert nouns - PLACES - set(GENERAL_WORDS) <= set(CATALOGUE)


def test_rooms_hold_only_things_with_a_shape_of_their_own() -> None:
    usual = {u.category for kind in room_types().values() for u in (*kind.usual, *kind.expected)}
    assert {noun for noun in usual if stand_in(noun).how not in ("catalogue", "table")} == set()


def test_what_a_room_holds_is_tied_to_what_it_holds_before() -> None:
    for name, kind in room_types().items():
        for listed in (kind.usual, kind.expected):
            known = {*PLACES, ""}
            for usual in listed:
                assert all(known & set(anchor.split("|")) for _, anchor, _ in usual.relations), (name, usual)
                known.add(usual.category)


def test_every_room_type_is_known() -> None:
    rooms = {e.value for code in LANGUAGES for es in load(code).phrases.values() for e in es if e.sort == "room"}
    assert rooms <= set(room_types())


def test_small_things_are_those_the_catalogue_puts_on_surfaces() -> None:
    habits = load_habits()
    categories = set(habits.group("small")) - set(GENERAL_WORDS)
    assert {c for c in categories if CATALOGUE[c].mount != "surface"} == set()
