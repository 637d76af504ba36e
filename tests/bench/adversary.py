"""A search that tries to fool the verdict, against 5 s of the whole room in plain MuJoCo.

python -m tests.bench.adversary [--candidates N] [--seed S] [--jobs N] [--only FAMILY[:SEED]]

Exits with 1 when a candidate was called valid that does not stand. Ctrl-C ends the search, and what was found is told.
"""

import argparse
import contextlib
import multiprocessing
import platform
import signal
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from importlib.metadata import version

from tests.bench.adversary_cases import FAMILIES
from tests.bench.adversary_hunt import OUTCOMES, TRIES, Hunt, hunt

SHOWN = 12
"""False verdicts of each family that are printed."""


def plan(candidates: int, seed: int, only: str) -> list[tuple[str, int]]:
    """The hunts for about so many candidates, family by family in turn."""
    family, _, number = only.partition(":")
    if number:
        return [(family, int(number))]
    families = [family] if family else list(FAMILIES)
    hunts = max(1, round(candidates / TRIES))
    return [(families[i % len(families)], seed + i // len(families)) for i in range(hunts)]


def run(hunts: Iterable[tuple[str, int]], jobs: int) -> Iterator[Hunt]:
    """What the hunts find, in their order."""
    if jobs == 1:
        yield from (hunt(*one) for one in hunts)
        return
    with multiprocessing.get_context("spawn").Pool(jobs, _leave_stops_to_the_parent) as pool:
        yield from pool.imap(_hunt, hunts)


def _leave_stops_to_the_parent() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _hunt(one: tuple[str, int]) -> Hunt:
    return hunt(*one)


def table(found: list[Hunt]) -> list[str]:
    """Candidates by family and outcome, and all together."""
    lines = [f"{'family':12s}" + "".join(f"{outcome:>15s}" for outcome in OUTCOMES)]
    total: Counter[str] = Counter()
    for family in dict.fromkeys(one.family for one in found):
        counts: Counter[str] = Counter()
        for one in found:
            if one.family == family:
                counts.update(one.counts)
        total.update(counts)
        lines.append(_row(family, counts))
    judged = sum(total[outcome] for outcome in OUTCOMES[:5])
    share = total["false invalid"] / max(1, judged)
    said = f"{judged} judged: {total['false valid']} false valid, {total['false invalid']} false invalid ({share:.2%})"
    return [*lines, _row("all", total), said]


def _row(name: str, counts: Counter[str]) -> str:
    return f"{name:12s}" + "".join(f"{counts[outcome]:15d}" for outcome in OUTCOMES)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--candidates", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", default="", help="one family, or one hunt of it, as FAMILY:SEED")
    arguments = parser.parse_args()
    begun, found, shown = time.perf_counter(), [], Counter[tuple[str, str]]()
    with contextlib.suppress(KeyboardInterrupt):
        for one in run(plan(arguments.candidates, arguments.seed, arguments.only), arguments.jobs):
            found.append(one)
            for line in one.false:
                kind = (one.family, line.split(" ", 1)[1].partition(":")[0])
                shown[kind] += 1
                if shown[kind] <= SHOWN:
                    print(line, flush=True)
    print("\n".join(table(found)))
    print(f"{time.perf_counter() - begun:.0f} s; mujoco {version('mujoco')}, {platform.machine()}")
    raise SystemExit(any(one.counts["false valid"] for one in found))


if __name__ == "__main__":
    main()
