"""The report on a generated room: what physics says of the whole, and whether the prompt's words hold in it."""

from collections.abc import Iterator, Sequence

from msgspec import structs

from thinkblox.brief import RelationKind
from thinkblox.plainness import plain_things
from thinkblox.plan import Plan, Tie
from thinkblox.scene.landmarks import corners
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.verdict.requirement import Requirement
from thinkblox.sim.verdict.verify import verify
from thinkblox.verdict import Absence, RelationResult, Report

TOGETHER: frozenset[RelationKind] = frozenset({"around", "in_rows"})
"""Relations that a whole company has, not each member by itself; as is any that names no anchor."""
UNKNOWN = "unknown"
"""Category of what the catalogue does not have."""
NO_DOOR = "The room has no door, so that no walkable way could be measured."


def report_on(
    scene: Scene,
    plan: Plan,
    *,
    absent: Sequence[Absence],
    tolerances: Tolerances,
    requirements: Sequence[Requirement] = (),
) -> Report:
    """Verify the scene and hold it against its plan."""
    missing = [
        Absence(id=word, category=UNKNOWN, asked=True, reason="the catalogue has nothing of that name")
        for word in plan.brief.missing
    ]
    verified = verify(scene, tolerances=tolerances, requirements=requirements)
    gone = (*absent, *missing)
    relations = tuple(relations_of(scene, plan))
    there = not any(absence.asked for absence in gone)
    doorless = () if any(o.kind == "door" for o in scene.room.openings) else (NO_DOOR,)
    return structs.replace(
        verified,
        complete=verified.valid and there and all(relation.holds for relation in relations),
        notes=(*plan.notes, *doorless, *verified.notes),
        absent=gone,
        stand_ins=plain_things(scene),
        unknown=plan.brief.unknown,
        relations=relations,
    )


def relations_of(scene: Scene, plan: Plan) -> Iterator[RelationResult]:
    """Measure every relation that the prompt names, once for a company and once for each other object."""
    for (subject, tie), members in _companies(plan).items():
        here = [id for id in members if id in scene]
        gone = [id for id in (*members, *tie.anchors) if id[-1].isdigit() and id not in scene]
        if gone:
            names = ", ".join(gone)
            yield RelationResult(
                kind=tie.kind, subject=subject, anchors=tie.anchors, holds=False, measured=f"{names} not placed"
            )
        else:
            filled = tie.kind == "in_corner" and len(here) >= len(corners(scene.room, tie.anchors)) > 1
            yield measure(scene, tie.kind, here, tie.anchors, rows=tie.rows, each=filled)


def _companies(plan: Plan) -> dict[tuple[str, Tie], list[str]]:
    """Who shares a relation: all of a request where it is one of the whole, else each object by itself."""
    groups: dict[tuple[str, Tie], list[str]] = {}
    for target in plan.targets:
        for tie in target.ties:
            if tie.asked:
                together = tie.kind in TOGETHER or not tie.anchors or (tie.kind == "in_corner" and tie.count > 1)
                alike = structs.replace(tie, index=0, count=1)
                groups.setdefault((target.request if together else target.id, alike), []).append(target.id)
    for (request, tie), members in groups.items():
        if not tie.anchors:
            members[:] = [target.id for target in plan.targets if target.request == request]
    return groups
