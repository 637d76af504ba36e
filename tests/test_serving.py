import json

import pytest

from tests.agents import Agent, expert_texts
from tests.layout_rooms import write
from thinkblox.episode import read_episode
from thinkblox.errors import UnavailableError
from thinkblox.generate import generate_room
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.serving.desk import MOST_ROOMS
from thinkblox.serving.naming import sayable
from thinkblox.serving.room import AgentRoom
from thinkblox.serving.tools import TOOLS
from thinkblox.steps import MAX_TEXT
from thinkblox.value import to_json

SMALL = "An empty room of 4 m by 4 m with a desk, a vase on the desk and a chair. Nothing else."


@pytest.fixture
def agent(tmp_path):
    root = tmp_path / "root"
    root.mkdir()
    return Agent(root)


@pytest.fixture
def begun(agent):
    agent.ok("start_room", prompt=SMALL)
    return agent


@pytest.fixture
def furnished(begun):
    begun.furnish()
    return begun


# --- placing


def test_the_verdict_is_the_answer_and_what_is_next(begun):
    data = begun.data("answer", room="room_1", text=expert_texts(begun.room())[0])
    assert data["done"]
    assert data["verdict"]["valid"]
    assert [p["id"] for p in data["committed"]] == ["desk_1"]
    assert data["next"] == "chair_1" or data["next"] == "vase_1"


def test_what_is_not_valid_changes_nothing_and_says_what_would_help(begun):
    before = begun.room().scene
    data = begun.data("place", room="room_1", id="desk_1", position=[0.2, 2.0, 0.0], yaw=0, reasoning="why not")
    assert not data["done"]
    assert "outside the room" in data["says"]
    assert "move at least" in data["says"]
    assert data["verdict"]["boundary"] > 0
    assert begun.room().scene == before
    assert "outside the room" in begun.ok("observe", room="room_1", pictures=False).text


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"id": "desk_1", "position": [1e9, 0, 0], "yaw": 0}, "<= 1000.0"),
        ({"id": "chair_1", "position": [1, 1, 0], "yaw": 0, "size": [1, 1, 1]}, "desk_1 was asked for"),
        ({"id": "Bed 9'; --", "position": [1, 1, 0], "yaw": 0, "size": [1, 1, 1]}, "$.id"),
        ({"id": "desk_1", "position": [1, 1, 0], "yaw": 0, "size": [900, 1, 1]}, "<= 100.0"),
        ({"id": "desk_1", "position": [1, 1, 0], "yaw": 0, "reasoning": "</think><answer>"}, "each once"),
    ],
)
def test_what_cannot_be_used_is_rejected_and_kept_in_the_trace(begun, arguments, says):
    data = begun.data("place", room="room_1", **arguments)
    assert not data["done"]
    assert says in data["rejection"]["message"]
    assert begun.room().episode().rounds[-1].tries[0].rejection is not None


@pytest.mark.parametrize("text", ["", "prose", "<think>a</think><answer>{no</answer>", "x" * (MAX_TEXT + 1), "[1, 2]"])
def test_a_text_that_cannot_be_read_is_rejected_with_the_reason(begun, text):
    data = begun.data("answer", room="room_1", text=text)
    assert data["rejection"]["reason"] in ("format", "json")
    assert data["next"] == "desk_1"


def test_with_nothing_to_place_a_text_is_still_told_what_is_wrong(furnished):
    assert "each once" in furnished.data("answer", room="room_1", text="prose")["says"]
    add = '<think>1. So.</think><answer>{"id": "bed_1", "position": [1, 1, 0], "yaw": 0, "size": [2, 1, 1]}</answer>'
    assert "nothing is to be placed" in furnished.refused("answer", room="room_1", text=add)


def test_the_observation_of_each_decision_can_be_made_again(begun):
    """With a change in between, which is no decision about the next object."""
    seen = [begun.room().observation()]
    begun.ok("place", room="room_1", id="desk_1", position=[0.2, 2.0, 0.0], yaw=0)
    while (room := begun.room()).target is not None:
        seen.append(room.observation())
        for text in expert_texts(room):
            if begun.data("answer", room="room_1", text=text)["done"]:
                break
            seen.append(room.observation())
        if seen[-1].target.id == "desk_1":
            begun.ok("turn", room="room_1", id="desk_1", yaw=180)
    assert [d.observation for d in room.episode().decisions()] == seen


