"""Where something is said to be, as a relation that can be measured: of ids and parts of the room."""

import dataclasses
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, cast, get_args

from shapely import Point

from thinkblox.assets import facts_of
from thinkblox.assets.plurals import singular
from thinkblox.brief import RelationKind
from thinkblox.editing.finding import Finder, Picks, usual_anchor
from thinkblox.editing.goals import DrawnUp, Laid, PartOfTop
from thinkblox.editing.grammar import means, rank_of
from thinkblox.editing.orders import AWAY_SIDE, NounPhrase
from thinkblox.editing.rows import rows_of_all
from thinkblox.errors import InputError
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Mention
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Meaning, Where
from thinkblox.reading.english.parts import relation_at
from thinkblox.reading.english.places import corner, opening, wall
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import Landmark, corners, things
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import ON_FLOOR

_KINDS = frozenset(get_args(RelationKind))
_NAMED = {"in": "inside", "by": "next_to", "along": "next_to", "against": "next_to", "to": "next_to", "on_top": "on",
          "per": "next_to", "for": "next_to", "from": "on", "among": "between"}  # fmt: skip
"""Prepositions that are called otherwise as relations."""
_OPENINGS = ("window", "door")
_SIDES = {"left": "left_wall", "right": "right_wall", "back": "far_wall", "front": "near_wall"}
_COMPASS = {"north_wall": (0.0, 1.0), "south_wall": (0.0, -1.0), "east_wall": (1.0, 0.0), "west_wall": (-1.0, 0.0)}
SIDED = ("side", "end", "long_side", "short_side")
"""Parts that a thing has two of."""
_TWO_SIDED = (*SIDED, "head")
_POINTED = ("that wall", "this wall", "the same wall")
_OF_ONE = ("on", "on_top", "under", "behind", "in_front_of", "left_of", "right_of", "inside", "in", "above")
"""Prepositions after which a plural means each of them."""
SAME_LENGTH = 0.01
"""How much two walls of the same length may differ [m]."""
LONGER = 0.1
"""By how much a table is longer than it is deep at least that has long sides, at which one sits [m]."""
OVER_EYES = 1.5
"""How high a top is at most at the sides of which small things stand on it [m]."""
EMPTY, OVER_HEAD = 0.8, 1.9
"""How far from an empty corner the nearest thing is at least, and from which height on nothing counts [m]."""
AT_END = 0.35
"""How far beyond the end of a thing lies what is at that end [m]."""
_OPEN_TOPS = ("tables", "desks", "counters", "worktops", "beds", "lounges", "seats", "covers")
CROWDED = 1.7
"""How far from a corner what stands in it is counted [m]."""


@dataclass(frozen=True)
class Bound:
    """A relation to ids or Places, as a Tie has it.

    Attributes:
        of_room: it is turned into the room ("facing the room").
        part: on which part of the top of its anchor; empty where any will do.
        end: at the very end of the top on that part.
        side: at which side of its anchor a seat is drawn up to it.
        middle: at the middle of the walls that it stands against.
        seat: before which seat of a table it lies.
        head: beside the end that is behind, as the head of a bed is.
        upon: the thing that its anchor rests on, and it too, being small.
    """

    kind: RelationKind
    anchors: tuple[str, ...] = ()
    negated: bool = False
    of_room: bool = False
    part: PartOfTop | Literal[""] = ""
    end: bool = False
    side: RelationKind | None = None
    middle: bool = False
    seat: str = ""
    head: bool = False
    upon: str = ""

    def holds(self, scene: Scene, id: str) -> bool:
        """Whether an object has the relation, or has it not where it is negated."""
        if self.seat and not self.negated:
            return id in scene and Laid("on", self.anchors, seat=self.seat).check(scene, scene, id)[0]
        if self.side is not None and not self.negated:
            return id in scene and DrawnUp("at", self.anchors, side=self.side).check(scene, scene, id)[0]
        return measure(scene, self.kind, id, self.anchors, negated=self.negated).holds


def bound(where: Where, category: str, finder: Finder, *, picks: Sequence[Picks] = ()) -> Bound:
    """What a prepositional phrase says of a thing of a category.

    Raises:
        InputError: it names what is not there, could mean several, or says nothing that can be measured.
    """
    found = _bound(where, category, finder, picks)
    if found is None or found.kind not in _KINDS:
        raise InputError(f"'{place_text(where)}' is no place that a thing can be put")
    return _upon(found, category, finder)


def _upon(found: Bound, category: str, finder: Finder) -> Bound:
    """A place beside what rests on a thing, for something small: it rests on the same thing."""
    beside = found.kind in ("left_of", "right_of", "in_front_of", "behind", "next_to") and not found.negated
    if not beside or not facts_of(category).is_in("small") or len(found.anchors) != 1:
        return found
    if found.anchors[0] not in finder.scene or finder.scene[found.anchors[0]].support not in finder.scene:
        return found
    if facts_of(finder.scene[found.anchors[0]].category).is_in("built_in"):
        return found
    return dataclasses.replace(found, upon=finder.scene[found.anchors[0]].support)


