"""The front of a room where many look one way: "desks that face the blackboard, a teacher's desk at the front"."""

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Draft, Mention

_FRONT = ("near_wall",)
_LED_FROM = ("desks", "tables", "worked_at")
"""What somebody stands or sits at who leads those that look there."""
_LOOKING = ("desks", "seats", "worked_at")
"""Where those have their places who look at a board."""


def settle_front(draft: Draft) -> None:
    """Say of what is at the front, which is no wall, that it is by what the many look at; else it stays by the door."""
    seen = _looked_at(draft) if draft.speaks_of_front else None
    if seen is None or any(b.anchors == _FRONT for b in draft.bonds_of(seen)):
        return
    for bond in [b for b in draft.bonds if b.anchors == _FRONT and b.kind == "against_wall" and not b.negated]:
        if not bond.subject.many:
            bond.kind = "in_front_of" if load_habits().is_in(bond.subject.noun, *_LED_FROM) else "near"
            bond.anchors = (seen,)
        elif any(b.kind == "facing" and seen in b.anchors for b in draft.bonds_of(bond.subject)):
            draft.bonds = [b for b in draft.bonds if b is not bond]


def _looked_at(draft: Draft) -> Mention | None:
    """What several look at by the prompt, or the board before their desks or seats."""
    facing = (b for b in draft.bonds if b.kind == "facing" and b.subject.many and not b.negated)
    faced = next((a for bond in facing for a in bond.anchors if isinstance(a, Mention) and a is not bond.subject), None)
    habits = load_habits()
    if faced is None and any(t.many and habits.is_in(t.noun, *_LOOKING) for t in draft.things):
        return next((t for t in draft.things if habits.is_in(t.noun, "boards") and not t.many), None)
    return faced