# --- changing what stands


def test_each_change_is_measured_and_in_the_trace(furnished, tmp_path):
    assert furnished.data("move", room="room_1", id="chair_1", position=[2.0, 2.5, 0], yaw=10)["done"]
    assert furnished.data("turn", room="room_1", id="chair_1", yaw=100)["done"]
    assert furnished.data("replace", room="room_1", id="vase_1", category="bowl")["done"]
    assert furnished.room().scene["vase_1"].category == "bowl"
    refused = furnished.data("remove", room="room_1", id="desk_1")
    assert not refused["done"]
    assert "what rests on it fails: vase_1" in refused["says"]
    assert furnished.data("remove", room="room_1", id="vase_1")["done"]
    assert furnished.data("remove", room="room_1", id="desk_1")["next"] == "desk_1"
    assert not furnished.data("move", room="room_1", id="chair_1", position=[9, 9, 0])["done"]
    furnished.ok("save", room="room_1", folder="room", pictures=False)
    episode = read_episode(tmp_path / "root" / "room")
    assert episode.scene == load_scene(tmp_path / "root" / "room") == furnished.room().scene
    assert [r.chosen for r in episode.rounds if r.kind == "edit"] == [0, 0, 0, None, 0, 0, None]


def test_two_things_change_places(agent):
    agent.ok("start_room", prompt="An empty room of 5 m by 5 m with two stools. Nothing else.")
    agent.furnish()
    first, second = agent.room().scene.placements
    data = agent.data("swap", room="room_1", id=first.id, other=second.id)
    assert data["done"], data["says"]
    assert agent.room().scene[first.id].position == second.position


def test_what_is_not_there_cannot_be_changed(furnished):
    data = furnished.data("move", room="room_1", id="sofa_1", position=[1, 1, 0])
    assert "sofa_1: it is not in the room; there are" in data["says"]
    assert "stands already" in furnished.data("place", room="room_1", id="chair_1", position=[1, 1, 0], yaw=0)["says"]


def test_one_more_thing_is_wanted_and_another_left_out(begun):
    assert begun.data("want", room="room_1", category="office chair", attributes=["red"])["id"] == "office_chair_1"
    begun.ok("skip", room="room_1", id="vase_1", reason="too fragile")
    assert "is not to be placed" in begun.refused("skip", room="room_1", id="vase_1")
    begun.furnish()
    data = begun.data("verify", room="room_1")
    assert {"id": "vase_1", "category": "vase", "asked": True, "reason": "too fragile"} in data["absent"]
    assert data["valid"]
    assert not data["complete"]
    assert "office_chair_1" in begun.room().scene


def test_the_expert_can_be_asked_for_the_next_object(begun):
    data = begun.data("ask_expert", room="room_1")
    assert data["done"]
    assert "desk_1" in begun.room().scene


# --- files


def test_a_room_of_ours_is_opened_with_its_trace_and_gone_on_with(begun, tmp_path):
    begun.ok("ask_expert", room="room_1")
    begun.ok("save", room="room_1", folder="rooms/first", pictures=False)
    opened = begun.data("open_room", path="rooms/first")
    assert opened["room"] == "room_2"
    assert opened["to_place"] == 2
    assert "Its trace goes on." in opened["says"]
    begun.furnish("room_2")
    begun.ok("save", room="room_2", folder="rooms/first", pictures=False, overwrite=True)
    home = tmp_path / "root" / "rooms" / "first"
    assert read_episode(home).scene == load_scene(home)
    assert json.loads((home / "report.json").read_bytes())["complete"]
    assert len(load_scene(home).placements) == 3


