"""The engine is given the very text and files that were checked: it reads nothing from the disk itself."""

import os
from pathlib import Path

import mujoco
import pytest

from tests.foreign_models import FLOOR, MODELS, crate, mjcf, opened
from thinkblox.errors import InputError
from thinkblox.sim.foreign import mjcf as mjcf_module
from thinkblox.sim.foreign.opening import open_model

BOX = crate("box", "0 0 .1")
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
MESHED = '<body><freejoint/><geom type="mesh" mesh="vase"/></body>'


def same_physics(ours: mujoco.MjModel, theirs: mujoco.MjModel) -> bool:
    fields = ("body_pos", "body_mass", "body_inertia", "geom_size", "geom_pos", "geom_friction", "jnt_range", "qpos0")
    return all((getattr(ours, field) == getattr(theirs, field)).all() for field in fields)


@pytest.mark.parametrize("name", ["rich.xml", "room/room.xml"])
def test_the_model_is_the_one_that_the_engine_reads_from_the_disk(name: str) -> None:
    assert same_physics(open_model(MODELS / name).model, mujoco.MjModel.from_xml_path(str(MODELS / name)))


def test_nothing_is_read_once_it_was_checked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "vase.obj").write_text(OBJ)
    (tmp_path / "part.xml").write_text("<mujocoinclude><option timestep='0.001'/></mujocoinclude>")
    (tmp_path / "more.xml").write_text(mjcf(crate("more", "0 0 0"), floor=""))
    read = mjcf_module._read

    def gone(*given: object) -> object:
        for file in tmp_path.iterdir():
            file.unlink()
        return read(*given)  # type: ignore[arg-type]

    monkeypatch.setattr(mjcf_module, "_read", gone)
    head = (
        '<include file="part.xml"/><asset><mesh name="vase" file="vase.obj"/><model name="m" file="more.xml"/></asset>'
    )
    model = opened(tmp_path, mjcf(MESHED + '<attach model="m" body="more" prefix="x_"/>', head=head)).model
    assert (model.opt.timestep, model.nmesh, model.nbody) == (0.001, 1, 3)


def test_a_mesh_without_a_name_is_called_after_its_file(tmp_path: Path) -> None:
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes" / "vase.obj").write_text(OBJ)
    head = '<compiler meshdir="meshes"/><asset><mesh file="vase.obj"/></asset>'
    assert opened(tmp_path, mjcf(MESHED, head=head)).model.mesh("vase").id == 0


def test_an_error_of_the_engine_names_file_and_line(tmp_path: Path) -> None:
    (tmp_path / "part.xml").write_text('<mujocoinclude>\n<worldbody>\n\n<geom sise="1"/></worldbody></mujocoinclude>')
    with pytest.raises(InputError, match=r"room\.xml: .* Element 'geom' at part\.xml:4"):
        opened(tmp_path, mjcf(BOX, head='<include file="part.xml"/>'))


def test_a_flaw_in_an_attached_model_is_told_of_that_file(tmp_path: Path) -> None:
    (tmp_path / "more.xml").write_text('<mujoco>\n<worldbody><geom sise="1"/></worldbody></mujoco>')
    head = '<asset><model name="m" file="more.xml"/></asset>'
    with pytest.raises(InputError, match=r"more\.xml: .* Element 'geom' at more\.xml:2"):
        opened(tmp_path, mjcf('<attach model="m" prefix="x_"/>' + BOX, head=head))


@pytest.mark.parametrize("text", ["../wood.png", "/etc/wood.png", "wood.png", "wood.jpg"])
def test_a_picture_that_cannot_be_read_is_left_plain(tmp_path: Path, text: str) -> None:
    (tmp_path / "wood.jpg").write_bytes(b"\xff\xd8\xff")
    look = f'<asset><texture name="t" type="cube" file="{text}"/><material name="m" texture="t"/></asset>'
    subject = opened(tmp_path, mjcf(crate("box", "0 0 .1", geom='material="m"'), head=look))
    assert subject.notes == (
        f"A picture is missing, outside the folder, or no PNG or KTX, and left plain, as physics sees none: {text}.",
    )


def test_a_cube_of_pictures_is_left_plain_as_a_whole(tmp_path: Path) -> None:
    sides = 'fileright="a.png" fileleft="b.png" fileup="c.png" filedown="d.png" filefront="e.png" fileback="f.png"'
    head = f'<asset><texture name="t" type="skybox" {sides}/></asset>'
    assert len(opened(tmp_path, mjcf(BOX, head=head)).notes) == 1


