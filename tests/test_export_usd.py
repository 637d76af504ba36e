"""scene.usda as OpenUSD reads it, held against the compiled model and against faults that validators miss."""

import math
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
from msgspec import structs
from pxr import Gf, Kind, Sdf, Usd, UsdGeom, UsdPhysics, UsdSemantics, UsdShade, UsdValidation

from tests.export_rooms import L_ROOM, sample_scene
from tests.sim_rooms import put
from thinkblox.assets import CATALOGUE, make_asset
from thinkblox.exporters.mjcf import mjcf_text
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.exporters.usd import usd_text, write_usd
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.settle import settle


@pytest.fixture(scope="module")
def stage(tmp_path_factory: pytest.TempPathFactory) -> Any:
    return written(sample_scene(), tmp_path_factory.mktemp("stage"))


def written(scene: Scene, folder: Path) -> Any:
    """A scene as it is read back."""
    write_usd(inventory_of(scene), folder / "scene.usda")
    return Usd.Stage.Open(str(folder / "scene.usda"))


def everything(prim: Any) -> Iterator[Any]:
    """A prim and all that is under it, in instances too."""
    return iter(Usd.PrimRange(prim, Usd.TraverseInstanceProxies()))


@pytest.fixture(scope="module")
def physics() -> tuple[mujoco.MjModel, mujoco.MjData]:
    model = build_spec(sample_scene()).compile()
    data = mujoco.MjData(model)
    data.qpos[:] = settle(sample_scene()).qpos
    mujoco.mj_kinematics(model, data)
    return model, data


def prims(stage: Any, api: Any) -> Iterator[Any]:
    return (prim for prim in stage.Traverse() if prim.HasAPI(api))


def path_of(body: str) -> str:
    id, _, link = body.partition("/")
    if link:
        return f"/World/Objects/{id}/{id}_{link}"
    jointed = {"wardrobe_1", "cupboard_1"}
    return f"/World/Objects/{id}/{id}" if id in jointed else f"/World/Objects/{id}"


def frame_of(name: str, data: mujoco.MjData) -> np.ndarray:
    """Where the frame of a body begins: on its joint's axis, if it has one."""
    model, body = data.model, data.body(name)
    joint = int(model.body_jntadr[body.id])
    if joint < 0 or model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE:
        return np.array(body.xpos)
    return np.array(body.xpos + body.xmat.reshape(3, 3) @ model.jnt_pos[joint])


def world_pose(prim: Any) -> tuple[np.ndarray, np.ndarray]:
    matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
    quat = matrix.ExtractRotationQuat()
    return np.array(matrix.ExtractTranslation()), np.array([quat.real, *quat.imaginary])


def _turn(prim: Any) -> np.ndarray:
    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, world_pose(prim)[1])
    return turn.reshape(3, 3)


def test_stage_metadata(stage: Any) -> None:
    root = stage.GetDefaultPrim()
    assert [prim.GetName() for prim in stage.GetPseudoRoot().GetChildren()] == ["World"]
    assert (root.GetPath(), root.GetTypeName(), Usd.ModelAPI(root).GetKind()) == ("/World", "Xform", "assembly")
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    assert (UsdGeom.GetStageMetersPerUnit(stage), UsdPhysics.GetStageKilogramsPerUnit(stage)) == (1.0, 1.0)
    assert stage.GetRootLayer().customLayerData["mujoco"] == mujoco.__version__


def test_one_physics_scene_with_its_gravity(stage: Any) -> None:
    (scene,) = [UsdPhysics.Scene(prim) for prim in stage.Traverse() if prim.IsA(UsdPhysics.Scene)]
    assert scene.GetGravityDirectionAttr().Get() == Gf.Vec3f(0, 0, -1)
    assert scene.GetGravityMagnitudeAttr().Get() == pytest.approx(9.81)


def test_openusd_finds_nothing_wrong(tmp_path: Path) -> None:
    write_usd(inventory_of(sample_scene()), tmp_path / "scene.usda")
    stage = Usd.Stage.Open(str(tmp_path / "scene.usda"))
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    errors = UsdValidation.ValidationContext(validators).Validate(stage)
    assert [f"{error.GetName()}: {error.GetMessage()}" for error in errors] == []


