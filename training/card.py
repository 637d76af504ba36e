"""The card of a dataset: what is in it, how it was made, and what was left out."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from thinkblox.version import package_version

if TYPE_CHECKING:
    from thinkblox.training.building import DatasetManifest

_MOST = 15
_HEAD = """\
---
configs:
- config_name: default
  data_files:
{files}
license: apache-2.0
tags: [robotics, 3d, indoor scenes, physics]
---

# Demonstrations of furnishing rooms, measured in simulation

{total} steps of {scenes} rooms: what a policy is shown (`prompt`, `images`), and a reasoning and answer (`completion`)
of which the placement was measured in MuJoCo and found valid. Made by ThinkBLOX {version}:

    thinkblox data build --recipe recipe.json --out DIR

Whole rooms belong to one split. `at` says where a row comes from: shard, episode, decision; the episodes, with every
verdict, are in `episodes/`. Everything that decided what was made is in `recipe.json`.
"""


def card_of(manifest: "DatasetManifest") -> str:
    """The text of the card, README.md of the dataset."""
    splits = [split for split, count in manifest.demonstrations.items() if count]
    files = "\n".join(f"  - split: {split}\n    path: data/{split}-*.parquet" for split in splits)
    head = _HEAD.format(
        files=files or "    []",
        total=sum(manifest.demonstrations.values()),
        scenes=manifest.scenes,
        version=package_version(),
    )
    tables = [
        _table("Split", "steps", manifest.demonstrations),
        _table("Left out because of", "steps or rooms", left_out(manifest)),
        _table("Most common objects", "steps", _most_common(manifest.categories)),
        _table("Most common rooms", "steps", _most_common(manifest.rooms)),
    ]
    return "\n".join([head, *filter(None, tables)])


def left_out(manifest: "DatasetManifest") -> dict[str, int]:
    """How many steps or rooms were left out, by why, in words."""
    few = f"rooms of fewer than {manifest.recipe.least} objects"
    return {few if why == "rooms" else why: count for why, count in manifest.refused.items()}


def _most_common(counts: Mapping[str, int]) -> dict[str, int]:
    return dict(sorted(counts.items(), key=lambda item: (-item[1], item[0]))[:_MOST])


def _table(what: str, of: str, counts: Mapping[str, int]) -> str:
    lines = [f"| {what} | {of} |", "| --- | --- |", *(f"| {name} | {count} |" for name, count in counts.items())]
    return "\n".join(lines) + "\n" if counts else ""
