"""What a user requires of every placement besides physics: a criterion of one's own, part of the verdict."""

from collections.abc import Sequence
from typing import Protocol

from thinkblox.errors import InputError
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.verdict import Unmet


class Requirement(Protocol):
    """A function of a scene and one of its placements; its name is that of the requirement in verdicts."""

    @property
    def __name__(self) -> str:
        """By which verdicts call it."""
        ...

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
        says = requirement(scene, placement)
        if not isinstance(says, str):
            raise InputError(
                f"the requirement {requirement.__name__} answered with a {type(says).__name__};"
                " it must say what is wrong, or '' when nothing is"
            )
        if says:
            found.append(Unmet(requirement=requirement.__name__, says=says))
    return tuple(found)
