"""Meshes and materials of a MuJoCo model: OBJ and PNG files by content, or all within the one file."""

import hashlib
from collections.abc import Mapping
from functools import lru_cache

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.exporters.hulls import hull_mesh, hull_obj
from thinkblox.exporters.inventory import InventoryLook
from thinkblox.scene.asset import Shape
from thinkblox.scene.blobs import BLOBS, FOLDER, blob_name
from thinkblox.scene.textured_mesh import TexturedMesh, mesh_of
from thinkblox.sim.build import hull_name

_GLOW = 0.5
"""The emission of what glows as brightly as its colour: more is white, under the light that it has besides."""


class Stock:
    """The meshes, materials and textures of a spec, each made when first asked for.

    Args:
        spec: what they are made in; the bytes of their files are put into its assets.
        looks: by name.
        pictures: textures that are in no blob, by hash.
        alone: the model must stand by itself, in one file: meshes lie in it, and textures are left out.
    """

    def __init__(
        self,
        spec: mujoco.MjSpec,
        looks: Mapping[str, InventoryLook],
        pictures: Mapping[str, bytes] | None = None,
        *,
        alone: bool = False,
    ) -> None:
        self._spec, self._looks, self._pictures, self.alone = spec, looks, pictures or {}, alone

    def hull(self, shape: Shape) -> str:
        """The mesh of a hull, also where the spec has it already, as points alone."""
        mesh, name = self._spec.mesh(hull_name(shape)), hull_name(shape)[:21]
        if self._spec.mesh(name) is None:
            mesh = mesh or self._spec.add_mesh()
            mesh.name = name
            mesh.inertia, mesh.smoothnormal = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX, shape.smooth
            self._spec.assets.pop(mesh.file, None)
            if self.alone:
                mesh.file = ""
                mesh.uservert = hull_mesh(shape.points, smooth=shape.smooth).points.ravel()
            else:
                mesh.file, self._spec.assets[mesh.file] = hull_obj(shape.points, smooth=shape.smooth)
        return name

    def blob(self, id: str) -> str:
        """The mesh of a blob."""
        return self.mesh(f"mesh_{id[:16]}", mesh_of(id))

    def mesh(self, name: str, drawn: TexturedMesh) -> str:
        """A mesh that is only looked at, called `name`."""
        if self._spec.mesh(name) is None:
            # Of an open surface only the shell has an inertia, which nothing uses.
            mesh = self._spec.add_mesh(name=name, inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL)
            if self.alone:
                _put_inline(mesh, drawn)
            else:
                mesh.file, data = obj_file(drawn)
                self._spec.assets[mesh.file] = data
        return name

    def material(self, name: str) -> str:
        """The material of a look."""
        if self._spec.material(name) is None:
            look = self._looks[name]
            material = self._spec.add_material(name=name, rgba=(*look.colour, look.opacity))
            material.roughness, material.metallic = look.roughness, look.metallic
            material.shininess, material.specular = 1.0 - look.roughness, 0.5 * (1.0 - look.roughness)
            material.emission = _GLOW * min(look.glow, 1.0)
            if look.texture is not None and not self.alone:
                material.textures[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = self._texture(look.texture)
        return name

    def _texture(self, id: str) -> str:
        name, file = f"texture_{id[:16]}", blob_name(id, "png")
        if self._spec.texture(name) is None:
            self._spec.add_texture(name=name, type=mujoco.mjtTexture.mjTEXTURE_2D, file=file)
            self._spec.assets[file] = self._pictures.get(id) or BLOBS.get(id)
        return name


def _put_inline(mesh: mujoco.MjsMesh, drawn: TexturedMesh) -> None:
    mesh.uservert, mesh.usernormal = drawn.vertices.ravel(), drawn.normals.ravel()
    mesh.userface = drawn.faces.ravel()


def obj_file(mesh: TexturedMesh) -> tuple[str, bytes]:
    """The path, relative to the model that names it, and the bytes of the OBJ file of a mesh.

    MuJoCo turns v upside down when it reads one, whose lowest row is v = 0 as in a `TexturedMesh`.
    """
    return _obj_file(mesh.to_bytes())


@lru_cache(maxsize=32)
def _obj_file(content: bytes) -> tuple[str, bytes]:
    mesh = TexturedMesh.from_bytes(content)
    rows = [*_rows("v", mesh.vertices), *_rows("vt", mesh.uv), *_rows("vn", mesh.normals)]
    rows += [f"f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}" for a, b, c in (mesh.faces + 1).tolist()]
    data = ("\n".join(rows) + "\n").encode()
    return f"{FOLDER}/{hashlib.sha256(data).hexdigest()}.obj", data


def _rows(word: str, values: NDArray[np.float32]) -> list[str]:
    return [word + "".join(f" {value:.9g}" for value in row) for row in values.tolist()]
