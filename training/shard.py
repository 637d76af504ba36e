"""One shard of a dataset: some rooms, made, filtered, drawn and written. What a worker process does."""

import gzip
import json
from collections import Counter
from collections.abc import Iterator, Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from msgspec import structs

from thinkblox.chat import Chat
from thinkblox.episode import Episode
from thinkblox.errors import InputError
from thinkblox.generate import generate_room
from thinkblox.placing import Effort
from thinkblox.png import png_of
from thinkblox.policies.chat_format import images, messages
from thinkblox.training.demonstration import Demonstration, demonstrations, shown
from thinkblox.training.prompts import sample_prompt
from thinkblox.training.recipe import SPLITS, Recipe, Split
from thinkblox.value import Value, to_json
from thinkblox.whole_file import write_whole

if TYPE_CHECKING:
    pass

EFFORT = Effort(restarts=0, rounds=1, revisions=0, seconds=60.0)
"""How hard a room is tried: what the expert places well is wanted, not what is mended afterwards."""


class ShardCount(Value, frozen=True, kw_only=True):
    """What came of a shard.

    Attributes:
        shard: its number.
        scenes: rooms that something was learnt from.
        demonstrations: for each split.
        refused: demonstrations by the filter that they did not pass; "rooms" of too few objects, "given up" for rooms
            that could not be made.
        categories: demonstrations for each category.
        rooms: demonstrations for each type of room.
        files: what was written, by the names in the dataset's folder.
    """

    shard: int
    scenes: int = 0
    demonstrations: dict[str, int] = {}
    refused: dict[str, int] = {}
    categories: dict[str, int] = {}
    rooms: dict[str, int] = {}
    files: tuple[str, ...] = ()


def make_shard(recipe: Recipe, folder: Path, shard: int) -> ShardCount:
    """Make a shard and write its files: its rows, the episodes that they come from, and last what came of it.

    Raises:
        InputError: something cannot be written.
    """
    rows: dict[Split, list[dict[str, Any]]] = {split: [] for split in SPLITS}
    counts: dict[str, Counter[str]] = {"refused": Counter(), "category": Counter(), "room": Counter()}
    episodes: list[bytes] = []
    for number in recipe.scenes_of(shard):
        episode = _episode(recipe, number, counts["refused"])
        if episode is None:
            continue
        found = list(_rows(recipe, episode, number, len(episodes), shard, counts))
        if found:
            rows[recipe.split_of(number)] += found
            episodes.append(episode.to_jsonl())
    files = [_write(folder / episodes_file(shard), gzip.compress(b"".join(episodes), mtime=0))]
    files += [
        _write(folder / f"data/{split}-{shard:05d}.parquet", _parquet(rows[split])) for split in SPLITS if rows[split]
    ]
    count = ShardCount(
        shard=shard,
        scenes=len(episodes),
        demonstrations={split: len(rows[split]) for split in SPLITS},
        refused=dict(sorted(counts["refused"].items())),
        categories=dict(sorted(counts["category"].items())),
        rooms=dict(sorted(counts["room"].items())),
        files=tuple(str(file.relative_to(folder)) for file in files),
    )
    _write(folder / count_file(shard), to_json(count))
    return count


def episodes_file(shard: int) -> str:
    """Where the episodes of a shard are: their traces one after the other, packed."""
    return f"episodes/{shard:05d}.jsonl.gz"


def count_file(shard: int) -> str:
    """Where it is written that a shard is done."""
    return f"done/{shard:05d}.json"


def _episode(recipe: Recipe, number: int, refused: Counter[str]) -> Episode | None:
    rng = np.random.default_rng((recipe.seed, number))
    prompt = recipe.prompts[number % len(recipe.prompts)] if recipe.prompts else sample_prompt(rng)
    try:
        made = generate_room(prompt, seed=int(rng.integers(2**31)), effort=EFFORT, order=recipe.order)
    except InputError:
        refused["given up"] += 1
        return None
    if len(made.scene.placements) < recipe.least:
        refused["rooms"] += 1
        return None
    kept = [structs.replace(r, propose_seconds=0.0, check_seconds=0.0) for r in made.episode.rounds if r.kept]
    used = {r.asset for r in kept} | {p.asset for r in kept for p in r.committed}
    assets = {id: asset for id, asset in made.episode.assets.items() if id in used}
    return structs.replace(made.episode, rounds=tuple(kept), assets=assets)


def _rows(
    recipe: Recipe, episode: Episode, number: int, index: int, shard: int, counts: dict[str, Counter[str]]
) -> Iterator[dict[str, Any]]:
    for made, decision in demonstrations(episode, recipe.filters, worked=recipe.worked, refused=counts["refused"]):
        counts["category"][made.category] += 1
        counts["room"][made.room] += 1
        yield row(made, shown(decision, recipe.sight), scene=number, at=f"{shard}/{index}/{made.decision}")


def row(made: Demonstration, chat: Chat, *, scene: int, at: str) -> dict[str, Any]:
    """A demonstration as trainers read it; `at` says where its episode is: shard, episode and decision."""
    return {
        "prompt": messages(chat),
        "completion": [{"role": "assistant", "content": [{"type": "text", "text": made.text}]}],
        "images": [{"bytes": png_of(image), "path": None} for image in images(chat)],
        "scene": scene,
        "at": at,
        "id": made.id,
        "category": made.category,
        "room": made.room,
        "asked": made.prompt,
    }


def _parquet(rows: Sequence[dict[str, Any]]) -> bytes:
    """Rows as a Parquet file that `datasets` reads with its pictures."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    text, block = pa.string(), pa.struct({"type": pa.string(), "text": pa.string()})
    said = pa.list_(pa.struct({"role": text, "content": pa.list_(block)}))
    picture = pa.struct({"bytes": pa.binary(), "path": text})
    types = {"prompt": said, "completion": said, "images": pa.list_(picture), "scene": pa.int64()}
    types |= dict.fromkeys(("at", "id", "category", "room", "asked"), text)
    schema = pa.schema(types, metadata={"huggingface": json.dumps({"info": {"features": FEATURES}})})
    held = BytesIO()
    pq.write_table(pa.Table.from_pylist(list(rows), schema), held, compression="zstd")
    return held.getvalue()


_TEXT = {"dtype": "string", "_type": "Value"}
_SAID = {
    "_type": "List",
    "feature": {"role": _TEXT, "content": {"_type": "List", "feature": {"type": _TEXT, "text": _TEXT}}},
}
FEATURES: dict[str, Any] = {
    "prompt": _SAID,
    "completion": _SAID,
    "images": {"_type": "List", "feature": {"_type": "Image"}},
    "scene": {"dtype": "int64", "_type": "Value"},
    **dict.fromkeys(("at", "id", "category", "room", "asked"), _TEXT),
}
"""The columns of a shard, in the words of `datasets`."""


def _write(file: Path, data: bytes) -> Path:
    file.parent.mkdir(parents=True, exist_ok=True)
    write_whole(file, data)
    return file
