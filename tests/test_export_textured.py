"""A textured mesh all the way: into MJCF and USD, without any effect on what is measured."""

import re
import shutil
from pathlib import Path

import mujoco
import numpy as np
import pytest
from pxr import Usd, UsdGeom, UsdPhysics, UsdShade, UsdValidation

from tests.textured import chequered_png, crate, crate_scene, without_visuals
from thinkblox.checking import VerifyOptions, verify_file
from thinkblox.exporters.saving import save_scene, write_scene
from thinkblox.scene.scene import load_scene
from thinkblox.scene.textured_mesh import mesh_of
from thinkblox.sim.build import build_spec
from thinkblox.sim.verdict.verify import verify
from thinkblox.sim.workers.pool import Job, VerdictPool
from thinkblox.value import to_json


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A saved room, moved elsewhere."""
    home = tmp_path_factory.mktemp("textured")
    save_scene(crate_scene(), home / "room", pictures=False)
    shutil.move(home / "room", home / "elsewhere")
    return home / "elsewhere"


@pytest.fixture(scope="module")
def model(folder: Path) -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_path(str(folder / "scene.xml"))


def test_the_scene_comes_back(folder: Path) -> None:
    assert load_scene(folder) == crate_scene()


def test_verdicts_and_masses_come_from_the_colliders_alone(model: mujoco.MjModel) -> None:
    bare = crate_scene(without_visuals(crate()))
    assert to_json(verify(crate_scene())) == to_json(verify(bare))
    plain = build_spec(bare).compile()
    measured = build_spec(crate_scene()).compile()
    np.testing.assert_array_equal(measured.body_mass, plain.body_mass)
    np.testing.assert_array_equal(measured.body_inertia, plain.body_inertia)
    np.testing.assert_array_equal(measured.body_ipos, plain.body_ipos)
    np.testing.assert_allclose(model.body_mass, plain.body_mass, rtol=1e-5)


def test_pools_need_no_blobs() -> None:
    placement = crate_scene().placements[0]
    job = Job(crate_scene().without(placement.id), crate(), (placement,))
    with VerdictPool(workers=1) as pool:
        (verdicts,) = pool.check([job])
    assert verdicts[0].valid, verdicts[0]


def test_mjcf_shows_the_mesh_and_collides_with_the_boxes(model: mujoco.MjModel) -> None:
    seen = [g for g in range(model.ngeom) if model.geom_bodyid[g] and model.geom_group[g] < 3]
    assert [int(model.geom_type[g]) for g in seen] == [int(mujoco.mjtGeom.mjGEOM_MESH)] * 2
    assert not model.geom_contype[seen].any()
    hidden = [g for g in range(model.ngeom) if model.geom_bodyid[g] and model.geom_group[g] == 3]
    assert [int(model.geom_type[g]) for g in hidden] == [int(mujoco.mjtGeom.mjGEOM_BOX)] * 2
    assert model.geom_contype[hidden].all()
    for geom in seen:
        material = int(model.geom_matid[geom])
        assert model.mat_texid[material, int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] >= 0
    assert model.mat_rgba[int(model.geom_matid[seen[0]])] == pytest.approx((1.0, 0.9, 0.8, 1.0))
    assert model.mat_roughness[int(model.geom_matid[seen[0]])] == pytest.approx(0.6)


def test_mjcf_has_the_texture_the_right_way_up(model: mujoco.MjModel) -> None:
    """The engine keeps the picture's top row first, and its v counts from there."""
    geom = model.geom("crate_1_visual_0").id
    number = int(model.geom_dataid[geom])
    where = slice(model.mesh_vertadr[number], model.mesh_vertadr[number] + model.mesh_vertnum[number])
    turn, points = np.zeros(9), model.mesh_vert[where].astype(float)
    mujoco.mju_quat2Mat(turn, model.geom_quat[geom])
    points = points @ turn.reshape(3, 3).T + model.geom_pos[geom]
    coordinates = slice(model.mesh_texcoordadr[number], model.mesh_texcoordadr[number] + 24)
    assert model.mesh_texcoordnum[number] == 24
    v = model.mesh_texcoord[coordinates, 1]
    corners = model.mesh_facetexcoord[: model.mesh_facenum[number]].ravel()
    heights = points[model.mesh_face[: model.mesh_facenum[number]].ravel(), 2]
    upright = np.repeat(np.abs(_face_normals(model, number, points)[:, 2]) < 0.5, 3)
    np.testing.assert_allclose(v[corners][upright], 1.0 - heights[upright] / 0.5, atol=1e-5)
    picture = model.mat_texid[int(model.geom_matid[geom]), int(mujoco.mjtTextureRole.mjTEXROLE_RGB)]
    texels = model.tex_data[model.tex_adr[picture] :].reshape(-1, 3)
    assert texels[0].tolist() == [200, 40, 30]


