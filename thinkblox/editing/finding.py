"""Which objects of a room a noun phrase means."""

import dataclasses
import math
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from thinkblox.assets import facts_of
from thinkblox.assets.palette import with_general
from thinkblox.assets.plurals import singular
from thinkblox.editing.by_compass import by_compass, compass_of
from thinkblox.editing.grammar import means, rank_of, whose
from thinkblox.editing.history import Past
from thinkblox.editing.orders import NounPhrase
from thinkblox.editing.rows import STEP, row_of, rows_of
from thinkblox.errors import InputError
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.things import are_alike, counts_as
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.own_names import own_name
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement, apart
from thinkblox.scene.relations import measure
from thinkblox.scene.room import Wall, turn_between
from thinkblox.scene.scene import Scene

BY_IT = 0.3
"""How far from what was spoken of something stands that belongs to it [m]."""
SAME_SIZE = 0.05
"""How much a size may differ from what is said of it [m]."""
ACROSS = 120.0
"""From which angle between two gazes on one looks at the other [degrees]."""
LEAST_HEAD = 4
"""Shortest word that can be the end of the name of another thing [characters]."""
LISTED = 40
"""Most kinds and objects that a message names."""
_FILLED = frozenset(("with", "of"))
Picks = Callable[[Sequence[Placement]], Sequence[Placement]]
"""Narrows several that a phrase fits down to those that an order can be about."""


