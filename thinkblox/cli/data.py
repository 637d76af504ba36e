"""`thinkblox data build`: demonstrations of furnishing rooms, measured in simulation, to learn from."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.cli.options import natural, whole
from thinkblox.cli.stopping import heed_stops
from thinkblox.cli.terminal import say, write_json

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands
    from thinkblox.training.recipe import Recipe
    from thinkblox.training.shard import ShardCount

STATUS = (
    "exit status: 0 made; 1 made, and nothing is in it; 2 the input cannot be used; 70 a fault of ours or of the"
    " system, what is done stays; 130 stopped, what is done stays: the same command goes on from there"
)


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    data = commands.add_parser("data", help="make demonstrations to learn from")
    actions = data.add_subparsers(title="actions", required=True, metavar="ACTION")
    parser = actions.add_parser("build", help="make a dataset of demonstrations", epilog=STATUS)
    parser.add_argument(
        "--out", metavar="DIR", type=Path, required=True, help="folder of the dataset; resumed if begun"
    )
    parser.add_argument("--config", metavar="FILE", type=Path, help="take the section `data` of this configuration")
    parser.add_argument("--recipe", metavar="FILE", type=Path, help="make it by the recipe.json of another dataset")
    parser.add_argument("--scenes", metavar="N", type=_scenes, help="rooms, one prompt each")
    parser.add_argument("--seed", metavar="N", type=natural, help="the same seed gives the same bytes (0)")
    parser.add_argument("--order", choices=("plan", "size", "random"), help="in which objects are placed (plan)")
    parser.add_argument(
        "--prompts", metavar="FILE", type=Path, help="prompts to use, one a line, instead of sampled ones"
    )
    parser.add_argument("--workers", metavar="N", type=_workers, default=1, help="processes (1)")
    parser.add_argument("--json", action="store_true", help="print the manifest as JSON")
    parser.set_defaults(run=_build)


def _scenes(text: str) -> int:
    return whole(text, 1, 10_000_000)


def _workers(text: str) -> int:
    return whole(text, 1, 1024)


def _build(arguments: argparse.Namespace) -> int:
    from thinkblox.training.building import build
    from thinkblox.training.card import left_out
    from thinkblox.value import to_json

    def tell(count: "ShardCount", done: int, total: int) -> None:
        heed_stops()
        if not arguments.json:
            made = sum(count.demonstrations.values())
            print(f"{done}/{total} shard {count.shard}: {made} steps of {count.scenes} rooms", file=sys.stderr)

    manifest = build(_recipe(arguments), arguments.out, workers=arguments.workers, on_shard=tell)
    if arguments.json:
        write_json(to_json(manifest))
    else:
        steps = ", ".join(f"{count} {split}" for split, count in manifest.demonstrations.items())
        left = ", ".join(f"{count} {why}" for why, count in left_out(manifest).items())
        say(f"{sum(manifest.demonstrations.values())} steps of {manifest.scenes} rooms: {steps}")
        say(f"left out: {left or 'nothing'}")
        say(f"written to {arguments.out}")
    if not any(manifest.demonstrations.values()):
        print("thinkblox: nothing is in the dataset: every step was left out, for what is said above", file=sys.stderr)
        return 1
    return 0


def _recipe(arguments: argparse.Namespace) -> "Recipe":
    from msgspec import structs

    from thinkblox.errors import InputError
    from thinkblox.training.recipe import Recipe
    from thinkblox.value import read_json

    said = {name: getattr(arguments, name) for name in ("scenes", "seed", "order")}
    said = {name: value for name, value in said.items() if value is not None}
    if arguments.prompts is not None:
        said["prompts"] = _lines(arguments.prompts)
    if arguments.recipe is not None:
        if arguments.config is not None:
            raise InputError("--recipe and --config both say what is made; give one of them")
        return structs.replace(read_json(arguments.recipe, Recipe), **said)
    if arguments.config is not None:
        from thinkblox.training.config import section

        base: Recipe = section(arguments.config, "data")
        return structs.replace(base, **said)
    if arguments.scenes is None:
        raise InputError("how many rooms? Give --scenes N, --recipe FILE, or --config FILE with a section `data`")
    return Recipe(**said)


def _lines(file: Path) -> tuple[str, ...]:
    from thinkblox.errors import InputError
    from thinkblox.regular_file import read_lines

    prompts = read_lines(file)
    if not prompts:
        raise InputError(f"{file}: holds no prompt; give one a line")
    return prompts
