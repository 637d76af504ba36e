"""Whatever is built holds what its fields promise: in Python, by replacing a field, and from JSON."""

import json
import math
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import structs

from thinkblox.brief import Brief, OpeningRequest, Relation, Request
from thinkblox.checked import CheckedValue
from thinkblox.errors import InputError
from thinkblox.importing.frames import about, split_yaw
from thinkblox.phrases import constraints
from thinkblox.plan import Plan, Target, Tie
from thinkblox.scene.asset import MAX_LINKS, MAX_SHAPES, Asset, Joint, Link, Shape, Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.verdict.world import CANDIDATE
from thinkblox.value import from_json, read_json, to_json

SHAPE = Shape(kind="box", size=(1.0, 1.0, 1.0), position=(0.0, 0.0, 0.5))
JOINT = Joint(kind="hinge", axis=(0.0, 0.0, 1.0), anchor=(0.0, 0.0, 0.0), lower=0.0, upper=90.0)
LINK = Link(name="body", shapes=(SHAPE,))
VALUES: dict[type[CheckedValue], Any] = {
    type(value): value
    for value in (
        Placement(
            id="bed_1", category="bed", asset="bed-0", position=(1.0, 2.0, 0.0), yaw=90.0, size=(2.0, 1.6, 1.0),
            support="floor",
        ),
        SHAPE,
        JOINT,
        LINK,
        Surface(name="top", position=(0.0, 0.0, 1.0), size=(1.0, 1.0), headroom=0.3),
        Asset(
            id="box-0", category="box", description="a box", size=(1.0, 1.0, 1.0), mass=10.0, friction=0.6,
            mount="floor", links=(LINK,),
        ),
        Opening(id="door_1", kind="door", wall=0, offset=1.0, width=0.9, height=2.0),
        rectangle(4.0, 3.0),
        Tolerances(),
        Physics(),
        Walking(),
        Request(key="bed", category="bed", size=(2.0, 1.6, None)),
        Relation(kind="on", subject="lamp", anchors=("table",)),
        OpeningRequest(kind="door"),
        Brief(prompt="a room", width=4.0, depth=3.0, area=12.0, height=2.5),
        Tie(kind="on"),
        Target(id="bed_1", category="bed", request="bed", size=(2.0, 1.6, None)),
        Plan(brief=Brief(prompt="a room")),
    )
}  # fmt: skip
DOOR = json.dumps({"id": "door_1", "kind": "door", "wall": 0, "offset": 1, "width": 0.9, "height": 2.0})
NUMBERS = [
    pytest.param(kind, path, id=f"{kind.__name__}.{'.'.join(map(str, path))}")
    for kind, value in VALUES.items()
    for field in value.__struct_fields__
    for path in [
        (field, *rest)
        for rest in (
            [()]
            if type(getattr(value, field)) is float
            else [(i,) for i, part in enumerate(getattr(value, field)) if type(part) is float]
            if isinstance(getattr(value, field), tuple)
            else []
        )
    ]
]


def with_number(value: CheckedValue, path: tuple[str | int, ...], number: float) -> CheckedValue:
    """The value with one number of one of its fields replaced."""
    field, old = str(path[0]), getattr(value, str(path[0]))
    new = number if len(path) == 1 else tuple(number if i == path[1] else part for i, part in enumerate(old))
    return structs.replace(value, **{field: new})


def test_every_kind_has_numbers_to_try():
    assert len(NUMBERS) > 60


