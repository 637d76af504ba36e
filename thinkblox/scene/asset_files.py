"""The meshes and textures of assets as files beside a scene.json."""

from collections.abc import Iterable
from pathlib import Path

from thinkblox.errors import InputError
from thinkblox.scene.asset import Asset
from thinkblox.scene.blobs import BLOBS, BlobKind, blob_name
from thinkblox.scene.texture import check_texture
from thinkblox.scene.textured_mesh import mesh_of

MAX_FILES = 4096
"""Most blobs that the assets of one scene may name."""
MAX_BYTES = 2_000_000_000
"""Most bytes that they may have together."""


def asset_files(assets: Iterable[Asset]) -> dict[str, bytes]:
    """What the assets need beside their scene.json, by relative path; raises InputError naming asset and blob."""
    return {blob_name(id, kind): _content(asset, id) for (id, kind), asset in _owners(assets).items()}


def read_asset_files(assets: Iterable[Asset], home: Path) -> None:
    """Find in `home` what the assets need.

    Raises:
        InputError: a file is missing, altered, broken, too large or outside of `home`, or there are too many; names
            the asset and the file.
    """
    total = 0
    for (id, kind), asset in _owners(assets).items():
        try:
            BLOBS.read(id, kind, home)
            _check(id, kind)
        except InputError as error:
            raise InputError(f"asset {asset.id!r}: {error}") from error
        total += len(BLOBS.get(id))
        if total > MAX_BYTES:
            raise InputError(f"{home}: its assets need more than {MAX_BYTES // 1_000_000} MB")


def _owners(assets: Iterable[Asset]) -> dict[tuple[str, BlobKind], Asset]:
    """For each blob the first asset that needs it."""
    owners: dict[tuple[str, BlobKind], Asset] = {}
    for asset in assets:
        for blob in asset.blobs:
            owners.setdefault(blob, asset)
    if len(owners) > MAX_FILES:
        raise InputError(f"the assets of a scene need {len(owners)} files; at most {MAX_FILES} are read")
    return owners


def _content(asset: Asset, id: str) -> bytes:
    try:
        return BLOBS.get(id)
    except InputError as error:
        raise InputError(f"asset {asset.id!r}: {error}") from error


def _check(id: str, kind: BlobKind) -> None:
    if kind == "bin":
        mesh_of(id)
        return
    try:
        check_texture(BLOBS.get(id))
    except InputError as error:
        raise InputError(f"texture {id[:12]}: {error}") from error
