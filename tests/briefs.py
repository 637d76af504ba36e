"""What tests ask of briefs."""

from thinkblox.brief import Brief


def counted(brief: Brief) -> dict[str, int]:
    """How many of each category are to be there, asked for or assumed."""
    counts: dict[str, int] = {}
    for request in brief.requests:
        counts[request.category] = counts.get(request.category, 0) + request.count
    return counts
