"""Rooms for the tests of editing, built of the catalogue's furniture at poses that are known to stand."""

from thinkblox.assets.source import ProceduralAssets
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at
from thinkblox.value import to_json

OPENINGS = (
    Opening(id="door_1", kind="door", wall=0, offset=0.3, width=0.9, height=2.1),
    Opening(id="window_1", kind="window", wall=2, offset=0.8, width=1.6, height=1.2, sill=0.9),
)
SOURCE = ProceduralAssets()


def room(width: float = 6.0, depth: float = 5.0) -> Room:
    return rectangle(width, depth, openings=OPENINGS)


def built(floor: Room, *rows: tuple[str, float, float, float, str]) -> Scene:
    """Things by id, x, y, yaw and what they stand on: "floor", "wall" or an id."""
    scene = Scene(prompt="a room", room=floor)
    for id, x, y, yaw, on in rows:
        category = id.rpartition("_")[0]
        alike = [p for p in scene.placements if p.category == category]
        asset = scene.asset_of(alike[0]) if alike else SOURCE.make(category, seed=3)
        z = 0.0
        if on == "wall":
            z = 1.5 - asset.size[2] / 2
        elif on in scene:
            tops = [s.position[2] for s in scene.asset_of(scene[on]).surfaces if not s.inner]
            z = scene[on].position[2] + max(tops)
        scene = scene.with_placement(placed_at(scene, asset, id=id, position=(x, y, z), yaw=yaw), asset)
    return scene


def placed(scene: Scene, category: str, x: float, y: float, yaw: float = 0.0) -> Scene:
    """One thing more on the floor."""
    asset = SOURCE.make(category, seed=3)
    id = f"{category}_{1 + sum(p.category == category for p in scene.placements)}"
    return scene.with_placement(placed_at(scene, asset, id=id, position=(x, y, 0.0), yaw=yaw), asset)


def bedroom() -> Scene:
    """A bed between two nightstands with lamps at the north wall, a wardrobe, and a window in the west."""
    window = Opening(id="window_1", kind="window", wall=3, offset=1.5, width=1.6, height=1.2, sill=0.9)
    return built(
        rectangle(6.0, 5.0, openings=(OPENINGS[0], window)),
        ("bed_1", 3.0, 3.9, 270.0, "floor"),
        ("nightstand_1", 4.1, 4.75, 270.0, "floor"),
        ("nightstand_2", 1.9, 4.75, 270.0, "floor"),
        ("wardrobe_1", 5.65, 2.0, 180.0, "floor"),
        ("table_lamp_1", 4.1, 4.75, 0.0, "nightstand_1"),
        ("table_lamp_2", 1.9, 4.75, 0.0, "nightstand_2"),
    )


def living() -> Scene:
    """A sofa and a coffee table with a vase, a sideboard at the east wall, a desk, an armchair and a rug."""
    return built(
        room(),
        ("rug_1", 2.6, 2.4, 0.0, "floor"),
        ("sofa_1", 3.0, 0.6, 90.0, "floor"),
        ("coffee_table_1", 3.0, 1.9, 90.0, "floor"),
        ("sideboard_1", 5.7, 2.5, 180.0, "floor"),
        ("desk_1", 0.5, 2.6, 0.0, "floor"),
        ("armchair_1", 5.3, 4.4, 225.0, "floor"),
        ("vase_1", 3.0, 1.9, 0.0, "coffee_table_1"),
        ("picture_1", 5.984, 1.0, 180.0, "wall"),
    )


def dining(chairs: int = 2) -> Scene:
    """A long table in the middle with chairs at one side."""
    rows = [("dining_table_1", 3.0, 2.5, 90.0, "floor")]
    rows += [(f"chair_{n + 1}", 2.6 + 0.8 * n, 1.75, 90.0, "floor") for n in range(chairs)]
    return built(room(), *rows)


def bytes_of(scene: Scene) -> dict[str, bytes]:
    """Each placement with its asset, as it is written."""
    return {p.id: to_json(p) + to_json(scene.asset_of(p)) for p in scene.placements}


def same_but(before: Scene, after: Scene, *ids: str) -> bool:
    """Whether everything but some objects has the same bytes."""
    old, new = bytes_of(before), bytes_of(after)
    return all(new.get(id) == data for id, data in old.items() if id not in ids)
