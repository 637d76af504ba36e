"""An asset that is seen otherwise than it collides: a box of three pieces under a mesh with a chequered texture."""

from io import BytesIO

import numpy as np
from msgspec import structs

from tests.sim_rooms import box, put, scene
from thinkblox.scene.asset import Asset, Joint, Link
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scene.texture import put_texture
from thinkblox.scene.textured_mesh import TexturedMesh, put_mesh
from thinkblox.scene.visuals import Look, MeshVisual
from thinkblox.value import Vec3

RED, BLUE = (200, 40, 30), (30, 60, 200)


def chequered_png(cells: int = 4, cell: int = 16) -> bytes:
    """A chequered picture whose upper half is red and white, and whose lower half is blue and white."""
    from PIL import Image

    side = cells * cell
    rows, columns = np.indices((side, side)) // cell
    pixels = np.full((side, side, 3), 240, np.uint8)
    dark = (rows + columns) % 2 == 0
    pixels[dark & (rows < cells // 2)] = RED
    pixels[dark & (rows >= cells // 2)] = BLUE
    file = BytesIO()
    Image.fromarray(pixels).save(file, "PNG")
    return file.getvalue()


def box_mesh(size: Vec3, centre: Vec3) -> TexturedMesh:
    """A box with the whole texture on each side, upright on the four that stand."""
    vertices: list[np.ndarray] = []
    normals: list[np.ndarray] = []
    up = np.array([0.0, 0.0, 1.0])
    for axis in range(3):
        for sign in (-1.0, 1.0):
            normal = np.eye(3)[axis] * sign
            high = up if axis < 2 else np.array([1.0, 0.0, 0.0])
            right = np.cross(high, normal)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                vertices.append((normal + u * right + v * high) / 2 * size + centre)
                normals.append(normal)
    uv = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] * 6
    faces = [(4 * side + a, 4 * side + b, 4 * side + c) for side in range(6) for a, b, c in ((0, 1, 2), (0, 2, 3))]
    return TexturedMesh.of(vertices=vertices, normals=normals, uv=uv, faces=faces)


def crate() -> Asset:
    """A crate with a lid on a hinge; body and lid are seen as textured meshes, and collide as boxes."""
    picture = put_texture(chequered_png())
    look = Look(base_colour=(1.0, 0.9, 0.8), roughness=0.6, texture=picture)
    body = Link(
        name="body",
        shapes=(box((0.6, 0.8, 0.5), (0.0, 0.0, 0.25)), box((0.1, 0.1, 0.1), (0.0, 0.0, 0.55), collide=False)),
        visuals=(MeshVisual(mesh=put_mesh(box_mesh((0.6, 0.8, 0.5), (0.0, 0.0, 0.25))), look=look),),
    )
    lid = Link(
        name="lid",
        shapes=(box((0.6, 0.8, 0.05), (0.0, 0.0, 0.53)),),
        joint=Joint(kind="hinge", axis=(0.0, -1.0, 0.0), anchor=(-0.3, 0.0, 0.505), lower=0.0, upper=90.0),
        visuals=(
            MeshVisual(
                mesh=put_mesh(box_mesh((0.6, 0.8, 0.05), (0.0, 0.0, 0.53))), look=Look(roughness=0.3, texture=picture)
            ),
        ),
    )
    return Asset(
        id="crate-0", category="crate", description="a painted crate", size=(0.6, 0.8, 0.555), mass=20.0, friction=0.6,
        mount="floor", links=(body, lid), licence="CC-BY-4.0", author='Ada "A" Müller <ada@example.org>',
    )  # fmt: skip


def without_visuals(asset: Asset) -> Asset:
    return structs.replace(asset, links=tuple(structs.replace(link, visuals=()) for link in asset.links))


def crate_scene(asset: Asset | None = None) -> Scene:
    """A room with a crate turned a little."""
    asset = asset or crate()
    return scene(rectangle(3.0, 3.0), (put(asset, 1.5, 1.5, yaw=-60.0), asset))
