"""Makes assets of the catalogue's categories."""

import difflib
import hashlib
import re
import zlib
from collections.abc import Sequence
from copy import deepcopy
from functools import lru_cache

import msgspec
import numpy as np
from msgspec import structs

from thinkblox.assets.ajar import ajar, depth_before, stands_open
from thinkblox.assets.catalogue import CATALOGUE, revision
from thinkblox.assets.category import Category
from thinkblox.assets.finish import fitted, links_of
from thinkblox.assets.levels import found_surfaces
from thinkblox.assets.masses import mass_of
from thinkblox.assets.mounting import mount_of
from thinkblox.assets.open_forms import FOR_LONG, opened, stood_up
from thinkblox.assets.palette import style_of
from thinkblox.assets.part import Build
from thinkblox.assets.repaint import of_kind, repainted
from thinkblox.assets.sizing import checked_size, is_stood, lain, size_for
from thinkblox.assets.spec import Spec
from thinkblox.assets.stand_ins import kind_of
from thinkblox.assets.stripes import patterned
from thinkblox.errors import InputError
from thinkblox.scene.asset import Asset, Link, Mount, Surface, worded
from thinkblox.value import Vec3

_PROVENANCE = re.compile(r"(?P<how>procedural|stand_in):(?P<category>\w+):seed=(?P<seed>\d+)(?::(?P<words>.*))?")


def make_asset(category: str, *, seed: int, attributes: Sequence[str] = (), size: Vec3 | None = None) -> Asset:
    """Return a new asset of a category; assets made with one seed match in style.

    Args:
        category: a name of the catalogue.
        seed: draws what the attributes leave open; at least 0.
        attributes: words such as "round", "double", "low", "for six", "red"; those that mean nothing are ignored.
        size: make it exactly this big (along the front axis, across, up) [m], to a tenth of a millimetre.

    Raises:
        InputError: an unknown category, a negative seed, or a size outside what the category can have.
    """
    return make_thing(category_of(category).name, seed=seed, attributes=attributes, size=size)


def make_thing(name: str, *, seed: int, attributes: Sequence[str] = (), size: Vec3 | None = None) -> Asset:
    """Return a new asset as `make_asset` does, and a plain stand-in for a name that the catalogue does not have.

    Raises:
        InputError: a negative seed, or a size outside what the thing can have.
    """
    if seed < 0:
        raise InputError(f"seed {seed} is negative; give 0 or more")
    kind = kind_of(name)
    return _made(
        kind.name, seed, tuple(attributes), None if size is None else checked_size(kind, size, attributes), revision()
    )


def fit_asset(asset: Asset, size: Vec3) -> Asset:
    """Return the same asset made at another size [m].

    Raises:
        InputError: the asset was not made by this catalogue, or the size is outside what its category can have.
    """
    made = _PROVENANCE.fullmatch(asset.provenance)
    if not made:
        raise InputError(f"asset {asset.id} cannot be made at another size: its provenance is {asset.provenance!r}")
    words = tuple(w for w in (made["words"] or "").split(",") if w)
    make = make_asset if made["how"] == "procedural" else make_thing
    return make(made["category"], seed=int(made["seed"]), attributes=words, size=size).described(asset.description)


def seed_of(asset: Asset) -> int | None:
    """The seed that an asset of this catalogue was made with; None for any other."""
    made = _PROVENANCE.fullmatch(asset.provenance)
    return int(made["seed"]) if made else None


def category_of(name: str) -> Category:
    """Return the category called `name`; raises InputError that lists the closest names."""
    if name in CATALOGUE:
        return CATALOGUE[name]
    close = difflib.get_close_matches(name.lower().replace(" ", "_"), CATALOGUE, n=4, cutoff=0.5)
    raise InputError(
        f"no category {name!r} in the catalogue" + (f"; close ones are {', '.join(close)}" if close else "")
    )


@lru_cache(maxsize=512)
def _made(name: str, seed: int, attributes: tuple[str, ...], size: Vec3 | None, revision: int) -> Asset:
    category = kind_of(name)
    said = [w.lower().replace("_", "-") for w in attributes]
    words = frozenset([*said, *(general for word in said for general in of_kind(word))])
    rng = np.random.default_rng([seed, zlib.crc32(name.encode())])
    drawn = size_for(category, words, rng)
    size = size or drawn
    stood = is_stood(category, words)
    lying = lain(category, size) if stood else size

    def generated(box: Vec3) -> Build:
        return category.generator(Spec(name, box, words, style_of(seed), deepcopy(rng)))

    made = ajar(generated, lying) if stands_open(category, words) else generated(lying)
    if stood and category.long_axis is not None:
        made = stood_up(made, category.long_axis)
    forms = words & {FOR_LONG, *(category.forms[role] for role in ("holds", "carries") if role in category.forms)}
    build = fitted(opened(made, forms, round=(made.front or category.front) == "any") if forms else made, size)
    links, mount = links_of(build, size), mount_of(category, words)
    painted, before = repainted(links, words), depth_before(links, size)
    surfaces = _topped(category, tuple(build.surfaces) or _found(category, mount, links, size))
    asset = Asset(
        id="",
        category=name,
        description=worded(attributes, category.noun),
        size=size,
        mass=mass_of(category, (size[0] - before, *size[1:])),
        friction=category.friction,
        mount=mount,
        links=patterned(painted, words),
        front=build.front or category.front,
        clearance=max(0.0, round(category.clearance - before, 4)),
        surfaces=surfaces,
        attributes=attributes,
        provenance=f"{'procedural' if name in CATALOGUE else 'stand_in'}:{name}:seed={seed}"
        + (f":{','.join(attributes)}" if attributes else ""),
    )
    digest = hashlib.sha256(msgspec.json.encode(asset)).hexdigest()[:8]
    return structs.replace(asset, id=f"{name}-{digest}", gaze=category.gaze)


def _topped(category: Category, surfaces: tuple[Surface, ...]) -> tuple[Surface, ...]:
    """The surfaces, those under the top of what is no shelf, rack or bunk as within: "on the cart" means its top."""
    if category.is_in("shelves", "tiered", "beds") or all(s.inner for s in surfaces):
        return surfaces
    return tuple(s if s.headroom is None else structs.replace(s, within=True) for s in surfaces)


def _found(category: Category, mount: Mount, links: tuple[Link, ...], size: Vec3) -> tuple[Surface, ...]:
    """Where things can be put on or into what names no place for them; lamps and plants are no tables."""
    if category.flat or mount == "ceiling" or mount != category.mount or category.is_in("lamps", "plants"):
        return ()
    return found_surfaces(links, size, small=mount == "surface")
