"""What can be done to a scene, as values; a scene applies them, and what they do not concern stays bit-identical."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from msgspec import structs

from thinkblox.errors import InputError
from thinkblox.scene.asset import Asset, Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.support import placed_at
from thinkblox.value import Value, Vec3

if TYPE_CHECKING:
    from thinkblox.scene.scene import Scene


class Add(Value, frozen=True, kw_only=True, tag_field="action", tag="add"):
    """One object more. Position [m] and yaw [degrees] as of a Placement."""

    id: str
    asset: Asset
    position: Vec3
    yaw: float


class Move(Value, frozen=True, kw_only=True, tag_field="action", tag="move"):
    """An object goes elsewhere, and what rests on it rides along; turned too, where a yaw is given."""

    id: str
    position: Vec3
    yaw: float | None = None


class Turn(Value, frozen=True, kw_only=True, tag_field="action", tag="turn"):
    """An object turns about its own middle to another yaw, and what rests on it with it."""

    id: str
    yaw: float


class Replace(Value, frozen=True, kw_only=True, tag_field="action", tag="replace"):
    """Another asset under the same id, at the same place unless another is given.

    What hangs keeps its back at its wall and its middle at its height. What rested on the old one comes to rest on the
    new one where that has a surface under it; the rest is left where it was.
    """

    id: str
    asset: Asset
    position: Vec3 | None = None
    yaw: float | None = None


class Remove(Value, frozen=True, kw_only=True, tag_field="action", tag="remove"):
    """An object goes; what rested on it is left where it was."""

    id: str


class Swap(Value, frozen=True, kw_only=True, tag_field="action", tag="swap"):
    """Two objects change places and directions, each with what rests on it; backs stay at their walls."""

    id: str
    other: str


Action = Add | Move | Turn | Replace | Remove | Swap


class Applied(NamedTuple):
    """A scene after an action.

    Attributes:
        scene: with the action done.
        carried: ids of what rode along, in their order.
        left: ids of what rested on what moved or went, and was left where it was.
    """

    scene: "Scene"
    carried: tuple[str, ...] = ()
    left: tuple[str, ...] = ()


def outcome(scene: "Scene", action: Action) -> Applied:
    """Do an action.

    Raises:
        InputError: an id that the scene does not have, or has already (to add), a pose that is none, an object swapped
            with itself or with what rests on it.
    """
    _check_there(scene, action)
    match action:
        case Add():
            return Applied(_added(scene, action))
        case Move():
            return _moved(scene, action.id, action.position, action.yaw)
        case Turn():
            return _moved(scene, action.id, scene[action.id].position, action.yaw)
        case Replace():
            return _replaced(scene, action)
        case Remove():
            left = tuple(p.id for p in scene.resting_on(action.id))
            return Applied(scene.without(action.id), (), left)
        case Swap():
            return _swapped(scene, action.id, action.other)
        case _:
            raise InputError(f"a {type(action).__name__} is no action: Add, Move, Turn, Replace, Remove, Swap")


def _check_there(scene: "Scene", action: Action) -> None:
    ids = (action.id, action.other) if isinstance(action, Swap) else (getattr(action, "id", None),)
    unknown = [id for id in ids if id is not None and id not in scene]
    if unknown and not isinstance(action, Add):
        there = ", ".join(p.id for p in scene.placements) or "none"
        raise InputError(f"the scene has no object {unknown[0]!r}; there are {there}")


def _added(scene: "Scene", action: Add) -> "Scene":
    if action.id in scene:
        raise InputError(f"{action.id} cannot be added: the scene has an object of that id; move or replace it")
    position, yaw = check_pose(action.id, action.position, action.yaw)
    placement = placed_at(scene, action.asset, id=action.id, position=position, yaw=yaw or 0.0)
    return scene.with_placement(placement, action.asset)


def check_pose(id: str, position: Sequence[float], yaw: float | None) -> tuple[Vec3, float | None]:
    """A pose as a Placement has it, its yaw within 0 to 360 degrees; raises InputError unless it is finite numbers."""
    try:
        x, y, z = (float(c) + 0.0 for c in position)
        turn = None if yaw is None else (float(yaw) % 360.0) % 360.0
    except (TypeError, ValueError) as error:
        raise InputError(_no_pose(id, position, yaw)) from error
    if not all(map(math.isfinite, (x, y, z, turn or 0.0))):
        raise InputError(_no_pose(id, position, yaw))
    return (x, y, z), turn


def _no_pose(id: str, position: object, yaw: object) -> str:
    turned = "" if yaw is None else f" and turned to {yaw!r}"
    needs = "a position is three finite numbers [m]" + ("" if yaw is None else ", a yaw one [degrees]")
    return f"{id} cannot be put at {position!r}{turned}: that is no pose; {needs}"


def _moved(scene: "Scene", id: str, position: Vec3, yaw: float | None) -> Applied:
    old = scene[id]
    place, turn = check_pose(id, position, yaw)
    new = structs.replace(old, position=place, yaw=old.yaw if turn is None else turn)
    riders = scene.riders(id)
    moved = [new, *(_carried_along(rider, old, new) for rider in riders)]
    return Applied(scene.with_placements(moved), tuple(p.id for p in riders))


def _carried_along(rider: Placement, old: Placement, new: Placement) -> Placement:
    """A rider where its carrier's motion takes it."""
    x, y = new.to_room(old.to_local((rider.position[0], rider.position[1])))
    z = rider.position[2] + new.position[2] - old.position[2]
    yaw = rider.yaw if new.yaw == old.yaw else round((rider.yaw + new.yaw - old.yaw) % 360.0, 4) % 360.0
    return structs.replace(rider, position=(round(x, 6), round(y, 6), round(z, 6)), yaw=yaw)


