"""How the loop treats policies: what it tells them, what it forgives, and what it does when they are at a loss."""

import json
import math

import numpy as np
import pytest
from msgspec import structs

from tests.sim_rooms import asset, box, put, scene, table, vase
from thinkblox.assets import make_asset
from thinkblox.assets.source import ProceduralAssets
from thinkblox.brief import Brief
from thinkblox.errors import InputError
from thinkblox.feedback import feedback_line
from thinkblox.furnishing import Generation
from thinkblox.generate import generate_room
from thinkblox.judging import Try, judge, judge_all
from thinkblox.observe import Observation
from thinkblox.phrases import planned_constraints
from thinkblox.placing import Effort
from thinkblox.plan import Plan, Target
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.scene.agreement import residual
from thinkblox.scene.asset import Asset, Link
from thinkblox.scene.room import Room, rectangle
from thinkblox.sim.verdict.world import World
from thinkblox.sim.workers.pool import VerdictPool
from thinkblox.steps import Step, parse, write_step
from thinkblox.value import Vec3, from_json, to_json

ONE_CHAIR = "An empty room with nothing in it but a chair."
ROOM = rectangle(4.0, 3.0)


def chair(x: float, y: float, z: float = 0.0, size: tuple[float, float, float] = (0.5, 0.45, 0.85)) -> str:
    return write_step(["There."], id="chair_1", position=(x, y, z), yaw=0.0, size=size)


class Answers:
    """Gives other answers in every round, and remembers what it was shown."""

    def __init__(self, *rounds: list[str]) -> None:
        self.rounds = rounds
        self.seen: list[Observation] = []

    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        self.seen.append(observation)
        return self.rounds[observation.round % len(self.rounds)]


def furnished(policy: object, *, rounds: int = 2, repairs: int = 0) -> Generation:
    effort = Effort(rounds=rounds, repairs=repairs, restarts=0)
    return generate_room(ONE_CHAIR, room=ROOM, policy=policy, effort=effort)  # type: ignore[arg-type]


# ---------------------------------------------------------------- feedback


def test_a_policy_is_told_of_each_of_its_last_answers() -> None:
    policy = Answers(
        [chair(0.2, 1.5), "<answer>{</answer>", chair(2.0, 1.5, 0.3)], [chair(3.9, 1.0)], [chair(2.0, 1.5)]
    )
    furnished(policy, rounds=3)
    first, second = policy.seen[1].feedback, policy.seen[2].feedback
    assert len(first) == 3
    assert "reaches 50.0 mm outside the room; move at least 0.05 m towards +x" in first[0]
    assert first[1].startswith("chair_1: not used: expected <think>")
    assert "fell" in first[2]
    assert "towards -z" in first[2]
    assert len(second) == 1
    assert "(3.90, 1.00, 0.00)" in second[0]


def test_a_json_error_is_told() -> None:
    policy = Answers(["<think>1.</think><answer>{]</answer>"])
    furnished(policy)
    assert "not one JSON object" in policy.seen[1].feedback[0]


def test_the_shift_that_is_named_helps() -> None:
    policy = Answers([chair(0.2, 1.5)], [chair(0.2, 1.5)])
    furnished(policy)
    said = policy.seen[1].feedback[0].partition("move at least ")[2].split(" m towards ")
    assert said[1] == "+x"
    assert furnished(Answers([chair(0.2 + float(said[0]), 1.5)])).report.valid


BANNER = asset("banner", (0.03, 3.8, 0.6), mount="wall", mass=3.0)
PODIUM = asset("podium", (3.8, 2.8, 0.5))
SMALL = {
    "wall": (asset("picture", (0.03, 0.5, 0.4), mount="wall", mass=1.0), 2.0, 2.985, 1.5, 270.0, "north_wall"),
    "floor": (asset("chest", (0.4, 0.4, 0.4)), 2.0, 1.5, 0.0, 0.0, "floor"),
    "surface": (asset("tray", (0.3, 0.3, 0.3), mount="surface", mass=1.0), 2.0, 1.5, 0.0, 0.0, "floor"),
}
NOWHERE = {
    "wall": "no free place was found along north_wall at this height; another height or another wall may have one",
    "floor": "no free place was found within 10 m, turned as it is; another turn may find one",
    "surface": "no free place was found at this height within 10 m, turned as it is; another surface may have one",
}


