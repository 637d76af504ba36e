"""Tools that begin, open, look over, save and close rooms, and tell what there is."""

import math
import os
from tempfile import TemporaryDirectory
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from msgspec import Meta, structs

from thinkblox.checking import MODEL_SUFFIXES, MODELS, VerifyOptions, verify_file
from thinkblox.episode import Episode, read_episode
from thinkblox.errors import InputError
from thinkblox.exporters.formats import DEFAULT
from thinkblox.exporters.saving import save_scene
from thinkblox.fills import Fill
from thinkblox.listing import listed
from thinkblox.plan import Plan
from thinkblox.planning import ExpertPlanner, with_surfaces
from thinkblox.printing import category as category_words
from thinkblox.printing import outcome, summary
from thinkblox.prompts import template
from thinkblox.reading import GrammarBriefer
from thinkblox.scene.room import Opening, Room
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.serving.desk import Desk
from thinkblox.serving.naming import sayable
from thinkblox.serving.placing_tools import Handle, next_id, next_words, plain
from thinkblox.serving.room import AgentRoom
from thinkblox.serving.root import MOST_LISTED
from thinkblox.serving.said import Said
from thinkblox.serving.tool import Tool
from thinkblox.value import Value
from thinkblox.verdict import Report
from thinkblox.wording import placed_line, room_words

MOST_PROMPT = 10_000
"""Longest prompt of a room [characters]."""
SECONDS = 300.0
"""How long the reading and measuring of a file may take [s]."""
MOST_RENAMED = 60
"""Most new ids that the text of an answer names; its data has them all."""
HOW = (
    "How to answer, with the tool `answer` (or say the same with place, move, turn, replace, remove and swap):\n"
    + template("step")
)
FilePath = Annotated[str, Meta(description="relative to the root folder")]


class Floor(Value, frozen=True, kw_only=True):
    """A room to furnish: corners counter-clockwise from (0, 0) [m], height [m], doors and windows."""

    floor: tuple[tuple[float, float], ...]
    height: float = 2.6
    openings: tuple[Opening, ...] = ()


class StartRoomTool(Tool, frozen=True, kw_only=True):
    """Begin a room for a prompt: it is read, a floor and the objects are planned, and you place one after the other."""

    prompt: Annotated[str, Meta(min_length=1, max_length=MOST_PROMPT, description="what the room should be")]
    seed: Annotated[int, Meta(ge=0, le=2**53, description="of the floor, the looks and the surfaces")] = 0
    room: Annotated[Floor, Meta(description="a floor of your own; made for the prompt if left out")] | None = None
    fill: Annotated[Fill, Meta(description="only what the prompt names, or what makes such a room besides")] = "named"

    def run(self, desk: Desk) -> Said:
        """Read, plan, and open it."""
        desk.check_space()
        if self.fill == "lived-in":
            raise InputError(
                "fill: a lived-in room is dressed after it is furnished; use want for what else lies about"
            )
        shape = self.room
        given = None if shape is None else Room(floor=shape.floor, height=shape.height, openings=shape.openings)
        planner, brief = ExpertPlanner(), GrammarBriefer(self.fill).brief(self.prompt)
        floor = given or planner.room(brief, np.random.default_rng((self.seed, 0)))
        plan = planner.plan(brief, floor)
        scene = Scene(prompt=self.prompt, seed=self.seed, room=with_surfaces(floor, brief, self.seed))
        room = AgentRoom(scene, plan, desk.source)
        handle = desk.add(room)
        count = len(room.plan.targets)
        lines = [f"{handle} is open. {count} object{' is' if count == 1 else 's are'} planned: {_ids(room)}."]
        missing = (*brief.missing, *brief.beyond)
        lines += [f"Not made: {', '.join(missing)}."] if missing else []
        lines += [f"Not understood: {', '.join(brief.unknown)}."] if brief.unknown else []
        lines += [f"Room: {room_words(room.scene.room)}", *plan.notes, next_words(room), HOW]
        return Said(("\n".join(lines),), _of(handle, room, lines))


