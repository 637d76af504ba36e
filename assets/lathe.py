"""Things turned about an upright axis, each told by its outline: fruit, tins, flasks, barrels, balls."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import cos, pi, sin, sqrt

from thinkblox.assets.palette import GLASS, GREY_METAL, KRAFT, OAK, STEEL, WHITE_PLASTIC
from thinkblox.assets.part import Build, Finish, Part, hull
from thinkblox.assets.shapes import disc, frustum, rounded_rings, top_surface
from thinkblox.assets.spec import Spec
from thinkblox.assets.vessels import turned_solid
from thinkblox.value import Vec2, Vec3


@dataclass(frozen=True)
class Band:
    """A stripe or label around what is turned, in shares of its height; it stands out by a hundredth.

    Attributes:
        radius: share of the full radius that the outline has there.
    """

    colours: tuple[Vec3, ...]
    low: float
    high: float
    radius: float = 1.0
    material: str = "paper"


def lathe(
    finishes: Sequence[Finish],
    outline: Sequence[Vec2],
    *,
    smooth: bool = False,
    convex: bool = False,
    cap: tuple[Finish, Sequence[Vec2]] | None = None,
    bands: Sequence[Band] = (),
    flat_top: bool = False,
) -> Callable[[Spec], Build]:
    """Return a generator of solids of revolution.

    Args:
        finishes: one is drawn, unless a colour is asked for.
        outline: rings (share of the height, share of the radius), from the foot up.
        smooth: whether the outline bends through its rings.
        convex: whether it only bulges: then it is one solid without edges.
        cap: finish and rings of what stands on top: a lid, a stalk, a valve.
        bands: stripes and labels.
        flat_top: whether things can be put on its last ring.
    """

    def generate(spec: Spec) -> Build:
        x, y, z = spec.size
        radius = min(x, y) / 2
        finish = spec.main(spec.choice(finishes))
        if convex:
            body = [_bulging(finish, radius, z, outline)]
        else:
            body = turned_solid(finish, radius, z, outline, round=smooth)
        if cap:
            body += [
                frustum(cap[0], (0, 0), (a[0] * z, b[0] * z), a[1] * radius, b[1] * radius) for a, b in pairwise(cap[1])
            ]
        body += [_stripe(spec, band, radius, z) for band in bands]
        top = outline[-1][1] * radius
        surfaces = [top_surface("top", (-top, top), (-top, top), z, round=True)] if flat_top else []
        return Build(body=body, surfaces=surfaces)

    return generate


def _bulging(finish: Finish, radius: float, z: float, outline: Sequence[Vec2]) -> Part:
    rings = rounded_rings([(h * z, r * radius) for h, r in outline])
    angles = [2 * pi * k / 20 for k in range(20)]
    return hull(finish, [(r * cos(a), r * sin(a), h) for h, r in rings for a in angles], smooth=True)


def _stripe(spec: Spec, band: Band, radius: float, z: float) -> Part:
    finish = Finish(spec.choice(band.colours), "paper" if band.material == "paper" else "plastic")
    return disc(finish, (0, 0), 1.01 * band.radius * radius, (band.low * z, band.high * z), collide=False)


def _skins(*colours: Vec3) -> tuple[Finish, ...]:
    return tuple(Finish(colour, "plastic") for colour in colours)


BALL: tuple[Vec2, ...] = tuple(
    (h, max(0.26, 2 * sqrt(h * (1 - h)))) if h else (0.0, 0.26) for h in (0.0, 0.06, 0.2, 0.4, 0.6, 0.8, 0.94, 1.0)
)
"""Outline of a ball on a small flat foot."""
_STALK = Finish((0.35, 0.27, 0.16), "wood")
_LABELS: tuple[Vec3, ...] = ((0.78, 0.22, 0.18), (0.20, 0.40, 0.62), (0.28, 0.50, 0.30), (0.92, 0.74, 0.30))

apple = lathe(
    _skins((0.74, 0.18, 0.15), (0.56, 0.67, 0.24), (0.83, 0.33, 0.20)),
    ((0.0, 0.4), (0.1, 0.74), (0.36, 1.0), (0.58, 0.99), (0.76, 0.8), (0.87, 0.3)),
    convex=True,
    cap=(_STALK, ((0.84, 0.06), (1.0, 0.05))),
)
orange = lathe(_skins((0.94, 0.55, 0.13), (0.95, 0.60, 0.18)), BALL, convex=True)
lemon = lathe(
    _skins(
        (0.95, 0.83, 0.25),
    ),
    ((0.0, 0.3), (0.12, 0.72), (0.4, 1.0), (0.6, 1.0), (0.85, 0.62), (0.95, 0.26), (1.0, 0.1)),
    convex=True,
)
pear = lathe(
    _skins((0.70, 0.72, 0.30), (0.80, 0.74, 0.36)),
    ((0.0, 0.4), (0.12, 0.86), (0.3, 1.0), (0.5, 0.82), (0.7, 0.5), (0.84, 0.4), (0.9, 0.16)),
    smooth=True,
    cap=(_STALK, ((0.88, 0.06), (1.0, 0.05))),
)
tomato = lathe(
    _skins(
        (0.80, 0.20, 0.13),
    ),
    ((0.0, 0.45), (0.12, 0.8), (0.45, 1.0), (0.75, 0.86), (0.92, 0.4)),
    convex=True,
    cap=(Finish((0.30, 0.48, 0.22), "leaf"), ((0.9, 0.4), (0.95, 0.08), (1.0, 0.05))),
)
pumpkin = lathe(
    _skins((0.90, 0.48, 0.14), (0.86, 0.55, 0.22)),
    ((0.0, 0.5), (0.1, 0.8), (0.38, 1.0), (0.62, 0.94), (0.78, 0.6), (0.82, 0.3)),
    convex=True,
    cap=(Finish((0.42, 0.44, 0.22), "leaf"), ((0.78, 0.16), (0.9, 0.09), (1.0, 0.12))),
)
cake = lathe(
    _skins((0.95, 0.90, 0.82), (0.45, 0.28, 0.18), (0.93, 0.72, 0.74)),
    ((0.0, 1.0), (0.08, 1.0), (0.081, 0.86), (0.82, 0.86), (0.84, 0.82)),
    cap=(Finish((0.76, 0.18, 0.18), "plastic"), ((0.84, 0.12), (0.95, 0.12), (1.0, 0.05))),
    bands=(Band(((0.96, 0.95, 0.92), (0.90, 0.80, 0.60)), 0.4, 0.5, 0.86),),
)
tin_can = lathe(
    (STEEL,), ((0.0, 0.95), (0.06, 1.0), (0.95, 1.0), (1.0, 0.95)), bands=(Band(_LABELS, 0.08, 0.92),), flat_top=True
)
soda_can = lathe(
    _skins(*_LABELS),
    ((0.0, 0.76), (0.06, 1.0), (0.88, 1.0)),
    cap=(STEEL, ((0.88, 1.0), (0.97, 0.8), (1.0, 0.8))),
    bands=(Band(((0.93, 0.92, 0.90),), 0.38, 0.6, material="plastic"),),
)
thermos = lathe(
    (STEEL, GREY_METAL, *_skins((0.22, 0.36, 0.34), (0.70, 0.22, 0.20))),
    ((0.0, 0.96), (0.03, 1.0), (0.7, 1.0), (0.76, 0.8)),
    cap=(Finish((0.16, 0.16, 0.17), "plastic"), ((0.76, 0.8), (0.98, 0.76), (1.0, 0.7))),
)
barrel = lathe(
    (OAK,),
    ((0.0, 0.82), (0.25, 0.96), (0.5, 1.0), (0.75, 0.96), (1.0, 0.82)),
    smooth=True,
    bands=tuple(
        Band(((0.24, 0.23, 0.23),), h, h + 0.05, r, "metal")
        for h, r in ((0.08, 0.9), (0.3, 0.98), (0.65, 0.98), (0.87, 0.9))
    ),
    flat_top=True,
)
drum_barrel = lathe(
    _skins((0.20, 0.36, 0.56), (0.24, 0.42, 0.32), (0.66, 0.20, 0.16)),
    (
        (0.0, 1.0),
        (0.32, 0.97),
        (0.34, 1.0),
        (0.36, 0.97),
        (0.65, 0.97),
        (0.67, 1.0),
        (0.69, 0.97),
        (0.98, 0.97),
        (1.0, 1.0),
    ),
    flat_top=True,
)
gas_bottle = lathe(
    _skins((0.76, 0.20, 0.16), (0.20, 0.34, 0.52), (0.60, 0.62, 0.64)),
    ((0.0, 0.9), (0.02, 0.96), (0.03, 1.0), (0.78, 1.0), (0.86, 0.8), (0.9, 0.36)),
    cap=(STEEL, ((0.9, 0.26), (0.94, 0.26), (0.941, 0.4), (0.97, 0.4), (0.971, 0.16), (1.0, 0.16))),
    bands=(Band(((0.94, 0.93, 0.90),), 0.5, 0.62),),
)
flask = lathe((GLASS,), ((0.0, 0.96), (0.04, 1.0), (0.66, 0.32), (0.94, 0.32), (0.96, 0.38), (1.0, 0.38)))
paint_pot = lathe(
    (GREY_METAL, STEEL), ((0.0, 1.0), (0.95, 1.0), (1.0, 0.94)), bands=(Band(_LABELS, 0.1, 0.8),), flat_top=True
)
sports_ball = lathe(
    _skins((0.86, 0.46, 0.20), (0.93, 0.92, 0.90), (0.20, 0.42, 0.62), (0.80, 0.24, 0.2)), BALL, convex=True
)
smoke_detector = lathe((WHITE_PLASTIC,), ((0.0, 0.5), (0.3, 0.66), (0.32, 0.94), (0.9, 1.0), (1.0, 1.0)))
sack = lathe(
    (KRAFT, Finish((0.86, 0.82, 0.72), "fabric")),
    ((0.0, 0.8), (0.1, 0.98), (0.4, 1.0), (0.7, 0.86), (0.82, 0.4), (0.87, 0.26), (0.95, 0.4), (1.0, 0.5)),
    smooth=True,
)
cloche = lathe(
    (STEEL,),
    ((0.0, 1.0), (0.03, 1.0), (0.031, 0.95), (0.35, 0.92), (0.6, 0.76), (0.8, 0.45), (0.86, 0.2)),
    convex=True,
    cap=(STEEL, ((0.86, 0.06), (0.9, 0.06), (0.91, 0.12), (1.0, 0.08))),
)