@pytest.mark.parametrize("mount", SMALL)
def test_where_no_free_place_was_found_says_where_it_looked(mount: str) -> None:
    kind, x, y, z, yaw, on = SMALL[mount]
    full = scene(ROOM, (put(BANNER, 2.0, 2.985, 1.4, 270.0, on="north_wall"), BANNER), (put(PODIUM, 2.0, 1.5), PODIUM))
    placement = put(kind, x, y, z, yaw, on=on)
    verdict = World(full).check([placement], kind)[0]
    assert "collision" in verdict.reasons
    said = feedback_line(full, placement.id, Try(placement=placement, verdict=verdict), kind)
    assert said.endswith(f"; {NOWHERE[mount]}")


def picture(yaw: float, x: float = 2.0) -> str:
    return write_step(["There."], id="picture_1", position=(x, 2.985, 1.4), yaw=yaw, size=(0.03, 0.9, 0.6))


def hung(policy: object, *, repairs: int = 0) -> Generation:
    effort = Effort(rounds=2, repairs=repairs, restarts=0)
    prompt = "An empty room with nothing in it but a picture."
    return generate_room(prompt, room=ROOM, policy=policy, effort=effort)  # type: ignore[arg-type]


def test_a_picture_that_faces_its_wall_is_told_which_way_to_turn() -> None:
    policy = Answers([picture(90.0), picture(90.0, 0.2)], [picture(270.0)])
    result = hung(policy)
    turned, both = policy.seen[1].feedback
    assert turned.endswith("hangs with its front to the wall; turn it to 270 degrees")
    assert "turn it to 270 degrees; move at least 0.25 m towards +x" in both
    assert result.report.complete


def test_a_picture_that_faces_its_wall_is_turned_in_repair() -> None:
    result = hung(Answers([picture(90.0)]), repairs=20)
    assert [r.kind for r in result.trace if r.chosen is not None] == ["repair"]
    assert (result.scene["picture_1"].yaw, result.report.valid) == (270.0, True)


# ---------------------------------------------------------------- policies that fail


class Raises:
    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        raise RuntimeError("out of memory")


def test_a_policy_that_raises_does_not_end_the_run() -> None:
    result = furnished(Raises())
    assert [t.rejection.reason for r in result.trace for t in r.tries if t.rejection] == ["policy", "policy"]
    assert "out of memory" in result.report.absent[0].reason
    assert furnished(Raises(), repairs=20).scene.placements[0].id == "chair_1"


@pytest.mark.parametrize("role", ["policy", "briefer", "planner", "source"])
def test_a_wrong_object_for_a_role_is_named(role: str) -> None:
    with pytest.raises(InputError, match=f"{role} is a int"):
        generate_room(ONE_CHAIR, **{role: 7})  # type: ignore[arg-type]


def test_a_policy_class_instead_of_an_object_is_fine_or_named() -> None:
    class Without:
        pass

    with pytest.raises(InputError, match="no propose"):
        generate_room(ONE_CHAIR, policy=Without())  # type: ignore[arg-type]


def test_what_came_before_a_failure_is_kept() -> None:
    class Late:
        def propose(self, observation, n, rng):
            yield chair(2.0, 1.5)
            raise RuntimeError("late\nand with a line break")

    result = furnished(Late())
    assert result.report.valid
    assert "late and with" in result.trace[0].tries[1].rejection.message  # type: ignore[union-attr]


@pytest.mark.parametrize(("answer", "says"), [("text", "one str"), (b"text", "one bytes"), (None, "NoneType")])
def test_one_text_instead_of_a_list_is_named(answer: object, says: str) -> None:
    class One:
        def propose(self, observation, n, rng):
            return answer

    assert says in furnished(One(), rounds=1).report.absent[0].reason


def test_texts_that_no_file_can_hold_are_rejected_and_cut() -> None:
    policy = Answers(["half \ud800" + chair(2.0, 1.5), "x" * 3_000_000, chair(2.0, 1.5).replace("}", ', "yaw": 3}')])
    result = furnished(policy, rounds=1)
    reasons = [t.rejection.reason for t in result.trace[0].tries if t.rejection]
    assert reasons == ["format", "format", "json"]
    assert len(result.episode.to_jsonl()) < 200_000


def test_what_a_source_does_not_have_is_absent_and_the_rest_is_placed() -> None:
    class SoldOut(ProceduralAssets):
        def make(self, category, *, seed, attributes=(), size=None):
            if category == "desk":
                raise InputError("desks are sold out")
            return super().make(category, seed=seed, attributes=attributes, size=size)

    result = generate_room("A room with a desk, a lamp on the desk and a bed", source=SoldOut(), seed=0)
    assert [(a.id, a.reason) for a in result.report.absent] == [("desk_1", "desks are sold out")]
    assert "bed_1" in result.scene
    assert not result.report.complete


