"""What a command prints, so that an output that cannot be written is told from every other fault."""

import contextlib
import io
import os
import sys
from collections.abc import Iterator
from typing import TextIO


class UnwrittenError(Exception):
    """The output could not be written.

    Attributes:
        unread: nobody was there to read it, as behind `| head`.
        why: in the system's words.
    """

    def __init__(self, error: OSError) -> None:
        super().__init__(str(error))
        self.unread = isinstance(error, BrokenPipeError)
        self.why = error.strerror


class _Output(io.TextIOBase):
    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        try:
            return self._stream.write(text)
        except OSError as error:
            raise UnwrittenError(error) from error

    def flush(self) -> None:
        try:
            self._stream.flush()
        except OSError as error:
            raise UnwrittenError(error) from error


@contextlib.contextmanager
def written_output() -> Iterator[None]:
    """All that is printed meanwhile is written out by the end; raises UnwrittenError."""
    with open(os.devnull, "w") as nowhere:  # noqa: PTH123 (a process may have been started without an output)
        stream = sys.stdout or nowhere
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # a file may have a name that is no text
        try:
            with contextlib.redirect_stdout(_Output(stream)):
                yield
                sys.stdout.flush()
        except UnwrittenError:
            # The last flush at exit must not fail too.
            with contextlib.suppress(OSError, ValueError):
                os.dup2(nowhere.fileno(), stream.fileno())
            raise
