"""A model behind any OpenAI-compatible server: vLLM, SGLang, llama.cpp, transformers serve, or a hosted one."""

import asyncio
import base64
import math
import re
from collections.abc import AsyncIterator, Coroutine, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar
from urllib.parse import urlsplit

import numpy as np

from thinkblox.chat import Chat, Message
from thinkblox.errors import InputError, NoAnswerError, UnavailableError
from thinkblox.png import png_of
from thinkblox.policies.keys import hidden, key_from, shown

if TYPE_CHECKING:
    from openai import AsyncOpenAI
    from openai.types.chat.chat_completion import Choice
    from PIL.Image import Image

PATIENCE = 3
"""After so many requests in a row without an answer a server counts as gone."""
TOP = 20
"""Tokens whose probabilities are asked for: what servers give at most."""
_OPTIONAL: tuple[str, ...] = ("n", "seed", "temperature", "max_tokens", "max_completion_tokens")
"""What is left out for a server that refuses it."""

R = TypeVar("R")


@dataclass(frozen=True)
class Asking:
    """How a server is asked.

    Attributes:
        temperature: of the samples; None for the server's own.
        tokens: longest answer [tokens].
        seconds: longest wait for one answer, retries included [s].
        retries: how often a request is repeated that failed for a while (429, 5xx, no connection), backing off.
        at_once: most requests under way together.
    """

    temperature: float | None = 0.7
    tokens: int = 4096
    seconds: float = 300.0
    retries: int = 4
    at_once: int = 8


