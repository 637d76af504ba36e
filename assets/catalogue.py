"""The table of categories: what can be asked for, what is known of it, and what makes it. Users add their own."""

import re
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import get_args

from thinkblox.assets.category import Category
from thinkblox.assets.facts import Facts
from thinkblox.assets.families import categories, general_words
from thinkblox.assets.figures import check_figures
from thinkblox.assets.plain import plain_categories
from thinkblox.brief import Place
from thinkblox.errors import InputError

_NAME = re.compile(r"[a-z][a-z0-9]*(?:_[a-z][a-z0-9]*)*")
GENERAL_WORDS: Mapping[str, Facts] = MappingProxyType(general_words())
"""What is known of the words that are no categories themselves, such as "any_table"."""


def _all_categories() -> Iterator[Category]:
    """Those with a shape of their own, then the plain ones, which take no word from the others."""
    shaped = {category.name: category for category in categories()}
    known = {**shaped, **GENERAL_WORDS}
    taken = {phrase for kind in known.values() for phrase in phrases(kind)} | {kind.noun for kind in shaped.values()}
    yield from shaped.values()
    yield from plain_categories(taken, known)


def revision() -> int:
    """A number that changes whenever the catalogue does: what is worked out from it is kept by this."""
    return _revisions[0]


def register(category: Category) -> None:
    """Add a category for the rest of this process: prompts, habits and expert know it from now on.

    It takes its name and words from plain things that have them, but not from what has a shape.

    Raises:
        InputError: the name is not in snake_case or exists; an English word of it means something else already; a
            size, a mass or another number that no such thing has, or a generator that cannot be called; or a habit, a
            sense or its companion names a category that there is not.
    """
    where = f"category {category.name!r}"
    if not _NAME.fullmatch(category.name):
        raise InputError(f"{where}: a name must be in snake_case, such as 'tea_trolley'")
    shaped = {name: kind for name, kind in CATALOGUE.items() if not kind.plain}
    if category.name in shaped or category.name in GENERAL_WORDS:
        raise InputError(f"{where} exists already; choose another name")
    check_figures(category, where)
    owners = {phrase: name for name, kind in {**GENERAL_WORDS, **shaped}.items() for phrase in phrases(kind)}
    for phrase in phrases(category):
        if phrase in owners:
            raise InputError(f"{where}: {phrase!r} means {owners[phrase]!r} already; take it out of its words")
    known = {category.name, *CATALOGUE, *GENERAL_WORDS, *get_args(Place)}
    for name in _named(category):
        if name not in known:
            raise InputError(f"{where} names {name!r}, which is no category and no place of a room")
    _rows[category.name] = category
    _revisions[0] += 1


def unregister(name: str) -> None:
    """Take a registered category away again; raises InputError for a name that was not registered."""
    if _rows.get(name) is _built_in.get(name):
        added = ", ".join(sorted(n for n, kind in _rows.items() if kind is not _built_in.get(n))) or "none"
        raise InputError(f"category {name!r} was not registered; registered are: {added}")
    if name in _built_in:
        _rows[name] = _built_in[name]
    else:
        del _rows[name]
    _revisions[0] += 1


def phrases(kind: Facts) -> Iterator[str]:
    """The English phrases that mean a kind of thing, in lower case; plurals only where they are irregular."""
    for phrase in kind.words.lower().split(","):
        yield from filter(None, (form.strip() for form in phrase.partition(":")[0].split("|")))


def _named(kind: Facts) -> Iterator[str]:
    """The categories and places that what is known of a kind of thing names."""
    for habit in kind.habits:
        relation, _, company = habit.partition(" if ")
        yield from (name for name in (*relation.split()[1:], company) if name and not name.startswith("@"))
    yield from (sense.partition(" if ")[0] for sense in kind.senses)
    if kind.companion is not None:
        yield kind.companion.category


_rows = {category.name: category for category in _all_categories()}
_built_in = dict(_rows)
_revisions = [0]

CATALOGUE: Mapping[str, Category] = MappingProxyType(_rows)
"""Every category by name."""
