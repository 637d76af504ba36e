"""A model that cannot be used is refused with its file, its element and the reason, and before the engine sees it."""

import struct
import time
from pathlib import Path

import pytest

from tests.foreign_models import FLOOR, crate, mjcf, opened
from thinkblox.errors import InputError
from thinkblox.sim.foreign import asset_limits, xml_elements
from thinkblox.sim.foreign.opening import open_model

BOX = crate("box", "0 0 .1")
MESH = '<asset><mesh name="vase" file="{}"/></asset>'
VASE = '<body><freejoint/><geom type="mesh" mesh="vase"/></body>'


def refusal(folder: Path, text: str, name: str = "room.xml") -> str:
    with pytest.raises(InputError) as caught:
        opened(folder, text, name)
    return str(caught.value)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "room.xml: the file is empty"),
        ("hello", "room.xml:1:1: not well-formed XML: syntax error"),
        ("<mujoco>\n<worldbody>\n</mujoco>", "room.xml:3:3: not well-formed XML: mismatched tag"),
        ("<mujoco><worldbody><geom size=1/></worldbody></mujoco>", "not well-formed"),
        ("<mujoco>\xff", "not well-formed"),
        ("<sdf/>", "room.xml:1: <sdf>: this is no model that can be read; those start with <mujoco> (MJCF)"),
        ("<mujoco/>", "room.xml: the model has no bodies"),
        (mjcf(""), "room.xml: the model has no bodies"),
        (mjcf('<body name="a"><site/></body>'), "room.xml: the model has no bodies"),
        (mjcf('<body><geom sise="1"/></body>'), "Schema violation: unrecognized attribute: 'sise'"),
        (mjcf('<body name="a"><freejoint/></body>'), "mass and inertia of moving bodies"),
        (mjcf(crate("box", "0 nan .1")), '<body name="box">: pos="0 nan .1" is not a number'),
        (mjcf(crate("box", "0 0 .1", geom='friction="NaN"')), 'friction="NaN" is not a number'),
        (mjcf(crate("box", "inf 0 .1")), "pos of the body box is not a finite number"),
        (mjcf(crate("box", "0 0 .1", geom='quat="inf 0 0 1"')), "quat of the geom 1 is not a finite number"),
        (mjcf(crate("box", "0 0 .1", geom='euler="inf 0 0"')), "quat of the geom 1 is not a finite number"),
        (mjcf(crate("box", "0 0 .1", geom='friction="inf 1 1"')), "friction of the geom 1 is not a finite number"),
        (mjcf(crate("box", "0 1e300 .1")), "pos of the body box is not a finite number, or more than 1e+10"),
        (mjcf(BOX, head='<option timestep="0"/>'), "<option timestep> is 0; it must be a time greater than 0"),
        (mjcf(BOX, head='<option timestep="-1"/>'), "<option timestep> is -1"),
        (mjcf(BOX, head='<option gravity="0 0 inf"/>'), "<option gravity> is not made of finite numbers"),
        (mjcf(BOX, head='<size memory="900G"/>'), 'memory="900G" is more than can be given'),
        (mjcf(BOX, head='<size nconmax="999999999"/>'), "more than can be given"),
        (mjcf(BOX, head='<asset><hfield name="h" nrow="99999" ncol="99999" size="1 1 1 1"/></asset>'), "nrow x ncol"),
        (mjcf(BOX, head='<asset><texture builtin="flat" width="99999" height="99999"/></asset>'), "width x height"),
        (mjcf(BOX, head='<extension><plugin plugin="mujoco.sdf.bolt"/></extension>'), "<extension>: engine plugins"),
        (mjcf(BOX, head='<equality><connect body1="box" anchor=""/></equality>'), "room.xml: MuJoCo cannot read it: "),
        (mjcf("<body>" * 500 + '<geom size="1"/>' + "</body>" * 500), "nested more than 400 deep"),
    ],
)  # fmt: skip
def test_a_bad_model_is_refused_with_a_reason(tmp_path: Path, text: str, says: str) -> None:
    assert says in refusal(tmp_path, text)


def test_a_missing_file_or_a_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"nothing\.xml: cannot be read: No such file"):
        open_model(tmp_path / "nothing.xml")
    with pytest.raises(InputError, match="cannot be read"):
        open_model(tmp_path)


ENTITIES = "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 30))


@pytest.mark.parametrize(
    "doctype",
    [
        "<!DOCTYPE mujoco>",
        f'<!DOCTYPE mujoco [<!ENTITY e0 "ha">{ENTITIES}]>',
        '<!DOCTYPE m [<!ENTITY x SYSTEM "file:///etc/passwd">]>',
        """<!DOCTYPE m [<?x ]><mujoco><include file="/etc/passwd"/></mujoco> ?>]>""",
    ],
)
def test_every_doctype_is_refused(tmp_path: Path, doctype: str) -> None:
    assert "room.xml:1: it has a DOCTYPE" in refusal(tmp_path, f"{doctype}{mjcf(BOX)}")
    assert "room.xml:2: it has a DOCTYPE" in refusal(tmp_path, f'<?xml version="1.0"?>\n{doctype}{mjcf(BOX)}')


