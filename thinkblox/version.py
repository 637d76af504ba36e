"""Which release this is."""

from functools import cache


@cache
def package_version() -> str:
    """The installed version of this package, or "0+unknown" when it runs from a bare source tree."""
    # Loaded here, for few who import the package ask.
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("thinkblox")
    except PackageNotFoundError:
        return "0+unknown"
