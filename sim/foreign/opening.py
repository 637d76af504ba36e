"""Any MJCF or URDF as a Subject: looked through, compiled with its own options, and divided into things."""

import warnings
from contextlib import suppress
from pathlib import Path

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.errors import InputError
from thinkblox.sim.engine_errors import ENGINE_ERRORS, said
from thinkblox.sim.foreign.mjcf_limits import MOST_BODIES, MjcfFiles, check_mjcf, too_many
from thinkblox.sim.foreign.things import things_of
from thinkblox.sim.foreign.unusual import unusual_options
from thinkblox.sim.foreign.urdf import urdf_spec
from thinkblox.sim.foreign.xml_elements import Element, walk
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.subject import Subject

SETTLED = "settled"
"""The keyframe that our own exports start from."""
LARGEST = 1e10
"""Numbers beyond this the engine takes for a simulation that blew up."""
NAMES = {"mujoco": "mjcf", "robot": "urdf"}
"""Root elements of the files that are read, and what they are called."""


class _FoundError(Exception):
    """Ends the reading of a file at its first element."""


def open_model(path: Path, *, folder: Path | None = None) -> Subject:
    """Read an MJCF or URDF file as something to be measured; which of the two it is, its root element says.

    The model keeps its own options. Its things are the children of the world with all that hangs on them; a child
    without joint and geoms is looked through to its own children, and one with nothing in it is left out. It starts
    from its keyframe "settled", or else its only keyframe, or else its reference pose, at rest in any case.
    What is done to a URDF is said at `urdf_spec`.

    The file comes from anywhere: see `guarded` for reading it in a process of its own.

    Args:
        path: of the file.
        folder: what no named file may lie outside of; the file's own folder (of a URDF, its package's) unless told
            otherwise.

    Raises:
        InputError: it cannot be read or is refused; names file, line and element where they are known.
    """
    path = Path(path)
    kind = kind_of(path)
    with quiet_engine(), warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        model, notes = _mjcf(path, folder) if kind == "mjcf" else _urdf(path, folder)
    _check_model(path, model)
    things = things_of(model)
    if not things:
        raise InputError(
            f"{path}: the model has no bodies with joints or geoms in them, so there is nothing to measure."
        )
    start, keyframe = start_of(model)
    return Subject(
        model=model,
        start=start,
        things=things,
        source=kind,
        unusual=unusual_options(model, things),
        notes=(*notes, *dict.fromkeys(f"MuJoCo warns: {' '.join(str(w.message).split())}" for w in warned)),
        keyframe=keyframe,
    )


def kind_of(path: Path) -> str:
    """What a file is by its root element: "mjcf" or "urdf"; raises InputError when it is neither, or no XML."""
    roots: list[Element] = []

    def first(element: Element) -> None:
        roots.append(element)
        raise _FoundError

    with suppress(_FoundError):
        walk(path, first)
    kind = NAMES.get(roots[0].tag)
    if kind is None:
        known = ", ".join(f"<{root}> ({name.upper()})" for root, name in NAMES.items())
        raise InputError(f"{roots[0]}: this is no model that can be read; those start with {known}.")
    return kind


def start_of(model: mujoco.MjModel) -> tuple[NDArray[np.float64], int | None]:
    """Where a model starts, and the keyframe that says so; None where it is the reference pose."""
    names = [str(model.key(key).name) for key in range(model.nkey)]
    if SETTLED in names:
        key = names.index(SETTLED)
    elif model.nkey == 1:
        key = 0
    else:
        return np.array(model.qpos0), None
    return np.array(model.key_qpos[key]), key


def _urdf(path: Path, folder: Path | None) -> tuple[mujoco.MjModel, tuple[str, ...]]:
    spec, notes = urdf_spec(path, folder=folder)
    return _compiled(path, spec, None), notes


def _mjcf(path: Path, folder: Path | None) -> tuple[mujoco.MjModel, tuple[str, ...]]:
    files = check_mjcf(path, folder=folder)
    try:
        spec = mujoco.MjSpec.from_file(str(path))
    except ENGINE_ERRORS as error:
        raise _refused(path, error, files) from error
    return _compiled(path, spec, files), ()


def _compiled(path: Path, spec: mujoco.MjSpec, files: MjcfFiles | None) -> mujoco.MjModel:
    try:
        return spec.compile()
    except ENGINE_ERRORS as error:
        raise _refused(path, error, files) from error


def _refused(path: Path, error: Exception, files: MjcfFiles | None) -> InputError:
    """What the engine said, with the file of the mesh that it speaks of."""
    text = said(error)
    meshes = files.meshes if files else {}
    found = [str(file) for name, file in meshes.items() if f"Element name '{name}'" in text]
    return InputError(f"{path}: MuJoCo cannot read it: {text}" + (f" (mesh file {found[0]})" if found else ""))


def _check_model(path: Path, model: mujoco.MjModel) -> None:
    """Refuse what compiles and yet cannot be simulated."""
    if model.nbody - 1 > MOST_BODIES:
        raise InputError(too_many(str(path), model.nbody - 1))
    if not 0.0 < model.opt.timestep < np.inf:
        raise InputError(f"{path}: <option timestep> is {model.opt.timestep:g}; it must be a time greater than 0.")
    for field in ("body_pos", "body_quat", "body_mass", "body_inertia", "geom_pos", "geom_size", "qpos0", "key_qpos"):
        values = getattr(model, field)
        usable = np.isfinite(values) & (np.abs(values) <= LARGEST)
        if not usable.all():
            row = int(np.argwhere(~usable.reshape(len(values), -1).all(axis=1))[0, 0])
            raise InputError(f"{path}: {_named(model, field, row)} is not a finite number, or more than {LARGEST:g}.")
    if not np.all(np.isfinite(model.opt.gravity)):
        raise InputError(f"{path}: <option gravity> is not made of finite numbers.")


def _named(model: mujoco.MjModel, field: str, row: int) -> str:
    kind, _, what = field.partition("_")
    if kind not in ("body", "geom"):
        return f"the number {row} of {field}"
    name = str((model.body(row) if kind == "body" else model.geom(row)).name)
    return f"{what} of the {kind} {name or row}"
