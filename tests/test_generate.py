import json
import re

import numpy as np
import pytest

from thinkblox.errors import InputError
from thinkblox.furnishing import Progress
from thinkblox.generate import generate_room
from thinkblox.observe import Observation
from thinkblox.phrases import planned_constraints
from thinkblox.placing import Effort
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.scene.agreement import residual
from thinkblox.scene.room import rectangle
from thinkblox.scene.support import placed_at
from thinkblox.steps import Step, parse, write_step
from thinkblox.value import to_json

BEDROOM = (
    "A calm bedroom, 4 m by 5 m, with a double bed against the long wall, two nightstands with a lamp on each, "
    "a wardrobe, and a small desk with a chair by the window."
)
ONE_CHAIR = "An empty room with nothing in it but a chair."
ONCE = Effort(candidates=1, rounds=1, repairs=0, restarts=0)


class Scripted:
    """Answers with the same texts whatever it sees, and remembers what it was shown."""

    def __init__(self, *texts: str) -> None:
        self.texts = texts
        self.seen: list[Observation] = []

    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        self.seen.append(observation)
        return [text.replace("SIZE", json.dumps(observation.asset.size)) for text in self.texts]


def chair_at(x: float, y: float, z: float = 0.0, id: str = "chair_1") -> str:
    answer = f'{{"id": "{id}", "position": [{x}, {y}, {z}], "yaw": 0, "size": SIZE}}'
    return f"<think>1. There.</think><answer>{answer}</answer>"


@pytest.fixture(scope="module")
def bedroom():
    return generate_room(BEDROOM, seed=0)


def test_everything_asked_for_is_placed_and_valid(bedroom):
    assert bedroom.report.complete
    asked = {target.id for target in bedroom.plan.targets if target.asked}
    categories = sorted(p.category for p in bedroom.scene.placements if p.id in asked)
    assert categories == sorted(
        ["bed", "nightstand", "nightstand", "table_lamp", "table_lamp", "wardrobe", "desk", "chair"]
    )
    assert all(relation.holds for relation in bedroom.report.relations)


def test_lamps_stand_one_on_each_nightstand(bedroom):
    lamps = [p for p in bedroom.scene.placements if p.category == "table_lamp"]
    assert sorted(lamp.support for lamp in lamps) == ["nightstand_1", "nightstand_2"]


def test_the_same_seed_gives_the_same_scene_and_another_seed_another():
    first, second, other = (to_json(generate_room(BEDROOM, seed=s).scene) for s in (3, 3, 4))
    assert first == second
    assert first != other


def test_the_trace_has_a_round_for_every_object_and_texts_that_parse(bedroom):
    assert {r.id for r in bedroom.trace} == {t.id for t in bedroom.plan.targets}
    texts = [t.text for r in bedroom.trace for t in r.tries if t.text]
    assert len(texts) > 20
    assert all(isinstance(parse(text), Step) for text in texts)


@pytest.mark.parametrize(
    "prompt",
    [
        BEDROOM,
        "A living room where a sofa faces a TV on a TV stand, a coffee table on a rug and an armchair in the corner.",
        "A dining room with an oval table with six chairs around it, a lamp above it and a picture on the wall.",
    ],
)
def test_the_reasons_of_the_expert_agree_with_its_answers(prompt):
    """The words name the pose: read back, they are where the answer is."""
    result = generate_room(prompt, seed=1)
    scene = result.scene.__class__(room=result.scene.room)
    checked = 0
    for r in result.trace:
        for t in r.tries if r.kept else ():
            step = parse(t.text)
            if not isinstance(step, Step):
                continue
            said = planned_constraints(step)
            assert said, t.text
            asset = next((a for a in result.scene.assets.values() if a.category == r.id.rsplit("_", 1)[0]), None)
            if asset is None:
                continue
            assert step.position is not None
            assert step.yaw is not None
            placement = placed_at(scene, asset, id=step.id, position=step.position, yaw=step.yaw)
            for constraint in said:
                off = residual(constraint, scene, placement) if asset.size == step.size else None
                if off is not None:
                    checked += 1
                    assert off <= (20.0 if constraint.kind == "facing" else 0.02), (constraint, t.text)
        if r.kept and r.chosen is not None and r.id in result.scene:
            placed = result.scene[r.id]
            scene = scene.with_placement(placed, result.scene.asset_of(placed))
    assert checked > 100


def test_a_policy_that_speaks_nonsense_leaves_the_object_out_with_the_reason():
    effort = Effort(rounds=2, repairs=0, restarts=0)
    result = generate_room(ONE_CHAIR, policy=Scripted("put it anywhere"), effort=effort)
    assert result.scene.placements == ()
    assert [a.id for a in result.report.absent] == ["chair_1"]
    assert "<think>" in result.report.absent[0].reason
    assert not result.report.complete
    assert [t.rejection.reason for r in result.trace for t in r.tries if t.rejection] == ["format", "format"]


def test_another_object_than_was_asked_for_is_rejected():
    result = generate_room(ONE_CHAIR, policy=Scripted(chair_at(1, 1, id="sofa_1")), effort=ONCE)
    rejection = result.trace[0].tries[0].rejection
    assert rejection is not None
    assert rejection.reason == "id"


