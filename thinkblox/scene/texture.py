"""Pictures on surfaces: PNG files, looked at before they are unpacked."""

import struct
from functools import lru_cache
from io import BytesIO

import numpy as np
from numpy.typing import NDArray

from thinkblox.errors import InputError
from thinkblox.scene.blobs import BLOBS

MAX_SIDE = 4096
"""Longest side of a texture [pixels]."""
_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_HEADER = struct.Struct(">II")


def check_texture(data: bytes) -> None:
    """Raises InputError unless bytes begin as a PNG picture of at most MAX_SIDE pixels a side."""
    if not data.startswith(_SIGNATURE) or data[12:16] != b"IHDR" or len(data) < 33:
        raise InputError("is no PNG picture")
    width, height = _HEADER.unpack_from(data, 16)
    if not (1 <= width <= MAX_SIDE and 1 <= height <= MAX_SIDE):
        raise InputError(f"is a picture of {width} by {height} pixels; a texture has 1 to {MAX_SIDE} a side")


def put_texture(data: bytes) -> str:
    """Keep the bytes of a PNG picture as a blob; returns its name. Raises InputError for what is no such picture."""
    try:
        check_texture(data)
    except InputError as error:
        raise InputError(f"the texture {error}") from error
    return BLOBS.put(data)


@lru_cache(maxsize=16)
def pixels_of(id: str) -> NDArray[np.uint8]:
    """The texture in a blob as sRGB (height, width, 3), its top row first.

    Raises:
        InputError: there is no such blob, or it is no PNG picture that can be used.
    """
    from PIL import Image

    data = BLOBS.get(id)
    try:
        check_texture(data)
        with Image.open(BytesIO(data), formats=("PNG",)) as picture:
            return np.asarray(picture.convert("RGB"))
    except (InputError, OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise InputError(f"texture {id[:12]}: {error}") from error
