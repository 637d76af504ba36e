"""The language every policy speaks: numbered reasoning in <think>, one JSON object in <answer>.

    <think>
    1. The bed is the focal point, so its head goes to the longest wall.
    2. It stands against the north wall, 1.20 m from the west wall.
    </think>
    <answer>{"id": "bed_1", "position": [2.0, 3.9, 0.0], "yaw": 270.0, "size": [2.1, 1.6, 1.0]}</answer>

The answer is an action: "add" where it does not say, or "move", "turn", "replace", "remove", "swap":

    <answer>{"action": "move", "id": "chair_1", "position": [1.0, 2.0, 0.0]}</answer>

`parse` is total: any text gives a Step or a Rejection. What the reasoning says about the pose is said in the phrases of
`thinkblox.phrases`, so that it can be read back and compared with the answer.
"""

from collections.abc import Sequence
from typing import Annotated, Literal, TypeVar

import msgspec
from msgspec import Meta

from thinkblox.checked import ObjectId
from thinkblox.errors import InputError
from thinkblox.json_faults import json_fault
from thinkblox.value import Value, Vec3, refuse_double_keys

MAX_TEXT = 20_000
"""Longest text that is read [characters]."""

ActionName = Literal["add", "move", "turn", "replace", "remove", "swap"]
NEEDED: dict[ActionName, tuple[str, ...]] = {
    "add": ("position", "yaw", "size"),
    "move": ("position",),
    "turn": ("yaw",),
    "replace": (),
    "remove": (),
    "swap": ("other",),
}
"""What the answer of each action must say besides the id."""
ALLOWED: dict[ActionName, tuple[str, ...]] = {
    "add": ("position", "yaw", "size"),
    "move": ("position", "yaw"),
    "turn": ("yaw",),
    "replace": ("position", "yaw", "size", "category", "attributes"),
    "remove": (),
    "swap": ("other",),
}
"""And what it may say."""
_TAGS = ("<think>", "</think>", "<answer>", "</answer>")

Coordinate = Annotated[float, Meta(ge=-1000.0, le=1000.0)]
Degrees = Annotated[float, Meta(ge=-3600.0, le=3600.0)]
Extent = Annotated[float, Meta(gt=0.0, le=100.0)]
Word = Annotated[str, Meta(min_length=1, max_length=60)]
A = TypeVar("A", bound=Value)


class Answer(Value, frozen=True, kw_only=True, omit_defaults=True):
    """An action in JSON: what goes where. Units and frames as in `Placement`.

    Attributes:
        action: what is done with the object.
        position, yaw, size: where it goes, and how big it is; "move" and "replace" keep what they do not say.
        category, attributes: what comes instead, for "replace"; the same category when left out.
        other: the object to change places with, for "swap".
    """

    action: ActionName = "add"
    id: ObjectId
    position: tuple[Coordinate, Coordinate, Coordinate] | None = None
    yaw: Degrees | None = None
    size: tuple[Extent, Extent, Extent] | None = None
    category: Word | None = None
    attributes: Annotated[tuple[Word, ...], Meta(max_length=16)] = ()
    other: ObjectId | None = None


class Step(Value, frozen=True, kw_only=True):
    """One reasoning-and-action text, read; attributes as of `Answer`, the yaw within 0 to 360 degrees.

    `position`, `yaw` and `size` are there where the action needs them; None where it leaves them as they are.
    """

    think: str
    action: ActionName = "add"
    id: str
    position: Vec3 | None = None
    yaw: float | None = None
    size: Vec3 | None = None
    category: str | None = None
    attributes: tuple[str, ...] = ()
    other: str | None = None


class Rejection(Value, frozen=True, kw_only=True):
    """Why a text or an answer cannot be used.

    Attributes:
        reason: "format" (the tags), "json" (the answer's text), "fields" (its keys, types or ranges), "id" (another
            object than was asked for), "action" (one that cannot be done here), "size" (one that the asset cannot
            have), "policy" (the policy failed and gave no text).
        message: one line that a person or a policy can act on.
    """

    reason: Literal["format", "json", "fields", "id", "action", "size", "policy"]
    message: str


