import asyncio
import base64
import io
import logging
import math
import pickle
import traceback

import numpy as np
import pytest
from PIL import Image

from tests.stub_server import Reply, completion, error, stub
from thinkblox.chat import Message
from thinkblox.errors import InputError, NoAnswerError, UnavailableError
from thinkblox.policies.openai_server import PATIENCE, Asking, OpenAiModel

CHAT = (Message("system", ("Be brief.",)), Message("user", ("Where?",)))
KEY = "sk-a-key-that-nobody-may-see"


@pytest.fixture(autouse=True)
def no_key(monkeypatch):
    for name in ("THINKBLOX_API_KEY", "OPENAI_API_KEY", "OPENAI_BASE_URL"):
        monkeypatch.delenv(name, raising=False)


def ask(server, n=1, *, seconds=20.0, retries=0, at_once=8, chat=CHAT):
    model = OpenAiModel(server.url, "stub", asking=Asking(seconds=seconds, retries=retries, at_once=at_once))
    return model.answer(chat, n, np.random.default_rng(0))


def test_a_chat_is_sent_and_its_answer_comes_back():
    with stub(lambda body: "There.") as server:
        assert ask(server) == ["There."]
    (body,) = server.seen
    assert body["model"] == "stub"
    assert body["messages"] == [
        {"role": "system", "content": "Be brief."},
        {"role": "user", "content": "Where?"},
    ]


def test_pictures_are_sent_as_png_between_the_texts():
    picture = Image.new("RGB", (8, 6), (10, 200, 30))
    with stub(lambda body: "Seen.") as server:
        ask(server, chat=(Message("user", ("Look:", picture, "Where?")),))
    kinds = [part["type"] for part in server.seen[0]["messages"][0]["content"]]
    assert kinds == ["text", "image_url", "text"]
    url = server.seen[0]["messages"][0]["content"][1]["image_url"]["url"]
    prefix, _, data = url.partition(",")
    assert prefix == "data:image/png;base64"
    back = Image.open(io.BytesIO(base64.b64decode(data)))
    assert (back.size, back.getpixel((0, 0))) == ((8, 6), (10, 200, 30))


def test_candidates_come_from_one_request_where_the_server_can():
    with stub(lambda body: "Yes.") as server:
        assert ask(server, 5) == ["Yes."] * 5
    assert [body["n"] for body in server.seen] == [5]


def test_candidates_come_from_several_requests_where_it_cannot_with_a_limit():
    def slowly(body):
        return Reply(seconds=0.05, body=completion(["Yes."]).body)

    with stub(slowly, honours_n=False) as server:
        model = OpenAiModel(server.url, "stub", asking=Asking(at_once=3))
        assert model.answer(CHAT, 8, np.random.default_rng(0)) == ["Yes."] * 8
        assert len(server.seen) == 8
        assert 1 < server.busiest <= 3
        assert len({body["seed"] for body in server.seen}) == 8
        assert model.answer(CHAT, 4, np.random.default_rng(0)) == ["Yes."] * 4
        assert "n" not in server.seen[8]


@pytest.mark.parametrize("name", ["n", "seed", "temperature"])
def test_what_a_server_refuses_to_be_told_is_left_out(name):
    with stub(lambda body: "Yes.", refuses=(name,)) as server:
        assert ask(server, 3) == ["Yes."] * 3
    assert name not in server.seen[-1]


def test_the_longest_answer_has_another_name_on_some_servers():
    with stub(lambda body: "Yes.", refuses=("max_tokens",)) as server:
        assert ask(server) == ["Yes."]
    assert server.seen[-1]["max_completion_tokens"] == 4096


@pytest.mark.parametrize("status", [429, 500, 503])
def test_what_fails_for_a_while_is_asked_again(status):
    first = [error(status, "busy", ("Retry-After-Ms", "1"))] * 2
    with stub(lambda body: "There.", first=first) as server:
        assert ask(server, retries=2) == ["There."]
    assert len(server.seen) == 3


