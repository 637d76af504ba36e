"""From English plurals back to their nouns: "shelves" is of "shelf", "mice" of "mouse"."""

from collections.abc import Iterator, Mapping

_IRREGULAR: Mapping[str, str] = {
    "men": "man",
    "women": "woman",
    "children": "child",
    "people": "person",
    "feet": "foot",
    "teeth": "tooth",
    "geese": "goose",
    "mice": "mouse",
    "lice": "louse",
    "oxen": "ox",
    "dice": "die",
    "pence": "penny",
    "cacti": "cactus",
    "fungi": "fungus",
    "foci": "focus",
    "radii": "radius",
    "alumni": "alumnus",
    "crises": "crisis",
    "axes": "axe",
    "bases": "base",
    "vases": "vase",
    "cases": "case",
    "purses": "purse",
    "cheeses": "cheese",
    "fridges": "fridge",
    "gateaux": "gateau",
    "bureaux": "bureau",
    "chateaux": "chateau",
    "media": "medium",
    "criteria": "criterion",
    "matrices": "matrix",
    "indices": "index",
    "sheep": "sheep",
    "fish": "fish",
    "aircraft": "aircraft",
    "series": "series",
}
_ENDINGS = (("ves", ("f", "fe", "ve")), ("ies", ("y", "ie")), ("es", ("e", "")), ("s", ("",)))
_NO_PLURAL = ("ss", "us", "is")
"""Endings in -s of nouns that are not plurals: "glass", "cactus", "tennis"."""


def singulars(word: str) -> Iterator[str]:
    """What `word` can be the plural of, the likeliest first; nothing where it does not look like a plural.

    Only a word list can tell which of them is a word: "shoes" gives "shoe" and "sho".
    """
    for plural, singular in _IRREGULAR.items():
        if word == plural or (len(word) > len(plural) + 1 and plural.endswith("men") and word.endswith(plural)):
            yield word[: len(word) - len(plural)] + singular
    if word.endswith(_NO_PLURAL) or len(word) < 3:
        return
    for ending, stems in _ENDINGS:
        if word.endswith(ending):
            yield from (word[: -len(ending)] + stem for stem in stems)
