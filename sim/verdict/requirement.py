"""What a user requires of every placement besides physics: a criterion of one's own, part of the verdict."""

from collections.abc import Sequence
from typing import Protocol

from thinkblox.errors import InputError
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.verdict import Unmet


class Requirement(Protocol):
    """A function of a scene and one of its placements; verdicts call it by its name, or by that of its class."""

    def __call__(self, scene: Scene, placement: Placement, /) -> str:
        """What is wrong with the placement in the scene, in a line with its numbers; empty when nothing is."""
        ...


def unmet_by(requirements: Sequence[Requirement], scene: Scene, placement: Placement) -> tuple[Unmet, ...]:
    """The requirements that a placement does not meet where it stands in a scene.

    Raises:
        InputError: a requirement that answers with something else than a text; names it.
    """
    found = []
    for requirement in requirements:
        says, name = requirement(scene, placement), _name_of(requirement)
        if not isinstance(says, str):
            raise InputError(
                f"the requirement {name} answered with a {type(says).__name__};"
                " it must say what is wrong, or '' when nothing is"
            )
        if says:
            found.append(Unmet(requirement=name, says=says))
    return tuple(found)


def check_requirements(requirements: object) -> tuple[Requirement, ...]:
    """The requirements as a tuple; raises InputError for what is no sequence of functions."""
    if callable(requirements) or not isinstance(requirements, Sequence):
        raise InputError(f"requirements are a list of functions; this is a {type(requirements).__name__}")
    wrong = next((r for r in requirements if not callable(r)), None)
    if wrong is not None:
        raise InputError(f"a requirement is a function of a scene and a placement; this is a {type(wrong).__name__}")
    return tuple(requirements)


def _name_of(requirement: Requirement) -> str:
    return str(getattr(requirement, "__name__", type(requirement).__name__))
