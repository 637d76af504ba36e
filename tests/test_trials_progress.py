"""What is told while a model furnishes a room, which may take long, and afterwards of whose room it is."""

import numpy as np
import pytest
from msgspec import structs

from tests.model_answers import answer_to, asked_of
from tests.stub_server import stub
from thinkblox.cli import main
from thinkblox.cli.progress import ObjectBar
from thinkblox.episode import Round
from thinkblox.generate import generate_room
from thinkblox.placing import Effort
from thinkblox.printing import whose

PROMPT = "A small room with a table and a chair near it."


class Babbler:
    def propose(self, observation, n, rng: np.random.Generator):
        return ["over there"] * n


@pytest.fixture(scope="module")
def babbled():
    heard: list[Round] = []
    effort = Effort(candidates=2, rounds=2, restarts=0)
    room = generate_room(PROMPT, policy=Babbler(), fill="named", effort=effort, on_round=heard.append)
    return room, heard


def test_each_round_is_told_as_it_goes(babbled):
    room, heard = babbled
    assert [(r.id, r.number, r.kind) for r in heard] == [(r.id, r.number, r.kind) for r in room.trace]
    assert [r.kind for r in heard[:3]] == ["policy", "policy", "repair"]


def test_a_long_round_of_no_use_is_a_line_with_the_reason(babbled, capsys):
    quick = babbled[1][0]
    ObjectBar(quiet=False).hear(quick)
    assert capsys.readouterr().err == ""
    ObjectBar(quiet=False).hear(structs.replace(quick, propose_seconds=70.0))
    assert capsys.readouterr().err.startswith(
        f"{quick.id}: 2 answers in 70 s, none of use; of the last: expected <think>"
    )
    ObjectBar(quiet=True).hear(structs.replace(quick, propose_seconds=70.0))
    assert capsys.readouterr().err == ""


def test_what_a_search_has_found_is_not_the_policys(babbled):
    placed = [p.id for p in babbled[0].scene.placements]
    assert whose(babbled[0].trace) == (
        f"where the model said: 0 of {len(placed)} objects; by a search instead: {'; '.join(placed)};"
        " not readable: 8 of 8 answers (format 8)"
    )


def test_the_command_says_that_a_model_is_asked_and_what_came_of_it(tmp_path, capsys):
    def babbles_of_chairs(body):
        text = asked_of(body)
        return "By the wall." if '"id":"chair_1","category' in text else answer_to(text)

    with stub(babbles_of_chairs) as server:
        options = ("--policy", server.spec, "--no-pictures", "--candidates", "1", "--out", str(tmp_path / "room"))
        main(["generate", PROMPT, *options])
    told = capsys.readouterr()
    asked, planned = told.err.splitlines()[:2]
    assert asked == "the model is asked what belongs into the room"
    assert planned == "3 objects planned; the model is asked where each goes"
    assert (
        "where the model said: 2 of 3 objects; by a search instead: chair_1; not readable: 3 of 5 answers" in told.out
    )


def test_of_the_expert_nothing_of_it_is_said(tmp_path, capsys):
    main(["generate", PROMPT, "--fill", "named", "--no-pictures", "--out", str(tmp_path / "room")])
    told = capsys.readouterr()
    assert "model" not in told.out + told.err


def test_what_found_no_place_counts_as_not_where_the_model_said(babbled):
    lost = [structs.replace(done, chosen=None) for done in babbled[0].trace[:3]]
    assert whose(lost) == "where the model said: 0 of 1 object; not readable: 4 of 4 answers (format 4)"
