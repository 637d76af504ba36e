"""Editing a finished room by instructions: what is named changes and is measured, everything else stays as it is."""

import dataclasses
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Literal, Protocol

import numpy as np
from msgspec import structs

from thinkblox.assets.source import AssetSource, ProceduralAssets
from thinkblox.brief import Brief
from thinkblox.editing.antecedents import with_antecedents
from thinkblox.editing.company import left_behind
from thinkblox.editing.ensuring import bring, ensure
from thinkblox.editing.falling_back import Reading, readings
from thinkblox.editing.finding import Finder
from thinkblox.editing.formations import form, formation_of
from thinkblox.editing.goals import Related
from thinkblox.editing.grammar import longest, means
from thinkblox.editing.heeding import check_heeded
from thinkblox.editing.history import Past, past_of
from thinkblox.editing.in_line import check_in_line
from thinkblox.editing.joining import is_that, joined
from thinkblox.editing.making import as_larger_one, hang, hangs_down, make
from thinkblox.editing.more_rows import is_row
from thinkblox.editing.moving import move, resite
from thinkblox.editing.off_floor import on_floor
from thinkblox.editing.orders import INSTEAD, Instruction, NounPhrase, Order
from thinkblox.editing.rearranging import free, rearrange
from thinkblox.editing.remarks import beside_corner, facing_wall
from thinkblox.editing.removing import clear, keep_only, remove, take_away
from thinkblox.editing.replacing import replace
from thinkblox.editing.spacing import space
from thinkblox.editing.spreading import spread
from thinkblox.editing.standing import as_made, carried_over
from thinkblox.editing.swapping import swap
from thinkblox.editing.telling import named
from thinkblox.editing.told_by_load import tell_by_load
from thinkblox.editing.turning import turn
from thinkblox.editing.turns import in_turn
from thinkblox.editing.wheres import Bound, slots_of
from thinkblox.editing.work import Work
from thinkblox.episode import Edited, Episode, RoomState, Round, Undone, read_episode
from thinkblox.errors import InputError
from thinkblox.placing import Effort
from thinkblox.plainness import plain_things
from thinkblox.plan import Plan
from thinkblox.players import EXPERT, players
from thinkblox.policies import Policy
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.tokens import tokenise
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.scoring import score
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.verdict.verify import reverify
from thinkblox.sim.verdict.world import World
from thinkblox.value import read_json
from thinkblox.verdict import Report

What = Literal["added", "removed", "replaced", "moved", "turned", "carried"]
Doer = Callable[[Work, Finder, Order], None]
_ON_EITHER = ("remove", "replace", "make", "move", "turn")
_RESTING = ("on", "in", "inside", "on_top", "from")


class Made(Protocol):
    """A room with its report and how it came about, as a Generation or an Edit has them."""

    @property
    def scene(self) -> Scene:
        """The room."""
        ...

    @property
    def report(self) -> Report:
        """What was measured of it."""
        ...

    @property
    def episode(self) -> Episode:
        """How it came about."""
        ...


@dataclass(frozen=True)
class Changed:
    """What became of one object.

    Attributes:
        what: "carried" is what rode along with what it rests on.
        before, after: where it stood and stands; None where it was or is not there.
    """

    id: str
    what: What
    before: Placement | None
    after: Placement | None


@dataclass(frozen=True)
class Edit:
    """A room after an instruction.

    Attributes:
        scene: the room; what is not in `changes` is bit-identical to what it was.
        report: what was measured of it; `complete` where the instruction was carried out, every word of it was
            understood, and everything passed.
        episode: how the room came about, this edit included.
        instruction: what was asked.
        changes: what became of each object that is not as it was.
        done: what was done, in sentences that name the objects.
        failed: what could not be done, with what was measured.
        unknown: words of the instruction that mean nothing.
        notes: what else there is to say, such as which seats stayed where their table left.
    """

    scene: Scene
    report: Report
    episode: Episode
    instruction: str
    changes: tuple[Changed, ...] = ()
    done: tuple[str, ...] = ()
    failed: tuple[str, ...] = ()
    unknown: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def plan(self) -> Plan:
        """By which the room was made."""
        return self.episode.plan

    @property
    def trace(self) -> tuple[Round, ...]:
        """The rounds of this edit."""
        last = self.episode.edits[-1] if self.episode.edits else None
        return last.rounds if isinstance(last, Edited) else ()

    @property
    def complete(self) -> bool:
        """Whether everything is done as asked, and the room passes."""
        return self.report.complete


