"""Words of shape and size, by an object's measures."""

import re
import tomllib
from collections.abc import Callable
from functools import cache
from importlib.resources import files

from shapely import MultiPoint, union_all
from shapely.geometry import box
from shapely.geometry.base import BaseGeometry

from thinkblox.evaluation.bodies import Body, corners_of
from thinkblox.evaluation.matching import names_of
from thinkblox.evaluation.vocabulary import load_vocabulary

_TABLE = "sizes.toml"
ROUND = (0.70, 0.86)
"""How much of the box round it a round outline fills; a circle fills 0.785."""
FULL = 0.9
"""How much of the box round it a rectangular outline fills at least."""
NEARLY = 0.87
"""The shorter side of a square or circle as a share of the longer one, at least."""
FLAT = 0.03
"""What is ordinarily no higher than this is cloth or mat [m]."""
NUMBERS = {"one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "eight": 8}
_DRAWERS = re.compile(r"(?P<number>\d+|[a-z]+)[ -]drawers?$")

Judged = tuple[bool, str] | None


def judged_form(body: Body, word: str, demanded: str) -> Judged:
    """Whether an object has a shape or size, with what was measured; None when that cannot be told.

    Args:
        body: the object.
        word: such as "round", "low" or "queen".
        demanded: the category, whose ordinary size words of size are held against where the object's own is not known.
    """
    word = word.lower().replace("-", " ")
    if word in _PLACES and not _is_bed(body, demanded):
        return _for_so_many(body, word, demanded)
    if word in _FORMS:
        return _FORMS[word](body)
    if word in _SIZES:
        ordinary = _ordinary(body, demanded)
        return None if ordinary is None else _SIZES[word](body, ordinary)
    drawers = _DRAWERS.fullmatch(word)
    if drawers and (wanted := NUMBERS.get(drawers["number"], _number(drawers["number"]))):
        there = sum(link.joint is not None and link.joint.kind == "slide" for link in body.asset.links)
        return there == wanted, f"{there} drawers"
    return None


def is_shape_word(word: str) -> bool:
    """Whether it says a shape, a number of drawers, or a size by itself, as "queen" does of a bed."""
    word = word.lower().replace("-", " ")
    return word in _FORMS or _DRAWERS.fullmatch(word) is not None


def is_size_word(word: str) -> bool:
    """Whether it says a size against what is ordinary."""
    return word.lower().replace("-", " ") in _SIZES


def _number(text: str) -> int | None:
    return int(text) if text.isdecimal() else None


def _outline(body: Body) -> tuple[BaseGeometry, float, float]:
    """Its outline with the sides of the box round it [m]: seen from the front for wall things, else from above."""
    if body.asset.mount != "wall":
        outline = body.to_own(union_all([part.outline for part in body.parts]))
        return outline, 2 * body.half[0], 2 * body.half[1]
    shapes = [corners_of(shape) for link in body.asset.links for shape in link.shapes]
    flat = union_all([_hull([(c[1], c[2]) for c in corners]) for corners in shapes])
    return flat, 2 * body.half[1], body.high - body.low


def _hull(points: list[tuple[float, float]]) -> BaseGeometry:
    return MultiPoint(points).convex_hull


def _fills(body: Body) -> tuple[float, float]:
    """How much of its box the hull of its outline fills, and the shorter side as a share of the longer one."""
    outline, a, b = _outline(body)
    return outline.convex_hull.area / (a * b), min(a, b) / max(a, b)


def _round(body: Body) -> tuple[bool, str]:
    filled, sides = _fills(body)
    return ROUND[0] <= filled <= ROUND[1] and sides >= NEARLY, f"fills {filled:.2f} of its box, sides 1 : {sides:.2f}"


def _oval(body: Body) -> tuple[bool, str]:
    filled, sides = _fills(body)
    return ROUND[0] <= filled <= ROUND[
        1
    ] + 0.04 and sides < 0.97, f"fills {filled:.2f} of its box, sides 1 : {sides:.2f}"


def _square(body: Body) -> tuple[bool, str]:
    filled, sides = _fills(body)
    return filled >= FULL and sides >= NEARLY, f"fills {filled:.2f} of its box, sides 1 : {sides:.2f}"


def _rectangular(body: Body) -> tuple[bool, str]:
    filled, sides = _fills(body)
    return filled >= FULL and sides < 0.97, f"fills {filled:.2f} of its box, sides 1 : {sides:.2f}"


def _l_shaped(body: Body) -> tuple[bool, str]:
    """Three of the four corners of its box are covered, and the fourth is free."""
    outline, a, b = _outline(body)
    covered = sum(
        outline.intersection(box(*sorted_box(sx * a / 2, sy * b / 2, a, b))).area > 0.5 * (0.2 * a * 0.2 * b)
        for sx in (-1, 1)
        for sy in (-1, 1)
    )
    share = outline.area / (a * b)
    return covered == 3 and share < 0.9, f"covers {covered} corners and {share:.2f} of its box"


def sorted_box(x: float, y: float, a: float, b: float) -> tuple[float, float, float, float]:
    """The fifth of a box of sides a and b that lies in its corner at (x, y) [m]."""
    inner = (x - 0.2 * a if x > 0 else x + 0.2 * a, y - 0.2 * b if y > 0 else y + 0.2 * b)
    return (min(x, inner[0]), min(y, inner[1]), max(x, inner[0]), max(y, inner[1]))


def _long(body: Body) -> tuple[bool, str]:
    short, long = sorted(2 * half for half in body.half)
    return long >= 1.7 * short, f"{long:.2f} m by {short:.2f} m"


def _full_length(body: Body) -> tuple[bool, str]:
    tall = body.high - body.low
    return tall >= 1.2, f"{tall:.2f} m high"


def _ultrawide(body: Body) -> tuple[bool, str]:
    wide, tall = 2 * max(body.half), body.high - body.low
    return wide >= 1.8 * tall, f"{wide:.2f} m by {tall:.2f} m"


def _grand(body: Body) -> tuple[bool, str]:
    """An upright piano is half a metre deep; a grand one has its strings lying."""
    deep = 2 * min(body.half)
    return deep >= 1.2, f"{deep:.2f} m deep"


def _four_poster(body: Body) -> tuple[bool, str]:
    tall = body.high - body.low
    return tall >= 1.5, f"{tall:.2f} m high"


def _rolled_up(body: Body) -> tuple[bool, str]:
    thick = body.high - body.low
    return thick >= 0.06, f"{thick:.2f} m thick"


def _loft(body: Body) -> tuple[bool, str]:
    """Nothing but legs below the height of a desk."""
    low = [part for part in body.parts if part.low < 1.0 and part.outline.area > 0.3]
    tall = body.high - body.low
    return tall >= 1.3 and not low, f"{tall:.2f} m high, {len(low)} broad parts below 1 m"


def _width(least: float, most: float) -> Callable[[Body], tuple[bool, str]]:
    def rule(body: Body) -> tuple[bool, str]:
        wide = 2 * min(body.half)
        return least <= wide <= most, f"{wide:.2f} m wide"

    return rule


_FORMS: dict[str, Callable[[Body], tuple[bool, str]]] = {
    "round": _round,
    "circular": _round,
    "oval": _oval,
    "square": _square,
    "rectangular": _rectangular,
    "l shaped": _l_shaped,
    "sectional": _l_shaped,
    "grand": _grand,
    "four poster": _four_poster,
    "rolled up": _rolled_up,
    "loft": _loft,
    "long": _long,
    "full length": _full_length,
    "ultrawide": _ultrawide,
    "queen": _width(1.4, 1.72),
    "queen size": _width(1.4, 1.72),
    "king": _width(1.72, 2.3),
    "king size": _width(1.72, 2.3),
    "double": _width(1.25, 1.72),
    "single": _width(0.7, 1.12),
    "twin": _width(0.7, 1.12),
}
Ordinary = tuple[float, float, float]
"""Shorter and longer horizontal side and height [m]."""


def _measures(body: Body) -> Ordinary:
    short, long = sorted(2 * half for half in body.half)
    return (short, long, body.high - body.low)


def _bulk(body: Body, ordinary: Ordinary) -> float:
    """How many times the ordinary size, by the mean of its measures; the height of cloth counts for nothing."""
    a, b, c = (m / o for m, o in zip(_measures(body), ordinary, strict=True))
    if ordinary[2] <= FLAT:
        return float((max(a, 1e-9) * max(b, 1e-9)) ** 0.5)
    return float((max(a, 1e-9) * max(b, 1e-9) * max(c, 1e-9)) ** (1 / 3))


def _small(body: Body, ordinary: Ordinary) -> tuple[bool, str]:
    ratio = _bulk(body, ordinary)
    return ratio <= 0.93, f"{ratio:.2f} times the ordinary size"


def _large(body: Body, ordinary: Ordinary) -> tuple[bool, str]:
    ratio = _bulk(body, ordinary)
    return ratio >= 1.07, f"{ratio:.2f} times the ordinary size"


def _tall(body: Body, ordinary: Ordinary) -> tuple[bool, str]:
    tall, usual = body.high - body.low, ordinary[2]
    return tall >= min(1.08 * usual, max(usual, 1.7)), f"{tall:.2f} m high, ordinarily {usual:.2f}"


def _low(body: Body, ordinary: Ordinary) -> tuple[bool, str]:
    tall, usual = body.high - body.low, ordinary[2]
    return tall <= max(0.93 * usual, 0.45), f"{tall:.2f} m high, ordinarily {usual:.2f}"


def _short(body: Body, ordinary: Ordinary) -> tuple[bool, str]:
    """Low, or less long: a short bench is as high as others."""
    is_low, how = _low(body, ordinary)
    long, usual = 2 * max(body.half), max(ordinary[:2])
    return is_low or long <= 0.9 * usual, f"{how}; {long:.2f} m long, ordinarily {usual:.2f}"


def _wide(body: Body, ordinary: Ordinary) -> tuple[bool, str]:
    side, usual = (min, min(ordinary[:2])) if _is_bed(body, "") else (max, ordinary[1])
    wide = 2 * side(body.half)
    return wide >= 1.07 * usual, f"{wide:.2f} m wide, ordinarily {usual:.2f}"


def _narrow(body: Body, ordinary: Ordinary) -> tuple[bool, str]:
    (short, long, _), (usual_short, usual_long, _) = _measures(body), ordinary
    slim = short <= 0.93 * usual_short or long <= 0.93 * usual_long
    return slim, f"{long:.2f} m by {short:.2f} m, ordinarily {usual_long:.2f} by {usual_short:.2f}"


_SIZES: dict[str, Callable[[Body, Ordinary], tuple[bool, str]]] = {
    **dict.fromkeys(("small", "mini", "little", "tiny", "compact", "miniature"), _small),
    **dict.fromkeys(("large", "big", "huge", "oversized", "giant", "spacious"), _large),
    **dict.fromkeys(("tall", "high"), _tall),
    "low": _low,
    "short": _short,
    "wide": _wide,
    **dict.fromkeys(("narrow", "slim", "slender"), _narrow),
}


_PLACES = ("double", "single")
"""Words that say of beds how wide they are, and of a sink or a desk whether it is one for two."""
_FOR_TWO = 1.25
"""Times the ordinary length from which a thing is one for two."""


def _is_bed(body: Body, demanded: str) -> bool:
    names = (demanded, *names_of(body.asset.category, body.asset.description))
    return any(load_vocabulary().steps(name, "bed") is not None for name in names)


def _for_so_many(body: Body, word: str, demanded: str) -> Judged:
    """Whether what is no bed is as long as one for two, or for one; None where its ordinary length is not known."""
    ordinary = _ordinary(body, demanded, own=True)
    if ordinary is None:
        return None
    long, usual = 2 * max(body.half), ordinary[1]
    return (long >= _FOR_TWO * usual) == (word == "double"), f"{long:.2f} m long, ordinarily {usual:.2f}"


def _ordinary(body: Body, demanded: str, *, own: bool = False) -> Ordinary | None:
    """The ordinary size of what was demanded, or of the nearest kind above it; with `own` of the thing first."""
    vocabulary, names = load_vocabulary(), [demanded, *names_of(body.asset.category, body.asset.description)]
    for name in (*names[1:], demanded) if own else names:
        steps = {known: step for known in _sizes() if (step := vocabulary.steps(name, known)) is not None}
        if steps:
            return _sizes()[min(steps, key=lambda known: steps[known])]
    return None


@cache
def _sizes() -> dict[str, Ordinary]:
    return {
        name: (float(a), float(b), float(c))
        for name, (a, b, c) in tomllib.loads(files("thinkblox.evaluation").joinpath(_TABLE).read_text("utf-8")).items()
    }
