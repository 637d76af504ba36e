"""A small OpenAI-compatible server for tests: it answers as it is told, and remembers what it was asked."""

import json
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

Body = dict[str, Any]
Answering = Callable[[Body], "str | Reply"]


@dataclass(frozen=True)
class Reply:
    """An HTTP response, which may promise more than it sends (`missing`), or send without an end (`endless`)."""

    status: int = 200
    body: bytes = b""
    kind: str = "application/json"
    seconds: float = 0.0
    missing: int = 0
    endless: bool = False
    headers: tuple[tuple[str, str], ...] = ()


@dataclass
class Stub:
    """What the server does and has seen.

    Attributes:
        answering: gives the text, or the whole response, for a request.
        honours_n: whether one request gives n choices.
        logprobs: probabilities of the first token; None where it gives none, as some servers.
        refuses: parameters for which a request is refused with 400.
        first: responses that come before any answer, one each.
    """

    answering: Answering
    url: str = ""
    honours_n: bool = True
    logprobs: dict[str, float] | None = None
    refuses: tuple[str, ...] = ()
    first: list[Reply] = field(default_factory=list)
    seen: list[Body] = field(default_factory=list)
    headers: list[dict[str, str]] = field(default_factory=list)
    busy: int = 0
    busiest: int = 0

    @property
    def spec(self) -> str:
        return f"openai:{self.url}#stub"

    def reply(self, body: Body) -> Reply:
        if self.first:
            return self.first.pop(0)
        if named := next((name for name in self.refuses if name in body), None):
            return error(400, f"Unsupported parameter: '{named}' is not supported with this model.")
        texts = []
        for _ in range(body.get("n", 1) if self.honours_n else 1):
            said = self.answering(body)
            if isinstance(said, Reply):
                return said
            texts.append(said)
        return completion(texts, self._logprobs(body))

    def _logprobs(self, body: Body) -> Body | None:
        if self.logprobs is None or not body.get("logprobs"):
            return None
        likely = [{"token": t, "logprob": p, "bytes": None} for t, p in self.logprobs.items()]
        return {"content": [{**likely[0], "top_logprobs": likely}], "refusal": None}


def completion(texts: list[str], logprobs: Body | None = None, **message: object) -> Reply:
    choices = [
        {
            "index": i,
            "message": {"role": "assistant", "content": t, **message},
            "finish_reason": "stop",
            "logprobs": logprobs,
        }
        for i, t in enumerate(texts)
    ]
    made = {"id": "c", "object": "chat.completion", "created": 0, "model": "stub", "choices": choices}
    return Reply(body=json.dumps(made).encode())


def error(status: int, message: str, *headers: tuple[str, str]) -> Reply:
    body = {"error": {"message": message, "type": "error", "param": None, "code": None}}
    return Reply(status=status, body=json.dumps(body).encode(), headers=headers)


@contextmanager
def stub(answering: Answering, **settings: Any) -> Iterator[Stub]:
    made = Stub(answering, **settings)
    lock = threading.Lock()

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            with lock:
                made.seen.append(body)
                made.headers.append({name.lower(): value for name, value in self.headers.items()})
                made.busy += 1
                made.busiest = max(made.busiest, made.busy)
            try:
                self._send(made.reply(body))
            except (BrokenPipeError, ConnectionResetError):
                pass  # the client has had enough
            finally:
                with lock:
                    made.busy -= 1

        def _send(self, reply: Reply) -> None:
            time.sleep(reply.seconds)
            self.send_response(reply.status)
            self.send_header("Content-Type", reply.kind)
            for name, value in reply.headers:
                self.send_header(name, value)
            if not reply.endless:
                self.send_header("Content-Length", str(len(reply.body) + reply.missing))
            self.end_headers()
            self.wfile.write(reply.body)
            while reply.endless:
                self.wfile.write(reply.body)
            self.close_connection = reply.missing > 0

        def log_message(self, *_: object) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever, daemon=True).start()
    made.url = f"http://127.0.0.1:{server.server_address[1]}/v1"
    try:
        yield made
    finally:
        server.shutdown()
        server.server_close()
