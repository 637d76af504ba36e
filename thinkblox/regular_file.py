"""Reading files of others with limits: only what is a regular file, and only so much of it."""

import codecs
import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from thinkblox.errors import InputError

MAX_BYTES = 256_000_000
"""Largest file of ours that is read as a whole [bytes]."""


def read_regular(path: Path, *, most: int = MAX_BYTES) -> bytes:
    """The content of a regular file of at most `most` bytes; raises InputError that names the file."""
    with opened_regular(path, most=most) as file:
        data = file.read(most + 1)
    if len(data) > most:
        raise _too_large(path, most)
    return data


def read_text(path: Path, *, most: int = MAX_BYTES) -> bytes:
    """The content of a text file as UTF-8 without a mark before it, with which, or as UTF-16, some editors save it.

    Raises:
        InputError: as for `read_regular`, or it begins as UTF-16 and is none.
    """
    data = read_regular(path, most=most)
    if not data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.removeprefix(codecs.BOM_UTF8)
    try:
        return data.decode("utf-16").encode()
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-16, as which it begins: {error.reason}; save it as UTF-8") from error


def read_lines(path: Path) -> tuple[str, ...]:
    """The lines of a text file that are not blank, without spaces about them; raises InputError."""
    try:
        lines = read_text(path).decode().splitlines()
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8: {error}") from error
    return tuple(line.strip() for line in lines if line.strip())


@contextmanager
def opened_regular(path: Path, *, most: int = MAX_BYTES) -> Iterator[BinaryIO]:
    """A regular file of at most `most` bytes, open for reading.

    Raises:
        InputError: it is missing, cannot be read, is too large, or is no regular file: a folder, a device or a pipe,
            for which nobody is waited; names the file.
    """
    try:
        with open(_opened(path), "rb") as file:
            status = os.fstat(file.fileno())
            if not stat.S_ISREG(status.st_mode):
                raise InputError(f"{path}: cannot be read: it is {_kind(status.st_mode)}, not a file")
            if status.st_size > most:
                raise _too_large(path, most)
            yield file
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from error


def _opened(path: Path) -> int:
    try:
        return os.open(path, os.O_RDONLY | os.O_CLOEXEC | os.O_NONBLOCK)
    except ValueError as error:  # a name that no file can have, as with a NUL in it
        raise InputError(f"{str(path)!r}: cannot be read: {error}") from error


def _too_large(path: Path, most: int) -> InputError:
    return InputError(f"{path}: is larger than {most // 1_000_000} MB; at most that is read")


def _kind(mode: int) -> str:
    kinds = {stat.S_IFDIR: "a folder", stat.S_IFIFO: "a pipe", stat.S_IFSOCK: "a socket"}
    return kinds.get(stat.S_IFMT(mode), "a device")
