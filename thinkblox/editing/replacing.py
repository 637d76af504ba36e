"""Orders that let another thing come in place of one."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace as replace_fields
from functools import partial

from shapely import Point

from thinkblox.editing.acting import related
from thinkblox.editing.adding import add, add_with
from thinkblox.editing.adding_one import MOST, add_one, category_of, of_size
from thinkblox.editing.carrying import place_anew, put_back, take, usual_ties
from thinkblox.editing.finding import SAME_SIZE, Finder
from thinkblox.editing.goals import Abreast, At, Goal, Related
from thinkblox.editing.grammar import means
from thinkblox.editing.moving_one import move_one
from thinkblox.editing.orders import SAME, NounPhrase, Order
from thinkblox.editing.reaching import Reaching, without
from thinkblox.editing.remaking import MORE, compared, looks_of, otherwise
from thinkblox.editing.removing import take_away
from thinkblox.editing.reseating import with_seats
from thinkblox.editing.spots import Pose, along_walls, at_wall
from thinkblox.editing.telling import named
from thinkblox.editing.wheres import Bound, bound, slots_of
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.judging import asset_for, style_seed
from thinkblox.plan import Target
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.measures import object_size
from thinkblox.reading.own_names import own_name
from thinkblox.scene.actions import Replace, outcome
from thinkblox.scene.asset import Asset
from thinkblox.scene.nearby import nearest_poses
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

_BY = ("with", "by", "for")
NEW_PLACE = 0.75
"""How far from the old one's middle the new one may stand that comes in its place, besides half of what one is longer
than the other [m].
"""
STAYS = 0.3
"""The same for a thing that is made otherwise [m]."""
SAID = 0.25
"""From how far that is said, besides half of the same [m]."""
NEXT_ABOVE = 0.05
"""How far from where it is to hang another thing may hang beside one [m]."""
BETWEEN_LAMPS = (0.4, 0.2, 0.8)
"""Gaps between things that hang beside each other [m]."""
TRIES = 60
"""Places about the old one's that are looked at."""


def replace(work: Work, finder: Finder, order: Order) -> None:
    """Let another thing stand where one stands; of several, so many as is said come for all of them."""
    if not order.things:
        raise InputError(f"'{order.text}' does not say what is replaced; there {finder.listed()}")
    named_with = [w.noun for p in order.things for w in p.places if w.noun is not None and w.text.lower() in _BY]
    if not order.instead and named_with:
        raise InputError(f"'{named_with[0].text}' is nothing that is known to come in place of another thing")
    if not order.instead:
        raise InputError(f"'{order.text}' does not say what comes instead; say 'with a ...'")
    found = (id for phrase in order.things for id in named(finder, phrase, phrase.places))
    ids = work.touched(dict.fromkeys(found))
    first = order.instead[0]
    if _hangs_elsewhere(work, ids, order.instead):
        _let_hang(work, finder, order, ids)
        return
    count, before = _how_many(order, ids, first.noun), work.scene
    for number, id in enumerate(ids[:count]):
        become = partial(_comes_in_place, work, id, first.noun)
        if with_seats(work, id, become, asked=bool(order.company)):
            _place(work, finder, order, id, first, number, count)
    if ids[count:]:
        take_away(work, ids[count:])
    _bring_more(work, finder, order, before, ids, count)
    finder.recent = [id for id in ids if id in work.scene]


def _hangs_elsewhere(work: Work, ids: Sequence[str], new: Sequence[NounPhrase]) -> bool:
    """Whether what comes instead hangs somewhere that is said, and what it comes for stands or hangs otherwise."""
    noun = new[0].noun
    if len(new) != 1 or noun.kind != "thing" or not noun.value or not new[0].places:
        return False
    mount = work.source.usual(category_of(work, noun, ()))[1]
    return mount in ("wall", "ceiling") and all(work.asset_of(id).mount != mount for id in ids)


def _let_hang(work: Work, finder: Finder, order: Order, ids: Sequence[str]) -> None:
    """Take things away and hang what comes instead where that is said; all is as before where that cannot be."""
    saved, said = work.saved(), (len(work.done), len(work.failed))
    take_away(work, ids)
    finder.scene = work.before = work.scene
    add(work, finder, Order("add", order.text, things=[order.instead[0]]))
    if len(work.failed) > said[1]:
        work.restore(saved)
        del work.done[said[0] :], work.failed[said[1] + 1 :]
        finder.scene = work.scene


