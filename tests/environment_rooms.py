"""Tiny rooms for robots, and robots of a user's own."""

from msgspec import structs

from tests.sim_rooms import asset, put, scene, table, vase, wardrobe
from thinkblox.scene.asset import Asset, Surface
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.scene import Scene

DOOR = Opening(id="door_1", kind="door", wall=0, offset=3.2, width=0.9, height=2.0)
FLOATING = """<mujoco model="ship"><option timestep="0.002"/><worldbody><body name="hull" pos="0 0 0.3">
  <freejoint/><geom type="box" size="0.2 0.1 0.1" euler="0 0 90"/><camera name="bow"/><site name="tool"/>
  <body name="flap"><joint name="flap" axis="0 1 0" range="-90 90"/><geom size="0.05" pos="0 0 0.2"/></body></body>
  </worldbody><actuator><motor name="flap" joint="flap"/></actuator></mujoco>"""
MOUNTED = """<mujoco model="arm"><worldbody><body name="foot"><geom type="cylinder" size="0.05 0.05" pos="0 0 0.05"/>
  <body name="upper" pos="0 0 0.2"><joint name="turn" axis="0 0 1" range="-170 170"/>
  <geom type="capsule" fromto="0 0 0 0 0 0.4" size="0.03"/><site name="attachment_site" pos="0 0 0.45"/></body></body>
  </worldbody><actuator><position name="turn" joint="turn" kp="10" ctrlrange="-2 2"/></actuator></mujoco>"""


def topped(name: str = "table") -> Asset:
    """A table that says that things can be put on it."""
    top = Surface(name="top", position=(0.0, 0.0, 0.75), size=(1.2, 0.8))
    return structs.replace(table(name=name), surfaces=(top,))


def robot_room() -> Scene:
    """Two tables, a vase on one of them, and a wardrobe, with floor to drive on."""
    return scene(
        rectangle(5.0, 5.0, openings=(DOOR,)),
        (put(topped(), 1.4, 1.2), topped()),
        (put(vase(), 1.3, 1.2, 0.75, on="table_1"), vase()),
        (put(topped("desk"), 3.6, 2.4), topped("desk")),
        (put(wardrobe(), 1.5, 4.65, yaw=-90.0), wardrobe()),
    )


def full_room() -> Scene:
    """A block that leaves no floor to a robot."""
    block = asset("block", (1.7, 1.7, 1.0))
    return scene(rectangle(2.0, 2.0), (put(block, 1.0, 1.0), block))
