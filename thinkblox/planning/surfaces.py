"""What a room is finished with: by what the prompt says, the type of room, and the seed."""

import hashlib
from collections.abc import Iterator, Sequence
from typing import TypeVar

from msgspec.structs import replace

from thinkblox.brief import Brief, SurfaceRequest
from thinkblox.knowledge.surfaces import Palette, UsualFinish, blended, colour_from, finishes
from thinkblox.layings import Laying
from thinkblox.scene.room import Room
from thinkblox.scene.surfaces import Covering, Surfaces

T = TypeVar("T")
_FACING = (0.15, 0.4)
"""How much more walls in the west and in the north count for, which a camera in the south sees."""
_TILES: tuple[Laying, ...] = ("subway", "checker", "stone", "marble", "terrazzo")
"""What is tiles, said more closely."""
_SAID = {"floor": "the floor is", "walls": "the walls are", "wall": "one wall is"}
"""What a surface that is not as asked is called in a note."""
_LOW: tuple[Laying, ...] = ("panels", "tiles", "subway", "marble")
"""What also covers the lower part of walls alone."""


def with_surfaces(room: Room, brief: Brief, seed: int) -> Room:
    """The room with its finish; one that has a finish already keeps it. The same brief and seed give the same.

    Choices go through their lists in turn from seed to seed, beginning where the prompt says, so that no two seeds in a
    row, and seldom two prompts, give rooms that look alike.
    """
    if room.surfaces is not None:
        return room
    turns, usual = _Turns(brief.prompt, seed), _usual(brief)
    known = finishes()
    name = turns.pick("palette", usual.palettes or tuple(known.palettes))
    colours = known.palettes[name]
    floor, walls = (turns.covering(part, turns.pick(part, choices), colours) for part, choices in _parts(usual))
    accent, dado = turns.pick("accent", usual.accent or ("none",)), turns.pick("dado", usual.dado or ("none",))
    plain = walls.laying == "paint" and dado == "none"
    surfaces = Surfaces(
        palette=name,
        floor=floor,
        walls=walls,
        accent=turns.covering("accent", accent, colours) if accent != "none" and plain else None,
        accent_wall=longest_free_wall(room),
        dado=None if dado == "none" else turns.covering("dado", dado, colours),
        trim=colour_from(colours.trim),
        door=colour_from(colours.door),
        curtains=colour_from(colours.curtain) if usual.curtains and "curtain" not in brief.excluded else None,
    )
    for request in _shared_out(brief.surfaces):
        surfaces = _as_asked(surfaces, request, turns, colours)
    if surfaces.accent is None:
        surfaces = replace(surfaces, accent_wall=None)
    return replace(room, surfaces=surfaces)


def surface_notes(brief: Brief, room: Room) -> Iterator[str]:
    """A sentence for every surface that the brief asks for and the room, finished as it is, does not have."""
    for request in brief.surfaces:
        if room.surfaces is not None and not _is_so(room.surfaces, request):
            yield f"{_SAID[request.part]} not as asked: {request.phrase}"


def longest_free_wall(room: Room) -> int:
    """The wall that is the longest after its openings are taken off; those count for more that pictures look at."""
    free = [wall.length for wall in room.walls]
    for opening in room.openings:
        free[opening.wall] -= 0.6 * opening.width
    worth = [1.0 - _FACING[1] * wall.inward[1] + _FACING[0] * wall.inward[0] for wall in room.walls]
    return max(range(len(free)), key=lambda i: (round(free[i] * worth[i], 3), -i))


def _parts(usual: UsualFinish) -> tuple[tuple[str, tuple[Laying, ...]], tuple[str, tuple[Laying, ...]]]:
    return ("floor", usual.floor), ("walls", usual.walls)


def _usual(brief: Brief) -> UsualFinish:
    """What such a room is finished with, changed by the words for its style; what is wet keeps its tiles."""
    known = finishes()
    usual = known.of(brief.room_type) or known.rooms["room"]
    for word in brief.style:
        style = known.styles.get(word)
        if style is not None:
            rough = known.is_rough(brief.room_type)
            kept = {name: value for name in ("accent", "palettes") if (value := getattr(style, name))}
            if not rough:
                kept |= {name: value for name in ("floor", "walls", "dado") if (value := getattr(style, name))}
            usual = replace(usual, **kept)
    return usual


class _Turns:
    """Choices that follow from a prompt and a seed."""

    def __init__(self, prompt: str, seed: int) -> None:
        self._prompt, self._seed = prompt, seed

    def pick(self, what: str, choices: Sequence[T]) -> T:
        """One of the choices; the next seed takes the next one."""
        start = hashlib.sha256(f"{what} {self._prompt}".encode()).digest()
        return choices[(int.from_bytes(start[:6], "big") + self._seed) % len(choices)]

    def covering(self, part: str, laying: Laying, palette: Palette) -> Covering:
        """A laying in the colours of a palette, or in one of its own."""
        dress = finishes().layings[laying]
        member = "accent" if laying == "paint" and part in ("accent", "dado") else dress.of
        own = self.pick(f"{part} colour", dress.colours) if dress.colours else getattr(palette, member)
        second = self.pick(f"{part} second", dress.seconds) if dress.seconds else ""
        second = getattr(palette, dress.companion) if dress.companion else second
        colour = colour_from(own)
        other = blended(colour_from(second), colour, dress.blend) if second else None
        return Covering(laying=laying, colour=colour, second=other)


def _shared_out(requests: Sequence[SurfaceRequest]) -> list[tuple[str, SurfaceRequest]]:
    """Which request is for which of floor, walls, accent and dado.

    Of two that are made of all walls, panelling or tiles go below, and the other above; else the second has a wall of
    its own.
    """
    whole = [r for r in requests if r.part == "walls"]
    shared = [("floor" if r.part == "floor" else "accent", r) for r in requests if r.part != "walls"]
    for at, request in enumerate(whole):
        low = len(whole) > 1 and request.laying in _LOW and not all(r.laying in _LOW for r in whole)
        above = [r for r in whole[:at] if r.laying not in _LOW]
        shared.append(("dado" if low else "accent" if above else "walls", request))
    return sorted(shared, key=lambda pair: ("floor", "walls", "accent", "dado").index(pair[0]))


def _as_asked(surfaces: Surfaces, asked: tuple[str, SurfaceRequest], turns: _Turns, palette: Palette) -> Surfaces:
    """The surfaces with one request met."""
    part, request = asked
    laying = request.laying or (surfaces.floor.laying if part == "floor" else "paint")
    made = turns.covering(part, laying, palette)
    if request.colour is not None:
        made = replace(made, colour=request.colour)
    if request.second is not None:
        made = replace(made, second=request.second)
    if part == "walls":
        return replace(surfaces, walls=made, accent=None, dado=None)
    changed: dict[str, Covering] = {part: made}
    return replace(surfaces, **changed)


def _is_so(surfaces: Surfaces, request: SurfaceRequest) -> bool:
    candidates = {
        "floor": (surfaces.floor,),
        "walls": (surfaces.walls, surfaces.dado, surfaces.accent),
        "wall": (surfaces.accent, surfaces.walls),
    }[request.part]
    return any(covering is not None and _looks(covering, request) for covering in candidates)


def _looks(covering: Covering, request: SurfaceRequest) -> bool:
    more_closely = request.laying == "tiles" and covering.laying in _TILES
    laid = request.laying in (None, covering.laying) or more_closely
    return laid and request.colour in (None, covering.colour)
