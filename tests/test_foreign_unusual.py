"""Options that make things stand better than they would are said, each in one sentence with its numbers."""

from pathlib import Path

import pytest

from tests.foreign_models import FLOOR, crate, mjcf, opened

BOX = crate("box", "0 0 .1")
SLEEP = '<option><flag sleep="enable"/></option>'
FREE = '<joint type="free" {}/>'


@pytest.mark.parametrize(
    ("world", "head", "says"),
    [
        (crate("box", "0 0 .1", free=FREE.format('damping="2"')), "", "Damping of up to 2 is added to the free"),
        (crate("box", "0 0 .1", free=FREE.format('armature="0.5"')), "", "Armature of up to 0.5 adds inertia"),
        (crate("box", "0 0 .1", free=FREE.format('frictionloss="4"')), "", "Dry friction of up to 4"),
        (crate("box", "0 0 .1", free=FREE.format('stiffness="90"')), "", "A spring of up to 90 N/m holds box"),
        (crate("box", "0 0 .1", geom='friction="2"'), "", "Friction is up to 2 on box."),
        (BOX, '<option timestep="0.01"/>', "The time step is coarse: 10 ms."),
        (BOX, '<option gravity="0 0 -3.7"/>', "Gravity is (0, 0, -3.7) m/s2"),
        (BOX, '<option gravity="0 -9.81 0"/>', "Gravity is (0, -9.81, 0) m/s2"),
        (BOX, '<option><flag gravity="disable"/></option>', "Gravity is disabled"),
        (BOX, '<option><flag contact="disable"/></option>', "Contacts are disabled"),
        (BOX, '<option><flag constraint="disable"/></option>', "All constraints are disabled"),
        (BOX.replace("<body", '<body gravcomp="1"'), "", "Gravity is compensated, by up to 100%, on box."),
        (crate("box", "0 0 .1", geom='margin="0.02"'), "", "margin or gap of up to 20 mm at box"),
        (crate("box", "0 0 .1", geom='solref="0.2 1"'), "", "very soft, with time constants up to 0.2 s, at box"),
        (crate("box", "0 0 .1", geom='solref="-100 -10"'), "", "very soft, with time constants up to 0.211 s"),
        (BOX, '<option o_margin="0.01"><flag override="enable"/></option>', "overrides every contact: margin 10 mm"),
        (BOX, '<option noslip_iterations="10"/>', "10 extra iterations"),
        (BOX, '<option density="1000" viscosity="0.1"/>', "fluid of 1000 kg/m3 and viscosity 0.1 Pa s"),
        (BOX, SLEEP, "may put things to sleep"),
        (BOX.replace("<body", '<body sleep="init"'), SLEEP, "starts with box asleep"),
        (crate("box", "0 0 .1", geom='contype="0" conaffinity="0"'), "", "No collision geometry"),
        (BOX, '<equality><weld body1="box"/></equality>', "An equality constraint holds box to the world."),
        (BOX, '<equality><connect body1="box" anchor="0 0 0"/></equality>', "holds box to the world"),
    ],
)  # fmt: skip
def test_an_unusual_option_is_said(tmp_path: Path, world: str, head: str, says: str) -> None:
    subject = opened(tmp_path, mjcf(world, head=head))
    assert any(says in sentence for sentence in subject.unusual), subject.unusual
    assert len(subject.unusual) == 1


def test_actuators_are_said(tmp_path: Path) -> None:
    world = '<body name="arm"><joint name="j"/><geom size=".1"/></body>'
    text = mjcf(world).replace("</mujoco>", '<actuator><motor joint="j"/><motor joint="j"/></actuator></mujoco>')
    assert opened(tmp_path, text).unusual == ("2 actuators act on arm.",)


def test_ordinary_options_are_not(tmp_path: Path) -> None:
    default = '<default><geom friction="1.2" solref="0.02 1" margin="0.001"/></default>'
    head = '<option timestep="0.005" gravity="0 0 -9.8"/>' + default
    assert opened(tmp_path, mjcf(BOX, head=head)).unusual == ()


def test_damping_and_armature_of_hinges_are_ordinary(tmp_path: Path) -> None:
    hinge = '<joint type="hinge" damping="2" armature="1" frictionloss="1"/>'
    assert opened(tmp_path, mjcf(crate("door", "0 0 1", free=hinge))).unusual == ()


def test_two_hundred_bodies_give_one_sentence(tmp_path: Path) -> None:
    many = "".join(crate(f"b{n}", f"{n} 0 .1", free=FREE.format(f'damping="{n + 1}"')) for n in range(200))
    (sentence,) = opened(tmp_path, mjcf(many)).unusual
    assert sentence == "Damping of up to 200 is added to the free motion of b0, b1, b2 and 197 more."


def test_friction_of_the_floor_is_said_by_its_name(tmp_path: Path) -> None:
    floor = FLOOR.replace("/>", ' friction="3"/>')
    assert opened(tmp_path, mjcf(BOX, floor=floor)).unusual == ("Friction is up to 3 on floor.",)
