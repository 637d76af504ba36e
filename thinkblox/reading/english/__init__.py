"""English, read with an open vocabulary: noun phrases, clauses, what they refer to, and what became of every word."""

import re
import unicodedata
from collections.abc import Iterator, Sequence

from msgspec import structs

from thinkblox.reading.draft import Draft
from thinkblox.reading.english.abilities import with_abilities
from thinkblox.reading.english.all_alike import with_all_alike
from thinkblox.reading.english.all_but import with_all_but
from thinkblox.reading.english.all_there_is import with_all_there_is
from thinkblox.reading.english.also_there import with_also_there
from thinkblox.reading.english.answers import with_answers
from thinkblox.reading.english.apposed import with_apposed
from thinkblox.reading.english.as_many import with_as_many
from thinkblox.reading.english.asides import with_asides
from thinkblox.reading.english.assortments import with_assortments
from thinkblox.reading.english.bare_fronts import with_bare_fronts
from thinkblox.reading.english.bare_places import with_bare_places
from thinkblox.reading.english.belongings import with_belongings
from thinkblox.reading.english.booths import with_booths
from thinkblox.reading.english.broken_off import with_broken_off
from thinkblox.reading.english.carrying import with_carrying
from thinkblox.reading.english.centring import with_centres
from thinkblox.reading.english.chunker import cut
from thinkblox.reading.english.clauses import Clauses
from thinkblox.reading.english.collectives import with_collectives
from thinkblox.reading.english.colours_meant import with_colours_meant
from thinkblox.reading.english.counted_after import with_counts_after
from thinkblox.reading.english.counted_rooms import with_furniture
from thinkblox.reading.english.counted_rows import with_counted_rows
from thinkblox.reading.english.denials import with_denials
from thinkblox.reading.english.denied_lists import with_denied_lists
from thinkblox.reading.english.denied_places import with_denied_places
from thinkblox.reading.english.dimensions import with_plain_sizes
from thinkblox.reading.english.doings import with_doings
from thinkblox.reading.english.each_of_which import with_each_of_which
from thinkblox.reading.english.each_side_having import with_each_side_having
from thinkblox.reading.english.elisions import with_counts, with_nouns
from thinkblox.reading.english.facing_people import with_facing_people
from thinkblox.reading.english.familiar import known_share
from thinkblox.reading.english.fronted import with_fronted
from thinkblox.reading.english.gapped import with_gapped
from thinkblox.reading.english.goals import with_goals
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.grids import with_grids
from thinkblox.reading.english.halves import with_halves
from thinkblox.reading.english.holders import with_holders
from thinkblox.reading.english.idioms import plainly
from thinkblox.reading.english.in_room import with_room_meant, with_rooms_parts
from thinkblox.reading.english.kept_clear import with_kept_clear
from thinkblox.reading.english.keyed import with_keyed
from thinkblox.reading.english.labels import with_labels
from thinkblox.reading.english.laid import with_laid
from thinkblox.reading.english.likenesses import with_likenesses
from thinkblox.reading.english.likings import with_likings
from thinkblox.reading.english.lists_for_each import with_lists_for_each
from thinkblox.reading.english.moods_told import with_moods_told
from thinkblox.reading.english.moved_parts import with_moved_parts
from thinkblox.reading.english.next_things import with_next_things
from thinkblox.reading.english.none_of import with_none_of
from thinkblox.reading.english.nothing_else import with_nothing_else
from thinkblox.reading.english.noughts import with_noughts
from thinkblox.reading.english.on_it_first import with_on_it_last
from thinkblox.reading.english.one_by_one import join_one_by_one
from thinkblox.reading.english.one_each_side import with_one_each_side
from thinkblox.reading.english.one_more import with_one_more
from thinkblox.reading.english.ones_apart import with_ones_apart
from thinkblox.reading.english.opening_places import with_opening_places
from thinkblox.reading.english.openings_meant import with_openings_meant
from thinkblox.reading.english.orders_not import with_orders_not
from thinkblox.reading.english.others import with_others
from thinkblox.reading.english.outside import with_outside
from thinkblox.reading.english.own_places import with_own_places
from thinkblox.reading.english.part_subjects import with_part_subjects
from thinkblox.reading.english.parts_of import with_wholes
from thinkblox.reading.english.passing import with_owners, with_passing
from thinkblox.reading.english.people_doing import with_people_doing
from thinkblox.reading.english.per_people import with_lists_per_person
from thinkblox.reading.english.persons_places import with_persons_places
from thinkblox.reading.english.pictured import with_pictured
from thinkblox.reading.english.place_settings import with_place_settings
from thinkblox.reading.english.places_having import with_places_having
from thinkblox.reading.english.plain_turns import with_plain_turns, without_not_followed
from thinkblox.reading.english.potted import with_potted
from thinkblox.reading.english.reasons import with_reasons
from thinkblox.reading.english.respectively import with_respective
from thinkblox.reading.english.rewording import reworded
from thinkblox.reading.english.room_sides import with_room_sides
from thinkblox.reading.english.rooms_having import with_rooms_having
from thinkblox.reading.english.roughly import with_rough
from thinkblox.reading.english.seats_joined import with_seats_joined
from thinkblox.reading.english.serial_commas import with_clause_commas, with_serial_commas
from thinkblox.reading.english.several_anchors import with_several_anchors
from thinkblox.reading.english.shared_openings import with_shared_openings
from thinkblox.reading.english.shared_out import with_shared_out
from thinkblox.reading.english.shared_rooms import with_parts
from thinkblox.reading.english.shares_told import with_shares
from thinkblox.reading.english.short_names import with_short_names
from thinkblox.reading.english.slips import meant_by
from thinkblox.reading.english.some_carriers import with_some_carriers
from thinkblox.reading.english.some_told import with_some_told
from thinkblox.reading.english.stacked_pairs import with_stacked_pairs
from thinkblox.reading.english.switched import with_switched
from thinkblox.reading.english.tasks import with_tasks
from thinkblox.reading.english.things_between import with_things_between
from thinkblox.reading.english.this_named import with_this_named
from thinkblox.reading.english.told_apart import with_told_apart
from thinkblox.reading.english.told_besides import with_told_besides
from thinkblox.reading.english.told_later import with_told_later
from thinkblox.reading.english.top_sides import with_top_sides
from thinkblox.reading.english.totals import with_totals
from thinkblox.reading.english.towns import with_towns
from thinkblox.reading.english.two_colours import with_two_colours
from thinkblox.reading.english.two_places import with_two_places
from thinkblox.reading.english.ways import with_ways
from thinkblox.reading.english.where_told import with_lists_there, with_where_told
from thinkblox.reading.english.written_lines import with_lines
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