def test_a_scene_without_a_trace_begins_one_with_what_stood_there(furnished, tmp_path):
    furnished.ok("save", room="room_1", folder="room", pictures=False)
    home = tmp_path / "root" / "room"
    (home / "alone.json").write_bytes((home / "scene.json").read_bytes())
    assert "no trace" in furnished.data("open_room", path="room/alone.json")["says"]
    assert furnished.data("remove", room="room_2", id="chair_1")["done"]
    furnished.ok("save", room="room_2", folder="second", pictures=False)
    episode = read_episode(tmp_path / "root" / "second")
    assert [p.id for p in episode.start.placements] == [p.id for p in furnished.room().scene.placements]
    assert episode.scene == load_scene(tmp_path / "root" / "second")


def test_a_room_changed_by_hand_keeps_its_plan_and_begins_a_new_trace(furnished, tmp_path):
    furnished.ok("save", room="room_1", folder="room", pictures=False)
    home = tmp_path / "root" / "room"
    (home / "scene.json").write_bytes(to_json(furnished.room().scene.without("chair_1")))
    opened = furnished.data("open_room", path="room")
    assert "does not lead to this scene" in opened["says"]
    assert opened["next"] == "chair_1"
    furnished.furnish("room_2")
    furnished.ok("save", room="room_2", folder="again", pictures=False)
    episode = read_episode(tmp_path / "root" / "again")
    assert [p.id for p in episode.stood] == ["desk_1", "vase_1"]
    assert episode.scene == load_scene(tmp_path / "root" / "again")


def test_a_trace_with_changes_is_not_played_back_as_if_it_had_none(furnished, tmp_path):
    furnished.ok("remove", room="room_1", id="vase_1")
    furnished.ok("save", room="room_1", folder="room", pictures=False)
    with pytest.raises(UnavailableError, match="changed after things stood in it"):
        generate_room(SMALL, policy=f"replay:{tmp_path / 'root' / 'room'}")


def test_paths_out_of_the_root_are_refused_and_nothing_is_written(furnished, tmp_path):
    outside = tmp_path / "outside"
    outside.mkdir()
    (outside / "scene.json").write_text("{}")
    (tmp_path / "root" / "link").symlink_to(outside)
    (tmp_path / "root" / "file.json").symlink_to(outside / "scene.json")
    for path in ("..", "../outside", "a/../../outside", str(outside), "link", "link/new", "~/x", "a\0b", "x" * 300):
        assert furnished.refused("save", room="room_1", folder=path), path
        assert furnished.refused("open_room", path=path), path
        assert furnished.refused("check_file", path=path), path
        assert furnished.refused("list_files", folder=path), path
    assert "is a link" in furnished.refused("open_room", path="file.json")
    assert "root itself" in furnished.refused("save", room="room_1", folder=".")
    assert [entry.name for entry in outside.iterdir()] == ["scene.json"]
    assert sorted(entry.name for entry in (tmp_path / "root").iterdir()) == ["file.json", "link"]
    assert furnished.ok("list_files").text == "nothing"


def test_files_that_a_layout_or_a_room_names_stay_under_the_root(furnished, tmp_path):
    furnished.ok("save", room="room_1", folder="room", pictures=False)
    trace = tmp_path / "root" / "room" / "trace.jsonl"
    trace.rename(tmp_path / "trace.jsonl")
    trace.symlink_to(tmp_path / "trace.jsonl")
    assert "is a link" in furnished.data("open_room", path="room")["says"]
    assert "leads out" in furnished.refused("check_file", path="room", assets="../..")
    (tmp_path / "part.xml").write_text("<mujoco/>")
    model = '<mujoco><include file="../part.xml"/><worldbody/></mujoco>'
    (tmp_path / "root" / "model.xml").write_text(model)
    assert "part.xml" in furnished.refused("check_file", path="model.xml")


def test_a_model_is_measured_but_not_opened(agent, tmp_path):
    crate = '<body name="crate" pos="1 1 0.1"><freejoint/><geom type="box" size="0.1 0.1 0.1"/></body>'
    floor = '<geom name="floor" type="plane" size="5 5 0.1"/>'
    (tmp_path / "root" / "room.xml").write_text(f"<mujoco><worldbody>{floor}{crate}</worldbody></mujoco>")
    assert "check_file" in agent.refused("open_room", path="room.xml")
    assert agent.data("check_file", path="room.xml")["valid"]


