"""Orders that move things: to a place, by so much, nearer to or away from others, or just elsewhere."""

import dataclasses
from collections.abc import Iterable, Sequence
from itertools import permutations

from thinkblox.editing.acting import (
    mark_names,
    related,
    say,
)
from thinkblox.editing.carrying import usual_ties
from thinkblox.editing.company import company_of, gathered, say_left, seats_at, with_company
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import (
    ELSEWHERE,
    ELSEWHERE_SMALL,
    Abreast,
    Across,
    Apart,
    At,
    Elsewhere,
    Goal,
    IntoRoom,
    Nearing,
    Related,
)
from thinkblox.editing.grammar import sections
from thinkblox.editing.moved_things import check_says_where, moved_things, split_places
from thinkblox.editing.moving_goals import AT_IT, goals_of, stood_abreast
from thinkblox.editing.moving_one import move_and_turn, move_one, seats_among
from thinkblox.editing.moving_rows import by_rows, row_to_wall, shifted_at_once
from thinkblox.editing.orders import Order
from thinkblox.editing.pairing import pair_up
from thinkblox.editing.reaching import Reaching
from thinkblox.editing.rows import rows_of_all
from thinkblox.editing.scattering import scatter, scatter_rows
from thinkblox.editing.stepping import way_of
from thinkblox.editing.turning import face_each_other
from thinkblox.editing.wheres import bound, slots_of
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.plan import Tie
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things, walls
from thinkblox.scene.placement import Placement

MOST_SLOTS = 5
"""Most things that are shared out to places so that as few as can be have to move."""
_LOOKS = ("facing", "opposite")
_PUSHED = ("push", "shove")
"""Verbs by which things come together without a gap, where that can be."""


def move(work: Work, finder: Finder, order: Order) -> None:
    """Move things to where an order says, or by as much, or nearer to or away from something."""
    if order.together or order.scatter or order.mutual not in ("", "facing"):
        _to_each_other(work, finder, order)
        return
    if " ".join(order.text.lower().split()[:2]) in _lined_up() and (wall := _any_wall(order)) is not None:
        _line_up(work, finder, order, wall)
        return
    if order.touching and not any(phrase.places for phrase in order.things):
        raise InputError(f"'{order.text}': without a gap to what? Say 'against the bed', or 'side by side'")
    if order.besides:
        raise InputError(f"'{order.text}' excepts places of what is moved; say where it goes")
    seen: set[tuple[str, str]] = set()
    order = gathered(work, finder, order)
    groups = list(_groups(work, finder, order))
    moving = {id for ids, _ in groups for id in ids}
    order = by_rows(work, order, sorted(moving))
    if shifted_at_once(work, order, groups) or row_to_wall(work, finder, order, groups):
        finder.recent = [id for ids, _ in groups for id in ids]
        return
    along = {mate for id in moving - seats_among(work, moving) for mate in company_of(work, finder, order, id)}
    for ids, places in groups:
        check_says_where(order, places)
        ids = tuple(id for id in ids if id not in along and not moving & set(work.before.carriers(id)))
        ids = _by_slots(work, finder, ids, places)
        told = _to_one_wall(work, order, ids)
        came: list[str] = []
        for index, id in enumerate(_foremost_first(work, finder, order, ids)):
            said = (id, " ".join(f"{w.text} {w.noun.text if w.noun else ''}" for w in places))
            if said in seen:
                continue
            seen.add(said)
            finder.scene, finder.about = work.scene, id
            goals = stood_abreast(goals_of(work, finder, told, id, places, index, len(ids)), came)
            came.append(id)
            with_company(work, finder, order, id, lambda id=id, goals=goals: move_and_turn(work, order, id, goals))  # type: ignore[misc]
        finder.recent = list(ids)
    if order.mutual == "facing":
        face_each_other(work, finder, order)


def _to_each_other(work: Work, finder: Finder, order: Order) -> None:
    """Bring things to where they stand to each other as an order says."""
    if order.mutual in ("face_to_face", "back_to_back"):
        pair_up(work, finder, order)
        return
    _together(work, finder, order)
    if order.mutual == "facing":
        face_each_other(work, finder, dataclasses.replace(order, things=[]))


def _lined_up() -> frozenset[str]:
    return frozenset(" ".join(words) for words in sections()["rows_of"])


def _any_wall(order: Order) -> Where | None:
    """The place of an order that is a wall, and does not say which."""
    places = [*order.places, *(where for phrase in order.things for where in phrase.places)]
    walls = [where for where in places if where.noun is not None and where.noun.value == "wall" and not where.negated]
    return walls[0] if walls and walls[0].whole is None and walls[0].second is None else None


