"""States in which a prompt wants to find things ("open", "folded"), as far as how they are made shows them."""

from collections.abc import Iterable, Iterator

from thinkblox.assets.ajar import has_open_door
from thinkblox.assets.facts import Role
from thinkblox.assets.open_forms import TIERED
from thinkblox.assets.plain import shape_of
from thinkblox.assets.sizing import OPEN
from thinkblox.assets.stand_ins import facts_of, kind_of, stand_in
from thinkblox.scene.asset import Asset

EMPTY, STACKED = "empty", "stacked"
_MEANT = {
    **dict.fromkeys(("bare", "clear", "cleared"), EMPTY),
    **dict.fromkeys(("rolled-up", "rolled up"), "rolled"),
    **dict.fromkeys(("opened", "wide open"), "open"),
    "shut": "closed",
}
"""Other words for a state."""
_TO_HOLD: Role = "holds"
_OPEN_FORMS = ("open", EMPTY, TIERED)
"""Forms that are made to hold things and are seen to have nothing in them."""
_TOPS = ("tables", "desks", "counters", "worktops", "shelves", "tiered")
"""What carries things on top and has nothing else on or in it."""
_SEATS = ("beds", "seats", "seating")
"""The same of what can be empty and is not called bare for that: a bare mattress has no linen."""
_BOARDS = frozenset("altar luggage_rack pallet plate podium sawhorse wall_shelf".split())
_STOCKED = frozenset("doll_house housekeeping_cart mug_tree popcorn_machine".split())
"""What has a hollow and is made with things in or on it."""
_ALWAYS: dict[str, frozenset[str]] = {
    "open": frozenset({"laptop", "curtain", "fireplace", "clothes_rack"}),
    "front-loading": frozenset({"washing_machine", "dryer"}),
    "folded": frozenset({"blanket", "towels"}),
    "made": frozenset({"bed", "hospital_bed", "bunk_bed", "crib"}),
    "stacked": frozenset({"book_stack", "paper", "towels"}),
    "rolled": frozenset({"rolled_rug", "rolled_mat"}),
    "framed": frozenset({"picture", "photo_frame", "mirror", "standing_mirror", "painting"}),
    "closed": frozenset("book book_stack notebook umbrella suitcase backpack toilet toolbox box pizza_box jar".split()),
    "swivel": frozenset({"office_chair"}),
    "folding": frozenset({"folding_table", "ironing_board", "ladder", "drying_rack"}),
    "on": frozenset({"tv", "wall_tv", "monitor", "computer", "laptop", "tablet"}),
    "lit": frozenset({"candle"}),
}
"""Categories that are made so and in no other way, by state."""
_OPENED = ("open", "open-fronted")
"""Forms of what is not shut."""
_SHUT_SHAPES = ("cabinet", "block", "tome")
"""Plain shapes that are shut on all sides."""


def meant_by(state: str) -> str:
    """The state that a word of a prompt means, in lower case: "rolled up" is "rolled"."""
    word = state.lower().strip()
    return _MEANT.get(word, word)


def words_for(category: str, states: Iterable[str]) -> Iterator[str]:
    """The words that have a thing made as states of it ask: an empty box is one that is open."""
    facts = facts_of(category)
    for state in map(meant_by, states):
        if state in facts.states or state in facts.forms.values():
            yield state
        elif state == EMPTY and facts.forms.get(_TO_HOLD) in _OPEN_FORMS:
            yield facts.forms[_TO_HOLD]


def shows_state(asset: Asset, state: str) -> bool:
    """Whether an asset is seen in a state: doors and drawers are shut, a laptop is open, a bed is made.

    What is empty is made so that nothing else is in or on it; whether anything rests there is seen in the room.
    """
    word, facts = meant_by(state), facts_of(asset.category)
    if word == EMPTY:
        return _is_left_empty(asset, state.lower().strip())
    if word == OPEN and any(link.joint is not None for link in asset.links):
        return has_open_door(asset.links)
    told = facts.states + tuple(facts.forms.values())
    if word in asset.attributes and word in told:
        return True
    if {*facts.states, *(_OPENED if word == "closed" else ())} & set(asset.attributes):
        return False
    shape = shape_of(kind_of(asset.category))
    if word == "closed" and (shape in _SHUT_SHAPES or any(link.joint is not None for link in asset.links)):
        return True
    if word == "open" and _is_hollow(asset):
        return True
    if (word, shape) in (("framed", "board"), ("folded", "cloth")):
        return True
    always = _ALWAYS.get(word, frozenset())
    return asset.category in always or stand_in(asset.category).like in always


def _is_hollow(asset: Asset) -> bool:
    """Whether it has neither lid nor doors, as a bin without a lid and shelves without doors."""
    lidless = any(s.within and s.headroom is None for s in asset.surfaces) or facts_of(asset.category).is_in("shelves")
    return lidless and all(link.joint is None for link in asset.links)


def _is_left_empty(asset: Asset, said: str) -> bool:
    """Whether a thing is made with a place for others, and with none of them there."""
    facts = facts_of(asset.category)
    if {"filled", "full"} & set(asset.attributes) or asset.category in _STOCKED:
        return False
    if EMPTY in asset.attributes and EMPTY in facts.forms.values():
        return True
    if _TO_HOLD in facts.forms:
        return facts.forms[_TO_HOLD] in _OPEN_FORMS and facts.forms[_TO_HOLD] in asset.attributes
    if any(surface.inner for surface in asset.surfaces):
        return True
    flat = facts.is_in(*_TOPS) or asset.category in _BOARDS or (said != "bare" and facts.is_in(*_SEATS))
    return flat and bool(asset.surfaces)
