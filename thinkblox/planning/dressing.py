"""What makes a furnished room a lived-in one: more to stand and hang in it, and what lies on all that carries."""

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from typing import Literal, cast

import numpy as np
from msgspec.structs import replace

from thinkblox.assets import CATALOGUE, facts_of, kind_of
from thinkblox.assets.category import Category
from thinkblox.assets.stand_ins import stand_in
from thinkblox.brief import Measures, RelationKind, Request
from thinkblox.knowledge.dressing import dressing
from thinkblox.knowledge.rooms import Usual, read_usual
from thinkblox.knowledge.things import are_alike, counts_as
from thinkblox.plan import Plan, Target, Tie
from thinkblox.planning.sizes import OPEN
from thinkblox.scene.asset import Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene

LEAST, MOST = 70, 100
"""How many objects a lived-in room is to have, at least and at most, as far as its surfaces have room."""
_FULL, _PACKED = 0.35, 0.6
"""Share of a top that things may cover, as people still use it, and of a shelf."""
_PASSES = 3
"""How often the things for a shelf are gone through, while it has room."""
_FEW = 2
"""Of what lies about by ones or twos a room has no more, but for each of those who sit there: no two alarm clocks."""
_MANY = 6
"""What there are so many of on a thing is what it is for, and comes first: books on a bookcase."""
_REACH, _REACHED_SHELF = 1.6, 1.9
"""Nothing lies on an open top, or on a shelf on a wall, that is higher [m]."""
_SET_FOR = 3
"""What is laid by so many on a table is laid for each who sits at it."""
_DRAWN_UP = ("at", "around", "at_long_side", "at_short_side")
"""Relations of seats to their table."""
_GAP = 0.03
"""Left about a thing on a surface [m]."""
Stage = Literal["furniture", "things", "spare"]
_PLACES = ("wall", "corner", "window", "door", "centre")
_STAGE = {"floor": 0, "wall": 1, "ceiling": 2, "surface": 3}


