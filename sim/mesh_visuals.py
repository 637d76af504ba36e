"""Meshes with textures in a MuJoCo model: OBJ and PNG files by content, for what is only looked at."""

import hashlib
from functools import lru_cache

import msgspec
import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.blobs import BLOBS, FOLDER, blob_name
from thinkblox.scene.textured_mesh import mesh_of
from thinkblox.scene.visuals import Look, MeshVisual


def add_mesh_visual(spec: mujoco.MjSpec, body: mujoco.MjsBody, visual: MeshVisual) -> None:
    """Add a mesh to a body, in the body's frame: it has no mass and touches nothing.

    Its files are named relative to the model's, and lie in `spec.assets`. MuJoCo turns v upside down when it reads an
    OBJ file, whose lowest row is v = 0 as in a `TexturedMesh`.
    """
    geom = body.add_geom(spec.find_default("visual"), type=mujoco.mjtGeom.mjGEOM_MESH, mass=0.0)
    geom.meshname, geom.material = _mesh(spec, visual.mesh), _material(spec, visual.look)


def _mesh(spec: mujoco.MjSpec, id: str) -> str:
    name = f"mesh-{id[:32]}"
    if spec.mesh(name) is None:
        file, data = obj_file(id)
        # Of an open surface only the shell has an inertia, which nothing uses.
        spec.add_mesh(name=name, file=file, inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL)
        spec.assets[file] = data
    return name


def _material(spec: mujoco.MjSpec, look: Look) -> str:
    name = f"look-{hashlib.sha256(msgspec.json.encode(look)).hexdigest()[:32]}"
    if spec.material(name) is None:
        material = spec.add_material(name=name, rgba=(*look.base_colour, 1.0))
        material.roughness, material.metallic = look.roughness, look.metallic
        material.shininess, material.specular = 1.0 - look.roughness, 0.5 * (1.0 - look.roughness)
        if look.texture is not None:
            material.textures[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = _texture(spec, look.texture)
    return name


def _texture(spec: mujoco.MjSpec, id: str) -> str:
    name, file = f"texture-{id[:32]}", blob_name(id, "png")
    if spec.texture(name) is None:
        spec.add_texture(name=name, type=mujoco.mjtTexture.mjTEXTURE_2D, file=file)
        spec.assets[file] = BLOBS.get(id)
    return name


@lru_cache(maxsize=32)
def obj_file(id: str) -> tuple[str, bytes]:
    """The path, relative to the model that names it, and the bytes of the OBJ file of a mesh in a blob."""
    mesh = mesh_of(id)
    rows = [*_rows("v", mesh.vertices), *_rows("vt", mesh.uv), *_rows("vn", mesh.normals)]
    rows += [f"f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}" for a, b, c in (mesh.faces + 1).tolist()]
    data = ("\n".join(rows) + "\n").encode()
    return f"{FOLDER}/{hashlib.sha256(data).hexdigest()}.obj", data


def _rows(word: str, values: NDArray[np.float32]) -> list[str]:
    return [word + "".join(f" {value:.9g}" for value in row) for row in values.tolist()]
