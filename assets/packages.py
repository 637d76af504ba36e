"""Boxes with something printed on them, and other packed goods."""

from collections.abc import Sequence

from thinkblox.assets.palette import BRIGHT, KRAFT, PAPER
from thinkblox.assets.part import Build, Finish, Part, hull
from thinkblox.assets.shapes import around, box, cushion, cylinder, top_surface
from thinkblox.assets.spec import Spec
from thinkblox.value import Vec3


def printed(spec: Spec, low: float, high: float, *, tones: Sequence[Vec3] = BRIGHT) -> list[Part]:
    """Return a box from `low` to `high` with a title, a disc and a line on its front and back [m]."""
    x, y, _ = spec.size
    paint = spec.main(Finish(spec.choice(tones), "paper"))
    tall = high - low
    inks = [Finish(BRIGHT[int(k)], "paper") for k in spec.rng.permutation(len(BRIGHT))]
    parts = [box(paint, (-x / 2, x / 2), (-y / 2, y / 2), (low, high))]
    for face in (x / 2, -x / 2):
        skin = around(face, 0.002)
        size = min(0.6 * y, 0.4 * tall)
        parts += [
            box(PAPER, skin, around(0, 0.8 * y), (low + 0.7 * tall, low + 0.88 * tall), collide=False),
            cylinder(inks[0], skin, around(0, size), around(low + 0.38 * tall, size), axis=0, collide=False),
            box(inks[1], skin, around(0, y), (low + 0.04 * tall, low + 0.1 * tall), collide=False),
        ]
    return parts


def packet(spec: Spec) -> Build:
    """Return an upright packet, such as of cereal."""
    x, y, z = spec.size
    body = printed(spec, 0.0, z)
    return Build(body=body, surfaces=[top_surface("top", (-x / 2, x / 2), (-y / 2, y / 2), z)])


def carton(spec: Spec) -> Build:
    """Return a drinks carton with a gable."""
    x, y, z = spec.size
    side = 0.78 * z
    body = printed(spec, 0.0, side, tones=((0.93, 0.93, 0.92), (0.90, 0.92, 0.95), (0.94, 0.90, 0.82)))
    paint = body[0].finish
    gable = [(u, v, side) for u in (-x / 2, x / 2) for v in (-y / 2, y / 2)]
    gable += [(u, v, 0.93 * z) for u in (-0.004, 0.004) for v in (-y / 2, y / 2)]
    body += [hull(paint, gable), box(paint, around(0, 0.006), (-y / 2, y / 2), (0.92 * z, z))]
    cap = cylinder(Finish(BRIGHT[1], "plastic"), around(0.26 * x, 0.02), around(0, 0.024), (0.84 * z, 0.9 * z))
    return Build(body=[*body, cap])


def flat_box(spec: Spec) -> Build:
    """Return a flat cardboard box with a print on its lid, such as a pizza's."""
    x, y, z = spec.size
    card = spec.main(KRAFT)
    wide = 0.62 * min(x, y)
    print_ = Finish((0.72, 0.22, 0.18), "paper")
    body = [
        box(card, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.92 * z)),
        box(card, (-0.49 * x, 0.49 * x), around(0, 0.98 * y), (0.92 * z, z)),
        cylinder(print_, around(0, wide), around(0, wide), (z - 0.001, z + 0.0004), collide=False),
    ]
    return Build(body=body, surfaces=[top_surface("lid", around(0, 0.98 * x), around(0, 0.98 * y), z)])


def game_box(spec: Spec) -> Build:
    """Return a flat box with a lid and a picture, as of a board game or a jigsaw."""
    x, y, z = spec.size
    paint = spec.main(Finish(spec.choice(BRIGHT), "paper"))
    inks = [Finish(BRIGHT[int(k)], "paper") for k in spec.rng.permutation(len(BRIGHT))]
    skin = (z - 0.001, z + 0.0004)
    body = [
        box(PAPER, around(0, 0.985 * x), around(0, 0.985 * y), (0, 0.3 * z)),
        box(paint, around(0, x), around(0, y), (0.2 * z, z)),
        box(PAPER, (-0.38 * x, -0.2 * x), around(0, 0.7 * y), skin, collide=False),
        *(
            box(
                inks[k % 4],
                around((0.02 + 0.17 * (k // 4)) * x, 0.13 * x),
                around((k % 4 - 1.5) * 0.2 * y, 0.15 * y),
                skin,
                collide=False,
            )
            for k in range(8)
        ),
    ]
    return Build(body=body, surfaces=[top_surface("lid", (-x / 2, x / 2), (-y / 2, y / 2), z)])


def tissue_box(spec: Spec) -> Build:
    """Return a box of tissues, one of them pulled out."""
    x, y, z = spec.size
    paint = spec.main(Finish(spec.style.accent.colour, "paper"))
    low = 0.7 * z
    leaf = [(u, v, low) for u in (-0.06 * x, 0.06 * x) for v in (-0.2 * y, 0.2 * y)]
    leaf += [(0.1 * x, -0.1 * y, z), (-0.02 * x, 0.02 * y, 0.94 * z), (-0.12 * x, 0.12 * y, z)]
    return Build(body=[cushion(paint, (-x / 2, x / 2), (-y / 2, y / 2), (0, low), radius=0.004), hull(PAPER, leaf)])


def sponge(spec: Spec) -> Build:
    """Return a sponge with a scouring side."""
    x, y, z = spec.size
    foam = spec.main(Finish((0.95, 0.80, 0.30), "fabric"))
    return Build(
        body=[
            cushion(foam, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.75 * z), radius=0.12 * z),
            cushion(
                Finish((0.24, 0.44, 0.28), "fabric"), (-x / 2, x / 2), (-y / 2, y / 2), (0.75 * z, z), radius=0.1 * z
            ),
        ]
    )
