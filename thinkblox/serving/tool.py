"""A tool as a value: its fields are what it is called with, checked as every other JSON is that comes from outside."""

import re
from inspect import cleandoc
from typing import TYPE_CHECKING, Any, ClassVar

import msgspec

from thinkblox.errors import InputError
from thinkblox.serving.said import Said
from thinkblox.value import Value, json_schema

if TYPE_CHECKING:
    from thinkblox.serving.desk import Desk

_CAPITAL = re.compile(r"(?<!^)(?=[A-Z])")


class Tool(Value, frozen=True, kw_only=True):
    """A call of one tool; its docstring tells an agent what it does, the `Meta` of a field what that is for.

    Attributes:
        reads: it changes nothing.
    """

    reads: ClassVar[bool] = False

    def run(self, desk: "Desk") -> Said:
        """Do it.

        Raises:
            InputError: it cannot be done; says what to do instead.
        """
        raise NotImplementedError

    @classmethod
    def called(cls) -> str:
        """Its name: "open_room" for OpenRoomTool."""
        return _CAPITAL.sub("_", cls.__name__.removesuffix("Tool")).lower()

    @classmethod
    def schema(cls) -> dict[str, Any]:
        """The JSON Schema of what it is called with: an object at its root."""
        whole = json_schema(cls)
        parts = whole.pop("$defs")
        root = parts.pop(cls.__name__)
        root.pop("title", None)
        root.pop("description", None)
        return {**root, **({"$defs": parts} if parts else {})}

    @classmethod
    def says(cls) -> str:
        """What it does, for an agent."""
        return cleandoc(cls.__doc__ or "")


def called_with(kind: type[Tool], arguments: object) -> Tool:
    """A call of a tool with what an agent gave.

    Raises:
        InputError: something is missing, unknown, of another type or out of range; says what.
    """
    try:
        return msgspec.convert(arguments, kind)
    except (InputError, msgspec.ValidationError, RecursionError) as error:
        fields = ", ".join(kind.__struct_fields__) or "nothing"
        raise InputError(f"{kind.called()}: {error}; it takes {fields}") from error
