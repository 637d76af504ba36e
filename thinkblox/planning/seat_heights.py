"""How high stools are: one sits as far below the top of a bench or a bar as below that of any table."""

from thinkblox.assets import kind_of
from thinkblox.planning.loads import asset_of, usual_size
from thinkblox.planning.members import Member, Members

_BELOW = 0.28
"""How far a seat is below the top that one sits at [m]."""
_SLIGHT = 0.08
"""What a stool may be too low [m]."""
_DRAWN_UP = ("at", "around", "at_long_side", "at_short_side")


def seat_height(member: Member, members: Members) -> float | None:
    """The height of a stool for the top that it is drawn up to [m]; None for its own."""
    kind = kind_of(member.category)
    if "stool" not in kind.like:
        return None
    anchors = [members.by_id[a] for t in member.ties if t.kind in _DRAWN_UP for a in t.anchors if a in members.by_id]
    wanted = max((_top(anchor, members) for anchor in anchors), default=0.0) - _BELOW
    height = min(round(wanted, 3), kind.size_range[1][2])
    return height if height > usual_size(member, members)[2] + _SLIGHT else None


def _top(anchor: Member, members: Members) -> float:
    """Height of the top that one sits at [m]; 0 where there is none."""
    if not kind_of(anchor.category).is_in("tables", "desks", "counters", "worktops", "worked_at", "meal_tables"):
        return 0.0
    surfaces = asset_of(anchor, members, usual_size(anchor, members)).surfaces
    tops = [s for s in surfaces if s.headroom is None and not s.within]
    return max(tops, key=lambda s: s.size[0] * s.size[1]).position[2] if tops else 0.0
