"""The second opinion: a reading that the order of the words speaks against is noticed, and a right one is not."""

from collections.abc import Callable

import pytest

from thinkblox.reading import read_brief
from thinkblox.reading.draft import Draft, Mention
from thinkblox.reading.english.chunker import cut
from thinkblox.reading.english.clauses import Clauses
from thinkblox.reading.english.second import SecondOpinion
from thinkblox.reading.language import lexicon_of


def _named(draft: Draft, word: str) -> Mention:
    return next(thing for thing in draft.things if thing.text.lower().endswith(word))


def _questions(text: str, spoil: Callable[[Draft], None] | None = None) -> list[str]:
    """What is open about the reading of a text, or about what somebody made of that."""
    lexicon = lexicon_of(text)
    tokens = lexicon.tokens(text)
    reader = Clauses(tokens, cut(lexicon, tokens)[0])
    draft = reader.read()
    if spoil is not None:
        spoil(draft)
    found = SecondOpinion(draft, reader.referents, reader.meant).disagreements(reader.cut)
    return [f"{reader.account.text(one.start, one.end)} ({one.question})" for one in found]


def _lose(noun: str) -> Callable[[Draft], None]:
    """Forget where a thing is."""

    def spoil(draft: Draft) -> None:
        thing = _named(draft, noun)
        draft.bonds = [bond for bond in draft.bonds if bond.subject is not thing]

    return spoil


def _hand(noun: str, to: str) -> Callable[[Draft], None]:
    """Say of one thing what was said of another."""

    def spoil(draft: Draft) -> None:
        thing = _named(draft, noun)
        for bond in draft.bonds_of(thing):
            draft.hand_over(bond, _named(draft, to))

    return spoil


def _share(noun: str, also: str) -> Callable[[Draft], None]:
    """Say of another thing too what was said of one."""

    def spoil(draft: Draft) -> None:
        for bond in draft.bonds_of(_named(draft, noun)):
            draft.bonds.append(type(bond)(bond.kind, _named(draft, also), bond.anchors))

    return spoil


def _count(noun: str, number: int | None) -> Callable[[Draft], None]:
    def spoil(draft: Draft) -> None:
        _named(draft, noun).count = number

    return spoil


def _turn(noun: str, to: str) -> Callable[[Draft], None]:
    """Relate something to another thing than was said."""

    def spoil(draft: Draft) -> None:
        for bond in draft.bonds_of(_named(draft, noun)):
            bond.anchors = (_named(draft, to),)

    return spoil


@pytest.mark.parametrize(
    ("text", "spoil", "question"),
    [
        # Where a thing is, and which thing it is.
        ("A bed. A lamp on a desk, a plant next to the bed.", _lose("plant"), "a plant next to the bed (where?)"),
        ("A sign above the shelves behind the counter.", _hand("shelves", "sign"),
         "the shelves behind the counter (where?)"),
        ("A sofa. On the desk is a lamp.", _turn("lamp", "sofa"), "On the desk (where?)"),
        ("A chair to the left of the bed.", lambda draft: setattr(draft.bonds[0], "kind", "right_of"),
         "A chair to the left of the bed (where?)"),
        ("A bed by the window and a desk against the wall.", _lose("desk"), "a desk against the wall (where?)"),
        ("A counter with a till is on the right.", _share("counter", "till"),
         "a till is on the right (which of them?)"),
        ("Behind the crib is a dresser, a basket under the dresser.",
         lambda draft: draft.bonds.append(type(draft.bonds[0])("behind", _named(draft, "basket"),
                                                               (_named(draft, "crib"),))),
         "Behind the crib (of what?)"),
        ("A television on a stand, a lamp opposite the stand.",
         lambda draft: draft.bonds.append(type(draft.bonds[0])("opposite", _named(draft, "stand"),
                                                               (_named(draft, "television"),))),
         "A television on a stand (where?)"),
        # What something has.
        ("A desk with a lamp and a clock.", _lose("clock"), "A desk with a lamp and a clock (where?)"),
        ("A desk with a lamp, a mug and a book.", _lose("book"), "A desk with a lamp , a mug and a book (where?)"),
        ("Four desks, each with two monitors.", _lose("monitors"), "Four desks , each with two monitors (where?)"),
        # How many.
        ("A sofa and three lamps.", _count("lamps", 4), "three lamps (how many?)"),
        ("A sofa and a rug.", _count("sofa", 2), "A sofa (how many?)"),
        ("Chairs on both sides of a table.", _count("chairs", 3), "Chairs on both sides of a table (how many?)"),
        ("A picture between two windows.", lambda draft: draft.openings.clear(), "two windows (how many?)"),
    ],
)  # fmt: skip
def test_what_the_words_speak_against_is_noticed(text, spoil, question):
    assert question in _questions(text, spoil)


