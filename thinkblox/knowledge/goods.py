"""What a shop sells, by the word before it: cameras in a camera shop."""

import tomllib
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import msgspec

from thinkblox.assets.plurals import singular
from thinkblox.assets.stand_ins import kind_of, stand_in
from thinkblox.knowledge.rooms import Usual, read_usual
from thinkblox.value import Value

_GOODS = "goods"


class Goods(Value, frozen=True, kw_only=True):
    """Words about goods.

    Attributes:
        shops: what a place where things are sold is called after them, a list.
        general: categories that lie in a shop of which one does not know what it sells, a list.
        laid: how goods of a mount are shown, in the notation of rooms.toml; there they are called "goods".
        shown: the category that is shown where the word before that is no single thing; empty for none.
    """

    shops: str
    general: str
    laid: dict[str, tuple[str, ...]]
    shown: dict[str, str]


def goods_in(words: list[str]) -> str:
    """The category of what the shop in a text sells that is called by it; empty where none is, or none that we know.

    Args:
        words: of the text, in their order.
    """
    said = [word.lower() for word in words]
    shops = _goods().shops.split(", ")
    for at, word in enumerate(said):
        if at and word in shops:
            return _shown(said[at - 1])
    return ""


def stocked(wanted: tuple[Usual, ...], goods: str) -> tuple[Usual, ...]:
    """What a shop holds with its goods instead of goods of any kind; unchanged where `goods` is empty."""
    if not goods:
        return wanted
    laid = [
        replace(u, category=goods) if u.category == _GOODS else u
        for u in read_usual(_goods().laid[kind_of(goods).mount])
    ]
    there = {usual.category for usual in laid}
    return (*(u for u in wanted if u.category not in there and u.category not in _goods().general.split(", ")), *laid)


def _shown(word: str) -> str:
    if word in _goods().shown:
        return _goods().shown[word]
    found = stand_in(singular(word))
    return found.category.name if found.how in ("catalogue", "table") else ""


@lru_cache(maxsize=1)
def _goods() -> Goods:
    text = Path(__file__).with_name("goods.toml").read_text(encoding="utf-8")
    return msgspec.convert(tomllib.loads(text), Goods)
