"""USD of other programs: units, masses, joints and colliders as UsdPhysics means them."""

import math
from pathlib import Path

import mujoco
import numpy as np
import pytest

import thinkblox
from thinkblox.sim.foreign.opening import open_model
from thinkblox.sim.foreign.triangles import triangles_of
from thinkblox.sim.subject import Subject

BODY = 'prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]'
SOLID = 'prepend apiSchemas = ["PhysicsCollisionAPI", "PhysicsMassAPI"]'
HEAD = '#usda 1.0\n(\n    upAxis = "Z"\n    metersPerUnit = 1\n)\n'
AT = 'double3 xformOp:translate = ({}, {}, {})\nuniform token[] xformOpOrder = ["xformOp:translate"]\n'


def opened(folder: Path, text: str, head: str = HEAD) -> Subject:
    path = folder / "stage.usda"
    path.write_text(head + text)
    return open_model(path)


def prim(kind: str, name: str, apis: str, *inside: str) -> str:
    return f'def {kind} "{name}" ({apis})\n{{\n' + "\n".join(inside) + "\n}\n"


def cube(name: str, side: float, *inside: str) -> str:
    return prim("Cube", name, SOLID, f"double size = {side}", *inside)


def joint(kind: str, name: str, body0: str, body1: str, *inside: str) -> str:
    ends = [f"rel physics:body{end} = <{path}>" for end, path in enumerate((body0, body1)) if path]
    return f'def {kind} "{name}"\n{{\n' + "\n".join([*ends, *inside]) + "\n}\n"


def test_centimetres_and_y_up_are_read_as_metres_and_z_up(tmp_path: Path) -> None:
    axis = "X"  # points the same way in both

    def cart(unit: float, up: str) -> str:
        def at(x: float, y: float, z: float) -> str:
            return AT.format(*(value * unit for value in ((x, y, z) if up == "Z" else (x, z, -y))))

        return prim(
            "Xform", "cart", BODY, "float physics:mass = 2", f"point3f physics:centerOfMass = ({0.01 * unit}, 0, 0)",
            at(0.1, 0.2, 0.6), cube("box", 0.2 * unit),
        ) + prim(
            "Xform", "lid", BODY, at(0.1, 0.2, 0.8),
            prim("Cylinder", "bar", SOLID, f'uniform token axis = "{axis}"', f"double radius = {0.02 * unit}",
                 f"double height = {0.1 * unit}", f"float physics:density = {500 / unit**3}"),
        ) + joint(
            "PhysicsPrismaticJoint", "slide", "/cart", "/lid", f'uniform token physics:axis = "{axis}"',
            f"point3f physics:localPos0 = {(0, 0, 0.2 * unit) if up == 'Z' else (0, 0.2 * unit, 0)}",
            f"float physics:lowerLimit = 0\nfloat physics:upperLimit = {0.3 * unit}",
        )  # fmt: skip

    metres = opened(tmp_path, cart(1.0, "Z"))
    centimetres = opened(tmp_path, cart(100.0, "Y"), HEAD.replace('"Z"', '"Y"').replace("Unit = 1", "Unit = 0.01"))
    for field in ("body_mass", "jnt_range"):
        ours, theirs = (getattr(subject.model, field) for subject in (metres, centimetres))
        np.testing.assert_allclose(ours, theirs, atol=1e-6)
    np.testing.assert_allclose(metres.model.opt.gravity, centimetres.model.opt.gravity, atol=1e-9)
    for mine, other in zip(*((s.data().xipos, s.data().geom_xpos) for s in (metres, centimetres)), strict=True):
        np.testing.assert_allclose(mine, other, atol=1e-6)
    assert metres.model.body("cart").mass[0] == 2.0
    assert metres.model.body("lid").mass[0] == pytest.approx(500 * math.pi * 0.02**2 * 0.1, rel=1e-6)


