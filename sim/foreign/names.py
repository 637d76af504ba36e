"""Lists of names in a sentence, however long they are."""

from collections.abc import Sequence

SHOWN = 3


def listed(names: Sequence[str], *, shown: int = SHOWN) -> str:
    """A few of the names and how many more there are: "a, b, c and 197 more"."""
    if len(names) <= shown:
        return ", ".join(names)
    return f"{', '.join(names[:shown])} and {len(names) - shown} more"
