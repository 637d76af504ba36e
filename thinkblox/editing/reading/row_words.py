"""The words of rows as they are read: "the front row", "the first and the last row", "a sixth table"."""

from msgspec import structs

from thinkblox.editing.lengths import is_number
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.tokens import Token


def with_rows(tokens: list[Token]) -> list[Token]:
    """Read "the front row" and "the back row" as the first and the last, and "a round one" as no preposition."""
    words = {"front": "first", "back": "last", "rear": "last", "final": "last"}
    tokens = _one_more(_each_row(tokens))
    read = list(tokens)
    for index, token in enumerate(tokens[:-1]):
        rows = tokens[index + 2].text == "rows" if index + 2 < len(tokens) and is_number(tokens[index + 1]) else False
        if token.text in words and (tokens[index + 1].text == "row" or rows):
            read[index] = structs.replace(token, text=words[token.text])
    for index in range(len(tokens) - 2):
        if tokens[index + 1].text == "round" and tokens[index + 2].text in ("one", "ones"):
            read[index + 1] = structs.replace(tokens[index + 1], text="circular")
        if tokens[index].text in ("a", "an", "another") and tokens[index + 1].text == "lower":
            read[index + 1] = structs.replace(tokens[index + 1], text="lowest")
    return read


def _each_row(tokens: list[Token]) -> list[Token]:
    """The tokens with "row" behind each of two numbers: "the first and the last row", "the front and back rows"."""
    read = list(tokens)
    for at in range(len(tokens) - 4, -1, -1):
        second = at + 2 + (tokens[at + 2].text == "the")
        row = tokens[second + 1] if second + 1 < len(tokens) else None
        if row is None or row.text not in ("row", "rows") or tokens[at + 1].text != "and":
            continue
        if _is_ordinal(tokens[at]) and _is_ordinal(tokens[second]):
            the = tokens[at + 2] if second > at + 2 else Token("the", "the", "word", start=-1)
            read[second + 1] = structs.replace(row, text="row")
            read[at + 1 : second] = [structs.replace(row, text="row", start=-1), tokens[at + 1], the]
    return read


def _one_more(tokens: list[Token]) -> list[Token]:
    """The tokens with "a sixth table" as another one, of which it is not a part."""
    read = list(tokens)
    for at in reversed(range(len(tokens) - 2)):
        counted = tokens[at].text == "a" and _is_ordinal(tokens[at + 1]) and tokens[at + 1].text != "last"
        if counted and tokens[at + 2].kind == "word" and tokens[at + 2].text not in ("of", "one"):
            words = f"{tokens[at].shown} {tokens[at + 1].shown}"
            read[at : at + 2] = [structs.replace(tokens[at], text="another", shown=words)]
    return read


def _is_ordinal(token: Token) -> bool:
    return token.text in ("front", "back", "rear") or grammar().at([token], 0, "ordinal") is not None
