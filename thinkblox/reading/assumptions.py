"""What a prompt leaves unsaid: the usual furniture of a bare room, seats for people, a table for a vase."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from thinkblox.assets import facts_of
from thinkblox.assets.plurals import singular
from thinkblox.assets.stand_ins import kind_of, stand_in
from thinkblox.brief import RelationKind
from thinkblox.fills import Fill
from thinkblox.knowledge.goods import goods_in, stocked
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import UNKNOWN_ROOM, Usual, kinds_of_room, room_type, room_types
from thinkblox.knowledge.seats import places_at, usual_seat
from thinkblox.knowledge.sets import rest_of_set
from thinkblox.knowledge.things import are_alike, counts_as, is_surface, things
from thinkblox.knowledge.variety import varieties
from thinkblox.reading.attach import relation_kind
from thinkblox.reading.draft import Bond, Draft, Mention
from thinkblox.reading.moods import FEW

_PLACES = ("wall", "long_wall", "short_wall", "corner", "window", "door", "centre", "floor")
_AMID = ("centre", "floor")
"""Places where an island may stand."""
_FURNISH = "furnished"
_SELLS = "shop"
"""The type of room of which only its goods tell more."""
_SEATED = ("at", "around", "at_long_side", "at_short_side")
"""How seats stand to their tables."""
_DRAWN_UP = (*_SEATED, "behind")
"""Relations of seats to what one sits at."""
_BEFORE = (*_DRAWN_UP, "in_front_of")
"""The same, and where a prompt says it in other words."""
_ENOUGH_SEATS = 3
"""Who names so many seats to lean back in has said on what people sit there."""
_MOST_FILLED, _MOST_STOCKED = 12, 30
"""Books are many shapes: more bookcases than this stay empty, and more shelves of goods, which are fewer."""
_MOST_SHOWN = 8
"""Of goods for whole shelves so many are laid out on a table."""
_CROWDED = 4
"""More people than this share no desk."""
_MOST = 2
"""A table at which one in so many sits is not where the people of a room have their places."""
_BENCH, _ON_BENCH = "bench", 4
"""What several sit on side by side, and how many at a table."""
_MOST_MEET = 12
"""More people than this do not all meet at one table."""
_SEVERAL = 2
"""So many tables are meant where a prompt does not count them."""
_MANY, _MOST_WALLS = 4, 3
"""So many along the walls stand at several, and at how many at most: one has the door."""
_FAR_WORDS = 5
"""So many words further on a place is still that of a thing."""
_WORKED_ON = ("worked_at", "tables", "counters", "worktops")
"""What people may work at together."""
_SINGLE, _LOCKER = "single", "locker"
_TILL = "cash_register"
_PAID_AT = frozenset({"cash", "till", "checkout", "cashier", "cashiers", "pay"})
"""Words in the names of what one pays at."""


_CABINETS = frozenset(("cabinet", "cupboard"))
"""What a base cabinet is called besides."""


def assume(draft: Draft, fill: Fill) -> None:
    """Add what the prompt takes for granted, marked as not asked for; for "named" only what carries something."""
    _shape_by_run(draft)
    if fill == "named" and not draft.empty:
        _part_off(draft)
        _one_on_each(draft)
        _carry(draft, seated=False)
    elif not draft.empty:
        bare = _FURNISH in draft.style or _is_bare(draft)
        sketched = _is_sketched(draft)
        sold = goods_in([word.text for word in draft.account]) if draft.room == _SELLS else ""
        if bare:
            _fill(draft, stocked(room_type(draft.room).usual, sold))
        _seat(draft)
        if sketched:
            _fill(draft, stocked(room_type(draft.room).expected, sold))
        if bare or sketched:
            for theme in draft.themes:
                if not theme.unless:
                    _fill(draft, theme.expected(draft.room))
        _part_off(draft)
        _set_down(draft)
        _staff(draft)
        _give_places(draft)
        _one_on_each(draft)
        _ring_up(draft)
        _lay_out_goods(draft, sold)
        _clear(draft)
        _carry(draft, seated=True)


def _clear(draft: Draft) -> None:
    """Nothing lies unasked on what is to be empty."""
    empty = [t for t in draft.things if "empty" in t.states]
    for thing in [t for t in draft.things if not t.asked and empty]:
        if any(b.kind in ("on", "inside") and set(b.anchors) & set(empty) for b in draft.bonds_of(thing)):
            draft.drop(thing)


def _shape_by_run(draft: Draft) -> None:
    """Take a shape that is said of what is built in one line for that of its room: a kitchen with U-shaped worktops."""
    shapes = room_type(draft.room).shapes
    for thing in [t for t in draft.things if t.asked and load_habits().is_in(t.noun, "takes_built_in")]:
        if load_habits().is_in(thing.noun, "built_in_line") and (said := [a for a in thing.attributes if a in shapes]):
            draft.room = shapes[said[0]]
            thing.attributes.remove(said[0])


def anticipated(draft: Draft) -> frozenset[str]:
    """What will be assumed to be there for the room and the themes of a prompt that leaves much unsaid."""
    if draft.empty or not (_is_bare(draft) or _is_sketched(draft)):
        return frozenset()
    themes = (usual for theme in draft.themes for usual in theme.expected(draft.room))
    return frozenset(usual.category for usual in (*room_type(draft.room).expected, *themes))


def stock(draft: Draft, uncounted: Collection[int] = ()) -> None:
    """Put books into bookcases, and goods onto the shelves of a room with a use, unless the prompt says what is there.

    Counts are settled by now.

    Args:
        draft: what was read.
        uncounted: ids of things of which nobody says how many: shelves with some of these are full of others, too.
    """
    laid = [b for b in draft.bonds if b.kind in ("on", "inside")]
    _fill_shelves([t for t in draft.things if t.noun == "bookcase"], laid, _MOST_FILLED)
    if draft.room not in ("", UNKNOWN_ROOM):
        told = [b for b in laid if b.subject.asked and id(b.subject) not in uncounted]
        goods = [t for t in draft.things if load_habits().is_in(t.noun, "takes_goods")]
        _fill_shelves(goods, told, _MOST_STOCKED)


def spread_along_walls(draft: Draft) -> None:
    """Share many cases that stand "along the walls" out over several walls; counts are settled by now."""
    said = [word.text.lower() for word in draft.account]
    for bond in draft.bonds:
        words, count = bond.subject.text.lower().split(), bond.subject.count or 1
        if bond.kind != "against_wall" or bond.anchors != ("wall",) or bond.each or bond.spread or bond.negated:
            continue
        after = (said[at + 1 : at + _FAR_WORDS] for at, word in enumerate(said) if words and word == words[-1])
        if count >= _MANY and bond.asked and any("walls" in rest and "two" not in rest for rest in after):
            bond.spread = min(_MOST_WALLS, count // 2)


def line_up_along_wall(draft: Draft) -> None:
    """Several that stand "along the wall" stand in a row there, rather than each at some wall; counts are settled."""
    for bond in [b for b in draft.bonds if b.kind == "against_wall" and b.spread == 1]:
        bond.spread = 0
        noun, several = bond.subject.noun, (bond.subject.count or 1) > 1 and not bond.negated
        stands = kind_of(noun).mount == "floor" and not load_habits().is_in(noun, "built_in_line")
        if several and stands and not any(b.kind == "in_rows" for b in draft.bonds_of(bond.subject)):
            draft.bonds.append(Bond("in_rows", bond.subject, rows=1, asked=False))


def complete_sets(draft: Draft) -> None:
    """Add what comes with things that stand on others and are of no use alone; counts are settled by now."""
    for thing in [t for t in draft.things if t.asked]:
        rest = rest_of_set(thing.noun)
        places = [b for b in draft.bonds_of(thing) if b.kind == "on" and not b.negated]
        if rest is None or not places:
            continue
        carriers = [id(anchor) for bond in places for anchor in bond.anchors]
        there = [t for t in draft.things if t.asked or _stands_on(draft, t, carriers)]
        if any(load_habits().is_in(t.noun, rest.group) for t in there):
            continue
        for category in rest.categories:
            if not _is_barred(draft, category) and not any(t.noun == category for t in there):
                part = _add(draft, category, thing.count or 1)
                draft.bonds += [Bond("on", part, bond.anchors, each=bond.each, asked=False) for bond in places]


def _stands_on(draft: Draft, thing: Mention, carriers: Collection[int]) -> bool:
    return any(b.kind == "on" and id(anchor) in carriers for b in draft.bonds_of(thing) for anchor in b.anchors)


def _fill_shelves(cases: list[Mention], laid: list[Bond], most: int) -> None:
    """Fill those on which nothing is laid, where there are not more than `most`."""
    if sum(t.count or 1 for t in cases) > most:
        return
    for case in cases:
        carries = any(case in b.anchors for b in laid)
        if not carries and not {"empty", "filled"} & {*case.attributes, *case.states}:
            case.attributes.append("filled")


def bed_down(draft: Draft) -> None:
    """Single beds where nobody says which: for children and students, and where there are several in a bedroom.

    The lockers of those who sleep in a room have one door each.
    """
    beds = [t for t in draft.things if load_habits().is_in(t.noun, "own_bed")]
    for bed in [t for t in beds if _SINGLE in kind_of(t.noun).variants]:
        several = (bed.count or 1) > 1 and room_type(draft.room).sleeps
        sized = bed.size is not None or not kind_of(bed.noun).variants.keys().isdisjoint(bed.attributes)
        if (several or room_type(draft.room).narrow_beds) and not sized and not {"large", "big"} & set(bed.attributes):
            bed.attributes.append(_SINGLE)
    for locker in [t for t in draft.things if t.noun == _LOCKER and _has(draft, "beds")]:
        if locker.size is None and kind_of(locker.noun).variants.keys().isdisjoint(locker.attributes):
            locker.attributes.append(_SINGLE)


def counted_seats(draft: Draft) -> tuple[str, ...]:
    """What several seats are called of which a prompt gives the number; visitors' chairs are apart from these."""
    seats = (t for t in draft.things if t.asked and _is_upright(t) and t.count is not None and not t.vague)
    seats = (t for t in seats if t.many or any(bond.each for bond in draft.bonds_of(t)))
    names = ((t.noun, *(singular(word) for word in t.text.lower().split()[-1:])) for t in seats)
    return tuple(name for pair in names for name in pair)


