"""A model that understands prompts, and one that plans."""

import numpy as np
from msgspec import structs

from thinkblox.asking import objects_chat, plan_chat
from thinkblox.assets import CATALOGUE
from thinkblox.assets.names import identifier_of, name_of
from thinkblox.assets.source import AssetSource, ProceduralAssets
from thinkblox.assets.stand_ins import noun_of
from thinkblox.brief import Brief
from thinkblox.chat import ChatModel
from thinkblox.errors import InputError
from thinkblox.fills import Fill
from thinkblox.knowledge.rooms import room_types
from thinkblox.observe import kinds_of
from thinkblox.plan import Plan
from thinkblox.planning import ExpertPlanner, plan_room
from thinkblox.policies.conversing import agreed
from thinkblox.prompts.answers import ObjectSet, PlannedOrder
from thinkblox.reading.second_reading import seconded
from thinkblox.reading.senses import with_senses
from thinkblox.scene.room import Room

MAX_PROMPT = 20_000
"""Longest prompt that a model is given [characters]."""


class ModelBriefer:
    """Lets a model understand prompts: it lists what belongs into the room, and what is to stand by what.

    Where that is not what the words of the prompt say, they count as not understood.
    """

    def __init__(self, model: ChatModel, *, fill: Fill = "essentials", seed: int = 0) -> None:
        """Take a model; with the fill "named", what it adds of its own is left out unless it carries what is named."""
        self._model = model
        self._fill = fill
        self._seed = seed

    def brief(self, prompt: str) -> Brief:
        """What the prompt asks for.

        Raises:
            InputError: the prompt is blank or too long, the model cannot be asked, or gives no list that can be used.
        """
        if not prompt.strip():
            raise InputError(
                "the prompt is empty; describe a room, such as 'A bedroom, 4 m by 5 m, with a double bed.'"
            )
        if len(prompt) > MAX_PROMPT:
            raise InputError(f"the prompt is {len(prompt)} characters long; at most {MAX_PROMPT} are read")
        rng = np.random.default_rng((self._seed, 1))
        chat = objects_chat(prompt)
        what = "the objects of the room"
        brief = seconded(agreed(self._model, chat, ObjectSet, lambda said: _usable(said, prompt), what=what, rng=rng))
        return _only_named(brief) if self._fill == "named" else brief


class ModelPlanner:
    """Lets a model decide on the order of the objects and on what each depends on.

    The room is as large as the brief says or its furniture needs, as for the expert, and what the brief asks for stays
    required.
    """

    def __init__(self, model: ChatModel, *, source: AssetSource | None = None, seed: int = 0) -> None:
        self._model = model
        self._source = source or ProceduralAssets()
        self._seed = seed
        self._expert = ExpertPlanner()

    def room(self, brief: Brief, rng: np.random.Generator) -> Room:
        """A room for a brief."""
        return self._expert.room(brief, rng)

    def plan(self, brief: Brief, room: Room) -> Plan:
        """The objects in the model's order.

        Raises:
            InputError: the model cannot be asked, or gives no order that can be used.
        """
        known = self._expert.plan(brief, room)
        if len(known.targets) < 2:
            return known
        rng = np.random.default_rng((self._seed, 2))
        chat = plan_chat(known, room, kinds_of(known, self._source))
        return agreed(
            self._model, chat, PlannedOrder, lambda said: said.plan(known), what="the order of the objects", rng=rng
        )


def category_named(noun: str) -> str:
    """What a noun phrase names: a category or general word of the catalogue's, else a plain stand-in's category."""
    words = noun_of(noun).split()
    name = identifier_of(" ".join(words))
    if name in CATALOGUE:
        return name
    found = name_of(words)
    return name if found is None or found.length < len(words) else found.name


def _usable(said: ObjectSet, prompt: str) -> Brief:
    """The brief of an answer; raises InputError for a room that cannot be."""
    brief = said.brief(prompt, category=category_named)
    brief = with_senses(brief)
    name = "_".join(noun_of(brief.room_type).split())
    brief = structs.replace(
        brief,
        room_type=name if name in room_types() else brief.room_type,
        excluded=tuple(dict.fromkeys(map(category_named, brief.excluded))),
    )
    plan_room(brief, rng=0)
    return brief


def _only_named(brief: Brief) -> Brief:
    """The brief without what the prompt does not name, but for what carries what it does."""
    kept = {request.key for request in brief.requests if request.asked}
    carried = [r for r in brief.relations if r.kind in ("on", "inside") and not r.negated]
    for _ in brief.requests:
        kept |= {anchor for relation in carried if relation.subject in kept for anchor in relation.anchors}
    gone = {request.key for request in brief.requests} - kept
    return structs.replace(
        brief,
        requests=tuple(r for r in brief.requests if r.key in kept),
        relations=tuple(r for r in brief.relations if r.subject not in gone and gone.isdisjoint(r.anchors)),
    )
