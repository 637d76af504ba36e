"""The pictures of docs/pictures, made anew.

python -m tests.bench.gallery [--out DIR] [--edit | --kinds [NAME ...]]
"""

import argparse
import sys
import tomllib
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import NamedTuple, cast

from PIL import Image

from tests.bench.robots import picture as robot_picture
from tests.bench.rooms import PROMPTS
from thinkblox.assets import CATALOGUE, make_asset
from thinkblox.editing import edit_room
from thinkblox.fills import Fill
from thinkblox.generate import generate_room
from thinkblox.observe import Observation, Sight
from thinkblox.sim.render import contact_sheet, render_preview, render_top

SHOWN = (
    "A living room, 5 m by 4.2 m, where a three-seat sofa faces a TV on a TV stand, with a coffee table on a rug "
    "between them, two armchairs, a floor lamp, a tall plant, a bookcase full of books and a picture above the sofa."
)
EDITED = "A bedroom, 5 m by 4.5 m: a double bed, two nightstands, a lamp on each, a wardrobe, a desk and armchair."
INSTRUCTION = (
    "Replace the armchair with a rocking chair, rotate the desk by 90 degrees, add a floor lamp next to the wardrobe"
    " and put a rug under the bed."
)
"""The room of docs/editing.md, and what is changed in it."""
KINDS = Path(__file__).with_name("kinds.toml")
COLUMNS, TILE = 3, 330
"""Of a contact sheet: rooms side by side, and the side of the picture of each in pixels."""
ROOMS = (0, 3, 4, 7, 12, 13, 15, 16, 21)
"""Lines of prompts.txt in the overview."""


def room(prompt: str) -> Image.Image:
    """A small preview of the room for a prompt."""
    return render_preview(generate_room(prompt).scene, size=400)


class Shown(NamedTuple):
    """A room of a contact sheet."""

    fill: Fill
    seed: int
    prompt: str


def kinds() -> dict[str, list[Shown]]:
    """The rooms of each contact sheet, by the kind of room."""
    table: dict[str, list[str]] = tomllib.loads(KINDS.read_text(encoding="utf-8"))
    return {kind: [_shown(line) for line in lines] for kind, lines in table.items()}


def _shown(line: str) -> Shown:
    how, _, prompt = line.partition(": ")
    fill, seed = how.split()
    return Shown(cast(Fill, fill), int(seed), prompt)


def tile(shown: Shown) -> Image.Image:
    """A preview for a contact sheet."""
    made = generate_room(shown.prompt, seed=shown.seed, fill=shown.fill)
    return render_preview(made.scene, size=2 * TILE).convert("RGB").resize((TILE, TILE), Image.Resampling.LANCZOS)


def draw_kinds(out: Path, names: list[str]) -> None:
    """Draw a contact sheet for each kind of room, or for those that are named."""
    for kind, rooms in kinds().items():
        if names and kind not in names:
            continue
        with ProcessPoolExecutor(2) as pool:
            tiles = list(pool.map(tile, rooms))
        sheet = Image.new("RGB", (COLUMNS * TILE, -(-len(tiles) // COLUMNS) * TILE))
        for number, picture in enumerate(tiles):
            sheet.paste(picture, (number % COLUMNS * TILE, number // COLUMNS * TILE))
        sheet.save(out / f"{kind}.jpg", quality=82, optimize=True)


def overview() -> Image.Image:
    """Nine rooms, three by three."""
    prompts = PROMPTS.read_text().splitlines()
    with ProcessPoolExecutor(2) as pool:
        pictures = list(pool.map(room, [prompts[i] for i in ROOMS]))
    sheet = Image.new("RGB", (1200, 1200))
    for number, picture in enumerate(pictures):
        sheet.paste(picture.convert("RGB"), (number % 3 * 400, number // 3 * 400))
    return sheet


def sight(observation: Observation) -> Image.Image:
    """What a model is shown at one step: the three views, and the object to place."""
    size = 448
    sheet = Image.new("RGB", (2 * size, 2 * size), (240, 237, 230))
    *views, target = observation.images(Sight(size=size))
    for number, picture in enumerate(views):
        sheet.paste(picture, (number % 2 * size, number // 2 * size))
    sheet.paste(target, (3 * size // 2 - target.width // 2, 3 * size // 2 - target.height // 2))
    return sheet


def edited() -> tuple[Image.Image, Image.Image]:
    """A room before and after an instruction."""
    made = generate_room(EDITED)
    result = edit_room(made, INSTRUCTION)
    return render_preview(made.scene, size=640), render_preview(result.scene, size=640)


def draw_edit(out: Path) -> None:
    """Draw the room of docs/editing.md before and after its instruction."""
    for name, picture in zip(("edit_before.png", "edit_after.png"), edited(), strict=True):
        picture.convert("RGB").save(out / name, optimize=True)


def main() -> int:
    """Draw every picture into the folder."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("docs/pictures"))
    parser.add_argument("--edit", action="store_true", help="only the pair of docs/editing.md")
    parser.add_argument("--kinds", nargs="*", metavar="NAME", help="only the contact sheets of docs/rooms.md")
    arguments = parser.parse_args()
    out = arguments.out
    out.mkdir(parents=True, exist_ok=True)
    if arguments.kinds is not None:
        draw_kinds(out, arguments.kinds)
        return 0
    draw_edit(out)
    if arguments.edit:
        return 0
    shown = generate_room(SHOWN)
    scene = shown.scene
    render_preview(scene).save(out / "preview.png", optimize=True)
    render_top(scene).save(out / "top.png", optimize=True)
    steps = [decision.observation for decision in shown.episode.decisions()]
    last = next(o for o in reversed(steps) if o.asset.mount == "floor" and o.asset.front == "one")
    sight(last).save(out / "sight.png", optimize=True)
    draw_kinds(out, [])
    overview().save(out / "rooms.png", optimize=True)
    robot_picture().save(out / "robot.png", optimize=True)
    assets = [make_asset(name, seed=2) for name in sorted(CATALOGUE) if not CATALOGUE[name].plain]
    contact_sheet(assets, columns=14, size=110).quantize(256).save(out / "catalogue.png", optimize=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
