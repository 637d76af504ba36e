"""Thousands of spoiled files through the verifier, in-process and by command: what becomes of them.

python -m tests.bench.mutations [--count N] [--seed S] [--commands N] [--jobs N] [--limit S] [--only FORMAT]

Every file is one that verifies cleanly with something changed in it. "refused" is status 2, "failed" 1, "passed" 0;
"broken" ended the process, and "over the limit" was stopped; by command, which reads in a process of its own, both are
refused. A fault is anything else: a traceback, a message with control characters in it, a pass of what is not even
well-formed, or of another report where a number is none; a file read or written outside; more than 4 GB of memory.
"""

import argparse
import collections
import json
import os
import platform
import random
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from importlib.metadata import version
from pathlib import Path

from msgspec import structs

from tests.bench.mutation_files import Mutant, Subject, subjects
from tests.bench.mutation_worker import Job, Outcome, Worker

MEMORY = 4 * 2**30
"""What the reading of a file may take [bytes]."""
STARTING = 15.0
"""What a command may take besides its limit [s]."""
STATUS = {0: "passed", 1: "failed", 2: "refused"}
WORKS: tuple[tuple[float, dict[str, object], tuple[str, ...]], ...] = (
    (0.005, {"fix": True, "out": "mended.json"}, ("--fix", "--out", "mended.json")),
    (0.005, {"page": "page.html"}, ("--html", "page.html")),
    (0.005, {"suites": ("molmospaces", "sceneeval")}, ("--suite", "molmospaces,sceneeval")),
)
"""How often what is asked for besides, and how; models can neither be mended nor written."""
COLUMNS = ("refused", "failed", "passed", "broken", "over the limit")


@dataclass
class Tally:
    """What became of the mutants of one format."""

    ends: collections.Counter[str] = field(default_factory=collections.Counter)
    seconds: float = 0.0
    memory: int = 0
    faults: list[str] = field(default_factory=list)
    late: list[str] = field(default_factory=list)

    def count(self, outcome: Outcome) -> None:
        self.ends[outcome.end] += 1
        self.seconds, self.memory = max(self.seconds, outcome.seconds), max(self.memory, outcome.memory)


class Field:
    """One share of the work: copies of the files, and a process in which they are measured."""

    def __init__(self, home: Path, limit: float, only: str | None) -> None:
        every = subjects(home / "files" / "of", home / "files" / "outside")
        self.subjects = [subject for subject in every if only in (None, subject.format)]
        if not self.subjects:
            raise SystemExit(f"no format {only!r}; there are {', '.join(sorted({each.format for each in every}))}")
        self.outside = home / "files" / "outside"
        self.cwd = home / "cwd"
        self.cwd.mkdir()
        self.limit = limit
        self.worker = Worker(home, limit)
        self.whole = [subject.file.read_bytes() for subject in self.subjects]
        self.reports = [self._report(subject) for subject in self.subjects]

    def _report(self, subject: Subject) -> bytes:
        outcome = self.worker.run(Job(subject.opened, subject.reading))
        if outcome.end != "passed":
            raise SystemExit(f"{subject.file} does not verify cleanly: {outcome}")
        return outcome.report

    def mutated(self, seed: int, tallies: dict[str, Tally], *, command: bool) -> None:
        """Spoil one file and see what becomes of it."""
        which = seed % len(self.subjects)
        subject, whole = self.subjects[which], self.whole[which]
        mutant = subject.mutant(whole, seed)
        asked, more = self._asked(subject, seed)
        subject.file.write_bytes(mutant.data)
        try:
            outcome = self.worker.run(Job(subject.opened, structs.replace(subject.reading, **asked)))
            faults = [*outcome.faults, *self._wrong(subject, mutant, outcome, self.reports[which], plain=not asked)]
            tally = tallies[subject.format]
            tally.count(outcome)
            if outcome.end == "over the limit":
                tally.late.append(f"{subject.format} {seed} {subject.file.name} {list(asked)}: over the limit")
            if command:
                by_command = self._by_command(subject, more, outcome.end)
                tallies["by command"].count(by_command)
                faults += by_command.faults
            tally.faults += [f"{subject.format} {seed} {subject.file.name} {list(asked)}: {fault}" for fault in faults]
        finally:
            subject.file.write_bytes(whole)
            for path in list(self.cwd.iterdir()):
                path.unlink()

    def _asked(self, subject: Subject, seed: int) -> tuple[dict[str, object], tuple[str, ...]]:
        roll = random.Random(f"asked {seed}").random()
        for share, asked, arguments in WORKS:
            if roll < share and (subject.is_json or "fix" not in asked):
                return {
                    key: str(self.cwd / value) if isinstance(value, str) else value for key, value in asked.items()
                }, arguments
            roll -= share
        return {}, ()

    def _wrong(self, subject: Subject, mutant: Mutant, outcome: Outcome, report: bytes, *, plain: bool) -> list[str]:
        found = []
        if outcome.memory > MEMORY:
            found.append(f"{outcome.memory / 2**30:.1f} GiB")
        if outcome.end == "passed" and not subject.well_formed(mutant.data):
            found.append("passed, and is not well-formed")
        if plain and outcome.end == "passed" and mutant.numberless and outcome.report != report:
            found.append("passed, with a number that is none")
        return found

    def _by_command(self, subject: Subject, more: Sequence[str], before: str) -> Outcome:
        arguments = [sys.executable, "-m", "thinkblox", "verify", str(subject.opened), "--json", *subject.arguments]
        arguments += [*more, "--timeout", str(self.limit), "--overwrite"]
        begin = time.monotonic()
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as errors:
            with subprocess.Popen(arguments, cwd=self.cwd, stdout=out, stderr=errors) as running:
                _, status, usage = os.wait4(running.pid, 0)
                running.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0)
            errors.seek(0)
            printed, said = out.read(), errors.read().decode(errors="replace")
        seconds, code = time.monotonic() - begin, running.returncode
        end = STATUS.get(code, f"status {code}")
        faults = []
        expected = "refused" if before in ("broken", "over the limit") else before
        if end != expected:
            faults.append(f"by command {end}, in-process {before}: {said[-300:]}")
        if "Traceback" in said or not all(line.isprintable() for line in said.splitlines()):
            faults.append(f"by command said {said[-300:]!r}")
        if code in (0, 1):
            json.loads(printed)
        if seconds > self.limit + STARTING:
            faults.append(f"by command took {seconds:.0f} s")
        return Outcome(end, seconds, usage.ru_maxrss * 1024, faults=tuple(faults))


