import os
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from importlib.metadata import version
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


def shipped() -> list[Path]:
    """Every file of the package, code and data, relative to the root."""
    found = [
        (Path(folder) / file).relative_to(ROOT)
        for folder, _, files in os.walk(ROOT / "thinkblox", followlinks=True)
        for file in files
    ]
    return [path for path in found if "__pycache__" not in path.parts]


def test_every_folder_with_code_or_data_is_listed():
    listed = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["setuptools"]["packages"]
    assert {".".join(path.parent.parts) for path in shipped()} == set(listed)
    assert len(set(listed)) == len(listed)


def test_a_wheel_holds_everything_and_building_it_warns_of_nothing(tmp_path):
    source = tmp_path / "source"
    source.mkdir()
    for name in ("pyproject.toml", "setup.py", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source)
    for name in ("thinkblox", *LINKED):
        shutil.copytree(ROOT / name, source / name, symlinks=True, ignore=shutil.ignore_patterns("__pycache__"))
    code = "from setuptools import build_meta; print(build_meta.build_wheel('.'))"
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    built = subprocess.run(
        [sys.executable, "-c", code], cwd=source, env=environment, capture_output=True, text=True, check=False
    )
    assert built.returncode == 0, built.stderr
    assert "warning" not in (built.stdout + built.stderr).lower()
    with zipfile.ZipFile(source / built.stdout.split()[-1]) as wheel:
        held = set(wheel.namelist())
        metadata = wheel.read(next(name for name in held if name.endswith("METADATA"))).decode()
    assert {path.as_posix() for path in shipped()} <= held
    links = re.findall(r"\]\(([^)]+)\)", metadata)
    assert len(links) > 4
    assert all(link.startswith("https://") for link in links)
    assert all(f"Project-URL: {name}, https://" in metadata for name in ("Homepage", "Changelog", "Issues"))


def test_the_version_is_that_of_the_package():
    assert run("import sys, thinkblox; print(thinkblox.__version__, 'importlib.metadata' in sys.modules)") == (
        f"{version('thinkblox')} True"
    )
    assert run("import sys, thinkblox; print('importlib.metadata' in sys.modules)") == "False"
    assert run("from thinkblox.cli import main\nmain(['--version'])") == f"thinkblox {version('thinkblox')}"


def test_a_bare_tree_has_no_known_version(tmp_path):
    (tmp_path / "thinkblox").symlink_to(ROOT / "thinkblox")
    code = "import sys; sys.path.insert(0, sys.argv[1]); import thinkblox; print(thinkblox.__version__)"
    done = subprocess.run(
        [sys.executable, "-I", "-S", "-c", code, str(tmp_path)], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "0+unknown"


MODELS = "'torch', 'transformers', 'peft', 'trl', 'datasets', 'llguidance', 'openai', 'mcp', 'dm_control'"


def test_importing_the_package_loads_nothing_heavy():
    heavy = f"{{'mujoco', 'pxr', 'numpy', 'shapely', 'embreex', 'PIL', {MODELS}}}"
    assert run(f"import sys, thinkblox; print(sorted({heavy} & set(sys.modules)))") == "[]"


COMMANDS = ((), ("generate",), ("verify",), ("render",), ("mcp",), ("schema",), ("assets",), ("assets", "list"))


@pytest.mark.parametrize("words", COMMANDS, ids=" ".join)
def test_help_loads_nothing_heavy(words):
    *shown, heavy = help_of(*words).splitlines()
    assert heavy == "[]"
    assert "exit status" in "\n".join(shown)


def help_of(*words: str) -> str:
    """What `--help` shows, and a line with the heavy modules that were loaded for it."""
    return run(
        "import sys\nfrom thinkblox.cli import main\n"
        f"try:\n    main([*{words!r}, '--help'])\nexcept SystemExit:\n    pass\n"
        f"print(sorted({{'mujoco', 'pxr', 'numpy', 'shapely', 'trimesh', 'msgspec', {MODELS}}} & set(sys.modules)))"
    )


def test_help_names_what_can_be_asked_for():
    from thinkblox.importing import FORMATS
    from thinkblox.sim.suites import SUITES

    shown = help_of("verify")
    assert all(name in shown for name in (*SUITES, *FORMATS, "mjcf", "urdf"))


def test_everything_imports_without_a_bare_folder_name():
    code = (
        "import pkgutil, sys, importlib, thinkblox\n"
        "for m in pkgutil.walk_packages(thinkblox.__path__, 'thinkblox.'):\n"
        "    if not m.name.endswith('__main__'):\n"
        "        importlib.import_module(m.name)\n"
        f"print(sorted(set({LINKED!r}) & set(sys.modules)), sorted({{{MODELS}}} & set(sys.modules)))"
    )
    assert run(code) == "[] []"


def test_every_public_name_exists():
    assert run("import thinkblox; print(all(getattr(thinkblox, n) is not None for n in thinkblox.__all__))") == "True"


@pytest.mark.parametrize("package", ["thinkblox", "thinkblox.importing"])
def test_no_module_hides_a_name_that_is_loaded_when_asked_for(package):
    """Importing a module sets its name in the package, over whatever would be loaded by that name."""
    code = (
        f"import pkgutil, {package} as package\n"
        "print({m.name for m in pkgutil.iter_modules(package.__path__)} & set(package.__all__))"
    )
    assert run(code) == "set()"


def test_an_unknown_name_says_what_there_is():
    import thinkblox

    with pytest.raises(AttributeError, match="generate_room"):
        thinkblox.generate_rooms  # noqa: B018
