"""The language every policy speaks: numbered reasoning in <think>, one JSON object in <answer>.

    <think>
    1. The bed is the focal point, so its head goes to the longest wall.
    2. It stands against the north wall, 1.20 m from the west wall.
    </think>
    <answer>{"id": "bed_1", "position": [2.0, 3.9, 0.0], "yaw": 270.0, "size": [2.1, 1.6, 1.0]}</answer>

`parse` is total: any text gives a Step or a Rejection. What the reasoning says about the pose is said in the phrases of
`thinkblox.phrases`, so that it can be read back and compared with the answer.
"""

import re
from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from thinkblox.value import Value, Vec3

MAX_TEXT = 20_000
"""Longest text that is read [characters]."""

_STEP = re.compile(r"\s*<think>(?P<think>.*?)</think>\s*<answer>(?P<answer>.*?)</answer>\s*", re.DOTALL)
_TAGS = ("<think>", "</think>", "<answer>", "</answer>")

Coordinate = Annotated[float, Meta(ge=-1000.0, le=1000.0)]
Degrees = Annotated[float, Meta(ge=-3600.0, le=3600.0)]
Extent = Annotated[float, Meta(gt=0.0, le=100.0)]


class Answer(Value, frozen=True, kw_only=True):
    """The action: what goes where. Units and frames as in `Placement`."""

    id: Annotated[str, Meta(pattern=r"^[a-z][a-z0-9_]*_[0-9]+$", max_length=80)]
    position: tuple[Coordinate, Coordinate, Coordinate]
    yaw: Degrees
    size: tuple[Extent, Extent, Extent]


class Step(Value, frozen=True, kw_only=True):
    """One reasoning-and-action text, read."""

    think: str
    id: str
    position: Vec3
    yaw: float
    size: Vec3


class Rejection(Value, frozen=True, kw_only=True):
    """Why a text or an answer cannot be used.

    Attributes:
        reason: "format" (the tags), "json" (the answer's text), "fields" (its keys, types or ranges), "id" (another
            object than was asked for), "size" (one that the asset cannot have).
        message: one line that a person or a policy can act on.
    """

    reason: Literal["format", "json", "fields", "id", "size"]
    message: str


def parse(text: str) -> Step | Rejection:
    """Read a policy's text; never raises, whatever the text."""
    if len(text) > MAX_TEXT:
        return Rejection(reason="format", message=f"the text has {len(text)} characters; at most {MAX_TEXT} are read")
    counts = {tag: text.count(tag) for tag in _TAGS}
    match = _STEP.fullmatch(text)
    if match is None or any(count != 1 for count in counts.values()):
        found = ", ".join(f"{count} {tag}" for tag, count in counts.items())
        return Rejection(
            reason="format",
            message=f"expected <think>...</think><answer>...</answer>, each once and nothing else; found {found}",
        )
    return _read_answer(match["think"].strip(), match["answer"])


def _read_answer(think: str, answer: str) -> Step | Rejection:
    try:
        read = msgspec.json.decode(answer.encode("utf-8", "replace"), type=Answer)
    except msgspec.ValidationError as error:
        return Rejection(reason="fields", message=f"the answer's object is wrong: {error}")
    except (msgspec.DecodeError, RecursionError) as error:
        return Rejection(reason="json", message=f"the answer is not one JSON object: {error}")
    return Step(think=think, id=read.id, position=read.position, yaw=read.yaw % 360.0, size=read.size)


def write_step(think: list[str], *, id: str, position: Vec3, yaw: float, size: Vec3) -> str:
    """Say `think` line by line and answer with a pose; `parse` reads it back to 0.1 mm and 0.01 degrees."""
    lines = "\n".join(f"{number}. {line}" for number, line in enumerate(think, 1))
    answer = Answer(
        id=id,
        position=_rounded(position),
        yaw=round(float(yaw) % 360.0, 2) % 360.0,
        size=_rounded(size),
    )
    return f"<think>\n{lines}\n</think>\n<answer>{msgspec.json.encode(answer).decode()}</answer>"


def _rounded(vector: Vec3) -> Vec3:
    x, y, z = (round(float(c), 4) + 0.0 for c in vector)
    return (x, y, z)
