"""Open forms: how a thing is made that is told to hold others and is usually made shut, solid or full.

The form of a category that stands under "holds" in its facts is one of FORMS, unless its own generator knows the word
and gives it room for others itself.
"""

from collections import defaultdict
from collections.abc import Callable, Collection, Mapping
from itertools import pairwise

from thinkblox.assets.part import Build, Finish, Part, bounds, turned
from thinkblox.assets.shapes import around, box, disc, inner_surface, shell, top_surface
from thinkblox.scene.asset import Surface
from thinkblox.value import Vec3

PITCH = 0.42
"""About how far the boards of an open case or a rack are apart [m]."""
TIERED, FOR_LONG = "tiered", "for-long-things"
"""The forms of a rack: for what lies in it, and for what is too long for that and stands."""
_THIN = (0.003, 0.018)
"""Least and greatest thickness of walls and boards [m]."""
_LIP = 0.02
"""How far the edges of the boards of a rack stand up [m]."""


def is_open(build: Build) -> bool:
    """Whether something can be put into a thing as it is made."""
    return any(surface.inner for surface in build.surfaces)


def opened(build: Build, words: Collection[str], *, round: bool) -> Build:
    """Return the open form of a build that the words name, in its finishes; the build itself where they name none.

    Args:
        build: as the generator made it.
        words: attributes of the thing.
        round: whether it looks the same all round, so that an open vessel of it is round.
    """
    form = next((FORMS[word] for word in FORMS if word in words), None)
    if form is None or is_open(build):
        return build
    low, high = bounds(build.parts)
    size = (high[0] - low[0], high[1] - low[1], high[2] - low[2])
    main, accent = _finishes(build)
    if form is open_box and round:
        return open_vessel(size, main, accent)
    return form(size, main, accent)


def _finishes(build: Build) -> tuple[Finish, Finish]:
    """The finish that most of a thing is made of, and another of it."""
    volumes: dict[Finish, float] = defaultdict(float)
    for part in build.parts:
        x, y, z = part.size
        volumes[part.finish] += x * y * z
    ordered = sorted(volumes, key=lambda finish: -volumes[finish])
    return ordered[0], ordered[min(1, len(ordered) - 1)]


def _thin(size: Vec3) -> float:
    return max(_THIN[0], min(_THIN[1], 0.06 * min(size)))


def open_box(size: Vec3, main: Finish, accent: Finish) -> Build:
    """Return a box without a lid, its rim and bottom of the accent."""
    x, y, z = size
    wall = _thin(size)
    rim = z - max(wall, 0.04 * z)
    inner = (around(0, x - 2 * wall), around(0, y - 2 * wall))
    body: list[Part] = [box(accent, *inner, (0, wall))]
    for finish, height in ((main, (0.0, rim)), (accent, (rim, z))):
        body += [box(finish, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - wall)), height) for s in (-1, 1)]
        body += [box(finish, (s * x / 2, s * (x / 2 - wall)), inner[1], height) for s in (-1, 1)]
    return Build(body=body, surfaces=[inner_surface("inside", *inner, wall)])


def open_vessel(size: Vec3, main: Finish, accent: Finish) -> Build:
    """Return a round vessel without a lid, its rim of the accent."""
    x, y, z = size
    r, wall = min(x, y) / 2, _thin(size)
    rim, foot = z - max(wall, 0.04 * z), 0.86
    body: list[Part] = [disc(main, (0, 0), foot * r, (0, wall))]
    body += shell(main, (0, 0), (0.5 * wall, rim), foot * r + 0.001, 0.98 * r, wall, pieces=16)
    body += shell(accent, (0, 0), (rim, z), r, r, 1.2 * wall, pieces=16)
    across = around(0, 2 * (foot * r - wall))
    return Build(body=body, surfaces=[inner_surface("bottom", across, across, wall, round=True)], front="any")


def open_case(size: Vec3, main: Finish, accent: Finish) -> Build:
    """Return a case that is open at its front, with boards where it is high enough for several."""
    return _case(size, main, accent, max(1, round(size[2] / PITCH)))


def lidded(size: Vec3, main: Finish, lid: Finish, rim: float) -> Build:
    """Return a box with its sides up to `rim` [m] and its lid standing open at the back, up to its full height."""
    x, y, z = size
    build, thick = open_box((x, y, rim), main, main), min(0.03, 0.25 * (z - rim))
    build.body.append(box(lid, (-x / 2, -x / 2 + thick), (-y / 2, y / 2), (rim, z)))
    return build


def booth(size: Vec3, main: Finish, accent: Finish) -> Build:
    """Return a cabin: a floor, three walls and a roof, open at its front."""
    return _case(size, main, accent, 1)


