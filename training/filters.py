"""What a demonstration must pass before anybody learns from it."""

import math
from typing import Literal

from rapidfuzz.distance import Levenshtein

from thinkblox.scene.scene import Scene
from thinkblox.steps import Step, parse, write_step
from thinkblox.training.outcome import ANGLE
from thinkblox.training.repredict import repredicted
from thinkblox.value import Value, Vec3
from thinkblox.verdict import Verdict

Fault = Literal["tags", "steps", "words", "agreement", "verdict"]


class Filters(Value, frozen=True, kw_only=True):
    """What is asked of a demonstration.

    Attributes:
        steps: lines of reasoning, at least.
        words: words of reasoning, at least.
        similarity: of the answer and the one that the reasoning leads to, by Levenshtein: more than this, 0 to 1.
        distance: how far apart the two may be along an axis [m], or in yaw [degrees by 90].
    """

    steps: int = 3
    words: int = 12
    similarity: float = 0.8
    distance: float = 0.1


def fault_of(scene: Scene, text: str, verdict: Verdict | None, filters: Filters) -> Fault | None:
    """Why a text is no demonstration for a scene: the first filter that it does not pass; None when it passes all."""
    step = parse(text)
    if not isinstance(step, Step) or step.position is None or step.yaw is None:
        return "tags"
    lines = [line for line in step.think.splitlines() if line.strip()]
    if len(lines) < filters.steps:
        return "steps"
    if len(step.think.split()) < filters.words:
        return "words"
    if not _agrees(scene, step, filters):
        return "agreement"
    if verdict is None or not verdict.valid:
        return "verdict"
    return None


def _agrees(scene: Scene, step: Step, filters: Filters) -> bool:
    found = repredicted(scene, step)
    if found is None or step.position is None or step.yaw is None:
        return False
    position, yaw = found
    apart = max(abs(a - b) for a, b in zip(position, step.position, strict=True))
    turned = abs(math.remainder(yaw - step.yaw, 360.0)) / ANGLE
    alike = Levenshtein.normalized_similarity(_answer(step, position, yaw), _answer(step, step.position, step.yaw))
    return alike > filters.similarity and max(apart, turned) <= filters.distance


def _answer(step: Step, position: Vec3, yaw: float) -> str:
    return write_step((), id=step.id, position=position, yaw=yaw, size=step.size)
