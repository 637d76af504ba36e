"""Materials of a USD stage: a UsdPreviewSurface for each colour and material, a physics material for each friction."""

from typing import Any

from pxr import Gf

from thinkblox.exporters.usd_prims import Prim, T
from thinkblox.sim.render.materials import FINISHES, linear

OPACITY = {"glass": 0.3}
BINDING = "MaterialBindingAPI"
Colour = tuple[float, float, float]


def look_name(material: str, colour: Colour) -> str:
    """The name of a material, such as "wood_b98a5c": what shares the name shares the material."""
    return f"{material}_" + "".join(f"{round(channel * 255):02x}" for channel in colour)


class Looks:
    """The materials under one scope, each made when first asked for."""

    def __init__(self, scope: Prim) -> None:
        self._scope = scope
        self._paths: dict[str, Any] = {}

    def bind(self, prim: Prim, material: str, colour: Colour) -> None:
        """Bind what the prim looks like; it must have the MaterialBindingAPI."""
        name = look_name(material, colour)
        if name not in self._paths:
            self._paths[name] = _surface(self._scope, name, material, colour)
        prim.link("material:binding", [self._paths[name]])

    def bind_friction(self, prim: Prim, friction: float) -> None:
        """Bind the physics material of the colliders in a prim; static and dynamic friction are the same."""
        name = f"friction_{friction:.3f}".replace(".", "_")
        if name not in self._paths:
            self._paths[name] = _physics(self._scope, name, friction)
        prim.link("material:binding:physics", [self._paths[name]])


def _surface(scope: Prim, name: str, material: str, colour: Colour) -> Any:
    finish, base = FINISHES[material], [round(channel, 5) for channel in linear(colour)]
    prim = scope.child(name, "Material")
    shader = prim.child("Surface", "Shader")
    shader.put("info:id", T.Token, "UsdPreviewSurface", uniform=True)
    shader.put("inputs:diffuseColor", T.Color3f, Gf.Vec3f(*base))
    # The roughness whose highlight is as wide as that of the finish's Blinn-Phong exponent.
    shader.put("inputs:roughness", T.Float, round((2.0 / (finish.gloss + 2.0)) ** 0.25, 3))
    shader.put("inputs:metallic", T.Float, 1.0 if finish.tinted else 0.0)
    if finish.glow:
        shader.put("inputs:emissiveColor", T.Color3f, Gf.Vec3f(*base) * finish.glow)
    if material in OPACITY:
        shader.put("inputs:opacity", T.Float, OPACITY[material])
    shader.declare("outputs:surface", T.Token)
    prim.connect("outputs:surface", T.Token, shader.path.AppendProperty("outputs:surface"))
    return prim.path


def _physics(scope: Prim, name: str, friction: float) -> Any:
    prim = scope.child(name, "Material", apis=["PhysicsMaterialAPI", "PhysxMaterialAPI"])
    prim.put("physics:staticFriction", T.Float, friction).put("physics:dynamicFriction", T.Float, friction)
    prim.put("physics:restitution", T.Float, 0.0)
    # MuJoCo takes the larger friction of a pair, PhysX the mean unless told otherwise.
    prim.put("physxMaterial:frictionCombineMode", T.Token, "max", uniform=True)
    return prim.path
