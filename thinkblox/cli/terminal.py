"""What a command prints: nothing in it, whatever file it comes from, steers the terminal."""

import re
import sys

from thinkblox.plain_text import escaped, is_harmful

_UNESCAPED = re.compile("[^\\x00-\\x7e]|\\x7f")
"""What JSON may hold unescaped beside plain ASCII."""


def say(text: str) -> None:
    """Print a text of several lines."""
    print(escaped(text, keep="\n"))


def complain(text: str) -> None:
    """Print an error on one line."""
    print(f"thinkblox: {escaped(text)}", file=sys.stderr)


def write_json(data: bytes) -> None:
    """Print JSON; what would steer a terminal stands in it as an escape of JSON, which means the same."""
    sys.stdout.write(_UNESCAPED.sub(lambda found: _json_escape(found[0]), data.decode()))


def _json_escape(character: str) -> str:
    return f"\\u{ord(character):04x}" if is_harmful(character) else character
