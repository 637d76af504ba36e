"""What laboratories, clinics and schools have on their benches and floors."""

from thinkblox.assets.palette import (
    BLACK_PLASTIC,
    BRIGHT,
    CHROME,
    DARK_PLASTIC,
    GLASS,
    GREY_METAL,
    GREY_PLASTIC,
    IRON,
    SCREEN,
    STEEL,
    WHITE_METAL,
    WHITE_PLASTIC,
)
from thinkblox.assets.part import Build, Finish, Part
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    ellipsoid,
    frustum,
    leg,
    panel,
    prism,
    rod,
    sphere,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.assets.tubes import ring, tube
from thinkblox.assets.vessels import hollow


def microscope(spec: Spec) -> Build:
    """Return a microscope; who looks through it sits at +x."""
    x, y, z = spec.size
    shell = spec.main(WHITE_METAL)
    arm = [
        (-x / 2, 0.08 * z),
        (-0.3 * x, 0.08 * z),
        (-0.24 * x, 0.62 * z),
        (-0.02 * x, 0.7 * z),
        (-0.06 * x, 0.8 * z),
        (-0.42 * x, 0.74 * z),
    ]
    body: list[Part] = [
        cushion(shell, (-x / 2, 0.42 * x), (-y / 2, y / 2), (0, 0.1 * z), radius=0.03 * z),
        prism(shell, [arm[0], arm[1], arm[2], arm[5]], around(0, 0.4 * y), axis=1),
        prism(shell, [arm[5], arm[2], arm[3], arm[4]], around(0, 0.4 * y), axis=1),
        box(IRON, (-0.3 * x, 0.24 * x), around(0, 0.9 * y), (0.34 * z, 0.38 * z)),
        disc(IRON, (-0.02 * x, 0), 0.1 * x, (0.62 * z, 0.7 * z)),
        rod(CHROME, (-0.02 * x, 0, 0.42 * z), (-0.02 * x, 0, 0.64 * z), 0.05 * x),
        rod(CHROME, (0.06 * x, 0.12 * y, 0.46 * z), (0.0, 0.03 * y, 0.64 * z), 0.04 * x),
        disc(Finish((1.0, 0.96, 0.86), "light"), (-0.02 * x, 0), 0.1 * x, (0.1 * z, 0.13 * z)),
        rod(shell, (-0.08 * x, 0, 0.74 * z), (0.18 * x, 0, 0.86 * z), 0.1 * x),
        *(
            rod(IRON, (0.14 * x, s * 0.14 * y, 0.84 * z), (x / 2 - 0.04 * x, s * 0.16 * y, z - 0.04 * z), 0.06 * x)
            for s in (-1, 1)
        ),
        *(
            cylinder(IRON, around(-0.3 * x, 0.18 * x), around(s * 0.32 * y, 0.2 * y), around(0.2 * z, 0.18 * x), axis=1)
            for s in (-1, 1)
        ),
    ]
    return Build(body=body)


