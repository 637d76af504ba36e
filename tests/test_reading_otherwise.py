"""The same said otherwise is read the same: other words, other marks, other orders, lines instead of sentences."""

import json
import re
import tomllib
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.test_reading_hostile import WORDS
from tests.test_reading_turns import related
from thinkblox.brief import Brief
from thinkblox.errors import InputError
from thinkblox.reading import read_brief
from thinkblox.reading.english.plain_turns import with_plain_turns
from thinkblox.reading.english.written_lines import with_lines

DEMANDS = Path(__file__).parent / "bench" / "demands"
OTHERWISE = tomllib.loads((Path(__file__).parent / "said_otherwise.toml").read_text("utf-8"))


def asked(brief: Brief) -> tuple[object, ...]:
    """What a brief asks for, whatever its words were."""
    names = {request.key: request.category for request in brief.requests}
    requests = Counter((r.category, r.count, tuple(sorted(r.attributes))) for r in brief.requests if r.asked)
    relations = Counter(
        (r.kind, names.get(r.subject, r.subject), tuple(names.get(a, a) for a in r.anchors), r.each, r.negated)
        for r in brief.relations
        if r.asked
    )
    return brief.room_type, requests, relations, len(brief.unknown)


REWORDED: dict[str, Callable[[str], str]] = {
    "no last full stop": lambda text: text.rstrip(". "),
    "beside": lambda text: re.sub(r"\bnext to\b", "beside", text),
    "adjacent to": lambda text: re.sub(r"\bnext to\b", "adjacent to", text),
    "over": lambda text: re.sub(r"\babove\b", "over", text),
    "one corner": lambda text: re.sub(r"\bin the corner\b(?! of)", "in one corner", text),
    "the center": lambda text: re.sub(r"\bin the middle of the room\b", "in the center of the room", text),
    "mounted": lambda text: re.sub(r"\bhangs on (?=the wall)", "is mounted on ", text),
    "gray": lambda text: text.replace("grey", "gray"),
    "two spaces": lambda text: text.replace(". ", ".  "),
    "a space before commas": lambda text: text.replace(", ", " , "),
    "curly apostrophes": lambda text: text.replace("'", "\u2019"),
    "a line each": lambda text: re.sub(r"(?<=[a-z]\.) (?=[A-Z])", "\n", text),
}


@pytest.mark.parametrize("reworded", REWORDED.values(), ids=REWORDED.keys())
def test_other_words_and_marks_change_nothing(reworded: Callable[[str], str]) -> None:
    prompts = [entry["prompt"] for name in ("br", "bt") for entry in json.loads((DEMANDS / f"{name}.json").read_text())]
    changed = [(prompt, other) for prompt in prompts if (other := reworded(prompt)) != prompt]
    assert changed
    assert [p for p, other in changed if asked(read_brief(p)) != asked(read_brief(other))] == []


@pytest.mark.parametrize("said", OTHERWISE["said"], ids=[said["kind"] for said in OTHERWISE["said"]])
def test_a_relation_is_read_however_it_is_said(said: dict[str, Any]) -> None:
    for way in said["ways"]:
        words = way.format(S=said["thing"].capitalize(), s=said["thing"], A=said["anchor"])
        brief = read_brief(f"This is a room. {said['before']} {words[0].upper()}{words[1:]}")
        assert said["kind"] in {relation.kind for relation in brief.relations if relation.asked}, words
        assert brief.unknown == (), words


ROOM = {
    "1 bed against_wall wall",
    "1 nightstand left_of bed",
    "1 nightstand-2 right_of bed",
    "2 table_lamp on nightstand nightstand-2",
    "1 rug under bed",
    "1 dresser opposite bed",
    "1 mirror above dresser",
    "1 armchair in_corner corner",
}


@pytest.mark.parametrize("prompt", [form["text"] for form in OTHERWISE["form"]])
def test_one_room_is_read_in_every_form(prompt: str) -> None:
    brief = read_brief(prompt)
    lamps = [relation for relation in brief.relations if relation.subject.startswith("table_lamp")]
    found = {words for words in related(brief) if "table_lamp" not in words}
    assert found == {words for words in ROOM if "table_lamp" not in words}
    assert sum(r.count for r in brief.requests if r.category == "table_lamp" and r.asked) == 2
    assert {anchor for lamp in lamps for anchor in lamp.anchors} == {"nightstand", "nightstand-2"}
    assert brief.unknown == ()


LINES = {
    "Bed": ("against the wall", "1 bed against_wall wall"),
    "Four chairs": ("around the table", "4 chair around dining_table"),
    "2 lamps": ("on the desk", "2 desk_lamp on desk"),
    "Rug": ("under the table", "1 rug under dining_table"),
    "Armchair": ("corner", "1 armchair in_corner corner"),
    "White wardrobe": ("to the left of the bed", "1 wardrobe left_of bed"),
    "Books (3)": ("on the shelf", "3 book on bookcase"),
}


@pytest.mark.parametrize("bullet", ["", "- ", "* ", "\u2022 ", "1. "])
@pytest.mark.parametrize("entry", ["{}: {}", "{} - {}", "{} \u2013 {}", "**{}**: {}", "{} -> {}", "{} = {}"])
def test_a_list_of_lines_is_read_whatever_marks_its_entries(bullet: str, entry: str) -> None:
    lines = [
        bullet.replace("1", str(at)) + entry.format(thing, where)
        for at, (thing, (where, _)) in enumerate(LINES.items(), 1)
    ]
    brief = read_brief("A large room.\n" + "\n".join(lines))
    assert {relation for _, relation in LINES.values()} <= related(brief)
    assert brief.unknown == ()
    text = brief.prompt
    assert [text[word.start : word.start + len(word.text)] for word in brief.account] == [w.text for w in brief.account]


@given(st.lists(st.sampled_from(WORDS), max_size=30).map(" ".join))
@example("Three lamps of different colours.")
@example("A clock on its wall, so that it faces the door.")
def test_plainer_words_leave_all_others_in_their_places(text: str) -> None:
    assert len(with_plain_turns(text)) == len(text)
    assert len(with_lines(text)) == len(text)
    try:
        brief = read_brief(text)
    except InputError:
        return  # No words, or a room of an impossible size.
    assert all(text[word.start : word.start + len(word.text)] == word.text for word in brief.account)