def _bring_more(work: Work, finder: Finder, order: Order, before: Scene, ids: Sequence[str], count: int) -> None:
    """Add what comes in place of things besides what stands where they stood: of two for one the second."""
    by, first = ids[0] if ids else "", order.instead[0].noun
    looks = [w for phrase in order.instead[1:] for w in phrase.places if w.word == "facing" and not w.negated]
    between = [p for p in order.instead[1:] if p.noun.kind == "thing" and any(w not in looks for w in p.places)]
    for noun in [first] * (count - len(ids)) + [p.noun for p in order.instead[1:] if p not in between]:
        for _ in range(noun.count or 1 if noun is not first and not by else 1):
            if not by:
                there: list[Goal] = [At(finder.vacated.position[:2], NEW_PLACE)] if finder.vacated is not None else []
                add_one(work, category_of(work, noun, ()), noun, there)
            elif noun is not first:
                finder.scene = work.scene
                heads = [by, *(p.id for p in work.scene.placements if p.id not in before)] if order.eached else [by]
                heads = [id for id in heads if work.scene[id].category == work.scene[by].category]
                add_with(work, finder, order, heads, [Where("with", noun, text="with")])
            elif work.scene[by].asset != before[by].asset:
                _add_another(work, by, noun, beside=order.abreast)
    came = [id for id in ids[:count] if id in work.scene] + [p.id for p in work.scene.placements if p.id not in before]
    if by and work.scene[by].asset != before[by].asset:
        _put_others(work, finder, order, came, [id for id in came if id not in ids], looks)
        for phrase in between:
            where = [w for w in phrase.places if w not in looks]
            _bring_to(work, finder, order, came, replace_fields(phrase, places=where))
    elif between or looks:
        work.failed += [f"{phrase.text} was not added: nothing came in place of {', '.join(ids)}" for phrase in between]


def _put_others(
    work: Work, finder: Finder, order: Order, came: Sequence[str], added: Sequence[str], looks: Sequence[Where]
) -> None:
    """Bring what has come besides to where all are to stand, and let all face what they are to."""
    first = order.instead[0]
    for id in came if looks else added:
        category = work.scene[id].category
        finder.scene, finder.about = work.scene, id
        places = [*(first.places if id in added else ()), *looks]
        goals = [related(bound(where, category, finder), category) for where in places]
        if goals and not all(goal.check(work.scene, work.scene, id)[0] for goal in goals):
            work.before = work.scene
            move_one(work, order, id, goals)


def _bring_to(work: Work, finder: Finder, order: Order, came: Sequence[str], phrase: NounPhrase) -> None:
    """Add what is to stand somewhere to what has come: "a coffee table between them"."""
    there, said = {p.id for p in work.scene.placements}, len(work.failed)
    finder.scene = work.before = work.scene
    if not any(where.word == "between" for where in phrase.places):
        alike = [id for id in came if work.scene[id].category == work.scene[came[0]].category]
        one = any(w.noun is not None and w.noun.kind == "pronoun" and w.noun.value == "it" for w in phrase.places)
        finder.recent, finder.about = alike[:1] if one else alike, ""
        add(work, finder, Order("add", order.text, things=[phrase]))
        return
    category = category_of(work, phrase.noun, ())
    near: list[Goal] = [Related("near", (came[0],))]
    id = add_one(work, category, phrase.noun, near) if came[0] in work.scene else ""
    if not id or len(work.failed) > said or id in there:
        return
    finder.scene, finder.recent, finder.about = work.scene, list(came), ""
    goals = [related(bound(where, category, finder), category) for where in phrase.places]
    finder.about = id
    move_one(work, order, id, goals)


def _add_another(work: Work, by: str, noun: Noun, *, beside: bool) -> None:
    """Add another one of what has come in place of a thing: beside it where that can be."""
    new = noun if noun.kind == "thing" else replace_fields(noun, value=work.scene[by].category, kind="thing")
    category, asset, said = category_of(work, new, ()), work.asset_of(by), len(work.failed)
    walls = _walls_at(work.scene, by, asset)
    abreast, near, walled = Abreast("next_to", (by,)), Related("near", (by,)), Related("against_wall", ("wall",))
    tries: list[list[Goal]] = [[abreast]]
    if asset.mount == "ceiling":
        old = work.scene[by]
        for spot in _beside_above(work.scene, by):
            del work.failed[said:]
            pose = ((*spot, old.position[2]), old.yaw)
            if add_one(work, category, new, [At(spot, NEXT_ABOVE)], asset=asset, first=[pose]):
                return
        return
    if walls:
        tries = [[abreast, Related("against_wall", walls)], [abreast]]
    if not beside:
        tries += [[near, walled], [walled]] if walls else [[near]]
    for goals in tries:
        del work.failed[said:]
        if id := add_one(work, category, new, goals, asset=asset):
            work.wishes = [wish for wish in work.wishes if beside or wish.id != id]
            return


