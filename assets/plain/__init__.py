"""Plain stand-ins: a table of things that have no shape of their own, and the few solids that they are made of.

A line of the table reads ``name; depth width height; mass; shape main accent; place; word, word``: lengths along the
front, across and up [m], the mass [kg], one of SHAPES with two finishes, one of KEEPING, and English words besides the
name. "name|plural" where the plural is irregular, "name|" where there is none. What a category of the catalogue has a
word for is not taken from here.
"""

from collections.abc import Callable, Collection, Iterator, Mapping
from copy import copy
from functools import lru_cache, partial
from pathlib import Path

from thinkblox.assets.category import Category, Generator
from thinkblox.assets.facts import Role
from thinkblox.assets.part import Build
from thinkblox.assets.plain import devices, fixtures, pieces, solids, stands
from thinkblox.assets.plain.finishes import finish_called
from thinkblox.assets.plain.places import KEEPING, Front
from thinkblox.errors import InputError

Solid = Callable[..., Build]
SHAPES: Mapping[str, Solid] = {
    solid.__name__: solid
    for module in (solids, pieces, fixtures, devices, stands)
    for solid in vars(module).values()
    if callable(solid) and getattr(solid, "__module__", "") == module.__name__ and not solid.__name__.startswith("_")
}
"""The solids by the name that the table gives them."""
_ROUND = frozenset("can ball dome bowl bucket bottle cone pillar post fountain tuft heap pendant tripod".split())
_TWO = frozenset("slab roll soft cloth stack crate stick tool stand platform rack frame cage mat strings".split())
_SOFT = frozenset("soft cloth heap hung mat".split())
_HOLDING = {
    **dict.fromkeys(
        "block can bag pot jug bottle tub bucket bowl pan dome cone soft slab wedge fountain vehicle".split(), "open"
    ),
    **dict.fromkeys("cabinet machine cage gable".split(), "open-fronted"),
    "rack": "tiered",
}
"""The form that a solid has when it is told to hold others, by the shape."""
_STATES: Mapping[str, tuple[str, ...]] = {"tome": ("open",)}
"""In which states a solid can be made besides as usual, by the shape."""
_GROUPS: Mapping[str, tuple[str, ...]] = {"shelves": ("tiered",)}
"""The groups of what has a shape, besides those of where it is kept."""
_WORDS = 5
"""The column of the words, which a line need not have."""


def plain_categories(taken: Collection[str], names: Collection[str]) -> Iterator[Category]:
    """The categories of the table, without the phrases in `taken` and the categories in `names`.

    A line whose every word is taken gives no category; one whose name is taken is called by its first free word.

    Raises:
        InputError: a line that cannot be read.
    """
    gone, used = frozenset(taken), set(names)
    for where, columns in table_lines():
        words = ", ".join(words_of_line(columns))
        name = columns[0].partition("|")[0]
        if name in used or not gone.isdisjoint(words.replace("|", ", ").split(", ")):
            free = [word for word in words.split(", ") if gone.isdisjoint(forms_of(word))]
            name, words = free[0].partition("|")[0].replace(" ", "_") if free else "", ", ".join(free)
        if name and name not in used:
            used.add(name)
            yield _category(where, columns, name, words)


def table_lines() -> Iterator[tuple[str, list[str]]]:
    """The columns of each line of the table, with where it stands."""
    for path in sorted(Path(__file__).parent.glob("*.txt")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if line and line[0] != "#":
                yield f"{path.name}, line {number}", line.split("; ")


def words_of_line(columns: list[str]) -> list[str]:
    """Every English phrase of a line as "singular|plural", its name first."""
    return [columns[0].replace("_", " "), *(columns[_WORDS].split(", ") if len(columns) > _WORDS else ())]


def forms_of(word: str) -> list[str]:
    """Singular and irregular plural of "singular|plural", as far as there are any."""
    return [form for form in word.split("|") if form]


def _category(where: str, columns: list[str], name: str, words: str) -> Category:
    try:
        depth, width, height = map(float, columns[1].split())
        made = {
            "name": name,
            "noun": name.replace("_", " "),
            "size": (depth, width, height),
            "mass": float(columns[2]),
            "generator": plain_generator(*columns[3].split()),
            "words": words,
        }
        kind = _kind(columns[3].partition(" ")[0], columns[4], abs(depth - width) < 1e-9)
    except (ValueError, TypeError, KeyError, IndexError, InputError) as error:
        raise InputError(f"the table of plain things, {where}: {'; '.join(columns)!r}: {error}") from error
    category = copy(kind)
    vars(category).update(made)
    return category


@lru_cache(maxsize=1024)
def _kind(shape: str, place: str, square: bool) -> Category:
    """What all things of one shape that are kept alike share: checked once, since checks of each would take long."""
    kept = KEEPING[place]
    kind = Category(
        name="",
        noun="",
        generator=plain_generator(shape, "grey"),
        size=(1.0, 1.0, 1.0),
        mass=1.0,
        mount=kept.mount,
        front=front_of(shape, square=square),
        friction=0.7 if shape in _SOFT else 0.5,
        clearance=kept.clearance,
        variation=0.04,
        large=kept.large,
        flat=kept.flat,
        low=0.4,
        high=2.5,
        plain=True,
        groups=(*kept.groups, *_GROUPS.get(shape, ())),
        habits=kept.habits,
        hanging=kept.hanging,
        gaze=kept.gaze,
        row=kept.row,
        forms=_forms(shape),
        states=_STATES.get(shape, ()),
    )
    _ = kind.places  # worked out once for all of them
    return kind


def _forms(shape: str) -> dict[Role, str]:
    if shape == "platform":
        return {"over": "open"}
    if shape == "rack":
        return {"holds": _HOLDING[shape], "carries": _HOLDING[shape]}
    if shape == "crate":
        return {"carries": "closed"}
    return {"holds": _HOLDING[shape]} if shape in _HOLDING else {}


@lru_cache(maxsize=2048)
def plain_generator(shape: str, main: str, accent: str = "") -> Generator:
    """What makes a solid of SHAPES in two finishes, given by their words; raises InputError for another name."""
    if shape not in SHAPES:
        raise InputError(f"no plain shape {shape!r}; there are {', '.join(sorted(SHAPES))}")
    return partial(SHAPES[shape], main=finish_called(main), accent=finish_called(accent or main))


def shape_of(category: Category) -> str:
    """The name of the solid that a plain category is made as; empty for what has a shape of its own."""
    made = category.generator
    return made.func.__name__ if isinstance(made, partial) else ""


def front_of(shape: str, *, square: bool) -> Front:
    """How many ways round a solid of this shape looks the same; `square` where it is as deep as wide."""
    if shape in _ROUND and square:
        return "any"
    return "two" if shape in _TWO or shape in _ROUND else "one"