class Dresser:
    """Plans what is added to a room of a plan; every random choice is drawn from `rng`."""

    def __init__(self, plan: Plan, rng: np.random.Generator) -> None:
        self.plan = plan
        self._rng = rng
        self._table = dressing()
        self._numbers: dict[str, int] = {}
        self._laid_out: Counter[str] = Counter()
        for target in plan.targets:
            self._numbers[target.category] = self._numbers.get(target.category, 0) + 1
        self._wanted = int(rng.integers(LEAST, MOST + 1))

    def add(self, stage: Stage, scene: Scene, full: Collection[str] = ()) -> tuple[Target, ...]:
        """What is added next to a room; nothing is laid onto what is `full`."""
        match stage:
            case "furniture":
                return self.furniture(scene)
            case "spare":
                return self.spare(scene)
            case "things":
                return self.things(scene, full)

    def furniture(self, scene: Scene) -> tuple[Target, ...]:
        """What else stands on the floor and hangs on the walls, largest first; a room with curtains gets no others."""
        usuals = self._table.furniture(self.plan.brief.room_type)
        if scene.surfaces.curtains is not None:
            usuals = tuple(u for u in usuals if facts_of(u.category).hanging.windows == "no")
        return self._more(scene, [(usual, self._lacking(scene, usual)) for usual in usuals])

    def spare(self, scene: Scene) -> tuple[Target, ...]:
        """What is put up where there is too little to put things on, in a room that has shelves."""
        usuals = self._table.furniture(self.plan.brief.room_type)
        if not any(facts_of(usual.category).is_in("shelves") for usual in usuals):
            return ()
        return self._more(scene, [(usual, usual.count) for usual in read_usual(self._table.spare)])

    def _lacking(self, scene: Scene, usual: Usual) -> int:
        wanted = min(usual.count, _windows(scene)) if usual.relations[0][1] == "window" else usual.count
        return wanted - self._there(scene, usual.category)

    def _more(self, scene: Scene, wanted: Sequence[tuple[Usual, int]]) -> tuple[Target, ...]:
        targets: list[Target] = []
        for usual, count in wanted:
            ties = self._ties(scene, usual)
            if ties is not None and count > 0 and self._is_welcome(usual.category):
                targets += self._added(usual.category, count, ties, _size_of_others(scene, usual.category))
        targets.sort(key=_rank)
        return self._planned(targets)

    def things(self, scene: Scene, full: Collection[str] = ()) -> tuple[Target, ...]:
        """What lies on everything that carries and is not `full`, in turn, until the room has as many as it is to."""
        carriers = [self._on(scene, p) for p in scene.placements if p.id not in full]
        turns = [turn for turn in carriers if turn is not None]
        targets: list[Target] = []
        while turns and len(scene.placements) + len(targets) < self._wanted:
            for turn in list(turns):
                group = next(turn, None)
                if group is None:
                    turns.remove(turn)
                else:
                    targets += group
        return self._planned(targets)

    def _on(self, scene: Scene, carrier: Placement) -> Iterator[list[Target]] | None:
        things = self._table.on(carrier.category, self.plan.brief.room_type)
        return self._laid(scene, carrier, things) if things else None

    def _laid(self, scene: Scene, carrier: Placement, things: tuple[Usual, ...]) -> Iterator[list[Target]]:
        """Groups of a kind for one thing, in an order of chance, while there is room on it."""
        surfaces = _serving(scene, carrier)
        resting = scene.resting_on(carrier.id)
        free = sum(_share(s) * s.size[0] * s.size[1] for s in surfaces) - sum(p.size[0] * p.size[1] for p in resting)
        most = (self._table.most_on(carrier.category, self.plan.brief.room_type) or MOST) - len(resting)
        seats = self._seats_at(carrier)
        for name in self._kit(resting) if seats else ():
            yield self._added(name, 1, (Tie(kind="on", anchors=(carrier.id,), asked=False),))
        passes = _PASSES if any(s.headroom is not None for s in surfaces) else 1
        order = [place for _ in range(passes) for place in self._rng.permutation(len(things))]
        first = [place for place in order[: len(things)] if things[place].count >= _MANY]
        for place in [*first, *(place for place in order if place not in first)]:
            usual = things[place]
            kind = kind_of(usual.category)
            if not self._is_welcome(usual.category) or not any(_has_room(s, kind) for s in surfaces):
                continue
            if any(are_alike(p.category, usual.category) for p in resting) or self._is_plenty(scene, usual, carrier):
                continue
            cover = (kind.size[0] + _GAP) * (kind.size[1] + _GAP)
            wanted = int(self._rng.integers((usual.count + 1) // 2, usual.count + 1))
            if seats and facts_of(usual.category).setting is not None and usual.count >= _SET_FOR:
                wanted = seats
            count = min(wanted, int(free / cover), most)
            if count > 0:
                free -= count * cover
                most -= count
                self._laid_out[usual.category] += count
                yield self._added(usual.category, count, (Tie(kind="on", anchors=(carrier.id,), asked=False),))

    def _kit(self, resting: Sequence[Placement]) -> list[str]:
        """What the things on a top are of no use without, and is not there."""
        there = [p.category for p in resting]
        kit = (name for category in dict.fromkeys(there) for name in self._table.kits.get(category, "").split(", "))
        return [name for name in kit if name and name not in there and self._is_welcome(name)]

    def _seats_at(self, carrier: Placement) -> int:
        """How many seats are drawn up to a table."""
        ties = (tie for target in self.plan.targets for tie in target.ties if tie.kind in _DRAWN_UP)
        return sum(carrier.id in tie.anchors for tie in ties)

    def _is_plenty(self, scene: Scene, usual: Usual, carrier: Placement) -> bool:
        """Whether the room has as many of a thing as anybody would have lying about; desks and tables each have it."""
        there = self._laid_out[usual.category] or self._there(scene, usual.category)
        own = facts_of(carrier.category).is_in("worked_at", "meal_tables", "desks", "counters")
        places = sum(p.category == carrier.category for p in scene.placements) if own else 1
        return usual.count <= _FEW and there >= places * usual.count

    def _ties(self, scene: Scene, usual: Usual) -> tuple[Tie, ...] | None:
        """How it is to stand; None where what it belongs to is not there."""
        ties = []
        for kind, anchors, _ in usual.relations:
            found = (self._anchor(scene, anchor) for anchor in anchors.split("|"))
            anchor = next(filter(None, found), "")
            if not anchor:
                return None
            ties.append(Tie(kind=cast(RelationKind, kind), anchors=(anchor,), asked=False))
        return tuple(ties)

    def _anchor(self, scene: Scene, name: str) -> str:
        if name in _PLACES:
            kind = "window" if name == "window" else "door"
            openings = any(opening.kind == kind for opening in scene.room.openings)
            return name if name not in ("window", "door") or openings else ""
        return next((p.id for p in scene.placements if p.category == name), "")

    def _there(self, scene: Scene, category: str) -> int:
        """How many alike there are."""
        made = (p.category if p.category in CATALOGUE else stand_in(p.category).like for p in scene.placements)
        return sum(are_alike(each, category) or counts_as(each, category) for each in made)

    def _is_welcome(self, category: str) -> bool:
        return not any(counts_as(category, name) or are_alike(category, name) for name in self.plan.brief.excluded)

    def _added(self, category: str, count: int, ties: tuple[Tie, ...], size: Measures = OPEN) -> list[Target]:
        """Targets of one kind, each of a colour of its own where such things come in several."""
        start = self._numbers.get(category, 0)
        self._numbers[category] = start + count
        counted = tuple(replace(tie, count=count) for tie in ties)
        return [
            Target(
                id=f"{category}_{start + index + 1}",
                category=category,
                request=f"{category}_{start + index + 1}",
                asked=False,
                attributes=self._colour(category),
                size=size,
                ties=tuple(replace(tie, index=index) for tie in counted),
            )
            for index in range(count)
        ]

    def _colour(self, category: str) -> tuple[str, ...]:
        if category not in self._table.varied.split(", "):
            return ()
        colours = self._table.colours.split(", ")
        return (colours[int(self._rng.integers(len(colours)))],)

    def _planned(self, targets: list[Target]) -> tuple[Target, ...]:
        """The targets, now in the plan with a request each."""
        requests = tuple(
            Request(key=t.request, category=t.category, asked=False, attributes=t.attributes) for t in targets
        )
        brief = replace(self.plan.brief, requests=(*self.plan.brief.requests, *requests))
        self.plan = replace(self.plan, brief=brief, targets=(*self.plan.targets, *targets))
        return tuple(targets)


def _size_of_others(scene: Scene, category: str) -> Measures:
    """The size of what it is to match: shelves that stand there already."""
    if not facts_of(category).is_in("shelves"):
        return OPEN
    return next((p.size for p in scene.placements if p.category == category), OPEN)


def _windows(scene: Scene) -> int:
    return sum(opening.kind == "window" for opening in scene.room.openings)


def _rank(target: Target) -> tuple[int, bool, float]:
    kind = kind_of(target.category)
    at_window = any("window" in tie.anchors for tie in target.ties) and kind.mount == "wall"
    return (-1 if at_window else _STAGE[kind.mount], kind.flat, -kind.size[0] * kind.size[1])


def _serving(scene: Scene, carrier: Placement) -> list[Surface]:
    """The surfaces of a thing that a hand reaches and that are not behind a door."""
    open_ = (s for s in scene.asset_of(carrier).surfaces if not s.within)
    base = carrier.position[2]
    reach = _REACHED_SHELF if kind_of(carrier.category).mount == "wall" else _REACH
    return [s for s in open_ if s.headroom is not None or base + s.position[2] <= reach]


def _share(surface: Surface) -> float:
    return _FULL if surface.headroom is None else _PACKED


def _has_room(surface: Surface, kind: Category) -> bool:
    depth, width, height = kind.size
    fits = (depth <= surface.size[0] and width <= surface.size[1]) or (
        width <= surface.size[0] and depth <= surface.size[1]
    )
    return fits and (surface.headroom is None or height + _GAP <= surface.headroom)
