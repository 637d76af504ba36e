"""Large data by content: bytes that values name by their SHA-256, so that a scene stays a small value.

Equal bytes have one name, wherever they come from, so one store serves the whole process: what a name stands for can
never change. Beside a scene.json they are files of that name in the folder `assets`.
"""

import re
from collections import OrderedDict
from hashlib import sha256
from pathlib import Path
from threading import RLock
from typing import Annotated, Literal

from msgspec import Meta

from thinkblox.errors import InputError
from thinkblox.regular_file import read_regular

BlobId = Annotated[str, Meta(pattern=r"^[0-9a-f]{64}\Z")]
"""The SHA-256 of some bytes, in lower-case hexadecimal digits."""
BlobKind = Literal["bin", "png"]
"""What a blob is, and how its file ends: a mesh of `textured_mesh`, or a picture."""
FOLDER = "assets"
"""Where blobs lie, beside the scene.json that names them."""
MAX_BLOB = 256_000_000
"""Largest blob [bytes]."""
_KEPT = 1_000_000_000
"""Bytes read from files that stay in memory; those longest unused are read again when asked for."""
_ID = re.compile(r"[0-9a-f]{64}")


def check_blob_id(id: str) -> None:
    """Raises InputError unless `id` is a SHA-256 in hexadecimal digits."""
    if not _ID.fullmatch(id):
        raise InputError(f"{id!r} is no name of a blob, which is a SHA-256 in 64 lower-case hexadecimal digits")


def blob_name(id: str, kind: BlobKind) -> str:
    """The path of a blob's file, relative to the scene.json that names it."""
    check_blob_id(id)
    return f"{FOLDER}/{id}.{kind}"


class BlobStore:
    """Bytes by the hash of their content: those that were put stay, those of files are read again when need be.

    Args:
        keep: so many bytes of what was read from files stay in memory.
    """

    def __init__(self, *, keep: int = _KEPT) -> None:
        self._given: dict[str, bytes] = {}
        self._files: dict[str, Path] = {}
        self._read: OrderedDict[str, bytes] = OrderedDict()
        self._keep = keep
        self._lock = RLock()

    def put(self, data: bytes) -> str:
        """Keep bytes; returns their name. Raises InputError for more than MAX_BLOB of them."""
        if len(data) > MAX_BLOB:
            raise InputError(f"a blob of {len(data)} bytes is too large; at most {MAX_BLOB} are kept")
        id = sha256(data).hexdigest()
        with self._lock:
            self._given[id] = bytes(data)
        return id

    def get(self, id: str) -> bytes:
        """The bytes called `id`; raises InputError when they were never given here, or their file has changed."""
        with self._lock:
            if id in self._given:
                return self._given[id]
            if id in self._read:
                self._read.move_to_end(id)
                return self._read[id]
            if id in self._files:
                return self._remember(id, _contents(self._files[id], id))
        raise InputError(f"there is no blob {id}; load the scene that names it from its folder")

    def read(self, id: str, kind: BlobKind, home: Path) -> None:
        """Find a blob in the folder of the scene that names it.

        Raises:
            InputError: the file is missing, is too large, is not what its name says, or lies outside of `home`.
        """
        file = home / blob_name(id, kind)
        if not _lies_in(file, home):
            raise InputError(f"{file}: leads out of the folder of its scene; it is not opened")
        data = _contents(file, id)
        with self._lock:
            self._files[id] = file.absolute()
            self._remember(id, data)

    def _remember(self, id: str, data: bytes) -> bytes:
        self._read[id] = data
        self._read.move_to_end(id)
        while len(self._read) > 1 and sum(map(len, self._read.values())) > self._keep:
            self._read.popitem(last=False)
        return data


BLOBS = BlobStore()
"""The store of this process."""


def _lies_in(file: Path, home: Path) -> bool:
    try:
        return file.resolve().is_relative_to(home.resolve())
    except (OSError, RuntimeError) as error:  # A loop of links is one or the other, by the release of Python.
        raise InputError(f"{file}: cannot be followed: {error}") from error


def _contents(file: Path, id: str) -> bytes:
    data = read_regular(file, most=MAX_BLOB)
    if sha256(data).hexdigest() != id:
        raise InputError(f"{file}: is not what its name says: its content was changed; save the scene again")
    return data
