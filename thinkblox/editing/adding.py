"""Orders that bring something: add it, or let it come in place of another thing."""

import dataclasses
from collections.abc import Iterator, Sequence

from thinkblox.assets import GENERAL_WORDS
from thinkblox.brief import Measures
from thinkblox.editing.carrying import place_anew, put_back, take, usual_ties
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import At, Goal, Related
from thinkblox.editing.moving import looking, related
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reaching import Reaching, ties_of
from thinkblox.editing.spots import Pose, spots
from thinkblox.editing.wheres import Bound, bound, named, spare
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.judging import asset_for, style_seed
from thinkblox.plan import Target
from thinkblox.reading.draft import Bond, Draft, Mention
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.senses import choose_senses
from thinkblox.scene.actions import Replace, outcome
from thinkblox.scene.asset import Asset
from thinkblox.scene.nearby import nearest_poses
from thinkblox.scene.scene import Scene

_BY = ("with", "by", "for")
MOST = 20
"""Most things that one order adds."""
NEW_PLACE = 0.75
"""How far from the old one's middle the new one may stand that comes in its place, besides half its growth [m]."""


def add(work: Work, finder: Finder, order: Order) -> None:
    """Add things where an order says, or where such things usually stand."""
    if not order.things:
        raise InputError(f"'{order.text}' does not say what to add")
    recent: list[str] = []
    before = bool(finder.recent)
    for number, phrase in enumerate(order.things):
        later = next((p.places for p in order.things[number:] if p.places), order.places)
        if not before:
            later = [w for w in later if w.noun is None or w.noun.kind != "pronoun"]
        recent += _add(work, finder, order, phrase, phrase.places or later)
        finder.scene, finder.recent = work.scene, recent or finder.recent
    finder.recent = recent


def _add(work: Work, finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]) -> list[str]:
    noun = phrase.noun
    if noun.kind != "thing":
        raise InputError(f"'{noun.text}' is no thing that can be added")
    count = noun.count or (2 if noun.plural else 1)
    if count > MOST:
        raise InputError(f"'{noun.text}': one order adds at most {MOST} things")
    wheres = _bounds(work, finder, noun, places)
    category = category_of(work, noun, wheres)
    each = next(
        (w for w, where in zip(wheres, places, strict=True) if where.noun is not None and where.noun.each), None
    )
    if each is not None:
        count = max(count, len(each.anchors))
    added = []
    for index in range(count):
        spots = [Bound(w.kind, (w.anchors[index % len(w.anchors)],), w.negated) if w is each else w for w in wheres]
        goals = [_related(work, w, category, index, count) for w in spots]
        goals += [looking(finder, n) for n in order.facing]
        id = _add_one(work, category, noun, goals)
        if not id:
            break
        added.append(id)
    if len(added) < count and count > 1:
        work.failed.append(f"{len(added)} of {count} {category.replace('_', ' ')} were added")
    return added


def _related(work: Work, where: Bound, category: str, index: int, count: int) -> Goal:
    """The goal of one of several that are added to those that are there."""
    there = _there(work, where, category)
    return related(where, category, there + (0 if where.kind == "around" else index), there + count - index)


def _bounds(work: Work, finder: Finder, noun: Noun, places: Sequence[Where]) -> list[Bound]:
    guess = noun.value if noun.value not in GENERAL_WORDS else category_of(work, noun, ())
    return [bound(where, guess, finder) for where in places]


def _there(work: Work, where: Bound, category: str) -> int:
    """How many of its kind are around the same thing already."""
    if where.kind != "around":
        return 0
    alike = [p.id for p in work.scene.placements if p.category == category]
    return sum(Bound("at", where.anchors).holds(work.scene, id) for id in alike)


def category_of(work: Work, noun: Noun, wheres: Sequence[Bound]) -> str:
    """The category that a noun means in this room and at that place: a "lamp" on a nightstand is a table lamp."""
    draft = Draft()
    thing = Mention(noun=noun.value, count=noun.count, plural=noun.plural, attributes=list(noun.attributes))
    draft.things.append(thing)
    draft.room = work.planned.brief.room_type if work.planned is not None else ""
    for where in wheres:
        for anchor in where.anchors:
            whole = Mention(work.scene[anchor].category) if anchor in work.scene else anchor
            draft.bonds.append(Bond(where.kind, thing, (whole,)))
    choose_senses(draft, {p.category for p in work.scene.placements})
    work.source.usual(thing.noun)
    return thing.noun


