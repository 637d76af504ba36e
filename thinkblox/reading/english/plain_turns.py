"""Turns of speech in plainer words of the same length: "to the left of which", "looking for", "runs the length of"."""

import re
from collections.abc import Callable

_OF_WHICH = re.compile(r"\b(?:to|on|at) (?:the|its) (left|right)(?: side| hand side)? of which\b", re.IGNORECASE)
"""At which side of what was named something is that comes."""
_WANTED = re.compile(
    r"(?:^|(?<=[.!?\n] ))(?:(?:i am|i'm|we are|we're|you|we) )?"
    r"(?:(?:looking|searching|hoping) for|in (?:need|search) of|thinking of|(?:how|what) about|welcome to|"
    r"(?:step|walk) into|(?:find|found|picture|imagine) (?:yourself|ourselves|myself) in|go for|opt for)"
    r"(?= (?:an?|the|my|our|this)\b)",
    re.IGNORECASE,
)
"""What else begins to say what is wanted."""
_PRESENT = re.compile(r"(?:^|(?<=[.!?\n] ))present (?:in (?:the|this) room |here )?(is|are)\b", re.IGNORECASE)
"""There is what comes."""
_INSIDE = re.compile(r"^inside,? (?=(?:is|are|there|you|we)\b)", re.IGNORECASE)
"""In the room, where nothing was named yet."""
_LENGTH_OF = re.compile(
    r"\b(?:run(ning|s)?|stretch(ing|es)?|extend(ing|s)?|span(ning|s)?) (?:along )?the "
    r"(?:full |whole |entire )?length of(?= (?:the|one|a)\b)",
    re.IGNORECASE,
)
"""What is as long as a wall."""
_SEATED_AT = re.compile(
    r"\b(?:at|around|on) which (?:up to )?(\w+) (?:people|persons|guests|students|children|adults) can "
    r"(?:sit|eat|work|dine|be seated)\b",
    re.IGNORECASE,
)
"""How many have a place at a table."""
_SHINING = re.compile(
    r"\b(lamps?|chandeliers?|lanterns?|pendants?) (lights?)(?= (?:up )?(?:the|an?|it|this)\b)", re.IGNORECASE
)
"""What lamps do, and no name of one."""
_NEXT = re.compile(r"(?:^|(?<=[.!?\n;] ))next(?=,)", re.IGNORECASE)
"""What comes then."""
_BOTH_SIDES = re.compile(r"\bflanked (?:on|at) (?:both|either|each) (?:sides?|ends?) (by|with)\b", re.IGNORECASE)
_SO_THAT = re.compile(
    r"\b(?:oriented|positioned|placed|turned|arranged|angled|set) so (?:that |as )?(?:it|they|to)(?: is| are)?"
    r" (fac(?:es?|ing) |look(?:s|ing)? )",
    re.IGNORECASE,
)
"""How a thing is turned, told as what that is for."""
_IN_WAY = re.compile(
    r"\b(?<!not )(?<!n't )(?<!without )(?<!avoid )"
    r"(?:(blocks|obstructs)|(?<=s )(block|obstruct)|(?:(?<=can )|(?<=may )|(?<=should )|(?<=would ))(block|obstruct)|"
    r"blocking|obstructing) (?:the|its|our|my|one) "
    r"(?:way|path|passage|view|door|doorway|window|entrance|exit|aisle|walkway|corridor)\b",
    re.IGNORECASE,
)
"""What a thing does to the way or the door, and no block."""
_NEITHER = re.compile(r"\bneither (\w+)(?= (?:may|can|is|should|must|shall|stands|faces|has|touches|will)\b)", re.IGNORECASE)
"""None of two."""
_FOR_ROOM = re.compile(r"(?:^|(?<=[.!?\n] ))(?:this|it)(?:'s| is) for (?=(?:an?|my|our|the)\b)", re.IGNORECASE)
"""Which room is wanted, told as what the words are for."""
_IN_HASTE = re.compile(r"\b((?:need|want|build|make|give me|get me)(?: an?)? [a-z]+(?: [a-z]+)?) (?:fast|quick|asap)(?=[,.:;!\n]|$)", re.IGNORECASE)
"""How soon it is wanted."""
_RUN_BY = re.compile(
    r"\b(?:run|owned|managed|staffed|inhabited|founded|used) by (?:an?|the|my|our|two|three|some) (?:[\w'-]+ ){0,3}?[\w'-]+"
    r"(?=\s*(?:[,.;:!?\n]|with\b|and has\b|who\b|$))",
    re.IGNORECASE,
)
"""Whose a room is."""
_ONCE_HAD = re.compile(
    r"(?:\b(?:that|which) )?\b(?:we|i|they|he|she|you|people) (?:used to (?:have|own|keep|use)|once (?:had|owned)|had before)"
    r"(?= (?:is|are|was|were|has|have)\b)",
    re.IGNORECASE,
)
"""What was once, and says nothing of what is."""
_UNDONE = re.compile(
    r"(?:\b(?:that|which) )?(?:\b(?:nobody|no one|no-one) (?:has|have|ever|wants|uses|dares|will|would)\b|"
    r"\b(?:that|which) (?:he|she|we|i|they) (?:has|have|had)(?:n't|nt| not| never)\b)[^,.;:!?\n]*",
    re.IGNORECASE,
)
"""What somebody has not done with a thing."""
_NEEDED = re.compile(
    r"\b(?:because|since|as) (?:he|she|we|i|they|you) (?:needs?|likes?|loves?|wants?|prefers?|hates?) (?:the|some|more|natural|good) "
    r"(?:day)?(?:light|sun|view|air|space|quiet|warmth|room)\b",
    re.IGNORECASE,
)
"""Why something is where it is."""
_NOT_ONE = re.compile(r"\b(and|but) not one(?= (?!of\b)[a-z])", re.IGNORECASE)
"""None at all."""
_RECEPTION = re.compile(r"\bthe reception(?= (?:has|needs|ought|must|should|is)\b(?: to)?(?: be| look| feel)? [a-z]+\s*[.;,!])", re.IGNORECASE)
"""The room, of which it is told how it looks."""
_SEEN_FIRST = re.compile(r"\b(what (?:you|we|one|visitors|guests) (?:notice|see|spot|meet)s?) first\b", re.IGNORECASE)
"""What is there, told as what is seen."""
_OUT_OF = re.compile(r"\bstraight (?:out of|from) [^,.:;!?\n]{1,40}?(?=\s*[,.:;!?\n]| with\b|$)", re.IGNORECASE)
"""What a room reminds of."""
_SMELL = re.compile(
    r"\b(?:that|the|a|some) (?:[\w-]+ ){0,2}(?:smell|scent|aroma|fragrance)(?: of [\w ]{1,30})?(?=\s*(?:[,.;:!\n]|and\b|$))",
    re.IGNORECASE,
)
_OUTSIDE = re.compile(r"\b(?:rain|snow|traffic|birdsong|fog|thunder) outside\b", re.IGNORECASE)
"""What nobody can place in a room."""
_ROBOTS = re.compile(
    r"\bfor (?:an?|the|our|my) (?:[\w-]+ ){0,2}robot(?=\s*(?:[,.:;(\n]|to\b|$))|"
    r"(?:^|(?<=[.!?\n] ))(an?|the|our|my) (?:[\w-]+ ){0,2}robot (?:will|should|must|has to|is going to|can) "
    r"(?:work|move|operate|live|drive|help|navigate|clean up|tidy up) (?:in|around|through|inside)\b",
    re.IGNORECASE,
)
"""Who uses the room, and is no part of it."""
_GONE = re.compile(
    r"\b((?:is|are) gone),? (?:so|and) (?:please )?(?:don't|do not) (?:add|put|place|include|give us) (?:one|any|it|them)\b",
    re.IGNORECASE,
)
"""What is not there, told twice."""
_REDONE = re.compile(
    r"(?:,? ?\bso )?\b(?:i|we) (?:want|need|would like|'d like|must have) (?:it|this|that|the room) "
    r"(?:re)?(?:done up|done|furnished|refurbished|renovated|decorated|designed|modelled)(?: please)?(?=[,.;:!\n]|$)",
    re.IGNORECASE,
)
"""That a room is wanted."""
_ROOM_NUMBER = re.compile(
    r"\broom (?:number |no\.? ?)?\d+ (?:of|in|at) (my|our|the|a) (hotel|hostel|motel|inn|guesthouse|dorm)\b", re.IGNORECASE
)
"""Which of many rooms alike."""
_TO_STAY_IN = re.compile(
    r"\bfor (?:an?|the|my|our|his|her) (?:[\w'-]+ ){1,4}to (?:[a-z]+ )?[a-z]+ in(?=[.,;:!\n]|$)", re.IGNORECASE
)
"""What somebody does in a room."""
_TO_CONTAIN = re.compile(r",? to (?:contain|include|feature|hold|comprise)\s*(?=:)", re.IGNORECASE)
"""What comes before a list of what is there."""
_UNDER_STAIRS = re.compile(
    r"^([^.;!?\n]*?\b(?:room|office|study|bathroom|toilet|loo|kitchen|den|nook|closet|pantry|workshop|studio|library|"
    r"bedroom|hideout|laundry)) (?:tucked |squeezed )?(?:away )?(?:in )?under (?:the|our|my) "
    r"(?:main )?(?:stairs|staircase|stairway|roof|eaves|rafters)\b",
    re.IGNORECASE,
)
"""Where in the house a room is."""
_EPISODE = re.compile(
    r"^(?:[\w-]+ ){0,4}(?:episode|trial|challenge|experiment|rollout)s?(?: takes place| set)? in (?=(?:an?|the|our)\b)",
    re.IGNORECASE,
)
_TARGET = re.compile(
    r"\bthe (?:target|goal|query)(?: object| item)? is (?=(?:an?|one)\b)", re.IGNORECASE
)
"""What robots are to look for, which is there."""
_MOOD_LIGHT = re.compile(
    r"(?<!\ba )(?<!\bthe )(?<!\bone )\b(?:soft|warm|gentle|dim|dimmed|moody|subdued|cosy|cozy|golden|harsh|mellow) "
    r"light(?:ing)?(?=\s*(?:[,.;:!\n]|please\b|and\b|everywhere\b|$))",
    re.IGNORECASE,
)
"""How light it is."""
_WHO_HAS = re.compile(
    r"\bfor (?:somebody|someone|people|an? (?:person|man|woman|child|boy|girl|family|couple|student|patient)|"
    r"(?:my|our) \w+) with (?:an? |the )?(?:[\w-]+ ){0,2}"
    r"(?:allerg(?:y|ies)|asthma|arthritis|dementia|autism|insomnia|migraines?|disabilit(?:y|ies)|back pain|vertigo)\b",
    re.IGNORECASE,
)
"""Whom a room is for, and how they are."""
_THE_REST = re.compile(
    r"\b(the rest|the others?|the remaining (?:\w+)),(?= [a-z]+(?:[- ](?:and )?[a-z]+)?\s*(?:[.;!\n]|$))", re.IGNORECASE
)
"""A comma where a verb is left out: "the rest, grey"."""
_PUT_IN = re.compile(r"\b((?:don't|do not) put) in(?= (?:any|a|an|more)\b)", re.IGNORECASE)
"""An order not to have something."""
_ASIDE = re.compile(
    r"\(?\b(?:please )?(?:don't|do not) (?:laugh|ask(?: why| me)?|judge(?: me)?|worry|panic|ask questions)\b[.!]?\)?", re.IGNORECASE
)
"""What is said to the reader."""
_UNWANTED = re.compile(
    r"(?:^|(?<=[.!?;\n] ))(?:any )?([a-z][\w-]+(?: [\w-]+)?)(?:, (?:though|however),?| though)? (?:i|we) (?:don't|do not) (?:want|need)"
    r"(?: to (?:see|have))?(?: there| here| in there)?(?=\s*[.;,!\n]|$)",
    re.IGNORECASE,
)
"""What is named first and then not wanted."""
_LEAST_OF_ALL = re.compile(
    r"\bleast of all (?:an? |any |the )?([\w-]+(?: [\w-]+)?)(?:,? so (?:please )?(?:don't|do not) (?:add|put|place) (?:one|any|it|them))?"
    r"(?=\s*[.;,!\n]|$)",
    re.IGNORECASE,
)
"""What is wanted less than anything."""
_NEEDS_NOTHING = re.compile(r"\bnobody needs anything\b", re.IGNORECASE)
_AND_WHERE = re.compile(
    r"(?:^|(?<=[.!?\n] ))(?:and |so )?(?:what(?:'s| is| goes| stands| lies| belongs| comes)? )?"
    r"(on|in|under|above|beneath|inside|next to|beside|behind|in front of) ((?:the|my|our) [\w-]+(?: [\w-]+)?|it|them)\?"
    r"(?= (?:an?|one|two|three|four|five|six|seven|eight|nine|ten|\d+|just|only)\b)",
    re.IGNORECASE,
)
"""A question where something is, which is answered right after it."""
_DAYS_BEFORE = re.compile(
    r"\bfrom (?:the|those) (?:days|times?|years|age|era) (?:before|of|when) [^,.;:()!?\n]+", re.IGNORECASE
)
"""Of which time a room is."""
_SO_NOT = re.compile(r"\(so (not (?:a single|one|any)) ([\w -]+?)!?\)", re.IGNORECASE)
"""What is not there, told in brackets."""
_OF_OWN = re.compile(r" of (?:its|their|his|her|my|our) own\b", re.IGNORECASE)
"""What says no more of a thing than that nobody shares it."""
_THREE_D = re.compile(r"\b3[- ]?d(?= (?:model|scene|render|rendering|environment|room|layout|view|interior)\b)", re.I)


