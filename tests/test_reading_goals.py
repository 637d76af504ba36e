"""What a robot is to do with things, which is not where they are when the room is made."""

import pytest

from tests.test_reading_asides import told


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "The robot must put the three cans into the bin. Three soda cans lie on the floor. The bin is by the door.",
            {"soda_can": 3, "waste_bin": 1},
            {"soda_can on floor", "waste_bin next_to door"},
        ),
        (
            "A kitchen. The robot's task: put the mug on the desk. The mug is on the kitchen table.",
            {"cup": 1, "desk": 1, "kitchen_table": 1},
            {"cup on kitchen_table"},
        ),
        (
            "The goal is to stack the cubes on the tray. Four cubes and a tray lie on the desk.",
            {"cube": 4, "tray": 1, "desk": 1},
            {"cube on desk", "tray on desk"},
        ),
        (
            "A desk with a red cube and a plate on it. The arm has to pick the red cube and place it on the plate.",
            {"cube": 1, "plate": 1, "desk": 1},
            {"cube on desk", "plate on desk"},
        ),
    ],
)
def test_goal_is_not_the_start(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("Put the mug on the desk.", "cup on desk"),
        ("A robot arm stands on the desk.", "robot_arm on desk"),
        ("A robotics lab. Place a crate on the desk.", "crate on desk"),
    ],
)
def test_orders_to_the_furnisher_are_kept(prompt: str, relation: str) -> None:
    assert relation in told(prompt)[1]
