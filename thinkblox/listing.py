"""The catalogue as a table: what may be asked for, by which words, and what comes of it."""

from collections.abc import Iterator

from thinkblox.assets import Category
from thinkblox.value import Value, Vec3


class CategoryEntry(Value, frozen=True, kw_only=True):
    """What is said of one category.

    Attributes:
        name: in snake_case, as in ids.
        noun: for people.
        mount: what it is placed on.
        size: of an ordinary one (along the front axis, across, up) [m].
        mass: of one of that size [kg].
        smallest, largest: what can be made [m].
        attributes: words of a prompt that change its size ("double", "for-6").
        words: English phrases that mean it, in the singular.
        plain: it is a plain stand-in: its size, mass and colours are meant, not its shape.
    """

    name: str
    noun: str
    mount: str
    size: Vec3
    mass: float
    smallest: Vec3
    largest: Vec3
    attributes: tuple[str, ...] = ()
    words: tuple[str, ...] = ()
    plain: bool = False


def listed(category: Category) -> CategoryEntry:
    """All that is said of a category."""
    smallest, largest = category.size_range
    people = (f"for-{category.seats}",) if category.seats else ()
    return CategoryEntry(
        name=category.name,
        noun=category.noun,
        mount=category.mount,
        size=category.size,
        mass=float(category.mass),
        smallest=smallest,
        largest=largest,
        attributes=(*category.variants, *people),
        words=tuple(dict.fromkeys(_words(category))),
        plain=category.plain,
    )


def _words(category: Category) -> Iterator[str]:
    """The English phrases for a category, in lower case and without their plurals."""
    for item in category.words.lower().split(","):
        yield from filter(None, [item.partition(":")[0].partition("|")[0].strip()])
