"""Objects in USD: articulations with links side by side, single bodies, and what is fixed."""

from thinkblox.exporters.inventory import InventoryBody, InventoryObject
from thinkblox.exporters.usd_assets import Shelf
from thinkblox.exporters.usd_joints import add_joint, fix_to_room
from thinkblox.exporters.usd_prims import Prim, T, quaternion, said, vector
from thinkblox.exporters.wikidata import wikidata_item

LABELS, _CONCEPT = "SemanticsLabelsAPI:class", "SemanticsLabelsAPI:wikidata_qcode"
_BODY = ("PhysicsRigidBodyAPI", "PhysicsMassAPI")


def add_object(parent: Prim, item: InventoryObject, shelf: Shelf) -> None:
    """Add an object: an articulation, or one body, or for what is fixed colliders and looks only.

    Licence and author of its asset are its custom data.
    """
    first, *joined = item.bodies
    rigid = item.free and not joined
    concept = wikidata_item(item.category)
    apis = [LABELS, *(_BODY if rigid else ()), *(["PhysicsArticulationRootAPI"] if joined else [])]
    apis += [_CONCEPT] if concept else []
    prim = parent.child(item.name, "Xform", apis=apis, kind="component").place(*first.settled)
    prim.spec.customData = said({"id": item.id, "asset": item.asset, "licence": item.licence, "author": item.author})
    add_label(prim, item.category)
    if concept:
        prim.put("semantics:labels:wikidata_qcode", T.TokenArray, [concept])
    if joined:
        _add_links(prim, item, shelf)
    else:
        _fill(prim, item, first, shelf, weighs=rigid)


def add_label(prim: Prim, label: str) -> None:
    """Say what a prim is, for segmentation; it must have the API named LABELS."""
    prim.put("semantics:labels:class", T.TokenArray, [label])


def _add_links(prim: Prim, item: InventoryObject, shelf: Shelf) -> None:
    first, *joined = item.bodies
    base = _add_link(prim, item, first, shelf)
    links: dict[str, Prim] = {first.name: base}
    for body in joined:
        child = _add_link(prim, item, body, shelf)
        child.link("physics:filteredPairs", [other.path for name, other in links.items() if name != body.parent])
        links[body.name] = child
    joints = prim.child("Joints", "Scope")
    if not item.free:
        fix_to_room(joints, base.path, *first.settled)
    for body in joined:
        if body.joint is not None and body.parent is not None:
            add_joint(joints, body.name, body.joint, links[body.parent].path, links[body.name].path)


def _add_link(parent: Prim, item: InventoryObject, body: InventoryBody, shelf: Shelf) -> Prim:
    apis = [LABELS, *_BODY, *(["PhysicsFilteredPairsAPI"] if body.joint is not None else [])]
    prim = parent.child(body.name, "Xform", apis=apis).place(*body.in_object)
    prim.spec.customData = said({"link": body.link})
    add_label(prim, body.label)
    _fill(prim, item, body, shelf, weighs=True)
    return prim


def _fill(prim: Prim, item: InventoryObject, body: InventoryBody, shelf: Shelf, *, weighs: bool) -> None:
    if weighs:
        prim.put("physics:mass", T.Float, body.mass)
        prim.put("physics:centerOfMass", T.Point3f, vector(body.centre))
        prim.put("physics:diagonalInertia", T.Float3, vector(body.inertia))
        prim.put("physics:principalAxes", T.Quatf, quaternion(body.axes))
    shelf.fill(prim, item, body)
