"""Where the meshes that a layout names are looked for: a folder of assets, and the layout's own folder."""

import gzip
import json
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

from thinkblox.errors import InputError
from thinkblox.importing.document import Document, Extent, Foreign, Metres, read_document
from thinkblox.importing.sizes import Sizes
from thinkblox.value import Vec3

MESHES = (".glb", ".gltf", ".obj", ".stl", ".ply")
DATASETS = ("", "assets", "Assets", "objathor-assets", "layoutvlm-objathor", "3D-FUTURE-model", "hssd")
"""Folders under the given ones in which collections are kept: I-Design's, and those of SceneEval's set-up."""
MAX_UNPACKED = 512_000_000


class Point(Foreign, frozen=True, kw_only=True):
    """A point or a size, by axis [m]."""

    x: Metres
    y: Metres
    z: Metres


class _Box(Foreign, frozen=True, kw_only=True):
    x: Extent | None = None
    y: Extent | None = None
    z: Extent | None = None
    size: Point | None = None
    min: Point | None = None
    max: Point | None = None


class _Metadata(Foreign, frozen=True, kw_only=True):
    boundingBox: _Box | None = None  # noqa: N815 (the key's own name)


class _Thor(Foreign, frozen=True, kw_only=True):
    assetMetadata: _Metadata | None = None  # noqa: N815


class Annotations(Foreign, frozen=True, kw_only=True):
    """The part of a record that a person or a model annotated."""

    category: str = ""
    onFloor: bool = False  # noqa: N815
    onWall: bool = False  # noqa: N815
    onCeiling: bool = False  # noqa: N815
    onObject: bool = False  # noqa: N815


class AssetRecord(Foreign, frozen=True, kw_only=True):
    """What a collection says of an asset: "data.json" of LayoutVLM's, "annotations.json" of objathor's."""

    assetMetadata: _Metadata | None = None  # noqa: N815
    thor_metadata: _Thor | None = None
    category: str = ""
    annotations: Annotations | None = None

    @property
    def kind(self) -> str:
        """What it is."""
        return self.annotations.category if self.annotations else self.category

    @property
    def box(self) -> Vec3 | None:
        """Its extents along x, y and z of the collection's own axes [m]; None where it has none above 0."""
        metadata = self.assetMetadata or (self.thor_metadata and self.thor_metadata.assetMetadata)
        box = metadata.boundingBox if metadata else None
        if box is None:
            return None
        if box.x and box.y and box.z:
            size = (box.x, box.y, box.z)
        elif box.size:
            size = (box.size.x, box.size.y, box.size.z)
        elif box.min and box.max:
            size = (box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z)
        else:
            return None
        return size if min(size) > 0.0 else None


@dataclass
class Library:
    """Finds files under `roots`, the asset folder first, and never opens one that lies outside them.

    `sizes` is a table of the user's own; it goes before what a layout or a collection says.
    """

    roots: tuple[Path, ...]
    sizes: Sizes = field(default_factory=dict)
    _records: dict[Path, dict[str, Any]] = field(default_factory=dict)
    _meshes: dict[str, Path | None] = field(default_factory=dict)

    def named(self, path: str, *, document: Document, at: str) -> Path | None:
        """The mesh at a path that a layout gives: as it stands if that is under a root, else by its last parts.

        Raises:
            InputError: a relative path that leads out of every root.
        """
        parts = PureWindowsPath(path).parts if "\\" in path else PurePosixPath(path).parts
        anchored = bool(parts) and (parts[0].startswith("/") or parts[0].endswith("\\"))
        if not anchored and ".." in parts and self._under(Path(*parts)) is None:
            document.fail(
                at, f"the mesh {path!r} leads out of the folder of the layout and of the assets; it is not opened"
            )
        tails = [parts[-n:] for n in ((2, 1) if anchored else (len(parts), 2, 1)) if len(parts) >= n]
        for tail in tails:
            found = self._mesh(PurePosixPath(*tail).with_suffix("").as_posix(), PurePosixPath(tail[-1]).suffix)
            if found:
                return found
        return None

    def asset(self, id: str) -> Path | None:
        """The mesh of an asset by its id, where the collections of Objaverse, 3D-FUTURE and HSSD keep it."""
        if not id or "/" in id or "\\" in id or id.startswith("."):
            return None
        if id not in self._meshes:
            self._meshes[id] = self._looked_for(id)
        return self._meshes[id]

    def _looked_for(self, id: str) -> Path | None:
        for pattern in (
            f"{id}/{id}",
            f"{id}",
            f"{id}/raw_model",
            f"glb/{id[0]}/{id}",
            f"decomposed/{id.split('_')[0]}/{id}",
        ):
            found = self._mesh(pattern)
            if found:
                return found
        return None

    def record(self, id: str) -> AssetRecord | None:
        """What the collection says of an asset; None where it says nothing."""
        if not id or "/" in id or "\\" in id or id.startswith("."):
            return None
        for folder in self._folders():
            for name in (f"{id}/data.json", f"{id}/annotations.json"):
                file = self._under(folder / name)
                if file:
                    return read_document(file).typed(AssetRecord)
            for name in ("annotations.json", "annotations.json.gz"):
                file = self._under(folder / name)
                if file and id in self._table(file):
                    return Document(file, None).part(AssetRecord, self._table(file)[id], f"$.{id}")
        return None

    def _folders(self) -> Iterator[Path]:
        return (Path(dataset) for dataset in DATASETS)

    def _mesh(self, stem: str, suffix: str = "") -> Path | None:
        suffixes = [suffix] if suffix in MESHES else list(MESHES)
        for folder in self._folders():
            for kind in suffixes:
                found = self._under(folder / f"{stem}{kind}")
                if found:
                    return found
        return None

    def _under(self, relative: Path) -> Path | None:
        """The file at a relative path under the first root that has it, if that is still under the root."""
        for root in self.roots:
            try:
                # Most paths that are tried are not there, and that is soon seen.
                if not (root / relative).is_file():
                    continue
                file = (root / relative).resolve()
                if file.is_relative_to(root.resolve()):
                    return file
            except (OSError, ValueError, RuntimeError):
                continue
        return None

    def _table(self, file: Path) -> dict[str, Any]:
        if file not in self._records:
            self._records[file] = _unpacked(file)
        return self._records[file]


def _unpacked(file: Path) -> dict[str, Any]:
    try:
        if file.suffix == ".gz":
            with gzip.open(file) as stream:
                data = stream.read(MAX_UNPACKED + 1)
        else:
            data = file.read_bytes()
        if len(data) > MAX_UNPACKED:
            raise InputError(f"{file}: is larger than {MAX_UNPACKED // 1_000_000} MB")
        table = json.loads(data)
    except (OSError, EOFError, ValueError, RecursionError) as error:
        raise InputError(f"{file}: cannot be read as annotations of assets: {error}") from error
    if not isinstance(table, dict):
        raise InputError(f"{file}: is no object that maps asset ids to annotations")
    return table
