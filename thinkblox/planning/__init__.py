"""A Brief to a Room and to a Plan: which floor, in which order, and what belongs to what."""

from thinkblox.planning.order import plan_brief
from thinkblox.planning.rooms import plan_room

__all__ = ["plan_brief", "plan_room"]