def _add_one(work: Work, category: str, noun: Noun, goals: Sequence[Goal]) -> str:
    """Add one thing; its id, or an empty text where that cannot be, which is noted."""
    id = work.new_id(category)
    attributes, ties = tuple(noun.attributes), ties_of(goals)
    if all(tie.kind in ("facing", "opposite") for tie in ties):
        ties = (*usual_ties(work.scene, category), *ties)
    target = work.target(id, category, ties, attributes)
    asset = _asset(work, target, noun)
    seated = any(isinstance(goal, Related) and goal.measured == "at" for goal in goals)
    direct = spots(work.scene, asset, goals) if seated else ()
    reaching = Reaching(work, target, asset, goals, direct=direct)
    if not reaching.run():
        work.failed.append(f"{id} was not added: {reaching.why}")
        return ""
    placement = work.scene[id]
    found = "; ".join(dict.fromkeys(goal.check(work.before, work.scene, id)[1] for goal in goals))
    x, y, _ = placement.position
    on = f" on {placement.support}" if placement.support != "floor" else ""
    work.done.append(f"{id} added at ({x:.2f}, {y:.2f}){on}{f' ({found})' if found else ''}")
    return id


def _asset(work: Work, target: Target, noun: Noun) -> Asset:
    """What is added: another one like those that are there, unless something else is said of it."""
    alike = [p for p in work.scene.placements if p.category == target.category]
    size = _size(work, target.category, noun)
    if alike and not target.attributes and size == (None, None, None):
        return work.scene.asset_of(alike[-1])
    return asset_for(
        Target(id=target.id, category=target.category, request=target.request, attributes=target.attributes, size=size),
        work.scene,
        work.source,
    )


def _size(work: Work, category: str, noun: Noun) -> Measures:
    """Depth, width and height that the noun's words say [m]."""
    if noun.size is None:
        return (None, None, None)
    depth, width, height = (noun.size.along(axis) for axis in ("depth", "width", "height"))
    length = noun.size.along("length")
    if length is not None:
        usual, _ = work.source.usual(category)
        depth, width = (length, width) if usual[0] > usual[1] else (depth, length)
    return (depth, width, height)


# --- in place of another


def replace(work: Work, finder: Finder, order: Order) -> None:
    """Let another thing stand where one stands."""
    if not order.things:
        raise InputError(f"'{order.text}' does not say what is replaced; there {finder.listed()}")
    named_with = [w.noun for p in order.things for w in p.places if w.noun is not None and w.text.lower() in _BY]
    if not order.instead and named_with:
        raise InputError(f"'{named_with[0].text}' is nothing that is known to come in place of another thing")
    if not order.instead:
        raise InputError(f"'{order.text}' does not say what comes instead; say 'with a ...'")
    new = order.instead[0].noun
    seen: set[str] = set()
    for phrase in order.things:
        ids = named(finder, phrase, phrase.places)
        for id in (i for i in ids if i not in seen):
            seen.add(id)
            _replace_one(work, id, _successor(work, id, new))
        finder.recent = list(ids)


def _successor(work: Work, id: str, new: Noun) -> Asset:
    """What comes in place of an object."""
    old = work.asset_of(id)
    same = new.kind == "number" or not new.value
    category = old.category if same else category_of(work, new, _place_of(work, id))
    target = Target(id="thing_1", category=category, request=category, attributes=tuple(new.attributes))
    made = asset_for(
        Target(
            id=target.id,
            category=category,
            request=category,
            attributes=target.attributes,
            size=_size(work, category, new),
        ),
        work.scene,
        work.source,
    )
    if made.id == old.id:
        made = work.source.make(category, seed=style_seed(work.scene) + 1, attributes=target.attributes)
    if made.id == old.id:
        raise InputError(
            f"{id}: there is no other {category.replace('_', ' ')} to come in its place; say what it is to be"
        )
    return made


def _place_of(work: Work, id: str) -> list[Bound]:
    support = work.scene[id].support
    return [Bound("on", (support,))] if support in work.scene else []


def _replace_one(work: Work, id: str, asset: Asset) -> None:
    before, saved = work.scene, work.saved()
    old = before[id]
    action = Replace(id=id, asset=asset)
    _, _, left = outcome(before, action)
    taken = take(work, left)
    reach = NEW_PLACE + max(0.0, max(asset.size[:2]) - max(old.size[:2])) / 2
    goals: list[Goal] = [At(old.position[:2], reach)]
    ties = work.usual_ties(id) or usual_ties(work.scene, asset.category)
    target = work.target(id, asset.category, ties, asset.attributes)
    reaching = Reaching(work, target, asset, goals, direct=_same_place(work.scene, id, asset), search=False)
    if not reaching.run():
        work.restore(saved)
        work.failed.append(f"{id} was not replaced by {asset.description}: {reaching.why}")
        return
    new = work.scene[id]
    x, y, _ = new.position
    work.done.append(f"{id} is now {_article(asset.description)} at ({x:.2f}, {y:.2f})")
    _replace_riders(work, id, taken, before)


