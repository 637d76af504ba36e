"""What the prompt calls a thing stays its name: in the brief, in the plan, and in the room's file."""

import pytest

from thinkblox import edit_room, generate_room
from thinkblox.assets import fit_asset, make_asset
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "category", "called"),
    [
        ("A white treatment table.", "massage_table", "treatment table"),
        ("Two grey totes.", "storage_bin", "tote"),
        ("The teacher's desk.", "desk", "teacher's desk"),
        ("Three buckets of tulips.", "flower_bucket", "bucket of tulips"),
        ("Two old pine farmhouse tables.", "dining_table", "farmhouse table"),
        ("Twenty sheets of paper.", "paper", "sheet of paper"),
        # Words that say less than ours, or nothing else, and what is told of looks, are no name.
        ("A round table with two chairs.", "dining_table", ""),
        ("Two wooden chairs.", "chair", ""),
        ("Ein Tisch mit vier Stühlen.", "dining_table", ""),
    ],
)  # fmt: skip
def test_a_brief_keeps_what_a_thing_is_called(prompt: str, category: str, called: str) -> None:
    requests = read_brief(prompt, fill="named").requests
    assert [r.called for r in requests if r.category == category] == [called]


@pytest.mark.parametrize(
    ("prompt", "category"),
    [
        ("A guard's hut: a desk with a flask on it.", "thermos"),
        ("A school lab: a lab bench with a flask on it.", "flask"),
        ("A toilet against the back wall, a brush next to it.", "toilet_brush"),
        ("An art studio with brushes on a workbench.", "paintbrush"),
        ("A hallway with loafers on a boot rack.", "shoes"),
        ("A bathroom with one white towel on a rack on the wall.", "towel_rail"),
        ("A hallway with four pairs of shoes on a rack.", "shoe_rack"),
    ],
)  # fmt: skip
def test_a_word_means_what_it_means_in_such_a_room(prompt: str, category: str) -> None:
    assert category in {r.category for r in read_brief(prompt, fill="named").requests}


def test_a_thing_keeps_its_name_when_it_is_fitted_and_painted() -> None:
    plain = make_asset("massage_table", seed=1, attributes=("white",))
    table = plain.called("treatment table")
    assert (table.description, table.name) == ("white treatment table", "treatment table")
    assert table.id != plain.id
    assert table.links == plain.links
    assert plain.called(plain.name) is plain
    assert fit_asset(table, (1.8, 0.7, 0.75)).description == "white treatment table"


def test_rooms_and_edits_carry_the_words_of_the_prompt() -> None:
    result = generate_room("A room of 4 by 4 m with a white treatment table and a stool.", fill="named", seed=1)
    scene = result.scene
    (table,) = (scene.asset_of(p) for p in scene.placements if p.category == "massage_table")
    assert table.description == "white treatment table"
    done = edit_room(scene, "Make the treatment table blue and add a tote.")
    described = {p.category: done.scene.asset_of(p).description for p in done.scene.placements}
    assert described["massage_table"] == "blue treatment table"
    assert described["storage_bin"] == "tote"


def test_an_edit_finds_a_thing_by_the_name_it_came_with() -> None:
    scene = generate_room("A 4 by 4 m room with two chairs and a garden chair.", fill="named", seed=1).scene
    named = {p.id: scene.asset_of(p).name for p in scene.placements if p.category == "chair"}
    assert sorted(named.values()) == ["chair", "chair", "garden chair"]
    done = edit_room(scene, "Remove the garden chair.")
    gone = {*named} - {p.id for p in done.scene.placements}
    assert [named[id] for id in gone] == ["garden chair"]
