import os
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
LINKED = ("sim", "assets", "training", "exporters")


def run(code: str) -> str:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd="/")
    return done.stdout.strip()


@pytest.mark.parametrize("name", LINKED)
def test_each_folder_is_linked_into_the_package(name):
    link = ROOT / "thinkblox" / name
    assert link.is_symlink()
    assert link.readlink() == Path("..") / name


def test_every_package_on_disk_is_listed():
    listed = set(tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["setuptools"]["packages"])
    found = set()
    for folder, _, files in os.walk(ROOT / "thinkblox", followlinks=True):
        if "__init__.py" in files:
            found.add(".".join(Path(folder).relative_to(ROOT).parts))
    assert found == listed


def test_importing_the_package_loads_nothing_heavy():
    heavy = "{'mujoco', 'pxr', 'torch', 'numpy', 'shapely', 'embreex', 'PIL'}"
    assert run(f"import sys, thinkblox; print(sorted({heavy} & set(sys.modules)))") == "[]"


def test_help_loads_nothing_heavy():
    code = (
        "import sys\nfrom thinkblox.cli import main\ntry:\n    main(['--help'])\nexcept SystemExit:\n    pass\n"
        "print(sorted({'mujoco', 'pxr', 'torch', 'numpy', 'shapely'} & set(sys.modules)))"
    )
    assert run(code).splitlines()[-1] == "[]"


def test_everything_imports_without_a_bare_folder_name():
    code = (
        "import pkgutil, sys, importlib, thinkblox\n"
        "for m in pkgutil.walk_packages(thinkblox.__path__, 'thinkblox.'):\n"
        "    if not m.name.endswith('__main__'):\n"
        "        importlib.import_module(m.name)\n"
        f"print(sorted(set({LINKED!r}) & set(sys.modules)), 'torch' in sys.modules)"
    )
    assert run(code) == "[] False"


def test_every_public_name_exists():
    assert run("import thinkblox; print(all(getattr(thinkblox, n) is not None for n in thinkblox.__all__))") == "True"


def test_an_unknown_name_says_what_there_is():
    import thinkblox

    with pytest.raises(AttributeError, match="generate_room"):
        thinkblox.generate_rooms  # noqa: B018
