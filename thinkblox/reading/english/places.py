"""What prepositions mean with corners, openings and walls."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Meaning

_AT_WALL = ("against", "along", "at", "by", "next_to", "near", "around", "in", "to", "from", "under", "above")
_CORNERED = ("in", "at", "on", "to", "by", "near", "next_to", "against", "along", "between")


WALLS = {
    "left": "left_wall", "right": "right_wall", "north": "north_wall", "south": "south_wall", "east": "east_wall",
    "west": "west_wall", "back": "far_wall", "rear": "far_wall", "far": "far_wall", "front": "near_wall",
}  # fmt: skip
"""Walls by the word that tells which."""


_OPPOSITE = ("opposite", "other side", "other end", "facing wall", "other wall")
"""What is said of the wall across from one that was named."""


def begins_two_walls(word: str) -> bool:
    """Whether a word can be the first of what `two_walls_at` reads."""
    return word in ("the", "both") or word in WALLS


def two_walls_at(words: Sequence[str]) -> tuple[str, int]:
    """The walls that "the left and right walls" are, and how many words that takes; "" and 0 where it is not that."""
    if list(words[:2]) == ["the", "walls"] and list(words[3:6]) in (["the", "left", "and"], ["the", "right", "and"]):
        length = 8 if list(words[6:7]) == ["the"] else 7
        return ("left_wall right_wall", length) if words[2] in ("to", "on", "at") else ("", 0)
    start = 1 if words[:1] in (["the"], ["both"]) else 0
    said = list(words[start : start + 4])
    if len(said) < 4 or said[1] != "and" or said[3] not in ("wall", "walls") or not {said[0], said[2]} <= WALLS.keys():
        return "", 0
    return f"{WALLS[said[0]]} {WALLS[said[2]]}", start + 4


def corner(word: str, said: Noun, walls: list[str], several: int) -> Meaning | None:
    """What stands so to one corner or several; `walls` are those that meet there."""
    if word == "far":
        return Meaning("far", ("corner",))
    if word not in _CORNERED:
        return None
    each = said.each or said.det in ("both", "all")
    all_of_them = 2 if said.det == "both" or len(walls) == 1 else 4
    times = several or (all_of_them if each else 1)
    opposite = "opposite" in said.text.lower() and said.plural
    spread = times if (each or several or opposite) else 0
    if opposite and not several:
        spread = 2
    return Meaning("in_corner", tuple(walls) or ("corner",), times=times if each else 1, spread=spread)


def opening(word: str, name: str, several: int = 0) -> Meaning | None:
    """What stands so to a window or door, or to each of `several`."""
    kind = word if word in ("under", "in_front_of") and name == "window" else _at_opening(word)
    meaning = Meaning(kind, (name,), times=max(several, 1), spread=several, loose=word == "between")
    return meaning if kind else None


def _at_opening(word: str) -> str:
    match word:
        case "near" | "far" | "facing" | "facing_away" | "opposite" | "left_of" | "right_of" | "above" | "outside":
            return word
        case "by" | "next_to" | "at" | "under" | "in_front_of" | "against" | "on" | "along" | "to" | "in":
            return "next_to"
        case "between" | "behind":
            return "near"
    return ""


def wall(word: str, said: Noun, name: str, several: int, *, each: bool) -> Meaning | None:
    """What stands so to one wall or several."""
    text = said.text.lower()
    if name == "wall":
        if "opposite walls" in text or "facing walls" in text:
            several = several or 2
        elif any(words in text for words in _OPPOSITE):
            name = "opposite_wall"
        elif (said.count == 1 and text.startswith("one")) or "same" in text.split():
            name = "one_wall"
    if word in ("facing", "facing_away", "opposite", "far"):
        return Meaning(word, (name,), times=several or 2 if each else 1, loose=each or "opposite walls" in text)
    times = several or (4 if name == "wall" and "side" not in text else 2) if each else 1
    if each and name in ("left_wall", "right_wall"):
        name, times = "wall", 2
    spread = (several or times) if (each or several) else int(word == "along" and not said.plural)
    if said.det == "both":
        spread = 2
    if "all" in text.split() or ("four walls" in text and not said.total):
        spread = 4
    kind = "on" if word in ("on", "on_top") else "against_wall" if word in _AT_WALL or word == "in_front_of" else ""
    return Meaning(kind, (name,), times=times, spread=spread) if kind else None