def pull_up(draft: Draft) -> None:
    """Have stools along a counter drawn up to it, and seats put before what hangs in front of those who sit there.

    A till at the counter, which has its place on one, is on it; the one chair next to a desk is drawn up to it.
    """
    habits = load_habits()
    alone = [bond for bond in draft.bonds if _is_alone(draft, bond)]
    draft.bonds += [Bond("at", bond.subject, bond.anchors, each=bond.each, asked=False) for bond in alone]
    for bond in draft.bonds:
        anchor = bond.anchors[0] if len(bond.anchors) == 1 else None
        if not isinstance(anchor, Mention) or bond.negated:
            continue
        drawn = bond.subject.many and habits.tie(bond.subject.noun, anchor.noun) == "at"
        seen = habits.is_in(bond.subject.noun, "wallpieces") and habits.is_in(anchor.noun, "seating", "seats")
        if bond.kind in ("next_to", "near") and drawn and habits.is_in(anchor.noun, "counters"):
            bond.kind = "at"
        elif bond.kind in ("next_to", "near", "at") and habits.is_served_on(bond.subject.noun, anchor.noun):
            bond.kind = "on"
        elif bond.kind == "in_front_of" and seen:
            if bond.each and not bond.subject.per:
                bond.subject.per, bond.each = [anchor], False
            bond.anchors = (bond.subject,)
            draft.hand_over(bond, anchor)


def _is_alone(draft: Draft, bond: Bond) -> bool:
    """Whether a chair is next to a desk that has no other seat, and nothing more is said of its place."""
    desk = bond.anchors[0] if len(bond.anchors) == 1 else None
    if bond.kind != "next_to" or bond.negated or not isinstance(desk, Mention) or not _is_desk(desk):
        return False
    seats = [b.subject for b in draft.bonds if desk in b.anchors and _is_upright(b.subject)]
    places = [b for b in draft.bonds_of(bond.subject) if not b.negated]
    one_each = (bond.each and len(seats) == 1) or sum(seat.count or 1 for seat in seats) == (desk.count or 1)
    alike = {seat.noun for seat in seats} == {bond.subject.noun}
    return alike and len(places) == 1 and _is_chair(bond.subject) and one_each