@pytest.mark.parametrize("number", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize(("kind", "path"), NUMBERS)
def test_what_is_not_a_finite_number_is_refused_by_its_field(kind, path, number):
    with pytest.raises(InputError, match=str(path[0])):
        with_number(VALUES[kind], path, number)


@pytest.mark.parametrize(("kind", "path"), NUMBERS)
def test_json_that_python_refuses_is_refused_for_the_same_field(kind, path):
    """-1e300 is below the least of every number there is here."""
    with pytest.raises(InputError, match=str(path[0])):
        with_number(VALUES[kind], path, -1e300)
    document = json.loads(to_json(VALUES[kind]))
    holder = document
    defaults = json.loads(json.dumps(structs.asdict(VALUES[kind]), default=structs.asdict))
    holder.setdefault(path[0], defaults[path[0]])
    for step in path[:-1]:
        holder = holder[step]
    holder[path[-1]] = -1e300
    with pytest.raises(InputError, match=str(path[0])):
        from_json(json.dumps(document), kind)


@pytest.mark.parametrize("kind", VALUES, ids=lambda kind: kind.__name__)
def test_what_is_whole_survives_being_written_and_read(kind):
    assert from_json(to_json(VALUES[kind]), kind) == VALUES[kind]


finite = st.floats(allow_nan=False, allow_infinity=False)


@given(st.sampled_from(["position", "size"]), st.integers(0, 2), finite | st.floats())
def test_python_and_json_agree_on_any_number_of_a_placement(field, index, number):
    bed = VALUES[Placement]
    document = json.loads(to_json(bed))
    document[field][index] = number
    if (0.0 < number <= 100.0) if field == "size" else abs(number) <= 1000.0:
        there = with_number(bed, (field, index), number)
        assert from_json(to_json(there), Placement) == from_json(json.dumps(document), Placement) == there
        return
    with pytest.raises(InputError, match=f"placement bed_1: {field}"):
        with_number(bed, (field, index), number)
    with pytest.raises(InputError):
        from_json(json.dumps(document), Placement)


REFUSED = {
    "an id with a line break": (Placement, {"id": "bed_1\n"}, "id"),
    "an id with an escape": (Placement, {"id": "bed\x1b[31m"}, "id"),
    "an id that is a number": (Placement, {"id": 3}, "id"),
    "two coordinates": (Placement, {"position": (1.0, 2.0)}, "position"),
    "an opening's id with a line break": (Opening, {"id": "door_1\n"}, "id"),
    "half a wall": (Opening, {"wall": 0.5}, "wall"),
    "a low room": (Room, {"height": 0.5}, "height"),
    "a quaternion of length 1.4": (Shape, {"quat_wxyz": (1.0, 0.0, 0.0, 1.0)}, "quat_wxyz"),
    "a quaternion of 0": (Shape, {"quat_wxyz": (0.0, 0.0, 0.0, 0.0)}, "quat_wxyz"),
    "a quaternion just off": (Shape, {"quat_wxyz": (1.000002, 0.0, 0.0, 0.0)}, "quat_wxyz"),
    "a shape far away": (Shape, {"position": (0.0, 0.0, 1e300)}, "position"),
    "a huge shape": (Shape, {"size": (1.0, 1e300, 1.0)}, r"size\[1\]"),
    "a flat hull": (Shape, {"kind": "hull", "points": ((0.0, 0.0, 0.0),) * 4}, "points"),
    "a colour past white": (Shape, {"colour": (0.0, 1.5, 0.0)}, r"colour\[1\]"),
    "an axis of length 2": (Joint, {"axis": (0.0, 0.0, 2.0)}, "axis"),
    "an axis of 1e300": (Joint, {"axis": (0.0, 0.0, 1e300)}, "axis"),
    "a range the wrong way round": (Joint, {"lower": 100.0}, "lower"),
    "a link without shapes": (Link, {"shapes": ()}, "shapes"),
    "a link without a name": (Link, {"name": ""}, "name"),
    "two links of one name": (Asset, {"links": (LINK, LINK)}, "links"),
    "too many links": (
        Asset, {"links": tuple(structs.replace(LINK, name=f"l{i}") for i in range(MAX_LINKS + 1))}, "links",
    ),
    "too many shapes": (Asset, {"links": (Link(name="b", shapes=(SHAPE,) * (MAX_SHAPES + 1)),)}, "links"),
    "no mass": (Asset, {"mass": 0.0}, "mass"),
    "another mount": (Asset, {"mount": "roof"}, "mount"),
    "no time to settle": (Physics, {"settle_time": 0.0}, "settle_time"),
    "no timestep": (Physics, {"timestep": 0.0}, "timestep"),
    "a settle of less than a step": (Physics, {"settle_time": 0.001}, "settle_time"),
    "looking after no step": (Physics, {"chunk": 0}, "chunk"),
    "contacts faster than two timesteps": (Physics, {"timestep": 0.005}, "solref"),
    "a share of two": (Tolerances, {"opens": 2.0}, "opens"),
    "a walker without width": (Walking, {"width": 0.0}, "width"),
    "none of them": (Request, {"count": 0}, "count"),
    "too many of them": (Request, {"count": 201}, "count"),
    "a sofa of no width": (Request, {"size": (None, 0.0, None)}, r"size\[1\]"),
    "a relation that there is not": (Relation, {"kind": "beneath"}, "kind"),
    "number -1 of its request": (Target, {"index": -1}, "index"),
}  # fmt: skip


@pytest.mark.parametrize(("kind", "change", "field"), REFUSED.values(), ids=REFUSED)
def test_a_field_out_of_range_is_named(kind, change, field):
    with pytest.raises(InputError, match=field):
        structs.replace(VALUES[kind], **change)


def test_the_message_says_whose_field_it_is_and_what_it_holds():
    with pytest.raises(InputError, match=r"placement bed_1: yaw is nan; expected float"):
        structs.replace(VALUES[Placement], yaw=math.nan)
    with pytest.raises(InputError, match=r"OpeningRequest\.count is -3; expected int >= 0"):
        OpeningRequest(kind="door", count=-3)


@pytest.mark.parametrize("name", ["floor", "ceiling", "north_wall", "south_wall"])
def test_an_opening_is_not_called_as_a_part_of_the_room_is(name):
    door = structs.replace(VALUES[Opening], id=name)
    with pytest.raises(InputError, match=f"'{name}'.*part of the room"):
        rectangle(4.0, 3.0, openings=(door,))


@given(st.floats(-1e-6, 1e-6))
def test_a_turn_of_almost_nothing_is_never_a_whole_one(yaw):
    [constraint] = constraints(f"It is turned to {yaw:.6f} degrees.")
    assert 0.0 <= constraint.values[0] < 360.0
    turned, rest = split_yaw(about("z", yaw))
    assert 0.0 <= turned < 360.0
    assert np.isfinite(rest).all()


def test_numbers_of_numpy_become_plain_ones():
    there = structs.replace(
        VALUES[Placement], position=(np.float64(1.0), np.float32(2.0), np.int64(0)), yaw=np.float64(90.0)
    )
    assert there == VALUES[Placement]
    assert [type(number) for number in (*there.position, there.yaw)] == [float, float, float, float]
    assert type(structs.replace(VALUES[Physics], chunk=np.int32(5)).chunk) is int
    with pytest.raises(InputError, match=r"yaw is nan"):
        structs.replace(VALUES[Placement], yaw=np.float64(math.nan))


def test_no_placement_can_be_called_as_the_candidate_is():
    with pytest.raises(InputError, match="id"):
        structs.replace(VALUES[Placement], id=CANDIDATE)


def test_what_is_in_a_value_is_kept_and_not_made_anew():
    asset = VALUES[Asset]
    assert structs.replace(asset, mass=3.0).links[0] is asset.links[0]


def test_parts_of_unit_length_may_be_rounded():
    assert structs.replace(VALUES[Shape], quat_wxyz=(0.7071068, 0.0, 0.7071068, 0.0))


@pytest.mark.parametrize(
    ("text", "key"),
    [
        ('{"height": 2.5, "floor": [[0, 0], [4, 0], [4, 3]], "height": 3.0}', "height"),
        ('{"floor": [[0, 0], [4, 0], [4, 3]], "hei\\u0067ht": 2.5, "height": 2.5}', "height"),
        (f'{{"floor": [[0, 0], [4, 0], [4, 3]], "openings": [{DOOR[:-1]}, "width": 0.8}}]}}', "width"),
    ],
    ids=["of the room", "spelt otherwise", "of an opening"],
)
def test_a_key_that_stands_twice_is_refused(tmp_path, text, key):
    (tmp_path / "room.json").write_text(text)
    with pytest.raises(InputError, match=f"room.json: .*'{key}' twice"):
        read_json(tmp_path / "room.json", Room)


def test_keys_of_different_objects_may_be_the_same(tmp_path):
    doors = tuple(structs.replace(VALUES[Opening], id=f"door_{n}", wall=n) for n in range(3))
    room = rectangle(4.0, 3.0, openings=doors)
    (tmp_path / "room.json").write_bytes(to_json(room))
    assert read_json(tmp_path / "room.json", Room) == room


def test_msgspec_alone_takes_the_last_of_two_keys():
    """Why files are read once more: when this fails, `_refuse_double_keys` can go."""
    assert msgspec.json.decode(b'{"a": 1, "a": 2}') == {"a": 2}
