"""Each, either, at least, not each other: how many are meant, and how they stand to one another."""

import pytest

from thinkblox.brief import Brief
from thinkblox.reading import read_brief


def _counts(brief: Brief) -> dict[str, int]:
    counts: dict[str, int] = {}
    for request in brief.requests:
        if request.asked:
            counts[request.category] = counts.get(request.category, 0) + request.count
    return counts


def _ties(brief: Brief) -> set[tuple[str, str, tuple[str, ...]]]:
    return {(r.kind, r.subject, r.anchors) for r in brief.relations if r.asked and not r.negated}


@pytest.mark.parametrize(
    "prompt",
    [
        "Two desks not facing each other.",
        "Desks not facing each other, two of them.",
        "Two desks. Don't put the desks facing each other.",
    ],
)
def test_what_is_not_to_face_each_other_is_denied(prompt: str) -> None:
    brief = read_brief(prompt)
    assert [(r.kind, r.subject, r.anchors, r.negated) for r in brief.relations if r.asked] == [
        ("facing", "desk", ("desk",), True)
    ]


def test_a_denied_place_stays_denied_after_dont_put() -> None:
    brief = read_brief("A bedroom with a bed and a lamp. Don't put the lamp on the bed.")
    assert [(r.kind, r.subject, r.negated) for r in brief.relations if r.asked] == [("on", "floor_lamp", True)]


def test_what_cannot_be_denied_is_not_understood() -> None:
    assert read_brief("Two desks, never in a row.").unknown == ("never in a row",)


@pytest.mark.parametrize(
    ("prompt", "counts", "ties"),
    [
        (
            "An office for three people, each with a desk and a chair.",
            {"desk": 3, "chair": 3},
            {("at", "chair", ("desk",))},
        ),
        ("An office for three people. Everyone has a bin.", {"waste_bin": 3}, set()),
        (
            "A table with a chair on each side and a plate in front of each chair.",
            {"dining_table": 1, "chair": 2, "plate": 2},
            {("around", "chair", ("dining_table",)), ("on", "plate", ("dining_table",))},
        ),
        (
            "A table with four chairs, a plate in front of every chair and a knife to the right of every plate.",
            {"dining_table": 1, "chair": 4, "plate": 4, "knife": 4},
            {("around", "chair", ("dining_table",)), ("right_of", "knife", ("plate",))},
        ),
        (
            "A lamp on every nightstand, two nightstands, a bed, and nothing else.",
            {"table_lamp": 2, "nightstand": 2, "bed": 1},
            {("on", "table_lamp", ("nightstand",))},
        ),
        (
            "Six desks facing the blackboard with a chair behind each desk.",
            {"desk": 6, "blackboard": 1, "chair": 6},
            {("facing", "desk", ("blackboard",)), ("behind", "chair", ("desk",))},
        ),
        (
            "A rug, on which stands a table, on which stands a vase with tulips.",
            {"rug": 1, "dining_table": 1, "vase": 1},
            {("under", "rug", ("dining_table",)), ("on", "vase", ("dining_table",))},
        ),
        (
            "Two candles on the table, a vase between the candles.",
            {"candle": 2, "vase": 1},
            {("on", "candle", ("dining_table",)), ("between", "vase", ("candle",))},
        ),
    ],
)
def test_each_is_each_of_what_was_named(
    prompt: str, counts: dict[str, int], ties: set[tuple[str, str, tuple[str, ...]]]
) -> None:
    brief = read_brief(prompt)
    assert counts.items() <= _counts(brief).items()
    assert ties <= _ties(brief)
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "category", "count"),
    [
        ("A spa with four recliners in a row and a side table between every two recliners.", "side_table", 3),
        ("Six hospital beds in two rows. A nightstand stands between neighbouring beds.", "nightstand", 4),
        ("A waiting room with six chairs along the wall and a plant between each pair of chairs.", "plant", 5),
        ("A row of five armchairs with two plants between each armchair.", "plant", 8),
        ("Two beds and a nightstand between every two beds.", "nightstand", 1),
        ("A ward with five beds and screens between the beds.", "room_divider", 4),
    ],
)
def test_between_every_two_is_in_every_gap(prompt: str, category: str, count: int) -> None:
    brief = read_brief(prompt, fill="named")
    assert _counts(brief)[category] == count
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "one", "other"),
    [
        ("A laundromat with four washers and four dryers facing each other.", "washing_machine", "dryer"),
        ("A living room with a sofa and an armchair facing each other.", "sofa", "armchair"),
    ],
)
def test_two_kinds_that_face_each_other_both_do(prompt: str, one: str, other: str) -> None:
    assert {("facing", one, (other,)), ("facing", other, (one,))} <= _ties(read_brief(prompt))


