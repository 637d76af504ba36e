"""A call of a tool by its name: whatever comes in, an answer that an agent can act on goes out."""

import traceback
from collections.abc import Mapping
from typing import Any, NamedTuple

import msgspec

from thinkblox.errors import ThinkBloxError
from thinkblox.plain_text import escaped
from thinkblox.serving.desk import Desk
from thinkblox.serving.said import Said
from thinkblox.serving.tool import called_with
from thinkblox.serving.tools import TOOLS

MOST_SAID = 4000
"""Longest error that is told [characters]."""


class Answered(NamedTuple):
    """What came of a call, and whether it was done at all."""

    said: Said
    done: bool


def call(desk: Desk, name: str, arguments: Mapping[str, Any] | None) -> Answered:
    """Call a tool; never raises, but for what ends the process."""
    if name not in TOOLS:
        return _refused(f"there is no tool {name[:80]!r}; there are {', '.join(TOOLS)}")
    try:
        msgspec.json.encode(arguments)
        return Answered(called_with(TOOLS[name], arguments or {}).run(desk), True)
    except UnicodeEncodeError:
        return _refused(f"{name}: a text in it is not valid: it holds halves of characters (surrogates)")
    except ThinkBloxError as error:
        return _refused(str(error).replace(f"{desk.root.folder}/", ""))
    except Exception as error:
        traceback.print_exception(error)  # to stderr, for whoever runs the server
        why = f"{type(error).__name__}: {error}"
        return _refused(
            f"{name}: this is a fault of ours ({why}); the room is as it was before, go on without this call"
        )


def _refused(why: str) -> Answered:
    text = escaped(why, keep="\n")
    return Answered(Said((text if len(text) <= MOST_SAID else f"{text[:MOST_SAID]}...",)), False)
