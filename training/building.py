"""Making a dataset of demonstrations: shard by shard, in many processes, to be stopped and resumed at any time."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path

from thinkblox.crew import Done, work_through
from thinkblox.errors import InputError, ThinkBloxError
from thinkblox.training.card import card_of
from thinkblox.training.recipe import RECIPE, Recipe
from thinkblox.training.shard import ShardCount, count_file, make_shard
from thinkblox.value import Value, read_json, to_json
from thinkblox.whole_file import write_whole

MANIFEST = "manifest.json"
SECONDS = 7200.0
"""For one shard [s]."""
Work = Callable[[Callable[[int], ShardCount], Sequence[int]], Iterable[Done[ShardCount]]]
"""Calls a function with each of some numbers, anywhere and in any order, and gives what comes of each as it is done."""


class DatasetManifest(Value, frozen=True, kw_only=True):
    """What a dataset holds: its recipe, and what came of all its shards together."""

    recipe: Recipe
    scenes: int
    demonstrations: dict[str, int]
    refused: dict[str, int]
    categories: dict[str, int]
    rooms: dict[str, int]
    files: tuple[str, ...]


def build(
    recipe: Recipe,
    folder: str | Path,
    *,
    workers: int = 1,
    work: Work | None = None,
    on_shard: Callable[[ShardCount, int, int], None] = lambda count, done, total: None,
) -> DatasetManifest:
    """Make a dataset in a folder, or go on with one that was begun by the same recipe.

    What a shard holds depends on the recipe and on its number alone, so shards may be made anywhere and in any order;
    each is written whole, and one that is there is not made again.

    Args:
        recipe: what is made.
        folder: where; made where it is not there.
        workers: processes.
        work: who makes the shards instead, a cluster say: called with a function and what it is to be called with.
        on_shard: told of each shard that is done: what came of it, how many are, and how many there are to be.

    Raises:
        InputError: the folder holds something else, another recipe's dataset, or cannot be written.
        ThinkBloxError: a shard could not be made; what is done stays, and the same call goes on from there.
    """
    folder = Path(folder)
    _begin(recipe, folder)
    counts: dict[int, ShardCount] = {}
    for count in _done(recipe, folder):
        counts[count.shard] = count
        on_shard(count, len(counts), recipe.shards)
    missing = [shard for shard in range(recipe.shards) if shard not in counts]
    run = work or partial(work_through, jobs=workers, seconds=SECONDS)
    for done in run(partial(make_shard, recipe, folder), missing):
        if done.result is None:
            why = f"{folder}: shard {missing[done.number]} could not be made: {done.fault}"
            raise ThinkBloxError(f"{why}; what is done stays, and the same command goes on from there")
        counts[done.result.shard] = done.result
        on_shard(done.result, len(counts), recipe.shards)
    manifest = _manifest(recipe, [counts[shard] for shard in range(recipe.shards)])
    write_whole(folder / "README.md", card_of(manifest).encode())
    write_whole(folder / MANIFEST, to_json(manifest))
    return manifest


def _begin(recipe: Recipe, folder: Path) -> None:
    """Claim the folder for the recipe."""
    file = folder / RECIPE
    if file.exists():
        if read_json(file, Recipe) != recipe:
            raise InputError(f"{folder}: holds a dataset of another recipe, {file}; choose another folder")
        return
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise InputError(f"{folder}: is not empty, and no dataset of ours; choose another folder")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{folder}: cannot be made: {error.strerror}") from error
    write_whole(file, to_json(recipe))


def _done(recipe: Recipe, folder: Path) -> Iterator[ShardCount]:
    for shard in range(recipe.shards):
        file = folder / count_file(shard)
        if file.exists():
            count = read_json(file, ShardCount)
            if all((folder / name).exists() for name in count.files):
                yield count


def _manifest(recipe: Recipe, counts: list[ShardCount]) -> DatasetManifest:
    def total(of: Callable[[ShardCount], dict[str, int]]) -> dict[str, int]:
        together: Counter[str] = Counter()
        for count in counts:
            together.update(of(count))
        return dict(sorted(together.items()))

    return DatasetManifest(
        recipe=recipe,
        scenes=sum(count.scenes for count in counts),
        demonstrations=total(lambda count: count.demonstrations),
        refused=total(lambda count: count.refused),
        categories=total(lambda count: count.categories),
        rooms=total(lambda count: count.rooms),
        files=tuple(name for count in counts for name in count.files),
    )
