"""Colours and materials that a prompt names, brought to what a generator made without them."""

from collections.abc import Callable, Collection, Iterable, Sequence
from functools import partial
from math import dist

from msgspec import structs

from thinkblox.assets.palette import (
    CLAY,
    COLOURS,
    LINEN,
    MARBLE,
    METALS,
    OAK,
    PALE_GLASS,
    PAPER,
    STEEL,
    STONES,
    WHITE_PLASTIC,
    WICKER,
    WOODS,
)
from thinkblox.assets.part import Finish
from thinkblox.scene.asset import Link, Material, Shape
from thinkblox.value import Vec3

SHARE = 0.2
"""Least share of the visible faces that shows a colour or a material."""
SAME_COLOUR = 0.16
"""Largest distance in sRGB between a colour and what goes by its name."""
MATERIALS: dict[str, frozenset[Material]] = {
    "wooden": frozenset({"wood"}),
    "metal": frozenset({"metal"}),
    "glass": frozenset({"glass"}),
    "leather": frozenset({"leather"}),
    "fabric": frozenset({"fabric"}),
    "upholstered": frozenset({"fabric", "leather"}),
    "stone": frozenset({"stone"}),
    "plastic": frozenset({"plastic"}),
    "ceramic": frozenset({"ceramic"}),
    "paper": frozenset({"paper"}),
}
"""What the words of materials are made of."""
_FINISHES: dict[str, Finish] = {
    "wooden": OAK,
    "metal": STEEL,
    "glass": Finish(PALE_GLASS.colour, "glass"),
    "leather": Finish((0.48, 0.29, 0.18), "leather"),
    "fabric": LINEN,
    "stone": MARBLE,
    "plastic": WHITE_PLASTIC,
    "ceramic": CLAY,
    "paper": PAPER,
    "wicker": WICKER,
    **WOODS,
    **METALS,
    **STONES,
}
TOPPED = {f"{word}-topped": word for word in _FINISHES}
"""Words for what has a top of a material, and the word for that: "marble-topped"."""
LOOKS = frozenset({*COLOURS, *MATERIALS, *_FINISHES, *TOPPED})
"""Words that say of which colour or material a thing is."""
_FRAME = 0.12
"""Least share of the visible faces that a frame has; less are handles and hinges."""
PLAINLY = 0.3
"""Share of the visible faces from which nobody would call a thing by another colour."""
_PALE, _SAME_PALE = 0.6, 0.1
"""Least channel of a pale colour, and the distance of what goes by its name: neither chrome nor birch is white."""
_COATED: tuple[Material, ...] = ("wood", "metal", "fabric", "leather", "plastic", "paper")
"""What is painted or dyed where the largest finish alone shows little of a colour."""
_SHADES: tuple[Material, ...] = ("light",)
"""What the shade of a lamp is of."""
_SLAB, _THICK = 0.2, 0.006
"""Least share of the largest shape's plan that a part of a top has, and how far below its highest one it ends [m]."""
_KEPT: frozenset[Material] = frozenset({"light", "screen", "leaf"})
"""What gives light, shows a picture or grows keeps its look."""
_DYED = ("leather", "fabric", "upholstered", "plastic", "ceramic", "wooden", "metal")
"""Words of materials that a colour beside them is the colour of, covers before frames: black leather."""
_COVERS: tuple[Material, ...] = ("wood", "fabric", "leather")
"""What is darkened before the rest."""
_DARK = "dark"
_OF_A_TONE = frozenset({*COLOURS, *WOODS, *METALS, *STONES} - {"wooden"})
"""Words with a tone of their own, which "dark" before them is about."""
DARKEST, _DARKENED = 0.45, 0.36
"""Below what brightness a thing is called dark, and how bright one is made that is not."""
MOSTLY = 0.5
"""Least share of a material that has the colour which is asked of it."""


def of_kind(word: str) -> tuple[str, ...]:
    """The general word for a kind of metal or stone, which is what generators heed: "metal" for "brass"."""
    return ("metal",) if word in METALS else ("stone",) if word in STONES else ()