def test_masses_follow_the_rules_of_usdphysics(tmp_path: Path) -> None:
    material = (
        'def Material "oak" (prepend apiSchemas = ["PhysicsMaterialAPI"])\n'
        "{\nfloat physics:density = 700\nfloat physics:dynamicFriction = 0.3\n}\n"
    )
    oak = SOLID.replace('"]', '", "MaterialBindingAPI"]')
    bound = "rel material:binding:physics = </oak>"
    bodies = {
        "water": (cube("a", 0.1), 1.0),
        "own": (cube("a", 0.1, "float physics:mass = 3"), 3.0),
        "dense": (cube("a", 0.1, "float physics:density = 2000"), 2.0),
        "wood": (prim("Cube", "a", oak, "double size = 0.1", bound), 0.7),
        "body": ("float physics:density = 400\n" + prim("Cube", "a", oak, "double size = 0.1", bound), 0.4),
        "said": ("float physics:mass = 5\n" + cube("a", 0.1), 5.0),
        "both": (cube("a", 0.1) + cube("b", 0.2, "float physics:mass = 1"), 2.0),
    }
    text = "".join(
        prim("Xform", name, BODY, AT.format(number, 0, 0.5), inside)
        for number, (name, (inside, _)) in enumerate(bodies.items())
    )
    model = opened(tmp_path, material + text).model
    for name, (_, mass) in bodies.items():
        assert model.body(name).mass[0] == pytest.approx(mass, rel=1e-6), name
    np.testing.assert_allclose(model.body("said").inertia, 5.0 * 2 * 0.1**2 / 12, rtol=1e-6)
    frictions = {model.body(model.geom_bodyid[geom]).name: model.geom_friction[geom, 0] for geom in range(model.ngeom)}
    assert frictions["wood"] == pytest.approx(0.3)
    assert frictions["water"] == 0.5


@pytest.mark.parametrize("turned", [False, True], ids=["as usual", "from child to parent"])
def test_a_hinge_opens_the_same_way_whichever_end_is_first(turned: bool, tmp_path: Path) -> None:
    box = prim("Xform", "box", BODY, AT.format(0, 0, 0.5), "bool physics:kinematicEnabled = 1", cube("a", 0.4))
    door = prim("Xform", "door", BODY, AT.format(0.4, 0, 0.5), cube("a", 0.3))
    places = ("(0.2, 0.2, 0)", "(-0.2, 0.2, 0)")
    limits = "float physics:lowerLimit = 0\nfloat physics:upperLimit = 90"
    ends = ("/box", "/door")
    if turned:
        places, ends = (places[1], places[0]), (ends[1], ends[0])
        limits = "float physics:lowerLimit = -90\nfloat physics:upperLimit = 0"
    hinge = joint(
        "PhysicsRevoluteJoint", "hinge", *ends, 'uniform token physics:axis = "Z"', limits,
        *(f"point3f physics:localPos{end} = {place}" for end, place in enumerate(places)),
    )  # fmt: skip
    subject = opened(tmp_path, box + door + hinge)
    model, data = subject.model, subject.data()
    assert [thing.id for thing in subject.things] == ["box"]
    np.testing.assert_allclose(data.body("door").xpos, (0.4, 0.0, 0.5), atol=1e-7)
    data.qpos[0] = -math.pi / 2 if turned else math.pi / 2  # a quarter turn of the door against the clock
    mujoco.mj_forward(model, data)
    np.testing.assert_allclose(data.body("door").xpos, (0.4, 0.4, 0.5), atol=1e-6)
    low, high = np.degrees(model.jnt_range[0])
    assert (round(low), round(high)) == ((-90, 0) if turned else (0, 90))


def test_colliders_are_as_large_as_they_look(tmp_path: Path) -> None:
    stretched = 'double3 xformOp:scale = (2, 1, 0.5)\nuniform token[] xformOpOrder = ["xformOp:scale"]\n'
    shapes = {
        "cone": (prim("Cone", "a", SOLID, "double radius = 0.2", "double height = 0.6"), (0.4, 0.4, 0.6)),
        "lying": (
            prim("Capsule", "a", SOLID, 'uniform token axis = "Y"', "double radius = 0.1", "double height = 0.4"),
            (0.2, 0.6, 0.2),
        ),
        "egg": (prim("Sphere", "a", SOLID, "double radius = 0.1", stretched), (0.4, 0.2, 0.1)),
        "oval": (prim("Cylinder", "a", SOLID, "double radius = 0.1", "double height = 1", stretched), (0.4, 0.2, 0.5)),
        "brick": (cube("a", 0.2, stretched), (0.4, 0.2, 0.1)),
    }
    text = "".join(
        prim("Xform", name, BODY, AT.format(number, 0, 1), inside)
        for number, (name, (inside, _)) in enumerate(shapes.items())
    )
    subject = opened(tmp_path, text)
    data = subject.data()
    for thing in subject.things:
        extent = np.ptp(triangles_of(subject.model, data, thing).vertices, axis=0)
        np.testing.assert_allclose(extent, shapes[thing.id][1], atol=0.004, err_msg=thing.id)