@pytest.mark.parametrize("name", ["vase.obj", "part.xml"])
def test_a_link_out_of_the_folder_is_refused(tmp_path: Path, name: str) -> None:
    models = tmp_path / "models"
    models.mkdir()
    (tmp_path / "vase.obj").write_text(OBJ)
    (tmp_path / "part.xml").write_text("<mujocoinclude/>")
    (models / name).symlink_to(tmp_path / name)
    heads = {
        "vase.obj": '<asset><mesh name="vase" file="vase.obj"/></asset>',
        "part.xml": '<include file="part.xml"/>',
    }
    file = models / "room.xml"
    file.write_text(mjcf(BOX, head=heads[name]))
    with pytest.raises(InputError, match=rf'names "{name}", a link that leaves the folder .*--root'):
        open_model(file)
    assert open_model(file, folder=tmp_path).things[0].id == "box"


def test_a_link_within_the_folder_is_followed(tmp_path: Path) -> None:
    (tmp_path / "part.xml").write_text("<mujocoinclude><option timestep='0.001'/></mujocoinclude>")
    (tmp_path / "link.xml").symlink_to(tmp_path / "part.xml")
    assert opened(tmp_path, mjcf(BOX, head='<include file="link.xml"/>')).model.opt.timestep == 0.001


@pytest.mark.parametrize("name", ["a" * 300 + ".obj", "a" * 5000 + ".obj", "loop.obj", "shut/vase.obj"])
def test_a_name_that_no_file_can_have_is_refused(tmp_path: Path, name: str) -> None:
    (tmp_path / "loop.obj").symlink_to(tmp_path / "loop.obj")
    (tmp_path / "shut").mkdir(mode=0)
    with pytest.raises(InputError, match="<mesh"):
        opened(tmp_path, mjcf(BOX, head=f'<asset><mesh name="vase" file="{name}"/></asset>'))
    shape = f'<collision><geometry><mesh filename="{name}"/></geometry></collision>'
    (tmp_path / "robot.urdf").write_text(f'<robot name="r"><link name="a">{shape}</link></robot>')
    with pytest.raises(InputError, match="<mesh"):
        open_model(tmp_path / "robot.urdf")


def test_a_model_outside_the_folder_that_is_given_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    file = tmp_path / "room.xml"
    file.write_text(mjcf(BOX))
    with pytest.raises(InputError, match="is not in the folder"):
        open_model(file, folder=tmp_path / "a")


@pytest.mark.parametrize("kind", ["fifo", "device"])
def test_what_is_no_ordinary_file_is_refused_at_once(tmp_path: Path, kind: str) -> None:
    file = tmp_path / "room.xml"
    if kind == "fifo":
        os.mkfifo(file)
    else:
        file.symlink_to("/dev/zero")
    with pytest.raises(InputError, match=r'"room\.xml" is no ordinary file'):
        open_model(file)


@pytest.mark.parametrize("name", ["a&#10;b", "a&#x9b;b", "a&#x2028;b", "a&#x202e;b"])
def test_a_name_with_control_characters_is_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputError, match="holds a control character") as caught:
        opened(tmp_path, mjcf(crate(name, "0 0 .1")))
    assert str(caught.value).isprintable()


def test_the_height_of_a_floor_that_a_model_lacks(tmp_path: Path) -> None:
    table = '<body name="table" pos="3 0 .5"><geom type="box" size=".5 .5 .5"/></body>'
    text = mjcf(table + crate("box", "0 0 .3"), floor="", head='<default><geom contype="2" conaffinity="0"/></default>')
    subject = opened(tmp_path, text)
    assert subject.notes == ("The model has no floor: a floor was put under the model's lowest point, at z = 0.000 m.",)


@pytest.mark.parametrize(
    ("floor", "world"),
    [
        (FLOOR, BOX),
        ('<geom type="plane" size="1 1 1"/>', BOX),
        ("", '<body><geom type="box" size=".5 .5 .5"/></body>' + crate("on", "0 0 .6")),
        ("", '<body name="fixed"><geom type="box" size=".5 .5 .5"/></body>'),
    ],
)
def test_a_floor_is_not_put_where_none_is_needed(tmp_path: Path, floor: str, world: str) -> None:
    assert opened(tmp_path, mjcf(world, floor=floor)).notes == ()
