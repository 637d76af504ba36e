"""What is shown while objects are placed."""

import sys
from typing import TYPE_CHECKING, Any

from thinkblox.cli.stopping import heed_stops

if TYPE_CHECKING:
    from thinkblox.generate import Progress


class ObjectBar:
    """A bar per object on a terminal, a plain line elsewhere, nothing when a machine reads along."""

    def __init__(self, *, quiet: bool) -> None:
        self._quiet = quiet
        self._bar: Any = None

    def __enter__(self) -> "ObjectBar":
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()

    def tell(self, progress: "Progress") -> None:
        """Show one object more; raises KeyboardInterrupt when the command was stopped meanwhile."""
        heed_stops()
        if self._quiet:
            return
        outcome = "placed" if progress.placed else "not placed"
        if progress.number == 1 and progress.attempt > 0:
            self._begin_anew(progress)
        if not sys.stderr.isatty():
            print(f"{progress.number}/{progress.total} {progress.target.id} {outcome}", file=sys.stderr)
            return
        from tqdm import tqdm

        if self._bar is None:
            self._bar = tqdm(total=progress.total, unit="object", file=sys.stderr)
        self._bar.set_description_str(f"{progress.target.id} {outcome}")
        self._bar.update()

    def _begin_anew(self, progress: "Progress") -> None:
        if self._bar is None:
            print(f"not all as asked; begun anew ({progress.attempt})", file=sys.stderr)
        else:
            self._bar.reset()
