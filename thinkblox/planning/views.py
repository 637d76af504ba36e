"""What people look at from where they lean back: nothing high stands in between, and seats gather about one table."""

from msgspec.structs import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.plan import Tie
from thinkblox.planning.loads import usual_size
from thinkblox.planning.members import Member, Members

_ACROSS = ("opposite", "facing")
_AT_WALLS = ("against_wall",)
_JOINS = ("near", "next_to", "around")
_MOST_ABOUT = 4
"""So many lounge seats have a side of a low table each; more stand round it in a circle."""


def keep_views(members: Members) -> None:
    """A table to eat at waits for the seats and the screen that they look at, and does not claim the middle.

    Seats that join a low table wait for the screen as well, and leave it in sight.
    """
    habits, seen = load_habits(), [m for m in members.all if _is_seen_across(members, m)]
    for other in members.all if seen else ():
        if habits.is_in(other.category, "meal_tables") and not any(tie.asked for tie in other.ties):
            other.ties = [tie for tie in other.ties if tie.kind != "in_centre"]
        elif not (habits.is_in(other.category, "lounges") and _joins_low_table(members, other)):
            continue
        other.waits |= {m.id for m in seen if m is not other and not members.depends(m, other)}


def gather(members: Members) -> None:
    """Of several lounge seats that nobody gave a place, the others join the low table before the first."""
    for request in members.by_request.values():
        loose = [m for m in request if load_habits().is_in(m.category, "lounges") and _is_loose(m)]
        table = _low_table_of(members, request[0]) if len(request) > 1 and len(loose) == len(request) else None
        if table is None:
            continue
        for number, seat in enumerate(loose[1:3]):
            if not members.depends(table, seat):
                seat.ties = [Tie(kind="next_to", anchors=(table.id,), index=number, asked=False)]


def seat_about(members: Members) -> None:
    """Of the lounge seats that are to be around a low table the widest has the wall, and the table stands before it.

    What people look at comes across from that seat, and the others leave it in sight.
    """
    for table in members.all:
        about = [m for m in members.all if load_habits().is_in(m.category, "lounges") and _around(m, table)]
        alone = not any(_around(m, table) for m in members.all if m not in about)
        placed = any(tie.asked for tie in (*table.ties, *table.denied))
        if not load_habits().is_in(table.category, "lounged_at") or placed or not alone:
            continue
        if not 1 < len(about) <= _MOST_ABOUT:
            continue
        first = max(about, key=lambda seat: usual_size(seat, members)[1])
        ties = [tie for tie in first.ties if table.id not in tie.anchors]
        if any(members.depends(table, seat) for seat in about):
            continue
        for tie in first.ties:
            if tie not in ties:
                members.owe(first, tie)
        first.ties = ties or [Tie(kind="against_wall", anchors=("wall",), asked=False)]
        table.ties = [Tie(kind="in_front_of", anchors=(first.id,), asked=False)]
        ids = {seat.id for seat in about}
        for other in members.all:
            across = [not tie.asked and tie.kind in _ACROSS and not ids.isdisjoint(tie.anchors) for tie in other.ties]
            turned = zip(other.ties, across, strict=True)
            other.ties = [replace(tie, anchors=(first.id,)) if turns else tie for tie, turns in turned]


def _around(seat: Member, table: Member) -> bool:
    return any(tie.kind == "around" and table.id in tie.anchors for tie in seat.ties)


def _is_seen_across(members: Members, thing: Member) -> bool:
    """Whether it stands across the room from where people lean back: a TV on its stand, a fire."""
    anchors = [members.by_id.get(a) for tie in thing.ties if tie.kind in _ACROSS for a in tie.anchors]
    looking = any(a is not None and load_habits().is_in(a.category, "lounges") for a in anchors)
    return looking and thing.mount in ("floor", "wall") and not load_habits().is_in(thing.category, "seating")


def _joins_low_table(members: Members, seat: Member) -> bool:
    """Whether a seat stands by a low table, as asked or usually."""
    anchors = (members.by_id.get(a) for tie in seat.ties if tie.kind in _JOINS for a in tie.anchors)
    return any(a is not None and load_habits().is_in(a.category, "lounged_at") for a in anchors)


def _is_loose(seat: Member) -> bool:
    return bool(seat.ties) and all(not tie.asked and tie.kind in _AT_WALLS for tie in seat.ties)


def _low_table_of(members: Members, seat: Member) -> Member | None:
    """The low table that stands before a seat."""
    before = (
        m
        for m in members.all
        if load_habits().is_in(m.category, "lounged_at")
        and any(tie.kind == "in_front_of" and seat.id in tie.anchors for tie in m.ties)
    )
    return next(before, None)
