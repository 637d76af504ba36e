"""Tools, machines and containers of workshops, stores and sites."""

from math import cos, pi, sin

from thinkblox.assets.palette import (
    BLACK_PLASTIC,
    BRIGHT,
    CHROME,
    DARK_PLASTIC,
    GREY_METAL,
    IRON,
    PINE,
    STEEL,
)
from thinkblox.assets.part import Build, Finish, Part
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, frustum, leg, prism, rod, sphere, top_surface
from thinkblox.assets.spec import Spec
from thinkblox.assets.tubes import tube

_RED = Finish((0.72, 0.18, 0.15), "metal")
_ORANGE = Finish((0.93, 0.42, 0.12), "plastic")
_WHITE = Finish((0.94, 0.94, 0.92), "plastic")


def toolbox(spec: Spec) -> Build:
    """Return a steel box with a ridged lid, two clasps and a handle along it."""
    x, y, z = spec.size
    paint = spec.main(spec.choice((_RED, Finish((0.22, 0.36, 0.56), "metal"), _RED)))
    side, ridge = 0.56 * z, 0.78 * z
    gable = [(-x / 2, side), (x / 2, side), (0.16 * x, ridge), (-0.16 * x, ridge)]
    body: list[Part] = [
        box(paint, (-x / 2, x / 2), (-y / 2, y / 2), (0, side - 0.01 * z)),
        prism(paint, gable, (-y / 2, y / 2), axis=1),
        *(box(STEEL, (0.47 * x, 0.51 * x), around(s * 0.28 * y, 0.08 * y), around(side, 0.2 * z)) for s in (-1, 1)),
        cylinder(IRON, around(0, 0.13 * z), around(0, 0.44 * y), (0.87 * z, z), axis=1),
        *(box(IRON, around(0, 0.1 * z), around(s * 0.2 * y, 0.03 * y), (ridge, 0.95 * z)) for s in (-1, 1)),
    ]
    return Build(body=body)


def drill(spec: Spec) -> Build:
    """Return a cordless drill standing on its battery, its bit to the front."""
    x, y, z = spec.size
    shell = spec.main(Finish(spec.choice(((0.90, 0.70, 0.16), (0.16, 0.40, 0.44), (0.72, 0.20, 0.16))), "plastic"))
    thick, mid = 0.36 * z, 0.82 * z
    grip = [(-0.3 * x, 0.18 * z), (-0.06 * x, 0.18 * z), (0.02 * x, 0.68 * z), (-0.26 * x, 0.68 * z)]
    body: list[Part] = [
        cushion(BLACK_PLASTIC, (-0.46 * x, 0.1 * x), (-y / 2, y / 2), (0, 0.2 * z), radius=0.06 * z),
        prism(shell, grip, around(0, 0.46 * y), axis=1),
        cushion(shell, (-x / 2, 0.14 * x), around(0, 0.86 * y), around(mid, thick), radius=0.12 * z),
        rod(BLACK_PLASTIC, (0.12 * x, 0, mid), (0.32 * x, 0, mid), 0.13 * z, end_radius=0.09 * z),
        rod(STEEL, (0.32 * x, 0, mid), (x / 2, 0, mid), 0.025 * z),
        box(BLACK_PLASTIC, (-0.02 * x, 0.06 * x), around(0, 0.3 * y), (0.52 * z, 0.66 * z)),
    ]
    return Build(body=body)


def vise(spec: Spec) -> Build:
    """Return a bench vise, its jaws and screw to the front."""
    x, y, z = spec.size
    iron = spec.main(Finish((0.24, 0.36, 0.50), "metal"))
    body: list[Part] = [
        cushion(iron, (-x / 2, 0.05 * x), (-y / 2, y / 2), (0, 0.16 * z), radius=0.03 * z),
        frustum(iron, (-0.22 * x, 0), (0.16 * z, 0.4 * z), 0.3 * y, 0.24 * y),
        box(iron, (-0.48 * x, 0.34 * x), around(0, 0.34 * y), (0.4 * z, 0.66 * z)),
        *(box(iron, around(a * x, 0.12 * x), around(0, 0.9 * y), (0.62 * z, z)) for a in (-0.08, 0.14)),
        rod(CHROME, (0.34 * x, 0, 0.53 * z), (0.45 * x, 0, 0.53 * z), 0.06 * z),
        cylinder(CHROME, (0.44 * x, x / 2), around(0, 0.6 * y), around(0.53 * z, 0.06 * x), axis=1),
    ]
    return Build(body=body)