def _beside_above(scene: Scene, by: str) -> Iterator[Vec2]:
    """Where another thing hangs beside one, along what is below that, the longer way first."""
    x, y = scene[by].position[:2]
    wide = max(scene[by].size[:2])
    below = [p for p in scene.placements if p.support == "floor" and p.footprint.contains(Point(x, y))]
    below = [p for p in below if scene.asset_of(p).collides]
    yaw = below[0].yaw + (90.0 if below[0].size[1] > below[0].size[0] else 0.0) if below else 0.0
    for turn in (0.0, 180.0, 90.0, 270.0):
        way = math.radians(yaw + turn)
        for off in (wide + gap for gap in BETWEEN_LAMPS):
            spot = (round(x + off * math.cos(way), 4), round(y + off * math.sin(way), 4))
            if scene.room.polygon.contains(Point(spot)):
                yield spot


def _how_many(order: Order, ids: Sequence[str], new: Noun) -> int:
    """How many come in place of these: so many as is said, one for "a bench", or as many as there were."""
    each = any(phrase.noun.det == "each" for phrase in order.things)
    each |= any(w.noun is not None and w.noun.each for phrase in order.things for w in phrase.places)
    if new.count and new.count > MOST:
        raise InputError(f"'{new.text}': one order adds at most {MOST} things")
    if new.count and new.count > 1:
        return new.count
    return len(ids) if each or new.plural or not (new.det == "a" or new.count) or new.kind == "number" else 1


def _comes_in_place(work: Work, id: str, new: Noun) -> bool:
    """Let a new thing stand where an object stands, a smaller one where the usual one cannot and no size is said."""
    said = len(work.failed)
    factors = MORE if new.degree and new.degree != SAME else MORE[:1]
    for factor in factors:
        tried = len(work.failed)
        if replace_one(work, id, _successor(work, id, new, factor), ask=factor == factors[-1]):
            del work.failed[said:tried]
            return True
        del work.failed[said + 1 :]
    asset = _successor(work, id, new, MORE[0])
    again = [(_as_small(work, id, asset), False)] if new.size is None and not new.degree else []
    again += [(asset, True)] if work.scene.riders(id) else []
    for other, bare in again:
        tried = len(work.failed)
        if replace_one(work, id, other, bare=bare):
            del work.failed[said:tried]
            return True
    del work.failed[said + 1 :]
    return False


def _as_small(work: Work, id: str, asset: Asset) -> Asset:
    """What is to come in place of an object, no longer and no deeper than that, as far as such a thing is made so."""
    old, (least, _) = work.asset_of(id).size, work.source.size_range(asset.category)
    depth, width, height = (max(min(own, there), low) for own, there, low in zip(asset.size, old, least, strict=True))
    if abs(asset.size[0] - asset.size[1]) < SAME_SIZE:
        depth = width = max(min(depth, width), least[0], least[1])
    return work.source.fit(asset, (depth, width, max(height, asset.size[2])))


def _place(work: Work, finder: Finder, order: Order, id: str, new: NounPhrase, number: int, count: int) -> None:
    """Bring what has come to where it is said to stand: of several places, "one on each side", to its own."""
    category = work.scene[id].category
    slots = [slots_of(where, category, finder) if count > 1 else [] for where in new.places]
    there = [several[number] if len(several) == count else bound(where, category, finder)
             for several, where in zip(slots, new.places, strict=True)]  # fmt: skip
    goals = [related(place, category) for place in there]
    if goals:
        finder.scene = work.before = work.scene
        move_one(work, order, id, goals)


