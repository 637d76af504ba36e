"""The package page: README.md with its relative links made absolute, as that page lies nowhere near the files."""

import re
from pathlib import Path

from setuptools import setup

HOME = "https://github.com/thinkblox/thinkblox/blob/main/"
RAW = "https://raw.githubusercontent.com/thinkblox/thinkblox/main/"


def absolute(text: str) -> str:
    """The text with every relative Markdown link made absolute, pictures to the raw files."""
    return re.sub(
        r"(?P<picture>!?)\[(?P<label>[^]]*)\]\((?!https?:|#)(?P<path>[^)]+)\)",
        lambda m: f"{m['picture']}[{m['label']}]({RAW if m['picture'] else HOME}{m['path']})",
        text,
    )


if __name__ == "__main__":
    readme = (Path(__file__).parent / "README.md").read_text(encoding="utf-8")
    setup(long_description=absolute(readme), long_description_content_type="text/markdown")
