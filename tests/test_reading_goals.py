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


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("The robot should pick up the mug on the desk and put it on the shelf.", {"cup on desk"}),
        ("The robot must fetch the book that lies on the sofa.", {"book on sofa"}),
        ("The robot takes the cup from the desk and brings it to the bookcase.", {"cup on desk"}),
        (
            "The robot has to carry the crate from the sofa to the workbench, which has a vise on it.",
            {"crate on sofa", "vise on workbench"},
        ),
        ("The robot must move the box to the table with four chairs around it.", {"chair around dining_table"}),
        (
            "The robot's goal is to put the toys lying on the floor into the toy box by the window.",
            {"toy on floor", "toy_box next_to window"},
        ),
        ("The robot must put the cup, the plate and the fork into the toolbox.", set()),
        (
            "The robot has to open the drawer of the dresser, which stands opposite the bed.",
            {"dresser opposite bed"},
        ),
        ("Task: move the box to the desk next to the door.", {"desk next_to door"}),
    ],
)
def test_goal_tells_where_things_are_now(prompt: str, relations: set[str]) -> None:
    assert told(prompt)[1] == relations


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("The robot stands in the middle. A desk is by the door.", {"robot in_centre centre", "desk next_to door"}),
        ("The robot is next to the desk and has to pick up the cup on the bed.", {"robot next_to desk", "cup on bed"}),
        ("The robot stands by the window. On its left is a desk.", {"robot next_to window", "desk left_of robot"}),
    ],
)
def test_robot_that_stands_somewhere_is_there(prompt: str, relations: set[str]) -> None:
    assert told(prompt)[1] == relations
