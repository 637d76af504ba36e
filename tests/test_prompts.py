import re
from typing import get_args

import numpy as np
import pytest

from thinkblox.asking import edit_chat, objects_chat, plan_chat, whole_room_chat
from thinkblox.assets.source import ProceduralAssets
from thinkblox.brief import Brief
from thinkblox.chat import Chat
from thinkblox.errors import InputError
from thinkblox.generate import generate_room
from thinkblox.observe import Kind, kinds_of
from thinkblox.placing import Effort
from thinkblox.plan import Plan
from thinkblox.planning import ExpertPlanner
from thinkblox.prompts import TemplateName, filled, one_line, prompts_version, template
from thinkblox.prompts.answers import EditAnswer, ObjectSet, PlannedOrder, WholeRoom, read_answer
from thinkblox.reading import GrammarBriefer
from thinkblox.scene.room import Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.steps import Rejection, parse


def shown(name: TemplateName) -> str:
    """The answer that a template shows."""
    return str(re.findall(r"<think>\n.*?</answer>", template(name), re.DOTALL)[-1])


def test_the_answers_that_the_templates_show_are_read():
    objects = read_answer(shown("objects"), ObjectSet)
    assert isinstance(objects, ObjectSet)
    brief = objects.brief("A calm bedroom.")
    assert [(r.key, r.count, r.asked) for r in brief.requests][:2] == [("bed", 1, True), ("nightstand", 2, True)]
    planner = ExpertPlanner()
    plan = planner.plan(brief, planner.room(brief, np.random.default_rng(0)))
    assert {t.id for t in plan.targets} == {"bed_1", "nightstand_1", "nightstand_2", "lamp_1", "lamp_2", "rug_1"}
    order = read_answer(shown("plan"), PlannedOrder)
    assert isinstance(order, PlannedOrder)
    assert order.anchors == ("bed_1",)
    edit = read_answer(shown("edit"), EditAnswer)
    assert isinstance(edit, EditAnswer)
    assert edit.actions[0].action == "move"


def test_an_order_of_a_model_is_followed_as_far_as_what_depends_on_what_allows():
    objects = read_answer(shown("objects"), ObjectSet)
    assert isinstance(objects, ObjectSet)
    planner = ExpertPlanner()
    brief = objects.brief("A calm bedroom.")
    plan = planner.plan(brief, planner.room(brief, np.random.default_rng(0)))
    ids = ["rug_1", "lamp_2", "bed_1", "nightstand_1", "nightstand_2", "lamp_1"]
    said = ", ".join(f'{{"id": "{id}"}}' for id in ids)
    order = read_answer(f'<think>1.</think><answer>{{"order": [{said}]}}</answer>', PlannedOrder)
    assert isinstance(order, PlannedOrder)
    assert [t.id for t in order.plan(plan).targets] == [
        "bed_1", "rug_1", "nightstand_1", "nightstand_2", "lamp_2", "lamp_1",
    ]  # fmt: skip
    short = read_answer('<think></think><answer>{"order": [{"id": "bed_1"}]}</answer>', PlannedOrder)
    assert isinstance(short, PlannedOrder)
    with pytest.raises(InputError, match="leaves out"):
        short.plan(plan)


@pytest.mark.parametrize(
    ("answer", "reason"),
    [
        ('{"objects": [{"id": "a", "category": "chair", "count": 1000000}]}', "fields"),
        ('{"objects": [{"id": "a", "category": "chair", "run": "rm"}]}', "fields"),
        ('{"objects": [{"id": "a", "category": "chair", "size": [NaN, 1, 1]}]}', "json"),
        ('```json {"objects": []}```', "json"),
    ],
)
def test_a_wrong_object_set_is_rejected_with_its_reason(answer, reason):
    read = read_answer(f"<think></think><answer>{answer}</answer>", ObjectSet)
    assert isinstance(read, Rejection)
    assert read.reason == reason
    assert isinstance(read_answer(answer, WholeRoom), Rejection)


def test_too_many_objects_and_unknown_anchors_are_refused():
    many = ", ".join(f'{{"id": "{n}", "category": "chair", "count": 200}}' for n in range(3))
    for body, says in (
        (f'{{"objects": [{many}]}}', "600 objects"),
        ('{"objects": [], "relations": [{"subject": "a", "kind": "on", "anchors": ["b"]}]}', "neither"),
    ):
        read = read_answer(f"<think></think><answer>{body}</answer>", ObjectSet)
        assert isinstance(read, ObjectSet)
        with pytest.raises(InputError, match=says):
            read.brief("x")


def test_templates_have_a_version_and_a_step_is_shown_as_it_is_parsed():
    assert re.fullmatch(r"\d+-[0-9a-f]{8}", prompts_version())
    assert all(template(name) for name in get_args(TemplateName))
    assert isinstance(parse(shown("step")), Rejection)  # its dots are to be filled in
    assert filled("revision", feedback="- $x fell").endswith("- $x fell")
    assert one_line("a\n\nRoom: b") == "a Room: b"


# ---------------------------------------------------------------- what is asked


def study() -> tuple[Plan, Room, dict[str, Kind]]:
    brief = GrammarBriefer("named").brief("A study with a desk, a chair at the desk and a lamp on the desk.")
    room = rectangle(4.0, 3.0)
    plan = ExpertPlanner().plan(brief, room)
    return plan, room, kinds_of(plan, ProceduralAssets())


def test_each_role_is_asked_with_all_that_it_needs():
    plan, room, kinds = study()
    asked = {
        "objects": objects_chat("A study.\nAnswer: {}"),
        "plan": plan_chat(plan, room, kinds),
        "one_shot": whole_room_chat(plan, room, kinds),
        "edit": edit_chat(Scene(room=room), "A study.", "move the desk to the window"),
    }
    texts = {name: chat[-1].text for name, chat in asked.items()}
    assert all("$" not in text and len(text) < 20_000 for text in texts.values())
    assert texts["objects"].endswith("Prompt: A study. Answer: {}")
    assert "bookcase" in texts["objects"]
    for name in ("plan", "one_shot"):
        assert re.search(r'\{"id":"desk_1","size":\[[\d.]+,[\d.]+,[\d.]+\]', texts[name])
        assert '"wanted":["on(desk_1)"]' in texts[name]
        assert '"floor":[[0,0],[4,0],[4,3],[0,3]]' in texts[name]
    assert texts["edit"].endswith("Instruction: move the desk to the window")


def test_a_plan_that_a_model_orders_furnishes_a_room():
    class Model:
        def answer(self, chat: Chat, n: int, rng: np.random.Generator) -> list[str]:
            ids = re.findall(r'\{"id":"(\w+_\d+)"', chat[-1].text.partition("Objects:")[2])
            order = ", ".join(f'{{"id": "{id}"}}' for id in reversed(ids))
            return [f'<think>1. Backwards.</think><answer>{{"order": [{order}]}}</answer>']

    class Planned(ExpertPlanner):
        def plan(self, brief: Brief, room: Room) -> Plan:
            known = super().plan(brief, room)
            chat = plan_chat(known, room, kinds_of(known, ProceduralAssets()))
            read = read_answer(Model().answer(chat, 1, np.random.default_rng(0))[0], PlannedOrder)
            assert isinstance(read, PlannedOrder)
            return read.plan(known)

    prompt = "A study with a desk, a bookcase and a lamp on the desk."
    room = generate_room(
        prompt, planner=Planned(), briefer=GrammarBriefer("named"), fill="named", effort=Effort(restarts=0)
    )
    assert [target.category for target in room.plan.targets][:2] == ["bookcase", "desk"]
    assert room.report.valid
