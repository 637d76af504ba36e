"""One more of what was named before: "another one", "a second one", "of the same kind"."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.assets.plurals import singular
from thinkblox.editing.grammar import longest, means
from thinkblox.editing.reading.clause import ENDS
from thinkblox.reading.english.grammar import grammar, is_count
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

_SECOND = ("second", "third", "fourth", "further", "additional", "extra")
_BEGINS = ("a", "an", "the", "my", "our", "another", "this", "that", "some")
_GOING = ("remove", "replace", "unwanted")
_BRINGING = ("add", "want", "put", "ensure", "move")
MOST_LOOKS = 4
"""Most words from an article to the name of a thing."""


def with_another(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "(put a round rug under the bed and add) another one" as "another round rug".

    Of "one of the same kind" nothing but the thing is left: what is added besides others is like them. What comes in
    place of something, or after that was taken away, is read with what it comes in place of.
    """
    left = _for_which_space(_without_kind(list(tokens)))
    for at in reversed(range(len(left))):
        length = _another_at(left, at)
        if not length:
            continue
        verbs = [n for n in range(at) if _verb(left, n)]
        begun = [n for n in verbs if _named(lexicon, left, n, at)]
        if not begun or _verb(left, verbs[-1]) not in _BRINGING or _verb(left, begun[-1]) in _GOING:
            continue
        head = _named(lexicon, left, begun[-1], at)
        another = structs.replace(left[at], text="another")
        left[at : at + length] = [another, *(structs.replace(token, start=-1) for token in head)]
    return left


def _verb(tokens: Sequence[Token], at: int) -> str:
    """What is done by the verb that begins there; empty where none does."""
    found, change = longest("verbs", tokens, at), longest("resizing", tokens, at)
    return found[0] if found is not None else "make" if change is not None else ""


def _another_at(tokens: Sequence[Token], at: int) -> int:
    """How many tokens say "another one" there: nothing that would tell which follows them."""
    words = [token.text for token in tokens[at : at + 4]]
    if words[:2] == ["another", "one"] or words[:2] == ["one", "more"]:
        length = 2
    elif words[:1] == ["one"] and (_is_added(tokens, at) or _goes_on_counting(tokens, at)):
        length = 1
    elif words[:1] == ["a"] and words[1:2] and words[1] in _SECOND and words[2:3] == ["one"]:
        length = 3
    else:
        return 0
    after = tokens[at + length] if at + length < len(tokens) else None
    ends = after is None or after.kind == "mark" or after.text in ("and", "but", "then", "please")
    placed = after is not None and after.text in _PLACES
    return length if ends or placed else 0


_PLACES = frozenset(
    "at by next near beside on in under above over below behind against along opposite around between to where there"
    " here as too with from to onto".split()
)


def _is_added(tokens: Sequence[Token], at: int) -> bool:
    return at > 0 and tokens[at - 1].text in ("add", "buy", "get")


def _goes_on_counting(tokens: Sequence[Token], at: int) -> bool:
    """Whether it counts on from what goes somewhere else: "(put) two cups on the desk and one (on the shelf)"."""
    begin = next((n for n in reversed(range(at)) if _verb(tokens, n)), at)
    before = [token.text for token in tokens[begin:at]]
    counted = any(is_count(tokens, n) for n in (begin + 1, begin + 2))
    each = next((n for n in range(at, min(at + 4, len(tokens))) if tokens[n].text in ("each", "either")), None)
    shared = "one" in before or (each is not None and grammar().at(tokens, each + 1, "parts") is not None)
    return before[-1:] == ["and"] and counted and not shared and bool(_PLACES & {*before})


def _named(lexicon: Lexicon, tokens: Sequence[Token], begin: int, end: int) -> list[Token]:
    """The first thing that is named there with its looks, as one; empty where none is named."""
    for at in range(begin, end):
        if tokens[at].text in ENDS:
            return []
        found = lexicon.longest(list(tokens), at)
        if found.entry("object") is None or at + found.length > end:
            continue
        article = next((n for n in range(at - 1, max(at - MOST_LOOKS, begin), -1) if tokens[n].text in _BEGINS), None)
        looks = list(tokens[article + 1 : at]) if article is not None and tokens[article].text in ("a", "an") else []
        looks = [token for token in looks if token.kind == "word" and not means("comparatives", token.text)]
        looks = [token for token in looks if token.text not in ("second", "new", "other")]
        last = tokens[at + found.length - 1]
        one = singular(last.text)
        return [*looks, *tokens[at : at + found.length - 1], structs.replace(last, text=one, shown=one)]
    return []


def _for_which_space(tokens: list[Token]) -> list[Token]:
    """The tokens with "I need the space for a washing machine, so put one there" as "put a washing machine there".

    So is "use the space for a desk".
    """
    words = [token.text for token in tokens]
    for at in range(len(tokens) - 4):
        space = at + 1 + (words[at + 1] in ("the", "that", "more", "some"))
        if space + 2 >= len(words) or words[space] not in ("space", "room") or words[space + 1] != "for":
            continue
        named = space + 2
        end = next((n for n in range(named, len(words)) if tokens[n].kind == "mark"), len(words))
        if words[named] not in ("a", "an", "another"):
            continue
        if words[at] == "use":
            put, there = (structs.replace(tokens[at], text=text, shown=text, start=-1) for text in ("put", "there"))
            return [
                *tokens[:at],
                structs.replace(put, start=tokens[at].start),
                *tokens[named:end],
                there,
                *tokens[end:],
            ]
        so = end + 1 + (words[end + 1 : end + 2] == ["so"])
        one = next((n for n in range(so, min(so + 3, len(words))) if words[n] == "one"), None)
        begin = at - (at > 0 and words[at - 1] in ("i", "we"))
        if (
            words[at] in ("need", "want")
            and begin < at
            and one is not None
            and longest("verbs", tokens, so) is not None
        ):
            return [*tokens[:begin], *tokens[so:one], *tokens[named:end], *tokens[one + 1 :]]
    return tokens


_KINDS = ("kind", "type", "sort", "style", "model", "design")


def _without_kind(tokens: list[Token]) -> list[Token]:
    """The tokens without "(another armchair) of the same kind", which one more of them is in any case."""
    left = list(tokens)
    for at in reversed(range(2, len(tokens) - 3)):
        words = [token.text for token in left[at : at + 4]]
        same = words[:3] == ["of", "the", "same"] and words[3:] and words[3] in _KINDS
        begun = [token.text for token in left[max(at - 5, 0) : at]]
        if same and ({"another", "more", *_SECOND} & {*begun}):
            del left[at : at + 4]
    return left