def spot_of(where: Where, id: str, start: Scene, finder: Finder) -> Placement:
    """Where the thing stood before the instruction that a place names by it: "where the wardrobe was".

    Raises:
        InputError: it is not there, could be several, or stands there still, as does the thing itself.
    """
    noun, now = where.noun, finder.scene
    old = dataclasses.replace(finder, scene=start)
    spoken = noun is not None and noun.kind == "number"
    among = [start[i] for i in finder.recent if i in start] if spoken else None
    ids = old.ids(NounPhrase(noun, id=noun.id), among=among or None) if noun is not None else ()
    says = f"where {noun.text if noun is not None else 'it'} is"
    if len(ids) != 1:
        raise InputError(f"'{says}' could be the place of {', '.join(ids)}; say of which")
    if ids[0] in now and now[ids[0]] == start[ids[0]] and ids[0] != id:
        raise InputError(
            f"'{says}': {ids[0]} stands there still; say where that goes first, or let the two swap places"
        )
    return start[ids[0]]


def slots_for(where: Where, category: str, finder: Finder, count: int | None) -> list[Bound]:
    """The places that a phrase names for so many things: "in the corners" any of them, where these are not as many."""
    slots, noun = slots_of(where, category, finder), where.noun
    corners_ = noun is not None and noun.kind == "place" and noun.value.split()[0] == "corner"
    if corners_ and noun is not None and noun.plural and not (noun.each or noun.count or noun.det in ("all", "both")):
        if count is None or count >= len(slots):
            return slots
        told = where.whole is not None or noun.value != "corner"
        return slots[:count] if told else [Bound("in_corner", ("corner",))]
    return slots


def slots_of(where: Where, category: str, finder: Finder) -> list[Bound]:
    """The places that a phrase names, one for each where it speaks of each: "in every corner", "on both sides of"."""
    noun = where.noun
    whole = where.whole
    if noun is not None and noun.kind == "part" and whole is not None and whole.each and whole.kind == "thing":
        ids = finder.ids(NounPhrase(whole, id=whole.id))
        each = [dataclasses.replace(where, whole=dataclasses.replace(whole, det="the", id=id)) for id in ids]
        return [slot for one in each for slot in slots_of(one, category, finder)]
    if noun is None or where.negated or not _speaks_of_each(where, noun):
        return [bound(where, category, finder)]
    scene = finder.scene
    if noun.kind == "part":
        return _sides(where, noun, finder, category)
    if noun.kind == "place":
        name = noun.value.split()[0]
        if name == "corner":
            return [Bound("in_corner", walls) for walls in _each_corner(finder, where, noun, category)]
        one = bound(dataclasses.replace(where, noun=dataclasses.replace(noun, det="the", count=None)), category, finder)
        marks = [mark.name for mark in things(scene, name)]
        if noun.count and noun.count != len(marks):
            raise InputError(f"'{noun.text}': the room has {len(marks)} of them")
        return [dataclasses.replace(one, anchors=(mark,)) for mark in marks]
    found = _thing(where, noun, category, finder, ())
    singles = [dataclasses.replace(where, noun=dataclasses.replace(noun, det="the", id=id)) for id in found.anchors]
    if _may_be_laid(where, found.kind, category):
        found_each = [_thing(w, w.noun, category, finder, ()) for w in singles if w.noun is not None]
        return [_upon(one, category, finder) for one in found_each]
    return [_upon(dataclasses.replace(found, anchors=(anchor,)), category, finder) for anchor in found.anchors]


def _each_corner(finder: Finder, where: Where, noun: Noun, category: str) -> list[tuple[str, ...]]:
    """The walls of every corner that is meant: of all, of those at a door's or window's wall, of those that are empty.

    Raises:
        InputError: there are not so many, or what is said of them is not known.
    """
    scene, found = (
        finder.scene,
        [tuple(c.name.removeprefix("corner of ").split(" and ")) for c in corners(finder.scene.room)],
    )
    spots = {walls: c.centre for walls, c in zip(found, corners(scene.room), strict=True)}
    _, _, wall = noun.value.partition(" ")
    if wall:
        found = [walls for walls in found if walls_of(scene, wall) in walls]
    if "opposite" in noun.text.lower().split():
        return _farthest_corners(scene, found, besides=category)
    if where.whole is not None and where.whole.kind != "room":
        openings = [o for o in scene.room.openings if o.kind == where.whole.value]
        found = [walls for walls in found if {scene.room.walls[o.wall].name for o in openings} & set(walls)]
    told = [word for word in (*noun.states, *noun.unshown) if not means("clear", word)]
    if (noun.states or noun.unshown) and not told:
        taken = [p for p in scene.placements if scene.asset_of(p).collides and p.position[2] < OVER_HEAD]
        away = {
            walls: min((p.footprint.distance(Point(spots[walls])) for p in taken), default=EMPTY) for walls in found
        }
        found = [walls for walls in found if away[walls] >= EMPTY]
    elif told or noun.degree:
        raise InputError(f"'{noun.text}': which corners those are is not known; say 'the corner by the window'")
    if not found or (noun.count and noun.count != len(found)):
        raise InputError(f"'{place_text(where)}': the room has {len(found)} of them")
    return found


def _farthest_corners(scene: Scene, found: Sequence[tuple[str, ...]], *, besides: str) -> list[tuple[str, ...]]:
    """The two corners that are farthest from each other, of several such pairs that of which more floor is free.

    Things of the category `besides` take no floor: they are what goes there.
    """
    spots = {walls: c.centre for walls, c in zip(found, corners(scene.room), strict=True)}
    standing = [p for p in scene.placements if scene.asset_of(p).collides and p.position[2] < OVER_HEAD]
    taken = [*(p.footprint for p in standing if p.category != besides), *(d.footprint for d in things(scene, "door"))]
    free = {walls: min((outline.distance(Point(spots[walls])) for outline in taken), default=EMPTY) for walls in found}

    pairs = [(one, other) for one in found for other in found if one < other]

    def far_and_free(pair: tuple[tuple[str, ...], tuple[str, ...]]) -> tuple[float, float]:
        one, other = pair
        return round(math.dist(spots[one], spots[other]), 1), min(free[one], EMPTY) + min(free[other], EMPTY)

    best = max(pairs, key=far_and_free)
    return list(best)


