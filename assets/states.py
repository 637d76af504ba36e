"""States in which a prompt wants to find things ("open", "folded"), as far as how they are made shows them."""

from thinkblox.assets.catalogue import CATALOGUE
from thinkblox.assets.plain import shape_of
from thinkblox.assets.stand_ins import facts_of
from thinkblox.scene.asset import Asset

_ALWAYS: dict[str, frozenset[str]] = {
    "open": frozenset({"laptop", "curtain"}),
    "folded": frozenset({"blanket", "towels"}),
    "made": frozenset({"bed", "hospital_bed", "bunk_bed", "crib"}),
    "stacked": frozenset({"book_stack", "towels"}),
    "framed": frozenset({"picture", "photo_frame", "mirror", "standing_mirror", "painting"}),
    "closed": frozenset("book book_stack notebook umbrella suitcase backpack toilet toolbox box pizza_box jar".split()),
    "swivel": frozenset({"office_chair"}),
    "folding": frozenset({"folding_table", "ironing_board", "ladder", "drying_rack"}),
    "on": frozenset({"tv", "wall_tv", "monitor", "computer", "laptop", "tablet"}),
    "lit": frozenset({"candle"}),
    "empty": frozenset(
        (
            "basket bathtub bookcase bowl cup glass laundry_basket plate shelving_unit tray vase wall_shelf waste_bin"
        ).split()
    ),
}
"""Categories that are made so and in no other way, by state."""
_SHUT = frozenset({"closed", "shut"})
_SHUT_SHAPES = ("cabinet", "block")
"""Plain shapes that are shut on all sides."""


def shows_state(asset: Asset, state: str) -> bool:
    """Whether an asset is seen in a state: doors and drawers are shut, a laptop is open, a bed is made."""
    word = state.lower().strip()
    if word == "empty" and {"filled", "full"} & set(asset.attributes):
        return False
    if word in _SHUT and any(link.joint is not None for link in asset.links):
        return True
    if word in _SHUT and asset.category in CATALOGUE and shape_of(CATALOGUE[asset.category]) in _SHUT_SHAPES:
        return True
    if word == "framed" and asset.category in CATALOGUE and shape_of(CATALOGUE[asset.category]) == "board":
        return True
    if word in asset.attributes and word in facts_of(asset.category).forms.values():
        return True
    if word == "folded" and asset.category in CATALOGUE and shape_of(CATALOGUE[asset.category]) == "cloth":
        return True
    return asset.category in _ALWAYS.get("closed" if word in _SHUT else word, frozenset())
