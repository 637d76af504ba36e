"""Which objects of a room a noun phrase means."""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from thinkblox.assets.plurals import singular
from thinkblox.editing.orders import NounPhrase
from thinkblox.errors import InputError
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.things import are_alike, counts_as
from thinkblox.reading.english.chunks import Noun
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement, apart
from thinkblox.scene.scene import Scene

LISTED = 40
"""Most kinds and objects that a message names."""
Picks = Callable[[Sequence[Placement]], Sequence[Placement]]
"""Narrows several that a phrase fits down to those that an order can be about."""


@dataclass
class Finder:
    """Finds what phrases mean in a scene; remembers what was spoken of last, for "it" and "them".

    Attributes:
        seen: from where "the left one" of several was decided, in sentences.
    """

    scene: Scene
    recent: list[str] = field(default_factory=list)
    seen: list[str] = field(default_factory=list)

    def ids(
        self, phrase: NounPhrase, *, picks: Sequence[Picks] = (), among: Sequence[Placement] | None = None
    ) -> tuple[str, ...]:
        """The objects that a phrase means: one, or as many as it says.

        Args:
            phrase: without what it says of where the things are; see `picks`.
            picks: asked one after the other where more fit than are meant.
            among: which objects it can be, where more is known of them.

        Raises:
            InputError: nothing fits, which lists what there is, or several do, which names them.
        """
        noun = phrase.noun
        if phrase.id or noun.id:
            return (phrase.id or noun.id,)
        if noun.kind == "pronoun":
            return self._spoken_of(noun)
        found = self.matching(noun) if among is None else list(among)
        if phrase.rank:
            found = sorted(found, key=lambda p: -phrase.rank * p.size[0] * p.size[1] * p.size[2])[:1]
        if not found:
            raise self.nothing(noun.text)
        return tuple(p.id for p in self._as_many(noun, found, picks))

    def matching(self, noun: Noun) -> list[Placement]:
        """Every object that a noun fits, those that are just that before those that are like it."""
        if noun.id:
            return [p for p in self.scene.placements if p.id == noun.id]
        same = [p for p in self.scene.placements if self._is_called(p, noun)]
        alike = same or [p for p in self.scene.placements if are_alike(p.category, noun.value)]
        wanted = [word.lower() for word in (*noun.attributes, *(noun.unshown if not noun.named else ()))]
        fitting = [p for p in alike if all(self._has(p, word) for word in wanted)]
        exact = [p for p in fitting if p.category == noun.value]
        return exact if exact and not noun.many else fitting

    def nothing(self, text: str) -> InputError:
        """The error that nothing fits a phrase, with what there is."""
        return InputError(f"the room has no {_bare(text)}; there {self.listed()}")

    def listed(self) -> str:
        """What there is: "are 2 nightstand, 1 bed"."""
        counts = Counter(p.category.replace("_", " ") for p in self.scene.placements)
        kinds = [f"{count} {name}" for name, count in counts.most_common(LISTED)]
        more = f" and {len(counts) - LISTED} kinds more" if len(counts) > LISTED else ""
        return f"are {', '.join(kinds)}{more}" if kinds else "is nothing in it"

    def described(self, placement: Placement) -> str:
        """An object by its id and where it is, so that it can be told from others."""
        if placement.support in self.scene:
            return f"{placement.id} (on {placement.support})"
        near = [p for p in self.scene.placements if p.id != placement.id and p.category != placement.category]
        near = [p for p in near if p.support == "floor" and self.scene.asset_of(p).collides]
        if placement.support != "floor":
            return f"{placement.id} (on {placement.support})"
        if not near:
            return placement.id
        return f"{placement.id} (by {min(near, key=lambda p: apart(p, placement)).id})"

    def _spoken_of(self, noun: Noun) -> tuple[str, ...]:
        if not self.recent:
            raise InputError(f"{noun.text!r} points at nothing that was named before; name what you mean")
        one = noun.value in ("it", "one")
        there = [id for id in self.recent if id in self.scene]
        return tuple(there[-1:] if one and len(there) > 1 else there)

    def _is_called(self, placement: Placement, noun: Noun) -> bool:
        category = placement.category.lower().replace(" ", "_").replace("-", "_")
        if counts_as(category, noun.value):
            return True
        words = noun.value.split("_")
        return not noun.named and words[-1:] == [singular(category.rpartition("_")[2])] and len(words) == 1

    def _has(self, placement: Placement, word: str) -> bool:
        asset = self.scene.asset_of(placement)
        said = {*asset.attributes, *asset.description.lower().replace(",", " ").split()}
        return word in said or word.replace(" ", "-") in said

    def _as_many(self, noun: Noun, found: list[Placement], picks: Sequence[Picks]) -> list[Placement]:
        count = 2 if noun.det == "both" else noun.count if noun.count and not noun.ordinal else None
        if count is None and (noun.plural or noun.det in ("all", "each")):
            return self._picked(found, picks, least=1)
        count = count or 1
        if noun.ordinal:
            found = sorted(found, key=lambda p: _number(p.id))
            number = noun.ordinal - 1 if noun.ordinal > 0 else len(found) - 1
            if number >= len(found):
                raise InputError(f"there are only {len(found)} {_bare(noun.text)}: {_ids(found)}")
            return [found[number]]
        if noun.side:
            found = self._by_side(found, noun) if len(found) > 1 else found
        if len(found) < count:
            raise InputError(f"{noun.text!r}: the room has only {_ids(found)}; there {self.listed()}")
        if len(found) > count:
            found = self._picked(found, picks, least=count)
        if len(found) > count:
            spoken = [p for p in found if p.id in self.recent]
            found = spoken if len(spoken) == count else found
        indefinite = noun.det in ("a", "another", "any", "") and not noun.definite
        if len(found) > count and not indefinite:
            says = ", ".join(self.described(p) for p in found[:LISTED])
            raise InputError(
                f"{noun.text!r} could be {says}; say which, by its place ('the one by the window') or by its id"
            )
        return found[-count:] if indefinite else found

    def _by_side(self, found: list[Placement], noun: Noun) -> list[Placement]:
        """The leftmost, rightmost or middle one: by the front of what they stand beside, or else seen from the door."""
        company = _company(self.scene, found)
        along = company.left if company is not None else _left_of_room(self.scene)
        ordered = sorted(found, key=lambda p: -(p.position[0] * along[0] + p.position[1] * along[1]))
        which = {"left": 0, "right": len(ordered) - 1, "middle": len(ordered) // 2}.get(noun.side)
        if which is None:
            return found
        doors = any(o.kind == "door" for o in self.scene.room.openings)
        of_room = "seen from the door" if doors else "seen by who looks north"
        says = f"{noun.text} is {ordered[which].id}, {f'by the front of {company.id}' if company else of_room}"
        self.seen += [says] if says not in self.seen else []
        return [ordered[which]]

    @staticmethod
    def _picked(found: list[Placement], picks: Sequence[Picks], *, least: int) -> list[Placement]:
        for pick in picks:
            if len(found) == least and least > 0:
                break
            fewer = list(pick(found))
            if len(fewer) >= least:
                found = fewer
        return found


def usual_anchor(category: str) -> Picks:
    """Keeps what things of a category usually stand by: chairs by the dining table rather than the coffee table."""

    def pick(found: Sequence[Placement]) -> Sequence[Placement]:
        ranks = {name: n for n, habit in enumerate(load_habits().of(category)) for name in habit.anchors}
        best = min((ranks[p.category] for p in found if p.category in ranks), default=None)
        return [p for p in found if ranks.get(p.category) == best] if best is not None else ()

    return pick


def nearest_to(scene: Scene, name: str, count: int) -> Picks:
    """Keeps the nearest `count` to a thing or part of the room."""

    def pick(found: Sequence[Placement]) -> Sequence[Placement]:
        marks = things(scene, name)
        if not marks:
            return ()
        far = {p.id: min(ground_gap(things(scene, p.id)[0], mark) for mark in marks) for p in found if p.id != name}
        return sorted((p for p in found if p.id in far), key=lambda p: far[p.id])[:count]

    return pick


def _company(scene: Scene, found: list[Placement]) -> Placement | None:
    """The one larger thing that all of them are next to."""
    large = [p for p in scene.placements if p.id not in {f.id for f in found} and scene.asset_of(p).front == "one"]
    for other in sorted(large, key=lambda p: -p.size[0] * p.size[1]):
        mark = things(scene, other.id)[0]
        if all(ground_gap(things(scene, p.id)[0], mark) < 0.6 for p in found):
            return other
    return None


def _left_of_room(scene: Scene) -> tuple[float, float]:
    """The left of somebody who comes in by the first door, or looks north where there is none."""
    door = next((o for o in scene.room.openings if o.kind == "door"), None)
    x, y = scene.room.walls[door.wall].inward if door is not None else (0.0, 1.0)
    return (-y, x)


def _number(id: str) -> tuple[int, str]:
    tail = id.rpartition("_")[2]
    return (int(tail) if tail.isdecimal() else 0, id)


def _ids(found: Sequence[Placement]) -> str:
    return ", ".join(p.id for p in found[:LISTED]) or "none"


def _bare(text: str) -> str:
    """A noun phrase without its article."""
    first, _, rest = text.partition(" ")
    return (
        rest if rest and first.lower() in ("the", "a", "an", "my", "both", "all", "this", "that", "another") else text
    )