@dataclass(frozen=True)
class _Source:
    """What is edited: a scene, what is known of it, and what led to it."""

    scene: Scene
    report: Report | None
    episode: Episode | None


def edit_room(
    room: Scene | Made | str | Path,
    instruction: str,
    *,
    seed: int = 0,
    policy: Policy | str | None = None,
    source: AssetSource | None = None,
    effort: Effort | None = None,
    tolerances: Tolerances | None = None,
) -> Edit:
    """Change a finished room as an English instruction says; what it does not name stays bit-identical.

    Every change is measured in MuJoCo like any placement; what cannot be done is not done, and `failed` says why with
    the numbers. What rests on a thing that moves, moves along. The report is made anew for what has changed and what
    that can concern; where a report on the room is known, it holds for the rest.

    Args:
        room: a scene, a generated or edited room, or the folder that one was saved to.
        instruction: one or more orders, such as "Move the desk under the window and turn it to face the room."
        seed: every random choice follows from it.
        policy: who proposes places, or that in a word as for `generate_room`; the embedded expert when not given.
        source: where assets come from; the catalogue when not given.
        effort: how hard to try.
        tolerances: what counts as valid.

    Raises:
        InputError: the room or the instruction cannot be used: it names what is not there, or what could be several.
    """
    if type(seed) is not int or not 0 <= seed < 2**63:
        raise InputError(f"the seed is {seed!r}; it must be a whole number from 0 to 2^63 - 1")
    if isinstance(policy, str):
        policy = players(policy, briefer=EXPERT, planner=EXPERT, seed=seed).policy
    if policy is not None and not callable(getattr(policy, "propose", None)):
        raise InputError(f"the policy is a {type(policy).__name__}, which has no propose(); see thinkblox.policies")
    made = _opened(room)
    past = past_of(made.episode.standing) if made.episode is not None else Past()

    def begun() -> Work:
        return Work(
            World(made.scene, tolerances=tolerances or Tolerances()),
            prompt=f"{made.scene.prompt}\nNow: {instruction.strip()}".strip(),
            planned=made.episode.plan if made.episode is not None else None,
            policy=policy if policy is not None and not isinstance(policy, str) else ExpertPolicy(),
            source=source or ProceduralAssets(),
            effort=effort or Effort(rounds=2),
            rng=np.random.default_rng((seed, 11)),
            seed=seed,
        )

    work, read, about = _first_that_can_be(begun, readings(instruction, made.scene), past)
    return _finished(work, made, read, tolerances, about)


def _first_that_can_be(
    begun: Callable[[], Work], ways: Iterable[Reading], past: Past
) -> tuple[Work, Instruction, tuple[str, ...]]:
    """The first of several ways to carry an instruction out in which everything is done, else that with most of it."""
    best: tuple[Work, Instruction, tuple[str, ...]] | None = None
    for way in ways:
        work = begun()
        try:
            about = _carry_out(work, way.instruction, past)
        except InputError:
            if best is None:
                raise
            continue
        if best is None or len(work.failed) < len(best[0].failed):
            best = work, way.instruction, about
            work.notes += [way.says] if way.says and not work.failed else []
        if not work.failed:
            break
    if best is None:
        raise InputError("the instruction does not say what to do")
    return best


