"""Nothing of an order is passed over in silence: what its kind does nothing about is refused before it begins."""

from collections.abc import Mapping

from thinkblox.editing.orders import Order
from thinkblox.errors import InputError

_WHERE = ("things", "places", "closer", "apart", "facing")
_SHIFTED = (
    "centred",
    "backs",
    "abreast",
    "touching",
    "in_line",
    "company",
    "mutual",
    "together",
    "scatter",
    "direction",
    "level",
    "lengths",
    "seated",
    "there",
    "free",
)
_LOOKED = ("facing", "backs")
_TURNED = ("turn", "sense", "direction")
_MOVED = (*_WHERE, *_SHIFTED, "rest", "spared", "besides")
HEEDED: Mapping[str, tuple[str, ...]] = {
    "add": (*_WHERE, "there", "centred", "besides", "mutual", "abreast", "level", "in_line"),
    "ensure": (*_WHERE, "total"),
    "put": (*_MOVED, "turn", "sense"),
    "move": (*_MOVED, "away", "turn", "sense"),
    "turn": ("things", "places", *_LOOKED, *_TURNED, "company", "mutual", "across", "rest", "spared"),
    "replace": ("things", "instead", "abreast"),
    "remove": ("things", "places", "rest", "spared", "away", "company"),
    "swap": ("things", "split", "company"),
    "rearrange": ("mutual", "things", "places", "free", "into", "room", "rest", "spared"),
    "resite": ("things", "rest", "spared"),
    "make": ("things", "room", "ceiling", "lengths", "change", "times", "looks", "direction", "bears"),
    "free": ("things", "places", "free", "space", "room", "rest", "spared", "away", "lengths"),
    "clear": ("things", "places", "room", "rest", "spared", "away"),
    "keep": ("things", "places", "rest", "room", "spared", "total", "away"),
    "only": ("things", "places", "total", "spared"),
    "spread": ("things", "places", "spared"),
    "gap": ("things", "places", "lengths", "change", "space", "room"),
}  # fmt: skip
"""What each kind of order does something about, as fields of an Order."""
_WHOLE = ("clear", "rearrange", "gap", "free", "make", "only", "replace", "swap", "resite", "spread")
"""Orders that are not begun where a word of them means nothing."""
SAID = {
    "instead": "what comes in place of it", "places": "where", "closer": "closer or further away", "apart": "how far",
    "besides": "which places are excepted",
    "spared": "what is excepted", "company": "what goes along", "mutual": "how they stand to each other",
    "across": "what is between them", "level": "how high",
    "together": "closer together", "scatter": "further apart", "facing": "what it faces", "turn": "an angle",
    "sense": "which way round", "direction": "a direction", "lengths": "a length", "change": "another size",
    "room": "the room", "ceiling": "the ceiling", "into": "what it becomes", "free": "what stays free",
    "rest": "everything else", "away": "away", "seated": "in or out", "looks": "another look", "space": "a space",
    "centred": "the middle",
    "total": "how many there are to be", "split": "two groups", "times": "how many times", "there": "in its place",
    "backs": "what its back is to", "bears": "what is to be on it", "abreast": "side by side",
    "touching": "without a gap", "in_line": "in a row",
}  # fmt: skip
"""What a field says, in words."""


def _takes_any(order: Order) -> bool:
    """Whether words that are not understood may say which are taken away: "the chairs that don't fit"."""
    told = (phrase.noun.many or phrase.noun.kind == "pronoun" for phrase in order.things)
    return order.doing == "remove" and any(told)


def check_heeded(order: Order) -> None:
    """Refuse an order that says more than such an order does.

    Raises:
        InputError: it says something that would be passed over.
    """
    heeded = HEEDED[order.doing]
    over = [words for field, words in SAID.items() if getattr(order, field) and field not in heeded]
    if order.turn == 0.0:
        over.append("an angle of 0 degrees")
    if order.lost and (order.doing in _WHOLE or order.rest or _takes_any(order)):
        raise InputError(f"'{order.text}': '{', '.join(order.lost)}' is not understood, so that nothing was done")
    if over:
        raise InputError(
            f"'{order.text}' also says {', '.join(over)}, which is not followed together with it; say it as an order"
            " of its own"
        )
