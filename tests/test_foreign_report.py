"""The report on any model: collisions, supports and motion as closed forms have them, and nothing passes in silence."""

import math
from pathlib import Path

import numpy as np
import pytest
from msgspec import structs

import thinkblox
from tests.foreign_models import FLOOR, MODELS, crate, mjcf, of, opened, reported
from thinkblox.scene.room import rectangle
from thinkblox.sim.foreign.model_report import model_report
from thinkblox.sim.foreign.opening import open_model
from thinkblox.sim.subject import Subject
from thinkblox.value import to_json

ELLIPTIC = '<option cone="elliptic" impratio="10"/>'


def test_a_room_of_several_files_is_as_a_person_would_say() -> None:
    report = model_report(open_model(MODELS / "room" / "room.xml"))
    assert report.valid
    assert report.source == "mjcf"
    assert report.simulated == 5.0
    assert [[s.by for s in v.supports] for v in report.objects] == [[], [], ["floor"], ["table"]]
    assert of(report, "body_6").rest is not None
    assert of(report, "cabinet").rest is None
    assert report.notes == ()
    assert set(report.versions) == {"thinkblox", "mujoco"}


def test_the_same_model_gives_the_same_bytes() -> None:
    first, second = (model_report(open_model(MODELS / "room" / "room.xml")) for _ in range(2))
    assert to_json(first) == to_json(second)


@pytest.mark.parametrize("turn", [0, 35])
@pytest.mark.parametrize("depth", [0.002, 0.02, 0.08])
def test_depth_and_overlap_of_two_boxes_are_exact(tmp_path: Path, depth: float, turn: int) -> None:
    boxes = crate("a", "0 0 .1") + crate("b", f"{0.2 - depth} 0 .1")
    world = f'<frame euler="0 0 {turn}">{boxes}</frame>'
    report = reported(tmp_path, mjcf(world))
    for id, other in (("a", "b"), ("b", "a")):
        (collision,) = of(report, id).collisions
        assert collision.other == other
        assert collision.depth == pytest.approx(depth, abs=1e-5)
        assert collision.overlap == pytest.approx(depth / 0.2, rel=1e-3)
        assert "collision" in of(report, id).reasons
    assert report.depth == pytest.approx(depth, abs=1e-5)
    assert not report.valid


@pytest.mark.parametrize(
    ("geom", "volume", "sunk"),
    [
        ('type="sphere" size=".1"', 4 / 3 * math.pi * 1e-3, math.pi * 0.02**2 * (0.1 - 0.02 / 3)),
        ('type="cylinder" size=".1 .1"', math.pi * 2e-3, math.pi * 0.01 * 0.02),
        ('type="ellipsoid" size=".1 .1 .1"', 4 / 3 * math.pi * 1e-3, math.pi * 0.02**2 * (0.1 - 0.02 / 3)),
    ],
)
def test_overlap_of_round_shapes_with_the_floor(tmp_path: Path, geom: str, volume: float, sunk: float) -> None:
    for floor in (FLOOR, '<geom type="plane" size="5 5 .1"/>'):
        text = mjcf(f'<body name="a" pos="0 0 .08"><freejoint/><geom {geom}/></body>', floor=floor)
        (collision,) = of(reported(tmp_path, text), "a").collisions
        assert collision.other == "floor"
        assert collision.depth == pytest.approx(0.02, abs=1e-5)
        assert collision.overlap == pytest.approx(sunk / volume, rel=0.02)


def test_touching_within_tolerance_is_no_collision(tmp_path: Path) -> None:
    report = reported(tmp_path, mjcf(crate("a", "0 0 .0995") + crate("b", "0 0 .299")))
    assert report.valid
    assert of(report, "b").supports[0].by == "a"


def test_a_plank_on_two_trestles_shares_its_weight(tmp_path: Path) -> None:
    trestles = crate("left", "-.4 0 .1", free="") + crate("right", ".6 0 .1", free="")
    plank = crate("plank", "0 0 .21", half=".8 .1 .01")
    shares = {s.by: s.share for s in of(reported(tmp_path, mjcf(trestles + plank, head=ELLIPTIC)), "plank").supports}
    assert sum(shares.values()) == pytest.approx(1.0, abs=0.01)
    assert shares["left"] > shares["right"]


