"""The phrases in which reasoning names its numbers, written and read back by one table.

A `Constraint` is what one phrase says about the pose of the object being placed. `phrase` writes it and `constraints`
finds every one in a text.
"""

import re
from collections.abc import Callable
from typing import Literal, NamedTuple

from thinkblox.steps import Step
from thinkblox.value import Value

Kind = Literal[
    "beside",  # 0.50 m to the left of bed_1 (between the footprints, along the anchor's own axes)
    "against",  # against the north wall
    "from_wall",  # 1.20 m from the west wall (from the footprint's nearest point)
    "corner",  # in the corner of the north wall and the west wall
    "on",  # on table_1
    "under",  # under bed_1
    "centred",  # centred on table_1
    "offset",  # 0.20 m forward and 0.10 m left of the centre of desk_1
    "between",  # between sofa_1 and tv_1
    "facing",  # facing desk_1, facing the north wall
    "turned",  # turned to 90 degrees
    "above",  # 0.75 m above table_1, 1.50 m above the floor
    "at",  # at (1.20, 3.40)
]
SIDES = {"left": "to the left of", "right": "to the right of", "front": "in front of", "back": "behind"}


class Constraint(Value, frozen=True, kw_only=True):
    """What one phrase says.

    Attributes:
        anchors: ids of objects, names of walls, or "floor".
        side: for "beside", one of `SIDES`.
        values: the numbers of the phrase [m or degrees].
    """

    kind: Kind
    anchors: tuple[str, ...] = ()
    side: str = ""
    values: tuple[float, ...] = ()


_NUM = r"(?<![\d.])(-?\d{1,6}(?:\.\d{1,6})?)(?![\d.]*\d)"
_PLAIN_ID = r"[a-z][a-z0-9_]{0,80}_\d{1,6}\b"
_ID = f"({_PLAIN_ID})"
_SIDES_OF_ROOM = "north-east|north-west|south-east|south-west|north|south|east|west"
_PLAIN_WALL = rf"the (?:{_SIDES_OF_ROOM}) wall(?: \d+)?"
_WALL = rf"the ((?:{_SIDES_OF_ROOM}) wall(?: \d+)?)"
_WALL_NAME = re.compile(rf"(?:{_SIDES_OF_ROOM.replace('-', '_')})_wall(?:_\d+)?")
_SIDE = "(" + "|".join(SIDES.values()) + ")"


class _Form(NamedTuple):
    kind: Kind
    pattern: re.Pattern[str]
    write: Callable[[Constraint], str]
    read: Callable[[tuple[str, ...]], Constraint]


def metres(value: float) -> str:
    """A length in the words of a phrase: at least two decimals, at most three."""
    text = f"{value:.3f}"
    return (text[:-1] if text.endswith("0") else text) + " m"


def wall_words(name: str) -> str:
    """Name a wall in words: north_wall_2 is "the north wall 2", north_east_wall "the north-east wall"."""
    side, _, number = name.partition("_wall")
    return f"the {side.replace('_', '-')} wall{number.replace('_', ' ')}"


def _wall_name(words: str) -> str:
    return words.replace("-", "_").replace(" ", "_")


def _thing(name: str) -> str:
    if name == "floor":
        return "the floor"
    return wall_words(name) if _WALL_NAME.fullmatch(name) else name


def _unthing(words: str) -> str:
    return _wall_name(words.removeprefix("the ")) if words.startswith("the ") else words


def _signed(words: str, number: str) -> float:
    return -float(number) if words in ("back", "right") else float(number)


def _offset_words(c: Constraint) -> str:
    forward, left = c.values
    ahead = f"{metres(abs(forward))} {'forward' if forward >= 0 else 'back'}"
    return f"{ahead} and {metres(abs(left))} {'left' if left >= 0 else 'right'} of the centre of {c.anchors[0]}"


