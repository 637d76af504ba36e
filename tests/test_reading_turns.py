"""Turns of speech: what is followed, and what is said not to be, so that no room is called all as asked for it."""

import pytest

from thinkblox.assets.palette import COLOURS
from thinkblox.brief import Brief
from thinkblox.reading import read_brief


def counted(brief: Brief) -> dict[str, int]:
    """How many of each category the prompt asks for."""
    counts: dict[str, int] = {}
    for request in brief.requests:
        if request.asked:
            counts[request.category] = counts.get(request.category, 0) + request.count
    return counts


def related(brief: Brief) -> set[str]:
    """What was asked for of each thing: "2 chair behind desk"."""
    return {
        " ".join([str(brief.request(r.subject).count), r.subject, r.kind, *r.anchors])
        for r in brief.relations
        if r.asked
    }


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        (
            "Three tables. Each table has four chairs, two on each long side, and two green lamps.",
            "12 chair, 6 table_lamp",
        ),
        (
            "Living room with a rug, two armchairs (no, three armchairs) and a bookcase.",
            "1 rug, 3 armchair, 1 bookcase",
        ),
        ("Put a bed against the wall. Actually, make it a bunk bed. A desk.", "1 bunk_bed, 1 desk"),
        ("A double bed, no, make that two single beds, and a wardrobe.", "2 bed, 1 wardrobe"),
        ("A dining table with six chairs. Actually, eight.", "1 dining_table, 8 chair"),
        ("An office with five booths; a booth is a desk with two stools. A printer.", "5 desk, 10 stool, 1 printer"),
        ("Four reading spots: each spot consists of an armchair and a floor lamp.", "4 armchair, 4 floor_lamp"),
        ("A florist with five buckets of tulips, three of roses and one with lilies.", "9 flower_bucket"),
        ("Six lockers on the left and as many on the right.", "12 locker"),
        ("A stack of six books on a desk.", "6 book, 1 desk"),
        ("Eight bar stools; every other stool has a coat on it.", "8 bar_stool, 4 coat"),
        ("Two chairs in front of the desk, one behind it.", "3 chair, 1 executive_desk"),
        ("Twelve chairs; every third chair has a book on it.", "12 chair, 4 book"),
        (
            "Three desks, behind each an office chair and in front of each two stools.",
            "3 executive_desk, 3 office_chair, 6 stool",
        ),
        ("A cue rack. This holds five cues; the sixth lies on the pool table.", "1 cue_rack, 6 cue"),
        ("A dining table with six chairs per side, one at the head.", "1 dining_table, 13 chair"),
        ("Two chairs at the table. Another two chairs by the window, one more by the door.", "5 chair"),
        ("Five chairs: two by the window and three others at the table.", "5 chair"),
        ("Four desks with a chair each. There are two extra chairs along the wall.", "4 desk, 6 chair"),
        ("A bench and a sofa. Both have two cushions.", "1 bench, 1 sofa, 4 pillow"),
        ("A red chair and a blue chair, each with a cushion, and a table.", "2 chair, 2 pillow"),
        ("Rehearsal room. Mic stands: three. Two by the window and the other one near the door.", "3 microphone_stand"),
        ("Plants? Two, by the window.", "2 plant"),
        ("Eight stools along a counter, and for every two stools one bowl.", "8 bar_stool, 4 bowl"),
        ("Three benches; on each bench two towels, under each one sports bag.", "6 towels, 3 sports_bag"),
        ("Three shelves; every shelf holds four boxes, plus one more box that fell on the floor.", "13 box"),
        ("A four-bed ward. Every bed has a locker on its left.", "4 hospital_bed, 4 locker"),
        ("A bed and a wardrobe. Forget the wardrobe.", "1 bed"),
        ("A bed with nightstands and lamps.", "1 bed, 2 nightstand, 2 table_lamp"),
        ("A clothes shop with two fitting rooms and a counter.", "2 changing_cubicle, 1 counter"),
        ("Like a mountain hut: fireplace going, boots drying.", "1 fireplace, 3 boots"),
        ("Four beds. Every bed has a locker on its left, a table and a chair.", "4 locker, 4 side_table, 4 chair"),
        ("Four desks, each with a laptop, and four chairs.", "4 desk, 4 laptop, 4 chair"),
        ("A desk with a bookcase behind it and two guest chairs in front of it.", "1 executive_desk, 2 visitor_chair"),
        ("Two guitar amps. The bass amp, nah, leave it out.", "2 guitar_amp"),
        ("Twelve acoustic panels on the walls, 6 grey and 6 orange.", "12 acoustic_panel"),
        ("3 rows of 4 desks, one printer per row.", "12 desk, 3 printer"),
        ("I teach art. My classroom has eight easels.", "8 easel"),
        ("A Franka arm and a UR5 arm on a workbench.", "2 robot_arm"),
    ],
)
def test_so_many_are_read(prompt: str, counts: str) -> None:
    brief = read_brief(prompt, fill="named")
    wanted = {category: int(count) for count, category in (item.split() for item in counts.split(", "))}
    assert {category: counted(brief).get(category) for category in wanted} == wanted
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("Nine chairs: four along the left wall, four along the right wall and the ninth by the door.",
         "1 chair-3 next_to door"),
        ("A console table, a basket to its left and, to its right, a sofa.", "1 sofa right_of console_table"),
        ("Two beds, a blue rug under one and a red one under the other.", "1 rug-2 under bed-2"),
        ("Two beds, blue bedding on one and yellow on the other.", "1 bedding-2 on bed-2"),
        ("A kitchen: fridge in the corner, then a stove, then a sink.", "1 stove next_to fridge"),
        ("Four bookcases. The first two hold five boxes each, the third three vases.", "3 vase inside bookcase-2"),
        ("An aquarium in the middle, two armchairs, one on the left and one on the right of it.",
         "1 armchair left_of aquarium"),
        ("A bistro: the table has six chairs, of which two are at the ends.", "2 chair at_short_side dining_table"),
        ("Two benches, a stove, and boxes under both.", "3 box under bench"),
        ("A playroom with two tents. One tent is red and has a lantern in it; in the blue tent there are two pillows.",
         "2 pillow inside play_tent-2"),
        ("A washing machine and a basket of towels in front.", "1 basket in_front_of washing_machine"),
        ("An island and a counter. Three stools at the island, each with a cushion on it, and two mugs on the counter.",
         "2 cup on counter"),
        ("A desk with a chair behind it, and there are two more in front of it.",
         "2 chair-2 in_front_of executive_desk"),
        ("Two chairs stand at a round table with a vase on it. Another two are by the window.",
         "2 chair-2 next_to window"),
        ("A sofa with a lamp beside it and another in the corner.", "1 floor_lamp-2 in_corner corner"),
        ("A dresser with a mirror above it, and there is another one above the bed.", "1 mirror-2 above bed"),
        ("A chair is behind the desk and two others stand by the window.", "2 chair-2 next_to window"),
        ("A stove, a fridge and a counter. The fridge is left of the stove, the counter right of it.",
         "1 counter right_of stove"),
        ("The mirror is above the sink, the cabinet under it.", "1 cabinet under counter"),
        ("A sofa and two armchairs. One armchair is by the window, the other by the door. Between them a table.",
         "1 coffee_table between armchair armchair-2"),
        ("The drums? In the corner.", "2 drum in_corner corner"),
        ("A drum kit in the corner, an amp left of the drums.", "1 amp left_of drum_kit"),
        ("A drum kit against the back wall, on a rug.", "1 drum_kit against_wall far_wall"),
        ("A lamp by the window, on a table.", "1 dining_table next_to window"),
        ("An office chair in front of the desk and facing it, a lamp by the door.", "1 office_chair facing desk"),
        ("A fridge for the medicines, a small one. It sits under the counter.", "1 fridge under counter"),
        ("A fridge, a dishwasher and a cabinet along the walls.", "1 fridge against_wall wall"),
        ("Three long tables. One of them should stand near the window, the others in the corner.",
         "1 dining_table near window"),
        ("Three manicure tables, on every table a lamp and five nail polishes, a chair on both sides of each.",
         "6 chair next_to manicure_table"),
        ("A couch has two pillows; the coffee table two magazines and a candle.", "2 magazine on coffee_table"),
        ("On either side of the fireplace is a bookcase, and above it a painting.", "1 picture above fireplace"),
        ("Distractors on the counter: two apples and a banana.", "2 apple on counter"),
        ("Two tables. One has four chairs around it. On the other are three vases.", "3 vase on dining_table-2"),
        ("Two desks. One has two monitors on it. The other has a lamp.", "1 desk_lamp on desk-2"),
        ("Two shelves. One holds ten books. The second one holds six cups.", "6 cup inside shelving_unit"),
        ("Two shelves; the first holds eight soup cans, the second one six bags of chips.",
         "6 bag_of_chips inside shelving_unit-2"),
        ("Two beds. One stands by the window. A lamp hangs above the other.", "1 pendant_lamp above bed-2"),
        ("Two desks. Mine has a plant on it, his has two mugs.", "2 cup on desk-2"),
        ("My desk is by the window, his is by the door.", "1 desk-2 next_to door"),
        ("A red chair and a blue chair. A cushion lies on the red one, a bag on the other.", "1 handbag on chair-2"),
        ("The table has two chairs, a red one and a blue one. A cushion is on the red one and a bag on the other.",
         "1 handbag on chair-2"),
        ("A mug and a plate are on the table with the mug to the left of the plate.", "1 cup left_of plate"),
        ("On the desk are a laptop and a lamp, and the lamp is to the right of the laptop.",
         "1 desk_lamp right_of laptop"),
        ("Her bed stands by the window, his bed by the door.", "1 bed-2 next_to door"),
        ("A sofa facing the TV. The TV stands on a low cabinet with a soundbar.", "1 tv on sideboard"),
        ("A medicine cabinet hangs above the sink. Inside it are ten bottles.", "10 bottle inside wall_cabinet"),
        ("Behind the counter a tall medicine cabinet stands; ten bottles are inside it.", "10 bottle inside cabinet"),
    ],
)  # fmt: skip
def test_who_stands_where_is_read(prompt: str, relations: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert relations in related(brief)
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "said"),
    [
        ("Two chairs left of the hearth, and the same again on the right.", "the same again on the right"),
        ("Ten desks; four desks out of every five have a lamp.", "out of every five"),
        ("A vase on the piano. Move the vase to the window.", "Move the vase to the window"),
        ("A sofa. Actually, I would rather have less.", "Actually , I would rather have less"),
        ("A desk with a lamp. No, make that a piano.", "No , make that a piano"),
        ("A wardrobe where the desk would usually be, and a rug.", "where the desk would usually be"),
        ("A rug shaped like a star and a bed.", "shaped like a star"),
        ("A tripod 2 m in front of the desk.", "2 m"),
        ("Three benches, a vase on the first, and nothing on the last.", "nothing on the last"),
        ("A stand beside each bed of two beds except the one nearest the door.", "except the one nearest the door"),
        ("An island with four stools on the far side.", "on the far side"),
        ("A chair either by the window or at the foot of the bed.", "or at the foot of the bed"),
        ("A table and four chairs, then take one away.", "take one away"),
        ("Wine glasses at four of the places.", "at four of the places"),
        ("Two desks in the back row have no chairs.", "in the back row"),
        ("A dining table, a rug under everything.", "under everything"),
        ("A jam jar whose lid is off.", "whose lid is off"),
        ("A sofa and four speakers around the room.", "around the room"),
        ("Plants throughout the room.", "throughout the room"),
        ("A fireplace and a sofa slightly angled towards the fireplace.", "slightly angled"),
        ("A clock leaning against the wall.", "leaning"),
        ("A shop with shelves and half as many stools as shelves.", "half as many stools as shelves"),
        ("Two sofas parallel to each other.", "parallel to each other"),
        ("Two benches. The benches are parallel.", "parallel"),
    ],
)
def test_what_is_not_followed_is_said(prompt: str, said: str) -> None:
    assert said in read_brief(prompt).unknown


