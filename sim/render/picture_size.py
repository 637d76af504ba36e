"""How large a picture may be asked for."""

from thinkblox.errors import InputError

SMALLEST, LARGEST = 16, 8192
"""Pixels along a side of a picture."""


def check_picture_size(size: object) -> int:
    """The size of a picture [pixels].

    Raises:
        InputError: it is no whole number, or nothing that is drawn.
    """
    if type(size) is not int or not SMALLEST <= size <= LARGEST:
        raise InputError(
            f"the size of a picture is {size!r}; it must be a whole number from {SMALLEST} to {LARGEST} [pixels]"
        )
    return size


def check_picture_count(count: object, most: int, what: str) -> int:
    """How many pictures, or columns of them.

    Raises:
        InputError: it is no whole number from 1 to `most`.
    """
    if type(count) is not int or not 1 <= count <= most:
        raise InputError(f"{what} is {count!r}; it must be a whole number from 1 to {most}")
    return count
