"""Nothing that a file or a name holds steers a terminal or a page."""

import json
import unicodedata
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from thinkblox.cli import main
from thinkblox.cli.terminal import complain, say, write_json
from thinkblox.page.markup import element
from thinkblox.plain_text import escaped

STEERING = "\x1b]0;owned\x07", "\x9b31m", "a\rb", "\u202egpj.exe", "\udc80", "a\nall passed", "a\u2028b", "\x7f"


def steers(text: str) -> bool:
    return any(unicodedata.category(c) in ("Cc", "Cs", "Zl", "Zp") or "\u202a" <= c <= "\u202e" for c in text)


@pytest.mark.parametrize("text", STEERING)
def test_what_is_shown_is_escaped(text: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert not steers(escaped(text))
    assert not steers(str(element("p", text)).replace("\n", ""))
    complain(text)
    assert not steers(capsys.readouterr().err.removesuffix("\n"))
    say(text)
    assert not steers(capsys.readouterr().out.replace("\n", ""))


@given(text=st.text())
def test_no_text_steers_and_plain_text_is_kept(text: str) -> None:
    assert not steers(escaped(text))
    assert steers(text) or escaped(text) == text or any(c in text for c in "\u200e\u200f\u2066\u2067\u2068\u2069")


def test_json_means_the_same(capsys: pytest.CaptureFixture[str]) -> None:
    value = {"a\x9b": "b\u202e\x7f \u00e9\u4e2d", "c": [1.5, "\x1b"]}
    write_json(json.dumps(value, ensure_ascii=False).encode())
    written = capsys.readouterr().out
    assert not steers(written)
    assert json.loads(written) == value
    assert "\u00e9\u4e2d" in written


@pytest.mark.parametrize("name", ["\x1b[31mred.json", "two\nlines.xml", "\udc80.urdf"])
def test_the_name_of_a_file_is_printed_escaped(tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", str(tmp_path / name)]) == 2
    said = capsys.readouterr().err
    assert said.startswith("thinkblox: ")
    assert not steers(said.removesuffix("\n"))
