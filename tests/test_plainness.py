"""A room with stand-ins says so: in its report, on the terminal and on the page."""

from thinkblox import printing
from thinkblox.assets import make_thing
from thinkblox.generate import generate_room
from thinkblox.plainness import plain_things
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.value import from_json, to_json
from thinkblox.verdict import PlainThing, Report


def placed(*names: str) -> Scene:
    room = Room(floor=((0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)))
    assets, placements = {}, []
    for number, name in enumerate(names, 1):
        asset = make_thing(name, seed=0)
        assets[asset.id] = asset
        placements.append(
            Placement(
                id=f"{asset.category}_{number}",
                category=asset.category,
                asset=asset.id,
                position=(2.0 * number, 4.0, 0.0),
                yaw=0.0,
                size=asset.size,
            )
        )
    return Scene(prompt="", seed=0, room=room, assets=assets, placements=tuple(placements))


def test_each_kind_is_named_once_with_what_it_is_like() -> None:
    found = plain_things(placed("crock pot", "bed", "crock pot", "dental throne", "quern"))
    assert [str(thing) for thing in found] == [
        "crock pot (size of: slow cooker)",
        "dental throne (size of: throne)",
        "quern (size not known)",
    ]
    assert found[0].ids == ("crock_pot_1", "crock_pot_3")
    assert [thing.how for thing in found] == ["table", "head", "plain"]


def test_what_has_a_shape_is_not_listed() -> None:
    assert plain_things(placed("bed", "sofa")) == ()


def test_a_guess_by_spelling_says_how_sure_it_is() -> None:
    thing = PlainThing(name="nebuliser", ids=("nebuliser_1",), how="spelling", like="humidifier", similarity=0.89)
    assert str(thing) == "nebuliser (size of: humidifier, 89% sure)"


def test_the_report_and_the_terminal_say_so() -> None:
    room = generate_room("A kitchen with a stove and a crock pot on the stove.", seed=0)
    assert [thing.name for thing in room.report.stand_ins] == ["crock pot"]
    assert (
        "as plain stand-ins: crock pot (size of: slow cooker)" in printing.summary(room.report, placed=2).splitlines()
    )
    assert from_json(to_json(room.report), Report).stand_ins == room.report.stand_ins
    assert room.scene.asset_of(room.scene["crock_pot_1"]).category == "crock_pot"
