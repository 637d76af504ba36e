"""Asking a model for one answer of a kind: what cannot be used is told to it, and it is asked once more."""

from collections.abc import Callable
from typing import TypeVar

import numpy as np

from thinkblox.chat import Chat, ChatModel, Message
from thinkblox.errors import InputError
from thinkblox.plain_text import escaped
from thinkblox.prompts.answers import MAX_ANSWER, read_answer
from thinkblox.steps import Rejection
from thinkblox.value import Value

A = TypeVar("A", bound=Value)
R = TypeVar("R")
TIMES = 2
"""How often a model is asked for one answer."""
_SHOWN = 300


def agreed(
    model: ChatModel, chat: Chat, kind: type[A], use: Callable[[A], R], *, what: str, rng: np.random.Generator
) -> R:
    """What becomes of a model's answer.

    Args:
        model: who is asked.
        chat: what it is told.
        kind: what its answer must be.
        use: makes something of it; raises InputError where that cannot be done.
        what: for an error, what was asked for ("the list of objects").
        rng: for its samples.

    Raises:
        InputError: the model cannot be asked, or no answer of it can be used; with the reason.
    """
    why = ""
    for _ in range(TIMES):
        said = _answer(model, chat, rng)
        try:
            return use(_read(said, kind))
        except InputError as error:
            why = " ".join(escaped(str(error), keep="\n").split())
        chat = (*chat, Message("assistant", (said[:MAX_ANSWER],)), Message("user", (_again(why),)))
    why = why if len(why) <= _SHOWN else f"{why[:_SHOWN]}..."
    raise InputError(f"the model was asked {TIMES} times for {what} and gave none that can be used: {why}")


def _answer(model: ChatModel, chat: Chat, rng: np.random.Generator) -> str:
    try:
        said: object = next(iter(model.answer(chat, 1, rng)), "")
    except InputError:
        raise
    except Exception as error:  # a model is anybody's code
        raise InputError(
            f"the model failed: {' '.join(f'{type(error).__name__}: {error}'.split())[:_SHOWN]}"
        ) from error
    return said if isinstance(said, str) else ""


def _read(said: str, kind: type[A]) -> A:
    found = read_answer(said, kind)
    if isinstance(found, Rejection):
        raise InputError(found.message)
    return found


def _again(why: str) -> str:
    return f"That cannot be used: {why}. Answer anew in the form asked for, and write nothing else."
