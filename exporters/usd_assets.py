"""What many objects share in a stage: the shapes of each link of each asset, stored once and referred to."""

from typing import Any

from pxr import Sdf, Tf

from thinkblox.exporters.inventory import InventoryBody, InventoryLook, InventoryObject
from thinkblox.exporters.usd_looks import BINDING, Looks
from thinkblox.exporters.usd_prims import Prim, T
from thinkblox.exporters.usd_shapes import add_colliders, add_visuals

SHELF = "Assets"
"""The class beside the default prim that holds them; classes are not drawn."""


class Shelf:
    """The visuals and colliders of links, each written when first asked for."""

    def __init__(self, layer: Any, looks: dict[str, InventoryLook], friction: Looks) -> None:
        self._root = Prim(Sdf.PrimSpec(layer, SHELF, Sdf.SpecifierClass, "Scope"))
        self._looks, self._friction = looks, friction
        self._links: dict[tuple[str, str], Prim] = {}

    def fill(self, prim: Prim, item: InventoryObject, body: InventoryBody) -> None:
        """Give a body its scopes "Visual" and "Collision".

        Visuals are instances, so that they are kept once; colliders are not, as some readers lose those of instances.
        """
        link = self._link(item, body)
        prim.child("Visual", "Scope").refer(link.path.AppendChild("Visual"), instance=True)
        if any(geom.collides for geom in body.geoms):
            scope = prim.child("Collision", "Scope", apis=[BINDING]).refer(link.path.AppendChild("Collision"))
            self._friction.bind_friction(scope, next(geom.friction[0] for geom in body.geoms if geom.collides))

    def _link(self, item: InventoryObject, body: InventoryBody) -> Prim:
        key = (item.asset, body.link)
        if key not in self._links:
            prim = self._root.child(Tf.MakeValidIdentifier(f"{item.asset}_{body.link}"), "Scope")
            seen = prim.child("Visual", "Scope")
            add_visuals(seen, body.geoms, Looks(seen.child("Looks", "Scope"), self._looks))
            scope = prim.child("Collision", "Scope").put("purpose", T.Token, "guide", uniform=True)
            add_colliders(scope, body.geoms)
            self._links[key] = prim
        return self._links[key]
