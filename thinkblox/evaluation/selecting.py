"""Which of the annotated prompts are to be judged."""

from collections.abc import Collection, Sequence

from thinkblox.errors import InputError
from thinkblox.evaluation.annotations import Annotation


def selected(
    annotations: Sequence[Annotation], *, only: Collection[str] = (), limit: int | None = None
) -> tuple[Annotation, ...]:
    """Those with one of the ids, or all where none is given, and of these the first `limit`.

    Raises:
        InputError: an id that no prompt has; lists some that there are.
    """
    ids = [annotation.id for annotation in annotations]
    if unknown := [id for id in only if id not in ids]:
        raise InputError(f"no prompt has the id {unknown[0]!r}; there are {', '.join(ids[:8])} and so on")
    kept = [annotation for annotation in annotations if not only or annotation.id in only]
    return tuple(kept[:limit])
