"""Sizes of rooms and things, however they are said."""

import numpy as np
import pytest

from thinkblox.planning import is_open, larger, plan_room
from thinkblox.reading import read_brief

ROOMS = [
    ("A bedroom measuring 3 m by 4 m. There is a bed.", "bedroom", (3.0, 4.0, None, None)),
    ("A bathroom measuring about 2.4 m by 3 m with a shower.", "bathroom", (2.4, 3.0, None, None)),
    ("A bathroom sized 2 m by 3 m with a toilet.", "bathroom", (2.0, 3.0, None, None)),
    ("A bedroom spanning 3 m by 4 m with a bed.", "bedroom", (3.0, 4.0, None, None)),
    ("A living room that measures 5 by 6 m has a sofa.", "living_room", (5.0, 6.0, None, None)),
    ("The office measures 4 m by 5 m. It has a desk.", "office", (4.0, 5.0, None, None)),
    ("A room measuring four metres by five metres, used as a bedroom.", "bedroom", (4.0, 5.0, None, None)),
    ("A 3mx4m bedroom with a bed.", "bedroom", (3.0, 4.0, None, None)),
    ("A bedroom with a width of 3 m and a length of 4 m. It has a bed.", "bedroom", (3.0, 4.0, None, None)),
    ("A bedroom. Length: 5 m, width: 4 m, height: 2.7 m.", "bedroom", (5.0, 4.0, None, 2.7)),
    ("Bedroom, width 4 m, depth 3 m, height 2.5 m, with a bed.", "bedroom", (4.0, 3.0, None, 2.5)),
    ("A 5-metre-long hallway, 1.5 m wide, with a coat rack.", "hallway", (5.0, 1.5, None, None)),
    ("The bedroom is 4 m wide and has a bed.", "bedroom", (4.0, None, None, None)),
    ("A bedroom with a ceiling height of 2.8 m and a bed.", "bedroom", (None, None, None, 2.8)),
    ("The bedroom has a bed and a ceiling height of 2.6 m.", "bedroom", (None, None, None, 2.6)),
    ("A bedroom with ceilings of 3 m and a bed.", "bedroom", (None, None, None, 3.0)),
    ("A bedroom with a 3 m high ceiling and a bed.", "bedroom", (None, None, None, 3.0)),
    ("A bedroom 10 feet by 12 feet with an 8 foot ceiling.", "bedroom", (3.048, 3.6576, None, 2.4384)),
    ("A bedroom with a bed. The ceiling height is 3 m.", "bedroom", (None, None, None, 3.0)),
    ("A dining room with a table with dimensions of 2 m by 1.2 m.", "dining_room", (None, None, None, None)),
]


@pytest.mark.parametrize(("prompt", "kind", "size"), ROOMS)
def test_a_room_is_as_large_as_is_said(
    prompt: str, kind: str, size: tuple[float | None, float | None, float | None, float | None]
) -> None:
    brief = read_brief(prompt)
    assert (brief.room_type, brief.unknown) == (kind, ())
    assert (brief.width, brief.depth, brief.area, brief.height) == pytest.approx(size)


@pytest.mark.parametrize(
    ("prompt", "thing", "size"),
    [
        ("A rug measuring 2 m by 3 m lies in the middle of the room.", "rug", (2.0, 3.0, None)),
        ("A dining room with a rug measuring 2 m by 3 m under the table.", "rug", (2.0, 3.0, None)),
        ("A dining room with a table that measures 2 m by 1.2 m.", "dining_table", (1.2, 2.0, None)),
        ("A dining room with a table with dimensions of 2 m by 1.2 m.", "dining_table", (1.2, 2.0, None)),
        ("A dining room with a table 2 m long and 1.2 m wide.", "dining_table", (1.2, 2.0, None)),
        ("A dining room with a table with a length of 2.4 m.", "dining_table", (None, 2.4, None)),
        ("A bedroom with a table with a height of 75 cm.", "table", (None, None, 0.75)),
        ("A round rug with a diameter of 2 m in a living room.", "rug", (2.0, 2.0, None)),
        ("Sofa: 2 m wide. Bookcase: 1.8 m tall.", "bookcase", (None, None, 1.8)),
        ("Table: width 1.2 m, depth 80 cm, height 75 cm.", "dining_table", (0.8, 1.2, 0.75)),
    ],
)
def test_a_thing_is_as_large_as_is_said(prompt: str, thing: str, size: tuple[float | None, ...]) -> None:
    brief = read_brief(prompt)
    assert not brief.unknown
    assert brief.request(thing).size == pytest.approx(size)
    assert (brief.width, brief.area, brief.height) == (None, None, None)


@pytest.mark.parametrize("prompt", ["A mirror hangs at a height of 1.5 m above the dresser.", "A shelf, 1 m off."])
def test_how_high_something_hangs_is_not_its_size(prompt: str) -> None:
    brief = read_brief(prompt)
    assert brief.unknown
    assert all(request.size == (None, None, None) for request in brief.requests)


@pytest.mark.parametrize("kind", ["bedroom", "hallway", "restaurant"])
@pytest.mark.parametrize("side", [2.0, 4.0, 9.0])
def test_one_side_of_a_room_is_kept(kind: str, side: float) -> None:
    brief = read_brief(f"The {kind} is {side:g} m wide and has a plant.")
    for seed in range(5):
        room = plan_room(brief, rng=np.random.default_rng(seed))
        assert room.extent[0] == pytest.approx(side)
        assert room.extent[1] >= 0.8
        assert is_open(brief)
        grown = plan_room(larger(brief, room, 1.4), rng=0)
        assert grown.extent[0] == pytest.approx(side)
        assert grown.extent[1] > room.extent[1]


def test_what_a_thing_measures_is_no_size_of_the_room() -> None:
    brief = read_brief("The room measures 4 m by 5 m. The rug measures 2 by 3 meters.")
    assert (brief.width, brief.depth) == (4.0, 5.0)
    assert [r.size for r in brief.requests if r.category == "rug"] == [(2.0, 3.0, None)]
    assert read_brief("The rug measures 2 m by 3 m.").width is None
