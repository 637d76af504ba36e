"""Long things with a grip and a head, lying with the grip to the front: cutlery, tools, brushes."""

from collections.abc import Callable

from thinkblox.assets.palette import BEECH, BRASS, BRIGHT, DARK_PLASTIC, IRON, STEEL
from thinkblox.assets.part import Build, Finish, Part, Range
from thinkblox.assets.shapes import around, box, cushion, ellipsoid, oval, prism, rod
from thinkblox.assets.spec import Spec
from thinkblox.assets.tubes import ring

Head = Callable[[Finish, Range, float, float], list[Part]]
"""Makes a head of a finish over a range along x, whose right end meets the grip, as wide and high as given [m]."""
_FLAT = 1 / 0.9
"""Stretches a grip whose lowest tenth is cut off, so that it lies flat, to its full height."""


def lying_tool(
    head: Head, *, share: float, slim: float, thick: float = 1.0, grip: Finish | None = None, metal: Finish = STEEL
) -> Callable[[Spec], Build]:
    """Return a generator of things with a grip at +x and a head at -x.

    Args:
        head: makes the head.
        share: of the length that the grip takes.
        slim: share of the width that the grip has.
        thick: share of the height that it has.
        grip: its finish; None where the whole is of one piece.
        metal: finish of the head.
    """

    def generate(spec: Spec) -> Build:
        x, y, z = spec.size
        start, held = (0.5 - share) * x, spec.main(grip or metal)
        outline = [
            (v, _FLAT * thick * z * (max(w, -0.4) + 0.4)) for v, w in oval(slim * y, 1.0, sides=12, squareness=3.0)
        ]
        handle = prism(held, outline, (start, x / 2), axis=0, smooth=True)
        return Build(body=[handle, *head(metal if grip else held, (-x / 2, start), y, z)])

    return generate


def _fork_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    root = x[0] + 0.6 * (x[1] - x[0])
    outline = [(root, -y / 2), (x[1], -0.15 * y), (x[1], 0.15 * y), (root, y / 2)]
    tines = [box(finish, (x[0], root), around((k - 1.5) * 0.29 * y, 0.13 * y), (0.15 * z, 0.7 * z)) for k in range(4)]
    return [prism(finish, outline, (0, 0.7 * z)), *tines]


def _knife_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    long = x[1] - x[0]
    edge = [
        (x[1], -0.3 * y),
        (x[1], 0.3 * y),
        (x[1] - 0.08 * long, y / 2),
        (x[0] + 0.3 * long, y / 2),
        (x[0], -0.3 * y),
        (x[0] + 0.1 * long, -y / 2),
    ]
    return [prism(finish, edge, (0, 0.35 * z))]


def _spoon_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    bowl = x[0] + 1.5 * y
    return [
        ellipsoid(finish, (x[0], bowl), (-y / 2, y / 2), (0, 0.8 * z)),
        box(finish, (bowl - 0.2 * y, x[1]), around(0, 0.22 * y), (0.1 * z, 0.6 * z)),
    ]


def _blade_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    root = x[0] + 0.4 * (x[1] - x[0])
    return [
        cushion(finish, (x[0], root), (-y / 2, y / 2), (0, 0.4 * z), radius=0.2 * z),
        box(finish, (root, x[1]), around(0, 0.2 * y), (0.05 * z, 0.4 * z)),
    ]


def _bristle_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    root = x[0] + 0.72 * (x[1] - x[0])
    ferrule = [(root, -y / 2), (x[1], -0.3 * y), (x[1], 0.3 * y), (root, y / 2)]
    hair = Finish((0.33, 0.25, 0.18), "fabric")
    return [box(hair, (x[0], root), around(0, 0.94 * y), (0.1 * z, 0.9 * z)), prism(finish, ferrule, (0, z))]


def _pad_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    hair = Finish((0.20, 0.19, 0.20), "plastic")
    return [
        cushion(finish, x, (-y / 2, y / 2), (0, 0.45 * z), radius=0.22 * z),
        cushion(hair, (x[0] + 0.12 * y, x[1] - 0.2 * y), around(0, 0.8 * y), (0.4 * z, z), radius=0.1 * z),
    ]


