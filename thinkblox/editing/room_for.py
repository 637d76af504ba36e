"""Room for something that is to come: "make room for a piano"."""

from collections.abc import Sequence

from thinkblox.editing.adding_one import MOST, add_one, category_of
from thinkblox.editing.orders import Order
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.scene.placement import Placement


def room_for(work: Work, order: Order) -> bool:
    """Say where there is room for what an order names, or that there is none; whether it names anything.

    Nothing is moved for it: where things would go on their own, and whether they may, only who asks can tell.
    """
    nouns = [noun for noun in order.purpose if noun.kind == "thing" and noun.named]
    if not nouns or order.places or order.free or len(nouns) < len(order.purpose):
        return False
    saved, said = work.saved(), len(work.failed)
    found = [place for noun in nouns for place in _tried(work, noun)]
    why = work.failed[said:]
    work.restore(saved)
    del work.failed[said:]
    what = " and ".join(noun.text for noun in nouns)
    if why:
        work.failed.append(f"there is no room for {what}: {_where(found)}{why[0]}; say what is to go, or where to")
    else:
        work.done.append(f"there is room for {what}, and nothing has to go: {_where(found).removesuffix('; ')}")
    return True


def _tried(work: Work, noun: Noun) -> list[Placement]:
    """Where so many of a thing could stand, with what stands there."""
    count = noun.count or (2 if noun.plural else 1)
    if count > MOST:
        raise InputError(f"'{noun.text}': room is looked for at most {MOST} things")
    category, found = category_of(work, noun, ()), list[Placement]()
    for _ in range(count):
        if not (id := add_one(work, category, noun, [])):
            break
        found.append(work.scene[id])
    return found


def _where(found: Sequence[Placement]) -> str:
    spots = [f"({p.position[0]:.2f}, {p.position[1]:.2f})" for p in found]
    sizes = f" of {found[0].size[0]:.2f} by {found[0].size[1]:.2f} m" if found else ""
    return f"one{sizes} could stand at {', '.join(spots)}; " if found else ""