def draw_up(draft: Draft, counted: Collection[str]) -> None:
    """Seats at the desks that a prompt names in a room, and at the tables that people sit around there.

    As many as are usual for each, where the prompt speaks of no such seats itself; counts are settled by now. Visitors'
    chairs, and what is assumed for another table, are no seats for it; many chairs are not those behind a desk.

    Args:
        draft: what was read.
        counted: what the seats are called of which there are to be as many as the prompt says, and no more.
    """
    if not draft.room or draft.empty:
        return
    _share_out(draft)
    seats = [t for t in draft.things if _is_upright(t)]
    taken = {id(t) for t in seats if _has_its_table(draft, t)}
    free = [t for t in seats if id(t) not in taken]
    drawn_to, seated = _drawn_to(draft, seats), _with_seats(draft)
    for table in [t for t in draft.things if t.asked and not t.seats and _is_for_one(draft, t)]:
        kind, seat, each = _usual_seat(draft.room, table.noun)
        served = any(b.asked and isinstance(a, Mention) for b in draft.bonds_of(table) for a in b.anchors)
        if kind == "around" and (served or (taken and _is_worked_on(draft, table))):
            continue  # A table beside loungers is theirs, and one to work at is none of those with seats.
        meeting = draft.people if _is_met_at(draft, table) and draft.people <= _MOST_MEET else 0
        count = max(each * (table.count or 1), meeting)
        drawn = drawn_to.get(table, [])
        own = kind == "behind" and bool(free)
        there = [t for t in free if not own or (t.count or 1) <= (table.count or 1)]
        there = [t for t in there if _is_high_enough(t)] if _is_desk(table) else there
        told = (*draft.excluded, *counted)
        if len(drawn) == 1 and not drawn[0].asked and drawn[0].noun == seat:
            drawn[0].count = count
        elif seated.get((table.noun, table.text), set()) - {table}:
            continue  # "Chairs at all desks but one."
        elif seat and not (drawn or there) and not any(counts_as(seat, n) for n in told):
            draft.bonds.append(Bond(kind, _add(draft, seat, count), (table,), each=table.count != 1, asked=False))


def _drawn_to(draft: Draft, seats: Sequence[Mention]) -> dict[Mention, list[Mention]]:
    """Which of the seats are told to be at each thing."""
    found: dict[Mention, list[Mention]] = {}
    for seat in seats:
        bonds = (b for b in draft.bonds_of(seat) if b.kind in _BEFORE)
        for anchor in dict.fromkeys(a for b in bonds for a in b.anchors if isinstance(a, Mention)):
            found.setdefault(anchor, []).append(seat)
    return found


def _with_seats(draft: Draft) -> dict[tuple[str, str], set[Mention]]:
    """The things at which seats were asked for, by category and by what they were called."""
    bonds = (b for b in draft.bonds if b.asked and b.kind in _BEFORE and not b.negated)
    anchors = {a for b in bonds for a in b.anchors if isinstance(a, Mention)}
    found: dict[tuple[str, str], set[Mention]] = {}
    for thing in (t for t in draft.things if t in anchors):
        found.setdefault((thing.noun, thing.text), set()).add(thing)
    return found


def _is_worked_on(draft: Draft, table: Mention) -> bool:
    """Whether what is to stand on it belongs on a worktop."""
    habits = load_habits()
    carried = [b.subject for b in draft.bonds if b.asked and b.kind == "on" and not b.negated and table in b.anchors]
    usual = (habit for thing in carried for habit in habits.of(thing.noun)[:1] if habit.kind == "on")
    return any(habits.is_in(name, "worktops") for habit in usual for name in habit.anchors[:1])


def _has_its_table(draft: Draft, seat: Mention) -> bool:
    """Whether a seat is spoken for: assumed for something, or asked to be at another table."""
    bonds = draft.bonds_of(seat)
    return any(b.kind in _DRAWN_UP and isinstance(a, Mention) for b in bonds for a in b.anchors) or (
        bool(bonds) and not seat.asked
    )


def _is_for_one(draft: Draft, table: Mention) -> bool:
    """Whether it is not among what the people are shared out to: the teacher's desk beside those of the pupils."""
    place = room_type(draft.room).place
    if not draft.people or not place or _is_met_at(draft, table):
        return True
    drawn = sum(b.subject.count or 1 for b in draft.bonds if b.kind in _DRAWN_UP and table in b.anchors)
    if table.noun == place and table.asked and drawn < (table.count or 1):
        return True
    return table.noun != place and table.count == 1 and _has(draft, "desks") and _is_desk(table)


def _is_desk(thing: Mention) -> bool:
    return load_habits().is_in(thing.noun, "worked_at")


def _is_upright(thing: Mention) -> bool:
    """Whether one sits upright on it at a table."""
    habits = load_habits()
    return not habits.is_in(thing.noun, "visits") and (
        habits.is_in(thing.noun, "drawn_aside", "chairs") or _is_stool(thing)
    )


def _is_high_enough(seat: Mention) -> bool:
    """Whether one can work at a desk on it: on no bean bag, pouf or bench."""
    habits = load_habits()
    upright = habits.is_in(seat.noun, "drawn_aside", "chairs") or seat.noun.endswith("_stool")
    return habits.is_in(seat.noun, "seats") and upright


def _is_stool(thing: Mention) -> bool:
    """Whether one sits on it upright."""
    habits = load_habits()
    return habits.is_in(thing.noun, "seating", "seats") and not habits.is_in(thing.noun, "lounges")


