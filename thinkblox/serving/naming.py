"""Names that an answer can say: the ids of other generators' objects are of any form."""

import re

from msgspec import structs

from thinkblox.scene.scene import Scene

_SAYABLE = re.compile(r"[a-z][a-z0-9_]*_[0-9]{1,9}")
_LONGEST = 80
_NUMBER = re.compile(r"(.*?)_?([0-9]{1,9})")


def sayable(scene: Scene) -> tuple[Scene, dict[str, str]]:
    """The scene with every object called as `steps.ObjectId` wants it, and the old ids of those that were not."""
    room = scene.room
    taken = {"floor", "ceiling", *(wall.name for wall in room.walls), *(opening.id for opening in room.openings)}
    taken |= {p.id for p in scene.placements if _can_be_said(p.id)}
    old: dict[str, str] = {}
    for placement in scene.placements:
        if not _can_be_said(placement.id):
            id = _name(placement.id, taken)
            taken.add(id)
            old[id] = placement.id
    new = {before: id for id, before in old.items()}
    renamed = tuple(structs.replace(p, id=new.get(p.id, p.id)) for p in scene.placements)
    return (structs.replace(scene, placements=renamed) if old else scene), old


def _can_be_said(id: str) -> bool:
    return len(id) <= _LONGEST and _SAYABLE.fullmatch(id) is not None


def _name(id: str, taken: set[str]) -> str:
    """The nearest name to an id that can be said and is free: "chair-0" is "chair_0", and "bed" is "bed_1"."""
    plain = re.sub(r"[^a-z0-9]+", "_", id.lower()).strip("_")
    match = _NUMBER.fullmatch(plain)
    stem, number = (match[1], int(match[2])) if match else (plain, 1)
    stem = stem[: _LONGEST - 12].strip("_")
    while f"{stem}_{number}" in taken:
        number += 1
    return f"{stem}_{number}"