def test_what_is_read_as_it_stands_there_leaves_no_question():
    for text in (
        "A table with four chairs around it, a vase on the table and a lamp above. Beside the door hangs a coat rack.",
        "Six desks in two rows, each with a monitor, a keyboard and a chair; a printer is on a cabinet by the door.",
        "A bedroom with a bed between two nightstands, each carrying a lamp, and a bench at the foot of the bed.",
        "Two sofas face each other across a coffee table; to the left of the one by the window is a plant.",
        "On the counter are a till and two jars, behind it a shelf full of bottles, in front of it four stools.",
        "Twelve chairs around an oval table; at each seat a plate, with a fork on its left and a knife on its right.",
        "A desk between the beds under a window. A stool with a towel beside the tub, a mirror over the sink.",
    ):
        assert not _questions(text), text


def _read(text: str) -> tuple[set[str], tuple[str, ...]]:
    """The relations of a brief with the numbers of their subjects, and what is not understood."""
    brief = read_brief(text)
    counts = {request.key: request.count for request in brief.requests}
    said = {f"{counts[r.subject]} {r.subject} {r.kind} {' '.join(r.anchors)}" for r in brief.relations if r.asked}
    return said, brief.unknown


@pytest.mark.parametrize(
    ("text", "relations"),
    [
        # How many each has, and how many are at both sides.
        ("Three shelves, each filled with boxes.", {"6 box inside shelving_unit"}),
        ("A fireplace with bookcases on both sides of it.", {"1 bookcase left_of fireplace",
                                                            "1 bookcase-2 right_of fireplace"}),
        ("Two sinks, a glass shelf above each sink with a cup.", {"2 wall_shelf above sink", "2 cup on wall_shelf"}),
        ("Two sofas, a coffee table with magazines in front of each sofa.", {"4 magazine on coffee_table"}),
        ("Two armchairs, each with a cushion, and a coffee table with a jug.", {"1 jug on coffee_table"}),
        ("Five pallet racks, each loaded with two boxes, a forklift in front of the third rack.",
         {"1 forklift in_front_of pallet_rack"}),
        ("A row of chairs by the entrance.", {"4 chair next_to door"}),
        # What a thing has, and where that is.
        ("A counter with a till and a ticket dispenser.", {"1 ticket_dispenser on counter"}),
        ("A pedestal with a bust. A clothes rail with ten dresses.", {"1 bust on pedestal",
                                                                     "10 dress on clothes_rack"}),
        ("A cupboard with plates on its shelves.", {"2 plate inside cabinet"}),
        ("A wall full of clocks and a stool.", {"2 clock on wall"}),
        ("A table with a jug and two glasses beside the bed.", {"2 glass on side_table",
                                                               "1 side_table next_to bed"}),
        ("A counter with a till is on the right.", {"1 counter against_wall right_wall"}),
        ("Trophies in a glass cabinet at the back.", {"1 china_cabinet against_wall far_wall"}),
        # What is meant.
        ("A bar with signs above the shelves behind the counter.", {"2 shelving_unit behind counter"}),
        ("A sofa, a coffee table with a plant, a TV on a stand opposite.", {"1 tv_stand opposite sofa"}),
        ("A sideboard, a picture above it and two stools in front of it.", {"2 stool in_front_of sideboard"}),
        ("A plate, a knife and a spoon to its right.", {"1 knife right_of plate", "1 spoon right_of plate"}),
        ("A whiteboard at one end of the room and a cabinet at the other end.",
         {"1 whiteboard against_wall one_wall", "1 cabinet against_wall opposite_wall"}),
        ("Bookcases along the walls to the left and right.", {"1 bookcase against_wall left_wall",
                                                             "1 bookcase-2 against_wall right_wall"}),
    ],
)  # fmt: skip
def test_what_was_misread_is_read(text, relations):
    said, unknown = _read(text)
    assert relations <= said
    assert not unknown


def test_two_windows_are_asked_for_and_light_grey_is_no_lamp():
    assert sum(opening.count for opening in read_brief("A picture between two windows.").openings) == 2
    assert [r.category for r in read_brief("A light grey sofa.").requests if r.asked] == ["sofa"]
    assert [r.category for r in read_brief("A bottle-green settee.").requests if r.asked] == ["sofa"]


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("An office with a desk near the bookcase and a chair behind it.", ("chair", "behind", "executive_desk")),
        ("A nook: an armchair by the bookcase, a floor lamp behind it.", ("floor_lamp", "behind", "armchair")),
        ("A nook: an armchair by the bookcase, a side table to its right.", ("side_table", "right_of", "armchair")),
    ],
)
def test_it_is_rather_what_stands_there_than_what_was_never_named_before(
    prompt: str, relation: tuple[str, str, str]
) -> None:
    brief = read_brief(prompt)
    assert relation in [(r.subject, r.kind, *r.anchors) for r in brief.relations]
    assert not brief.unknown