class OpenRoomTool(Tool, frozen=True, kw_only=True):
    """Open somebody's layout, or one of our rooms or scenes, measure it, and go on with it.

    Layouts of Holodeck, LayoutGPT, LayoutVLM, I-Design, IL3D and SceneEval are read. MJCF and URDF models can only be
    measured: use check_file.
    """

    path: FilePath
    format: Annotated[str, Meta(description="whose layout it is, where the file does not tell")] | None = None
    assets: Annotated[str, Meta(description="folder with the meshes that it names, relative to the root")] | None = None
    sizes: Annotated[str, Meta(description="JSON file with sizes by name, relative to the root")] | None = None
    which: Annotated[str, Meta(description="which room, of a file that holds several")] | None = None
    height: Annotated[float, Meta(description="of the room, where the layout has none [m]")] | None = None
    short_side: Annotated[float, Meta(description="of the room, for a layout in pixels [m]")] | None = None
    room_size: (
        Annotated[tuple[float, ...], Meta(description="[x, y] or [x, y, z], where there are no walls")] | None
    ) = None

    def run(self, desk: Desk) -> Said:
        """Read, measure and open it."""
        desk.check_space()
        path = desk.root.reading(self.path)
        ours = f"{self.path}/scene.json" if path.is_dir() else ""
        path = desk.root.reading(ours) if ours else path
        if self.format in MODELS or path.suffix.lower() in MODEL_SUFFIXES:
            raise InputError(f"{self.path}: a model is measured, not changed; check_file does that")
        home = TemporaryDirectory(prefix="thinkblox-")
        options = structs.replace(_options(self, desk), out=f"{home.name}/scene.json")
        report = verify_file(path, options, timeout=SECONDS)
        own = report.source == "thinkblox"
        scene, old = sayable(load_scene(path if own else home.name))
        plan, episode, note = _history(desk, ours, scene) if own else (None, None, "")
        new = {before: id for id, before in old.items()}
        reading = structs.replace(report, substituted=tuple(new.get(id, id) for id in report.substituted))
        room = AgentRoom(scene, plan, desk.source, episode=episode, reading=reading)
        handle = desk.add(room)
        if not own:
            room.keeps = home  # its meshes are read from there again
        lines = [f"{handle} is open.", summary(report, placed=len(report.objects)), *([note] if note else [])]
        lines += [f"To be spoken of, things have other ids here: {_renamed(old)}."] if old else []
        lines += [f"Room: {room_words(scene.room)}", next_words(room), "list_objects shows what stands there.", HOW]
        return Said(("\n".join(lines),), {**_of(handle, room, lines), "ids_in_the_file": old})


class CheckFileTool(Tool, frozen=True, kw_only=True):
    """Measure any scene, layout, MJCF or URDF file, or a folder with one of our rooms, without opening it."""

    reads: ClassVar[bool] = True
    path: FilePath
    format: Annotated[str, Meta(description="thinkblox, mjcf, urdf, or whose layout it is")] | None = None
    assets: Annotated[str, Meta(description="folder with the meshes that it names, relative to the root")] | None = None
    sizes: Annotated[str, Meta(description="JSON file with sizes by name, relative to the root")] | None = None
    which: Annotated[str, Meta(description="which room, of a file that holds several")] | None = None
    height: float | None = None
    short_side: float | None = None
    room_size: tuple[float, ...] | None = None
    suites: Annotated[tuple[str, ...], Meta(description="published criteria to measure by")] = ()

    def run(self, desk: Desk) -> Said:
        """Measure it."""
        path = desk.root.reading(self.path)
        path = desk.root.reading(f"{self.path}/scene.json") if path.is_dir() else path
        options = structs.replace(_options(self, desk), suites=self.suites)
        if self.format in MODELS or (self.format is None and path.suffix.lower() in MODEL_SUFFIXES):
            options = structs.replace(options, root=str(desk.root.folder))
        return _reported(verify_file(path, options, timeout=SECONDS))


class VerifyTool(Tool, frozen=True, kw_only=True):
    """Verify the whole room: every object, everything free at once, ways and doors, and what the prompt asks for."""

    reads: ClassVar[bool] = True
    room: Handle

    def run(self, desk: Desk) -> Said:
        """Verify it."""
        room = desk.room(self.room)
        report = room.report()
        return _reported(report, judged=room.planned)


