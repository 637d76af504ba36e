import json
import signal
import subprocess
import sys
from contextlib import asynccontextmanager
from pathlib import Path

import anyio
import pytest

from thinkblox.cli import main
from thinkblox.episode import read_episode
from thinkblox.generate import generate_room
from thinkblox.scene.scene import load_scene
from thinkblox.serving.tools import TOOLS

mcp = pytest.importorskip("mcp")

FIVE = "An empty study of 4 m by 4 m with a desk, a chair at the desk, a lamp on the desk, a bookshelf and a rug."
HOME = Path(__file__).parent.parent
COMMAND = ("-m", "thinkblox", "mcp", "--root")
HELLO = {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}}


@asynccontextmanager
async def served(root: Path):
    """A client of a server in a process of its own, and a function that calls a tool there."""
    server = mcp.StdioServerParameters(
        command=sys.executable, args=[*COMMAND, str(root)], cwd=Path(__file__).parent.parent
    )
    async with mcp.Client(server, mode="legacy") as client:

        async def call(name, *, error=False, **arguments):
            result = await client.call_tool(name, arguments)
            assert result.is_error == error, result.content
            return result

        yield client, call


def test_an_agent_furnishes_a_room_from_end_to_end(tmp_path):
    made = generate_room(FIVE, seed=4, fill="named")
    said = {r.id: r.tries[r.chosen].text for r in made.trace if r.kept and r.kind == "policy" and r.chosen is not None}
    assert len(said) == 5

    async def agent():
        async with served(tmp_path) as (client, call):
            listed = await client.list_tools()
            assert [tool.name for tool in listed.tools] == list(TOOLS)
            begun = await call("start_room", prompt=FIVE, seed=4)
            handle, next_id = begun.structured_content["room"], begun.structured_content["next"]
            assert "<answer>" in begun.content[0].text
            seen = []
            while next_id:
                shown = await call("observe", room=handle, size=96)
                seen.append([part.type for part in shown.content])
                assert json.dumps(next_id) in shown.content[0].text
                done = await call("answer", room=handle, text=said[next_id])
                assert done.structured_content["done"], done.structured_content
                next_id = done.structured_content["next"]
            assert seen == [["text"] + 4 * ["text", "image"]] * 5
            verified = await call("verify", room=handle)
            assert verified.structured_content["complete"]
            picture = await call("render", room=handle, size=128)
            assert picture.content[1].mime_type == "image/png"
            saved = await call("save", room=handle, folder="rooms/study", pictures=False)
            assert "trace.jsonl" in saved.structured_content["files"]

    anyio.run(agent)
    home = tmp_path / "rooms" / "study"
    assert {p.id: p.position for p in load_scene(home).placements} == {p.id: p.position for p in made.scene.placements}
    assert json.loads((home / "report.json").read_bytes())["complete"]
    episode = read_episode(home)
    assert episode.scene == load_scene(home)
    assert [d.round.tries[0].text for d in episode.decisions()] == list(said.values())
    again = generate_room(FIVE, seed=4, policy=f"replay:{home}")
    assert again.scene.placements == load_scene(home).placements


def test_what_goes_wrong_is_an_answer_and_the_server_goes_on(tmp_path):
    async def agent():
        async with served(tmp_path) as (_, call):
            await call("start_room", prompt="A chair")
            for name, arguments, says in (
                ("observe", {"room": "room_7"}, "open are room_1"),
                ("open_room", {"path": "../secret"}, "leads out of the root"),
                ("open_room", {"path": "none"}, "no such file"),
                ("start_room", {"prompt": "x" * 50_000}, "length <= 10000"),
                ("place", {"room": "room_1", "id": "chair_1", "position": "here", "yaw": 0}, "$.position"),
                ("nothing", {}, "there is no tool"),
            ):
                result = await call(name, error=True, **arguments)
                assert says in result.content[0].text
                assert "Traceback" not in result.content[0].text
            far = await call("place", room="room_1", id="chair_1", position=[1e9, 0, 0], yaw=0)
            assert far.structured_content["rejection"]["reason"] == "fields"
            other = await call("place", room="room_1", id="sofa_1", position=[1, 1, 0], yaw=0, size=[1, 1, 1])
            assert "chair_1 was asked for" in other.structured_content["says"]
            unread = await call("answer", room="room_1", text="<think>a</think><answer>{oh</answer>")
            assert unread.structured_content["rejection"]["reason"] == "json"
            assert (await call("list_rooms")).structured_content["rooms"][0]["to_place"] == 1

    anyio.run(agent)
    assert list(tmp_path.iterdir()) == []


class Wire:
    """A server, and lines of the protocol as they stand."""

    def __init__(self, root: Path) -> None:
        command = [sys.executable, *COMMAND, str(root)]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.ask("initialize", HELLO)
        self.send(json.dumps({"jsonrpc": "2.0", "method": "notifications/initialized"}).encode())

    def send(self, line: bytes) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(line + b"\n")
        self.process.stdin.flush()

    def ask(self, method: str, params: object) -> object:
        assert self.process.stdout is not None
        self.send(json.dumps({"jsonrpc": "2.0", "id": 1, "method": method, "params": params}).encode())
        return json.loads(self.process.stdout.readline())["result"]


def test_lines_that_are_no_message_do_not_end_the_server_and_stdout_has_nothing_else(tmp_path):
    wire = Wire(tmp_path)
    for line in (b"prose", b"\xff\xfe\x00", b"[" * 5000, b'{"jsonrpc": "2.0"}', b""):
        wire.send(line)
    rooms = wire.ask("tools/call", {"name": "list_rooms", "arguments": {}})
    assert rooms["structuredContent"] == {"rooms": []}  # type: ignore[index]
    rest, _ = wire.process.communicate(timeout=30)
    assert wire.process.returncode == 0
    assert rest == b""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_server_that_waits_can_be_stopped(tmp_path, number):
    wire = Wire(tmp_path)
    wire.process.send_signal(number)
    _, said = wire.process.communicate(timeout=30)
    assert wire.process.returncode == 130
    assert said.decode() == "thinkblox: stopped; nothing was written\n"


def test_without_a_root_nothing_is_served(tmp_path, capsys):
    with pytest.raises(SystemExit, match="2"):
        main(["mcp"])
    assert main(["mcp", "--root", str(tmp_path / "none")]) == 2
    assert "there is no such folder" in capsys.readouterr().err
    (tmp_path / "file").touch()
    assert main(["mcp", "--root", str(tmp_path / "file")]) == 2
    assert "is not a folder" in capsys.readouterr().err


def test_without_the_sdk_it_says_how_to_get_it(tmp_path, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "mcp.server.stdio", None)
    assert main(["mcp", "--root", str(tmp_path)]) == 2
    assert "pip install 'thinkblox[mcp]'" in capsys.readouterr().err
