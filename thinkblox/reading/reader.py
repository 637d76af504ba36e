"""Puts the stages of reading together: items, grammar, senses, counts, assumptions, and a Brief of them."""

import math
from collections.abc import Mapping
from typing import Literal, get_args

from thinkblox.assets import CATALOGUE, Category, kind_of
from thinkblox.assets.mounting import HANGING, PROPPED, WALL_MOUNTED, mount_of
from thinkblox.assets.palette import without_general
from thinkblox.assets.repaint import MATERIALS
from thinkblox.brief import Brief, OpeningRequest, Place, Relation, Request, SurfaceRequest
from thinkblox.errors import InputError
from thinkblox.fills import Fill
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.things import are_alike
from thinkblox.reading.assumptions import (
    anticipated,
    assume,
    bed_down,
    complete_sets,
    counted_seats,
    draw_up,
    drop_barred,
    line_up_along_wall,
    pull_up,
    spread_along_walls,
    stock,
)
from thinkblox.reading.carriers import carry_contents, share_carriers, too_large
from thinkblox.reading.chunker import Chunker
from thinkblox.reading.counts import limit_things, settle_counts
from thinkblox.reading.draft import Bond, Draft, Gap, Mention
from thinkblox.reading.english import read_english
from thinkblox.reading.english.account import of_all_words
from thinkblox.reading.grammar import Walker
from thinkblox.reading.keeping import keep_things
from thinkblox.reading.language import lexicon_of
from thinkblox.reading.lexicon import ENGLISH
from thinkblox.reading.measures import object_size
from thinkblox.reading.moods import emphasise, read_moods
from thinkblox.reading.own_names import own_name
from thinkblox.reading.room_looks import finish_of_room
from thinkblox.reading.senses import choose_senses
from thinkblox.reading.sizes import Size, check_area, check_side
from thinkblox.reading.stacks import raise_stacks
from thinkblox.reading.uncollected import uncollected

MAX_LENGTH = 20_000
"""Longest prompt that is read [characters]."""
_OTHER_SHAPES = ("round", "oval", "U-shaped", "T-shaped", "hexagonal", "octagonal", "triangular", "trapezoidal")
"""Shapes of a floor that we do not make."""
_DRAWN_UP = ("around", "at", "at_long_side", "at_short_side")
"""How seats are at a table."""
_TOPS = ("tables", "desks", "counters", "worktops", "wallpieces", "seats", "beds")
"""Groups of things on which others lie, and not in them."""
_PLACES: tuple[Place, ...] = get_args(Place)
_FURNITURE = 0.2
"""Outline from which what is said to be on a wall, and cannot hang, is furniture that stands against it [m2]."""
_HEAVY = 150.0
"""What stands on the floor and weighs more hangs on no wall [kg]."""
_TALL = 1.5
"""Storage that is higher stands, also where it is said to be on a wall [m]."""
_SHAPES = ("L-shaped", "rectangular", "empty", "filled", "standing", "shared", "single", "double", "corner", "open")
"""What is said of a room that is made, or asks for nothing."""
_ROOM_SIZES = ("tiny", "small", "large", "long", "narrow", "square", "wide", "low", "tall")

_SQUARE, _AT_SQUARE = "square", 4
"""A form of tables, and how many are assumed to sit at one."""


def read_brief(prompt: str, *, fill: Fill = "essentials") -> Brief:
    """What a prompt asks for, read by rules in one of the languages of `LANGUAGES`.

    Args:
        prompt: the text.
        fill: what is assumed besides: with "named" nothing but what has to carry what is named; what makes a room a
            lived-in one depends on where its furniture stands, so that "lived-in" differs from "essentials" only in
            bookcases, which are left for the books that will be put into them.

    Raises:
        InputError: the prompt is blank, longer than MAX_LENGTH, in a language we do not know, or asks for a room of
            an impossible size.
    """
    if not prompt.strip():
        raise InputError("the prompt is empty; describe a room, such as 'A bedroom, 4 m by 5 m, with a double bed.'")
    if len(prompt) > MAX_LENGTH:
        raise InputError(f"the prompt is {len(prompt)} characters long; at most {MAX_LENGTH} are read")
    with uncollected():
        lexicon = lexicon_of(prompt)
        if lexicon.code == ENGLISH:
            draft = read_english(lexicon, prompt)
        else:
            draft = Walker(list(Chunker(lexicon, lexicon.tokens(prompt)).items())).walk()
        _finish(draft, fill)
        return _brief(prompt, lexicon.code, draft)