def _line_up(work: Work, finder: Finder, order: Order, where: Where) -> None:
    """Let all that is named stand at one wall: at the longest at which it can."""
    said, saved, before, noun = (len(work.done), len(work.failed)), work.saved(), work.scene, where.noun
    failed: list[str] = []
    lined = [p.position[:2] for phrase in order.things for p in finder.matching(phrase.noun)]
    walls_ = sorted(
        work.scene.room.walls,
        key=lambda wall: (-round(wall.length, 1), sum(wall.coordinates(spot)[1] for spot in lined)),
    )
    if noun is not None and noun.degree:
        named_ = bound(where, "", finder).anchors
        walls_ = [wall for wall in walls_ if wall.name in named_]
    for wall in walls_:
        where.noun = dataclasses.replace(noun, value=wall.name, degree="") if noun is not None else None
        plain = dataclasses.replace(order, text=wall.name)
        move(work, finder, plain)
        if len(work.failed) == said[1]:
            break
        failed = failed or work.failed[said[1] :]
        work.restore(saved)
        del work.done[said[0] :], work.failed[said[1] :]
        finder.scene = work.before = before
    else:
        work.failed += [f"no wall has room for all of them: {failed[0]}"]


def _groups(work: Work, finder: Finder, order: Order) -> Iterable[tuple[tuple[str, ...], list[Where]]]:
    """What is moved; of several that go nearer to something, or away from it, those in front first."""
    if not order.closer or order.direction or len(order.things) < 2:
        return moved_things(work, finder, order)
    groups = [group for group in moved_things(work, finder, order) if group[0]]
    ranks = {id: n for n, id in enumerate(_foremost_first(work, finder, order, [ids[0] for ids, _ in groups]))}
    return sorted(groups, key=lambda group: ranks[group[0][0]])


def _by_slots(work: Work, finder: Finder, ids: Sequence[str], places: Sequence[Where]) -> tuple[str, ...]:
    """Things in the order of the places that a phrase names for them, so that as few as can be have to move."""
    if not 1 < len(ids) <= MOST_SLOTS or len(places) != 1 or places[0].word == "spot":
        return tuple(ids)
    finder.about = ids[0]
    category = work.scene[ids[0]].category
    slots = slots_of(places[0], category, finder)
    if len(ids) % len(slots):
        return tuple(ids)
    slots *= len(ids) // len(slots)
    goals = [related(slot, category) for slot in slots]
    held = {(id, n): goal.check(work.scene, work.scene, id)[0] for id in ids for n, goal in enumerate(goals)}
    return max(permutations(ids), key=lambda ordered: sum(held[id, n] for n, id in enumerate(ordered)))


def _to_one_wall(work: Work, order: Order, ids: Sequence[str]) -> Order:
    """The order, where a row that goes "closer to the wall" goes to that which is nearest to all of it together."""
    bare = [phrase.noun.value == "wall" and not phrase.noun.degree for _, phrase in order.closer]
    if len(ids) < 2 or not any(bare) or not any(phrase.noun.rows for phrase in order.things):
        return order
    marks = [things(work.scene, id)[0] for id in ids]
    wall = min(
        walls(work.scene.room, "wall"), key=lambda w: sum(ground_gap(m, things(work.scene, w.name)[0]) for m in marks)
    )
    closer = [
        (
            nearer,
            dataclasses.replace(phrase, noun=dataclasses.replace(phrase.noun, value=wall.name)) if plain else phrase,
        )
        for (nearer, phrase), plain in zip(order.closer, bare, strict=True)
    ]
    return dataclasses.replace(order, closer=closer)


def _foremost_first(work: Work, finder: Finder, order: Order, ids: Sequence[str]) -> Sequence[str]:
    """Things that go one way, those in front first, so that none runs into the next."""
    if len(ids) < 2 or not (order.direction or order.closer):
        return ids
    if not order.direction:
        nearer, phrase = order.closer[0]
        if phrase.noun.det == "my":
            return ids
        gap = Nearing(mark_names(finder, phrase), nearer)
        return sorted(ids, key=lambda id: gap.of(work.scene, id) * (1.0 if nearer else -1.0))
    x, y, _ = way_of(work, order, work.scene[ids[0]])
    return sorted(ids, key=lambda id: -(work.scene[id].position[0] * x + work.scene[id].position[1] * y))