def _replaced(scene: "Scene", action: Replace) -> Applied:
    old, asset = scene[action.id], action.asset
    position, turn = check_pose(old.id, action.position or _same_place(old, asset, scene), action.yaw)
    yaw = old.yaw if turn is None else turn
    new = structs.replace(
        old, category=asset.category, asset=asset.id, position=position, yaw=yaw, size=asset.size, support=""
    )
    carried: list[Placement] = []
    left: list[str] = []
    for rider in scene.resting_on(old.id):
        seated = _seated(rider, old, new, asset, on_top=_is_on_top(scene, rider, old))
        if seated is None:
            left.append(rider.id)
            continue
        carried += [seated, *(_carried_along(upper, rider, seated) for upper in scene.riders(rider.id))]
    after = scene.with_placement(new, asset)
    after = after.with_placements(carried) if carried else after
    return Applied(after, tuple(p.id for p in carried), tuple(left))


def _same_place(old: Placement, asset: Asset, scene: "Scene") -> Vec3:
    """Where another asset stands so that it takes the place of an old one: by its back, or by its top or middle."""
    x, y, z = old.position
    backed = asset.mount == "wall" or (asset.front == "one" and scene.asset_of(old).front == "one")
    if backed and asset.mount in ("wall", "floor"):
        x, y = old.to_room(((asset.size[0] - old.size[0]) / 2, 0.0))
    if asset.mount == "wall":
        z = min(max(0.0, z + (old.size[2] - asset.size[2]) / 2), max(0.0, scene.room.height - asset.size[2]))
    elif asset.mount == "ceiling":
        z = scene.room.height - asset.size[2]
    return (round(x, 6), round(y, 6), round(z, 6))


def _is_on_top(scene: "Scene", rider: Placement, old: Placement) -> bool:
    """Whether what rests on something does so on its top rather than in it."""
    surfaces = scene.asset_of(old).surfaces
    at = min(surfaces, key=lambda s: abs(old.position[2] + s.position[2] - rider.position[2]), default=None)
    return at is not None and not at.inner


def _seated(rider: Placement, old: Placement, new: Placement, asset: Asset, *, on_top: bool) -> Placement | None:
    """A rider on the new carrier, right where it is or else where it was on the old one; None where neither is a place.

    Of the surfaces under it, it takes the one nearest to its height; what stood on top stands on top again.
    """
    for at in (rider, _carried_along(rider, old, new)):
        x, y = new.to_local((at.position[0], at.position[1]))
        under = [s for s in asset.surfaces if _fits(rider, s, x, y)]
        tops = [s for s in under if not s.inner] if on_top else []
        heights = [new.position[2] + s.position[2] for s in tops or under]
        if heights:
            height = min(heights, key=lambda h: abs(h - at.position[2]))
            return structs.replace(at, position=(*at.position[:2], round(height, 6)))
    return None


def _fits(rider: Placement, surface: Surface, x: float, y: float) -> bool:
    """Whether a rider stands on a surface at a point of the carrier's frame: its middle is well over it."""
    inset = min(rider.size[:2]) / 4
    over = abs(x - surface.position[0]) + inset <= surface.size[0] / 2
    along = abs(y - surface.position[1]) + inset <= surface.size[1] / 2
    return over and along and (surface.headroom is None or rider.size[2] <= surface.headroom)


def _swapped(scene: "Scene", first: str, second: str) -> Applied:
    one, other = scene[first], scene[second]
    if first == second or first in scene.carriers(second) or second in scene.carriers(first):
        raise InputError(f"{first} and {second} cannot change places: one is the other, or rests on it")
    groups = []
    for mine, theirs in ((one, other), (other, one)):
        place = _same_place(theirs, scene.asset_of(mine), scene)
        new = structs.replace(mine, position=place, yaw=theirs.yaw)
        groups.append([new, *(_carried_along(rider, mine, new) for rider in scene.riders(mine.id))])
    moved = [placement for group in groups for placement in group]
    carried = tuple(p.id for p in moved if p.id not in (first, second))
    return Applied(scene.with_placements(moved), carried)