class OpenAiModel:
    """Continues chats by asking a server; the key comes from the environment each time, and is kept nowhere."""

    def __init__(self, base_url: str, model: str, *, asking: Asking | None = None) -> None:
        """Check the address; nothing is asked yet.

        Raises:
            InputError: the URL or the model's name cannot be used, or the client is not installed.
        """
        _check_installed()
        self._url = _checked_url(base_url)
        if not model.strip() or not model.isprintable():
            raise InputError(f"{self._url}: which model? Write its name behind a #, as in {self._url}#qwen3-vl")
        self._model = model.strip()
        self._asking = asking or Asking()
        self._left_out: set[str] = set()
        self._failures = 0

    def __repr__(self) -> str:
        return f"OpenAiModel({self._url!r}, {self._model!r})"

    def answer(self, chat: Chat, n: int, rng: np.random.Generator) -> list[str]:
        """Up to `n` answers, sampled apart.

        Raises:
            UnavailableError: the server is not there, refuses the key or the model, or fails time and again.
            NoAnswerError: it failed this time.
        """
        key, seed = key_from(), int(rng.integers(2**31))
        choices = self._asked(self._sampled(key, _messages(chat), n, seed), key)
        return [hidden(_text(choice), key) for choice in choices[:n]]

    def probability(self, chat: Chat, word: str) -> float:
        """How likely the first token of the answer is `word`, whatever its case; 0 where it is not among the likeliest.

        Raises:
            UnavailableError: as for `answer`, or the server gives no probabilities.
            NoAnswerError: it failed this time.
        """
        key = key_from()
        return self._likelihood(self._asked(self._single(key, _first_token(chat)), key), word)

    def probabilities(self, chats: Sequence[Chat], word: str) -> list[float | None]:
        """`probability` for many chats, asked together; None where the server failed for one.

        It takes at most `Asking.seconds` for every `Asking.at_once` chats.

        Raises:
            UnavailableError: as for `probability`, or all chats failed, time and again.
        """
        key = key_from()
        found = _run(self._together(key, [_first_token(chat) for chat in chats]))
        failures = [self._error(each, key) for each in found if isinstance(each, Exception)]
        gone = next((each for each in failures if not isinstance(each, NoAnswerError)), None)
        if gone is not None:
            raise gone
        self._failures = self._failures + 1 if chats and len(failures) == len(chats) else 0
        if self._failures >= PATIENCE:
            raise UnavailableError(
                f"{failures[-1]}; that was so for all of {len(chats)}, {self._failures} times in a row"
            )
        return [None if isinstance(each, BaseException) else self._likelihood(each, word) for each in found]

    def _likelihood(self, choices: "list[Choice]", word: str) -> float:
        logprobs = choices[0].logprobs
        if logprobs is None or not logprobs.content or not logprobs.content[0].top_logprobs:
            raise UnavailableError(
                f"{self._url}: gives no logprobs for {self._model}, which are needed here; vLLM, SGLang and llama.cpp"
                " give them, `transformers serve` does not"
            )
        likely = logprobs.content[0].top_logprobs
        return min(1.0, sum(math.exp(t.logprob) for t in likely if t.token.strip().lower() == word.strip().lower()))

    def _asked(self, asking: "Coroutine[Any, Any, list[Choice]]", key: str) -> "list[Choice]":
        try:
            choices = _run(asking)
        except InputError:
            raise
        except Exception as error:
            # Neither its text nor what it came from is passed on: there may be a key in them.
            raise self._failure(error, key) from None
        self._failures = 0
        return choices

    def _failure(self, error: Exception, key: str) -> InputError:
        found = self._error(error, key)
        self._failures += 1
        if isinstance(found, NoAnswerError) and self._failures >= PATIENCE:
            return UnavailableError(f"{found}; that was so {self._failures} times in a row")
        return found

    def _error(self, error: Exception, key: str) -> InputError:
        from thinkblox.policies.server_errors import error_of

        if isinstance(error, InputError):
            return error
        return error_of(error, self._url, self._model, lambda text: shown(text, key), has_key=bool(key))

    async def _sampled(self, key: str, messages: list[dict[str, Any]], n: int, seed: int) -> "list[Choice]":
        """As many answers as the server gives in one go, and the others one by one."""
        common = {"messages": messages, "temperature": self._asking.temperature, "max_tokens": self._asking.tokens}
        async with self._client(key) as client:
            choices: list[Choice] = []
            if "n" not in self._left_out:
                choices = await self._choices(client, {**common, "n": n, "seed": seed} if n > 1 else common)
                if len(choices) < n:
                    self._left_out.add("n")
            gate = asyncio.Semaphore(self._asking.at_once)

            async def one(number: int) -> "list[Choice]":
                async with gate:
                    return await self._choices(client, {**common, "seed": (seed + number) % 2**31})

            rest = await asyncio.gather(*map(one, range(len(choices), n)), return_exceptions=True)
        choices += [choice for part in rest if not isinstance(part, BaseException) for choice in part[:1]]
        failed = next((part for part in rest if isinstance(part, BaseException)), None)
        if failed is not None and not choices:
            raise failed
        return choices

    async def _single(self, key: str, body: dict[str, Any]) -> "list[Choice]":
        async with self._client(key) as client:
            return await self._choices(client, body)

    async def _together(self, key: str, bodies: Sequence[dict[str, Any]]) -> "list[list[Choice] | BaseException]":
        gate = asyncio.Semaphore(self._asking.at_once)
        async with self._client(key) as client:

            async def one(body: dict[str, Any]) -> "list[Choice]":
                async with gate:
                    return await self._choices(client, body)

            return await asyncio.gather(*map(one, bodies), return_exceptions=True)

    @asynccontextmanager
    async def _client(self, key: str) -> "AsyncIterator[AsyncOpenAI]":
        from openai import AsyncOpenAI, DefaultAsyncHttpxClient

        from thinkblox.policies.bounded import bound

        http = DefaultAsyncHttpxClient(event_hooks={"response": [bound]})
        async with AsyncOpenAI(
            base_url=self._url,
            api_key=key or "none",
            timeout=self._asking.seconds,
            max_retries=self._asking.retries,
            http_client=http,
        ) as client:
            yield client

    async def _choices(self, client: "AsyncOpenAI", body: dict[str, Any]) -> "list[Choice]":
        """The choices of one request, without what the server refuses to be told."""
        import openai

        async with asyncio.timeout(self._asking.seconds):
            while True:
                body = self._accepted(body)
                try:
                    made: Any = await client.chat.completions.create(model=self._model, **body)
                    return _checked_choices(made)
                except (openai.BadRequestError, openai.UnprocessableEntityError) as error:
                    refused = _refused(error, body)
                    if refused is None:
                        raise
                    self._left_out.add(refused)

    def _accepted(self, body: dict[str, Any]) -> dict[str, Any]:
        """A request without what was refused; one name for the longest answer stands in for the other."""
        kept = {k: v for k, v in body.items() if v is not None and k not in self._left_out}
        if "max_tokens" in body and "max_tokens" in self._left_out and "max_completion_tokens" not in self._left_out:
            kept["max_completion_tokens"] = body["max_tokens"]
        return kept


