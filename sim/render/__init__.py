"""Pictures of scenes and assets by ray casting: no display, no GL; the same picture on every run."""

from thinkblox.sim.render.camera import Camera, framed, plan_camera
from thinkblox.sim.render.frame import NOTHING, ROOM, Frame, cast
from thinkblox.sim.render.plan_view import plan_of, render_top
from thinkblox.sim.render.portrait import contact_sheet, render_asset
from thinkblox.sim.render.preview import best_view, render_preview
from thinkblox.sim.render.views import Marking, RoomView, render_target, room_views

__all__ = [
    "NOTHING",
    "ROOM",
    "Camera",
    "Frame",
    "Marking",
    "RoomView",
    "best_view",
    "cast",
    "contact_sheet",
    "framed",
    "plan_camera",
    "plan_of",
    "render_asset",
    "render_preview",
    "render_target",
    "render_top",
    "room_views",
]
