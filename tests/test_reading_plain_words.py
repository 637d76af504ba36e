"""Plain sentences as people type them: what is asked for, and how it is to stand."""

import pytest

from tests.test_reading_turns import related
from thinkblox.brief import Brief
from thinkblox.reading import read_brief


def _asked(brief: Brief) -> str:
    """What the prompt asks for: "2 chair, 1 desk"."""
    counts: dict[str, int] = {}
    for request in brief.requests:
        if request.asked:
            counts[request.category] = counts.get(request.category, 0) + request.count
    return ", ".join(f"{count} {category}" for category, count in sorted(counts.items()))


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("A gym with a bench press. Can the bench press be far from the door?", "1 weight_bench"),
        ("Can you do a study with two desks?", "2 desk"),
        ("can each desk have a lamp? Three desks.", "3 desk, 3 desk_lamp"),
        ("A pantry with a can, a jar and a bottle on a shelf.", "1 bottle, 1 jar, 1 shelving_unit, 1 tin_can"),
        ("My robot has to find the keys. Give me a console table, the keys are on it.", "1 console_table, 3 key"),
        ("A bowl on a table. Leave some space so it can drive through.", "1 bowl, 1 dining_table"),
        ("A table which can hold six plates.", "1 dining_table, 6 plate"),
    ],
)
def test_what_can_be_or_has_to_be_done_asks_for_nothing(prompt: str, asked: str) -> None:
    assert _asked(read_brief(prompt)) == asked


def test_an_ability_is_told() -> None:
    brief = read_brief("A lamp that can rotate next to a desk.")
    assert _asked(brief) == "1 desk, 1 floor_lamp"
    assert brief.unknown == ("that can rotate",)


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("A square table. A white bowl is centered on the table.", "1 bowl in_centre dining_table"),
        ("A desk with a monitor centred on it.", "1 monitor in_centre desk"),
        ("A vase stands centrally on the table.", "1 vase in_centre dining_table"),
        ("A tray centered on the ottoman holds two cups.", "1 tray in_centre ottoman"),
        ("A coffee table centred on a rug.", "1 rug under coffee_table"),
        ("A bench is by a sofa, and a stack of at least three books lies on it.", "3 book on bench"),
        ("A desk by a bookcase, and a pile of up to six folders sits on it.", "6 folder on desk"),
    ],
)
def test_what_lies_in_the_middle_or_in_a_pile(prompt: str, relation: str) -> None:
    brief = read_brief(prompt)
    assert relation in related(brief)
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("A treadmill and a bike. Both of them face a mirror.", "1 bicycle, 1 mirror, 1 treadmill"),
        ("Two chairs. Both face a mirror with a lamp above it.", "2 chair, 1 mirror, 1 pendant_lamp"),
        ("A sofa and an armchair. They both face a TV.", "1 armchair, 1 sofa, 1 tv"),
        ("Two chairs. Both chairs are next to a lamp and have a cushion.", "2 chair, 1 floor_lamp, 2 pillow"),
        ("Two beds. Both of them have a pillow.", "2 bed, 2 pillow"),
    ],
)
def test_what_both_stand_by_is_one_and_what_both_have_are_two(prompt: str, asked: str) -> None:
    found = _asked(read_brief(prompt))
    assert sorted(found.split(", ")) == sorted(asked.split(", "))


def test_they_are_the_things_that_were_joined() -> None:
    assert related(read_brief("A table and a chair. They stand by the window.")) == {
        "1 dining_table next_to window",
        "1 chair next_to window",
    }
    brief = read_brief("A bed with a pillow and a blanket. They are white.")
    looks = {request.category: request.attributes for request in brief.requests if request.asked}
    assert looks == {"bed": (), "pillow": ("white",), "blanket": ("white",)}


def test_a_keyboard_stands_on_a_stand_of_its_own() -> None:
    assert "1 electric_piano on keyboard_stand" in related(read_brief("A music studio with a keyboard on a stand."))
