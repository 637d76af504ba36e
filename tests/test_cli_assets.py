"""`thinkblox assets list`: the catalogue, as a table, one category at a time, and as JSON."""

import json
import os
import subprocess
import sys

from thinkblox.assets import CATALOGUE
from thinkblox.cli import main
from thinkblox.reading import read_brief


def entries(capsys) -> list[dict[str, object]]:
    assert main(["assets", "list", "--json"]) == 0
    found: list[dict[str, object]] = json.loads(capsys.readouterr().out)
    return found


def test_every_category_is_a_line(capsys):
    assert main(["assets", "list"]) == 0
    heading, *lines, last = capsys.readouterr().out.splitlines()
    assert heading.split()[0] == "category"
    assert [line.split()[0] for line in lines] == list(CATALOGUE)
    assert last.startswith(f"{len(CATALOGUE)} categories")


def test_one_category_in_full(capsys):
    assert main(["assets", "list", "--category", "bed"]) == 0
    out = capsys.readouterr().out
    for part in ("bed", "floor", "smallest", "largest", "kg", "double", "four poster bed"):
        assert part in out


def test_json_says_all_of_each(capsys):
    found = entries(capsys)
    assert [entry["name"] for entry in found] == list(CATALOGUE)
    for entry in found:
        kind = CATALOGUE[str(entry["name"])]
        assert entry["noun"] == kind.noun
        assert entry["mount"] == kind.mount
        assert entry["size"] == list(kind.size)
        assert entry["mass"] == kind.mass
        assert [entry["smallest"], entry["largest"]] == [list(size) for size in kind.size_range]
        assert set(kind.variants) <= set(entry["attributes"])  # type: ignore[call-overload]


def test_the_words_are_ones_that_mean_it(capsys):
    [desk] = [entry for entry in entries(capsys) if entry["name"] == "desk"]
    words = desk["words"]
    assert isinstance(words, list)
    assert "writing desk" in words
    for word in words[:3]:
        assert [r.category for r in read_brief(f"An empty room with a {word}.").requests] == ["desk"]


def test_json_of_one_category_is_a_list_of_one(capsys):
    assert main(["assets", "list", "--category", "desk", "--json"]) == 0
    assert [entry["name"] for entry in json.loads(capsys.readouterr().out)] == ["desk"]


def test_an_unknown_category_is_refused_with_close_ones(capsys):
    assert main(["assets", "list", "--category", "desq"]) == 2
    assert "desk" in capsys.readouterr().err


def test_a_reader_that_has_enough_is_no_error():
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, "-m", "thinkblox", "assets", "list"]
    done = subprocess.run(command, stdout=writer, stderr=subprocess.PIPE, text=True, check=False)
    os.close(writer)
    assert done.returncode == 141
    assert done.stderr == ""
