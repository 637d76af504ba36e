"""Any URDF opens: meshes found as ROS finds them, link names kept, and a floor under what would fall for ever."""

import re
import shutil
from pathlib import Path

import pytest

from tests.foreign_models import MODELS, of
from thinkblox.errors import InputError
from thinkblox.sim.foreign.model_report import model_report
from thinkblox.sim.foreign.opening import open_model
from thinkblox.sim.subject import Subject

TABLE = MODELS / "table_description"
INERTIAL = '<inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
SHAPE = '<collision><geometry><box size="1 1 1"/></geometry></collision>'


def link(name: str, inside: str = INERTIAL + SHAPE) -> str:
    return f'<link name="{name}">{inside}</link>'


def joint(parent: str, child: str, kind: str = "fixed", more: str = "") -> str:
    return (
        f'<joint name="{parent}_{child}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{more}</joint>'
    )


def opened(folder: Path, *parts: str) -> Subject:
    return open_model(written(folder, *parts))


def written(folder: Path, *parts: str) -> Path:
    file = folder / "model.urdf"
    file.write_text(f'<robot name="model">{"".join(parts)}</robot>')
    return file


def names(subject: Subject) -> list[str]:
    return [str(subject.model.body(body).name) for body in range(1, subject.model.nbody)]


def test_a_table_stands_on_a_floor_at_its_feet() -> None:
    subject = open_model(TABLE / "urdf" / "table.urdf")
    assert subject.source == "urdf"
    assert names(subject) == ["top", "leg_0", "leg_1", "leg_2", "leg_3", "drawer"]
    assert [(t.id, t.free, len(t.bodies)) for t in subject.things] == [("top", True, 6)]
    assert "lowest point, at z = -0.720 m" in subject.notes[1]
    report = model_report(subject)
    assert report.valid, report
    assert report.source == "urdf"
    (top,) = report.objects
    assert [(s.by, s.share) for s in top.supports] == [("floor", 1.0)]
    assert max(report.drift, report.depth) < 1e-4


def test_a_package_address_is_found_under_another_name_of_the_folder(tmp_path: Path) -> None:
    shutil.copytree(TABLE, tmp_path / "renamed")
    assert open_model(tmp_path / "renamed" / "urdf" / "table.urdf").model.nmesh == 1


def test_a_missing_mesh_names_the_element(tmp_path: Path) -> None:
    shutil.copytree(TABLE, tmp_path / "t")
    (tmp_path / "t" / "meshes" / "foot.obj").unlink()
    with pytest.raises(InputError, match=r'table\.urdf:\d+: <mesh> names "meshes/foot\.obj", which is not in'):
        open_model(tmp_path / "t" / "urdf" / "table.urdf")


def test_a_root_called_world_holds_what_hangs_on_it(tmp_path: Path) -> None:
    mug = joint("world", "mug", "floating", '<origin xyz="0 0 2"/>')
    subject = opened(tmp_path, link("world", ""), link("shelf"), link("mug"), joint("world", "shelf"), mug)
    assert [(t.id, t.free) for t in subject.things] == [("shelf", False), ("mug", True)]
    assert subject.notes == ()
    assert subject.model.ngeom == 2


def test_an_empty_root_with_several_links_is_a_frame_and_with_one_link_a_free_base(tmp_path: Path) -> None:
    frame = opened(tmp_path, link("scene", ""), link("a"), link("b"), joint("scene", "a"), joint("scene", "b"))
    assert [(t.id, t.free) for t in frame.things] == [("a", False), ("b", False)]
    base = opened(tmp_path, link("base", ""), link("a"), joint("base", "a"))
    assert [(t.id, t.free, len(t.bodies)) for t in base.things] == [("base", True, 2)]