def _finish(draft: Draft, fill: Fill) -> None:
    known = set(map(id, draft.things))
    draft.bonds = [
        b for b in draft.bonds if all(id(t) in known for t in (b.subject, *b.anchors) if isinstance(t, Mention))
    ]
    said = draft.things or draft.missing or draft.openings or draft.unknown or draft.sizes or draft.surfaces
    roomless = draft.room in ("", "room") and not any(word.text.lower() == "room" for word in draft.account)
    if roomless and draft.account and not said:
        draft.unknown.append("no room and no thing is named")
    if draft.rooms:
        draft.unknown.append(f"more than one room: {', '.join(draft.rooms)} left out")
    _drop_impossible_sizes(draft)
    limit_things(draft)
    _drop_general(draft)
    keep_things(draft)
    read_moods(draft)
    carry_contents(draft)
    share_carriers(draft)
    choose_senses(draft, anticipated(draft) if fill != "named" else ())
    emphasise(draft)
    _settle_carriers(draft)
    draft.unknown += too_large(draft)
    pull_up(draft)
    assume(draft, fill)
    drop_barred(draft)
    counted = counted_seats(draft)
    uncounted = {id(t) for t in draft.things if t.count is None}
    settle_counts(draft)
    spread_along_walls(draft)
    line_up_along_wall(draft)
    raise_stacks(draft)
    draft.bonds = [b for b in draft.bonds if b.anchors != (b.subject,) or (b.subject.count or 1) > 1]
    if fill != "named":
        draw_up(draft, counted if fill == "essentials" else ())
        bed_down(draft)
        complete_sets(draft)
    if fill == "essentials":
        stock(draft, uncounted)
    _fit_tables(draft)


def _settle_carriers(draft: Draft) -> None:
    """What has no inside carries on top, and furniture "on" a wall stands against it."""
    opposite = any(bond.anchors == ("opposite_wall",) for bond in draft.bonds)
    shared = len({id(bond.subject) for bond in draft.bonds if bond.anchors == ("one_wall",)}) > 1
    habits = load_habits()
    for bond in draft.bonds:
        if bond.anchors == ("one_wall",) and not (opposite or shared or bond.subject.plural):
            bond.anchors = ("wall",)
        anchor = bond.anchors[0] if bond.anchors else None
        if bond.kind == "inside" and isinstance(anchor, Mention) and habits.is_in(anchor.noun, *_TOPS):
            bond.kind = "inside" if habits.is_in(anchor.noun, "storage") else "on"
        elif bond.kind == "on" and isinstance(anchor, str) and not bond.negated:
            _hang(bond, anchor)
        elif bond.kind == "on" and isinstance(anchor, Mention) and not bond.negated:
            _prop(bond.subject, kind_of(anchor.noun))
        elif bond.kind == "above" and isinstance(anchor, Mention) and not bond.negated:
            if _spans(kind_of(bond.subject.noun), kind_of(anchor.noun)):
                bond.kind, bond.subject, bond.anchors = "under", anchor, (bond.subject,)
            else:
                _hang_over(bond.subject, anchor, draft)


def _spans(kind: Category, other: Category) -> bool:
    """Whether something stands on the floor over another thing there, as a loft bed over a desk."""
    return kind.mount == other.mount == "floor" and "over" in kind.forms


