"""From English plurals back to their nouns: "shelves" is of "shelf", "mice" of "mouse"."""

from collections.abc import Iterator, Mapping
from functools import lru_cache

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
    "menus": "menu",
    "media": "medium",
    "criteria": "criterion",
    "matrices": "matrix",
    "indices": "index",
    "sheep": "sheep",
    "fish": "fish",
    "aircraft": "aircraft",
    "series": "series",
    "knives": "knife",
    "shelves": "shelf",
    "loaves": "loaf",
    "leaves": "leaf",
    "wolves": "wolf",
    "calves": "calf",
    "halves": "half",
    "scarves": "scarf",
    "wives": "wife",
    "lives": "life",
    "thieves": "thief",
    "chassis": "chassis",
    "species": "species",
    "shoes": "shoe",
    "canoes": "canoe",
    "horseshoes": "horseshoe",
    "toes": "toe",
    "hoes": "hoe",
    "movies": "movie",
    "cookies": "cookie",
    "ties": "tie",
    "pies": "pie",
    "selfies": "selfie",
    "zombies": "zombie",
    "brownies": "brownie",
    "smoothies": "smoothie",
    "glasses": "glass",
    "bookcases": "bookcase",
    "suitcases": "suitcase",
    "briefcases": "briefcase",
    "horses": "horse",
    "houses": "house",
    "dollhouses": "dollhouse",
    "hoses": "hose",
    "roses": "rose",
    "noses": "nose",
    "fuses": "fuse",
    "blouses": "blouse",
    "causes": "cause",
    "corpses": "corpse",
    "bongos": "bongo",
    "maracas": "maraca",
    "dominoes": "domino",
}
_INNER = ("shelves", "knives", "loaves")
"""Irregular plurals that words are made with: "bookshelves"."""
_SINGULAR = frozenset(
    (
        "gas bus lens canvas atlas iris trellis thermos chaos rhinoceros albatross cactus christmas scissors "
        "pliers binoculars trousers jeans headphones goggles tongs tweezers pyjamas stairs bellows news"
    ).split()
)
"""Nouns that only look like plurals, or have no other form."""
_ENDINGS = (("ves", ("f", "fe", "ve")), ("ies", ("y", "ie")), ("es", ("e", "")), ("s", ("",)))
_NO_PLURAL = ("ss", "us", "is")
"""Endings in -s of nouns that are not plurals: "glass", "cactus", "tennis"."""


def singulars(word: str) -> Iterator[str]:
    """What `word` can be the plural of, the likeliest first; nothing where it does not look like a plural.

    Only a word list can tell which of them is a word: "shoes" gives "shoe" and "sho".
    """
    if word in _IRREGULAR:
        yield _IRREGULAR[word]
    elif word.endswith("men") and len(word) > len("men") + 1:
        yield f"{word.removesuffix('men')}man"
    elif word.endswith(_INNER):
        yield singular(word)
    if word.endswith(_NO_PLURAL) or len(word) < 3:
        return
    for ending, stems in _ENDINGS:
        if word.endswith(ending):
            yield from (word[: -len(ending)] + stem for stem in stems)


@lru_cache(maxsize=4096)
def singular(word: str) -> str:
    """The likeliest singular of a lower-case noun by its spelling; the word itself where it has no plural ending."""
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    if word.endswith(_INNER):
        many = next(ending for ending in _INNER if word.endswith(ending))
        return word.removesuffix(many) + _IRREGULAR[many]
    if word in _SINGULAR or len(word) < 4 or not word.endswith("s") or word.endswith(_NO_PLURAL):
        return word
    if word.endswith("es") and word[:-2] in _SINGULAR:
        return word[:-2]
    if word.endswith("ies"):
        return word[:-3] + "y"
    if word.endswith(("ches", "shes", "sses", "xes", "zes", "oes")):
        return word[:-2]
    return word[:-1]