@pytest.mark.parametrize(
    ("reply", "kind", "words"),
    [
        (error(401, "Bad key"), UnavailableError, "wants a key .*set THINKBLOX_API_KEY"),
        (error(404, "The model `stub` does not exist"), UnavailableError, "has no model 'stub'.* ends in /v1"),
        (error(429, "quota"), NoAnswerError, "asked too often.*quota.*again later"),
        (error(429, "quota", ("Retry-After", "3600")), NoAnswerError, "again in 3600 s, as it says"),
        (error(429, "quota", ("Retry-After", "sk-1 \x1b")), NoAnswerError, "again later$"),
        (error(500, "CUDA out of memory"), NoAnswerError, "status 500 .CUDA out of memory"),
        (error(400, "maximum context length is 8"), NoAnswerError, "status 400 .*maximum context length"),
        (Reply(status=502, body=b"<html>\x1b[31mBad gateway</html>", kind="text/html"), NoAnswerError, "Bad gateway"),
        (Reply(body=b"<html>Hello</html>", kind="text/html"), NoAnswerError, "did not answer with JSON.*<html>"),
        (Reply(body=b'{"choices": [{"mess'), NoAnswerError, "cannot be read"),
        (Reply(body=b'{"choices": [', missing=500), NoAnswerError, "broke off its answer"),
        (Reply(body=b""), NoAnswerError, "cannot be read|did not answer"),
        (Reply(body=b"null"), NoAnswerError, "JSON"),
        (Reply(body=b"[]"), NoAnswerError, "JSON|no choice"),
        (Reply(body=b"{}"), NoAnswerError, "no choice"),
        (Reply(body=b'{"choices": []}'), NoAnswerError, "no choice"),
        (Reply(body=b'{"choices": "many"}'), NoAnswerError, "no choice"),
        (Reply(body=b'{"error": {"message": "overloaded", "code": 503}}'), NoAnswerError, "with an error: overloaded"),
        (error(400, "image input is not supported"), NoAnswerError, "not supported.*--without pictures"),
        (Reply(body=b'{"choices": [{"message": null}]}'), NoAnswerError, "no text"),
        (Reply(body=b'{"choices": [{"message": {"content": 7}}]}'), NoAnswerError, "no text"),
        (Reply(seconds=3.0), NoAnswerError, "no answer in time"),
        (Reply(body=b" " * 65536, endless=True), NoAnswerError, "more than|in time"),
    ],
    ids=lambda value: value.__name__ if isinstance(value, type) else "",
)
def test_what_goes_wrong_is_named_with_what_to_do(reply, kind, words):
    with stub(lambda body: reply) as server, pytest.raises(kind, match=words) as raised:
        ask(server, seconds=1.0)
    assert server.url in str(raised.value)
    assert "\x1b" not in str(raised.value)


def test_a_server_that_is_not_there_is_named():
    with stub(lambda body: "x") as server:
        pass
    with pytest.raises(UnavailableError, match=r"cannot be reached.*start the server"):
        ask(server)


def test_a_server_that_fails_time_and_again_counts_as_gone():
    with stub(lambda body: error(500, "down")) as server:
        model = OpenAiModel(server.url, "stub", asking=Asking(retries=0))
        for _ in range(PATIENCE - 1):
            with pytest.raises(NoAnswerError):
                model.answer(CHAT, 1, np.random.default_rng(0))
        with pytest.raises(UnavailableError, match=f"{PATIENCE} times in a row"):
            model.answer(CHAT, 1, np.random.default_rng(0))


def test_some_of_several_requests_may_fail():
    replies = iter([completion(["a"]), error(500, "x"), completion(["b"])])
    with stub(lambda body: next(replies), honours_n=False) as server:
        assert len(ask(server, 3, at_once=1)) == 2


def test_reasoning_that_a_server_splits_off_is_put_back():
    answer = completion(["<answer>{}</answer>"], reasoning_content="1. <think>Here.")
    with stub(lambda body: answer) as server:
        assert ask(server) == ["<think>1. Here.</think><answer>{}</answer>"]


def test_of_a_model_that_was_cut_off_while_it_thought_the_thought_stays():
    answer = completion([""], reasoning_content="1. By the wall, or")
    with stub(lambda body: answer) as server:
        assert ask(server) == ["<think>1. By the wall, or"]


TEXT = {"type": "text", "text": "<answer>{}</answer>"}


@pytest.mark.parametrize(
    ("content", "text"),
    [
        ([{"type": "text", "text": "<think>1.</think>"}, TEXT], "<think>1.</think><answer>{}</answer>"),
        (
            [{"type": "thinking", "thinking": [{"type": "text", "text": "1."}]}, TEXT],
            "<think>1.</think>" + TEXT["text"],
        ),
        ([{"type": "thinking", "thinking": "1."}, TEXT], "<think>1.</think>" + TEXT["text"]),
        ([7, {"type": "image"}, {"type": "text", "text": [TEXT]}, {"type": "text"}], ""),
        ([], ""),
    ],
)
def test_an_answer_in_parts_is_their_text(content, text):
    with stub(lambda body: completion([""], content=content)) as server:
        assert ask(server) == [text]