def _hung_form(kind: Category, mount: str, bond: Bond) -> str | None:
    """What hangs in place of a kind that stands: a wall cabinet for a glass cabinet that is said to be on the wall."""
    plain = bond.anchors == ("wall",) or WALL_MOUNTED in bond.subject.attributes
    names = [kind.name, *([kind.name.rpartition("_")[2]] if kind.is_in("cases") and plain else [])]
    return next((f"{mount}_{name}" for name in names if f"{mount}_{name}" in CATALOGUE), None)


def _hang(bond: Bond, place: str) -> None:
    """Hang what is said to be on a wall or the ceiling, where it can; furniture stands against the wall."""
    thing, kind = bond.subject, kind_of(bond.subject.noun)
    word = HANGING if place == "ceiling" else WALL_MOUNTED if place.endswith("wall") else ""
    mount = "ceiling" if place == "ceiling" else "wall"
    if mount == "ceiling" and WALL_MOUNTED in thing.attributes:
        thing.attributes.remove(WALL_MOUNTED)
    if not word or kind.mount == mount:
        return
    if (hung := _hung_form(kind, mount, bond)) is not None:
        bond.subject.noun = hung
        made_of = [word for word in thing.called.split() if word in MATERIALS and word not in thing.attributes]
        thing.attributes += made_of
        return
    stands = _stands_up_to_walls(kind) or (_stands_at_walls(kind) and word not in bond.subject.attributes)
    if mount_of(kind, (word,)) == mount and not stands:
        thing.attributes += [word] if word not in thing.attributes else []
    elif mount == "wall" and kind.mount == "floor" and (stands or kind.size[0] * kind.size[1] > _FURNITURE):
        bond.kind = "against_wall"


def _stands_up_to_walls(kind: Category) -> bool:
    """Whether it is tall storage, or heavy, which stands before a wall where it is said to be on one."""
    return kind.mount == "floor" and (kind.mass > _HEAVY or (kind.size[2] > _TALL and kind.is_in("storage")))


def _stands_at_walls(kind: Category) -> bool:
    """Whether it is storage that stands at a wall where nobody says that it hangs there."""
    return kind.mount == "floor" and kind.is_in("storage")


def _hang_over(thing: Mention, furniture: Mention, draft: Draft) -> None:
    """What is above furniture and on nothing hangs on the wall there, or from the ceiling, where such things can."""
    carried = any(b.subject is thing and b.kind in ("on", "inside", "in_corner") for b in draft.bonds)
    kind = kind_of(thing.noun)
    if not carried and kind.mount in ("floor", "surface") and mount_of(kind, thing.attributes) == kind.mount:
        amid = load_habits().is_in(furniture.noun, "amid_room") or _is_amid(furniture, draft)
        word, mount = (HANGING, "ceiling") if amid and not _is_at_wall(furniture, draft) else (WALL_MOUNTED, "wall")
        thing.attributes += [word] if mount_of(kind, (word,)) == mount else []


def _is_amid(thing: Mention, draft: Draft) -> bool:
    return any(b.kind == "in_centre" and not b.negated for b in draft.bonds_of(thing))


def _is_at_wall(thing: Mention, draft: Draft) -> bool:
    bonds = (b for b in draft.bonds_of(thing) if not b.negated)
    return any(b.kind in ("against_wall", "in_corner") or "window" in b.anchors for b in bonds)


def _prop(thing: Mention, carrier: Category) -> None:
    """What usually hangs on a wall stands where it is said to be on furniture: a painting on an easel."""
    stands = carrier.mount == "floor" or carrier.is_in("shelves")
    if stands and not carrier.flat and mount_of(kind_of(thing.noun), thing.attributes) == "wall":
        thing.attributes.append(PROPPED)


def _drop_impossible_sizes(draft: Draft) -> None:
    """Sizes that are no lengths ("a bed of nan metres") are listed, not used."""
    for thing in draft.things:
        if thing.size is not None and not all(0.0 < length.metres < math.inf for length in thing.size.lengths):
            draft.unknown.append(thing.size.text)
            thing.size = None


