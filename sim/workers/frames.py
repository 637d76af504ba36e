"""Messages on a socket between a process and its child: each in a frame that begins with its length."""

import socket
import struct
import time

_LENGTH = struct.Struct("!Q")


def send_frame(channel: socket.socket, message: bytes, *, until: float | None = None) -> None:
    """Send a message; raises TimeoutError at the monotonic time `until` [s], another OSError when nobody listens."""
    channel.settimeout(left(until))
    channel.sendall(_LENGTH.pack(len(message)) + message)


def receive_frame(channel: socket.socket, *, until: float | None = None) -> bytes:
    """The next message; raises TimeoutError at the monotonic time `until` [s], EOFError when nobody sends any more."""
    (length,) = _LENGTH.unpack(_receive(channel, _LENGTH.size, until))
    return bytes(_receive(channel, length, until))


def left(until: float | None) -> float | None:
    """Seconds until a monotonic time; never none at all, as what has arrived is taken even when it is late."""
    return None if until is None else max(0.001, until - time.monotonic())


def _receive(channel: socket.socket, length: int, until: float | None) -> bytearray:
    data = bytearray(length)
    view = memoryview(data)
    while view:
        channel.settimeout(left(until))
        count = channel.recv_into(view)
        if not count:
            raise EOFError
        view = view[count:]
    return data