def brush_pole(spec: Spec) -> Build:
    """Return a broom or mop that stands on its head."""
    x, y, z = spec.size
    pole = spec.main(spec.style.wood)
    broad = spec.category == "mop"
    hair = Finish((0.90, 0.88, 0.82) if broad else spec.choice(((0.76, 0.62, 0.34), (0.62, 0.24, 0.20))), "fabric")
    tuft = 0.12 * z
    skirt = [(-x / 2, 0.0), (x / 2, 0.0), (0.34 * x, tuft), (-0.34 * x, tuft)]
    body: list[Part] = [
        prism(hair, skirt, around(0, y if not broad else 0.98 * y), axis=1),
        cushion(
            DARK_PLASTIC if broad else pole, around(0, 0.7 * x), (-y / 2, y / 2), (tuft, tuft + 0.025 * z), radius=0.01
        ),
        disc(pole, (0, 0), 0.0125, (tuft + 0.02 * z, z)),
    ]
    return Build(body=body)


def vacuum_cleaner(spec: Spec) -> Build:
    """Return an upright vacuum cleaner, its floor head to the front."""
    x, y, z = spec.size
    shell = spec.main(Finish(spec.choice(((0.62, 0.20, 0.22), (0.30, 0.44, 0.58), (0.52, 0.40, 0.58))), "plastic"))
    lean = [(-0.3 * x, 0.12 * z), (-0.02 * x, 0.12 * z), (-0.12 * x, 0.62 * z), (-0.36 * x, 0.62 * z)]
    body: list[Part] = [
        cushion(DARK_PLASTIC, (-0.36 * x, x / 2), (-y / 2, y / 2), (0, 0.09 * z), radius=0.02 * z),
        *(
            cylinder(BLACK_PLASTIC, (-x / 2, -x / 2 + 0.12 * z), around(s * 0.42 * y, 0.08 * y), (0, 0.12 * z), axis=1)
            for s in (-1, 1)
        ),
        box(DARK_PLASTIC, (-0.44 * x, -0.02 * x), around(0, 0.76 * y), (0.05 * z, 0.13 * z)),
        prism(shell, lean, around(0, 0.74 * y), axis=1),
        rod(GREY_METAL, (-0.24 * x, 0, 0.6 * z), (-0.4 * x, 0, 0.96 * z), 0.014),
        cushion(DARK_PLASTIC, (-x / 2, -0.2 * x), around(0, 0.14 * y), (0.94 * z, z), radius=0.02 * z),
    ]
    return Build(body=body)


def wheelbarrow(spec: Spec) -> Build:
    """Return a wheelbarrow, its handles to the front, where one takes hold of it."""
    x, y, z = spec.size
    steel, wheel = spec.main(Finish((0.24, 0.42, 0.30), "metal")), 0.6 * z
    low, rim = 0.5 * z, z
    floor_ = ((-0.22 * x, 0.2 * x), 0.5 * y)
    body: list[Part] = [
        cylinder(BLACK_PLASTIC, (-x / 2, wheel - x / 2), around(0, 0.12 * y), (0, wheel), axis=1),
        box(steel, floor_[0], around(0, floor_[1]), (low, low + 0.03 * z)),
    ]
    for s in (-1, 1):
        wall = [(s * 0.25 * y, low), (s * 0.27 * y, low), (s * 0.5 * y, rim), (s * 0.47 * y, rim)]
        body += [
            prism(steel, wall, (-0.36 * x, 0.26 * x), axis=0),
            rod(PINE, (wheel / 2 - x / 2, s * 0.1 * y, wheel / 2), (x / 2, s * 0.34 * y, 0.48 * z), 0.02),
            leg(IRON, (0.24 * x, s * 0.26 * y), (0.12 * x, s * 0.26 * y), (0, 0.5 * z), 0.035, 0.035),
        ]
    ends = (
        [(-0.24 * x, low), (-0.22 * x, low), (-0.39 * x, rim), (-0.42 * x, rim)],
        [(0.18 * x, low), (0.2 * x, low), (0.29 * x, rim), (0.26 * x, rim)],
    )
    body += [prism(steel, end, around(0, 0.84 * y), axis=1) for end in ends]
    return Build(body=body)