def test_doors_keep_their_joints_and_limits(tmp_path: Path) -> None:
    limit = '<axis xyz="0 0 1"/><limit lower="-0.5" upper="1.5" effort="9" velocity="1"/>'
    subject = opened(
        tmp_path,
        link("world", ""),
        link("box"),
        joint("world", "box"),
        link("door"),
        joint("box", "door", "revolute", limit),
    )
    assert subject.model.jnt_range.tolist() == [[-0.5, 1.5]]
    assert subject.things[0].bodies == (1, 2)


def test_two_meshes_of_one_name_stay_two(tmp_path: Path) -> None:
    wedge = (TABLE / "meshes" / "foot.obj").read_text()
    for folder, factor in (("a", 1), ("b", 3)):
        (tmp_path / folder).mkdir()
        scaled = "\n".join(
            " ".join([word[0], *(str(float(n) * factor) for n in word[1:])]) if word[0] == "v" else line
            for line, word in ((line, line.split()) for line in wedge.splitlines())
        )
        (tmp_path / folder / "part.obj").write_text(scaled)
    mesh = '<collision><geometry><mesh filename="{}/part.obj"/></geometry></collision>'
    model = opened(tmp_path, link("x", INERTIAL + mesh.format("a") + mesh.format("b"))).model
    assert model.nmesh == 2
    assert model.geom_rbound[2] == pytest.approx(3 * model.geom_rbound[1])


def test_links_without_mass_are_said(tmp_path: Path) -> None:
    subject = opened(tmp_path, link("box", SHAPE))
    assert "Without inertial, box weighs what its collision shapes do at 1000 kg/m3." in subject.notes
    assert subject.model.body_mass[1] == pytest.approx(1000.0)


def test_the_engines_own_section_is_kept(tmp_path: Path) -> None:
    own = '<mujoco><compiler fusestatic="true" discardvisual="false"/><option timestep="0.001"/></mujoco>'
    subject = opened(tmp_path, own, link("a"), link("b"), joint("a", "b"))
    assert subject.model.opt.timestep == 0.001
    assert names(subject) == ["a", "b"]


def test_a_tall_thing_on_its_edge_falls(tmp_path: Path) -> None:
    tall = '<collision><origin xyz="0 0 1" rpy="0.4 0 0"/><geometry><box size="0.3 0.3 2"/></geometry></collision>'
    report = model_report(opened(tmp_path, link("tower", INERTIAL.replace("/>", '/><origin xyz="0 0 1"/>', 1) + tall)))
    assert "tilt" in of(report, "tower").reasons


MESH = '<link name="a"><collision><geometry><mesh filename="{}"/></geometry></collision></link>'


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("<robot", "not well-formed"),
        ("<robot/>", "no link has collision geometry"),
        (f"<robot>{link('a', INERTIAL)}</robot>", "no link has collision geometry"),
        ('<robot xmlns:xacro="x"><xacro:macro name="m"/></robot>', "this is xacro; expand it first"),
        (f"<robot>{link('${name}')}</robot>", "this is xacro"),
        (f"<robot>{link('a')}{link('b')}{joint('a', 'b')}{joint('b', 'a')}</robot>", "hang in a circle"),
        (f"<robot>{link('a')}{joint('a', 'c')}</robot>", "URDF joint parent or child missing"),
        (f"<robot>{link('a')}{link('a')}</robot>", "repeated URDF name"),
        (f"<robot>{link('a', INERTIAL.replace('2', '1e-99', 1) + SHAPE)}</robot>", "a link that moves needs a mass"),
        (f"<robot>{link('a', SHAPE.replace('1 1 1', '1 nan 1'))}</robot>", '<box>: size="1 nan 1" is not a number'),
        (f"<robot>{link('a', SHAPE.replace('1 1 1', '1 0 1'))}</robot>", "must be positive"),
        (f"<robot>{MESH.format('package://p/m.stl')}</robot>", '<mesh> names "m.stl", which is not in'),
        (f"<robot>{MESH.format('package://p/../../m.stl')}</robot>", "leaves the folder"),
        (f"<robot>{MESH.format('../m.stl')}</robot>", '<mesh> names "../m.stl", which leaves the folder'),
        (f"<robot>{MESH.format('/etc/m.stl')}</robot>", "absolute path"),
        (f"<robot>{MESH.format('file:///etc/m.stl')}</robot>", "absolute path"),
        (f"<robot>{MESH.format('')}</robot>", "<mesh> names"),
        ("<robot>" + "<link name='a'/>" * 20_001 + "</robot>", "20001 bodies"),
    ],
)  # fmt: skip
def test_a_bad_urdf_is_refused_with_a_reason(tmp_path: Path, text: str, says: str) -> None:
    file = tmp_path / "robot.urdf"
    file.write_text(text)
    with pytest.raises(InputError) as caught:
        open_model(file)
    assert says in str(caught.value)
    assert "robot.urdf" in str(caught.value)


