"""Every word of a prompt has a fate, and what names or changes a thing is made of something or said not to be."""

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from thinkblox.errors import InputError
from thinkblox.reading import read_brief
from thinkblox.reading.english import read_english
from thinkblox.reading.english.account import of_all_words
from thinkblox.reading.lexicon import load
from thinkblox.reading.tokens import texts, tokenise

WORDS = (
    "a the two each chair table lamp bed shelf window wall corner with without on in next to of for not no only it "
    "them one other both half left right red wooden cosy large is are stands holds has facing between 3 m x , . ; "
    ": ( ) and or but which where dozen at least every second of them the rest quickly frobnicator café don't"
).split(" ")


def _fates(prompt: str) -> dict[str, str]:
    return {word.text.lower(): word.fate for word in read_brief(prompt).account}


@given(st.text("abm '-2²", max_size=20))
def test_the_texts_of_a_phrase_are_those_of_its_tokens(phrase: str) -> None:
    assert texts(phrase) == tuple(token.text for token in tokenise(phrase))


def _covered(text: str) -> None:
    shown = [(t.shown, t.start) for t in tokenise(text) if t.kind != "mark"]
    draft = read_english(load("en"), text)
    words = [(w.text, w.start) for w in of_all_words(draft.account, draft.written, draft.told)]
    assert [start for _, start in words] == sorted({start for _, start in words})
    assert "".join(text for text, _ in words) == "".join(text for text, _ in shown)
    assert {start for _, start in shown} <= {start for _, start in words}


@settings(deadline=None, max_examples=150)
@given(st.lists(st.sampled_from(WORDS), max_size=40).map(" ".join))
@example("is and is")
@example("a table without red and no lamp")
@example("without red")
@example("tables and tables of many chairs")
def test_the_account_covers_every_word_once_and_in_order(text: str) -> None:
    _covered(text)


@settings(deadline=None, max_examples=150)
@given(st.text(max_size=80))
@example("W/")
@example("a room w/o rug w/ a bed")
@example("WALL-MOUNTED")
def test_the_account_covers_every_word_of_any_text(text: str) -> None:
    _covered(text)


def test_words_are_found_again_where_they_begin() -> None:
    prompt = "A study: two desks (1.2 m wide), each with a lamp; no rug."
    for word in read_brief(prompt).account:
        assert prompt[word.start :].startswith(word.text)


def test_what_is_asked_for_related_and_wanted_away() -> None:
    fates = _fates("A cosy bedroom with a red bed against the wall and no television, 4 m by 5 m.")
    assert fates["bed"] == fates["red"] == fates["bedroom"] == "requested"
    assert fates["against"] == fates["wall"] == "related"
    assert fates["no"] == fates["television"] == fates["4"] == "constraint"
    assert fates["cosy"] in ("style", "filler")


@pytest.mark.parametrize(
    ("prompt", "lost"),
    [
        ("A sofa and a rug. In the corner, far from the window.", "In the corner"),
        ("A study with a desk and a chair. The chair is for the desk.", "for the desk"),
        ("A desk with a lamp. A shelf stands 40 cm from the desk.", "40 cm from"),
    ],
)
def test_what_is_dropped_is_said(prompt: str, lost: str) -> None:
    brief = read_brief(prompt)
    assert lost in brief.unknown
    assert "not_understood" in {word.fate for word in brief.account}


@pytest.mark.parametrize(
    "prompt",
    [
        "A bedroom for a programmer who never tidies up, with a bed and a desk.",
        "An instagram ready kitchen, so two stools in all, smells like apple pie.",
        "A living room with ample seating, providing a cozy touch: a sofa and two armchairs.",
    ],
)
def test_words_that_ask_for_nothing_are_no_loss(prompt: str) -> None:
    brief = read_brief(prompt)
    assert brief.unknown == ()
    assert "not_understood" not in {word.fate for word in brief.account}


