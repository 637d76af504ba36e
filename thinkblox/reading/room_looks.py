"""What a look of the whole room asks of floor, walls and furniture: "a blue room", "dark wood", "red leather"."""

from collections.abc import Sequence
from dataclasses import dataclass

from msgspec.structs import replace

from thinkblox.assets.palette import COLOURS, METALS, WOODS
from thinkblox.brief import Look, SurfaceRequest
from thinkblox.knowledge.surfaces import surface_words
from thinkblox.layings import Colour

_DARK, _DARK_WOOD = "charcoal", "walnut"
_BUILT_OF = ("brick",)
"""Materials that are seen on the walls rather than underfoot."""
_COVERS = ("leather", "fabric")
"""Materials that what one sits on is covered with."""


@dataclass(frozen=True)
class RoomFinish:
    """What the looks of a room ask for: of its surfaces, of its furniture, and what neither can have."""

    surfaces: tuple[SurfaceRequest, ...]
    furniture: tuple[Look, ...]
    unmet: tuple[str, ...]


def finish_of_room(looks: Sequence[str], tones: Sequence[Look]) -> RoomFinish:
    """What all the looks of a room ask for.

    Args:
        looks: everything that is said of it, in the words of attributes.
        tones: those of them that are said by themselves, which are said of the furniture too: "all pastel pink".
    """
    furniture = [worn for tone in tones if (worn := _worn(tone))]
    if "dark" in looks and not any("dark" in tone for tone in tones):
        furniture.append((_DARK_WOOD,))
    kept = {word for tone in tones if not set(tone).isdisjoint((*_COVERS, "metal", *METALS)) for word in tone}
    rest = [look for look in looks if look not in kept]
    found = {look: _in_its_colour(request, look, tones) for look in rest if (request := surface_of_room(look, rest))}
    own = {word for tone in tones if any(_is_stone(word) for word in tone) for word in tone if word in COLOURS}
    surfaces = tuple(request for look, request in found.items() if look not in own)
    shown = {word for look in furniture for word in look}
    unmet = tuple(look for look in looks if look not in found and look not in shown)
    return RoomFinish(surfaces, tuple(dict.fromkeys(furniture)), unmet)


def _worn(tone: Look) -> Look:
    """The words of a tone that furniture shows: a wood that is said more closely, a metal, a cover, or mere colours."""
    wood = [word for word in tone if word in WOODS and word != "wooden"]
    if "dark" in tone or wood:
        return (wood[0] if wood else _DARK_WOOD,)
    plain = [word for word in tone if word in COLOURS or word in _COVERS or word == "metal" or word in METALS]
    return tuple(plain) if len(plain) == len(tone) else ()


def _is_stone(word: str) -> bool:
    return word not in COLOURS and surface_words().layings("floor").get(word) not in (None, "planks")


def _in_its_colour(request: SurfaceRequest, look: str, tones: Sequence[Look]) -> SurfaceRequest:
    """A floor of stone in the colour that is said with it: "white marble"."""
    words = [word for tone in tones if look in tone and _is_stone(look) for word in tone]
    colour = next((c for word in words if (c := _colour(word)) is not None), None)
    return request if colour is None else replace(request, colour=colour)


def _colour(word: str) -> Colour | None:
    return surface_words().colours.get(word) or COLOURS.get(word)


def surface_of_room(look: str, looks: Sequence[str]) -> SurfaceRequest | None:
    """What one of the looks of a room asks of its floor or walls; None for one that asks for neither.

    Colours are those of the walls. Materials are those of the floor, and brick that of the walls. "Dark" is the shade
    of a wood among the looks, else of the walls.
    """
    words, phrase = surface_words(), f"{look} room"
    floor = words.layings("floor")
    wooden = [other for other in looks if other == "wooden" or other in words.woods]
    if look == "dark" and not wooden:
        return SurfaceRequest(part="walls", colour=words.colours[_DARK], phrase=phrase)
    if look in _BUILT_OF:
        return SurfaceRequest(part="walls", laying=words.layings("walls")[look], phrase=phrase)
    if look == "dark" or look in wooden:
        wood = look if look in words.woods else _DARK_WOOD if "dark" in looks else ""
        return SurfaceRequest(
            part="floor", laying="planks", colour=words.colours[wood] if wood else None, phrase=phrase
        )
    if look in floor:
        return SurfaceRequest(part="floor", laying=floor[look], phrase=phrase)
    colour = _colour(look)
    return None if colour is None else SurfaceRequest(part="walls", colour=colour, phrase=phrase)