def with_plain_turns(text: str) -> str:
    """The text with plainer words, each as long as what it stands for where that is not shorter."""
    for pattern, plainer in _TURNS:
        text = pattern.sub(_padded(plainer), text)
    return text


def _padded(plainer: Callable[[re.Match[str]], str]) -> Callable[[re.Match[str]], str]:
    """The same words with spaces after them, so that all that follows stays in its place."""
    return lambda said: plainer(said).ljust(len(said[0]))


def _turned_so(verb: str) -> str:
    """The participle of "facing" or "looking at" for the verb of "so that it faces"."""
    return "facing " if verb.lower().startswith("fac") else "looking "


def _along(said: re.Match[str]) -> str:
    """The verb or participle and the preposition for "runs the length of"."""
    ending = next((group for group in said.groups() if group), "")
    return f"{'running' if ending.endswith('ing') else 'runs' if ending else 'run'} along"


_TURNS: tuple[tuple[re.Pattern[str], Callable[[re.Match[str]], str]], ...] = (
    (_OF_WHICH, lambda said: f"{said[1].lower()} of which"),
    (_WANTED, lambda said: "show"),
    (_PRESENT, lambda said: f"there {said[1].lower()}"),
    (_INSIDE, lambda said: "here"),
    (_LENGTH_OF, _along),
    (_SEATED_AT, lambda said: f"that seats {said[1]}"),
    (_SHINING, lambda said: f"{said[1]} {'helps' if said[2].endswith('s') else 'help'}"),
    (_NEXT, lambda said: "then"),
    (_BOTH_SIDES, lambda said: f"flanked {said[1]}"),
    (_SO_THAT, lambda said: _turned_so(said[1])),
    (_IN_WAY, lambda said: f"{'is ' if said[1] else 'are ' if said[2] else 'be ' if said[3] else ''}in the way"),
    (_NEITHER, lambda said: f"no {said[1]}"),
    (_FOR_ROOM, lambda said: "show"),
    (_IN_HASTE, lambda said: said[1]),
    (_RUN_BY, lambda said: ""),
    (_ONCE_HAD, lambda said: ""),
    (_UNDONE, lambda said: ""),
    (_NEEDED, lambda said: ""),
    (_NOT_ONE, lambda said: f"{said[1]} no"),
    (_RECEPTION, lambda said: "the room"),
    (_SEEN_FIRST, lambda said: said[1]),
    (_OUT_OF, lambda said: ""),
    (_SMELL, lambda said: ""),
    (_OUTSIDE, lambda said: ""),
    (_ROBOTS, lambda said: "show" if said[1] else ""),
    (_GONE, lambda said: said[1]),
    (_REDONE, lambda said: ""),
    (_ROOM_NUMBER, lambda said: f"{said[1]} {said[2]} room"),
    (_TO_STAY_IN, lambda said: ""),
    (_TO_CONTAIN, lambda said: ""),
    (_UNDER_STAIRS, lambda said: said[1]),
    (_EPISODE, lambda said: "show"),
    (_TARGET, lambda said: "there is"),
    (_MOOD_LIGHT, lambda said: ""),
    (_WHO_HAS, lambda said: ""),
    (_THE_REST, lambda said: said[1]),
    (_PUT_IN, lambda said: said[1]),
    (_ASIDE, lambda said: ""),
    (_UNWANTED, lambda said: f"no {said[1]}"),
    (_LEAST_OF_ALL, lambda said: f"no {said[1]}"),
    (_NEEDS_NOTHING, lambda said: "is nothing"),
    (_AND_WHERE, lambda said: f"{said[1].lower()} {said[2]}:"),
    (_DAYS_BEFORE, lambda said: ""),
    (_SO_NOT, lambda said: f", no {said[2]},"),
    (_OF_OWN, lambda said: ""),
    (_THREE_D, lambda said: ""),
)
"""What is read as what."""
