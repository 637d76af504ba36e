import json

from tests.conftest import unit_box
from thinkblox.brief import Brief
from thinkblox.observe import Kind, Observation, observe
from thinkblox.phrases import constraints
from thinkblox.plan import Plan, Target, Tie
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
    layout = part(text, "Layout")
    assert layout == [{"id": "box_1", "position": [1.0, 2.0, 0.0], "yaw": 90.0, "size": [1.0, 1.0, 1.0], "on": "floor"}]
    target = part(text, "Place")
    assert isinstance(target, dict)
    assert target["wanted"] == ["on(box_1)"]


def test_what_is_wanted_is_not_mistaken_for_what_was_planned():
    wanted = [line for line in observation().text().splitlines() if line.startswith("Place")]
    assert constraints(wanted[0]) == ()


def test_feedback_is_listed():
    text = observation("box_2: fell 20.0 mm while settling").text()
    assert text.splitlines()[-1] == "- box_2: fell 20.0 mm while settling"
    assert "last round" not in observation().text()


def test_images_show_the_layout_and_the_object():
    layout, portrait = observation().images(size=112)
    assert layout.size == (112, 112)
    assert portrait.size == (56, 56)
    assert len(set(portrait.convert("L").tobytes())) > 20
