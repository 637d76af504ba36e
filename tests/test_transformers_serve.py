import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from thinkblox.chat import Message
from thinkblox.errors import UnavailableError
from thinkblox.generate import generate_room
from thinkblox.placing import Effort
from thinkblox.policies.model import ModelPolicy
from thinkblox.policies.openai_server import Asking, OpenAiModel

pytestmark = pytest.mark.slow
for needed in ("fastapi", "uvicorn"):
    pytest.importorskip(needed, reason="transformers serve needs it")

SERVE = """
import sys
from thinkblox.policies.processors import use_without_torchvision
use_without_torchvision()
from transformers.cli.transformers import main
sys.argv = ["transformers", "serve", sys.argv[1], "--device", "cpu", "--port", sys.argv[2]]
main()
"""
PATIENCE = 120.0


@pytest.fixture(scope="module")
def model(tiny_folder):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [sys.executable, "-c", SERVE, str(tiny_folder), str(port)]
    running = subprocess.Popen(command, cwd=Path(__file__).parents[1])
    try:
        _wait_for(f"http://localhost:{port}/health", running)
        asking = Asking(tokens=48, retries=1, seconds=120.0)
        yield OpenAiModel(f"http://localhost:{port}/v1", str(tiny_folder), asking=asking)
    finally:
        running.terminate()
        running.wait(30)


def _wait_for(url, running):
    for _ in range(int(PATIENCE * 2)):
        assert running.poll() is None, "the server did not start"
        try:
            urllib.request.urlopen(url, timeout=5).close()
            return
        except OSError:
            time.sleep(0.5)
    raise AssertionError("the server did not answer")


def test_candidates_come_though_it_knows_no_n(model):
    chat = (Message("user", ("Look:", Image.new("RGB", (56, 56)), "Where?")),)
    texts = model.answer(chat, 3, np.random.default_rng(0))
    assert len(texts) == 3
    assert all(isinstance(text, str) for text in texts)


def test_it_gives_no_probabilities_and_that_is_said(model):
    with pytest.raises(UnavailableError, match="gives no logprobs"):
        model.probability((Message("user", ("Yes or no?",)),), "Yes")


def test_a_room_is_furnished_whatever_it_answers(model):
    effort = Effort(candidates=1, rounds=2, restarts=0)
    result = generate_room("A room with two chairs.", policy=ModelPolicy(model), effort=effort)
    tried = [t for r in result.trace if r.kind == "policy" for t in r.tries]
    assert len(tried) >= 2
    assert all(t.valid or t.rejection or t.verdict for t in tried)
    assert {p.category for p in result.scene.placements} >= {"chair"}
