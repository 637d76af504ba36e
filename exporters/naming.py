"""Names that MuJoCo, dm_control, ROS and USD all take: a letter, then letters, digits and underscores."""

import re
import unicodedata
from collections.abc import Iterable

LONGEST = 100
_OTHER = re.compile(r"[^A-Za-z0-9]+")


def safe_name(name: str) -> str:
    """The name without what some reader refuses: accents are dropped, and runs of other characters are one "_"."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    # A name that is safe keeps its underscores, also several in a row.
    safe = plain if is_safe(plain) else _OTHER.sub("_", plain).strip("_")
    if not safe[:1].isalpha():
        safe = f"n_{safe}".rstrip("_")
    return safe[:LONGEST]


def is_safe(name: str) -> bool:
    """Whether every reader takes the name as it is."""
    return bool(re.fullmatch(rf"[A-Za-z][A-Za-z0-9_]{{0,{LONGEST - 1}}}", name))


class Names:
    """Safe names, no two of which differ in case alone.

    Args:
        taken: names that are not given.
    """

    def __init__(self, taken: Iterable[str] = ()) -> None:
        self._taken = {name.casefold() for name in taken}

    def give(self, wanted: str) -> str:
        """The safe form of a name, with a number where that is taken."""
        safe = candidate = safe_name(wanted)
        number = 1
        while candidate.casefold() in self._taken:
            number += 1
            candidate = f"{safe[: LONGEST - 8]}_{number}"
        self._taken.add(candidate.casefold())
        return candidate

    def give_all(self, wanted: Iterable[str]) -> dict[str, str]:
        """Safe names of several that differ, by these; those that are safe already come first and stay."""
        every = list(wanted)
        given = {name: self.give(name) for name in every if is_safe(name)}
        return {name: given.get(name) or self.give(name) for name in every}