def beaker(spec: Spec) -> Build:
    """Return a glass beaker, half full."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    fill = Finish(spec.choice(((0.45, 0.66, 0.82), (0.60, 0.76, 0.50), (0.86, 0.66, 0.40))), "plastic")
    body = hollow(GLASS, (0, 0), radius, z, 0.94, 0.05 * radius)
    body.append(disc(spec.main(fill), (0, 0), 0.86 * radius, (0.16 * z, 0.5 * z)))
    return Build(body=body)


def tube_rack(spec: Spec) -> Build:
    """Return a rack with a row of filled test tubes."""
    x, y, z = spec.size
    wood, count = spec.wood, 6
    body: list[Part] = [
        box(wood, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.08 * z)),
        *(box(wood, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - 0.06 * y)), (0.08 * z, 0.62 * z)) for s in (-1, 1)),
        box(wood, (-x / 2, x / 2), around(0, 0.88 * y), (0.5 * z, 0.58 * z)),
    ]
    for k in range(count):
        at, r = (0.0, (k - (count - 1) / 2) * 0.14 * y), 0.048 * y
        tone = Finish(BRIGHT[k % len(BRIGHT)], "plastic")
        body += [disc(tone, at, r, (0.08 * z, 0.5 * z)), disc(GLASS, at, r, (0.58 * z, z))]
    return Build(body=body)


def centrifuge(spec: Spec) -> Build:
    """Return a bench centrifuge with a round lid and a panel to the front."""
    x, y, z = spec.size
    shell = spec.main(WHITE_PLASTIC)
    side = [(-x / 2, 0.0), (x / 2, 0.0), (x / 2, 0.4 * z), (0.3 * x, 0.8 * z), (-x / 2, 0.8 * z)]
    body: list[Part] = [
        prism(shell, side, (-y / 2, y / 2), axis=1),
        frustum(GREY_PLASTIC, (-0.1 * x, 0), (0.8 * z, z), 0.38 * min(x, y), 0.32 * min(x, y)),
        box(SCREEN, (0.49 * x, 0.502 * x), around(-0.1 * y, 0.4 * y), (0.12 * z, 0.32 * z), collide=False),
        cylinder(IRON, (0.49 * x, 0.51 * x), around(0.3 * y, 0.12 * y), around(0.22 * z, 0.12 * y), axis=0),
    ]
    return Build(body=body)


def fume_hood(spec: Spec) -> Build:
    """Return a fume cupboard: a worktop in a cabin with a sash half open, on a cupboard."""
    x, y, z = spec.size
    shell, top, head = spec.main(WHITE_METAL), 0.38 * z, 0.86 * z
    wall = 0.05 * y
    body: list[Part] = [
        box(shell, (-x / 2, 0.44 * x), (-y / 2, y / 2), (0, top - 0.02 * z)),
        box(Finish((0.22, 0.23, 0.25), "stone"), (-x / 2, x / 2), (-y / 2, y / 2), (top - 0.02 * z, top)),
        *(box(shell, (-x / 2, 0.46 * x), (s * y / 2, s * (y / 2 - wall)), (top, z)) for s in (-1, 1)),
        box(shell, (-x / 2, -0.46 * x), around(0, y - 2 * wall), (top, z)),
        box(shell, (-0.46 * x, 0.46 * x), around(0, y - 2 * wall), (head, z)),
        *panel(GREY_METAL, (0.42 * x, 0.45 * x), around(0, y - 2 * wall), (0.6 * z, head), 0.03, GLASS),
        *(
            box(GREY_METAL, (0.44 * x, 0.455 * x), around(s * 0.24 * y, 0.46 * y), (0.03 * z, 0.35 * z))
            for s in (-1, 1)
        ),
        *(box(STEEL, (0.455 * x, 0.48 * x), around(s * 0.04 * y, 0.015), around(0.2 * z, 0.08 * z)) for s in (-1, 1)),
        box(SCREEN, (0.46 * x, 0.462 * x), around(0.3 * y, 0.2 * y), around(0.93 * z, 0.05 * z), collide=False),
    ]
    inner = top_surface("worktop", (-0.44 * x, 0.38 * x), around(0, y - 2.2 * wall), top, headroom=0.46 * z)
    return Build(body=body, surfaces=[inner])


def skeleton(spec: Spec) -> Build:
    """Return a skeleton on its stand; it looks to the front."""
    x, y, z = spec.size
    bone, foot = Finish((0.90, 0.86, 0.76), "ceramic"), 0.05 * z
    hip, neck = 0.52 * z, 0.83 * z
    body: list[Part] = [
        disc(IRON, (0, 0), 0.48 * min(x, y), (0, 0.02 * z)),
        disc(IRON, (-0.1 * x, 0), 0.012, (0.02 * z, 0.8 * z)),
        rod(bone, (0, 0, hip), (0, 0, neck + 0.04 * z), 0.02),
        ellipsoid(bone, around(0.02 * x, 0.4 * x), around(0, 0.34 * y), (0.88 * z, z)),
        box(bone, (0.0, 0.18 * x), around(0, 0.2 * y), (0.865 * z, 0.9 * z)),
        ellipsoid(bone, around(0, 0.3 * x), around(0, 0.62 * y), (hip - 0.03 * z, hip + 0.06 * z)),
        cylinder(bone, around(0, 0.03), around(0, 0.8 * y), around(neck - 0.02 * z, 0.03), axis=1),
    ]
    for k in range(5):
        level = hip + (0.12 + 0.04 * k) * z
        body += ring(bone, (0.04 * x, 0, level), (0.2 * x, (0.27 - 0.012 * abs(k - 2)) * y), 0.01, axis=2, sides=10)
    for s in (-1, 1):
        knee, elbow = (0.03 * x, s * 0.16 * y, 0.28 * z), (0.0, s * 0.44 * y, 0.62 * z)
        body += tube(bone, [(0, s * 0.2 * y, hip), knee, (0, s * 0.16 * y, foot)], 0.017)
        body += tube(bone, [(0, s * 0.4 * y, neck - 0.02 * z), elbow, (0.04 * x, s * 0.46 * y, 0.45 * z)], 0.013)
        body += [
            cushion(bone, (-0.1 * x, 0.4 * x), around(s * 0.16 * y, 0.14 * y), (0.025 * z, foot + 0.01), radius=0.012),
            sphere(BLACK_PLASTIC, (0.18 * x, s * 0.07 * y, 0.945 * z), 0.014),
            ellipsoid(bone, around(0.05 * x, 0.1 * x), around(s * 0.46 * y, 0.08 * y), (0.38 * z, 0.46 * z)),
        ]
    return Build(body=body)


def bunsen_burner(spec: Spec) -> Build:
    """Return a gas burner with a blue flame."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    flame = Finish((0.40, 0.62, 0.98), "light")
    return Build(
        body=[
            disc(spec.main(IRON), (0, 0), radius, (0, 0.08 * z)),
            disc(CHROME, (0, 0), 0.2 * radius, (0.08 * z, 0.74 * z)),
            disc(CHROME, (0, 0), 0.32 * radius, (0.2 * z, 0.3 * z)),
            frustum(flame, (0, 0), (0.74 * z, z), 0.2 * radius, 0.03 * radius),
        ]
    )


