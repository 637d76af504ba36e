"""How people and benchmarks write: parts of several, chains of pronouns, places in the room, things we do not have."""

import pytest

from tests.test_reading import counted, related
from thinkblox.errors import InputError
from thinkblox.reading import read_brief

# prompt: objects asked for, relations, things that are missing
PROMPTS = {
    "A desk with a chair; next to it a bookcase, and on it a lamp.": (
        "1 desk, 1 chair, 1 bookcase, 1 desk_lamp",
        "chair at desk, bookcase next_to desk, desk_lamp on desk",
        "",
    ),
    "A living room with a sofa, a basket beside the sofa and a blanket on the sofa.": (
        "1 sofa, 1 basket, 1 blanket",
        "basket next_to sofa, blanket on sofa",
        "",
    ),
    "A dining room with a long table, 2 chairs on each long side and one at each end.": (
        "1 dining_table, 6 chair",
        "chair at_long_side dining_table, chair at_short_side dining_table",
        "",
    ),
    "A bedroom with two armchairs, one by the window and one by the door, and a bed.": (
        "2 armchair, 1 bed",
        "armchair next_to window, armchair next_to door",
        "",
    ),
    "A sofa with a lamp on either side and a picture above it.": (
        "1 sofa, 2 floor_lamp, 1 picture",
        "floor_lamp left_of sofa, floor_lamp right_of sofa, picture above sofa",
        "",
    ),
    "A bar with a bar counter and five stools, a shelf with bottles behind the counter, and a jukebox in the corner.": (
        "1 bar_counter, 5 bar_stool, 1 shelving_unit, 3 bottle, 1 jukebox",
        "bottle inside shelving_unit, shelving_unit behind bar_counter, jukebox in_corner corner",
        "",
    ),
    "A living room with a pouffe in front of the armchair and coat hooks by the entrance.": (
        "1 ottoman, 1 armchair, 1 coat_hooks",
        "ottoman in_front_of armchair, coat_hooks next_to door",
        "",
    ),
    "A bookstore with a cash desk by the entrance, six bookcases along the north wall, and a reading table with "
    "two chairs in the north-east corner.": (
        "1 counter, 6 bookcase, 1 display_table, 2 chair",
        (
            "counter next_to door, bookcase against_wall north_wall, chair around display_table, display_table "
            "in_corner north_wall east_wall"
        ),
        "",
    ),
    "Laundry: washer, dryer next to it, shelf above both with detergent bottles, hamper.": (
        "1 washing_machine, 1 dryer, 1 wall_shelf, 3 detergent_bottle, 1 laundry_basket",
        "dryer next_to washing_machine, wall_shelf above dryer washing_machine, detergent_bottle on wall_shelf",
        "",
    ),
    "A hospital room with two beds separated by a curtain, a nightstand next to each bed, a TV mounted on the "
    "wall opposite the beds, and a visitor chair.": (
        "2 hospital_bed, 1 curtain, 2 nightstand, 1 wall_tv, 1 visitor_chair",
        "curtain between hospital_bed, nightstand next_to hospital_bed, wall_tv opposite hospital_bed",
        "",
    ),
    "The kitchen contains a refrigerator, an oven, a dishwasher and a sink, all lined up along the north wall. A "
    "dining table with four chairs is in the middle of the room. A pendant lamp hangs above the table.": (
        "1 fridge, 1 oven, 1 dishwasher, 1 sink, 1 dining_table, 4 chair, 1 pendant_lamp",
        (
            "fridge against_wall north_wall, oven against_wall north_wall, dishwasher against_wall "
            "north_wall, base_cabinet against_wall north_wall, chair around dining_table, dining_table "
            "in_centre centre, pendant_lamp above dining_table"
        ),
        "",
    ),
    "A cafe with a counter, an espresso machine and a cake display on it, a menu board behind it, five round "
    "tables with two chairs each and a potted plant by the entrance.": (
        "1 counter, 1 coffee_machine, 1 cake_display, 1 menu_board, 5 dining_table, 10 chair, 1 potted_plant",
        (
            "coffee_machine on counter, cake_display on counter, menu_board behind counter, chair around "
            "dining_table, potted_plant next_to door"
        ),
        "",
    ),
    "There is a desk in front of the window, with a laptop and a cup of coffee on it. A bookshelf filled with "
    "books is to the right of the desk.": (
        "1 desk, 1 laptop, 1 cup, 1 bookcase",
        "desk in_front_of window, laptop on desk, cup on desk, bookcase right_of desk",
        "",
    ),
    "Place a bed against the wall. Put two pillows on it. Put a nightstand to the left of the bed and a lamp on it.": (
        "1 bed, 2 pillow, 1 nightstand, 1 table_lamp",
        "bed against_wall wall, pillow on bed, nightstand left_of bed, table_lamp on nightstand",
        "",
    ),
    "A dentist's office with a dentist chair in the middle, a cabinet, a sink, a stool and a lamp above the chair.": (
        "1 dentist_chair, 1 cabinet, 1 washbasin, 1 stool, 1 pendant_lamp",
        "dentist_chair in_centre centre, pendant_lamp above dentist_chair",
        "",
    ),
    "A restaurant with ten tables: six round tables with four chairs each and four square tables with two chairs "
    "each.": (
        "10 dining_table, 32 chair",
        "chair around dining_table",
        "",
    ),
    "A living room: sofa against the left wall, TV stand against the right wall, TV on it, coffee table between "
    "them.": (
        "1 sofa, 1 tv_stand, 1 tv, 1 coffee_table",
        (
            "sofa against_wall left_wall, tv_stand against_wall right_wall, tv on tv_stand, coffee_table "
            "between sofa tv_stand"
        ),
        "",
    ),
    "A pharmacy with shelves of medicine bottles along the walls, a counter with a computer and a cash register, "
    "and three chairs for waiting.": (
        "4 shelving_unit, 3 medicine_bottle, 1 counter, 1 computer, 1 cash_register, 3 chair",
        (
            "medicine_bottle inside shelving_unit, shelving_unit against_wall wall, computer on counter, "
            "cash_register on counter"
        ),
        "",
    ),
    "A dorm room for two students: two beds, two desks with chairs and lamps, two wardrobes.": (
        "2 bed, 2 desk, 2 chair, 2 desk_lamp, 2 wardrobe",
        "chair at desk, desk_lamp on desk",
        "",
    ),
    "A study with a large desk in the centre of the room, a leather chair behind it, two chairs in front of it, "
    "and bookcases covering the back wall.": (
        "1 executive_desk, 3 chair, 2 bookcase",
        (
            "executive_desk in_centre centre, chair behind executive_desk, chair in_front_of executive_desk, "
            "bookcase against_wall far_wall"
        ),
        "",
    ),
    "A dining room with a table that seats ten, a china cabinet and a bar cart.": (
        "1 dining_table, 1 china_cabinet, 1 bar_cart",
        "",
        "",
    ),
    "A hotel room with twin beds, a nightstand between them with a phone and a lamp on it, a desk with a chair, a"
    " luggage rack, and a safe in the wardrobe.": (
        "2 bed, 1 nightstand, 1 phone, 1 table_lamp, 1 desk, 1 chair, 1 safe, 1 wardrobe, 1 luggage_rack",
        ("nightstand between bed, phone on nightstand, table_lamp on nightstand, chair at desk, safe inside wardrobe"),
        "",
    ),
    "A bookshelf stands against the wall with a globe on the top shelf and three books on the middle shelf.": (
        "1 bookcase, 1 globe, 3 book",
        "bookcase against_wall wall, globe inside bookcase, book inside bookcase",
        "",
    ),
    "Create a bedroom. It needs a bed, a desk with a laptop, a chair tucked under the desk, and a trash can "
    "beside the desk.": (
        "1 bed, 1 desk, 1 laptop, 1 chair, 1 waste_bin",
        "laptop on desk, chair at desk, waste_bin next_to desk",
        "",
    ),
    "Kitchen. Fridge in the corner. Stove next to the fridge. Sink next to the stove. Table in the middle with 2 "
    "chairs on opposite sides.": (
        "1 fridge, 1 stove, 1 sink, 1 kitchen_table, 2 chair",
        (
            "fridge in_corner corner, stove next_to fridge, base_cabinet next_to stove, kitchen_table "
            "in_centre centre, chair around kitchen_table"
        ),
        "",
    ),
    "A tea room with four low tables, each with four floor cushions around it, and a teapot and two cups on each "
    "table.": (
        "4 coffee_table, 16 floor_cushion, 4 teapot, 8 cup",
        "floor_cushion around coffee_table, teapot on coffee_table, cup on coffee_table",
        "",
    ),
    "Living room with sofa (3 seats), armchair x2, coffee table, TV unit w/ 55 inch TV, 2x bookcase, floor lamp": (
        "1 sofa, 2 armchair, 1 coffee_table, 1 tv_stand, 1 tv, 2 bookcase, 1 floor_lamp",
        "tv on tv_stand",
        "",
    ),
    "A bedroom with a crib next to the double bed and a dresser opposite it, with a TV on the dresser.": (
        "1 crib, 1 bed, 1 dresser, 1 tv",
        "crib next_to bed, dresser opposite bed, tv on dresser",
        "",
    ),
    "In the middle of the room there is a double bed with a nightstand on both sides. Opposite the bed there is a"
    " dresser with a television. In the far right corner stands a plant.": (
        "1 bed, 2 nightstand, 1 dresser, 1 tv, 1 plant",
        (
            "bed in_centre centre, nightstand left_of bed, nightstand right_of bed, dresser opposite bed, "
            "tv on dresser, plant "
            "in_corner far_wall right_wall"
        ),
        "",
    ),
    "A kitchen with an apple, a knife and a cutting board on the counter, and a trash bin next to the fridge.": (
        "1 apple, 1 knife, 1 cutting_board, 1 base_cabinet, 1 waste_bin, 1 fridge",
        "apple on base_cabinet, knife on base_cabinet, cutting_board on base_cabinet, waste_bin next_to fridge",
        "",
    ),
    "Two single beds with a shared nightstand, a double desk with two chairs, and two wardrobes on the opposite wall": (
        "2 bed, 1 nightstand, 1 desk, 2 chair, 2 wardrobe",
        "nightstand between bed, chair at desk, wardrobe against_wall opposite_wall",
        "",
    ),
    "A court room with a judge's desk and twelve chairs in two rows to the left of it.": (
        "1 desk, 12 chair",
        "chair in_rows, chair left_of desk",
        "",
    ),
    "A bookstore. Four tall bookshelves line the back wall. In the center, two display tables, each with three "
    "stacks of books. The checkout counter is on the right side near the entrance with a cash register on top. "
    "Two armchairs and a small table between them form a reading area in the left corner.": (
        "4 bookcase, 2 display_table, 6 book_stack, 1 counter, 1 cash_register, 2 armchair, 1 coffee_table",
        (
            "bookcase against_wall far_wall, display_table in_centre centre, book_stack on display_table, "
            "counter against_wall right_wall, counter near door, cash_register on counter, coffee_table "
            "between armchair, coffee_table in_corner left_wall"
        ),
        "",
    ),
    "hospital ward 8m x 6m, 4 beds along the long wall, each with a bedside table, curtains between beds, sink by"
    " the door": (
        "4 hospital_bed, 4 nightstand, 3 curtain, 1 washbasin",
        (
            "hospital_bed against_wall long_wall, nightstand next_to hospital_bed, curtain between "
            "hospital_bed, washbasin next_to door"
        ),
        "",
    ),
    "Classroom: 3 rows of 5 desks with chairs, all facing the blackboard; teacher's desk in front of the "
    "blackboard with an apple and a laptop on it; cabinet in the back corner; two windows on the left wall.": (
        "15 school_desk, 16 chair, 1 blackboard, 1 desk, 1 apple, 1 laptop, 1 cabinet",
        (
            "school_desk in_rows, chair at school_desk, school_desk facing blackboard, desk in_front_of "
            "blackboard, laptop on desk, cabinet in_corner far_wall"
        ),
        "",
    ),
    "A laundry room with two washing machines next to each other, a dryer on the right of them, a shelf above the"
    " machines with detergent and a basket.": (
        "2 washing_machine, 1 dryer, 1 wall_shelf, 1 detergent, 1 basket",
        (
            "washing_machine next_to washing_machine, dryer right_of washing_machine, "
            "wall_shelf above washing_machine dryer"
        ),
        "",
    ),
    "A nursery with a crib against the wall, a rocking chair next to the crib, a small table with a lamp between "
    "them, a dresser opposite the crib, and a round rug in the middle of the room with three toys on it.": (
        "1 crib, 1 rocking_chair, 1 play_table, 1 table_lamp, 1 dresser, 1 rug, 3 toy",
        (
            "crib against_wall wall, rocking_chair next_to crib, table_lamp on play_table, play_table between"
            " rocking_chair crib, dresser opposite crib, rug in_centre centre, toy on rug"
        ),
        "",
    ),
    "A meeting room with a rectangular table, four chairs on each side and one at each end, a TV on the wall at "
    "the end of the table, and a whiteboard next to the door.": (
        "1 conference_table, 10 chair, 1 wall_tv, 1 whiteboard",
        "chair at_long_side conference_table, wall_tv near conference_table, whiteboard next_to door",
        "",
    ),
    "Living room with fireplace; two sofas facing each other in front of the fireplace, rug between them, coffee "
    "table on the rug, bookcases on both sides of the fireplace.": (
        "1 fireplace, 2 sofa, 1 rug, 1 coffee_table, 2 bookcase",
        (
            "sofa facing sofa, sofa in_front_of fireplace, rug between sofa, rug under coffee_table, bookcase"
            " left_of fireplace, bookcase right_of fireplace"
        ),
        "",
    ),
    "A reception with a desk, two chairs in front of it and one behind it, a sofa along the wall, and a plant on "
    "each side of the sofa.": (
        "1 reception_desk, 3 chair, 1 sofa, 2 plant",
        (
            "chair in_front_of reception_desk, chair behind reception_desk, sofa against_wall wall, "
            "plant left_of sofa, plant right_of sofa"
        ),
        "",
    ),
    "A bedroom containing one double bed, one wardrobe with a suitcase on top, one desk with one lamp and one "
    "chair, and one window.": (
        "1 bed, 1 wardrobe, 1 suitcase, 1 desk, 1 desk_lamp, 1 chair",
        "suitcase on wardrobe, desk_lamp on desk, chair at desk",
        "",
    ),
    "A bar: long counter with 8 stools in front of it, shelves with 12 bottles behind it, 2 pool tables, dart "
    "board on the left wall.": (
        "1 counter, 8 bar_stool, 2 shelving_unit, 12 bottle, 2 pool_table, 1 dart_board",
        (
            "bar_stool in_front_of counter, bottle inside shelving_unit, shelving_unit behind counter, dart_board"
            " on left_wall"
        ),
        "",
    ),
    "Bookshelf, left of it armchair, right of it plant.": (
        "1 bookcase, 1 armchair, 1 plant",
        "armchair left_of bookcase, plant right_of bookcase",
        "",
    ),
    "A kitchen where the fridge stands between the oven and the dishwasher, a window above the sink, and an "
    "island in the middle with a bowl, two cups and a kettle on it.": (
        "1 fridge, 1 oven, 1 dishwasher, 1 sink, 1 kitchen_island, 1 bowl, 2 cup, 1 kettle",
        (
            "oven next_to fridge, dishwasher next_to fridge, kitchen_island in_centre centre, bowl on "
            "kitchen_island, cup on kitchen_island, kettle on kitchen_island"
        ),
        "",
    ),
    "An open office for eight people, with desks in two rows facing each other, a monitor and a keyboard on each "
    "desk, an office chair at each desk, a printer and a water cooler.": (
        "8 desk, 8 monitor, 8 keyboard, 8 office_chair, 1 printer, 1 water_dispenser",
        "desk in_rows, desk facing desk, monitor on desk, keyboard on desk, office_chair at desk",
        "",
    ),
    "A living room with a corner sofa in the far left corner, a square coffee table in front of it, a TV "
    "opposite, a floor lamp between the sofa and the window, and six framed pictures above the sofa.": (
        "1 sofa, 1 coffee_table, 1 tv, 1 floor_lamp, 6 picture",
        (
            "sofa in_corner far_wall left_wall, coffee_table in_front_of sofa, tv opposite sofa, floor_lamp "
            "next_to window, floor_lamp next_to sofa, picture above sofa"
        ),
        "",
    ),
    "A dining table, eight chairs: three on each side and one at each end.": (
        "1 dining_table, 8 chair",
        "chair at_long_side dining_table",
        "",
    ),
    "Una camera da letto con un letto matrimoniale, due comodini con una lampada su ciascuno e un armadio contro "
    "la parete.": (
        "1 bed, 2 nightstand, 2 table_lamp, 1 wardrobe",
        "table_lamp on nightstand, wardrobe against_wall wall",
        "",
    ),
    "Un soggiorno con un divano, un tavolino davanti al divano, due poltrone, una libreria e un tappeto rotondo.": (
        "1 sofa, 1 coffee_table, 2 armchair, 1 bookcase, 1 rug",
        "coffee_table in_front_of sofa",
        "",
    ),
    "Una cucina di 4 x 3 m con un tavolo e quattro sedie intorno al tavolo, un frigorifero nell'angolo e un "
    "lavello sotto la finestra.": (
        "1 kitchen_table, 4 chair, 1 fridge, 1 sink",
        "chair around kitchen_table, fridge in_corner corner",
        "",
    ),
    "Um quarto com uma cama de casal, duas mesas de cabeceira e um guarda-roupa.": (
        "1 bed, 2 nightstand, 1 wardrobe",
        "",
        "",
    ),
    "Uma sala de estar com um sofá, uma mesa de centro na frente do sofá, uma televisão e um tapete redondo.": (
        "1 sofa, 1 coffee_table, 1 tv, 1 rug",
        "coffee_table in_front_of sofa",
        "",
    ),
    "Um escritório com duas escrivaninhas, um computador em cada uma e uma planta no canto.": (
        "2 desk, 2 computer, 1 plant",
        "computer on desk, plant in_corner corner",
        "",
    ),
    "Een slaapkamer met een tweepersoonsbed, twee nachtkastjes en een kledingkast.": (
        "1 bed, 2 nightstand, 1 wardrobe",
        "",
        "",
    ),
    "Een woonkamer met een bank tegen de muur, een salontafel voor de bank, twee fauteuils en een plant in de hoek.": (
        "1 sofa, 1 coffee_table, 2 armchair, 1 plant",
        "sofa against_wall wall, coffee_table in_front_of sofa, plant in_corner corner",
        "",
    ),
}


