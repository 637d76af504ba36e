"""What is public: every name that a package announces is there, and no two classes of the project share a name."""

import ast
import os
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent


def modules() -> dict[str, ast.Module]:
    """Every module of the package by its name, parsed."""
    found: dict[str, ast.Module] = {}
    for folder, _, files in os.walk(ROOT / "thinkblox", followlinks=True):
        for file in (Path(folder, name) for name in sorted(files) if name.endswith(".py")):
            parts = file.relative_to(ROOT).with_suffix("").parts
            found[".".join(part for part in parts if part != "__init__")] = ast.parse(file.read_text(), str(file))
    return found


MODULES = modules()


def announces(module: ast.Module) -> bool:
    targets = [target for node in module.body if isinstance(node, ast.Assign) for target in node.targets]
    return any(isinstance(target, ast.Name) and target.id == "__all__" for target in targets)


def run(code: str) -> str:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, cwd="/")
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_no_two_public_classes_share_a_name() -> None:
    homes = defaultdict(list)
    for name, module in MODULES.items():
        for node in module.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                homes[node.name].append(name)
    assert {name: where for name, where in homes.items() if len(where) > 1} == {}


def test_the_packages_for_users_announce_their_names() -> None:
    named = {name for name, module in MODULES.items() if announces(module)}
    assert named >= {"thinkblox", "thinkblox.sim", "thinkblox.sim.workers", "thinkblox.scene", "thinkblox.assets"}


def test_every_announced_name_exists_and_can_be_had_by_a_star() -> None:
    names = sorted(name for name, module in MODULES.items() if announces(module))
    code = (
        "import importlib\n"
        f"for name in {names!r}:\n"
        "    module, space = importlib.import_module(name), {}\n"
        "    exec(f'from {name} import *', space)\n"
        "    assert len(set(module.__all__)) == len(module.__all__), name\n"
        "    missing = set(module.__all__) - set(space)\n"
        "    assert not missing, (name, missing)\n"
        "    assert all(getattr(module, each) is space[each] for each in module.__all__), name\n"
    )
    assert run(code) == ""


@pytest.mark.parametrize("package", ["thinkblox.sim", "thinkblox.sim.workers"])
def test_a_package_lists_its_names_and_loads_nothing_heavy_for_it(package: str) -> None:
    code = (
        f"import sys, {package} as package\n"
        "assert dir(package) == sorted(package.__all__), dir(package)\n"
        "print(sorted({'mujoco', 'numpy', 'shapely', 'embreex', 'PIL'} & set(sys.modules)))"
    )
    assert run(code) == "[]"


def test_a_name_that_is_not_there_is_told_with_those_that_are() -> None:
    import thinkblox.sim

    with pytest.raises(AttributeError, match=r"'thinkblox\.sim' has no attribute 'verifie'; it has .*verify"):
        thinkblox.sim.verifie  # noqa: B018


def test_a_name_is_the_same_object_from_wherever_it_is_had() -> None:
    import thinkblox
    import thinkblox.sim
    import thinkblox.sim.workers
    from thinkblox.sim.workers.pool import VerdictPool

    assert thinkblox.VerdictPool is thinkblox.sim.VerdictPool is thinkblox.sim.workers.VerdictPool is VerdictPool
    assert thinkblox.World is thinkblox.sim.World
    assert thinkblox.verify is thinkblox.sim.verify