def _fit_tables(draft: Draft) -> None:
    """Say of every table that comes for more or fewer for how many it is, so that one of that size is made."""
    for table in draft.things:
        around = (b for b in draft.bonds if b.kind == "around" and table in b.anchors)
        for bond in draft.bonds:
            if (
                bond.kind == "around"
                and table in bond.anchors
                and not bond.subject.asked
                and _SQUARE in table.attributes
            ):
                bond.subject.count = min(bond.subject.count or 1, _AT_SQUARE * (table.count or 1))
        seats = sum((b.subject.count or 1) * (table.count or 1) // _anchored(b) for b in around)
        named = any(attribute.startswith("for-") for attribute in table.attributes)
        if seats and table.count and not named and kind_of(table.noun).seats:
            table.attributes.append(f"for-{table.seats or max(1, seats // table.count)}")


def _anchored(bond: Bond) -> int:
    """How many things a bond is to, all together."""
    return sum(anchor.count or 1 for anchor in bond.anchors if isinstance(anchor, Mention)) or 1


def _drop_general(draft: Draft) -> None:
    """Ask once for the plants of "a shop full of plants: fifteen potted plants ..."."""
    for thing in list(draft.things):
        later = draft.things[draft.things.index(thing) + 1 :] if thing.general else []
        others = [t for t in later if t.asked and are_alike(t.noun, thing.noun)]
        if others and (thing.count is None or sum(t.count or 1 for t in others) == thing.count):
            draft.drop(thing)


def _brief(prompt: str, code: str, draft: Draft) -> Brief:
    keys = _keys(draft.things)
    width, depth, area, height = _room_size(draft.sizes)
    shape: Literal["rectangle", "L"] = "L" if "L-shaped" in draft.room_attributes else "rectangle"
    others = [a for a in draft.room_attributes if a in _OTHER_SHAPES]
    sizes = [a for a in draft.room_attributes if a in _ROOM_SIZES]
    said = [a for a in draft.room_attributes if a not in (*others, *sizes, *_SHAPES)]
    finish = finish_of_room(said, draft.tones)
    return Brief(
        prompt=prompt,
        language=code,
        room_type=draft.room or "room",
        shape=shape,
        width=width,
        depth=depth,
        area=area,
        height=height,
        people=draft.people or _seated(draft),
        openings=_openings(draft.openings),
        requests=tuple(_request(thing, keys) for thing in draft.things),
        relations=tuple(dict.fromkeys(_relation(bond, keys) for bond in draft.bonds)),
        style=tuple(dict.fromkeys(sizes + draft.style)),
        surfaces=_surfaces([*draft.surfaces, *finish.surfaces]),
        looks=finish.furniture,
        missing=tuple(dict.fromkeys(draft.missing)),
        beyond=tuple(dict.fromkeys(draft.beyond)),
        unknown=tuple(dict.fromkeys([*(f"{look} room" for look in (*others, *finish.unmet)), *draft.unknown])),
        empty=draft.empty,
        excluded=tuple(sorted(draft.excluded)),
        free=tuple(place for place in _PLACES if place in draft.free),
        account=of_all_words(draft.account, draft.written, draft.told) if draft.written else draft.account,
    )


def _seated(draft: Draft) -> int:
    """How many the tables seat, as the prompt says, where it leaves open on what."""
    tables = [t for t in draft.things if t.asked and t.seats and not load_habits().is_in(t.noun, "lounges", "beds")]
    drawn_up = [b.subject for b in draft.bonds if b.kind in _DRAWN_UP and set(b.anchors) & set(tables)]
    return 0 if any(seat.asked for seat in drawn_up) else sum(t.seats * (t.count or 1) for t in tables)


def _keys(things: list[Mention]) -> dict[int, str]:
    counts: dict[str, int] = {}
    keys: dict[int, str] = {}
    for thing in things:
        number = counts[thing.noun] = counts.get(thing.noun, 0) + 1
        keys[id(thing)] = thing.noun if number == 1 else f"{thing.noun}-{number}"
    return keys


def _request(thing: Mention, keys: dict[int, str]) -> Request:
    return Request(
        key=keys[id(thing)],
        category=thing.noun,
        count=thing.count or 1,
        asked=thing.asked,
        attributes=tuple(without_general(thing.attributes)),
        phrase=thing.text,
        called=own_name(thing.called, thing.noun),
        size=object_size(thing.noun, thing.size),
        least=thing.least if thing.least is None else min(thing.least, thing.count or 1),
        most=thing.most if thing.most is None else max(thing.most, thing.count or 1),
        unshown=tuple(dict.fromkeys(thing.unshown)),
        states=tuple(dict.fromkeys(thing.states)),
    )


def _relation(bond: Bond, keys: dict[int, str]) -> Relation:
    subject = keys[id(bond.subject)]
    anchors = tuple(a if isinstance(a, str) else keys[id(a)] for a in bond.anchors)
    if len(anchors) > 1 and bond.subject.count == 1:
        anchors = tuple(anchor for anchor in anchors if anchor != subject)
    return Relation(
        kind=bond.kind,
        subject=subject,
        anchors=anchors,
        each=bond.each,
        asked=bond.asked,
        rows=bond.rows,
        spread=bond.spread,
        negated=bond.negated,
    )


def _surfaces(asked: list[SurfaceRequest]) -> tuple[SurfaceRequest, ...]:
    """Each once, what is said of all walls first, and nothing of one wall that is said of all."""
    whole = {(r.laying, r.colour) for r in asked if r.part == "walls"}
    kept = [r for r in asked if r.part != "wall" or (r.laying, r.colour) not in whole]
    looks = {(r.part, r.laying, r.colour, r.second): r for r in kept}
    return tuple(sorted(looks.values(), key=lambda r: ("floor", "walls", "wall").index(r.part)))


def _openings(gaps: list[Gap]) -> tuple[OpeningRequest, ...]:
    return tuple(
        OpeningRequest(kind="door" if gap.kind == "door" else "window", wall=gap.wall, count=min(gap.count, 20))
        for gap in gaps
    )


def _room_size(sizes: list[Size]) -> tuple[float | None, float | None, float | None, float | None]:
    """Width, depth, area and height that the prompt gives [m, m2]; the first of each kind counts.

    Two sides that are told apart ("5 m long, ... 1.5 m wide") are both; one alone without a direction is of a square.
    """
    width = depth = area = height = None
    lone: dict[str, float] = {}
    for size in sizes:
        if size.area is not None:
            area = area or check_area(size.area, size.text)
            continue
        height = height or _height(size)
        sides = [length for length in size.lengths if length.axis != "height"][:2]
        checked = [check_side(length.metres, size.text) for length in sides]
        if len(checked) == 2 and width is None:
            width, depth = checked
        elif len(checked) == 1 and sides[0].axis:
            lone.setdefault(sides[0].axis, checked[0])
        elif len(checked) == 1 and width is None and area is None:
            area = check_area(checked[0] ** 2, size.text)
    if width is None and lone:
        width, depth = _of_lone(lone)
    return width, depth, area, height


def _of_lone(lone: Mapping[str, float]) -> tuple[float | None, float | None]:
    """Width and depth of sides that were named one by one; what is long lies along the width."""
    across = lone.get("width") or lone.get("diameter")
    along = lone.get("length")
    if along is not None:
        return along, lone.get("depth") or across
    return across, lone.get("depth")


def _height(size: Size) -> float | None:
    named = size.along("height")
    third = size.lengths[2].metres if len(size.lengths) == 3 else None
    height = named if named is not None else third
    if height is not None and not 2.0 <= height <= 10.0:
        raise InputError(f"the room's height in {size.text!r} is {height:g} m; it must be 2 to 10 m")
    return height
