"""Turns of phrase that say the same as plainer words: "one per back corner", "a bit dark", "an overhead camera"."""

from collections.abc import Iterator, Sequence

from msgspec import structs

from thinkblox.reading.english.grammar import grammar, is_count
from thinkblox.reading.tokens import Token

_ENDS = ("back", "front", "rear", "far")
"""What says of corners which two they are."""


_CORRECTING = ("hmm", "hm", "no", "actually", "well", "maybe", "perhaps", "but", "though")
"""What may come before a number that is put right."""
_ANYWHERE = ["all", "over", "the", "place"]
_OF_THEM = ("their", "its")
_TURNED = ("heads", "backs", "headboards", "headboard")
_TOWARD = ("to", "against", "toward", "towards")
_AGAIN = ("and", "&", "upon")
"""What joins a noun to itself: "crates and crates"."""
_BY = ("x", "by", "and")
"""What joins the numbers of rows and columns."""
_PAIRS_OF = (["pair", "of"], ["pairs", "of"])
_DRINKS = (
    "wine",
    "water",
    "beer",
    "drink",
    "drinks",
    "champagne",
    "juice",
    "bottle",
    "jug",
    "carafe",
    "pitcher",
    "bar",
)
"""Where these are spoken of a pair of glasses is two to drink from."""
_GLASSES = ("glass", "glasses")
_PARTS, _FIXED = ("wall", "ceiling"), ("mounted", "hung", "fixed")
"""Words that a hyphen would join: "a wall mounted shelf"."""
_LONGEST = 6
"""Most words of a name before "each"."""


