import math

import mujoco
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import structs

from tests.sim_rooms import asset, box, put, scene, wardrobe
from thinkblox.assets import make_asset
from thinkblox.scene.asset import Asset, Joint, Link, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec, compiled
from thinkblox.sim.geometry.swings import Surroundings, surroundings, swings
from thinkblox.sim.settings import Walking
from thinkblox.verdict import Swing

WARDROBE = wardrobe()
BLOCK = asset("block", (0.4, 3.0, 1.0), mass=100.0)
ROD = Shape(kind="cylinder", size=(0.03, 0.03, 1.8), position=(0.0, 0.0, 0.9))
POST = asset("post", (0.03, 0.03, 1.8), ROD, mass=50.0)
RADIUS, AHEAD, RANGE = math.hypot(0.02, 0.498), math.atan(0.02 / 0.498), 110.0
L_ROOM = Room(floor=((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)))


def chest(travel: float = 0.3, *, lid: bool = False, flap: bool = False) -> Asset:
    """A box 0.6 m deep with one drawer, or a lid hinged at its back, or a flap 0.5 m high hinged at its foot."""
    body = box((0.55, 0.8, 0.5), (-0.025, 0.0, 0.25))
    if lid:
        shape, joint = box((0.6, 0.8, 0.02), (0.0, 0.0, 0.51)), hinge((0.0, -1.0, 0.0), (-0.3, 0.0, 0.5), 80.0)
    elif flap:
        shape, joint = box((0.02, 0.8, 0.48), (0.26, 0.0, 0.26)), hinge((0.0, 1.0, 0.0), (0.27, 0.0, 0.02), 110.0)
    else:
        shape = box((0.05, 0.8, 0.3), (0.275, 0.0, 0.25))
        joint = Joint(kind="slide", axis=(1.0, 0.0, 0.0), anchor=(0.0, 0.0, 0.0), lower=0.0, upper=travel)
    return asset("chest", (0.6, 0.8, 0.52), body, links=(Link(name="front", shapes=(shape,), joint=joint),), mass=30.0)


def hinge(axis: tuple[float, float, float], anchor: tuple[float, float, float], upper: float) -> Joint:
    return Joint(kind="hinge", axis=axis, anchor=anchor, lower=0.0, upper=upper)


def of_one(found: tuple[Swing, ...], link: str) -> Swing:
    return next(swing for swing in found if swing.link == link)


@pytest.mark.parametrize("gap", [0.05, 0.1, 0.2, 0.3, 0.4, 0.45])
@pytest.mark.parametrize("yaw", [0.0, 90.0, 217.0])
def test_a_door_opens_until_its_edge_meets_what_stands_before_it(gap: float, yaw: float) -> None:
    """The edge of a door is at R sin(angle + phi) before its hinge, phi being where it starts."""
    here = put(WARDROBE, 5.0, 5.0, yaw=yaw)
    x, y = here.to_room((0.3 + gap + 0.2, 0.0))
    room = scene(rectangle(10.0, 10.0), (put(BLOCK, x, y, yaw=yaw), BLOCK))
    found = swings(room, here, WARDROBE)
    angle = math.degrees(math.asin((gap + 0.02 + 0.001) / RADIUS) - AHEAD)
    assert [(s.of, s.link, s.hits) for s in found] == [
        ("wardrobe_1", "door_left", ("block_1",)),
        ("wardrobe_1", "door_right", ("block_1",)),
    ]
    assert [s.opens for s in found] == pytest.approx([angle / RANGE] * 2, abs=0.02)


def test_a_door_with_room_before_it_opens() -> None:
    room = scene(rectangle(10.0, 10.0), (put(BLOCK, 6.03, 5.0), BLOCK))
    assert swings(room, put(WARDROBE, 5.0, 5.0), WARDROBE) == ()


@pytest.mark.parametrize("gap", [0.0, 0.1, 0.15, 0.29])
def test_a_drawer_slides_until_it_meets_something(gap: float) -> None:
    kind = chest()
    found = swings(scene(None, (put(BLOCK, 2.5 + gap, 2.0), BLOCK)), put(kind, 2.0, 2.0), kind)
    assert found[0].opens == pytest.approx((gap + 0.001) / 0.3, abs=0.02)
    assert found[0].hits == ("block_1",)


def test_both_see_it_what_stands_before_a_drawer_and_the_drawer() -> None:
    kind = chest()
    here, before = put(kind, 2.0, 2.0), put(BLOCK, 2.6, 2.0)
    mine = swings(scene(None, (before, BLOCK)), here, kind)
    theirs = swings(scene(None, (here, kind)), before, BLOCK)
    assert mine == theirs
    assert mine[0].of == "chest_1"


def test_what_another_thing_blocks_already_is_not_the_fault_of_the_next() -> None:
    kind = chest()
    room = scene(None, (put(kind, 2.0, 2.0), kind), (put(BLOCK, 2.55, 2.0), BLOCK))
    assert swings(room, put(BLOCK, 2.56, 4.0, id="block_2"), BLOCK) == ()
    assert swings(room, put(POST, 2.45, 2.2), POST) == ()
    assert swings(room, put(POST, 2.325, 2.2), POST)[0].opens < 0.1


