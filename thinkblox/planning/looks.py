"""What is said of a room's furniture as a whole: "dark wood", "chrome and red leather", "pastel pink"."""

from msgspec.structs import replace

from thinkblox.assets import facts_of
from thinkblox.assets.make import make_thing
from thinkblox.assets.palette import COLOURS, METALS, WOODS
from thinkblox.assets.repaint import LOOKS, share
from thinkblox.brief import Brief, Look, Request
from thinkblox.scene.asset import Material

_LEAST: dict[Material, float] = {"wood": 0.3, "metal": 0.1}
"""From this share of its faces on a thing is one of wood, or one with legs or a frame of metal."""
_SAT_ON = ("seats", "lounges", "seating", "treated_on")
"""Groups of what has a cover."""
_COLOURED = (*_SAT_ON, "covers", "counters")
"""Groups of what a colour is seen on that is said of a whole room; beds and cupboards keep their own."""


def with_looks(brief: Brief) -> Brief:
    """The brief with the looks of its furniture said of what it only assumes and has something to show them on.

    A wood and a metal go to all that have wood or metal; of several covers or colours each goes to some.
    """
    framed = [look for look in brief.looks if _framing(look)]
    covers = [look for look in brief.looks if not _framing(look)]
    requests: list[Request] = []
    for request in brief.requests:
        mine = [look for look in framed if _has(request.category, _framing(look))]
        fitting = [look for look in covers if facts_of(request.category).is_in(*_groups(look))]
        mine += fitting[len(requests) % len(fitting) :][:1] if fitting else []
        free = not request.asked and LOOKS.isdisjoint(request.attributes)
        words = [word for look in mine if free for word in look]
        requests.append(replace(request, attributes=tuple(dict.fromkeys((*request.attributes, *words)))))
    return replace(brief, requests=tuple(requests))


def _framing(look: Look) -> Material | None:
    """The material of frames and tops that a look is of; None for covers and colours."""
    kinds: tuple[tuple[Material, frozenset[str]], ...] = (
        ("wood", frozenset(WOODS)),
        ("metal", frozenset({"metal", *METALS})),
    )
    return next((material for material, words in kinds if not words.isdisjoint(look)), None)


def _groups(look: Look) -> tuple[str, ...]:
    return _COLOURED if all(word in COLOURS for word in look) else _SAT_ON


def _has(category: str, material: Material | None) -> bool:
    made = make_thing(category, seed=0)
    return material is not None and share(made.links, lambda s: s.material == material) >= _LEAST[material]
