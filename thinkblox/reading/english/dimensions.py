"""Sizes of which the side is named first: "a ceiling height of 2.8 m", "width: 4 m", "an 8 foot ceiling"."""

from collections.abc import Sequence
from dataclasses import replace

from msgspec import structs

from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.sizes import Length, Size, read_size
from thinkblox.reading.tokens import Token

_AXES = {
    "width": "width", "breadth": "width", "depth": "depth", "length": "length", "height": "height",
    "diameter": "diameter",
}  # fmt: skip
_CEILING = ("ceiling", "ceilings")
_ARTICLES = ("a", "an", "the", "its", "my", "our")
_FIRST = frozenset({*_AXES, *_CEILING, *_ARTICLES, "room", "total", "overall"})
_NAMED, _NEAR = frozenset({*_AXES, *_CEILING}), 6
"""What names a side, and among how many words one has to come."""
_LINKS = ("of", "is", "are", ":", "=", "at", "being")
_MOST = 3
"""So many sides are told together."""
_LEADS = ("measuring", "sized", "spanning", "measured", "sizing")
"""What is said before the size of something."""
_SAID = ("measures", "spans")
_RELATIVE = ("that", "which")


def led_size(lexicon: Lexicon, tokens: list[Token], start: int) -> tuple[Size, int] | None:
    """The size that begins at `start` with the name of a side or ends with the ceiling, and the token after it."""
    if tokens[start].text not in _FIRST or _NAMED.isdisjoint(token.text for token in tokens[start : start + _NEAR]):
        return None
    found = _of_ceiling(lexicon, tokens, start)
    lengths: list[Length] = []
    end = at = start
    while found is None and len(lengths) < _MOST and (told := _told(lexicon, tokens, at)) is not None:
        lengths.append(told[0])
        end = at = told[1]
        joined = at < len(tokens) and tokens[at].text in (",", "and")
        at += joined + (joined and at + 1 < len(tokens) and tokens[at + 1].text == "and")
    if found is not None or not lengths:
        return found
    return Size(tuple(lengths), " ".join(token.shown for token in tokens[start:end])), end


def _told(lexicon: Lexicon, tokens: list[Token], start: int) -> tuple[Length, int] | None:
    """The one side that is named at a token, and the token after its length."""
    at = start + (start < len(tokens) and tokens[start].text in _ARTICLES)
    at += at < len(tokens) and tokens[at].text in ("room", "total", "overall")
    ceiling = at < len(tokens) and tokens[at].text in _CEILING
    at += ceiling
    axis = _AXES.get(tokens[at].text, "") if at < len(tokens) else ""
    at += bool(axis)
    if not (axis or ceiling):
        return None
    linked = at < len(tokens) and tokens[at].text in _LINKS
    if not (linked or axis):
        return None
    at += linked
    about = grammar().at(tokens, at, "quantifiers")
    at += about.length if about is not None else 0
    size = read_size(lexicon, tokens, at) if at < len(tokens) else None
    if size is None or len(size[0].lengths) > 1 or size[0].area is not None:
        return None
    length = size[0].lengths[0]
    axis = "height" if ceiling else axis
    return (replace(length, axis=axis), size[1]) if length.axis in ("", axis) else None


def _of_ceiling(lexicon: Lexicon, tokens: list[Token], start: int) -> tuple[Size, int] | None:
    """The height of "an 8 foot ceiling", "a 3 m high ceiling"."""
    at = start + (tokens[start].text in _ARTICLES)
    size = read_size(lexicon, tokens, at) if at < len(tokens) else None
    if size is None or len(size[0].lengths) > 1 or size[1] >= len(tokens) or tokens[size[1]].text not in _CEILING:
        return None
    length, end = replace(size[0].lengths[0], axis="height"), size[1] + 1
    return Size((length,), " ".join(token.shown for token in tokens[start:end])), end


def with_plain_sizes(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "of" for what leads to a size: "a rug measuring 2 m by 3 m", "a table that measures 2 m"."""
    made = list(tokens)
    for at, token in enumerate(tokens):
        relative = token.text in _SAID and at > 0 and tokens[at - 1].text in _RELATIVE
        if not (relative or token.text in _LEADS) or at + 1 == len(tokens):
            continue
        about = grammar().at(made, at + 1, "quantifiers")
        skip = about.length if about is not None else int(tokens[at + 1].text in ("at", "up", "to"))
        if read_size(lexicon, made, at + 1 + skip) is None:
            continue
        made[at - relative] = structs.replace(tokens[at - relative], text="of", glued=False)
        if relative:
            made[at] = structs.replace(token, text="about")
    return made
