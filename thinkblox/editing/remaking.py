"""The same kind of thing made otherwise: larger, of another colour, round."""

import dataclasses
import re
from collections.abc import Sequence

from thinkblox.assets.repaint import LOOKS, MATERIALS
from thinkblox.editing.grammar import means
from thinkblox.editing.orders import Order
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.judging import style_seed
from thinkblox.scene.asset import Asset
from thinkblox.value import Vec3

MORE, SLIGHTLY = (1.25, 1.15, 1.08), (1.1, 1.06)
"""By which factors a thing becomes larger where nobody says by how much: the first that there is room for."""
LEAST = 0.02
"""Least by which it differs then [m]."""
_SENSES = {"longer": 1, "wider": 1, "deeper": 1, "larger": 1, "higher": 1,
           "shorter": -1, "narrower": -1, "smaller": -1, "lower": -1}  # fmt: skip
_EVEN = frozenset(("round", "circular", "square", "hexagonal", "octagonal"))
"""Outlines that are as deep as they are wide."""
_AXES = {"longer": "length", "shorter": "length", "wider": "width", "narrower": "width", "deeper": "depth",
         "higher": "height", "lower": "height"}  # fmt: skip
LEAST_SHARE = 0.5
"""Which share of a side a length is at least that it is to come to: "longer, 2.5 m"."""
_BY_LENGTH = re.compile(r"\b(?:m|cm|mm|met(?:er|re)s?|centimet(?:er|re)s?|f(?:ee|oo)t|inch(?:es)?)\s+\w+er\b")
"""A length by which something changes: "20 cm longer"."""


def factors(order: Order) -> tuple[float, ...]:
    """By which factors what an order makes larger or smaller may become so; one where it says how large."""
    if order.times and order.change:
        return (order.times,)
    if order.lengths or not order.change:
        return (1.0,)
    return SLIGHTLY if order.slight else MORE


def otherwise(work: Work, old: Asset, order: Order, factor: float = MORE[0]) -> Asset:
    """The same kind of thing as an order wants it, larger by a factor where nobody says by how much.

    Raises:
        InputError: such a thing is not made so.
    """
    size = _size(work, old, order, factor)
    if not order.looks:
        return work.source.fit(old, size) if size != old.size else old
    made = looking(work, old, order.looks)
    shaped = _shapes(made.attributes) != _shapes(old.attributes)
    if shaped and size == old.size:
        return made
    least, most = work.source.size_range(old.category)
    kept = tuple(min(max(s, a), b) for s, a, b in zip(size, least, most, strict=True))
    fitted = work.source.fit(made, (kept[0], kept[1], kept[2]))
    return fitted if set(order.looks) <= {*fitted.attributes} else made


def looking(work: Work, old: Asset, looks: Sequence[str]) -> Asset:
    """A thing of a kind that looks as it is said, and otherwise as the old one did.

    Raises:
        InputError: such things do not come so.
    """
    shaped = bool(_shapes(looks))
    kept = [word for word in old.attributes if not any(_are_alike(word, look) for look in looks)]
    kept = [word for word in kept if not (shaped and means("proportions", word))]
    for words in ((*looks, *kept), tuple(looks)):
        made = work.source.make(old.category, seed=style_seed(work.scene), attributes=words).called(old.name)
        if set(looks) <= set(made.attributes):
            return made
    raise InputError(f"no {old.category.replace('_', ' ')} is made {' and '.join(looks)}")


def _are_alike(one: str, other: str) -> bool:
    """Whether two looks cannot both be: two colours, two materials, two shapes."""
    material = (one in MATERIALS, other in MATERIALS)
    if one in LOOKS or other in LOOKS:
        return one in LOOKS and other in LOOKS and material[0] == material[1]
    return bool(_shapes((one,)) and _shapes((other,)))


def _shapes(words: Sequence[str]) -> frozenset[str]:
    return frozenset(word for word in words if means("shapes", word))


