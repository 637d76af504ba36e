"""What a pronoun, or a relation without a noun, points back to: every thing named before is weighed.

Three things count: whether it can bear the relation (`antecedents.toml`), how lately it was spoken of, and what it is
in its sentence: what has the list, what the clause is about, what a pronoun just meant. Where the two best come near
each other, nobody can tell which is meant.
"""

import tomllib
from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

from thinkblox.assets import facts_of, kind_of, revision
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Draft, Mention
from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.referents import Referents, is_small, last_word
from thinkblox.reading.english.said import is_link
from thinkblox.reading.english.survey import Occurrence, Survey, survey

_WINDOW = 60
"""How many chunks back a pronoun can reach."""
_BESIDE = ("next_to", "left_of", "right_of", "in_front_of", "behind", "near")
"""Relations that nothing has to what it lies on."""
_SIDES = ("left_of", "right_of", "in_front_of", "behind", "above", "under")
"""Relations of which two are told of one thing in a row: "the fridge is left of the stove, the sink right of it"."""
_TURNED = ("left_of", "right_of", "in_front_of", "behind")
"""Relations that one thing seldom has to another of its kind."""
_FAINT = 0.25
"""How much of a part of a sentence counts once another sentence has begun."""
_SOFT = ("beds", "lounges", "seats", "chairs")
"""What hardly anything stands on."""
_PAIR = 2
_NEAR = 6
"""How many things back another can be of which both are "them"."""


@dataclass(frozen=True, slots=True)
class Antecedent:
    """A thing that may be meant, and how much speaks for it; `several` where it is more than "it" can be."""

    thing: Mention
    score: float
    several: bool = False


@dataclass(frozen=True, slots=True)
class OpenReference:
    """Words from token `start` to `end` that may point back to either of two things."""

    start: int
    end: int
    one: Mention
    other: Mention


_OVER, _CARRIED = ("above", "under"), ("on", "on_top", "inside")
"""Relations of what is over or under another, and of what lies on it or in it."""
_WITHIN = ("in", "inside")


