"""Rooms of one prompt differ from seed to seed in what the prompt leaves open, and in nothing else."""

import numpy as np
import pytest

from thinkblox.planning import plan_room, varied
from thinkblox.reading import GrammarBriefer, read_brief
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene

SEEDS = range(10)


def kinds(prompt, seed):
    return frozenset(request.category for request in varied(read_brief(prompt), seed).requests)


def test_a_mere_name_of_a_room_is_furnished_in_many_ways():
    assert len({kinds("A cosy living room", seed) for seed in SEEDS}) >= 6


@pytest.mark.parametrize("prompt", ["A cosy living room", "A bedroom", "A kitchen", "An office"])
def test_what_every_such_room_has_stays(prompt):
    from thinkblox.knowledge.rooms import room_type

    brief = read_brief(prompt)
    essential = {usual.category for usual in room_type(brief.room_type).expected}
    assert all(essential <= kinds(prompt, seed) for seed in SEEDS)


def test_a_prompt_that_names_its_things_gets_these():
    prompt = "A bedroom with a bed, a desk, a chair and a wardrobe"
    assert all(varied(read_brief(prompt), seed) == read_brief(prompt) for seed in SEEDS)


def test_what_is_named_stays():
    assert all("piano" in kinds("A living room with a piano", seed) for seed in SEEDS)


def test_what_is_not_wanted_does_not_come():
    assert not any("plant" in kinds("A living room without any plants", seed) for seed in SEEDS)


def test_named_alone_is_named_alone():
    brief = GrammarBriefer("named").brief("A cosy living room")
    assert all(varied(brief, seed) == brief for seed in SEEDS)


def test_relations_of_what_is_left_out_go_too():
    for seed in SEEDS:
        brief = varied(read_brief("A cosy living room"), seed)
        keys = {request.key for request in brief.requests}
        assert all(relation.subject in keys for relation in brief.relations)
        assert len(keys) == len(brief.requests)


def test_the_same_seed_gives_the_same():
    brief = read_brief("A cosy living room")
    assert varied(brief, 4) == varied(brief, 4)


def test_rooms_differ_in_size_and_openings():
    brief = read_brief("A home office with a desk and a chair")
    rooms = [plan_room(brief, rng=np.random.default_rng((seed, 0))) for seed in SEEDS]
    areas = [room.polygon.area for room in rooms]
    assert max(areas) > 1.1 * min(areas)
    assert len({opening.wall for room in rooms for opening in room.openings if opening.kind == "door"}) > 1
    assert len({opening.wall for room in rooms for opening in room.openings if opening.kind == "window"}) > 1


def test_a_size_that_is_given_is_kept():
    brief = read_brief("A bedroom, 4 m by 5 m, with a bed")
    assert {plan_room(brief, rng=np.random.default_rng((seed, 0))).extent for seed in SEEDS} == {(4.0, 5.0)}


def test_the_bench_measures_a_distance():
    from tests.bench.variety import distance

    one, other = Scene(room=rectangle(4.0, 3.0), seed=0), Scene(room=rectangle(8.0, 3.0), seed=0)
    assert distance(one, one).room == 0.0
    assert distance(one, other).room == pytest.approx(np.log(2.0) / 2)
