"""Where in the room the faults of a report are: overlaps, what reaches out, gaps below, blocked zones and ways."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import shapely
from numpy.typing import NDArray

from thinkblox.sim.geometry.openings import door_zone, window_zone
from thinkblox.sim.render.motions import rests, sweep
from thinkblox.sim.render.sights import Scenery, Sighted
from thinkblox.sim.settings import Walking
from thinkblox.verdict import Report, Verdict

Array = NDArray[np.float64]
Kind = Literal["overlap", "contact", "outside", "gap", "rest", "swing", "zone", "push", "unreachable", "move"]
FALLS = frozenset({"drop", "drift", "tilt", "unsupported"})
MOST_PAIRS = 600
"""Pairs of pieces whose common volume is worked out, at most, for one collision."""
LEAST_OUT = 1e-4
"""What reaches less through the floor or the ceiling is not drawn [m]."""
LEAST_GAP = 0.002
"""Gaps below this are not drawn [m]."""


@dataclass(frozen=True)
class Fault:
    """One thing to draw.

    Attributes:
        kind: what it shows.
        id: the object whose fault it is.
        solids: points (n, 3) each; the hulls of their projections are filled or outlined [m].
        arrow: from where to where (2, 3), or None [m].
        dashes: lines (k, 3) drawn dashed [m].
        text: the number that belongs to it.
    """

    kind: Kind
    id: str
    solids: tuple[Array, ...] = ()
    arrow: Array | None = None
    dashes: tuple[Array, ...] = ()
    text: str = ""


def faults_of(report: Report, scenery: Scenery, walking: Walking | None = None) -> tuple[Fault, ...]:
    """Everything in a report that has a place in the room."""
    failing = [v for v in report.objects if not v.valid]
    found = [*_overlaps(failing, scenery), *_swings(failing, scenery)]
    found += [fault for verdict in failing for fault in _of_verdict(verdict, scenery, walking or Walking())]
    moving = [v for v in failing if v.settled and FALLS.intersection(v.reasons)]
    return (*found, *_rests(moving, scenery), *_unreachable(report, scenery), *_moves(report, scenery))


def _of_verdict(verdict: Verdict, scenery: Scenery, walking: Walking) -> Iterator[Fault]:
    body = scenery.body(verdict.id)
    if body is None:
        return
    if "outside" in verdict.reasons:
        yield from _outside(scenery, body, verdict.outside)
    if "drop" in verdict.reasons or "unsupported" in verdict.reasons:
        yield from _gap(scenery, body)
    for push in verdict.pushed if "pushes" in verdict.reasons else ():
        other = scenery.body(push.other)
        if other is not None:
            arrow = np.array([body.middle, other.middle])
            yield Fault("push", body.id, arrow=arrow, text=f"pushed {millimetres(push.distance)}")
    yield from _zones(scenery, verdict, walking)


def millimetres(length: float) -> str:
    """A length as it is written beside a mark: "3.0 mm", "120 mm", "1.25 m"."""
    if abs(length) >= 1.0:
        return f"{length:.2f} m"
    return f"{length * 1000:.0f} mm" if abs(length) >= 0.01 else f"{length * 1000:.1f} mm"


def _overlaps(verdicts: Sequence[Verdict], scenery: Scenery) -> Iterator[Fault]:
    """Every pair that collides, once."""
    seen: set[frozenset[str]] = set()
    for verdict in verdicts:
        for collision in verdict.collisions:
            pair = frozenset((verdict.id, collision.other))
            body, other = scenery.body(verdict.id), scenery.body(collision.other)
            if pair not in seen and body is not None and other is not None:
                seen.add(pair)
                yield _overlap(scenery, body, other, f"{millimetres(collision.depth)} deep")


def _overlap(scenery: Scenery, body: Sighted, other: Sighted, text: str) -> Fault:
    """What two objects both fill; where no common volume is found, the engine's contacts between them."""
    common = tuple(_common(body, other))
    if common:
        return Fault("overlap", body.id, common, text=text)
    points = _contacts(scenery, body.id, other.id)
    if not len(points):
        low = np.maximum(body.points.min(0), other.points.min(0))
        high = np.minimum(body.points.max(0), other.points.max(0))
        points = np.array([(low + high) / 2])
    return Fault("contact", body.id, tuple(point[None] for point in points), text=text)