def patient_monitor(spec: Spec) -> Build:
    """Return a patient monitor on its wheeled stand."""
    x, y, z = spec.size
    shell, radius, low = spec.main(WHITE_PLASTIC), min(x, y) / 2, 0.74 * z
    body: list[Part] = [
        disc(DARK_PLASTIC, (0, 0), 0.96 * radius, (0, 0.03 * z)),
        disc(GREY_METAL, (0, 0), 0.02, (0.03 * z, low)),
        cushion(shell, (-0.3 * x, 0.2 * x), (-y / 2, y / 2), (low, z), radius=0.03),
        box(SCREEN, (0.19 * x, 0.202 * x), around(0.06 * y, 0.76 * y), (low + 0.03 * z, z - 0.03 * z), collide=False),
        box(shell, around(0, 0.5 * x), around(0, 0.5 * y), (0.4 * z, 0.44 * z)),
    ]
    for k, tone in enumerate(((0.35, 0.85, 0.45), (0.95, 0.80, 0.30), (0.40, 0.70, 0.95))):
        height = low + (0.08 + 0.05 * k) * z
        body.append(
            box(
                Finish(tone, "light"),
                (0.2 * x, 0.204 * x),
                around(0.06 * y, 0.6 * y),
                around(height, 0.006 * z),
                collide=False,
            )
        )
    return Build(body=body)


def surgical_lamp(spec: Spec) -> Build:
    """Return an operating lamp on its jointed arm under the ceiling."""
    x, y, z = spec.size
    shell, radius = spec.main(WHITE_METAL), min(0.36 * x, 0.5 * y)
    at, level = x / 2 - radius, 0.2 * z
    body: list[Part] = [
        disc(shell, (-x / 2 + 0.1 * x, 0), 0.1 * x, (z - 0.04 * z, z)),
        disc(shell, (-x / 2 + 0.1 * x, 0), 0.03, (0.6 * z, z - 0.04 * z)),
        rod(shell, (-x / 2 + 0.1 * x, 0, 0.62 * z), (0.0, 0, 0.56 * z), 0.03),
        rod(shell, (0.0, 0, 0.58 * z), (at, 0, level), 0.025),
        frustum(shell, (at, 0), (0.04 * z, level), radius, 0.5 * radius),
        disc(Finish((1.0, 0.98, 0.93), "light"), (at, 0), 0.9 * radius, (0, 0.04 * z)),
    ]
    return Build(body=body)


def thermometer(spec: Spec) -> Build:
    """Return a thermometer lying down."""
    x, y, z = spec.size
    return Build(
        body=[
            cushion(spec.main(WHITE_PLASTIC), (-x / 2, 0.4 * x), (-y / 2, y / 2), (0, z), radius=0.3 * z),
            box(SCREEN, (-0.3 * x, 0.05 * x), around(0, 0.6 * y), (z - 0.001, z + 0.0004), collide=False),
            rod(STEEL, (0.38 * x, 0, z / 2), (x / 2, 0, z / 2), 0.3 * z),
        ]
    )


