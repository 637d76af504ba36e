"""Materials of a USD stage: a UsdPreviewSurface for each look, a physics material for each friction."""

from collections.abc import Mapping
from typing import Any

from pxr import Gf, Sdf

from thinkblox.exporters.inventory import InventoryLook
from thinkblox.exporters.usd_prims import Prim, T
from thinkblox.scene.blobs import FOLDER
from thinkblox.sim.build import ROLL, TORSION
from thinkblox.sim.render.materials import linear
from thinkblox.sim.settings import Physics

BINDING = "MaterialBindingAPI"
_LABELS = "SemanticsLabelsAPI:material"
UV = "st"
"""The primvar that says where in the texture a vertex is."""


class Looks:
    """The materials under one scope, each made when first asked for.

    Args:
        scope: where they are put.
        looks: by name.
        folder: where the textures lie, relative to the layer.
    """

    def __init__(self, scope: Prim, looks: Mapping[str, InventoryLook], folder: str = f"./{FOLDER}") -> None:
        self._scope, self._looks, self._folder = scope, looks, folder
        self._paths: dict[str, Any] = {}

    def bind(self, prim: Prim, look: str) -> None:
        """Bind what the prim looks like; it must have the MaterialBindingAPI."""
        if look not in self._paths:
            self._paths[look] = _surface(self._scope, self._looks[look], self._folder)
        prim.link("material:binding", [self._paths[look]])

    def bind_friction(self, prim: Prim, friction: float) -> None:
        """Bind the physics material of the colliders in a prim; static and dynamic friction are the same."""
        name = f"friction_{friction:.3f}".replace(".", "_")
        if name not in self._paths:
            self._paths[name] = _physics(self._scope, name, friction)
        prim.link("material:binding:physics", [self._paths[name]])


def _surface(scope: Prim, look: InventoryLook, folder: str) -> Any:
    base = [round(channel, 5) for channel in linear(look.colour)]
    prim = scope.child(look.name, "Material", apis=[_LABELS])
    prim.put("semantics:labels:material", T.TokenArray, [look.name.partition("_")[0]])
    shader = prim.child("Surface", "Shader")
    shader.put("info:id", T.Token, "UsdPreviewSurface", uniform=True)
    if look.texture is None:
        shader.put("inputs:diffuseColor", T.Color3f, Gf.Vec3f(*base))
    else:
        source = _texture(prim, f"{folder}/{look.texture}.png", base)
        shader.connect("inputs:diffuseColor", T.Color3f, source.path.AppendProperty("outputs:rgb"))
    shader.put("inputs:roughness", T.Float, look.roughness)
    shader.put("inputs:metallic", T.Float, look.metallic)
    if look.glow:
        shader.put("inputs:emissiveColor", T.Color3f, Gf.Vec3f(*base) * look.glow)
    if look.opacity < 1.0:
        shader.put("inputs:opacity", T.Float, look.opacity)
    shader.declare("outputs:surface", T.Token)
    prim.connect("outputs:surface", T.Token, shader.path.AppendProperty("outputs:surface"))
    return prim.path


def _texture(material: Prim, file: str, base: list[float]) -> Prim:
    """The shaders that look a texture up; its file is named relative to the layer's."""
    place = material.child("Place", "Shader").put("info:id", T.Token, "UsdPrimvarReader_float2", uniform=True)
    place.put("inputs:varname", T.String, UV).declare("outputs:result", T.Float2)
    prim = material.child("Texture", "Shader").put("info:id", T.Token, "UsdUVTexture", uniform=True)
    prim.put("inputs:file", T.Asset, Sdf.AssetPath(file))
    prim.put("inputs:sourceColorSpace", T.Token, "sRGB")
    prim.put("inputs:wrapS", T.Token, "repeat").put("inputs:wrapT", T.Token, "repeat")
    prim.put("inputs:scale", T.Float4, Gf.Vec4f(*base, 1.0))
    prim.connect("inputs:st", T.Float2, place.path.AppendProperty("outputs:result"))
    return prim.declare("outputs:rgb", T.Float3)


def _physics(scope: Prim, name: str, friction: float) -> Any:
    apis = ["PhysicsMaterialAPI", "PhysxMaterialAPI", "NewtonMaterialAPI", _LABELS]
    prim = scope.child(name, "Material", apis=apis)
    prim.put("semantics:labels:material", T.TokenArray, ["friction"])
    prim.put("physics:staticFriction", T.Float, friction).put("physics:dynamicFriction", T.Float, friction)
    prim.put("physics:restitution", T.Float, 0.0)
    # MuJoCo takes the larger friction of a pair, PhysX the mean unless told otherwise; where nothing can be told, the
    # inventory has made the two alike.
    prim.put("physxMaterial:frictionCombineMode", T.Token, "max", uniform=True)
    # A stage has no solref: without these Newton's contacts are softer than MuJoCo's, and things sink and slide.
    time, ratio = Physics().solref
    prim.put("newton:contactStiffness", T.Float, 1.0 / (time * ratio) ** 2)
    prim.put("newton:contactDamping", T.Float, 2.0 / time)
    prim.put("newton:torsionalFriction", T.Float, TORSION).put("newton:rollingFriction", T.Float, ROLL)
    return prim.path
