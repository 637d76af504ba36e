"""The record of how a room came about: one line of trace.jsonl for every round of tries."""

from typing import Literal

from thinkblox.steps import Rejection
from thinkblox.value import Value
from thinkblox.verdict import Verdict


class Try(Value, frozen=True, kw_only=True):
    """One proposal and what became of it: rejected unread, or measured.

    Attributes:
        text: a policy's words; empty in the search around a failed try.
    """

    text: str = ""
    rejection: Rejection | None = None
    verdict: Verdict | None = None


class Round(Value, frozen=True, kw_only=True):
    """A round of tries for one object.

    Attributes:
        id: the object.
        number: rounds for this object, from 0.
        kind: "policy"; "repair" for the search around the best failed try; "last resort" for a pose that keeps
            everything but a walkable way or a window free.
        chosen: index of the try that was committed; None when none was.
        propose_seconds, check_seconds: time spent in the policy and in the physics.
        attempt: how often the room had been begun anew before.
        kept: whether it belongs to the attempt that became the room.
    """

    id: str
    number: int
    kind: Literal["policy", "repair", "last resort"]
    tries: tuple[Try, ...]
    chosen: int | None = None
    propose_seconds: float = 0.0
    check_seconds: float = 0.0
    attempt: int = 0
    kept: bool = True
