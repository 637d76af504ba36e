"""Orders that bring something: add it, or let it come in place of another thing."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets import GENERAL_WORDS, facts_of
from thinkblox.assets.plurals import singular
from thinkblox.editing.acting import centred, level, looking, mark_names
from thinkblox.editing.adding_goals import abreast, compared, related_to_those, there_where, under_each
from thinkblox.editing.adding_one import MOST, add_one, category_of
from thinkblox.editing.adding_places import (
    before_each,
    besides,
    how_many,
    not_bearing,
    of_lacking,
    of_those,
    one_at,
    there_already,
)
from thinkblox.editing.adding_unsaid import at_their_table, at_window, on_neighbour, on_usual
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import Apart, Related
from thinkblox.editing.more_rows import add_rows, is_row
from thinkblox.editing.orders import SAME, NounPhrase, Order
from thinkblox.editing.place_settings import (
    are_seats_around,
    is_laid_before,
    is_set_beside,
    seat_like,
    settings_on,
    so_many,
)
from thinkblox.editing.telling import anchored
from thinkblox.editing.to_a_line import add_to_line, line_said
from thinkblox.editing.wheres import Bound, slots_for, spot_of, told_by
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.knowledge.things import things as known_things
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where


def add(work: Work, finder: Finder, order: Order) -> None:
    """Add things where an order says, or where such things usually stand."""
    if not order.things:
        what = (
            f"'{', '.join(order.lost)}' is nothing that can be added" if order.lost else "that does not say what to add"
        )
        raise InputError(f"'{order.text}': {what}")
    recent: list[str] = []
    before = bool(finder.recent or finder.past.about)
    _fix_it(finder, order)
    for number, phrase in enumerate(order.things):
        if number and not recent and any(map(_is_by_it, phrase.places)):
            work.failed.append(f"{phrase.text} was not added: what it is to go by was not added either")
            continue
        later = next((p.places for p in order.things[number:] if p.places), order.places)
        if not before:
            later = [w for w in later if w.noun is None or w.noun.kind != "pronoun"]
        recent += _add(work, finder, order, phrase, phrase.places or later)
        finder.scene, finder.recent = work.scene, recent or finder.recent
    finder.recent = recent


def _is_by_it(where: Where) -> bool:
    """Whether a place is at "it", or a side of it."""
    nouns = [noun for noun in (where.noun, where.whole) if noun is not None]
    side = where.whole is None and any(noun.kind == "part" and noun.det == "my" for noun in nouns)
    return side or any(noun.kind == "pronoun" and noun.value == "it" for noun in nouns)


def _fix_it(finder: Finder, order: Order) -> None:
    """Let "it" be what an order before named, where what is added first carries nothing: "a bowl and a plate on it"."""
    small = [facts_of(p.noun.value).is_in("small") for p in order.things if p.noun.named]
    if len(order.things) < 2 or not all(small[:1] or [False]) or not finder.recent or order.things[0].places:
        return
    for where in (w for phrase in order.things for w in phrase.places):
        if where.noun is not None and where.noun.kind == "pronoun" and where.noun.value == "it":
            where.noun = replace(where.noun, id=finder.recent[-1])


def _add(work: Work, finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]) -> list[str]:
    phrase = _one_more(finder, phrase)
    noun = phrase.noun
    if (in_rows := _add_in_rows(work, finder, order, phrase, places)) is not None:
        return in_rows
    _check(noun)
    if noun.definite and not noun.id and noun.det == "the" and (there := finder.matching(noun)):
        raise InputError(f"'{noun.text}' is there already: {', '.join(p.id for p in there)}; add 'a' or 'another' one")
    finder.about = one_at(finder, phrase, places)
    places = anchored(finder, places)
    within, places = _with(places)
    places, load = of_lacking(places)
    spots_said, places = [w for w in places if w.word == "spot"], [w for w in places if w.word != "spot"]
    guess = noun.value if noun.value not in GENERAL_WORDS else category_of(work, noun, ())
    slots = [slots_for(where, guess, finder, noun.count) for where in places]
    slots = not_bearing(finder, slots, load) if load is not None else slots
    slots = before_each(slots)
    slots = besides(finder, order, phrase, slots)
    if (lying := there_already(work, noun, guess, slots)) is not None:
        return lying
    places, slots = of_those(finder, places, slots)
    if noun.degree and noun.degree != SAME:
        raise InputError(f"'{noun.text}': {noun.degree} than what? Say a size, or replace one that is there")
    left = [finder.left_place(order.text)] if order.there else []
    left += [spot_of(where, "", work.start, finder) for where in spots_said]
    floor = [Bound("on", (spot.support,)) for spot in left if spot.support == "floor"]
    category = category_of(work, noun, [*(bounds[0] for bounds in slots), *floor])
    several = next((len(bounds) for bounds in slots if len(bounds) > 1), 1)
    if any(len(bounds) not in (1, several) for bounds in slots):
        raise InputError(f"'{order.text}' names several places of two kinds at once; give two orders")
    count = how_many(noun, places, several)
    if count > MOST:
        raise InputError(f"'{noun.text}': one order adds at most {MOST} things; that would be {count}")
    added: list[str] = []
    for index in range(count):
        here = [bounds[index % len(bounds)] for bounds in slots]
        middles = [centred(work.scene, w) if order.centred else (w, []) for w in here]
        here = [w for w, _ in middles]
        goals = [goal for _, more in middles for goal in more]
        goals += [related_to_those(work, one, category, index, count) for w in here for one in under_each(w)]
        goals += [Related("on", (w.upon,)) for w in here if w.upon]
        goals += [Related("on", beside, negated=True) for w in places if (beside := told_by(w, finder))]
        goals += [looking(finder, n) for n in order.facing]
        goals += [level(finder, n, order.text) for n in order.level]
        goals += [compared(finder, category, nearer, other) for nearer, other in order.closer]
        goals += [goal for spot in left for goal in there_where(work, spot, category)]
        goals += [Apart(mark_names(finder, other), away, order.bound) for away, other in order.apart]
        goals = goals or at_window(work, category)
        goals = abreast(goals, order, added)
        tried = len(work.failed)
        id = (at_their_table(work, category, noun) or on_usual(work, finder, category, noun)) if not goals else ""
        id = id or (on_neighbour(work, category, noun, here, goals) if len(work.failed) == tried else "")
        id = id or (add_one(work, category, noun, goals) if len(work.failed) == tried else "")
        if not id and several < 2:
            break
        added += [id] if id else []
        finder.scene = work.scene
    if len(added) < count and count > 1:
        work.failed.append(f"{len(added)} of {count} {category.replace('_', ' ')} were added")
    return added + add_with(work, finder, order, added, within)


def _laid_for_each(work: Work, finder: Finder, order: Order, noun: Noun, places: Sequence[Where]) -> list[str]:
    """Lay so many things on a table before the seats that are at it; empty where they do not lie so, or cannot."""
    onto = places[0] if len(places) == 1 and places[0].word in ("on", "to") and not places[0].negated else None
    table = onto.noun if onto is not None and onto.whole is None else None
    if table is None or table.kind not in ("thing", "pronoun") or table.many or order.facing or order.closer:
        return []
    ids = finder.ids(NounPhrase(table, id=table.id))
    spots = settings_on(work, noun.value, ids[0], noun.count or 1) if len(ids) == 1 else []
    saved, said = work.saved(), (len(work.done), len(work.failed))
    added: list[str] = []
    one = replace(noun, count=1, plural=False)
    for kind, id in spots:
        mark = Noun("thing", work.scene[id].category, 0, 0, id, det="the", id=id)
        came = _add(work, finder, Order("add", order.text), NounPhrase(replace(one)), [Where(kind, mark, text=kind)])
        if not came or work.scene[came[0]].support != ids[0]:
            work.restore(saved)
            del work.done[said[0] :], work.failed[said[1] :]
            finder.scene = work.scene
            return []
        added += came
    return added


def _one_more(finder: Finder, phrase: NounPhrase) -> NounPhrase:
    """Read "another one" as one more of what was named last, in this instruction or the edit before, which is said."""
    noun, last = phrase.noun, [id for id in (*finder.recent, *finder.past.about) if id in finder.scene]
    bare = noun.kind in ("number", "pronoun") and noun.text.lower() in ("another", "another one", "one more")
    if not bare or not last:
        return phrase
    category = finder.scene[last[-1]].category
    finder.seen.append(
        f"'{noun.text}' is taken to be another {category.replace('_', ' ')}, as {last[-1]} was named last"
    )
    one = Noun("thing", category, 0, 0, f"another {category.replace('_', ' ')}", det="another", named=True)
    return replace(phrase, noun=one)


def _add_in_rows(
    work: Work, finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]
) -> list[str] | None:
    """Add another row, more to one that is there, or one before each seat of a table; None where it is other."""
    if is_row(phrase.noun):
        return add_rows(work, finder, order, phrase, places)
    if laid := _laid_for_each(work, finder, order, phrase.noun, places):
        return laid
    line = line_said(work, finder, phrase.noun, places)
    if not line or order.facing or order.closer or order.apart:
        return None
    return add_to_line(work, phrase.noun, line)


def _check(noun: Noun) -> None:
    """Refuse what nothing can be added by.

    Raises:
        InputError: it is no thing, or says how many in a way that means nothing here.
    """
    words = noun.value.split("_")
    known = any(word in known_things() or f"any_{word}" in GENERAL_WORDS for word in map(singular, words[:-1]))
    bare = not noun.named and not (noun.det or noun.count or noun.plural or noun.id)
    if noun.kind != "thing" or noun.det in ("no", "none") or (not noun.named and known) or bare:
        raise InputError(f"'{noun.text}' is no thing that can be added")
    if noun.rows or noun.groups:
        raise InputError(f"'{noun.text}': rows and groups are not added as such; say how many, and where each goes")
    if noun.det in ("both", "half", "other", "each") or noun.fraction[1] or noun.every or noun.ordinal > 2:
        raise InputError(f"'{noun.text}' points at things that are there; say how many are to be added")


def _with(places: Sequence[Where]) -> tuple[list[Where], list[Where]]:
    """What is added along ("a table with four chairs"), and where things go."""
    along = [w for w in places if w.word == "with" and w.noun is not None and w.noun.kind == "thing"]
    return along, [w for w in places if w not in along]


def add_with(work: Work, finder: Finder, order: Order, heads: Sequence[str], along: Sequence[Where]) -> list[str]:
    """Add what goes with things that were added, at each of them."""
    added: list[str] = []
    for head in heads if along else ():
        finder.scene, finder.recent = work.scene, [head]
        for where in along:
            noun = seat_like(work, where.noun, head) if where.noun is not None else None
            it = Noun("thing", work.scene[head].category, 0, 0, "it", det="the", id=head)
            noun = so_many(work, noun, head, several=len(heads) > 1) if noun is not None else None
            if noun is not None and is_laid_before(work, noun.value, head):
                one = replace(noun, count=1, plural=False) if noun.plural and not noun.count else noun
                added += _add(work, finder, Order("add", order.text), NounPhrase(one), [Where("in_front_of", it)])
            elif noun is not None and is_set_beside(work, noun.value, head):
                added += _add(work, finder, Order("add", order.text), NounPhrase(noun), [Where("next_to", it)])
            elif noun is not None and are_seats_around(work, noun, head):
                around = [Where("around", it, text="around")]
                added += _add(work, finder, Order("add", order.text), NounPhrase(noun), around)
            elif noun is not None:
                rests = work.source.usual(category_of(work, noun, ()))[1] == "surface" and work.asset_of(head).surfaces
                at = Where("on" if rests else "to", it, text="on" if rests else "at")
                added += _add(work, finder, Order("add", order.text), NounPhrase(noun), [at])
    return added
