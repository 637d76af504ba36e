"""What people call a thing, where that is not our word for it."""

from thinkblox.assets.plurals import singular
from thinkblox.assets.stand_ins import noun_of

_LONGEST = 200
"""Longest name that a thing is given [characters]."""


def own_name(called: str, category: str) -> str:
    """The name, where it says more or something else than a category does: "tote", "teacher's desk"; else nothing."""
    said, ours = ({singular(word) for word in name.split()} for name in (called, noun_of(category)))
    return "" if said <= ours else called[:_LONGEST].strip()
