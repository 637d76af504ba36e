"""Whether an object has an attribute, where geometry, colour or material can show it."""

from typing import NamedTuple

from thinkblox.evaluation import element_rules
from thinkblox.evaluation.appearance import has_colour, has_material, is_material_word
from thinkblox.evaluation.bodies import Body
from thinkblox.evaluation.colours import is_colour_word
from thinkblox.evaluation.forms import is_shape_word, is_size_word, judged_form
from thinkblox.evaluation.walls import Enclosure

NOT_SHOWN = "neither geometry, colour nor material shows it"
_ON_WALL = ("wall mounted", "mounted", "wall hung", "hanging on the wall")
_HANGING = ("hanging", "suspended", "ceiling mounted")


def what_shows(word: str) -> str:
    """What an attribute is seen by: "colour", "material", "shape", "size" or "mounting"; empty for a state or style."""
    plain = word.lower().replace("-", " ")
    if plain in _ON_WALL or plain in _HANGING:
        return "mounting"
    tests = (
        (is_colour_word, "colour"),
        (is_material_word, "material"),
        (is_shape_word, "shape"),
        (is_size_word, "size"),
    )
    return next((name for is_one, name in tests if is_one(plain)), "")


class Shown(NamedTuple):
    """Whether an object has an attribute, and what shows it; `holds` is None where nothing can."""

    holds: bool | None
    says: str


def shows(body: Body, word: str, demanded: str, room: Enclosure) -> Shown:
    """Whether an object that counts for the category `demanded` has an attribute.

    A word that is both a colour and a material, such as "gold", may be either.
    """
    plain = word.lower().replace("-", " ")
    if plain in _ON_WALL:
        return Shown(*element_rules.holds("on_wall", body, "wall", room))
    if plain in _HANGING:
        return Shown(*element_rules.holds("hang_ceiling", body, "ceiling", room))
    seen = [(has(body, plain), what) for is_word, has, what in _LOOKS if is_word(plain)]
    if seen:
        (_, share), what = max(seen)
        return Shown(any(holds for (holds, _), _ in seen), f"{share * 100:.0f} % of it of that {what}")
    form = judged_form(body, plain, demanded)
    return Shown(None, NOT_SHOWN) if form is None else Shown(*form)


_LOOKS = ((is_colour_word, has_colour, "colour"), (is_material_word, has_material, "material"))