@pytest.mark.parametrize(
    "prompt",
    [
        "A bedroom with a king-size bed, a nightstand with a lamp on each side and a wardrobe.",
        "A bed with a nightstand with a lamp on either side.",
    ],
)
def test_a_nightstand_with_a_lamp_on_each_side_is_two_of_both(prompt: str) -> None:
    brief = read_brief(prompt)
    assert _counts(brief)["nightstand"] == _counts(brief)["table_lamp"] == 2
    beside = {(kind, anchors) for kind, subject, anchors in _ties(brief) if subject.startswith("nightstand")}
    assert beside == {("left_of", ("bed",)), ("right_of", ("bed",))}


@pytest.mark.parametrize(
    ("prompt", "seat", "count"),
    [
        ("A library with three tables, four chairs at each table, and a librarian's desk.", "chair", 12),
        ("A boss's office with a desk, and a meeting table with six chairs.", "chair", 6),
        ("A library with three tables with chairs, and a librarian's desk.", "office_chair", 1),
    ],
)
def test_no_seat_is_assumed_beside_a_number_of_seats(prompt: str, seat: str, count: int) -> None:
    seats = {r.category: r.count for r in read_brief(prompt).requests if r.category.endswith("chair")}
    assert sum(n for category, n in seats.items() if category.endswith(seat)) == count


def test_a_desk_of_a_lived_in_room_has_its_seat_besides_those_of_a_table() -> None:
    prompt = "A library with three tables, four chairs at each table, and a librarian's desk."
    relations = read_brief(prompt, fill="lived-in").relations
    assert ("behind", "office_chair", ("reception_desk",)) in {(r.kind, r.subject, r.anchors) for r in relations}


def test_everyone_of_nobody_knows_how_many_is_not_understood() -> None:
    assert read_brief("An office. Everyone has a bin.").unknown == ("Everyone",)


def test_bounds_are_kept_by_the_whole_and_its_parts() -> None:
    brief = read_brief("A greenhouse with between 3 and 5 plants, at least two of them big.")
    asked = [r for r in brief.requests if r.asked]
    assert sum(r.least or r.count for r in asked) == 3
    assert [(r.attributes, r.least) for r in asked] == [(("large",), 2), ((), 1)]


def test_no_more_than_one_is_no_exclusion() -> None:
    brief = read_brief("A bedroom with no more than one lamp and fewer than three pillows.")
    assert brief.excluded == ()
    assert [(r.count, r.most) for r in brief.requests if r.asked] == [(1, 1), (2, 2)]


def test_a_comparison_parts_nothing() -> None:
    brief = read_brief(
        "A sofa with three cushions: one yellow, two navy. Behind the sofa a console table half as long as the sofa."
    )
    assert _counts(brief) == {"sofa": 1, "pillow": 3, "console_table": 1}
    assert brief.unknown == ("half as long as the sofa",)


@pytest.mark.parametrize(
    ("prompt", "counts", "lost"),
    [
        ("Either a sofa or a bed.", {"sofa": 1}, "or a bed"),
        ("A bedroom with either a bed or a cot with two pillows, and a desk.", {"bed": 1, "desk": 1}, None),
    ],
)
def test_of_two_to_choose_from_one_is_made(prompt: str, counts: dict[str, int], lost: str | None) -> None:
    brief = read_brief(prompt)
    assert _counts(brief) == counts
    assert brief.unknown == (lost or "or a cot with two pillows",)


def test_no_lamp_or_rug_excludes_both() -> None:
    assert {"any_lamp", "rug"} <= set(read_brief("A bedroom with a bed, no lamp or rug.").excluded)


