"""Orders that let things change places: two things, or two groups of them."""

import dataclasses
import math
from collections.abc import Iterator, Sequence
from itertools import chain

from msgspec import structs

from thinkblox.committing import commit
from thinkblox.editing.acting import moved_words
from thinkblox.editing.carrying import place_anew, put_back, take
from thinkblox.editing.company import (
    REACH,
    SITTING,
    bring_overhead,
    bring_together,
    done_or_undone,
    mates_of,
    seats_at,
    with_company,
)
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import At, Goal, Region, Related, Traded, Within
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reaching import Reaching
from thinkblox.editing.spots import Pose, along_walls, at_wall
from thinkblox.editing.telling import named
from thinkblox.editing.work import Work
from thinkblox.episode import Round
from thinkblox.errors import InputError
from thinkblox.judging import Proposal, Try
from thinkblox.scene.actions import Swap
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.nearby import nearest_poses
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at
from thinkblox.steps import write_step
from thinkblox.value import Vec2

SWAP_TRIES = 60
"""Poses around the other's place that are looked at for one of two that change places."""
SWAPPED = 0.5
"""How far from the other's place something may stand that has changed places with it, besides a quarter of their
lengths [m].
"""
AWAY = 0.3
"""From how far that is said [m]."""
GROUPED = 0.6
"""How far from the middle of a group's places what comes there may stand, besides the reach of both groups [m]."""


def _on_each(finder: Finder, order: Order) -> list[tuple[str, ...]]:
    """Read "the lamps on desk_1 and desk_2" as that on the one and that on the other; empty where it is not that."""
    said = [p for p in order.things if p.noun.kind == "thing"]
    if len(said) != 2 or order.split or not said[0].noun.many or len(said[0].places) != 1 or said[1].places:
        return []
    where, one = said[0].places[0], dataclasses.replace(said[0].noun, plural=False, det="the")
    if where.noun is None or where.noun.kind != "thing" or where.noun.value != said[1].noun.value:
        return []
    second = dataclasses.replace(where, noun=dataclasses.replace(said[1].noun, id=said[1].id or said[1].noun.id))
    return [named(finder, NounPhrase(one), [place]) for place in (where, second)]


def _without_riders(scene: Scene, groups: Sequence[tuple[str, ...]]) -> list[tuple[str, ...]]:
    """The groups without what rests on what is in one: "the stand with the TV" goes with it anyway."""
    named_too = {id for group in groups for id in group}
    left = [tuple(id for id in group if not named_too & set(scene.carriers(id))) for group in groups]
    return [group for group in left if group]


def swap(work: Work, finder: Finder, order: Order) -> None:
    """Let two things change places, with what the order names along."""
    if order.company:
        _swap_with_company(work, finder, order)
        return
    groups = _on_each(finder, order) or [named(finder, phrase, phrase.places) for phrase in order.things]
    groups = _without_riders(work.scene, groups)
    ids = list(dict.fromkeys(id for group in groups for id in group))
    if len(work.touched(ids)) < len(ids) and ids:
        return
    if len(ids) > 2 and (len(groups) == 2 or order.split):
        split = min(order.split or 1, len(groups) - 1)
        swap_groups(work, [i for g in groups[:split] for i in g], [i for g in groups[split:] for i in g])
        finder.recent = ids
        return
    if len(ids) != 2:
        raise InputError(f"'{order.text}' must name two things that change places; it names {', '.join(ids) or 'none'}")

    def exchange() -> None:
        _exchange(work, *ids)

    together = bring_overhead(work, ids, exchange) or done_or_undone(work, exchange)
    if not together and not _with_seats(work, finder, ids):
        exchange()
    finder.recent = ids


def _with_seats(work: Work, finder: Finder, ids: Sequence[str]) -> bool:
    """Let two things change places with the seats that are drawn up to them; whether they have some, and can so."""
    named_too = {*ids, *finder.named, *work.kept}
    high = {id: work.scene[id].size[2] >= SITTING for id in ids}
    seats = {id: seats_at(work.scene, id, besides=named_too) if high[id] else [] for id in ids}
    one, other = ids
    if not any(seats.values()):
        return False

    def second() -> None:
        bring_together(work, other, seats[other], lambda: _exchange(work, *ids))

    if done_or_undone(work, lambda: bring_together(work, one, seats[one], second)):
        return True
    work.left += [(id, seats[id]) for id in ids if seats[id]]
    return False