def test_rubbish_from_a_role_is_named() -> None:
    class Rubbish:
        def brief(self, prompt):
            return {"chairs": 10**6}

    with pytest.raises(InputError, match="briefer answered with a dict"):
        generate_room(ONE_CHAIR, briefer=Rubbish())
    with pytest.raises(InputError, match="twice"):
        Plan(brief=Brief(prompt=""), targets=(target("chair_1"), target("chair_1")))
    with pytest.raises(InputError, match="id"):
        target("Chair")
    for wrong in ({"restarts": -1}, {"candidates": 0}, {"rounds": 1.5}):
        with pytest.raises(InputError, match=next(iter(wrong))):
            Effort(**wrong)


def test_a_room_of_ints_is_seen_as_it_is_read_back() -> None:
    policy = Answers([chair(2.0, 1.5)])
    room = Room(floor=((0, 0), (4, 0), (4, 3), (0, 3)), height=3)
    result = generate_room(ONE_CHAIR, room=room, policy=policy, effort=Effort(restarts=0))
    seen = policy.seen
    assert [d.observation.text() for d in result.episode.decisions()] == [o.text() for o in seen]
    assert structs.replace(from_json(to_json(result.episode.room), Room), surfaces=None) == room
    assert '"floor":[[0,0]' in seen[0].text()


def test_roles_can_be_played_by_anybody() -> None:
    from thinkblox.planning import ExpertPlanner
    from thinkblox.reading import GrammarBriefer

    class Louder(GrammarBriefer):
        def brief(self, prompt: str):
            return super().brief(f"{prompt} And a bed.")

    result = generate_room(ONE_CHAIR, briefer=Louder(), planner=ExpertPlanner(), seed=1)
    assert {p.category for p in result.scene.placements} >= {"bed", "chair"}


# ---------------------------------------------------------------- what is committed


def test_what_is_put_down_from_above_is_committed_where_it_rests() -> None:
    result = furnished(Answers([chair(2.0, 1.5, 0.0025)]))
    assert result.scene["chair_1"].position[2] == 0.0
    assert result.trace[0].tries[0].placement.position[2] == 0.0025  # type: ignore[union-attr]
    assert result.trace[0].committed == (result.scene["chair_1"],)


def test_repairs_speak_too_and_their_words_agree_with_their_answers() -> None:
    result = furnished(Answers([chair(0.1, 1.5)]), repairs=20)
    repaired = result.trace[-1]
    assert repaired.kind == "repair"
    for tried in repaired.tries:
        step = parse(tried.text)
        assert isinstance(step, Step)
        assert tried.placement is not None
        for constraint in planned_constraints(step):
            off = residual(constraint, result.episode.start, tried.placement)
            assert off is None or off < 0.01


def test_a_neighbour_makes_room() -> None:
    """A wardrobe in the middle leaves no place for the bed; the policy insists, and the wardrobe makes room."""

    class Insists:
        def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
            if observation.target.category == "bed":
                size = observation.asset.size
                return [
                    write_step(["In the corner."], id="bed_1", position=(size[0] / 2, 3.2, 0.0), yaw=0.0, size=size)
                ]
            x = 1.6 if observation.target.category == "wardrobe" else 3.0
            size = observation.asset.size
            return [write_step(["Here."], id=observation.target.id, position=(x, 3.0, 0.0), yaw=270.0, size=size)]

    class BedLast:
        def room(self, brief, rng):
            return rectangle(4.5, 4.0)

        def plan(self, brief, room):
            from msgspec import structs

            from thinkblox.planning import plan_brief

            plan = plan_brief(brief, room)
            order = sorted(plan.targets, key=lambda t: t.category == "bed")
            return structs.replace(plan, targets=tuple(structs.replace(t, ties=()) for t in order))

    effort = Effort(rounds=1, repairs=0, restarts=0)
    result = generate_room(
        "Nothing but a single bed and a wardrobe.", policy=Insists(), planner=BedLast(), effort=effort, seed=0
    )
    kinds = [r.kind for r in result.trace]
    assert kinds == ["policy", "policy", "revision", "revision"], [
        str(t.verdict) for r in result.trace for t in r.tries
    ]
    assert result.trace[2].id == "wardrobe_1"
    step = parse(result.trace[2].tries[0].text)
    assert isinstance(step, Step)
    assert step.action == "move"
    assert result.report.valid
    assert result.episode.scene == result.scene


