"""What MuJoCo's cameras see of an exported room, for the pictures of docs/interop.md."""

import mujoco
import numpy as np
import pytest

from tests.bench.cameras import TILE, seen_of
from tests.environment_rooms import robot_room


@pytest.mark.slow
def test_each_camera_sees_the_room_beside_our_preview() -> None:
    try:
        mujoco.Renderer(mujoco.MjModel.from_xml_string("<mujoco/>"), 8, 8).close()
    except (RuntimeError, ImportError, AttributeError, mujoco.FatalError) as error:
        pytest.skip(f"nothing draws by OpenGL here: {error}")
    pictures = list(seen_of(robot_room()))
    assert len(pictures) == 1 + 2 + 4
    assert all(picture.size == TILE and np.asarray(picture).std() > 10.0 for picture in pictures)