class Antecedents:
    """Weighs what pronouns may mean.

    Args:
        draft: what was read so far.
        meant: what the noun phrase at each token was taken for.
        chunks: the text.
    """

    def __init__(
        self, draft: Draft, referents: Referents, meant: Mapping[int, Sequence[Mention]], chunks: Sequence[Chunk]
    ) -> None:
        self._draft = draft
        self._referents = referents
        self._meant = meant
        self._chunks = chunks
        self._starts = [chunk.start for chunk in chunks]
        self._nouns = {chunk.start: chunk for chunk in reversed(chunks) if isinstance(chunk, Noun)}
        self.pointed: dict[int, Mention] = {}
        self.unclear: list[OpenReference] = []
        self._seen: tuple[int, Survey] | None = None

    def choose(
        self,
        where: tuple[int, int],
        kind: str,
        subjects: Sequence[Mention],
        noun: str,
        found: Mention,
        *,
        one: bool,
    ) -> Mention:
        """What words at tokens `where` mean, of which the reader of clauses `found` something.

        That counts for it as well; where another comes near, that is noted in `unclear`. The rest as in `ranked`.
        """
        if one and (usual := self._usual_carrier(where[0], found, kind, subjects, noun)) is not None:
            return usual
        several = found.many or self._referents.total(found) > 1
        if one and several and subjects and all(s.owner is found for s in subjects):
            return found  # What each of several has is on, under or beside that one.
        if kind in _CARRIED and self._is_hung(where[0]):
            hooks = [c for c in self.ranked(where[0], kind, subjects, noun, one=one) if _takes_hung(c.thing)]
            if hooks:
                return hooks[0].thing
        by = weights()
        large = not load_habits().is_in(noun, "small")
        apart = one and (kind in _OVER or (large and kind not in _CARRIED))
        again = self._pointed_before(where[0]) if apart else None
        ranked = [
            Antecedent(
                c.thing,
                c.score
                + by["reader"] * (c.thing is found and not (one and c.several))
                + by["again"] * (c.thing is again),
            )
            for c in self.ranked(where[0], kind, subjects, noun, one=one)
        ]
        hollow = [c for c in ranked if last_word(c.thing) in grammar().lists["containers"]] if kind in _WITHIN else []
        ranked = hollow if found in [c.thing for c in hollow] else ranked
        if found not in [c.thing for c in ranked]:
            another = kind in _TURNED and ranked and any(s.noun == found.noun for s in subjects)
            return max(ranked, key=lambda candidate: candidate.score).thing if another else found
        best, *others = sorted(ranked, key=lambda candidate: -candidate.score)
        low = is_small(best.thing) or load_habits().is_in(best.thing.noun, "seats", "chairs")
        if kind == "above" and low and load_habits().tie(noun, best.thing.noun) != "above":
            hung = next((c for c in others if load_habits().tie(noun, c.thing.noun) == "above"), None)
            best, others = (hung, []) if hung is not None else (best, others)
        close = bool(others) and best.score - others[0].score < by["margin"]
        screen = load_habits().is_in(best.thing.noun, "screens")
        under = self._carrier(best, others) if (close or screen) and kind in ("", *_BESIDE) else None
        if under is not None and noun in load_habits().known() and not facts_of(noun).is_in("small"):
            best = under  # What stands on the floor beside a thing stands beside what that lies on.
        elif close:
            self.unclear.append(OpenReference(*where, best.thing, others[0].thing))
            best = next(c for c in ranked if c.thing is found) if others[0].thing is found else best
        if not self._is_owner(best.thing, where[0]):
            self.pointed[where[0]] = best.thing
        return best.thing

    def _is_hung(self, start: int) -> bool:
        """Whether the words before token `start` say that something hangs there."""
        at = bisect_left(self._starts, start) - 1
        return at >= 0 and (
            is_link(self._chunks[at], "verbs", "hang") or is_link(self._chunks[at], "participles", "hang")
        )

    def _pointed_before(self, start: int) -> Mention | None:
        """What the last pronoun before token `start` meant, if it stands in the same sentence."""
        before = max((at for at in self.pointed if at < start), default=-1)
        between = self._chunks[bisect_left(self._starts, before) : bisect_left(self._starts, start)]
        if before < 0 or any(is_link(chunk, "mark", "stop") for chunk in between):
            return None
        return self.pointed[before]

    def _usual_carrier(
        self, start: int, found: Mention, kind: str, subjects: Sequence[Mention], noun: str
    ) -> Mention | None:
        """What such things lie on that stands beside what carries none: "a bed with a nightstand and a lamp on it"."""
        is_in = load_habits().is_in
        if kind not in ("on", "on_top") or not is_in(found.noun, *_SOFT) or load_habits().tie(noun, found.noun) == "on":
            return None
        seen = self._survey(start)
        now = [t for n in seen.named if n.sentence == seen.sentence for t in self._meant.get(n.noun.start, ())]
        own = (t for t in reversed(now) if t.owner is found and t not in subjects)
        return next((t for t in own if is_in(t.noun, "surfaces", "tables")), None)

    def _carrier(self, best: Antecedent, others: Sequence[Antecedent]) -> Antecedent | None:
        """Which of them the best lies on; itself where another one lies on it and comes near."""
        bonds = (b for c in (best, *others) for b in self._draft.bonds_of(c.thing) if b.kind == "on" and not b.negated)
        laid = {b.subject: b.anchors for b in bonds}
        if others and best.thing in laid.get(others[0].thing, ()):
            return best
        return next((c for c in others if c.thing in laid.get(best.thing, ())), None)

    def is_named_alone(self, thing: Mention) -> bool:
        """Whether it was named last without the others of its kind: "the left nightstand"."""
        start = max((start for start, things in self._meant.items() if thing in things), default=-1)
        named = self._nouns.get(start)
        return named is not None and not named.many and list(self._meant[start]) == [thing]

    def _is_owner(self, thing: Mention, start: int) -> bool:
        """Whether the words before `start` tell what a thing has: "a table with two books on it"."""
        seen = self._survey(start)
        own = seen.named[-1] if seen.named else None
        owners = [t for o in own.owners for t in self._meant.get(o.start, ())] if own is not None else []
        return own is not None and own.role == "member" and thing in owners

    def ranked(self, start: int, kind: str, subjects: Sequence[Mention], noun: str, *, one: bool) -> list[Antecedent]:
        """What the words at token `start` may point back to, the likeliest first.

        Args:
            start: the first token of the preposition, or of the pronoun.
            kind: the relation that it is to have.
            subjects: what has the relation; empty where that comes later.
            noun: what that is called.
            one: whether the pronoun is one for a single thing.
        """
        seen = self._survey(start)
        last = next((n for n in reversed(seen.named) if self._means_any(n, subjects)), None)
        besides = {id(t) for s in subjects for t in self._referents.clan(s)}
        if kind == "opposite":
            besides |= {id(t) for t in self._draft.things[-_WINDOW:] if t.owner is not None and t.owner in subjects}
        kept = set(map(id, self._draft.things[-_WINDOW:]))
        alike = {noun, *(s.noun for s in subjects)} if kind in (*_TURNED, "") else set()
        scores: dict[int, Antecedent] = {}
        for named in seen.named:
            for thing in self._meant.get(named.noun.start, ()):
                if id(thing) in besides or id(thing) not in kept or (one and self._is_one_of_two(thing)):
                    continue
                score = worth(kind or "next_to", noun, thing.noun)
                score += weights()["alike"] * (thing.noun in alike)
                several = not self._is_one(thing, named, last, seen)
                if one and several:
                    score += weights()["several"] + self._place(kind, named, None, seen)
                else:
                    score += self._place(kind, named, last, seen)
                if id(thing) not in scores or scores[id(thing)].score < score:
                    scores[id(thing)] = Antecedent(thing, score, several)
        return sorted(scores.values(), key=lambda candidate: -candidate.score)

    def bearer(self, start: int, states: Sequence[str], found: Mention) -> Mention:
        """What "it" at token `start` is that is said to be in some states; `found` unless only another can be so."""
        if can_be(found.noun, states):
            return found
        ranked = self.ranked(start, "", (), "", one=True)
        able = (c.thing for c in ranked if not c.several and can_be(c.thing.noun, states))
        return next(able, found)

    def choose_several(
        self,
        where: tuple[int, int],
        kind: str,
        subjects: Sequence[Mention],
        noun: str,
        found: tuple[Mention, ...],
    ) -> tuple[Mention, ...]:
        """What "them" at tokens `where` means, of which the reader of clauses `found` something; as `choose`."""
        by = weights()
        scores = self._sets(where[0], kind, subjects, noun)
        mine = frozenset(found)
        lone = len(found) == 1 and not found[0].many
        if not scores or (mine not in scores and not lone):
            return found
        if mine in scores:
            scores[mine] = (scores[mine][0] + by["reader_several"], found)
        best, *others = sorted(scores.values(), key=lambda entry: -entry[0])
        near = next((e for e in others if best[0] - e[0] < by["margin"]), None)
        if near is not None:
            self.unclear.append(OpenReference(*where, _apart(best[1], near[1]), _apart(near[1], best[1])))
            return found if found in (best[1], near[1]) else best[1]
        return best[1]

    def _sets(
        self, start: int, kind: str, subjects: Sequence[Mention], noun: str
    ) -> dict[frozenset[Mention], tuple[float, tuple[Mention, ...]]]:
        """Things that "them" can mean together: several of one name, two that were joined, or one beside another."""
        by, seen = weights(), self._survey(start)
        own = next((n for n in reversed(seen.named) if self._means_any(n, subjects)), None)
        own = replace(own, joined=None) if own is not None else None
        taken = [*subjects, *(t for s in subjects for t in (s.owner, s.host) if t is not None)]
        scores: dict[frozenset[Mention], tuple[float, tuple[Mention, ...]]] = {}

        def weigh(score: float, things: Sequence[Mention]) -> None:
            kept = tuple(dict.fromkeys(t for t in things if t in self._draft.things))
            total = score + sum(worth(kind, noun, t.noun) for t in kept) / max(1, len(kept))
            if kept and not set(kept) & set(taken) and scores.get(frozenset(kept), (total - 1,))[0] < total:
                scores[frozenset(kept)] = (total, kept)

        before = [n for n in seen.named if n is not own and self._meant.get(n.noun.start)]
        for named in before:
            things = [p for t in self._meant[named.noun.start] for p in self._referents.family(t)]
            said = named.noun.plural and named.noun.definite and not any(t.many for t in things)
            if len(things) > 1 or any(t.many for t in things) or said:
                family = by["family"] * (said or len(things) > 1) + by["apart"] * self._are_told_apart(things, seen)
                weigh(self._place(kind, named, own, seen) + family, things)
        runs = list(_lists(seen.named, own))
        for run in runs:
            things = [t for n in run for t in self._meant[n.noun.start]]
            weigh(sum(self._place(kind, n, own, seen) for n in run) / len(run) + by["whole_list"], things)
        for at, named in enumerate(before):
            for other in before[max(0, at - _NEAR) : at]:
                pair = [t for n in (other, named) for t in self._meant[n.noun.start]]
                tied = "joined" if named.joined is other.noun else "told" if named.of is other.noun else "beside"
                ends = kind != "between" and any(run[-1] is named and run[0] is not other for run in runs)
                apart = ends or (tied == "beside" and (kind != "between" or {named.role, other.role} != {"head"}))
                apart |= tied != "joined" and any(t.many for t in pair)
                apart |= kind == "between" and any(self._lies_on(one, pair) for one in pair)
                if len(pair) == 2 and other.sentence == named.sentence and not apart:
                    score = (self._place(kind, named, own, seen) + self._place(kind, other, own, seen)) / 2
                    weigh(score + by[f"pair_{tied}"], pair)
        return scores

    def _lies_on(self, thing: Mention, others: Sequence[Mention]) -> bool:
        """Whether it lies on any of others, so that nothing can be between these."""
        lying = (b for b in self._draft.bonds_of(thing) if b.kind in ("on", "inside") and not b.negated)
        return any(other in bond.anchors for bond in lying for other in others)

    def _are_told_apart(self, things: Sequence[Mention], seen: Survey) -> bool:
        """Whether the last sentence told of each of two: "one is by the window, the other by the door"."""
        told = [n for n in seen.named if n.sentence >= seen.sentence - 1 and self._means_any(n, things)]
        return len(things) == _PAIR and not any(t.many for t in things) and len(told) >= _PAIR

    def _was_named_before(self, named: Occurrence, seen: Survey) -> bool:
        """Whether it is spoken of again, and not for the first time: "by the bookcase", of which nobody knew."""
        things = self._meant.get(named.noun.start, ())
        return any(self._means_any(n, things) for n in seen.named if n.noun.start < named.noun.start)

    def _is_small(self, named: Occurrence) -> bool:
        return all(is_small(thing) for thing in self._meant.get(named.noun.start, ()))

    def _means_any(self, named: Occurrence, things: Sequence[Mention]) -> bool:
        return any(t in things for t in self._meant.get(named.noun.start, ()))

    def _is_one(self, thing: Mention, named: Occurrence, own: Occurrence | None, seen: Survey) -> bool:
        """Whether "it" may be said of a thing: of one, or of each of several."""
        shared = named.noun.start in seen.spread or thing in self._referents.shared
        if (shared and named.sentence == seen.sentence) or thing.rows or thing.groups:
            return True
        if own is not None and named.noun in own.owners and (named.noun.each or own.noun.each):
            return True
        if thing.noun.replace("_", " ") in grammar().lists["pairs"]:
            return False
        return not (thing.many or (named.noun.many and not self._referents.is_apart(thing)))

    def _place(self, kind: str, named: Occurrence, own: Occurrence | None, seen: Survey) -> float:
        """How much speaks for a thing by where it was named."""
        by = weights()
        back = seen.sentence - named.sentence
        score = by[named.role] + by["sentence"] * back
        score += by["part"] * (seen.part - named.part if not back else _FAINT * max(0, seen.last - named.part))
        lies = own is not None and own.listed and kind in _BESIDE and self._is_small(own)
        if own is not None and named.noun in own.owners and not lies:
            owner = by["owner"] if named.noun is own.owners[0] else by["outer"]
            score += owner * (by["listed"] if own.listed else 1.0)
        if seen.topics.get(named.sentence) is named.noun and back < 2:
            first = by["first"] if named.noun.start in seen.loose else by["topic"]
            score += first if not back or seen.sentence not in seen.topics else 0.0
        carries = kind in ("on", "inside", "above", "under") and not self._is_small(named)
        if own is not None and own.joined is named.noun and (own.owners or not carries):
            score += by["joined"] if own.paired else by["tail"] * (named.role == "head")
        if named.role == "head" and own is None and named.part == seen.part - 1 and not back:
            score += by["before"]
        if named.role == "anchor":
            known = named.noun.definite and self._was_named_before(named, seen)
            score += by["known"] * known + by["fresh"] * (named.noun.definite and not known)
            right_before = named.part == seen.part - 1 and not back
            score += by["latest"] * (known and right_before)
            alike = kind in _SIDES and named.link in _SIDES and right_before and not seen.verb
            score += by["parallel"] * (alike and own is not None and own.part == seen.part and own.role == "head")
            near = own is not None and named.part == seen.part and not back and own.noun.start < named.noun.start
            score += by["own"] * (near and not seen.having > named.noun.start)
        score += self._centre(named, seen)
        return score

    def _centre(self, named: Occurrence, seen: Survey) -> float:
        """How much speaks for what a pronoun meant lately."""
        by, things = weights(), self._meant.get(named.noun.start, ())
        told = [at for start, at in seen.links.items() if self.pointed.get(start) in things]
        if not told or max(told)[0] < seen.sentence - 1:
            return 0.0
        sentence, part, word = max(told)
        if sentence < seen.sentence:
            return by["centre"] + by["sentence"]
        share = by["lying"] if word in ("on", "on_top", "in") else 1.0
        return share * by["centre"] + by["part"] * max(0, seen.part - part - 1)

    def _is_one_of_two(self, thing: Mention) -> bool:
        """Whether it stands at one side of something and another at the other, and nothing is said of each."""
        return thing in self._referents.flanking and thing not in self._referents.shared

    def _survey(self, start: int) -> Survey:
        """What was named before token `start`."""
        if self._seen is None or self._seen[0] != start:
            end = bisect_left(self._starts, start)
            self._seen = (start, survey(self._chunks[max(0, end - _WINDOW) : end], self._meant))
        return self._seen[1]


