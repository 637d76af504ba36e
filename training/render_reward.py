"""R_render of the ThinkBLOX paper: what a vision-language model says of the rendered result."""

from collections.abc import Callable, Sequence
from typing import Any

from thinkblox.chat import Chat, Message
from thinkblox.prompts import filled, one_line
from thinkblox.training.outcome import Rollout
from thinkblox.training.picture_judge import PictureJudge, judged_views
from thinkblox.wording import describe_tie

SIZE = 336
"""Width and height of each of its pictures [pixels]."""


class RenderReward:
    """exp(logprob "Yes") of a judge that sees the room with the object in it, 0 to 1 (ThinkBLOX, R_render).

    A text that cannot be used, or takes the object away, gets 0. What the judge leaves unanswered gets None, and its
    share is logged; a judge that is gone ends the training, of which the checkpoints stay.
    """

    def __init__(self, judge: PictureJudge, *, size: int = SIZE) -> None:
        self._judge, self._size = judge, size

    @property
    def name(self) -> str:
        """For logs: it says who judges."""
        return f"render:{self._judge.name}"

    def __call__(
        self, *, outcome: Sequence[Rollout], log_metric: Callable[[str, float], None] | None = None, **_: Any
    ) -> list[float | None]:
        """The reward of each rollout.

        Raises:
            UnavailableError: the judge is gone.
        """
        shown = [each for each in outcome if _is_there(each)]
        said = self._judge.approvals([asked_of(each, self._size) for each in shown])
        if log_metric is not None and shown:
            log_metric(f"unanswered/{self.name}", said.count(None) / len(said))
        found = iter(said)
        return [next(found) if _is_there(each) else 0.0 for each in outcome]


def asked_of(outcome: Rollout, size: int = SIZE) -> Chat:
    """What a judge is asked of a placement."""
    target, scene = outcome.case.target, outcome.after
    if scene is None:
        raise ValueError(f"{target.id} was not placed, and cannot be shown")
    wanted = "; ".join(describe_tie(tie) for tie in outcome.case.told) or "nothing in particular"
    question = filled(
        "judge_step", id=target.id, category=target.category, prompt=one_line(scene.prompt), wanted=wanted
    )
    return (Message("user", (question, *judged_views(scene, size=size, ids=True))),)


def _is_there(outcome: Rollout) -> bool:
    return outcome.after is not None
