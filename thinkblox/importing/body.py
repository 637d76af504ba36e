"""From an item to an asset and its pose: mesh or box, scaled, on its base, what is not yaw put into its shapes."""

import math
from dataclasses import dataclass

import numpy as np

from thinkblox.assets.decompose import FlatMeshError, convex_pieces
from thinkblox.assets.imported import BOX_CORNERS, box_shape, hull_shape, imported_asset
from thinkblox.assets.mesh_file import read_triangles
from thinkblox.errors import InputError
from thinkblox.importing.document import Document, plain
from thinkblox.importing.draft import Item
from thinkblox.importing.frames import Array, about, own_from_file, split_yaw
from thinkblox.importing.usual import FRICTION, category_name, is_rug, usual, usual_mass
from thinkblox.scene.asset import Asset, Mount, Shape
from thinkblox.value import Vec3

LARGEST, SMALLEST = 100.0, 1e-4
"""Extents that an object can have [m]."""
FURTHEST = 1000.0
"""Coordinate that an object can have [m]."""
DIFFERENT = 0.02
"""By which share a mesh may differ from the size that the layout gives before that is said."""


@dataclass(frozen=True)
class ItemBody:
    """An object's shapes in its own frame, origin at the footprint's centre at the base, and where that stands.

    Attributes:
        item: what it was made of.
        pieces: corner points of its convex pieces (n, 3) [m].
        boxed: it is a box for want of a mesh.
        plain_box: it is an upright box, and no hull is needed to say so.
        size: (along the front, across, up) of all pieces [m].
        position: of its origin in the room [m].
        yaw: counter-clockwise from +x [degrees].
        notes: what to say about it.
    """

    item: Item
    pieces: tuple[Array, ...]
    boxed: bool
    plain_box: bool
    size: Vec3
    position: Vec3
    yaw: float
    notes: tuple[str, ...]

    @property
    def in_room(self) -> tuple[Array, ...]:
        """The pieces' corners in the room [m]."""
        turn = about("z", self.yaw)
        return tuple(piece @ turn.T + self.position for piece in self.pieces)

    def asset(self, document: Document, mount: Mount) -> Asset:
        """The asset that it is, placed on what `mount` says.

        Raises:
            InputError: it is nothing that can be simulated, such as a hull without a volume; names file and object.
        """
        try:
            return self._asset(mount)
        except InputError as error:
            source = f" of {self.item.mesh}" if self.item.mesh and not self.boxed else ""
            document.fail(self.item.at, f"{plain(self.item.name)!r}{source}: {error}")

    def _asset(self, mount: Mount) -> Asset:
        kind, category = self.item.kind, usual(self.item.kind)
        name = category_name(kind)
        mass = self.item.mass if self.item.mass is not None else usual_mass(kind, self.size)
        source = self.item.mesh.name if self.item.mesh and not self.boxed else "box"
        return imported_asset(
            self._shapes(name, collide=not is_rug(kind, self.size[2])),
            category=name,
            description=plain(self.item.name),
            size=self.size,
            mass=round(mass, 6),
            friction=category.friction if category else FRICTION,
            mount=mount,
            provenance=f"layout:{plain(source)}",
        )

    def _shapes(self, category: str, *, collide: bool) -> list[Shape]:
        if self.plain_box:
            return [box_shape(self.size, category=category, collide=collide)]
        return [hull_shape(piece, category=category, collide=collide) for piece in self.pieces]


