"""A table of sizes of the user's own, for layouts whose sizes stand in the program that made them."""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from thinkblox.importing.document import Extent, plain, read_document
from thinkblox.value import Vec3

Sizes = Mapping[str, Vec3]
"""(Along the front, across, up) [m] by name."""


def read_sizes(path: Path) -> Sizes:
    """Read a JSON object that maps names to [x, y, z], along the front, across and up [m].

    Raises:
        InputError: it is no such table; names the file and the place in it.
    """
    document = read_document(path)
    table = document.typed(dict[str, Any])
    return {
        name: document.part(tuple[Extent, Extent, Extent], size, f"$.{plain(name)}") for name, size in table.items()
    }


def size_in(sizes: Sizes, *names: str) -> Vec3 | None:
    """The size of the first name that the table has, as it is or without the number at its end; None for none."""
    for name in names:
        for form in (name, re.sub(r"[-_ ]?\d{1,9}\Z", "", name)):
            if form in sizes:
                return sizes[form]
    return None