def test_shares_follow_the_lever(tmp_path: Path) -> None:
    posts = "".join(
        f'<body name="{n}" pos="{x} 0 .1"><geom type="box" size=".001 .1 .1"/></body>'
        for n, x in (("l", -0.3), ("r", 0.6))
    )
    plank = crate("plank", "0 0 .21", half=".8 .1 .01")
    shares = {s.by: s.share for s in of(reported(tmp_path, mjcf(posts + plank, head=ELLIPTIC)), "plank").supports}
    assert shares["l"] == pytest.approx(0.6 / 0.9, abs=0.02)
    assert shares["r"] == pytest.approx(0.3 / 0.9, abs=0.02)


def test_what_falls_drops(tmp_path: Path) -> None:
    verdict = of(reported(tmp_path, mjcf(crate("a", "0 0 .15")), seconds=2.0), "a")
    assert verdict.reasons == ("drop",)
    assert verdict.drop == pytest.approx(0.05, abs=5e-3)
    assert 0.0 < (verdict.rest or 0.0) < 1.0


def test_what_falls_for_ever_is_unsupported_too(tmp_path: Path) -> None:
    beside = '<geom type="plane" size="1 1 .1" pos="0 0 -99"/>'
    verdict = of(reported(tmp_path, mjcf(crate("a", "0 0 .15"), floor=beside)), "a")
    assert verdict.reasons == ("unsupported", "drop")
    assert verdict.drop == pytest.approx(9.81 / 2, rel=0.01)
    assert verdict.rest is None


def test_what_hovers_is_unsupported(tmp_path: Path) -> None:
    text = mjcf(crate("a", "0 0 1").replace("<body", '<body gravcomp="1"'))
    assert of(reported(tmp_path, text), "a").reasons == ("unsupported",)


def test_what_slides_drifts_and_what_topples_tilts(tmp_path: Path) -> None:
    slope = '<geom name="slope" type="box" size="2 2 .1" pos="0 0 -.1" euler="0 20 0" friction="0.1"/>'
    world = crate("a", "0 0 .107", geom='friction="0.1"').replace("pos=", 'euler="0 20 0" pos=')
    sliding = of(reported(tmp_path, mjcf(world, floor=slope)), "a")
    assert "drift" in sliding.reasons
    assert sliding.tilt < 2.0
    toppling = of(
        reported(tmp_path, mjcf(crate("a", "0 0 .5", half=".05 .05 .5").replace("pos=", 'euler="9 0 0" pos='))), "a"
    )
    assert "tilt" in toppling.reasons
    assert toppling.tilt > 60.0


def test_gravity_may_point_elsewhere(tmp_path: Path) -> None:
    wall = '<geom name="wall" type="box" size=".1 5 5" pos="-.1 0 0"/>'
    text = mjcf(crate("a", ".15 0 0"), head='<option gravity="-9.81 0 0"/>', floor=wall)
    verdict = of(reported(tmp_path, text), "a")
    assert verdict.reasons == ("drop",)
    assert verdict.drop == pytest.approx(0.05, abs=5e-3)
    assert [(s.by, s.share) for s in verdict.supports] == [("wall", 1.0)]


def test_without_gravity_nothing_is_said_to_be_supported(tmp_path: Path) -> None:
    report = reported(tmp_path, mjcf(crate("a", "0 0 1"), head='<option gravity="0 0 0"/>'))
    assert report.valid
    assert any("Without gravity" in note for note in report.notes)
    assert any("Gravity is (0, 0, 0)" in sentence for sentence in report.unusual)


def test_what_a_weld_or_a_tendon_holds_is_carried_by_it(tmp_path: Path) -> None:
    hung = crate("lamp", "0 0 1").replace("</body>", '<site name="hook" pos="0 0 .1"/></body>')
    world = f'<site name="ceiling" pos="0 0 1.5"/>{hung}{crate("sign", "1 0 1")}'
    tail = (
        '<tendon><spatial name="cord" limited="true" range="0 .4"><site site="ceiling"/><site site="hook"/></spatial>'
        "</tendon>"
        '<equality><weld body1="sign"/></equality></mujoco>'
    )
    report = reported(tmp_path, mjcf(world).replace("</mujoco>", tail))
    assert [s.by for s in of(report, "lamp").supports] == ["cord"]
    assert [s.by for s in of(report, "sign").supports] == ["world"]
    assert "unsupported" not in {reason for v in report.objects for reason in v.reasons}