def _common(body: Sighted, other: Sighted) -> Iterator[Array]:
    """Corners of each volume that a piece of one shares with a piece of the other."""
    from manifold3d import Manifold

    for a, b in [(a, b) for a in body.pieces for b in other.pieces if _boxes_meet(a, b)][:MOST_PAIRS]:
        shared = Manifold.hull_points(a) ^ Manifold.hull_points(b)
        if shared.volume() > 1e-10:
            yield np.asarray(shared.to_mesh().vert_properties, np.float64)[:, :3]


def _swings(verdicts: Sequence[Verdict], scenery: Scenery) -> Iterator[Fault]:
    """Every door or drawer that is kept shut, once."""
    blocked = [v for v in verdicts if "blocks_opening" in v.reasons]
    found = [(verdict.id, swing) for verdict in blocked[::-1] for swing in verdict.swings if swing.opens < 1.0]
    shut = {(swing.of, swing.link): (id, swing) for id, swing in found}
    for (of, link), (id, swing) in shut.items():
        swept = sweep(scenery.subject, of, link)
        if swept:
            yield Fault("swing", id, swept, text=f"opens {swing.opens:.0%}")


def _boxes_meet(a: Array, b: Array) -> bool:
    return bool((a.min(0) < b.max(0)).all() and (b.min(0) < a.max(0)).all())


def _contacts(scenery: Scenery, first: str, second: str, most: int = 4) -> Array:
    """The deepest contact points between two objects (n, 3)."""
    model, data = scenery.subject.model, scenery.subject.data()
    bodies = {thing.id: set(thing.bodies) for thing in scenery.subject.things}
    wanted = (bodies.get(first, set()), bodies.get(second, set()))
    found: list[tuple[float, tuple[float, ...]]] = []
    for index in range(data.ncon):
        a, b = (int(model.geom_bodyid[geom]) for geom in data.contact.geom[index])
        if (a in wanted[0] and b in wanted[1]) or (b in wanted[0] and a in wanted[1]):
            found.append((float(data.contact.dist[index]), tuple(map(float, data.contact.pos[index]))))
    return np.array([point for _, point in sorted(found)[:most]], np.float64).reshape(-1, 3)


def _outside(scenery: Scenery, body: Sighted, distance: float) -> Iterator[Fault]:
    """The part outside the room, and an arrow as long as it reaches out."""
    room, text = scenery.room, f"{millimetres(distance)} outside"
    if room is None:
        return
    past = shapely.difference(body.footprint, room.polygon)
    parts = [part for part in shapely.get_parts(past) if shapely.area(part) > 1e-8]
    if parts:
        corners = np.concatenate([shapely.get_coordinates(part) for part in parts])
        reach = shapely.distance(shapely.points(corners), room.polygon)
        furthest = shapely.Point(corners[reach > reach.max() - 0.001].mean(0))
        line = shapely.get_coordinates(shapely.shortest_line(room.polygon, furthest))
        rings = [shapely.get_coordinates(part) for part in parts]
        solids = tuple(np.concatenate([_at(ring, body.low), _at(ring, body.high)]) for ring in rings)
        yield Fault("outside", body.id, solids, arrow=_at(line, max(body.low, 0.0)), text=text)
    x, y = body.middle[:2]
    reaches = (
        ("above the ceiling", room.height, max(body.high, room.height)),
        ("in the floor", 0.0, min(body.low, 0.0)),
    )
    for where, start, end in reaches:
        if abs(end - start) > LEAST_OUT:
            arrow = np.array([(x, y, start), (x, y, end)])
            yield Fault("outside", body.id, arrow=arrow, text=f"{millimetres(abs(end - start))} {where}")


def _at(flat: Array, height: float) -> Array:
    return np.column_stack([flat, np.full(len(flat), height)])