def pallet(spec: Spec) -> Build:
    """Return a wooden pallet; things stand on its boards."""
    x, y, z = spec.size
    wood, deck = spec.main(PINE), 0.15 * z
    body: list[Part] = []
    for k in range(3):
        at = (k - 1) * (y / 2 - 0.05 * y)
        body.append(box(wood, (-x / 2, x / 2), around(at, 0.1 * y), (0, deck)))
        body += [
            box(wood, around((j - 1) * 0.44 * x, 0.12 * x), around(at, 0.1 * y), (deck, z - 2 * deck)) for j in range(3)
        ]
    body += [
        box(wood, around((j - 1) * 0.44 * x, 0.12 * x), (-y / 2, y / 2), (z - 2 * deck, z - deck)) for j in range(3)
    ]
    count = 7
    body += [
        box(wood, (-x / 2, x / 2), around((k - 3) * (y - 0.11 * y) / (count - 1), 0.12 * y), (z - deck, z))
        for k in range(count)
    ]
    return Build(body=body, surfaces=[top_surface("deck", (-x / 2, x / 2), (-y / 2, y / 2), z)])


def traffic_cone(spec: Spec) -> Build:
    """Return a cone with a white band on a square foot."""
    x, y, z = spec.size
    shell, foot, r = spec.main(_ORANGE), 0.05 * z, 0.4 * min(x, y)
    ends = [(foot, r), (0.42 * z, 0.62 * r), (0.66 * z, 0.4 * r), (z, 0.12 * r)]
    tones = (shell, _WHITE, shell)
    body: list[Part] = [cushion(DARK_PLASTIC, (-x / 2, x / 2), (-y / 2, y / 2), (0, foot), radius=0.2 * foot)]
    body += [frustum(t, (0, 0), (a[0], b[0]), a[1], b[1]) for t, a, b in zip(tones, ends, ends[1:], strict=False)]
    return Build(body=body)


def fire_extinguisher(spec: Spec) -> Build:
    """Return a fire extinguisher with its hose, on its foot or on a wall bracket."""
    x, y, z = spec.size
    hung = spec.category.startswith("wall")
    radius = min(0.4 * x if hung else 0.42 * x, 0.46 * y)
    red, at = spec.main(Finish((0.78, 0.12, 0.11), "plastic")), (x / 2 - radius if hung else -0.06 * x, -y / 2 + radius)
    body: list[Part] = [
        disc(red, at, radius, (0, 0.7 * z)),
        frustum(red, at, (0.7 * z, 0.8 * z), radius, 0.34 * radius),
        disc(STEEL, at, 0.3 * radius, (0.8 * z, 0.88 * z)),
        box(IRON, (at[0] - 0.4 * radius, at[0] + radius), around(at[1], 0.3 * radius), (0.88 * z, 0.92 * z)),
        box(IRON, (at[0] - 0.4 * radius, at[0] + 0.9 * radius), around(at[1], 0.24 * radius), (0.95 * z, z)),
        box(IRON, (at[0] - 0.4 * radius, at[0] - 0.1 * radius), around(at[1], 0.24 * radius), (0.9 * z, 0.97 * z)),
        disc(_WHITE, at, 1.005 * radius, (0.3 * z, 0.48 * z), collide=False),
    ]
    side = y / 2 - 0.1 * radius
    hose = [(at[0], at[1] + 0.2 * radius, 0.84 * z), (at[0], 0.8 * side, 0.84 * z), (at[0], side, 0.7 * z)]
    body += tube(BLACK_PLASTIC, [*hose, (at[0], side, 0.2 * z)], 0.1 * radius)
    if hung:
        body.append(box(IRON, (-x / 2, at[0]), around(at[1], 0.6 * radius), around(0.5 * z, 0.06 * z)))
        body.append(box(IRON, (-x / 2, -x / 2 + 0.06 * x), around(at[1], 0.8 * radius), around(0.5 * z, 0.3 * z)))
    return Build(body=body)


