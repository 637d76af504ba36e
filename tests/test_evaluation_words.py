import pytest

from tests.judged_rooms import demands
from thinkblox.assets.catalogue import CATALOGUE
from thinkblox.evaluation.matching import match
from thinkblox.evaluation.relation_words import element, element_rule, object_rules
from thinkblox.evaluation.vocabulary import load_vocabulary, plain

WORDS = load_vocabulary()


@pytest.mark.parametrize(
    ("name", "demanded", "steps"),
    [
        ("couch", "sofa", 0),
        ("tv", "television", 0),
        ("bookshelf", "bookcase", 0),
        ("fridge", "refrigerator", 0),
        ("rug", "carpet", 0),
        ("waste_bin", "trash can", 0),
        ("office_chair", "chair", 1),
        ("dining_table", "table", 1),
        ("floor lamp", "lamps", 1),
        ("potted_plant", "plants", 1),
        ("dentist_chair", "chair", 1),
        ("six dining chairs", "chair", 2),
        ("loaf of bread", "bread", 0),
        ("red wine bottle", "bottle", 2),
        ("bowl of red apples", "bowl", 1),
        ("box of crayons", "crayon box", 1),
        ("two cues", "pool cue", 1),
        ("cash register", "cash register", 0),
        ("chair", "office chair", None),
        ("table", "coffee table", None),
        ("dressing_table", "table", None),
        ("nightstand", "table", None),
        ("toy car", "car", None),
        ("lamp", "floor lamp", None),
        ("bookcase", "book", None),
        ("wheelchair", "chair", None),
        ("hair dryer", "dryer", None),
    ],
)
def test_a_general_word_takes_the_special_one_and_not_the_other_way(name, demanded, steps):
    assert WORDS.steps(name, demanded) == steps


@pytest.mark.parametrize(
    ("written", "singular"),
    [
        ("Shelves", "shelf"),
        ("wine glasses", "wine glass"),
        ("the  boxes", "box"),
        ("cherries", "cherry"),
        ("a bus", "bus"),
        ("coffee_tables", "coffee table"),
        ("knives", "knife"),
        ("", ""),
        ("!", ""),
    ],
)
def test_plain_names(written, singular):
    assert plain(written) == singular


def test_every_category_of_the_catalogue_is_what_its_own_noun_says():
    strange = [n for n, c in CATALOGUE.items() if WORDS.steps(n, c.noun) is None and WORDS.steps(c.noun, n) is None]
    assert strange == ["curtain_rail"]  # whose noun is a privacy curtain


def test_no_word_of_the_tables_is_above_itself():
    above = [(a, b) for a in WORDS.kinds for b in WORDS.kinds if a != b and WORDS.steps(a, b) is not None]
    assert [(a, b) for a, b in above if (b, a) in above] == [("phone", "telephone"), ("telephone", "phone")]


def ids(named, *categories):
    return match(named, demands(counts=[["eq", 1, c] for c in categories]), WORDS)


def test_an_object_counts_for_the_most_special_category_that_is_demanded():
    named = {"a": ("coffee_table",), "b": ("dining_table",), "c": ("high_chair",), "d": ("chair", "oak chair")}
    assert ids(named, "table", "coffee table", "chair", "high chair") == {
        "table": ("b",),
        "coffee table": ("a",),
        "chair": ("d",),
        "high chair": ("c",),
    }


def test_its_description_is_a_name_of_an_object_too():
    named = {"a": ("chair", "wooden rocking chair"), "b": ("chair", "chair")}
    assert ids(named, "rocking chair", "chair") == {"rocking chair": ("a",), "chair": ("b",)}


def test_what_is_only_alike_counts_where_nothing_else_is_there():
    assert ids({"a": ("desk_lamp",), "b": ("table_lamp",)}, "table lamp") == {"table lamp": ("b",)}
    assert ids({"a": ("desk_lamp",)}, "table lamp") == {"table lamp": ("a",)}


def test_a_category_that_only_relations_name_takes_what_other_rows_count():
    rows = demands(counts=[["eq", 1, "floor lamp"]], elements=[["eq", 1, "near", "lamp", "window"]])
    assert match({"a": ("floor_lamp",)}, rows, WORDS) == {"floor lamp": ("a",), "lamp": ("a",)}


def test_two_words_for_one_thing_name_the_same_objects():
    rows = demands(counts=[["eq", 1, "couch"]], attributes=[["eq", 1, "sofa", "blue"]])
    assert match({"a": ("sofa",)}, rows, WORDS) == {"couch": ("a",), "sofa": ("a",)}


def test_words_of_relations():
    assert object_rules("at the foot of") == ("front_of", "next_to")
    assert object_rules("On-Top") == ("on_top",)
    assert object_rules("diagonally across") == ()
    assert element_rule("on", "wall") == "on_wall"
    assert element_rule("on", "ceiling") == "hang_ceiling"
    assert element_rule("in", "corner") == "corner_room"
    assert element_rule("orbiting", "wall") is None
    assert [element(name) for name in ("back wall", "windows", "bedroom", "the corner")] == [
        "wall",
        "window",
        "room",
        "corner",
    ]
