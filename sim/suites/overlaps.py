"""How deep objects are in one another and in the room, as the Drake metrics of SceneEval's fork ask it."""

from thinkblox.sim.foreign.triangles import colliding
from thinkblox.sim.subject import Subject
from thinkblox.sim.suites.criteria import above, exempt
from thinkblox.sim.suites.running import Run
from thinkblox.sim.suites.touching import Owners, Pair
from thinkblox.suite import Finding

DEPTH = 0.001
"""Deeper contacts are collisions [m]."""


class Overlaps:
    """Depths of the contacts between objects, and of each object with the room, at the start [m]."""

    def __init__(self, subject: Subject, start: Run) -> None:
        owners = Owners(subject)
        depths = owners.depths(start.model, start.data) | owners.fixed_depths(start.model, start.data)
        self.pairs = {p: d for p, d in depths.items() if all(map(owners.is_thing, p))}
        self._room = {p: d for p, d in depths.items() if p not in self.pairs}
        touchable = colliding(subject.model)
        solid = {name for name, can in zip(owners.names, touchable, strict=True) if can}
        self.ids = tuple(t.id for t in subject.things if t.id in solid)
        self.soft = tuple(exempt(t.id, "nothing of it collides") for t in subject.things if t.id not in solid)

    @property
    def colliding(self) -> frozenset[str]:
        """Which objects are deeper in another one than DEPTH."""
        return frozenset(name for pair, depth in self.pairs.items() if depth > DEPTH for name in pair)

    def with_each_other(self) -> list[Finding]:
        """A finding for every touching pair, and for every object that touches none."""
        return _findings(self.pairs, self.ids) + list(self.soft)

    def with_room(self) -> list[Finding]:
        """The same for the floor, the walls and whatever else belongs to no object."""
        return _findings(self._room, self.ids) + list(self.soft)


def _findings(depths: dict[Pair, float], ids: tuple[str, ...]) -> list[Finding]:
    touching = {name for pair in depths for name in pair}
    found = [above(f"{a} + {b}", depth, DEPTH, inclusive=False) for (a, b), depth in depths.items()]
    return found + [above(id, 0.0, DEPTH) for id in ids if id not in touching]