def test_light_things_are_pushed_aside_and_named() -> None:
    kind, stool = chest(), asset("stool", (0.3, 0.3, 0.45), mass=4.0)
    here, before = put(kind, 2.0, 2.0), put(stool, 2.46, 2.0)
    (aside,) = swings(scene(None, (before, stool)), here, kind)
    assert (aside.opens, aside.hits) == (1.0, ("stool_1",))
    assert [p.other for p in aside.pushes] == ["stool_1"]
    assert aside.pushes[0].force == pytest.approx(stool.friction * 4.0 * 9.81, abs=0.01)
    assert str(aside) == "front of chest_1 (100%, pushes stool_1 aside with 24 N)"
    assert swings(scene(None, (here, kind)), before, stool) == ()
    further = scene(None, (before, stool), (put(BLOCK, 2.65, 2.0), BLOCK))
    assert swings(further, here, kind)[0].hits == ("stool_1", "block_1")
    assert swings(scene(None, (before, stool)), here, kind, walking=Walking(movable=2.0))[0].hits == ("stool_1",)


def test_a_light_thing_that_is_fixed_ends_an_opening() -> None:
    lamp = asset("wall_lamp", (0.3, 0.1, 0.2), mass=1.0, mount="wall")
    room = scene(None, (put(lamp, 1.0, 0.05, 1.0, yaw=0.0, on="south_wall"), lamp))
    found = swings(room, put(WARDROBE, 0.3, 0.55), WARDROBE)
    assert of_one(found, "door_right").hits == ("wall_lamp_1",)


def test_what_it_carries_moves_along() -> None:
    kind = chest(lid=True)
    statue = asset("statue", (0.2, 0.2, 0.5), mass=40.0, mount="surface")
    mat = asset("mat", (0.3, 0.3, 0.02), mass=20.0, mount="surface")
    here = put(kind, 2.0, 2.0)
    on_mat = (put(mat, 2.0, 2.0, 0.52, on="chest_1"), mat), (put(statue, 2.0, 2.0, 0.54, on="mat_1"), statue)
    assert swings(scene(None, (here, kind), *on_mat), here, kind) == ()
    assert swings(scene(None, (here, kind), on_mat[0]), *on_mat[1]) == ()
    beside = structs.replace(on_mat[1][0], support="floor")
    assert swings(scene(None, (here, kind)), beside, statue)[0].of == "chest_1"


def test_its_own_body_and_doors_are_not_in_the_way() -> None:
    assert swings(scene(), put(WARDROBE, 2.0, 2.0), WARDROBE) == ()


def test_walls_floor_and_ceiling_end_an_opening() -> None:
    drawer, flap, lid = chest(), chest(flap=True), chest(lid=True)
    to_wall = swings(scene(), put(drawer, 3.55, 2.0), drawer)
    assert to_wall[0].hits == ("east_wall",)
    assert to_wall[0].opens == pytest.approx(0.15 / 0.3, abs=0.02)
    to_floor = swings(scene(), put(flap, 2.0, 2.0), flap)
    assert to_floor[0].hits == ("floor",)
    assert to_floor[0].opens == pytest.approx(90.0 / 110.0, abs=0.04)
    assert swings(scene(), put(lid, 2.0, 2.0, 1.8), lid)[0].hits == ("ceiling",)
    assert swings(scene(), put(lid, 2.0, 2.0), lid) == ()


def test_a_door_of_the_room_counts_as_shut() -> None:
    door = Opening(id="door_1", kind="door", wall=1, offset=1.5, width=1.0, height=2.0)
    kind = chest()
    found = swings(scene(rectangle(4.0, 5.0, openings=(door,))), put(kind, 3.6, 2.0), kind)
    assert found[0].hits == ("east_wall",)


def test_the_corner_of_an_l_that_points_into_the_room() -> None:
    """The corner at (2, 2) is 0.1 m before the right-hand door, which is 0.5 m wide."""
    found = swings(scene(L_ROOM), put(WARDROBE, 1.9, 1.4, yaw=90.0), WARDROBE)
    assert [s.link for s in found] == ["door_right"]
    assert set(found[0].hits) <= {"north_wall", "east_wall_2"}
    assert found[0].opens < 0.9
    assert swings(scene(L_ROOM), put(WARDROBE, 0.9, 1.4, yaw=90.0), WARDROBE) == ()


def test_rugs_are_not_in_the_way() -> None:
    rug = asset("rug", (2.0, 1.4, 0.2), box((2.0, 1.4, 0.2), (0.0, 0.0, 0.1), collide=False))
    kind = chest()
    assert swings(scene(None, (put(rug, 2.6, 2.0), rug)), put(kind, 2.0, 2.0), kind) == ()
    assert swings(scene(None, (put(kind, 2.0, 2.0), kind)), put(rug, 2.6, 2.0), rug) == ()