@pytest.mark.parametrize(("prompt", "expected"), PROMPTS.items())
def test_prompts_nobody_has_seen_are_read(prompt: str, expected: tuple[str, str, str]) -> None:
    objects, relations, missing = expected
    brief = read_brief(prompt)
    asked = {r.category for r in brief.requests if r.asked}
    assert {c: n for c, n in counted(brief).items() if c in asked} == _counts(objects)
    assert {r for r in relations.split(", ") if r} <= related(brief)
    assert "; ".join((*brief.missing, *brief.beyond)) == missing


def _counts(text: str) -> dict[str, int]:
    return {name: int(number) for number, name in (item.split() for item in text.split(", ") if item)}


def test_a_language_we_do_not_read_is_refused() -> None:
    with pytest.raises(InputError, match="Dutch"):
        read_brief("Sypialnia z dużym łóżkiem, szafą, biurkiem i krzesłem przy oknie.")


@pytest.mark.parametrize(
    ("prompt", "sizes"),
    [
        ("A 2 m long sofa and a 65-inch TV.", {"sofa": (None, 2.0, None), "tv": (None, 1.44, 0.869)}),
        ("A desk, 1.6 m wide and 0.8 m deep.", {"desk": (0.8, 1.6, None)}),
        (
            "A bed (1.6 x 2 m) and a 1.2 x 0.8 m coffee table.",
            {"bed": (2.0, 1.6, None), "coffee_table": (0.8, 1.2, None)},
        ),
        ("A bookcase 2 m tall.", {"bookcase": (None, None, 2.0)}),
        ("A round table 1.2 m in diameter.", {"dining_table": (1.2, 1.2, None)}),
    ],
)
def test_sizes_of_things(prompt: str, sizes: dict[str, tuple[float | None, ...]]) -> None:
    assert {r.category: r.size for r in read_brief(prompt).requests if any(r.size)} == sizes
