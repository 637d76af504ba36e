"""How much a room is filled with besides what its prompt names."""

from typing import Literal, get_args

Fill = Literal["named", "essentials", "lived-in"]
"""What stands in a room besides what its prompt names."""
FILLS: tuple[Fill, ...] = get_args(Fill)
