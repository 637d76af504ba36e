"""What the report of a room said of its prompt, held against the room as it is after an edit or an undo."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.demands import demands_of
from thinkblox.plan import Plan
from thinkblox.reporting import relations_of
from thinkblox.scene.scene import Scene
from thinkblox.verdict import Absence, Demand, RelationResult, Report

NOT_PLACED = "not placed when the room was made"


def carried_over(report: Report, scene: Scene, before: Scene, known: Report | None, plan: Plan | None) -> Report:
    """A report with what `known`, on the room before, said of the prompt, measured anew.

    What held before and does not any more is what the edit changed on purpose: it is left out, and a note says so. What
    did not hold before and does not now keeps the report from being complete.
    """
    if known is None or plan is None:
        return report
    wanted = _filled(plan, scene, before)
    told: list[RelationResult | Demand] = [*known.relations, *known.demands]
    old, held = {_key(r) for r in known.relations}, {_key(r) for r in told if r.holds}
    there = [r for r in relations_of(scene, plan) if _key(r) in old]
    said = {_key(d) for d in known.demands}
    asked = [d for d in demands_of(scene, wanted) if _key(d) in said]
    now: list[RelationResult | Demand] = [*there, *asked]
    given_up = [r for r in now if not r.holds and _key(r) in held]
    notes = [f"No longer so since an edit: {_words(r)}." for r in given_up]
    return _with(
        report,
        relations=[r for r in there if r not in given_up],
        demands=[d for d in asked if d not in given_up],
        absent=_still_absent(known.absent, scene, before),
        plan=plan,
        notes=notes,
    )


def as_made(report: Report, scene: Scene, known: Report | None, plan: Plan) -> Report:
    """A report on a room that is again as it was made, held against its whole plan."""
    listed = [a for a in known.absent if a.id not in scene] if known is not None else []
    names = {a.id for a in listed}
    listed += [
        Absence(id=t.id, category=t.category, asked=True, reason=NOT_PLACED)
        for t in plan.targets
        if t.asked and t.id not in scene and t.id not in names
    ]
    relations, demands = list(relations_of(scene, plan)), list(demands_of(scene, plan))
    return _with(report, relations=relations, demands=demands, absent=listed, plan=plan, notes=())


def _with(
    report: Report,
    *,
    relations: Sequence[RelationResult],
    demands: Sequence[Demand],
    absent: Sequence[Absence],
    plan: Plan,
    notes: Sequence[str],
) -> Report:
    so = all(r.holds for r in relations) and all(d.holds for d in demands)
    nameless = bool(plan.brief.unknown or plan.brief.missing or plan.brief.beyond)
    return structs.replace(
        report,
        complete=report.complete and so and not nameless and not any(a.asked for a in absent),
        unknown=tuple(dict.fromkeys((*report.unknown, *plan.brief.unknown))),
        relations=tuple(relations),
        demands=tuple(demands),
        absent=tuple(absent),
        notes=(*report.notes, *notes),
    )


def _filled(plan: Plan, scene: Scene, before: Scene) -> Plan:
    """The plan, where what was added stands for what was missing of its kind."""
    added = [p for p in scene.placements if p.id not in before and not any(t.id == p.id for t in plan.targets)]
    targets = []
    for target in plan.targets:
        new = next((p for p in added if p.category == target.category), None)
        if target.id not in before and target.id not in scene and new is not None:
            added.remove(new)
            target = structs.replace(target, id=new.id)
        targets.append(target)
    return structs.replace(plan, targets=tuple(targets))


def _still_absent(absent: Sequence[Absence], scene: Scene, before: Scene) -> list[Absence]:
    """What is still missing: each thing that was added stands for one of its kind."""
    added = [p.category for p in scene.placements if p.id not in before]
    left = []
    for absence in absent:
        if absence.category in added:
            added.remove(absence.category)
        elif absence.id not in scene:
            left.append(absence)
    return left


def _key(result: RelationResult | Demand) -> tuple[object, ...]:
    if isinstance(result, Demand):
        return result.kind, result.subject, result.wanted
    return result.kind, result.subject, result.anchors, result.negated


def _words(result: RelationResult | Demand) -> str:
    if isinstance(result, Demand):
        return f"{result.subject}: {result.wanted} ({result.measured})"
    no = "not " if result.negated else ""
    return f"{result.subject} {no}{result.kind} {', '.join(result.anchors)} ({result.measured})".replace("  ", " ")
