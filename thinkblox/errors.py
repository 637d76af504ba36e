"""The errors this package raises on purpose; all derive from one base, so that a caller can catch them together."""


class ThinkBloxError(Exception):
    """Base of every error raised on purpose; its text is fit to be shown to a user."""


class InputError(ThinkBloxError):
    """An input that cannot be used (prompt, room, file, folder): says what was wrong, where, and what to do."""


class NoAnswerError(InputError):
    """A model was asked and did not answer, or not with a text; it may answer the next time."""


class UnavailableError(InputError):
    """Whoever plays a role cannot play it at all: a server is gone or refuses the key, a trace has another room in it.

    A room that was begun is broken off, and what was tried until then is kept.
    """
