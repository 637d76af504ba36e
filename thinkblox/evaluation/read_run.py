"""Reading every annotated prompt, and judging what was read."""

import time
from collections.abc import Sequence

from thinkblox.brief import Brief
from thinkblox.errors import InputError
from thinkblox.evaluation.annotations import Annotation
from thinkblox.evaluation.brief_judge import judge_brief
from thinkblox.evaluation.results import Judgement
from thinkblox.policies import Briefer


def judge_reading(annotations: Sequence[Annotation], briefer: Briefer) -> tuple[Judgement, ...]:
    """What of every demand stands in the brief that the briefer makes of its prompt."""
    return tuple(_judged(annotation, briefer) for annotation in annotations)


def _judged(annotation: Annotation, briefer: Briefer) -> Judgement:
    began, refused = time.perf_counter(), ""
    try:
        brief = briefer.brief(annotation.prompt)
    except InputError as error:
        brief, refused = Brief(prompt=annotation.prompt), str(error)
    seconds = time.perf_counter() - began
    return Judgement(
        id=annotation.id,
        style=annotation.style,
        prompt=annotation.prompt,
        rows=judge_brief(annotation, brief),
        refused=refused,
        seconds=seconds,
    )
