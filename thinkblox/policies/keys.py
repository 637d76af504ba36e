"""The key of a server: from the environment alone, and never in what is shown or written."""

import os
from collections.abc import Mapping

from thinkblox.errors import UnavailableError
from thinkblox.plain_text import escaped

VARIABLES = ("THINKBLOX_API_KEY", "OPENAI_API_KEY")
"""Where a key is looked for; the first that is set counts."""
_HIDDEN = "(the key)"


def key_from(environment: Mapping[str, str] = os.environ) -> str:
    """The key; empty where there is none, as local servers need none.

    Raises:
        UnavailableError: what is set cannot be a key; names the variable.
    """
    name = next((name for name in VARIABLES if environment.get(name, "").strip()), None)
    if name is None:
        return ""
    key = environment[name].strip()
    if not key.isascii() or not key.isprintable() or " " in key:
        raise UnavailableError(f"{name} holds no key: a key is one line of ASCII characters without spaces")
    return key


def hidden(text: str, key: str) -> str:
    """A text without the key, should somebody have repeated it."""
    return text.replace(key, _HIDDEN) if key else text


def shown(text: str, key: str, *, most: int = 300) -> str:
    """What a server says, fit to be shown: in one line, not long, harmless, and without the key."""
    line = " ".join(escaped(hidden(text, key), keep="\n\r\t").split())
    return line if len(line) <= most else f"{line[:most]}..."
