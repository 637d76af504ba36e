"""Types of rooms: by which names, with what in them, and for how many."""

import pytest

from tests.briefs import counted
from thinkblox import generate_room
from thinkblox.knowledge.rooms import kinds_of_room
from thinkblox.planning import plan_room, varied
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "room", "thing"),
    [
        ("A barber shop", "barber_shop", "barber_chair"),
        ("tattoo parlour, neon", "tattoo_studio", "tattoo_machine"),
        ("the vet's exam room", "vet_clinic", "examination_table"),
        ("A chemistry lab", "science_lab", "flask"),
        ("a yurt", "tent", "lantern"),
        ("A wine cellar", "wine_cellar", "wine_rack"),
        ("A podcast studio", "podcast_studio", "microphone"),
        ("A wine shop with shelves and a tasting table", "wine_shop", "wine_bottle"),
        ("A bike shop", "bike_shop", "helmet"),
        ("A fish and chip shop", "takeaway", "deep_fryer"),
        ("A fitting room", "fitting_room", "changing_cubicle"),
        ("A camera shop", "shop", "camera"),
        ("A mobile phone shop with a counter", "phone_shop", "phone"),
        ("A clock shop", "shop", "clock"),
        ("A dressing room with an ottoman", "walk_in_closet", "standing_mirror"),
        ("A dentist's room", "dental_surgery", "dentist_chair"),
        ("A music teacher's studio with a grand piano", "music_room", "rug"),
        ("A flower shop with a counter and buckets of flowers", "florist", "bouquet"),
        ("A furniture showroom", "shop", "armchair"),
        ("A banquet room for a wedding", "banquet_hall", "dining_table"),
        ("Phone pod in a co-working space", "phone_booth", "stool"),
        ("A treehouse with a bean bag", "treehouse", "bean_bag"),
        ("Ticket kiosk: a counter and a stool", "ticket_booth", "stool"),
    ],
)
def test_a_room_is_known_by_its_name(prompt: str, room: str, thing: str) -> None:
    brief = read_brief(prompt)
    assert brief.room_type == room
    assert thing in counted(brief)


def test_booths_stand_in_other_rooms() -> None:
    office = read_brief("An office with six desks. Along the wall are three phone booths, each with a stool in it.")
    assert (office.room_type, counted(office)["phone_booth"], counted(office)["stool"]) == ("office", 3, 3)


def test_everybody_has_one_of_what_each_has_there() -> None:
    yoga = counted(read_brief("A yoga studio for nine people with a mirror and a plant next to the mirror"))
    assert (yoga["yoga_mat"], yoga["studio_mirror"]) == (9, 1)


def test_what_belongs_to_each_place_comes_along() -> None:
    barber = counted(read_brief("A barber shop for five people"))
    assert {barber[noun] for noun in ("barber_chair", "dressing_table", "mirror", "razor")} == {5}


def test_who_arranges_what_the_room_is_for_gets_no_more_of_it() -> None:
    assert "hob" not in counted(read_brief("A kitchen with a fridge next to a base cabinet"))
    assert "hob" in counted(read_brief("A kitchen with a clock above a bench"))


def test_words_mean_in_a_room_what_they_mean_in_the_wider_one() -> None:
    assert kinds_of_room("hospital_ward") == {"hospital_ward", "hospital_room"}
    assert counted(read_brief("A hospital ward with five beds"))["hospital_bed"] == 5


@pytest.mark.slow
@pytest.mark.parametrize(
    "prompt",
    [
        pytest.param("A dental surgery", marks=pytest.mark.slow),
        "A pottery studio",
        "A mudroom",
        "A barber shop with a clock",
    ],
)
def test_what_a_room_usually_holds_fits_into_it(prompt: str) -> None:
    made = generate_room(prompt)
    assert made.report.complete, made.report.absent


@pytest.mark.parametrize(("prompt", "sold"), [("A phone shop", "phone"), ("A guitar shop", "violin")])
def test_what_a_shop_shows_is_there_with_every_seed(prompt: str, sold: str) -> None:
    for seed in range(8):
        brief = varied(read_brief(prompt), seed)
        tables = [r.key for r in brief.requests if r.category == "display_table"]
        laid = [r.subject for r in brief.relations if r.kind == "on" and r.anchors[0] in tables]
        assert bool(laid) == bool(tables)
    assert sold in counted(read_brief(prompt))


def test_a_church_is_entered_across_from_its_altar_and_has_tall_windows() -> None:
    brief = read_brief("A village church")
    room = plan_room(brief, rng=1)
    door, *windows = room.openings
    lengths = [wall.length for wall in room.walls]
    assert lengths[door.wall] == min(lengths)
    assert abs(door.offset + door.width / 2.0 - lengths[door.wall] / 2.0) < 0.01
    assert len(windows) == 4
    assert all(w.height > 2.0 * w.width and lengths[w.wall] == max(lengths) for w in windows)


def test_a_small_room_is_hardly_larger_than_it_must_be() -> None:
    brief = read_brief("A small bathroom with a bathtub")
    areas = [plan_room(brief, rng=seed).polygon.area for seed in range(6)]
    assert max(areas) < 1.2 * min(areas)


@pytest.mark.parametrize(
    ("prompt", "category", "count"),
    [
        ("A server room with racks and cooling units", "cooling_unit", 2),
        ("A music room with a piano and three microphones on stands", "microphone_stand", 3),
        ("A music room with a drum kit. Acoustic panels cover the walls.", "acoustic_panel", 8),
        ("A meeting room with a table for ten", "office_chair", 10),
    ],
)
def test_words_of_a_room_are_the_things_they_mean(prompt: str, category: str, count: int) -> None:
    assert counted(read_brief(prompt))[category] == count


def test_a_standing_desk_is_height_adjustable() -> None:
    desk = read_brief("A home office with a standing desk").requests[0]
    assert (desk.category, desk.attributes) == ("desk", ("height-adjustable",))


def test_a_desk_has_a_chair_whatever_else_there_is_to_sit_on_in_a_detailed_room():
    from thinkblox.reading import read_brief

    for seat in ("a bean bag", "an ottoman", "a bench at the foot of the bed"):
        brief = read_brief(f"A girl's room with a bed, a desk, a bookcase, a doll house, a rug and {seat}")
        drawn_up = [brief.request(r.subject).category for r in brief.relations if r.kind == "at"]
        assert ["chair" in name for name in drawn_up] == [True], seat
    assert not any("chair" in r.category for r in read_brief("A bedroom with a bed, a desk and a stool").requests)