def undo_edit(room: Made | str | Path) -> Edit:
    """Give a room back as it was before its last edit that was not undone; the history says so.

    Args:
        room: an edited room, or the folder that one was saved to.

    Raises:
        InputError: it has no edit to undo, or was changed since by other means.
    """
    made = _opened(room)
    standing = made.episode.standing if made.episode is not None else ()
    if made.episode is None or not standing:
        raise InputError("there is no edit to undo; the trace of the room holds none")
    last, episode = standing[-1], made.episode
    if RoomState.of(made.scene) != last.after:
        raise InputError(f"the room has been changed since edit {last.number}; it cannot be undone")
    scene = episode.restored(last.before)
    report = structs.replace(
        reverify(scene, made.scene, made.report), stand_ins=plain_things(scene), score=score(scene)
    )
    if len(standing) == 1:
        report = as_made(report, scene, made.report, episode.plan)
    else:
        report = carried_over(report, scene, made.scene, made.report, episode.plan)
    episode = structs.replace(episode, edits=(*episode.edits, Undone(number=last.number)))
    says = (f"edit {last.number} undone: {last.instruction}",)
    return Edit(scene, report, episode, f"undo edit {last.number}", _changes(made.scene, scene), says)


def _opened(room: object) -> _Source:
    if isinstance(room, Scene):
        return _Source(room, None, None)
    if isinstance(room, str | Path):
        return _from_files(Path(room))
    scene, report, episode = (getattr(room, name, None) for name in ("scene", "report", "episode"))
    if isinstance(scene, Scene) and isinstance(report, Report) and isinstance(episode, Episode):
        return _Source(scene, report, episode)
    raise InputError(f"a {type(room).__name__} is no room to edit; give a Scene, a generated room or its folder")


def _from_files(path: Path) -> _Source:
    scene = load_scene(path)
    home = path if path.is_dir() else path.parent
    if not (home / "trace.jsonl").is_file():
        return _Source(scene, None, None)
    episode = read_episode(home / "trace.jsonl")
    if not _is_part_of(scene, episode.scene):
        return _Source(scene, None, episode)
    report = read_json(home / "report.json", Report) if (home / "report.json").is_file() else None
    ids = {p.id for p in scene.placements}
    same = report is not None and {v.id for v in report.objects} == ids
    return _Source(scene, report if same else None, episode)


def _is_part_of(scene: Scene, made: Scene) -> bool:
    """Whether a scene is as it was made, but for what was taken out again before it was reported on."""
    there = {p.id: p for p in made.placements}
    same = all(p == there.get(p.id) and scene.asset_of(p) == made.assets.get(p.asset) for p in scene.placements)
    return same and scene.room == made.room


# --- carrying out


def _made_room(work: Work, finder: Finder, order: Order) -> None:
    """Take away what stands where something comes "instead of" it: "put a bowl on the table instead of the vase"."""
    for phrase in order.things:
        others = [w for w in phrase.places if w.text == INSTEAD and w.noun is not None and w.noun.kind == "thing"]
        wanted = [w for w in phrase.places if not w.negated]
        for where in others if wanted else ():
            ids = finder.ids(NounPhrase(where.noun, id=where.noun.id)) if where.noun is not None else ()
            there = [slot for w in wanted for id in ids[:1] for slot in slots_of(w, work.scene[id].category, finder)]
            if not all(any(id not in b.anchors and _is_there(work.scene, b, id) for b in there) for id in ids):
                continue
            if _is_known(phrase) or order.doing == "move":
                raise InputError(
                    f"'{order.text}': {', '.join(ids)} is in its way there; say where that goes, or let the two swap"
                    " places"
                )
            phrase.places = [w for w in phrase.places if w is not where]
            take_away(work, work.touched(ids))
            finder.scene = work.before = work.scene


def _add(work: Work, finder: Finder, order: Order) -> None:
    """Add what is new, where something else may have to make room for it."""
    _made_room(work, finder, order)
    bring(work, finder, order)


def _is_there(scene: Scene, there: Bound, id: str) -> bool:
    """Whether an object takes a place, or rests on the thing that the place is a part of."""
    return there.holds(scene, id) or bool(set(scene.carriers(id)) & set(there.anchors))


