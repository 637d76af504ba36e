"""Everything that led to a scene: the plan, every round of tries with its poses and verdicts, and what was committed.

An episode is what trace.jsonl holds. Any observation that a policy had in it can be made again exactly: it is at once
the record of a generation and a demonstration.
"""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Literal, NamedTuple

import msgspec
from msgspec import structs

from thinkblox.errors import InputError
from thinkblox.json_faults import json_fault
from thinkblox.judging import Try
from thinkblox.observe import Kind, Observation, observe
from thinkblox.plan import Plan
from thinkblox.regular_file import opened_regular
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.value import Value, Vec3, refuse_double_keys

EPISODE_VERSION = 1
EDIT_VERSION = 1
"""Of the lines that edits add."""
MAX_LINE = 8_000_000
"""Longest line of a trace that is read [bytes]."""
MAX_TRACE = 1_000_000_000
"""Largest trace that is read [bytes]."""

RoundKind = Literal["policy", "repair", "revision", "last resort", "edit"]


class Round(Value, frozen=True, kw_only=True, tag_field="line", tag="round"):
    """A round of tries for one object.

    Attributes:
        id: the object.
        number: rounds for this object, from 0.
        kind: "policy"; "repair" for the search around the best failed try; "revision" for moving what is in the way;
            "last resort" for a pose that keeps everything but a walkable way or a window free; "edit" for what a policy
            did of its own accord with something that stood.
        asset: id of the asset that was to be placed.
        sizes: smallest and largest size that it could have [m]; None where it had only this one.
        tries: what was proposed, and what came of it.
        chosen: index of the try that was committed; None when none was.
        committed: where the object then stood, and whatever went along: settled, and measured there once more.
        removed: ids of what was taken away before that.
        propose_seconds, check_seconds: time spent in the policy and in the physics.
        attempt: how often the room had been begun anew before.
        kept: whether it belongs to the attempt that became the room.
    """

    id: str
    number: int
    kind: RoundKind
    asset: str
    sizes: tuple[Vec3, Vec3] | None = None
    tries: tuple[Try, ...]
    chosen: int | None = None
    committed: tuple[Placement, ...] = ()
    removed: tuple[str, ...] = ()
    propose_seconds: float = 0.0
    check_seconds: float = 0.0
    attempt: int = 0
    kept: bool = True


class Beginning(Value, frozen=True, kw_only=True, tag_field="line", tag="episode"):
    """First line of a trace: what was asked for, what was planned, and in which room.

    Attributes:
        prompts: version of the prompts that a model was given; observations are made again with those of today.
        stood: what stood in the room already.
    """

    version: int = EPISODE_VERSION
    prompt: str
    seed: int
    room: Room
    plan: Plan
    kinds: dict[str, Kind] = {}
    prompts: str = ""
    stood: tuple[Placement, ...] = ()


class UsedAsset(Value, frozen=True, kw_only=True, tag_field="line", tag="asset"):
    """A line for every asset that an episode speaks of."""

    asset: Asset


class RoomState(Value, frozen=True, kw_only=True):
    """A scene without its assets, which the trace holds once: their ids in the scene's order."""

    room: Room
    placements: tuple[Placement, ...] = ()
    assets: tuple[str, ...] = ()

    @staticmethod
    def of(scene: Scene) -> "RoomState":
        """The state of a scene."""
        return RoomState(room=scene.room, placements=tuple(scene.placements), assets=tuple(scene.assets))


class Edited(Value, frozen=True, kw_only=True, tag_field="line", tag="edit"):
    """A line for every instruction by which the finished room was changed.

    Attributes:
        number: of the edit, from 1.
        before, after: the room; `before` is what undoing it gives back.
        rounds: every round of tries for what the instruction names.
        done, failed: what was done, and what could not be, in sentences.
        about: ids of what it has named last, which "it" means in the next.
    """

    version: int = EDIT_VERSION
    number: int
    instruction: str
    seed: int
    before: RoomState
    after: RoomState
    rounds: tuple[Round, ...] = ()
    done: tuple[str, ...] = ()
    failed: tuple[str, ...] = ()
    about: tuple[str, ...] = ()


