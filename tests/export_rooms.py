"""A room with one of everything that an exporter has to tell apart."""

from dataclasses import dataclass, field

from tests.sim_rooms import asset, box, put, scene, table, vase, wardrobe
from thinkblox.scene.asset import Asset, Joint, Link, Shape
from thinkblox.scene.room import Opening, Room
from thinkblox.scene.scene import Scene
from thinkblox.verdict import Report, Verdict

L_ROOM = Room(
    floor=((0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (3.0, 3.0), (3.0, 5.0), (0.0, 5.0)),
    openings=(
        Opening(id="door_1", kind="door", wall=0, offset=4.8, width=0.9, height=2.0),
        Opening(id="window_1", kind="window", wall=1, offset=1.0, width=1.2, height=1.2, sill=0.9),
    ),
)


def all_shapes() -> Asset:
    """A low block that carries one shape of every kind, each a little over the next."""
    top = [(-0.1, -0.1, 0.0), (0.1, -0.1, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.2)]
    slanted = (0.9238795325112867, 0.0, 0.3826834323650898, 0.0)
    shapes = (
        box((0.4, 1.2, 0.2), (0.0, 0.0, 0.1), colour=(0.5, 0.35, 0.2)),
        Shape(kind="cylinder", size=(0.1, 0.1, 0.3), position=(0.0, -0.45, 0.35), material="metal"),
        Shape(kind="capsule", size=(0.1, 0.1, 0.3), position=(0.0, -0.2, 0.35), quat_wxyz=slanted, material="plastic"),
        Shape(kind="sphere", size=(0.2, 0.2, 0.2), position=(0.0, 0.05, 0.3), material="glass"),
        Shape(kind="ellipsoid", size=(0.3, 0.2, 0.1), position=(0.0, 0.25, 0.25), material="light"),
        Shape(kind="hull", size=(0.2, 0.2, 0.2), position=(0.0, 0.45, 0.2), points=tuple(top), colour=(0.1, 0.6, 0.2)),
    )
    return asset("sampler", (0.4, 1.2, 0.5), *shapes, mass=12.0, friction=0.7)


def drawer_box() -> Asset:
    """A cupboard for a wall, with one drawer and a flap about an oblique axis."""
    drawer = Link(
        name="drawer",
        shapes=(box((0.3, 0.36, 0.1), (0.0, 0.0, 0.1)),),
        joint=Joint(kind="slide", axis=(1.0, 0.0, 0.0), anchor=(0.0, 0.0, 0.1), lower=0.0, upper=0.25),
    )
    flap = Link(
        name="flap",
        shapes=(box((0.02, 0.36, 0.1), (0.18, 0.0, 0.25)),),
        joint=Joint(kind="hinge", axis=(0.0, -0.8, 0.6), anchor=(0.18, 0.0, 0.2), lower=0.0, upper=60.0),
    )
    return asset(
        "cupboard", (0.4, 0.4, 0.4), box((0.02, 0.4, 0.4), (-0.19, 0.0, 0.2)), mass=9.0, mount="wall",
        links=(drawer, flap),
    )  # fmt: skip


def rug() -> Asset:
    return asset("rug", (1.5, 2.0, 0.01), box((1.5, 2.0, 0.01), (0.0, 0.0, 0.005), collide=False, material="fabric"))


def picture() -> Asset:
    return asset("picture", (0.03, 0.6, 0.5), mass=2.0, mount="wall")


def sample_scene() -> Scene:
    return scene(
        L_ROOM,
        (put(table(), 1.5, 2.2, yaw=33.3), table()),
        (put(vase(), 1.5, 2.2, 0.75, on="table_1"), vase()),
        (put(wardrobe(), 0.75, 4.2, yaw=-90.0), wardrobe()),
        (put(all_shapes(), 3.5, 1.2, yaw=120.0), all_shapes()),
        (put(drawer_box(), 0.2001, 1.0, 1.2, on="west_wall"), drawer_box()),
        (put(picture(), 1.5, 0.0151, 1.4, 90.0, on="south_wall"), picture()),
        (put(rug(), 4.5, 1.5), rug()),
    )


@dataclass(frozen=True)
class Trace:
    """What `save_room` needs of an Episode."""

    lines: tuple[str, ...] = ("first", "second")

    def to_jsonl(self) -> bytes:
        return "".join(f"{line}\n" for line in self.lines).encode()


@dataclass(frozen=True)
class Result:
    """What `save_room` needs of a Generation."""

    scene: Scene
    report: Report
    episode: Trace = field(default_factory=Trace)


def result() -> Result:
    return Result(sample_scene(), report_on(sample_scene()))


def report_on(scene: Scene) -> Report:
    """A report that says that all is well, without looking."""
    objects = tuple(Verdict(id=placement.id, valid=True) for placement in scene.placements)
    return Report(valid=True, prompt="a room", objects=objects)