def test_fixed_furniture_in_fixed_furniture_collides_and_in_a_wall_does_not(tmp_path: Path) -> None:
    fixed = [
        crate("sofa", "0 0 .4", half=".5 1 .4", free=""),
        crate("table", ".6 0 .3", half=".2 .2 .3", free=""),
        crate("wall_1", "0 1.05 1.2", half="2 .1 1.2", free=""),
        crate("a", "-.55 0 1.2", half=".1 3 1.2", free=""),
        crate("Floor0", "0 0 -.1", half="3 3 .15", free=""),
    ]
    report = reported(tmp_path, mjcf("".join(fixed), floor=""))
    assert {v.id: [c.other for c in v.collisions] for v in report.objects if v.collisions} == {
        "sofa": ["table"],
        "table": ["sofa"],
    }
    assert of(report, "sofa").depth == pytest.approx(0.1, abs=1e-6)
    assert of(report, "table").collisions[0].overlap == pytest.approx(0.25, abs=1e-6)
    assert any("Nothing in the model can move" in note for note in report.notes)


def test_joints_that_move_are_not_said_to_be_nothing_that_can(tmp_path: Path) -> None:
    hinge = '<joint name="hinge" axis="0 1 0" range="-90 90"/>'
    lid = f'<body name="lid" pos=".5 0 1">{hinge}<geom size=".3 .2 .02" type="box" pos=".3 0 0"/></body>'
    chest = f'<body name="chest">{lid}<geom type="box" size=".2 .2 .2" pos="0 0 .2"/></body>'
    notes = reported(tmp_path, mjcf(chest)).notes
    assert any("Joints moved" in note and "hinge of chest" in note for note in notes)
    assert not any("Nothing in the model can move," in note for note in notes)
    assert any("its joints alone" in note for note in notes)


def test_a_movable_thing_in_a_wall_collides_with_it(tmp_path: Path) -> None:
    wall = crate("wall_1", "0 1 1.2", half="2 .1 1.2", free="")
    (collision,) = of(reported(tmp_path, mjcf(wall + crate("box", "0 .83 .1"))), "box").collisions
    assert (collision.other, round(collision.depth, 4)) == ("wall_1", 0.03)


@pytest.mark.parametrize(
    ("world", "head", "tail"),
    [
        (
            crate("a", "0 0 .1", geom='contype="2" conaffinity="2"')
            + crate("b", ".15 0 .1", geom='contype="4" conaffinity="4"'),
            "",
            "",
        ),
        (crate("a", "0 0 .1") + crate("b", ".15 0 .1"), "", '<contact><exclude body1="a" body2="b"/></contact>'),
        (crate("a", "0 0 .1") + crate("b", ".15 0 .1"), '<option><flag contact="disable"/></option>', ""),
    ],
)  # fmt: skip
def test_contacts_that_are_switched_off_are_told(tmp_path: Path, world: str, head: str, tail: str) -> None:
    report = reported(tmp_path, mjcf(world, head=head).replace("</mujoco>", tail + "</mujoco>"))
    assert of(report, "a").collisions == ()
    assert any("switches off the contacts" in note and "a and b (50.0 mm)" in note for note in report.notes)


def test_a_contact_pair_makes_up_for_what_is_switched_off(tmp_path: Path) -> None:
    off = 'contype="0" conaffinity="0" name="{}"'
    world = crate("a", "0 0 .1", geom=off.format("x"))
    tail = '<contact><pair geom1="x" geom2="floor"/></contact></mujoco>'
    report = reported(tmp_path, mjcf(world).replace("</mujoco>", tail))
    assert report.valid
    assert report.notes == ()
    assert report.unusual == ()


def test_a_full_contact_buffer_is_unstable(tmp_path: Path) -> None:
    many = "".join(crate(f"b{n}", f"{n % 5 * 0.2} {n // 5 * 0.2} .1") for n in range(25))
    report = reported(tmp_path, mjcf(many, head='<size memory="150K"/>'))
    assert not report.valid
    assert all(v.reasons and "unstable" in v.reasons for v in report.objects)
    assert any("overflowed" in note for note in report.notes)


def test_a_simulation_that_blows_up_is_unstable(tmp_path: Path) -> None:
    world = '<body name="a" pos="0 0 1"><joint type="slide" axis="0 0 1" stiffness="1e9"/><geom size=".1"/></body>'
    text = mjcf(world + crate("b", "1 0 .1"), head='<option timestep="0.02"/>')
    text = text.replace("</mujoco>", '<keyframe><key qpos="5 1 0 .1 1 0 0 0"/></keyframe></mujoco>')
    report = reported(tmp_path, text)
    assert [v.reasons for v in report.objects if v.id == "b"] == [("unstable",)]
    assert any("BADQ" in note for note in report.notes)
    assert not report.valid


