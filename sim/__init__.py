"""A scene in MuJoCo: built, measured, settled, drawn. Names are loaded when they are first used.

- **Measure**: a `World` measures candidates for one object more, `verify` a whole scene, and `settle` lets it come to
  rest; by `Tolerances`, `Physics` and `Walking`.
- **In processes of their own**: `VerdictPool` measures many `Job`s, `guarded` calls what reads foreign input.
- **Build**: `build_spec` makes the MjSpec that is measured and exported.
- **Anyone's model**: a `Subject` comes from `subject_of` a scene or `open_model` of a file; `model_report` and
  `run_suite`, by one of `SUITES`, measure it.
- **Draw**: `render_preview` a room, `render_top` its plan, `room_views` with all marks for a
  policy; `render_asset`, `render_target` and `contact_sheet` draw things; `cast` from a `Camera` gives a
  `Frame` of ids and depths.
"""

from typing import TYPE_CHECKING

from thinkblox.lazy import lazily

if TYPE_CHECKING:
    from thinkblox.sim.build import build_spec
    from thinkblox.sim.foreign.model_report import model_report
    from thinkblox.sim.foreign.opening import open_model
    from thinkblox.sim.render import (
        Camera,
        Frame,
        cast,
        contact_sheet,
        render_asset,
        render_preview,
        render_target,
        render_top,
        room_views,
    )
    from thinkblox.sim.settings import Physics, Tolerances, Walking
    from thinkblox.sim.subject import Subject, subject_of
    from thinkblox.sim.suites import SUITES, run_suite
    from thinkblox.sim.verdict.settle import SettledState, settle
    from thinkblox.sim.verdict.verify import verify
    from thinkblox.sim.verdict.world import World
    from thinkblox.sim.workers import Job, VerdictPool, guarded

__all__ = [
    "SUITES",
    "Camera",
    "Frame",
    "Job",
    "Physics",
    "SettledState",
    "Subject",
    "Tolerances",
    "VerdictPool",
    "Walking",
    "World",
    "build_spec",
    "cast",
    "contact_sheet",
    "guarded",
    "model_report",
    "open_model",
    "render_asset",
    "render_preview",
    "render_target",
    "render_top",
    "room_views",
    "run_suite",
    "settle",
    "subject_of",
    "verify",
]
_RENDER = (
    "Camera",
    "Frame",
    "cast",
    "contact_sheet",
    "render_asset",
    "render_preview",
    "render_target",
    "render_top",
    "room_views",
)
__getattr__, __dir__ = lazily(
    __name__,
    {
        **dict.fromkeys(("Physics", "Tolerances", "Walking"), "thinkblox.sim.settings"),
        **dict.fromkeys(("SettledState", "settle"), "thinkblox.sim.verdict.settle"),
        "World": "thinkblox.sim.verdict.world",
        "verify": "thinkblox.sim.verdict.verify",
        **dict.fromkeys(("Job", "VerdictPool", "guarded"), "thinkblox.sim.workers"),
        "build_spec": "thinkblox.sim.build",
        **dict.fromkeys(("Subject", "subject_of"), "thinkblox.sim.subject"),
        "open_model": "thinkblox.sim.foreign.opening",
        "model_report": "thinkblox.sim.foreign.model_report",
        **dict.fromkeys(("SUITES", "run_suite"), "thinkblox.sim.suites"),
        **dict.fromkeys(_RENDER, "thinkblox.sim.render"),
    },
)
