"""Any MJCF, URDF or USD as a Subject: looked through, compiled with its own options, and divided into things."""

import warnings
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from thinkblox.errors import InputError
from thinkblox.sim.engine_errors import ENGINE_ERRORS, said
from thinkblox.sim.foreign.aside import set_aside
from thinkblox.sim.foreign.floors import add_floor, needed_floor
from thinkblox.sim.foreign.mjcf import mjcf_spec, plain_note, refusal
from thinkblox.sim.foreign.mjcf_limits import MOST_BODIES, too_many
from thinkblox.sim.foreign.start import start_of
from thinkblox.sim.foreign.things import things_of
from thinkblox.sim.foreign.unusual import unusual_options
from thinkblox.sim.foreign.urdf import urdf_spec
from thinkblox.sim.foreign.xml_elements import Element, walk
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.subject import Subject

LARGEST = 1e10
"""Numbers beyond this the engine takes for a simulation that blew up."""
_BOUNDED = ("body_pos", "body_quat", "body_mass", "body_inertia", "geom_pos", "geom_size", "qpos0", "key_qpos")
_FINITE = (
    *("geom_quat", "geom_friction", "geom_margin", "geom_gap", "geom_solref", "geom_solimp", "body_ipos", "body_iquat"),
    *("jnt_pos", "jnt_axis", "jnt_stiffness", "dof_damping", "dof_armature", "dof_frictionloss", "qpos_spring"),
)
"""What the engine takes as it stands, be it infinite or no number."""
NAMES = {"mujoco": "mjcf", "robot": "urdf"}
"""Root elements of the files that are read, and what they are called."""

USD_SUFFIXES = (".usd", ".usda", ".usdc", ".usdz")


class _FoundError(Exception):
    """Ends the reading of a file at its first element."""


@dataclass(frozen=True)
class _Read:
    """A file as the engine's spec, notes on how it was read, and what to say when the engine refuses it.

    `room` names bodies that are no things: floor and walls.
    """

    spec: mujoco.MjSpec
    notes: tuple[str, ...]
    refused: Callable[[BaseException], str]
    room: frozenset[str] = frozenset()


def open_model(
    path: Path,
    *,
    folder: Path | None = None,
    fixed_base: bool = False,
    exclude: Sequence[str] = (),
    robots: Sequence[str] = (),
) -> Subject:
    """Read an MJCF, URDF or USD file as something to be measured.

    The model keeps its own options. Its things are the children of the world with all that hangs on them; a child
    without joint and geoms is looked through to its own children, and one with nothing in it is left out. It starts
    as `start_of` says, at rest in any case. What is done to a URDF is said at `urdf_spec`.

    Where something free has nothing under it, a floor is put under the whole. Robots are not furniture: they are held
    where they start, and nothing is said of them but what else touches them.

    The file comes from anywhere: see `guarded` for reading it in a process of its own.

    Args:
        path: of the file.
        folder: what no named file may lie outside of; the file's own folder (of a URDF, its package's) unless told
            otherwise.
        fixed_base: hold the root links of a URDF to the world.
        exclude: names of things, or patterns such as "target*", that are left out: nothing touches them.
        robots: names or patterns of things that are robots.

    Raises:
        InputError: it cannot be read or is refused; names file, line and element where they are known.
    """
    path = Path(path)
    kind = kind_of(path)
    if fixed_base and kind != "urdf":
        raise InputError(f"{path}: --fixed-base is for URDF; an MJCF says by its joints what is fixed.")
    if folder is not None and not path.absolute().is_relative_to(folder.absolute()):
        raise InputError(f"{path}: is not in the folder {folder}, so nothing that it names would be read.")
    with quiet_engine(), warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        read = _usd(path, folder) if kind == "usd" else _xml(path, kind, folder, fixed_base)
        model = _compiled(read)
        _check_model(path, model)
        try:
            model, floor = _floored(path, read, model)
            things = tuple(thing for thing in things_of(model) if thing.id not in read.room)
            sorted_out = set_aside(path, model, things, exclude=exclude, robots=robots)
        except mujoco.FatalError as error:
            raise InputError(read.refused(error)) from error
    if not sorted_out.things:
        lacks = "nothing but what was set aside" if exclude or robots else "no bodies with joints or geoms in them"
        raise InputError(f"{path}: the model has {lacks}, so there is nothing to measure.")
    start = start_of(model)
    return Subject(
        model=model,
        start=start.qpos,
        things=sorted_out.things,
        source=kind,
        unusual=unusual_options(model, sorted_out.things),
        notes=(
            *read.notes,
            *start.notes,
            *floor,
            *sorted_out.notes,
            *dict.fromkeys(f"MuJoCo warns: {' '.join(str(w.message).split())}" for w in warned),
        ),
        keyframe=start.keyframe,
        robots=sorted_out.robots,
    )