def test_no_content_is_an_empty_text():
    with stub(lambda body: Reply(body=b'{"choices": [{"message": {"role": "assistant", "content": null}}]}')) as server:
        assert ask(server) == [""]


def test_it_can_be_asked_where_an_event_loop_runs():
    async def inside(server):
        return ask(server)

    with stub(lambda body: "There.") as server:
        assert asyncio.run(inside(server)) == ["There."]


@pytest.mark.parametrize("name", ["THINKBLOX_API_KEY", "OPENAI_API_KEY"])
def test_the_key_comes_from_the_environment(monkeypatch, name):
    monkeypatch.setenv(name, f" {KEY}\n")
    with stub(lambda body: "There.") as server:
        ask(server)
    assert server.headers[0]["authorization"] == f"Bearer {KEY}"


def test_the_key_is_in_no_log_no_error_and_no_answer(monkeypatch, caplog):
    monkeypatch.setenv("OPENAI_API_KEY", KEY)
    caplog.set_level(logging.DEBUG)
    told = []
    replies = [
        error(401, f"Incorrect API key provided: {KEY}"),
        error(500, f"headers: Bearer {KEY}"),
        Reply(body=f"<p>{KEY}</p>".encode(), kind="text/html"),
        Reply(body=f'{{"{KEY}'.encode()),
        error(400, KEY),
    ]
    with stub(lambda body: replies.pop(0)) as server:
        model = OpenAiModel(server.url, "stub", asking=Asking(retries=0))
        while replies:
            with pytest.raises(InputError) as raised:
                model.answer(CHAT, 1, np.random.default_rng(0))
            told.append("".join(traceback.format_exception(raised.value)))
    with stub(lambda body: f"My key is {KEY}") as server:
        told += ask(server)
    told += [repr(model), pickle.dumps(model).decode("latin1"), str(vars(model)), caplog.text]
    assert not any(KEY in text for text in told)
    assert "refuses the key in THINKBLOX_API_KEY or OPENAI_API_KEY" in told[0]


@pytest.mark.parametrize("key", ["sk-ä", "two words", "a\nb"])
def test_what_cannot_be_a_key_is_said_without_it(monkeypatch, key):
    monkeypatch.setenv("OPENAI_API_KEY", key)
    with stub(lambda body: "x") as server, pytest.raises(InputError, match="OPENAI_API_KEY holds no key") as raised:
        ask(server)
    assert key not in str(raised.value)
    assert server.seen == []


@pytest.mark.parametrize(
    "url",
    ["", "localhost:8000", "ftp://x", "http://", "http://[", "http://x:port", "file:///etc/passwd", "http://a\nb"],
)
def test_what_is_no_address_is_refused(url):
    with pytest.raises(InputError, match="is not the URL of a server"):
        OpenAiModel(url, "m")


@pytest.mark.parametrize("url", [f"http://me:{KEY}@x/v1", f"http://{KEY}@x/v1", f"https://x/v1?api_key={KEY}"])
def test_a_key_in_an_address_is_refused_and_not_repeated(url):
    with pytest.raises(InputError, match="holds no key") as raised:
        OpenAiModel(url, "m")
    assert KEY not in "".join(traceback.format_exception(raised.value))


def test_a_server_needs_the_name_of_a_model():
    with pytest.raises(InputError, match="which model"):
        OpenAiModel("http://localhost:8000/v1", " ")


def test_probabilities_of_a_first_word_are_added_up():
    likely = {"Yes": math.log(0.5), " yes": math.log(0.2), "No": math.log(0.3)}
    with stub(lambda body: "Yes", logprobs=likely) as server:
        model = OpenAiModel(server.url, "stub")
        assert model.probability(CHAT, "Yes") == pytest.approx(0.7)
        assert model.probability(CHAT, "no") == pytest.approx(0.3)
        assert model.probability(CHAT, "maybe") == 0.0


def test_probabilities_that_are_absent_are_an_error():
    with stub(lambda body: "Yes") as server, pytest.raises(UnavailableError, match=r"no logprobs.*vLLM"):
        OpenAiModel(server.url, "stub").probability(CHAT, "Yes")