def _exchange(work: Work, one: str, other: str) -> None:
    """Let two things change places: exactly, or as near to that as each can stand."""
    ids, before = (one, other), work.scene
    action = Swap(id=one, other=other)
    after = before.apply(action)
    verdict = work.world.ruled_out(action) or work.world.measure(action)
    text = write_step([f"{one} and {other} change places."], action="swap", id=one, other=other)
    proposal = Proposal(text, action, after[one], after.asset_of(after[one]))
    tried = Try(text=text, placement=after[one], verdict=verdict)
    if verdict.valid:
        work.world, placements = commit(work.world, proposal, verdict)
    else:
        placements = ()
    work.rounds.append(
        Round(
            id=one,
            number=0,
            kind="repair",
            asset=before[one].asset,
            tries=(tried,),
            chosen=0 if verdict.valid else None,
            committed=placements,
        )
    )
    for id in ids:
        work.assets[before[id].asset] = before.asset_of(before[id])
    if not verdict.valid:
        why = _swap_nearby(work, one, other)
        if why:
            work.failed.append(f"{one} and {other} were left where they are: {why}; exactly exchanged, {verdict}")
            return
    for id, partner in ((one, other), (other, one)):
        away = math.dist(work.scene[id].position[:2], before[partner].position[:2])
        where = f"{away:.2f} m from" if away > AWAY else "to"
        why = f"; exactly exchanged, {verdict}" if away > AWAY and not verdict.valid else ""
        work.done.append(f"{moved_words(before[id], work.scene[id])}, {where} where {partner} was{why}")


def _swap_with_company(work: Work, finder: Finder, order: Order) -> None:
    """Let two things change places, and what belongs to one of them go along with it: "the desk and its chair"."""
    ids = [id for phrase in order.things for id in named(finder, phrase, phrase.places)]
    alone = dataclasses.replace(order, company=[])
    owner = next((id for id in reversed(ids) if _has_all(work, finder, order, id)), "")
    if len(ids) != 2 or not owner:
        said = " and ".join(phrase.noun.text for phrase in order.company)
        raise InputError(f"'{order.text}': which of {', '.join(ids)} {said} goes along with is not known")
    with_company(work, finder, order, owner, lambda: swap(work, finder, alone))


def _has_all(work: Work, finder: Finder, order: Order, id: str) -> bool:
    """Whether everything that is to go along stands by an object."""
    for phrase in order.company:
        mates = mates_of(work, finder, phrase, id)
        mark = things(work.scene, id)[0]
        if any(ground_gap(mark, things(work.scene, mate)[0]) > REACH for mate in mates):
            return False
    return True


def _swap_nearby(work: Work, one: str, other: str) -> str:
    """Put each as near to the other's place as it can stand; says why where that is not near enough."""
    before, saved = work.scene, work.saved()
    exchanged = before.apply(Swap(id=one, other=other))
    taken = take(work, (one, other))
    order = sorted((one, other), key=lambda id: -before[id].size[0] * before[id].size[1])
    for id in order:
        partner = before[other if id == one else one]
        reach = SWAPPED + (max(before[id].size[:2]) + max(partner.size[:2])) / 4
        asset, pose = work.assets[before[id].asset], exchanged[id]
        goals: list[Goal] = [At(partner.position[:2], reach), Traded(partner.position[:2])]
        if at_wall(before, id) and at_wall(before, partner.id):
            goals.append(Related("against_wall", ("wall",)))
        target = work.target(id, before[id].category, (), asset.attributes)
        walled = along_walls(work.scene, asset, partner.position[:2], reach) if at_wall(before, id) else ()
        poses = chain(walled, _about(work, id, pose))
        reaching = Reaching(work, target, asset, goals, direct=poses, ask=False, tries=SWAP_TRIES)
        if not reaching.run():
            why = reaching.why
            work.restore(saved)
            return why
    for id in order:
        lost = put_back(work, before[id], taken, before)
        for rider in (p for p in taken if p.id in lost):
            if not place_anew(work, rider, carriers=(id,)):
                work.restore(saved)
                return f"{rider.id} could not go along with {id}"
    return ""


def _about(work: Work, id: str, pose: Placement) -> Iterator[Pose]:
    """The pose and the nearest free ones, as they are turned first."""
    asset = work.assets[pose.asset]
    yield pose.position, pose.yaw
    placed = placed_at(work.scene, asset, id=id, position=pose.position, yaw=pose.yaw)
    for near in nearest_poses(work.scene, asset, placed):
        yield near.position, near.yaw


