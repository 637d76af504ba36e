"""What can be placed: procedural furniture and its properties."""

from thinkblox.assets.catalogue import CATALOGUE, GENERAL_WORDS, register, revision, unregister
from thinkblox.assets.category import Category
from thinkblox.assets.facts import Companion, Facts, Hanging, RowGaps, Use
from thinkblox.assets.levels import room_under
from thinkblox.assets.make import category_of, fit_asset, make_asset, make_thing
from thinkblox.assets.source import AssetSource, ProceduralAssets
from thinkblox.assets.stand_ins import StandIn, facts_of, kind_of, stand_in

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
    "StandIn",
    "Use",
    "category_of",
    "facts_of",
    "fit_asset",
    "kind_of",
    "make_asset",
    "make_thing",
    "register",
    "revision",
    "room_under",
    "stand_in",
    "unregister",
]