def _gap(scenery: Scenery, body: Sighted) -> Iterator[Fault]:
    """Dashes from the corners of an object's base down to what lies below; for what is mounted, to its wall."""
    mounted = _to_wall(scenery, body)
    if mounted is not None:
        if np.linalg.norm(mounted[0] - mounted[1]) > LEAST_GAP:
            length = float(np.linalg.norm(mounted[0] - mounted[1]))
            yield Fault("gap", body.id, arrow=mounted, text=f"{millimetres(length)} off")
        return
    base = body.points[body.points[:, 2] < body.low + 0.02]
    outline = shapely.get_coordinates(shapely.oriented_envelope(shapely.MultiPoint(base[:, :2])))
    corners = np.unique(np.round(outline, 6), axis=0)[:4]
    others = [piece for other in (*scenery.bodies, scenery.rest) if other is not body for piece in other.pieces]
    feet = [np.array([(x, y, body.low), (x, y, _below(others, x, y, body.low))]) for x, y in corners]
    x, y = corners.mean(0)
    middle = np.array([(x, y, body.low), (x, y, _below(others, x, y, body.low))])
    dashes = tuple(foot for foot in feet if foot[0, 2] - foot[1, 2] > LEAST_GAP)
    height = float(middle[0, 2] - middle[1, 2])
    if dashes and height > LEAST_GAP:
        yield Fault("gap", body.id, arrow=middle, dashes=dashes, text=f"{millimetres(height)} above")


def _below(pieces: Sequence[Array], x: float, y: float, height: float) -> float:
    """Height of the highest piece below a point; 0, the floor's, where there is none [m]."""
    found = [0.0] if height >= 0.0 else [height]
    for piece in pieces:
        low, high = piece.min(0), piece.max(0)
        if low[0] <= x <= high[0] and low[1] <= y <= high[1] and high[2] <= height + 0.002:
            hull = shapely.MultiPoint(piece[:, :2]).convex_hull
            if shapely.intersects_xy(hull, x, y):
                found.append(float(high[2]))
    return max(found)


def _to_wall(scenery: Scenery, body: Sighted) -> Array | None:
    """From the back of something mounted to the wall or ceiling that it names (2, 3)."""
    scene = scenery.scene
    placement = scene[body.id] if scene is not None and body.id in scene else None
    if scene is None or placement is None or scene.asset_of(placement).mount not in ("wall", "ceiling"):
        return None
    x, y, z = body.middle
    if scene.asset_of(placement).mount == "ceiling":
        return np.array([(x, y, body.high), (x, y, scene.room.height)])
    wall = next((wall for wall in scene.room.walls if wall.name == placement.support), None)
    if wall is None:
        return np.array([(x, y, z), (x, y, z)])
    inward = (body.points[:, :2] - wall.start) @ np.array(wall.inward)
    along = float((body.middle[:2] - wall.start) @ np.array(wall.along))
    return np.array([(*wall.point(along, float(inward.min())), z), (*wall.point(along), z)])


def _rests(verdicts: Sequence[Verdict], scenery: Scenery) -> Iterator[Fault]:
    """Where what moves while it settles ends up, as the engine finds it with all else held still."""
    ends = rests(scenery.subject, [verdict.id for verdict in verdicts])
    for verdict in verdicts:
        body, end = scenery.body(verdict.id), ends.get(verdict.id)
        if body is None or end is None:
            continue
        points = body.points @ end.turn.T + end.shift
        slides = f"slides {millimetres(verdict.drift)}" if "drift" in verdict.reasons else ""
        text = f"tilts {verdict.tilt:.0f}°" if "tilt" in verdict.reasons else slides
        way = np.array([body.middle, body.middle @ end.turn.T + end.shift])
        yield Fault("rest", body.id, (points,), arrow=way if text else None, text=text)


def _zones(scenery: Scenery, verdict: Verdict, walking: Walking) -> Iterator[Fault]:
    room = scenery.room
    for opening in room.openings if room is not None else ():
        if room is not None and opening.id in verdict.blocked:
            zone_of = door_zone if opening.kind == "door" else window_zone
            zone = shapely.get_coordinates(zone_of(room, opening, walking))
            yield Fault("zone", verdict.id, (_at(zone, 0.003),), text=opening.id)


def _unreachable(report: Report, scenery: Scenery) -> Iterator[Fault]:
    for access in (report.walker, report.robot):
        for id in access.unreachable if access is not None else ():
            body = scenery.body(id)
            if body is not None:
                who = "walker" if access is report.walker else "robot"
                yield Fault("unreachable", id, (body.middle[None],), text=f"no way for a {who}")


def _moves(report: Report, scenery: Scenery) -> Iterator[Fault]:
    for move in report.moves:
        body = scenery.body(move.id)
        if body is not None and move.distance > 0.0:
            middle = body.middle
            yield Fault("move", move.id, arrow=np.array([middle - move.by, middle]), text=millimetres(move.distance))