def test_a_fixed_mesh_keeps_its_hollow_and_a_flat_one_its_face(tmp_path: Path) -> None:
    points = "(0,0,0),(2,0,0),(2,1,0),(0,1,0),(0,0,1),(1,0,1),(1,1,1),(0,1,1),(1,0,0.5),(2,0,0.5),(1,1,0.5),(2,1,0.5)"
    stairs = prim(
        "Mesh", "stairs", SOLID, f"point3f[] points = [{points}]",
        "int[] faceVertexCounts = [4, 4, 4, 4, 4, 4, 6, 6]",
        "int[] faceVertexIndices = [0,3,2,1, 0,4,7,3, 4,5,6,7, 5,8,10,6, 8,9,11,10, 1,2,11,9,"
        " 0,1,9,8,5,4, 3,7,6,10,11,2]",
    )  # fmt: skip
    ground = prim(
        "Mesh", "ground", SOLID, "point3f[] points = [(-5,-5,0),(5,-5,0),(5,5,0),(-5,5,0)]",
        "int[] faceVertexCounts = [4]\nint[] faceVertexIndices = [0,1,2,3]",
    )  # fmt: skip
    ball = prim("Sphere", "a", SOLID, "double radius = 0.1")
    low = prim("Xform", "low", BODY, AT.format(1.5, 0.5, 0.62), ball)
    far = prim("Xform", "far", BODY, AT.format(-3, 0, 0.12), ball)
    subject = opened(tmp_path, stairs + ground + low + far)
    data = subject.data()
    while data.time < 1.0:
        mujoco.mj_step(subject.model, data)
    assert data.body("low").xpos[2] == pytest.approx(0.6, abs=0.005)
    assert data.body("far").xpos[2] == pytest.approx(0.1, abs=0.005)
    assert any("into convex pieces: /stairs" in note for note in subject.notes)


def test_a_generic_joint_is_locked_where_its_limits_cross(tmp_path: Path) -> None:
    apis = [f"PhysicsLimitAPI:{name}" for name in ("transX", "transY", "transZ", "rotX", "rotY", "rotZ")]
    crossed = "float limit:{0}:physics:low = 1\nfloat limit:{0}:physics:high = -1"
    said = [crossed.format(api.partition(":")[2]) for api in apis[:5]]
    said.append("float limit:rotZ:physics:low = -30\nfloat limit:rotZ:physics:high = 60")
    listed = ", ".join(f'"{api}"' for api in apis)
    post = prim("Xform", "post", BODY, AT.format(0, 0, 0.5), cube("a", 0.2))
    hold = f'def PhysicsJoint "hold" (prepend apiSchemas = [{listed}])\n{{\nrel physics:body1 = </post>\n'
    hold += "point3f physics:localPos0 = (0, 0, 0.5)\n" + "\n".join(said) + "\n}\n"
    model = opened(tmp_path, post + hold).model
    assert model.njnt == 1
    np.testing.assert_allclose(np.degrees(model.jnt_range[0]), (-30, 60), atol=1e-4)
    np.testing.assert_allclose(model.jnt_axis[0], (0, 0, 1), atol=1e-9)