def _speaks_of_each(where: Where, noun: Noun) -> bool:
    several = noun.each or noun.det == "both" or (noun.det == "all" and noun.plural)
    if noun.kind == "part":
        return noun.value in _TWO_SIDED and where.whole is not None and (several or noun.plural)
    if noun.kind == "place" and noun.value.split()[0] == "corner":
        return several or noun.plural
    if noun.kind == "pronoun":
        return noun.det in ("each", "both")
    if noun.kind == "thing":
        return several or (noun.plural and where.second is None and where.word in _OF_ONE and not noun.share)
    return noun.kind == "place" and several


def _sides(where: Where, noun: Noun, finder: Finder, category: str) -> list[Bound]:
    """The two sides, or the two ends, of a thing, a door or a window."""
    whole = where.whole
    if whole is None or whole.kind not in ("thing", "pronoun", "place"):
        raise InputError(f"'{place_text(where)}' is no place that a thing can be put")
    if whole.kind == "place":
        if whole.value not in _OPENINGS or not things(finder.scene, whole.value):
            raise InputError(f"'{place_text(where)}' is no place that a thing can be put")
        names = [mark.name for mark in things(finder.scene, opening_named(finder.scene, whole))]
        return [Bound(kind, (name,)) for name in names for kind in ("left_of", "right_of")]
    anchors = finder.ids(NounPhrase(whole, id=whole.id))
    bounds: list[Bound] = []
    for anchor in anchors:
        deep, wide, _ = finder.scene[anchor].size
        tables = facts_of(finder.scene[anchor].category).is_in("tables", "desks", "counters")
        seated = facts_of(category).is_in("seating") and tables
        long = noun.value == "long_side" or (noun.value == "side" and seated and abs(deep - wide) > LONGER)
        across = long == (deep > wide) if long or noun.value != "side" else True
        kinds: tuple[RelationKind, RelationKind] = ("left_of", "right_of") if across else ("in_front_of", "behind")
        small = [facts_of(name).is_in("small") for name in (category, finder.scene[anchor].category)]
        tops = [s.position[2] for s in finder.scene.asset_of(finder.scene[anchor]).surfaces]
        if small == [True, False] and tops and max(tops) < OVER_EYES:
            parts: tuple[PartOfTop, ...] = ("left", "right") if across else ("front", "back")
            bounds += [Bound("on", (anchor,), part=part, end=noun.value == "end") for part in parts]
            continue
        if seated:
            bounds += [Bound("at", (anchor,), side=kind) for kind in kinds]
        else:
            bounds += [_upon(Bound(kind, (anchor,)), category, finder) for kind in kinds]
    return bounds


def place_text(where: Where) -> str:
    """A place as it was said."""
    joined = where.noun is not None and where.noun.text.endswith((" by", " with"))
    whole = f"{'' if joined else ' of'} {where.whole.text}" if where.whole is not None else ""
    return f"{where.text} {where.noun.text if where.noun else ''}{whole}".strip()


def _bound(where: Where, category: str, finder: Finder, picks: Sequence[Picks]) -> Bound | None:
    noun = where.noun
    if noun is None:
        return None
    if noun.kind == "people":
        faced = _faced(noun, finder) if where.word in ("facing", "opposite", "to") else None
        return _thing(where, faced or _thing_of(noun, finder), category, finder, picks)
    if noun.kind == "room":
        return Bound("facing", of_room=True) if where.word in ("facing", "to", "near", "at", "opposite") else None
    if noun.kind == "part":
        return _part(where, noun, category, finder)
    if noun.kind == "place":
        return _place(where, noun, finder)
    if where.word == "between" and noun.rows and where.second is None:
        return _between_rows(where, noun, finder)
    return _thing(where, noun, category, finder, picks)


def _between_rows(where: Where, noun: Noun, finder: Finder) -> Bound:
    """Between the only two rows of the room: between what is nearest to the middle of all in either.

    Raises:
        InputError: there are more of them, or none.
    """
    rows = rows_of_all(finder.scene)
    if len(rows) != 2 or noun.ordinal or noun.rows not in (-1, 2):
        raise InputError(
            f"'{place_text(where)}': there are {len(rows)} rows; say which, such as 'the first and the second row'"
        )
    every = [p.position for row in rows for p in row]
    x, y = (sum(spot[axis] for spot in every) / len(every) for axis in (0, 1))
    kinds = [row[0].category for row in rows]
    heads = [[p for p in row if p.category == kind] for row, kind in zip(rows, kinds, strict=True)]
    one, other = (min(row, key=lambda p: math.dist(p.position[:2], (x, y))) for row in heads)
    return Bound("between", (one.id, other.id), where.negated)


def _beside_opening(where: Where, noun: Noun, whole: Noun | None, finder: Finder) -> Bound | None:
    """To the left or the right of a door or window, or at the other side of it; None of anything else."""
    if whole is None or whole.kind != "place" or whole.value not in _OPENINGS:
        return None
    if noun.value == "side" and noun.det == "other":
        return _across_opening(where, opening_named(finder.scene, whole), finder)
    if noun.value not in ("left", "right"):
        return None
    beside: RelationKind = "left_of" if noun.value == "left" else "right_of"
    return Bound(beside, (opening_named(finder.scene, whole),), where.negated)


