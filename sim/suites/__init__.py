"""Suites of published criteria, each named after its source, on any subject."""

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING

from thinkblox.errors import InputError

if TYPE_CHECKING:
    from thinkblox.sim.subject import Subject
    from thinkblox.suite import SuiteResult

SUITES: tuple[str, ...] = ("molmospaces", "litereality", "scenesmith", "sceneeval", "sceneeval_sim")


def run_suite(name: str, subject: "Subject", *, seed: int = 0) -> "SuiteResult":
    """Measure a subject by one source's criteria.

    Args:
        name: one of SUITES.
        subject: it is left as it is: what a suite changes, it changes in a copy.
        seed: of whatever the suite samples or displaces at random.

    Raises:
        InputError: there is no suite of that name.
    """
    if name not in SUITES:
        raise InputError(f"there is no suite {name!r}; there are {', '.join(SUITES)}")
    from thinkblox.sim.quiet import quiet_engine
    from thinkblox.sim.suites.usable import unusable
    from thinkblox.suite import SuiteResult

    module = import_module(f"thinkblox.sim.suites.{name}")
    refused = unusable(subject)
    if refused is not None:
        return SuiteResult(suite=name, source=module.SOURCE, passed=False, criteria=(refused,))
    run: Callable[..., SuiteResult] = module.run
    with quiet_engine():
        return run(subject, seed=seed)