def test_what_is_in_an_instance_collides_too(tmp_path: Path) -> None:
    chair = f'def Xform "model"\n{{\n{cube("a", 0.4)}\n}}\n'
    (tmp_path / "chair.usda").write_text(HEAD.replace("(\n", '(\n    defaultPrim = "model"\n') + chair)
    apis = f"instanceable = true\nprepend references = @chair.usda@\n{BODY}"
    bodies = [f'def Xform "{name}" ({apis})\n{{\n{AT.format(x, 0, 0.2)}\n}}\n' for name, x in (("one", 0), ("two", 2))]
    subject = opened(tmp_path, "".join(bodies))
    assert {thing.id for thing in subject.things} == {"one", "two"}
    assert subject.model.body("one").mass[0] == pytest.approx(64.0)


def test_a_joint_within_an_instance_holds(tmp_path: Path) -> None:
    lid = prim("Xform", "lid", BODY, AT.format(0, 0, 0.3), cube("a", 0.1))
    inside = prim("Xform", "box", BODY, cube("a", 0.4)) + lid
    hinge = joint(
        "PhysicsRevoluteJoint", "hinge", "/model/box", "/model/lid", "point3f physics:localPos0 = (0, 0, 0.3)"
    )
    chest = f'def Xform "model"\n{{\n{inside}{hinge}\n}}\n'
    (tmp_path / "chest.usda").write_text(HEAD.replace("(\n", '(\n    defaultPrim = "model"\n') + chest)
    apis = "instanceable = true\nprepend references = @chest.usda@"
    chests = [f'def Xform "{name}" ({apis})\n{{\n{AT.format(x, 0, 0.2)}\n}}\n' for name, x in (("one", 0), ("two", 2))]
    model = opened(tmp_path, "".join(chests)).model
    kinds = [mujoco.mjtJoint(kind).name for kind in model.jnt_type]
    assert sorted(kinds) == ["mjJNT_FREE", "mjJNT_FREE", "mjJNT_HINGE", "mjJNT_HINGE"]
    assert model.nexclude == 2


def test_only_what_says_no_mass_is_taken_as_one_kilogram(tmp_path: Path) -> None:
    weights = {"one": "float physics:mass = 1", "none": ""}
    bodies = "".join(prim("Xform", name, BODY, AT.format(0, 0, 1), mass) for name, mass in weights.items())
    floor = cube("floor", 4.0, AT.format(0, 0, -2))
    subject = opened(tmp_path, floor + bodies)
    assert [subject.model.body(name).mass[0] for name in weights] == [1.0, 1.0]
    told = [note for note in subject.notes if "taken as 1 kg" in note]
    assert told == ["Without mass and colliders, taken as 1 kg: /none."]


def test_a_loop_of_bodies_is_closed(tmp_path: Path) -> None:
    places = {"a": 0, "b": 1, "c": 2}
    bars = "".join(prim("Xform", name, BODY, AT.format(x, 0, 1), cube("s", 0.1)) for name, x in places.items())
    hinges = "".join(
        joint("PhysicsSphericalJoint", one + two, f"/{one}", f"/{two}",
              f"point3f physics:localPos0 = ({places[two] - places[one]}, 0, 0)")
        for one, two in ("ab", "bc", "ca")
    )  # fmt: skip
    model = opened(tmp_path, bars + hinges).model
    assert model.njnt == 3  # one free, two balls
    assert model.neq == 1


def test_what_cannot_be_is_refused(tmp_path: Path) -> None:
    body = prim("Xform", "thing", BODY, AT.format(0, 0, 0.5), cube("a", 0.2))
    for text, said in (
        (body.replace("double size = 0.2", "double size = -1"), "above 0"),
        (body.replace("double size = 0.2", "double size = 0.2\nfloat physics:mass = -3"), "has a mass of -3"),
        ('def Xform "nothing"\n{\n}\n', "nothing to measure"),
        (body + joint("PhysicsSphericalJoint", "torn", "/thing", ""), "0.5 m apart"),
    ):
        with pytest.raises(thinkblox.InputError, match=said):
            opened(tmp_path, text)
    for old, new, said in (("Unit = 1", "Unit = 0", "metres a unit"), ('"Z"', '"W"', "'W' up")):
        with pytest.raises(thinkblox.InputError, match=said):
            opened(tmp_path, body, HEAD.replace(old, new))


