"""What is shown while objects are placed."""

import sys
from typing import TYPE_CHECKING, Any

from thinkblox.cli.stopping import heed_stops

if TYPE_CHECKING:
    from thinkblox.furnishing import Generation, Progress
    from thinkblox.plan import Plan


class ObjectBar:
    """A bar per object on a terminal, a plain line elsewhere, nothing when a machine reads along."""

    def __init__(self, *, quiet: bool) -> None:
        self._quiet = quiet
        self._bar: Any = None
        self._attempts = 1

    def __enter__(self) -> "ObjectBar":
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()

    def begin(self, plan: "Plan") -> None:
        """Say at once what the prompt asks for and will not be placed, for there is too much of it."""
        heed_stops()
        if plan.brief.beyond and not self._quiet:
            from thinkblox.reporting import TOO_MANY

            print(f"not placed: {', '.join(plan.brief.beyond)}: {TOO_MANY}", file=sys.stderr)

    def end(self, result: "Generation") -> None:
        """Say which of several attempts the room is."""
        if self._attempts > 1 and not self._quiet:
            if self._bar is not None:
                self._bar.clear()
            print(f"attempt {result.attempt + 1} of {self._attempts} is kept", file=sys.stderr)

    def tell(self, progress: "Progress") -> None:
        """Show one object more; raises KeyboardInterrupt when the command was stopped meanwhile."""
        heed_stops()
        if self._quiet:
            return
        self._attempts = progress.attempt + 1
        outcome = "placed" if progress.placed else "not placed"
        if progress.number == 1 and progress.attempt > 0:
            self._begin_anew(progress)
        if not sys.stderr.isatty():
            print(f"{progress.number}/{progress.total} {progress.target.id} {outcome}", file=sys.stderr)
            return
        from tqdm import tqdm

        if self._bar is None:
            self._bar = tqdm(total=progress.total, unit="object", file=sys.stderr)
        self._bar.total = progress.total
        self._bar.set_description_str(f"{progress.target.id} {outcome}")
        self._bar.update()

    def _begin_anew(self, progress: "Progress") -> None:
        said = f"{progress.anew or 'not all as asked'}; attempt {progress.attempt + 1}, begun anew"
        if self._bar is None:
            print(said, file=sys.stderr)
        else:
            self._bar.write(said, file=sys.stderr)
            self._bar.reset()
