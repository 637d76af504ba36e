"""The phrases of instructions' own grammar in an order: lengths, directions, rows, comparatives."""

from dataclasses import replace

from thinkblox.editing.reading.cutting import OrderMark
from thinkblox.editing.reading.draft import IN_ROW, OrderDraft
from thinkblox.editing.reading.looks import read_adjective
from thinkblox.editing.rows import MIDDLE_ROW
from thinkblox.reading.english.chunks import Adjective, Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.sizes import Length, Size


def read_mark(draft: OrderDraft, mark: OrderMark) -> None:
    """Take a phrase of the instructions' own grammar."""
    order = draft.order
    match mark.sort:
        case "few" | "seated" | "flanks":
            _how(draft, mark)
        case "lengths":
            _length(draft, mark)
        case "fractions":
            draft.fraction = mark.value
        case "turn" | "multiples":
            setattr(order, "turn" if mark.sort == "turn" else "times", mark.value)
        case "directions":
            if order.direction:
                order.lost.append(mark.key)
            order.direction = order.direction or mark.key
        case "clear":
            read_adjective(draft, Adjective(0, 0, "free"))
        case "rows":
            _row(draft, MIDDLE_ROW if mark.key == "middle" else int(mark.key))
        case "comparatives" | "absolutes":
            _change(draft, mark)
        case _:
            _marker(draft, mark.key)


def _change(draft: OrderDraft, mark: OrderMark) -> None:
    """Take how the size of a thing changes; of two ways the first is lost."""
    order = draft.order
    if draft.negated:
        draft.negated = False
        order.ruled_out.append(mark.key)
        return
    absolute = mark.sort == "absolutes" and order.lengths
    if order.change and not absolute and order.change.removesuffix("=") != mark.key:
        order.lost.append(order.change.removesuffix("="))
    order.change = mark.key if mark.sort == "comparatives" else f"{mark.key}="


def _how(draft: OrderDraft, mark: OrderMark) -> None:
    order = draft.order
    order.slight |= mark.sort == "few"
    order.seated = mark.key if mark.sort == "seated" else order.seated
    if mark.sort == "flanks":
        _flank(draft, mark.key)


def _flank(draft: OrderDraft, side: str) -> None:
    """Read "next to the laptop, on its left"; where nothing was named but the thing itself, it is a direction."""
    anchors = draft.anchors or ([] if draft.places_of_last() else _named_before(draft))
    if anchors and draft.order.things:
        draft.order.things[-1].places.append(Where(f"{side}_of", anchors[-1], text=f"to the {side} of"))
    elif draft.order.doing == "put" and draft.order.things and not draft.order.lengths and not draft.places_of_last():
        it = Noun("pronoun", "it", 0, 0, "it")
        draft.order.things[-1].places.append(Where(f"{side}_of", it, text=f"to the {side} of"))
    else:
        draft.order.direction = draft.order.direction or side


def _named_before(draft: OrderDraft) -> list[Noun]:
    """What was named with the thing before the last, or that thing itself: a wall has no sides."""
    named = [noun for noun in draft.former if noun.kind == "thing"]
    before = draft.order.things[-2:-1]
    return named or ([before[0].noun] if draft.former and before else [])


def _row(draft: OrderDraft, number: int) -> None:
    """Read "in the front row" of what was named last."""
    phrase = draft.excepted or (draft.order.things[-1] if draft.order.things else None)
    last = phrase.places[-1] if phrase is not None and phrase.places else None
    if last is not None and last.whole is not None and last.whole.kind == "thing":
        last.whole = replace(last.whole, rows=1, ordinal=number, plural=last.whole.many or last.whole.each)
    elif last is not None and last.noun is not None and last.noun.kind == "thing":
        several = last.noun.many or last.noun.each
        last.noun = replace(last.noun, rows=1, ordinal=number, plural=several)
    elif phrase is not None and phrase.noun.kind == "pronoun" and phrase.noun.value == "them":
        phrase.noun = replace(phrase.noun, rows=1, ordinal=number)
    elif phrase is None or phrase.noun.kind != "thing":
        draft.order.lost.append("row")
    else:
        phrase.member = phrase.noun.ordinal
        middle = [w for w in phrase.places if w.noun is not None and w.noun.kind == "part" and not w.whole]
        side = next((w.noun.value for w in middle if w.noun is not None and w.noun.value in IN_ROW), "")
        phrase.places = [w for w in phrase.places if w not in middle] if side else phrase.places
        phrase.noun = replace(phrase.noun, rows=1, ordinal=number, side=side or phrase.noun.side)


def _length(draft: OrderDraft, mark: OrderMark) -> None:
    order, new = draft.order, draft.sized()
    if new is not None and order.doing != "replace" and all(axis for _, axis in mark.lengths):
        new.size = Size(tuple(Length(metres, axis, "m") for metres, axis in mark.lengths), order.text)
        return
    order.lengths += mark.lengths
    bound, _, by = mark.key.partition(" ")
    order.bound = bound if bound in ("ge", "le") else order.bound
    order.by |= by == "by" or bound == "by"
    draft.up_to |= "to" in (by, bound)
    draft.distance = len(mark.lengths) == 1 and not mark.lengths[0][1]


def _marker(draft: OrderDraft, key: str) -> None:
    order = draft.order
    match key:
        case "nearer" | "farther":
            draft.pending = key == "nearer"
        case "clockwise" | "anticlockwise":
            order.sense = -1 if key == "clockwise" else 1
        case "round":
            _round(draft)
        case "elsewhere":
            order.doing, draft.told = "resite", len(draft.places())
        case "away" | "rest" | "there" | "centred":
            setattr(order, key, True)
        case "so" | "unblock":
            draft.mode, draft.so, draft.unsaid = key, [], repr(order)
        case "together":
            order.mutual = "next_to"
        case _:
            pass


def _round(draft: OrderDraft) -> None:
    """Read "turn it round", "make the table round"."""
    order = draft.order
    if order.doing == "turn" and order.turn is None:
        order.turn, draft.around = 180.0, True
    elif order.doing == "make" and draft.negated:
        draft.negated = False
        order.ruled_out.append("round")
    elif order.doing == "make" or (order.doing == "put" and (order.looks or "be round" in order.text.lower())):
        order.looks.append("round")
    elif order.doing != "swap":
        order.lost.append("round")
