"""What came of training runs, as tables in Markdown and as curves, from what the runs and the scoring left behind.

A folder of results has, for each run, a folder of its name with `config.json` and `trainer_state.json` as the trainers
write them, and `scores.json` as `thinkblox train score` writes it.
"""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import msgspec

from thinkblox.errors import InputError
from thinkblox.training.curves import Panel, Points, draw
from thinkblox.training.held_out import Score
from thinkblox.value import Value
from thinkblox.whole_file import write_whole

SCORES, STATE, CONFIG = "scores.json", "trainer_state.json", "config.json"
LOSS = {"loss": "loss on the completion", "mean_token_accuracy": "share of tokens that are the likeliest"}
REWARD = {
    "share/valid": "share of valid rollouts",
    "share/parsed": "share of rollouts that can be read",
    "rewards/coll/mean": "R_coll",
    "rewards/layout/mean": "R_layout",
    "rewards/rules/mean": "relations that hold",
    "rewards/cons/mean": "R_cons",
    "kl": "divergence from the start",
    "completions/mean_length": "tokens of an answer",
}
"""What of a log is drawn, and how it is called."""
BEGIN, END = "<!-- made by thinkblox train report -->", "<!-- end of what is made -->"
"""Between these lines of a document the tables are put."""
_SETTINGS = ("scheme", "hard", "seed", "steps", "batch", "prompts", "rollouts", "learning_rate", "beta", "temperature")


class ScoredAnswers(Value, frozen=True, kw_only=True):
    """How somebody's answers to held-out steps scored.

    Attributes:
        who: as the table calls it.
        data: rows, in words.
        score: what was measured.
    """

    who: str
    data: str
    score: Score


class RunLog(NamedTuple):
    """What a run left behind: its settings, and its log, a line for each some steps."""

    name: str
    config: dict[str, Any]
    history: list[dict[str, Any]]

    def points(self, key: str) -> list[tuple[float, float]]:
        """The steps and values of one quantity."""
        return [(float(line["step"]), float(line[key])) for line in self.history if line.get(key) is not None]


def read_run(folder: Path) -> RunLog:
    """Read what a run left in its folder.

    Raises:
        InputError: a file is not there or is none of a trainer.
    """
    found: list[Any] = []
    for name in (CONFIG, STATE):
        try:
            found.append(json.loads((folder / name).read_bytes()))
        except (OSError, ValueError) as error:
            raise InputError(f"{folder / name}: cannot be read: {error}") from error
    history = found[1].get("log_history") if isinstance(found[1], dict) else None
    if not isinstance(history, list):
        raise InputError(f"{folder / STATE}: has no log_history; a trainer writes it")
    return RunLog(folder.name, found[0], history)


def read_scores(file: Path) -> list[ScoredAnswers]:
    """The scores of a file; none where there is no file yet.

    Raises:
        InputError: it holds something else.
    """
    if not file.exists():
        return []
    try:
        return msgspec.json.decode(file.read_bytes(), type=list[ScoredAnswers])
    except msgspec.MsgspecError as error:
        raise InputError(f"{file}: holds no scores: {error}") from error


def add_score(file: Path, scored: ScoredAnswers) -> None:
    """Put a score into a file, in the place of an older one of the same name on the same rows."""
    kept = [old for old in read_scores(file) if (old.who, old.data) != (scored.who, scored.data)]
    file.parent.mkdir(parents=True, exist_ok=True)
    write_whole(file, msgspec.json.format(msgspec.json.encode([*kept, scored]), indent=1) + b"\n")


def report(results: Path, pictures: Path) -> str:
    """The tables of a folder of results, as Markdown; the curves are written to `pictures`, loss.png and reward.png.

    Raises:
        InputError: as `read_run` and `read_scores`, or the folder holds nothing of either.
    """
    runs = [read_run(file.parent) for file in sorted(results.glob(f"*/{STATE}"))]
    scores = read_scores(results / SCORES)
    if not runs and not scores:
        raise InputError(f"{results}: holds no results: no NAME/{STATE} of a run, and no {SCORES}")
    parts = []
    if scores:
        parts += [_table_of_scores(scores), _table_of_kinds(scores)]
    if runs:
        parts.append(_table_of_runs(runs))
    pictures.mkdir(parents=True, exist_ok=True)
    for file, wanted in (("loss.png", LOSS), ("reward.png", REWARD)):
        panels = _panels(runs, wanted, supervised=wanted is LOSS)
        if panels:
            draw(panels).save(pictures / file)
    return "\n".join(parts)


def write_between(file: Path, made: str) -> None:
    """Put what is made into a file between its two marks; a file that is not there is made.

    Raises:
        InputError: the file has not both marks, once each and in order.
    """
    text = file.read_text(encoding="utf-8") if file.exists() else f"# Results\n\n{BEGIN}\n{END}\n"
    if text.count(BEGIN) != 1 or text.count(END) != 1 or text.index(BEGIN) > text.index(END):
        raise InputError(f"{file}: has no place for the tables; it needs the lines {BEGIN} and {END}")
    before, rest = text.split(BEGIN)
    write_whole(file, f"{before}{BEGIN}\n\n{made}\n{END}{rest.split(END)[1]}".encode())


def _panels(runs: list[RunLog], wanted: Mapping[str, str], *, supervised: bool) -> list[Panel]:
    chosen = [run for run in runs if ("scheme" not in run.config) == supervised]
    panels = []
    for key, title in wanted.items():
        lines: dict[str, Points] = {run.name: run.points(key) for run in chosen if run.points(key)}
        if lines:
            panels.append(Panel(title, lines))
    return panels


def _table_of_scores(scores: list[ScoredAnswers]) -> str:
    head = ("who", "rows", "read", "free", "inside", "valid", "hard", "soft", "cons", "mean of tiers")
    rows = []
    for each in scores:
        s = each.score
        shares = [f"{100 * share:.1f}" for share in (s.parsed, s.free, s.inside, s.valid)]
        tiers = [s.hard, s.soft, s.cons]
        means = [f"{value:.3f}" for value in (*tiers, sum(tiers) / len(tiers))]
        rows.append((each.who, f"{s.steps} {each.data}", *shares, *means))
    return table(head, rows)


def _table_of_kinds(scores: list[ScoredAnswers]) -> str:
    mounts = sorted({mount for each in scores for mount in each.score.by_mount})
    rows = []
    for each in scores:
        s = each.score
        cells = ["{} of {}".format(*s.by_mount[mount]) if mount in s.by_mount else "" for mount in mounts]
        reasons = ", ".join(f"{reason} {count}" for reason, count in list(s.reasons.items())[:4])
        rows.append((each.who, *cells, reasons))
    return table(("valid ones", *mounts, "what spoke against the others"), rows)


def _table_of_runs(runs: list[RunLog]) -> str:
    rows = []
    for run in runs:
        said = [f"{key} {run.config[key]}" for key in _SETTINGS if run.config.get(key) is not None]
        seconds = next((line["train_runtime"] for line in reversed(run.history) if "train_runtime" in line), None)
        spent = "" if seconds is None else f"{float(seconds) / 60:.0f}"
        steps = max((int(line["step"]) for line in run.history if "step" in line), default=0)
        rows.append((run.name, str(steps), spent, ", ".join(said)))
    return table(("run", "steps done", "minutes", "settings"), rows)


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table in Markdown."""
    lines = ["| " + " | ".join(cells) + " |" for cells in (head, ("---",) * len(head), *rows)]
    return "\n".join(lines) + "\n"