@pytest.mark.parametrize(
    ("prompt", "lost"),
    [
        ("A lamp on the desk or the nightstand.", "or the nightstand"),
        ("Two beds, each not next to the other.", "next to the other"),
    ],
)
def test_a_choice_of_places_and_a_denial_of_what_is_unknown_are_said(prompt: str, lost: str) -> None:
    assert read_brief(prompt).unknown == (lost,)


def test_a_bound_told_after_is_that_of_what_was_named() -> None:
    chair = read_brief("A kitchen with chairs, at least four.").request("chair")
    assert (chair.count, chair.least) == (4, 4)


def test_each_of_them_are_the_several_that_were_told_apart() -> None:
    brief = read_brief(
        "There are three desks. The first is near the window. The second carries a computer. A printer stands on the"
        " third. Each of them has its own desk lamp."
    )
    assert _counts(brief)["desk_lamp"] == 3
    assert ("on", "desk_lamp", ("desk", "desk-2", "desk-3")) in _ties(brief)


@pytest.mark.parametrize(("said", "count"), [("a pair of scissors", 1), ("two pairs of headphones", 2)])
def test_a_pair_of_what_comes_in_pairs_is_one(said: str, count: int) -> None:
    assert set(_counts(read_brief(f"A desk with {said} on it.")).values()) == {1, count}


@pytest.mark.parametrize(
    "said",
    [
        "Every chair has a dictionary on it apart from one.",
        "Every chair but one has a dictionary on it.",
        "All but one of the chairs have a dictionary on them.",
    ],
)
def test_all_but_one_are_the_others(said: str) -> None:
    brief = read_brief(f"Nine chairs. {said}")
    assert _counts(brief) == {"chair": 9, "dictionary": 8}


def test_each_goes_on_through_what_each_has() -> None:
    brief = read_brief("Four lanes. Per lane: one sofa and one ball rack with six bowling balls in it.")
    assert _counts(brief)["bowling_ball"] == 24


def test_in_each_is_said_of_the_whole_list() -> None:
    brief = read_brief("Five lockers along the walls, a jersey, a towel and a helmet in each.")
    assert {_counts(brief)[key] for key in ("jersey", "towels", "helmet")} == {5}


def test_from_left_to_right_says_the_order() -> None:
    brief = read_brief("On a workbench stand, from left to right, a tin can, a glass bottle and a milk carton.")
    assert {("right_of", "bottle", ("tin_can",)), ("right_of", "milk_carton", ("bottle",))} <= _ties(brief)


def test_people_have_things_and_are_none() -> None:
    brief = read_brief("Three officials each have a folding table, with a ledger on it and a chair behind it.")
    assert _counts(brief) == {"folding_table": 3, "ledger": 3, "chair": 3}
    brief = read_brief("A desk. Two guests' chairs facing the desk. The host's own chair goes behind the desk.")
    assert _counts(brief) == {"executive_desk": 1, "chair": 3}


def test_ones_are_of_what_was_denied_elsewhere() -> None:
    brief = read_brief("Four desks. There are no plants on the desks; two tall ones stand near the window instead.")
    assert _counts(brief)["plant"] == 2
    assert ("near", "plant", ("window",)) in _ties(brief)


def test_along_with_is_in_the_same_place() -> None:
    brief = read_brief("A lamp stands on the desk together with a laptop and two books.")
    assert {("on", "laptop", ("desk",)), ("on", "book", ("desk",))} <= _ties(brief)


def test_verbs_that_no_list_has_stand_between_a_thing_and_its_place() -> None:
    brief = read_brief("A kiln humming in the corner, two brooms and a mop leaning against the wall.")
    assert {("in_corner", "kiln", ("corner",)), ("against_wall", "broom", ("wall",))} <= _ties(brief)


def test_only_what_is_thin_leans() -> None:
    brief = read_brief("A studio with an easel, a stool and canvases leaning against the wall.")
    assert {subject for kind, subject, _ in _ties(brief) if kind == "against_wall"} == {"picture"}


