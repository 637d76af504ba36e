"""The files that tests.bench.mutations spoils: of every format some that verify cleanly."""

import json
import random
import shutil
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from pathlib import Path

from pxr import Sdf, Tf

from tests.export_rooms import sample_scene
from tests.foreign_models import MODELS
from tests.layout_rooms import chair_mesh, write
from tests.mutants import (
    USD_NUMBER,
    XML_NUMBER,
    mutated_json,
    mutated_usd,
    mutated_xml,
    nudged_json,
    nudged_text,
    numberless_json,
    numberless_text,
)
from thinkblox.checking import VerifyOptions
from thinkblox.exporters.saving import write_scene
from thinkblox.generate import generate_room
from thinkblox.importing import FORMATS
from thinkblox.saving import save_room

LAYOUTS = Path(__file__).parents[1] / "data" / "layouts"


@dataclass(frozen=True)
class Mutant:
    """A spoiled text.

    Attributes:
        data: the text.
        numberless: one of its numbers was replaced by what is none, and nothing else.
    """

    data: bytes
    numberless: bool


@dataclass(frozen=True)
class Subject:
    """A file that is spoiled, and how it is measured.

    Attributes:
        format: whose it is.
        file: that is spoiled.
        opened: the file that is measured, which is that file or names it.
        reading: how it is read.
        arguments: the same for the command line.
        outside: paths of files that it must not read.
    """

    format: str
    file: Path
    opened: Path
    reading: VerifyOptions = field(default_factory=VerifyOptions)
    arguments: tuple[str, ...] = ()
    outside: tuple[str, ...] = ()

    @property
    def is_json(self) -> bool:
        """Whether it is JSON; it is XML otherwise."""
        return self.file.suffix == ".json"

    def mutant(self, whole: bytes, seed: int) -> Mutant:
        """A spoiled text of the whole one."""
        rng = random.Random(seed)
        numberless = rng.random() < 0.2
        if not self.is_json:
            return Mutant(self._text(whole.decode(), rng, numberless).encode("utf-8", "surrogatepass"), numberless)
        if numberless:
            return Mutant(numberless_json(whole, rng), True)
        if rng.random() < 0.6:
            return Mutant(nudged_json(whole, rng, rng.randint(1, 4)), False)
        return Mutant(mutated_json(whole, rng, values=self.outside), False)

    def _text(self, text: str, rng: random.Random, numberless: bool) -> str:
        usd = self.format == "USD"
        number = USD_NUMBER if usd else XML_NUMBER
        if numberless:
            return numberless_text(text, number, rng)
        if rng.random() < 0.5:
            return nudged_text(text, number, rng, rng.randint(1, 4))
        if usd:
            return mutated_usd(text, rng, rng.randint(1, 6))
        return mutated_xml(text, rng.getrandbits(32), rng.randint(1, 6), values=self.outside)

    def well_formed(self, data: bytes) -> bool:
        """Whether a text is JSON or XML at all, by the standard library, or USD by OpenUSD."""
        try:
            if self.format == "USD":
                Sdf.Layer.CreateAnonymous(".usda").ImportFromString(data.decode())
            elif self.is_json:
                json.loads(data.decode())
            else:
                ElementTree.fromstring(data)
        except (ValueError, RecursionError, ElementTree.ParseError, Tf.ErrorException):
            return False
        return True


def subjects(home: Path, outside: Path) -> list[Subject]:
    """Write the files under `home`, each in a folder of its own; and what they must not read to `outside`."""
    outside.mkdir(parents=True)
    shutil.copy(MODELS / "room" / "assets" / "wedge.obj", outside)
    shutil.copy(MODELS / "room" / "parts" / "table.xml", outside)
    chair_mesh().export(outside / "chair.glb")
    forbidden = tuple(name for path in sorted(outside.iterdir()) for name in (str(path), f"../../outside/{path.name}"))
    made = [maker(home) for maker in (_ours, _sampler, _mjcf, _parts, _assets, _written_mjcf, _urdf, _usd)]
    made += [_layout(home, name) for name in FORMATS]
    made += [_sample(home, name) for name in ("il3d", "sceneeval", "holodeck")]
    return [Subject(s.format, s.file, s.opened, s.reading, s.arguments, forbidden) for s in made]


def _ours(home: Path) -> Subject:
    result = generate_room("A room with a desk, a lamp on it, a wardrobe and a picture.", seed=1)
    file = save_room(result, home / "ours", pictures=False) / "scene.json"
    return Subject("scene.json", file, file)


def _sampler(home: Path) -> Subject:
    file = home / "sampler" / "scene.json"
    file.parent.mkdir()
    write_scene(sample_scene(), file)
    return Subject("scene.json", file, file)


def _mjcf(home: Path) -> Subject:
    """One of everything that the engine has, where it stands."""
    file = home / "rich" / "room.xml"
    file.parent.mkdir()
    text = (MODELS / "rich.xml").read_text()
    text = text.replace('pos="2 0 .1"', 'pos="2 0 .2"').replace('ctrl="0 .1"', 'ctrl="0 0"').replace("0 0 2", "1 0 2")
    file.write_text(text)
    return Subject("MJCF", file, file)


def _room(home: Path, name: str, part: str) -> Subject:
    shutil.copytree(MODELS / "room", home / name)
    return Subject("MJCF", home / name / part, home / name / "room.xml")


def _parts(home: Path) -> Subject:
    return _room(home, "parts", "parts/table.xml")


def _assets(home: Path) -> Subject:
    return _room(home, "assets", "parts/assets.xml")


def _written_mjcf(home: Path) -> Subject:
    return Subject("MJCF", home / "ours" / "scene.xml", home / "ours" / "scene.xml")


def _usd(home: Path) -> Subject:
    file = home / "usd" / "scene.usda"
    shutil.copytree(home / "ours", file.parent)
    return Subject("USD", file, file)


def _urdf(home: Path) -> Subject:
    shutil.copytree(MODELS / "table_description", home / "table_description")
    file = home / "table_description" / "urdf" / "table.urdf"
    return Subject("URDF", file, file)


def _layout(home: Path, format: str) -> Subject:
    file = write(home / format, format)
    side = ("--short-side", "3.0") if format == "layoutgpt" else ()
    return Subject(
        format,
        file,
        file,
        VerifyOptions(format=format, short_side=3.0 if side else None),
        ("--format", format, *side),
    )


def _sample(home: Path, name: str) -> Subject:
    """A file as its generator writes them, with walls, doors and windows."""
    file = home / f"{name}_sample" / f"{name}.json"
    file.parent.mkdir()
    shutil.copy(LAYOUTS / f"{name}.json", file)
    for mesh in LAYOUTS.glob("*.glb"):
        shutil.copy(mesh, file.parent)
    room = "bedroom" if name == "holodeck" else None
    return Subject(
        name,
        file,
        file,
        VerifyOptions(format=name, room=room),
        ("--format", name, *(("--room", room) if room else ())),
    )
