"""One clause of an instruction, and the small words that begin, join and end clauses."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from thinkblox.editing.grammar import longest
from thinkblox.reading.tokens import Token

ENDS = (".", ";", "!", "?", "\n")
POINTERS = frozenset(
    "the a an both all it them my every each that this these those another some only just its their our any no more"
    " everything nothing half one".split()
)
"""Words after a verb in the middle of a sentence, by which it is told from a noun."""
LINKS = (",", "and", "then", "but", "also", "while", "plus")
WANTS = ("want",)
BRINGS = ("add", "want", "ensure")
NEWS = ("add", "put", "want")
AGAIN = ("it", "its", "them", "their", "they")
NOT = Token("not", "not", "word", start=-1)
TO = Token("to", "to", "word", start=-1)
WITH = Token("with", "with", "word", start=-1)


@dataclass(frozen=True)
class Clause:
    """One order of an instruction.

    Attributes:
        doing: what is to be done, a key of the grammar's verbs.
        change: how the room changes by the verb alone ("lengthen").
        tokens: what it says after the verb; of a wish without what makes it one.
        text: the clause as it was written.
    """

    doing: str
    change: str
    tokens: tuple[Token, ...]
    text: str


@dataclass(frozen=True)
class ClauseStart:
    """Where a clause begins and where its words go on, with those that come before."""

    begin: int
    body: int
    doing: str
    change: str = ""
    before: tuple[Token, ...] = ()
    denied: bool = False
    whose: tuple[Token, ...] = ()


def spoken(tokens: Sequence[Token], named: Mapping[int, str]) -> str:
    """Words as they were written, without the marks at their ends."""
    text, skip, end = "", 0, -1
    for token in sorted(tokens, key=lambda token: token.start):
        if token.start < skip:
            continue
        shown = named.get(token.start, token.shown)
        if token.start in named:
            skip = token.start + len(named[token.start].rpartition("_")[0])
        close = token.kind == "mark" or (token.start == end and token.start >= 0) or not text
        text += shown if close else f" {shown}"
        end = token.start + len(token.shown) if token.glued is False else -2
        if token.glued:
            text, end = f"{text}-", token.start + len(token.shown) + 1
    words = text.strip(" ,.;:!?\n").split(" ")
    while len(words) > 1 and words[-1].lower() in LINKS:
        del words[-1]
    return " ".join(words).strip(" ,.;:!?\n")


def after_fillers(tokens: Sequence[Token]) -> int:
    """Where the first word stands that is no courtesy."""
    index = 0
    while index < len(tokens) and (filler := longest("fillers", tokens, index)) is not None:
        index += filler[1]
    return index


def is_filler_at(tokens: Sequence[Token], token: Token) -> bool:
    """Whether a token belongs to words that ask for nothing."""
    at = tokens.index(token)
    spans = ((start, longest("fillers", tokens, start)) for start in range(at + 1))
    return any(found is not None and start + found[1] > at for start, found in spans)


def rest_of_sentence(tokens: Sequence[Token], at: int) -> list[int]:
    """The tokens up to the end of the sentence."""
    end = next((n for n in range(at, len(tokens)) if tokens[n].text in ENDS), len(tokens))
    return list(range(at, end))


def meant_at(tokens: Sequence[Token], at: int, section: str) -> str:
    """The key of the phrase of a section that begins at a token; empty where none does."""
    found = longest(section, tokens, at)
    return found[0] if found is not None else ""


def ends_at(tokens: Sequence[Token], at: int) -> bool:
    """Whether an order, or a part of it, ends before a token."""
    return at >= len(tokens) or tokens[at].text in (*ENDS, *LINKS, "please", "now", "away")
