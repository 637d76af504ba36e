"""The output folder: whole or not at all, and never over anything that is not ours."""

from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest

from tests.export_rooms import Line, Result, result
from thinkblox.errors import InputError
from thinkblox.exporters.folder import FILES, PICTURES, check_folder, save_pictures, save_room
from thinkblox.scene.scene import load_scene

WITHOUT_PICTURES = sorted(set(FILES) - set(PICTURES))


def names(folder: Path) -> list[str]:
    return sorted(entry.name for entry in folder.iterdir())


def save(made: Result, out: Path, *, overwrite: bool = False) -> Path:
    return save_room(made, out, pictures=False, overwrite=overwrite)  # type: ignore[arg-type]


def test_everything_is_written_and_nothing_else(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "deep" / "room")
    assert names(out) == WITHOUT_PICTURES
    assert names(tmp_path / "deep") == ["room"]
    assert load_scene(out) == result().scene
    assert (out / "trace.jsonl").read_text() == '{"text":"first"}\n{"text":"second"}\n'
    assert out.stat().st_mode & 0o077 == (tmp_path / "deep").stat().st_mode & 0o077


def test_the_same_room_twice_gives_the_same_bytes(tmp_path: Path) -> None:
    first, second = (save(result(), tmp_path / name) for name in ("a", "b"))
    for name in WITHOUT_PICTURES:
        assert (first / name).read_bytes() == (second / name).read_bytes(), name


def test_pictures_come_with_the_room(tmp_path: Path) -> None:
    from PIL import Image

    paths = save_pictures(result().scene, tmp_path / "pictures", size=64)
    assert [path.name for path in paths] == list(PICTURES)
    assert names(tmp_path / "pictures") == sorted(PICTURES)
    assert [Image.open(path).size for path in paths] == [(64, 64), (64, 64)]


def test_ours_is_replaced_only_when_asked(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "room")
    with pytest.raises(InputError, match="already holds a room"):
        check_folder(out)
    other = replace(result(), trace=())
    with pytest.raises(InputError, match="already holds a room"):
        save(other, out)
    assert (out / "trace.jsonl").stat().st_size > 0
    save(other, out, overwrite=True)
    assert (out / "trace.jsonl").stat().st_size == 0
    assert names(tmp_path) == ["room"]


@pytest.mark.parametrize("overwrite", [False, True])
@pytest.mark.parametrize("content", [{}, {"thesis.tex": "years of work"}, {"scene.json": "{}"}])
def test_what_is_not_ours_is_left_alone(tmp_path: Path, overwrite: bool, content: dict[str, str]) -> None:
    out = tmp_path / "mine"
    out.mkdir()
    for name, text in content.items():
        (out / name).write_text(text)
    with pytest.raises(InputError, match="choose another"):
        save(result(), out, overwrite=overwrite)
    assert {name: (out / name).read_text() for name in names(out)} == content
    assert names(tmp_path) == ["mine"]


def test_a_room_with_a_foreign_file_in_it_is_not_replaced(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "room")
    (out / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match=r"notes\.txt"):
        save(result(), out, overwrite=True)
    assert names(out) == sorted([*WITHOUT_PICTURES, "notes.txt"])


def test_a_file_or_a_link_in_the_way(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    room = save(result(), tmp_path / "room")
    (tmp_path / "link").symlink_to(room)
    for out in (tmp_path / "file", tmp_path / "link"):
        with pytest.raises(InputError, match=r"not a folder|symbolic link"):
            check_folder(out, overwrite=True)
    with pytest.raises(InputError, match="file is not a folder"):
        check_folder(tmp_path / "file" / "room")


def test_a_parent_that_cannot_be_written(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="/proc"):
        save(result(), Path("/proc/thinkblox/room"))
    with pytest.raises(InputError, match="too long"):
        save(result(), tmp_path / ("x" * 300))
    assert names(tmp_path) == []


@dataclass(frozen=True)
class Interrupted:
    """A result whose trace stops the work half-way, when other files are already written."""

    error: BaseException
    whole: Result = field(default_factory=result)

    def __getattr__(self, name: str) -> object:
        return getattr(self.whole, name)

    @property
    def trace(self) -> tuple[Line, ...]:
        raise self.error


@pytest.mark.parametrize("error", [KeyboardInterrupt(), RuntimeError("no"), OSError(28, "No space left on device")])
def test_a_failure_leaves_nothing_behind(tmp_path: Path, error: BaseException) -> None:
    expected = InputError if isinstance(error, OSError) else type(error)
    with pytest.raises(expected):
        save_room(Interrupted(error), tmp_path / "deep" / "room", pictures=False)  # type: ignore[arg-type]
    assert names(tmp_path) == []


def test_a_failure_leaves_the_old_room_as_it_was(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "room")
    before = {name: (out / name).read_bytes() for name in names(out)}
    with pytest.raises(KeyboardInterrupt):
        save_room(Interrupted(KeyboardInterrupt()), out, pictures=False, overwrite=True)  # type: ignore[arg-type]
    assert {name: (out / name).read_bytes() for name in names(out)} == before
    assert names(tmp_path) == ["room"]