def test_a_size_the_asset_cannot_have_is_rejected():
    text = chair_at(1.5, 1.5).replace("SIZE", "[4, 4, 9]")
    result = generate_room(ONE_CHAIR, policy=Scripted(text), effort=ONCE)
    rejection = result.trace[0].tries[0].rejection
    assert rejection is not None
    assert rejection.reason == "size"


def test_the_measured_failure_goes_back_to_the_policy():
    policy = Scripted(chair_at(-3.0, 1.0))
    generate_room(ONE_CHAIR, room=rectangle(4.0, 3.0), policy=policy, effort=Effort(rounds=3, repairs=0, restarts=0))
    assert [len(o.feedback) for o in policy.seen] == [0, 1, 1]
    assert [o.round for o in policy.seen] == [0, 1, 2]
    line = policy.seen[1].feedback[0]
    assert line.startswith("chair_1 at (-3.00, 1.00, 0.00) turned to 0 degrees: reaches ")
    assert re.search(r"\d+\.\d mm outside the room; move at least 3.50 m towards \+x", line)
    assert line in policy.seen[1].text()


def test_the_nearest_valid_pose_is_found_around_a_failed_try():
    policy = Scripted(chair_at(0.1, 1.5))
    result = generate_room(ONE_CHAIR, room=rectangle(4.0, 3.0), policy=policy, effort=Effort(rounds=1, restarts=0))
    chair = result.scene["chair_1"]
    assert result.trace[-1].kind == "repair"
    assert 0.1 < chair.position[0] < 0.5
    assert result.report.valid


def test_a_thing_in_the_air_is_measured_as_falling():
    result = generate_room(ONE_CHAIR, room=rectangle(4, 3), policy=Scripted(chair_at(2, 1.5, 0.5)), effort=ONCE)
    verdict = result.trace[0].tries[0].verdict
    assert verdict is not None
    assert "drop" in verdict.reasons


def test_the_best_valid_candidate_is_committed_among_bad_ones():
    policy = Scripted(chair_at(-1, 1), "nonsense", chair_at(2.0, 1.5), chair_at(1.0, 1.5))
    result = generate_room(ONE_CHAIR, room=rectangle(4.0, 3.0), policy=policy, effort=Effort(candidates=4))
    assert result.trace[0].chosen == 2
    assert result.scene["chair_1"].position[:2] == (2.0, 1.5)


def test_the_expert_answers_with_as_many_texts_as_asked(bedroom):
    seen: list[int] = []

    class Counting(ExpertPolicy):
        def propose(self, observation, n, rng):
            texts = super().propose(observation, n, rng)
            seen.append(len(texts))
            assert len(set(texts)) == len(texts)
            return texts

    generate_room(ONE_CHAIR, policy=Counting(), effort=Effort(candidates=5))
    assert seen == [5]


def test_a_room_that_is_not_all_as_asked_is_begun_anew_and_the_best_attempt_is_kept():
    policy = Scripted(chair_at(-3.0, 1.0))
    effort = Effort(candidates=1, rounds=1, repairs=0, restarts=2)
    result = generate_room(ONE_CHAIR, room=rectangle(4.0, 3.0), policy=policy, effort=effort)
    assert [(r.attempt, r.kept) for r in result.trace] == [(0, True), (1, False)]
    assert [a.id for a in result.report.absent] == ["chair_1"]


def test_what_no_arrangement_can_mend_is_not_tried_again():
    told: list[Progress] = []
    result = generate_room("A room with a haunted chair.", on_object=told.append)
    assert [p.attempt for p in told] == [0]
    assert result.report.valid
    assert not result.report.complete


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"prompt": None}, "NoneType"),
        ({"prompt": "bed \udcff"}, "UTF-8"),
        ({"prompt": ONE_CHAIR, "seed": -1}, "seed"),
        ({"prompt": ONE_CHAIR, "seed": 1.5}, "seed"),
        ({"prompt": ONE_CHAIR, "seed": True}, "seed"),
        ({"prompt": ONE_CHAIR, "room": {"floor": []}}, "Room"),
    ],
)
def test_wrong_arguments_are_named(arguments, message):
    with pytest.raises(InputError, match=message):
        generate_room(**arguments)


def test_a_policy_may_answer_with_anything():
    class Odd:
        def propose(self, observation, n, rng):
            return [None, 7, "text"]

    result = generate_room(ONE_CHAIR, policy=Odd(), effort=Effort(rounds=1, restarts=0))
    assert [t.rejection.reason for t in result.trace[0].tries if t.rejection] == ["format"] * 3


def test_progress_is_told_for_every_object():
    told: list[Progress] = []
    generate_room(ONE_CHAIR, on_object=told.append)
    assert [(p.target.id, p.placed, p.number, p.total) for p in told] == [("chair_1", True, 1, 1)]


def test_written_steps_of_a_scripted_policy_round_trip():
    text = write_step(["Here."], id="chair_1", position=(2.0, 1.5, 0.0), yaw=30.0, size=(0.5, 0.47, 0.85))
    assert isinstance(parse(text), Step)
