"""Where assets come from: whatever finds, makes and fits them; the catalogue of procedural furniture is one."""

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Protocol

from thinkblox.assets.catalogue import CATALOGUE, phrases, revision
from thinkblox.assets.facts import Facts
from thinkblox.assets.make import fit_asset, make_thing
from thinkblox.assets.spelling import Spelling
from thinkblox.assets.stand_ins import facts_of, kind_of
from thinkblox.scene.asset import Asset, Mount
from thinkblox.value import Vec3

_MOST = 8
"""Most phrases that are taken for being spelt alike."""


class AssetSource(Protocol):
    """What can give assets of named categories, and say what is known of them."""

    def find(self, words: str) -> tuple[str, ...]:
        """The categories that an English noun phrase can mean, the likeliest first; empty when there is none."""
        ...

    def facts(self, category: str) -> Facts:
        """What is known of a category; the defaults for one that is not known."""
        ...

    def size_range(self, category: str) -> tuple[Vec3, Vec3]:
        """Smallest and largest size that `make` and `fit` accept [m]; raises InputError for an unknown category."""
        ...

    def usual(self, category: str) -> tuple[Vec3, Mount]:
        """Size of an ordinary one [m], and what it is placed on; raises InputError for an unknown category."""
        ...

    def make(self, category: str, *, seed: int, attributes: Sequence[str] = (), size: Vec3 | None = None) -> Asset:
        """A new asset; the same arguments give the same asset. Raises InputError for what cannot be made.

        Its id differs with its content, for a scene holds one asset under each id.
        """
        ...

    def fit(self, asset: Asset, size: Vec3) -> Asset:
        """One of its own assets at another size [m]; raises InputError when it cannot have that size."""
        ...


class ProceduralAssets:
    """The catalogue's own furniture, with the categories that were registered, and plain stand-ins for all else."""

    def find(self, words: str) -> tuple[str, ...]:
        """The categories that the words name, then those that their last words name, then those spelt much alike."""
        known, spelling = _by_phrase(revision())
        parts = words.lower().replace("_", " ").split()
        ends = [" ".join(parts[start:]) for start in range(len(parts))]
        forms = [form for end in ends for form in (end, end.removesuffix("s"), end.removesuffix("es"))]
        named = [name for form in forms for name in known.get(form, ())]
        close = spelling.close(" ".join(parts), _MOST)
        return tuple(dict.fromkeys([*named, *(name for phrase in close for name in known[phrase])]))

    def facts(self, category: str) -> Facts:
        """What the catalogue knows of a category."""
        return facts_of(category)

    def size_range(self, category: str) -> tuple[Vec3, Vec3]:
        """Smallest and largest size that the generator makes [m]."""
        return kind_of(category).size_range

    def usual(self, category: str) -> tuple[Vec3, Mount]:
        """Size and mount that the catalogue gives."""
        kind = kind_of(category)
        return kind.size, kind.mount

    def make(self, category: str, *, seed: int, attributes: Sequence[str] = (), size: Vec3 | None = None) -> Asset:
        """A new asset of a category, as `make_thing`."""
        return make_thing(category, seed=seed, attributes=attributes, size=size)

    def fit(self, asset: Asset, size: Vec3) -> Asset:
        """The same asset made at another size, as `fit_asset`."""
        return fit_asset(asset, size)


@lru_cache(maxsize=1)
def _by_phrase(revision: int) -> tuple[Mapping[str, tuple[str, ...]], Spelling]:
    """The categories by what they are called: their names, nouns and English words; with the spelling of these."""
    found: dict[str, tuple[str, ...]] = {}
    for name, category in sorted(CATALOGUE.items(), key=lambda item: item[1].plain):
        for phrase in dict.fromkeys((name.replace("_", " "), category.noun.lower(), *phrases(category))):
            found[phrase] = (*found.get(phrase, ()), name)
    return found, Spelling(found)
