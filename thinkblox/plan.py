"""In which order the objects of a brief are placed, and what each depends on."""

from collections.abc import Sequence
from typing import Annotated

from msgspec import Meta

from thinkblox.brief import Brief, Measures, Name, Ordinal, RelationKind
from thinkblox.checked import CheckedValue, ObjectId
from thinkblox.errors import InputError

OfSome = Annotated[int, Meta(ge=1, le=1_000_000)]


class Tie(CheckedValue, frozen=True, kw_only=True):
    """A relation of one target, with the ids of the very objects it refers to, or a Place of the room.

    Attributes:
        index, count: which of how many alike shares this anchor (chair 2 of 6 around table_1).
        rows: for "in_rows", the number of rows.
        asked: the prompt names it.
        spread: over how many walls or corners those that share it are; 0 for any number.
        means: it only serves a relation between other things than these, which is some target's `due`: beside the
            table, for what is asked beside the lamp that is to come on it.
    """

    kind: RelationKind
    anchors: tuple[str, ...] = ()
    index: Ordinal = 0
    count: OfSome = 1
    rows: Ordinal = 0
    asked: bool = True
    spread: Ordinal = 0
    means: bool = False


class Due(CheckedValue, frozen=True, kw_only=True):
    """A relation asked for of `subject`, which stands before the thing comes that the relation is to."""

    subject: ObjectId
    tie: Tie


def is_object(anchor: str) -> bool:
    """Whether an anchor of a Tie is the id of an object, "<category>_<n>", rather than a Place of the room."""
    return anchor.rpartition("_")[2].isdecimal()


def carries(tie: Tie) -> bool:
    """Whether the tie's anchor carries what has it: on it, inside it, or in the middle of its top."""
    on_object = tie.kind == "in_centre" and any(map(is_object, tie.anchors))
    return bool(tie.anchors) and (tie.kind in ("on", "inside") or on_object)


class Target(CheckedValue, frozen=True, kw_only=True):
    """One object to place.

    Attributes:
        id: "<category>_<n>", the id its placement will have.
        request: key of its request; all targets of a request share one asset, but where no two of it are the same.
        index, count: which of how many of its request.
        ties: its relations, the one that decides where it goes first.
        denied: relations that it must not have.
        due: relations asked for of others that can be measured once it stands, as the last of those concerned.
        size: what its asset must measure, where that is not left open.
        called: as its request is called.
    """

    id: ObjectId
    category: Name
    request: Name
    asked: bool = True
    attributes: tuple[str, ...] = ()
    index: Ordinal = 0
    count: OfSome = 1
    ties: tuple[Tie, ...] = ()
    denied: tuple[Tie, ...] = ()
    due: tuple[Due, ...] = ()
    size: Measures = (None, None, None)
    called: Annotated[str, Meta(max_length=200)] = ""

    @property
    def depends_on(self) -> tuple[str, ...]:
        """Ids of the objects that must be placed before it (places of the room are left out)."""
        return tuple(dict.fromkeys(a for tie in self.ties for a in tie.anchors if is_object(a)))

    @property
    def wanted(self) -> tuple[Tie | Due, ...]:
        """All that its place is to bring about."""
        return (*self.ties, *self.due)


class Plan(CheckedValue, frozen=True, kw_only=True):
    """The targets in the order in which they are placed: anchors, what belongs to them, small things.

    Attributes:
        notes: what the prompt asks for and cannot have, in sentences.
        free: parts of the room to keep free of furniture: Places, of walls the names.
    """

    brief: Brief
    targets: tuple[Target, ...] = ()
    notes: tuple[str, ...] = ()
    free: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        super().__post_init__()
        ids = [target.id for target in self.targets]
        twice = next((id for id in ids if ids.count(id) > 1), None)
        if twice is not None:
            raise self.refused("targets", f"name {twice!r} twice; ids must differ")

    def target(self, id: str) -> Target:
        """The target called `id`; raises KeyError."""
        for target in self.targets:
            if target.id == id:
                return target
        raise KeyError(f"no target {id!r}")


def in_order(targets: Sequence[Target]) -> list[Target]:
    """The targets in their order, but none before what it depends on, or must keep away from.

    Raises:
        InputError: some wait for each other.
    """
    there = {target.id for target in targets}
    needs = {t.id: there.intersection(t.depends_on) - {t.id} for t in targets}
    kept_from = {t.id: there.intersection(anchor for tie in t.denied for anchor in tie.anchors) for t in targets}
    waiting, placed, done = list(targets), list[Target](), set[str]()
    while waiting:
        free = [t for t in waiting if needs[t.id] <= done]
        ready = next((t for t in free if kept_from[t.id] - {t.id} <= done), free[0] if free else None)
        if ready is None:
            raise InputError(f"the plan has {', '.join(t.id for t in waiting[:5])} wait for each other")
        waiting.remove(ready)
        placed.append(ready)
        done.add(ready.id)
    return placed
