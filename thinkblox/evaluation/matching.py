"""Which object counts for which demanded category: each for the most special one that it is."""

from collections.abc import Iterable, Mapping, Sequence

from thinkblox.evaluation.vocabulary import Vocabulary


def match(
    named: Mapping[str, Sequence[str]], categories: Iterable[str], vocabulary: Vocabulary
) -> dict[str, tuple[str, ...]]:
    """The ids of the objects of each category.

    As in SceneEval, an object counts for one category only: where a prompt demands a table and two coffee tables, a
    coffee table is no table. What is only alike counts where nothing else is there for that category.

    Args:
        named: id of each object -> the names that it has, any of which may match.
        categories: what is demanded.
        vocabulary: by which names match.
    """
    found: dict[str, list[str]] = {category: [] for category in categories}
    left: list[str] = []
    for id, names in named.items():
        best = _nearest(names, found, vocabulary)
        if best is None:
            left.append(id)
        else:
            found[best].append(id)
    for category in [category for category, ids in found.items() if not ids]:
        stand_ins = [id for id in left if any(vocabulary.is_alike(name, category) for name in named[id])]
        found[category] += stand_ins
        left = [id for id in left if id not in stand_ins]
    return {category: tuple(ids) for category, ids in found.items()}


def _nearest(names: Sequence[str], categories: Iterable[str], vocabulary: Vocabulary) -> str | None:
    """The demanded category that lies the fewest kinds above any of the names, and of several the most special."""
    steps: dict[str, int] = {}
    for category in categories:
        above = [step for name in names if (step := vocabulary.steps(name, category)) is not None]
        if above:
            steps[category] = min(above)
    nearest = [category for category, step in steps.items() if step == min(steps.values())]
    special = [a for a in nearest if any(vocabulary.steps(a, b) is not None for b in nearest if a != b)]
    return next(iter([*special, *nearest]), None)


def is_kind_of(names: Iterable[str], category: str, vocabulary: Vocabulary) -> bool:
    """Whether an object of these names is one of a category, or may be taken for one."""
    return any(vocabulary.steps(n, category) is not None or vocabulary.is_alike(n, category) for n in names)


def names_of(category: str, description: str) -> tuple[str, ...]:
    """The names that an object has, which are words for it."""
    return (category, description) if description else (category,)
