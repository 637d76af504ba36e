"""What an instruction says in other words, put into those that are read; "desk 2" as the object of that number."""

import re
from collections.abc import Collection, Iterable, Sequence

from msgspec import structs

from thinkblox.assets import facts_of
from thinkblox.assets.plurals import singular
from thinkblox.editing.grammar import longest, means
from thinkblox.editing.lengths import DEGREES
from thinkblox.reading.english.grammar import grammar, is_count
from thinkblox.reading.lexicon import Lexicon, load
from thinkblox.reading.sizes import read_size
from thinkblox.reading.tokens import Token, tokenise

_NUMBERED = re.compile(
    r"\b([a-z]+(?:[ -][a-z]+){0,2})\s+(?:no\.?\s*|nr\.?\s*|number\s+|#\s*)?([0-9]{1,3})\b(?![.,]?[0-9])", re.I
)
_NUMBER = re.compile(r" (?:no|nr|number)$", re.I)
_SERIES = re.compile(r"\b([a-z]+s) ([0-9]{1,3}(?:, ?[0-9]{1,3})*,? (?:and|&) [0-9]{1,3})\b(?!\s*[.,]?[0-9])", re.I)
_RANGE = re.compile(r"\b([a-z]+s) ([0-9]{1,3}) ?(?:to|through|-|–) ?([0-9]{1,3})\b(?!\s*[.,]?[0-9])", re.I)
_CONTRACTED = re.compile(r"\b(it|they)['’](?:s|re)\b", re.I)
_BREAKS = (",", ";", ".", "!")
MOST_NAMED = 8
"""Most words of a thing that is to be in between others."""
_ARTICLES = ("the", "my", "our", "your", "this", "that", "each", "every")
_SHARES = (*DEGREES, "%", "percent", "times", "x")
"""After a number that is an angle or a share."""
_AFTER_NAME = ("and", "or", "but", "too", "as", "please", "then", "around", "instead", "is", "should")
"""After somebody's name, where what is theirs is not named: "on the teacher's"."""
_DETERMINERS = ("a", "an", "the", "another", "some", "my", "our", "is", "it")
"""Before a thing of which a size follows: "the table 2 by 1 m", where "from table 2 by 1 m" is by how much."""
_INTO = ("the", "a", "front", "its", "their")
"""After "in" where that is no unit."""


def reworded(tokens: Sequence[Token]) -> list[Token]:
    """The tokens, with what they say in other words put into the words that are read; each keeps how it was written."""
    left: list[Token] = []
    at = 0
    while at < len(tokens):
        found = longest("same", tokens, at)
        if found is None:
            left.append(tokens[at])
            at += 1
            continue
        words, (first, *more) = " ".join(t.shown for t in tokens[at : at + found[1]]), tokenise(found[0])
        left.append(structs.replace(first, shown=words, start=tokens[at].start))
        left += [structs.replace(token, start=-1) for token in more]
        at += found[1]
    return left


