"""The figures that head a report: first what holds as everything was placed, then once it has settled."""

from collections.abc import Sequence

from thinkblox.verdict import Demand, RelationResult, Report

UNKNOWN = "unknown"
"""Category of what the catalogue does not have."""
MODELS = ("mjcf", "urdf")
"""What is measured in one go from its start, so that `Report.depth` is that of the start."""


def headline(report: Report) -> tuple[str, ...]:
    """Phrases with the extremes of a report, in the order in which they were measured; empty for an empty room."""
    if not report.objects:
        return ()
    phrases = [f"as placed: {_placed(report)}"]
    if report.source not in MODELS and report.simulated:
        phrases.append(f"once settled: deepest contact {report.depth * 1000:.2f} mm")
    if report.simulated:
        moved, turned = report.drift * 1000, report.tilt
        phrases.append(f"in {report.simulated:g} s with everything free: {moved:.2f} mm, {turned:.2f} degrees")
    return tuple(phrases)


SAID = 4
"""Shortfalls that a line names before it counts the others."""


def shortfalls(report: Report) -> tuple[str, ...]:
    """What was asked for and is not so, not there, not seen or not understood, a phrase each; the gravest first."""
    missing = [a.id for a in report.absent if a.category == UNKNOWN]
    phrases = [shortfall(demand) for demand in report.demands if not demand.holds]
    phrases += [f"not made: {', '.join(missing)}"] if missing else []
    phrases += [f"not so: {r.subject} {relation_words(r)}" for r in report.relations if not r.holds]
    phrases += [f"not understood: {', '.join(report.unknown)}"] if report.unknown else []
    return tuple(phrases)


def in_short(phrases: Sequence[str]) -> str:
    """Some of the phrases in one line, and how many more there are."""
    more = len(phrases) - SAID
    return "; ".join(phrases[:SAID]) + (f"; and {more} more" if more > 0 else "")


def shortfall(demand: Demand) -> str:
    """A demand that is not met, in a phrase."""
    match demand.kind:
        case "attribute":
            return f"not shown: {demand.wanted} {demand.subject}"
        case "state":
            return f"noted, not shown: {demand.wanted} {demand.subject}"
        case "excluded":
            return f"not wanted, but there: {demand.measured}"
        case "free":
            return f"not free: {demand.measured}"
        case _:
            return f"{demand.subject}: {demand.measured}, asked for {demand.wanted}"


def relation_words(relation: RelationResult) -> str:
    """A relation as words: "not next to door", "against wall"; a place that ends the kind is said once."""
    denied = "not " if relation.negated else ""
    kind = relation.kind.replace("_", " ")
    said = kind.rpartition(" ")[2]
    if relation.anchors and all(anchor.endswith(said) for anchor in relation.anchors):
        kind = kind.removesuffix(said).strip()
    return f"{denied}{kind} {', '.join(relation.anchors)}".strip()


def _placed(report: Report) -> str:
    start = report.depth if report.source in MODELS else 0.0
    deepest = max(start, *(verdict.depth for verdict in report.objects), 0.0)
    outside = max(verdict.outside for verdict in report.objects)
    further = f", {outside * 1000:.2f} mm outside the room at most" if outside > 0.0 else ""
    return f"deepest contact {deepest * 1000:.2f} mm{further}"
