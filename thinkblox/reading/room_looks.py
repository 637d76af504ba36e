"""What a look of the whole room asks of its floor and walls: "a blue room", "dark wood", "white marble"."""

from collections.abc import Sequence

from thinkblox.assets.palette import COLOURS
from thinkblox.brief import SurfaceRequest
from thinkblox.knowledge.surfaces import surface_words

_DARK, _DARK_WOOD = "charcoal", "walnut"
_BUILT_OF = ("brick",)
"""Materials that are seen on the walls rather than underfoot."""


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
    colour = words.colours.get(look) or COLOURS.get(look)
    return None if colour is None else SurfaceRequest(part="walls", colour=colour, phrase=phrase)
