"""Turns of speech in plainer words of the same length: "to the left of which", "looking for", "runs the length of"."""

import re
import tomllib
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path
from typing import Any

_OF_WHICH = re.compile(r"\b(?:to|on|at) (?:the|its) (left|right)(?: side| hand side)? of which\b", re.IGNORECASE)
"""At which side of what was named something is that comes."""
_WANTED = re.compile(
    r"(?:^|(?<=[.!?\n] )|(?<=\n))(?:(?:i am|i'm|we are|we're|you|we) )?"
    r"(?:(?:looking|searching|hoping) for|in (?:need|search) of|thinking of|(?:how|what) about|welcome to|"
    r"(?:step|walk) into|(?:find|found|picture|imagine) (?:yourself|ourselves|myself) in|go for|opt for)"
    r"(?= (?:an?|the|my|our|this)\b)",
    re.IGNORECASE,
)
"""What else begins to say what is wanted."""
_PRESENT = re.compile(r"(?:^|(?<=[.!?\n] )|(?<=\n))present (?:in (?:the|this) room |here )?(is|are)\b", re.IGNORECASE)
"""There is what comes."""
_INSIDE = re.compile(r"^inside,? (?=(?:is|are|there|you|we)\b)", re.IGNORECASE)
"""In the room, where nothing was named yet."""
_LENGTH_OF = re.compile(
    r"\b(?:run(ning|s)?|stretch(ing|es)?|extend(ing|s)?|span(ning|s)?) (?:along )?the "
    r"(?:full |whole |entire )?length of(?= (?:the|one|a)\b)",
    re.IGNORECASE,
)
"""What is as long as a wall."""
_SEATED_AT = re.compile(
    r"\b(?:at|around|on) which (?:up to )?(\w+) (?:people|persons|guests|students|children|adults) can "
    r"(?:sit|eat|work|dine|be seated)\b",
    re.IGNORECASE,
)
"""How many have a place at a table."""
_SHINING = re.compile(
    r"\b(lamps?|chandeliers?|lanterns?|pendants?) (lights?)(?= (?:up )?(?:the|an?|it|this)\b)", re.IGNORECASE
)
"""What lamps do, and no name of one."""
_NEXT = re.compile(r"(?:^|(?<=[.!?\n;] )|(?<=\n))next(?=,)", re.IGNORECASE)
"""What comes then."""
_BOTH_SIDES = re.compile(r"\bflanked (?:on|at) (?:both|either|each) (?:sides?|ends?) (by|with)\b", re.IGNORECASE)
_SO_THAT = re.compile(
    r"\b(?:oriented|positioned|placed|turned|arranged|angled|set) so (?:that |as )?(?:it|they|to)(?: is| are)?"
    r" (fac(?:es?|ing) |look(?:s|ing)? )",
    re.IGNORECASE,
)
"""How a thing is turned, told as what that is for."""
_IN_WAY = re.compile(
    r"\b(?<!not )(?<!n't )(?<!without )(?<!avoid )"
    r"(?:(blocks|obstructs)|(?<=s )(block|obstruct)|(?:(?<=can )|(?<=may )|(?<=should )|(?<=would ))(block|obstruct)|"
    r"blocking|obstructing) (?:the|its|our|my|one) "
    r"(?:way|path|passage|view|door|doorway|window|entrance|exit|aisle|walkway|corridor)\b",
    re.IGNORECASE,
)
"""What a thing does to the way or the door, and no block."""
_SETS = re.compile(r"\\.|\[(?:\\.|[^\]])*\]")
_OPTIONAL = re.compile(r".[?*{]", re.DOTALL)
_RUN = re.compile(r"[a-z' ]+")
_KIND = re.compile(r"^\?(?::|<?=)")
"""Parts of a pattern: sets of characters, what may be left out, words, and how a group that has to be there begins."""
_NOT_THERE, _QUANTIFIED = ("?!", "?<!"), ("?", "*", "{")
_THREE_D = re.compile(r"\b3[- ]?d(?= (?:model|scene|render|rendering|environment|room|layout|view|interior)\b)", re.I)


def with_plain_turns(text: str) -> str:
    """The text with plainer words, each as long as what it stands for where that is not shorter."""
    said = text.lower()
    for pattern, plainer in (*_TURNS, *_listed()):
        has = any(word in said for word in _words_of(pattern))
        if has and (turned := pattern.sub(_padded(plainer), text)) != text:
            text, said = turned, turned.lower()
    return text


def without_not_followed(text: str) -> tuple[str, list[str]]:
    """The text without turns that are not followed, spaces in their place, and these turns."""
    told: list[str] = []

    def left(said: re.Match[str]) -> str:
        told.append(" ".join(said[0].split()).strip(" ,"))
        return " " * len(said[0])

    said = text.lower()
    for pattern in _not_followed():
        if any(word in said for word in _words_of(pattern)):
            text = pattern.sub(left, text)
    return text, told