def _share_out(draft: Draft) -> None:
    """As many of what is assumed on, above or at each of the things that a prompt counts as there usually are."""
    usuals = (*room_type(draft.room).expected, *room_type(draft.room).usual)
    for bond in draft.bonds:
        anchor = bond.anchors[0] if bond.anchors else None
        assumed = not bond.asked and not bond.subject.asked
        shared = bond.each and (bond.kind in ("on", "above") or (bond.kind == "at" and not _is_manned(draft, bond)))
        if assumed and shared and isinstance(anchor, Mention) and anchor.asked:
            usual = next((u for u in usuals if u.category == bond.subject.noun), None)
            number = next((u.count for u in usuals if u.category == anchor.noun), 0)
            if usual is not None and number:
                bond.subject.count = max(1, usual.count // number) * (anchor.count or 1)


def _is_manned(draft: Draft, bond: Bond) -> bool:
    """Whether the seats are those of the people that a prompt counts."""
    return 0 < draft.people <= (bond.subject.count or 1)


def _usual_seat(room: str, noun: str) -> tuple[RelationKind, str, int]:
    """How which seat is drawn up to a thing in a type of room, and how many; no seat where nobody sits at it."""
    usuals = room_type(room).usual
    for usual in usuals:
        for kind, anchor, _ in usual.relations:
            if (
                anchor == noun
                and kind in ("at", "around", "at_long_side")
                and load_habits().is_in(usual.category, "drawn_aside")
            ):
                tables = sum(other.count for other in usuals if other.category == anchor) or 1
                return relation_kind(kind), usual.category, max(1, usual.count // tables)
    drawn = usual_seat(noun) or usual_seat(stand_in(noun).like)
    return (relation_kind(drawn.relations[0][0]), drawn.category, drawn.count) if drawn else ("at", "", 0)


def _is_bare(draft: Draft) -> bool:
    """Whether only the room is named, or with it one thing that is not what such a room is for."""
    if not draft.things:
        return not draft.missing
    core = room_type(draft.room).usual[0].category
    return draft.room not in ("", "room") and len(draft.things) == 1 and not are_alike(draft.things[0].noun, core)


def _is_sketched(draft: Draft) -> bool:
    """Whether the prompt names the room and a few things, rather than all that it is to hold.

    Who says how things of different kinds stand to each other has the room before their eyes, unless none of them is
    what it is for; to give a table its chairs is not to say that.
    """
    if draft.room in ("", "room") or len({thing.noun for thing in draft.things}) >= FEW:
        return False
    told = [b for b in draft.bonds if b.asked and b.kind not in _SEATED and not _is_on_worktop(b)]
    arranged = any(isinstance(a, Mention) and a is not b.subject for b in told for a in b.anchors)
    core = room_type(draft.room).core
    return not (arranged and any(are_alike(name, thing.noun) for name in core for thing in draft.things))


def _is_on_worktop(bond: Bond) -> bool:
    """Whether it says what stands on the worktop, which is part of the whole, and so arranges nothing."""
    return bond.kind == "on" and any(
        isinstance(a, Mention) and load_habits().is_in(a.noun, "built_in_line") and is_surface(a.called or a.text)
        for a in bond.anchors
    )


def _fill(draft: Draft, wanted: tuple[Usual, ...]) -> None:
    present = {noun for thing in draft.things for noun in (thing.noun, *_called(thing))}
    made: dict[str, Mention] = {thing.noun: thing for thing in draft.things}
    counted = {t.noun for t in draft.things if t.asked and t.count is not None and t.noun in things()}
    unlikely = {noun for theme in draft.themes for noun in theme.unlikely}
    for usual in wanted:
        one = {thing.noun for thing in draft.things if _is_of_one(draft, thing, usual)}
        there = any(_serves(noun, usual) for noun in present - one)
        there |= _is_barred(draft, usual.category)
        # One more of what a prompt counts would be one too many: a standing mirror is a mirror.
        there |= any(counts_as(usual.category, noun) and not _is_too_little(noun, usual) for noun in counted - one)
        there |= any(usual.category.endswith(f"_{name}") for name in _plainly_counted(draft, one))
        there |= _is_cover(usual.category) and any(map(_is_cover, counted))
        there |= any(t.asked and varieties().stands_for(usual.category, t.noun) for t in draft.things)
        if there or usual.category in unlikely or _have_places(draft, usual.category) or _is_crowded_out(draft, usual):
            continue
        places = [_place(anchor, made) for _, anchor, _ in usual.relations]
        if any(anchor and not place for (_, anchor, _), place in zip(usual.relations, places, strict=True)):
            continue
        if any(
            k in _SEATED and _is_seated(draft, made.get(p))
            for (k, _, _), p in zip(usual.relations, places, strict=True)
        ):
            continue
        thing = made[usual.category] = _add(draft, usual.category, usual.count)
        for (kind, _, each), place in zip(usual.relations, places, strict=True):
            anchors = (made.get(place, place),) if place else ()
            draft.bonds.append(Bond(relation_kind(kind), thing, anchors, each=each, asked=False))
    for usual in wanted:
        _share_with(draft, usual, made)
    _scale(draft)


def _is_cover(noun: str) -> bool:
    """Whether it is a rug or mat: who counts rugs counts mats."""
    return load_habits().is_in(noun, "covers")


def _plainly_counted(draft: Draft, but: Collection[str] = ()) -> frozenset[str]:
    """The plain words by which things are counted: of who asks for "two cabinets", a base cabinet would be a third."""
    named = (t for t in draft.things if t.asked and t.noun in things() and t.noun not in but)
    counted = (t for t in named if t.count is not None)
    return frozenset(t.called for t in counted if t.called.isalpha())


def _is_of_one(draft: Draft, thing: Mention, usual: Usual) -> bool:
    """Whether it is that of who teaches many: a single desk, or its chair, where each of many has a place."""
    place = room_type(draft.room).place
    single = thing.asked and thing.count == 1 and usual.count > _CROWDED
    own = usual.category == place and thing.noun != place
    return single and bool(place) and (own or any(each and a == place for _, a, each in usual.relations))


def _is_seated(draft: Draft, table: Mention | None) -> bool:
    """Whether the prompt says what one sits on at it."""
    return any(b.asked and b.kind in _SEATED and table in b.anchors for b in draft.bonds if table is not None)


def _called(thing: Mention) -> list[str]:
    """What a thing is called besides what it is made as: a sofa bed is a bed."""
    words = thing.text.lower().split()[-1:] if thing.asked else []
    return [word for word in words if word in things() and not thing.noun.endswith(word)]


def _is_crowded_out(draft: Draft, usual: Usual) -> bool:
    """Whether it would stand in the centre, where the prompt has something else stand."""
    habits = load_habits()
    if not any(anchor == "centre" for _, anchor, _ in usual.relations) or habits.is_in(usual.category, "covers"):
        return False
    centred = (b.subject for b in draft.bonds if b.asked and not b.negated and b.anchors == ("centre",))
    return any(kind_of(t.noun).mount == "floor" and not habits.is_in(t.noun, "covers") for t in centred)


def _part_off(draft: Draft) -> None:
    """Add the parts of the room that a prompt names by their use, each with what makes it, its own but for storage."""
    for theme in [t for t in draft.themes if t.unless and t.room not in kinds_of_room(draft.room)]:
        own = {usual.category for usual in theme.expected(draft.room)}
        if served := [t for t in draft.things if theme.is_served_by(t.noun) and not _is_of_other(draft, t, own)]:
            served[0].asked |= not any(t.asked for t in served)
            continue
        made: dict[str, Mention] = {}
        for number, usual in enumerate(theme.expected(draft.room)):
            places = [_place(anchors, made) for _, anchors, _ in usual.relations]
            shared = number and not any(kind in _DRAWN_UP for kind, _, _ in usual.relations)
            there = shared and any(_serves(t.noun, usual) for t in draft.things)
            if there or _is_barred(draft, usual.category) or not all(places):
                continue
            thing = made[usual.category] = _add(draft, usual.category, usual.count)
            thing.asked = not number
            for (kind, _, each), place in zip(usual.relations, places, strict=True):
                draft.bonds.append(Bond(relation_kind(kind), thing, (made.get(place, place),), each=each, asked=False))


def _is_of_other(draft: Draft, thing: Mention, own: Collection[str]) -> bool:
    """Whether it is told to be at, on or before what is not of its own part of the room, and so no part by itself.

    A table with seats of its own is one wherever it stands.
    """
    anchors = (a for b in draft.bonds_of(thing) for a in b.anchors if b.asked and isinstance(a, Mention))
    return not _is_seated(draft, thing) and any(anchor.noun not in own for anchor in anchors)


def _share_with(draft: Draft, usual: Usual, made: Mapping[str, Mention]) -> None:
    """Give every seat that is asked for what is assumed that people sit at on it: a mirror and a shelf to each.

    Of seats that nobody counts there are as many as those tables usually have.
    """
    seats = [t for t in draft.things if t.asked and t.count and _serves(t.noun, usual) and not draft.bonds_of(t)]
    seats = [t for t in seats if not _is_of_one(draft, t, usual)]
    uncounted = [t for t in draft.things if t.asked and t.count is None and t.plural and not draft.bonds_of(t)]
    alike = [t for t in uncounted if _serves(t.noun, usual)]
    if len(seats) == 1 and seats[0].many and load_habits().is_in(seats[0].noun, "lounges"):
        _line_up(draft, seats[0], usual, made)
    for kind, anchors, each in usual.relations:
        place = made.get(_place(anchors, made))
        if alike and kind in _SEATED and usual.count > 1 and place is not None and not place.asked:
            alike[0].count = usual.count
        if alike and each and kind == "above" and place is not None:
            draft.bonds.append(Bond("above", alike[0], (place,), each=True, asked=False))
        if len(seats) == 1 and usual.category == room_type(draft.room).place and kind == "on" and place is not None:
            if not place.asked:
                _multiply(draft, place, seats[0].count or 1)
            draft.bonds.append(Bond("on", seats[0], (place,), asked=False))
        if len(seats) == 1 and kind in _SEATED and each and place is not None and not place.asked:
            if place.count != seats[0].count:
                _multiply(draft, place, seats[0].count or 1)
            draft.bonds.append(Bond(relation_kind(kind), seats[0], (place,), asked=False))


def _line_up(draft: Draft, seat: Mention, usual: Usual, made: Mapping[str, Mention]) -> None:
    """Put seats that are asked for into the rows in which such seats stand there, to look at what those look at."""
    if not any(kind == "in_rows" for kind, _, _ in usual.relations):
        return
    for kind, anchors, _ in usual.relations:
        seen = made.get(_place(anchors, made))
        if kind == "in_rows" or seen is not None:
            draft.bonds.append(Bond(relation_kind(kind), seat, (seen,) if seen is not None else (), asked=False))


def _place(anchors: str, made: Mapping[str, Mention]) -> str:
    """The first of "a|b" that is there: a thing, or a place of the room; empty where none is."""
    return next((anchor for anchor in anchors.split("|") if anchor in made or anchor in _PLACES), "")


def _serves(noun: str, usual: Usual) -> bool:
    """Whether a <noun> will do instead of what is expected: no island and no bar for the cabinets along a wall."""
    walled = any(kind == "against_wall" for kind, _, _ in usual.relations)
    if all(load_habits().is_in(name, "treated_on") for name in (noun, usual.category)):
        return True
    if _is_too_little(noun, usual):
        return False
    amid = walled and noun != usual.category and load_habits().is_in(noun, "sat_around", "served_over")
    return _is_one(noun, usual.category) and not amid


def _is_too_little(noun: str, usual: Usual) -> bool:
    """Whether worktops are expected, and a <noun> is a cupboard."""
    return load_habits().is_in(usual.category, "built_in_line", "worktops") and _is_mere_storage(noun)


def _is_mere_storage(noun: str) -> bool:
    """Whether it stands by itself, and nobody works at it or builds a sink into it: a cupboard."""
    habits = load_habits()
    return habits.is_in(noun, "storage") and not habits.is_in(noun, "worktops", "takes_built_in", "built_in_line")


def _have_places(draft: Draft, category: str) -> bool:
    """Whether a thing is a place of one's own where the prompt names tables or loungers for the people."""
    loungers = [t for t in draft.things if t.asked and load_habits().is_in(t.noun, "lounges")]
    said = sum(t.count or (_ENOUGH_SEATS if t.rows else 1) for t in loungers)
    if load_habits().is_in(category, "lounges") and said >= _ENOUGH_SEATS:
        return True
    if load_habits().is_in(category, "chairs") and any(t.rows for t in loungers):
        return True
    if load_habits().is_in(category, "meal_tables") and _has(draft, "sat_in"):
        return True
    named = any(
        t.asked
        and not _is_too_small(t, draft.people)
        and not (load_habits().is_in(category, "desks") and _is_met_at(draft, t))
        and (
            load_habits().is_in(t.noun, "meal_tables")
            or (t.many and load_habits().is_in(t.noun, "worked_at"))
            or (load_habits().is_in(t.noun, "lounges") and load_habits().is_in(category, "lounges"))
        )
        for t in draft.things
    )
    return category == room_type(draft.room).place and named


def _is_met_at(draft: Draft, table: Mention) -> bool:
    """Whether people meet at it who have desks of their own: no table of any kind, but that of another type of room."""
    place, usual = room_type(draft.room).place, next(iter(load_habits().group("meal_tables")), "")
    desks = bool(place) and load_habits().is_in(place, "desks")
    return desks and table.noun != usual and any(kind.seats_at == table.noun for kind in room_types().values())


def _is_one(noun: str, category: str) -> bool:
    """Whether a <noun> will do where a <category> is expected: a beer fridge for a fridge."""
    upright = load_habits().is_in(category, "chairs")
    if upright and (not load_habits().is_in(noun, "chairs", "seats") or load_habits().is_in(noun, "lounges")):
        return False
    if load_habits().is_in(category, "own_bed") and load_habits().is_in(noun, "lain_on", "beds"):
        return True
    return are_alike(category, noun) or counts_as(noun, category) or stand_in(noun).like == category


def _is_barred(draft: Draft, category: str) -> bool:
    """Whether a prompt that wants no mirrors, or no tables, wants no <category> either."""
    names = ((noun, noun.removeprefix("any_")) for noun in draft.excluded)
    return any(
        _is_one(noun, category) or counts_as(category, noun) or category.endswith(f"_{name}") for noun, name in names
    )


def drop_barred(draft: Draft) -> None:
    """Take back what was assumed with something else and is not wanted."""
    for thing in [t for t in draft.things if not t.asked and _is_barred(draft, t.noun)]:
        draft.drop(thing)


def _scale(draft: Draft) -> None:
    """As many seats, desks or beds as the people the room is for, with what each has; a couple shares its bed."""
    share = "bedroom" in kinds_of_room(draft.room) and draft.people == 2 and not draft.apart
    if not draft.people or share:
        return
    habits, room = load_habits(), room_type(draft.room)
    for thing in [t for t in draft.things if not t.asked]:
        bed = room.sleeps and habits.is_in(thing.noun, "own_bed")
        place = thing.noun == room.place or habits.is_in(thing.noun, "meal_seats")
        anchors = [a for b in draft.bonds_of(thing) for a in b.anchors if isinstance(a, Mention)]
        if any(anchor.seats or _is_ones_own(anchor, draft.people) for anchor in anchors):
            continue
        several = any((anchor.count or 1) > 1 for anchor in anchors)
        if several and thing.noun != room.place and draft.people < (thing.count or 1):
            continue
        if bed or thing.noun == room.place or (place and thing.many):
            _multiply(draft, thing, draft.people if bed else _enough(thing.noun, draft.people))


def _multiply(draft: Draft, thing: Mention, count: int) -> None:
    """Give an assumed thing another count, and what is assumed for each of it, or to stand at, as many times more."""
    before, thing.count = thing.count or 1, count
    for bond in draft.bonds:
        if bond.asked or not bond.each or bond.subject.asked:
            continue
        if thing in bond.anchors and (bond.subject.count or 1) % before == 0 and bond.subject.count != count:
            _multiply(draft, bond.subject, (bond.subject.count or 1) * count // before)
        for anchor in bond.anchors if bond.subject is thing else ():
            if isinstance(anchor, Mention) and not anchor.asked and anchor.count == before != count:
                _multiply(draft, anchor, count)


def _seat(draft: Draft) -> None:
    """Chairs for "a table for four" and "a dining room for six", unless seats were named."""
    _share_table(draft)
    for thing in [t for t in draft.things if t.seats]:
        if thing.count is None and thing.plural and not thing.rows and not any(b.each for b in draft.bonds_of(thing)):
            thing.count = facts_of(thing.noun).plenty or _SEVERAL
        if drawn := [b.subject for b in draft.bonds if b.kind in _SEATED and thing in b.anchors]:
            if len(drawn) == 1 and not drawn[0].asked:
                drawn[0].count = thing.seats * (thing.count or 1)
            continue
        free = [t for t in draft.things if _is_chair(t) and not draft.bonds_of(t)]
        for seat in free:
            seat.count = thing.seats * (thing.count or 1) if seat.count is None else seat.count
            draft.bonds.append(Bond(_seated(thing), seat, (thing,), asked=False))
        if not free:
            _chairs(draft, thing, thing.seats * (thing.count or 1))
    for seat in [t for t in draft.things if t.count is None and load_habits().is_in(t.noun, "seats")]:
        tables = [b.anchors[0] for b in draft.bonds_of(seat) if b.kind == "around"]
        people = sum(t.seats * (t.count or 1) for t in tables if isinstance(t, Mention)) or draft.people
        seat.count = people if people and tables and room_type(draft.room).seats_at else seat.count
    table = next((t for t in draft.things if load_habits().is_in(t.noun, "meal_tables")), None)
    shared = table is not None and room_type(draft.room).place and not _is_too_small(table, draft.people)
    if table is not None and _is_met_at(draft, table):
        return
    if draft.people and (room_type(draft.room).seats_at or shared) and not _has(draft, "seats"):
        _chairs(draft, table or _add(draft, room_type(draft.room).seats_at, 1), draft.people)


def _is_bench(seat: Mention) -> bool:
    return seat.noun.endswith(_BENCH)


def _benches(people: int) -> int:
    """How many benches so many people sit on at a table: one at either long side, and more for many."""
    return max(2, -(-people // _ON_BENCH))


def _share_table(draft: Draft) -> None:
    """Places for all the people of a room at the table that is named there, where the prompt counts no seats."""
    habits = load_habits()
    seats = [t for t in draft.things if habits.is_in(t.noun, "seats") and not habits.is_in(t.noun, "lounges")]
    tables = [t for t in draft.things if habits.is_in(t.noun, "meal_tables")]
    seats = [t for t in seats if not _is_bench(t)]
    uncounted = all(t.count is None and _is_chair(t) and not draft.bonds_of(t) for t in seats)
    if draft.people and room_type(draft.room).seats_at and len(tables) == 1 and uncounted:
        table = tables[0]
        if table.count and not table.seats and not _is_too_small(table, draft.people):
            table.seats = -(-draft.people // table.count)


def _staff(draft: Draft) -> None:
    """Desks for the people of a room, and seats for the desks or tables, where only "desks" and "chairs" are named."""
    place = room_type(draft.room).place
    for desk in draft.things:
        own = desk.noun == place if place else _is_desk(desk)
        if draft.people and desk.count is None and not desk.rows and own:
            desk.count = _enough(desk.noun, draft.people)
    bare = [t for t in draft.things if t.count is None and not t.rows and not draft.bonds_of(t)]
    for seat in [t for t in bare if _is_upright(t)]:
        tables = [(t, _usual_seat(draft.room, t.noun)) for t in draft.things if t.asked and (t.count or t in bare)]
        tables = [(t, usual) for t, usual in tables if usual[1] and not _is_sat_at(draft, t)]
        served = [(t, usual) for t, usual in tables if counts_as(usual[1], seat.noun)]
        tables = served or [(t, usual) for t, usual in tables if _is_stool(seat) and not _is_bar(t)]
        if len({(table.noun, table.seats) for table, _ in tables}) == 1:
            table, (kind, _, each) = tables[0]
            table.count = table.count or facts_of(table.noun).plenty or _SEVERAL
            seat.count = (_benches(table.seats) if table.seats and _is_bench(seat) else table.seats) or each
            alike = tuple(other for other, _ in tables)
            draft.bonds.append(Bond(kind, seat, alike, each=table.many or len(alike) > 1, asked=False))


def _one_on_each(draft: Draft) -> None:
    """One on each of several, where nobody counts or places what there usually is one of on each: "desks, monitors"."""
    usual = [usual for kind in room_types().values() for usual in kind.usual]
    each = {(u.category, anchor) for u in usual for kind, anchor, each in u.relations if kind == "on" and each}
    for thing in [t for t in draft.things if t.asked and t.plural and t.count is None and not draft.bonds_of(t)]:
        carrier = next((t for t in draft.things if t.many and _has_one(thing.noun, t.noun, each)), None)
        if carrier is not None:
            draft.bonds.append(Bond("on", thing, (carrier,), each=True, asked=False))


def _has_one(noun: str, carrier: str, each: Collection[tuple[str, str]]) -> bool:
    """Whether each <carrier> has a <noun>: what works only with a screen has its desk."""
    return (noun, carrier) in each or (rest_of_set(noun) is not None and load_habits().is_in(carrier, "desks"))


def _set_down(draft: Draft) -> None:
    """A place with its seat for each of several things along the walls that people work with: "ten computers"."""
    place = room_type(draft.room).place
    seat = usual_seat(place) if place else None
    if seat is None or not load_habits().is_in(place, "desks"):
        return
    for thing in [t for t in draft.things if t.asked and (t.count or 1) > 1 and rest_of_set(t.noun)]:
        walled = [b for b in draft.bonds_of(thing) if b.kind == "against_wall" and b.asked and not b.negated]
        if walled and len(walled) == len(draft.bonds_of(thing)):
            desk, chair = _add(draft, place, thing.count or 1), _add(draft, seat.category, thing.count or 1)
            for bond in walled:
                draft.hand_over(bond, desk)
            draft.bonds.append(Bond("on", thing, (desk,), asked=False))
            draft.bonds.append(Bond(relation_kind(seat.relations[0][0]), chair, (desk,), each=True, asked=False))


def _ring_up(draft: Draft) -> None:
    """A cash register where one pays: on what is called a cash desk, and on a counter where such a room has one."""
    if any(are_alike(t.noun, _TILL) for t in draft.things) or _TILL in draft.excluded:
        return
    paid_at = {a for usual in room_type(draft.room).usual if usual.category == _TILL for _, a, _ in usual.relations}
    for desk in [t for t in draft.things if t.asked and load_habits().is_in(t.noun, "served_over")]:
        named = not _PAID_AT.isdisjoint(desk.text.lower().replace("'", "").split())
        if named or desk.noun in paid_at:
            register = _add(draft, _TILL, (desk.count or 1) if named else 1)
            draft.bonds.append(Bond("on", register, (desk,), each=named and desk.many, asked=False))


def _lay_out_goods(draft: Draft, sold: str) -> None:
    """What such a shop shows on its tables, where the prompt says nothing of what lies on them."""
    laid = [anchor for b in draft.bonds if b.kind in ("on", "inside") for anchor in b.anchors]
    usual = [(u, r[1]) for u in stocked(room_type(draft.room).usual, sold) for r in u.relations if r[0] == "on"]
    shelved = [u for u, anchor in usual if load_habits().is_in(anchor, "shelves")][:1]
    for table in [t for t in draft.things if t.asked and t.noun in varieties().shows.split(", ") and t not in laid]:
        for goods in [u for u, anchor in usual if anchor == table.noun] or shelved:
            if goods.category not in draft.excluded and "empty" not in (*table.attributes, *table.states):
                shown = _add(draft, goods.category, min(goods.count, _MOST_SHOWN))
                draft.bonds.append(Bond("on", shown, (table,), asked=False))


def _is_bar(thing: Mention) -> bool:
    return load_habits().is_in(thing.noun, "counters")


def _is_ones_own(thing: Mention, people: int, places: int = 1) -> bool:
    """Whether it is that of who teaches, as so many people have no room at it."""
    return thing.asked and thing.count is not None and _CROWDED * thing.count * places < people


def _is_too_small(table: Mention, people: int) -> bool:
    """Whether most of the people would find no place at it: the table for demonstrations in a classroom."""
    return _MOST * (table.count or _SEVERAL) * (table.seats or places_at(table.noun)) < people


def _enough(noun: str, people: int) -> int:
    """How many of what people work at are enough for so many."""
    return -(-people // places_at(noun)) if load_habits().is_in(noun, "worked_at") else people


def _is_sat_at(draft: Draft, table: Mention) -> bool:
    return any(b.kind in _DRAWN_UP and table in b.anchors for b in draft.bonds)


def _give_places(draft: Draft) -> None:
    """A place for each of the people of a room, where fewer are named: pupils do not sit at the teacher's desk."""
    room = room_type(draft.room)
    there = [t for t in draft.things if _is_one(t.noun, room.place)]
    shared = places_at(room.place) if room.place else 1
    unsaid = any(t.count is None or t.noun == room.place or t.count >= draft.people for t in there)
    unsaid &= any(not _is_ones_own(t, draft.people, shared) for t in there)
    shared_table = any(
        load_habits().is_in(t.noun, "meal_tables") and not _is_too_small(t, draft.people) for t in draft.things
    )
    if draft.people < 2 or not room.place or not there or unsaid or shared_table or _are_seated(draft, there):
        return
    made: dict[str, Mention] = {t.noun: t for t in draft.things}
    for usual in room.usual:
        own = usual.category == room.place
        drawn = any(anchor == room.place and each for _, anchor, each in usual.relations)
        if own or (
            drawn and room.place in made and not any(t.asked and _is_one(t.noun, usual.category) for t in draft.things)
        ):
            count = _enough(usual.category, draft.people) if own else draft.people
            thing = made[usual.category] = _add(draft, usual.category, count)
            for kind, anchor, each in usual.relations:
                if place := _place(anchor, made):
                    bond = Bond(relation_kind(kind), thing, (made.get(place, place),), each=each, asked=False)
                    draft.bonds.append(bond)
                elif not anchor:
                    draft.bonds.append(Bond(relation_kind(kind), thing, (), each=each, asked=False))


def _are_seated(draft: Draft, tables: list[Mention]) -> bool:
    """Whether the prompt gives all the people of a room their seats at some of its tables: four stools at each."""
    drawn = (b for b in draft.bonds if b.asked and b.kind in _SEATED and not b.negated and _is_stool(b.subject))
    seats = 0
    for bond in drawn:
        served = [table for table in tables if table in bond.anchors]
        seats += (bond.subject.count or 1) * (sum(t.count or 1 for t in served) if bond.each else bool(served))
    return seats >= draft.people


def _is_chair(thing: Mention) -> bool:
    return load_habits().is_in(thing.noun, "chairs")


def _chairs(draft: Draft, table: Mention, count: int) -> None:
    usual = usual_seat(table.noun) if load_habits().is_in(table.noun, "meal_tables") else None
    category = usual.category if usual is not None else "chair"
    if _is_barred(draft, category):
        return
    seat = _add(draft, category, count)
    draft.bonds.append(Bond(_seated(table), seat, (table,), each=table.many, asked=False))


def _seated(table: Mention) -> RelationKind:
    return "at" if load_habits().is_in(table.noun, "desks") else "around"


def _has(draft: Draft, group: str) -> bool:
    return any(load_habits().is_in(thing.noun, group) for thing in draft.things)


def _carry(draft: Draft, *, seated: bool) -> None:
    """Something to put small things on, where the prompt names nothing that could carry them; a desk with its seat."""
    _build_in(draft)
    for thing in [t for t in draft.things if load_habits().is_in(t.noun, "small")]:
        if _lies_somewhere(draft, thing):
            continue
        carriers = [a for habit in load_habits().of(thing.noun) if habit.kind == "on" for a in habit.anchors]
        if not any(t.noun in carriers and _serves_for(draft, thing, t) for t in draft.things):
            noun = _carrier(draft, [c for c in carriers if not c.startswith("any_") and c not in draft.excluded])
            if noun:
                own = thing.noun == room_type(draft.room).place or _is_ones_work(draft, thing, noun)
                carrier, drawn = _add(draft, noun, (thing.count or 1) if own else 1), usual_seat(noun)
                worked_at = seated and load_habits().is_in(noun, "worked_at")
                if drawn is not None and worked_at and not _has(draft, "drawn_aside"):
                    seat = _add(draft, drawn.category, carrier.count or 1)
                    kind = relation_kind(drawn.relations[0][0])
                    draft.bonds.append(Bond(kind, seat, (carrier,), each=carrier.many, asked=False))


def _take_off_shelves(draft: Draft) -> None:
    """What is built in is on no shelf: "shelves full of pots and a sink" ends its list of pots before the sink."""
    habits = load_habits()
    for thing in [t for t in draft.things if habits.is_in(t.noun, "built_in")]:
        shelved = [
            bond
            for bond in draft.bonds_of(thing)
            if bond.kind in ("on", "inside") and any(habits.is_in(n, "shelves") for n in _anchored(bond))
        ]
        draft.bonds = [bond for bond in draft.bonds if all(bond is not other for other in shelved)]


def _anchored(bond: Bond) -> list[str]:
    """What a bond is to, the places of the room aside."""
    return [anchor.noun for anchor in bond.anchors if isinstance(anchor, Mention)]


def _serves_for(draft: Draft, thing: Mention, carrier: Mention) -> bool:
    """Whether it is where such a thing is used: who sleeps has no lamp on a bookcase, no one the printer of all."""
    habits = load_habits()
    high = habits.is_in(thing.noun, "lamps") and habits.is_in(carrier.noun, "shelves")
    first = next((a for habit in habits.of(thing.noun) if habit.kind == "on" for a in habit.anchors), "")
    own = carrier.many and habits.is_in(carrier.noun, "worked_at") and habits.is_in(first, "storage")
    if _is_ones_work(draft, thing, first) and not habits.is_in(carrier.noun, *_WORKED_ON):
        return False
    return not (high and _has(draft, "beds")) and not (own and thing.count == 1 and _is_sat_at(draft, carrier))


def _is_ones_work(draft: Draft, thing: Mention, place: str) -> bool:
    """Whether each of the people of a room has one of what lies where one works: two monitors, in an office for two."""
    return draft.people > 1 and thing.count == draft.people and load_habits().is_in(place, "worked_at")


def _build_in(draft: Draft) -> None:
    """A cabinet for a sink or hob where there is no worktop; what is said of its place is then said of the cabinet."""
    habits = load_habits()
    _take_off_shelves(draft)
    alone = [t for t in draft.things if habits.is_in(t.noun, "built_in")]
    if any(habits.is_in(t.noun, "takes_built_in") for t in draft.things):
        alone = [t for t in alone if _has_place(draft, t)]
    for thing in [t for t in alone if not any(b.kind == "on" for b in draft.bonds_of(t))]:
        plain = "counter" if _plainly_counted(draft) & _CABINETS else "base_cabinet"
        cabinet = _unplaced_counter(draft, plain) if thing.count in (None, 1) else None
        cabinet = cabinet or _add(draft, plain, thing.count or 1)
        for bond in list(draft.bonds):
            if bond.subject is thing and bond.kind == "next_to" and bond.anchors == ("window",) and not bond.negated:
                draft.bonds.append(replace(bond, subject=cabinet, asked=False))
            elif bond.subject is thing:
                draft.hand_over(bond, cabinet)
            if not habits.is_in(bond.subject.noun, "small", "wallpieces"):
                bond.anchors = tuple(cabinet if a is thing else a for a in bond.anchors)
        _share_cabinet(draft, cabinet)
        if cabinet.many:
            thing.count = 1
        draft.bonds.append(Bond("on", thing, (cabinet,), each=cabinet.many, asked=False))


def _unplaced_counter(draft: Draft, usual: str) -> Mention | None:
    """The one counter that is asked for, where nothing says where it stands; None where there is none."""
    counters = [t for t in draft.things if t.asked and (t.noun == usual or t.noun == "counter")]
    plain = len(counters) == 1 and counters[0].count in (None, 1) and not draft.bonds_of(counters[0])
    return counters[0] if plain else None


def _share_cabinet(draft: Draft, cabinet: Mention) -> None:
    """Give each of several its cabinet with a sink: "a sink at every table"."""
    for bond in draft.bonds_of(cabinet):
        if bond.each and any(isinstance(a, Mention) for a in bond.anchors):
            bond.kind = "next_to" if bond.kind in _SEATED else bond.kind
            cabinet.count = (cabinet.count or 1) * sum(a.count or 1 for a in bond.anchors if isinstance(a, Mention))


def _has_place(draft: Draft, thing: Mention) -> bool:
    """Whether it is asked to be by a part of the room, and so not where an island stands."""
    asked = (b for b in draft.bonds_of(thing) if b.asked and not b.negated)
    places = (anchor for bond in asked for anchor in bond.anchors if isinstance(anchor, str))
    return any(place not in _AMID for place in places)


def _lies_somewhere(draft: Draft, thing: Mention) -> bool:
    """Whether a small thing is on, in or beside another, or may stand on the floor."""
    habits = load_habits()
    if any(habit.kind != "on" for habit in habits.of(thing.noun)):
        return True
    anchors = [a for b in draft.bonds_of(thing) for a in b.anchors if isinstance(a, Mention)]
    laid = any(b.kind in ("on", "inside") for b in draft.bonds_of(thing))
    return laid or any(habits.is_in(a.noun, "small") for a in anchors)


def _carrier(draft: Draft, carriers: list[str]) -> str:
    """Return the usual carrier; a side table where nobody dines, no bed in a hall, no bar in a home."""
    usual = {usual.category for usual in room_type(draft.room).usual}
    awake = not room_type(draft.room).sleeps and draft.room not in ("", UNKNOWN_ROOM)
    if awake and carriers and load_habits().is_in(carriers[0], "beds"):
        beds = load_habits().group("beds")
        carriers = sorted((c for c in carriers if c not in beds), key=lambda c: c not in usual)
    if (
        carriers
        and load_habits().is_in(carriers[0], "served_over")
        and usual.isdisjoint(load_habits().group("counters"))
    ):
        carriers = sorted(carriers, key=lambda c: c not in usual)
    if not carriers:
        return ""
    large = load_habits().is_in(carriers[0], "large_tables")
    public = room_type(draft.room).public
    if large and room_type(draft.room).sleeps and "nightstand" in carriers and _has(draft, "beds"):
        return "nightstand"
    return "side_table" if large and not public and "side_table" in carriers else carriers[0]


def _add(draft: Draft, noun: str, count: int) -> Mention:
    thing = Mention(noun, count, asked=False)
    draft.things.append(thing)
    return thing
