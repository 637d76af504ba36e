"""What a foreign layout says, in our conventions, before meshes are read and supports are looked for."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from thinkblox.importing.frames import Array
from thinkblox.scene.asset import Mount
from thinkblox.value import Vec2, Vec3

Anchor = Literal["centre", "base", "origin"]


@dataclass(frozen=True)
class Hole:
    """A door or window: the two ends of its foot line in the room's frame, and its lower and upper edge [m]."""

    name: str
    kind: Literal["door", "window"]
    ends: tuple[Vec2, Vec2]
    low: float
    high: float
    at: str


@dataclass(frozen=True)
class RoomOutline:
    """The room: corners of its floor in either order [m], the height of the floor and of the room [m].

    `height` is None where the format has none. `at` is the JSON path of the floor.
    """

    corners: tuple[Vec2, ...]
    at: str
    height: float | None = None
    level: float = 0.0
    holes: tuple[Hole, ...] = ()


@dataclass(frozen=True)
class Item:
    """One object.

    Attributes:
        name: as the layout calls it, the only one of that name.
        kind: words that say what it is.
        at: JSON path, for messages.
        position: of its anchor in the room's frame [m].
        linear: 3x3 map from its own frame (x front, y left, z up) to the room's: a rotation, and scales if it has any.
        anchor: the point that stands at `position`: the middle of its box, the middle of its box's base, or the origin
            of its mesh; before `linear`.
        size: (along the front, across, up) before `linear` [m]; None where the layout gives none.
        mesh: the file that shows it; None where there is none.
        called: what a table of sizes may call it besides.
        sought: what was looked for, when no mesh was found.
        scale: of the mesh, along the axes of the object's own frame.
        fitted: the mesh is stretched to `size`.
        mount, mass: where the layout says; [kg].
    """

    name: str
    kind: str
    at: str
    position: Vec3
    linear: Array
    anchor: Anchor = "centre"
    size: Vec3 | None = None
    mesh: Path | None = None
    called: str = ""
    sought: str = ""
    scale: Vec3 = (1.0, 1.0, 1.0)
    fitted: bool = False
    mount: Mount | None = None
    mass: float | None = None


@dataclass(frozen=True)
class LayoutDraft:
    """A whole layout; `unplaced` are names of objects that it lists without a pose."""

    outline: RoomOutline
    items: tuple[Item, ...]
    prompt: str = ""
    notes: tuple[str, ...] = ()
    unplaced: tuple[str, ...] = field(default=())
