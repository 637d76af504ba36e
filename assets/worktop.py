"""What stands on a worktop: sinks, hobs and small kitchen machines."""

from thinkblox.assets.appliances import chamber, plates
from thinkblox.assets.carcasses import door, face_of
from thinkblox.assets.palette import (
    BLACK_GLASS,
    BLACK_PLASTIC,
    CHROME,
    DARK_PLASTIC,
    GREY_METAL,
    IRON,
    STEEL,
    WHITE_METAL,
    WHITE_PLASTIC,
)
from thinkblox.assets.part import Build, Finish, Part
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, frustum, inner_surface, rod, top_surface
from thinkblox.assets.spec import Spec

_RIM = 0.03
"""How far a sink stands out above its worktop [m]."""


def hob(spec: Spec) -> Build:
    """Return a flat glass hob that lies on a worktop."""
    x, y, z = spec.size
    body = [box(BLACK_GLASS, (-x / 2, x / 2), (-y / 2, y / 2), (0, z - 0.002)), *plates(spec, (-x / 2, x / 2), z)]
    return Build(body=body, surfaces=[top_surface("hob", (-x / 2, x / 2), (-y / 2, y / 2), z - 0.002)])


def microwave(spec: Spec) -> Build:
    """Return a microwave oven, its door on the left and its panel on the right."""
    x, y, z = spec.size
    finish, front = spec.main(spec.choice((WHITE_METAL, STEEL, IRON))), x / 2 - 0.042
    split = -y / 2 + 0.25 * y
    build = Build(body=chamber(finish, (-x / 2, front), (-y / 2, y / 2), (0.008, z), wall=0.02, base=0.02, lid=0.02))
    build.body += [
        box(finish, (-x / 2 + 0.02, front), (-y / 2 + 0.02, split), (0.028, z - 0.02)),
        box(DARK_PLASTIC, (front, front + 0.018), (-y / 2 + 0.002, split - 0.003), (0.012, z - 0.004)),
        box(
            Finish((0.45, 0.85, 0.75), "light"),
            (front + 0.018, front + 0.02),
            (-y / 2 + 0.03, split - 0.03),
            (z - 0.07, z - 0.045),
            collide=False,
        ),
        cylinder(
            GREY_METAL, (front + 0.018, front + 0.034), around((split - y / 2) / 2, 0.04), around(0.3 * z, 0.04), axis=0
        ),
    ]
    build.body += [
        disc(BLACK_PLASTIC, (sx * 0.38 * x - 0.01, sy * 0.4 * y), 0.015, (0, 0.008)) for sx in (-1, 1) for sy in (-1, 1)
    ]
    face = face_of(
        "door",
        (front + 0.002, x / 2),
        (split + 0.001, y / 2 - 0.002),
        (0.012, z - 0.004),
        IRON if finish != IRON else DARK_PLASTIC,
        STEEL,
    )
    build.moving.append(door(face, left_hung=True, glazed=True))
    build.surfaces.append(top_surface("top", (-x / 2, front), (-y / 2, y / 2), z))
    hold = ((-x / 2 + 0.02, front - 0.01), (split, y / 2 - 0.02))
    build.surfaces.append(inner_surface("chamber", *hold, 0.028, headroom=z - 0.048))
    return build


def sink(spec: Spec) -> Build:
    """Return a basin set into a worktop: a low rim about a dark bowl, two of them where it is "double", and a tap."""
    x, y, z = spec.size
    deep, floor = min(_RIM, 0.6 * z), 0.006
    rim = STEEL if spec.category == "sink" else spec.main(Finish((0.95, 0.95, 0.93), "ceramic"))
    hollow = ((-x / 2 + 0.1, x / 2 - 0.04), (-y / 2 + 0.04, y / 2 - 0.04))
    body = [
        box(rim, (-x / 2, hollow[0][0]), (-y / 2, y / 2), (0, deep)),
        box(rim, (hollow[0][1], x / 2), (-y / 2, y / 2), (0, deep)),
        *(box(rim, hollow[0], (s * y / 2, s * (y / 2 - 0.04)), (0, deep)) for s in (-1, 1)),
        box(GREY_METAL, *hollow, (0, floor)),
    ]
    bowls = [hollow[1]]
    if spec.has("double"):
        body.append(box(rim, hollow[0], around(0, 0.04), (floor, deep)))
        bowls = [(hollow[1][0], -0.02), (0.02, hollow[1][1])]
    body += [disc(IRON, (0.03, (low + high) / 2), 0.03, (floor, floor + 0.003)) for low, high in bowls]
    body += tap(-x / 2 + 0.05, deep, z)
    names = ("basin",) if len(bowls) == 1 else ("basin 1", "basin 2")
    basins = [inner_surface(name, hollow[0], bowl, floor) for name, bowl in zip(names, bowls, strict=True)]
    return Build(body=body, surfaces=basins)


