"""Where something is said to be, as a relation that can be measured: of ids and parts of the room."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast, get_args

from thinkblox.assets import facts_of
from thinkblox.brief import RelationKind
from thinkblox.editing.finding import Finder, Picks, usual_anchor
from thinkblox.editing.orders import NounPhrase
from thinkblox.errors import InputError
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Mention
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.english.parts import relation_at
from thinkblox.reading.english.places import corner, opening, wall
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import ON_FLOOR

_KINDS = frozenset(get_args(RelationKind))
_NAMED = {"in": "inside", "by": "next_to", "along": "next_to", "against": "next_to", "to": "next_to", "on_top": "on",
          "per": "next_to", "for": "next_to", "from": "on", "among": "between"}  # fmt: skip
"""Prepositions that are called otherwise as relations."""
_OPENINGS = ("window", "door")
_SIDES = {"left": "left_wall", "right": "right_wall", "back": "far_wall", "front": "near_wall"}
_OPEN_TOPS = ("tables", "desks", "counters", "worktops", "beds", "lounges", "seats", "covers")


@dataclass(frozen=True)
class Bound:
    """A relation to ids or Places, as a Tie has it.

    Attributes:
        of_room: it is turned into the room ("facing the room").
    """

    kind: RelationKind
    anchors: tuple[str, ...] = ()
    negated: bool = False
    of_room: bool = False

    def holds(self, scene: Scene, id: str) -> bool:
        """Whether an object has the relation, or has it not where it is negated."""
        return measure(scene, self.kind, id, self.anchors, negated=self.negated).holds


def bound(where: Where, category: str, finder: Finder, *, picks: Sequence[Picks] = ()) -> Bound:
    """What a prepositional phrase says of a thing of a category.

    Raises:
        InputError: it names what is not there, could mean several, or says nothing that can be measured.
    """
    found = _bound(where, category, finder, picks)
    if found is None or found.kind not in _KINDS:
        raise InputError(f"'{_text(where)}' is no place that a thing can be put")
    return found


def _text(where: Where) -> str:
    whole = f" of {where.whole.text}" if where.whole is not None else ""
    return f"{where.text} {where.noun.text if where.noun else ''}{whole}".strip()


def _bound(where: Where, category: str, finder: Finder, picks: Sequence[Picks]) -> Bound | None:
    noun = where.noun
    if noun is None:
        return None
    if noun.kind == "room":
        return Bound("facing", of_room=True) if where.word in ("facing", "to", "near", "at", "opposite") else None
    if noun.kind == "part":
        return _part(where, noun, category, finder)
    if noun.kind == "place":
        return _place(where, noun, finder)
    return _thing(where, noun, category, finder, picks)


def _part(where: Where, noun: Noun, category: str, finder: Finder) -> Bound | None:
    """To the left of the sofa, at the foot of the bed, in the middle of the table or of the room."""
    whole = where.whole or (Noun("thing", noun.owner, 0, 0, noun.owner) if noun.owner else None)
    if whole is None or whole.kind in ("room", "place", "abstract"):
        if whole is not None and whole.kind == "place" and whole.value in _OPENINGS and noun.value in ("left", "right"):
            return Bound(cast(RelationKind, f"{noun.value}_of"), (whole.value,), where.negated)
        if noun.value == "middle":
            return Bound("in_centre", ("centre",), where.negated)
        side = _SIDES.get(noun.value)
        return Bound("against_wall", (_walls_of(finder.scene, side),), where.negated) if side else None
    anchors = finder.ids(NounPhrase(whole), picks=(usual_anchor(category),))
    kind = relation_at(noun.value, category, Mention(finder.scene[anchors[0]].category))
    return Bound(cast(RelationKind, kind), anchors, where.negated)


def _place(where: Where, noun: Noun, finder: Finder) -> Bound | None:
    name, *walls = noun.value.split()
    word = where.word
    if name == "centre":
        if where.whole is not None and where.whole.kind in ("thing", "pronoun"):
            return Bound("in_centre", finder.ids(NounPhrase(where.whole)), where.negated)
        return Bound("in_centre", ("centre",), where.negated)
    if name in _OPENINGS:
        if not any(o.kind == name for o in finder.scene.room.openings):
            raise InputError(f"the room has no {name}")
        if word == "under":
            return Bound("under", (name,), where.negated)
        meaning = opening(word, name)
    elif name == "corner":
        beside = _corner_beside(where, finder)
        if beside is not None:
            return Bound("in_corner", beside, where.negated)
        meaning = corner(word, noun, walls, 0)
    elif name in ("floor", "ceiling"):
        return Bound("on", (name,), where.negated)
    else:
        meaning = wall(word, noun, name, 0, each=noun.each)
    if meaning is None:
        return None
    anchors = tuple(_walls_of(finder.scene, str(anchor)) for anchor in meaning.anchors)
    return Bound(cast(RelationKind, meaning.kind), anchors, where.negated)


def _corner_beside(where: Where, finder: Finder) -> tuple[str, ...] | None:
    """The walls of the corner that is nearest to a door or window: "in the corner of the window"."""
    whole = where.whole
    if whole is None or whole.kind not in ("place", "thing"):
        return None
    name = whole.value if whole.kind == "place" else finder.ids(NounPhrase(whole))[0]
    return corner_near(finder.scene, name)


def corner_near(scene: Scene, name: str) -> tuple[str, ...]:
    """The names of the two walls of the corner nearest to a thing or part of the room.

    Raises:
        InputError: the scene has no such thing, or no corner.
    """
    marks, corners = things(scene, name), things(scene, "corner")
    if not marks or not corners:
        raise InputError(f"the room has no corner by the {name.replace('_', ' ')}")
    best = min(corners, key=lambda c: min(mark.footprint.distance(c.footprint) for mark in marks))
    return tuple(best.name.removeprefix("corner of ").split(" and "))


def _walls_of(scene: Scene, place: str) -> str:
    """A wall as it is seen from the door, by the name that it has; anything else as it is."""
    seen = {"left_wall": 1.0, "right_wall": -1.0}
    walls, door = scene.room.walls, next((o for o in scene.room.openings if o.kind == "door"), None)
    if place not in (*seen, "far_wall", "near_wall"):
        return place
    x, y = walls[door.wall].inward if door is not None else (0.0, 1.0)
    wanted = (x, y) if place == "far_wall" else (-x, -y) if place == "near_wall" else None
    if wanted is None:
        wanted = (-y * seen[place], x * seen[place])
    return max(walls, key=lambda w: (-w.inward[0] * wanted[0] - w.inward[1] * wanted[1], w.length)).name


def _thing(where: Where, noun: Noun, category: str, finder: Finder, picks: Sequence[Picks]) -> Bound:
    kind = _NAMED.get(where.word, where.word)
    phrase = NounPhrase(noun)
    if where.negated:
        found = [p.id for p in finder.matching(noun)] if noun.kind == "thing" else list(finder.ids(phrase))
        if not found:
            raise finder.nothing(noun.text)
        return Bound(_fitting(kind, where, category, found[0], finder), tuple(found), negated=True)
    anchors = finder.ids(phrase, picks=(*picks, usual_anchor(category)))
    if where.second is not None:
        second = where.second
        more = (second.value,) if second.kind == "place" else finder.ids(NounPhrase(second))
        anchors = (*anchors, *more)
    return Bound(_fitting(kind, where, category, anchors[0], finder), anchors)


def _fitting(kind: str, where: Where, category: str, anchor: str, finder: Finder) -> RelationKind:
    """The relation that a general word like "at", "to" or "in" stands for between these two."""
    habits, scene = load_habits(), finder.scene
    name, asset = scene[anchor].category, scene.asset_of(scene[anchor])
    usual = habits.tie(category, name)
    small = facts_of(category).is_in("small")
    if where.word == "to" and small and asset.surfaces and scene[anchor].position[2] < 1.0 + ON_FLOOR:
        return "on"
    if kind == "at":
        seated = "around" if habits.is_in(name, "tables") else "at" if habits.is_in(category, "seats") else "next_to"
        return usual if usual in ("at", "around") else cast(RelationKind, seated)
    if where.word == "to" and usual in ("at", "around", "on"):
        return usual
    if kind == "inside" and habits.is_in(name, *_OPEN_TOPS):
        return "on"
    if kind == "on" and small and habits.is_in(name, "shelves") and not any(not s.inner for s in asset.surfaces):
        return "inside"
    if kind == "next_to" and where.word == "against" and asset.front == "one":
        return "next_to"
    return cast(RelationKind, kind)


NEARNESS = (
    "next_to",
    "near",
    "at",
    "around",
    "in_corner",
    "against_wall",
    "in_front_of",
    "behind",
    "left_of",
    "right_of",
)
"""Relations by which the nearest of several is meant, where none has them by measure."""
CLOSE = 2.0
"""How far the nearest may be then [m]."""


def named(finder: Finder, phrase: NounPhrase, said: Sequence[Where], *, picks: Sequence[Picks] = ()) -> tuple[str, ...]:
    """The objects that a phrase means, by where they are said to be, without those that it excepts.

    Raises:
        InputError: as `Finder.ids`, none of them is there, or all are excepted.
    """
    ids = _named(finder, phrase, said, picks)
    left = spare(finder, ids, phrase.spared)
    if ids and not left:
        raise InputError(f"'{phrase.text}' means nothing but what it excepts: {', '.join(ids)}")
    return left


def spare(finder: Finder, ids: Sequence[str], spared: Sequence[NounPhrase]) -> tuple[str, ...]:
    """Objects without those that are excepted: "except two" is the first two of them."""
    for phrase in spared:
        one = phrase.noun.kind == "pronoun" and phrase.noun.value == "one"
        if (one or phrase.noun.kind == "number") and not phrase.places:
            ids = ids[1 if one else phrase.noun.count or 0 :]
        else:
            out = _named(finder, phrase, phrase.places, ())
            ids = [id for id in ids if id not in out]
    return tuple(ids)


def _named(finder: Finder, phrase: NounPhrase, said: Sequence[Where], picks: Sequence[Picks]) -> tuple[str, ...]:
    if not said or phrase.id or phrase.noun.kind == "pronoun":
        return finder.ids(phrase, picks=picks)
    found = finder.matching(phrase.noun)
    if not found:
        raise finder.nothing(phrase.noun.text)
    for where in said:
        there = bound(where, found[0].category, finder)
        held = [p for p in found if there.holds(finder.scene, p.id)]
        if not held and there.kind in NEARNESS and not there.negated:
            held = _nearest(finder.scene, found, there.anchors)
        if not held:
            says = ", ".join(finder.described(p) for p in found)
            raise InputError(f"there is no {phrase.noun.word} {_text(where)}; there is {says}")
        found = held
    return finder.ids(phrase, picks=picks, among=found)


def _nearest(scene: Scene, found: Sequence[Placement], anchors: Sequence[str]) -> list[Placement]:
    marks = [mark for name in anchors for mark in things(scene, name)]
    away = {p.id: min((ground_gap(things(scene, p.id)[0], mark) for mark in marks), default=CLOSE) for p in found}
    return [p for p in sorted(found, key=lambda p: away[p.id])[:1] if away[p.id] < CLOSE]