class RenderTool(Tool, frozen=True, kw_only=True):
    """A picture of the room as it is: a three-quarter view (preview), or a plan with names (top)."""

    reads: ClassVar[bool] = True
    room: Handle
    view: Literal["preview", "top"] = "preview"
    size: Annotated[int, Meta(ge=64, le=2048, description="of the picture [pixels]")] = 768

    def run(self, desk: Desk) -> Said:
        """Draw it."""
        from thinkblox.sim.render import render_preview, render_top
        from thinkblox.sim.verdict.settle import settle

        scene = desk.room(self.room).scene
        draw = render_preview if self.view == "preview" else render_top
        return Said((f"{self.room}, {self.view}:", draw(scene, size=self.size, poses=settle(scene).poses)))


class SaveTool(Tool, frozen=True, kw_only=True):
    """Save the room to a folder under the root: scene.json, exports, report, pictures, the trace of your answers."""

    room: Handle
    folder: FilePath
    formats: Annotated[tuple[str, ...], Meta(description="of export")] = DEFAULT
    pictures: bool = True
    overwrite: Annotated[bool, Meta(description="replace a room that was saved there before")] = False

    def run(self, desk: Desk) -> Said:
        """Save it."""
        room, out = desk.room(self.room), desk.root.writing(self.folder)
        report = room.report()
        save_scene(
            room.scene,
            out,
            report,
            formats=self.formats,
            pictures=self.pictures,
            overwrite=self.overwrite,
            extra={"trace.jsonl": room.episode().to_jsonl()},
        )
        names = sorted(entry.name for entry in out.iterdir())
        says = f"saved to {desk.root.shown(out)}: {', '.join(names)}; {_outcome(report, room.planned)}"
        return Said((says,), {"says": says, "folder": desk.root.shown(out), "files": names})


class ListRoomsTool(Tool, frozen=True, kw_only=True):
    """The rooms that are open, with their handles."""

    reads: ClassVar[bool] = True

    def run(self, desk: Desk) -> Said:
        """List them."""
        rooms = [_of(handle, room) for handle, room in desk.rooms.items()]
        lines = [f"{r['room']}: {r['placed']} placed, {r['to_place']} to place; {r['prompt'][:200]}" for r in rooms]
        return Said(
            ("\n".join(lines) or "No room is open: start_room begins one, open_room reads one.",), {"rooms": rooms}
        )


class ListObjectsTool(Tool, frozen=True, kw_only=True):
    """What stands in the room, a line of JSON each, and what is still to be placed."""

    reads: ClassVar[bool] = True
    room: Handle

    def run(self, desk: Desk) -> Said:
        """List them."""
        room = desk.room(self.room)
        lines = [placed_line(room.scene, placement) for placement in room.scene.placements]
        waiting = [t.id for t in room.plan.targets if t.id not in room.scene and t.id not in room.left_out]
        lines += [f"To place: {', '.join(waiting) or 'nothing'}"]
        lines += [f"Left out: {id}: {why}" for id, why in room.left_out.items()]
        data = {
            "objects": [plain(p) for p in room.scene.placements],
            "to_place": waiting,
            "left_out": room.left_out,
        }
        return Said(("\n".join(lines),), data)


class ListCategoriesTool(Tool, frozen=True, kw_only=True):
    """What there is to furnish with; with a category, its usual, smallest and largest size, and its attributes."""

    reads: ClassVar[bool] = True
    category: Annotated[str, Meta(max_length=60)] | None = None

    def run(self, desk: Desk) -> Said:
        """List them."""
        from thinkblox.assets import CATALOGUE, category_of

        if self.category is not None:
            entry = listed(category_of(self.category))
            return Said((category_words(entry),), plain(entry))
        names = [name for name, kind in CATALOGUE.items() if not kind.plain]
        return Said((f"{', '.join(names)}\nAny other thing can be wanted too, and is a plain stand-in.",))


class ListFilesTool(Tool, frozen=True, kw_only=True):
    """The files and folders in a folder under the root; links are left out."""

    reads: ClassVar[bool] = True
    folder: FilePath = "."

    def run(self, desk: Desk) -> Said:
        """List them."""
        found = list(desk.root.entries(self.folder))
        more = f"\nand {len(found) - MOST_LISTED} more" if len(found) > MOST_LISTED else ""
        return Said(("\n".join(found[:MOST_LISTED]) + more or "nothing",), {"entries": found[:MOST_LISTED]})