def inertial(mass: float, *moments: float, products: float = 0.0) -> str:
    ixx, iyy, izz = moments
    return (
        f'<inertial><mass value="{mass}"/><inertia ixx="{ixx}" iyy="{iyy}" izz="{izz}" ixy="{products}" ixz="0"'
        ' iyz="0"/></inertial>'
    )


def test_an_inertia_that_no_body_has_is_balanced_by_the_least(tmp_path: Path) -> None:
    subject = opened(tmp_path, link("a", inertial(2, 0.1, 0.2, 0.5) + SHAPE))
    assert subject.model.body_inertia[1] == pytest.approx([0.5, 0.3, 0.2], rel=1e-5)
    assert any(note.startswith("No body has the inertia of a: the two smaller moments") for note in subject.notes)


def test_products_of_inertia_that_are_missing_are_zero(tmp_path: Path) -> None:
    bare = inertial(2, 0.2, 0.2, 0.3).replace(' ixy="0.0" ixz="0" iyz="0"', "")
    subject = opened(tmp_path, link("a", bare + SHAPE))
    assert subject.model.body_inertia[1] == pytest.approx([0.3, 0.2, 0.2])
    assert "Products of inertia that a does not say are taken as 0." in subject.notes


def test_a_tensor_that_is_turned_is_balanced_along_its_axes(tmp_path: Path) -> None:
    subject = opened(tmp_path, link("a", inertial(2, 0.3, 0.3, 0.9, products=0.1) + SHAPE))
    assert sorted(subject.model.body_inertia[1]) == pytest.approx([0.35, 0.55, 0.9], rel=1e-5)


@pytest.mark.parametrize("moments", [(0, 0, 0), (1, 1, 0), (1, 1, -1)])
def test_an_inertia_that_is_zero_or_less_is_that_of_a_ball_of_water(tmp_path: Path, moments: tuple[float, ...]) -> None:
    subject = opened(tmp_path, link("a", inertial(1, *moments) + SHAPE))
    radius = (3 / (4000 * 3.14159265)) ** (1 / 3)
    assert subject.model.body_inertia[1] == pytest.approx([0.4 * radius**2] * 3, rel=1e-5)
    assert any("The inertia of a is that of a ball of water" in note for note in subject.notes)


def test_a_link_between_two_joints_that_weighs_nothing_is_given_a_gram(tmp_path: Path) -> None:
    axis = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
    parts = joint("a", "cross", "revolute", axis), joint("cross", "b", "revolute", axis)
    subject = opened(tmp_path, link("a"), link("cross", ""), link("b"), *parts)
    assert subject.model.body("cross").mass[0] == 0.001
    assert any("cross was given 0.001 kg" in note for note in subject.notes)
    assert names(subject) == ["a", "cross", "b"]


def test_a_root_of_no_mass_is_fixed_as_bullet_reads_it(tmp_path: Path) -> None:
    subject = opened(tmp_path, link("table", inertial(0, 0, 0, 0) + SHAPE))
    assert [(t.id, t.free) for t in subject.things] == [("table", False)]
    assert any("The root link table has the mass 0, so it is fixed" in note for note in subject.notes)


