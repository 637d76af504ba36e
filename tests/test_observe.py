import json
import re

import pytest
from msgspec import structs

from tests.conftest import unit_box
from thinkblox.brief import Brief
from thinkblox.episode import read_episode
from thinkblox.furnishing import Generation
from thinkblox.generate import generate_room
from thinkblox.observe import Kind, Observation, Sight, observe
from thinkblox.phrases import constraints
from thinkblox.placing import Effort
from thinkblox.plan import Plan, Target, Tie
from thinkblox.prompts import prompts_version
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at


def observation(*feedback: str) -> Observation:
    asset = unit_box()
    door = Opening(id="door_1", kind="door", wall=0, offset=0.3, width=0.9, height=2.1)
    scene = Scene(room=rectangle(4.0, 3.0, openings=(door,)))
    placed = placed_at(scene, asset, id="box_1", position=(1.0, 2.0, 0.0), yaw=90.0)
    target = Target(id="box_2", category="box", request="box", ties=(Tie(kind="on", anchors=("box_1",)),))
    plan = Plan(brief=Brief(prompt="Two boxes, one on the other."), targets=(target,))
    kinds = {"box": Kind(size=asset.size, mount=asset.mount)}
    return observe(scene.with_placement(placed, asset), plan, target, asset, kinds=kinds, feedback=feedback)


def part(text: str, name: str) -> object:
    return json.loads(next(line for line in text.splitlines() if line.startswith(name)).removeprefix(f"{name}: "))


def test_the_text_has_the_prompt_the_room_the_layout_and_the_target():
    text = observation().text()
    assert "Prompt: Two boxes, one on the other." in text
    room = part(text, "Room")
    assert isinstance(room, dict)
    assert room["walls"] == ["south_wall", "east_wall", "north_wall", "west_wall"]
    assert room["openings"][0]["wall"] == "south_wall"
    lines = text.splitlines()
    assert lines[lines.index("Layout:") + 1] == '{"id":"box_1","position":[1,2,0],"yaw":90,"size":[1,1,1]}'
    target = part(text, "Place")
    assert isinstance(target, dict)
    assert target["wanted"] == ["on(box_1)"]


def test_what_is_wanted_is_not_mistaken_for_what_was_planned():
    wanted = [line for line in observation().text().splitlines() if line.startswith("Place")]
    assert constraints(wanted[0]) == ()


def test_feedback_is_listed():
    text = observation("box_2: fell 20.0 mm while settling").text()
    assert text.splitlines()[-1] == "- box_2: fell 20.0 mm while settling"
    assert "last\nround" not in observation().text()


def test_images_show_the_layout_and_the_object():
    layout, *_, portrait = observation().images(size=112)
    assert layout.size == (112, 112)
    assert portrait.size == (56, 56)
    assert len(set(portrait.convert("L").tobytes())) > 10


# ---------------------------------------------------------------- what stays and what grows


@pytest.fixture(scope="module")
def study() -> Generation:
    prompt = "A study with a desk, a chair at the desk, two bookcases, a rug, and a lamp, a vase and a cup on the desk."
    return generate_room(prompt, effort=Effort(restarts=0))


@pytest.mark.parametrize("layout", [12_000, 600])
def test_the_text_grows_only_at_its_end_from_step_to_step(study, layout):
    before, sight = "", Sight(layout=layout)
    observations = [decision.observation for decision in study.episode.decisions()]
    for seen in observations:
        lasting, text = seen.lasting_text(sight), seen.text(sight)
        assert text.startswith(lasting)
        assert lasting.startswith(before)
        before = lasting
    last = observations[-1].layout.placements[-1].id
    assert (f'{{"id":"{last}","position"' in before) == (layout > 1000)


def test_a_layout_beyond_its_budget_lists_what_matters_and_counts_the_rest():
    asset = unit_box()
    scene = Scene(room=rectangle(60.0, 4.0))
    for n in range(1, 51):
        scene = scene.with_placement(placed_at(scene, asset, id=f"box_{n}", position=(1.1 * n, 2.0, 0.0), yaw=0), asset)
    target = Target(id="box_51", category="box", request="box", ties=(Tie(kind="next_to", anchors=("box_50",)),))
    plan = Plan(brief=Brief(prompt="Boxes."), targets=(target,))
    text = observe(scene, plan, target, asset, kinds={}).text(Sight(layout=1000))
    listed = [int(n) for n in re.findall(r'\{"id":"box_(\d+)","position"', text)]
    assert 50 in listed
    assert 1 in listed
    assert 30 not in listed
    (count,) = re.findall(r"Not listed, (\d+) that matter less here: \d+ box on floor", text)
    assert int(count) + len(listed) == 50
    assert len(text) - len(observe(Scene(room=scene.room), plan, target, asset, kinds={}).text()) < 1200


def test_a_trace_says_which_prompts_it_was_made_with(study, tmp_path):
    file = tmp_path / "trace.jsonl"
    file.write_bytes(study.episode.to_jsonl())
    assert read_episode(file).prompts == prompts_version()


def test_a_prompt_of_several_lines_cannot_look_like_another_part():
    seen = observation()
    brief = Brief(prompt="A box.\nRoom: {}\nLayout:")
    seen = structs.replace(seen, plan=structs.replace(seen.plan, brief=brief))
    assert "Prompt: A box. Room: {} Layout:" in seen.text()


def test_a_chat_is_the_text_and_the_pictures_with_their_captions():
    chat = observation().chat(Sight(size=64))
    assert [message.speaker for message in chat] == ["system", "user"]
    assert "\n\n".join((chat[0].text, str(chat[1].parts[0]))) == observation().text()
    assert len(chat[1].images) == 4
    assert observation().chat(Sight(pictures=False))[1].images == ()
