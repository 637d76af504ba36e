"""What collides, in the shapes that every reader of robots' models has: boxes, cylinders, balls, and hulls as files."""

from dataclasses import dataclass, field

from thinkblox.exporters.hulls import hull_obj, hull_of, rod_of
from thinkblox.scene.asset import Shape
from thinkblox.sim.geometry.collider import collider


@dataclass
class SolidFiles:
    """The OBJ files of hulls, by their paths relative to what names them."""

    files: dict[str, bytes] = field(default_factory=dict)

    def hull(self, shape: Shape) -> str:
        """The path of a hull's file, which is kept."""
        name, data = hull_obj(shape.points, smooth=shape.smooth)
        self.files[name] = data
        return name


def plain_solid(shape: Shape) -> Shape:
    """The shape as it collides, a capsule and an ellipsoid as hulls."""
    if shape.kind == "ellipsoid":
        return collider(hull_of(shape))
    return collider(rod_of(shape)) if shape.kind == "capsule" else collider(shape)