# ---------------------------------------------------------------- episodes


def test_an_episode_is_read_back_and_its_observations_are_those_the_policy_had(tmp_path) -> None:
    seen: list[Observation] = []

    class Watched(ExpertPolicy):
        def propose(self, observation, n, rng):
            seen.append(observation)
            return super().propose(observation, n, rng)

    prompt = "A study with a desk, an office chair at the desk, a desk lamp on the desk and a bookcase."
    result = generate_room(prompt, seed=3, policy=Watched(), effort=Effort(restarts=0))
    file = tmp_path / "trace.jsonl"
    file.write_bytes(result.episode.to_jsonl())
    from thinkblox.episode import read_episode

    again = read_episode(tmp_path)
    assert again == result.episode
    assert again.scene == result.scene
    made = [decision.observation for decision in again.decisions()]
    assert [to_json(o) for o in made] == [to_json(o) for o in seen]
    assert [o.text() for o in made] == [o.text() for o in seen]
    assert made[1].images(size=96)[0].tobytes() == seen[1].images(size=96)[0].tobytes()


def test_the_expert_reads_nothing_but_the_record() -> None:
    class Blind(ExpertPolicy):
        def propose(self, observation, n, rng):
            return super().propose(from_json(to_json(observation), Observation), n, rng)

    prompt = "A bedroom with a double bed, two nightstands with a lamp on each, a wardrobe, a desk and a chair."
    assert generate_room(prompt, seed=2, policy=Blind()).scene == generate_room(prompt, seed=2).scene


def test_a_record_that_was_read_has_no_pictures_and_says_so() -> None:
    policy = Answers([chair(2.0, 1.5)])
    furnished(policy)
    read = from_json(to_json(policy.seen[0]), Observation)
    with pytest.raises(InputError, match="observe"):
        read.images()


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda lines: lines[1:], "begins an episode"),
        (lambda lines: [lines[0].replace(b'"version":1', b'"version":9'), *lines[1:]], "version 9"),
        (lambda lines: [lines[0], *[line for line in lines[1:] if b'"line":"asset"' not in line]], "asset that is not"),
        (lambda lines: [*lines[:-1], lines[-1][:40] + b"\n"], "line"),
    ],
)
def test_a_broken_trace_is_named(tmp_path, change, says) -> None:
    from thinkblox.episode import read_episode

    lines = furnished(Answers([chair(2.0, 1.5)])).episode.to_jsonl().splitlines(keepends=True)
    (tmp_path / "trace.jsonl").write_bytes(b"".join(change(lines)))
    with pytest.raises(InputError, match=says):
        read_episode(tmp_path / "trace.jsonl")


# ---------------------------------------------------------------- the judge

TABLE, VASE = table(), vase()
CRATE = asset("crate", (0.4, 0.4, 0.4), mass=8.0)
STAGE = scene(
    rectangle(5.0, 4.0), (put(TABLE, 1.5, 1.5), TABLE), (put(VASE, 1.5, 1.5, 0.75), VASE), (put(CRATE, 3.5, 3.0), CRATE)
)


def target(id: str, category: str = "chair") -> Target:
    return Target(id=id, category=category, request=category)


@pytest.mark.parametrize(
    ("text", "id", "reason"),
    [
        (write_step(["x"], action="move", id="table_1", position=(3.0, 1.0, 0.0)), "table_1", None),
        (write_step(["x"], action="turn", id="table_1", yaw=90.0), "table_1", None),
        (write_step(["x"], action="remove", id="crate_1"), "crate_1", None),
        (write_step(["x"], action="swap", id="table_1", other="crate_1"), "table_1", None),
        (write_step(["x"], action="replace", id="crate_1", category="armchair"), "crate_1", None),
        (write_step(["x"], action="move", id="sofa_1", position=(3.0, 1.0, 0.0)), "sofa_1", "action"),
        (write_step(["x"], action="swap", id="table_1", other="sofa_1"), "table_1", "action"),
        (write_step(["x"], action="swap", id="table_1", other="vase_1"), "table_1", "action"),
        (write_step(["x"], id="table_1", position=(3.0, 1.0, 0.0), yaw=0.0, size=(1.0, 1.0, 1.0)), "table_1", "action"),
        (write_step(["x"], action="replace", id="crate_1", category="hoverboard"), "crate_1", None),
        ('<think></think><answer>{"action": "move", "id": "table_1"}</answer>', "table_1", "fields"),
        ('<think></think><answer>{"action": "remove", "id": "table_1", "yaw": 2}</answer>', "table_1", "fields"),
        ('<think></think><answer>{"action": "eat", "id": "table_1"}</answer>', "table_1", "fields"),
        (7, "table_1", "format"),
    ],
)
def test_every_action_is_judged(text: object, id: str, reason: str | None) -> None:
    tried = judge(World(STAGE), target(id), text)
    if reason is None:
        assert tried.valid, str(tried.verdict)
    else:
        assert tried.rejection is not None
        assert tried.rejection.reason == reason
        assert not tried.valid