def plainly(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with the plain words for each turn of phrase; what was written stays what they show."""
    return _rows(_hyphened(list(_plain(list(_corrected([*_elided([*_everywhere(tokens)])]))))))


def _everywhere(tokens: Sequence[Token]) -> Iterator[Token]:
    """Read "all over the place" as "everywhere"."""
    at = 0
    while at < len(tokens):
        said = tokens[at : at + len(_ANYWHERE)]
        if [token.text for token in said] == _ANYWHERE:
            yield structs.replace(tokens[at], text="everywhere", shown=" ".join(token.shown for token in said))
            at += len(_ANYWHERE)
        else:
            yield tokens[at]
            at += 1


def _elided(tokens: Sequence[Token]) -> Iterator[Token]:
    """Read "one holds a tin, the other one four cups" as "the other four cups": no cups are called "four cups"."""
    for at, token in enumerate(tokens):
        if token.text == "one" and at and tokens[at - 1].text == "other" and _is_counted(tokens, at + 1):
            continue
        after = tokens[at + 1] if at + 1 < len(tokens) else None
        led = token.text == "other" and after is not None and after.text == "one" and _is_counted(tokens, at + 2)
        yield structs.replace(token, shown=f"{token.shown} {after.shown}") if led and after is not None else token


def _is_counted(tokens: Sequence[Token], at: int) -> bool:
    """Whether a number and a plural come and nothing of the same clause, as it does after a measure."""
    if at + 1 >= len(tokens) or not tokens[at + 1].text.endswith("s"):
        return False
    after = tokens[at + 2] if at + 2 < len(tokens) else None
    number = is_count(tokens, at)
    return number and (after is None or after.kind == "mark" or after.text == "and")


def _corrected(tokens: Sequence[Token]) -> Iterator[Token]:
    """Read "four is enough" as "make that four"."""
    at = 0
    while at < len(tokens):
        length = _is_enough(tokens, at)
        if length:
            yield structs.replace(tokens[at], text="make", shown="")
            yield structs.replace(tokens[at], text="that", shown="")
        yield (
            structs.replace(tokens[at], shown=" ".join(t.shown for t in tokens[at : at + length]))
            if length
            else tokens[at]
        )
        at += length or 1


def _rows(tokens: list[Token]) -> list[Token]:
    """Read "five rows with three desks each" as "five rows of three desks"."""
    for at in range(1, len(tokens) - 2):
        led = tokens[at - 1].text in grammar().lists["ranged"] and tokens[at].text == "with"
        if not led or grammar().at(tokens, at + 1, "count") is None:
            continue
        ends = (n for n in range(at + 2, min(at + _LONGEST, len(tokens))))
        each = next((n for n in ends if tokens[n].text == "each" or tokens[n].kind == "mark"), None)
        if each is not None and tokens[each].text == "each":
            tokens[at] = structs.replace(tokens[at], text="of")
            tokens[each] = structs.replace(tokens[each], text="too")
    return tokens


def _plain(tokens: Sequence[Token]) -> Iterator[Token]:
    at, drinks = 0, _is_of_drinks(tokens)
    while at < len(tokens):
        words = [token.text for token in tokens[at : at + 3]]
        if _is_grid(tokens, at):
            yield from (tokens[at], tokens[at + 1], structs.replace(tokens[at + 2], text="of"))
            shown = " ".join(token.shown for token in tokens[at + 3 : at + 6])
            yield structs.replace(tokens[at + 3], shown=shown)
            at += 6
            continue
        if words[0] == "per" and words[1:2] and words[1] in _ENDS and words[2:] == ["corner"]:
            yield structs.replace(tokens[at], text="in")
            yield structs.replace(tokens[at], text="each", shown="", start=tokens[at].start + len(tokens[at].shown))
        elif words[0] == "," and (turned := _turned_ends(tokens, at + 1)):
            yield from (tokens[at], *turned)
            at += 1 + (tokens[at + 1].text in _OF_THEM)
        elif words[0] == "overhead" and words[1:] and words[1] in grammar().lists["overhead"]:
            yield structs.replace(tokens[at], text="hanging")
        elif words[:2] == ["a", "bit"] and words[2:] and words[2] != "of" and tokens[at + 2].kind == "word":
            yield structs.replace(tokens[at], text="quite", shown=f"{tokens[at].shown} {tokens[at + 1].shown}")
            at += 1
        elif words[:2] in (["grown", "ups"], ["grown", "up"]) and tokens[at].glued:
            adults = "adults" if words[1] == "ups" else "adult"
            yield structs.replace(tokens[at + 1], text=adults, shown=f"{tokens[at].shown}-{tokens[at + 1].shown}")
            at += 1
        elif len(words) == len(_BY) and words[0] == words[2] and words[0].endswith("s") and words[1] in _AGAIN:
            of = bool(tokens[at + 3 : at + 4]) and tokens[at + 3].text == "of"
            yield structs.replace(tokens[at], text="really")
            yield structs.replace(
                tokens[at + 1], text="really" if of and grammar().at(tokens, at + 2, "vague") else "many"
            )
            at += 1
        elif words[:1] == ["glasses"] and not drinks and [t.text for t in tokens[at - 2 : at]] in _PAIRS_OF:
            yield structs.replace(tokens[at], text="eyeglasses")
        else:
            yield tokens[at]
        at += 1


def _is_of_drinks(tokens: Sequence[Token]) -> bool:
    """Whether drinks are spoken of: a water glass beside a pair of glasses tells the two apart."""
    drinks = [at for at, token in enumerate(tokens) if token.text in _DRINKS]
    return bool(drinks) and not any(token.text in _GLASSES for at in drinks for token in tokens[at + 1 : at + 2])


def _turned_ends(tokens: Sequence[Token], at: int) -> list[Token]:
    """Read ", heads to the wall" as ", with their heads to the wall"; empty where it does not come."""
    owned = at < len(tokens) and tokens[at].text in _OF_THEM
    ends, toward = (*(t.text for t in tokens[at + owned : at + owned + 2]), "", "")[:2]
    if ends not in _TURNED or toward not in _TOWARD:
        return []
    their = tokens[at] if owned else structs.replace(tokens[at], text="their", shown="")
    return [
        structs.replace(tokens[at], text="with", shown=""),
        their,
        structs.replace(tokens[at + owned], text="backs" if ends == "backs" else "head"),
    ]


def _hyphened(tokens: list[Token]) -> list[Token]:
    """Read "a wall mounted shelf" as "a wall-mounted shelf", unless it is followed by where on the wall."""
    for at in range(len(tokens) - 2):
        fixed = tokens[at].text in _PARTS and tokens[at + 1].text in _FIXED and tokens[at + 2].kind == "word"
        if fixed and not grammar().at(tokens, at + 2, "prepositions", "determiners", "count", "vague"):
            tokens[at] = structs.replace(tokens[at], glued=True)
    return tokens


def _is_enough(tokens: Sequence[Token], at: int) -> int:
    """How many words "four is enough" has, which puts a number right that was told before; 0 where it does not come."""
    if not at or not (tokens[at - 1].kind == "mark" or tokens[at - 1].text in _CORRECTING):
        return 0
    number = is_count(tokens, at)
    verb, said = ([token.text for token in tokens[at + 1 : at + 3]] + ["", ""])[:2]
    ends = at + 3 >= len(tokens) or tokens[at + 3].kind == "mark"
    enough = (verb in ("is", "are") and said in ("enough", "plenty")) or (verb == "will" and said == "do")
    return 3 if number and ends and enough else 0


def _is_grid(tokens: Sequence[Token], at: int) -> bool:
    """Whether "4 rows x 6 columns of" comes."""
    words = [token.text for token in tokens[at : at + 6]]
    if words[1:2] != ["rows"] or words[2:3] == [] or words[2] not in _BY or words[4:] != ["columns", "of"]:
        return False
    return all(is_count(tokens, n) for n in (at, at + 3))
