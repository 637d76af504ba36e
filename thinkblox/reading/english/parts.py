"""How things at a part of another stand to it: at its side, its foot, its middle."""

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Mention

SIDES = {"left": "left_of", "right": "right_of", "front": "in_front_of", "back": "behind"}
"""Sides of things, and how what is there stands to them."""
_PARTS = {
    **SIDES,
    "long_side": "at_long_side",
    "short_side": "at_short_side",
    "foot": "at_foot_of",
    "middle": "in_centre",
    "inside": "inside",
    "in_shelf": "inside",
}
"""How what is at a part of a thing stands to it; "on" for all others."""


def relation_at(part: str, name: str, whole: Mention) -> str:
    """How what is at such a part of a thing stands to it."""
    match part:
        case "side":
            seated = load_habits().tie(name, whole.noun) in ("at", "around")
            return "around" if seated else "next_to"
        case "end":
            return _end(name, whole)
        case "head" if _lies_at_head(name) and not load_habits().is_in(whole.noun, "tables"):
            return "on"
        case _ if part == "corner" or " " in part:
            lies = load_habits().is_in(name, "small") and load_habits().is_in(whole.noun, "surfaces", "beds", "lounges")
            return "on" if lies else "next_to"
        case "head":
            return "at_short_side" if load_habits().is_in(whole.noun, "tables") else "next_to"
    return _PARTS.get(part, "on")


def _lies_at_head(name: str) -> bool:
    """Whether it is a pillow rather than a lamp, which stands there."""
    return load_habits().is_in(name, "small") and not load_habits().is_in(name, "lamps")


def _end(name: str, whole: Mention) -> str:
    habits = load_habits()
    if habits.is_in(name, "wallpieces", "screens"):
        return "near"
    if habits.is_in(whole.noun, "beds"):
        return "at_foot_of"
    if habits.is_in(name, "small", "plants") and habits.is_in(whole.noun, "surfaces"):
        return "on"
    return "at_short_side" if habits.is_in(whole.noun, "tables", "desks") else "next_to"
