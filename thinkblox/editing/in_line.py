"""Things that are to stand or hang in one line: held against where they have come."""

from collections.abc import Sequence

import numpy as np

from thinkblox.editing.work import Work

OFF_LINE = 0.15
"""How far from the line through all of them the middle of one may be [m]."""


def check_in_line(work: Work, ids: Sequence[str]) -> None:
    """Note whether the middles of things are in one line, seen from above.

    Args:
        work: the edit.
        ids: of the things; of two or less nothing is said.
    """
    spots = np.array([work.scene[id].position[:2] for id in ids if id in work.scene])
    if len(spots) < 3:
        return
    off = spots - spots.mean(axis=0)
    across = np.linalg.svd(off)[2][1]
    far = float(np.abs(off @ across).max())
    says = f"{', '.join(ids)}: at most {far:.2f} m off one line"
    (work.done if far <= OFF_LINE else work.failed).append(says)
