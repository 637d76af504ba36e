"""The items of Wikidata that categories are, where one is known."""

import tomllib
from functools import cache
from importlib.resources import files


def wikidata_item(category: str) -> str | None:
    """The item of a category, such as "Q15026" of "chair", or of a broader one; None where none is known."""
    return _items().get(category)


@cache
def _items() -> dict[str, str]:
    text = files("thinkblox.exporters").joinpath("wikidata.toml").read_text(encoding="utf-8")
    return {category: item for item, categories in tomllib.loads(text).items() for category in categories}
