"""What the README and the guide show is run as it stands."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.bench.gallery import kinds

ROOT = Path(__file__).parent.parent
RUN = ("guide", "extending", "models", "editing", "mcp", "environment", "interop")
BLOCKS = [
    pytest.param(block, id=f"{name}-{number}", marks=[] if name == "README.md" else [pytest.mark.slow])
    for name in ("README.md", *(f"docs/{page}.md" for page in RUN))
    for number, block in enumerate(re.findall(r"```python\n(.*?)```", (ROOT / name).read_text(), re.DOTALL))
]


@pytest.mark.parametrize("block", BLOCKS)
def test_python_blocks_run(block, tmp_path):
    done = subprocess.run([sys.executable, "-c", block], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout


def make(*arguments: str) -> subprocess.CompletedProcess[str]:
    """Make in this environment, which is taken as set up."""
    done = [f"-o{sys.prefix}/{stamp}" for stamp in ("installed", "installed-dev")]
    command = ["make", "-C", str(ROOT), *done, f"VENV={sys.prefix}", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_make_demo_writes_a_room_and_prints_the_report():
    done = make("demo")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "all as asked" in done.stdout
    names = {path.name for path in (ROOT / "out" / "demo").iterdir()}
    assert names == {
        "scene.json", "scene.xml", "scene.usda", "report.json", "trace.jsonl", "preview.png", "top.png",
        "manifest.json", "assets",
    }  # fmt: skip


def test_make_test_lints_types_and_tests():
    done = make("--dry-run", "test")
    assert done.returncode == 0, done.stderr
    assert all(tool in done.stdout for tool in ("ruff", "lint-imports", "mypy", "pytest"))


@pytest.mark.slow
def test_the_commands_of_the_readme_run(tmp_path):
    shown = re.findall(r"^    thinkblox (\w+)(.*)$", (ROOT / "README.md").read_text(), re.MULTILINE)
    assert [command for command, _ in shown] == [
        "generate", "edit", "verify", "evaluate", "export", "render", "assets", "schema",
    ]  # fmt: skip
    values = {"PROMPT": "An empty room with nothing in it but a chair.", "DIR": str(tmp_path / "room")}
    values |= {"SCENE": values["DIR"], "N": "2", "PX": "96", "NAME": "scene", "WHO": "expert"}
    values |= {"INSTRUCTION": "Turn the chair by 90 degrees."}
    values |= {"PATH": values["DIR"], "A,B": "scenesmith,sceneeval_sim", "FILE": str(tmp_path / "page.html")}
    demands = [{"id": "chair", "prompt": values["PROMPT"], "count": [["eq", 1, "chair"]]}]
    (tmp_path / "annotations.json").write_text(json.dumps(demands))
    for command, rest in shown:
        rest = rest.replace("--annotations FILE", f"--annotations {tmp_path / 'annotations.json'}")
        rest = rest.replace("--category NAME", "--category desk")
        rest = rest.replace("--out DIR", f"--out {tmp_path / command}") if command in ("edit", "export") else rest
        rest = rest.replace("--to A,B", "--to mjcf,glb").replace("--flavor NAME", "--flavor mjx")
        words = re.sub(r"\[--(room|json|out|overwrite)[^]]*\]|#.*|[\[\]]", "", rest).split()
        arguments = [values.get(word, word) for word in words]
        done = subprocess.run(
            [sys.executable, "-m", "thinkblox", command, *arguments], capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, (command, done.stderr)


def test_links_point_at_files():
    pages = (*RUN, "engines", "rooms", "training", "evaluation", "benchmarks")
    for name in ("README.md", *(f"docs/{page}.md" for page in pages)):
        for link in re.findall(r"\]\(([^)#:]+)\)", (ROOT / name).read_text()):
            assert (ROOT / name).parent.joinpath(link).exists(), (name, link)


def test_setting_up_installs_what_runs_and_the_tools_only_where_used(tmp_path):
    demo, test = (make("--dry-run", f"VENV={tmp_path}/fresh", target).stdout for target in ("demo", "test"))
    assert "install -c constraints.txt --no-build-isolation -e .\n" in demo
    assert "[dev]" not in demo
    assert "[dev]" in test
    assert "--quiet" not in demo + test
    assert "lint-imports --no-logo" in test


def test_the_tree_of_the_readme_names_what_exists():
    tree = (ROOT / "README.md").read_text().split("## The tree")[1].split("##")[0]
    for line in re.findall(r"^    (\S.*?)  ", tree, re.MULTILINE):
        assert all((ROOT / word).exists() for word in line.split()), line


def test_every_contact_sheet_is_shown_with_its_prompts():
    text = (ROOT / "docs/rooms.md").read_text(encoding="utf-8")
    for kind, rooms in kinds().items():
        assert f"(pictures/{kind}.jpg)" in text
        assert (ROOT / f"docs/pictures/{kind}.jpg").stat().st_size < 400_000
        assert len(rooms) == 6
        assert all(f"{room.prompt} (seed {room.seed}, {room.fill})" in text for room in rooms)