def _successor(work: Work, id: str, new: Noun, factor: float) -> Asset:
    """What comes in place of an object; by a factor larger or smaller where only that is said."""
    old = work.asset_of(id)
    same = new.kind == "number" or not new.value
    category = old.category if same else category_of(work, new, _place_of(work, id))
    size = next((means("sizes", word) for word in new.attributes if means("sizes", word)), "")
    if same and size and new.size is None and not new.degree:
        degree = "larger" if size == "1" else "smaller"
        rest = [word for word in new.attributes if not means("sizes", word)]
        return _compared(work, old, category, replace_fields(new, degree=degree, attributes=rest), factor)
    if new.degree == SAME:
        return _as_large(work, old, category, new)
    if new.degree:
        return _compared(work, old, category, new, factor)
    if same and new.attributes and new.size is None:
        return _otherwise(work, old, new)
    target = Target(
        id="thing_1",
        category=category,
        request=category,
        attributes=tuple(new.attributes),
        size=object_size(category, new.size),
        called=own_name(new.called, category),
    )
    made = of_size(asset_for(target, work.scene, work.source), target.size)
    if made.links == old.links and not (new.attributes or new.size):
        made = work.source.make(category, seed=style_seed(work.scene) + 1, attributes=target.attributes)
        made = made.called(target.called) if target.called else made
    if made.links == old.links:
        raise InputError(
            f"{id}: there is no other {category.replace('_', ' ')} to come in its place; say what it is to be"
        )
    return made


def _as_large(work: Work, old: Asset, category: str, new: Noun) -> Asset:
    """Another thing of the size that the old one has.

    Raises:
        InputError: it is not made so large or so small.
    """
    made = work.source.make(category, seed=style_seed(work.scene), attributes=tuple(new.attributes))
    fitted = work.source.fit(made, old.size)
    if max(abs(a - b) for a, b in zip(fitted.size, old.size, strict=True)) > SAME_SIZE:
        sizes = [" by ".join(f"{side:.2f}" for side in size) for size in (old.size, fitted.size)]
        raise InputError(f"'{new.text}' is not made as large as {sizes[0]} m; the nearest is {sizes[1]} m")
    return fitted


def _otherwise(work: Work, old: Asset, new: Noun) -> Asset:
    """The same kind of thing of other looks: "a blue one"."""
    return otherwise(work, old, Order("make", new.text, looks=list(new.attributes)))


def _compared(work: Work, old: Asset, category: str, new: Noun, factor: float) -> Asset:
    """What is larger, taller, ... than the old one, as is said."""
    if category == old.category:
        made = _compared_by_size(work, old, new) if new.size else compared(work, old, new.degree, factor)
        return _otherwise(work, made, new) if new.attributes else made
    usual = work.source.make(category, seed=style_seed(work.scene), attributes=tuple(new.attributes))
    least, most = work.source.size_range(category)
    start = [min(max(o, a), b) for o, a, b in zip(old.size, least, most, strict=True)]
    return compared(work, work.source.fit(usual, (start[0], start[1], start[2])), new.degree, factor)


def _compared_by_size(work: Work, old: Asset, new: Noun) -> Asset:
    """What is "a longer one, 1.8 m": of just that length.

    Raises:
        InputError: it is not made so, or would not be longer.
    """
    lengths = [(length.metres, length.axis) for length in new.size.lengths] if new.size is not None else []
    if len(lengths) == 1:
        change = means("comparatives", new.degree)
        made = otherwise(work, old, Order("make", new.text, lengths=lengths, change=f"{change}="))
    else:
        size = object_size(old.category, new.size)
        deep, wide, high = (said or own for said, own in zip(size, old.size, strict=True))
        made = of_size(work.source.fit(old, (deep, wide, high)), size)
    if (sum(made.size) > sum(old.size)) != (sum(compared(work, old, new.degree).size) > sum(old.size)):
        raise InputError(f"'{new.text}': that is not {new.degree} than it is, {looks_of(old)}")
    return made


def _place_of(work: Work, id: str) -> list[Bound]:
    support = work.scene[id].support
    return [Bound("on", (support,))] if support in work.scene else []


