"""Frames, inertias and numbers in the terms of the XML formats."""

import math
import re
from collections.abc import Iterable, Sequence
from typing import Any
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from thinkblox.exporters.inventory import InventoryBody
from thinkblox.scene.corners import rotation

_LOCKED = 1.0 - 1e-12
_NOT_IN_XML = re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def inertia_about_centre(body: InventoryBody) -> NDArray[np.float64]:
    """The inertia of a body about its centre of mass, along its own axes (3, 3) [kg m2]."""
    turn = rotation(body.axes)
    inertia: NDArray[np.float64] = turn @ np.diag(body.inertia) @ turn.T
    return inertia


def inertia_attributes(body: InventoryBody) -> dict[str, str]:
    """The same as the six numbers of URDF and SDF."""
    inertia = inertia_about_centre(body)
    return {
        f"i{'xyz'[row]}{'xyz'[column]}": numbers((inertia[row, column],))
        for row in range(3)
        for column in range(row, 3)
    }


def roll_pitch_yaw(quat_wxyz: Sequence[float]) -> tuple[float, float, float]:
    """The turns about the fixed axes x, then y, then z, that make an orientation [rad]."""
    turn = rotation(quat_wxyz)
    sine = -float(turn[2, 0])
    if abs(sine) > _LOCKED:
        return (0.0, math.copysign(math.pi / 2, sine), math.atan2(-float(turn[0, 1]), float(turn[1, 1])))
    return (
        math.atan2(float(turn[2, 1]), float(turn[2, 2])),
        math.atan2(sine, math.hypot(float(turn[2, 1]), float(turn[2, 2]))),
        math.atan2(float(turn[1, 0]), float(turn[0, 0])),
    )


def numbers(values: Iterable[float]) -> str:
    """Numbers as XML has them, with every digit that counts."""
    return " ".join(f"{float(value) + 0.0:.15g}" for value in values)


def in_xml(text: str) -> str:
    """A text that XML can hold: what it has no character for, such as a NUL, is written as in JSON."""
    return _NOT_IN_XML.sub(lambda found: f"\\u{ord(found[0]):04x}", text)


def add(parent: ElementTree.Element, tag: str, text: str | None = None, **attributes: str) -> ElementTree.Element:
    """Append an element."""
    element = ElementTree.SubElement(parent, tag, attributes)
    element.text = text
    return element


def xml_text(root: ElementTree.Element) -> str:
    """An element as a document."""
    ElementTree.indent(root, "  ")
    return '<?xml version="1.0"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def placing(pose: tuple[Any, Any]) -> dict[str, str]:
    """The attributes of a URDF origin."""
    position, quat_wxyz = pose
    return {"xyz": numbers(position), "rpy": numbers(roll_pitch_yaw(quat_wxyz))}
