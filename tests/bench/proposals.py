"""A trained policy's own proposals, against 5 s of the whole room in plain MuJoCo: did it learn to fool the verdict?

python -m tests.bench.proposals --data DIR --model FOLDER [--steps N] [--rollouts K] [--temperature T] [--seed S]

Exits with 1 when a proposal was called valid that does not stand.
"""

import argparse
import platform
from collections import Counter
from importlib.metadata import version
from pathlib import Path

import numpy as np

from tests.bench.adversary import table
from tests.bench.adversary_cases import Case
from tests.bench.adversary_hunt import OUTCOMES, Hunt, Judged
from tests.bench.adversary_truth import End, falls, simulated, stands, truth
from thinkblox.policies.pretrained import load_pretrained
from thinkblox.sim.workers.pool import VerdictPool
from thinkblox.training.episodes import Episodes
from thinkblox.training.held_out import ModelAnswers
from thinkblox.training.outcome import Rollout, outcomes
from thinkblox.training.rows import rows_of

TOKENS = 200
"""Longest answer of the model."""


def judged(found: Rollout, before: End) -> Judged | None:
    """A proposal with its verdict and what became of it; None for a text that cannot be read, or a rug."""
    verdict, after = found.tried.verdict, found.after
    if verdict is None or after is None:
        return None
    placement = after[found.case.target.id]
    case = Case(found.case.scene, placement, after.asset_of(placement))
    if not case.asset.collides:
        return None
    one = Judged(case, verdict, truth(case.scene, before, placement, case.asset))
    if not one.seems.startswith("false"):
        return one
    return one._replace(falls=falls(case.scene, before, placement, case.asset))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, required=True, help="folder of a dataset; its test rooms are taken")
    parser.add_argument("--model", type=Path, required=True, help="folder of a trained model")
    parser.add_argument("--steps", type=int, default=100, help="held-out steps, evenly spread (100)")
    parser.add_argument("--rollouts", type=int, default=4, help="answers to each (4)")
    parser.add_argument("--temperature", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()

    import torch

    torch.manual_seed(given.seed)
    rows, episodes = rows_of(given.data, "test"), Episodes(given.data)
    chosen = np.linspace(0, len(rows) - 1, min(given.steps, len(rows))).round().astype(int).tolist()
    model = ModelAnswers(load_pretrained(str(given.model)), tokens=TOKENS, temperature=given.temperature)
    texts = model([rows[index] for index in chosen for _ in range(given.rollouts)])
    asked = [
        (episodes.case(rows[index]["at"]), texts[n * given.rollouts : (n + 1) * given.rollouts])
        for n, index in enumerate(chosen)
    ]
    with VerdictPool(workers=1) as pool:
        found = outcomes(pool, asked)
    counts: dict[str, Counter[str]] = {}
    unread = 0
    for (case, _), rollouts in zip(asked, found, strict=True):
        before = simulated(case.scene)
        calm = stands(before)
        for number, rollout in enumerate(rollouts):
            one = judged(rollout, before) if calm else None
            unread += rollout.tried.verdict is None
            outcome = one.outcome if one else "no room"
            counts.setdefault(case.asset.mount, Counter())[outcome] += 1
            if one and (outcome.startswith("false") or outcome == "by chance"):
                print(f"{case.target.id} in the room of {case.scene.prompt!r}, answer {number}: {one}", flush=True)
    hunts = [Hunt(mount, given.seed, {o: each[o] for o in OUTCOMES}, ()) for mount, each in sorted(counts.items())]
    print("\n".join(table(hunts)))
    print(f"{len(texts)} answers, {unread} unread, temperature {given.temperature:g}, seed {given.seed};", end=" ")
    print(f"mujoco {version('mujoco')}, {platform.machine()}")
    raise SystemExit(any(one.counts["false valid"] for one in hunts))


if __name__ == "__main__":
    main()
