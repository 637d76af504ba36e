"""What an evaluation found: every prompt with all its rows, and what the room's own report says."""

from typing import Literal

import msgspec

from thinkblox.evaluation.tallies import JudgedRow

EVALUATION_VERSION = 1
Subject = Literal["rooms", "reading"]


class Judgement(msgspec.Struct, frozen=True, kw_only=True):
    """One prompt and what became of it.

    Attributes:
        refused: why there is no room, or no brief; empty when there is one.
        complete: whether the room's report says that all is as asked; None where there is no report.
        valid: whether the verifier found the room valid; None where there is no report.
        seconds: that its room took to be made, or its prompt to be read; 0 for a room that was there already.
    """

    id: str
    style: str
    prompt: str
    rows: tuple[JudgedRow, ...]
    refused: str = ""
    complete: bool | None = None
    valid: bool | None = None
    seconds: float = 0.0

    @property
    def whole(self) -> bool:
        """Whether everything that can be judged is as demanded."""
        return not self.refused and all(row.met is not False for row in self.rows)

    @property
    def disagrees(self) -> bool:
        """Whether the room's report and the judge say different things of the whole prompt."""
        return self.complete is not None and self.complete != self.whole

    @property
    def failures(self) -> tuple[JudgedRow, ...]:
        """The demands that are not met."""
        return tuple(row for row in self.rows if row.met is False)


class Evaluation(msgspec.Struct, frozen=True, kw_only=True):
    """Every judged prompt of a file of annotations.

    Attributes:
        of: whether finished rooms were judged, or the reading of the prompts alone.
        annotations: name of the file.
        seed: of the rooms that were made.
    """

    of: Subject
    annotations: str
    judgements: tuple[Judgement, ...]
    seed: int = 0
    version: int = EVALUATION_VERSION
