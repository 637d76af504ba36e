"""Rewards against numbers worked out by hand, from texts that are read, done and measured."""

import math
from collections.abc import Iterator

import pytest
from msgspec import structs

from tests.sim_rooms import asset, put, scene, table, vase
from thinkblox.plan import Target, Tie
from thinkblox.scene.asset import Asset
from thinkblox.scene.scene import Scene
from thinkblox.sim.workers.pool import VerdictPool
from thinkblox.steps import write_step
from thinkblox.training.outcome import Asked, outcomes
from thinkblox.training.rewards import REWARDS
from thinkblox.value import Vec3

TABLE, VASE = table(), vase()
CHAIR = asset("chair", (0.5, 0.5, 0.9), mass=5.0)
ROOM = scene(None, (put(TABLE, 2.0, 2.5), TABLE))


@pytest.fixture(scope="module")
def pool() -> Iterator[VerdictPool]:
    with VerdictPool(workers=0) as pool:
        yield pool


def text(kind: Asset, position: Vec3, yaw: float = 0.0, says: str = "") -> str:
    return write_step([says or "Here."], id=f"{kind.category}_1", position=position, yaw=yaw, size=kind.size)


def reward(pool: VerdictPool, name: str, texts: list[str], kind: Asset = CHAIR, *ties: Tie, room: Scene = ROOM):
    target = Target(id=f"{kind.category}_1", category=kind.category, request=kind.category, ties=ties)
    (found,) = outcomes(pool, [(Asked(room, target, kind), texts)])
    return REWARDS[name](outcome=found, prompts=[], completions=[])


def test_a_text_that_cannot_be_used_gets_the_floor_of_everything(pool: VerdictPool) -> None:
    at = Tie(kind="at", anchors=("table_1",))
    floors = {
        name: reward(pool, name, ["a chair by the window", text(CHAIR, (1.0, 1.0, 0.0))], CHAIR, at) for name in REWARDS
    }
    for name, (unread, read) in floors.items():
        assert unread == (0.0 if name == "rules" else -1.0), name
        assert read is not None
        assert read >= unread, name


def test_format(pool: VerdictPool) -> None:
    good = text(CHAIR, (1.0, 1.0, 0.0))
    other = good.replace("chair_1", "chair_2")
    assert reward(pool, "format", [good, good[:-9], other, "", good + "!"]) == [0.0, -1.0, -1.0, -1.0, -1.0]


def test_collisions(pool: VerdictPool) -> None:
    """Half of a box of 0.5 m is in another of that size: rho is a half."""
    room = scene(None, (put(CHAIR, 2.0, 2.0, id="chair_9"), CHAIR))
    free, half = reward(pool, "coll", [text(CHAIR, (1.0, 1.0, 0.0)), text(CHAIR, (2.25, 2.0, 0.0))], room=room)
    assert free == 0.0
    assert half == pytest.approx(-math.tanh(2.5), abs=1e-6)


def test_outside(pool: VerdictPool) -> None:
    """A box of 0.5 m whose middle is on the wall reaches 0.25 m outside."""
    assert reward(pool, "layout", [text(CHAIR, (0.0, 2.0, 0.0)), text(CHAIR, (0.25, 2.0, 0.0))]) == [
        pytest.approx(-math.tanh(0.25), abs=1e-6),
        0.0,
    ]


def test_support_and_settling(pool: VerdictPool) -> None:
    texts = [text(VASE, (2.0, 2.5, 0.75)), text(VASE, (2.0, 2.5, 1.2)), text(VASE, (2.0 + 0.6, 2.5, 0.75))]
    on, above, _edge = reward(pool, "support", texts, VASE)
    assert (on, above) == (0.0, -1.0)
    rest, fell, toppled = reward(pool, "settle", texts, VASE)
    assert rest == pytest.approx(0.0, abs=0.02)
    assert fell is not None
    assert toppled is not None
    assert rest > max(fell, toppled)
    assert reward(pool, "valid", texts, VASE) == [0.0, -1.0, -1.0]


def test_alignment(pool: VerdictPool) -> None:
    """A chair west of the table looks at it, past it at 60 degrees, or away from it."""
    texts = [text(CHAIR, (1.0, 2.5, 0.0), yaw) for yaw in (0.0, 60.0, 180.0)]
    tie = Tie(kind="at", anchors=("table_1",))
    assert reward(pool, "align", texts, CHAIR, tie) == pytest.approx([1.0, 0.5, -1.0], abs=1e-9)
    assert reward(pool, "align", [*texts, "?"], CHAIR) == [None] * 4


def test_a_desk_is_aligned_with_what_is_seen_from_it(pool: VerdictPool) -> None:
    desk = structs.replace(CHAIR, id="desk-0", category="desk", gaze="back")
    tie = Tie(kind="facing", anchors=("table_1",))
    texts = [text(desk, (1.0, 2.5, 0.0), yaw) for yaw in (180.0, 0.0)]
    assert reward(pool, "align", texts, desk, tie) == pytest.approx([1.0, -1.0], abs=1e-9)
    assert reward(pool, "rules", texts, desk, tie) == [1.0, 0.0]


def test_relations(pool: VerdictPool) -> None:
    ties = (Tie(kind="next_to", anchors=("table_1",)), Tie(kind="against_wall", anchors=("west_wall",)))
    texts = [text(CHAIR, (0.25, 0.25, 0.0)), text(CHAIR, (1.0, 2.5, 0.0)), text(CHAIR, (3.0, 4.5, 0.0))]
    assert reward(pool, "rules", texts, CHAIR, *ties) == [0.5, 0.5, 0.0]
    assert reward(pool, "rules", texts, CHAIR) == [None] * 3
    later = Tie(kind="next_to", anchors=("sofa_1",))
    assert reward(pool, "rules", texts, CHAIR, later) == [None] * 3


def test_reasoning_and_answer(pool: VerdictPool) -> None:
    """At 0.30 m from a wall that is said and 0.10 m off; 45 degrees off; both; and nothing said of it."""
    says = ["0.30 m from the west wall", "turned to 45 degrees", "0.30 m from the west wall, turned to 45 degrees"]
    texts = [text(CHAIR, (0.65, 2.0, 0.0), says=each) for each in (*says, "It looks well there.", "at (3.65, 2.00)")]
    assert reward(pool, "cons", texts) == pytest.approx([-0.1, -0.5, -0.3, -1.0, -1.0], abs=1e-6)


def test_what_reasoning_says_of_things_that_are_not_there_counts_for_nothing(pool: VerdictPool) -> None:
    assert reward(pool, "cons", [text(CHAIR, (0.65, 2.0, 0.0), says="0.50 m to the left of bed_7")]) == [-1.0]