@pytest.mark.parametrize("word", ["zorgle", "quibbet", "hampfel"])
def test_a_thing_that_nobody_knows_is_in_the_room_and_said(word: str) -> None:
    brief = read_brief(f"A bedroom with a bed and a {word}.")
    assert word in counted(brief)
    assert brief.unknown == (f"a {word} (no such thing is known)",)


def test_one_thing_of_two_colours_is_said() -> None:
    assert read_brief("A red chair. The chair is blue.").unknown == ("A red chair: red or blue",)
    assert read_brief("A chair that is black and white.").unknown == ()


@pytest.mark.parametrize(
    "prompt",
    [
        "Two suitcases, the smaller of which is open.",
        "Three tables. The largest table has six chairs.",
        "Two armchairs; the bigger one is leather.",
    ],
)
def test_the_larger_of_several_is_one_of_them_and_its_size_is_no_thing(prompt: str) -> None:
    brief = read_brief(prompt, fill="named")
    marked = [r for r in brief.requests if r.unshown]
    assert [r.count for r in marked] == [1]
    assert marked[0].unshown[0] in ("smaller", "largest", "bigger")
    assert not {"smaller", "largest", "bigger"} & set(counted(brief))


def test_the_larger_is_the_one_that_was_called_large() -> None:
    brief = read_brief("A large table and a small table. A vase stands on the larger table.", fill="named")
    carriers = [r.anchors for r in brief.relations if r.kind == "on"]
    assert [brief.request(anchors[0]).attributes for anchors in carriers] == [("large",)]


