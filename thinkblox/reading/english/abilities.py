"""The "can" of "her old chair can stay", which is a verb and no can."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.knowledge.vocabulary import name_of
from thinkblox.reading.tokens import Token

_DOING = frozenset(
    "also be come face fit go hang have hold keep lean lie live remain rest share sit stand stay still take".split()
)
"""What follows the verb: other verbs as they are without an ending, and what may come between."""
_CAN = "can"


def with_abilities(tokens: Sequence[Token]) -> list[Token]:
    """The tokens, with "should" for a "can" that is a verb."""
    return [structs.replace(token, text="should") if _is_verb(tokens, at) else token for at, token in enumerate(tokens)]


def _is_verb(tokens: Sequence[Token], at: int) -> bool:
    if tokens[at].text != _CAN or not at or at + 1 == len(tokens) or tokens[at - 1].kind != "word":
        return False
    name = name_of([tokens[at - 1].text, _CAN])
    called = name is not None and name.length > 1
    return tokens[at + 1].text in _DOING and not called and name_of([tokens[at - 1].text]) is not None