def test_racks_are_what_such_a_shop_has_and_its_mirror_is_the_only_one() -> None:
    brief = read_brief("A clothing shop with racks, a mirror, two shelves and a counter")
    assert _counts(brief) == {"clothes_rack": 4, "mirror": 1, "shelving_unit": 2, "counter": 1}
    assert not [r.category for r in brief.requests if not r.asked and "mirror" in r.category]


@pytest.mark.parametrize(
    ("prompt", "long", "short"),
    [
        ("A dining table with a chair at each end", 0, 2),
        ("A dining table with a bench on each long side and a chair at each end", 2, 2),
        ("A table with one chair at each end and three on each long side", 6, 2),
        ("A dining table with chairs along both long sides and one at each end", 4, 2),
        ("A dining table for eight with chairs on both long sides", 8, 0),
    ],
)
def test_each_end_of_a_table_is_no_end_of_the_room(prompt: str, long: int, short: int) -> None:
    brief = read_brief(prompt)
    counts = {r.key: r.count for r in brief.requests}
    assert counts.pop("dining_table") == 1
    placed = {
        kind: [r.subject for r in brief.relations if r.kind == kind] for kind in {r.kind for r in brief.relations}
    }
    assert sum(counts[key] for key in placed.get("at_long_side", ())) == long
    assert sum(counts[key] for key in placed.get("at_short_side", ())) == short
    assert brief.unknown == ()


@pytest.mark.parametrize(
    "prompt",
    [
        "A room with four rows of desks, five desks per row.",
        "A room with four rows of desks, five in each row.",
        "A room with four rows of desks with five desks in each row.",
        "A room with desks in four rows, five desks per row.",
    ],
)
def test_rows_are_counted_by_what_each_has(prompt: str) -> None:
    brief = read_brief(prompt)
    assert _counts(brief) == {"desk": 20}
    assert brief.unknown == ()


def test_rows_of_seats_are_all_the_seats() -> None:
    brief = read_brief("A cinema with 5 rows of seats, 8 seats in each row")
    assert {r.category: r.count for r in brief.requests if "chair" in r.category} == {"armchair": 40}


def test_visitors_sit_before_the_desk_and_not_before_a_chair() -> None:
    brief = read_brief("An office chair is behind the desk and two visitor chairs are in front of it.")
    assert ("in_front_of", "visitor_chair", ("executive_desk",)) in _ties(brief)


@pytest.mark.parametrize(
    "end",
    [
        "nothing else",
        "no other furniture",
        "not a single other piece of furniture",
        "without any other furniture",
        "and that is all",
    ],
)
def test_nothing_is_assumed_besides_what_is_all(end: str) -> None:
    brief = read_brief(f"A bedroom with a futon on the floor and a paper lantern beside it, {end}.")
    assert brief.empty
    assert {r.category for r in brief.requests} == {"futon", "lantern"}
    assert brief.unknown == ()


def test_a_size_far_too_deep_for_the_last_thing_is_the_rooms() -> None:
    brief = read_brief("small bedroom with single bed and wardrobe, 3 by 3 metres")
    assert (brief.width, brief.depth) == (3.0, 3.0)
    rug = read_brief("A bedroom with a bed and a rug, 2 m by 3 m.")
    assert (rug.width, rug.depth) == (None, None)


def test_what_heads_a_list_is_a_thing_though_nobody_knows_it() -> None:
    assert _counts(read_brief("a gizmo unit, a sofa and a lamp")) == {"gizmo_unit": 1, "sofa": 1, "floor_lamp": 1}


@pytest.mark.parametrize("prompt", ["a large wall mounted TV opposite the sofa", "a large wall-mounted TV, and a sofa"])
def test_wall_mounted_is_said_with_or_without_a_hyphen(prompt: str) -> None:
    assert _counts(read_brief(prompt)) == {"wall_tv": 1, "sofa": 1}


@pytest.mark.parametrize("prompt", ["a two-bedroom apartment with a sofa", "a 2-bedroom flat", "a two bedroom house"])
def test_the_rooms_of_a_home_are_more_than_the_one_that_is_made(prompt: str) -> None:
    assert read_brief(prompt).unknown == ("more than one room: 2 bedrooms left out",)


