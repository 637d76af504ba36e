"""What was measured of each room, in a file for each, so that a run that was stopped goes on."""

import os
from pathlib import Path

from thinkblox.errors import InputError
from thinkblox.evaluation.room_tally import RoomTally
from thinkblox.holding import note_placed, placed, signals_held
from thinkblox.value import from_json, to_json


class KeptRooms:
    """A folder of what was measured. It is made with the first room: before that nothing on the disk is changed."""

    def __init__(self, folder: Path, *, anew: bool = False) -> None:
        """Keep rooms in a folder; with `anew` those of earlier runs are not read, and go when the first is kept.

        Raises:
            InputError: something else has that name.
        """
        if os.path.lexists(folder) and not folder.is_dir():
            raise InputError(f"{folder}: exists and is not a folder; choose another name")
        self._folder = folder
        self._stale = anew

    def read(self, name: str) -> RoomTally | None:
        """What was measured of a room before; None where there is nothing that can be read."""
        file = self._folder / f"{name}.json"
        if self._stale or not file.is_file():
            return None
        try:
            return from_json(file.read_bytes(), RoomTally)
        except InputError:
            return None

    def keep(self, name: str, tally: RoomTally) -> None:
        """Write what was measured of a room; raises InputError."""
        file = self._folder / f"{name}.json"
        draft = file.with_suffix(".draft")
        try:
            with signals_held():
                self._make()
                draft.write_bytes(to_json(tally))
                draft.replace(file)
                if self._folder not in placed():
                    note_placed(self._folder)
        except OSError as error:
            raise InputError(f"{file}: cannot be written: {error.strerror}") from error

    def _make(self) -> None:
        self._folder.mkdir(parents=True, exist_ok=True)
        for file in self._folder.glob("*.json") if self._stale else ():
            file.unlink()
        self._stale = False
