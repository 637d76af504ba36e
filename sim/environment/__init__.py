"""A room as an environment for robots, of dm_control and of Gymnasium (extra `[env]`).

    from thinkblox.sim.environment import make_environment

    environment = make_environment("out/bedroom", "drive", "desk_1", seed=0)
    told = environment.reset()

Importing this registers "ThinkBLOX/Reach-v0", "ThinkBLOX/Drive-v0", "ThinkBLOX/Open-v0" and "ThinkBLOX/Carry-v0" with
Gymnasium, where that is installed.
"""

from typing import TYPE_CHECKING

from thinkblox.lazy import lazily
from thinkblox.sim.environment.registration import register_environments

if TYPE_CHECKING:
    from thinkblox.sim.environment.gym_env import make_gym_environment, vector_environment
    from thinkblox.sim.environment.making import make_environment
    from thinkblox.sim.environment.pictures import Pictures
    from thinkblox.sim.environment.policies import (
        RandomPolicy,
        ScriptedCarry,
        ScriptedDrive,
        ScriptedOpen,
        ScriptedReach,
        run_episode,
    )
    from thinkblox.sim.environment.robot import Robot, load_robot
    from thinkblox.sim.environment.room_source import make_arena, opened, rooms_of

__all__ = [
    "Pictures",
    "RandomPolicy",
    "Robot",
    "ScriptedCarry",
    "ScriptedDrive",
    "ScriptedOpen",
    "ScriptedReach",
    "load_robot",
    "make_arena",
    "make_environment",
    "make_gym_environment",
    "opened",
    "rooms_of",
    "run_episode",
    "vector_environment",
]
_HERE = "thinkblox.sim.environment"
__getattr__, __dir__ = lazily(
    __name__,
    {
        **dict.fromkeys(("make_gym_environment", "vector_environment"), f"{_HERE}.gym_env"),
        "make_environment": f"{_HERE}.making",
        "Pictures": f"{_HERE}.pictures",
        **dict.fromkeys(
            ("RandomPolicy", "ScriptedCarry", "ScriptedDrive", "ScriptedOpen", "ScriptedReach", "run_episode"),
            f"{_HERE}.policies",
        ),
        **dict.fromkeys(("Robot", "load_robot"), f"{_HERE}.robot"),
        **dict.fromkeys(("make_arena", "opened", "rooms_of"), f"{_HERE}.room_source"),
    },
)
register_environments()
