"""What models are told: templates in files of their own, beside the types of their answers.

A template is text with `$names`, filled by `filled`. A change of any is a new version: NUMBER is raised by hand,
and the version says besides what the files hold, so that a trace tells which prompts it was made with.
"""

from functools import cache
from hashlib import sha256
from pathlib import Path
from string import Template
from typing import Literal, get_args

TemplateName = Literal["objects", "plan", "step", "revision", "edit", "one_shot"]
"""Object-set extraction, global planning, one step, its revision after a rejection, an edit, a whole room at once."""
JudgeName = Literal["judge_step", "judge_room"]
"""What a judge is asked: whether an object is well placed, and how good a room is. No policy is told this."""
NUMBER = 1
"""Raised with every change of meaning."""


@cache
def template(name: TemplateName | JudgeName) -> str:
    """The text of a template."""
    return Path(__file__).with_name(f"{name}.txt").read_text(encoding="utf-8").rstrip("\n")


def filled(name: TemplateName | JudgeName, **values: str) -> str:
    """A template with its names filled in; raises KeyError where one is missing."""
    return Template(template(name)).substitute(values)


@cache
def prompts_version() -> str:
    """The version of all templates together: "1-5f0c2a9b"."""
    texts = "\0".join(template(name) for name in get_args(TemplateName))
    return f"{NUMBER}-{sha256(texts.encode()).hexdigest()[:8]}"


def one_line(text: str) -> str:
    """Text of a user's on one line, so that it cannot look like another part of a prompt."""
    return " ".join(text.split())
