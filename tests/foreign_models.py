"""Small MJCF texts for the tests of foreign models."""

from pathlib import Path

from thinkblox.sim.foreign.model_report import model_report
from thinkblox.sim.foreign.opening import open_model
from thinkblox.sim.subject import Subject
from thinkblox.verdict import Report, Verdict

MODELS = Path(__file__).parent / "data" / "models"
FLOOR = '<geom name="floor" type="box" size="5 5 0.1" pos="0 0 -0.1"/>'


def mjcf(world: str, *, head: str = "", floor: str = FLOOR) -> str:
    return f"<mujoco>{head}<worldbody>{floor}{world}</worldbody></mujoco>"


def crate(name: str, position: str, *, half: str = "0.1 0.1 0.1", free: str = "<freejoint/>", geom: str = "") -> str:
    return f'<body name="{name}" pos="{position}">{free}<geom type="box" size="{half}" {geom}/></body>'


def opened(folder: Path, text: str, name: str = "room.xml") -> Subject:
    file = folder / name
    file.write_text(text)
    return open_model(file)


def reported(folder: Path, text: str, *, seconds: float = 1.0, name: str = "room.xml") -> Report:
    return model_report(opened(folder, text, name), seconds=seconds)


def of(report: Report, id: str) -> Verdict:
    return next(verdict for verdict in report.objects if verdict.id == id)
