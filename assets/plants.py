"""Plants: a pot, soil, and leaves that are thin hulls about a stem; flowers."""

from math import cos, pi, radians, sin

import numpy as np

from thinkblox.assets.palette import LEAVES, PAPER, PETALS, SOIL, STEEL, WICKER
from thinkblox.assets.part import Build, Finish, Part, hull, turned
from thinkblox.assets.shapes import around, box, disc, ellipsoid, frustum, pad, rod
from thinkblox.assets.spec import Spec
from thinkblox.value import Vec2, Vec3

_POTS = ("ceramic", "terracotta", "clay", "porcelain", "stone", "plastic", "metal", "wicker", "paper")
"""Words for what a pot is made of."""
_PRESSED = 2e-4
"""What is no thicker along some axis is pressed flat [m]."""


def pot(finish: Finish, radius: float, height: float) -> list[Part]:
    """Return a tapered pot with a rim, filled with soil [m]."""
    return [
        disc(finish, (0, 0), 0.7 * radius, (0, 0.006)),
        frustum(finish, (0, 0), (0.006, 0.86 * height), 0.7 * radius, 0.94 * radius),
        disc(finish, (0, 0), radius, (0.86 * height, 0.985 * height)),
        disc(SOIL, (0, 0), 0.88 * radius, (0.985 * height, height)),
    ]


def leaf(
    finish: Finish, base: Vec3, azimuth: float, pitch: float, length: float, width: float, droop: float = 18.0
) -> Part:
    """Return a pointed leaf that leaves `base` at an azimuth and a pitch above the level [degrees, m]."""
    out = np.array([cos(radians(azimuth)), sin(radians(azimuth)), 0.0])
    side = np.array([-out[1], out[0], 0.0])
    up = np.array([0.0, 0.0, 1.0])
    ridge = [np.array(base)]
    for k in range(1, 5):
        angle = radians(pitch - droop * k / 2)
        ridge.append(ridge[-1] + length / 4 * (cos(angle) * out + sin(angle) * up))
    points: list[Vec3] = []
    for at, half in zip(ridge, (0.06, 0.42, 0.5, 0.34, 0.02), strict=True):
        for shift in (-half, half):
            p = at + shift * width * side
            points += [(float(p[0]), float(p[1]), float(p[2])), (float(p[0]), float(p[1]), float(p[2]) + 0.004)]
    return hull(finish, points, smooth=False)


def plant(spec: Spec) -> Build:
    """Return a tall plant in a floor pot: broad leaves on a stem, a fan of blades, or a small tree."""
    x, y, z = spec.size
    reach = min(x, y) / 2
    finish = spec.main(spec.choice((spec.style.glaze, WICKER, spec.style.glaze)))
    height = min(0.32, 0.26 * z)
    build = Build(body=pot(finish, min(0.42 * min(x, y), 0.17), height))
    grow = spec.choice((_broad, _blades, _tree))
    build.body += kept_inside(grow(spec, reach, height, z), (reach, reach), z)
    return build


def kept_inside(parts: list[Part], half: Vec2, top: float) -> list[Part]:
    """Keep leaves within the box by clamping their corners, so that the pot keeps its shape.

    A leaf that grows wholly outside is pressed flat by that, and left out.
    """
    kept: list[Part] = []
    for part in parts:
        if part.kind != "hull":
            kept.append(part)
            continue
        points = [
            (float(np.clip(a, -half[0], half[0])), float(np.clip(b, -half[1], half[1])), min(c, top))
            for a, b, c in part.points
        ]
        if float(np.ptp(points, axis=0).min()) > _PRESSED:
            kept.append(hull(part.finish, points, smooth=part.smooth))
    return kept


def _broad(spec: Spec, reach: float, low: float, z: float) -> list[Part]:
    count, parts = (
        11,
        [
            rod(
                Finish((0.35, 0.33, 0.20), "wood"),
                (0, 0, low - 0.01),
                (0, 0, low + 0.45 * (z - low)),
                0.014,
                end_radius=0.008,
            )
        ],
    )
    for k in range(count):
        level = k / (count - 1)
        base = (0.0, 0.0, low + (0.04 + 0.40 * level) * (z - low))
        azimuth, pitch = k * 137.5 + spec.between(-8, 8), 38 + 38 * level
        stem = 0.3 * (z - low) * spec.between(0.8, 1.1)
        out = (
            stem * cos(radians(pitch)) * cos(radians(azimuth)),
            stem * cos(radians(pitch)) * sin(radians(azimuth)),
            stem * sin(radians(pitch)),
        )
        tip = (base[0] + out[0], base[1] + out[1], base[2] + out[2])
        parts.append(rod(LEAVES[2], base, tip, 0.005, sides=5))
        parts.append(
            leaf(spec.choice(LEAVES), tip, azimuth, pitch - 30, 0.62 * reach + 0.1, 0.4 * reach + 0.04, droop=24)
        )
    return parts


