"""Files with something wrong in them: how a text is spoiled, by what it is written in."""

import json
import random
import re
from collections.abc import Iterator, Sequence
from typing import Any

VALUES = (
    "", "0", "-1", "1e308", "-1e308", "1e-308", "1e9", "2147483648", "-2147483649", "nan", "inf", "0 0 0", "0 0 0 0",
    "1 2", "x", "true", "free", "mesh", "hfield", "plane", "../a", "/etc/passwd", "room.xml", "\u00e9", "a" * 5000,
    "1 " * 3000,
)  # fmt: skip
"""What an attribute of XML is made."""
NUMBERS = "0 -1 7 0.001 1e308 -1e308 1e-308 1e9 2147483648 inf -inf 1e4 90 -0.3".split()
XML_NUMBER = r'(?<=[" ])-?(?:\d+\.?\d*|\.\d+)(?=[" ])'
USD_NUMBER = r"(?<=[ (\[])-?(?:\d+\.?\d*|\.\d+)(?=[,)\]\n])"
USD_WORDS = (
    *"PhysicsRevoluteJoint PhysicsPrismaticJoint PhysicsFixedJoint PhysicsJoint PhysicsRigidBodyAPI Cube Mesh".split(),
    *"Sphere Cone Cylinder Plane Xform PhysicsScene float double3 </World> </World/Objects> </nothing>".split(),
)
"""What a type or a path of USD is made."""
TAGS = "body geom joint freejoint site mesh replicate frame include link robot flexcomp composite attach plugin".split()
ODD: tuple[Any, ...] = (
    None, True, -1, 0, 1e300, -1e300, 1e-300, 2**63, 10**400, -1e-17, float("nan"), float("inf"), "", "floor", "a\nb",
    "chair_1\n", "\x1b[2J", "../../etc/passwd", "x" * 100_000, [], {}, [[]], [0, 0, 0], {"a": 1},
)  # fmt: skip
"""What a value of JSON is made."""
NO_NUMBERS: tuple[Any, ...] = ("1.0", "garbage", [], {}, [1.0], True, float("nan"), float("inf"), 1e300, -1e300)
"""What no length, angle or mass is."""


def mutated_xml(text: str, seed: int, times: int, *, values: Sequence[str] = ()) -> str:
    """A text of XML with some values, names, tags or stretches changed; `values` are put in besides the usual."""
    chance = random.Random(seed)
    for _ in range(times):
        kind = chance.randrange(9)
        if kind >= 5:
            text = _replaced(text, XML_NUMBER, chance.choice(NUMBERS), chance)
        elif kind <= 1:
            text = _replaced(text, r'"[^"]*"', f'"{chance.choice((*VALUES, *values))}"', chance)
        elif kind == 2:
            text = _replaced(text, r"(?<=<)\w+", chance.choice(TAGS), chance)
        elif kind == 3:
            text = _replaced(text, r' \w+="[^"]*"', "", chance)
        else:
            start, end = sorted(chance.randrange(len(text) + 1) for _ in range(2))
            end = min(end, start + 60)
            text = text[:start] + text[start:end] * chance.choice((0, 2, 30)) + text[end:]
    return text


def mutated_json(text: bytes, rng: random.Random, *, values: Sequence[Any] = ()) -> bytes:
    """A text of JSON with one thing wrong: a value, a key, an entry too many or too few, or bytes."""
    if rng.random() < 0.25:
        data = bytearray(text)
        at = rng.randrange(len(data))
        data[at : at + rng.choice((0, 1, 1, 50))] = rng.choice((b"", b"\0", b'"', b"{", b"9", b"\xff", b",", b"-"))
        return bytes(data)
    document = json.loads(text)
    holder, key = rng.choice(list(places(document)))
    match rng.randrange(4):
        case 0:
            del holder[key]
        case 1 if isinstance(holder, list):
            holder += [holder[key]] * rng.choice((1, 5, 3000))
        case 2 if isinstance(holder, dict):
            holder[rng.choice(("", "extra", "id\n", "x" * 1000))] = holder.pop(key)
        case _:
            holder[key] = rng.choice((*ODD, *values))
    return _written(document)