class CloseRoomTool(Tool, frozen=True, kw_only=True):
    """Close a room; what was not saved of it is gone."""

    room: Handle

    def run(self, desk: Desk) -> Said:
        """Close it."""
        desk.room(self.room)
        del desk.rooms[self.room]
        return Said((f"{self.room} is closed.",))


def _ids(room: AgentRoom) -> str:
    return ", ".join(target.id for target in room.plan.targets) or "none"


def _renamed(old: dict[str, str]) -> str:
    some = ", ".join(f"{id} is {before!r}" for id, before in list(old.items())[:MOST_RENAMED])
    return some + (f", and {len(old) - MOST_RENAMED} more" if len(old) > MOST_RENAMED else "")


def _of(handle: str, room: AgentRoom, lines: list[str] | None = None) -> dict[str, Any]:
    """A room in a few plain values."""
    found = {
        "room": handle,
        "prompt": room.scene.prompt,
        "seed": room.scene.seed,
        "placed": len(room.scene.placements),
        "to_place": room.to_place,
        "next": next_id(room),
    }
    return found if lines is None else {**found, "says": "\n".join(lines)}


def _options(tool: OpenRoomTool | CheckFileTool, desk: Desk) -> VerifyOptions:
    """How a file is read, every path in it under the root."""
    for length in (tool.height, tool.short_side, *(tool.room_size or ())):
        if length is not None and not math.isfinite(length):
            raise InputError(f"{length} m is no length")
    return VerifyOptions(
        format=tool.format,
        assets=None if tool.assets is None else str(desk.root.reading(tool.assets)),
        sizes=None if tool.sizes is None else str(desk.root.reading(tool.sizes)),
        room=tool.which,
        height=tool.height,
        short_side=tool.short_side,
        room_size=tool.room_size,
    )


def _history(desk: Desk, scene_file: str, scene: Scene) -> tuple[Plan | None, Episode | None, str]:
    """The plan of one of our rooms, how it came about if that can be gone on with, and a word on that."""
    name = scene_file.removesuffix("scene.json") + "trace.jsonl"
    if not scene_file or not os.path.lexists(desk.root.folder / name):
        return None, None, "There is no trace of how it came about; a new one begins."
    try:
        episode = read_episode(desk.root.reading(name))
        reached = _reached(episode)
    except (InputError, KeyError) as error:
        return None, None, f"Its trace cannot be used ({error}); a new one begins."
    if reached == scene:
        return episode.plan, episode, "Its trace goes on."
    known = episode.plan if episode.prompt == scene.prompt else None
    return known, None, "Its trace does not lead to this scene; a new one begins."


def _reached(episode: Episode) -> Scene:
    """The scene to which the rounds of an episode lead by themselves."""
    scene = episode.start
    for done in episode.rounds:
        scene = episode.after(scene, done) if done.kept else scene
    return scene


def _outcome(report: Report, judged: bool) -> str:
    """In a few words how a prompt was met, or where none was looked at, whether everything passed."""
    if judged:
        return outcome(report)
    passed = report.valid and all(suite.passed for suite in report.suites)
    return "all passed" if passed else "not all passed"


def _reported(report: Report, *, judged: bool = False) -> Said:
    """A report in words and figures; what fails of it in full."""
    text = f"{summary(report, placed=len(report.objects))}\n{_outcome(report, judged)}"
    data = {
        "says": text,
        "valid": report.valid,
        "complete": report.complete if judged else None,
        "objects": [{"id": v.id, "valid": v.valid} for v in report.objects],
        "failing": [plain(v) for v in report.objects if not v.valid],
        "absent": [plain(a) for a in report.absent],
        "relations": [plain(r) for r in report.relations],
        "demands": [plain(d) for d in report.demands],
        "suites": [{"suite": s.suite, "passed": s.passed} for s in report.suites],
        "depth": report.depth,
        "drift": report.drift,
        "tilt": report.tilt,
    }
    return Said((text,), data)