def test_poses_are_those_of_the_settled_model(stage: Any, physics: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = physics
    for number in range(1, model.nbody):
        name = model.body(number).name
        position, quat = world_pose(stage.GetPrimAtPath(path_of(name)))
        np.testing.assert_allclose(position, frame_of(name, data), atol=1e-6, err_msg=name)
        assert abs(quat @ data.xquat[number]) == pytest.approx(1.0, abs=1e-9)


def test_masses_are_those_of_the_model(stage: Any, physics: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = physics
    mujoco.mj_comPos(model, data)
    bodies = list(prims(stage, UsdPhysics.RigidBodyAPI))
    by_path = {path_of(model.body(number).name): number for number in range(1, model.nbody)}
    for prim in bodies:
        body, mass = by_path[prim.GetPath().pathString], UsdPhysics.MassAPI(prim)
        assert mass.GetMassAttr().Get() == pytest.approx(model.body_mass[body])
        centre = world_pose(prim)[0] + _turn(prim) @ np.array(mass.GetCenterOfMassAttr().Get())
        np.testing.assert_allclose(centre, data.xipos[body], atol=2e-6)
        np.testing.assert_allclose(mass.GetDiagonalInertiaAttr().Get(), model.body_inertia[body], rtol=1e-5)
        axes = mass.GetPrincipalAxesAttr().Get()
        np.testing.assert_allclose([axes.real, *axes.imaginary], model.body_iquat[body], atol=1e-6)
    assert len(bodies) == 3 + 3 + 3  # table, vase, sampler; wardrobe and doors; cupboard, drawer and flap


def test_inertias_are_possible(stage: Any) -> None:
    for prim in prims(stage, UsdPhysics.MassAPI):
        low, middle, high = sorted(UsdPhysics.MassAPI(prim).GetDiagonalInertiaAttr().Get())
        assert 0.0 < low <= middle <= high <= (low + middle) * (1 + 1e-5)


def test_joint_frames_agree_and_limits_are_in_order(stage: Any) -> None:
    joints = [UsdPhysics.Joint(prim) for prim in stage.Traverse() if prim.IsA(UsdPhysics.Joint)]
    assert len(joints) == 5
    for joint in joints:
        ends = []
        for side, body in enumerate((joint.GetBody0Rel(), joint.GetBody1Rel())):
            position = getattr(joint, f"GetLocalPos{side}Attr")().Get()
            turn = getattr(joint, f"GetLocalRot{side}Attr")().Get()
            frame = Gf.Matrix4d().SetRotate(Gf.Quatd(turn)) * Gf.Matrix4d().SetTranslate(Gf.Vec3d(position))
            target = body.GetTargets()
            prim = stage.GetPrimAtPath(target[0]) if target else stage.GetPseudoRoot()
            above = UsdGeom.XformCache().GetLocalToWorldTransform(prim)
            ends.append(np.array(frame * above))
        np.testing.assert_allclose(ends[0], ends[1], atol=1e-4, err_msg=str(joint.GetPath()))


@pytest.mark.parametrize(
    ("path", "kind", "axis", "lower", "upper"),
    [
        ("wardrobe_1/Joints/wardrobe_1_door_left", UsdPhysics.RevoluteJoint, (0.0, 0.0, 1.0), 0.0, 110.0),
        ("wardrobe_1/Joints/wardrobe_1_door_right", UsdPhysics.RevoluteJoint, (0.0, 0.0, -1.0), 0.0, 110.0),
        ("cupboard_1/Joints/cupboard_1_drawer", UsdPhysics.PrismaticJoint, (1.0, 0.0, 0.0), 0.0, 0.25),
        ("cupboard_1/Joints/cupboard_1_flap", UsdPhysics.RevoluteJoint, (0.0, -0.8, 0.6), 0.0, 60.0),
    ],
)
def test_joints(stage: Any, path: str, kind: Any, axis: tuple[float, float, float], lower: float, upper: float) -> None:
    joint = kind(stage.GetPrimAtPath(f"/World/Objects/{path}"))
    assert (joint.GetLowerLimitAttr().Get(), joint.GetUpperLimitAttr().Get()) == (lower, upper)
    unit = Gf.Vec3d(*(float(joint.GetAxisAttr().Get() == name) for name in "XYZ"))
    turned = Gf.Rotation(Gf.Quatd(joint.GetLocalRot0Attr().Get())).TransformDir(unit)
    np.testing.assert_allclose(turned, axis, atol=1e-6)


def test_opened_joints_bring_their_links_where_the_model_does(stage: Any) -> None:
    model = build_spec(sample_scene()).compile()
    data = mujoco.MjData(model)
    for name, body in (("wardrobe_1/door_right", "wardrobe_1"), ("cupboard_1/drawer", "cupboard_1"),
                       ("cupboard_1/flap", "cupboard_1")):  # fmt: skip
        id, link = name.split("/")
        joint = UsdPhysics.Joint(stage.GetPrimAtPath(f"/World/Objects/{id}/Joints/{id}_{link}"))
        opened = 0.5 * joint.GetPrim().GetAttribute("physics:upperLimit").Get()
        unit = Gf.Vec3d(*(float(joint.GetPrim().GetAttribute("physics:axis").Get() == axis) for axis in "XYZ"))
        hinge = joint.GetPrim().IsA(UsdPhysics.RevoluteJoint)
        motion = Gf.Matrix4d(1.0)
        motion = motion.SetRotate(Gf.Rotation(unit, opened)) if hinge else motion.SetTranslate(unit * opened)
        frames = [
            Gf.Matrix4d().SetRotate(Gf.Quatd(turn.Get())) * Gf.Matrix4d().SetTranslate(Gf.Vec3d(position.Get()))
            for position, turn in (
                (joint.GetLocalPos0Attr(), joint.GetLocalRot0Attr()),
                (joint.GetLocalPos1Attr(), joint.GetLocalRot1Attr()),
            )
        ]
        relative = frames[1].GetInverse() * motion * frames[0]
        data.qpos[model.joint(name).qposadr[0]] = np.radians(opened) if hinge else opened
        mujoco.mj_kinematics(model, data)
        turn = data.body(body).xmat.reshape(3, 3)
        expected = turn.T @ (frame_of(name, data) - data.body(body).xpos)
        np.testing.assert_allclose(relative.ExtractTranslation(), expected, atol=1e-6)
        expected_turn = turn.T @ data.body(name).xmat.reshape(3, 3)
        np.testing.assert_allclose(np.array(relative.ExtractRotationMatrix()).T, expected_turn, atol=1e-6)


def test_joints_rub_and_are_damped_as_in_the_model(stage: Any, physics: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    """PhysX and Newton take efforts in N m or N, and damping of angles by the degree."""
    model, _ = physics
    for source in ("wardrobe_1/door_left", "wardrobe_1/door_right", "cupboard_1/drawer", "cupboard_1/flap"):
        dof, id = int(model.joint(source).dofadr[0]), source.partition("/")[0]
        prim = stage.GetPrimAtPath(f"/World/Objects/{id}/Joints/{source.replace('/', '_')}")
        side = "angular" if prim.IsA(UsdPhysics.RevoluteJoint) else "linear"
        assert {f"PhysxJointAxisAPI:{side}", "NewtonJointAPI"} <= set(prim.GetPrimTypeInfo().GetAppliedAPISchemas())
        damping = model.dof_damping[dof] * (np.pi / 180 if side == "angular" else 1.0)
        expected = {
            f"physxJointAxis:{side}:staticFrictionEffort": model.dof_frictionloss[dof],
            f"physxJointAxis:{side}:dynamicFrictionEffort": model.dof_frictionloss[dof],
            f"physxJointAxis:{side}:viscousFrictionCoefficient": damping,
            "newton:friction": model.dof_frictionloss[dof],
            "newton:damping": damping,
        }
        for name, value in expected.items():
            assert prim.GetAttribute(name).Get() == pytest.approx(value, rel=1e-6), name


@pytest.mark.slow
def test_the_catalogue_can_be_exported(tmp_path: Path) -> None:
    scene = Scene(room=rectangle(30.0, 30.0))
    for number, category in enumerate([name for name, kind in CATALOGUE.items() if not kind.plain][::7]):
        asset = make_asset(category, seed=number)
        height = {"wall": 1.0, "ceiling": 2.6 - asset.size[2]}.get(asset.mount, 0.0)
        placement = put(asset, 2.5 + 4.0 * (number % 7), 2.5 + 4.0 * (number // 7), height)
        scene = scene.with_placement(placement, asset)
    write_usd(inventory_of(scene), tmp_path / "scene.usda")
    stage = Usd.Stage.Open(str(tmp_path / "scene.usda"))
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    errors = UsdValidation.ValidationContext(validators).Validate(stage)
    assert [f"{error.GetName()}: {error.GetMessage()}" for error in errors] == []
    model = build_spec(scene).compile()
    exported = sum(UsdPhysics.MassAPI(prim).GetMassAttr().Get() for prim in prims(stage, UsdPhysics.MassAPI))
    fixed = sum(
        model.body(p.id).subtreemass[0]
        for p in scene.placements
        if not scene.asset_of(p).free and len(scene.asset_of(p).links) == 1
    )
    assert exported + fixed == pytest.approx(model.body_mass.sum(), rel=1e-5)


def test_articulations_are_roots_with_links_side_by_side(stage: Any) -> None:
    roots = list(prims(stage, UsdPhysics.ArticulationRootAPI))
    assert [root.GetName() for root in roots] == ["wardrobe_1", "cupboard_1"]
    for prim in prims(stage, UsdPhysics.RigidBodyAPI):
        above = prim.GetParent()
        while above:
            assert not above.HasAPI(UsdPhysics.RigidBodyAPI)
            above = above.GetParent()
    mount = UsdPhysics.FixedJoint(stage.GetPrimAtPath("/World/Objects/cupboard_1/Joints/mount"))
    assert not mount.GetBody0Rel().GetTargets()
    right = UsdPhysics.FilteredPairsAPI(stage.GetPrimAtPath("/World/Objects/wardrobe_1/wardrobe_1_door_right"))
    assert right.GetFilteredPairsRel().GetTargets() == ["/World/Objects/wardrobe_1/wardrobe_1_door_left"]


def test_every_body_is_solid_and_unscaled(stage: Any) -> None:
    for prim in prims(stage, UsdPhysics.RigidBodyAPI):
        assert any(child.HasAPI(UsdPhysics.CollisionAPI) for child in Usd.PrimRange(prim)), prim.GetPath()
        matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
        assert Gf.Transform(matrix).GetScale() == pytest.approx((1.0, 1.0, 1.0), abs=1e-9)


def test_what_is_fixed_has_no_body_and_a_rug_no_collider(stage: Any) -> None:
    picture, rug = (stage.GetPrimAtPath(f"/World/Objects/{id}") for id in ("picture_1", "rug_1"))
    assert not picture.HasAPI(UsdPhysics.RigidBodyAPI)
    assert any(prim.HasAPI(UsdPhysics.CollisionAPI) for prim in Usd.PrimRange(picture))
    assert not any(prim.HasAPI(UsdPhysics.CollisionAPI) for prim in Usd.PrimRange(rug))
    assert not any(prim.HasAPI(UsdPhysics.RigidBodyAPI) for prim in Usd.PrimRange(stage.GetPrimAtPath("/World/Room")))


def test_colliders_are_convex_and_have_friction(stage: Any) -> None:
    kinds = set()
    for prim in prims(stage, UsdPhysics.CollisionAPI):
        kinds.add(prim.GetTypeName())
        if prim.IsA(UsdGeom.Mesh):
            assert UsdPhysics.MeshCollisionAPI(prim).GetApproximationAttr().Get() == "convexHull"
        material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial("physics")
        rubbing = UsdPhysics.MaterialAPI(material.GetPrim())
        assert rubbing.GetStaticFrictionAttr().Get() == rubbing.GetDynamicFrictionAttr().Get() > 0.0
        assert UsdGeom.Imageable(prim).ComputePurpose() == "guide"
        # OpenUSD's reader of physics, and with it Newton's, knows direct bindings only.
        bound = UsdShade.MaterialBindingAPI(prim).GetDirectBindingRel("physics").GetTargets()
        assert bound == [material.GetPath()]
    assert kinds == {"Cube", "Cylinder", "Capsule", "Sphere", "Mesh"}


def test_colliders_fill_what_the_model_fills(stage: Any, physics: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = physics
    mujoco.mj_forward(model, data)
    cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["guide"])
    for id in ("sampler_1", "table_1", "vase_1"):
        box = cache.ComputeWorldBound(stage.GetPrimAtPath(f"/World/Objects/{id}/Collision")).ComputeAlignedRange()
        geoms = [g for g in range(model.ngeom) if model.body(int(model.geom_bodyid[g])).name == id]
        low = min(_lowest(model, data, g) for g in geoms)
        assert box.GetMin()[2] == pytest.approx(low, abs=2e-3)


def _lowest(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> float:
    centre, half = model.geom_aabb[geom][:3], model.geom_aabb[geom][3:]
    turn = data.geom_xmat[geom].reshape(3, 3)
    return float(data.geom_xpos[geom][2] + turn[2] @ centre - np.abs(turn[2]) @ half)


def edges_of(mesh: Any) -> Counter[frozenset[int]]:
    """How many faces of a mesh have each edge."""
    edges: Counter[frozenset[int]] = Counter()
    indices, first = list(mesh.GetFaceVertexIndicesAttr().Get()), 0
    for count in mesh.GetFaceVertexCountsAttr().Get():
        face = indices[first : first + count]
        edges.update(frozenset(edge) for edge in zip(face, [*face[1:], face[0]], strict=True))
        first += count
    return edges


def test_visible_meshes_are_complete(stage: Any) -> None:
    every = everything(stage.GetPseudoRoot())
    meshes = [prim for prim in every if prim.IsA(UsdGeom.Mesh) and not prim.HasAPI(UsdPhysics.CollisionAPI)]
    assert len([mesh for mesh in meshes if "/Objects/" in str(mesh.GetPath())]) > 7
    for prim in meshes:
        mesh = UsdGeom.Mesh(prim)
        points, normals = np.array(mesh.GetPointsAttr().Get()), np.array(mesh.GetNormalsAttr().Get())
        counts, index = mesh.GetFaceVertexCountsAttr().Get(), np.array(mesh.GetFaceVertexIndicesAttr().Get())
        assert mesh.GetSubdivisionSchemeAttr().Get() == "none"
        assert mesh.GetNormalsInterpolation() == "faceVarying"
        assert len(index) == len(normals)
        assert len(np.unique(points, axis=0)) == len(points)
        assert max(edges_of(mesh).values()) <= 2, "more than two faces at an edge are no surface with an inside"
        assert sum(counts) == len(index)
        assert (index.min(), index.max()) == (0, len(points) - 1)
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-3)
        np.testing.assert_allclose(mesh.GetExtentAttr().Get(), [points.min(axis=0), points.max(axis=0)], atol=1e-6)
        material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        shader, _, _ = material.ComputeSurfaceSource()
        assert shader.GetShaderId() == "UsdPreviewSurface"


def test_faces_and_normals_point_outwards(stage: Any) -> None:
    table = everything(stage.GetPrimAtPath("/World/Objects/table_1/Visual"))
    prim = UsdGeom.Mesh(next(prim for prim in table if prim.IsA(UsdGeom.Mesh)))
    points, normals = np.array(prim.GetPointsAttr().Get()), np.array(prim.GetNormalsAttr().Get())
    for quad, facing in zip(
        np.array(prim.GetFaceVertexIndicesAttr().Get()).reshape(-1, 4), normals.reshape(-1, 4, 3), strict=True
    ):
        a, b, c, _ = points[quad]
        winding = np.cross(b - a, c - b)
        np.testing.assert_allclose(winding / np.linalg.norm(winding), facing[0], atol=1e-3)


def test_walls_leave_their_openings_free(stage: Any) -> None:
    walls = [p for p in stage.GetPrimAtPath("/World/Room").GetChildren() if p.GetName().endswith(("wall", "wall_2"))]
    assert {wall.GetName() for wall in walls} == {wall.name for wall in L_ROOM.walls}
    south = stage.GetPrimAtPath("/World/Room/south_wall/Collision").GetChildren()
    assert len(south) == 3  # left of the door, right of it, above it
    floor = UsdGeom.Mesh(stage.GetPrimAtPath("/World/Room/floor/Visual/floor"))
    points, faces = np.array(floor.GetPointsAttr().Get()), np.array(floor.GetFaceVertexIndicesAttr().Get())
    corners = points[faces.reshape(-1, 3)]
    area = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2].sum() / 2
    assert area == pytest.approx(L_ROOM.polygon.area)


def test_a_chair_is_stored_once(tmp_path: Path) -> None:
    room, kind = rectangle(8.0, 8.0), make_asset("chair", seed=0)
    sizes = {}
    for many in (1, 8):
        scene = Scene(room=room)
        for number in range(many):
            scene = scene.with_placement(put(kind, 0.9 * number + 0.8, 2.0, id=f"chair_{number + 1}"), kind)
        (tmp_path / str(many)).mkdir()
        stage = written(scene, tmp_path / str(many))
        sizes[many] = sum(file.stat().st_size for file in (tmp_path / str(many)).rglob("*") if file.is_file())
    chairs = stage.GetPrimAtPath("/World/Objects").GetChildren()
    assert len(chairs) == 8
    seen = [stage.GetPrimAtPath(chair.GetPath().AppendChild("Visual")) for chair in chairs]
    assert all(visual.IsInstance() for visual in seen)
    assert len({str(visual.GetPrototype().GetPath()) for visual in seen}) == 1
    assert all(chair.HasAPI(UsdPhysics.RigidBodyAPI) and not chair.IsInstance() for chair in chairs)
    assert sizes[8] - sizes[1] < 8 * 2500
    for chair in chairs:
        parts = list(everything(chair))
        assert any(prim.HasAPI(UsdPhysics.CollisionAPI) for prim in parts)
        for prim in parts:
            if prim.IsA(UsdGeom.Mesh) and not prim.HasAPI(UsdPhysics.CollisionAPI):
                material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
                assert material.GetSurfaceOutput(), prim.GetPath()


def test_colliding_hulls_have_normals_and_touch_where_the_model_does(stage: Any) -> None:
    hulls = list(prims(stage, UsdPhysics.MeshCollisionAPI))
    assert len(hulls) == 2
    for prim in hulls:
        mesh = UsdGeom.Mesh(prim)
        points, index = np.array(mesh.GetPointsAttr().Get()), np.array(mesh.GetFaceVertexIndicesAttr().Get())
        normals = np.array(mesh.GetNormalsAttr().Get())
        assert mesh.GetNormalsInterpolation() == "faceVarying"
        assert len(normals) == len(index)
        outward = (points[index] - points.mean(axis=0)) * normals
        assert outward.sum(axis=1).min() > 0.0


def test_the_room_has_its_parts(stage: Any) -> None:
    labels = {
        prim.GetName(): UsdSemantics.LabelsAPI(prim, "class").GetLabelsAttr().Get()[0]
        for prim in stage.GetPrimAtPath("/World/Room").GetChildren()
    }
    for name, label in (("floor", "floor"), ("ceiling", "ceiling"), ("door_1", "door"), ("window_1", "window")):
        assert labels[name] == label
    prim = next(p for p in everything(stage.GetPrimAtPath("/World/Room/floor/Visual")) if p.IsA(UsdGeom.Mesh))
    st = np.array(UsdGeom.PrimvarsAPI(prim).GetPrimvar("st").Get())
    assert (st.min(), st.max()) == (pytest.approx(0.0, abs=1e-5), pytest.approx(1.0, abs=1e-5))
    material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
    assert list(UsdSemantics.LabelsAPI(material.GetPrim(), "material").GetLabelsAttr().Get()) == ["planks"]
    floor = stage.GetPrimAtPath("/World/Room/floor/Collision").GetChildren()[0]
    assert floor.GetAttribute("xformOp:scale").Get()[2] == pytest.approx(Physics().floor_thickness)


def test_it_is_lit_and_looked_at_as_the_mjcf_is(stage: Any) -> None:
    model = mujoco.MjModel.from_xml_string(mjcf_text(inventory_of(sample_scene())))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    cameras = stage.GetPrimAtPath("/World/Cameras").GetChildren()
    assert [prim.GetName() for prim in cameras] == [model.camera(number).name for number in range(model.ncam)]
    for number, prim in enumerate(cameras):
        position, _ = world_pose(prim)
        np.testing.assert_allclose(position, data.cam_xpos[number], atol=1e-6)
        np.testing.assert_allclose(_turn(prim), data.cam_xmat[number].reshape(3, 3), atol=1e-6)
        camera = UsdGeom.Camera(prim).GetCamera(Usd.TimeCode.Default())
        fovy = camera.GetFieldOfView(Gf.Camera.FOVVertical)
        assert fovy == pytest.approx(model.cam_fovy[number], abs=1e-3)
    lights = [prim for prim in stage.GetPrimAtPath("/World/Lights").GetChildren() if prim.GetName() != "sky"]
    assert len(lights) == model.nlight


def test_kinds_and_labels(stage: Any) -> None:
    for placement in sample_scene().placements:
        prim = stage.GetPrimAtPath(f"/World/Objects/{placement.id}")
        assert Usd.ModelAPI(prim).GetKind() == Kind.Tokens.component
        assert prim.IsModel()
        assert list(UsdSemantics.LabelsAPI(prim, "class").GetLabelsAttr().Get()) == [placement.category]
    (table,) = (
        UsdSemantics.LabelsAPI(stage.GetPrimAtPath("/World/Objects/table_1"), "wikidata_qcode").GetLabelsAttr().Get()
    )
    assert table == "Q14748"
    assert not stage.GetPrimAtPath("/World/Objects/sampler_1").HasAPI(UsdSemantics.LabelsAPI, "wikidata_qcode")
    for prim in everything(stage.GetPseudoRoot()):
        if prim.IsA(UsdShade.Material):
            assert UsdSemantics.LabelsAPI(prim, "material").GetLabelsAttr().Get(), prim.GetPath()
    door = stage.GetPrimAtPath("/World/Objects/wardrobe_1/wardrobe_1_door_left")
    assert list(UsdSemantics.LabelsAPI(door, "class").GetLabelsAttr().Get()) == ["door left"]


def test_ids_that_are_no_identifiers_stay_apart() -> None:
    scene = sample_scene()
    first = scene.placements[0]
    twins = tuple(structs.replace(first, id=id, position=(1.0, y, 0.0)) for id, y in (("a.b", 1.0), ("a-b", 3.0)))
    layer = Sdf.Layer.CreateAnonymous(".usda")
    layer.ImportFromString(usd_text(inventory_of(structs.replace(scene, placements=twins))))
    stage = Usd.Stage.Open(layer)
    names = [prim.GetName() for prim in stage.GetPrimAtPath("/World/Objects").GetChildren()]
    assert names == ["a_b", "a_b_2"]


def test_the_same_scene_gives_the_same_bytes(tmp_path: Path) -> None:
    write_usd(inventory_of(sample_scene()), tmp_path / "scene.usda")
    (tmp_path / "again").mkdir()
    write_usd(inventory_of(sample_scene()), tmp_path / "again" / "scene.usda")
    text = (tmp_path / "scene.usda").read_text()
    assert text.startswith("#usda 1.0")
    assert "/tmp" not in text + usd_text(inventory_of(sample_scene()))
    for file in (file for file in tmp_path.rglob("*") if file.is_file() and "again" not in file.parts):
        assert file.read_bytes() == (tmp_path / "again" / file.relative_to(tmp_path)).read_bytes()


def test_an_empty_room_is_a_stage_too() -> None:
    layer = Sdf.Layer.CreateAnonymous(".usda")
    assert layer.ImportFromString(usd_text(inventory_of(Scene(room=L_ROOM, prompt='say "hi"\n\\ {} ü'))))
    assert layer.customLayerData["prompt"] == 'say "hi"\n\\ {} ü'
    assert math.isclose(UsdPhysics.GetStageKilogramsPerUnit(Usd.Stage.Open(layer)), 1.0)