def _face_normals(model: mujoco.MjModel, number: int, points: np.ndarray) -> np.ndarray:
    corners = points[model.mesh_face[: model.mesh_facenum[number]]]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return np.asarray(cross / np.linalg.norm(cross, axis=1, keepdims=True))


def test_mjcf_names_files_relative_to_itself(folder: Path) -> None:
    files = re.findall(r'file="([^"]*)"', (folder / "scene.xml").read_text())
    assert len(set(files)) > 3
    assert all(re.fullmatch(r"assets/[0-9a-f]{64}\.(obj|png)", name) and (folder / name).is_file() for name in files)


def test_credits_are_in_the_model_and_on_the_stage(model: mujoco.MjModel, folder: Path) -> None:
    text = bytes(model.text_data).decode()
    assert "CC-BY-4.0" in text
    assert "ada@example.org" in text
    stage = Usd.Stage.Open(str(folder / "scene.usda"))
    prim = stage.GetPrimAtPath("/World/Objects/crate_1")
    data = prim.GetCustomData()
    assert (data["asset"], data["licence"], data["author"]) == ("crate-0", "CC-BY-4.0", crate().author)


def test_usd_binds_the_texture(folder: Path) -> None:
    stage = Usd.Stage.Open(str(folder / "scene.usda"))
    visual = stage.GetPrimAtPath("/World/Objects/crate_1/crate_1/Visual")
    under = visual.GetFilteredChildren(Usd.TraverseInstanceProxies())
    (prim,) = [child for child in under if child.IsA(UsdGeom.Mesh)]
    mesh, expected = UsdGeom.Mesh(prim), mesh_of(crate().links[0].visuals[0].mesh)
    st = UsdGeom.PrimvarsAPI(prim).GetPrimvar("st")
    assert st.GetInterpolation() == "faceVarying"
    corners = expected.faces.ravel()
    np.testing.assert_array_equal(np.array(st.ComputeFlattened()), expected.uv[corners])
    index = np.array(mesh.GetFaceVertexIndicesAttr().Get())
    np.testing.assert_allclose(np.array(mesh.GetPointsAttr().Get())[index], expected.vertices[corners], atol=1e-6)
    material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
    surface, _, _ = material.ComputeSurfaceSource()
    texture = UsdShade.Shader(surface.GetInput("diffuseColor").GetConnectedSources()[0][0].source.GetPrim())
    assert texture.GetShaderId() == "UsdUVTexture"
    file = texture.GetInput("file").Get()
    assert file.path.startswith("./")
    assert Path(file.resolvedPath).read_bytes() == chequered_png()
    reader = UsdShade.Shader(texture.GetInput("st").GetConnectedSources()[0][0].source.GetPrim())
    assert (reader.GetShaderId(), reader.GetInput("varname").Get()) == ("UsdPrimvarReader_float2", "st")


def test_usd_collides_with_the_boxes(folder: Path) -> None:
    stage = Usd.Stage.Open(str(folder / "scene.usda"))
    for link in ("crate_1", "crate_1_lid"):
        prim = stage.GetPrimAtPath(f"/World/Objects/crate_1/{link}")
        colliders = [child for child in Usd.PrimRange(prim) if child.HasAPI(UsdPhysics.CollisionAPI)]
        assert [child.GetTypeName() for child in colliders] == ["Cube"]


def test_openusd_finds_nothing_wrong(folder: Path) -> None:
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    stage = Usd.Stage.Open(str(folder / "scene.usda"))
    errors = UsdValidation.ValidationContext(validators).Validate(stage)
    assert [f"{error.GetName()}: {error.GetMessage()}" for error in errors] == []


def test_a_single_scene_file_brings_its_meshes_along(tmp_path: Path) -> None:
    write_scene(crate_scene(), tmp_path / "mended.json")
    assert load_scene(tmp_path / "mended.json") == crate_scene()
    assert len(list((tmp_path / "assets").iterdir())) == 3


def test_the_same_scene_gives_the_same_bytes(tmp_path: Path, folder: Path) -> None:
    again = save_scene(load_scene(folder), tmp_path / "again", pictures=False)
    names = sorted(path.relative_to(folder) for path in folder.rglob("*") if path.is_file())
    assert names == sorted(path.relative_to(again) for path in again.rglob("*") if path.is_file())
    assert [name for name in names if (folder / name).read_bytes() != (again / name).read_bytes()] == []


def test_what_verify_writes_brings_its_meshes_along(tmp_path: Path, folder: Path) -> None:
    out = tmp_path / "again.json"
    assert verify_file(folder, VerifyOptions(out=str(out))).valid
    assert load_scene(out) == crate_scene()
