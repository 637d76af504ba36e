"""What many objects share in a stage: the shapes of each link of each asset, stored once and referred to."""

import hashlib
from collections.abc import Mapping
from typing import Any

from pxr import Sdf, Tf

from thinkblox.exporters.inventory import Inventory, InventoryBody, InventoryLook, InventoryObject
from thinkblox.exporters.naming import Names
from thinkblox.exporters.usd_looks import Looks
from thinkblox.exporters.usd_prims import Prim, T, in_binary, put_units, said
from thinkblox.exporters.usd_shapes import add_colliders, add_visuals
from thinkblox.scene.blobs import FOLDER

SHELF = "Assets"
"""The class beside the default prim that holds them in a stage that stands alone; classes are not drawn."""


class AssetLayers:
    """The layer of each asset of an inventory, which is a payload of the objects that are made of it, and the room's.

    Attributes:
        files: its bytes, by its path relative to the stage that names it.
    """

    def __init__(self, inventory: Inventory) -> None:
        self.files: dict[str, bytes] = {}
        self._names: dict[str, str] = {}
        for item in inventory.objects:
            if item.asset not in self._names:
                self._names[item.asset] = self.add(_asset_layer(item, inventory.looks))

    def add(self, layer: Any) -> str:
        """Take one more layer; returns its path."""
        data = in_binary(layer)
        name = f"{FOLDER}/{hashlib.sha256(data).hexdigest()}.usdc"
        self.files[name] = data
        return name

    def file_of(self, item: InventoryObject) -> str:
        """The path of the layer that an object's asset is in."""
        return self._names[item.asset]


class Shelf:
    """The visuals and colliders of links.

    Args:
        layer: the stage's own.
        looks: by name.
        layers: where they lie; None to keep them in the stage's own layer, each written when first asked for.
    """

    def __init__(self, layer: Any, looks: Mapping[str, InventoryLook], layers: AssetLayers | None = None) -> None:
        self._layer, self._looks, self._layers = layer, looks, layers
        self._links: dict[tuple[str, str], Prim] = {}
        self._root: Prim | None = None

    def fill(self, prim: Prim, item: InventoryObject, body: InventoryBody) -> None:
        """Give a body its scopes "Visual" and "Collision".

        Visuals are instances, so that they are kept once; colliders are not, as some readers lose those of instances.
        """
        self._take(prim.child("Visual", "Scope"), item, body, "Visual", instance=True)
        if any(geom.collides for geom in body.geoms):
            self._take(prim.child("Collision", "Scope"), item, body, "Collision")

    def _take(
        self, scope: Prim, item: InventoryObject, body: InventoryBody, what: str, *, instance: bool = False
    ) -> None:
        if self._layers is not None:
            path = Sdf.Path(f"/{_ASSET}").AppendChild(_link_names(item)[body.link]).AppendChild(what)
            scope.load(f"./{self._layers.file_of(item)}", path, instance=instance)
        else:
            scope.refer(self._link(item, body).path.AppendChild(what), instance=instance)

    def _link(self, item: InventoryObject, body: InventoryBody) -> Prim:
        key = (item.asset, body.link)
        if key not in self._links:
            self._root = self._root or Prim(Sdf.PrimSpec(self._layer, SHELF, Sdf.SpecifierClass, "Scope"))
            prim = self._root.child(Tf.MakeValidIdentifier(f"{item.asset}_{body.link}"), "Scope")
            _add_link(prim, body, self._looks)
            self._links[key] = prim
        return self._links[key]


_ASSET = "Asset"
"""The default prim of an asset's layer."""


def _link_names(item: InventoryObject) -> dict[str, str]:
    """What the links of an asset are called in its layer, by what they are called in the asset."""
    return Names().give_all(body.link for body in item.bodies)


def _asset_layer(item: InventoryObject, looks: Mapping[str, InventoryLook]) -> Any:
    """All that can be seen and touched of an asset's links, each in its own frame, without pose or mass."""
    layer = Sdf.Layer.CreateAnonymous(".usdc")
    with Sdf.ChangeBlock():
        put_units(layer)
        layer.defaultPrim = _ASSET
        root = Prim(Sdf.PrimSpec(layer, _ASSET, Sdf.SpecifierDef, "Xform"))
        root.spec.kind = "component"
        root.spec.customData = said({"id": item.asset, "licence": item.licence, "author": item.author})
        names = _link_names(item)
        for body in item.bodies:
            _add_link(Prim(Sdf.PrimSpec(root.spec, names[body.link], Sdf.SpecifierDef, "Xform")), body, looks, ".")
    return layer


def _add_link(prim: Prim, body: InventoryBody, looks: Mapping[str, InventoryLook], folder: str = f"./{FOLDER}") -> None:
    seen = prim.child("Visual", "Scope")
    add_visuals(seen, body.geoms, Looks(seen.child("Looks", "Scope"), looks, folder))
    if any(geom.collides for geom in body.geoms):
        scope = prim.child("Collision", "Scope").put("purpose", T.Token, "guide", uniform=True)
        add_colliders(scope, body.geoms, Looks(scope.child("Looks", "Scope"), looks, folder))
