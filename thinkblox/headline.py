"""The figures that head a report: first what holds as everything was placed, then once it has settled."""

from thinkblox.verdict import Report

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


def _placed(report: Report) -> str:
    start = report.depth if report.source in MODELS else 0.0
    deepest = max(start, *(verdict.depth for verdict in report.objects), 0.0)
    outside = max(verdict.outside for verdict in report.objects)
    further = f", {outside * 1000:.2f} mm outside the room at most" if outside > 0.0 else ""
    return f"deepest contact {deepest * 1000:.2f} mm{further}"