def test_what_carries_a_thing_in_the_middle_stands_there() -> None:
    assert ("in_centre", "pier", ("centre",)) in _ties(read_brief("In the middle a telescope sits on a concrete pier."))


@pytest.mark.parametrize(
    ("prompt", "wanted"),
    [
        ("Eight bookcases against the walls, each holding six books.", {"bookcase": 8, "book": 48}),
        ("A table with four chairs. In front of every chair there are a cup and a glass on the table.", {"glass": 4}),
        ("A round table with six chairs around it; at every place a plate and a glass.", {"plate": 6, "glass": 6}),
        ("A conveyor with four small boxes and a large one on it.", {"box": 5}),
        ("Along each of the long walls runs a bench with five potted plants on it.", {"bench": 2, "potted_plant": 10}),
        ("Four tables with three chairs apiece.", {"chair": 12}),
        ("Three shelves: the first holds two jars, the second 8 boxes, the third is empty.", {"shelving_unit": 3}),
        ("Four repair stands, all but one of them holding a bicycle.", {"repair_stand": 4, "bicycle": 3}),
        ("A cabinet with two doors and three drawers.", {"cabinet": 1}),
        ("Three rolls of fabric.", {"roll_of_fabric": 3}),
    ],
)
def test_how_many_there_are(prompt: str, wanted: dict[str, int]) -> None:
    assert wanted.items() <= _counts(read_brief(prompt)).items()


@pytest.mark.parametrize(
    ("prompt", "wanted"),
    [
        (
            "A harp and a piano. The former is in a corner. A stool stands in front of the latter.",
            ("in_front_of", "stool", ("piano",)),
        ),
        (
            "A stool before a backdrop. Two plants, one to the left of the stool, the other to the right.",
            ("right_of", "plant-2", ("stool",)),
        ),
        ("The sofa: against the wall. A lamp.", ("against_wall", "sofa", ("wall",))),
        ("Radio studio. Centre: round table. A sofa.", ("in_centre", "table", ("centre",))),
        ("A clock ticks on the sideboard.", ("on", "clock", ("sideboard",))),
        ("Put a cupboard under the television and five books inside that.", ("inside", "book", ("cabinet",))),
        (
            "On the desk are a telephone, a bell and a jar; behind it, a swivel chair.",
            ("behind", "office_chair", ("executive_desk",)),
        ),
        ("Posters all over the walls and a rug.", ("on", "poster", ("wall",))),
    ],
)
def test_what_stands_where(prompt: str, wanted: tuple[str, str, tuple[str, ...]]) -> None:
    assert wanted in _ties(read_brief(prompt))


def test_what_used_to_be_there_is_not() -> None:
    brief = read_brief("Where the pool table used to be there's an armchair now. We have no use for a blackboard.")
    assert _counts(brief) == {"armchair": 1}


def test_what_is_said_of_each_round_one_is_not_said_of_the_square_ones() -> None:
    brief = read_brief(
        "Six tables: four round ones with three chairs apiece and two square ones with four. On each round table there"
        " is a cake stand, on each square one a teapot and four cups."
    )
    assert _counts(brief) == {"dining_table": 6, "chair": 20, "cake_stand": 4, "teapot": 2, "cup": 8}


def test_the_desk_of_the_teacher_is_another_one() -> None:
    brief = read_brief("A classroom with eight desks. The teacher's desk is in front of the whiteboard on the wall.")
    assert _counts(brief) == {"school_desk": 8, "desk": 1, "whiteboard": 1}


def test_a_fan_on_the_ceiling_is_a_ceiling_fan() -> None:
    assert _counts(read_brief("A table and a fan hanging from the ceiling.")) == {"dining_table": 1, "ceiling_fan": 1}


def test_a_bed_over_a_desk_has_the_desk_under_it() -> None:
    brief = read_brief("A child's room with a loft bed over a desk.")
    assert [(r.kind, r.subject, r.anchors) for r in brief.relations if r.asked] == [("under", "desk", ("bunk_bed",))]


