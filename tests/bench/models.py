"""What a model's answers cost: candidates, what is kept from step to step, and steps against a whole room at once.

python -m tests.bench.models [--hidden N --layers N] [--size PIXELS] [--step N] [--device cpu|cuda] [TABLE ...]

The model is random and its answers are as long as the expert's: what counts is how much is computed. CPU seconds of one
thread, or wall seconds on a GPU; compare them within one run alone.
"""

import argparse
import platform
import tempfile
import time
from collections.abc import Callable
from importlib.metadata import version

import numpy as np

from thinkblox.chat import Chat
from thinkblox.furnishing import Generation
from thinkblox.generate import generate_room
from thinkblox.observe import Sight, observe
from thinkblox.policies.hf import HfModel
from thinkblox.policies.pretrained import Pretrained, load_pretrained
from thinkblox.policies.tiny import TinySize, build_tiny
from thinkblox.scene.scene import Scene

PROMPT = (
    "A classroom, 8 m by 9 m, with twelve school desks in three rows facing a whiteboard, a chair at each of them, a "
    "teacher's desk with a chair and a computer, a bookshelf and a globe on it."
)
TABLES = ("candidates", "prefix", "modes")


def steps(made: Generation, sight: Sight) -> list[tuple[Chat, str]]:
    """What a policy is shown at every step of a finished room, and the expert's answer to it."""
    said = {r.id: r.tries[r.chosen].text for r in made.trace if r.kept and r.chosen is not None}
    targets = {target.id: target for target in made.plan.targets}
    scene, found = Scene(prompt=made.scene.prompt, room=made.scene.room), []
    for placement in made.scene.placements:
        asset = made.scene.asset_of(placement)
        seen = observe(scene, made.plan, targets[placement.id], asset, kinds=made.episode.kinds)
        found.append((seen.chat(sight), said[placement.id]))
        scene = scene.with_placement(placement, asset)
    return found


class Bench:
    """One model, whose answers are as long as is said."""

    def __init__(self, read: Pretrained) -> None:
        self._read = read
        on_gpu = read.model.device.type == "cuda"
        self._clock: Callable[[], float] = time.perf_counter if on_gpu else time.process_time

    def tokens(self, text: str) -> int:
        """How long a text is."""
        return len(self._read.processor.tokenizer(text)["input_ids"])

    def model(self, length: int, *, reuse: bool = True) -> HfModel:
        """The model, with answers of a length."""
        made = HfModel(self._read, max_new_tokens=length, temperature=1.0, reuse_prefix=reuse, seconds=1e6)
        made._decoder._ends = frozenset()  # random weights may end a turn at any time
        return made

    def seconds(self, model: HfModel, chat: Chat, n: int = 1) -> float:
        """One answer's time [s]."""
        start = self._clock()
        model.answer(chat, n, np.random.default_rng(0))
        return self._clock() - start

    def best(self, run: Callable[[], float], times: int = 5) -> float:
        """The least of some."""
        return min(run() for _ in range(times))


def candidates(bench: Bench, chat: Chat, length: int) -> None:
    """Print what n candidates cost."""
    print(f"candidates for one chat, {length} tokens each")
    one = 0.0
    for n in (1, 2, 4, 8, 16):
        taken = bench.best(lambda n=n: bench.seconds(bench.model(length), chat, n))  # type: ignore[misc]
        one = one or taken
        print(f"  n = {n:2}  {taken:8.3f} s  {taken / one:5.2f} times one")


def prefix(bench: Bench, before: Chat, chat: Chat, length: int) -> None:
    """Print what a step costs with and without what was kept of the one before."""

    def step(length: int, reuse: bool) -> float:
        model = bench.model(length, reuse=reuse)
        bench.seconds(model, before)
        return bench.seconds(model, chat)

    model = bench.model(1)
    bench.seconds(model, before)
    first = model.counts.prompt
    bench.seconds(model, chat)
    print(f"a step of {model.counts.prompt - first} tokens, {model.counts.reused} of them as in the step before")
    for name, tokens in (("up to the first token of the answer", 1), (f"whole, {length} tokens answered", length)):
        kept, anew = (bench.best(lambda r=r: step(tokens, r)) for r in (True, False))  # type: ignore[misc] # noqa: B023
        print(f"  {name:40} {kept:8.3f} s kept  {anew:8.3f} s anew  {kept / anew:5.2f}")


def modes(bench: Bench, shown: list[tuple[Chat, str]]) -> None:
    """Print steps against a whole room at once, with the same objects and answers of the same lengths."""
    print(
        f"{len(shown)} objects: a room in steps, and at once (the first step's text, all answers one after the other)"
    )
    lengths = [bench.tokens(answer) for _, answer in shown]
    rows: list[tuple[str, int, int, float]] = []
    for name, reuse in (("in steps, kept", True), ("in steps, anew", False)):
        model, taken = bench.model(1, reuse=reuse), 0.0
        read = written = 0
        kept = model._decoder._kept
        for (chat, _), length in zip(shown, lengths, strict=True):
            step = bench.model(length, reuse=reuse)
            step._decoder._kept = kept
            taken += bench.seconds(step, chat)
            kept = step._decoder._kept
            read += step.counts.prompt - step.counts.reused
            written += step.counts.made
        rows.append((name, read, written, taken))
    model = bench.model(sum(lengths))
    taken = bench.seconds(model, shown[0][0])
    rows.append(("at once", model.counts.prompt, model.counts.made, taken))
    print("                        read   written      [s]  times at once")
    for name, read, written, seconds in rows:
        print(f"  {name:18} {read:8} {written:8} {seconds:9.2f} {seconds / taken:8.2f}")


def main() -> int:
    """Print the tables."""
    import torch

    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("tables", nargs="*", help=f"of {', '.join(TABLES)}; all when none is named")
    parser.add_argument("--hidden", type=int, default=TinySize().hidden)
    parser.add_argument("--layers", type=int, default=TinySize().layers)
    parser.add_argument("--size", type=int, default=0, help="pixels of a picture; none when 0")
    parser.add_argument("--step", type=int, default=20)
    parser.add_argument("--device", default="cpu")
    options = parser.parse_args()
    torch.set_num_threads(1)
    size = TinySize(hidden=options.hidden, layers=options.layers, heads=max(2, options.hidden // 64 * 2))
    made = generate_room(PROMPT, fill="named")
    sight = Sight(size=options.size) if options.size else Sight(pictures=False)
    shown = steps(made, sight)
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(load_pretrained(build_tiny(folder, size=size), device=options.device))
    count = sum(p.numel() for p in bench._read.model.parameters())
    print(f"{count / 1e6:.2f} M parameters, {len(shown)} objects, pictures of {options.size} pixels")
    (before, _), (chat, answer) = shown[options.step - 2], shown[options.step - 1]
    length = bench.tokens(answer)
    tables = options.tables or TABLES
    if "candidates" in tables:
        candidates(bench, chat, length)
    if "prefix" in tables:
        prefix(bench, before, chat, length)
    if "modes" in tables:
        modes(bench, shown[: options.step])
    print(f"python {platform.python_version()}, torch {version('torch')}, transformers {version('transformers')}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
