"""What is shown while objects are placed."""

import sys
from typing import TYPE_CHECKING, Any

from thinkblox.cli.stopping import heed_stops

if TYPE_CHECKING:
    from thinkblox.episode import Round
    from thinkblox.furnishing import Generation, Progress
    from thinkblox.plan import Plan


LONG = 5.0
"""A round of answers that took longer is told when it was of no use [s]."""


class ObjectBar:
    """A bar per object on a terminal, a plain line elsewhere, nothing when a machine reads along."""

    def __init__(self, *, quiet: bool, reads: bool = False, places: bool = False) -> None:
        """Begin; `reads` and `places` say what a model does, which takes its time."""
        self._quiet = quiet
        self._reads, self._places = reads, places
        self._bar: Any = None
        self._attempts = 1

    def __enter__(self) -> "ObjectBar":
        if self._reads:
            self._say("the model is asked what belongs into the room")
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()

    def begin(self, plan: "Plan") -> None:
        """Say at once what the prompt asks for and will not be placed, for there is too much of it."""
        heed_stops()
        if plan.brief.beyond:
            from thinkblox.reporting import TOO_MANY

            self._say(f"not placed: {', '.join(plan.brief.beyond)}: {TOO_MANY}")
        if self._places:
            count = len(plan.targets)
            self._say(f"{count} object{'' if count == 1 else 's'} planned; the model is asked where each goes")

    def hear(self, done: "Round") -> None:
        """Tell of a round that took long and was of no use; raises KeyboardInterrupt as `tell`."""
        heed_stops()
        if done.kind == "policy" and done.chosen is None and done.propose_seconds > LONG:
            from thinkblox.printing import no_use

            self._say(no_use(done))

    def end(self, result: "Generation") -> None:
        """Say which of several attempts the room is."""
        if self._attempts > 1:
            if self._bar is not None:
                self._bar.clear()
            self._say(f"attempt {result.attempt + 1} of {self._attempts} is kept")

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
        self._say(f"{progress.anew or 'not all as asked'}; attempt {progress.attempt + 1}, begun anew")
        if self._bar is not None:
            self._bar.reset()

    def _say(self, line: str) -> None:
        if self._quiet:
            return
        if self._bar is None:
            print(line, file=sys.stderr)
        else:
            self._bar.write(line, file=sys.stderr)