def _together(work: Work, finder: Finder, order: Order) -> None:
    """Bring things nearer to each other, or further apart: the largest stays."""
    if order.scatter and (rows := _rows_meant(work, finder, order)):
        by = order.lengths[0][0] if order.lengths else None
        scatter_rows(work, rows, by=by, slight=order.slight)
        finder.recent = [p.id for row in rows for p in row]
        return
    ids = list(dict.fromkeys(id for ids, _ in moved_things(work, finder, order) for id in ids))
    if len(ids) < 2:
        raise InputError(f"'{order.text}' names one thing; say what it is to come closer to, or away from")
    if order.scatter and len(ids) > 2:
        if _placed(order):
            raise InputError(f"'{order.text}' says how far apart things are to be and where; give two orders")
        scatter(work, ids, by=order.lengths[0][0] if order.lengths else None, slight=order.slight)
        finder.recent = ids
        return
    seats = {id: seats_at(work.scene, id, besides=ids) for id in ids}
    fixed, *rest = sorted(ids, key=lambda id: -work.scene[id].size[0] * work.scene[id].size[1])
    by = order.lengths[0][0] if order.lengths else None
    also = _also(work, finder, order, fixed)
    if also:
        move_one(work, order, fixed, also)
    looks = [goal for goal in also if isinstance(goal, IntoRoom) or (isinstance(goal, Related) and goal.kind in _LOOKS)]
    placed = [fixed]
    for id in rest:
        beside = order.mutual == "next_to"
        next_to = Abreast("next_to", (placed[-1],)) if order.abreast else Related("next_to", (fixed,))
        goal = next_to if beside else Nearing((fixed,), order.together, by, order.slight)
        there = _also(work, finder, order, id) if also and not _cornered(also) else looks
        there = [Related("facing", goal.anchors) if isinstance(goal, Across) else goal for goal in there]
        close = Apart((placed[-1] if order.abreast else fixed,), AT_IT, "le")
        pushed = beside and order.text.lower().split(" ", 1)[0] in _PUSHED
        saved, said = work.saved(), len(work.failed)
        move_one(work, order, id, [goal, *([close] if order.touching or pushed else []), *there])
        if len(work.failed) > said and pushed and not order.touching:
            work.restore(saved)
            del work.failed[said:]
            move_one(work, order, id, [goal, *there])
        placed.append(id)
    for id, left in seats.items():
        say_left(work, id, left)
    finder.recent = ids


def _rows_meant(work: Work, finder: Finder, order: Order) -> list[list[Placement]]:
    """The rows that an order moves apart: "pull the rows further apart"; empty where it is about other things."""
    noun = order.things[0].noun if len(order.things) == 1 and not order.things[0].places else None
    every = noun is not None and noun.rows < 0 and not noun.ordinal and noun.det in ("the", "all", "both")
    if not every or noun is None or _placed(order):
        return []
    of = finder.matching(dataclasses.replace(noun, rows=0, plural=True)) if noun.kind == "thing" else []
    rows = [row for row in rows_of_all(work.scene) if not of or any(p in of for p in row)]
    return rows if len(rows) > 1 else []


def _cornered(goals: Sequence[Goal]) -> bool:
    """Whether there is room for one thing alone: in a corner, or where another stood."""
    return any(isinstance(goal, At) or (isinstance(goal, Related) and goal.kind == "in_corner") for goal in goals)


def _placed(order: Order) -> bool:
    """Whether an order says where things go, besides how they stand to each other."""
    told = (order.places, order.facing, order.backs, order.direction, order.company, order.there, order.free)
    places = [w for phrase in order.things for w in phrase.places if w.word not in ("from", "of")]
    return any(told) or any(not phrase.noun.many or len(order.things) == 1 for phrase in order.things if places)


def _also(work: Work, finder: Finder, order: Order, id: str) -> list[Goal]:
    """Where things that are brought together go besides, and what they face: the largest of them leads.

    Raises:
        InputError: the order says more than that of them.
    """
    told = {"direction": order.direction, "angle": order.turn, "seat": order.seated, "company": order.company,
            "distance": order.closer or order.apart}  # fmt: skip
    if over := ", ".join(name for name, said in told.items() if said):
        raise InputError(f"'{order.text}' says how things stand to each other and a {over} too; give two orders")
    places = next((p.places for p in reversed(order.things) if p.places), order.places)
    known = [p for p in order.things if p.places is places]
    _, destination = split_places(finder, order, known[0], places) if known else ([], places)
    finder.scene, finder.about = work.scene, id
    return goals_of(work, finder, dataclasses.replace(order, slight=False), id, destination, 0, 1)


def resite(work: Work, finder: Finder, order: Order) -> None:
    """Find another place for things."""
    for ids, places in moved_things(work, finder, order):
        for id in ids:
            before = work.scene[id]
            finder.scene, finder.about = work.scene, id
            told = goals_of(work, finder, order, id, places, 0, 1)
            goal = Elsewhere(ELSEWHERE if before.support == "floor" else ELSEWHERE_SMALL)
            planned = work.usual_ties(id) or usual_ties(work.scene, before.category)
            failed: Reaching | None = None
            for ties in (planned, ()):
                failed = _anywhere(work, id, [goal, *told], ties)
                if failed is None:
                    break
            say(work, id, before, failed, [goal, *told])
        finder.recent = list(ids)


def _anywhere(work: Work, id: str, goals: Sequence[Goal], ties: Sequence[Tie]) -> Reaching | None:
    target = work.target(id, work.scene[id].category, ties, work.asset_of(id).attributes)
    reaching = Reaching(work, target, work.asset_of(id), goals)
    return None if reaching.run() else reaching
