"""Instructions as orders."""

from thinkblox.editing.reading.instruction import MAX_INSTRUCTION, read_instruction

__all__ = ["MAX_INSTRUCTION", "read_instruction"]
