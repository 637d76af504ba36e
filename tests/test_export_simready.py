"""Packages of single assets: where SimReady looks for things, and what is said of them."""

import json
from pathlib import Path

import pytest
from msgspec import structs
from PIL import Image
from pxr import Usd, UsdPhysics, UsdSemantics

from tests.sim_rooms import asset, put, scene, table, wardrobe
from thinkblox.exporters.exporting import export_scene


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    gadget = structs.replace(asset("gadget", (0.2, 0.2, 0.2)), mount="surface")
    shelf = structs.replace(asset("wall_shelf", (0.2, 0.6, 0.1)), mount="wall")
    room = scene(
        None, (put(table(), 1.0, 1.5, yaw=30.0), table()), (put(table(), 3.0, 1.5, id="table_2"), table()),
        (put(wardrobe(), 2.0, 4.0, yaw=-90.0), wardrobe()), (put(gadget, 1.0, 4.0), gadget),
        (put(shelf, 0.1, 3.0, 1.5), shelf),
    )  # fmt: skip
    return export_scene(room, tmp_path_factory.mktemp("simready") / "out", formats=("simready",))


def test_each_asset_is_a_package_or_told_why_not(folder: Path) -> None:
    told = json.loads((folder / "scene.simready.json").read_text())
    assert [package["asset"] for package in told["packages"]] == ["table-0", "wardrobe-0"]
    assert {other["asset"]: other["because"].split()[0] for other in told["others"]} == {
        "gadget-0": "no", "wall_shelf-0": "it",
    }  # fmt: skip
    assert sorted(path.name for path in (folder / "simready").iterdir()) == ["table_0", "wardrobe_0"]


def test_a_package_is_where_it_is_looked_for(folder: Path) -> None:
    for name, bodies in (("table_0", 1), ("wardrobe_0", 3)):
        home = folder / "simready" / name / "usd"
        assert {file.name for file in home.glob("*.usd*")} == {f"{name}.usda"}
        assert Image.open(home / ".thumbs/256x256" / f"{name}.usda.png").size == (256, 256)
        stage = Usd.Stage.Open(str(home / f"{name}.usda"))
        data = {**stage.GetRootLayer().customLayerData, **json.loads((home / f"{name}.json").read_text())}
        assert data["qcode"] == "Q14748" if name == "table_0" else "Q14745"
        assert (data["asset_name"], data["asset_type"], data["rigid_body_count"]) == (name, "prop", bodies)
        assert data["SimReady_Metadata"]["source_file"] == f"{name}.usda"
        assert sum(prim.HasAPI(UsdPhysics.RigidBodyAPI) for prim in stage.Traverse()) == bodies
        (item,) = stage.GetPrimAtPath("/World/Objects").GetChildren()
        assert item.GetName() == name
        assert UsdSemantics.LabelsAPI(item, "wikidata_qcode").GetLabelsAttr().Get()
        assert not stage.GetPrimAtPath("/World/Room")


def test_a_prop_stands_at_the_origin_with_its_doors_shut(folder: Path) -> None:
    stage = Usd.Stage.Open(str(folder / "simready/wardrobe_0/usd/wardrobe_0.usda"))
    item = stage.GetPrimAtPath("/World/Objects/wardrobe_0")
    assert list(item.GetAttribute("xformOp:translate").Get()) == [0.0, 0.0, 0.0]
    door = stage.GetPrimAtPath("/World/Objects/wardrobe_0/wardrobe_0_door_left")
    assert list(door.GetAttribute("xformOp:translate").Get()) == pytest.approx([0.28, 0.5, 0.0])
    assert item.GetCustomDataByKey("asset") == "wardrobe-0"
