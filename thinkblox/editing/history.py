"""What edits before have spoken of and changed: what "it" means then, and what a thing was standing on."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from thinkblox.episode import Edited, RoomState
from thinkblox.scene.placement import Placement


@dataclass(frozen=True)
class Past:
    """The edits of a room that were not undone.

    Attributes:
        about: ids that the last of them was about.
        gone: the one thing that the last of them has taken away, as it stood.
        carriers: on what each thing rested that has come to rest on something else since, by its id.
    """

    about: tuple[str, ...] = ()
    gone: Placement | None = None
    carriers: Mapping[str, str] = field(default_factory=dict)


def past_of(edits: Sequence[Edited]) -> Past:
    """What the edits of a room have left to be spoken of."""
    carriers: dict[str, str] = {}
    for edit in reversed(edits):
        now = {p.id: p.support for p in edit.after.placements}
        for placement in edit.before.placements:
            if now.get(placement.id, "") != placement.support:
                carriers.setdefault(placement.id, placement.support)
    return Past(_about(edits[-1]), _gone(edits[-1]), carriers) if edits else Past()


def _gone(edit: Edited) -> Placement | None:
    left = {p.id for p in edit.after.placements}
    gone = [p for p in edit.before.placements if p.id not in left]
    return gone[0] if len(gone) == 1 else None


def _about(edit: Edited) -> tuple[str, ...]:
    """What an edit was about; of one that does not say the one thing that it has changed."""
    if edit.about:
        return tuple(edit.about)
    before, after = _placements(edit.before), _placements(edit.after)
    changed = [id for id, p in after.items() if before.get(id) != p]
    own = [id for id in changed if after[id].support not in changed]
    return tuple(own) if len(own) == 1 else ()


def _placements(state: RoomState) -> dict[str, Placement]:
    return {p.id: p for p in state.placements}