@pytest.mark.parametrize(
    "prompt",
    [
        "A bedroom, no television. No mirror, no wardrobe, just a bed.",
        "Make it cosy: a sofa and two lamps.",
        "We wait in a hall with two benches.",
        "Three high tables with two stools each.",
        "A soft pink armchair and a rug.",
        "A workshop: (a) a workbench; (b) a stool.",
    ],
)
def test_plain_words_are_no_turns(prompt: str) -> None:
    assert read_brief(prompt).unknown == ()


@pytest.mark.parametrize(
    "how", ["parallel to", "perpendicular to", "diagonal to", "at right angles to", "aligned with", "in line with"]
)
def test_how_things_are_turned_to_others_is_said_and_they_stay_themselves(how: str) -> None:
    brief = read_brief(f"A pantry with a barrel {how} the shelf and a bench {how} the shelf.", fill="named")
    assert counted(brief) == {"barrel": 1, "bench": 1, "shelving_unit": 1}
    assert brief.unknown == (f"{how} the shelf",) * 2 or brief.unknown == (f"{how} the shelf",)
    assert related(brief) == set()


def test_what_hangs_along_the_wall_is_on_it() -> None:
    brief = read_brief("A workshop with two pictures hung along the wall.", fill="named")
    assert related(brief) == {"2 picture on wall"}
    assert brief.unknown == ()