def test_nothing_can_be_hidden_in_what_looks_like_a_comment(tmp_path: Path) -> None:
    hidden = "<mujoco><!-- -- --><custom><text name='<!--'/></custom><include file='/etc/passwd'/><!-- --> '</mujoco>"
    assert "not well-formed" in refusal(tmp_path, hidden)


def test_a_file_too_large_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(xml_elements, "LARGEST_FILE", 2**20)
    assert "2 MiB; at most 1 MiB" in refusal(tmp_path, mjcf(BOX) + " " * 2**21)


@pytest.mark.parametrize(
    ("world", "bodies"),
    [
        ("<body/>" * 20_001, 20_001),
        (f'<replicate count="1000"><replicate count="1000">{BOX}</replicate></replicate>', 1_000_000),
        ('<flexcomp name="f" type="grid" count="100 100 100" spacing="1 1 1"/>', 1_000_000),
        ('<composite type="cable" prefix="a" count="30000 1 1" size="1"/>', 30_000),
    ],
)
def test_too_many_bodies_are_refused(tmp_path: Path, world: str, bodies: int) -> None:
    assert f"the model has at least {bodies} bodies; at most 20000 are read" in refusal(tmp_path, mjcf(world))


def test_a_million_bodies_are_refused_soon(tmp_path: Path) -> None:
    file = tmp_path / "room.xml"
    file.write_text(mjcf("<body><freejoint/><geom size='.1'/></body>\n" * 1_000_000))
    begin = time.process_time()
    with pytest.raises(InputError, match="20001 bodies"):
        open_model(file)
    assert time.process_time() - begin < 30.0, "the engine would take minutes"


def test_bodies_of_attached_models_count(tmp_path: Path) -> None:
    (tmp_path / "many.xml").write_text(mjcf("<body><geom size='1'/></body>" * 15_000, floor=""))
    attach = '<attach model="m" prefix="{}"/>'
    text = mjcf(attach.format("a") + attach.format("b"), head='<asset><model name="m" file="many.xml"/></asset>')
    assert "30000 bodies" in refusal(tmp_path, text)


def test_a_million_elements_are_refused(tmp_path: Path) -> None:
    text = mjcf(f'<body><geom size="1"/></body><replicate count="{10**9}"><site/></replicate>')
    assert "elements; at most 500000" in refusal(tmp_path, text)


@pytest.mark.parametrize(
    ("head", "says"),
    [
        (MESH.format("vase.obj"), '<mesh name="vase"> names "vase.obj", which is not in'),
        (MESH.format("/etc/vase.obj"), 'room.xml:1: <mesh name="vase"> names the absolute path "/etc/vase.obj"'),
        (MESH.format("C:\\vase.obj"), "absolute path"),
        (MESH.format("https://example.org/vase.obj"), "absolute path"),
        (MESH.format("../vase.obj"), 'names "../vase.obj", which leaves the folder'),
        (MESH.format("a/../../vase.obj"), "leaves the folder"),
        (MESH.format("..\\vase.obj"), "leaves the folder"),
        ('<compiler meshdir=".."/>' + MESH.format("vase.obj"), "leaves the folder"),
        ('<compiler meshdir="/etc"/>' + MESH.format("vase.obj"), 'meshdir="/etc" is an absolute path'),
        ('<compiler assetdir="meshes"/>' + MESH.format("vase.obj"), "meshes"),
        ('<asset><hfield name="h" file="../h.png" size="1 1 1 1"/></asset>', '<hfield name="h"> names "../h.png"'),
        ('<asset><skin name="s" file="s.skn"/></asset>', '<skin name="s"> names "s.skn"'),
        ('<asset><model name="m" file="../m.xml"/></asset>', '<model name="m"> names "../m.xml"'),
        ('<include file="../part.xml"/>', '<include> names "../part.xml", which leaves'),
        ('<include file="/etc/passwd"/>', "absolute path"),
        ('<INCLUDE file="/etc/passwd"/>', "absolute path"),
        ('<include file="part.xml"/>', 'names "part.xml", which is not in'),
        ('<include file="room.xml"/>', "includes itself: room.xml -> room.xml"),
        ('<asset><model name="m" file="room.xml"/></asset>', "it attaches itself: room.xml -> room.xml"),
    ],
)
def test_files_that_are_missing_or_elsewhere_are_refused(tmp_path: Path, head: str, says: str) -> None:
    assert says in refusal(tmp_path, mjcf(BOX, head=head))


