"""What hangs beside something and is on nothing: it hangs on the wall there."""

from collections.abc import Iterator, Mapping, Sequence

from thinkblox.assets import CATALOGUE, Category, kind_of
from thinkblox.assets.mounting import WALL_MOUNTED, mount_of
from thinkblox.knowledge.senses import senses_of
from thinkblox.reading.attach import bind
from thinkblox.reading.draft import Bond, Draft, Mention
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_BESIDE = ("left_of", "right_of", "next_to", "near", "between")
"""Relations that leave open on what something hangs."""
_OUTLINE = 0.2
"""What has a larger outline stands at a wall where it cannot hang [m2]."""
_HUNG = ("wall", "ceiling")
_ON_WALL = "rel:on_wall"
"""The condition of what a word means where it hangs on a wall."""
_HANGING = ("verbs", "participles")


def hang_up(draft: Draft, chunks: Sequence[Chunk], meant: Mapping[int, list[Mention]]) -> None:
    """Put on the wall what is said to hang, and stands otherwise, where nothing is told of what it hangs on."""
    for noun, verb in _hanging(chunks):
        for thing in meant.get(noun.start, []):
            bonds = draft.bonds_of(thing)
            beside = bool(bonds) and all(b.kind in _BESIDE and not b.negated for b in bonds)
            if not beside or thing not in draft.things or kind_of(thing.noun).mount in _HUNG:
                continue
            if can_hang(kind_of(thing.noun)):
                bind(draft, Bond("on", thing, ("wall",)))
            else:
                draft.unknown.append(f"{noun.text} {verb.text}")


def can_hang(kind: Category) -> bool:
    """Whether such a thing can be on a wall, be it in another form."""
    if any(_ON_WALL in sense.conditions for sense in senses_of(kind.name)):
        return True
    little = kind.size[0] * kind.size[1] <= _OUTLINE
    return little or f"wall_{kind.name}" in CATALOGUE or mount_of(kind, (WALL_MOUNTED,)) == "wall"


def _hanging(chunks: Sequence[Chunk]) -> Iterator[tuple[Noun, Connector]]:
    """Of what it is said that it hangs: "a lantern hangs by the door", "left of the board hangs a lantern"."""
    for at, chunk in enumerate(chunks):
        if not at or not isinstance(chunk, Connector) or chunk.value != "hang" or chunk.sort not in _HANGING:
            continue
        before, after = chunks[at - 1], chunk_at(chunks, at + 1)
        if is_link(before, "verbs", "be") and at > 1:
            before = chunks[at - 2]
        if isinstance(after, Noun) and after.kind == "thing" and not after.definite:
            yield after, chunk
        elif isinstance(before, Noun) and before.kind == "thing" and is_link(after, "prepositions"):
            yield before, chunk
