"""Writing prims straight into an Sdf layer: ten times as fast as through a stage, which recomposes at every call."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from pxr import Gf, Sdf, Tf, Vt

from thinkblox.errors import InputError
from thinkblox.value import Quat, Vec3

T = Sdf.ValueTypeNames
IDENTITY: Quat = (1.0, 0.0, 0.0, 0.0)


class Prim:
    """A prim being defined in a layer."""

    def __init__(self, spec: Any) -> None:
        self.spec = spec

    @property
    def path(self) -> Any:
        """Its Sdf.Path."""
        return self.spec.path

    def child(self, name: str, type: str = "", *, apis: Sequence[str] = (), kind: str = "") -> "Prim":
        """Define a child; a name that is no identifier, or is taken, is changed to one that is."""
        prim = Prim(Sdf.PrimSpec(self.spec, self._free_name(name), Sdf.SpecifierDef, type))
        if apis:
            prim.spec.SetInfo("apiSchemas", Sdf.TokenListOp.Create(prependedItems=list(apis)))
        if kind:
            prim.spec.kind = kind
        return prim

    def _free_name(self, name: str) -> str:
        valid = str(Tf.MakeValidIdentifier(name))
        taken, candidate, number = self.spec.nameChildren, valid, 1
        while candidate in taken:
            number += 1
            candidate = f"{valid}_{number}"
        return candidate

    def put(self, name: str, type: Any, value: Any, *, uniform: bool = False, interpolation: str = "") -> "Prim":
        """Author an attribute."""
        variability = Sdf.VariabilityUniform if uniform else Sdf.VariabilityVarying
        attribute = Sdf.AttributeSpec(self.spec, name, type, variability)
        attribute.default = value
        if interpolation:
            attribute.SetInfo("interpolation", interpolation)
        return self

    def link(self, name: str, targets: Iterable[Any]) -> "Prim":
        """Author a relationship to the paths of prims."""
        relationship = Sdf.RelationshipSpec(self.spec, name, False)
        relationship.targetPathList.explicitItems = list(targets)
        return self

    def refer(self, path: Any, *, instance: bool = False) -> "Prim":
        """Take on all of another prim of the layer; an `instance` cannot be changed below."""
        self.spec.referenceList.prependedItems = [Sdf.Reference("", path)]
        if instance:
            self.spec.instanceable = True
        return self

    def load(self, file: str, path: Any, *, instance: bool = False) -> "Prim":
        """Take on all of a prim of another layer, when asked to; an `instance` cannot be changed below."""
        self.spec.payloadList.prependedItems = [Sdf.Payload(file, path)]
        if instance:
            self.spec.instanceable = True
        return self

    def declare(self, name: str, type: Any) -> "Prim":
        """Author an attribute without a value: an output."""
        Sdf.AttributeSpec(self.spec, name, type)
        return self

    def connect(self, name: str, type: Any, source: Any) -> "Prim":
        """Author an attribute that takes its value from the output at path `source`."""
        attribute = Sdf.AttributeSpec(self.spec, name, type)
        attribute.connectionPathList.explicitItems = [source]
        return self

    def place(self, position: Vec3, quat_wxyz: Quat = IDENTITY, scale: Vec3 | None = None) -> "Prim":
        """Author its pose [m], and a scale for what is no body."""
        order = ["xformOp:translate", "xformOp:orient"] + (["xformOp:scale"] if scale else [])
        self.put("xformOp:translate", T.Double3, Gf.Vec3d(*position))
        self.put("xformOp:orient", T.Quatd, Gf.Quatd(quat_wxyz[0], *quat_wxyz[1:]))
        if scale:
            self.put("xformOp:scale", T.Double3, Gf.Vec3d(*scale))
        return self.put("xformOpOrder", T.TokenArray, Vt.TokenArray(order), uniform=True)

    def extent(self, low: Sequence[float], high: Sequence[float]) -> "Prim":
        """Author its extent in its own frame [m]."""
        return self.put("extent", T.Float3Array, Vt.Vec3fArray([Gf.Vec3f(*map(float, v)) for v in (low, high)]))


def put_units(layer: Any) -> None:
    """Say that a layer has z up, metres and kilograms."""
    for key, value in (("upAxis", "Z"), ("metersPerUnit", 1.0), ("kilogramsPerUnit", 1.0)):
        layer.pseudoRoot.SetInfo(key, value)


def said(texts: Mapping[str, str]) -> dict[str, str]:
    """Texts as metadata: USD ends one at a NUL, which is written as in JSON."""
    return {key: text.replace("\0", "\\u0000") for key, text in texts.items()}


def in_binary(layer: Any) -> bytes:
    """A layer in USD's binary format, by way of a temporary file; raises InputError when that cannot be written."""
    with TemporaryDirectory() as folder:
        made = Path(folder) / "layer.usdc"
        try:
            layer.Export(str(made))
        except Tf.ErrorException as error:
            told = " ".join(str(error).split())
            raise InputError(f"{folder}: USD cannot write there: {told[:300]}") from error
        return made.read_bytes()


def vectors(rows: Any, digits: int) -> Any:
    """Rows of three numbers as a USD array, rounded to `digits`."""
    return Vt.Vec3fArray.FromNumpy(
        np.ascontiguousarray(np.round(np.asarray(rows, np.float64), digits) + 0.0, np.float32)
    )


def vector(value: Sequence[float]) -> Any:
    """Three numbers as a USD vector of floats."""
    return Gf.Vec3f(*map(float, value))


def quaternion(quat_wxyz: Sequence[float]) -> Any:
    """Return a USD quaternion of floats."""
    w, x, y, z = map(float, quat_wxyz)
    return Gf.Quatf(w, x, y, z)
