"""Changing a finished room by instructions: read, found in the room, carried out, measured, and kept as a history."""

from thinkblox.editing.edit import Changed, Edit, edit_room, undo_edit

__all__ = ["Changed", "Edit", "edit_room", "undo_edit"]
