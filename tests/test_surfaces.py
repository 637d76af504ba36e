"""What rooms are finished with: by the prompt, the type of room and the seed, kept in the room and in every output."""

from collections.abc import Sequence
from itertools import pairwise

import msgspec
import mujoco
import numpy as np
import pytest
from msgspec.structs import replace

from thinkblox.errors import InputError
from thinkblox.exporters.inventory import Inventory
from thinkblox.exporters.mjcf import mjcf_text
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.knowledge.rooms import room_types
from thinkblox.knowledge.surfaces import colour_from, finishes
from thinkblox.planning import plan_brief, plan_room, with_surfaces
from thinkblox.reading import GrammarBriefer
from thinkblox.scene.room import Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scene.surfaces import Covering, Surfaces
from thinkblox.sim.render import render_preview, render_top
from thinkblox.sim.render.layings import MAKES, colours
from thinkblox.value import from_json, to_json


def finished(prompt: str, seed: int = 0) -> Room:
    brief = GrammarBriefer().brief(prompt)
    return with_surfaces(plan_room(brief, rng=seed), brief, seed)


def surfaces(prompt: str, seed: int = 0) -> Surfaces:
    found = finished(prompt, seed).surfaces
    assert found is not None
    return found


def difference(first: object, second: object) -> float:
    return float(np.abs(np.asarray(first).astype(int) - np.asarray(second).astype(int)).mean())


def test_the_same_prompt_and_seed_give_the_same_finish() -> None:
    assert to_json(finished("A bedroom with a bed", 3)) == to_json(finished("A bedroom with a bed", 3))


@pytest.mark.parametrize(
    "prompt", ["A bedroom with a bed", "A kitchen with a stove", "A gym", "A clinic", "A workshop"]
)
def test_two_rooms_in_a_row_do_not_look_alike(prompt: str) -> None:
    found = [surfaces(prompt, seed) for seed in range(6)]
    assert all(a.palette != b.palette for a, b in pairwise(found))
    pictures = [render_preview(Scene(room=finished(prompt, seed)), size=96) for seed in range(2)]
    assert difference(*pictures) > 1.0


def test_floors_fit_the_type_of_room() -> None:
    def floors(prompt: str) -> set[str]:
        return {surfaces(prompt, seed).floor.laying for seed in range(8)}

    assert floors("A garage with a car lift") == {"concrete"}
    assert floors("A gym with a treadmill") == {"rubber"}
    assert floors("A bathroom with a toilet") <= {"tiles", "stone", "checker", "terrazzo", "marble"}
    assert floors("A clinic with a desk") <= {"linoleum", "terrazzo", "tiles"}
    assert "carpet" in floors("A bedroom with a bed")
    assert floors("A server room with two server racks") <= {"tiles", "rubber", "linoleum"}
    assert floors("A greenhouse with a potting bench") <= {"stone", "concrete", "brick", "tiles"}
    assert floors("A victorian greenhouse with a potting bench") <= {"stone", "concrete", "brick", "tiles"}
    assert all(surfaces("A bathroom with a toilet", seed).dado is not None for seed in range(4))


def test_every_type_of_room_has_a_finish_and_every_palette_is_colours() -> None:
    known = finishes()
    assert set(known.rooms) <= set(room_types())
    assert [name for name in room_types() if known.of(name) is None] == []
    assert len(known.palettes) >= 12
    for palette in known.palettes.values():
        assert all(0.0 <= c <= 1.0 for code in msgspec.structs.astuple(palette) for c in colour_from(code))
    for usual in (*known.rooms.values(), *known.styles.values()):
        assert set(usual.palettes) <= set(known.palettes)
    assert all(usual.floor and usual.walls for usual in known.rooms.values())


def test_the_prompt_goes_before_the_type_of_room() -> None:
    found = surfaces("A gym with white walls, a wooden floor and a treadmill")
    assert found.floor.laying == "planks"
    assert found.walls.laying == "paint"
    assert min(found.walls.colour) > 0.9
    assert found.accent is None


def test_an_exposed_brick_wall_is_one_wall() -> None:
    found = surfaces("A bedroom with an exposed brick wall and a bed")
    assert found.accent is not None
    assert found.accent.laying == "brick"
    assert found.walls.laying != "brick"


def test_panelling_and_paper_share_a_wall() -> None:
    found = surfaces("A study with wood panelling, striped wallpaper and a desk")
    assert found.dado is not None
    assert (found.dado.laying, found.walls.laying) == ("panels", "stripes")