def parse(text: str) -> Step | Rejection:
    """Read a policy's text; never raises, whatever the text."""
    parts = tagged(text)
    return parts if isinstance(parts, Rejection) else _read_answer(*parts)


def tagged(text: str, *, most: int = MAX_TEXT) -> tuple[str, str] | Rejection:
    """What stands in <think> and in <answer> of a text of at most so many characters."""
    if len(text) > most:
        return Rejection(reason="format", message=f"the text has {len(text)} characters; at most {most} are read")
    if not text.isascii() and text.encode("utf-8", "ignore").decode() != text:
        return Rejection(reason="format", message="the text is not valid: it holds halves of characters (surrogates)")
    parts = _parts(text)
    if parts is None:
        found = ", ".join(f"{text.count(tag)} {tag}" for tag in _TAGS)
        return Rejection(
            reason="format",
            message=f"expected <think>...</think><answer>...</answer>, each once and nothing else; found {found}",
        )
    return parts


def _parts(text: str) -> tuple[str, str] | None:
    """What stands in the two pairs of tags; None when they are not there once each, with nothing else about them."""
    if any(text.count(tag) != 1 for tag in _TAGS):
        return None
    before, _, rest = text.partition("<think>")
    think, _, rest = rest.partition("</think>")
    between, _, rest = rest.partition("<answer>")
    answer, end, after = rest.partition("</answer>")
    return (think.strip(), answer) if end and not (before + between + after).strip() else None


def decoded(answer: str, kind: type[A]) -> A | Rejection:
    """What stands in <answer>, read as one JSON object of some kind; never raises."""
    try:
        read = msgspec.json.decode(answer, type=kind)
        refuse_double_keys(answer.encode(), "the answer")
    except msgspec.ValidationError as error:
        return Rejection(reason="fields", message=f"the answer's object is wrong: {json_fault(error, answer, Answer)}")
    except InputError as error:
        return Rejection(reason="json", message=str(error))
    except (msgspec.DecodeError, RecursionError) as error:
        return Rejection(reason="json", message=f"the answer is not one JSON object: {error}")
    return read


def _read_answer(think: str, answer: str) -> Step | Rejection:
    read = decoded(answer, Answer)
    if isinstance(read, Rejection):
        return read
    said = {name for name in ALLOWED["replace"] + ("other",) if getattr(read, name) not in (None, ())}
    missing = [name for name in NEEDED[read.action] if name not in said]
    extra = sorted(said.difference(ALLOWED[read.action]))
    if missing or extra:
        wrong = [f"needs {', '.join(missing)}"] if missing else []
        wrong += [f"takes no {', '.join(extra)}"] if extra else []
        return Rejection(reason="fields", message=f"the answer's object is wrong: {read.action} {' and '.join(wrong)}")
    return Step(
        think=think,
        action=read.action,
        id=read.id,
        position=read.position,
        yaw=None if read.yaw is None else (read.yaw % 360.0) % 360.0,
        size=read.size,
        category=read.category,
        attributes=read.attributes,
        other=read.other,
    )


def write_step(
    think: Sequence[str],
    *,
    id: str,
    position: Vec3 | None = None,
    yaw: float | None = None,
    size: Vec3 | None = None,
    action: ActionName = "add",
    category: str | None = None,
    attributes: tuple[str, ...] = (),
    other: str | None = None,
) -> str:
    """Say `think` line by line and answer with an action; `parse` reads it back to 0.1 mm and 0.01 degrees."""
    lines = "\n".join(f"{number}. {line}" for number, line in enumerate(think, 1))
    answer = Answer(
        action=action,
        id=id,
        position=None if position is None else _rounded(position),
        yaw=None if yaw is None else round(float(yaw) % 360.0, 2) % 360.0,
        size=None if size is None else _rounded(size),
        category=category,
        attributes=attributes,
        other=other,
    )
    return f"<think>\n{lines}\n</think>\n<answer>{msgspec.json.encode(answer).decode()}</answer>"


def _rounded(vector: Vec3) -> Vec3:
    x, y, z = (round(float(c), 4) + 0.0 for c in vector)
    return (x, y, z)
