"""What tests ask of briefs."""

from thinkblox.brief import Brief
from thinkblox.reading import read_brief


def counted(brief: Brief) -> dict[str, int]:
    """How many of each category are to be there, asked for or assumed."""
    counts: dict[str, int] = {}
    for request in brief.requests:
        counts[request.category] = counts.get(request.category, 0) + request.count
    return counts


def told(prompt: str) -> tuple[dict[str, int], set[str]]:
    """What is asked for, and how it stands; everything is understood."""
    brief = read_brief(prompt)
    assert not brief.unknown
    return asked(brief), related(brief)


def asked(brief: Brief) -> dict[str, int]:
    """How many are asked for, by key."""
    return {r.key: r.count for r in brief.requests if r.asked}


def related(brief: Brief) -> set[str]:
    """The relations that are asked for, in words."""
    return {
        " ".join((r.subject, "not " * r.negated + r.kind, *r.anchors, *["each"] * r.each))
        for r in brief.relations
        if r.asked
    }
