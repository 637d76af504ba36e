"""A rug made so large that what is named is on it."""

from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import At
from thinkblox.editing.orders import Order
from thinkblox.editing.reaching import Reaching
from thinkblox.editing.remaking import looks_of
from thinkblox.editing.telling import named
from thinkblox.editing.work import Work
from thinkblox.errors import InputError

SHORT = 0.01
"""By how much it may be shorter than what is on it [m]."""
THERE = 0.02
"""How far from the middle of all its own may come to lie [m]."""


def spread_under(work: Work, finder: Finder, order: Order) -> None:
    """Let a rug be as large as it has to be for all that is named to be on it, and lie under that.

    Raises:
        InputError: it is nothing that lies flat on the floor, or more is said of its size.
    """
    (phrase,) = order.things
    ids = named(finder, phrase, phrase.places)
    if len(ids) != 1 or work.asset_of(ids[0]).collides or work.scene[ids[0]].support != "floor":
        raise InputError(f"'{order.text}': only one rug can be made so that things are on it; say how large")
    if (
        order.lengths
        or order.times
        or order.looks
        or order.change.removesuffix("=") not in ("", "larger", "wider", "longer")
    ):
        raise InputError(f"'{order.text}' says how large it is to be and what is to be on it; give two orders")
    borne = [id for phrase in order.bears for id in named(finder, phrase, ())]
    id = ids[0]
    rug, asset = work.scene[id], work.asset_of(id)
    shapes = [work.scene[name].footprint for name in (id, *borne)]
    corners = [rug.to_local((x, y)) for shape in shapes for x, y in shape.exterior.coords]
    (x0, x1), (y0, y1) = ((min(axis), max(axis)) for axis in zip(*corners, strict=True))
    wanted = (round(x1 - x0, 3), round(y1 - y0, 3), asset.size[2])
    made = work.source.fit(asset, wanted) if wanted != asset.size else asset
    if any(have < want - SHORT for have, want in zip(made.size[:2], wanted[:2], strict=True)):
        says = f"{wanted[0]:.2f} by {wanted[1]:.2f} m for {', '.join(borne)} to be on it"
        work.failed.append(f"{id} was left as it is: it would have to be {says}, and it is made up to {looks_of(made)}")
        return
    spot = rug.to_room(((x0 + x1) / 2, (y0 + y1) / 2))
    goals = [At(spot, THERE)]
    target = work.target(id, rug.category, (), made.attributes)
    pose = ((round(spot[0], 4), round(spot[1], 4), rug.position[2]), rug.yaw)
    reaching = Reaching(work, target, made, goals, direct=[pose], ask=False, begin=pose)
    if not reaching.run():
        work.failed.append(f"{id} was left as it is: {reaching.why}")
        return
    work.wish(id, goals)
    finder.recent = [id]
    work.done.append(f"{id} is now {looks_of(made)}, with {', '.join(borne)} on it")
