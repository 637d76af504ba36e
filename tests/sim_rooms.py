"""Tiny rooms and hand-made assets for the tests of thinkblox.sim."""

from thinkblox.scene.asset import Asset, Joint, Link, Mount, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec3


def box(size: Vec3, position: Vec3, **more: object) -> Shape:
    return Shape(kind="box", size=size, position=position, **more)  # type: ignore[arg-type]


def asset(
    name: str,
    size: Vec3,
    *shapes: Shape,
    mass: float = 10.0,
    mount: Mount = "floor",
    friction: float = 0.6,
    links: tuple[Link, ...] = (),
) -> Asset:
    """An asset of these shapes; without any, one box."""
    body = Link(name="body", shapes=shapes or (box(size, (0.0, 0.0, size[2] / 2)),))
    return Asset(
        id=f"{name}-0", category=name, description=name, size=size, mass=mass, friction=friction, mount=mount,
        links=(body, *links),
    )  # fmt: skip


def put(
    asset: Asset, x: float, y: float, z: float = 0.0, yaw: float = 0.0, *, id: str = "", on: str = "floor"
) -> Placement:
    return Placement(
        id=id or f"{asset.category}_1", category=asset.category, asset=asset.id, position=(x, y, z), yaw=yaw,
        size=asset.size, support=on,
    )  # fmt: skip


def scene(room: Room | None = None, *objects: tuple[Placement, Asset]) -> Scene:
    built = Scene(room=room or rectangle(4.0, 5.0))
    for placement, kind in objects:
        built = built.with_placement(placement, kind)
    return built


def table(width: float = 1.2, depth: float = 0.8, height: float = 0.75, name: str = "table") -> Asset:
    leg, x, y = 0.05, width / 2 - 0.04, depth / 2 - 0.04
    legs = [box((leg, leg, height - 0.03), (sx * x, sy * y, (height - 0.03) / 2)) for sx in (-1, 1) for sy in (-1, 1)]
    return asset(name, (width, depth, height), box((width, depth, 0.03), (0.0, 0.0, height - 0.015)), *legs, mass=25.0)


def vase(name: str = "vase") -> Asset:
    shape = Shape(kind="cylinder", size=(0.12, 0.12, 0.3), position=(0.0, 0.0, 0.15), material="ceramic")
    return asset(name, (0.12, 0.12, 0.3), shape, mass=1.5, mount="surface")


def wardrobe() -> Asset:
    """A carcass with two hinged doors on its front."""
    width, depth, height, board = 1.0, 0.6, 2.0, 0.02
    inner = depth - board - 0.002
    middle = -(board + 0.002) / 2
    carcass = [
        box((inner, board, height), (middle, width / 2 - board / 2, height / 2)),
        box((inner, board, height), (middle, -width / 2 + board / 2, height / 2)),
        box((inner, width - 2 * board, board), (middle, 0.0, 0.1)),
        box((inner, width - 2 * board, board), (middle, 0.0, height - board / 2)),
        box((board, width - 2 * board, height), (-depth / 2 + board / 2, 0.0, height / 2)),
    ]
    doors = tuple(
        Link(
            name=f"door_{side}",
            shapes=(box((board, width / 2 - 0.004, height - 0.12), (depth / 2 - board / 2, y, height / 2 + 0.05)),),
            joint=Joint(
                kind="hinge", axis=(0.0, 0.0, axis), anchor=(depth / 2 - board, edge, 0.0), lower=0.0, upper=110.0
            ),
        )
        for side, y, edge, axis in (("left", width / 4, width / 2, 1.0), ("right", -width / 4, -width / 2, -1.0))
    )
    return asset("wardrobe", (depth, width, height), *carcass, mass=60.0, links=doors)