def _size(work: Work, old: Asset, order: Order, factor: float) -> Vec3:
    """The size that an order wants of a thing [m].

    Raises:
        InputError: things of that kind are not made so large or so small.
    """
    deep, wide, high = old.size
    sides = {"depth": deep, "width": wide, "height": high}
    change, absolute = order.change.removesuffix("="), order.change.endswith("=")
    long = "depth" if deep > wide else "width"
    even = bool(_shapes(order.looks or old.attributes) & _EVEN)
    change = "lower" if change == "shorter" and high > max(deep, wide) else change
    if len(order.lengths) > 1 and not any(axis for _, axis in order.lengths) and not order.by:
        return _possible(work, old, _outline(old, [metres for metres, _ in order.lengths]), said=True)
    for metres, axis in order.lengths or ([(0.0, "")] if change else []):
        named = axis or _AXES.get(change, "")
        if named == "diameter":
            sides |= {"depth": metres, "width": metres}
            continue
        if not named and change not in ("larger", "smaller"):
            raise InputError(f"it is not said which side of it is to be {metres:g} m; say 'wide', 'long' or 'high'")
        if named == "width" and old.front != "one" and not even and not (absolute and metres > max(deep, wide)):
            named = "width" if long == "depth" else "depth"
        for side in (long if named == "length" else named,) if named else ("depth", "width"):
            sides[side] = _changed(
                sides[side], metres, change, absolute=absolute or not change, order=order, factor=factor
            )
            across = "width" if side == "depth" else "depth"
            if even and side != "height" and not any(axis == across for _, axis in order.lengths):
                sides[across] = sides[side]
    wanted = (sides["depth"], sides["width"], sides["height"])
    return _possible(work, old, wanted, said=bool(order.lengths or order.times))


def _outline(old: Asset, lengths: Sequence[float]) -> Vec3:
    """The size of a thing that is to be "2 by 3 m": its longer side is the longer of the two; a third is its height."""
    deep, wide, high = old.size
    less, more = sorted(lengths[:2])
    deep, wide = (more, less) if deep > wide else (less, more)
    return (deep, wide, lengths[2] if len(lengths) > 2 else high)


def _changed(side: float, metres: float, change: str, *, absolute: bool, order: Order, factor: float) -> float:
    sense = _SENSES.get(change, 1)
    if not metres and order.times:
        return side * order.times
    if not metres:
        return side * factor if sense > 0 else side / factor
    if not order.by and (absolute or (metres >= LEAST_SHARE * side and not _BY_LENGTH.search(order.text.lower()))):
        return metres
    return side + sense * metres


def _possible(work: Work, old: Asset, wanted: Vec3, *, said: bool) -> Vec3:
    least, most = work.source.size_range(old.category)
    held = tuple(min(max(w, a), b) for w, a, b in zip(wanted, least, most, strict=True))
    size = (round(held[0], 3), round(held[1], 3), round(held[2], 3))
    name = old.category.replace("_", " ")
    if said and max(abs(a - b) for a, b in zip(size, wanted, strict=True)) > 1e-3:
        raise InputError(f"a {name} is made from {_by(least)} to {_by(most)}, and {_by(wanted)} is wanted")
    grows = [(w - o, s - o) for w, o, s in zip(wanted, old.size, size, strict=True)]
    if any(abs(w) > LEAST for w, _ in grows) and not any(s * w > 0 and abs(s) >= LEAST for w, s in grows):
        raise InputError(f"a {name} is made from {_by(least)} to {_by(most)}, and this is {_by(old.size)}")
    return size if any(abs(s) > 1e-3 for _, s in grows) else old.size


def _by(size: Vec3) -> str:
    return " by ".join(f"{side:.2f}" for side in size) + " m"


def looks_of(asset: Asset) -> str:
    """A thing and its size, in words."""
    return f"{asset.description}, {_by(asset.size)}"


def compared(work: Work, old: Asset, degree: str, factor: float = MORE[0]) -> Asset:
    """The same kind of thing as "a larger one", "a taller one" of it, by a factor.

    Raises:
        InputError: a word that compares nothing that can be made otherwise, or no such thing is made.
    """
    change = means("comparatives", degree)
    if not change:
        raise InputError(f"'{degree}': what that means of a {old.category.replace('_', ' ')} is not known")
    return work.source.fit(old, _size(work, old, dataclasses.replace(Order("make", degree), change=change), factor))
