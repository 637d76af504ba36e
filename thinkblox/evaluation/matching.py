"""Which object counts for which demanded category: each for the most special one that it is."""

from collections.abc import Iterable, Mapping, Sequence

from thinkblox.evaluation.annotations import Annotation
from thinkblox.evaluation.vocabulary import Vocabulary


def match(
    named: Mapping[str, Sequence[str]], annotation: Annotation, vocabulary: Vocabulary
) -> dict[str, tuple[str, ...]]:
    """The ids of the objects of each category that a row speaks of.

    As in SceneEval, an object counts for one of the counted categories only: where a prompt demands a table and two
    coffee tables, a coffee table is no table. What is only alike counts where nothing else is there for that category.
    A category that no row counts takes every object that is one of it.

    Args:
        named: id of each object -> the names that it has, any of which may match.
        annotation: what is demanded.
        vocabulary: by which names match.
    """
    counted = {vocabulary.canonical(row.category) for row in annotation.counts}
    found = _shared_out(named, sorted(counted), vocabulary)
    for category in annotation.categories:
        name = vocabulary.canonical(category)
        if name not in found:
            kinds = [id for id, names in named.items() if _is_one(names, name, vocabulary)]
            found[name] = kinds or [id for id, names in named.items() if is_kind_of(names, name, vocabulary)]
    return {category: tuple(found[vocabulary.canonical(category)]) for category in annotation.categories}


def _shared_out(
    named: Mapping[str, Sequence[str]], categories: Iterable[str], vocabulary: Vocabulary
) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {category: [] for category in categories}
    left: list[str] = []
    for id, names in named.items():
        best = _nearest(names, found, vocabulary)
        (left if best is None else found[best]).append(id)
    for category in [category for category, ids in found.items() if not ids]:
        found[category] = [id for id in left if is_kind_of(named[id], category, vocabulary)]
        left = [id for id in left if id not in found[category]]
    return found


def _is_one(names: Iterable[str], category: str, vocabulary: Vocabulary) -> bool:
    return any(vocabulary.steps(name, category) is not None for name in names)


def _nearest(names: Sequence[str], categories: Iterable[str], vocabulary: Vocabulary) -> str | None:
    """The most special of the demanded categories that any of the names is one of, and of several the nearest."""
    steps: dict[str, int] = {}
    for category in categories:
        above = [step for name in names if (step := vocabulary.steps(name, category)) is not None]
        if above:
            steps[category] = min(above)
    special = [a for a in steps if not any(a != b and vocabulary.steps(b, a) is not None for b in steps)]
    return min(special or steps, key=lambda category: steps[category], default=None)


def is_kind_of(names: Iterable[str], category: str, vocabulary: Vocabulary) -> bool:
    """Whether an object of these names is one of a category, or may be taken for one."""
    return any(vocabulary.steps(n, category) is not None or vocabulary.is_alike(n, category) for n in names)


def names_of(category: str, description: str) -> tuple[str, ...]:
    """The names that an object has, which are words for it."""
    return (category, description) if description else (category,)