def _put(work: Work, finder: Finder, order: Order) -> None:
    """Put what is there, or add what is new: "the vase", "a vase"."""
    if hangs_down(work, finder, order):
        hang(work, finder, order)
        return
    _point_at_known(finder, order)
    _made_room(work, finder, order)
    known = [_is_known(p) or _is_all_there(finder, p, order.things[n + 1 :]) for n, p in enumerate(order.things)]
    if _is_preferred(finder, order):
        noun = dataclasses.replace(
            order.things[0].noun, det="the", attributes=[], size=None, unshown=[], count=None, plural=False
        )
        old = NounPhrase(noun)
        replace(work, finder, dataclasses.replace(order, doing="replace", things=[old], instead=order.things))
        return
    if (standing := _to_be_hung(work, finder, order)) is not None:
        replace(work, finder, standing)
        return
    if order.things and not any(known) and not order.rest:
        check_heeded(dataclasses.replace(order, doing="add", company=[]))
        bring(work, finder, order)
    elif not all(known) and all(phrase.places for phrase in order.things):
        for phrase, there in zip(order.things, known, strict=True):
            (move if there else bring)(work, finder, dataclasses.replace(order, things=[phrase]))
            finder.scene = work.before = work.scene
    else:
        move(work, finder, order)


def _to_be_hung(work: Work, finder: Finder, order: Order) -> Order | None:
    """The order that replaces what stands by one that hangs: "hang the TV on the wall"; None where it says no such."""
    noun = order.things[0].noun if len(order.things) == 1 and not order.things[0].places else None
    if noun is None or noun.kind != "thing" or not noun.text.lower().endswith(" on the wall") or not noun.named:
        return None
    found = finder.matching(noun)
    if work.source.usual(noun.value)[1] != "wall" or len(found) != 1 or work.asset_of(found[0].id).mount == "wall":
        return None
    hung = NounPhrase(dataclasses.replace(noun, det="a", called=""))
    return dataclasses.replace(order, doing="replace", things=[NounPhrase(noun, id=found[0].id)], instead=[hung])


def _point_at_known(finder: Finder, order: Order) -> None:
    """Let what is named without a verb, and without an article, be what is there: "wardrobe next to the door"."""
    if longest("verbs", tokenise(order.text.lower()), 0) is not None:
        return
    for phrase in order.things:
        noun = phrase.noun
        bare = noun.kind == "thing" and not (noun.det or noun.count or noun.id or noun.degree)
        if bare and phrase.places and finder.matching(noun):
            phrase.noun = dataclasses.replace(noun, det="the")


def _is_preferred(finder: Finder, order: Order) -> bool:
    """Whether it says what somebody would rather have, of a kind of which one is there: "I'd rather have a big bed"."""
    noun = order.things[0].noun if len(order.things) == 1 else None
    said = longest("preferring", tokenise(order.text.lower()), 0) is not None
    one = noun is not None and noun.kind == "thing" and not noun.definite
    if not (said and one) or noun is None or order.company or noun.degree or noun.det == "another":
        return False
    bare = dataclasses.replace(noun, attributes=[], size=None, unshown=[], count=None)
    return len(finder.matching(bare)) == 1 and not order.things[0].places


def _is_of_pair(finder: Finder, phrase: NounPhrase, later: Sequence[NounPhrase]) -> bool:
    """Whether it is one of two that are there, of which the other is named next: "one stool here, the other there"."""
    there = finder.matching(phrase.noun)
    others = [p for p in later if p.noun.kind == "pronoun" and p.noun.value == "other"]
    if len(there) != 2 or len(others) != 1:
        return False
    one, other = there
    finder.seen.append(f"'{phrase.noun.text}' is taken to be {one.id}, and '{others[0].noun.text}' {other.id}")
    phrase.noun = dataclasses.replace(phrase.noun, id=one.id)
    phrase.id, others[0].id = one.id, other.id
    others[0].noun = dataclasses.replace(phrase.noun, id=other.id)
    return True


def _is_all_there(finder: Finder, phrase: NounPhrase, later: Sequence[NounPhrase]) -> bool:
    """Whether "one lamp on each nightstand" speaks of the lamps that are there: one for each place, and no more."""
    noun, each = phrase.noun, [w for w in phrase.places if w.noun is not None and w.noun.each]
    if noun.kind == "thing" and noun.count == 1 and not noun.det and _is_of_pair(finder, phrase, later):
        return True
    there = finder.matching(noun) if noun.kind == "thing" and noun.count == 1 and not noun.det and each else []
    if len(there) < 2 or len(slots_of(each[0], there[0].category, finder)) != len(there):
        return False
    finder.seen.append(f"'{noun.text}' is taken to be each of {', '.join(p.id for p in there)}")
    phrase.noun = dataclasses.replace(noun, det="all", count=None, plural=True)
    return True


