"""Each asset of a scene as a package by itself, laid out and described as SimReady's profile Robotics-Prop wants it."""

import datetime
import json
from collections.abc import Iterator
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import Any

from thinkblox.exporters.inventory import Inventory, InventoryObject
from thinkblox.exporters.naming import Names
from thinkblox.exporters.saving import THUMBS
from thinkblox.exporters.usd import write_prop
from thinkblox.exporters.usd_prims import IDENTITY, said
from thinkblox.exporters.wikidata import wikidata_item
from thinkblox.scene.asset import Asset
from thinkblox.sim.render import render_asset

FOLDER, _STAGES = "simready", "usd"
_SIZE = 256
"""Of a thumbnail [pixels]."""
_FIXED = "it is fixed to the room and has no part that moves: a prop is a body"
_UNNAMED = "no item of Wikidata is known for it, and the profile wants one"


def write_simready(inventory: Inventory, path: Path) -> None:
    """Write packages of assets into `simready` beside `path`, which lists them, and why others are none.

    Each is "<name>/usd/<name>.usda" with a thumbnail, and its description in USD and in "<name>.json" beside it. They
    have the day on which they were made in them, so the same asset does not give the same bytes on another day.
    """
    home, names = path.parent / FOLDER, Names()
    packages, others = [], []
    for item, asset in _each(inventory):
        concept = wikidata_item(item.category)
        why = None if concept else _UNNAMED
        why = why if item.free or len(item.bodies) > 1 else _FIXED
        if why is not None or concept is None:
            others.append({"asset": asset.id, "category": item.category, "because": why})
            continue
        name = names.give(asset.id)
        stage = home / name / _STAGES / f"{name}.usda"
        _write(inventory, item, asset, stage, concept)
        packages.append(
            {"asset": asset.id, "category": item.category, "stage": stage.relative_to(path.parent).as_posix()}
        )
    path.write_text(json.dumps({"packages": packages, "others": others}, indent=2) + "\n", encoding="utf-8")


def _each(inventory: Inventory) -> Iterator[tuple[InventoryObject, Asset]]:
    """The first object of each asset."""
    known = set()
    for item, placement in zip(inventory.objects, inventory.scene.placements, strict=True):
        if item.asset not in known:
            known.add(item.asset)
            yield item, inventory.scene.asset_of(placement)


def _write(inventory: Inventory, item: InventoryObject, asset: Asset, stage: Path, concept: str) -> None:
    name, thumbs = stage.stem, stage.parent / THUMBS
    thumbs.mkdir(parents=True)
    told = {"asset_name": name, "asset_type": "prop", "source_file": stage.name}
    told["usd_date_generated"] = datetime.datetime.now(tz=datetime.UTC).date().isoformat()
    write_prop(replace(inventory, objects=(_at_origin(item, name),)), stage, said(told))
    more: dict[str, Any] = {
        "author": asset.author, "asset_license": asset.licence, "category": item.category, "qcode": concept,
        "rigid_body_count": len(item.bodies), "asset_extents": asset.size, "mass": asset.mass,
    }  # fmt: skip
    stage.with_suffix(".json").write_text(json.dumps(more, indent=2) + "\n", encoding="utf-8")
    picture = BytesIO()
    render_asset(asset, size=_SIZE).save(picture, "PNG")
    (thumbs / f"{stage.name}.png").write_bytes(picture.getvalue())


def _at_origin(item: InventoryObject, name: str) -> InventoryObject:
    """An object under another name, upright at the origin, everything shut, free where it was fixed."""
    first, *joined = item.bodies
    called = {
        body.name: name if body is first else f"{name}{body.name.removeprefix(first.name)}" for body in item.bodies
    }
    home = ((0.0, 0.0, 0.0), IDENTITY)
    bodies = [replace(first, name=name, proposed=home, settled=home, in_object=home)]
    for body in joined:
        assert body.joint is not None
        assert body.parent is not None
        place = (body.joint.anchor, IDENTITY)
        placed = replace(body, proposed=place, settled=place, in_object=place)
        bodies.append(replace(placed, name=called[body.name], parent=called[body.parent]))
    return replace(item, name=name, bodies=tuple(bodies))