_WORDS_OF_SIDE = {words: side for side, words in SIDES.items()}
_FORMS: tuple[_Form, ...] = (
    _Form(
        "beside",
        re.compile(rf"{_NUM} m {_SIDE} {_ID}"),
        lambda c: f"{metres(c.values[0])} {SIDES[c.side]} {c.anchors[0]}",
        lambda g: Constraint(kind="beside", anchors=(g[2],), side=_WORDS_OF_SIDE[g[1]], values=(float(g[0]),)),
    ),
    _Form(
        "against",
        re.compile(rf"against {_WALL}"),
        lambda c: f"against {wall_words(c.anchors[0])}",
        lambda g: Constraint(kind="against", anchors=(_wall_name(g[0]),)),
    ),
    _Form(
        "from_wall",
        re.compile(rf"{_NUM} m from {_WALL}"),
        lambda c: f"{metres(c.values[0])} from {wall_words(c.anchors[0])}",
        lambda g: Constraint(kind="from_wall", anchors=(_wall_name(g[1]),), values=(float(g[0]),)),
    ),
    _Form(
        "corner",
        re.compile(rf"in the corner of {_WALL} and {_WALL}"),
        lambda c: f"in the corner of {wall_words(c.anchors[0])} and {wall_words(c.anchors[1])}",
        lambda g: Constraint(kind="corner", anchors=(_wall_name(g[0]), _wall_name(g[1]))),
    ),
    _Form(
        "on",
        re.compile(rf"(?<!centred )(?<!depends )\bon {_ID}"),
        lambda c: f"on {c.anchors[0]}",
        lambda g: Constraint(kind="on", anchors=(g[0],)),
    ),
    _Form(
        "under",
        re.compile(rf"\bunder {_ID}"),
        lambda c: f"under {c.anchors[0]}",
        lambda g: Constraint(kind="under", anchors=(g[0],)),
    ),
    _Form(
        "centred",
        re.compile(rf"centred on {_ID}"),
        lambda c: f"centred on {c.anchors[0]}",
        lambda g: Constraint(kind="centred", anchors=(g[0],)),
    ),
    _Form(
        "offset",
        re.compile(rf"{_NUM} m (forward|back) and {_NUM} m (left|right) of the centre of {_ID}"),
        _offset_words,
        lambda g: Constraint(kind="offset", anchors=(g[4],), values=(_signed(g[1], g[0]), _signed(g[3], g[2]))),
    ),
    _Form(
        "between",
        re.compile(rf"between {_ID} and {_ID}"),
        lambda c: f"between {c.anchors[0]} and {c.anchors[1]}",
        lambda g: Constraint(kind="between", anchors=(g[0], g[1])),
    ),
    _Form(
        "facing",
        re.compile(rf"facing ({_PLAIN_ID}|{_PLAIN_WALL})"),
        lambda c: f"facing {_thing(c.anchors[0])}",
        lambda g: Constraint(kind="facing", anchors=(_unthing(g[0]),)),
    ),
    _Form(
        "turned",
        re.compile(rf"turned to {_NUM} degrees"),
        lambda c: f"turned to {c.values[0]:g} degrees",
        lambda g: Constraint(kind="turned", values=(float(g[0]) % 360.0 % 360.0,)),
    ),
    _Form(
        "above",
        re.compile(rf"{_NUM} m above ({_PLAIN_ID}|the floor)"),
        lambda c: f"{metres(c.values[0])} above {_thing(c.anchors[0])}",
        lambda g: Constraint(kind="above", anchors=(_unthing(g[1]),), values=(float(g[0]),)),
    ),
    _Form(
        "at",
        re.compile(rf"at \( ?{_NUM}, {_NUM}\)"),
        lambda c: f"at ({c.values[0]:.3f}, {c.values[1]:.3f})",
        lambda g: Constraint(kind="at", values=(float(g[0]), float(g[1]))),
    ),
)
_FORM_OF = {form.kind: form for form in _FORMS}


def phrase(constraint: Constraint) -> str:
    """The words of a constraint; `constraints` reads them back."""
    return _FORM_OF[constraint.kind].write(constraint)


def constraints(text: str) -> tuple[Constraint, ...]:
    """Every constraint that a text states in these phrases, in the order in which they stand."""
    found = [(match.start(), form.read(match.groups())) for form in _FORMS for match in form.pattern.finditer(text)]
    return tuple(constraint for _, constraint in sorted(found, key=lambda pair: pair[0]))


def planned_constraints(step: Step) -> tuple[Constraint, ...]:
    """What a step's reasoning says about its pose."""
    return constraints(step.think)