def _is_known(phrase: NounPhrase) -> bool:
    """Whether a phrase points at something that is there."""
    noun = phrase.noun
    pointed = noun.definite or noun.det in ("each", "all", "both", "half")
    if is_row(noun) and not (pointed or noun.ordinal):
        return False
    return bool(
        phrase.id or pointed or noun.of_known or noun.kind in ("pronoun", "number") or phrase.rank or noun.ordinal
    )


def _bring(work: Work, finder: Finder, order: Order) -> None:
    """Move what is there; "bring a chair" where there is none adds one."""
    _made_room(work, finder, order)
    if order.away:
        if order.lengths or order.slight:
            raise InputError(f"'{order.text}': away from what? Say 'away from the wall'")
        remove(work, finder, order)
        return
    if hangs_down(work, finder, order):
        hang(work, finder, order)
        return
    if (larger := as_larger_one(finder, order)) is not None:
        make(work, finder, larger)
        return
    fetched = bool(means("fetching", order.text.split(" ", 1)[0].lower()))
    new = [p.noun.kind == "thing" and not p.noun.definite and _is_more(finder, p.noun) for p in order.things]
    new = new if fetched else [False]
    (bring if order.things and all(new) else move)(work, finder, order)


def _is_more(finder: Finder, noun: Noun) -> bool:
    """Whether something that is fetched is not there yet: none is, or it is said to be one more."""
    said = noun.text.lower().split()
    return not finder.matching(noun) or noun.det == "another" or bool({"more", "extra", "additional"} & {*said})


_MOVING = ("keep", "swap", "move", "put", "turn")
"""Orders by which what is kept on something goes where that goes."""


def _keep(work: Work, finder: Finder, order: Order) -> None:
    """Everything that is not named stays where it is in any case; what is named is said to."""
    before = dataclasses.replace(finder, scene=work.start)
    ids = [id for phrase in order.things for id in _kept(before, phrase)]
    finder.recent = finder.recent or ids
    goes = [id for id in ids if id not in work.kept and id in work.scene and work.scene[id].support in work.scene]
    for id in goes:
        work.done.append(f"{id} stays on {work.scene[id].support}")
        work.wish(id, [Related("on", (work.scene[id].support,))])
    if len(goes) < len(ids) or not ids:
        left = [id for id in ids if id not in goes]
        work.done.append(f"{', '.join(left) or 'all else'} stays as it is")


def _on_its_carrier(finder: Finder, phrase: NounPhrase, id: str) -> bool:
    """Whether something stays on what carries it, wherever that goes: "the printer stays on the cabinet"."""
    on = [w.noun for w in phrase.places if w.word in ("on", "on_top") and not w.negated and w.noun is not None]
    carrier = finder.scene[id].support
    named_ = [p.id for noun in on if noun.kind == "thing" for p in finder.matching(noun)]
    return carrier in finder.scene and carrier in named_


_BY = ("above", "next_to", "near", "by", "at", "in_front_of", "behind", "left_of", "right_of", "under", "around")


def _marks_of(finder: Finder, phrase: NounPhrase) -> list[str]:
    """The things at which something is said to stay: "the mirror stays above the washbasin"."""
    nouns = [w.noun for w in phrase.places if w.word in _BY and not w.negated and w.noun is not None]
    return [p.id for noun in nouns if noun.kind == "thing" for p in finder.matching(noun)]


def _follow(work: Work, finder: Finder, order: Order) -> None:
    """Let what is to stay at a thing go where that has gone."""
    before = dataclasses.replace(finder, scene=work.start)
    gone = [
        id in work.scene and id in work.start and work.scene[id] != work.start[id]
        for phrase in order.things
        for id in _marks_of(before, phrase)
    ]
    if order.doing == "keep" and any(gone) and all(phrase.places for phrase in order.things):
        order.doing = "put"


