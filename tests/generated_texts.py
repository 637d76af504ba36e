"""Answers of every sort that a model may give, by chance: valid, cut short, of wrong types, two at once, anything."""

import json
import random
from collections.abc import Callable, Iterator
from typing import Any

from thinkblox.steps import ALLOWED, MAX_TEXT, NEEDED, ActionName

_WORDS = (
    *"the bed goes to the north wall at 0.4 m, so that {} [] < > \" ' ``` // 1. NaN &amp; \\n".split(),
    "\u00e9\u8a9e", "\U0001f6cf\ufe0f", "\u202e",
)  # fmt: skip
_JUNK: tuple[object, ...] = (
    None, True, "", "1", [], {}, [[]], -1, 0, 1e9, 1e308, -1e-320, 10**400, float("nan"), float("inf"), "\x00",
    "\ud800", ["1", 2, 3], [1, 2], [1, 2, 3, 4], {"x": 1}, "chair_1", "Bed one", "a" * 200,
)  # fmt: skip
_TAGS = ("<think>", "</think>", "<answer>", "</answer>")


def generated(count: int, seed: int) -> Iterator[tuple[str, str, bool]]:
    """So many texts, each with its sort and whether it is a step."""
    draw = random.Random(seed)
    for _ in range(count):
        sort = draw.choice(list(_SORTS))
        yield sort, _SORTS[sort](draw), sort == "valid"


def _answer(draw: random.Random) -> dict[str, Any]:
    action: ActionName = draw.choice(tuple(NEEDED))
    values: dict[str, Any] = {
        "position": [round(draw.uniform(-1000, 1000), draw.randrange(8)) for _ in range(3)],
        "yaw": draw.choice([draw.randint(-3600, 3600), draw.uniform(-3600, 3600)]),
        "size": [draw.uniform(1e-6, 100) for _ in range(3)],
        "category": draw.choice(["chair", "静かな椅子", "x" * 60]),
        "attributes": ["red"] * draw.randrange(1, 17),
        "other": f"table_{draw.randrange(1000)}",
    }
    optional = [name for name in ALLOWED[action] if name not in NEEDED[action] and draw.random() < 0.5]
    names = [*NEEDED[action], *optional]
    answer = {"id": f"{draw.choice(['bed', 'tv_stand', 'a1'])}_{draw.randrange(10**6)}"}
    answer |= {name: values[name] for name in names}
    if action != "add" or draw.random() < 0.5:
        answer["action"] = action
    items = list(answer.items())
    draw.shuffle(items)
    return dict(items)


def _think(draw: random.Random) -> str:
    words = [word for word in draw.choices(_WORDS, k=draw.randrange(60)) if word not in _TAGS]
    return draw.choice(["\n", " "]).join(words)


def _step(draw: random.Random, answer: object) -> str:
    space = draw.choice(["", "\n", " \t\r\n"])
    text = json.dumps(answer, ensure_ascii=draw.random() < 0.5, indent=draw.choice([None, None, 2]))
    return f"{space}<think>{space}{_think(draw)}</think>{space}<answer>{space}{text}</answer>{space}"


def _valid(draw: random.Random) -> str:
    return _step(draw, _answer(draw))


def _cut(draw: random.Random) -> str:
    text = _valid(draw).rstrip()
    return text[: draw.randrange(len(text))]


def _wrong_type(draw: random.Random) -> str:
    answer = _answer(draw)
    # An optional part that is null is as good as left out; every other piece of junk is none of an answer's types.
    name = draw.choice(["id", *NEEDED[answer.get("action", "add")]])
    unlike = [j for j in _JUNK if not (name == "yaw" and type(j) in (int, float) and abs(float(str(j))) <= 3600)]
    unlike = [j for j in unlike if not (name in ("id", "other") and j == "chair_1")]
    return _step(draw, answer | {name: draw.choice(unlike)})


def _unknown_key(draw: random.Random) -> str:
    return _step(draw, _answer(draw) | {draw.choice(["rotation", "__class__", "", "ID", "id "]): 1})


def _missing_key(draw: random.Random) -> str:
    answer = _answer(draw)
    del answer[draw.choice(["id", *NEEDED[answer.get("action", "add")]])]
    return _step(draw, answer)


def _twice(draw: random.Random) -> str:
    first, second = _valid(draw), _valid(draw)
    return draw.choice([first + second, first.replace("</answer>", "}{</answer>"), f"{first}\n\nOr:\n{second}"])


def _double_key(draw: random.Random) -> str:
    return _valid(draw).replace('"id"', '"id": "chair_1", "id"', 1)


def _nested(draw: random.Random) -> str:
    text = _valid(draw)
    tag = draw.choice(_TAGS)
    return draw.choice([text.replace(tag, tag * 2, 1), text.replace(tag, f"{tag}{draw.choice(_TAGS)}", 1)])


def _about(draw: random.Random) -> str:
    around = draw.choice(["Sure! Here it is:", "```json", "\u200b", "."])
    return draw.choice([f"{around}{_valid(draw)}", f"{_valid(draw)}{around}"])


def _fenced(draw: random.Random) -> str:
    return _valid(draw).replace("<answer>", "<answer>```json\n").replace("</answer>", "\n```</answer>")


def _commented(draw: random.Random) -> str:
    comment = draw.choice(["// here\n", "/* here */", "# here\n"])
    start, _, rest = _valid(draw).rpartition("<answer>")
    return f"{start}<answer>{comment}{rest}"


def _anything(draw: random.Random) -> str:
    return "".join(
        chr(draw.choice([draw.randrange(128), draw.randrange(0x11_0000)])) for _ in range(draw.randrange(200))
    )


def _torn(draw: random.Random) -> str:
    pieces = draw.choices([*_TAGS, *_WORDS, '{"id": "bed_1"', "}", "[" * 50, "\ud800"], k=draw.randrange(40))
    return "".join(pieces)


def _long(draw: random.Random) -> str:
    piece = draw.choice([*_WORDS, *_TAGS, "[", "9", '{"a":'])
    return (piece * (10**6 // len(piece)))[: draw.choice([MAX_TEXT + 1, 10**6])]


def _long_inside(draw: random.Random) -> str:
    return _valid(draw).replace("<think>", "<think>" + "so " * (MAX_TEXT // 3 + 1))


_SORTS: dict[str, Callable[[random.Random], str]] = {
    "valid": _valid, "cut short": _cut, "wrong type": _wrong_type, "unknown key": _unknown_key,
    "missing key": _missing_key, "two answers": _twice, "a key twice": _double_key, "nested tags": _nested,
    "words about it": _about, "fenced": _fenced, "commented": _commented, "any characters": _anything, "torn": _torn,
    "a megabyte": _long, "too much thought": _long_inside,
}  # fmt: skip