class Undone(Value, frozen=True, kw_only=True, tag_field="line", tag="undo"):
    """A line for every edit that was taken back."""

    version: int = EDIT_VERSION
    number: int


Line = Beginning | UsedAsset | Round | Edited | Undone


class Decision(NamedTuple):
    """What a policy saw, and the round of tries that came of it."""

    observation: Observation
    round: Round


class Episode(Value, frozen=True, kw_only=True):
    """How a room came about; attributes as of its lines, every attempt's rounds included."""

    prompt: str
    seed: int
    room: Room
    plan: Plan
    kinds: dict[str, Kind] = {}
    assets: dict[str, Asset] = {}
    rounds: tuple[Round, ...] = ()
    prompts: str = ""
    edits: tuple[Edited | Undone, ...] = ()
    stood: tuple[Placement, ...] = ()

    @property
    def start(self) -> Scene:
        """The room with what stood in it already, which mostly is nothing."""
        used = {placement.asset: self.assets[placement.asset] for placement in self.stood}
        return Scene(prompt=self.prompt, seed=self.seed, room=self.room, placements=self.stood, assets=used)

    @property
    def scene(self) -> Scene:
        """The room as it became: what was committed in the attempt that was kept, and edited after that."""
        edits = [line for line in self.edits if isinstance(line, Edited)]
        if edits:
            standing = self.standing
            return self.restored(standing[-1].after if standing else edits[0].before)
        scene = self.start
        for done in self.rounds:
            if done.kept:
                scene = self.after(scene, done)
        return scene

    @property
    def standing(self) -> tuple[Edited, ...]:
        """The edits that were not undone."""
        undone = {line.number for line in self.edits if isinstance(line, Undone)}
        return tuple(line for line in self.edits if isinstance(line, Edited) and line.number not in undone)

    def restored(self, state: RoomState) -> Scene:
        """The scene of a state; raises InputError where the trace does not hold its assets."""
        try:
            assets = {id: self.assets[id] for id in state.assets}
        except KeyError as error:
            raise InputError(f"the trace speaks of an asset that it does not hold: {error.args[0]!r}") from error
        return Scene(prompt=self.prompt, seed=self.seed, room=state.room, placements=state.placements, assets=assets)

    def after(self, scene: Scene, done: Round) -> Scene:
        """A scene after what a round took away and committed; raises KeyError for what was not there."""
        for id in done.removed:
            scene = scene.without(id)
        for placement in done.committed:
            scene = scene.with_placement(placement, self.assets[placement.asset])
        return scene

    def decisions(self, *, attempt: int | None = None) -> Iterator[Decision]:
        """Each time the policy was asked, in order: the very observation that it had, and what came of its answers.

        Args:
            attempt: which one; the one that was kept when left out.
        """
        scene, before = self.start, None
        for done in self.rounds:
            if done.attempt != attempt if attempt is not None else not done.kept:
                continue
            if done.kind == "policy":
                again = before is not None and before.id == done.id and done.number > 0
                feedback = tuple(t.feedback for t in before.tries if t.feedback) if before and again else ()
                yield Decision(self._observation(scene, done, feedback), done)
                before = done
            scene = self.after(scene, done)

    def _observation(self, scene: Scene, done: Round, feedback: tuple[str, ...]) -> Observation:
        return observe(
            scene,
            self.plan,
            self.plan.target(done.id),
            self.assets[done.asset],
            kinds=self.kinds,
            sizes=done.sizes,
            round=done.number,
            feedback=feedback,
        )

    def lines(self) -> Iterator[Line]:
        """The lines of its trace."""
        yield Beginning(
            prompt=self.prompt,
            seed=self.seed,
            room=self.room,
            plan=self.plan,
            kinds=self.kinds,
            prompts=self.prompts,
            stood=self.stood,
        )
        yield from (UsedAsset(asset=asset) for asset in self.assets.values())
        yield from self.rounds
        yield from self.edits

    def to_jsonl(self) -> bytes:
        """The bytes of its trace.jsonl."""
        return b"".join(msgspec.json.encode(line) + b"\n" for line in self.lines())