@dataclass
class Finder:
    """Finds what phrases mean in a scene; remembers what was spoken of last, for "it" and "them".

    Attributes:
        seen: from where "the left one" of several was decided, and which of several were taken, in sentences.
        owners: what an order has named last, for "its chairs".
        several: what an order has named of which it says what becomes of it, for "their chairs".
        named: everything that an order has named so far, for "the other nightstand".
        vacated: the last thing that was taken away, or moved by itself, as it stood.
        past: what the edits before were about.
        start: the room before the instruction.
        about: id of what is being moved, from which "the other side" is seen.
    """

    scene: Scene
    recent: list[str] = field(default_factory=list)
    seen: list[str] = field(default_factory=list)
    about: str = ""
    owners: list[str] = field(default_factory=list)
    several: list[str] = field(default_factory=list)
    named: list[str] = field(default_factory=list)
    vacated: Placement | None = None
    past: Past = field(default_factory=Past)
    start: Scene | None = None

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
        if phrase.noun.kind == "abstract":
            raise InputError(f"'{phrase.noun.text}' is not understood; say it by things that are in the room")
        ids = self._ids(phrase, picks, among)
        self.named += ids if phrase.noun.det != "other" else ()
        return ids

    def _ids(self, phrase: NounPhrase, picks: Sequence[Picks], among: Sequence[Placement] | None) -> tuple[str, ...]:
        noun = phrase.noun
        if phrase.id or noun.id:
            return (phrase.id or noun.id,)
        if noun.kind == "pronoun" or self._is_of_others(noun):
            return self._part(phrase, self._spoken_of(noun))
        if noun.rows and noun.kind == "number":
            return tuple(p.id for p in row_of(self.scene, (), noun, phrase.member))
        among = self._looking_so(noun) if among is None else among
        rank = phrase.rank or rank_of(noun.degree)[0]
        found = self.matching(noun, wide=bool(rank)) if among is None else list(among)
        if not found:
            raise self.nothing(noun.text)
        _check_told(phrase, found)
        if len(found) == 1 and noun.named and (noun.unshown or noun.styles or noun.states):
            says = f"'{noun.text}' is taken to be {found[0].id}"
            self.seen += [says] if says not in self.seen else []
        if noun.size is not None:
            found = self._of_size(noun, found)
        if noun.rows:
            row = tuple(p.id for p in row_of(self.scene, _of_rows(found), noun, phrase.member))
            return self._part(phrase, row) if phrase.share or phrase.left or noun.every else row
        found = self._called_by_load(noun, self._told_apart(phrase, found))
        if noun.total and noun.total != len(found):
            raise InputError(f"'{noun.text}': there are {len(found)}: {_ids(found)}")
        if phrase.share or phrase.left or noun.every:
            return self._part(phrase, tuple(p.id for p in self._as_many(_all(noun), found, picks)))
        return tuple(p.id for p in self._as_many(noun, found, picks))

    def _looking_so(self, noun: Noun) -> list[Placement] | None:
        """What looks as is said of "the green one": of the kind that was named last, or of any; None for others."""
        if noun.kind != "number" or not noun.attributes or noun.det != "the":
            return None
        last = [id for id in (*self.recent, *self.past.about) if id in self.scene]
        fits = [p for p in self.scene.placements if all(self._has(p, word) for word in noun.attributes)]
        alike = [p for p in fits if any(are_alike(p.category, self.scene[id].category) for id in last)]
        found = alike or fits
        self.seen += [f"'{noun.text}' is taken to be {_ids(found)}"] if len(found) == 1 else []
        return found or None

    def left_place(self, text: str) -> Placement:
        """What has been taken away, as it stood.

        Raises:
            InputError: nothing has been.
        """
        if self.vacated is None and self.past.gone is not None:
            self.seen.append(f"the place is taken to be that of {self.past.gone.id}, of the edit before")
            return self.past.gone
        if self.vacated is None:
            raise InputError(f"'{text}': nothing was taken away before, whose place that could be; say a place")
        return self.vacated

    def left_carrier(self, id: str) -> str:
        """What something rested on before it was moved, or rests on still; empty where nothing is known of it."""
        now = self.scene[id].support if id in self.scene else ""
        begun = self.start[id].support if self.start is not None and id in self.start else now
        return begun if begun != now else self.past.carriers.get(id, now)

    def _is_of_others(self, noun: Noun) -> bool:
        """Whether it is "the remaining ones" of what was spoken of."""
        return noun.kind == "number" and noun.det == "other" and not noun.ordinal and bool(self.recent)

    def _part(self, phrase: NounPhrase, ids: Sequence[str]) -> tuple[str, ...]:
        """So many of these as a phrase says, where it does not say which; that is said."""
        noun, ids = phrase.noun, sorted(ids, key=_number)
        if noun.every:
            if noun.counted:
                raise InputError(f"'{noun.text}' does not say which; say 'every second', or how many")
            kept = _around(self.scene, ids)[noun.every - 1 :: noun.every]
        elif phrase.left:
            if phrase.left >= len(ids):
                raise InputError(
                    f"'all but {phrase.left}': there are only {len(ids)} {_bare(noun.text)}: {_listed(ids)}"
                )
            kept = ids[phrase.left :]
        else:
            share = phrase.share or (0.5 if noun.kind == "pronoun" and noun.value == "half" else 0.0)
            if not share:
                return tuple(ids)
            count = min(max(1, math.floor(share * len(ids) + 0.5)), len(ids))
            kept = ids[len(ids) - count :]
        if not kept:
            raise InputError(f"'{noun.text}' means none of {_listed(ids)}")
        self._say_taken(noun, kept, ids)
        return tuple(kept)

    def _say_taken(self, noun: Noun, kept: Sequence[str], ids: Sequence[str]) -> None:
        if len(kept) < len(ids):
            says = f"'{noun.text}' is taken to be {_listed(kept)}, of {len(ids)}"
            self.seen += [says] if says not in self.seen else []

    def _of_size(self, noun: Noun, found: Sequence[Placement]) -> list[Placement]:
        """Those that have the size that is said of them."""
        wanted = [(length.metres, length.axis) for length in noun.size.lengths] if noun.size is not None else []
        fits = [p for p in found if all(_has_length(p, metres, axis) for metres, axis in wanted)]
        if not fits:
            sizes = ", ".join(f"{p.id} ({' by '.join(f'{s:.2f}' for s in p.size)} m)" for p in found[:LISTED])
            raise InputError(f"the room has no {_bare(noun.text)}; there is {sizes}")
        return fits

    def _others(self, noun: Noun, found: Sequence[Placement]) -> list[Placement]:
        """Those that were not spoken of."""
        left = [p for p in found if p.id not in self.recent]
        left = left if len(left) < len(found) else [p for p in found if p.id not in self.named]
        if len(left) in (0, len(found)) and self.about in self.scene:
            left = [p for p in found if not self._belongs(self.scene[self.about], p.id)]
        if len(left) == len(found) and len(found) > 1 and not (noun.many and self.recent):
            says = ", ".join(self.described(p) for p in found[:LISTED])
            raise InputError(f"'{noun.text}': other than which? It could be {says}")
        if not left:
            raise InputError(f"'{noun.text}': there is no other than {_ids(found)}")
        return left

    def _told_apart(self, phrase: NounPhrase, found: list[Placement]) -> list[Placement]:
        """Those that are meant by what was spoken of, by how large they are, or by whose they are."""
        noun = phrase.noun
        if means("nearest", noun.degree):
            found = self._nearest(noun, found)
        rank, along = (phrase.rank, phrase.along) if phrase.rank else rank_of(noun.degree)
        if noun.det == "other":
            found = self._others(noun, found)
        if len(found) > 1 and compass_of(noun):
            found = by_compass(noun, found)
        if len(found) > 1 and (wall := _depth_of(noun)):
            found = self._by_depth(noun, found, back=wall == "far_wall")
        if rank:
            found = _ranked(noun, found, rank, along)
        if whose(noun.text) and len(found) > 1:
            found = self._of_somebody(noun, found)
        return found

    def _by_depth(self, noun: Noun, found: Sequence[Placement], *, back: bool) -> list[Placement]:
        """Those at the back or the front: of rows the last or the first, of other things as seen from the door."""
        rows = rows_of(self.scene, found) if all(self.scene.asset_of(p).front == "one" for p in found) else []
        if len(rows) > 1:
            return rows[-1] if back else rows[0]
        x, y = _left_of_room(self.scene)
        ahead = {p.id: round((p.position[0] * y - p.position[1] * x) * (1.0 if back else -1.0), 2) for p in found}
        ordered = sorted(found, key=lambda p: -ahead[p.id])
        count = noun.count or (2 if noun.det == "both" else 1)
        last = ahead[ordered[min(count, len(ordered)) - 1].id]
        meant = [p for p in ordered if ahead[p.id] >= last - (STEP if noun.count is None else 0.0)]
        says = f"'{noun.text}' is taken to be {_ids(meant)}, seen from the door"
        self.seen += [says] if says not in self.seen else []
        return meant

    def _called_by_load(self, noun: Noun, found: list[Placement]) -> list[Placement]:
        """Those of several that are called by what rests on them: "the printer cabinet", which is said."""
        words = {singular(word) for word in noun.called.lower().split()[:-1]} if len(found) > 1 else set()
        loads = [p for p in self.scene.placements if p.category.rpartition("_")[2] in words]
        bearing = [p for p in found if any(p.id in self.scene.carriers(load.id) for load in loads)]
        says = f"'{noun.text}' is taken to be {_ids(bearing)}"
        self.seen += [says] if len(bearing) == 1 and says not in self.seen else []
        return bearing or found

    def _nearest(self, noun: Noun, found: Sequence[Placement]) -> list[Placement]:
        """The one that is nearest to what is moved, or farthest from it.

        Raises:
            InputError: it is not said from what.
        """
        if self.about not in self.scene:
            raise InputError(f"'{noun.text}': which is the {noun.degree} is not known; say what it is {noun.degree} to")
        mark = things(self.scene, self.about)[0]
        away = {p.id: ground_gap(things(self.scene, p.id)[0], mark) for p in found if p.id != self.about}
        ordered = sorted((p for p in found if p.id in away), key=lambda p: away[p.id])
        if not ordered:
            raise self.nothing(noun.text)
        return ordered[:1] if means("nearest", noun.degree) == "nearest" else ordered[-1:]

    def _of_somebody(self, noun: Noun, found: Sequence[Placement]) -> list[Placement]:
        """The teacher's desk, the one that is turned to all others of its kind; the pupils' desks, which are these.

        Raises:
            InputError: none is, or several are.
        """
        gazes = {p.id: things(self.scene, p.id)[0].gaze for p in found}
        facing = [p for p in found if sum(turn_between(gazes[p.id], gaze) > ACROSS for gaze in gazes.values()) > 1]
        owner = singular(whose(noun.text).removesuffix("'s").removesuffix("'"))
        if means("audience", owner) and len(facing) <= 1 and (noun.many or noun.each or noun.det == "all"):
            return [p for p in found if p not in facing]
        if len(facing) != 1 or len(found) < 3:
            raise InputError(
                f"'{noun.text}': which of {_ids(found)} is {whose(noun.text)} is not known; name it by its id"
            )
        return facing

    def matching(self, noun: Noun, *, wide: bool = False) -> list[Placement]:
        """Every object that a noun fits; of one thing those that are just that before those that are like it.

        Args:
            noun: the phrase.
            wide: those that are like it are meant too, as of "the nearest desk".
        """
        if noun.id:
            return [p for p in self.scene.placements if p.id == noun.id]
        if (group := means("collectives", singular(noun.word.lower()))) and (noun.many or noun.det in ("all", "each")):
            return [p for p in self.scene.placements if facts_of(p.category).is_in(group)]
        same = [p for p in self.scene.placements if self._is_called(p, noun)]
        same = [p for p in same or self.scene.placements if self._has_name(p, noun.called)] or same
        if noun.many and not noun.count and noun.named:
            same += [p for p in self.scene.placements if p not in same and self._is_of(p, noun)]
        alike = same or [p for p in self.scene.placements if are_alike(p.category, noun.value)]
        told = [word for word in noun.unshown if word != noun.degree] if not noun.named else []
        wanted = [word.lower() for word in (*noun.attributes, *told)]
        fitting = [p for p in alike if all(self._has(p, word) for word in wanted)]
        literal = [p for p in fitting if noun.word in p.category.split("_")]
        fitting = literal or fitting
        exact = [p for p in fitting if p.category == noun.value]
        if len(exact) > 1 and (_is_told_otherwise(noun) or len(exact) == (2 if noun.det == "both" else noun.count)):
            return exact
        wide = wide or noun.many or noun.each or bool(noun.every or noun.rows) or noun.det in ("all", "both", "other")
        fitting = exact if exact and not wide else fitting
        return fitting or ([] if wanted else self._with_more(noun))

    def _with_more(self, noun: Noun) -> list[Placement]:
        """Where no such thing is there, those that are one with something, or by the end of their name.

        "The vase" is a vase with flowers, "the benches" are the workbenches.
        """
        names = {noun.value, singular(noun.word.lower())}
        filled = [
            p for p in self.scene.placements if _FILLED & {*p.category.split("_")[1:]} and _head(p.category) in names
        ]
        word = singular(noun.word.lower())
        filled = filled or [p for p in self.scene.placements if self._is_of(p, noun)]
        if filled:
            return filled
        lasts = {p.id: p.category.rpartition("_")[2] for p in self.scene.placements}
        joined = [p for p in self.scene.placements if lasts[p.id] == word or
                  (len(word) >= LEAST_HEAD and lasts[p.id].endswith(word))]  # fmt: skip
        joined = [p for p in joined if not facts_of(p.category).is_in("small")]
        joined = joined or [p for p in self.scene.placements if _is_holder_of(p.category, word)]
        says = f"'{noun.text}' is taken to be {_ids(joined)}"
        told = len(joined) == 1 or noun.many or noun.det in ("all", "both", "each")
        self.seen += [says] if joined and told and says not in self.seen else []
        return joined

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
            self._recall(noun)
        if not self.recent:
            raise InputError(f"{noun.text!r} points at nothing that was named before; name what you mean")
        if noun.det == "other":
            return self._other_of_kind(noun)
        one = noun.value in ("it", "one")
        there = [id for id in self.recent if id in self.scene]
        alike = [p.id for p in self.scene.placements if len(there) == 1 and p.category == self.scene[there[0]].category]
        if noun.det == "both" and len(alike) == 2:
            there = alike
        came = len(there) == 1 and self.start is not None and there[0] not in self.start
        if noun.value == "them" and came and len(alike) > 1:
            there = alike
            self.seen.append(f"'{noun.text}' is taken to be {_listed(alike)}")
        return tuple(there[-1:] if one and len(there) > 1 else there)

    def _recall(self, noun: Noun) -> None:
        """Let a pronoun mean what the edit before was about, where this instruction has named nothing yet."""
        self.recent = [id for id in self.past.about if id in self.scene]
        if self.recent:
            self.seen.append(f"'{noun.text}' is taken to be {_listed(self.recent)}, of the edit before")

    def _other_of_kind(self, noun: Noun) -> tuple[str, ...]:
        """Those of the kind of what was named last that were not named: "take one away and put the other there".

        Raises:
            InputError: there are not just so many.
        """
        kinds = {id.rpartition("_")[0] for id in self.recent}
        left = [p.id for p in self.scene.placements if p.id.rpartition("_")[0] in kinds and p.id not in self.recent]
        all_of_them = not noun.count and noun.text.lower().endswith(("others", "ones"))
        if not left or (len(left) != (noun.count or 1) and not all_of_them):
            raise InputError(f"'{noun.text}' could be {_listed(left)}; say which, by its place or its id")
        return tuple(left)

    def _is_called(self, placement: Placement, noun: Noun) -> bool:
        category = placement.category.lower().replace(" ", "_").replace("-", "_")
        if counts_as(category, noun.value):
            return True
        words = noun.value.split("_")
        return not noun.named and words[-1:] == [singular(category.rpartition("_")[2])] and len(words) == 1

    def _is_of(self, placement: Placement, noun: Noun) -> bool:
        """Whether it is several of what a noun names, as one thing: "the books" are a row of books too."""
        head, of, what = self.scene.asset_of(placement).description.rpartition(" of ")
        return bool(head and of) and singular(what.lower()) == singular(noun.word.lower())

    def _has_name(self, placement: Placement, name: str) -> bool:
        """Whether it was named so when it came: one of the desks is "the teacher's desk"."""
        return bool(own_name(name, placement.category)) and self.scene.asset_of(placement).name == name

    def _has(self, placement: Placement, word: str) -> bool:
        asset = self.scene.asset_of(placement)
        said = {*with_general(asset.attributes), *asset.description.lower().replace(",", " ").split()}
        return word in said or word.replace(" ", "-") in said

    def _as_many(self, noun: Noun, found: list[Placement], picks: Sequence[Picks]) -> list[Placement]:
        count = 2 if noun.det == "both" else noun.count if noun.count and not noun.ordinal else None
        if noun.ordinal:
            return self._by_number(noun, found)
        if count is None and (noun.plural or noun.det in ("all", "each")):
            half = len(found) // 2
            return self._by_side(found, noun, half) if noun.side and half else self._picked(found, picks, least=1)
        if noun.vague and count is not None:
            count = max(1, min(count, len(found)))
        count = count or 1
        if noun.side:
            found = self._by_side(found, noun, count) if len(found) > count else found
        if len(found) < count:
            raise InputError(f"'{noun.text}': the room has only {_ids(found)}; there {self.listed()}")
        if len(found) > count:
            found = self._picked(found, picks, least=count)
        if len(found) > count:
            found = self._of_context(noun, found, count)
        if len(found) > count and not _is_whichever(noun):
            says = ", ".join(self.described(p) for p in found[:LISTED])
            raise InputError(
                f"'{noun.text}' could be {says}; say which, by its place ('the one by the window') or by its id"
            )
        if len(found) > count:
            self._say_taken(noun, [p.id for p in found[-count:]], [p.id for p in found])
        return found[-count:]

    def _of_context(self, noun: Noun, found: list[Placement], count: int) -> list[Placement]:
        """Those of several that were spoken of, or that belong to what was: "turn the desk and push the chair in"."""
        spoken = [p for p in found if p.id in self.recent]
        if len(spoken) == count:
            return spoken
        by_them = [p for p in found if any(self._belongs(p, id) for id in self.recent)]
        if len(by_them) != count or not noun.definite:
            return found
        self._say_taken(noun, [p.id for p in by_them], [p.id for p in found])
        return by_them

    def _belongs(self, placement: Placement, id: str) -> bool:
        """Whether something rests on an object or stands by it."""
        if id not in self.scene or id == placement.id:
            return False
        gap = ground_gap(things(self.scene, placement.id)[0], things(self.scene, id)[0])
        return id in self.scene.carriers(placement.id) or (placement.support == "floor" and gap <= BY_IT)

    def _by_number(self, noun: Noun, found: Sequence[Placement]) -> list[Placement]:
        """The second of them, the last two, by the numbers of their ids, or counted from a side."""
        if noun.side in ("left", "right"):
            found = self._leftmost_first(found)[0][:: 1 if noun.side == "left" else -1]
        else:
            found = sorted(found, key=lambda p: _number(p.id))
        several = noun.count if noun.count and noun.plural else 1
        start = noun.ordinal - 1 if noun.ordinal > 0 else len(found) - several
        if start < 0 or start + several > len(found):
            raise InputError(f"there are only {len(found)} {_bare(noun.text)}: {_ids(found)}")
        return list(found[start : start + several])

    def _by_side(self, found: list[Placement], noun: Noun, count: int = 1) -> list[Placement]:
        """The leftmost, rightmost or middle one: by the front of what they stand beside, or else seen from the door."""
        ordered, company = self._leftmost_first(found)
        which = {"left": 0, "right": len(ordered) - count, "middle": (len(ordered) - count + 1) // 2}.get(noun.side)
        if which is None:
            return found
        meant = ordered[which : which + count]
        doors = any(o.kind == "door" for o in self.scene.room.openings)
        of_room = "seen from the door" if doors else "seen by who looks north"
        of_room = "seen by who looks at it" if self._looked_at(found, company) is not None else of_room
        ids = " and ".join(p.id for p in meant)
        by = f"by the front of {company.id}" if company else of_room
        says = f"{noun.text} {'is' if count == 1 else 'are'} {ids}, {by}"
        self.seen += [says] if says not in self.seen else []
        return meant

    def _leftmost_first(self, found: Sequence[Placement]) -> tuple[list[Placement], Placement | None]:
        """Things from left to right, and by the front of what, if not as seen from the door."""
        company = _company(self.scene, list(found))
        if (wall := self._looked_at(found, company)) is not None:
            return sorted(found, key=lambda p: -wall.coordinates(p.position[:2])[0]), None
        along = company.left if company is not None else _left_of_room(self.scene)
        return sorted(found, key=lambda p: -(p.position[0] * along[0] + p.position[1] * along[1])), company

    def _looked_at(self, found: Sequence[Placement], company: Placement | None) -> Wall | None:
        """The wall that all of them hang on, or stand at where they are beside nothing."""
        hung = _hung_at(self.scene, found)
        return hung if hung is not None or company is not None else _stood_at(self.scene, found)

    @staticmethod
    def _picked(found: list[Placement], picks: Sequence[Picks], *, least: int) -> list[Placement]:
        for pick in picks:
            if len(found) == least and least > 0:
                break
            fewer = list(pick(found))
            if len(fewer) >= least:
                found = fewer
        return found


def _around(scene: Scene, ids: Sequence[str]) -> list[str]:
    """Seats at one table as one goes around it, what stands at walls as one goes along them, else by their numbers."""
    tables = [p for p in scene.placements if facts_of(p.category).is_in("tables")]
    table = next((t for t in tables if all(measure(scene, "at", id, (t.id,)).holds for id in ids)), None)
    if table is None or not all(facts_of(scene[id].category).is_in("seating") for id in ids):
        walls = {
            id: next(
                (n for n, w in enumerate(scene.room.walls) if measure(scene, "against_wall", id, (w.name,)).holds), -1
            )
            for id in ids
        }
        if -1 in walls.values():
            return list(ids)
        along = {id: scene.room.walls[n].coordinates(scene[id].position[:2])[0] for id, n in walls.items()}
        return sorted(ids, key=lambda id: (walls[id], along[id]))
    local = {id: table.to_local(scene[id].position[:2]) for id in ids}
    return sorted(ids, key=lambda id: math.atan2(local[id][1], local[id][0]))


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
    ids = {f.id for f in found}
    large = [
        p for p in scene.placements if p.id not in ids and scene.asset_of(p).front == "one" and p.support == "floor"
    ]
    stood = _stood_at(scene, found)
    for other in sorted(large, key=lambda p: -p.size[0] * p.size[1]):
        mark = things(scene, other.id)[0]
        if stood is not None and not measure(scene, "against_wall", other.id, (stood.name,)).holds:
            continue
        if math.prod(other.size) < max(math.prod(p.size) for p in found):
            continue
        if all(ground_gap(things(scene, p.id)[0], mark) < 0.6 for p in found):
            return other
    return None


def _hung_at(scene: Scene, found: Sequence[Placement]) -> Wall | None:
    """The one wall that all of them hang on."""
    names = {p.support for p in found}
    return next((wall for wall in scene.room.walls if {wall.name} == names), None)


def _stood_at(scene: Scene, found: Sequence[Placement]) -> Wall | None:
    """The one wall that all of them stand with their backs to."""
    fronted = all(scene.asset_of(p).front == "one" for p in found)
    walls = scene.room.walls if fronted and len(found) > 1 else ()
    return next((w for w in walls if all(measure(scene, "against_wall", p.id, (w.name,)).holds for p in found)), None)


def _left_of_room(scene: Scene) -> tuple[float, float]:
    """The left of somebody who comes in by the first door, or looks north where there is none."""
    door = next((o for o in scene.room.openings if o.kind == "door"), None)
    x, y = scene.room.walls[door.wall].inward if door is not None else (0.0, 1.0)
    return (-y, x)


def _number(id: str) -> tuple[int, str]:
    tail = id.rpartition("_")[2]
    return (int(tail) if tail.isdecimal() else 0, id)


def _listed(ids: Sequence[str]) -> str:
    return ", ".join(ids[:LISTED]) or "none"


def _all(noun: Noun) -> Noun:
    """The same phrase for all of them."""
    return dataclasses.replace(noun, det="all", count=None, plural=True, every=0, share=0.0)


def _extent(placement: Placement, along: str) -> float:
    """How large something is, or how high, how long, or how high up its top is [m]."""
    deep, wide, high = placement.size
    if along == "level":
        return placement.position[2] + high
    return high if along == "height" else max(deep, wide) if along == "length" else deep * wide * high


def _has_length(placement: Placement, metres: float, axis: str) -> bool:
    deep, wide, high = placement.size
    sides = {"width": (wide,), "depth": (deep,), "height": (high,), "length": (max(deep, wide),)}
    return any(abs(side - metres) <= SAME_SIZE for side in sides.get(axis, (deep, wide, high)))


def _is_told_otherwise(noun: Noun) -> bool:
    """Whether a word says which are meant that no thing of a room shows: "the waiting chairs" are no office chairs."""
    said = {*own_name(noun.called, noun.value).split()} if noun.named and not whose(noun.text) else set()
    shown = " ".join(
        (noun.value.replace("_", " "), noun.word, *noun.attributes, *noun.unshown, *noun.looks, noun.degree)
    )
    return bool({singular(word) for word in said} - {singular(word) for word in shown.lower().split()})


def _depth_of(noun: Noun) -> str:
    """The wall, as it is seen from the door, at which those are that a phrase means: "the two back tables"."""
    words = noun.text.lower().split()[:-1] if noun.kind == "thing" and not noun.rows else []
    told = [found for word in words if (found := means("depths", word))]
    return told[0] if len(told) == 1 and not {"left", "right"} & {*words} else ""


def _is_whichever(noun: Noun) -> bool:
    """Whether any of several will do: "a chair", "two of the chairs"."""
    if noun.of_known and noun.count is not None:
        return True
    return noun.det in ("a", "another", "any", "either", "") and not noun.definite


def _ranked(noun: Noun, found: Sequence[Placement], rank: int, along: str) -> list[Placement]:
    """So many of them as are meant by how large they are.

    Raises:
        InputError: others are just as large.
    """
    ordered = sorted(found, key=lambda p: -rank * _extent(p, along))
    count = noun.count or 1
    meant, rest = ordered[:count], ordered[count:]
    if rest and abs(_extent(rest[0], along) - _extent(meant[-1], along)) < 0.01 * _extent(rest[0], along):
        same = [p for p in ordered if abs(_extent(p, along) - _extent(rest[0], along)) < 0.01 * _extent(p, along)]
        raise InputError(
            f"'{noun.text}': {_ids(same)} are of the same size; say which, by its place ('the one by the window') or by"
            " its id"
        )
    return meant


def _check_told(phrase: NounPhrase, found: Sequence[Placement]) -> None:
    """Refuse what says which of several in a way that nobody can tell.

    Raises:
        InputError: it compares by what no thing of a room shows, calls some what nobody sees, or forms groups.
    """
    noun = phrase.noun
    unseen = [word for word in (*noun.unshown, *noun.states, *noun.styles) if word != noun.degree] if noun.named else []
    if unseen and len(found) > 1 and not phrase.rank:
        raise InputError(
            f"'{noun.text}': which of {_ids(found)} that are cannot be seen; say by place ('by the window') or id"
        )
    if noun.degree and not phrase.rank and not rank_of(noun.degree)[0] and not means("nearest", noun.degree):
        raise InputError(f"'{noun.text}': which is the {noun.degree} is not known; name it by its place or its id")
    if noun.groups:
        raise InputError(f"'{noun.text}': groups of things are not known in a room; name them by place or id")


def _of_rows(found: Sequence[Placement]) -> list[Placement]:
    """Those of several that can form rows: of pupils' desks and one of the teacher the pupils'."""
    counts = Counter(p.category for p in found)
    return [p for p in found if counts[p.category] > 1] or list(found)


def _is_holder_of(category: str, word: str) -> bool:
    """Whether it is what holds such a thing, and is called by it: a sink cabinet by "the sink"."""
    first, _, last = category.rpartition("_")
    return bool(first) and first.split("_")[-1] == word and bool(means("holders", last))


def _head(category: str) -> str:
    """What a kind of thing is before what it holds: "vase" of a vase with flowers, "stack" of a stack of books."""
    words = category.split("_")
    return "_".join(words[: next((n for n, word in enumerate(words) if n and word in _FILLED), len(words))])


def _ids(found: Sequence[Placement]) -> str:
    return ", ".join(p.id for p in found[:LISTED]) or "none"


def _bare(text: str) -> str:
    """A noun phrase without its article."""
    first, _, rest = text.partition(" ")
    return (
        rest if rest and first.lower() in ("the", "a", "an", "my", "both", "all", "this", "that", "another") else text
    )