@pytest.mark.parametrize(
    "denial", ["where no desk faces a window", "and no desk facing the window", "and no desk stands next to a window"]
)
def test_what_is_denied_of_things_excludes_none_of_them(denial: str) -> None:
    brief = read_brief(f"An office with two desks and a printer, {denial}.", fill="named")
    assert counted(brief) == {"desk": 2, "printer": 1}
    assert brief.excluded == ()
    assert [(r.subject, r.anchors) for r in brief.relations if r.negated] == [("desk", ("window",))]


def test_what_is_denied_of_things_that_nobody_named_is_said() -> None:
    brief = read_brief("An office where no desk faces a window.")
    assert brief.unknown == ("no desk faces a window",)
    assert brief.excluded == ()
    assert not any(r.asked for r in brief.relations)


@pytest.mark.parametrize(
    ("prompt", "category", "looks"),
    [
        ("Two tables. One has four chairs around it. The other is round.", "dining_table-2", "round"),
        ("There are two desks. Mine is a cheap pine one. Hers is white.", "desk-2", "white"),
        ("Two mugs on the table, mine is blue, hers is pink.", "cup-2", "pink"),
        ("My bed is red, hers is blue.", "bed-2", "blue"),
        ("Two armchairs, hers and his. Hers is green and stands near the window. His is brown.", "armchair-2", "brown"),
    ],
)
def test_each_has_its_own_looks(prompt: str, category: str, looks: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert [word for word in brief.request(category).attributes if word in COLOURS or word == looks] == [looks]
    assert brief.unknown == ()


def test_all_but_some_look_as_is_said() -> None:
    brief = read_brief("Ten lockers against the wall, all but three are yellow.", fill="named")
    assert sorted((r.count, r.attributes) for r in brief.requests) == [(3, ()), (7, ("yellow",))]