def _first_token(chat: Chat) -> dict[str, Any]:
    """A request for the likeliest first tokens of an answer."""
    body = {"max_tokens": 1, "temperature": 0.0, "logprobs": True, "top_logprobs": TOP}
    return {"messages": _messages(chat), **body}


def _run(asking: Coroutine[Any, Any, R]) -> R:
    """Run it to its end, also where an event loop runs already, as in a notebook."""
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return asyncio.run(asking)
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(asyncio.run, asking).result()


def _check_installed() -> None:
    try:
        import openai  # noqa: F401 (whether it is there)
    except ImportError:
        raise InputError("the client for servers is not installed; pip install 'thinkblox[openai]'") from None


def _checked_url(url: str) -> str:
    """The address of a server; raises InputError, and does not repeat what may be a key."""
    try:
        parts = urlsplit(url.strip())
        host, _ = parts.hostname, parts.port
    except ValueError:
        host, parts = None, urlsplit("")
    if parts.username is not None or parts.password is not None or parts.query:
        raise InputError("the URL of a server holds no key, password or query; set THINKBLOX_API_KEY instead")
    if parts.scheme not in ("http", "https") or not host or not url.isprintable():
        raise InputError(f"{url[:200]!r} is not the URL of a server; one is http://localhost:8000/v1")
    return url.strip().rstrip("/")


def _messages(chat: Chat) -> list[dict[str, Any]]:
    return [{"role": message.speaker, "content": _content(message)} for message in chat]


def _content(message: Message) -> str | list[dict[str, Any]]:
    if not message.images:
        return message.text
    return list(_parts(message.parts))


def _parts(parts: "Sequence[str | Image]") -> Iterator[dict[str, Any]]:
    for part in parts:
        if isinstance(part, str):
            yield {"type": "text", "text": part}
        else:
            data = base64.b64encode(png_of(part)).decode()
            yield {"type": "image_url", "image_url": {"url": f"data:image/png;base64,{data}"}}


def _checked_choices(made: Any) -> "list[Choice]":
    """The choices of what a server sent, which the client takes on trust."""
    from openai.types.chat import ChatCompletion

    from thinkblox.policies.server_errors import NotAnAnswerError

    if not isinstance(made, ChatCompletion):
        raise NotAnAnswerError(f"did not answer with JSON, but with {str(made)[:80]!r}")
    completion: ChatCompletion = made
    choices: Any = completion.choices
    if not isinstance(choices, list) or not choices:
        fault = (completion.model_extra or {}).get("error")
        says = fault.get("message") if isinstance(fault, dict) else fault
        raise NotAnAnswerError(f"answered with an error: {says}" if says else "answered with no choice at all")
    if not all(isinstance(getattr(getattr(c, "message", None), "content", 0), str | list | None) for c in choices):
        raise NotAnAnswerError("answered with choices that hold no text")
    return list(choices)


def _text(choice: "Choice") -> str:
    """What a model said; where a server has split its reasoning off, it is put back in its tags.

    They stay open where nothing came after it, as of a model that was cut off while it thought.
    """
    content, extra = choice.message.content, choice.message.model_extra or {}
    said = _joined(content, "text") or getattr(choice.message, "refusal", None) or ""
    thought = extra.get("reasoning_content") or extra.get("reasoning") or _joined(content, "thinking")
    if not isinstance(thought, str) or not thought or "<think>" in said or ("<answer>" not in said and said.strip()):
        return said
    thought = re.sub("</?(think|answer)>", "", thought)
    return f"<think>{thought}</think>{said}" if said.strip() else f"<think>{thought}"


def _joined(content: object, kind: str) -> str:
    """The text of a message's content, or that of its parts of a kind; thinking may be in parts of text itself."""
    if isinstance(content, str):
        return content if kind == "text" else ""
    parts = [part for part in content if isinstance(part, dict)] if isinstance(content, list) else []
    held = [part.get(kind) for part in parts if part.get("type") == kind]
    return "".join(each if isinstance(each, str) else "" if kind == "text" else _joined(each, "text") for each in held)


def _refused(error: Any, body: dict[str, Any]) -> str | None:
    """Which optional part of a request a server does not take; None where it is none of them."""
    told = [name for name in _OPTIONAL if name in body]
    words = str(error)
    named = (n for n in told if error.param == n or (len(n) > 1 and re.search(rf"(?<![a-z_]){n}(?![a-z_])", words)))
    return next(named, "n" if "n" in told and body["n"] > 1 else None)
