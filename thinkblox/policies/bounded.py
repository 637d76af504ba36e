"""Responses of servers that are read only as far as an answer can be long."""

from collections.abc import AsyncIterator, Callable
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from httpx2 import AsyncByteStream, Response

MAX_ANSWER = 32_000_000
"""Longest response that is read [bytes]."""


class TooLongError(Exception):
    """A response is longer than any that is read."""


async def bound(response: "Response") -> None:
    """A hook for the client: nothing of a response is read beyond MAX_ANSWER."""
    from httpx2 import AsyncByteStream

    if isinstance(response.stream, AsyncByteStream):
        response.stream = _bounded_stream()(response.stream)


@cache
def _bounded_stream() -> "Callable[[AsyncByteStream], AsyncByteStream]":
    """The class of a stream that ends in an error when it has given too much; the client asks for one of its own."""
    from httpx2 import AsyncByteStream

    class Bounded(AsyncByteStream):
        def __init__(self, stream: AsyncByteStream) -> None:
            self._stream = stream

        async def __aiter__(self) -> AsyncIterator[bytes]:
            read = 0
            async for part in self._stream:
                read += len(part)
                if read > MAX_ANSWER:
                    raise TooLongError(f"sent more than {MAX_ANSWER} bytes in answer to one request")
                yield part

        async def aclose(self) -> None:
            await self._stream.aclose()

    return Bounded