def _lists(named: Sequence[Occurrence], own: Occurrence | None) -> Iterator[Sequence[Occurrence]]:
    """The lists of more than two that end with two joined ones: "a sofa, a plant and a rug"; `own` is left out."""
    for at, last in enumerate(named):
        start = at
        while start and _goes_on(named[start - 1], named[start]):
            start -= 1
        if last.joined is not None and at - start >= _PAIR:
            yield named[start : at + (own is None or last.noun is not own.noun)]


def _goes_on(one: Occurrence, other: Occurrence) -> bool:
    """Whether a list goes on from one to the other."""
    alike = one.role == other.role and one.owners == other.owners and one.sentence == other.sentence
    return alike and other.part - one.part == 1 and other.noun.start - one.noun.end == 1


def _apart(things: Sequence[Mention], others: Sequence[Mention]) -> Mention:
    """What tells some things from others."""
    return next((thing for thing in things if thing not in others), things[0])


def _takes_hung(thing: Mention) -> bool:
    """Whether clothes and towels hang on it."""
    return last_word(thing) in grammar().lists["hung_on"]


def worth(kind: str, noun: str, to: str) -> float:
    """How well a thing bears such a relation of a `noun`; against it where that is negative."""
    return _worth(kind, noun, to, revision())


@lru_cache(maxsize=4096)
def _worth(kind: str, noun: str, to: str, revision: int) -> float:
    habits = load_habits()
    usual = weights()["habit"] if noun and habits.tie(noun, to) == kind else 0.0
    for row in _table()["worth"]:
        if kind not in row["relations"]:
            continue
        if "of" in row and not (noun and habits.is_in(noun, *row["of"])):
            continue
        groups = [g for g in row["to"] if g != "small" or max(kind_of(to).size) <= weights()["small"]]
        if row["to"] == ["other"] or (groups and habits.is_in(to, *groups)):
            return usual or float(row["by"])
    return usual


def can_be(category: str, states: Sequence[str]) -> bool:
    """Whether a thing can be in all these states, as far as is known: a desk is not lit, a lamp not folded."""
    is_in = load_habits().is_in
    rows = [row for row in _table()["states"] if any(state in row["words"] for state in states)]
    return all(is_in(category, *row["only"]) if "only" in row else not is_in(category, *row["none"]) for row in rows)


def weights() -> dict[str, float]:
    """How much each thing counts."""
    found: dict[str, float] = _table()["weights"]
    return found


@lru_cache(maxsize=1)
def _table() -> dict[str, Any]:
    return tomllib.loads((Path(__file__).parent / "antecedents.toml").read_text("utf-8"))
