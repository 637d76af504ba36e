"""A model that reads a prompt otherwise than its words say is not believed without a word."""

import json
from typing import Any

import pytest
from msgspec import structs

from tests.model_answers import answer_to, asked_of, said
from tests.stub_server import stub
from thinkblox.cli import main
from thinkblox.policies.understanding import ModelBriefer
from thinkblox.reading import read_brief
from thinkblox.reading.second_reading import seconded

PROMPT = (
    "A bedroom, 4 m by 5 m, with a red double bed, two nightstands next to it, a desk 1.6 m wide against the north"
    " wall, a lamp on each nightstand, some chairs, and no rug"
)
OBJECTS: dict[str, Any] = {
    "room": {"type": "bedroom", "width": 5.0, "depth": 4.0},
    "objects": [
        {"id": "b", "category": "bed", "attributes": ["red", "double"]},
        {"id": "n", "category": "nightstand", "count": 2},
        {"id": "d", "category": "desk", "size": [None, 1.6, None]},
        {"id": "l", "category": "lamp", "count": 2},
        {"id": "c", "category": "dining chair", "count": 4},
    ],
    "relations": [
        {"subject": "n", "kind": "left_of", "anchors": ["b"]},
        {"subject": "l", "kind": "on", "anchors": ["n"], "each": True},
        {"subject": "d", "kind": "against_wall", "anchors": ["north_wall"]},
    ],
    "excluded": ["rug"],
}


class Model:
    def __init__(self, answer):
        self.answer_text = said(answer)

    def answer(self, chat, n, rng):
        return [self.answer_text]


def unknown(answer, prompt=PROMPT):
    return ModelBriefer(Model(answer)).brief(prompt).unknown


def without(key, *ids):
    return OBJECTS | {key: [e for e in OBJECTS[key] if e.get("id", e.get("subject")) not in ids]}


def with_object(id, **changes):
    return OBJECTS | {"objects": [e | changes if e["id"] == id else e for e in OBJECTS["objects"]]}


def test_a_model_that_reads_what_the_prompt_says_in_its_own_way_is_believed():
    assert unknown(OBJECTS) == ()


@pytest.mark.parametrize(
    ("answer", "told"),
    [
        (OBJECTS | {"room": {"type": "bedroom", "width": 6.0, "depth": 4.0}}, "4 m by 5 m (read as 6 m by 4 m)"),
        (OBJECTS | {"room": {"type": "bedroom"}}, "4 m by 5 m (not read)"),
        (with_object("n", count=1), "two nightstands (read as 1)"),
        (with_object("n", asked=False), "two nightstands (not read)"),
        (with_object("b", attributes=["double"]), "a red double bed (read without red)"),
        (with_object("d", size=[None, 1.2, None]), "a desk (read with another size)"),
        (OBJECTS | {"excluded": []}, "no rug (not read)"),
        (without("relations", "l"), "table lamp on nightstand (not read)"),
        (without("relations", "d"), "desk against wall north wall (not read)"),
    ],
)
def test_what_a_model_reads_otherwise_is_not_understood(answer, told):
    assert unknown(answer) == (told,)


def test_left_is_not_read_as_right():
    prompt = "A room with a bed and a desk to the left of the bed"
    things = [{"id": "bed", "category": "bed"}, {"id": "desk", "category": "desk"}]
    found = [
        unknown({"objects": things, "relations": [{"subject": "desk", "kind": kind, "anchors": ["bed"]}]}, prompt)
        for kind in ("left_of", "next_to", "right_of")
    ]
    assert found == [(), (), ("desk left of bed (not read)",)]


def test_a_brief_of_the_grammar_agrees_with_itself():
    for prompt in (
        "An L-shaped office of 30 square metres, 3 m high, with two doors, three windows and mismatched chairs",
        "A living room with a tartan loveseat facing a TV, and at least three plants in the corners",
        "Un dormitorio de 4 m por 5 m con una cama y dos mesitas",
    ):
        brief = read_brief(prompt)
        assert seconded(brief) == brief


def test_walls_that_no_answer_can_tell_are_as_the_prompt_says():
    brief = structs.replace(read_brief("A study with brick walls and a desk"), surfaces=())
    assert [surface.laying for surface in seconded(brief).surfaces] == ["brick"]


def test_what_the_grammar_cannot_read_is_left_to_the_model():
    brief = structs.replace(read_brief("A desk"), prompt="机と椅子のある書斎、四メートル四方、窓は二つでお願いします")
    assert seconded(brief) == brief


def test_a_room_of_another_size_than_asked_is_not_all_as_asked(tmp_path, capsys):
    prompt, out = "A room of 6 m by 5 m with a table and a chair near it", tmp_path / "room"
    with stub(lambda body: answer_to(asked_of(body))) as server:
        options = ["--reader", server.spec, "--out", str(out), "--no-pictures"]
        assert main(["generate", prompt, *options]) == 1
    assert "6 m by 5 m (read as 4 m by 3 m)" in capsys.readouterr().out
    assert json.loads((out / "report.json").read_text())["unknown"] == ["6 m by 5 m (read as 4 m by 3 m)"]


@pytest.mark.parametrize(
    ("prompt", "things", "told"),
    [
        ("A cafe with five round tables", {"bistro_table": 5}, ()),
        ("A cafe with five dining tables", {"bistro_table": 5}, ("five dining tables (not read)",)),
        ("A living room with a couch and a television", {"sofa": 1, "tv": 1}, ()),
        ("A living room with a couch and a coffee table", {"sofa": 1, "desk": 1}, ("a coffee table (not read)",)),
    ],
)
def test_a_thing_may_have_another_name_but_be_no_other_thing(prompt, things, told):
    entries = [{"id": k, "category": k, "count": n, "attributes": ["round"]} for k, n in things.items()]
    assert unknown({"objects": entries}, prompt) == told


def test_a_look_may_be_said_in_more_words():
    bed = {"id": "bed", "category": "bed", "attributes": ["king-size"]}
    assert unknown({"objects": [bed]}, "A bedroom with a king size bed") == ()
    assert unknown({"objects": [bed | {"attributes": []}]}, "A bedroom with a king size bed") != ()
