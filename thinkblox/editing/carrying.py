"""What rests on what goes or is exchanged: taken off, and placed anew."""

from collections.abc import Sequence

from thinkblox.assets import facts_of
from thinkblox.brief import RelationKind
from thinkblox.editing.goals import Related
from thinkblox.editing.reaching import Reaching, ties_of, without
from thinkblox.editing.work import Work
from thinkblox.free_places import Stretch, free_places
from thinkblox.knowledge.habits import load_habits
from thinkblox.plan import Tie
from thinkblox.scene.actions import Move
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec3

CARRIERS = 8
"""How many things that could carry it are looked at for one that has lost its own."""
ASKED = 2
"""On how many of them with room the policy is asked for a place where the widest free ones will not do."""


def take(work: Work, ids: Sequence[str]) -> list[Placement]:
    """Take objects out of the room with all that rests on them; returns them as they were, carriers first."""
    scene = work.scene
    gone = list(dict.fromkeys(g for id in ids for g in (id, *(r.id for r in scene.riders(id)))))
    taken = sorted((scene[id] for id in gone), key=lambda p: len(scene.carriers(p.id)))
    for placement in taken:
        work.assets[placement.asset] = scene.asset_of(placement)
    work.world = work.world.with_scene(without(scene, gone))
    return taken


def place_anew(work: Work, old: Placement, *, carriers: Sequence[str] = ()) -> bool:
    """Give something that was taken out another place: on these carriers, or on what usually carries it."""
    asset = work.assets[old.asset]
    fits = [p.id for p in work.scene.placements if work.asset_of(p.id).surfaces and p.id != old.id]
    fits = [id for id in fits if work.asset_of(id).mount != "surface"]
    usual = [id for id in usual_carriers(work.scene, old.category) if id in fits]
    near = sorted(fits, key=lambda id: (_is_soft(work.scene[id].category), _away(work.scene[id], old)))
    if asset.mount == "surface":
        looked_at = list(dict.fromkeys([*carriers, *usual, *near]))[:CARRIERS]
        free = [id for id in looked_at if id in carriers]
        for carrier in looked_at:
            reaching = _onto(work, old, carrier)
            stretches = free_places(work.scene, reaching.target, asset.card)
            reaching.direct = [(spot, stretch.yaw) for stretch in stretches for spot in _along(stretch)]
            if reaching.run():
                return True
            free += [carrier] if stretches and carrier not in free else []
        return any(_onto(work, old, carrier, ask=True).run() for carrier in free[:ASKED])
    target = work.target(old.id, old.category, work.usual_ties(old.id) or usual_ties(work.scene, old.category))
    return Reaching(work, target, asset, (), begin=(old.position, old.yaw)).run()


def usual_carriers(scene: Scene, category: str) -> list[str]:
    """What things of a category usually rest on, of what is in the room, the most usual first."""
    names = [name for habit in load_habits().of(category) if habit.kind == "on" for name in habit.anchors]
    return [p.id for name in names for p in scene.placements if p.category == name]


def _onto(work: Work, old: Placement, carrier: str, *, ask: bool = False) -> Reaching:
    """What brings something that was taken out onto a thing."""
    asset, goals = work.assets[old.asset], (Related("on", (carrier,)),)
    target = work.target(old.id, old.category, ties_of(goals), asset.attributes)
    return Reaching(work, target, asset, goals, ask=ask, search=False)


def _is_soft(category: str) -> bool:
    """Whether people sit or lie on it, so that things are put there last."""
    return facts_of(category).is_in("seating", "beds", "lounges")


def _along(stretch: Stretch) -> list[Vec3]:
    """The middle of a stretch and its ends."""
    (x0, y0, z), (x1, y1, _) = stretch.start, stretch.end
    return [((x0 + x1) / 2, (y0 + y1) / 2, z), stretch.start, stretch.end]


def put_back(work: Work, old: Placement, taken: Sequence[Placement], before: Scene) -> list[str]:
    """Put what rested on an object back onto it, as it stood there; ids of what could not."""
    new = work.scene[old.id]
    carried = before.apply(Move(id=old.id, position=new.position, yaw=new.yaw))
    failed: list[str] = []
    for rider in taken:
        if old.id not in before.carriers(rider.id):
            continue
        asset, at = work.assets[rider.asset], carried[rider.id]
        below = next((c for c in before.carriers(rider.id)), "")
        if below in failed or not work.world.check([at], asset)[0].valid:
            failed.append(rider.id)
            continue
        work.world = work.world.with_placement(at, asset)
    return failed


def usual_ties(scene: Scene, category: str) -> tuple[Tie, ...]:
    """Where a thing of a category usually stands, of what is in the room: its first habit that can be had."""
    for habit in load_habits().of(category):
        kind: RelationKind = habit.kind
        if not habit.anchors:
            continue
        if any(habit.anchors[0] == p.category for p in scene.placements) or _is_object_habit(scene, habit.anchors):
            names = [p.id for name in habit.anchors for p in scene.placements if p.category == name]
            return (Tie(kind=kind, anchors=(names[0],), asked=False),)
        if habit.anchors[0] in ("wall", "corner", "centre", "long_wall", "short_wall") or (
            habit.anchors[0] in ("window", "door") and any(o.kind == habit.anchors[0] for o in scene.room.openings)
        ):
            return (Tie(kind=kind, anchors=habit.anchors[:1], asked=False),)
    return ()


def _is_object_habit(scene: Scene, anchors: Sequence[str]) -> bool:
    return any(p.category in anchors for p in scene.placements)


def _away(one: Placement, other: Placement) -> float:
    return abs(one.position[0] - other.position[0]) + abs(one.position[1] - other.position[1])