__all__ = ["known_share", "read_english"]
_POINTS = re.compile(r"\b(?:i\.e\.|e\.g\.|etc\.|approx\.|incl\.|ca\.|resp\.|vs\.|max\.|min\.)", re.IGNORECASE)
"""Abbreviations whose points end no sentence."""
_HALF = re.compile(r"\bhalf an?(?= (?:met(?:re|er)|foot|inch|yard)\b)", re.IGNORECASE)
"""Half of a unit of length, which is a number."""
_LABEL = re.compile(
    r"^\s*(?:(?:(?:room|scene|interior|layout) )?(?:description|prompt|request|brief|spec|specification):|"
    r"(?:(?:please|kindly|can you|could you|hi|hello)[,:]? )*"
    r"(?:create|generate|design|make|build|furnish|lay out|set up|render|produce|model|arrange)(?: me| us)? "
    r"(?:this|the following|such a|the described|the below)(?: (?:3d|indoor))? "
    r"(?:room|scene|space|layout|interior|environment)(?:,? please| for me| for us)?[.!:?]|"
    r"(?:i|we)(?:'d| would)? (?:like|want|need)(?: to have)? the following(?: room| scene| layout)?[.:]) ",
    re.IGNORECASE,
)
"""What a text is, or that it is wanted, said before it."""
_SPACES = re.compile(r"[ \t\u00a0]+(?=[ \t\u00a0,;.:!?)])|(?<=\n)[ \t\u00a0]+")
_PLAIN = str.maketrans({"\u2019": "'", "\u2018": "'", "\u02bc": "'", "\u201c": '"', "\u201d": '"'})
_TIMES = re.compile(r"(?<=\()(?:[x\u00d7] ?\d{1,3}|\d{1,3} ?[x\u00d7])(?=\s*[,);])", re.IGNORECASE)
"""How many there are, in brackets after a thing: "(x2)", "(2x, around the table)"."""
_AND_HALF = re.compile(
    r"\b(\d+|one|two|three|four|five|six|seven|eight|nine|ten) and a half"
    r"(?= ?(?:m|met(?:re|er)s?|cm|centimet(?:re|er)s?|f(?:oo|ee)t|ft|inch(?:es)?|yards?|by|x|times)\b)|"
    r"(?<=(?:es|rs|et|ft| m) by )(\d+|one|two|three|four|five|six|seven|eight|nine|ten) and a half\b",
    re.IGNORECASE,
)
"""So many and half of a unit of length."""
_TO_TEN = ("", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
_ONE = re.compile(
    r"\ban?(?= (?:met(?:re|er)|foot|yard) (?:away|apart|from|in front|behind|above|below|off)\b)", re.IGNORECASE
)
"""One of a unit of length where it says how far off something is."""
_WITHIN = re.compile(
    r"\bwithin (?:about |around |roughly )?(\d+(?:[.,]\d+)?|an?|half an?|one|two) ?"
    r"(m|met(?:re|er)s?|cm|centimet(?:re|er)s?|f(?:oo|ee)t|ft|steps?)(?: and a half)? (?:of|from)\b",
    re.IGNORECASE,
)
"""How far something is at most from another thing."""
_NEIGHBOUR = re.compile(
    r"\bits (?:next-door |nearest |closest |immediate )?neighbou?r (is|being|will be)\b", re.IGNORECASE
)
"""What stands next to what was spoken of."""
_IMAGINED = re.compile(
    r"(?:^|(?<=[.!?\n] )|(?<=\n)|(?<=\bso )|(?<=\bnow )|(?<=\bjust )|(?<=\bplease )|(?<=, ))"
    r"(?:picture|envision|visuali[sz]e|conjure up|think of)(?= (?:an?|the|my|our|this)\b)",
    re.IGNORECASE,
)
"""An order to imagine what comes."""
_WHOSE = re.compile(
    r"\bwhose (head|headboard|back|front) (?:is|stands)"
    r"(?: (?:placed|positioned|situated|located|set|pushed))?(?: (?:right )?up)?(?= (?:against|to)\b)",
    re.IGNORECASE,
)
"""How a thing stands, told of a part of it."""
_FROM = re.compile(
    r"\b(in front|to the left|to the right|on top) from(?= (?:an?|the|its?|my|our|this)\b)", re.IGNORECASE
)
"""What others say for "in front of"."""
_ONE_OTHER = re.compile(
    r"(?<=s) (one (?:above|on top of|over|under|below|beneath|next to|beside|behind|in front of|on) "
    r"(?:the other|another)\b)(?: (?=(?:on|in|at|against|along|by|near|over|above|opposite) (?:the|an?|my|our)\b))?",
    re.IGNORECASE,
)
"""Where commas are left out around words that tell of two how one stands to the other."""
_TO_CEILING = re.compile(
    r"\b(?:(reach|go|rise|extend|stretch|run|tower)(es|s|ing)? (?:(?:all|right|straight|nearly|almost) )?(?:the way )?"
    r"(?:up )?(?:to )?|(?:(?:all|right|straight|nearly|almost) )?(?:the way )?up to )the (?:ceiling|roof|rafters)\b",
    re.IGNORECASE,
)
"""What is as tall as its room."""
_METRES = {"m": 1.0, "c": 0.01, "f": 0.3, "s": 0.7}
"""Lengths by the first letters of their units [m]."""
_NEAR, _BESIDE = 1.0, 0.5
"""What is at most so far off is near something, or beside it [m]; what is said to be nearer still is not understood."""
_SHORT = {"w": "with", "teh": "the", "n": "and", "pls": "please", "plz": "please"}
_SHORT |= {"evrywhere": "everywhere", "coffe": "coffee"}
_YET = ("still", "already", "now", "always", "just", "also", "only")
"""Adverbs between "'s" and what it says."""
_JOINED = ("its", "thats", "hes", "shes", "whats", "heres")
"""Words with "is" joined to them by an apostrophe."""
_ONES = ("ones", "others", "thirds")
_ARE = ("theyre", "youre")
"""The same with "are"."""
_SHARED = ("theyd", "theyll", "theyve")
"""What says after a thing whom it is for: "the wardrobe they'd share"."""

_FIGURES = range(2, len(_TO_TEN))
_BEFORE_FIGURES, _AFTER_FIGURES = ("the", "all", "these", "those", "other"), ("poster", "seater", "seat")
"""Words before figures that stand for a number word, and after figures that are part of a name."""

_BY_UNITS = ("mx", "cmx", "ftx")
"""Units with the "x" of "3mx4m"."""


def read_english(lexicon: Lexicon, text: str) -> Draft:
    """What an English text asks for, before counts and general words are settled."""
    written, (text, places) = text, _evened(with_lines(unicodedata.normalize("NFC", text)))
    text = _POINTS.sub(lambda match: match[0].replace(".", " "), text)
    text = _LABEL.sub(lambda match: "\n".rjust(len(match[0])), text)
    text = _WITHIN.sub(lambda match: _within(match).ljust(len(match[0])), text)
    text = _NEIGHBOUR.sub(lambda match: f"next to it {match[1]}".ljust(len(match[0])), text)
    text = _WHOSE.sub(lambda match: f"with its {match[1]}".ljust(len(match[0])), text)
    text = _FROM.sub(lambda match: f"{match[1]} of".ljust(len(match[0])), text)
    text = _ONE_OTHER.sub(lambda match: f",{match[1]}".ljust(len(match[0]), ","), text)
    text, told = without_not_followed(text)
    text = with_shares(with_plain_turns(text))
    text = _TO_CEILING.sub(lambda match: _full_height(match).ljust(len(match[0])), text)
    text = _IMAGINED.sub(lambda match: "show".ljust(len(match[0])), text)
    text = _ONE.sub(lambda match: "1".ljust(len(match[0])), text)
    text = _TIMES.sub(lambda match: re.sub(r"\D", " ", match[0]), text)
    text = _AND_HALF.sub(lambda match: _and_half((match[1] or match[2]).lower()).ljust(len(match[0])), text)
    text = _HALF.sub(lambda match: "0.5".ljust(len(match[0])), text)
    tokens = [structs.replace(token, start=places[token.start]) for token in lexicon.tokens(text)]
    tokens = with_plain_sizes(lexicon, with_grids(_spelt_out(tokens)))
    tokens = reworded(plainly(with_abilities(with_owners(with_parts(with_labels(tokens))))))
    meant = [meant_by(lexicon, token.text) if token.kind == "word" else "" for token in tokens]
    tokens = [structs.replace(token, text=word) if word else token for token, word in zip(tokens, meant, strict=True)]
    spelt = [structs.replace(token, shown=word) if word else token for token, word in zip(tokens, meant, strict=True)]
    chunks, noted = cut(lexicon, spelt)
    for rewritten in (
        with_serial_commas,
        with_clause_commas,
        with_rooms_parts,
        with_room_meant,
        with_where_told,
        with_each_side_having,
        with_lists_there,
        with_broken_off,
        with_this_named,
        with_short_names,
        with_people_doing,
        with_denied_lists,
        with_on_it_last,
        with_totals,
        with_orders_not,
        with_likenesses,
        with_likings,
        with_lists_per_person,
        with_lists_for_each,
        with_outside,
        with_colours_meant,
        with_two_colours,
        with_as_many,
        with_towns,
        with_gapped,
        with_shared_out,
        with_none_of,
        with_counts_after,
        with_one_more,
        with_pictured,
        with_respective,
        with_collectives,
        with_told_apart,
        with_carrying,
        with_moods_told,
        with_told_besides,
        with_some_told,
        with_also_there,
        with_some_carriers,
        with_one_each_side,
        with_two_places,
        with_fronted,
        with_rooms_having,
        with_room_sides,
        with_shared_openings,
        with_opening_places,
        with_moved_parts,
        with_part_subjects,
        with_own_places,
        with_ways,
        with_each_of_which,
        with_next_things,
        with_keyed,
        with_apposed,
        with_place_settings,
        with_persons_places,
        with_things_between,
        with_ones_apart,
        with_wholes,
        with_facing_people,
        with_told_later,
        with_seats_joined,
        with_potted,
        with_goals,
        with_tasks,
        with_rough,
        with_halves,
        with_all_but,
        with_all_alike,
        with_holders,
        with_passing,
        with_belongings,
        with_bare_fronts,
        with_openings_meant,
        with_denied_places,
        with_kept_clear,
        with_switched,
        with_places_having,
        with_top_sides,
        with_bare_places,
        with_stacked_pairs,
        with_noughts,
        with_nothing_else,
        with_all_there_is,
        with_counted_rows,
        with_reasons,
        with_assortments,
        with_booths,
        with_laid,
        with_doings,
        with_others,
        with_denials,
        with_nouns,
        with_several_anchors,
        with_counts,
        with_asides,
        with_answers,
        with_furniture,
        with_centres,
    ):
        chunks = rewritten(chunks)
    clauses = Clauses(tokens, chunks)
    draft = clauses.read()
    join_one_by_one(draft, chunks, clauses.meant)
    draft.surfaces += noted
    draft.unknown += told
    draft.written, draft.told = written, told
    draft.unknown += [f"{t.shown} (read as {word})" for t, word in zip(tokens, meant, strict=True) if word]
    return draft


def _evened(text: str) -> tuple[str, list[int]]:
    """A text with plain apostrophes, without spaces that are too many, and in small letters where it has no others.

    Also, of each of its characters, the place in the text as it was written.
    """
    plain = text.translate(_PLAIN)
    plain = plain.lower() if plain.isupper() and len(plain.lower()) == len(plain) else plain
    gone = {at for found in _SPACES.finditer(plain) for at in range(*found.span())}
    places = [at for at in range(len(plain)) if at not in gone]
    return "".join(plain[at] for at in places) if gone else plain, places


def _in_words(tokens: Sequence[Token]) -> Iterator[Token]:
    """The tokens with number words for the figures of "the 2", "all 3" and "a 4-poster", of which others are told."""
    for at, token in enumerate(tokens):
        before, after = tokens[at - 1].text if at else "", tokens[at + 1].text if at + 1 < len(tokens) else ""
        named = token.glued and after in _AFTER_FIGURES
        if token.kind == "number" and token.value in _FIGURES and (named or before in _BEFORE_FIGURES):
            measured = after in ("by", "x") or after in grammar().lists["length_units"]
            text = _TO_TEN[int(token.value)]
            yield structs.replace(token, text=text, kind="word", value=0.0) if named or not measured else token
        else:
            yield token


def _spelt_out(tokens: list[Token]) -> list[Token]:
    """Words that people shorten, as the lexicon has them; "it's", "they're" and "a kettle's on it" as two."""
    whole: list[Token] = []
    slashed = [*_slashed([*_in_words(tokens)])]
    for at, token in enumerate(slashed):
        after = slashed[at + 1 : at + 4]
        told = token.owner and (token.text in _JOINED or _says_where(after) or _says_how(token, after))
        verb = "is" if told else "are" if token.text in _ARE else ""
        if verb:
            head = len(token.text) - (1 if verb == "is" else 2)
            first, rest = token.shown[:head], token.shown[head:]
            whole.append(Token(token.text[:head], first, "word", start=token.start))
            whole.append(Token(verb, rest, "word", start=token.start + head))
        elif token.text in _BY_UNITS and at and slashed[at - 1].kind == "number":
            unit = token.text[:-1]
            whole.append(Token(unit, token.shown[:-1], "word", start=token.start))
            whole.append(Token("x", token.shown[-1:], "word", start=token.start + len(unit)))
        elif token.text in _SHARED and at and slashed[at - 1].kind == "word":
            head = len("they")
            whole.append(Token("they", token.shown[:head], "word", start=token.start))
            whole.append(Token("would", token.shown[head:], "word", start=token.start + head))
        else:
            whole.append(structs.replace(token, text=_SHORT[token.text]) if token.text in _SHORT else token)
    return whole


def _says_how(one: Token, after: list[Token]) -> bool:
    """Whether a word that follows "one's" or "the other's" is all that is said of it, so that "'s" stands for "is"."""
    ends = len(after) == 1 or (len(after) > 1 and (after[1].kind == "mark" or after[1].text == "and"))
    return one.text in _ONES and ends and after[0].kind == "word"


def _says_where(after: list[Token]) -> bool:
    """Whether words that follow "'s" tell where something is, so that it stands for "is"."""
    if [token.text for token in after[:2]] in (["there", "is"], ["there", "are"]):
        return False
    here = after[1:2] if after and after[0].text in _YET else []
    if here and here[0].text in ("here", "there"):
        return True
    after = after[1:] if here else after
    if len(after) < len(("on", "the")) or after[0].glued or after[1].kind == "mark":
        return False
    return after[0].text in grammar().lists["after_is"]


def _slashed(tokens: list[Token]) -> Iterator[Token]:
    """The tokens with "w/o" and "w/" as one word each."""
    at = 0
    while at < len(tokens):
        slash = tokens[at].text == "w" and at + 1 < len(tokens) and tokens[at + 1].text == "/"
        if not slash:
            yield tokens[at]
            at += 1
            continue
        without = at + 2 < len(tokens) and tokens[at + 2].text == "o"
        length = 3 if without else 2
        shown = "".join(token.shown for token in tokens[at : at + length])
        word = "without" if without else "with"
        yield structs.replace(tokens[at], text=word, shown=shown)
        at += length


def _and_half(number: str) -> str:
    """The number of "one and a half", in digits."""
    return f"{_TO_TEN.index(number) if number in _TO_TEN else int(number)}.5"


def _full_height(said: re.Match[str]) -> str:
    """The look of what reaches up to the ceiling, with a verb where the text has one."""
    verb = "" if not said[1] or said[2] == "ing" else "is " if said[2] else "are "
    return f"{verb}full-height"


def _within(said: re.Match[str]) -> str:
    """The preposition for "within 1.5 m of"; the words themselves where no relation of ours is as close."""
    number = said[1].lower().replace(",", ".")
    amount = 0.5 if number.startswith("half") else {"a": 1.0, "an": 1.0, "one": 1.0, "two": 2.0}.get(number)
    metres = (float(number) if amount is None else amount) * _METRES[said[2].lower()[0]]
    return "near" if metres >= _NEAR else "next to" if metres >= _BESIDE else said[0]