def repainted(links: Sequence[Link], words: Iterable[str]) -> tuple[Link, ...]:
    """The links with the largest finish changed, where words ask for a colour or a material that nothing shows."""
    found = tuple(links)
    named = sorted(set(words))
    for word in named:
        finish = _FINISHES.get(word)
        if finish is None:
            continue
        if word in WOODS and not any(_FINISHES[other].material == "metal" for other in named if other in _FINISHES):
            found = _framed(found, finish)
        if word in METALS:
            found = _turned(found, "metal", finish)
        if not shows_finish(found, word):
            found = _dressed(found, finish.colour, finish.material)
    for word in named:
        if word in TOPPED:
            finish = _FINISHES[TOPPED[word]]
            found = _recoloured(found, top_of(found).__contains__, finish.colour, finish.material)
        if word in COLOURS:
            found = _coated(found, COLOURS[word])
    return _darkened(_dyed(found, named), named)


def _darkened(links: tuple[Link, ...], words: Collection[str]) -> tuple[Link, ...]:
    """The links in darker tones of their own where words ask for that and name neither colour nor kind of wood.

    Wood, cloth and leather come first, and all of it where they are too little.
    """
    if _DARK not in words or any(word in _OF_A_TONE for word in words):
        return links
    for first in (True, False):
        bright = brightness(links)
        if bright <= DARKEST:
            break
        chosen = partial(_is_darkened, first=first)
        links = tuple(structs.replace(link, shapes=_darker(link.shapes, chosen, _DARKENED / bright)) for link in links)
    return links


def _is_darkened(shape: Shape, *, first: bool) -> bool:
    return shape.material in _COVERS if first else shape.material not in _KEPT


def _darker(shapes: Iterable[Shape], chosen: Callable[[Shape], bool], share: float) -> tuple[Shape, ...]:
    def darker(shape: Shape) -> Shape:
        r, g, b = (c * share for c in shape.colour)
        return structs.replace(shape, colour=(r, g, b))

    return tuple(darker(shape) if chosen(shape) else shape for shape in shapes)


def brightness(links: Iterable[Link]) -> float:
    """Mean brightness of the faces of all shapes, 0 to 1."""
    shapes = [shape for link in links for shape in link.shapes]
    whole = sum(map(faces, shapes))
    return sum(faces(s) * (0.3 * s.colour[0] + 0.59 * s.colour[1] + 0.11 * s.colour[2]) for s in shapes) / whole


def _coated(links: tuple[Link, ...], colour: Vec3) -> tuple[Link, ...]:
    """The links with their largest finish in a colour, and the next largest too where that is little of the whole.

    A lamp that is mostly shade has that in the colour as well.
    """
    if _colour_share(links, colour) < SHARE:
        links = _dressed(links, colour, None)
    for coated in (_COATED, _SHADES):
        if not shows_colour(links, colour):
            links = _dressed(links, colour, None, of=coated, other_than=colour)
    return links


def dyed(words: Iterable[str]) -> tuple[str, str] | None:
    """The one colour among words and the material that it is the colour of; None where words do not say both."""
    named = set(words)
    colours = [word for word in named if word in COLOURS]
    material = next((word for word in _DYED if word in named), None)
    return (colours[0], material) if material is not None and len(colours) == 1 else None


def is_dyed(links: Iterable[Link], colour: str, material: str) -> bool:
    """Whether most of what is seen of a material has a colour."""
    made, meant = list(links), MATERIALS[material]
    near = share(made, lambda shape: shape.material in meant and dist(shape.colour, COLOURS[colour]) <= SAME_COLOUR)
    return near >= MOSTLY * share(made, lambda shape: shape.material in meant)


def _dyed(links: tuple[Link, ...], words: Iterable[str]) -> tuple[Link, ...]:
    """The links with a material in the colour that was asked of it, its largest finishes first."""
    pair = dyed(words)
    if pair is None:
        return links
    colour, material = COLOURS[pair[0]], MATERIALS[pair[1]]
    while not is_dyed(links, *pair):
        links = _dressed(links, colour, None, of=material, other_than=colour)
    return links


def _framed(links: Sequence[Link], wood: Finish) -> tuple[Link, ...]:
    """The links with legs and frames of wood, where they are of metal: a wooden stool has no legs of chrome."""
    metal = share(links, lambda shape: shape.material == "metal")
    return _turned(links, "metal", wood) if metal >= _FRAME else tuple(links)


def _turned(links: Sequence[Link], material: Material, finish: Finish) -> tuple[Link, ...]:
    """The links with all shapes of one material in another finish."""
    return _recoloured(links, lambda shape: shape.material == material, finish.colour, finish.material)