def crate(spec: Spec) -> Build:
    """Return an open crate of slats, or an open bin of plastic for shelves."""
    x, y, z = spec.size
    if spec.category == "storage_bin":
        return _bin(spec)
    wood, board = spec.main(PINE), 0.05 * min(x, y)
    body: list[Part] = [box(wood, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.05 * z))]
    for k in range(3):
        level = around((0.2 + 0.33 * k) * z, 0.25 * z) if k else (0.05 * z, 0.31 * z)
        level = (level[0], z) if k == 2 else level
        body += [box(wood, (s * x / 2, s * (x / 2 - board)), (-y / 2, y / 2), level) for s in (-1, 1)]
        body += [box(wood, around(0, x - 2 * board), (s * y / 2, s * (y / 2 - board)), level) for s in (-1, 1)]
    body += [
        box(wood, around(sx * (x / 2 - 1.5 * board), board), around(sy * (y / 2 - 1.5 * board), board), (0.05 * z, z))
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    return Build(body=body)


def _bin(spec: Spec) -> Build:
    """A plastic shelf box with a low front and a label."""
    x, y, z = spec.size
    shell = spec.main(Finish(spec.choice(BRIGHT), "plastic"))
    wall = 0.03 * min(x, y)
    side = [(-x / 2, 0.0), (x / 2, 0.0), (x / 2, 0.55 * z), (0.2 * x, z), (-x / 2, z)]
    body: list[Part] = [
        box(shell, (-x / 2 + wall, x / 2 - wall), around(0, y - 2 * wall), (0, wall)),
        *(
            prism(shell, side, (min(s * y / 2, s * (y / 2 - wall)), max(s * y / 2, s * (y / 2 - wall))), axis=1)
            for s in (-1, 1)
        ),
        box(shell, (-x / 2, -x / 2 + wall), around(0, y - 2 * wall), (0, z)),
        box(shell, (x / 2 - wall, x / 2), around(0, y - 2 * wall), (0, 0.55 * z)),
        box(_WHITE, around(x / 2, 0.002), around(0, 0.5 * y), (0.2 * z, 0.42 * z), collide=False),
    ]
    return Build(body=body)


def pegboard(spec: Spec) -> Build:
    """Return a board on the wall with tools hung on it; "shelved" with two shelves instead, for what it carries."""
    x, y, z = spec.size
    board = spec.main(Finish((0.80, 0.70, 0.52), "wood"))
    face = -x / 2 + (min(0.02, 0.24 * x) if spec.has("shelved") else 0.24 * x)
    body: list[Part] = [box(board, (-x / 2, face), (-y / 2, y / 2), (0, z))]
    for row in range(5):
        body += [
            box(
                IRON,
                (face, face + 0.002),
                around((k - 5.5) * 0.08 * y, 0.008),
                around((0.14 + 0.18 * row) * z, 0.008),
                collide=False,
            )
            for k in range(12)
        ]
    if spec.has("shelved"):
        levels = (0.1 * z, 0.55 * z)
        body += [box(STEEL, (face, x / 2), (-y / 2, y / 2), (h - 0.008, h)) for h in levels]
        rows = [(h, (levels[1] - 0.008 if h < levels[1] else z) - h) for h in levels]
        shelf = ((face, x / 2), (-y / 2, y / 2))
        return Build(body=body, surfaces=[top_surface("shelf", *shelf, h, headroom=room) for h, room in rows])
    hung = (x / 2 + face) / 2
    for k, colour in enumerate(BRIGHT):
        at = (k - 2) * 0.18 * y
        body += [
            rod(Finish(colour, "plastic"), (hung, at, 0.3 * z), (hung, at, 0.52 * z), 0.3 * (x / 2 - face)),
            rod(STEEL, (hung, at, 0.5 * z), (hung, at, 0.78 * z), 0.12 * (x / 2 - face)),
            box(STEEL, (face, x / 2), around(at, 0.06 * y if k % 2 else 0.02 * y), around(0.8 * z, 0.05 * z)),
        ]
    return Build(body=body)


def sawhorse(spec: Spec) -> Build:
    """Return a trestle of a beam on four splayed legs."""
    x, y, z = spec.size
    wood = spec.main(PINE)
    body: list[Part] = [box(wood, around(0, 0.22 * x), (-y / 2, y / 2), (z - 0.13 * z, z))]
    for sx in (-1, 1):
        for sy in (-1, 1):
            foot, head = (sx * 0.44 * x, sy * 0.44 * y), (sx * 0.1 * x, sy * 0.4 * y)
            body.append(leg(wood, foot, head, (0, 0.95 * z), 0.12 * x, 0.12 * x))
    body += [box(wood, around(0, 0.52 * x), around(s * 0.42 * y, 0.03 * y), (0.3 * z, 0.4 * z)) for s in (-1, 1)]
    return Build(body=body, surfaces=[top_surface("beam", around(0, 0.22 * x), (-y / 2, y / 2), z)])


def anvil(spec: Spec) -> Build:
    """Return an anvil on a wooden block, its horn to the front."""
    x, y, z = spec.size
    block, iron = 0.62 * z, spec.main(IRON)
    foot = 0.36 * x
    body: list[Part] = [
        disc(spec.style.wood, (-0.1 * x, 0), min(foot, y / 2), (0, block)),
        box(iron, (-0.34 * x, 0.14 * x), around(0, 0.5 * y), (block, block + 0.1 * z)),
        box(iron, (-0.24 * x, 0.04 * x), around(0, 0.26 * y), (block + 0.1 * z, 0.86 * z)),
        box(iron, (-0.44 * x, 0.18 * x), around(0, 0.4 * y), (0.86 * z, z)),
        rod(iron, (0.18 * x, 0, 0.93 * z), (x / 2, 0, 0.95 * z), 0.06 * z, end_radius=0.01 * z),
    ]
    return Build(body=body)


def drill_press(spec: Spec) -> Build:
    """Return a pillar drill: its head with the belt's cover and the motor, its chuck over a table with a vice."""
    x, y, z = spec.size
    paint = spec.main(Finish((0.30, 0.46, 0.42), "metal"))
    spindle, level = 0.16 * x, 0.5 * z
    body: list[Part] = [
        box(IRON, (-x / 2, 0.42 * x), around(0, 0.84 * y), (0, 0.035 * z)),
        disc(STEEL, (-0.24 * x, 0), 0.07 * x, (0.03 * z, 0.92 * z)),
        disc(IRON, (-0.24 * x, 0), 0.12 * x, (0.03 * z, 0.08 * z)),
        disc(IRON, (-0.24 * x, 0), 0.11 * x, (level - 0.08 * z, level - 0.01 * z)),
        box(IRON, (-0.26 * x, 0.4 * x), around(0, 0.74 * y), (level - 0.02 * z, level)),
        *(
            box(GREY_METAL, around(spindle + s * 0.1 * x, 0.06 * x), around(0, 0.24 * y), (level, level + 0.035 * z))
            for s in (-1, 1)
        ),
        cushion(paint, (-0.36 * x, 0.34 * x), around(0, 0.44 * y), (0.72 * z, 0.88 * z), radius=0.02 * z),
        cushion(paint, (-0.46 * x, 0.42 * x), around(0, 0.5 * y), (0.9 * z, z), radius=0.03 * z),
        box(IRON, (-0.3 * x, 0.28 * x), around(0, 0.36 * y), (0.87 * z, 0.91 * z)),
        cylinder(IRON, around(-0.39 * x, 0.22 * x), around(0, 0.22 * x), (0.7 * z, 0.88 * z)),
        disc(STEEL, (spindle, 0), 0.07 * x, (0.66 * z, 0.73 * z)),
        frustum(IRON, (spindle, 0), (0.615 * z, 0.665 * z), 0.03 * x, 0.055 * x),
        disc(STEEL, (spindle, 0), 0.014 * x, (0.56 * z, 0.62 * z)),
    ]
    hub = (spindle - 0.04 * x, 0.3 * y, 0.78 * z)
    body.append(rod(STEEL, (hub[0], 0.2 * y, hub[2]), (hub[0], 0.34 * y, hub[2]), 0.035 * x))
    for k in range(3):
        turn = pi / 2 + 2 * pi * k / 3
        end = (hub[0] + 0.3 * x * cos(turn), y / 2 - 0.03, hub[2] + 0.3 * x * sin(turn))
        body += [rod(STEEL, hub, end, 0.01), sphere(IRON, end, 0.026)]
    body.append(
        box(Finish((0.74, 0.2, 0.16), "plastic"), (0.33 * x, 0.36 * x), around(0, 0.1 * y), around(0.8 * z, 0.04 * z))
    )
    return Build(body=body)


def table_saw(spec: Spec) -> Build:
    """Return a saw bench with its blade and fence."""
    x, y, z = spec.size
    paint, top = spec.main(Finish((0.24, 0.34, 0.46), "metal")), 0.88 * z
    wide = 0.24 * z
    body: list[Part] = [
        box(paint, around(0, 0.74 * x), around(0, 0.66 * y), (0.06 * z, top - 0.05 * z)),
        box(IRON, around(0, 0.8 * x), around(0, 0.72 * y), (0, 0.06 * z)),
        box(STEEL, (-x / 2, x / 2), (-y / 2, y / 2), (top - 0.05 * z, top)),
        cylinder(CHROME, around(-0.05 * x, wide), around(0, 0.004), (z - wide, z), axis=1),
        box(GREY_METAL, (-x / 2, x / 2), around(0.3 * y, 0.03 * y), (top, top + 0.06 * z)),
        cylinder(
            Finish((0.8, 0.2, 0.16), "plastic"),
            (0.37 * x, 0.39 * x),
            around(-0.2 * y, 0.06),
            around(0.7 * z, 0.06),
            axis=0,
        ),
    ]
    return Build(body=body)


def sewing_machine(spec: Spec) -> Build:
    """Return a sewing machine; whoever sews sits at +x."""
    x, y, z = spec.size
    shell = spec.main(_WHITE)
    body: list[Part] = [
        cushion(shell, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.2 * z), radius=0.03 * z),
        cushion(shell, around(0, 0.66 * x), (0.22 * y, 0.44 * y), (0.18 * z, 0.8 * z), radius=0.03 * z),
        cushion(shell, around(0, 0.66 * x), (-0.44 * y, 0.44 * y), (0.66 * z, 0.95 * z), radius=0.05 * z),
        cushion(shell, around(0, 0.6 * x), (-0.44 * y, -0.26 * y), (0.46 * z, 0.7 * z), radius=0.03 * z),
        rod(STEEL, (0, -0.35 * y, 0.2 * z), (0, -0.35 * y, 0.48 * z), 0.008 * y),
        cylinder(GREY_METAL, around(0, 0.3 * z), (0.44 * y, y / 2), around(0.68 * z, 0.3 * z), axis=1),
        disc(Finish(BRIGHT[0], "fabric"), (0, 0.16 * y), 0.03 * y, (0.94 * z, z)),
    ]
    return Build(body=body)
