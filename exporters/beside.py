"""Files that an exported scene names: by content, in a folder beside it, so that the whole can be moved."""

from collections.abc import Mapping
from pathlib import Path

from thinkblox.exporters.inventory import Inventory
from thinkblox.scene.blobs import BLOBS, blob_name


def texture_files(inventory: Inventory, pictures: Mapping[str, bytes]) -> dict[str, bytes]:
    """The textures of all looks and other `pictures` by hash, by their paths relative to what names them."""
    textures = {look.texture for look in inventory.looks.values() if look.texture is not None}
    found = {texture: BLOBS.get(texture) for texture in textures} | dict(pictures)
    return {blob_name(texture, "png"): found[texture] for texture in sorted(found)}


def write_beside(path: Path, files: Mapping[str, bytes]) -> None:
    """Write files by their paths relative to the folder of `path`; one that is there has that content already."""
    for name, data in files.items():
        file = path.parent / name
        file.parent.mkdir(exist_ok=True)
        if not file.exists():
            file.write_bytes(data)
