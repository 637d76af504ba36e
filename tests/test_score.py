"""The score of a room by interior guidelines: what lowers and raises each part, and rooms that have little to score."""

import json
import math
import subprocess
import sys
from pathlib import Path

import pytest

import thinkblox
from thinkblox.assets import make_asset
from thinkblox.errors import InputError
from thinkblox.importing import read_layout
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scoring import WEIGHTS, score

DOOR = Opening(id="door_1", kind="door", wall=0, offset=0.3, width=0.9, height=2.1)
WINDOW = Opening(id="window_1", kind="window", wall=2, offset=1.5, width=1.5, height=1.2, sill=0.9)


def room(*things, size=(5.0, 4.0), openings=(DOOR, WINDOW)):
    """A scene of (category, x, y, yaw[, words]) things on the floor; a second one of a kind is its _2."""
    scene = Scene(room=rectangle(*size, openings=openings))
    counts: dict[str, int] = {}
    for category, x, y, yaw, *words in things:
        counts[category] = counts.get(category, 0) + 1
        asset = make_asset(category, seed=0, attributes=tuple(words))
        id = f"{category}_{counts[category]}"
        at = Placement(id=id, category=category, asset=asset.id, position=(x, y, 0.0), yaw=yaw, size=asset.size)
        scene = scene.with_placement(at, asset)
    return scene


def of(name, *things, **options):
    return score(room(*things, **options)).part(name)


def total(scene):
    found = score(scene).total
    assert found is not None
    return found


def depth(category, *words):
    return make_asset(category, seed=0, attributes=words).size[0]


def test_total_is_the_weighted_mean():
    whole = score(room(("bed", 2.5, 3.0, 270, "double"), ("wardrobe", 4.6, 1.0, 180)))
    counted = [(part.score, part.weight) for part in whole.parts if part.score is not None]
    mean = sum(score * weight for score, weight in counted) / sum(weight for _, weight in counted)
    assert whole.total == pytest.approx(mean, abs=1e-3)
    assert [part.name for part in whole.parts] == list(WEIGHTS)
    assert all(0.0 <= score <= 1.0 for score, _ in counted)


def test_a_wardrobe_that_cannot_be_opened():
    free = of("clearance", ("wardrobe", 4.6, 2.0, 180))
    shut = of("clearance", ("wardrobe", 4.6, 2.0, 180), ("sideboard", 3.9, 2.0, 0))
    assert free.score == 1.0
    assert shut.score < 0.8
    assert "needs is free" in shut.worst


def test_a_chair_is_drawn_aside():
    assert of("clearance", ("wardrobe", 4.6, 2.0, 180), ("chair", 3.9, 2.0, 0)).score == 1.0


def test_the_swing_of_a_door():
    assert of("clearance", ("bookcase", 0.8, 0.3, 90)).worst.endswith("before door_1 is free")


def test_a_wall_of_cupboards_cuts_the_room():
    open_ = of("circulation", ("bed", 2.5, 3.0, 270))
    row = [("bookcase", 0.45 + 0.8 * n, 2.0, 90) for n in range(6)]
    cut = of("circulation", ("bed", 2.5, 3.2, 270), *row, openings=(DOOR,))
    assert open_.score == pytest.approx(1.0, abs=0.01)
    assert cut.score < 0.9
    assert cut.numbers["floor_reached"] < 0.8
    assert "bed_1" in cut.worst


@pytest.mark.parametrize(("gap", "good"), [(0.4, True), (0.02, False), (1.2, False)])
def test_the_coffee_table_before_its_sofa(gap, good):
    x = 0.5 + depth("sofa") / 2 + gap + depth("coffee_table") / 2
    part = of("distances", ("sofa", 0.5, 2.0, 0), ("coffee_table", x, 2.0, 0))
    assert (part.score > 0.9) is good


def test_a_chair_that_looks_away_from_its_table():
    away = 2.5 + depth("kitchen_table") / 2 + depth("chair") / 2 - 0.1
    to = of("distances", ("kitchen_table", 2.5, 2.0, 0), ("chair", away, 2.0, 180))
    off = of("distances", ("kitchen_table", 2.5, 2.0, 0), ("chair", away, 2.0, 0))
    assert to.score == 1.0
    assert off.score == 0.0


def test_armchairs_that_face_talk():
    facing = of("conversation", ("armchair", 1.0, 2.0, 0), ("armchair", 3.4, 2.0, 180))
    averted = of("conversation", ("armchair", 1.0, 2.0, 180), ("armchair", 3.4, 2.0, 0))
    far = of("conversation", ("armchair", 0.5, 2.0, 0), ("armchair", 7.5, 2.0, 180), size=(8.0, 4.0))
    assert facing.score == 1.0
    assert averted.score == 0.0
    assert far.score == 0.0


