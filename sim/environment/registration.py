"""The environments' names in Gymnasium's registry."""

from importlib.util import find_spec

NAMESPACE = "ThinkBLOX"
NAMES = {task: f"{NAMESPACE}/{task.capitalize()}-v0" for task in ("reach", "drive", "open", "carry")}
"""What `gymnasium.make` takes, by task."""


def register_environments() -> None:
    """Register them, where Gymnasium is installed."""
    if find_spec("gymnasium") is None:
        return
    import gymnasium

    for task, id in NAMES.items():
        if id not in gymnasium.registry:
            entry = "thinkblox.sim.environment.gym_env:make_gym_environment"
            gymnasium.register(id, entry_point=entry, kwargs={"task": task})