def test_a_room_that_came_with_its_own_surfaces_keeps_them_and_says_so() -> None:
    brief = GrammarBriefer().brief("A bedroom with brick walls and a bed")
    plain = Covering(laying="paint", colour=(0.9, 0.9, 0.9))
    own = replace(rectangle(4.0, 4.0), surfaces=Surfaces(floor=plain, walls=plain))
    assert with_surfaces(own, brief, 0) == own
    assert "the walls are not as asked: brick walls" in plan_brief(brief, own).notes
    assert not plan_brief(brief, with_surfaces(rectangle(4.0, 4.0), brief, 0)).notes


def test_a_room_from_before_still_loads_and_is_shown() -> None:
    room = from_json(b'{"floor": [[0, 0], [3, 0], [3, 3], [0, 3]]}', Room)
    assert room.surfaces is None
    assert Scene(room=room, seed=5).surfaces == Scene(room=room, seed=5).surfaces
    assert np.asarray(render_preview(Scene(room=room), size=48)).std() > 5


def test_an_accent_on_no_wall_is_refused() -> None:
    plain = Covering(laying="paint", colour=(0.9, 0.9, 0.9))
    with pytest.raises(InputError, match="accent_wall is 7; walls are 0 to 3"):
        replace(rectangle(3.0, 3.0), surfaces=Surfaces(floor=plain, walls=plain, accent_wall=7))


def test_exports_have_the_colours_of_floor_and_walls() -> None:
    room = finished("A living room with blue walls and a marble floor")
    inventory: Inventory = inventory_of(Scene(room=room))
    assert room.surfaces is not None
    looks = {wall.name: inventory.looks[wall.look] for wall in inventory.walls}
    assert looks["floor"].colour == pytest.approx(room.surfaces.floor.colour)
    assert looks["north_wall"].colour == pytest.approx(room.surfaces.walls.colour)
    model = mujoco.MjModel.from_xml_string(mjcf_text(inventory))
    seen = model.geom("north_wall_visual")
    assert model.mat_rgba[int(seen.matid[0])] == pytest.approx((*room.surfaces.walls.colour, 1.0), abs=1e-4)


@pytest.mark.parametrize("laying", sorted(MAKES))
@pytest.mark.parametrize("floor", [True, False])
def test_every_laying_keeps_about_its_colour_near_and_far(laying: str, floor: bool) -> None:
    x, y = (axis.ravel().astype(np.float32) for axis in np.meshgrid(np.linspace(0, 4, 120), np.linspace(0, 2.6, 90)))
    covering = Covering(laying=laying, colour=(0.6, 0.5, 0.4), second=(0.5, 0.45, 0.4))  # type: ignore[arg-type]
    for width in (0.001, 0.05):
        found = colours(covering, x, y, np.full_like(x, width), floor=floor)
        assert found.shape == (len(x), 3)
        assert np.isfinite(found).all()
        assert found.min() >= 0.0
        assert np.abs(found.mean(0) - (0.319, 0.214, 0.133)).max() < 0.09


def _tones(laying: str, width: float) -> np.ndarray:
    """Brightness on a grid of points 5 mm apart, 2.4 m square."""
    side = np.arange(480, dtype=np.float32) * np.float32(0.005)
    x, y = (axis.ravel() for axis in np.meshgrid(side, side))
    covering = Covering(laying=laying, colour=(0.6, 0.58, 0.55))  # type: ignore[arg-type]
    found = colours(covering, x, y, np.full_like(x, width), floor=True).mean(1)
    return np.asarray(found.reshape(480, 480) / found.mean())


@pytest.mark.parametrize("laying", ["carpet", "linoleum"])
def test_soft_floors_have_a_grain_and_no_clouds(laying: str) -> None:
    tones = _tones(laying, 0.008)
    patches = tones.reshape(8, 60, 8, 60).mean((1, 3))
    assert patches.std() < 0.25 * tones.std()
    assert tones.std() > 0.015


def test_terrazzo_lies_still_from_afar() -> None:
    assert _tones("terrazzo", 0.002).std() > 0.05
    assert _tones("terrazzo", 0.02).std() < 0.025


def test_walls_and_floor_are_seen_in_their_colours() -> None:
    def seen(prompt: str) -> Sequence[float]:
        picture = np.asarray(render_top(Scene(room=finished(prompt)), size=96)).astype(float)
        return list(picture[44:52, 44:52].reshape(-1, 3).mean(0))

    red, green, blue = seen("A room with a red carpeted floor")
    assert red > green + 30
    red, green, blue = seen("A room with a blue carpeted floor")
    assert blue > red + 20