def test_files_that_cannot_be_read_say_why(agent, tmp_path):
    (tmp_path / "root" / "bad.json").write_text('{"room": {"floor": [')
    (tmp_path / "root" / "text.txt").write_text("prose")
    (tmp_path / "root" / "empty").mkdir()
    assert "bad.json" in agent.refused("open_room", path="bad.json")
    assert "is not read" in agent.refused("open_room", path="text.txt")
    assert "scene.json" in agent.refused("open_room", path="empty")
    assert "no such file" in agent.refused("open_room", path="none")
    assert "holodeck" in agent.refused("check_file", path="bad.json", format="sketch")
    assert str(tmp_path) not in agent.refused("open_room", path="bad.json")


def test_a_room_is_not_saved_over_other_files(furnished, tmp_path):
    (tmp_path / "root" / "mine").mkdir()
    (tmp_path / "root" / "mine" / "thesis.tex").write_text("x")
    assert "holds other files" in furnished.refused("save", room="room_1", folder="mine", overwrite=True)
    furnished.ok("save", room="room_1", folder="room", pictures=False)
    assert "already holds a room" in furnished.refused("save", room="room_1", folder="room")
    assert "no format 'vrml'" in furnished.refused("save", room="room_1", folder="other", formats=["vrml"])


# --- sessions


def test_rooms_are_apart_by_their_handles_and_limited(agent):
    for seed in range(MOST_ROOMS):
        agent.ok("start_room", prompt="A chair", seed=seed)
    assert "close_room" in agent.refused("start_room", prompt="A chair")
    agent.ok("close_room", room="room_3")
    assert agent.data("start_room", prompt="A chair")["room"] == f"room_{MOST_ROOMS + 1}"
    assert "there is no room 'room_3'" in agent.refused("observe", room="room_3")
    agent.ok("ask_expert", room="room_1")
    assert len(agent.room("room_2").scene.placements) == 0


def test_a_room_of_the_agents_own_is_furnished(agent):
    floor = {"floor": [[0, 0], [5, 0], [5, 4], [0, 4]], "height": 3}
    agent.ok("start_room", prompt="A chair", room=floor)
    assert agent.room().scene.room.height == 3.0
    assert "simple polygon" in agent.refused(
        "start_room", prompt="A chair", room={"floor": [[0, 0], [1, 1], [1, 0], [0, 1]]}
    )


@pytest.mark.parametrize(
    ("name", "arguments", "says"),
    [
        ("furnish", {}, "there is no tool 'furnish'; there are start_room"),
        ("observe", {}, "missing required field `room`"),
        ("observe", {"room": "room_1", "zoom": 2}, "unknown field `zoom`"),
        ("observe", {"room": "room_1", "size": 10**6}, "<= 1024"),
        ("observe", {"room": 7}, "Expected `str`"),
        ("start_room", {"prompt": ""}, "length >= 1"),
        ("start_room", {"prompt": "x" * 100_000}, "length <= 10000"),
        ("start_room", {"prompt": "\ud800"}, "surrogates"),
        ("start_room", {"prompt": "A chair", "seed": -1}, ">= 0"),
        ("start_room", {"prompt": "A chair", "fill": "lived-in"}, "want"),
        ("place", {"room": "room_1", "id": "desk_1", "position": [1, 2], "yaw": 0}, "$.position"),
        ("place", {"room": "room_1", "id": "desk_1", "position": [1, 2, None], "yaw": 0}, "$.position[2]"),
        ("place", {"room": "room_1", "id": "x_1", "position": [1, 2, 0], "yaw": 0}, "which is desk_1"),
        ("want", {"room": "room_1", "category": "../../etc"}, "$.category"),
        ("want", {"room": "room_1", "category": "chair", "size": [-1, 1, 1]}, "size"),
        ("render", {"room": "room_9"}, "open are room_1"),
        ("list_categories", {"category": "unobtainium thing"}, "unobtainium"),
    ],
)
def test_a_wrong_call_is_an_error_to_act_on(begun, name, arguments, says):
    assert says in begun.refused(name, **arguments)


