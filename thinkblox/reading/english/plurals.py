"""English nouns, plural to singular."""

_IRREGULAR = {
    "men": "man", "women": "woman", "children": "child", "feet": "foot", "teeth": "tooth", "geese": "goose",
    "mice": "mouse", "knives": "knife", "shelves": "shelf", "loaves": "loaf", "leaves": "leaf", "wolves": "wolf",
    "calves": "calf", "halves": "half", "scarves": "scarf", "wives": "wife", "lives": "life", "thieves": "thief",
    "people": "person", "dice": "die", "axes": "axe", "cacti": "cactus", "fungi": "fungus", "oxen": "ox",
    "chassis": "chassis", "series": "series", "species": "species", "shoes": "shoe", "canoes": "canoe",
    "horseshoes": "horseshoe", "toes": "toe", "hoes": "hoe", "movies": "movie", "cookies": "cookie", "ties": "tie",
    "pies": "pie", "selfies": "selfie", "zombies": "zombie", "brownies": "brownie", "smoothies": "smoothie",
    "gas": "gas", "bus": "bus", "lens": "lens", "canvas": "canvas", "atlas": "atlas", "iris": "iris", "trellis": "trellis",
    "thermos": "thermos", "chaos": "chaos", "rhinoceros": "rhinoceros", "albatross": "albatross",
    "cactus": "cactus", "christmas": "christmas", "glasses": "glass", "vases": "vase", "cases": "case",
    "bookcases": "bookcase", "suitcases": "suitcase", "briefcases": "briefcase", "bases": "base", "horses": "horse",
    "houses": "house", "dollhouses": "dollhouse", "purses": "purse", "hoses": "hose", "roses": "rose", "noses": "nose",
    "fuses": "fuse", "blouses": "blouse", "cheeses": "cheese", "causes": "cause", "corpses": "corpse",
    "scissors": "scissors", "pliers": "pliers", "binoculars": "binoculars", "trousers": "trousers", "jeans": "jeans",
    "headphones": "headphones", "goggles": "goggles", "tongs": "tongs", "tweezers": "tweezers", "pyjamas": "pyjamas",
    "stairs": "stairs", "bellows": "bellows", "news": "news", "bongos": "bongo", "maracas": "maraca", "dominoes": "domino",
}  # fmt: skip


def singular(word: str) -> str:
    """The singular of a lower-case noun; the word itself where it has no plural ending."""
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    if len(word) < 4 or not word.endswith("s") or word.endswith(("ss", "us", "is")):
        return word
    if word.endswith("ies"):
        return word[:-3] + "y"
    if word.endswith(("ches", "shes", "sses", "xes", "zes", "oes")):
        return word[:-2]
    return word[:-1]


PAIRS = (
    "scissors", "pliers", "binoculars", "trousers", "jeans", "headphones", "goggles", "tongs", "tweezers", "pyjamas",
    "shears", "spectacles", "earphones", "shorts", "tights", "secateurs", "clippers",
)  # fmt: skip
"""Nouns of which a pair is one."""
