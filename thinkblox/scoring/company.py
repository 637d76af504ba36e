"""What the guidelines say of things that belong together: at which distance, turned how, and looking at what."""

import heapq
import math
from collections.abc import Callable, Iterator, Sequence

from thinkblox.scene.rectangles import separation
from thinkblox.scene.room import turn_between
from thinkblox.scoring.rating import Case, Rating, plateau, rated
from thinkblox.scoring.standing import Furnishing, Standing, rects_of

TOGETHER = 1.5
"""What is further away than this belongs to something else [m]."""
LOOKS = (30.0, 90.0)
"""Up to the first angle something is looked at, from the second not at all [degrees]."""
_LOOKED_AT = 8
"""Of many seats or screens, so many of the nearest are looked at."""
_SCREEN = 0.6
"""Least diagonal of a screen that is watched from seats [m]."""


def distances(standing: Standing) -> Rating:
    """How far things that belong together are as far apart as the handbooks say, and turned to each other.

    Merrell et al. 2011, pairwise distance and angle; figures of the handbooks: a seat at its table 0.35 m under to
    0.15 m before it and facing it; a low table 0.3 to 0.5 m from its sofa; a nightstand within 0.1 m of its bed or
    sofa; a screen 1.5 to 2.5 of its diagonals from the seat that looks straight at it (within 10 degrees). The score
    is the mean over all such pairs.
    """
    cases = [*_seats(standing), *_low_tables(standing), *_nightstands(standing), *_screens(standing)]
    return rated(cases)


def _nearest(thing: Furnishing, others: Sequence[Furnishing]) -> tuple[Furnishing, float] | None:
    """Whichever is nearest, and how far it is, depth of overlap being less than 0 [m]."""
    found = [other for other in others if other is not thing]
    if not found:
        return None
    gaps = separation(rects_of((thing,)), rects_of(found))[0]
    best = int(gaps.argmin())
    return found[best], float(gaps[best])


def _near(thing: Furnishing, others: Sequence[Furnishing]) -> list[Furnishing]:
    """The nearest of the others, as many as are worth a look."""
    x, y, _ = thing.placement.position
    found = [other for other in others if other is not thing]
    if len(found) <= _LOOKED_AT:
        return found
    return heapq.nsmallest(_LOOKED_AT, found, key=lambda other: math.dist(other.placement.position[:2], (x, y)))


def _turn_to(thing: Furnishing, other: Furnishing) -> float:
    """Between where one looks who uses a thing and the nearest part of another [degrees]."""
    (x, y, _), (fx, fy, _) = thing.placement.position, other.placement.position
    a, b = other.placement.to_local((x, y))
    half = [side / 2 for side in other.placement.size[:2]]
    nearest = other.placement.to_room((min(max(a, -half[0]), half[0]), min(max(b, -half[1]), half[1])))
    spots = [spot for spot in ((fx, fy), nearest) if math.dist(spot, (x, y)) > 0.01]
    bearings = (math.degrees(math.atan2(spot[1] - y, spot[0] - x)) for spot in spots)
    return min((turn_between(thing.gaze, bearing) for bearing in bearings), default=0.0)


def _pairs(
    subjects: Sequence[Furnishing],
    anchors: Sequence[Furnishing],
    rate: Callable[[Furnishing, Furnishing, float], float],
) -> Iterator[Case]:
    for thing in subjects:
        found = _nearest(thing, anchors)
        if found is not None and found[1] < TOGETHER:
            other, gap = found
            yield Case(rate(thing, other, gap), f"{thing.id} is {gap:.2f} m from {other.id}")


def _seats(standing: Standing) -> Iterator[Case]:
    tables = [t for t in standing.on_floor if t.facts.is_in("meal_tables", "desks", "counters")]
    seats = [t for t in standing.on_floor if t.facts.is_in("seating") and t.is_moved]

    def drawn_up(seat: Furnishing, table: Furnishing, gap: float) -> float:
        turned = plateau(_turn_to(seat, table), -1.0, 0.0, *LOOKS) if seat.is_turned else 1.0
        return plateau(gap, -0.7, -0.4, 0.15, 0.7) * turned

    return _pairs(seats, tables, drawn_up)


def _low_tables(standing: Standing) -> Iterator[Case]:
    sofas = [t for t in standing.on_floor if t.facts.is_in("lounges")]
    tables = [t for t in standing.on_floor if t.placement.category == "coffee_table"]
    return _pairs(tables, sofas, lambda table, sofa, gap: plateau(gap, 0.05, 0.3, 0.5, 1.0))


def _nightstands(standing: Standing) -> Iterator[Case]:
    beds = [t for t in standing.on_floor if t.facts.is_in("beds", "lounges")]
    beside = [t for t in standing.on_floor if next(iter(t.facts.habits), "").startswith("next_to @beds")]
    return _pairs(beside, beds, lambda thing, bed, gap: plateau(gap, -0.05, -0.005, 0.1, 0.5))