def _kept(finder: Finder, phrase: NounPhrase) -> tuple[str, ...]:
    """What a phrase says is to stay; "its stand" is every stand that it could be."""
    if phrase.noun.kind not in ("thing", "number"):
        return ()
    if phrase.noun.det == "my":
        found = tuple(p.id for p in finder.matching(phrase.noun))
        if not found:
            raise finder.nothing(phrase.noun.text)
        return found
    alike = finder.matching(phrase.noun) if phrase.noun.kind == "thing" and not phrase.noun.id else []
    bare = not (phrase.places or phrase.rank or phrase.noun.side or phrase.noun.ordinal or phrase.noun.count)
    if len(alike) > 1 and bare and phrase.noun.definite:
        return tuple(p.id for p in alike)
    return named(finder, phrase, phrase.places)


_DOERS: dict[str, Doer] = {
    "add": _add,
    "ensure": ensure,
    "only": keep_only,
    "gap": space,
    "spread": spread,
    "put": _put,
    "move": _bring,
    "turn": turn,
    "replace": replace,
    "remove": remove,
    "swap": swap,
    "rearrange": rearrange,
    "resite": resite,
    "make": make,
    "free": free,
    "clear": clear,
    "keep": _keep,
}


def _do(work: Work, finder: Finder, order: Order) -> None:
    """Do what an order says: several things go to a formation as one."""
    formed = formation_of(order) if order.doing in ("rearrange", "put", "move") and order.things else None
    if formed is not None:
        form(work, finder, order, formed)
    else:
        _DOERS[order.doing](work, finder, order)
    if order.in_line:
        check_in_line(work, finder.recent)


def _carry_out(work: Work, read: Instruction, past: Past) -> tuple[str, ...]:
    """Do what was read; the ids of what it has named last."""
    finder = Finder(work.scene, past=past, start=work.start)
    orders = in_turn(with_antecedents(joined(read.orders), finder), finder)
    _tell_others(orders, finder)
    kept = [phrase for order in orders if order.doing == "keep" for phrase in order.things]
    moves = all(order.doing in _MOVING for order in orders)
    work.kept = frozenset(
        id
        for phrase in kept
        for id in _kept(finder, phrase)
        if not (moves and (_on_its_carrier(finder, phrase, id) or _marks_of(finder, phrase)))
    )
    if any(order.doing == "keep" and order.rest and _is_of_anything(order) for order in orders):
        work.kept |= {p.id for p in work.scene.placements}
    undone = False
    for number, order in enumerate(orders):
        finder.scene = work.before = work.scene
        work.order = (number, order.text)
        finder.owners, finder.several, finder.named, finder.about = [], [], [], ""
        before, said = work.scene, (len(work.done), len(work.failed))
        if number and undone and _needs(order, orders[number - 1]):
            work.failed.append(f"'{order.text}' was not done, as '{orders[number - 1].text}' was not")
            continue
        try:
            _on_either(order, finder)
            tell_by_load(order, finder)
            _follow(work, finder, order)
            _check_back(order, finder)
            _do(work, finder, order)
        except InputError as error:
            others = ", ".join(f"'{text}'" for text in dict.fromkeys(o.text for o in orders) if text != order.text)
            if not others or type(error) is not InputError:
                raise
            raise InputError(f"{error}; nothing was done, {others} neither") from error
        _hold(work, order, before, said[0])
        undone = work.scene is before and len(work.failed) > said[1]
        gone = [p for p in before.placements if p.id not in work.scene]
        finder.vacated = _largest(gone) if gone else _left(before, work.scene, finder.recent) or finder.vacated
        if said == (len(work.done), len(work.failed)):
            raise InputError(f"'{order.text}': nothing was found in it that could be done")
    work.done += finder.seen
    work.failed[:] = dict.fromkeys(work.failed)
    work.failed += work.unkept()
    return tuple(id for id in finder.recent if id in work.scene)


def _needs(order: Order, last: Order) -> bool:
    """Whether what is taken away is so because of what was put elsewhere before: "instead", "and remove the other"."""
    other = any(phrase.noun.det == "other" or phrase.noun.value == "other" for phrase in order.things)
    moving = last.doing in ("put", "move", "add", "replace")
    return order.doing == "remove" and moving and (other or "instead" in last.text.lower().split())


