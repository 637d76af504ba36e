"""What went wrong between a server and us, in words that say what to do."""

import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from thinkblox.errors import InputError, NoAnswerError, UnavailableError
from thinkblox.policies.bounded import TooLongError
from thinkblox.policies.keys import VARIABLES

if TYPE_CHECKING:
    import openai

_NAMES = " or ".join(VARIABLES)
_SEEING = re.compile(r"image|vision|visual|multi-?modal", re.IGNORECASE)
"""How a server speaks of the pictures that a model cannot take."""


class NotAnAnswerError(Exception):
    """What came is no chat completion; the text says what it is."""


def error_of(found: Exception, where: str, model: str, show: Callable[[str], str], *, has_key: bool) -> InputError:
    """The error for a user.

    Args:
        found: what the client raised.
        where: the server's URL.
        model: its name there.
        show: makes what the server said fit to be shown.
        has_key: whether a key was sent.
    """
    import httpx2
    import openai

    if isinstance(found, openai.APIStatusError):
        return _refused(found, where, model, show(_words(found)), has_key=has_key)
    if isinstance(found, TimeoutError | openai.APITimeoutError):
        return NoAnswerError(f"{where}: gave no answer in time; see whether the server is overloaded")
    if isinstance(found, openai.APIConnectionError):
        why = show(str(found.__cause__ or found))
        if isinstance(found.__cause__, httpx2.ReadError | httpx2.RemoteProtocolError | httpx2.WriteError):
            return NoAnswerError(f"{where}: broke off its answer ({why}); see its log")
        return UnavailableError(f"{where}: cannot be reached ({why}); start the server, or mend its URL")
    if isinstance(found, TooLongError | NotAnAnswerError):
        return NoAnswerError(f"{where}: {show(str(found))}; see whether this is the URL of an OpenAI-compatible server")
    return NoAnswerError(f"{where}: answered with what cannot be read ({type(found).__name__}: {show(str(found))})")


def _refused(found: "openai.APIStatusError", where: str, model: str, said: str, *, has_key: bool) -> InputError:
    match found.status_code:
        case 401 | 403 if has_key:
            return UnavailableError(f"{where}: refuses the key in {_NAMES} ({said}); set one that it knows")
        case 401 | 403:
            return UnavailableError(f"{where}: wants a key ({said}); set {_NAMES}")
        case 404:
            return UnavailableError(
                f"{where}: has no model {model!r}, or nothing at this URL ({said}); see its list of models, and whether"
                " its URL ends in /v1"
            )
        case 429:
            wait = found.response.headers.get("retry-after", "")
            later = f"in {wait} s, as it says" if wait.isdecimal() and wait.isascii() else "later"
            return NoAnswerError(f"{where}: was asked too often, or more than is paid for ({said}); try again {later}")
        case status if status >= 500:
            return NoAnswerError(f"{where}: failed with status {status} ({said}); see its log")
        case status if _SEEING.search(said):
            return NoAnswerError(
                f"{where}: refused the request with status {status} ({said}); a model that cannot see is asked with"
                " --without pictures"
            )
        case status:
            return NoAnswerError(f"{where}: refused the request with status {status} ({said})")


def _words(found: "openai.APIStatusError") -> str:
    body = found.body
    inner = body.get("error", body) if isinstance(body, dict) else body
    message = inner.get("message") if isinstance(inner, dict) else inner
    return str(message or found.message)