def test_a_fault_of_ours_is_said_without_a_traceback_and_the_room_is_as_it_was(begun, monkeypatch, capsys):
    def broken(self, text):
        raise ZeroDivisionError("by nothing")

    before = begun.room().scene
    with monkeypatch.context() as patch:
        patch.setattr(AgentRoom, "answer", broken)
        from thinkblox.serving.calls import call

        answered = call(begun.desk, "answer", {"room": "room_1", "text": "x"})
    assert not answered.done
    assert "a fault of ours (ZeroDivisionError: by nothing)" in answered.said.text
    assert "Traceback" not in answered.said.text
    assert begun.room().scene == before
    assert capsys.readouterr().out == ""


def test_what_there_is_is_listed(furnished):
    assert {o["id"] for o in furnished.data("list_objects", room="room_1")["objects"]} == {
        "desk_1",
        "chair_1",
        "vase_1",
    }
    assert "armchair" in furnished.ok("list_categories").text
    assert furnished.data("list_categories", category="armchair")["mount"] == "floor"
    assert furnished.data("list_rooms")["rooms"][0]["placed"] == 3


def test_pictures_are_drawn_as_asked(furnished):
    _, picture = furnished.ok("render", room="room_1", view="top", size=128).parts
    assert picture.size == (128, 128)


def test_each_tool_says_what_it_does_and_takes_an_object():
    for tool in TOOLS.values():
        assert len(tool.says()) > 20
        assert tool.schema()["type"] == "object"
        assert tool.schema()["additionalProperties"] is False


@pytest.mark.parametrize("format", ["layoutvlm", pytest.param("holodeck", marks=pytest.mark.slow)])
def test_a_layout_of_others_is_opened_changed_and_saved_as_ours(agent, tmp_path, format):
    write(tmp_path / "root", format)
    opened = agent.data("open_room", path=f"{format}.json")
    assert opened["placed"] == 5
    assert "chair-0" in opened["ids_in_the_file"].values() or format != "layoutvlm"
    chair = next(p for p in agent.room().scene.placements if p.category.startswith("chair"))
    x, y, z = chair.position
    assert agent.data("move", room="room_1", id=chair.id, position=[x + 0.2, y, z])["done"]
    agent.ok("want", room="room_1", category="stool")
    assert agent.data("ask_expert", room="room_1")["done"]
    verified = agent.data("verify", room="room_1")
    assert verified["complete"] is None
    assert "measured as boxes, for want of a mesh" in verified["says"]
    assert "all as asked" not in agent.ok("save", room="room_1", folder="ours", pictures=False).text
    agent.ok("open_room", path="ours")
    assert "all as asked" not in agent.ok("verify", room="room_2").text
    home = tmp_path / "root" / "ours"
    assert read_episode(home).scene == load_scene(home)
    assert len(load_scene(home).placements) == 6
    assert agent.data("check_file", path="ours")["says"]


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("chair_1", "chair_1"),
        ("chair-0", "chair_0"),
        ("Dining-Table.3", "dining_table_3"),
        ("bed", "bed_1"),
        ("sofa3", "sofa_3"),
        ("x" * 120, "x" * 68 + "_1"),
    ],
)
def test_ids_of_others_become_such_as_an_answer_can_say(before, after, box_asset):
    there = Placement(id=before, category="box", asset="box-0", position=(1, 1, 0), yaw=0.0, size=(1, 1, 1))
    scene = Scene(room=rectangle(4, 4), placements=(there,), assets={"box-0": box_asset})
    named, old = sayable(scene)
    assert [p.id for p in named.placements] == [after]
    assert old == ({} if before == after else {after: before})


def test_two_names_that_become_alike_stay_apart(box_asset):
    ids = ("box.1", "box-1", "box_1", "BOX_1", "door_1")
    places = tuple(
        Placement(id=id, category="box", asset="box-0", position=(1, 1, 0), yaw=0.0, size=(1, 1, 1)) for id in ids
    )
    scene = Scene(room=rectangle(4, 4), placements=places, assets={"box-0": box_asset})
    assert [p.id for p in sayable(scene)[0].placements] == ["box_2", "box_3", "box_1", "box_4", "door_1"]