def test_something_of_the_same_id_is_looked_past() -> None:
    room = scene(None, (put(WARDROBE, 2.0, 2.0), WARDROBE), (put(BLOCK, 2.7, 2.0), BLOCK))
    assert swings(room, put(WARDROBE, 2.1, 2.0), WARDROBE)
    assert {s.of for s in swings(room, put(BLOCK, 2.6, 2.0), BLOCK)} == {"wardrobe_1"}
    assert swings(room, put(BLOCK, 3.5, 2.0), BLOCK) == ()


def test_without_a_range_nothing_is_measured() -> None:
    shut = structs.replace(chest(), links=(chest().links[0], structs.replace(chest().links[1], joint=Joint(
        kind="slide", axis=(1.0, 0.0, 0.0), anchor=(0.0, 0.0, 0.0), lower=0.0, upper=0.0))))  # fmt: skip
    assert swings(scene(None, (put(BLOCK, 2.6, 2.0), BLOCK)), put(shut, 2.0, 2.0), shut) == ()


def test_a_joint_that_opens_to_the_negative_side() -> None:
    back = structs.replace(chest(), links=(chest().links[0], structs.replace(chest().links[1], joint=Joint(
        kind="slide", axis=(-1.0, 0.0, 0.0), anchor=(0.0, 0.0, 0.0), lower=-0.3, upper=0.0))))  # fmt: skip
    found = swings(scene(None, (put(BLOCK, 2.65, 2.0), BLOCK)), put(back, 2.0, 2.0), back)
    assert found[0].opens == pytest.approx(0.5, abs=0.02)


def furnished() -> list[tuple[Placement, Asset]]:
    names = ("wardrobe", "bed", "dresser", "desk", "office_chair", "nightstand", "fridge", "toy_box")
    kinds = [make_asset(name, seed=3) for name in names]
    return [(put(k, 0.9 + 1.2 * (i % 4), 1.0 + 1.3 * (i // 4), yaw=35.0 * i), k) for i, k in enumerate(kinds)]


def test_surroundings_that_grew_are_those_of_the_scene() -> None:
    objects, room = furnished(), rectangle(5.0, 4.0)
    grown = Surroundings(room, Walking())
    for one in objects:
        grown = grown.with_objects([one])
    whole = surroundings(scene(room, *objects))
    for placement, kind in objects:
        moved = structs.replace(placement, yaw=placement.yaw + 10.0)
        assert grown.swings(moved, kind) == whole.swings(moved, kind) == grown.swings(moved, kind)


@settings(max_examples=15, deadline=None)
@given(st.sampled_from(("wardrobe", "dresser", "fridge", "stove", "toy_box", "washing_machine")), st.data())
def test_the_engine_finds_the_same(name: str, data: st.DataObject) -> None:
    """A little further than it opens the engine finds a contact over 0.5 mm deep, and a little less none of 1.5 mm."""
    kind, other = make_asset(name, seed=2), data.draw(st.sampled_from((BLOCK, POST, make_asset("sofa", seed=0))))
    here = put(kind, 5.0, 5.0, yaw=data.draw(st.floats(0.0, 360.0)))
    x, y = here.to_room((data.draw(st.floats(0.6, 1.2)), data.draw(st.floats(-0.6, 0.6))))
    there = put(other, x, y, yaw=data.draw(st.floats(0.0, 360.0)), id="other_1")
    room = scene(rectangle(10.0, 10.0), (here, kind), (there, other))
    if here.footprint.distance(there.footprint) < 0.02:
        return
    found = {s.link: s for s in swings(room, here, kind) if s.hits == ("other_1",)}
    for link in kind.links[1:]:
        share = found[link.name].opens if link.name in found else 1.0
        assert share < 0.01 or depth_at(room, link, share - 0.005) < 0.0015
        assert share == 1.0 or depth_at(room, link, share + 0.01) > 0.0005


def depth_at(room: Scene, link: Link, share: float) -> float:
    """Depth of the deepest contact of the opened link with the other object in the engine [m]."""
    model = compiled(build_spec(room))
    data = mujoco.MjData(model)
    assert link.joint is not None
    radians = math.radians(link.joint.upper) if link.joint.kind == "hinge" else link.joint.upper
    id = next(p.id for p in room.placements if p.id != "other_1")
    data.joint(f"{id}/{link.name}").qpos[0] = share * radians
    mujoco.mj_forward(model, data)
    moved = model.body(f"{id}/{link.name}").id
    other = model.body("other_1").id
    bodies = model.geom_bodyid[data.contact.geom]
    hits = np.sort(bodies, axis=1) == sorted((moved, other))
    depths = -data.contact.dist[hits.all(axis=1)]
    return float(depths.max(initial=0.0))


def test_what_is_pushed_aside_weighs_what_stands_on_it_too() -> None:
    kind, stool, cup = chest(), asset("stool", (0.3, 0.3, 0.45), mass=4.0), asset("cup", (0.1, 0.1, 0.1), mass=2.0)
    here, before, on = put(kind, 2.0, 2.0), put(stool, 2.46, 2.0), put(cup, 2.46, 2.0, 0.45, on="stool_1")
    (aside,) = swings(scene(None, (before, stool), (on, cup)), here, kind)
    assert aside.pushes[0].force == pytest.approx(stool.friction * 6.0 * 9.81, abs=0.01)