def test_what_other_programs_may_stumble_over_is_told(tmp_path: Path) -> None:
    sound = prim("Xform", "thing", BODY, AT.format(0, 0, 0.1), "float physics:mass = 1",
                 "float3 physics:diagonalInertia = (0.01, 0.01, 0.01)", cube("a", 0.2))  # fmt: skip
    scene = 'def PhysicsScene "scene"\n{\nfloat physics:gravityMagnitude = 9.81\n}\n'
    (told,) = (note for note in opened(tmp_path, sound).notes if note.startswith("Other programs may stumble"))
    assert "the stage: has 0 physics scenes; it needs exactly one." in told
    (told,) = (note for note in opened(tmp_path, scene + sound.replace("0.01)", "0.5)")).notes if "stumble" in note)
    assert "/thing: has an inertia that no body can have" in told
    assert "physics scenes" not in told


def test_a_stage_without_the_files_that_it_names_is_refused(tmp_path: Path) -> None:
    box = prim("Xform", "box", f"{BODY}\nprepend references = @./gone.usda@</X>", cube("shape", 0.2))
    with pytest.raises(thinkblox.InputError, match=r"without the files that it names: .*gone\.usda$"):
        opened(tmp_path, box)
    with pytest.raises(thinkblox.InputError, match=r"names: .*lost\.usda$"):
        opened(tmp_path, cube("a", 0.2), HEAD.replace("(", "(\n    subLayers = [@./lost.usda@]", 1))


def test_what_is_left_to_the_engine_is_no_fault(tmp_path: Path) -> None:
    """No inertia and no magnitude of gravity are those of the colliders and of the earth."""
    scene = 'def PhysicsScene "scene"\n{\n}\n' + cube("floor", 2, AT.format(0, 0, -1))
    stands = prim("Xform", "thing", BODY, AT.format(0, 0, 0.05), "float physics:mass = 1", cube("a", 0.2))
    notes = opened(tmp_path, scene + stands).notes
    assert not any(word in note for note in notes for word in ("inertia", "gravity", "no floor"))
    through = prim("Xform", "thing", BODY, AT.format(0, 0, 0), "float physics:mass = 1", cube("a", 5))
    notes = opened(tmp_path, scene + through).notes
    assert any(note.startswith("Nothing fixed reaches lower than thing: a floor was put") for note in notes)


def copies(model: str) -> str:
    return prim(
        "PointInstancer", "many", "", "rel prototypes = </many/one>", "int[] protoIndices = [0, 0]",
        "point3f[] positions = [(0, 0, 1), (2, 0, 1)]", model,
    )  # fmt: skip


@pytest.mark.parametrize("kind", ["def", "class"])
def test_copies_of_bodies_that_would_not_be_there_are_refused(tmp_path: Path, kind: str) -> None:
    body = prim("Xform", "one", BODY, cube("box", 0.4)).replace("def Xform", f"{kind} Xform", 1)
    with pytest.raises(thinkblox.InputError, match="/many: makes copies of /many/one, which has physics"):
        opened(tmp_path, copies(body) + prim("Xform", "other", BODY, cube("box", 0.4)))


def test_copies_of_what_is_only_seen_do_no_harm(tmp_path: Path) -> None:
    leaf = prim("Cube", "one", "", "double size = 0.1")
    subject = opened(tmp_path, copies(leaf) + prim("Xform", "pot", BODY, cube("box", 0.4)))
    assert [thing.id for thing in subject.things] == ["pot"]


def test_a_pose_that_changes_over_time_is_told_where_it_matters(tmp_path: Path) -> None:
    moving = AT.format(0, 0, 0.2).replace("translate = (0, 0, 0.2)", "translate.timeSamples = {1: (0, 0, 1)}")
    seen = prim("Xform", "bird", "", moving, prim("Cube", "look", "", "double size = 0.1"))
    still = prim("Xform", "box", BODY, AT.format(0, 0, 0.2), cube("box", 0.4))
    assert not any("over time" in note for note in opened(tmp_path, seen + still).notes)
    cart = prim("Xform", "cart", "", moving, still)
    told = next(note for note in opened(tmp_path, seen + cart).notes if "over time" in note)
    assert told == "Moved over time, but measured where it stands without a time: /cart."
