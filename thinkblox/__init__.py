"""Physics-verified indoor scenes: a prompt in, a furnished room out, measured in MuJoCo object by object.

    import thinkblox

    result = thinkblox.generate_room("A calm bedroom with a double bed and two nightstands", seed=0)
    thinkblox.save_room(result, "out/bedroom")

Names are loaded when they are first used: importing the package loads no physics engine.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from thinkblox.checking import VerifyOptions, verify_file
    from thinkblox.editing import Edit, edit_room, undo_edit
    from thinkblox.episode import Episode, read_episode
    from thinkblox.errors import InputError, ThinkBloxError
    from thinkblox.exporters.exporting import export_scene
    from thinkblox.exporters.mjcf import to_mjmodel, to_mjspec
    from thinkblox.exporters.saving import save_scene
    from thinkblox.furnishing import Generation
    from thinkblox.generate import generate_room
    from thinkblox.judging import Try, judge, judge_all
    from thinkblox.observe import Observation
    from thinkblox.placing import Effort
    from thinkblox.plan import Target
    from thinkblox.policies import Policy
    from thinkblox.room_score import RoomScore
    from thinkblox.saving import save_room
    from thinkblox.scene.actions import Add, Move, Remove, Replace, Swap, Turn
    from thinkblox.scene.asset import Asset
    from thinkblox.scene.placement import Placement
    from thinkblox.scene.room import Opening, Room
    from thinkblox.scene.scene import Scene, load_scene
    from thinkblox.scoring import score
    from thinkblox.sim.verdict.verify import verify
    from thinkblox.sim.verdict.world import World
    from thinkblox.sim.workers.pool import Job, VerdictPool
    from thinkblox.steps import Rejection, Step, parse
    from thinkblox.verdict import Report, Verdict

__version__: str
_HOME = {
    "Add": "thinkblox.scene.actions",
    "Asset": "thinkblox.scene.asset",
    "Edit": "thinkblox.editing",
    "Effort": "thinkblox.placing",
    "Episode": "thinkblox.episode",
    "Generation": "thinkblox.furnishing",
    "InputError": "thinkblox.errors",
    "Job": "thinkblox.sim.workers.pool",
    "Move": "thinkblox.scene.actions",
    "Observation": "thinkblox.observe",
    "Opening": "thinkblox.scene.room",
    "Placement": "thinkblox.scene.placement",
    "Policy": "thinkblox.policies",
    "Rejection": "thinkblox.steps",
    "Remove": "thinkblox.scene.actions",
    "Replace": "thinkblox.scene.actions",
    "Report": "thinkblox.verdict",
    "Room": "thinkblox.scene.room",
    "RoomScore": "thinkblox.room_score",
    "Scene": "thinkblox.scene.scene",
    "Step": "thinkblox.steps",
    "Swap": "thinkblox.scene.actions",
    "Target": "thinkblox.plan",
    "ThinkBloxError": "thinkblox.errors",
    "Try": "thinkblox.judging",
    "Turn": "thinkblox.scene.actions",
    "Verdict": "thinkblox.verdict",
    "VerdictPool": "thinkblox.sim.workers.pool",
    "VerifyOptions": "thinkblox.checking",
    "World": "thinkblox.sim.verdict.world",
    "edit_room": "thinkblox.editing",
    "export_scene": "thinkblox.exporters.exporting",
    "generate_room": "thinkblox.generate",
    "judge": "thinkblox.judging",
    "judge_all": "thinkblox.judging",
    "load_scene": "thinkblox.scene.scene",
    "parse": "thinkblox.steps",
    "read_episode": "thinkblox.episode",
    "save_room": "thinkblox.saving",
    "save_scene": "thinkblox.exporters.saving",
    "score": "thinkblox.scoring",
    "to_mjmodel": "thinkblox.exporters.mjcf",
    "to_mjspec": "thinkblox.exporters.mjcf",
    "undo_edit": "thinkblox.editing",
    "verify": "thinkblox.sim.verdict.verify",
    "verify_file": "thinkblox.checking",
}
__all__ = [
    "Add",
    "Asset",
    "Edit",
    "Effort",
    "Episode",
    "Generation",
    "InputError",
    "Job",
    "Move",
    "Observation",
    "Opening",
    "Placement",
    "Policy",
    "Rejection",
    "Remove",
    "Replace",
    "Report",
    "Room",
    "RoomScore",
    "Scene",
    "Step",
    "Swap",
    "Target",
    "ThinkBloxError",
    "Try",
    "Turn",
    "Verdict",
    "VerdictPool",
    "VerifyOptions",
    "World",
    "edit_room",
    "export_scene",
    "generate_room",
    "judge",
    "judge_all",
    "load_scene",
    "parse",
    "read_episode",
    "save_room",
    "save_scene",
    "score",
    "to_mjmodel",
    "to_mjspec",
    "undo_edit",
    "verify",
    "verify_file",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return import_module("thinkblox.version").package_version()
    if name not in _HOME:
        raise AttributeError(f"module 'thinkblox' has no attribute {name!r}; it has {', '.join(__all__)}")
    return getattr(import_module(_HOME[name]), name)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