def test_an_addition_is_judged_with_its_asset_or_the_one_made_for_it() -> None:
    made = make_asset("chair", seed=5)
    text = write_step(["There."], id="chair_9", position=(3.0, 1.0, 0.0), yaw=0.0, size=made.size)
    tried = judge(World(STAGE), target("chair_9"), text, asset=made)
    assert tried.valid
    assert tried.placement is not None
    assert tried.placement.asset == made.id
    other = judge(World(STAGE), target("chair_9"), text)
    assert other.valid
    assert other.placement is not None
    assert math.dist(other.placement.size, made.size) < 0.01


def test_the_pool_judges_as_the_world_does() -> None:
    texts = [
        write_step(["x"], action="move", id="table_1", position=(3.0, 1.0, 0.0)),
        write_step(["x"], action="move", id="table_1", position=(3.4, 3.0, 0.0)),
        write_step(["x"], action="remove", id="table_1"),
        "nonsense",
        write_step(["x"], action="swap", id="table_1", other="crate_1"),
    ]
    cases = [(STAGE, target("table_1"), texts), (STAGE, target("crate_1"), texts[:1])]
    with VerdictPool(workers=1) as pool:
        pooled = judge_all(pool, cases)
    assert [len(row) for row in pooled] == [5, 1]
    alone = [[judge(World(s), t, text) for text in said] for s, t, said in cases]
    assert json.dumps([[to_json(t).decode() for t in r] for r in pooled]) == json.dumps(
        [[to_json(t).decode() for t in r] for r in alone]
    )


# ---------------------------------------------------------------- what cannot stand


class TipsOver(ProceduralAssets):
    """Its chairs weigh on their fronts, before all that they stand on."""

    def make(self, category: str, **more: object) -> Asset:
        made = super().make(category, **more)  # type: ignore[arg-type]
        foot = box((0.1, 0.45, 0.4), (-0.2, 0.0, 0.2))
        seat = box((0.5, 0.45, 0.45), (0.0, 0.0, 0.625))
        links = (Link(name="body", shapes=(foot, seat)),)
        return structs.replace(made, id="chair-tipping", size=(0.5, 0.45, 0.85), links=links)

    def fit(self, asset: Asset, size: Vec3) -> Asset:
        return asset


def tried(result: Generation) -> dict[str, list[int]]:
    """How many tries were measured in each round of every object, in the first attempt."""
    found: dict[str, list[int]] = {}
    for entry in (entry for entry in result.trace if entry.attempt == 0):
        found.setdefault(entry.id, []).append(len(entry.tries))
    return found


def test_what_cannot_stand_is_given_up_after_a_round_and_its_like_after_a_try() -> None:
    prompt = "An empty room with nothing in it but three chairs."
    result = generate_room(prompt, room=ROOM, source=TipsOver(), effort=Effort(restarts=0))
    (first,), *others = tried(result).values()
    assert first <= Effort().candidates
    assert others == [[1], [1]]
    assert len(result.report.absent) == 3
    for absence in result.report.absent:
        assert absence.reason.startswith("it cannot stand: by itself on an empty level floor it ")
        assert "tilted" in absence.reason


def test_what_stands_by_itself_is_tried_on_where_it_falls() -> None:
    result = furnished(Answers([chair(2.0, 1.5, 0.3)], [chair(2.0, 1.5)]))
    assert result.report.complete


def test_what_only_a_wall_holds_may_lean_on_it() -> None:
    policy = Answers([chair(2.0, 1.5), chair(3.7499, 1.5)])
    result = generate_room(ONE_CHAIR, room=ROOM, policy=policy, source=TipsOver(), effort=Effort(restarts=0))
    assert result.report.valid
    assert result.scene["chair_1"].position[0] > 3.74
