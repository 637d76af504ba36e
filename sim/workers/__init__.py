"""Work in processes of its own: pools of verdicts for trainers, and a fence round foreign input.

Names are loaded when they are first used: a worker process that starts loads no more than it needs.
"""

from typing import TYPE_CHECKING

from thinkblox.lazy import lazily

if TYPE_CHECKING:
    from thinkblox.sim.workers.guard import guarded
    from thinkblox.sim.workers.pool import Job, VerdictPool

__all__ = ["Job", "VerdictPool", "guarded"]
__getattr__, __dir__ = lazily(
    __name__,
    {
        "Job": "thinkblox.sim.workers.pool",
        "VerdictPool": "thinkblox.sim.workers.pool",
        "guarded": "thinkblox.sim.workers.guard",
    },
)
