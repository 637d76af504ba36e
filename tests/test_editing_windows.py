"""What hangs on walls stays off windows, unless an instruction says so."""

from tests.edited_rooms import built, room
from tests.test_editing_guard import done
from thinkblox import edit_room
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.scene.windows import covered_openings


def _with_sideboard_at_window(x: float) -> Scene:
    """A sideboard at the wall of a window that is between x = 3.6 and 5.2 m, and a picture on another wall."""
    return built(room(), ("sideboard_1", x, 4.75, 270.0, "floor"), ("picture_1", 5.984, 1.0, 180.0, "wall"))


def test_a_picture_goes_beside_the_window_over_what_stands_there() -> None:
    after = done(_with_sideboard_at_window(3.2), "Hang the picture above the sideboard").scene
    assert measure(after, "above", "picture_1", ("sideboard_1",)).holds
    assert not covered_openings(after.room, after["picture_1"])


def test_a_picture_is_not_hung_on_the_glass() -> None:
    (failed,) = edit_room(_with_sideboard_at_window(4.4), "Hang the picture above the sideboard").failed
    assert "picture_1 was left where it is" in failed


def test_a_low_plant_is_next_to_the_window_that_it_stands_below() -> None:
    before = built(room(), ("potted_plant_1", 0.3, 0.5, 0.0, "floor"))
    after = done(before, "Move the plant next to the window").scene
    assert after["potted_plant_1"].position[1] > 4.0


def test_a_television_that_is_hung_becomes_one_that_hangs() -> None:
    before = built(room(), ("tv_stand_1", 3.0, 0.3, 90.0, "floor"), ("tv_1", 3.0, 0.3, 90.0, "tv_stand_1"))
    after = done(before, "Hang the TV on the wall").scene
    assert after["tv_1"].support.endswith("_wall")