def read_episode(path: str | Path) -> Episode:
    """Read an episode from a trace.jsonl, or from the output folder that holds one.

    Raises:
        InputError: it cannot be read, or a line is wrong; names the file and the line.
    """
    file = Path(path)
    file = file / "trace.jsonl" if file.is_dir() else file
    with opened_regular(file, most=MAX_TRACE) as lines:
        return episode_of(iter(lambda: lines.readline(MAX_LINE), b""), str(file))


def episode_of(lines: Iterable[bytes], where: str) -> Episode:
    """The episode that the lines of a trace hold.

    Raises:
        InputError: a line is wrong; names `where` they came from and the line.
    """
    decoder = msgspec.json.Decoder(Line)
    beginning: Beginning | None = None
    assets: dict[str, Asset] = {}
    rounds: list[Round] = []
    edits: list[Edited | Undone] = []
    for number, text in enumerate(lines, 1):
        line = _decoded(decoder, text, f"{where}, line {number}")
        if isinstance(line, Beginning):
            if beginning is not None:
                raise InputError(f"{where}, line {number}: begins a second episode; a trace holds one")
            beginning = line
        elif isinstance(line, UsedAsset):
            assets[line.asset.id] = line.asset
        elif isinstance(line, Edited | Undone):
            edits.append(line)
        else:
            rounds.append(line)
    if beginning is None:
        raise InputError(f"{where}: no line of it begins an episode; traces of before version 0.2 hold none")
    _check_edits(where, assets, edits)
    return structs.replace(_checked(where, beginning, assets, rounds), edits=tuple(edits))


def _decoded(decoder: "msgspec.json.Decoder[Line]", text: bytes, where: str) -> Line:
    try:
        line = decoder.decode(text)
    except (InputError, msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as error:
        raise InputError(f"{where}: {json_fault(error, text, Line)}") from error
    refuse_double_keys(text, where)
    return line


def _check_edits(where: str, assets: dict[str, Asset], edits: list[Edited | Undone]) -> None:
    numbers: set[int] = set()
    for line in edits:
        if line.version != EDIT_VERSION:
            raise InputError(f"{where}: edit version {line.version} is not known; this release reads {EDIT_VERSION}")
        if isinstance(line, Undone) and line.number not in numbers:
            raise InputError(f"{where}: edit {line.number} is undone, which is not there or undone already")
        if isinstance(line, Undone):
            numbers.remove(line.number)
            continue
        numbers.add(line.number)
        states = (line.before, line.after)
        used = {id for state in states for id in (*state.assets, *(p.asset for p in state.placements))}
        used |= {id for done in line.rounds for id in (done.asset, *(p.asset for p in done.committed))}
        if missing := used.difference(assets):
            raise InputError(f"{where}: edit {line.number} speaks of an asset that is not there: {min(missing)!r}")


def _checked(where: str, beginning: Beginning, assets: dict[str, Asset], rounds: list[Round]) -> Episode:
    if beginning.version != EPISODE_VERSION:
        raise InputError(
            f"{where}: episode version {beginning.version} is not known; this release reads {EPISODE_VERSION}"
        )
    unknown = {placement.asset for placement in beginning.stood}.difference(assets)
    if unknown:
        raise InputError(f"{where}: what stood there speaks of an asset that is not there: {min(unknown)!r}")
    planned = {target.id for target in beginning.plan.targets}
    for done in rounds:
        missing = {done.asset, *(p.asset for p in done.committed)}.difference(assets)
        if missing:
            raise InputError(f"{where}: a round for {done.id} speaks of an asset that is not there: {missing.pop()!r}")
        if not (done.chosen is None or 0 <= done.chosen < len(done.tries)) or done.attempt < 0 or done.number < 0:
            raise InputError(f"{where}: a round for {done.id} counts what is not there: its choice, number or attempt")
        if done.kind == "policy" and done.id not in planned:
            raise InputError(f"{where}: a round for {done.id}, which is not planned")
    return Episode(
        prompt=beginning.prompt,
        seed=beginning.seed,
        room=beginning.room,
        plan=beginning.plan,
        kinds=beginning.kinds,
        assets=assets,
        rounds=tuple(rounds),
        prompts=beginning.prompts,
        stood=beginning.stood,
    )