@pytest.mark.parametrize(
    ("said", "category", "count"),
    [
        ("three stations, each with a mirror and a chair, two wash basins at the back, and a bench", "washbasin", 2),
        ("three stations, each with a mirror and a chair, two wash basins at the back, and a bench", "bench", 1),
        ("six stations, each a desk with a lamp, a keyboard and a chair, and a printer in the corner", "printer", 1),
        ("six stations, each a desk with two monitors and a keyboard, and an office chair", "office_chair", 6),
    ],
)
def test_what_each_of_a_group_has_ends_with_its_list(said: str, category: str, count: int) -> None:
    found = {request.category: request.count for request in read_brief(f"A studio with {said}.").requests}
    assert found[category] == count


def test_a_guitar_on_its_stand_is_one_thing_and_a_squat_rack_no_low_shelf() -> None:
    asked = [
        (r.category, r.count)
        for r in read_brief("A den with a guitar on a stand and a squat rack.").requests
        if r.asked
    ]
    assert asked == [("guitar", 1), ("squat_rack", 1)]


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("A dormitory for six students with a bed and a locker for each student", {"bed": 6, "locker": 6}),
        (
            "An office for three people with a desk, a monitor and a chair for each person and a printer",
            {"desk": 3, "monitor": 3, "chair": 3, "printer": 1},
        ),
        (
            "A break room for eight people with a sofa, a TV and a chair for each person",
            {"sofa": 1, "tv": 1, "chair": 8},
        ),
        ("A room for two children, with a bed for each child and one desk", {"bed": 2, "desk": 1}),
        ("A classroom with twelve desks and a chair for each student", {"school_desk": 12, "chair": 12}),
        ("A dining room with a table and eight chairs. A plate and a glass for each guest.", {"plate": 8, "glass": 8}),
        (
            "A table with six chairs. There is a plate, a fork and a glass at every seat.",
            {"plate": 6, "fork": 6, "glass": 6},
        ),
        (
            "An office with four desks, a printer, and a monitor, a keyboard and a mouse on each desk",
            {"desk": 4, "printer": 1, "monitor": 4, "keyboard": 4, "mouse": 4},
        ),
    ],
)
def test_what_there_is_for_each_is_counted(prompt: str, counts: dict[str, int]) -> None:
    brief = read_brief(prompt)
    asked = {request.category: request.count for request in brief.requests if request.asked}
    assert {category: asked[category] for category in counts} == counts
    assert not brief.unknown


def test_one_for_each_of_nobody_is_told() -> None:
    assert read_brief("A kindergarten with a cubby for every child").unknown == ("for every child",)


def test_what_is_at_every_seat_is_on_the_table() -> None:
    brief = read_brief("A round table with six chairs, with a plate, a fork and a glass at every seat.")
    on = {relation.subject: relation.anchors for relation in brief.relations if relation.kind == "on"}
    assert set(on.values()) == {("dining_table",)}
    assert set(on) == {"plate", "fork", "glass"}


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("Two shelves against the wall; each stores five boxes.", {"shelving_unit": 2, "box": 10}),
        ("Three cabinets. Each houses a printer.", {"cabinet": 3, "printer": 3}),
        ("Two tables. Each displays four vases.", {"dining_table": 2, "vase": 8}),
        ("Six desks with two chairs each, and every other desk also gets a vase.", {"chair": 12, "vase": 3}),
        ("Two long desks with four chairs each; every player has a monitor and a mug.", {"monitor": 8, "cup": 8}),
        ("A classroom, five rows with three desks each.", {"school_desk": 15}),
        ("A chapel with four rows with two pews each and an altar.", {"pew": 8, "altar": 1}),
        ("Four desks. Every one of these desks has a lamp.", {"desk": 4, "desk_lamp": 4}),
        ("Two kilns, one per back corner.", {"kiln": 2}),
    ],
)
def test_what_each_of_them_holds_or_has_is_counted(prompt: str, counts: dict[str, int]) -> None:
    brief = read_brief(prompt)
    asked = dict.fromkeys(counts, 0)
    for request in brief.requests:
        if request.asked and request.category in counts:
            asked[request.category] += request.count
    assert asked == counts
    assert not brief.unknown


def test_seats_of_several_kinds_seat_nobody_knows_how_many() -> None:
    assert read_brief("A sofa and two armchairs. Everyone gets a mug.").unknown


