"""Agents in tests: a desk whose tools are called without any protocol, and what the expert would say."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from thinkblox.policies.expert import ExpertPolicy
from thinkblox.serving.calls import call
from thinkblox.serving.desk import Desk
from thinkblox.serving.room import AgentRoom
from thinkblox.serving.root import Root
from thinkblox.serving.said import Said


class Agent:
    """Calls tools; `ok` wants them done, `refused` wants an error and returns it."""

    def __init__(self, root: Path) -> None:
        self.desk = Desk(Root(root))

    def ok(self, name: str, **arguments: Any) -> Said:
        answered = call(self.desk, name, arguments)
        assert answered.done, answered.said.text
        return answered.said

    def data(self, name: str, **arguments: Any) -> dict[str, Any]:
        data = self.ok(name, **arguments).data
        assert data is not None
        return data

    def refused(self, name: str, **arguments: Any) -> str:
        answered = call(self.desk, name, arguments)
        assert not answered.done
        assert "Traceback" not in answered.said.text
        assert "fault of ours" not in answered.said.text, answered.said.text
        return answered.said.text

    def room(self, handle: str = "room_1") -> AgentRoom:
        return self.desk.rooms[handle]

    def furnish(self, handle: str = "room_1") -> None:
        """Place all that is to be placed, with the expert's texts."""
        room = self.room(handle)
        furnish(room, lambda text: self.data("answer", room=handle, text=text))


def expert_texts(room: AgentRoom, n: int = 8) -> list[str]:
    """What the expert would say about the next object."""
    return ExpertPolicy().propose(room.observation(), n, np.random.default_rng(0))


def furnish(room: AgentRoom, answer: Callable[[str], dict[str, Any]]) -> None:
    while room.target is not None:
        target = room.target.id
        assert any(answer(text)["done"] for text in expert_texts(room)), target
