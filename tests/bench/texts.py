"""The longest that a text of each kind takes to be read, in CPU time: answers of a policy, and prompts.

With --generated, that many answers by chance are read too: none may raise, all that are steps are read as such, and
every other is rejected with a reason.

python -m tests.bench.texts [--times N] [--generated N]
"""

import argparse
import contextlib
import platform
import time
from collections import Counter
from collections.abc import Callable, Iterator
from importlib.metadata import version
from pathlib import Path

from tests.generated_texts import generated
from thinkblox.errors import InputError
from thinkblox.phrases import constraints, planned_constraints
from thinkblox.reading import read_brief
from thinkblox.steps import MAX_TEXT, Rejection, Step, parse

ANSWER = '<answer>{"id": "chair_1", "position": [1.0, 2.0, 0.0], "yaw": 90.0, "size": [0.5, 0.5, 0.9]}</answer>'
ROOM = MAX_TEXT - len(f"<think></think>{ANSWER}")
PHRASES = (
    "turned to 90 degrees, ", "0.30 m above desk_1, ", "at (1.000, 2.000), ", "between table_1 and table_2, ",
    "facing window_1, ", "on table_1, ", "0.25 m from the north wall, ", "left of chair_1, ", "in front of table_1, ",
)  # fmt: skip
TORN = (
    "turned to ", "at (", "between ", "facing ", "9", "-", ".", "9.", "1e9", "chair_", "_", "0.3 m ", "above the ",
    "a", "A_1 ", "between a_1 and ", "at (1, ", "\n", " ", "\u00e9", "\U0001f600", '"', "\\", "[", "{", "<", "</think>",
)  # fmt: skip
NASTY = ("9" * 4000, "_" * 4000, "a" * 4000, "1." * 2000, "-" * 4000)
STRUCTURES: dict[str, str] = {
    "tags": "</think><answer>" * (MAX_TEXT // 16),
    "opened tags": "<think>" * (MAX_TEXT // 7),
    "deep lists": f"<think></think><answer>{'[' * ROOM}</answer>",
    "deep objects": f"<think></think><answer>{('{' + chr(34) + 'a' + chr(34) + ':') * (ROOM // 5)}</answer>",
    "many keys": "<think></think><answer>{" + ",".join(f'"k{n}":1' for n in range(ROOM // 10)) + "}</answer>",
    "one long number": f'<think></think><answer>{{"id": "a", "yaw": {"9" * ROOM}}}</answer>',
    "one long id": f'<think></think><answer>{{"id": "{"a" * ROOM}"}}</answer>',
    "many attributes": '<think></think><answer>{"id": "a", "attributes": [' + "1," * (ROOM // 3) + "1]}</answer>",
    "escapes": '<think></think><answer>{"id": "' + "\\u0041" * (ROOM // 6) + '"}</answer>',
}
PROSE = (
    "The room is calm and bright. ", "There is a double bed against the long wall, with a nightstand on each side. ",
    "Beside the window stands a desk with a lamp and an office chair in front of it. ", "It feels like home. ",
    "Three bookcases line the wall opposite the door, and a rug lies in front of the sofa. ",
)  # fmt: skip
LONG = 20_000
"""Characters of a prompt."""


def answers() -> Iterator[tuple[str, str]]:
    """Texts of a policy of the greatest length, by kind."""
    for piece in (*PHRASES, *TORN):
        said = piece * (ROOM // len(piece))
        yield f"{piece.strip()[:24] or ascii(piece)} ...", f"<think>{said}</think>{ANSWER}"
    for start in ("turned to ", "at (", "at (1, ", "between ", "facing ", ""):
        for tail in NASTY:
            said = (start + tail + " ") * (ROOM // (len(start) + len(tail) + 1))
            yield f"{start}{tail[:4]} x {len(tail)} ...", f"<think>{said}</think>{ANSWER}"
    yield from STRUCTURES.items()


def prompts() -> Iterator[tuple[str, str]]:
    """Prompts of 20 kB, by kind."""
    yield "prose", ("".join(PROSE) * LONG)[:LONG]
    ordinary = Path(__file__).with_name("prompts.txt").read_text().split("\n")
    yield "prompts one after the other", (" ".join(ordinary) * 20)[:LONG]
    for piece in ("a chair left of ", "a table with ", "two chairs and ", "9", "chair ", "of the ", "not ", ", ", "x"):
        yield f"{piece.strip()} ...", (piece * LONG)[:LONG]


def seconds(read: Callable[[str], object], text: str, times: int) -> float:
    """CPU time of one reading, the least of some [s]."""
    found = []
    for _ in range(times):
        begin = time.process_time()
        read(text)
        found.append(time.process_time() - begin)
    return min(found)


def _brief(text: str) -> None:
    with contextlib.suppress(InputError):
        read_brief(text)


def _parsed(text: str) -> object:
    return parse(text)


def _planned(text: str) -> object:
    """Of what a step says, or of the whole text where it is no step."""
    read = parse(text)
    return planned_constraints(read) if isinstance(read, Step) else constraints(text)


def table(name: str, read: Callable[[str], object], texts: dict[str, str], times: int) -> None:
    """Print the five kinds of text that take longest."""
    rows = sorted(((seconds(read, text, times), kind) for kind, text in texts.items()), reverse=True)
    print(f"{name}: {len(rows)} kinds of text of up to {max(map(len, texts.values()))} characters")
    for taken, kind in rows[:5]:
        print(f"{taken * 1000:10.1f}  {kind}")


def outcomes(count: int, seed: int = 0) -> Counter[tuple[str, str]]:
    """How many generated texts of each sort were read as what; raises AssertionError where one was read wrongly."""
    found: Counter[tuple[str, str]] = Counter()
    for sort, text, is_step in generated(count, seed):
        read = parse(text)
        assert isinstance(read, Step) == is_step, (sort, text[:500], read)
        assert isinstance(read, Step) or read.message, (sort, text[:500])
        found[sort, read.reason if isinstance(read, Rejection) else "step"] += 1
    return found


def main() -> int:
    """Print the worst of each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--times", type=int, default=3)
    parser.add_argument("--generated", metavar="N", type=int, default=0)
    arguments = parser.parse_args()
    if arguments.generated:
        start = time.process_time()
        found = outcomes(arguments.generated)
        taken = time.process_time() - start
        print(f"{arguments.generated} generated answers in {taken:.1f} s of CPU, by sort and outcome")
        for (sort, outcome), number in sorted(found.items()):
            print(f"{number:10d}  {sort}: {outcome}")
    print("CPU time [ms], worst kinds of text first")
    table("parse", _parsed, dict(answers()), arguments.times)
    table("parse and planned_constraints", _planned, dict(answers()), arguments.times)
    _brief("A room with a chair.")
    table("read_brief", _brief, dict(prompts()), 1)
    print(f"python {platform.python_version()}, msgspec {version('msgspec')}, {platform.machine()}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