def _hammer_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    middle = (x[0] + x[1]) / 2
    claw = [(x[0], -0.1 * y), (x[1], -0.1 * y), (middle + 0.2 * (x[1] - x[0]), -y / 2), (middle, -y / 2)]
    return [
        box(finish, x, around(0.02 * y, 0.3 * y), (0, z)),
        prism(finish, claw, (0.15 * z, 0.85 * z)),
        box(finish, around(middle, 0.6 * (x[1] - x[0])), (0.15 * y, 0.4 * y), (0.12 * z, 0.88 * z)),
        box(finish, around(middle, 0.9 * (x[1] - x[0])), (0.4 * y, y / 2), (0, z)),
    ]


def _shaft_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    tip = x[0] + 0.12 * (x[1] - x[0])
    return [
        rod(finish, (tip, 0, z / 2), (x[1], 0, z / 2), 0.09 * y),
        box(finish, (x[0], tip), around(0, 0.3 * y), around(z / 2, 0.1 * z)),
    ]


def _jaw_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    root = x[0] + 0.5 * (x[1] - x[0])
    return [
        box(finish, (root, x[1]), (-y / 2, y / 2), (0, z)),
        prism(finish, [(x[0], -y / 2), (root, -y / 2), (root, -0.14 * y), (x[0], -0.2 * y)], (0, z)),
        prism(finish, [(x[0], y / 2), (root, y / 2), (root, 0.14 * y), (x[0], 0.2 * y)], (0, z)),
    ]


def _saw_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    return [prism(finish, [(x[0], 0.2 * y), (x[0], y / 2), (x[1], y / 2), (x[1], -y / 2)], (0, 0.2 * z))]


def _scissor_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    grip = Finish(BRIGHT[0], "plastic")
    cross = x[0] + 0.55 * (x[1] - x[0])
    blades = [
        prism(
            finish,
            [(x[0], 0.0), (cross, s * 0.24 * y), (x[1], s * 0.1 * y), (cross, -s * 0.1 * y)],
            (low, low + 0.4 * z),
        )
        for s, low in ((1, 0.0), (-1, 0.4 * z))
    ]
    wide = (0.32 * (x[1] - x[0]), 0.24 * y)
    rings = [
        part
        for s in (-1, 1)
        for part in ring(grip, (x[1] - 0.1 * (x[1] - x[0]), s * 0.27 * y, z / 2), wide, z / 2, axis=2)
    ]
    return [*blades, *rings]


def _key_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    long = x[1] - x[0]
    teeth = [
        box(finish, around(x[0] + (0.1 + 0.16 * k) * long, 0.1 * long), (0, 0.3 * y), (0, 0.8 * z)) for k in (0, 1)
    ]
    return [box(finish, x, around(0, 0.18 * y), (0, 0.8 * z)), *teeth]


def _ladle_head(finish: Finish, x: Range, y: float, z: float) -> list[Part]:
    return [
        ellipsoid(finish, (x[0], x[0] + y), (-y / 2, y / 2), (0, 0.9 * z)),
        box(finish, (x[0] + 0.8 * y, x[1]), around(0, 0.16 * y), (0, 0.2 * z)),
    ]


fork = lying_tool(_fork_head, share=0.5, slim=0.45, thick=0.5)
knife = lying_tool(_knife_head, share=0.45, slim=0.8, thick=0.9)
spoon = lying_tool(_spoon_head, share=0.4, slim=0.34, thick=0.45)
kitchen_knife = lying_tool(_knife_head, share=0.38, slim=0.55, grip=DARK_PLASTIC)
spatula = lying_tool(_blade_head, share=0.42, slim=0.3, grip=DARK_PLASTIC)
ladle = lying_tool(_ladle_head, share=0.5, slim=0.2, thick=0.3)
hammer = lying_tool(_hammer_head, share=0.88, slim=0.26, thick=0.8, grip=BEECH, metal=IRON)
screwdriver = lying_tool(_shaft_head, share=0.5, slim=1.0, grip=Finish(BRIGHT[0], "plastic"))
wrench = lying_tool(_jaw_head, share=0.78, slim=0.42)
saw = lying_tool(_saw_head, share=0.26, slim=0.9, grip=BEECH)
paintbrush = lying_tool(_bristle_head, share=0.5, slim=0.3, grip=BEECH)
hairbrush = lying_tool(_pad_head, share=0.5, slim=0.32, thick=0.4, grip=DARK_PLASTIC, metal=DARK_PLASTIC)
toothbrush = lying_tool(_pad_head, share=0.75, slim=0.6, thick=0.5, grip=Finish(BRIGHT[1], "plastic"))
scissors = lying_tool(_scissor_head, share=0.05, slim=0.1)
key = lying_tool(_key_head, share=0.32, slim=1.0, metal=BRASS)
