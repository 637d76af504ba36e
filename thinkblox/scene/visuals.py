"""What an asset looks like where its colliders do not say it: a mesh with a material, both by content."""

import math

from thinkblox.errors import InputError
from thinkblox.scene.blobs import BlobId, check_blob_id
from thinkblox.value import Value, Vec3


class Look(Value, frozen=True, kw_only=True, omit_defaults=True):
    """A surface as metal-rough materials describe it.

    Attributes:
        base_colour: sRGB triple, 0 to 1; where there is a texture, the texture is multiplied by it, in linear light.
        roughness: 0 is a mirror, 1 is chalk.
        metallic: 1 for bare metal, 0 for everything else.
        texture: blob of a PNG picture, sRGB; None for a plain colour.

    Raises:
        InputError: a number that is not in 0 to 1, or a texture that is no name of a blob.
    """

    base_colour: Vec3 = (1.0, 1.0, 1.0)
    roughness: float = 0.5
    metallic: float = 0.0
    texture: BlobId | None = None

    def __post_init__(self) -> None:
        for name, value in (
            *(("base_colour", channel) for channel in self.base_colour),
            ("roughness", self.roughness),
            ("metallic", self.metallic),
        ):
            if not (math.isfinite(value) and 0.0 <= value <= 1.0):
                raise InputError(f"the {name} of a look is {value}; it must be 0 to 1")
        if self.texture is not None:
            check_blob_id(self.texture)


class MeshVisual(Value, frozen=True, kw_only=True, omit_defaults=True):
    """A mesh to be looked at, in the asset's frame.

    Attributes:
        mesh: blob of a `TexturedMesh`.
        look: what it is made of.

    Raises:
        InputError: a mesh that is no name of a blob.
    """

    mesh: BlobId
    look: Look = Look()

    def __post_init__(self) -> None:
        check_blob_id(self.mesh)