def nudged_json(text: bytes, rng: random.Random, times: int) -> bytes:
    """A text of JSON that says something else and is as well formed: numbers changed, entries exchanged."""
    document = json.loads(text)
    for _ in range(times):
        found = list(places(document))
        numbers = [(h, k) for h, k in found if isinstance(h[k], int | float) and not isinstance(h[k], bool)]
        if rng.random() < 0.8 and numbers:
            holder, key = rng.choice(numbers)
            holder[key] = type(holder[key])(_nudged(holder[key], rng))
        else:
            (one, at), (other, there) = rng.choice(found), rng.choice(found)
            one[at], other[there] = json.loads(json.dumps(other[there])), json.loads(json.dumps(one[at]))
    return _written(document)


def nudged_text(text: str, number: str, rng: random.Random, times: int) -> str:
    """A text with other numbers in it, where they are as the pattern `number` has them."""
    for _ in range(times):
        found = list(re.finditer(number, text))
        if not found:
            return text
        match = rng.choice(found)
        text = f"{text[: match.start()]}{_nudged(float(match[0]), rng):.9g}{text[match.end() :]}"
    return text


def _nudged(number: float, rng: random.Random) -> float:
    if rng.random() < 0.2:
        return number * rng.choice((1e-4, 1e4, 1e7))
    return number * rng.choice((-1.0, 0.0, 0.5, 0.9, 1.1, 2.0)) + rng.choice((0.0, 0.0, 0.01, -0.01, 0.5, -0.5))


def numberless_json(text: bytes, rng: random.Random) -> bytes:
    """A text of JSON in which one number is none."""
    document = json.loads(text)
    found = [(h, k) for h, k in places(document) if isinstance(h[k], float)]
    found = found or [(h, k) for h, k in places(document) if type(h[k]) is int]
    holder, key = rng.choice(found)
    holder[key] = rng.choice(NO_NUMBERS)
    return _written(document)


def numberless_text(text: str, number: str, rng: random.Random) -> str:
    """A text in which one number, as the pattern has them, is none; infinity is one in USD."""
    words = ("x", "1.0.0", "nan", "?") if number == USD_NUMBER else ("x", "1.0.0", "nan", "?", "inf")
    return _replaced(text, number, rng.choice(words), rng)


def mutated_usd(text: str, rng: random.Random, times: int) -> str:
    """A text of USD with some values, types or lines changed, left out or doubled."""
    for _ in range(times):
        kind = rng.randrange(5)
        if kind == 0:
            text = _replaced(text, USD_NUMBER, rng.choice(NUMBERS), rng)
        elif kind == 1:
            text = _replaced(text, r'"[^"]*"', f'"{rng.choice(VALUES[:-2])}"', rng)
        elif kind == 2:
            text = _replaced(
                text, r"\b(Physics\w+|Cube|Mesh|Xform|float3?|double3?|<[^>]*>)", rng.choice(USD_WORDS), rng
            )
        else:
            lines = text.split("\n")
            at = rng.randrange(1, len(lines))
            lines[at : at + 1] = lines[at : at + 1] * rng.choice((0, 0, 2))
            text = "\n".join(lines)
    return text


def places(document: Any) -> Iterator[tuple[Any, Any]]:
    """Everything in a document, as what holds it and the key under which it does."""
    keys = document if isinstance(document, dict) else range(len(document)) if isinstance(document, list) else ()
    for key in list(keys):
        yield document, key
        yield from places(document[key])


def _replaced(text: str, pattern: str, by: str, chance: random.Random) -> str:
    found = list(re.finditer(pattern, text))
    if not found:
        return text
    match = chance.choice(found)
    return text[: match.start()] + by + text[match.end() :]


def _written(document: Any) -> bytes:
    return json.dumps(document).encode("utf-8", "surrogatepass")