def _check_back(order: Order, finder: Finder) -> None:
    """Refuse "move it back" after an edit, which could be to where it was.

    Raises:
        InputError: it is that.
    """
    again = bool(order.things) and all(is_that(phrase.noun) for phrase in order.things)
    bare = order.doing in ("move", "put") and order.direction == "back" and not (order.lengths or order.slight)
    if again and bare and not finder.recent and finder.past.about:
        raise InputError(f"'{order.text}': the last edit is taken back with --undo; or say how far back, or to what")


def _largest(gone: Sequence[Placement]) -> Placement:
    """What has left the most room of what is gone, the table of "it and its chairs"; the last of several alike."""
    return max(enumerate(gone), key=lambda each: (round(each[1].size[0] * each[1].size[1], 1), each[0]))[1]


def _left(before: Scene, after: Scene, ids: Sequence[str]) -> Placement | None:
    """Where the one thing that was moved stood: "move the table to the window and put the bench where it was"."""
    moved = [id for id in ids if id in before and id in after and before[id].position != after[id].position]
    return before[moved[0]] if len(moved) == len(ids) == 1 else None


def _on_either(order: Order, finder: Finder) -> None:
    """Read "the lamps on the desk and the sideboard" as those on either, where such things rest on both.

    Raises:
        InputError: none rests on the second, which carries things too and would be taken away with all that it carries.
    """
    for number, (head, other) in enumerate(pairwise(order.things)):
        where, known = head.places[-1] if head.places else None, other.noun
        several = head.noun.kind == "thing" and head.noun.many and not head.noun.count and order.doing in _ON_EITHER
        one = known.kind == "thing" and known.definite and not known.many and not other.id
        if not several or not one or where is None or where.noun is None or where.word not in _RESTING:
            continue
        carriers = {p.support for p in finder.matching(head.noun)}
        if where.noun.kind != "thing" or where.noun.many:
            continue
        there = finder.matching(known)
        if carriers & {p.id for p in there}:
            places = [*head.places[:-1], dataclasses.replace(where, noun=known), *other.places]
            order.things[number + 1] = dataclasses.replace(head, noun=dataclasses.replace(head.noun), places=places)
        elif order.doing == "remove" and any(finder.scene.riders(p.id) for p in there):
            raise InputError(
                f"'{order.text}': {known.text} could be what goes, or where {head.noun.text} are that go; none is"
                " there: say it in two orders"
            )


def _tell_others(orders: Sequence[Order], finder: Finder) -> None:
    """Let "one picture" be one of those that are there, where the others of them are to stay, maybe somewhere."""
    for order, later in pairwise(orders):
        nouns = [phrase.noun for phrase in later.things]
        others = [
            p for p, noun in zip(later.things, nouns, strict=True) if (noun.kind, noun.value) == ("pronoun", "other")
        ]
        if order.doing != "put" or later.doing != "keep" or not others:
            continue
        for phrase in order.things:
            if phrase.noun.kind == "thing" and phrase.noun.count and not phrase.noun.det:
                for other in others:
                    other.noun = dataclasses.replace(phrase.noun, det="all", count=None, plural=True)
                    phrase.spared += [other] if other.places else []
                phrase.noun = dataclasses.replace(phrase.noun, of_known=True)
                if not others[0].places:
                    later.things = []


def _is_of_anything(order: Order) -> bool:
    """Whether it says "don't move anything", of nothing but what is added then."""
    words = order.text.lower().split()
    return "anything" in words and "else" not in words


def _hold(work: Work, order: Order, before: Scene, said: int) -> None:
    """Take an order back that has changed what is to stay as it is, with what was said of it since.

    What rested on something that was taken away stays as far as it can: it is not taken away itself.
    """
    there = {p.id: p for p in work.scene.placements}
    lost = {p.id for p in before.placements if p.id not in there}
    changed = [p.id for p in before.placements if p.id in work.kept and there.get(p.id) != p]
    changed = [id for id in changed if id in lost or not lost & set(before.carriers(id))]
    if changed:
        work.world = work.world.with_scene(before)
        del work.done[said:]
        work.wishes = [wish for wish in work.wishes if wish.order < work.order[0]]
        work.failed.append(f"'{order.text}' was not done: {', '.join(changed)} is to stay as it is")


