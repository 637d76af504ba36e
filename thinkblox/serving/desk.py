"""What the tools work on: the rooms of one session by their handles, and the root of all files."""

from thinkblox.assets.source import AssetSource, ProceduralAssets
from thinkblox.errors import InputError
from thinkblox.serving.room import AgentRoom
from thinkblox.serving.root import Root

MOST_ROOMS = 16
"""Most rooms of one session that are open at a time."""


class Desk:
    """The rooms of one session.

    Attributes:
        root: where files are read and written.
        source: where assets come from.
        rooms: by handle.
    """

    def __init__(self, root: Root, source: AssetSource | None = None) -> None:
        self.root = root
        self.source = source or ProceduralAssets()
        self.rooms: dict[str, AgentRoom] = {}
        self._count = 0

    def room(self, handle: str) -> AgentRoom:
        """The room of a handle; raises InputError with those that there are."""
        if handle not in self.rooms:
            there = ", ".join(self.rooms) or "none: start_room begins one, open_room reads one"
            raise InputError(f"there is no room {handle[:80]!r}; open are {there}")
        return self.rooms[handle]

    def check_space(self) -> None:
        """Raise InputError where no room more can be opened."""
        if len(self.rooms) >= MOST_ROOMS:
            raise InputError(f"{MOST_ROOMS} rooms are open, which is the most; save one and close it with close_room")

    def add(self, room: AgentRoom) -> str:
        """Take a room in; returns its handle, which no other room of the session ever has."""
        self.check_space()
        self._count += 1
        handle = f"room_{self._count}"
        self.rooms[handle] = room
        return handle