def shared(home: Path, seeds: Sequence[int], commands: int, limit: float, only: str | None) -> dict[str, Tally]:
    """Work through some seeds; every so many of them by command too."""
    tallies: dict[str, Tally] = collections.defaultdict(Tally)
    place = Field(home, limit, only)
    try:
        for number, seed in enumerate(seeds):
            place.mutated(seed, tallies, command=bool(commands) and number % max(1, len(seeds) // commands) == 0)
            if number % 500 == 499:
                faults = [fault for tally in tallies.values() for fault in tally.faults]
                so_far = [f"{number + 1} of {len(seeds)}", *table(tallies), *faults]
                print("\n".join(so_far), file=sys.stderr, flush=True)
    finally:
        place.worker.end()
    return tallies


def table(tallies: dict[str, Tally]) -> Iterator[str]:
    """The rows, one for each format."""
    ends = "".join(f"{name:>16}" for name in COLUMNS)
    yield f"{'format':12}{'mutants':>9}{ends}{'worst s':>9}{'worst MB':>10}"
    every = Tally()
    for name, tally in sorted(tallies.items(), key=lambda item: (item[0] == "by command", item[0].lower())):
        if name == "by command":
            yield _row("in-process", every)
        else:
            every.ends.update(tally.ends)
            every.seconds, every.memory = max(every.seconds, tally.seconds), max(every.memory, tally.memory)
        yield _row(name, tally)


def _row(name: str, tally: Tally) -> str:
    ends = "".join(f"{tally.ends[column]:16d}" for column in COLUMNS)
    return f"{name:12}{tally.ends.total():9d}{ends}{tally.seconds:9.1f}{tally.memory / 2**20:10.0f}"


def main(argv: Sequence[str] | None = None) -> int:
    """Print the table and every fault; status 1 when there is one."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--commands", type=int, default=40, help="so many of them by command too")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--limit", type=float, default=60.0, help="what one may take [s]")
    parser.add_argument("--only", metavar="FORMAT", help="files of one format")
    arguments = parser.parse_args(argv)
    seeds = range(arguments.seed * 10**8, arguments.seed * 10**8 + arguments.count)
    tallies: dict[str, Tally] = collections.defaultdict(Tally)
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(arguments.jobs) as pool:
        done = [
            pool.submit(
                shared,
                Path(scratch) / str(job),
                seeds[job :: arguments.jobs],
                arguments.commands // arguments.jobs,
                arguments.limit,
                arguments.only,
            )
            for job in range(arguments.jobs)
        ]
        for each in done:
            for name, tally in each.result().items():
                tallies[name].ends.update(tally.ends)
                tallies[name].seconds = max(tallies[name].seconds, tally.seconds)
                tallies[name].memory = max(tallies[name].memory, tally.memory)
                tallies[name].faults += tally.faults
                tallies[name].late += tally.late
    print("\n".join(table(tallies)))
    faults = [fault for tally in tallies.values() for fault in tally.faults]
    print(f"{len(faults)} faults; {time.monotonic() - begin:.0f} s")
    print("\n".join([*faults, *(late for tally in tallies.values() for late in tally.late)]))
    print(
        f"python {platform.python_version()}, mujoco {version('mujoco')}, {platform.machine()}, {os.cpu_count()} cores"
    )
    return 1 if faults else 0


if __name__ == "__main__":
    raise SystemExit(main())