def body_of(document: Document, item: Item) -> ItemBody:
    """Build an item.

    Raises:
        InputError: its mesh cannot be used, it has neither mesh nor size, or it is larger or further away than a thing
            in a room can be; names the file and JSON path.
    """
    pieces, boxed, notes = _own_pieces(document, item)
    yaw, rest = split_yaw(item.linear)
    upright = bool((rest == np.eye(3)).all())
    anchored = _anchored(pieces, "centre" if boxed and item.anchor == "centre" else item.anchor, boxed=boxed)
    turned = [piece @ rest.T for piece in anchored]
    low, high = _bounds(turned)
    origin = np.array([*(low + high)[:2] / 2, low[2]])
    extent, place = high - low, np.asarray(item.position) + about("z", yaw) @ origin
    _check(document, item, extent, place, boxed=boxed)
    return ItemBody(
        item=item,
        pieces=tuple(piece - origin for piece in turned),
        boxed=boxed,
        plain_box=boxed and upright,
        size=_vec(extent),
        position=_vec(place),
        yaw=yaw,
        notes=notes,
    )


def _own_pieces(document: Document, item: Item) -> tuple[list[Array], bool, tuple[str, ...]]:
    """Convex pieces in the item's own frame, whether they are a box in a mesh's stead, and what to say about it."""
    if item.mesh is None:
        if item.size is None:
            hint = f"its mesh {plain(item.sought)!r} was not found" if item.sought else "it names no mesh"
            document.fail(
                item.at,
                f"{plain(item.name)!r} has no size, and {hint}; name the folder of assets that has its mesh (--assets),"
                " or a table of sizes (--sizes)",
            )
        return [BOX_CORNERS * item.size], True, ()
    try:
        found = convex_pieces(read_triangles(item.mesh))
    except FlatMeshError as error:
        if item.size is None:
            document.fail(item.at, f"{plain(item.name)!r}: {item.mesh}: {error}")
        return [BOX_CORNERS * item.size], True, (f"{plain(item.name)} is a box: {item.mesh.name}: {error}.",)
    except InputError as error:
        document.fail(item.at, f"the mesh of {plain(item.name)!r}: {error}")
    own = own_from_file(item.mesh)
    pieces = [piece @ own.T * item.scale for piece in found]
    if item.size is None:
        return pieces, False, ()
    low, high = _bounds(pieces)
    ratio = np.asarray(item.size) / (high - low)
    if item.fitted:
        return [piece * ratio for piece in pieces], False, ()
    return pieces, False, _difference(item, high - low, ratio)


def _difference(item: Item, extent: Array, ratio: Array) -> tuple[str, ...]:
    if np.abs(np.log(ratio)).max() < DIFFERENT:
        return ()
    told, measured = (" x ".join(f"{v:.3g}" for v in size) for size in (item.size or (), extent))
    return (f"{plain(item.name)}: the layout says {told} m, its mesh measures {measured} m; the mesh was taken.",)


def _anchored(pieces: list[Array], anchor: str, *, boxed: bool) -> list[Array]:
    """The pieces, moved so that the point which stands at the item's position is the origin."""
    if anchor == "origin" and not boxed:
        return pieces
    low, high = _bounds(pieces)
    middle = (low + high) / 2
    point = middle if anchor == "centre" else np.array([middle[0], middle[1], low[2]])
    return [piece - point for piece in pieces]


def _bounds(pieces: list[Array]) -> tuple[Array, Array]:
    every = np.vstack(pieces)
    return every.min(axis=0), every.max(axis=0)


def _check(document: Document, item: Item, extent: Array, place: Array, *, boxed: bool) -> None:
    measures = " x ".join(f"{v:.4g}" for v in extent)
    what = f"{plain(item.name)!r} measures {measures} m"
    if not np.isfinite(extent).all() or extent.max() > LARGEST or extent.min() < SMALLEST:
        hint = "" if boxed else ": is its mesh in centimetres or millimetres?"
        document.fail(item.at, f"{what}; an object in a room measures {SMALLEST:g} to {LARGEST:g} m each way{hint}")
    if not all(math.isfinite(v) and abs(v) <= FURTHEST for v in place):
        document.fail(
            item.at, f"{plain(item.name)!r} stands at {place.round(3).tolist()}; a room ends within {FURTHEST:g} m"
        )


def _vec(values: Array) -> Vec3:
    x, y, z = (round(float(v), 9) for v in values)
    return (x, y, z)