def _screens(standing: Standing) -> Iterator[Case]:
    seats = [t for t in standing.on_floor if t.facts.is_in("lounges") and t.is_turned]
    for screen in standing.of("screens"):
        diagonal = math.hypot(*screen.placement.size[1:])
        if diagonal < _SCREEN or not seats:
            continue
        best = max((_viewing(seat, screen, diagonal) for seat in _near(screen, seats)), key=lambda case: case.score)
        yield best


def _viewing(seat: Furnishing, screen: Furnishing, diagonal: float) -> Case:
    (x, y, _), (sx, sy, _) = seat.placement.position, screen.placement.position
    away = max(0.0, math.dist((x, y), (sx, sy)) - seat.placement.size[0] / 2)
    turn = turn_between(seat.gaze, math.degrees(math.atan2(sy - y, sx - x)))
    back = turn_between(screen.gaze, math.degrees(math.atan2(y - sy, x - sx))) if screen.is_turned else 0.0
    fits = plateau(away / diagonal, 0.6, 1.5, 2.5, 4.5)
    score = fits * plateau(turn, -1.0, 0.0, 10.0, 60.0) * plateau(back, -1.0, 0.0, 30.0, 80.0)
    return Case(score, f"{seat.id} is {away:.2f} m from {screen.id}, {turn:.0f} degrees off it")


def conversation(standing: Standing) -> Rating:
    """How far lounge seats stand so that people talk: facing or at right angles, 1.2 to 2.4 m apart.

    Merrell et al. 2011, conversation: seats of a group face each other at the distance of a talk. For each seat the
    best of the others: 1 between 1.2 and 2.4 m from the middle of one front to that of the other, to 0 at 0.4 and 4 m,
    times how far each is turned to the other, 1 up to 60 degrees, 0 from 120. The score is the mean over seats.
    """
    seats = [t for t in standing.on_floor if t.facts.is_in("lounges") and t.is_turned]
    if len(seats) < 2:
        return Rating(None, {"things": float(len(seats))})
    cases = []
    for seat in seats:
        best = max((_talk(seat, other) for other in _near(seat, seats)), key=lambda case: case.score)
        cases.append(best)
    return rated(cases)


def _talk(seat: Furnishing, other: Furnishing) -> Case:
    a, b = (t.placement.to_room((t.placement.size[0] / 2, 0.0)) for t in (seat, other))
    away = math.dist(a, b)
    turns = [max(0.0, _turn_to(x, y)) for x, y in ((seat, other), (other, seat))]
    turned = min(plateau(turn, -1.0, 0.0, 60.0, 120.0) for turn in turns)
    return Case(plateau(away, 0.4, 1.2, 2.4, 4.0) * turned, f"{seat.id} is {away:.2f} m from {other.id}")


def emphasis(standing: Standing) -> Rating:
    """Whether seats look at a focal point, and what is to be the centre of a wall stands in the middle of it.

    Merrell et al. 2011, emphasis: a focal point, and the group turned to it. Focal points are screens, boards and
    fires; of every lounge seat, and every seat or desk that stands in rows before a board, the best look at one: 1 up
    to 30 degrees, 0 from 90; of every bed, fire and board, how far it is from the middle of its wall or of the stretch
    between its neighbours, over half of that. The score is the mean of all of these.
    """
    focal = [t for t in standing.of("screens", "boards", "watched") if math.hypot(*t.placement.size[1:]) > _SCREEN]
    focal += [t for t in standing.on_floor if t.placement.category == "fireplace"]
    lounges = [t for t in standing.on_floor if t.facts.is_in("lounges", "lined_up") and t.is_turned]
    cases = []
    for seat in lounges if focal else ():
        turn = min(_turn_to(seat, point) for point in _near(seat, focal))
        score = plateau(turn, -1.0, 0.0, *LOOKS)
        cases.append(Case(score, f"{seat.id} looks {turn:.0f} degrees past what it should look at"))
    centred = [_centred(standing, t) for t in (*standing.of("boards"), *standing.of("beds")) if t.is_turned]
    return rated([*cases, *(case for case in centred if case is not None)], points=len(focal))


def _centred(standing: Standing, thing: Furnishing) -> Case | None:
    """How near the middle of its wall something is; None for what stands at no wall, or is one of several there."""
    placement = thing.placement
    back = placement.to_room((-placement.size[0] / 2, 0.0))
    walls = [wall for wall in standing.room.walls if turn_between(placement.yaw, wall.yaw) < 10.0]
    wall = min(walls, key=lambda wall: abs(wall.coordinates(back)[1]), default=None)
    alike = [t for t in standing.things if t.placement.category == placement.category]
    if wall is None or wall.coordinates(back)[1] > 0.3 or len(alike) > 1:
        return None
    room = wall.length - placement.size[1]
    off = abs(wall.coordinates(back)[0] - wall.length / 2)
    score = 1.0 if room < 0.6 else 1.0 - 0.5 * min(1.0, 2.0 * off / room)
    return Case(score, f"{thing.id} is {off:.2f} m beside the middle of its wall")
