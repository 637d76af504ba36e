"""Physics-verified indoor scenes: a prompt in, a furnished room out, measured in MuJoCo object by object.

    import thinkblox

    result = thinkblox.generate_room("A calm bedroom with a double bed and two nightstands", seed=0)
    thinkblox.save_room(result, "out/bedroom")

Names are loaded when they are first used: importing the package loads no physics engine.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from thinkblox.checking import Reading, verify_file
    from thinkblox.errors import InputError, ThinkBloxError
    from thinkblox.exporters.folder import save_room
    from thinkblox.generate import Generation, generate_room
    from thinkblox.policies import Policy
    from thinkblox.room import Opening, Room
    from thinkblox.scene import Placement, Scene, load_scene
    from thinkblox.sim.pool import Job, VerdictPool
    from thinkblox.sim.verify import verify
    from thinkblox.sim.world import World
    from thinkblox.steps import Rejection, Step, parse
    from thinkblox.verdict import Report, Verdict

_HOME = {
    "Generation": "thinkblox.generate",
    "InputError": "thinkblox.errors",
    "Job": "thinkblox.sim.pool",
    "Opening": "thinkblox.room",
    "Placement": "thinkblox.scene",
    "Policy": "thinkblox.policies",
    "Reading": "thinkblox.checking",
    "Rejection": "thinkblox.steps",
    "Report": "thinkblox.verdict",
    "Room": "thinkblox.room",
    "Scene": "thinkblox.scene",
    "Step": "thinkblox.steps",
    "ThinkBloxError": "thinkblox.errors",
    "Verdict": "thinkblox.verdict",
    "VerdictPool": "thinkblox.sim.pool",
    "World": "thinkblox.sim.world",
    "generate_room": "thinkblox.generate",
    "load_scene": "thinkblox.scene",
    "parse": "thinkblox.steps",
    "save_room": "thinkblox.exporters.folder",
    "verify": "thinkblox.sim.verify",
    "verify_file": "thinkblox.checking",
}
__all__ = [
    "Generation",
    "InputError",
    "Job",
    "Opening",
    "Placement",
    "Policy",
    "Reading",
    "Rejection",
    "Report",
    "Room",
    "Scene",
    "Step",
    "ThinkBloxError",
    "Verdict",
    "VerdictPool",
    "World",
    "generate_room",
    "load_scene",
    "parse",
    "save_room",
    "verify",
    "verify_file",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'thinkblox' has no attribute {name!r}; it has {', '.join(__all__)}")
    return getattr(import_module(_HOME[name]), name)


def __dir__() -> list[str]:
    return __all__