@cache
def _not_followed() -> tuple[re.Pattern[str], ...]:
    table = _table()
    return tuple(_pattern(table, said) for said in table["told"].values())


@cache
def _table() -> dict[str, Any]:
    return tomllib.loads(Path(__file__).with_name("turns.toml").read_text(encoding="utf-8"))


def _pattern(table: dict[str, Any], said: str) -> re.Pattern[str]:
    for name, part in table["parts"].items():
        said = said.replace(f"{{{name}}}", part)
    return re.compile(said, re.IGNORECASE)


@cache
def _words_of(pattern: re.Pattern[str]) -> tuple[str, ...]:
    """Words of which everything that a pattern finds has one in it, to be looked for first; none where all may have."""
    return _needed(_SETS.sub("\0", pattern.pattern)) or ("",)


def _needed(pattern: str) -> tuple[str, ...]:
    """Such words of a pattern without sets of characters, the longest there are; none where some ways have none."""
    each: list[tuple[str, ...]] = []
    for text, groups in _branches(pattern):
        runs = [(run,) for run in _RUN.findall(_OPTIONAL.sub("\0", text).lower())]
        inner = [_needed(_KIND.sub("", group)) for group in groups if not group.startswith(_NOT_THERE)]
        found = [words for words in (*runs, *inner) if words]
        each.append(max(found, key=lambda words: (min(map(len, words)), -len(words)), default=()))
    return tuple(word for words in each for word in words) if all(each) else ()


def _branches(pattern: str) -> list[tuple[str, list[str]]]:
    """The ways of a pattern: what each has outside its groups, and the insides of the groups that it has to have."""
    branches: list[tuple[str, list[str]]] = [("", [])]
    depth = begin = 0
    for at, char in enumerate(pattern):
        text, groups = branches[-1]
        if char == "(":
            depth, begin = depth + 1, begin if depth else at + 1
        elif char == ")":
            depth -= 1
            if not depth:
                groups += [] if pattern[at + 1 : at + 2] in _QUANTIFIED else [pattern[begin:at]]
                branches[-1] = (f"{text}\0", groups)
        elif not depth and char == "|":
            branches.append(("", []))
        elif not depth:
            branches[-1] = (text + char, groups)
    return branches


@cache
def _listed() -> tuple[tuple[re.Pattern[str], Callable[[re.Match[str]], str]], ...]:
    """The turns of turns.toml: what is said, and its plainer words; none for what asks for nothing."""
    table = _table()
    idle = [(_pattern(table, said), partial(_as_template, "")) for said in table["idle"].values()]
    return (*idle, *((_pattern(table, said), partial(_as_template, plain)) for said, plain in table["plain"].values()))


def _as_template(plain: str, said: re.Match[str]) -> str:
    """Plain words in which the groups of what was said are put."""
    return said.expand(plain)


def _padded(plainer: Callable[[re.Match[str]], str]) -> Callable[[re.Match[str]], str]:
    """The same words with spaces after them, so that all that follows stays in its place; none that are longer."""

    def put(said: re.Match[str]) -> str:
        words = plainer(said)
        return words.ljust(len(said[0])) if len(words) <= len(said[0]) else said[0]

    return put


def _turned_so(verb: str) -> str:
    """The participle of "facing" or "looking at" for the verb of "so that it faces"."""
    return "facing " if verb.lower().startswith("fac") else "looking "


def _along(said: re.Match[str]) -> str:
    """The verb or participle and the preposition for "runs the length of"."""
    ending = next((group for group in said.groups() if group), "")
    return f"{'running' if ending.endswith('ing') else 'runs' if ending else 'run'} along"


_TURNS: tuple[tuple[re.Pattern[str], Callable[[re.Match[str]], str]], ...] = (
    (_OF_WHICH, lambda said: f"{said[1].lower()} of which"),
    (_WANTED, lambda said: "show"),
    (_PRESENT, lambda said: f"there {said[1].lower()}"),
    (_INSIDE, lambda said: "here"),
    (_LENGTH_OF, _along),
    (_SEATED_AT, lambda said: f"that seats {said[1]}"),
    (_SHINING, lambda said: f"{said[1]} {'helps' if said[2].endswith('s') else 'help'}"),
    (_NEXT, lambda said: "then"),
    (_BOTH_SIDES, lambda said: f"flanked {said[1]}"),
    (_SO_THAT, lambda said: _turned_so(said[1])),
    (_IN_WAY, lambda said: f"{'is ' if said[1] else 'are ' if said[2] else 'be ' if said[3] else ''}in the way"),
    (_THREE_D, lambda said: ""),
)
"""What is read as what."""
