"""What `guarded` and its fence say to each other, pickled."""

from typing import Any, Literal, NamedTuple


class Call(NamedTuple):
    """What a fence is to do.

    Attributes:
        function: it and its arguments, pickled by themselves: reading them loads modules, which is to happen within.
        memory: address space that it may use [bytes]; None for no limit.
        main: where the caller's main module is, if the function lives there, as multiprocessing.spawn.prepare takes it.
    """

    function: bytes
    memory: int | None
    main: dict[str, str]


class Outcome(NamedTuple):
    """What a fence says: that all is loaded and the function begins, and then what it returned or raised."""

    kind: Literal["started", "done", "failed", "out of memory"]
    value: Any = None
