"""One hunt: random candidates of one family, and then changes to the most promising of them."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tests.bench.adversary_cases import FAMILIES, Case
from tests.bench.adversary_things import GENES, Genes
from tests.bench.adversary_truth import RUNS, End, Truth, falls, simulated, stands, truth
from thinkblox.errors import InputError
from thinkblox.scene.scene import Scene
from thinkblox.sim.verdict.world import World
from thinkblox.verdict import Reason, Verdict

CLEAR = 0.1
"""By which share of a tolerance a measure must be beyond it, or within it, to tell anything."""
SELDOM = 0.1
"""Most of the nearly equal runs in which something may fall that is called valid, for chance to be the reason."""
RANDOM, TRIES = 10, 24
"""Random candidates of a hunt, and all of its candidates."""
LETTING_GO: frozenset[Reason] = frozenset(
    {"collision", "unsupported", "drift", "drop", "tilt", "restless", "pushes", "unstable"}
)
"""Reasons that 5 s of simulation can confirm; the others are geometry."""
OUTCOMES = ("agree", "at the line", "by chance", "false valid", "false invalid", "other reasons", "no room")


class Judged(NamedTuple):
    """A candidate, the verdict on it and what became of it.

    `falls` says in how many of RUNS nearly equal runs it does not stand, where the verdict seems false.
    """

    case: Case
    verdict: Verdict
    truth: Truth
    falls: int | None = None

    @property
    def outcome(self) -> str:
        """One of OUTCOMES; "by chance" is invalid that falls now and then, and valid that seldom falls."""
        seems = self.seems
        if seems == "false invalid" and self.falls:
            return "by chance"
        if seems == "false valid" and self.falls is not None and self.falls <= RUNS * SELDOM:
            return "by chance"
        return seems

    @property
    def seems(self) -> str:
        """The outcome by one run."""
        fell, held = self.truth.share > 1.0 + CLEAR, self.truth.share < 1.0 - CLEAR
        if self.verdict.valid:
            return "false valid" if fell else ("agree" if held else "at the line")
        if not set(self.verdict.reasons) <= LETTING_GO:
            return "other reasons"
        if fell or self.truth.first > 1.0 + CLEAR or self.truth.stir > 1.0 + CLEAR:
            return "agree"
        return "false invalid" if held and max(self.truth.first, self.truth.stir) < 1.0 - CLEAR else "at the line"

    @property
    def promise(self) -> float:
        """How near to a false valid, or to a false invalid, it is; larger is nearer."""
        if self.verdict.valid:
            return min(self.truth.share, 1e3)
        return -max(self.truth.share, self.truth.first) if set(self.verdict.reasons) <= LETTING_GO else -1e6

    def __str__(self) -> str:
        """The verdict and the truth."""
        rest = "" if self.verdict.rest is None else f", rest {self.verdict.rest:.2f} s"
        measured = f"drift {1000 * self.verdict.drift:.2f} mm, drop {1000 * self.verdict.drop:.2f} mm"
        said = f"{self.verdict} ({measured}, tilt {self.verdict.tilt:.2f}{rest})"
        again = "" if self.falls is None else f"; falls in {self.falls} of {RUNS} runs"
        return f"{self.outcome}: {said}; in 5 s: {self.truth.what}, {self.truth.share:.2f} of what is tolerated{again}"


class Hunt(NamedTuple):
    """What one hunt found: how often each outcome, and what was false, in words."""

    family: str
    seed: int
    counts: dict[str, int]
    false: tuple[str, ...]


def hunt(family: str, seed: int) -> Hunt:
    """Try to fool the verdict; even seeds look for false valid, odd ones for false invalid."""
    counts, false = dict.fromkeys(OUTCOMES, 0), []
    for number, judged in enumerate(candidates(family, seed)):
        outcome = "no room" if judged is None else judged.outcome
        counts[outcome] += 1
        if outcome.startswith("false") or outcome == "by chance":
            false.append(f"{family}:{seed}:{number} {judged}")
    return Hunt(family, seed, counts, tuple(false))


def candidates(family: str, seed: int) -> Iterator[Judged | None]:
    """Every candidate of a hunt in its order; None where the room does not stand, or cannot be built."""
    rng = np.random.default_rng([seed, *family.encode()])
    wanted, rooms = seed % 2 == 0, _Rooms()
    best, most = rng.random(GENES), -np.inf
    for number in range(TRIES):
        genome = rng.random(GENES) if number < RANDOM else _changed(best, rng)
        judged = _judged(family, genome, rooms)
        yield judged
        if judged is not None and judged.verdict.valid == wanted and judged.promise > most:
            best, most = genome, judged.promise


class _Rooms:
    """What becomes of the room without the candidate; the last one is kept, as many candidates are for one room."""

    def __init__(self) -> None:
        self._scene: Scene | None = None
        self._end: End | None = None

    def end(self, scene: Scene) -> End:
        if self._end is None or scene != self._scene:
            self._scene, self._end = scene, simulated(scene)
        return self._end


def _judged(family: str, genome: NDArray[np.float64], rooms: _Rooms) -> Judged | None:
    try:
        case = FAMILIES[family](Genes(genome))
        before = rooms.end(case.scene)
        if not stands(before):
            return None
        verdict = World(case.scene).check([case.placement], case.asset, way=False)[0]
    except InputError:
        return None
    judged = Judged(case, verdict, truth(case.scene, before, case.placement, case.asset))
    if not judged.seems.startswith("false"):
        return judged
    return judged._replace(falls=falls(case.scene, before, case.placement, case.asset))


def _changed(genome: NDArray[np.float64], rng: np.random.Generator) -> NDArray[np.float64]:
    """A few of the first numbers drawn anew or moved a little."""
    values = genome.copy()
    for index in rng.integers(0, GENES // 3, int(rng.integers(1, 5))):
        values[index] = rng.random() if rng.random() < 0.3 else np.clip(values[index] + rng.normal(0.0, 0.05), 0.0, 1.0)
    return values
