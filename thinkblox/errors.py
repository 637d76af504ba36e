"""The errors this package raises on purpose; all derive from one base, so that a caller can catch them together."""


class ThinkBloxError(Exception):
    """Base of every error raised on purpose; its text is fit to be shown to a user."""


class InputError(ThinkBloxError):
    """An input that cannot be used (prompt, room, file, folder): says what was wrong, where, and what to do."""