# --- the outcome


def _finished(
    work: Work, made: _Source, read: Instruction, tolerances: Tolerances | None, about: tuple[str, ...]
) -> Edit:
    scene = _in_order(work.scene, made.scene)
    report = reverify(scene, made.scene, made.report, tolerances=tolerances)
    changes = _changes(made.scene, scene)
    carried = [c.id for c in changes if c.what == "carried"]
    done = [*work.done, *([f"{', '.join(carried)} went along with what carries it"] if carried else [])]
    before = {v.id for v in made.report.objects if not v.valid} if made.report is not None else set()
    old_faults = [v.id for v in report.objects if not v.valid and v.id in before]
    work.notes += left_behind(work)
    work.notes += [*on_floor(work, [c.id for c in changes]), *facing_wall(work, [c.id for c in changes])]
    work.notes += beside_corner(work)
    if old_faults:
        work.notes.append(f"{', '.join(old_faults)} did not pass before the edit either.")
    report = structs.replace(
        report,
        complete=report.valid and not work.failed and not read.unknown,
        unknown=read.unknown,
        stand_ins=plain_things(scene),
        score=score(scene),
        notes=(*done, *(f"Not done: {text}" for text in work.failed), *work.notes, *report.notes),
    )
    plan = made.episode.plan if made.episode is not None else None
    report = carried_over(report, scene, made.scene, made.report, plan)
    episode = made.episode or _begun(made.scene)
    number = 1 + sum(isinstance(line, Edited) for line in episode.edits)
    line = Edited(
        number=number,
        instruction=read.text,
        seed=work.seed,
        before=RoomState.of(made.scene),
        after=RoomState.of(scene),
        rounds=tuple(work.rounds),
        done=tuple(done),
        failed=tuple(work.failed),
        about=about,
    )
    assets = {**episode.assets, **made.scene.assets, **work.assets, **scene.assets}
    episode = structs.replace(episode, assets=assets, edits=(*episode.edits, line))
    said = tuple(done), tuple(work.failed), read.unknown, tuple(work.notes)
    return Edit(scene, report, episode, read.text, changes, *said)


def _begun(scene: Scene) -> Episode:
    """The episode of a room of which it is not known how it came about."""
    plan = Plan(brief=Brief(prompt=scene.prompt))
    return Episode(prompt=scene.prompt, seed=scene.seed, room=scene.room, plan=plan, assets=dict(scene.assets))


def _in_order(scene: Scene, before: Scene) -> Scene:
    """The scene with its objects and assets in the order in which they were before, new ones last."""
    place = {p.id: number for number, p in enumerate(before.placements)}
    placements = tuple(sorted(scene.placements, key=lambda p: place.get(p.id, len(place))))
    kept: dict[str, Asset] = {id: asset for id, asset in before.assets.items() if id in scene.assets}
    same = [p.id for p in placements] == [p.id for p in scene.placements]
    assets = {**kept, **scene.assets}
    if same and list(assets) == list(scene.assets):
        return scene
    return structs.replace(scene, placements=placements, assets=assets)


def _changes(before: Scene, after: Scene) -> tuple[Changed, ...]:
    """What is not as it was, in the order of the scene, what is gone first."""
    there = {p.id: p for p in before.placements}
    found = [Changed(p.id, "removed", p, None) for p in before.placements if p.id not in after]
    for new in after.placements:
        old = there.get(new.id)
        if old != new:
            found.append(Changed(new.id, _what(before, after, old, new), old, new))
    return tuple(found)


def _what(before: Scene, after: Scene, old: Placement | None, new: Placement) -> What:
    if old is None:
        return "added"
    if old.asset != new.asset:
        return "replaced"
    rides = old.support in before and old.support == new.support and before[old.support] != after[old.support]
    if rides:
        return "carried"
    return "moved" if old.position != new.position else "turned"