def test_too_small_a_step_is_an_error_and_no_hang(tmp_path: Path) -> None:
    report = reported(tmp_path, mjcf(crate("a", "0 0 .1"), head='<option timestep="1e-9"/>'))
    assert of(report, "a").reasons == ("error",)
    assert "more than 200000 steps" in of(report, "a").message


def test_what_sleeps_from_the_start_is_measured_all_the_same(tmp_path: Path) -> None:
    asleep = '<option><flag sleep="enable"/></option>'
    world = (crate("a", "0 0 .1") + crate("b", ".15 0 .1")).replace("<body", '<body sleep="init"')
    subject = opened(tmp_path, mjcf(world, head=asleep))
    report = model_report(subject, seconds=0.5)
    assert of(report, "a").depth == pytest.approx(0.05, abs=1e-5)
    assert of(report, "a").supports[0].by == "floor"
    assert subject.model.opt.enableflags != 0


def test_joints_that_swing_and_parts_in_one_another_are_told(tmp_path: Path) -> None:
    arm = (
        '<body name="arm" pos="0 0 2"><geom name="base" type="box" size=".1 .1 .1"/><body name="upper" pos=".3 0 0">'
        '<joint name="elbow" axis="0 1 0" range="-90 90"/><geom type="box" size=".1 .05 .05" pos=".1 0 0"/>'
        '<body name="tip"><joint name="wrist" axis="0 0 1"/><geom size=".05" pos="-.23 0 0"/></body></body></body>'
    )
    report = reported(tmp_path, mjcf(arm))
    assert any("Joints moved" in note and "elbow of arm" in note for note in report.notes)
    assert any("Parts of one thing are inside one another" in note and "arm" in note for note in report.notes)


def test_the_boundary_is_known_where_the_room_is(tmp_path: Path) -> None:
    subject = opened(tmp_path, mjcf(crate("in", "1 1 .1") + crate("out", "2.95 1 .1")))
    roomy = Subject(model=subject.model, start=subject.start, things=subject.things, room=rectangle(3.0, 3.0))
    report = model_report(roomy, seconds=0.2)
    assert of(report, "in").boundary == pytest.approx(-0.9, abs=1e-6)
    assert of(report, "out").boundary == pytest.approx(0.05, abs=1e-6)
    assert of(report, "out").reasons == ("outside",)


@pytest.fixture(scope="module")
def room(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, thinkblox.Generation]:
    folder = tmp_path_factory.mktemp("rooms") / "bedroom"
    made = thinkblox.generate_room("A bedroom with a bed, a nightstand with a lamp on it, a wardrobe and a rug", seed=3)
    thinkblox.save_room(made, folder, pictures=False)
    return folder, made


def test_our_own_export_has_no_false_faults(room: tuple[Path, thinkblox.Generation]) -> None:
    folder, made = room
    report = model_report(open_model(folder / "scene.xml"))
    assert made.report.valid
    assert report.valid, report
    assert [v.id for v in report.objects] == [v.id for v in made.report.objects]
    assert report.depth == pytest.approx(made.report.depth, abs=1e-6)
    assert report.drift == pytest.approx(made.report.drift, abs=1e-4)
    expected = ("No collision geometry", "The engine may put things to sleep")
    assert all(sentence.startswith(expected) or expected[0] in sentence for sentence in report.unusual)
    for theirs in made.report.objects:
        mine = of(report, theirs.id)
        if mine.supports:
            assert mine.supports[0].by == theirs.supports[0].by


def test_a_thing_pushed_into_another_in_our_export_collides_as_in_our_scene(
    room: tuple[Path, thinkblox.Generation],
) -> None:
    folder, made = room
    subject = open_model(folder / "scene.xml")
    moved = next(p for p in made.scene.placements if p.category == "nightstand")
    bed = next(p for p in made.scene.placements if "bed" in p.category)
    start, address = subject.start.copy(), int(subject.model.joint(f"{moved.id}_free").qposadr[0])
    towards = np.array(bed.position[:2]) - start[address : address + 2]
    start[address : address + 2] += 0.1 * towards / np.linalg.norm(towards)
    shifted = Subject(model=subject.model, start=start, things=subject.things, source="mjcf")
    mine = of(model_report(shifted, seconds=0.2), moved.id)
    x, y = map(float, start[address : address + 2])
    there = structs.replace(moved, position=(x, y, moved.position[2]))
    scene = made.scene.without(moved.id).with_placement(there, made.scene.asset_of(moved))
    theirs = of(thinkblox.verify(scene), moved.id)
    assert mine.collisions[0].other == theirs.collisions[0].other
    assert mine.depth == pytest.approx(theirs.depth, abs=2e-4)
