"""Pictures as PNG."""

from io import BytesIO
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from PIL.Image import Image

_LEVEL = 2
"""Of zlib: a twentieth more bytes than its usual level of 6, in a quarter of the time."""


def png_of(picture: "Image") -> bytes:
    """A picture as the bytes of a PNG file, the same ones for the same picture."""
    file = BytesIO()
    picture.save(file, format="PNG", compress_level=_LEVEL)
    return file.getvalue()
