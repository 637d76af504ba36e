"""The report on a generated room: what physics says of the whole, and whether the prompt's words hold in it."""

from collections.abc import Iterator, Sequence

from msgspec import structs

from thinkblox.brief import RelationKind
from thinkblox.demands import demands_of, placed_of
from thinkblox.headline import UNKNOWN
from thinkblox.plainness import plain_things
from thinkblox.plan import Plan, Target, Tie
from thinkblox.reading.counts import MAX_OBJECTS, MAX_OF_A_KIND
from thinkblox.scene.landmarks import corners
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.scoring import score
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.verdict.requirement import Requirement
from thinkblox.sim.verdict.verify import verify
from thinkblox.verdict import Absence, RelationResult, Report

TOGETHER: frozenset[RelationKind] = frozenset({"around", "in_rows", "at_long_side", "at_short_side"})
"""Relations that a whole company has, not each member by itself; as is any that names no anchor, or is spread."""
NAMELESS = "the catalogue has nothing of that name"
TOO_MANY = f"a room is given at most {MAX_OBJECTS} things, and {MAX_OF_A_KIND} of a kind"
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
    brief = plan.brief
    missing = [
        Absence(id=word, category=UNKNOWN, asked=True, reason=why)
        for why, words in ((NAMELESS, brief.missing), (TOO_MANY, brief.beyond))
        for word in words
    ]
    verified = verify(scene, tolerances=tolerances, requirements=requirements)
    relations, demands = tuple(relations_of(scene, plan)), demands_of(scene, plan)
    so = all(r.holds for r in relations) and all(d.holds for d in demands)
    as_asked = so and not missing and not brief.unknown
    doorless = () if any(o.kind == "door" for o in scene.room.openings) else (NO_DOOR,)
    return structs.replace(
        verified,
        complete=verified.valid and as_asked,
        notes=(*plan.notes, *doorless, *verified.notes),
        absent=(*absent, *missing),
        stand_ins=plain_things(scene),
        unknown=brief.unknown,
        relations=relations,
        demands=demands,
        score=score(scene),
    )


def relations_of(scene: Scene, plan: Plan) -> Iterator[RelationResult]:
    """Measure every relation that the prompt names, once for a company and once for each other object."""
    spared = _spared(scene, plan)
    for (subject, tie), members in _companies(plan).items():
        wanted = [id for id in members if id not in spared]
        anchors = tuple(id for id in tie.anchors if id not in spared)
        if not wanted or (tie.anchors and not anchors):
            continue
        gone = [id for id in (*wanted, *anchors) if _is_planned(plan, id) and id not in scene]
        if gone:
            says = f"{', '.join(gone)} not placed"
            yield RelationResult(kind=tie.kind, subject=subject, anchors=anchors, holds=False, measured=says)
        else:
            filled = tie.kind == "in_corner" and len(wanted) >= len(corners(scene.room, anchors)) > 1
            yield measure(scene, tie.kind, wanted, anchors, rows=tie.rows, each=filled, spread=tie.spread)
    yield from _denied(scene, plan)


def _denied(scene: Scene, plan: Plan) -> Iterator[RelationResult]:
    """Measure every relation that must not hold; what is not there cannot have it."""
    for target in plan.targets:
        for tie in target.denied:
            anchors = tuple(id for id in tie.anchors if id in scene or not _is_planned(plan, id))
            if target.id in scene and (anchors or not tie.anchors):
                yield measure(scene, tie.kind, target.id, anchors, rows=tie.rows, negated=True)


def _is_planned(plan: Plan, id: str) -> bool:
    return any(target.id == id for target in plan.targets)


def _spared(scene: Scene, plan: Plan) -> frozenset[str]:
    """Those not placed of requests of which enough are: "at least eight" of ten planned."""
    enough = {
        request.key for request in plan.brief.requests if len(placed_of(scene, plan, request.key)) >= request.bounds[0]
    }
    return frozenset(t.id for t in plan.targets if t.request in enough and t.id not in scene)


def _companies(plan: Plan) -> dict[tuple[str, Tie], list[str]]:
    """Who shares a relation: all of a request where it is one of the whole, else each object by itself."""
    groups: dict[tuple[str, Tie], list[str]] = {}
    for target, tie in _asked(plan):
        alike = structs.replace(tie, index=0, count=1)
        groups.setdefault((_company(target, tie), alike), []).append(target.id)
    for (request, tie), members in groups.items():
        if not tie.anchors:
            members[:] = [target.id for target in plan.targets if target.request == request]
    return groups


def _asked(plan: Plan) -> Iterator[tuple[Target, Tie]]:
    """Every relation that the prompt names, with who has it; what only serves another is none."""
    for target in plan.targets:
        yield from ((target, tie) for tie in target.ties if tie.asked and not tie.means)
    by_id = {target.id: target for target in plan.targets}
    for due in (due for target in plan.targets for due in target.due):
        if due.subject in by_id:
            yield by_id[due.subject], due.tie


def _company(target: Target, tie: Tie) -> str:
    together = tie.kind in TOGETHER or not tie.anchors or tie.spread or (tie.kind == "in_corner" and tie.count > 1)
    return target.request if together else target.id
