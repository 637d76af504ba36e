"""A policy that asks a model once for the whole room, and hands its layout out object by object."""

import msgspec
import numpy as np

from thinkblox.asking import whole_room_chat
from thinkblox.chat import ChatModel
from thinkblox.errors import InputError
from thinkblox.observe import Observation
from thinkblox.plain_text import escaped
from thinkblox.plan import Plan
from thinkblox.prompts.answers import MAX_ANSWER, WholeRoom
from thinkblox.scene.room import Room
from thinkblox.steps import Answer, Rejection, decoded, tagged

_BEGINNING = 200
"""Characters of an answer that cannot be used, as far as it is repeated."""
_THOUGHT = 10_000
"""Characters of the model's reasoning that are kept, with the first object."""
_LATER = "1. It stands where the layout of the whole room has it."


class OneShotPolicy:
    """Places objects by a layout of the whole room that a model gives before any of them stands.

    The baseline of step-by-step reasoning: what the layout says of an object is measured when its turn comes, and the
    model learns nothing of that. A room that is begun anew has a layout of its own.
    """

    def __init__(self, model: ChatModel) -> None:
        self._model = model
        self._of: tuple[Plan, Room] | None = None
        self._asked: set[str] = set()
        self._texts: dict[str, str] = {}
        self._wrong = ""

    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        """The place that the layout gives an object; nothing when it is asked for it again.

        Raises:
            InputError: the model cannot be asked, its layout cannot be read, or leaves the object out.
        """
        if observation.round:
            return []
        id, of = observation.target.id, (observation.plan, observation.layout.room)
        if of != self._of or id in self._asked:
            self._of, self._asked = of, set()
            self._lay_out(observation, rng)
        self._asked.add(id)
        if self._wrong:
            raise InputError(self._wrong)
        if id not in self._texts:
            raise InputError(f"the layout of the whole room leaves out {id}")
        return [self._texts[id]]

    def _lay_out(self, observation: Observation, rng: np.random.Generator) -> None:
        self._texts, self._wrong = {}, "the model gave no layout of the whole room"
        chat = whole_room_chat(observation.plan, observation.layout.room, observation.kinds)
        said = next(iter(self._model.answer(chat, 1, rng)), "")
        parts = tagged(said, most=MAX_ANSWER)
        room = parts if isinstance(parts, Rejection) else decoded(parts[1], WholeRoom)
        if isinstance(room, Rejection) or isinstance(parts, Rejection):
            why = room.message if isinstance(room, Rejection) else ""
            began = escaped(said[:_BEGINNING])
            self._wrong = f"the layout of the whole room cannot be used: {why}; it began {began!r}"
            return
        ids = [answer.id for answer in room.objects]
        twice = next((id for id in ids if ids.count(id) > 1), "")
        self._wrong = f"the layout of the whole room has {twice} twice" if twice else ""
        for number, answer in enumerate(room.objects):
            self._texts[answer.id] = _text(answer, _LATER if number else parts[0][:_THOUGHT])


def _text(answer: Answer, think: str) -> str:
    return f"<think>\n{think}\n</think>\n<answer>{msgspec.json.encode(answer).decode()}</answer>"