def swap_groups(work: Work, ones: Sequence[str], others: Sequence[str]) -> None:
    """Let the things of two groups stand where those of the other stood."""
    before, saved = work.scene, work.saved()
    taken = take(work, (*ones, *others))
    where = {id: _middle(before, group) for group, ids in ((others, ones), (ones, others)) for id in ids}
    partners = _partners(before, ones, others)
    reach = {id: GROUPED + _reach(before, ones) + _reach(before, others) for id in where}
    for id in sorted(where, key=lambda id: -before[id].size[0] * before[id].size[1]):
        old, asset, (x, y) = before[id], work.assets[before[id].asset], where[id]
        group = others if id in ones else ones
        name = f"where {', '.join(group)} stood"
        goals: list[Goal] = [Within(Region((x, y), reach[id], name))]
        target = work.target(id, old.category, (), asset.attributes)
        begin: Pose = ((x, y, old.position[2]), before[group[0]].yaw)
        pose = placed_at(work.scene, asset, id=id, position=begin[0], yaw=begin[1])
        poses = _about(work, id, pose)
        if id in partners:
            partner = before[partners[id]]
            poses, goals = _in_place_of(work, old, partner)
        reaching = Reaching(work, target, asset, goals, direct=poses, ask=False, begin=begin, tries=SWAP_TRIES)
        if not reaching.run():
            work.restore(saved)
            work.failed.append(f"{', '.join(ones)} and {', '.join(others)} were left where they are: {reaching.why}")
            return
    for id in where:
        for lost in put_back(work, before[id], [p for p in taken if p.id not in where], before):
            if not place_anew(work, next(p for p in taken if p.id == lost), carriers=(id,)):
                work.restore(saved)
                work.failed.append(f"{lost} could not go along with {id}")
                return
    work.done += [moved_words(before[id], work.scene[id]) for id in where]


def _in_place_of(work: Work, old: Placement, partner: Placement) -> tuple[Iterator[Pose], list[Goal]]:
    """Where a thing goes that takes the place of another: right there if it is of the same kind, else about there."""
    asset = work.assets[old.asset]
    there = structs.replace(old, position=partner.position, yaw=partner.yaw)
    if partner.category == old.category:
        return _about(work, old.id, there), [At(partner.position[:2])]
    reach = SWAPPED + (max(old.size[:2]) + max(partner.size[:2])) / 4
    walled = at_wall(work.start, partner.id) and asset.mount == "floor"
    by_wall = along_walls(work.scene, asset, partner.position[:2], reach) if walled else ()
    return chain(by_wall, _about(work, old.id, there)), [At(partner.position[:2], reach)]


def _partners(scene: Scene, ones: Sequence[str], others: Sequence[str]) -> dict[str, str]:
    """Which of the other group each takes the place of, where both hold the same kinds, or as many of one kind."""
    kinds = [sorted(scene[id].category for id in group) for group in (ones, others)]
    if kinds[0] != kinds[1] and len(ones) == len(others) and all(len(set(names)) == 1 for names in kinds):
        ordered = [sorted(ids, key=lambda id: scene[id].position[:2]) for ids in (ones, others)]
        return {id: other for pair in zip(*ordered, strict=True) for id, other in (pair, pair[::-1])}
    if kinds[0] != kinds[1]:
        return {}
    pairs: dict[str, str] = {}
    for kind in dict.fromkeys(kinds[0]):
        group = [[id for id in ids if scene[id].category == kind] for ids in (ones, others)]
        for one, other in zip(*(sorted(ids, key=lambda id: scene[id].position[:2]) for ids in group), strict=True):
            pairs |= {one: other, other: one}
    return pairs


def _middle(scene: Scene, ids: Sequence[str]) -> Vec2:
    spots = [scene[id].position for id in ids]
    return (sum(x for x, _, _ in spots) / len(spots), sum(y for _, y, _ in spots) / len(spots))


def _reach(scene: Scene, ids: Sequence[str]) -> float:
    """How far the outlines of some things are from the middle of them [m]."""
    x, y = _middle(scene, ids)
    return max(
        abs(scene[id].position[0] - x) + abs(scene[id].position[1] - y) + max(scene[id].size[:2]) / 2 for id in ids
    )