def robot_arm(spec: Spec) -> Build:
    """Return an industrial arm with six joints and a gripper to the front."""
    x, y, z = spec.size
    paint, joint = spec.main(Finish((0.93, 0.50, 0.12), "metal")), 0.34 * y
    shoulder, elbow, wrist = (-0.26 * x, 0.0, 0.42 * z), (-0.34 * x, 0.0, 0.86 * z), (0.34 * x, 0.0, 0.7 * z)
    body: list[Part] = [
        box(IRON, (-0.5 * x, -0.08 * x), around(0, y), (0, 0.05 * z)),
        disc(paint, (-0.26 * x, 0), 0.36 * y, (0.05 * z, 0.3 * z)),
        box(paint, around(-0.26 * x, 0.5 * y), around(0, 0.8 * y), (0.3 * z, 0.36 * z)),
        *(
            cylinder(paint, around(p[0], joint), around(0, 0.84 * y), around(p[2], joint), axis=1)
            for p in (shoulder, elbow)
        ),
        rod(paint, shoulder, elbow, 0.24 * y, end_radius=0.18 * y),
        rod(paint, elbow, wrist, 0.2 * y, end_radius=0.12 * y),
        cylinder(IRON, around(wrist[0], 0.26 * y), around(0, 0.5 * y), around(wrist[2], 0.26 * y), axis=1),
        rod(IRON, wrist, (0.42 * x, 0, 0.56 * z), 0.1 * y),
        box(GREY_METAL, around(0.44 * x, 0.1 * x), around(0, 0.5 * y), (0.5 * z, 0.56 * z)),
        *(
            box(GREY_METAL, around(0.44 * x, 0.05 * x), around(s * 0.2 * y, 0.06 * y), (0.42 * z, 0.5 * z))
            for s in (-1, 1)
        ),
    ]
    return Build(body=body)


def conveyor(spec: Spec) -> Build:
    """Return a belt conveyor on legs, along y."""
    x, y, z = spec.size
    frame = spec.main(Finish((0.28, 0.40, 0.52), "metal"))
    drum = 0.14 * z
    body: list[Part] = [
        box(DARK_PLASTIC, around(0, 0.86 * x), around(0, y - drum), (z - drum, z)),
        *(
            box(frame, (s * x / 2, s * (x / 2 - 0.05 * x)), around(0, y - 0.4 * drum), (z - 1.2 * drum, z - 0.1 * drum))
            for s in (-1, 1)
        ),
        *(
            cylinder(DARK_PLASTIC, around(0, 0.86 * x), around(s * (y - drum) / 2, drum), (z - drum, z), axis=0)
            for s in (-1, 1)
        ),
    ]
    count = max(2, round(y / 1.2) + 1)
    for k in range(count):
        at = (k / (count - 1) - 0.5) * (y - 0.3 * min(y, 1.0))
        body += [leg(frame, (s * 0.46 * x, at), (s * 0.46 * x, at), (0, z - 1.2 * drum), 0.05, 0.05) for s in (-1, 1)]
        body.append(box(frame, around(0, 0.92 * x), around(at, 0.03), (0.2 * z, 0.26 * z)))
    return Build(body=body, surfaces=[top_surface("belt", around(0, 0.86 * x), around(0, y - drum), z)])


def stack_light(spec: Spec) -> Build:
    """Return a signal tower of three lights."""
    x, y, z = spec.size
    radius, low = min(x, y) / 2, 0.4 * z
    tones = ((0.20, 0.75, 0.35), (0.98, 0.72, 0.18), (0.90, 0.18, 0.14))
    step = (0.96 * z - low) / 3
    body: list[Part] = [
        disc(IRON, (0, 0), radius, (0, 0.05 * z)),
        disc(GREY_METAL, (0, 0), 0.36 * radius, (0.05 * z, low)),
    ]
    body += [
        disc(Finish(tone, "light"), (0, 0), 0.8 * radius, (low + k * step, low + (k + 0.94) * step))
        for k, tone in enumerate(tones)
    ]
    return Build(body=[*body, disc(IRON, (0, 0), 0.84 * radius, (0.94 * z, z))])
