"""A Brief to a Room and to a Plan: which floor, in which order, and what belongs to what."""

import numpy as np

from thinkblox.brief import Brief
from thinkblox.plan import Plan
from thinkblox.planning.drawn_sizes import with_sizes
from thinkblox.planning.forms import with_forms
from thinkblox.planning.looks import with_looks
from thinkblox.planning.openings import openings_wanted
from thinkblox.planning.order import plan_brief
from thinkblox.planning.orders import reordered
from thinkblox.planning.rooms import is_open, larger, plan_room
from thinkblox.planning.runs import with_run
from thinkblox.planning.surfaces import with_surfaces
from thinkblox.planning.tightness import fitted, is_essential, relieved
from thinkblox.planning.variety import varied
from thinkblox.scene.room import Room


class ExpertPlanner:
    """The Planner that needs no model: rooms as large as their furniture needs, anchors before what belongs to them."""

    def room(self, brief: Brief, rng: np.random.Generator) -> Room:
        """A room for a brief."""
        return plan_room(brief, rng=rng)

    def plan(self, brief: Brief, room: Room) -> Plan:
        """The objects in the order in which they are placed."""
        return plan_brief(brief, room)


__all__ = [
    "ExpertPlanner",
    "fitted",
    "is_essential",
    "is_open",
    "larger",
    "openings_wanted",
    "plan_brief",
    "plan_room",
    "relieved",
    "reordered",
    "varied",
    "with_forms",
    "with_looks",
    "with_run",
    "with_sizes",
    "with_surfaces",
]
