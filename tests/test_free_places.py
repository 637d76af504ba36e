"""Where there is space for a thing: what is said to be free is, and what a small model reads of it."""

import numpy as np
import pytest

from thinkblox.compact import IT, named
from thinkblox.episode import Episode
from thinkblox.free_places import Stretch, free_places
from thinkblox.generate import generate_room
from thinkblox.judging import asset_for
from thinkblox.observe import Layout, Sight
from thinkblox.placing import Effort
from thinkblox.plan import Target, Tie
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at
from thinkblox.sim.verdict.world import World

PROMPT = "An office, 5 m by 4 m, with a desk with a chair and a lamp on it, a wardrobe, a shelf, a plant and a clock."


@pytest.fixture(scope="module")
def episode() -> Episode:
    return generate_room(PROMPT, seed=3, effort=Effort(restarts=0)).episode


def target(category: str, *ties: Tie) -> Target:
    return Target(id=f"{category}_1", category=category, request=category, ties=ties)


def places(scene: Scene, wanted: Target) -> tuple[Stretch, ...]:
    return free_places(Layout.of(scene), wanted, asset_for(wanted, scene).card)


def test_an_empty_room_is_free_along_its_walls_but_at_the_door() -> None:
    door = Opening(id="door_1", kind="door", wall=0, offset=2.0, width=0.9, height=2.0)
    scene = Scene(prompt="", room=rectangle(4.0, 3.0, openings=(door,)))
    found = places(scene, target("bookcase", Tie(kind="against_wall", anchors=("wall",))))
    by = [stretch.by for stretch in found]
    assert by.count("north_wall") == 1
    assert by.count("south_wall") in (1, 2)
    (north,) = (stretch for stretch in found if stretch.by == "north_wall")
    assert north.yaw == 270.0
    assert abs(north.start[0] - north.end[0]) > 2.0


@pytest.mark.slow
def test_nine_of_ten_free_places_are_valid(episode: Episode) -> None:
    """Against the judge: any point of any line, for all that the expert had to place."""
    rng = np.random.default_rng(0)
    valid = []
    for decision in episode.decisions():
        seen = decision.observation
        scene = seen.__dict__["shown"][0]
        asset = seen.__dict__["shown"][1]
        for stretch in free_places(seen.layout, seen.target, seen.asset)[:2]:
            share = rng.random()
            x, y, z = (a * (1 - share) + b * share for a, b in zip(stretch.start, stretch.end, strict=True))
            placed = placed_at(scene, asset, id=seen.target.id, position=(x, y, z), yaw=stretch.yaw)
            valid += [verdict.valid for verdict in World(scene).check([placed], asset)]
    assert len(valid) >= 10
    assert np.mean(valid) >= 0.9


def test_what_is_carried_has_its_height(episode: Episode) -> None:
    for decision in episode.decisions():
        seen = decision.observation
        if seen.asset.mount == "surface":
            found = free_places(seen.layout, seen.target, seen.asset)
            assert found
            assert all(stretch.start[2] == stretch.end[2] > 0.3 for stretch in found)
            return
    pytest.fail("nothing stands on anything")


def test_compact_words_say_numbers_as_answers_do(episode: Episode) -> None:
    seen = next(d.observation for d in episode.decisions() if d.observation.layout.placements)
    (message,) = seen.chat(Sight(words="compact", pictures=False))
    lines = message.text.splitlines()
    assert lines[0].startswith("room 5.0 4.0 high ")
    assert any(line.startswith(f'place {seen.target.category} "{IT}" ') for line in lines)
    assert named('{"id": "it_1"}', seen.target.id) == f'{{"id": "{seen.target.id}"}}'
    assert any(line.startswith("free ") for line in lines)
    assert len(message.text) < len(seen.text()) / 4


def test_distance_is_to_the_nearest_point_of_the_line() -> None:
    stretch = Stretch("north_wall", 0.0, (1.0, 0.0, 0.0), (3.0, 0.0, 0.0))
    assert [round(stretch.distance(place), 3) for place in ((2.0, 0.5, 0.0), (4.0, 0.0, 0.0), (1.0, 0.0, 0.0))] == [
        0.5,
        1.0,
        0.0,
    ]