def _case(size: Vec3, main: Finish, accent: Finish, rows: int) -> Build:
    x, y, z = size
    wall = _thin(size)
    inner = ((-x / 2 + wall, x / 2), around(0, y - 2 * wall))
    body: list[Part] = [box(main, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - wall)), (0, z)) for s in (-1, 1)]
    body.append(box(main, (-x / 2, -x / 2 + wall), inner[1], (0, z)))
    body.append(box(main, *inner, (z - wall, z)))
    surfaces = [top_surface("top", (-x / 2, x / 2), (-y / 2, y / 2), z)]
    levels = [wall + k * (z - wall) / rows for k in range(rows)] + [z]
    for level, above in pairwise(levels):
        body.append(box(accent, *inner, (level - wall, level)))
        shelf = inner_surface(f"shelf at {level:.2f} m", *inner, level, headroom=above - wall - level)
        surfaces.append(shelf)
    return Build(body=body, surfaces=surfaces)


def tiers(size: Vec3, main: Finish, accent: Finish) -> Build:
    """Return a rack: boards with low edges between two sides of posts, under a bar that joins them at the top."""
    x, y, z = size
    post, rows = max(0.012, min(0.04, 0.1 * min(x, y))), max(1, round(z / PITCH))
    thin, lip = _thin(size), min(_LIP, 0.06 * z)
    body: list[Part] = []
    for s in (-1, 1):
        side = (s * y / 2, s * (y / 2 - post))
        body += [box(main, (t * x / 2, t * (x / 2 - post)), side, (0, z)) for t in (-1, 1)]
        body += [box(main, around(0, x - 2 * post), side, height) for height in ((0, post), (z - post, z))]
    body.append(box(main, (-x / 2, -x / 2 + post), around(0, y - 2 * post), (z - post, z)))
    inner = (around(0, x - 2 * thin), around(0, y - 2 * post))
    surfaces: list[Surface] = []
    pitch = (z - post - 0.04 * z) / rows
    for k in range(rows):
        level = 0.04 * z + thin + k * pitch
        body.append(box(accent, (-x / 2, x / 2), inner[1], (level - thin, level)))
        body += [box(accent, (t * x / 2, t * (x / 2 - thin)), inner[1], (level, level + lip)) for t in (-1, 1)]
        surfaces.append(top_surface(f"tier {k + 1}", *inner, level, headroom=pitch - thin))
    return Build(body=body, surfaces=surfaces)


def long_rack(size: Vec3, main: Finish, accent: Finish) -> Build:
    """Return a rack for long things that stand in it: a tray between posts, with rails at the back, open at the top."""
    x, y, z = size
    post, thin = max(0.012, min(0.04, 0.1 * min(x, y))), _thin(size)
    rim = min(0.3, 0.2 * z)
    body: list[Part] = [box(accent, (-x / 2, x / 2), (-y / 2, y / 2), (0, thin))]
    body += [box(main, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - thin)), (thin, rim)) for s in (-1, 1)]
    body += [box(main, (s * x / 2, s * (x / 2 - thin)), around(0, y - 2 * thin), (thin, rim)) for s in (-1, 1)]
    back = (-x / 2, -x / 2 + post)
    body += [box(main, back, (s * y / 2, s * (y / 2 - post)), (rim, z)) for s in (-1, 1)]
    body += [box(main, back, around(0, y - 2 * post), (share * z - post, share * z)) for share in (0.6, 1.0)]
    inner = ((-x / 2 + post, x / 2 - thin), around(0, y - 2 * thin))
    return Build(body=body, surfaces=[inner_surface("tray", *inner, thin)])


def stood_up(build: Build, axis: int) -> Build:
    """Return a long thing that lies along a level axis (0 or 1) on its heavier end, on a foot that keeps it there."""
    parts = build.parts
    low, high = bounds(parts)
    volumes = [p.size[0] * p.size[1] * p.size[2] for p in parts]
    heavy = sum(v * p.centre[axis] for v, p in zip(volumes, parts, strict=True)) / sum(volumes)
    down = heavy < (low[axis] + high[axis]) / 2
    degrees = (90.0 if axis == 1 else -90.0) * (1.0 if down else -1.0)
    raised = [turned(part, 1 - axis, degrees, (0.0, 0.0, 0.0)) for part in parts]
    low, high = bounds(raised)
    middle = [sum(v * p.centre[i] for v, p in zip(volumes, raised, strict=True)) / sum(volumes) for i in range(2)]
    reach = min(min(middle[i] - low[i], high[i] - middle[i]) for i in range(2))
    foot = disc(_finishes(build)[0], (middle[0], middle[1]), reach, (low[2] - 0.003, low[2] + 0.003))
    return Build(body=[*raised, foot])


FORMS: Mapping[str, Callable[[Vec3, Finish, Finish], Build]] = {
    "open": open_box,
    "open-fronted": open_case,
    "walk-in": booth,
    TIERED: tiers,
    FOR_LONG: long_rack,
}
"""What the words for an open form mean."""
