"""Settings with which nothing can be measured are refused where they are made, by the name of the field."""

import math

import pytest

from tests.sim_rooms import asset, put, scene
from thinkblox.errors import InputError
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.verdict.verify import verify
from thinkblox.sim.verdict.world import World
from thinkblox.value import from_json

CRATE = asset("crate", (0.5, 0.5, 0.5))


@pytest.mark.parametrize(
    ("kind", "name", "value"),
    [
        (Physics, "settle_time", 0),
        (Physics, "settle_time", 0.0),
        (Physics, "settle_time", 1e-12),
        (Physics, "settle_time", -1.0),
        (Physics, "settle_time", math.inf),
        (Physics, "timestep", 0.0),
        (Physics, "timestep", math.nan),
        (Physics, "chunk", 0),
        (Physics, "chunk", 10**9),
        (Physics, "rest_time", -0.1),
        (Physics, "hold_time", math.nan),
        (Physics, "lost", 0.0),
        (Physics, "wall_thickness", 0.0),
        (Physics, "gravity", (0.0, 0.0, math.nan)),
        (Physics, "solref", (math.inf, 1.0)),
        (Tolerances, "drift", -0.001),
        (Tolerances, "penetration", math.nan),
        (Walking, "width", 0.0),
        (Walking, "reach", -1.0),
    ],
)
def test_what_cannot_be_used_is_refused_by_its_name(kind: type, name: str, value: object) -> None:
    with pytest.raises(InputError, match=rf"{kind.__name__}\.{name}(\[\d\])? is "):
        kind(**{name: value})


def test_it_is_refused_in_a_file_too() -> None:
    with pytest.raises(InputError, match=r"settings.json.*settle_time"):
        from_json(b'{"settle_time": 0}', Physics, where="settings.json")


@pytest.mark.parametrize(
    "physics",
    [
        Physics(settle_time=0.004),
        Physics(rest_time=0.0, hold_time=0.0),
        Physics(chunk=1),
    ],
    ids=["one step", "no rest and no hold", "a look each step"],
)
def test_the_least_that_is_allowed_gives_a_verdict(physics: Physics) -> None:
    room = scene(None, (put(CRATE, 2.0, 2.0), CRATE))
    assert verify(room, physics=physics).objects[0].id == "crate_1"
    assert World(room, physics=physics).check([put(CRATE, 1.0, 1.0, id="crate_2")], CRATE)[0].settled