def kind_of(path: Path) -> str:
    """What a file is: "usd" by its ending, "mjcf" or "urdf" by its root element; raises InputError when it is none."""
    if path.suffix.lower() in USD_SUFFIXES:
        return "usd"
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


def _usd(path: Path, folder: Path | None) -> _Read:
    from thinkblox.sim.foreign.usd import usd_spec

    spec, notes = usd_spec(path, folder=folder)
    return _Read(spec, notes, lambda error: f"{path}: MuJoCo cannot read it: {said(error)}")


def _xml(path: Path, kind: str, folder: Path | None, fixed_base: bool) -> _Read:
    return _mjcf(path, folder) if kind == "mjcf" else _urdf(path, folder, fixed_base)


def _urdf(path: Path, folder: Path | None, fixed_base: bool) -> _Read:
    spec, files = urdf_spec(path, folder=folder, fixed_base=fixed_base)
    return _Read(spec, files.notes, lambda error: files.refusal(path, error), files.room)


def _mjcf(path: Path, folder: Path | None) -> _Read:
    spec, text, files = mjcf_spec(path, folder=folder)
    return _Read(spec, plain_note(files), lambda error: refusal(path, error, text, files))


def _compiled(read: _Read) -> mujoco.MjModel:
    try:
        return read.spec.compile()
    except ENGINE_ERRORS as error:
        raise InputError(read.refused(error)) from error


def _floored(path: Path, read: _Read, model: mujoco.MjModel) -> tuple[mujoco.MjModel, tuple[str, ...]]:
    """The model with a floor under it, and a note on that, where it has none and needs one."""
    data = Subject(model, start_of(model).qpos, ()).data()
    floor = needed_floor(model, data, things_of(model))
    if floor is None:
        return model, ()
    add_floor(read.spec, model, data, floor.height)
    model = _compiled(read)
    _check_model(path, model)
    return model, (floor.note,)


def _check_model(path: Path, model: mujoco.MjModel) -> None:
    """Refuse what compiles and yet cannot be simulated."""
    if model.nbody - 1 > MOST_BODIES:
        raise InputError(too_many(str(path), model.nbody - 1))
    if not 0.0 < model.opt.timestep < np.inf:
        raise InputError(f"{path}: <option timestep> is {model.opt.timestep:g}; it must be a time greater than 0.")
    for field in (*_BOUNDED, *_FINITE):
        values = getattr(model, field)
        usable = np.isfinite(values) & ((np.abs(values) <= LARGEST) | (field in _FINITE))
        if not usable.all():
            row = int(np.argwhere(~usable.reshape(len(values), -1).all(axis=1))[0, 0])
            above = f", or more than {LARGEST:g}; is the model in metres?" if field in _BOUNDED else "."
            raise InputError(f"{path}: {_named(model, field, row)} is not a finite number{above}")
    if not np.all(np.isfinite(model.opt.gravity)):
        raise InputError(f"{path}: <option gravity> is not made of finite numbers.")


def _named(model: mujoco.MjModel, field: str, row: int) -> str:
    kind, _, what = field.partition("_")
    if kind not in ("body", "geom"):
        return f"the number {row} of {field}"
    name = str((model.body(row) if kind == "body" else model.geom(row)).name)
    return f"{what} of the {kind} {name or row}"