def _blades(spec: Spec, reach: float, low: float, z: float) -> list[Part]:
    parts = []
    for k in range(13):
        azimuth = k * 137.5
        spread = 0.35 * reach * (k / 13) ** 0.5
        base = (spread * cos(radians(azimuth)), spread * sin(radians(azimuth)), low - 0.01)
        length = (z - low) * spec.between(0.7, 1.0) * (1.0 if k == 0 else 0.95)
        parts.append(
            leaf(spec.choice(LEAVES), base, azimuth, 88 - 14 * (k / 13), length, 0.055 + 0.08 * reach, droop=4)
        )
    return parts


def _tree(spec: Spec, reach: float, low: float, z: float) -> list[Part]:
    trunk = Finish((0.40, 0.30, 0.21), "wood")
    fork = low + 0.4 * (z - low)
    parts = [rod(trunk, (0, 0, low - 0.01), (0.02, 0, fork), 0.018, end_radius=0.012)]
    for k in range(4):
        a = pi / 2 * k + spec.between(-0.3, 0.3)
        tip = (0.45 * reach * cos(a), 0.45 * reach * sin(a), fork + (0.28 + 0.08 * (k % 2)) * (z - low))
        parts.append(rod(trunk, (0.02, 0, fork - 0.01), tip, 0.009, sides=6, end_radius=0.005))
        turn = float(np.degrees(a)) + 20
        parts += [
            leaf(spec.choice(LEAVES), tip, turn + 90 * j, 46 - 26 * (j % 2), 0.78 * reach, 0.44 * reach, droop=22)
            for j in range(4)
        ]
    crown = (0.02, 0.0, z - 0.36 * reach)
    parts.append(rod(trunk, (0.02, 0, fork - 0.01), crown, 0.01, sides=6, end_radius=0.005))
    parts += [
        leaf(LEAVES[k], crown, 120.0 * k + 40, 58 - 8 * k, 0.66 * reach, 0.42 * reach, droop=18) for k in range(3)
    ]
    return parts


def potted_plant(spec: Spec) -> Build:
    """Return a small plant for a table, or a flowering pot; where words say what the pot is of, that is most of it."""
    x, y, z = spec.size
    reach = min(x, y) / 2
    large = spec.has(*_POTS)
    wide, height = (0.76, 0.47 * z) if large else (0.6, 0.38 * z)
    finish = spec.main(spec.choice((spec.style.glaze, Finish((0.73, 0.44, 0.32), "ceramic"))))
    build = Build(body=pot(finish, wide * reach, height))
    green = spec.choice(LEAVES)
    parts: list[Part] = []
    for k in range(1 if large else 0, 12, 2 if large else 1):
        pitch = 22 + 58 * k / 11
        parts.append(
            leaf(
                green if k % 3 else LEAVES[1],
                (0, 0, height - 0.005),
                k * 137.5,
                pitch,
                (z - height) * (0.72 + 0.32 * k / 11),
                0.34 * reach,
                droop=14,
            )
        )
    if spec.has("flowering", "flower", "flowers") or spec.rng.random() < 0.4:
        petal = spec.choice(PETALS)
        for k in range(4):
            a, top = 1.6 * k, z - 0.02 - 0.05 * z * k
            tip = (0.3 * reach * cos(a), 0.3 * reach * sin(a), top)
            parts += [rod(LEAVES[2], (0, 0, height), tip, 0.003, sides=5), *_blossom(petal, tip, 0.14 * reach + 0.008)]
    build.body += kept_inside(parts, (reach, reach), z)
    return build


def _blossom(petal: Finish, at: Vec3, radius: float) -> list[Part]:
    x, y, z = at
    return [ellipsoid(petal, (x - radius, x + radius), (y - radius, y + radius), (z - 0.5 * radius, z + 0.5 * radius))]


