"""Which generator wrote a file, told by keys that only its format has."""

from typing import Any

from thinkblox.errors import InputError
from thinkblox.importing.document import plain
from thinkblox.importing.formats import FORMATS
from thinkblox.importing.holodeck import is_holodeck
from thinkblox.importing.idesign import is_idesign
from thinkblox.importing.il3d import is_il3d
from thinkblox.importing.layoutgpt import is_layoutgpt
from thinkblox.importing.layoutvlm import is_layoutvlm
from thinkblox.importing.sceneeval import is_sceneeval

_SIGNATURES = {
    "holodeck": is_holodeck,
    "idesign": is_idesign,
    "il3d": is_il3d,
    "layoutgpt": is_layoutgpt,
    "layoutvlm": is_layoutvlm,
    "sceneeval": is_sceneeval,
}

SHOWN, SHORT = 6, 30
"""How many keys of a file that nobody reads are told, and how much of each."""


def detect(document: Any) -> str:
    """The format of a JSON value.

    Raises:
        InputError: it has the keys of no format that is read, or of several.
    """
    found = [name for name, signature in _SIGNATURES.items() if signature(document)]
    if len(found) == 1:
        return found[0]
    what = (
        f"has the keys of {' and '.join(found)}"
        if found
        else f"has the keys of no layout that is read{_keys(document)}"
    )
    choices = ", ".join(found or FORMATS)
    raise InputError(f"{what}; say which it is with --format, one of {choices}")


def _keys(document: Any) -> str:
    """The keys that a value has, as an insertion; nothing where it has none."""
    first = document[0] if isinstance(document, list) and document else document
    if not isinstance(first, dict) or not first:
        return ""
    names = [repr(plain(key)[:SHORT]) for key in first]
    return f" ({', '.join(names[:SHOWN])}{', ...' if len(names) > SHOWN else ''})"