def replace_one(
    work: Work, id: str, asset: Asset, *, stays: bool = False, bare: bool = False, ask: bool = False
) -> bool:
    """Let an asset stand where an object stands; whether that could be, which is noted.

    What stood at a wall stands at it again where that can be. The place is that of the old one, so that it is tried
    with all that is free about it before anybody is asked.

    Args:
        work: the edit.
        id: of the object.
        asset: what it becomes.
        stays: it is the same thing made otherwise, and stays where it is.
        bare: all that rests on it is placed anew.
        ask: whether the policy is asked where nothing there will do.
    """
    before, saved = work.scene, work.saved()
    old = before[id]
    _, _, left = outcome(before, Replace(id=id, asset=asset))
    taken = take(work, [rider.id for rider in before.riders(id)] if bare else left)
    reach = (STAYS if stays else NEW_PLACE) + abs(max(asset.size[:2]) - max(old.size[:2])) / 2
    there, walled = At(old.position[:2], reach), _walls_at(before, id, asset)
    ties = work.usual_ties(id) or usual_ties(work.scene, asset.category)
    target = work.target(id, asset.category, ties, asset.attributes)
    wanted: list[list[Goal]] = [[there, Related("against_wall", walled)]] if walled else []
    wanted += [[there]] if not (walled and stays) else []
    why = ""
    for goals in wanted:
        direct = _same_place(work.scene, id, asset, reach)
        last = goals is wanted[-1]
        reaching = Reaching(work, target, asset, goals, direct=direct, ask=ask and last, search=False, tries=TRIES)
        if reaching.run():
            break
        why = why or reaching.why
    else:
        work.restore(saved)
        size = " by ".join(f"{side:.2f}" for side in asset.size)
        says = f"left as it is; of {size} m there" if stays else f"not replaced by {_article(asset.description)}"
        work.failed.append(f"{id} was {says}: {why}")
        return False
    _say_replaced(work, old, asset, walled)
    _replace_riders(work, id, taken, before)
    return True


def _walls_at(scene: Scene, id: str, asset: Asset) -> tuple[str, ...]:
    """The wall that a thing stands with its back to, where what comes there can do so too."""
    if asset.mount != "floor" or asset.front == "any" or scene.asset_of(scene[id]).front == "any":
        return ()
    found = [wall.name for wall in scene.room.walls if measure(scene, "against_wall", id, (wall.name,)).holds]
    return tuple(found[:1]) if at_wall(scene, id) else ()


def _say_replaced(work: Work, old: Placement, asset: Asset, walled: tuple[str, ...]) -> None:
    new = work.scene[old.id]
    x, y, _ = new.position
    size = " by ".join(f"{side:.2f}" for side in asset.size)
    says = f"{old.id} is now {_article(asset.description)} of {size} m at ({x:.2f}, {y:.2f})"
    says += f", turned to yaw {new.yaw:g}" if new.yaw != old.yaw else ""
    away = math.dist(new.position[:2], old.position[:2])
    says += f", {away:.2f} m from where it was" if away > abs(max(new.size[:2]) - max(old.size[:2])) / 2 + SAID else ""
    if walled and not measure(work.scene, "against_wall", old.id, walled).holds:
        says += f", and not at the {walled[0].replace('_', ' ')} any more"
    work.done.append(says)


def _replace_riders(work: Work, id: str, off: Sequence[Placement], before: Scene) -> None:
    for rider in off:
        if rider.support == id or rider.support not in {p.id for p in off}:
            if place_anew(work, rider, carriers=(id,)):
                put_back(work, rider, [p for p in off if p.id != rider.id], before)
                work.done.append(f"{rider.id}, which stood on {id}, placed anew on {work.scene[rider.id].support}")
            else:
                work.failed.append(f"{rider.id}, which stood on {id}, was taken away: nothing else carries it")


def _same_place(scene: Scene, id: str, asset: Asset, reach: float) -> Iterator[Pose]:
    """Where the old one stands, by its back; then the nearest places that are free, at a wall where that is at one.

    What stands partly under the old one, as a seat that is drawn up to it, may also stand under the new one.
    """
    new = scene.apply(Replace(id=id, asset=asset))[id]
    yield new.position, new.yaw
    under = [p.id for p in scene.placements if p.id != id and p.footprint.intersection(scene[id].footprint).area > 0.0]
    off = {rider.id for rider in scene.riders(id)}
    empty = without(scene, {*off, *(i for i in under if scene[i].support == scene[id].support)})
    if at_wall(scene, id) and asset.mount == "floor":
        yield from along_walls(without(empty, [id]), asset, scene[id].position[:2], reach)
    for near in nearest_poses(empty, asset, new):
        if near.yaw == new.yaw:
            yield near.position, near.yaw


def _article(text: str) -> str:
    return f"an {text}" if text[:1] in "aeiou" else f"a {text}"