def _across_opening(where: Where, name: str, finder: Finder) -> Bound:
    """The side of a door or window across from that at which stands what is moved."""
    here = _here(finder, place_text(where)).position[:2]
    marks = sorted(things(finder.scene, name), key=lambda mark: math.dist(mark.centre, here))
    if not marks:
        raise InputError(f"the room has no {name}")
    side: RelationKind = "right_of" if marks[0].to_local(here)[1] > 0 else "left_of"
    return Bound(side, (marks[0].name,), where.negated)


def _faced(noun: Noun, finder: Finder) -> Noun | None:
    """What is in the middle of the front row, at which those sit who look ahead: "the pupils"; None of others."""
    rows = rows_of_all(finder.scene) if means("audience", singular(noun.word.lower())) else []
    front = [p for p in rows[0] if p.category == rows[0][0].category and p.id != finder.about] if rows else []
    at = front[len(front) // 2] if front else None
    return Noun("thing", at.category, 0, 0, noun.text, det="the", id=at.id) if at is not None else None


def _thing_of(noun: Noun, finder: Finder) -> Noun:
    """The desk or table of somebody: of "the teacher" what is called the teacher's, or else would be.

    Raises:
        InputError: none is somebody's in this room.
    """
    owner, scene = noun.word, finder.scene
    worked_at = [p for p in scene.placements if facts_of(p.category).is_in("desks", "tables", "counters")]
    called = [p for p in worked_at if scene.asset_of(p).name.lower().startswith((f"{owner}'s ", f"{owner} "))]
    if len(called) == 1:
        return Noun("thing", called[0].category, 0, 0, noun.text, det="the", id=called[0].id)
    raise InputError(f"'{noun.text}': nothing in the room is known to be of one; name a thing, such as a desk")


def _part(where: Where, noun: Noun, category: str, finder: Finder) -> Bound | None:
    """To the left of the sofa, at the foot of the bed, in the middle of the table or of the room."""
    whole = where.whole or (Noun("thing", noun.owner, 0, 0, noun.owner) if noun.owner else None)
    if whole is None and noun.det == "my":
        whole = Noun("pronoun", "it", 0, 0, "it")
    if whole is None or whole.kind in ("room", "place", "abstract"):
        if (beside := _beside_opening(where, noun, whole, finder)) is not None:
            return beside
        if noun.value == "middle" and whole is not None and whole.kind == "place":
            return _middle_of(where, whole, finder)
        if noun.value == "middle":
            top = _top_spoken_of(finder, category) if whole is None else ""
            return Bound("in_centre", (top or "centre",), where.negated)
        side = _SIDES.get(noun.value)
        return Bound("against_wall", (walls_of(finder.scene, side),), where.negated) if side else None
    anchors = _its_own(finder, noun, finder.ids(NounPhrase(whole, id=whole.id), picks=(usual_anchor(category),)))
    if noun.value == "side" and noun.count == 1 and where.word != "from":
        raise InputError(f"'{place_text(where)}': which side? Say 'the left side', or 'in front of'")
    if part := _part_of_top(where, noun, category, finder, anchors[0]):
        return Bound("on", anchors, where.negated, part=part, end=part != "end" and noun.word.lower() == "end")
    if where.second is not None and len(anchors) == 1:
        return Bound(_side_towards(finder, where, where.second, anchors[0]), anchors, where.negated)
    if noun.value in ("side", "end") and noun.det == "other":
        side = _other_side(finder, where, anchors[0], category)
        drawn = facts_of(category).is_in("seating") and load_habits().is_in(
            finder.scene[anchors[0]].category, "tables", "desks"
        )
        return Bound("at", anchors, side=side) if drawn and not where.negated else Bound(side, anchors, where.negated)
    return _at_part(where, noun, category, finder, anchors)


def _its_own(finder: Finder, part: Noun, anchors: tuple[str, ...]) -> tuple[str, ...]:
    """Of several things at whose other side each of others goes, that which the one in hand is nearest to."""
    if len(anchors) < 2 or part.det != "other" or finder.about not in finder.scene:
        return anchors
    mark = things(finder.scene, finder.about)[0]
    return (min(anchors, key=lambda id: ground_gap(mark, things(finder.scene, id)[0])),)


def _at_part(where: Where, noun: Noun, category: str, finder: Finder, anchors: tuple[str, ...]) -> Bound:
    """At a part of a thing as prompts mean it; at the end of what has no top for it to the left or right of it."""
    kind = cast(RelationKind, relation_at(noun.value, category, Mention(finder.scene[anchors[0]].category)))
    if kind != "next_to" or where.negated:
        return Bound(kind, anchors, where.negated)
    if noun.value == "end" and len(anchors) == 1:
        return Bound(_nearest_end(finder, anchors[0]), anchors)
    return Bound(kind, anchors, head=noun.value == "head")


def _nearest_end(finder: Finder, anchor: str) -> RelationKind:
    """The left or the right of a thing: that at which more floor is free, or on which what is moved stands."""
    scene, thing = finder.scene, finder.scene[anchor]
    others = [p.footprint for p in scene.placements if p.id not in (anchor, finder.about) and p.support == "floor"]
    others = [outline for outline in others if outline.intersection(thing.footprint).is_empty]
    free: dict[RelationKind, float] = {}
    sides: tuple[tuple[RelationKind, float], ...] = (("left_of", 1.0), ("right_of", -1.0))
    for kind, sign in sides:
        spot = Point(thing.to_room((0.0, sign * (thing.size[1] / 2 + AT_END))))
        inside = scene.room.polygon.contains(spot)
        free[kind] = min((outline.distance(spot) for outline in others), default=AT_END) if inside else -1.0
    if finder.about in scene and min(free.values()) >= AT_END / 2:
        return "left_of" if thing.to_local(scene[finder.about].position[:2])[1] > 0 else "right_of"
    return max(free, key=lambda kind: min(free[kind], AT_END))


def _middle_of(where: Where, whole: Noun, finder: Finder) -> Bound:
    """The middle of a wall, or before the middle of a window or door.

    Raises:
        InputError: it is none of them.
    """
    found = _place(Where("against", whole, text="against"), whole, finder) if "wall" in whole.value else None
    if found is None or where.negated:
        raise InputError(f"'{place_text(where)}' is no place that a thing can be put")
    return dataclasses.replace(found, middle=True)


def _side_towards(finder: Finder, where: Where, mark: Noun, anchor: str) -> RelationKind:
    """The side of a thing that is nearest to another, or farthest from it; of what stands at a wall its left or right.

    Raises:
        InputError: the other is not there, or could be several.
    """
    scene, thing = finder.scene, finder.scene[anchor]
    names = (opening_named(scene, mark),) if mark.kind == "place" else finder.ids(NounPhrase(mark, id=mark.id))
    marks = [mark for name in names for mark in things(scene, name)]
    if not marks:
        raise InputError(f"the room has no {mark.text}")
    nearest = min(marks, key=lambda m: math.dist(m.centre, thing.position[:2]))
    ahead, left = thing.to_local(nearest.centre)
    sign = -1.0 if where.text == AWAY_SIDE else 1.0
    walled = measure(scene, "against_wall", anchor, ("wall",)).holds
    if walled or abs(left) >= abs(ahead):
        return "left_of" if sign * left > 0 else "right_of"
    return "in_front_of" if sign * ahead > 0 else "behind"


def _other_side(finder: Finder, where: Where, anchor: str, category: str) -> RelationKind:
    """The side of a thing across from that at which stands what is moved, or the one such thing that is there."""
    thing = finder.scene[anchor]
    there = [p for p in finder.scene.placements if p.category == category and p.id != anchor]
    there = [p for p in there if any(measure(finder.scene, kind, p.id, (anchor,)).holds for kind in ("at", "next_to"))]
    here = there[0] if finder.about not in finder.scene and len(there) == 1 else _here(finder, place_text(where))
    ahead, left = thing.to_local(here.position[:2])
    ended = where.noun is not None and where.noun.value == "end" and thing.size[0] != thing.size[1]
    if finder.scene.asset_of(thing).mount == "wall":
        return "right_of" if left > 0 else "left_of"
    if thing.size[0] > thing.size[1] if ended else abs(ahead) / thing.size[0] >= abs(left) / thing.size[1]:
        return "behind" if ahead > 0 else "in_front_of"
    return "right_of" if left > 0 else "left_of"


def _top_spoken_of(finder: Finder, category: str) -> str:
    """What carries such things of that which was named last, or carries that: in whose middle something small goes."""
    if not facts_of(category).is_in("small"):
        return ""
    named = [id for id in reversed(finder.recent) if id in finder.scene]
    tops = [id for last in named for id in (last, finder.scene[last].support) if id in finder.scene]
    return next((id for id in tops if facts_of(finder.scene[id].category).is_in("tables", "desks")), "")


def _part_of_top(where: Where, noun: Noun, category: str, finder: Finder, anchor: str) -> PartOfTop | Literal[""]:
    """Which part of a thing's top something small is to stand on: "on the left side of the desk"."""
    thing = finder.scene[anchor]
    bare = noun.word.lower() not in ("end", "side", "edge", "corner", "half")
    there = where.word in ("on", "at") or (where.word == "to" and not bare)
    on_top = there and facts_of(category).is_in("small") and finder.scene.asset_of(thing).surfaces
    if there and noun.word.lower() == "edge" and facts_of(category).is_in("small"):
        return "end"
    if not on_top or noun.value not in (*get_args(PartOfTop), "side"):
        return ""
    sided = cast(PartOfTop, noun.value)
    if noun.value not in ("end", "side"):
        return sided
    if noun.det != "other":
        return "end" if noun.value == "end" else ""
    here = _here(finder, place_text(where))
    if thing.support in finder.scene and here.support != anchor:
        return ""
    ahead, left = thing.to_local(here.position[:2])
    if thing.size[0] > thing.size[1]:
        return "back" if ahead > 0 else "front"
    return "right" if left > 0 else "left"


def _place(where: Where, noun: Noun, finder: Finder) -> Bound | None:
    if noun.value == "wall" and noun.states == ["new"]:
        noun = dataclasses.replace(noun, value=_wall_moved(finder, noun), states=[])
    told = bool(noun.states) or any(word != noun.degree for word in noun.unshown)
    if noun.value == "corner" and told and noun.det in ("a", "any", "another") and not where.negated:
        return Bound("in_corner", _each_corner(finder, where, noun, "")[0])
    return _place_named(where, noun, finder)


def _place_named(where: Where, noun: Noun, finder: Finder) -> Bound | None:
    name, *walls = noun.value.split()
    nearest = bool(means("nearest", noun.degree))
    told = [word for word in noun.unshown if word != noun.degree]
    if (noun.states or (told if nearest else noun.unshown)) and not where.negated:
        raise InputError(
            f"'{place_text(where)}': which that is is not known; name the wall, the corner or what is beside it"
        )
    if where.word == "between" and where.second is not None:
        return _between_places(where, name, where.second, finder)
    if name == "centre":
        whole = where.whole
        anchors = finder.ids(NounPhrase(whole)) if whole is not None and whole.kind in ("thing", "pronoun") else (name,)
        return Bound("in_centre", anchors, where.negated)
    if name in ("floor", "ceiling"):
        return Bound("on", (name,), where.negated)
    if name in _COMPASS and where.whole is not None and where.whole.kind in ("thing", "pronoun"):
        return _side_by_compass(where, where.whole, name, finder)
    if name in _OPENINGS:
        meaning = _opening(where, noun, name, finder)
    elif name == "corner":
        beside = _corner_beside(where, noun, finder)
        word = "in" if where.word == "from" else where.word
        meaning = Meaning("in_corner", beside) if beside else corner(word, noun, walls, 0)
    else:
        meaning = _wall(where, noun, name, finder)
    if meaning is None:
        return None
    if name in _COMPASS and meaning.anchors == (name,) and meaning.kind in ("against_wall", "on"):
        meaning = dataclasses.replace(meaning, anchors=(name, *(wall for wall in walls if wall in _COMPASS)))
    anchors = tuple(walls_of(finder.scene, str(anchor)) for anchor in meaning.anchors)
    return Bound(cast(RelationKind, meaning.kind), anchors, where.negated)


def opening_named(scene: Scene, noun: Noun) -> str:
    """The door or window that a phrase means by the side of the room that it is at: "the north window"; else its kind.

    Raises:
        InputError: none is at that side, or several are.
    """
    kind = noun.value.split()[0]
    side = next((word for word in noun.text.lower().split() if f"{word}_wall" in _COMPASS), "")
    if kind not in _OPENINGS or not side:
        return kind
    found = [o.id for o in scene.room.openings if o.kind == kind and scene.room.walls[o.wall].name.startswith(side)]
    if len(found) != 1:
        raise InputError(f"'{noun.text}': the room has {len(found)} such: {', '.join(found) or 'none'}")
    return found[0]


def _nearest_mark(finder: Finder, noun: Noun, marks: Sequence[Landmark]) -> str:
    """The name of the wall, corner, door or window that is nearest to what is moved, or farthest from it.

    Raises:
        InputError: the room has none, or nothing is moved.
    """
    if not marks:
        raise InputError(f"the room has no {noun.word}")
    here = things(finder.scene, _here(finder, f"the {noun.degree} {noun.word}").id)[0]
    ordered = sorted(marks, key=lambda mark: round(ground_gap(here, mark), 3))
    return (ordered[0] if means("nearest", noun.degree) == "nearest" else ordered[-1]).name


def _between_places(where: Where, name: str, second: Noun, finder: Finder) -> Bound:
    """Between a part of the room and another, or a thing.

    Raises:
        InputError: the room has none of that.
    """
    other = (second.value.split()[0],) if second.kind == "place" else finder.ids(NounPhrase(second, id=second.id))
    for place in (name, *other):
        if not things(finder.scene, place):
            raise InputError(f"the room has no {place.replace('_', ' ')}")
    return Bound("between", (name, *other), where.negated)


def _side_by_compass(where: Where, whole: Noun, name: str, finder: Finder) -> Bound:
    """The north side of a thing, as its front, back, left or right."""
    ids = finder.ids(NounPhrase(whole, id=whole.id))
    if len(ids) != 1:
        raise InputError(f"'{place_text(where)}' could be at {', '.join(ids)}; say at which")
    thing, (x, y) = finder.scene[ids[0]], _COMPASS[name]
    ahead, across = x * thing.front[0] + y * thing.front[1], x * thing.left[0] + y * thing.left[1]
    if abs(ahead) >= abs(across):
        return Bound("in_front_of" if ahead > 0 else "behind", ids, where.negated)
    return Bound("left_of" if across > 0 else "right_of", ids, where.negated)


def _opening(where: Where, noun: Noun, name: str, finder: Finder) -> Meaning | None:
    if any("sill" in word for word in noun.text.lower().split()):
        raise InputError(f"'{place_text(where)}': sills carry nothing here; name what stands by the window, or a shelf")
    if not any(o.kind == name for o in finder.scene.room.openings):
        raise InputError(f"the room has no {name}")
    named = opening_named(finder.scene, noun)
    mark = _nearest_mark(finder, noun, things(finder.scene, name)) if means("nearest", noun.degree) else named
    return Meaning("under", (mark,)) if where.word == "under" else _of_mark(opening(where.word, name), mark)


def _of_mark(meaning: Meaning | None, mark: str) -> Meaning | None:
    return dataclasses.replace(meaning, anchors=(mark,)) if meaning is not None else None


def _wall(where: Where, noun: Noun, name: str, finder: Finder) -> Meaning | None:
    meaning = wall(where.word, noun, name, 0, each=noun.each)
    if meaning is None:
        return None
    if noun.text.lower() in _POINTED and (pointed := _wall_left(finder)):
        meaning = dataclasses.replace(meaning, anchors=(pointed,))
    elif means("nearest", noun.degree):
        marks = things(finder.scene, "wall")
        meaning = dataclasses.replace(meaning, anchors=(_nearest_mark(finder, noun, marks),))
    elif noun.degree:
        meaning = dataclasses.replace(meaning, anchors=_walls_by_length(finder.scene, noun))
    if meaning.anchors == ("opposite_wall",) or where.second or _is_beside(where, name):
        meaning = dataclasses.replace(meaning, anchors=(_opposite_wall(finder, where),))
    stands = noun.word == "side" or _stands(finder)
    return dataclasses.replace(meaning, kind="against_wall") if meaning.kind == "on" and stands else meaning


def _wall_left(finder: Finder) -> str:
    """The wall at which stood what the same instruction takes away; empty where nothing was, or it stood at none."""
    gone = finder.vacated
    if gone is None or finder.start is None or gone.id not in finder.start:
        return ""
    at = [w for w in finder.scene.room.walls if measure(finder.start, "against_wall", gone.id, (w.name,)).holds]
    return min(at, key=lambda w: turn_between(w.yaw, gone.yaw)).name if at else ""


def _wall_moved(finder: Finder, noun: Noun) -> str:
    """The wall that the same instruction has moved: "(make the room wider and put a piano at) the new wall".

    Raises:
        InputError: it has moved none, or several.
    """
    old = finder.start.room.walls if finder.start is not None else finder.scene.room.walls
    pairs = zip(old, finder.scene.room.walls, strict=True) if len(old) == len(finder.scene.room.walls) else ()
    moved = [now.name for was, now in pairs if abs(was.coordinates(now.start)[1]) > SAME_LENGTH]
    if len(moved) != 1:
        raise InputError(f"'{noun.text}': {', '.join(moved) or 'no wall'} has moved; say which, as 'the north wall'")
    return moved[0]


def _walls_by_length(scene: Scene, noun: Noun) -> tuple[str, ...]:
    """The longest or the shortest walls.

    Raises:
        InputError: they are compared by something else.
    """
    rank, along = rank_of(noun.degree)
    if not rank or along in ("height", "level") or noun.value != "wall":
        raise InputError(f"'{noun.text}': which wall that is is not known; say 'the north wall'")
    most = max(rank * wall.length for wall in scene.room.walls)
    return tuple(wall.name for wall in scene.room.walls if abs(rank * wall.length - most) < SAME_LENGTH)


def told_by(where: Where, finder: Finder) -> tuple[str, ...]:
    """The things by which a corner is told, on which nothing stands that is put there: "the corner by the wardrobe"."""
    noun, beside = where.noun, where.whole or where.second
    cornered = noun is not None and noun.kind == "place" and noun.value.split()[0] == "corner"
    if not cornered or where.negated or beside is None or beside.kind != "thing":
        return ()
    return finder.ids(NounPhrase(beside, id=beside.id))


def _stands(finder: Finder) -> bool:
    """Whether what is moved stands on the floor."""
    return finder.about in finder.scene and finder.scene.asset_of(finder.scene[finder.about]).mount == "floor"


def _is_beside(where: Where, name: str) -> bool:
    """Whether it is "the wall behind the sofa"."""
    return name == "wall" and where.whole is not None and where.whole.kind in ("thing", "place")


def _corner_beside(where: Where, noun: Noun, finder: Finder) -> tuple[str, ...] | None:
    """The walls of "the corner by the window", "the corner opposite the door", "the other corner"."""
    other = noun.det == "other" or "opposite" in noun.text.lower().split()
    if means("nearest", noun.degree):
        mark_name = _nearest_mark(finder, noun, corners(finder.scene.room, noun.value.split()[1:]))
        return tuple(mark_name.removeprefix("corner of ").split(" and "))
    mark = where.whole or where.second
    mark = None if mark is not None and mark.kind == "room" else mark
    if not other and (mark is None or mark.kind not in ("place", "thing")):
        return None
    found = list(corners(finder.scene.room, noun.value.split()[1:]))
    if other:
        here = _here(finder, place_text(where))
        nearest = min(corners(finder.scene.room), key=lambda c: math.dist(c.centre, here.position[:2]))
        found = [c for c in found if c.name != nearest.name]
    if mark is not None:
        by = opening_named(finder.scene, mark) if mark.value in _OPENINGS else mark.value
        name = by if mark.kind == "place" else finder.ids(NounPhrase(mark, id=mark.id))[0]
        if not things(finder.scene, name) or not found:
            raise InputError(f"the room has no corner {where.text} {mark.text}")
        found = _corners_by(finder.scene, found, name)
        found = found[::-1] if where.second is not None else found
    elif other and len(found) > 1 and "opposite" in noun.text.lower().split():
        found.sort(key=lambda c: -math.dist(c.centre, here.position[:2]))
    elif len(found) > 1:
        others = [p for p in finder.scene.placements if p.id != finder.about and finder.scene.asset_of(p).collides]
        room = {c.name: min((p.footprint.distance(c.footprint) for p in others), default=EMPTY) for c in found}
        found.sort(key=lambda c: (-min(round(room[c.name], 1), EMPTY), math.dist(c.centre, here.position[:2])))
    if not found:
        raise InputError(f"the room has no such corner: '{place_text(where)}'")
    return tuple(found[0].name.removeprefix("corner of ").split(" and "))


def corner_told(finder: Finder, beside: Noun) -> tuple[str, ...]:
    """The walls of the corner that is told by what is beside it.

    Raises:
        InputError: the room has none of that.
    """
    noun = Noun("place", "corner", 0, 0, "the corner", det="the")
    return _corner_beside(Where("in", noun, whole=beside, text="in"), noun, finder) or ()


def _here(finder: Finder, text: str) -> Placement:
    """What is moved, from where it stands.

    Raises:
        InputError: nothing is there from which "the other side" could be told.
    """
    if finder.about not in finder.scene:
        raise InputError(f"'{text}': the other one than which? Name it, such as 'the north wall'")
    return finder.scene[finder.about]


def _opposite_wall(finder: Finder, where: Where) -> str:
    """The wall across from that which a thing stands at, or from what the phrase names."""
    scene, beside = finder.scene, where.second or where.whole
    if beside is not None:
        name = beside.value if beside.kind == "place" else finder.ids(NounPhrase(beside, id=beside.id))[0]
        marks = things(scene, name)
        if not marks:
            raise InputError(f"the room has no {name.replace('_', ' ')}")
        _check_at_one_wall(scene, where, name)
        spot = marks[0].centre
        if where.second is not None and name in scene and scene.asset_of(scene[name]).front == "one":
            x, y = scene[name].front
            return max(scene.room.walls, key=lambda w: (round(-w.inward[0] * x - w.inward[1] * y, 3), w.length)).name
    else:
        spot = _here(finder, place_text(where)).position[:2]
    walls = scene.room.walls
    away = [abs(wall.coordinates(spot)[1]) for wall in walls]
    near = walls[min(range(len(walls)), key=lambda n: away[n])]
    if beside is not None and where.second is None:
        return near.name
    return min(walls, key=lambda w: (w.inward[0] * near.inward[0] + w.inward[1] * near.inward[1], -w.length)).name


def _check_at_one_wall(scene: Scene, where: Where, kind: str) -> None:
    """Refuse "the wall with the window" where windows are in several.

    Raises:
        InputError: they are; says in which.
    """
    walls = dict.fromkeys(scene.room.walls[o.wall].name for o in scene.room.openings if o.kind == kind)
    if len(walls) > 1:
        raise InputError(f"'{place_text(where)}': a {kind} is in {' and in '.join(walls)}; say which wall")


def corner_near(scene: Scene, name: str) -> tuple[str, ...]:
    """The names of the two walls of the corner nearest to a thing or part of the room.

    Raises:
        InputError: the scene has no such thing, or no corner.
    """
    found = corners(scene.room)
    if not things(scene, name) or not found:
        raise InputError(f"the room has no corner by the {name.replace('_', ' ')}")
    return tuple(_corners_by(scene, found, name)[0].name.removeprefix("corner of ").split(" and "))


def _corners_by(scene: Scene, found: Sequence[Landmark], name: str) -> list[Landmark]:
    """Corners by their distance from a thing or part of the room; of those at a window what is at a door comes last.

    Of two that are as near, the emptier one comes first.
    """
    marks = things(scene, name)
    others = [mark for kind in _OPENINGS if name in _OPENINGS and kind != name for mark in things(scene, kind)]

    def away(corner: Landmark, marks: Sequence[Landmark]) -> float:
        return min((float(mark.footprint.distance(corner.footprint)) for mark in marks), default=math.inf)

    def rank(corner: Landmark) -> tuple[bool, float, int]:
        near = away(corner, marks)
        crowd = sum(math.dist(p.position[:2], corner.centre) < CROWDED for p in scene.placements)
        return away(corner, others) < near, round(near, 1), crowd

    return sorted(found, key=rank)


def walls_of(scene: Scene, place: str) -> str:
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
    own = noun.det == "my" and noun.text.lower().split()[:1] in (["its"], ["their"])
    if own and finder.about in finder.scene:
        anchors: tuple[str, ...] = (_own(finder, noun),)
    else:
        anchors = finder.ids(phrase, picks=(*picks, usual_anchor(category)))
    if where.second is not None:
        second = where.second
        more = (second.value,) if second.kind == "place" else finder.ids(NounPhrase(second))
        anchors = (*anchors, *more)
    if not anchors:
        raise InputError(f"'{place_text(where)}': there is nothing yet that '{noun.text}' could be")
    kind = _fitting(kind, where, category, anchors[0], finder)
    if _may_be_laid(where, kind, category) and len(anchors) == 1:
        table = table_of(finder.scene, anchors[0])
        return Bound("on", (table,), seat=anchors[0]) if table else Bound(kind, anchors)
    return Bound(kind, anchors)


def _may_be_laid(where: Where, kind: RelationKind, category: str) -> bool:
    """Whether something small lies on the table before a seat when it is put there."""
    return facts_of(category).is_in("small") and (kind in ("in_front_of", "at") or where.word in ("at", "by"))


def table_of(scene: Scene, seat: str) -> str:
    """The table that a seat is drawn up to; empty where it is none, or at none."""
    if not facts_of(scene[seat].category).is_in("seating"):
        return ""
    tables = [p.id for p in scene.placements if facts_of(p.category).is_in("tables", "desks", "counters")]
    return next((table for table in tables if measure(scene, "at", seat, (table,)).holds), "")


def _own(finder: Finder, noun: Noun) -> str:
    """The one of a kind that is nearest to what is moved: "its desk"."""
    found = finder.matching(dataclasses.replace(noun, plural=True, count=None))
    mark = things(finder.scene, finder.about)[0]
    near = [p.id for p in found if p.id != finder.about]
    if not near:
        raise finder.nothing(noun.text)
    return min(near, key=lambda id: ground_gap(mark, things(finder.scene, id)[0]))


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
    seat = facts_of(category).is_in("seating")
    if kind in ("under", "inside") and seat and habits.is_in(name, "tables", "desks"):
        return "at"
    if kind == "behind" and seat and habits.is_in(name, "desks") and asset.gaze == "back":
        return "at"
    if kind == "inside" and habits.is_in(name, *_OPEN_TOPS):
        return "on"
    if kind == "on" and small and habits.is_in(name, "shelves") and not any(not s.inner for s in asset.surfaces):
        return "inside"
    if kind == "next_to" and where.word == "against" and asset.front == "one":
        return "next_to"
    return cast(RelationKind, kind)