def in_between(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "(the armchairs) with the table in between" as "and put the table between them"."""
    left = list(tokens)
    for at in reversed(range(len(tokens) - 1)):
        if (tokens[at].text, tokens[at + 1].text) != ("in", "between"):
            continue
        begin = next((n for n in range(at - 1, max(at - MOST_NAMED, -1), -1) if left[n].text == "with"), None)
        if begin is None or any(left[n].kind == "mark" for n in range(begin, at)):
            continue
        between = [structs.replace(token, start=-1) for token in tokenise("between them")]
        between[0] = structs.replace(
            between[0], shown=f"{tokens[at].shown} {tokens[at + 1].shown}", start=tokens[at].start
        )
        put = Token("put", "put", "word", start=-1)
        left[at : at + 2] = between
        left[begin : begin + 1] = [structs.replace(left[begin], text="and", shown="and"), put]
    return left


_ASIDE = ("behind", "in_front_of", "left_of", "right_of", "next_to", "under", "above")
"""Where something is to be that goes along with another thing."""


def with_new_on_it(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "(put the chair there) with an alarm clock on it" as ", add an alarm clock on it".

    So is "(add an armchair) with a lamp behind it", whatever it goes with; what is on something new is read with that,
    unless it is said before where that goes: "(add a bench by the bed) with a blanket on it".
    """
    left = list(tokens)
    for at in reversed(range(2, len(tokens) - 3)):
        if tokens[at].text != "with" or tokens[at + 1].text not in ("a", "an"):
            continue
        comma, add = Token(",", ",", "mark", start=-1), Token("add", "add", "word", start=tokens[at].start)
        added = [comma, structs.replace(add, shown=tokens[at].shown)]
        if _is_beside_it(tokens, at):
            for sides in (n + 3 for n in range(at, min(at + MOST_NAMED, len(tokens))) if _is_at_sides(tokens, n)):
                left[sides:sides] = [Token(word, word, "word", start=-1) for word in ("of", "it")]
            left[at : at + 1] = added
            continue
        end = next((n for n in range(at + 2, min(at + MOST_NAMED, len(tokens))) if tokens[n].kind == "mark"), None)
        end = min(at + MOST_NAMED, len(tokens)) if end is None else end
        on_it = [token.text for token in tokens[end - 2 : end]] in (["on", "it"], ["on", "them"])
        begin = next((n + 1 for n in range(at - 2, -1, -1) if tokens[n].kind == "mark"), 0)
        said = ((n, longest("verbs", tokens, n)) for n in range(begin, at))
        verbs = [(n + found[1], found[0]) for n, found in said if found is not None]
        after = [tokens[n].text for n, doing in verbs if doing in ("put", "move")]
        known = any(word in ("the", "my", "both", "it", "them") for word in after)
        has_place = verbs and any(grammar().at(tokens, n, "prepositions") is not None for n in range(verbs[-1][0], at))
        links = [n for n in range(at, end) if tokens[n].text in ("and", ",")]
        links += [at] if links else []
        if on_it and (known or (has_place and all(_is_small(tokens, n + 1) for n in links))):
            left[at : at + 1] = added
    return left


def _is_small(tokens: Sequence[Token], at: int) -> bool:
    """Whether something small is named there: "a book"."""
    at += at < len(tokens) and tokens[at].text in ("a", "an", "some", "two", "three")
    thing = load("en").longest(list(tokens), at).entry("object") if at < len(tokens) else None
    return thing is not None and facts_of(thing.value).is_in("small")


def _is_at_sides(tokens: Sequence[Token], at: int) -> bool:
    """Whether "on either side", of nothing that is named, stands there at the end of what is said."""
    words = [token.text for token in tokens[at : at + 3]]
    sides = (
        words[:1] == ["on"] and words[1:2] in (["either"], ["each"], ["both"]) and words[2:] in (["side"], ["sides"])
    )
    return sides and (at + 3 == len(tokens) or tokens[at + 3].kind == "mark")


def _is_beside_it(tokens: Sequence[Token], at: int) -> bool:
    """Whether a phrase with something new says at which side of "it" that is to be: "with a lamp behind it".

    What it goes with has a place of its own before that: of "put a stool with a pillow beside it" that is the stool's.
    """
    begin = next((n for n in range(at - 1, -1, -1) if longest("verbs", tokens, n) is not None), 0)
    if not any(grammar().at(tokens, n, "prepositions") or tokens[n].text == "there" for n in range(begin, at)):
        return False
    for n in range(at + 2, min(at + MOST_NAMED, len(tokens) - 1)):
        if _is_at_sides(tokens, n):
            return True
        found = grammar().at(tokens, n, "prepositions")
        if tokens[n].kind == "mark" or (found is not None and found.value not in _ASIDE):
            return False
        if found is not None:
            after = n + found.length
            ends = after + 1 == len(tokens) or tokens[after + 1 : after + 2][0].kind == "mark"
            return after < len(tokens) and tokens[after].text == "it" and ends
    return False


_LARGE = ("big", "large", "wide", "long")
_HOLDING = ("for", "to hold", "to fit", "to take", "to fit under", "to cover", "to go under", "to reach under")


def with_borne(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "(a rug) big enough for the chairs" as "; make it bigger so that the chairs are on it"."""
    left = list(tokens)
    for at in reversed(range(2, len(tokens) - 3)):
        if tokens[at].text != "enough" or tokens[at - 1].text not in _LARGE:
            continue
        said = " ".join(token.text for token in tokens[at + 1 : at + 4])
        held = next((words for words in _HOLDING[::-1] if f"{said} ".startswith(f"{words} ")), "")
        begin = at - 3 if [t.text for t in tokens[at - 3 : at - 1]] in (["that", "is"], ["which", "is"]) else at - 1
        verb = next((n for n in range(begin - 1, -1, -1) if longest("verbs", tokens, n) is not None), None)
        rug = verb is not None and any(_lies_flat(tokens, n) for n in range(verb + 1, begin))
        after = at + 1 + len(held.split())
        end = next((n for n in range(after, len(tokens)) if tokens[n].kind == "mark"), len(tokens))
        if not held or not rug or after >= end or tokens[after].text not in (*_ARTICLES, "all", "both"):
            continue
        makes = [structs.replace(token, start=-1) for token in tokenise("; make it bigger so that")]
        shown = " ".join(token.shown for token in tokens[begin:after])
        makes[1] = structs.replace(makes[1], shown=shown, start=tokens[begin].start)
        ends = [structs.replace(token, start=-1) for token in tokenise("are on it")]
        left[begin:end] = [*makes, *tokens[after:end], *ends]
    return left


def _lies_flat(tokens: Sequence[Token], at: int) -> bool:
    """Whether something is named there that lies flat on the floor: "a rug"."""
    thing = load("en").longest(list(tokens), at).entry("object")
    return thing is not None and facts_of(thing.value).is_in("covers")


def counted_to(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "reduce the number of chairs (from eight) to six" as "there should only be six chairs"."""
    tokens = _too_many(tokens)
    begin = next((n for n, token in enumerate(tokens) if means("counting", token.text)), None)
    end = next((n for n in range(begin or 0, len(tokens)) if tokens[n].kind == "mark"), len(tokens))
    to = next((n for n in range(begin or 0, end) if tokens[n].text == "to"), end)
    said = [token.text for token in tokens[(begin or 0) + 1 : to]]
    counted = to + 2 == end and is_count(tokens, to + 1)
    if begin is None or not counted or said[:1] not in (["the"], ["my"], ["our"]):
        return list(tokens)
    first = begin + (4 if said[1:3] == ["number", "of"] else 2)
    last = next((n for n in range(first, to) if tokens[n].text in ("from", "down", "up")), to)
    first += tokens[first].text == "the"
    there = [structs.replace(token, start=-1) for token in tokenise("there should only be")]
    there[0] = structs.replace(
        there[0], shown=" ".join(t.shown for t in tokens[begin:first]), start=tokens[begin].start
    )
    number = [structs.replace(tokens[to + 1], start=tokens[to + 1].start)]
    return [*tokens[:begin], *there, *number, *tokens[first:last], *tokens[end:]] if first < last else list(tokens)


def _too_many(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "there are too many chairs, four are enough" as "reduce the chairs to four"."""
    at = next((n for n in range(1, len(tokens)) if (tokens[n - 1].text, tokens[n].text) == ("too", "many")), None)
    end = next((n for n in range(at or 0, len(tokens)) if tokens[n].kind == "mark"), len(tokens))
    if at is None or end + 2 >= len(tokens) or tokens[0].text not in ("there", "we", "i"):
        return list(tokens)
    found = longest("wishes", tokens, end + 2)
    counted = is_count(tokens, end + 1)
    if found is None or found[0] != "only" or not counted:
        return list(tokens)
    first, the, to = (Token(word, word, "word", start=-1) for word in ("reduce", "the", "to"))
    first = structs.replace(first, shown=" ".join(t.shown for t in tokens[: at + 1]), start=tokens[0].start)
    return [first, the, *tokens[at + 1 : end], to, tokens[end + 1], *tokens[end + 2 + found[1] :]]


def with_its_wall(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "the TV wall" as "the wall with the TV"."""
    left = list(tokens)
    for at in reversed(range(2, len(tokens))):
        begin = next((n for n in range(at - 1, max(at - 4, -1), -1) if tokens[n].text in _ARTICLES), None)
        named = lexicon.longest(list(tokens[:at]), begin + 1) if begin is not None and begin + 1 < at else None
        whole = named is not None and named.entry("object") is not None and begin is not None
        if tokens[at].text != "wall" or begin is None or named is None or not whole or begin + 1 + named.length != at:
            continue
        the, wall, along = (Token(word, word, "word", start=-1) for word in ("the", "wall", "with"))
        shown = " ".join(token.shown for token in tokens[begin : at + 1])
        wall = structs.replace(wall, shown=shown, start=tokens[begin].start)
        left[begin : at + 1] = [the, wall, along, the, *(structs.replace(t, start=-1) for t in tokens[begin + 1 : at])]
    return left


def in_its_place(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "instead of it (I want a bench)", behind another sentence, as "in its place".

    "Instead of under the bed", where something is not to be, is ", not under the bed".
    """
    left = list(tokens)
    for at in reversed(range(2, len(tokens) - 2)):
        link = grammar().at(tokens, at + 2, "prepositions")
        if tokens[at].text == "instead" and tokens[at + 1].text == "of" and link is not None and link.value != "of":
            comma, no = Token(",", ",", "mark", start=-1), Token("not", "not", "word", start=-1)
            left[at : at + 2] = [comma, structs.replace(no, shown="instead of", start=tokens[at].start)]
    tokens = list(left)
    for at in reversed(range(2, len(tokens) - 2)):
        words = [token.text for token in tokens[at : at + 3]]
        its = {"it": "its", "them": "their"}.get(words[2], "")
        if words[:2] == ["instead", "of"] and its and tokens[at - 1].text in (*_BREAKS, "and"):
            place = [structs.replace(token, start=-1) for token in tokenise(f"in {its} place")]
            place[0] = structs.replace(
                place[0], shown=" ".join(t.shown for t in tokens[at : at + 3]), start=tokens[at].start
            )
            left[at : at + 3] = place
    return left


def without_rather_than(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "(I'd rather have the bench here) than there" left out, and "than a sofa" as "instead of"."""
    at = next((n for n, token in enumerate(tokens) if token.text == "than" and n + 1 < len(tokens)), None)
    if at is None or not any(token.text in ("rather", "prefer", "sooner") for token in tokens[:at]):
        return list(tokens)
    end = next((n for n in range(at, len(tokens)) if tokens[n].text in _BREAKS), len(tokens))
    if grammar().at(tokens, at + 1, "prepositions") is not None or tokens[at + 1].text in ("where", "here", "there"):
        return [*tokens[:at], *tokens[end:]]
    if tokens[at + 1].text not in ("a", "an", *_ARTICLES):
        return list(tokens)
    the = Token("the", "the", "word", start=-1)
    instead = [structs.replace(tokens[at], text="instead"), Token("of", "of", "word", start=-1), the]
    return [*tokens[:at], *instead, *tokens[at + 2 :]]


def something_instead(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "no lamp; two candles instead" as "remove the lamp; add two candles"."""
    if len(tokens) < 3 or tokens[0].text != "no" or tokens[1].kind != "word" or longest("fillers", tokens, 0):
        return list(tokens)
    end = next((n for n, token in enumerate(tokens) if token.text in _BREAKS), len(tokens))
    later = next((n for n in range(end + 1, len(tokens)) if tokens[n].text == "instead"), None)
    verbs = any(longest("verbs", tokens, n) is not None for n in (1, min(end + 1, len(tokens) - 1)))
    if verbs or later is None:
        return list(tokens)
    remove, the, add = (Token(word, word, "word", start=-1) for word in ("remove", "the", "add"))
    first = [structs.replace(remove, shown=tokens[0].shown, start=tokens[0].start), the, *tokens[1:end]]
    return [*first, structs.replace(tokens[end], text=";"), add, *tokens[end + 1 : later], *tokens[later + 1 :]]


def with_owners(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "the left nightstand's lamp" as "the lamp of the left nightstand"."""
    left = list(tokens)
    for at in reversed(range(len(tokens) - 1)):
        begin = next((n for n in range(at - 1, max(at - 4, -1), -1) if left[n].text in _ARTICLES), None)
        if not left[at].owner or begin is None or not _is_thing(lexicon, left, at):
            continue
        named = lexicon.longest(left, at + 1)
        if named.entry("object") is None or grammar().at(left, at + 1, "parts") is not None:
            continue
        end = at + 1 + named.length
        one = singular(left[at].text)
        whole = [*left[begin:at], structs.replace(left[at], owner=False, text=one, shown=one)]
        the = Token("the", "the", "word", start=-1)
        left[begin:end] = [the, *left[at + 1 : end], Token("of", "of", "word", start=-1), *whole]
    return left


def with_heads(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "(on every student desk and) on the teacher's" as "on the teacher's desk".

    What is said to be somebody's is such a thing as was named last behind the same preposition, or last of all.
    """
    left = list(tokens)
    for at in reversed(range(1, len(tokens))):
        after = tokens[at + 1] if at + 1 < len(tokens) else None
        alone = after is None or after.kind == "mark" or after.text in _AFTER_NAME
        alone = alone or grammar().at(tokens, at + 1, "prepositions") is not None
        if not tokens[at].owner or not alone or tokens[at - 1].text not in _ARTICLES:
            continue
        link = tokens[at - 2].text if at > 1 and grammar().at(tokens, at - 2, "prepositions") is not None else ""
        begun = [n for n in range(at - 2) if tokens[n].text == link] if link else []
        head = _first_thing(lexicon, tokens[begun[-1] : at - 2]) if begun else _last_thing(lexicon, tokens[: at - 1])
        if head is not None:
            left.insert(at + 1, structs.replace(head, text=singular(head.text), owner=False, start=-1))
    return left


def with_own(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "(a second desk next to) mine" as "the desk": of such as the sentence is about.

    So is "one" of "(replace the table with) a round one for six", which is told by how many sit at it.
    """
    left = list(tokens)
    for at in reversed(range(1, len(tokens))):
        if tokens[at].text == "one" and _is_for_many(tokens, at + 1):
            head = _last_thing(lexicon, tokens[:at])
            name = singular(head.text) if head is not None else tokens[at].text
            left[at] = structs.replace(tokens[at], text=name, shown=name)
            continue
        if tokens[at].text not in ("mine", "ours", "yours"):
            continue
        begin = next((n + 1 for n in range(at - 1, -1, -1) if tokens[n].text in (".", ";", "!", "?")), 0)
        if (head := _first_thing(lexicon, tokens[begin:at])) is not None:
            the = structs.replace(tokens[at], text="the")
            left[at : at + 1] = [the, structs.replace(head, text=singular(head.text), start=-1)]
    return left


def _is_for_many(tokens: Sequence[Token], at: int) -> bool:
    """Whether it goes on with for how many people something is: "for six", "that seats six"."""
    same = longest("same", tokens, at)
    seats = same is not None and same[0] == "for"
    after = at + (same[1] if same is not None and seats else 1)
    begun = seats or (at < len(tokens) and tokens[at].text == "for")
    counted = after < len(tokens) and grammar().at(tokens, after, "count") is not None
    return begun and (counted or (after < len(tokens) and tokens[after].kind == "number"))


def _first_thing(lexicon: Lexicon, tokens: Sequence[Token]) -> Token | None:
    """The last word of the first name of a thing."""
    for at in range(len(tokens)):
        found = lexicon.longest(list(tokens), at)
        if found.entry("object") is not None:
            return tokens[at + found.length - 1]
    return None


def _last_thing(lexicon: Lexicon, tokens: Sequence[Token]) -> Token | None:
    """The last word of the last name of a thing."""
    found = (_first_thing(lexicon, tokens[at:]) for at in range(len(tokens) - 1, -1, -1))
    return next((token for token in found if token is not None), None)


def _is_thing(lexicon: Lexicon, tokens: Sequence[Token], at: int) -> bool:
    """Whether a thing of the catalogue is named by the tokens that end there."""
    token = structs.replace(tokens[at], owner=False)
    return any(
        (found := lexicon.longest([*tokens[begin:at], token], 0)).entry("object") is not None
        and found.length == at + 1 - begin
        for begin in range(max(0, at - 2), at + 1)
    )


def uncontracted(text: str) -> str:
    """The text with "it's" and "they're" in full, which are told from "its" and "there" by that alone."""
    return _CONTRACTED.sub(lambda found: f"{found[1]} {'is' if found[1].lower() == 'it' else 'are'}", text)


def with_ids(lexicon: Lexicon, text: str, ids: Collection[str]) -> str:
    """The text with "desk 2" and "desk number 2" as the id of that object, where there is one.

    Args:
        lexicon: of its language, by which the words for a kind are known.
        text: the instruction.
        ids: of the objects that are there.
    """
    text = _RANGE.sub(lambda found: _each_numbered(lexicon, found, range(int(found[2]), int(found[3]) + 1), ids), text)
    text = _SERIES.sub(lambda found: _each_numbered(lexicon, found, re.findall(r"[0-9]+", found[2]), ids), text)
    written, end = "", 0
    for match in _NUMBERED.finditer(text):
        after = tokenise(text[match.start(2) :])
        pointed = bool({*text[: match.end(1)].lower().split()[-3:]} & {*_DETERMINERS})
        by_much = not pointed and [token.text for token in after[1:2]] == ["by"]
        if match.start() < end or (not by_much and _is_amount(lexicon, after)):
            continue
        words = re.split(r"[ -]", _NUMBER.sub("", match[1]))
        for count in range(len(words)):
            name = " ".join(words[count:])
            id = _id(_kinds(lexicon, name), match[2], ids)
            if id:
                begin = match.start() + len(" ".join(words)) - len(name)
                written += text[end:begin] + id
                end = match.end()
                break
    return written + text[end:]


def _each_numbered(lexicon: Lexicon, found: re.Match[str], numbers: Iterable[int | str], ids: Collection[str]) -> str:
    """What "desks 1, 2 and 3", "desks 1 to 3" are as the ids of these; as it was where one of them is not there."""
    kinds = [*_kinds(lexicon, singular(found[1].lower())), singular(found[1].lower())]
    named = [_id(kinds, str(number), ids) for number in numbers]
    return f"{', '.join(named[:-1])} and {named[-1]}" if len(named) > 1 and all(named) else found[0]


def _is_amount(lexicon: Lexicon, tokens: Sequence[Token]) -> bool:
    """Whether the number that comes first says how much or how many: "2 m", "2 by 1 m", "90 degrees", "4 plates"."""
    after = [token.text for token in tokens[1:3]]
    if after[:1] == ["in"]:
        return after[1:] == [] or after[1] not in _INTO
    named = lexicon.longest(list(tokens), 1).entry("object") if after else None
    size = read_size(lexicon, list(tokens), 0)
    measured = size is not None and tokens[size[1] - 1].kind != "number"
    return measured or (bool(after) and after[0] in _SHARES) or (named is not None and named.plural)


def _id(kinds: Sequence[str], number: str, ids: Collection[str]) -> str:
    """The object of one of these kinds with that number; of "chair 2" also the only office chair with it."""
    for kind in kinds:
        if (id := f"{kind}_{number}") in ids:
            return id
    like = [id for id in ids for kind in kinds[:1] if id.endswith(f"_{kind}_{number}")]
    return like[0] if len(like) == 1 else ""


def _kinds(lexicon: Lexicon, name: str) -> list[str]:
    """The categories that words name, and the words themselves."""
    tokens = list(lexicon.tokens(name))
    found = lexicon.longest(tokens, 0)
    named = [entry.value for entry in found.entries if entry.sort == "object"] if found.length == len(tokens) else []
    return [name.lower().replace(" ", "_"), *named]


def without_commas(tokens: list[Token]) -> list[Token]:
    """The tokens with no comma between two adjectives: "a bigger, round one"."""
    return [token for at, token in enumerate(tokens) if not (token.text == "," and _is_of_adjectives(tokens, at))]


def _is_of_adjectives(tokens: Sequence[Token], at: int) -> bool:
    if at < 2 or at + 2 > len(tokens):
        return False
    adjective = means("comparatives", tokens[at - 1].text) or means("sizes", tokens[at - 1].text)
    begun = tokens[at - 2].text in ("a", "an", "the", "another", "some")
    return bool(adjective) and begun and tokens[at + 1].kind == "word" and tokens[at + 1].text not in ("and", "please")


def included(tokens: list[Token]) -> list[Token]:
    """The tokens, where "turn the table, chairs included" says that it is turned with its chairs."""
    read = list(tokens)
    for at in reversed([n for n, token in enumerate(tokens) if means("included", token.text) or _is_too(tokens, n)]):
        comma = next((n for n in range(at - 1, max(at - 4, 0), -1) if read[n].text == ","), None)
        if comma is not None and comma < at - 1:
            own = () if read[comma + 1].text in ("the", "its", "their") else tokenise("its")
            said = [structs.replace(token, start=-1) for token in (*tokenise("with"), *own)]
            read[comma : at + 1] = [*said, *read[comma + 1 : at]]
    return read


def _is_too(tokens: Sequence[Token], at: int) -> bool:
    """Whether it is that of ", chairs too": a bare word between a comma and it."""
    return (
        tokens[at].text == "too"
        and at > 1
        and tokens[at - 2].text == ","
        and tokens[at - 1].text not in ("it", "them", "this", "that", "these", "those")
    )
