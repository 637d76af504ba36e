from msgspec import structs

from thinkblox.headline import headline, relation_words
from thinkblox.verdict import RelationResult, Report, Verdict

FAILED = Verdict(id="bed_1", valid=False, reasons=("collision",), depth=0.067)
OUT = Verdict(id="lamp_1", valid=False, reasons=("outside",), boundary=0.0305)
GOOD = Verdict(id="desk_1", valid=True, boundary=-0.2)
WHOLE = Report(valid=False, objects=(GOOD, FAILED), depth=0.00005, drift=0.0012, tilt=0.4, simulated=5.0)


def test_what_holds_as_placed_comes_before_what_holds_once_settled() -> None:
    assert headline(WHOLE) == (
        "as placed: deepest contact 67.00 mm",
        "once settled: deepest contact 0.05 mm",
        "in 5 s with everything free: 1.20 mm, 0.40 degrees",
    )


def test_how_far_something_is_outside_is_said() -> None:
    phrases = headline(structs.replace(WHOLE, objects=(GOOD, OUT)))
    assert phrases[0] == "as placed: deepest contact 0.00 mm, 30.50 mm outside the room at most"


def test_a_model_is_measured_from_its_start() -> None:
    assert headline(structs.replace(WHOLE, objects=(GOOD,), source="mjcf", depth=0.012)) == (
        "as placed: deepest contact 12.00 mm",
        "in 5 s with everything free: 1.20 mm, 0.40 degrees",
    )


def test_of_an_empty_room_there_is_nothing_to_say() -> None:
    assert headline(Report(valid=True)) == ()


def test_a_place_is_said_once_in_the_words_of_a_relation() -> None:
    told = RelationResult(subject="crib", kind="against_wall", anchors=("wall",), holds=False, measured="1 m")
    assert relation_words(told) == "against wall"
    assert relation_words(structs.replace(told, anchors=("far_wall",))) == "against far_wall"