def _replace_riders(work: Work, id: str, taken: Sequence[object], before: Scene) -> None:
    from thinkblox.scene.placement import Placement

    off = [p for p in taken if isinstance(p, Placement)]
    for rider in off:
        if rider.support == id or rider.support not in {p.id for p in off}:
            if place_anew(work, rider, carriers=(id,)):
                put_back(work, rider, [p for p in off if p.id != rider.id], before)
                work.done.append(f"{rider.id}, which stood on {id}, placed anew on {work.scene[rider.id].support}")
            else:
                work.failed.append(f"{rider.id}, which stood on {id}, was taken away: nothing else carries it")


def _same_place(scene: Scene, id: str, asset: Asset) -> Iterator[Pose]:
    """Where the old one stands, by its back; then the nearest places that are free."""
    new = scene.apply(Replace(id=id, asset=asset))[id]
    yield new.position, new.yaw
    empty = scene
    for rider in scene.riders(id):
        empty = empty.without(rider.id)
    for near in nearest_poses(empty, asset, new):
        if near.yaw == new.yaw:
            yield near.position, near.yaw


def _article(text: str) -> str:
    return f"an {text}" if text[:1] in "aeiou" else f"a {text}"


def remove(work: Work, finder: Finder, order: Order) -> None:
    """Take things away; what rested on them is placed anew."""
    if order.rest and not order.things:
        take_away(work, left_over(work, finder, order))
        return
    if not order.things:
        raise InputError(f"'{order.text}' does not say what; there {finder.listed()}")
    ids: dict[str, None] = {}
    for phrase in order.things:
        if phrase.noun.kind in ("place", "part"):
            raise InputError(f"'{phrase.noun.text}' is no thing that can be taken away; there {finder.listed()}")
        meant = named(finder, phrase, phrase.places)
        ids |= dict.fromkeys(meant)
        if phrase.laden:
            ids |= dict.fromkeys(rider.id for id in meant for rider in work.scene.riders(id))
    take_away(work, tuple(ids))
    finder.recent = []


def left_over(work: Work, finder: Finder, order: Order) -> tuple[str, ...]:
    """Everything that an order speaks of by "everything" or "the room", without what it excepts and what is kept.

    What carries a thing that stays cannot go either; that is noted.
    """
    ids = [p.id for p in work.scene.placements]
    for where in (w for w in order.places if w.noun is not None and w.noun.kind in ("thing", "pronoun")):
        carriers = finder.ids(NounPhrase(where.noun)) if where.noun is not None else ()
        ids = [id for id in ids if set(work.scene.carriers(id)) & set(carriers)]
    if any(w.noun is not None and w.noun.word == "furniture" for w in order.places):
        floor = [id for id in ids if work.scene[id].support == "floor"]
        ids = list(dict.fromkeys(i for id in floor for i in (id, *(rider.id for rider in work.scene.riders(id)))))
    going = [id for id in spare(finder, ids, order.spared) if id not in work.kept]
    bearing = {c: id for id in ids if id not in going for c in work.scene.carriers(id) if c in going}
    work.failed += [f"{c} was not taken away: {id}, which is to stay, rests on it" for c, id in bearing.items()]
    return tuple(id for id in going if id not in bearing)


def clear(work: Work, finder: Finder, order: Order) -> None:
    """Take away what is in the room, or what rests on a thing; a thing that carries nothing ever goes itself."""
    if order.room or order.rest or any(w.word == "from" for p in order.things for w in p.places):
        if order.things and not order.room:
            for phrase in order.things:
                phrase.places = [dataclasses.replace(w, word="on") if w.word == "from" else w for w in phrase.places]
            remove(work, finder, order)
            return
        ids = left_over(work, finder, order)
        take_away(work, ids)
        if not ids and not work.failed:
            work.done.append("nothing is there to be taken away: it is so already")
        return
    if not order.things:
        raise InputError(f"'{order.text}' does not say what is to be cleared; say a thing, or a part of the room")
    for id in dict.fromkeys(id for phrase in order.things for id in named(finder, phrase, phrase.places)):
        riders = tuple(rider.id for rider in work.scene.riders(id) if rider.id not in work.kept)
        take_away(work, riders)
        if riders:
            continue
        if work.asset_of(id).surfaces:
            work.done.append(f"nothing rests on {id} that could be taken away: it is so already")
        else:
            take_away(work, (id,))
    finder.recent = []


def take_away(work: Work, ids: Sequence[str]) -> None:
    """Take objects out of the room and give what rested on them, and is not one of them, another place."""
    before = work.scene
    taken = take(work, ids)
    work.done += [f"{id} taken away" for id in ids]
    off = [p for p in taken if p.id not in ids]
    for rider in off:
        if rider.support in {p.id for p in off}:
            continue
        if place_anew(work, rider):
            put_back(work, rider, [p for p in off if p.id != rider.id], before)
            work.done.append(
                f"{rider.id}, which rested on {rider.support}, placed anew on {work.scene[rider.id].support}"
            )
        else:
            gone = [rider.id, *(p.id for p in off if rider.id in before.carriers(p.id))]
            work.failed.append(f"{', '.join(gone)} went with {rider.support}: nothing else in the room carries it")
