"""Whether a relation of a brief holds in a scene: geometry over footprints and heights, with what was measured."""

from collections.abc import Sequence

from thinkblox.brief import RelationKind
from thinkblox.scene.arrangement import Arrangement
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.companies import around, at_sides, between, in_rows, on_one, over_so_many
from thinkblox.scene.landmarks import Landmark, corners, things
from thinkblox.scene.pairs import FLAT, Finding, Pair, denied_for, every, facing_each_other, pair_for
from thinkblox.verdict import RelationResult

FACED = 2.0
"""How far at most a wall is off that is faced and has no name: nobody faces one across the room [m]."""
_DEFAULT_ANCHOR = {"against_wall": ("wall",), "in_corner": ("corner",), "in_centre": ("centre",)}
_ONE = ("one_wall", "opposite_wall")
_PARTS = ("wall", "corner", "window", "door")
"""Parts of a room of which there may be none."""


def measure(
    scene: Arrangement,
    kind: RelationKind,
    subject: str | Sequence[str],
    anchors: Sequence[str],
    *,
    rows: int = 0,
    each: bool = False,
    spread: int = 0,
    negated: bool = False,
) -> RelationResult:
    """Measure whether `subject` stands in a relation to `anchors`.

    Args:
        scene: where.
        kind: which relation.
        subject: one id, or the ids of all members of a request: each of them must hold.
        anchors: ids, Places, names of walls or ids of openings. Several subjects without anchors are measured against
            each other (and face each other when both do). A relation between two things holds when it holds for any
            one anchor; "between" takes them together.
        rows: for "in_rows", how many; 0 for any number.
        each: every anchor, or every corner, needs a subject of its own as well.
        spread: over how many different walls or corners the subjects are; 0 for any number.
        negated: it must not hold, for no subject and no anchor; `holds` says then that this is so.

    Returns:
        Also for what is not in the scene: the relation does not hold then, and `measured` says what is missing.
    """
    subjects = (subject,) if isinstance(subject, str) else tuple(subject)
    against = tuple(anchors) or _DEFAULT_ANCHOR.get(kind, subjects[1:] and subjects)
    found = {name: things(scene, name) for name in (*subjects, *against)}
    absent = [name for name, parts in found.items() if not parts]
    if negated and subjects and absent and set(absent) <= set(_PARTS):
        holds, text = True, f"the room has no {', '.join(absent)}"
    elif absent or not subjects:
        holds, text = False, f"{', '.join(absent) or 'the subject'} is not in the room"
    else:
        members = [found[name][0] for name in subjects]
        parts = [part for name in against for part in found[name]]
        if kind == "in_corner":
            parts = list(corners(scene.room, against))
        if kind == "facing" and against == ("wall",):
            parts = [wall for wall in parts if any(ground_gap(m, wall) <= FACED for m in members)] or parts
        if negated:
            holds, text = _none(scene, kind, members, parts, rows)
        elif spread and parts:
            holds, text = over_so_many(members, parts, pair_for(kind, scene.room), spread)
        elif len(against) == 1 and against[0] in _ONE and parts:
            holds, text = on_one(members, parts, pair_for(kind, scene.room))
        else:
            holds, text = _all(scene, kind, members, parts, rows, each)
    return RelationResult(
        kind=kind, subject=", ".join(subjects), anchors=tuple(anchors), holds=holds, measured=text, negated=negated
    )


def _all(
    scene: Arrangement, kind: RelationKind, members: list[Landmark], anchors: list[Landmark], rows: int, each: bool
) -> Finding:
    if kind == "in_rows":
        return in_rows(members, rows)
    if not anchors:
        return False, "the relation names nothing to measure against"
    if kind == "around":
        return around(members, anchors)
    if kind == "between":
        return every([between(member, anchors) for member in members])
    pair = pair_for(kind, scene.room)
    if kind in ("at_long_side", "at_short_side"):
        return at_sides(members, anchors, long=kind == "at_long_side", pair=pair)
    if kind == "far" or (kind == "under" and len(members) == 1 and members[0].top - members[0].base <= FLAT):
        return every([pair(member, anchor) for member in members for anchor in anchors if anchor.name != member.name])
    if kind == "facing" and anchors == members:
        pair = facing_each_other
    findings = [_best(pair, member, anchors) for member in members]
    if each:
        findings += [_best(lambda a, m: pair(m, a), anchor, members) for anchor in anchors]
    return every(findings)


def _none(
    scene: Arrangement, kind: RelationKind, members: list[Landmark], anchors: list[Landmark], rows: int
) -> Finding:
    """No subject has the relation to any anchor; the text is that of those that have, or of the nearest."""
    if kind in ("around", "between", "in_rows"):
        found, text = _all(scene, kind, members, anchors, rows, False)
        return not found, text
    findings = [_best(denied_for(kind, scene.room), member, anchors) for member in members]
    return every([(not found, text) for found, text in findings])


def _best(pair: Pair, one: Landmark, others: list[Landmark]) -> Finding:
    """The finding against the nearest of the others for which it holds, else against the nearest."""
    near_first = sorted((o for o in others if o.name != one.name), key=lambda o: one.footprint.distance(o.footprint))
    findings = [pair(one, other) for other in near_first]
    return next((f for f in findings if f[0]), findings[0] if findings else (False, "there is no other"))
