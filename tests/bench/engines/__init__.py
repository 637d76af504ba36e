"""Exported rooms in other engines: what each makes of them, by a driver in a virtual environment of its own."""
