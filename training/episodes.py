"""The episodes of a dataset: from a row back to the scene in which its decision was made."""

import gzip
from collections import OrderedDict
from itertools import pairwise
from pathlib import Path

from thinkblox.episode import Decision, Episode, episode_of
from thinkblox.errors import InputError
from thinkblox.judging import asset_for
from thinkblox.training.demonstration import scene_of
from thinkblox.training.outcome import Asked
from thinkblox.training.shard import episodes_file

_BEGINS = b'{"line":"episode"'
_KEPT = 256
"""Episodes that are kept at hand."""


class Episodes:
    """Reads the episodes of a dataset as they are needed."""

    def __init__(self, folder: str | Path) -> None:
        self._folder = Path(folder)
        self._lines: OrderedDict[int, list[list[bytes]]] = OrderedDict()
        self._cases: OrderedDict[tuple[int, int], dict[int, Asked]] = OrderedDict()

    def case(self, at: str) -> Asked:
        """What was asked at a decision, "shard/episode/decision".

        Raises:
            InputError: there is no such decision.
        """
        shard, line, decision = self._place(at)
        cases = self._cases.get((shard, line))
        if cases is None:
            cases = self._cases[shard, line] = _cases(self._episode(shard, line))
            if len(self._cases) > _KEPT:
                self._cases.popitem(last=False)
        if decision not in cases:
            raise InputError(f"{self._folder}: row {at}: its episode has no decision {decision}")
        return cases[decision]

    def _place(self, at: str) -> tuple[int, int, int]:
        try:
            shard, episode, decision = (int(part) for part in at.split("/"))
        except ValueError as error:
            raise InputError(f"{self._folder}: {at!r} is no place of an episode: shard/episode/decision") from error
        return shard, episode, decision

    def _episode(self, shard: int, line: int) -> Episode:
        if shard not in self._lines:
            self._lines[shard] = self._read(shard)
            if len(self._lines) > _KEPT:
                self._lines.popitem(last=False)
        lines = self._lines[shard]
        if not 0 <= line < len(lines):
            raise InputError(f"{self._folder / episodes_file(shard)}: has no episode {line + 1}")
        return episode_of(lines[line], f"{self._folder / episodes_file(shard)}, episode {line + 1}")

    def _read(self, shard: int) -> list[list[bytes]]:
        file = self._folder / episodes_file(shard)
        try:
            lines = gzip.decompress(file.read_bytes()).splitlines()
        except (OSError, EOFError) as error:
            raise InputError(f"{file}: cannot be read: {error}") from error
        starts = [number for number, text in enumerate(lines) if text.startswith(_BEGINS)]
        return [lines[start:end] for start, end in pairwise([*starts, len(lines)])]


def case_of(episode: Episode, decision: Decision) -> Asked:
    """What was asked at a decision of an episode."""
    target = episode.plan.target(decision.round.id)
    scene = scene_of(decision)
    return Asked(scene, target, episode.assets.get(decision.round.asset) or asset_for(target, scene))


def _cases(episode: Episode) -> dict[int, Asked]:
    return {number: case_of(episode, decision) for number, decision in enumerate(episode.decisions())}