def test_furniture_on_one_side():
    spread = of("balance", ("wardrobe", 0.4, 2.0, 0), ("wardrobe", 4.6, 2.0, 180))
    heaped = of("balance", ("wardrobe", 0.4, 1.0, 0), ("wardrobe", 0.4, 3.0, 0))
    assert spread.score == pytest.approx(1.0, abs=0.01)
    assert heaped.score < 0.5
    assert heaped.numbers["offset"] == pytest.approx(2.1, abs=0.01)


def test_a_bed_askew_and_off_its_wall():
    straight = of("alignment", ("bed", 4.0 - depth("bed") / 2 + 1.0, 2.0, 180))
    askew = of("alignment", ("bed", 2.5, 2.0, 200))
    assert straight.score == 1.0
    assert askew.score < 0.5


def test_a_sofa_with_its_back_to_the_television():
    def watching(yaw):
        return of("emphasis", ("tv_stand", 4.7, 2.0, 180), ("tv", 4.7, 2.0, 180), ("sofa", 1.5, 2.0, yaw))

    assert watching(0).score == 1.0
    assert watching(180).score == 0.0


def test_a_wardrobe_before_the_window():
    assert of("daylight", ("dresser", 2.2, 3.7, 270)).score == pytest.approx(1.0, abs=0.1)
    assert of("daylight", ("wardrobe", 2.2, 3.7, 270)).score < 0.6


def test_an_empty_room():
    empty = score(room())
    assert empty.total is None
    assert str(empty) == "nothing to score"


def test_one_object():
    alone = score(room(("plant", 2.5, 2.0, 0)))
    assert alone.total is not None
    assert 0.9 <= alone.total <= 1.0


def test_things_that_nobody_knows():
    scene = room(("wardrobe", 4.6, 2.0, 180), ("chair", 1.0, 2.0, 0))
    unknown = [
        Placement(id=f"thing_{n}", category="zzz_unheard_of", asset=p.asset, position=p.position, yaw=33.0, size=p.size)
        for n, p in enumerate(scene.placements, 1)
    ]
    strange = Scene(room=scene.room, placements=tuple(unknown), assets=scene.assets)
    assert 0.0 <= total(strange) <= 1.0


@pytest.mark.parametrize("name", ["idesign.json", "il3d.json", "sceneeval.json"])
def test_layouts_of_others(name):
    scene = read_layout(Path(__file__).parent / "data" / "layouts" / name).scene
    assert 0.0 < total(scene) <= 1.0


def test_not_a_scene():
    with pytest.raises(InputError, match="cannot be scored"):
        score("a room")  # type: ignore[arg-type]


def test_it_is_turned_with_its_room():
    """A quarter turn of everything changes nothing."""
    things = (("bed", 2.5, 2.9, 270, "double"), ("wardrobe", 4.6, 1.0, 180), ("chair", 1.0, 1.5, 30))
    openings = (DOOR,)
    turned = [(c, 4.0 - y, x, (yaw + 90) % 360, *words) for c, x, y, yaw, *words in things]
    door = Opening(id="door_1", kind="door", wall=1, offset=0.3, width=0.9, height=2.1)
    one, other = total(room(*things, openings=openings)), total(room(*turned, size=(4.0, 5.0), openings=(door,)))
    assert math.isclose(one, other, abs_tol=0.01)


def test_the_report_has_it():
    made = thinkblox.generate_room("A bedroom with a bed and a wardrobe", seed=3)
    assert made.report.score == thinkblox.score(made.scene)


@pytest.mark.slow
def test_verify_says_it(tmp_path):
    made = thinkblox.generate_room("A bedroom with a bed and a wardrobe", seed=3)
    thinkblox.save_scene(made.scene, tmp_path / "scene.json")
    done = subprocess.run(
        [sys.executable, "-m", "thinkblox", "verify", str(tmp_path / "scene.json")], capture_output=True, text=True
    )
    assert "interior guidelines, 0 to 1: " in done.stdout
    done = subprocess.run(
        [sys.executable, "-m", "thinkblox", "verify", "--json", str(tmp_path / "scene.json")],
        capture_output=True,
        text=True,
    )
    assert json.loads(done.stdout)["score"]["total"] == thinkblox.score(made.scene).total


def test_hundreds_of_things():
    """It takes no longer than a person waits."""
    rows = [("armchair", 1.0 + 1.5 * (n % 20), 1.0 + 1.5 * (n // 20), 0) for n in range(400)]
    assert score(room(*rows, size=(32.0, 32.0))).total is not None