def test_paths_in_includes_are_judged_too(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "a.xml").write_text('<mujocoinclude>\n<include file="b.xml"/></mujocoinclude>')
    (tmp_path / "parts" / "b.xml").write_text(f"<mujocoinclude>\n\n{MESH.format('../../vase.obj')}</mujocoinclude>")
    said = refusal(tmp_path, mjcf(BOX, head='<include file="parts/a.xml"/>'))
    assert 'parts/b.xml:3: <mesh name="vase"> names "../../vase.obj", which leaves' in said


def test_includes_in_a_circle_and_twice_are_refused(tmp_path: Path) -> None:
    (tmp_path / "a.xml").write_text('<mujocoinclude><include file="b.xml"/></mujocoinclude>')
    (tmp_path / "b.xml").write_text('<mujocoinclude><include file="a.xml"/></mujocoinclude>')
    assert "includes itself: room.xml -> a.xml -> b.xml -> a.xml" in refusal(
        tmp_path, mjcf(BOX, head='<include file="a.xml"/>')
    )
    (tmp_path / "c.xml").write_text("<mujocoinclude><option/></mujocoinclude>")
    twice = mjcf(BOX, head='<include file="c.xml"/><include file="c.xml"/>')
    assert "included twice" in refusal(tmp_path, twice)


def test_a_file_outside_is_read_where_the_folder_is_given(tmp_path: Path) -> None:
    (tmp_path / "models").mkdir()
    (tmp_path / "part.xml").write_text("<mujocoinclude><option timestep='0.001'/></mujocoinclude>")
    file = tmp_path / "models" / "room.xml"
    file.write_text(mjcf(BOX, head='<include file="../part.xml"/>'))
    with pytest.raises(InputError, match="leaves the folder"):
        open_model(file)
    assert open_model(file, folder=tmp_path).model.opt.timestep == 0.001


def test_what_exists_instead_is_said(tmp_path: Path) -> None:
    (tmp_path / "vases.obj").write_text("v 0 0 0")
    assert "There are vases.obj." in refusal(tmp_path, mjcf(BOX, head=MESH.format("vase.obj")))


def stl(triangles: int, *numbers: float) -> bytes:
    return bytes(80) + struct.pack("<I", triangles) + b"".join(struct.pack("<f", n) for n in numbers)


OBJ_FLAT = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 3 2\nf 1 2 4\n"
OBJ_NAN = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 nan\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
PNG_HUGE = b"\x89PNG\r\n\x1a\n" + bytes(8) + struct.pack(">II", 60_000, 60_000)


@pytest.mark.parametrize(
    ("name", "data", "says"),
    [
        ("vase.stl", stl(5_000_001), '"vase.stl" has 5000001 triangles; at most 5000000'),
        ("vase.msh", struct.pack("<4i", 9, 0, 0, 6_000_000), "6000000 triangles"),
        ("vase.obj", b"v 0 0 0\n" + b"f 1 1 1\n" * 5_000_001, "5000001 triangles"),
        ("vase.obj", b"", 'the file "vase.obj" is empty'),
        ("vase.dae", b"<COLLADA/>", '"vase.dae" is of a kind that MuJoCo does not read'),
        ("vase.obj", OBJ_FLAT, "coplanar"),
        ("vase.obj", OBJ_NAN, "not finite"),
        ("vase.obj", b"not a mesh", "at least 4 vertices"),
        ("vase.stl", b"solid vase\nfacet normal 0 0 1\n" + b" " * 99, "ASCII"),
        ("vase.stl", stl(9, 1.0, 2.0), "vase.stl"),
    ],
)
def test_bad_meshes_are_refused_with_their_file(tmp_path: Path, name: str, data: bytes, says: str) -> None:
    (tmp_path / name).write_bytes(data)
    said = refusal(tmp_path, mjcf(VASE, head=MESH.format(name)))
    assert says in said
    assert name in said


def test_a_mesh_file_too_large_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(asset_limits, "LARGEST_MESH", 2**20)
    (tmp_path / "vase.obj").write_bytes(b"# " * 2**20)
    assert '"vase.obj" has 2 MiB; at most 1 MiB' in refusal(tmp_path, mjcf(VASE, head=MESH.format("vase.obj")))


def test_a_picture_too_large_is_refused(tmp_path: Path) -> None:
    (tmp_path / "wood.png").write_bytes(PNG_HUGE)
    text = mjcf(BOX, head='<asset><texture name="t" type="2d" file="wood.png"/></asset>')
    assert '"wood.png" has 60000 x 60000 pixels' in refusal(tmp_path, text)


def test_names_may_read_like_numbers(tmp_path: Path) -> None:
    assert [t.id for t in opened(tmp_path, mjcf(crate("nan", "0 0 .1"), floor=FLOOR)).things] == ["nan"]
