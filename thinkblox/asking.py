"""What is said to a model that reads a prompt, plans, edits, or furnishes a whole room at once."""

from collections.abc import Mapping
from functools import cache

from thinkblox.assets import CATALOGUE
from thinkblox.chat import Chat, Message
from thinkblox.observe import Kind
from thinkblox.plan import Plan
from thinkblox.prompts import TemplateName, filled, one_line
from thinkblox.prompts.answers import MOST_OBJECTS, PLACES, RELATIONS
from thinkblox.scene.arrangement import Arrangement
from thinkblox.scene.room import Room
from thinkblox.wording import layout_text, planned_line, room_words

LAYOUT = 40_000
"""Characters of a layout that is to be edited; beyond that, things are counted only."""


def objects_chat(prompt: str) -> Chat:
    """What belongs into the room for a prompt; the answer is an `answers.ObjectSet`."""
    return _asked(
        "objects",
        prompt=one_line(prompt),
        most=str(MOST_OBJECTS),
        places=", ".join(PLACES),
        relations=", ".join(RELATIONS),
        categories=_categories(),
    )


def plan_chat(plan: Plan, room: Room, kinds: Mapping[str, Kind]) -> Chat:
    """In which order the objects of a plan are placed; the answer is an `answers.PlannedOrder`."""
    return _asked(
        "plan",
        prompt=one_line(plan.brief.prompt),
        room=room_words(room),
        objects=_planned(plan, kinds),
        places=", ".join(PLACES),
        relations=", ".join(RELATIONS),
    )


def whole_room_chat(plan: Plan, room: Room, kinds: Mapping[str, Kind]) -> Chat:
    """Where all objects of a plan go, at once; the answer is an `answers.WholeRoom`."""
    prompt = one_line(plan.brief.prompt)
    return _asked("one_shot", prompt=prompt, room=room_words(room), objects=_planned(plan, kinds))


def edit_chat(arrangement: Arrangement, prompt: str, instruction: str) -> Chat:
    """What an instruction means for a layout; the answer is an `answers.Edit`."""
    return _asked(
        "edit",
        prompt=one_line(prompt),
        room=room_words(arrangement.room),
        layout=layout_text(arrangement, None, LAYOUT).whole,
        instruction=one_line(instruction),
    )


def _asked(name: TemplateName, **values: str) -> Chat:
    return (Message("user", (filled(name, **values),)),)


def _planned(plan: Plan, kinds: Mapping[str, Kind]) -> str:
    lines = []
    for target in plan.targets:
        kind = kinds.get(target.category)
        lines.append(planned_line(target, kind.size if kind else None, kind.mount if kind else None))
    return "\n".join(lines)


@cache
def _categories() -> str:
    return ", ".join(name for name, category in CATALOGUE.items() if not category.plain)
