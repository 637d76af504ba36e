"""Verdicts that could be fooled: each of these was once valid and fell, or stood and was not."""

from msgspec import structs

from tests.bench.adversary_truth import simulated, truth
from tests.sim_rooms import asset, box, put, scene, table, vase
from thinkblox.assets import make_asset
from thinkblox.scene.asset import Shape
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.world import World
from thinkblox.verdict import Verdict

TABLE = table()
ON_TABLE = (put(TABLE, 2.0, 2.0), TABLE)
BOOK = asset("book", (0.2, 0.14, 0.03), mass=0.5, mount="surface")
CUP = asset(
    "cup", (0.08, 0.08, 0.1), Shape(kind="cylinder", size=(0.08, 0.08, 0.1), position=(0.0, 0.0, 0.05)), mass=0.3
)


def on_books(gap: float) -> Verdict:
    """A cup on a stack of three books that each lie so far over the one below [m]."""
    room, height = scene(None, ON_TABLE), TABLE.size[2]
    for number in range(3):
        height += gap
        room = room.with_placement(put(BOOK, 2.0, 2.0, height, id=f"book_{number}"), BOOK)
        height += BOOK.size[2]
    return World(room).check([put(CUP, 2.0, 2.0, height)], CUP)[0]


def test_a_heavy_aquarium_on_a_notebook_is_too_deep_in_it_once_it_rests() -> None:
    notebook, aquarium = make_asset("notebook", seed=0), make_asset("aquarium", seed=0)
    there = put(notebook, 2.0, 2.0, TABLE.size[2], id="notebook_1")
    room = scene(None, ON_TABLE, (there, notebook))
    heavy = structs.replace(aquarium, mass=65.0)
    verdict = World(room).check([put(heavy, 2.0, 2.0, there.top)], heavy)[0]
    assert verdict.reasons == ("collision",)
    assert [collision.other for collision in verdict.collisions] == ["notebook_1"]
    assert verdict.depth > 0.001


def test_a_cup_on_a_stack_of_books_stands_whatever_the_instant() -> None:
    verdict = on_books(0.0)
    assert verdict.valid, str(verdict)
    assert verdict.supports[0].by == "book_2"
    assert verdict.supports[0].share > 0.9


def test_what_was_not_at_rest_before_is_not_blamed_on_the_last_to_come() -> None:
    verdict = on_books(0.003)
    assert verdict.valid, str(verdict)
    assert 0.008 < verdict.drop < 0.011
    assert not [push for push in verdict.pushed if push.distance > 0.001]


def test_what_the_candidate_tilts_is_pushed_though_its_base_stays() -> None:
    """A shelf that lies loosely on one block is tipped by what is put on its end."""
    block, plank = asset("block", (0.4, 0.4, 0.4), mass=40.0), asset("plank", (1.0, 0.3, 0.03), mass=3.0)
    room = scene(None, (put(block, 2.0, 2.0), block), (put(plank, 2.0, 2.0, 0.4), plank))
    weight = asset("weight", (0.1, 0.1, 0.1), mass=20.0)
    verdict = World(room).check([put(weight, 2.4, 2.0, 0.43)], weight)[0]
    assert "pushes" in verdict.reasons
    assert verdict.pushed[0].tilt > 2.0


def test_a_capsule_on_its_end_falls_after_a_while() -> None:
    """It hardly moves in the first half second; what falls asleep then would stand for ever."""
    kind = asset(
        "pill",
        (0.06, 0.06, 0.13),
        Shape(kind="capsule", size=(0.06, 0.06, 0.13), position=(0.0, 0.0, 0.065)),
        mass=0.05,
    )
    room = scene(None, ON_TABLE)
    verdict = World(room).check([put(kind, 2.1, 1.9, TABLE.size[2] + 0.0003, 17.0)], kind)[0]
    assert not verdict.valid


def test_a_wide_disc_on_the_edge_of_a_narrow_drum_is_watched_to_the_end() -> None:
    drum = asset("drum", (0.1036, 0.1036, 0.3228), Shape(kind="cylinder", size=(0.1036, 0.1036, 0.3228),
                 position=(0.0, 0.0, 0.1614)), mass=19.3)  # fmt: skip
    disc = asset("disc", (0.4568, 0.4568, 0.0626), Shape(kind="cylinder", size=(0.4568, 0.4568, 0.0626),
                 position=(0.0, 0.0, 0.0313)), mass=11.2)  # fmt: skip
    room = scene(None, (put(drum, 2.0, 2.0), drum))
    verdict = World(room).check([put(disc, 2.0393, 1.9670, 0.3228)], disc)[0]
    assert not verdict.valid


def test_a_slender_pole_is_not_proven_to_stand_by_five_millimetres() -> None:
    foot, mast = box((0.1, 0.1, 0.05), (0.0, 0.0, 0.025)), box((0.06, 0.06, 1.95), (0.04, 0.0, 1.025))
    pole = asset("pole", (0.14, 0.1, 2.0), foot, mast, mass=10.0)
    assert World(scene()).check([put(pole, 2.0, 2.0)], pole)[0].valid
    early = World(scene(), physics=Physics(settle_time=0.5)).check([put(pole, 2.0, 2.0)], pole)[0]
    assert early.reasons == ("restless",), "half a second proves nothing of it"


def test_what_stands_squarely_in_a_shelf_is_believed_at_once() -> None:
    """The middle of the shelf is higher than what stands in it, and does not weigh on it."""
    shelves, bottle = make_asset("shelving_unit", seed=0), make_asset("bottle", seed=0)
    surface = min(shelves.surfaces, key=lambda surface: surface.position[2])
    base = put(shelves, 2.0, 2.0)
    x, y = base.to_room(surface.position[:2])
    verdict = World(scene(None, (base, shelves))).check([put(bottle, x, y, surface.position[2])], bottle)[0]
    assert verdict.valid, str(verdict)
    assert verdict.rest is not None
    assert verdict.rest < 0.5


def test_towels_on_top_of_a_coat_rack_do_what_the_simulation_says() -> None:
    rack, kind = make_asset("coat_rack", seed=0), make_asset("towels", seed=0)
    base = put(rack, 2.0, 2.0)
    room, there = scene(None, (base, rack)), put(kind, 2.0, 2.0, base.top)
    found = truth(room, simulated(room), there, kind)
    verdict = World(room).check([there], kind)[0]
    assert verdict.valid == (found.share <= 1.0), f"{verdict}; {found}"


def test_a_vase_on_a_table_is_as_before() -> None:
    verdict = World(scene(None, ON_TABLE)).check([put(vase(), 2.0, 2.0, TABLE.size[2])], vase())[0]
    assert verdict.valid
    assert verdict.rest is not None
    assert verdict.rest < 0.2