def tap(x: float, low: float, high: float) -> list[Part]:
    """Return a mixer tap whose spout reaches 0.16 m forwards at height `high` [m]."""
    return [
        disc(CHROME, (x, 0), 0.024, (low, low + 0.015)),
        disc(CHROME, (x, 0), 0.013, (low + 0.015, high)),
        cylinder(CHROME, (x + 0.01, x + 0.16), around(0, 0.022), (high - 0.022, high), axis=0),
        disc(CHROME, (x + 0.15, 0), 0.01, (high - 0.045, high - 0.02)),
        rod(CHROME, (x, 0.012, low + 0.05), (x, 0.07, low + 0.07), 0.007),
    ]


def kettle(spec: Spec) -> Build:
    """Return an electric kettle."""
    x, y, z = spec.size
    finish = spec.main(spec.choice((STEEL, Finish(spec.style.accent.colour, "metal"), WHITE_PLASTIC)))
    at, radius = (0.04 * x, 0.0), min(0.4 * x, 0.5 * y)
    body = [
        disc(BLACK_PLASTIC, at, radius * 0.95, (0, 0.02)),
        frustum(finish, at, (0.02, 0.86 * z), radius, 0.72 * radius),
        frustum(finish, at, (0.86 * z, 0.94 * z), 0.72 * radius, 0.45 * radius),
        disc(BLACK_PLASTIC, at, 0.016, (0.94 * z, z)),
        rod(finish, (at[0] + 0.6 * radius, 0, 0.68 * z), (x / 2 - 0.012, 0, 0.84 * z), 0.02, end_radius=0.01),
        box(BLACK_PLASTIC, (-x / 2, -x / 2 + 0.02), around(0, 0.026), (0.25 * z, 0.9 * z)),
        *(
            box(BLACK_PLASTIC, (-x / 2 + 0.02, at[0] - 0.6 * radius), around(0, 0.026), (h * z, h * z + 0.02))
            for h in (0.25, 0.78)
        ),
    ]
    return Build(body=body)


def toaster(spec: Spec) -> Build:
    """Return a toaster for two slices."""
    x, y, z = spec.size
    finish = spec.main(spec.choice((STEEL, Finish(spec.style.accent.colour, "metal"))))
    body = [
        box(BLACK_PLASTIC, (-x / 2 + 0.01, x / 2 - 0.02), (-y / 2 + 0.01, y / 2 - 0.01), (0, 0.015)),
        cushion(finish, (-x / 2, x / 2 - 0.02), (-y / 2, y / 2), (0.015, z), radius=0.03),
        *(
            box(BLACK_PLASTIC, around(-0.01, x - 0.1), around(s * 0.2 * y, 0.025), (z - 0.01, z + 0.001), collide=False)
            for s in (-1, 1)
        ),
        box(BLACK_PLASTIC, (x / 2 - 0.02, x / 2), around(0, 0.04), (0.6 * z, 0.68 * z)),
    ]
    return Build(body=body)


def coffee_machine(spec: Spec) -> Build:
    """Return an espresso machine with a cup tray."""
    x, y, z = spec.size
    finish = spec.main(spec.choice((STEEL, IRON, Finish((0.68, 0.20, 0.17), "metal"))))
    body = [
        box(finish, (-x / 2, -0.04 * x), (-y / 2, y / 2), (0, z - 0.004)),
        cushion(finish, (-0.04 * x, 0.38 * x), (-y / 2, y / 2), (0.62 * z, z), radius=0.015),
        box(DARK_PLASTIC, (-0.04 * x, x / 2), (-y / 2, y / 2), (0, 0.1 * z)),
        box(GREY_METAL, (0.0, x / 2 - 0.02), (-y / 2 + 0.02, y / 2 - 0.02), (0.1 * z, 0.1 * z + 0.005)),
        disc(CHROME, (0.2 * x, 0), 0.03, (0.5 * z, 0.62 * z)),
        rod(BLACK_PLASTIC, (0.2 * x, 0, 0.53 * z), (0.48 * x, 0, 0.51 * z), 0.012),
        box(
            Finish((0.50, 0.80, 0.90), "light"),
            (0.38 * x, 0.38 * x + 0.002),
            around(0, 0.3 * y),
            (0.8 * z, 0.87 * z),
            collide=False,
        ),
    ]
    return Build(
        body=body,
        surfaces=[
            top_surface("tray", (0.0, x / 2 - 0.02), (-y / 2 + 0.02, y / 2 - 0.02), 0.1 * z + 0.005, headroom=0.38 * z)
        ],
    )
