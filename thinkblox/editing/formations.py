"""Desks and tables arranged in rows, in a U, or in groups that face each other, each with what is drawn up to it."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain, islice, product

from thinkblox.assets import facts_of
from thinkblox.editing.acting import mark_names, moved_words
from thinkblox.editing.carrying import put_back, take
from thinkblox.editing.company import seats_at
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import EXACT, At, Goal, Turned
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reaching import Reaching, without
from thinkblox.editing.rows import SAME_WAY, looks_to, rows_of
from thinkblox.editing.spots import free, near_offsets
from thinkblox.editing.telling import named
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.tokens import tokenise
from thinkblox.scene.bearings import bearing
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

BEHIND = (0.75, 0.6, 0.5)
"""How much floor lies behind each seat, or each desk without one [m]: what is tried, the widest first."""
BESIDE = (0.35, 0.15, 0.05)
"""How far the desks of a row, and groups, stand from each other [m]."""
AROUND = 0.6
"""How far from the middle of the room the middle of all may come to be [m]."""
TRIES = 12
"""About so many middles are tried for each distance."""
TOUCHING = 0.01
"""How far the desks of a group stand from each other [m]."""


Cell = tuple[Vec2, float]
"""A spot of the floor [m], and where who sits there looks, or the yaw of what stands there [degrees]."""


MOST_MEASURED = 40
"""Most ways to stand that are measured."""
ACROSS = (1.6, 1.2, 0.9)
"""How much floor lies between two rows of seats that face each other [m]: what is tried, the widest first."""


@dataclass(frozen=True)
class Formation:
    """So many rows, or groups, of so many things each; of a U the row at its back and two sides of `each`."""

    parts: int
    each: int
    grouped: bool
    in_u: bool = False
    facing: bool = False

    def words(self) -> str:
        """In words."""
        if self.in_u:
            return f"a U with {self.each} at either side"
        return f"{self.parts} {'groups' if self.grouped else 'rows'} of {self.each}"


def formation_of(order: Order) -> Where | None:
    """The place of an order that is a formation: "in two rows of four", "into groups of four"."""
    places = [*order.places, *(where for phrase in order.things for where in phrase.places)]
    return next(
        (where for where in places if where.word == "in" and not where.negated and _is_formed(where.noun)), None
    )


def _is_formed(noun: Noun | None) -> bool:
    if noun is not None and _is_u(noun):
        return True
    if noun is None or noun.kind != "number" or noun.ordinal:
        return False
    words = noun.text.lower().split()
    return noun.rows > 1 or (bool(noun.count) and "groups" in words)


def _is_u(noun: Noun) -> bool:
    """Whether it is "a U", "a U shape", "a horseshoe"."""
    words = noun.text.lower().replace("-", " ").removeprefix("a ").removeprefix("the ").split()
    return words in (["u"], ["u", "shape"], ["u", "formation"], ["horseshoe"], ["horseshoe", "shape"])


def form(work: Work, finder: Finder, order: Order, where: Where) -> None:
    """Arrange things in a formation, with the seats that are drawn up to them and all that rests on them.

    Raises:
        InputError: there are not so many, or they do not stand on the floor.
    """
    ids = list(dict.fromkeys(id for phrase in order.things for id in named(finder, phrase, ())))
    ids = [id for id in work.touched(ids) if work.scene[id].support == "floor"]
    ids = _meant(work.scene, ids, where.noun)
    formation = _formation(order, where.noun, len(ids))
    if order.mutual == "facing" and not formation.grouped:
        formation = _face_to_face(work.scene, order, ids, formation)
    gaze = _gaze(work.scene, finder, order, ids)
    finder.recent = ids
    if _is_so(work.scene, ids, formation, gaze):
        work.done.append(f"{', '.join(ids)} stay: they stand in {formation.words()} already")
        return
    before, saved, said = work.scene, work.saved(), len(work.failed)
    why = ""
    said_so = bool(order.facing or any(w.word == "facing" for p in order.things for w in p.places))
    either = formation.grouped or formation.facing
    turns = (0.0, 90.0, 180.0, 270.0) if formation.in_u else (0.0, 90.0) if either else (0.0,)
    ways = [gaze] if said_so else [(gaze + turn) % 360.0 for turn in turns]
    laid = chain.from_iterable(_cells(before, ids, formation, way) for way in ways)
    for cells in islice((cells for cells in laid if _look_free(before, ids, cells)), MOST_MEASURED):
        failed = _moved(work, before, ids, cells)
        if not failed:
            work.done += [moved_words(before[p.id], p) for p in work.scene.placements if p != before[p.id]]
            del work.failed[said:]
            return
        why = why or failed
        work.restore(saved)
    work.failed.append(f"{', '.join(ids)} do not come to stand in {formation.words()}: {why or 'there is no room'}")


def _meant(scene: Scene, ids: list[str], noun: Noun | None) -> list[str]:
    """Those that are meant: of the desks of a class, where so many are said, not that of who teaches."""
    kinds = [scene[id].category for id in ids]
    most = [id for id in ids if scene[id].category == max(kinds, key=kinds.count)]
    count = noun.count if noun is not None and noun.count else len(ids)
    return most if len(ids) % count and not len(most) % count else ids


def _formation(order: Order, noun: Noun | None, count: int) -> Formation:
    """What is said of so many things.

    Raises:
        InputError: it is of another number of them.
    """
    text = noun.text.lower() if noun is not None else ""
    if noun is not None and _is_u(noun):
        if count < 3:
            raise InputError(f"'{order.text}': there are {count} of them, which make no U")
        return Formation(1, count // 3, grouped=False, in_u=True)
    counted = [int(found.value) for word in tokenise(text) if (found := grammar().at([word], 0, "count")) is not None]
    counted = counted or [int(token.text) for token in tokenise(text) if token.kind == "number"]
    grouped = "groups" in text.split()
    each = counted[-1] if text.rpartition(" of ")[1] and counted else 0
    parts = noun.rows if noun is not None and noun.rows > 1 else counted[0] if len(counted) > 1 else 0
    parts = parts or (count // each if each else 0)
    each = each or math.ceil(count / max(parts, 1))
    if count < 2 or not parts or not parts * (each - 1) < count <= parts * each or (grouped and each % 2):
        raise InputError(f"'{order.text}': there are {count} of them, which makes no '{text}'")
    return Formation(parts, each, grouped)


def _face_to_face(scene: Scene, order: Order, ids: Sequence[str], formation: Formation) -> Formation:
    """Two rows of seats that look at each other.

    Raises:
        InputError: they are not two, or of tables, or are to stand to each other otherwise.
    """
    seats = all(facts_of(scene[id].category).is_in("seating") for id in ids)
    if formation.parts != 2 or formation.in_u or not seats:
        raise InputError(f"'{order.text}': two rows of seats can face each other; say 'into groups of two' of tables")
    return replace(formation, facing=True)


def _gaze(scene: Scene, finder: Finder, order: Order, ids: Sequence[str]) -> float:
    """Where who sits there is to look: to what the order says, else as most of them do now [degrees]."""
    nouns = [*order.facing, *(w.noun for p in order.things for w in p.places if w.word == "facing" and w.noun)]
    if nouns:
        name = mark_names(finder, NounPhrase(nouns[0]))[0]
        x, y = scene.room.polygon.centroid.coords[0]
        mark = min(things(scene, name), key=lambda mark: math.dist(mark.centre, (x, y)))
        way = bearing((x, y), mark.centre)
        return min((wall.yaw + 180.0 for wall in scene.room.walls), key=lambda yaw: turn_between(yaw, way)) % 360.0
    gazes = [looks_to(scene, scene[id]) for id in ids]
    return max(gazes, key=lambda gaze: sum(turn_between(gaze, other) <= SAME_WAY for other in gazes))


def _is_so(scene: Scene, ids: Sequence[str], formation: Formation, gaze: float) -> bool:
    """Whether they stand in such rows already, and look that way."""
    rows = rows_of(scene, [scene[id] for id in ids])
    same = all(turn_between(looks_to(scene, scene[id]), gaze) <= SAME_WAY for id in ids)
    sizes = [len(row) for row in rows]
    even = len(rows) == formation.parts and max(sizes) == formation.each and sum(sizes) == len(ids)
    return same and even and not (formation.grouped or formation.in_u or formation.facing)


def _cells(scene: Scene, ids: Sequence[str], formation: Formation, gaze: float) -> Iterator[dict[str, Cell]]:
    """Where each of them stands and how it is turned, what is roomiest first, in the order of where they stand now."""
    size = scene[ids[0]].size
    seats = [scene[seat] for id in ids for seat in seats_at(scene, id, besides=())]
    deep, wide = size[0], size[1]
    sit = max((_reach(scene, seat, ids) for seat in seats), default=0.0)
    centres = [*_standing(scene, ids)] if formation.grouped else []
    centres += [(float(x), float(y)) for x, y in scene.room.polygon.centroid.coords]
    middles = near_offsets(AROUND)
    for behind in BEHIND:
        for beside in BESIDE:
            laid = [list(_u(formation, len(ids), deep, wide, beside) if formation.in_u
                         else _blocks(formation, deep, wide, sit + behind, beside) if formation.grouped
                         else _two_rows(formation, len(ids), deep, wide, ACROSS[BEHIND.index(behind)], beside)
                         if formation.facing
                         else _ranks(formation, len(ids), deep, wide, sit + behind, beside))]  # fmt: skip
            laid += [list(_blocks(formation, deep, wide, 0.0, beside, in_line=True))] if formation.grouped else []
            for (x, y), local, (dx, dy) in product(centres, laid, middles[:: max(1, len(middles) // TRIES)]):
                cells = [(_placed((x + dx, y + dy), gaze, spot), (gaze + turn) % 360.0) for spot, turn in local]
                yield _assigned(scene, ids, cells)


def _standing(scene: Scene, ids: Sequence[str]) -> Iterator[Vec2]:
    """The middle of where they stand now."""
    spots = [scene[id].position for id in ids]
    yield (sum(x for x, _, _ in spots) / len(spots), sum(y for _, y, _ in spots) / len(spots))


def _reach(scene: Scene, seat: Placement, ids: Sequence[str]) -> float:
    """How far a seat reaches beyond the desk that it is drawn up to [m]."""
    desk = min((scene[id] for id in ids), key=lambda p: math.dist(p.position, seat.position))
    away = abs(desk.to_local(seat.position[:2])[0])
    return max(0.0, away + seat.size[0] / 2 - desk.size[0] / 2)


def _ranks(formation: Formation, count: int, deep: float, wide: float, behind: float, beside: float) -> Iterator[Cell]:
    """Rows one behind the other, seen from the middle of all: ahead is where they look."""
    for n in range(count):
        row, column = divmod(n, formation.each)
        ahead = ((formation.parts - 1) / 2 - row) * (deep + behind)
        yield (ahead, ((formation.each - 1) / 2 - column) * (wide + beside)), 0.0


def _two_rows(
    formation: Formation, count: int, deep: float, wide: float, across: float, beside: float
) -> Iterator[Cell]:
    """Two rows of seats, of which the one ahead looks back."""
    out = (deep + across) / 2
    for n in range(count):
        row, column = divmod(n, formation.each)
        aside = ((formation.each - 1) / 2 - column) * (wide + beside)
        yield (-out if row else out, aside), 0.0 if row else 180.0


def _blocks(
    formation: Formation, deep: float, wide: float, behind: float, beside: float, *, in_line: bool = False
) -> Iterator[Cell]:
    """Groups side by side, in each of which two lines of desks meet with their fronts away from those who sit there.

    Groups that are in line stand one ahead of the other, end to end.
    """
    columns = formation.each // 2
    long = columns * (wide + TOUCHING)
    for group in range(formation.parts):
        step = (formation.parts - 1) / 2 - group
        middle = 0.0 if in_line else step * (2 * (deep + behind) + beside)
        ahead = step * (long + beside) if in_line else 0.0
        for n in range(formation.each):
            line, column = divmod(n, columns)
            along = (column + 0.5) * (wide + TOUCHING) - long / 2
            out = (deep + TOUCHING) / 2 * (1.0 if line else -1.0)
            yield (ahead + along, middle + out), -90.0 if line else 90.0


def _u(formation: Formation, count: int, deep: float, wide: float, beside: float) -> Iterator[Cell]:
    """A line at the back that looks ahead, to the open side, and one along either side that looks to the other."""
    line = count - 2 * formation.each
    step = wide + beside / 2
    back = -formation.each * step / 2
    aside = max((line - 1) / 2 * step + wide / 2, wide / 2) + deep / 2 + beside
    for n in range(line):
        yield (back, ((line - 1) / 2 - n) * step), 0.0
    for left, turn in ((1.0, -90.0), (-1.0, 90.0)):
        for n in range(formation.each):
            yield (back + deep / 2 + beside + wide / 2 + n * step, left * aside), turn


def _placed(centre: Vec2, gaze: float, spot: Vec2) -> Vec2:
    """A spot that is seen from a middle and a way that is ahead, in the room."""
    way = math.radians(gaze)
    x = centre[0] + spot[0] * math.cos(way) - spot[1] * math.sin(way)
    y = centre[1] + spot[0] * math.sin(way) + spot[1] * math.cos(way)
    return (round(x, 4), round(y, 4))


def _assigned(scene: Scene, ids: Sequence[str], cells: Sequence[Cell]) -> dict[str, Cell]:
    """A cell for each, the nearest that is left; cells are where who sits there looks, things by their yaw."""
    left, found = list(cells), {}
    for id in ids:
        cell = min(left, key=lambda cell: math.dist(cell[0], scene[id].position[:2]))
        left.remove(cell)
        turn = (scene[id].yaw - looks_to(scene, scene[id])) % 360.0
        found[id] = (cell[0], round((cell[1] + turn) % 360.0, 3) % 360.0)
    return found


def _look_free(scene: Scene, ids: Sequence[str], cells: dict[str, Cell]) -> bool:
    """Whether nothing else stands there, seen from above."""
    seats = {seat: id for id in ids for seat in seats_at(scene, id, besides=())}
    gone = [*ids, *seats]
    empty = without(scene, [*gone, *(rider.id for id in gone for rider in scene.riders(id))])
    for id in gone:
        spot, yaw = cells[id] if id in cells else _beside(scene, id, seats[id], cells)
        if not list(free(empty, scene.asset_of(scene[id]), [((*spot, scene[id].position[2]), yaw)])):
            return False
    return True


def _moved(work: Work, before: Scene, ids: Sequence[str], cells: dict[str, Cell]) -> str:
    """Put everything there, with seats and all that rests on it; why not, where that cannot be."""
    seats = {seat: id for id in ids for seat in seats_at(before, id, besides=set(work.kept))}
    taken = take(work, [*ids, *seats])
    for id in (*ids, *seats):
        spot, yaw = cells[id] if id in cells else _beside(before, id, seats[id], cells)
        old, asset = before[id], work.assets[before[id].asset]
        target = work.target(id, old.category, (), asset.attributes)
        goals: list[Goal] = [At(spot, EXACT), Turned((yaw,))]
        pose = ((*spot, old.position[2]), yaw)
        reaching = Reaching(work, target, asset, goals, direct=(pose,), ask=False, search=False)
        if not reaching.run():
            return reaching.why
        if lost := put_back(work, old, [p for p in taken if p.id not in (*ids, *seats)], before):
            return f"{', '.join(lost)} could not go along with {id}"
    return ""


def _beside(scene: Scene, seat: str, desk: str, cells: dict[str, Cell]) -> Cell:
    """Where a seat stands to its desk as it did before."""
    (x, y), yaw = cells[desk]
    turn = yaw - scene[desk].yaw
    ahead, left = scene[desk].to_local(scene[seat].position[:2])
    way = math.radians(yaw)
    spot = (x + ahead * math.cos(way) - left * math.sin(way), y + ahead * math.sin(way) + left * math.cos(way))
    return (round(spot[0], 4), round(spot[1], 4)), round((scene[seat].yaw + turn) % 360.0, 3) % 360.0