def test_a_fixed_base_is_held_and_needs_no_floor(tmp_path: Path) -> None:
    file = written(tmp_path, link("base"), link("arm"), joint("base", "arm"))
    assert open_model(file).things[0].free
    subject = open_model(file, fixed_base=True)
    assert not subject.things[0].free
    assert subject.model.ngeom == 2
    assert not any("stands free" in note for note in subject.notes)


def test_numbers_that_are_one_too_many_and_what_is_said_twice_are_passed_over(tmp_path: Path) -> None:
    axes = '<axis xyz="0 0 1"/><axis xyz="0 1 0"/><origin xyz="0 0 1" rpy="0 0 0 0"/>'
    limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
    subject = opened(tmp_path, link("a"), link("b"), joint("a", "b", "revolute", axes + limit))
    assert subject.model.jnt_axis[1].tolist() == [0, 0, 1]
    assert any("with more than 3 numbers" in note for note in subject.notes)
    assert any("The joint a_b says something twice" in note for note in subject.notes)


def test_commas_between_numbers_are_read_as_spaces(tmp_path: Path) -> None:
    subject = opened(tmp_path, link("a"), link("b"), joint("a", "b", "fixed", '<origin xyz="0, 0.5, 1"/>'))
    assert subject.model.body("b").pos.tolist() == [0.0, 0.5, 1.0]
    assert any("Commas" in note for note in subject.notes)


def test_a_level_plane_is_a_slab_under_it(tmp_path: Path) -> None:
    plane = '<collision><origin xyz="1 2 0.25"/><geometry><plane normal="0 0 1"/></geometry></collision>'
    subject = opened(tmp_path, link("ground", inertial(0, 0, 0, 0) + plane), link("a"))
    slab = next(geom for geom in map(subject.model.geom, range(subject.model.ngeom)) if geom.size[0] == 50.0)
    assert slab.pos[2] + slab.size[2] == 0.25
    assert any("A plane is read as a slab" in note for note in subject.notes)


def test_a_plane_that_leans_is_refused(tmp_path: Path) -> None:
    plane = '<collision><geometry><plane normal="0 1 1"/></geometry></collision>'
    with pytest.raises(InputError, match="geometry"):
        opened(tmp_path, link("ground", inertial(0, 0, 0, 0) + plane))


def test_an_error_of_the_engine_names_the_line_of_the_urdf(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"Element 'axis' at model\.urdf:3"):
        opened(tmp_path, link("a"), link("b"), joint("a", "b", "revolute", "\n\n<axis xyz='0 x 1'/>"))


def test_a_mesh_that_is_a_link_out_of_the_folder_is_refused(tmp_path: Path) -> None:
    folder = tmp_path / "robot"
    folder.mkdir()
    shutil.copy(TABLE / "meshes" / "foot.obj", tmp_path)
    (folder / "foot.obj").symlink_to(tmp_path / "foot.obj")
    file = written(folder, MESH.format("foot.obj"))
    with pytest.raises(InputError, match="a link that leaves the folder"):
        open_model(file)
    assert open_model(file, folder=tmp_path).model.nmesh == 1


def test_an_include_in_a_urdf_reads_nothing(tmp_path: Path) -> None:
    (tmp_path / "part.xml").write_text("<x><option timestep='0.5'/></x>")
    subject = opened(tmp_path, f'<mujoco><include file="{tmp_path}/part.xml"/></mujoco>', link("a"))
    assert subject.model.opt.timestep < 0.5


@pytest.mark.parametrize("value", ["inf", "-inf", "Infinity", "1e999"])
@pytest.mark.parametrize("name", ["ixx", "iyz"])
def test_an_infinite_inertia_is_refused(tmp_path: Path, name: str, value: str) -> None:
    inertial = re.sub(f'{name}="[01]"', f'{name}="{value}"', INERTIAL)
    with pytest.raises(InputError, match=rf'model\.urdf:1: <inertia>: {name}="{value}" is not a finite number'):
        opened(tmp_path, link("a", inertial + SHAPE))
