import pytest

from thinkblox.assets import CATALOGUE, kind_of
from thinkblox.assets.names import known_phrases
from thinkblox.assets.plurals import singular, singulars
from thinkblox.knowledge.vocabulary import is_abstract, is_person, name_of, thing_called


@pytest.mark.parametrize(
    ("phrase", "category", "length", "plural"),
    [
        ("wok", "wok", 1, False),
        ("a pair of heavy frying pans", "frying_pan", 2, True),
        ("wooden cutting-boards", "cutting_board", 1, True),
        ("coffee table", "coffee_table", 2, False),
        ("chests of drawers", "dresser", 3, True),
        ("bookshelves", "bookcase", 1, True),
        ("bread loaves", "bread", 2, True),
        ("cheese board", "cheese_board", 2, False),
        ("tables", "any_table", 1, True),
        ("mice", "mouse", 1, True),
        ("glasses", "glass", 1, True),
        ("box", "box", 1, False),
        ("boxes", "box", 1, True),
        ("grapes", "grapes", 1, True),
    ],
)
def test_the_longest_name_at_the_end_of_a_phrase_is_found(
    phrase: str, category: str, length: int, plural: bool
) -> None:
    found = name_of(phrase.split())
    assert found is not None
    assert (found.category, found.length, found.plural) == (category, length, plural)


@pytest.mark.parametrize(
    ("phrase", "name"),
    [("samovars", "samovar"), ("bread loaves", "bread"), ("couches", "sofa"), ("tables", "any_table")],
)
def test_what_is_plain_is_asked_for_by_its_own_name(phrase: str, name: str) -> None:
    found = name_of(phrase.split())
    assert found is not None
    assert found.name == name
    if not name.startswith("any_"):
        assert kind_of(name).size == CATALOGUE[found.category].size


def test_a_name_can_say_more_than_the_thing() -> None:
    found = name_of(["loveseats"])
    assert found is not None
    assert (found.category, found.attribute) == ("sofa", "two-seat")
    attributes = {found.attribute for phrase in known_phrases() if (found := thing_called(phrase))}
    assert {"", "queen", "two-seat"} <= attributes


@pytest.mark.parametrize("phrase", ["", "gizmotron", "lovely", "wok of"])
def test_what_ends_in_no_name_of_a_thing_has_none(phrase: str) -> None:
    assert name_of(phrase.split()) is None


def test_every_word_of_every_category_names_it_or_its_like() -> None:
    for kind in CATALOGUE.values():
        for item in filter(None, (word.strip() for word in kind.words.split(","))):
            found = name_of(item.partition(":")[0].partition("|")[0].lower().split())
            assert found is not None, item
            assert found.category in CATALOGUE or found.category.startswith("any_")


@pytest.mark.parametrize(
    ("word", "singular"),
    [
        ("shelves", "shelf"),
        ("knives", "knife"),
        ("loaves", "loaf"),
        ("women", "woman"),
        ("feet", "foot"),
        ("berries", "berry"),
        ("boxes", "box"),
        ("shoes", "shoe"),
        ("chairs", "chair"),
        ("firemen", "fireman"),
    ],
)
def test_a_plural_leads_back_to_its_noun(word: str, singular: str) -> None:
    assert singular in set(singulars(word))


@pytest.mark.parametrize("word", ["glass", "cactus", "tennis", "chair", "as"])
def test_what_is_no_plural_leads_nowhere(word: str) -> None:
    assert list(singulars(word)) == []


ABSTRACT = "space atmosphere functionality storage feel unease touch warmth ambience style vibe comfort privacy morning"
ABSTRACT += " party evening tranquillity kindness moments activities productivity togetherness arrangement storages"
THINGS = "apartment equipment cushion station instrument painting television glass lamp wok table chest monument"
PERSONS = "guests children women cashier student people"


def test_what_is_never_a_thing_is_told_from_what_is() -> None:
    assert [word for word in ABSTRACT.split() if not is_abstract(word)] == []
    assert [word for word in f"{THINGS} {PERSONS}".split() if is_abstract(word)] == []


def test_people_are_told_from_things() -> None:
    assert [word for word in PERSONS.split() if not is_person(word)] == []
    assert [word for word in f"{THINGS} {ABSTRACT}".split() if is_person(word)] == []


def test_nothing_of_the_catalogue_is_called_abstract_or_a_person_by_its_only_word() -> None:
    nouns = [kind.noun for kind in CATALOGUE.values() if " " not in kind.noun]
    assert [noun for noun in nouns if is_abstract(noun) or is_person(noun)] == []


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        ("shelves", "shelf"),
        ("boxes", "box"),
        ("berries", "berry"),
        ("glass", "glass"),
        ("gas", "gas"),
        ("crises", "crisis"),
        ("sheep", "sheep"),
        ("canvases", "canvas"),
        ("lenses", "lens"),
    ],
)
def test_the_likeliest_singular_is_told_by_spelling(word: str, expected: str) -> None:
    assert singular(word) == expected
