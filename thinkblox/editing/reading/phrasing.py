"""Nouns as phrases: "the last two chairs", "the largest of the tables", "another"."""

from dataclasses import replace
from typing import cast

from thinkblox.assets.plurals import singular
from thinkblox.editing.orders import NounPhrase
from thinkblox.editing.reading.draft import OrderDraft
from thinkblox.editing.rows import MIDDLE_ROW
from thinkblox.reading.english.chunks import Connector, Noun

_ROW = "row_of_"
"""How things begin that are one thing in the catalogue, and a row where it is said which."""


def as_another(draft: OrderDraft, noun: Noun) -> Noun:
    """Read "and another on the shelf" as one more of what was named last."""
    last = draft.order.things[-1].noun if draft.order.things else None
    new = draft.order.doing in ("add", "put") and last is not None and last.kind == "thing" and not last.definite
    bare = noun.kind == "pronoun" and noun.value == "one" and not noun.det and (last is None or (last.count or 1) == 1)
    if not (noun.kind == "pronoun" and (noun.det == "another" or bare) and new) or last is None:
        return noun
    return replace(last, det="another", count=noun.count, plural=False, text=f"another {last.word}")


def _middle_row(draft: OrderDraft, noun: Noun) -> Noun | None:
    """Read "the middle row of desks" as the desks in it."""
    link, of = draft.ahead(), draft.ahead(1)
    row = noun.kind == "number" and noun.rows and "middle row" in noun.text.lower()
    if not row or not isinstance(link, Connector) or link.value != "of" or not isinstance(of, Noun):
        return None
    draft.at += 2
    return replace(of, det="the", plural=True, rows=1, ordinal=MIDDLE_ROW, text=f"{noun.text} of {of.text}")


def phrase_of(draft: OrderDraft, noun: Noun) -> NounPhrase:
    """A noun with which, or how many, of several it means."""
    rank, _, along = draft.cutter.ranks.get(id(noun), "").partition(" ")
    share = draft.cutter.shares.get(id(noun), 0.0)
    if noun.det == "half":
        share = 0.5
    if noun.value.startswith(_ROW) and noun.ordinal:
        value = singular(noun.value.removeprefix(_ROW))
        noun = replace(noun, value=value, rows=1, plural=True, count=None)
    if noun.kind == "number" and noun.rows and "middle row" in noun.text.lower():
        noun = replace(noun, rows=1, ordinal=MIDDLE_ROW)
    if noun.fraction[1]:
        share = noun.fraction[0] / noun.fraction[1]
    if noun.vague and noun.kind == "thing" and singular(noun.text.split()[-1]) == noun.text.split()[-1].lower():
        noun = replace(noun, count=1, vague=False, plural=False, det="another")
    left = int(-share) if share < 0 else 0
    return NounPhrase(noun, id=noun.id, rank=int(rank or 0), along=along, share=max(share, 0.0), left=left)


def merged(draft: OrderDraft, noun: Noun) -> Noun:
    """Read "the last two chairs", "the largest of the tables" as one phrase; "the one" as the thing before it."""
    if (row := _middle_row(draft, noun)) is not None:
        return row
    following = draft.ahead()
    whole = isinstance(following, Noun) and following.kind == "thing" and not following.det
    if noun.kind == "number" and noun.ordinal and whole and isinstance(following, Noun):
        draft.at += 1
        return replace(following, ordinal=noun.ordinal, det="the", text=f"{noun.text} {following.text}")
    if noun.kind == "pronoun" and noun.value == "all" and noun.text.lower() == "all" and whole:
        draft.at += 1
        return replace(cast(Noun, following), det="all", plural=True, text=f"{noun.text} {following.text}")  # type: ignore[union-attr]
    if noun.kind == "number" and noun.ordinal and isinstance(following, Noun) and following.rows > 1:
        draft.at += 1
        return replace(noun, rows=following.rows, text=f"{noun.text} {following.text}")
    located = isinstance(following, Connector) and following.sort == "prepositions"
    if noun.kind == "pronoun" and noun.value == "them" and noun.count and located:
        noun = replace(noun, kind="number", det="the")
    things = [phrase.noun for phrase in draft.order.things if phrase.noun.kind == "thing"]
    head = draft.anchors[-1] if draft.anchors and draft.anchors[-1].kind == "thing" else None
    known = things[-1] if things else head
    pointed = noun.kind == "number" and (noun.det in ("the", "other", "any", "a") or noun.ordinal or noun.of_known)
    if pointed and known is not None and draft.mode != "instead":
        return replace(
            noun, kind="thing", value=known.value, named=known.named, plural=(noun.count or 1) > 1,
            det=noun.det or "the", id="",
        )  # fmt: skip
    return noun
