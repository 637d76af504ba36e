"""In which order the objects of a plan are placed."""

from typing import Literal, get_args

Order = Literal["plan", "size", "random"]
"""As planned, large things first, or by chance; nothing ever comes before what it depends on."""
ORDERS: tuple[Order, ...] = get_args(Order)
