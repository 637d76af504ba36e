"""Whose assets a scene shows, and under which licence."""

from thinkblox.scene.scene import Scene
from thinkblox.value import Value


class Credit(Value, frozen=True, kw_only=True):
    """The assets of one author under one licence, by id, in the order in which they were placed."""

    licence: str
    author: str
    assets: tuple[str, ...]


def credits_of(scene: Scene) -> tuple[Credit, ...]:
    """The licences and authors of all assets that are placed, each pair once."""
    found: dict[tuple[str, str], dict[str, None]] = {}
    for placement in scene.placements:
        asset = scene.asset_of(placement)
        found.setdefault((asset.licence, asset.author), {})[asset.id] = None
    return tuple(Credit(licence=licence, author=author, assets=tuple(ids)) for (licence, author), ids in found.items())
