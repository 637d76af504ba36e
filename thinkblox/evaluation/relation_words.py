"""The relations that are judged, and the words in which annotations name them."""

from typing import Literal

ObjectRule = Literal[
    "next_to",
    "near",
    "across_from",
    "far",
    "face_to",
    "left_of",
    "right_of",
    "front_of",
    "back_of",
    "long_side_of",
    "short_side_of",
    "on_top",
    "inside_of",
    "outside_of",
    "under",
    "above",
    "middle_of",
    "surround",
]
ElementRule = Literal[
    "on_wall",
    "against_wall",
    "corner_room",
    "hang_ceiling",
    "middle_room",
    "inside_room",
    "next_to",
    "near",
    "across_from",
    "far",
]
Element = Literal["wall", "door", "window", "floor", "ceiling", "corner", "room"]

_OBJECTS: dict[str, tuple[ObjectRule, ...]] = {
    "next_to": ("next_to",),
    "beside": ("next_to",),
    "adjacent_to": ("next_to",),
    "adjacent": ("next_to",),
    "by": ("next_to",),
    "at": ("next_to",),
    "between": ("next_to",),
    "side_by_side": ("next_to",),
    "attached_to": ("next_to",),
    "near": ("near",),
    "close_to": ("near",),
    "nearby": ("near",),
    "across_from": ("across_from",),
    "across": ("across_from",),
    "opposite": ("across_from",),
    "opposite_to": ("across_from",),
    "far": ("far",),
    "far_from": ("far",),
    "away_from": ("far",),
    "face_to": ("face_to",),
    "facing": ("face_to",),
    "face": ("face_to",),
    "left_of": ("left_of",),
    "left": ("left_of",),
    "to_the_left_of": ("left_of",),
    "right_of": ("right_of",),
    "right": ("right_of",),
    "to_the_right_of": ("right_of",),
    "front_of": ("front_of",),
    "in_front_of": ("front_of",),
    "front": ("front_of",),
    "at_the_foot_of": ("front_of", "next_to"),
    "at_foot_of": ("front_of", "next_to"),
    "foot_of": ("front_of", "next_to"),
    "back_of": ("back_of",),
    "behind": ("back_of",),
    "back": ("back_of",),
    "long_side_of": ("long_side_of",),
    "at_long_side_of": ("long_side_of",),
    "short_side_of": ("short_side_of",),
    "at_short_side_of": ("short_side_of",),
    "at_the_head_of": ("short_side_of",),
    "on_top": ("on_top",),
    "on_top_of": ("on_top",),
    "on": ("on_top",),
    "atop": ("on_top",),
    "inside_of": ("inside_of",),
    "inside": ("inside_of",),
    "in": ("inside_of",),
    "outside_of": ("outside_of",),
    "outside": ("outside_of",),
    "under": ("under",),
    "below": ("under",),
    "beneath": ("under",),
    "underneath": ("under",),
    "above": ("above",),
    "over": ("above",),
    "middle_of": ("middle_of",),
    "in_the_middle_of": ("middle_of",),
    "center_of": ("middle_of",),
    "centered_on": ("middle_of",),
    "surround": ("surround",),
    "surrounding": ("surround",),
    "around": ("surround",),
    "circle": ("surround",),
}
_ELEMENTS: dict[str, ElementRule] = {
    "on_wall": "on_wall",
    "on": "on_wall",
    "hang_on": "on_wall",
    "hanging_on": "on_wall",
    "mounted_on": "on_wall",
    "mounted": "on_wall",
    "against_wall": "against_wall",
    "against": "against_wall",
    "along": "against_wall",
    "corner_room": "corner_room",
    "corner_of_room": "corner_room",
    "corner": "corner_room",
    "in_corner": "corner_room",
    "corner_of": "corner_room",
    "hang_ceiling": "hang_ceiling",
    "hang_from_ceiling": "hang_ceiling",
    "hang": "hang_ceiling",
    "hang_from": "hang_ceiling",
    "hanging_from": "hang_ceiling",
    "middle_room": "middle_room",
    "middle_of_room": "middle_room",
    "middle": "middle_room",
    "middle_of": "middle_room",
    "center": "middle_room",
    "center_of": "middle_room",
    "inside_room": "inside_room",
    "inside": "inside_room",
    "in": "inside_room",
    "next_to": "next_to",
    "beside": "next_to",
    "by": "next_to",
    "under": "next_to",
    "below": "next_to",
    "in_front_of": "next_to",
    "front_of": "next_to",
    "adjacent_to": "next_to",
    "near": "near",
    "close_to": "near",
    "across_from": "across_from",
    "opposite": "across_from",
    "far": "far",
    "far_from": "far",
    "away_from": "far",
}
_PARTS: tuple[Element, ...] = ("wall", "door", "window", "floor", "ceiling", "corner")


def object_rules(relation: str) -> tuple[ObjectRule, ...]:
    """The rules that all have to hold for a relation between objects; none when the word means none of them."""
    return _OBJECTS.get(_joined(relation), ())


def element_rule(relation: str, part: str) -> ElementRule | None:
    """The rule for a relation to a part of the room, such as ("on", "ceiling"); None when the words mean none."""
    word = _joined(relation)
    if word == "on" and part == "ceiling":
        return "hang_ceiling"
    if part == "corner" and word in ("in", "at", "inside", "on"):
        return "corner_room"
    return _ELEMENTS.get(word)


def element(name: str) -> Element:
    """The part of the room that a name means, such as "wall" for "back wall"; a name of a room means the room."""
    words = _joined(name).split("_")
    return next((part for part in _PARTS if part in words or f"{part}s" in words), "room")


def _joined(text: str) -> str:
    return "_".join(text.lower().replace("-", " ").replace("_", " ").split())
