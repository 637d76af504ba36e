"""What can be placed: procedural furniture and its properties."""

from thinkblox.assets.catalogue import CATALOGUE, GENERAL_WORDS, facts_of, register, revision, unregister
from thinkblox.assets.category import Category
from thinkblox.assets.facts import Companion, Facts, Hanging, RowGaps, Use
from thinkblox.assets.make import category_of, fit_asset, make_asset
from thinkblox.assets.source import AssetSource, ProceduralAssets

__all__ = [
    "CATALOGUE",
    "GENERAL_WORDS",
    "AssetSource",
    "Category",
    "Companion",
    "Facts",
    "Hanging",
    "ProceduralAssets",
    "RowGaps",
    "Use",
    "category_of",
    "facts_of",
    "fit_asset",
    "make_asset",
    "register",
    "revision",
    "unregister",
]
