"""manifest.json: which files of an output folder belong to it, what they are, and whose assets they show."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

import msgspec

from thinkblox.exporters.credits import Credit
from thinkblox.value import Value, read_json

FileKind = Literal["scene", "report", "asset", "format", "picture", "extra"]
MANIFEST = "manifest.json"
MANIFEST_VERSION = 1
PICTURES = ("preview.png", "top.png")
_OLDER = ("scene.json", "scene.xml", "scene.usda", "report.json", "trace.jsonl")
"""What a folder of the release before the manifest holds, and nothing else."""


class ManifestFile(Value, frozen=True, kw_only=True, omit_defaults=True):
    """A file of the folder.

    Attributes:
        name: its path relative to the folder, with "/".
        kind: what it is for; "asset" is a mesh or texture that scene.json names by its content.
        format: the export format that wrote it.
        says: what it holds, in a few words.
    """

    name: str
    kind: FileKind
    format: str | None = None
    says: str = ""


class Manifest(Value, frozen=True, kw_only=True):
    """What an output folder holds besides this file.

    Attributes:
        thinkblox: the release that wrote it.
        files: all of them, in the order in which they were written.
        formats: names of the export formats.
        credits: licences and authors of the assets that are placed.
    """

    version: int = MANIFEST_VERSION
    thinkblox: str
    files: tuple[ManifestFile, ...]
    formats: tuple[str, ...]
    credits: tuple[Credit, ...]


class _Named(msgspec.Struct):
    name: str


class _AnyManifest(msgspec.Struct):
    """What a manifest of any release has."""

    version: int
    thinkblox: str
    files: list[_Named]


def foreign_files(folder: Path) -> Iterator[str]:
    """What lies in an output folder and does not belong to it, by relative path.

    Pictures may be drawn into a folder after it was written. Links belong to nobody.

    Raises:
        InputError: its manifest is not one.
    """
    ours = _belonging(folder)
    above = {str(parent) for name in ours for parent in Path(name).parents}
    for home, folders, files in os.walk(folder):
        for name in sorted(folders + files):
            path = Path(home, name)
            relative = path.relative_to(folder).as_posix()
            if path.is_symlink() or relative not in (above if path.is_dir() else ours):
                yield relative
        folders[:] = [name for name in folders if Path(home, name).relative_to(folder).as_posix() in above]


def _belonging(folder: Path) -> set[str]:
    if not os.path.lexists(folder / MANIFEST):
        return {*_OLDER, *PICTURES}
    manifest = read_json(folder / MANIFEST, _AnyManifest)
    return {MANIFEST, *PICTURES, *(file.name for file in manifest.files)}