@pytest.mark.parametrize(
    "prompt",
    [
        "A room with a console table flanked by two plants.",
        "A room with a console table flanked by plants.",
        "A room with a console table. Two plants flank it.",
        "A room with two plants flanking a console table.",
    ],
)
def test_of_two_that_flank_something_one_is_at_each_side(prompt: str) -> None:
    brief = read_brief(prompt)
    assert _counts(brief) == {"console_table": 1, "plant": 2}
    assert _ties(brief) == {
        ("left_of", "plant", ("console_table",)),
        ("right_of", "plant-2", ("console_table",)),
    }
    assert not brief.unknown


def test_one_of_two_kinds_that_flank_something_is_at_its_left() -> None:
    brief = read_brief("A hall with a console table flanked by a plant and an umbrella stand.")
    ties = {("left_of", "plant", ("console_table",)), ("right_of", "umbrella_stand", ("console_table",))}
    assert _ties(brief) == ties


def test_between_what_each_of_two_has_is_between_two() -> None:
    brief = read_brief("Two single beds, each with a desk at its foot, and a mini fridge between the desks.")
    assert ("between", "fridge", ("desk",)) in _ties(brief)
    assert not brief.unknown


@pytest.mark.parametrize("between", ["the two windows", "the door and the window"])
def test_between_openings_is_no_more_than_near_them_and_told(between: str) -> None:
    assert read_brief(f"An office with a cabinet between {between}.").unknown == (f"between {between}",)


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("A counter with jars of flour, sugar and rice, two of each.", {"jar": 6}),
        ("A table with a bowl, plates and glasses, four of each.", {"bowl": 1, "plate": 4, "glass": 4}),
        ("A sunroom with hanging plants in each corner.", {"hanging_plant": 4}),
    ],
)
def test_of_each_kind_there_are_so_many(prompt: str, counts: dict[str, int]) -> None:
    found = _counts(read_brief(prompt))
    assert {category: found.get(category) for category in counts} == counts


@pytest.mark.parametrize(
    ("prompt", "rows"),
    [
        ("A classroom with twelve school desks in three columns.", 4),
        ("A classroom with three columns of four school desks.", 4),
        ("A classroom with twelve school desks in three rows.", 3),
        ("A hall with 4 rows x 6 columns of chairs.", 4),
    ],
)
def test_columns_are_counted_across_rows(prompt: str, rows: int) -> None:
    assert [r.rows for r in read_brief(prompt, fill="named").relations if r.kind == "in_rows"] == [rows]


@pytest.mark.parametrize(
    ("prompt", "tie"),
    [
        ("A game room with a pool table under a hanging lamp.", ("above", "pendant_lamp", ("pool_table",))),
        ("Four desks, each under a pendant lamp.", ("above", "pendant_lamp", ("desk",))),
        ("A den with a mini fridge below the TV.", ("above", "wall_tv", ("fridge",))),
        ("A bathroom with a sink under a mirror.", ("under", "washbasin", ("mirror",))),
        ("A library with a ladder leaning on a bookcase.", ("next_to", "ladder", ("bookcase",))),
    ],
)
def test_what_is_under_what_hangs_or_leans_on_what_stands(prompt: str, tie: tuple[str, str, tuple[str, ...]]) -> None:
    assert _ties(read_brief(prompt)) == {tie}


def test_what_is_said_to_stand_between_an_opening_and_a_thing_has_the_thing_beside_it() -> None:
    brief = read_brief("A nursery with a crib between the window and the wardrobe.")
    assert _counts(brief) == {"crib": 1, "wardrobe": 1}
    assert ("next_to", "crib", ("wardrobe",)) in _ties(brief)
    assert brief.unknown


def test_heads_of_a_table_are_its_short_sides() -> None:
    brief = read_brief(
        "A dining room with a table for eight, six chairs on the long sides and two armchairs at the heads."
    )
    assert ("at_short_side", "armchair", ("dining_table",)) in _ties(brief)
    assert _counts(brief) == {"dining_table": 1, "chair": 6, "armchair": 2}
    assert not brief.unknown