def cut_flower(spec: Spec) -> Build:
    """Return a flower on its stem that lies, its blossom to the left; "upright" it stands on its cut end."""
    x, y, z = spec.size
    petal = spec.main(spec.choice(PETALS))
    if spec.has("upright"):
        r = min(x, y) / 2
        body: list[Part] = [
            disc(LEAVES[2], (0, 0), 0.4 * r, (0, 0.004)),
            disc(LEAVES[2], (0, 0), 0.12 * r, (0.004, z - r)),
            ellipsoid(petal, (-r, r), (-r, r), (z - 1.4 * r, z)),
        ]
        body += [box(LEAVES[1], (s * 0.8 * r, 0.0), around(0, 0.3 * r), around(h * z, 0.004)) for s, h in _LEAVES]
        return Build(body=body, front="any")
    stem = min(0.008, 0.3 * z)
    body = [
        box(LEAVES[2], around(0, stem), (-y / 2, y / 2 - z), (0, stem)),
        pad(petal, (-x / 2, x / 2), (y / 2 - 1.2 * x, y / 2), (0, z), flat=True),
    ]
    body += [box(LEAVES[1], (s * 0.4 * x, 0.0), around((h - 0.5) * y, 0.4 * x), (0, 0.003)) for s, h in _LEAVES]
    return Build(body=body)


_LEAVES = ((-1, 0.45), (1, 0.6))
"""The leaves of a cut flower: at which side, and at which share of its length."""


def bouquet(spec: Spec) -> Build:
    """Return a bunch of flowers in paper that lies, its blossoms to the left; "upright" it stands on its stems."""
    x, y, z = spec.size
    if not spec.has("upright"):
        lying = Spec(spec.category, (z, x, y), frozenset({"upright", *spec.words}), spec.style, spec.rng)
        parts = [turned(part, 0, -90.0, (0.0, 0.0, 0.0)) for part in bouquet(lying).body]
        wrap = box(PAPER, around(0, 0.8 * x), (0.3 * y, 0.97 * y), (-0.5 * x, -0.47 * x))
        return Build(body=[*parts, wrap])
    r = min(x, y) / 2
    body: list[Part] = [
        disc(LEAVES[2], (0, 0), 0.45 * r, (0, 0.1 * z)),
        frustum(PAPER, (0, 0), (0.1 * z, 0.72 * z), 0.4 * r, 0.8 * r),
        frustum(LEAVES[3], (0, 0), (0.72 * z, 0.8 * z), 0.8 * r, 0.9 * r),
    ]
    petal = spec.main(spec.choice(PETALS))
    for k in range(9):
        a, away = radians(137.5 * k), 0.7 * r * (k / 8) ** 0.5
        tint = petal if k % 3 else spec.choice(PETALS)
        body += _blossom(tint, (away * cos(a), away * sin(a), z - 0.14 * r - 0.1 * z * (k / 8) ** 2), 0.28 * r)
    return Build(body=body, front="any")


def flower_bucket(spec: Spec) -> Build:
    """Return a zinc bucket of cut flowers."""
    x, y, z = spec.size
    reach, height = min(x, y) / 2, 0.48 * z
    radius = 0.62 * reach
    body: list[Part] = [
        disc(STEEL, (0, 0), 0.74 * radius, (0, 0.006)),
        frustum(spec.main(STEEL), (0, 0), (0.006, height), 0.74 * radius, radius),
    ]
    body.append(disc(LEAVES[3], (0, 0), 0.9 * radius, (height, height + 0.012)))
    petal, parts = spec.choice(PETALS), []
    for k in range(11):
        a, spread = radians(137.5 * k), reach * (k / 11) ** 0.5 * 0.85
        tip = (spread * cos(a), spread * sin(a), z - 0.04 - 0.2 * z * (k / 11) ** 1.5)
        parts.append(rod(LEAVES[2], (0.4 * tip[0], 0.4 * tip[1], height), tip, 0.004, sides=5))
        parts += _blossom(petal if k % 3 else spec.choice(PETALS), tip, 0.15 * reach)
        if k % 2:
            parts.append(
                leaf(
                    LEAVES[k % 4],
                    (0.45 * tip[0], 0.45 * tip[1], height + 0.03),
                    137.5 * k,
                    50,
                    0.6 * reach,
                    0.2 * reach,
                )
            )
    return Build(body=body + kept_inside(parts, (reach, reach), z))
