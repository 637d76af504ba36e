"""Exported rooms before Khronos' own validator of glTF, which npm installs when it is first needed.

python -m tests.bench.gltf ROOMS [--home DIR]
"""

import argparse
import json
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

from thinkblox.exporters.exporting import export_file
from thinkblox.sim.environment import rooms_of

PACKAGE = "gltf-validator@2.0.0-dev.3.10"
_ASKS = """
const fs = require('fs'), validator = require('gltf-validator');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])), {maxIssues: 0})
  .then(told => console.log(JSON.stringify(told)), error => { console.error(error); process.exit(1); });
"""


def validator(home: Path) -> Path:
    """The folder in which the validator is installed; raises CalledProcessError when it cannot be."""
    if not (home / "node_modules" / "gltf-validator").is_dir():
        home.mkdir(parents=True, exist_ok=True)
        subprocess.run(["npm", "install", "--silent", "--prefix", home, PACKAGE], check=True)
    return home


def validated(file: Path, home: Path) -> dict[str, Any]:
    """What the validator says of a file."""
    done = subprocess.run(
        ["node", "-e", _ASKS, file.absolute()], cwd=validator(home), capture_output=True, text=True, check=True
    )
    return json.loads(done.stdout)  # type: ignore[no-any-return]


def main() -> int:
    """Print a line for each room; exit status 1 when one has errors."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rooms", nargs="+")
    parser.add_argument("--home", type=Path, default=Path("out/gltf"))
    arguments = parser.parse_args()
    wrong = 0
    for source in (source for room in arguments.rooms for source in rooms_of(room)):
        with tempfile.TemporaryDirectory(prefix="gltf-") as folder:
            told = validated(export_file(source.load(), Path(folder, "room.glb"), doors=True), arguments.home)
        issues = told["issues"]
        kinds = dict(Counter(message["code"] for message in issues["messages"]))
        print(f"{source.name}: {issues['numErrors']} errors, {issues['numWarnings']} warnings, {kinds}", flush=True)
        wrong += issues["numErrors"]
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