def _recoloured(
    links: Sequence[Link], chosen: Callable[[Shape], bool], colour: Vec3, material: Material | None
) -> tuple[Link, ...]:
    """The links with another colour, and material, for the chosen shapes."""

    def recoloured(shape: Shape) -> Shape:
        if not chosen(shape):
            return shape
        return structs.replace(shape, colour=colour, material=material or shape.material)

    return tuple(structs.replace(link, shapes=tuple(map(recoloured, link.shapes))) for link in links)


def shows_colour(links: Iterable[Link], colour: Vec3) -> bool:
    """Whether enough of what is seen has about that colour for it to be called so."""
    return _colour_share(links, colour) >= PLAINLY


def _colour_share(links: Iterable[Link], colour: Vec3) -> float:
    return share(links, lambda shape: _has_colour(shape, colour))


def _has_colour(shape: Shape, colour: Vec3) -> bool:
    """Whether a shape goes by the name of a colour; a shade does only where it was made in that, as it glows."""
    near = 0.0 if shape.material in _SHADES else _SAME_PALE if min(colour) > _PALE else SAME_COLOUR
    return dist(shape.colour, colour) <= near


def shows_finish(links: Iterable[Link], word: str) -> bool:
    """Whether enough of what is seen is of the material that a word means; its kind is told by its colour."""
    made = list(links)
    if word in MATERIALS:
        return share(made, lambda shape: shape.material in MATERIALS[word]) >= SHARE
    finish = _FINISHES[word]
    if word in WOODS or word == "wicker":
        return _colour_share(made, finish.colour) >= SHARE
    near = share(
        made, lambda shape: shape.material == finish.material and dist(shape.colour, finish.colour) <= SAME_COLOUR
    )
    return near >= SHARE


def shows_top(links: Iterable[Link], word: str) -> bool:
    """Whether what a thing has on top is of the material that "marble-topped" names."""
    finish = _FINISHES[TOPPED[word]]
    top = top_of(links)
    return bool(top) and all((s.material, s.colour) == (finish.material, finish.colour) for s in top)


def top_of(links: Iterable[Link]) -> tuple[Shape, ...]:
    """The flat shapes that make up the upper side of a table, a counter or a chest; none where it has no such side."""
    shapes = [shape for link in links for shape in link.shapes if shape.collide]
    whole = max((shape.size[0] * shape.size[1] for shape in shapes), default=0.0)
    height = max((_top(shape) for shape in shapes), default=0.0)
    wide = (s for s in shapes if s.kind in ("box", "cylinder", "hull") and s.size[0] * s.size[1] > _SLAB * whole)
    return tuple(shape for shape in wide if _top(shape) > height - _THICK)


def _top(shape: Shape) -> float:
    return shape.position[2] + shape.size[2] / 2


def share(links: Iterable[Link], shows: Callable[[Shape], bool]) -> float:
    """Share of the faces of all shapes, seen as boxes, that belong to shapes of a kind."""
    shapes = [shape for link in links for shape in link.shapes]
    whole = sum(map(faces, shapes))
    return sum(faces(shape) for shape in shapes if shows(shape)) / whole if whole else 0.0


def faces(shape: Shape) -> float:
    """Area of three faces of the box around a shape [m2]."""
    x, y, z = shape.size
    return x * y + y * z + z * x


def _dressed(
    links: Sequence[Link],
    colour: Vec3,
    material: Material | None,
    *,
    of: Collection[Material] = (),
    other_than: Vec3 | None = None,
) -> tuple[Link, ...]:
    """The links with another colour, and material, for all shapes that have the finish with the largest faces.

    Of some materials alone, and of finishes of another colour than one, where these are given.
    """
    areas: dict[tuple[Vec3, Material], float] = {}
    for shape in (shape for link in links for shape in link.shapes):
        meant = (not of or shape.material in of) and (other_than is None or not _has_colour(shape, other_than))
        if (shape.material not in _KEPT or shape.material in of) and meant:
            key = (shape.colour, shape.material)
            areas[key] = areas.get(key, 0.0) + faces(shape)
    if not areas:
        return tuple(links)
    largest = max(areas, key=lambda key: areas[key])
    return _recoloured(links, lambda shape: (shape.colour, shape.material) == largest, colour, material)
