"""How a model is asked for places: for one object after the other, or for all of them at once."""

from typing import Literal, get_args

Mode = Literal["progressive", "one-shot"]
MODES: tuple[Mode, ...] = get_args(Mode)