@pytest.mark.parametrize("corner", ["SW corner", "southwest corner", "south-west corner", "southwestern corner"])
def test_corners_are_told_by_the_compass(corner: str) -> None:
    brief = read_brief(f"A bedroom with a desk in the {corner}.", fill="named")
    assert _ties(brief) == {("in_corner", "desk", ("south_wall", "west_wall"))}
    assert not brief.unknown


def test_notes_leave_out_the_words_before_places() -> None:
    brief = read_brief("Bedroom, door east, two windows north, wardrobe NE corner, bed west wall.", fill="named")
    assert {(gap.kind, gap.wall, gap.count) for gap in brief.openings} == {
        ("door", "east_wall", 1),
        ("window", "north_wall", 2),
    }
    assert _ties(brief) == {
        ("in_corner", "wardrobe", ("north_wall", "east_wall")),
        ("against_wall", "bed", ("west_wall",)),
    }
    assert not brief.unknown


def test_what_we_have_got_is_asked_for() -> None:
    brief = read_brief("We've got a 3x4 m home office: one desk, two screens.", fill="named")
    assert (brief.room_type, brief.width, brief.depth) == ("home_office", 3.0, 4.0)
    assert not brief.unknown


def test_along_the_back_is_along_the_far_wall() -> None:
    brief = read_brief("A shop with a counter and a freezer along the back.", fill="named")
    assert ("against_wall", "fridge", ("far_wall",)) in _ties(brief)


def test_a_car_hangs_on_no_wall() -> None:
    brief = read_brief("A garage with a car and two bicycles hanging on the left wall.", fill="named")
    assert ("against_wall", "car", ("left_wall",)) in _ties(brief)
    assert ("on", "wall_bicycle", ("left_wall",)) in _ties(brief)
    assert "wall-mounted" not in brief.request("car").attributes


@pytest.mark.parametrize(
    ("prompt", "seats"),
    [
        ("A classroom for eight pupils at four desks.", 8),
        ("A cafe for six people at two tables.", 6),
        ("A room that seats twelve around an oval table.", 12),
    ],
)
def test_people_at_several_tables_are_shared_out(prompt: str, seats: int) -> None:
    requests = read_brief(prompt).requests
    assert sum(request.count for request in requests if request.category == "chair") == seats


@pytest.mark.parametrize(
    "said",
    [
        "Each has a monitor. They share a printer on a cabinet by the window.",
        "Each of them has a monitor, and they share a printer that stands on a cabinet.",
        "Each has a monitor, and a cabinet with a printer on it stands by the door.",
        "Each has a desk and a monitor, and they share a printer on a cabinet by the door.",
    ],
)
def test_what_people_share_is_apart_from_what_each_has(said: str) -> None:
    brief = read_brief(f"An office for two people. {said}")
    counts = {request.category: request.count for request in brief.requests}
    assert brief.unknown == ()
    assert (counts["monitor"], counts["printer"], counts["cabinet"], counts["desk"]) == (2, 1, 1, 2)
    assert all(relation.subject != "monitor" for relation in brief.relations if relation.asked)


@pytest.mark.parametrize(
    "tables",
    [
        "Six tables",
        "Six tables, four of them with two chairs, the other two with three",
        "Six tables, two of them round",
    ],
)
def test_every_second_of_all_though_some_were_told_apart(tables: str) -> None:
    brief = read_brief(f"A cafe with {tables}. A vase on every second table.")
    assert _counts(brief)["vase"] == 3
    assert brief.unknown == ()


@pytest.mark.parametrize("said", ["One of the desks has a lamp.", "One of them stands by the window.", ""])
def test_the_chairs_are_those_of_all_desks(said: str) -> None:
    brief = read_brief(f"An office with three desks. {said} The chairs are red.")
    assert _counts(brief)["chair"] == 3


@pytest.mark.parametrize("rest", ["each of the others", "every one of the others"])
def test_each_of_the_others_has_one(rest: str) -> None:
    brief = read_brief(f"A gallery with six pedestals, a vase on every second one and a bust on {rest}.")
    assert (_counts(brief)["vase"], _counts(brief)["bust"]) == (3, 3)
    assert brief.unknown == ()