def test_a_contracted_verb_is_read() -> None:
    brief = read_brief("A bedroom with a bed and a wardrobe. The wardrobe? It's opposite the bed.")
    assert ("opposite", "wardrobe", ("bed",)) in [(r.kind, r.subject, r.anchors) for r in brief.relations]
    assert [w.text for w in brief.account][-4:] == ["'s", "opposite", "the", "bed"]


def test_english_is_known_by_its_words_and_polish_is_not() -> None:
    assert read_brief("haunted victorian parlour, halloween party tonight").language == "en"
    with pytest.raises(InputError, match="hardly a word"):
        read_brief("W pokoju stoi duże łóżko, szafa i biurko z lampą przy oknie.")


@pytest.mark.parametrize(
    ("prompt", "unread", "things"),
    [
        (
            "A room with a bed, a dresser taller than the wardrobe.",
            "taller than the wardrobe",
            "bed dresser wardrobe",
        ),
        ("A room with a sofa and a desk twice as long as the sofa.", "twice as long as the sofa", "sofa desk"),
        ("A room with a sofa and a cat sleeping on the sofa.", "a cat sleeping on the sofa", "sofa"),
        ("A room with a sofa. My cat sleeps on the sofa.", "My cat sleeps on the sofa", "sofa"),
        ("A room with a sofa and the toilet lid up.", "lid up", "sofa toilet"),
        ("A room with a desk, drawer open.", "drawer open", "desk"),
        ("A room with ceiling painted dark blue and a sofa.", "ceiling painted dark blue", "sofa"),
        ("A room with a sofa. The ceiling is blue.", "ceiling is blue", "sofa"),
        ("A room with a sofa and a dog asleep on a rug.", "a dog asleep on a rug", "sofa rug"),
        ("A room with a man sitting on a sofa.", "a man", "sofa"),
        ("A room with a sofa. Budget is 2000 euros.", "2000 euros", "sofa"),
        ("A room with a tv 1.5 m above the floor.", "1.5 m above the floor", "tv"),
    ],
)
def test_what_no_room_shows_is_said_and_never_becomes_a_thing(prompt: str, unread: str, things: str) -> None:
    brief = read_brief(prompt)
    assert unread in brief.unknown
    assert {r.category for r in brief.requests if r.asked} == set(things.split())
    assert all(r.size == (None, None, None) for r in brief.requests)


@pytest.mark.parametrize("prompt", ["A room with a cat bed and a dog bowl.", "A room with a sofa, rather than a bed."])
def test_things_named_after_an_animal_stay_things(prompt: str) -> None:
    assert not read_brief(prompt).unknown


@pytest.mark.parametrize("prompt", ["!!! ... ??? ,,,", "12 3 4.5 7 100"])
def test_a_prompt_without_words_is_told_that_it_has_none(prompt: str) -> None:
    with pytest.raises(InputError, match="no words"):
        read_brief(prompt)


def test_words_with_a_slip_are_read_as_the_word_that_was_meant_and_said() -> None:
    brief = read_brief("Pls make me a bedrom with a wardrob and a lamp next too the bed thx!!")
    assert brief.room_type == "bedroom"
    assert {r.category for r in brief.requests if r.asked} >= {"wardrobe", "bed"}
    assert brief.unknown == ("bedrom (read as bedroom)", "wardrob (read as wardrobe)")


def test_some_is_a_plain_determiner() -> None:
    assert read_brief("A study with some paintings and a desk.").unknown == ()


@pytest.mark.parametrize("first", ["A bedroom with one door", "A bedroom with a bed"])
def test_the_wall_of_the_door_may_be_said_in_a_sentence_of_its_own(first: str) -> None:
    brief = read_brief(f"{first}. The door is on the north wall.")
    assert [(gap.kind, gap.wall, gap.count) for gap in brief.openings] == [("door", "north_wall", 1)]
    assert brief.unknown == ()
