"""Masses and inertias that no body can have, mended by the least, and what is to be said of that."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.foreign.names import listed

Floats = NDArray[np.float64]
WATER = 1000.0
"""Density of the ball whose inertia stands for one that is missing [kg/m3]."""
LIGHTEST = 0.001
"""Mass of what moves and is said to weigh nothing [kg]."""
LEAST = 1e-12
"""The engine takes no smaller mass or inertia for what moves [kg, kg m2]."""
SLACK = 1e-6
"""By which share A + B is more than C once they are balanced."""
_NAMES = (("ixx", 0, 0), ("iyy", 1, 1), ("izz", 2, 2), ("ixy", 0, 1), ("ixz", 0, 2), ("iyz", 1, 2))


@dataclass
class Mended:
    """Links by what was done to their inertia."""

    balanced: list[str]
    guessed: list[str]
    weightless: list[str]
    filled: list[str]

    def notes(self) -> tuple[str, ...]:
        """A sentence for each kind."""
        found = []
        if self.balanced:
            found.append(balanced_note(self.balanced))
        if self.guessed:
            found.append(f"The inertia of {listed(self.guessed)} is that of a ball of water, for want of a usable one.")
        if self.weightless:
            found.append(f"What moves must weigh something: {listed(self.weightless)} was given {LIGHTEST:g} kg.")
        if self.filled:
            found.append(f"Products of inertia that {listed(self.filled)} does not say are taken as 0.")
        return tuple(found)


def mend_inertias(root: ElementTree.Element, free: tuple[str, ...]) -> Mended:
    """Mend the links of a URDF; what the engine cannot read as numbers is left for it to refuse.

    An inertia that breaks the triangle inequality has its smaller moments raised; one that is zero or not positive is
    that of a ball; products that are missing are 0. A link that moves and, with all that is fixed to it, weighs nothing
    is given a little mass.

    Args:
        root: the <robot>; changed in place.
        free: links that nothing holds.
    """
    mended = Mended([], [], [], [])
    for link in _weightless(root, free):
        _weigh(link)
        mended.weightless.append(link.get("name", ""))
    for link in root.iterfind("link"):
        inertia, mass = link.find("inertial/inertia"), _mass(link)
        if inertia is not None and _fill(inertia):
            mended.filled.append(link.get("name", ""))
        tensor = None if inertia is None else _tensor(inertia)
        if inertia is None or tensor is None or not 0.0 < mass < math.inf:
            continue
        moments, axes = np.linalg.eigh(tensor)
        if moments[0] <= LEAST * min(1.0, mass):
            _write(inertia, np.eye(3) * _ball(mass))
            mended.guessed.append(link.get("name", ""))
        elif moments[0] + moments[1] < moments[2]:
            _write(inertia, axes @ np.diag(balanced(moments)) @ axes.T)
            mended.balanced.append(link.get("name", ""))
    return mended


def _fill(inertia: ElementTree.Element) -> bool:
    """Make 0 of the products of inertia that are missing, if any are, as Bullet reads them."""
    missing = [name for name, row, column in _NAMES if row != column and inertia.get(name) is None]
    for name in missing:
        inertia.set(name, "0")
    return bool(missing)


def balanced(moments: Floats) -> Floats:
    """Principal moments that a body can have: the two smaller ones raised until A + B exceeds C by a little.

    Args:
        moments: (3,) in any order; C is more than A + B [kg m2].
    """
    order = np.argsort(moments)
    raised = np.array(moments, np.float64)
    raised[order[:2]] += (moments[order[2]] * (1.0 + SLACK) - moments[order[0]] - moments[order[1]]) / 2
    return raised


def balanced_note(names: list[str]) -> str:
    """What is to be said of those whose moments were balanced."""
    return f"No body has the inertia of {listed(names)}: the two smaller moments were raised until A + B >= C."


def _ball(mass: float) -> float:
    """Moment of inertia of a ball of water [kg m2]."""
    radius = math.cbrt(3.0 * mass / (4.0 * math.pi * WATER))
    return max(0.4 * mass * radius * radius, 10 * LEAST)


def _mass(link: ElementTree.Element) -> float:
    """Of a link with <inertial> [kg]; NaN where it has none or no number."""
    node = link.find("inertial/mass")
    return math.nan if node is None else _number(node.get("value", ""))


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan


def _tensor(node: ElementTree.Element) -> Floats | None:
    """The inertia that an element says [kg m2]; None where a number is none."""
    tensor = np.zeros((3, 3))
    for name, row, column in _NAMES:
        tensor[row, column] = tensor[column, row] = _number(node.get(name, ""))
    return tensor if np.all(np.isfinite(tensor)) and np.abs(tensor).max() < 1e100 else None


def _write(node: ElementTree.Element, tensor: Floats) -> None:
    for name, row, column in _NAMES:
        node.set(name, repr(float(tensor[row, column])))


def _weigh(link: ElementTree.Element) -> None:
    """Give a link without weight a little mass, and the inertia of a ball."""
    inertial = link.find("inertial")
    if inertial is None:
        inertial = ElementTree.SubElement(link, "inertial")
    for name in ("mass", "inertia"):
        if inertial.find(name) is None:
            ElementTree.SubElement(inertial, name)
    for node in inertial.iterfind("mass"):
        node.set("value", repr(LIGHTEST))
    for node in inertial.iterfind("inertia"):
        _write(node, np.eye(3) * _ball(LIGHTEST))


def _weightless(root: ElementTree.Element, free: tuple[str, ...]) -> Iterator[ElementTree.Element]:
    """The links that move and weigh nothing with all that is fixed to them."""
    links = {link.get("name", ""): link for link in root.iterfind("link")}
    fixed: dict[str, list[str]] = {}
    moving = list(free)
    for joint in root.iterfind("joint"):
        parent, child = (_named(joint, end) for end in ("parent", "child"))
        if joint.get("type") == "fixed":
            fixed.setdefault(parent, []).append(child)
        else:
            moving.append(child)
    for name in dict.fromkeys(moving):
        together, seen = [name], {name}
        for one in together:
            more = [child for child in fixed.get(one, ()) if child not in seen]
            seen.update(more)
            together += more
        if name in links and not any(_weighs(links[one]) for one in together if one in links):
            yield links[name]


def _weighs(link: ElementTree.Element) -> bool:
    if link.find("inertial") is None:
        return link.find("collision") is not None
    return not _mass(link) <= 0.0


def _named(joint: ElementTree.Element, end: str) -> str:
    node = joint.find(end)
    return "" if node is None else node.get("link", "")
