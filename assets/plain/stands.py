"""Plain pieces on a stand or in a frame: desks for notes, lamps on poles, loudspeakers, cubicles, crosses, loungers."""

from math import cos, pi, sin

from thinkblox.assets.palette import BLACK_PLASTIC, BRIGHT, DARK_PLASTIC, GREY_METAL, IRON, MIRROR, PALE_GLASS
from thinkblox.assets.part import Build, Finish, Part
from thinkblox.assets.plain.pieces import booth
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, frustum, prism, rod, top_surface
from thinkblox.assets.spec import Spec

_SIGNALS = ((0.80, 0.16, 0.14), (0.95, 0.70, 0.16), (0.20, 0.66, 0.34))


def notes_stand(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a sloping desk with a ledge, on a pole with three feet."""
    x, y, z = spec.size
    finish, thin = spec.main(main), min(0.014, 0.03 * z)
    low, ledge, deep = 0.74 * z, 0.3 * x, 0.02
    desk = [(ledge, low), (ledge - deep, low), (-0.3 * x - deep, z), (-0.3 * x, z)]
    feet = [(x / 2 * cos(a) * 0.96, y / 2 * sin(a) * 0.96) for a in (pi, pi / 3, -pi / 3)]
    return Build(
        body=[
            prism(finish, desk, (-y / 2, y / 2), axis=1),
            box(finish, (ledge - deep, ledge + 0.05), (-y / 2, y / 2), (low - 0.012, low)),
            disc(accent, (-0.02 * x, 0), thin, (0.1 * z, 0.86 * z)),
            disc(accent, (-0.02 * x, 0), 2 * thin, (0.1 * z, 0.17 * z)),
            *(rod(accent, (0.0, 0.0, 0.13 * z), (a, b, thin), 0.8 * thin) for a, b in feet),
            *(disc(accent, foot, 1.4 * thin, (0, 2 * thin)) for foot in feet),
        ]
    )


def lectern(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a reading desk: a sloping top of the accent on a tapered column, with a foot."""
    x, y, z = spec.size
    finish = spec.main(main)
    top = [(x / 2, 0.82 * z), (x / 2, 0.86 * z), (-x / 2, z), (-x / 2, 0.93 * z)]
    column = [(-0.34 * x, 0.05 * z), (0.26 * x, 0.05 * z), (0.36 * x, 0.86 * z), (-0.42 * x, 0.94 * z)]
    return Build(
        body=[
            box(finish, (-x / 2, 0.4 * x), around(0, 0.9 * y), (0, 0.06 * z)),
            prism(finish, column, around(0, 0.66 * y), axis=1),
            prism(accent, top, (-y / 2, y / 2), axis=1),
            box(finish, (0.46 * x, x / 2), (-y / 2, y / 2), (0.85 * z, 0.89 * z)),
        ]
    )


def spotlight(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a lamp on a pole with three feet, its broad face of the accent tilted down to the front."""
    x, y, z = spec.size
    finish, thin = spec.main(main), 0.014
    feet = [(x / 2 * cos(a) * 0.95, y / 2 * sin(a) * 0.95) for a in (pi, pi / 3, -pi / 3)]
    wide, tall = 0.8 * y, min(0.7 * y, 0.3 * z)
    back, lean = z - 0.8 * tall, 0.25 * tall
    face = [(0.3 * x, z - tall), (0.3 * x + lean, z), (0.3 * x + lean - 0.02, z), (0.3 * x - 0.02, z - tall)]
    shade = [(0.29 * x, z - tall), (0.29 * x + lean, z), (-0.06 * x, back + 0.5 * tall), (-0.06 * x, back + 0.2 * tall)]
    return Build(
        body=[
            disc(IRON, (-0.02 * x, 0), thin, (0.12 * z, back + 0.4 * tall)),
            *(rod(IRON, (-0.02 * x, 0.0, 0.24 * z), (a, b, thin), 0.8 * thin) for a, b in feet),
            *(disc(IRON, foot, 1.4 * thin, (0, 2 * thin)) for foot in feet),
            prism(finish, shade, around(0, 0.9 * wide), axis=1),
            prism(accent, face, around(0, wide), axis=1),
        ]
    )


def loudspeaker(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a case with the cone of a woofer and, where it is higher than wide, that of a tweeter."""
    x, y, z = spec.size
    face = x / 2 - 0.02
    body: list[Part] = [cushion(spec.main(main), (-x / 2, face), (-y / 2, y / 2), (0, z), radius=0.015)]
    upright = z > 1.15 * y
    large = 0.4 * min(y, 0.6 * z if upright else z)
    for height, radius in ((0.34 * z, large), (0.78 * z, 0.5 * large)) if upright else ((0.5 * z, large),):
        for share, finish, front in ((1.0, accent, 0.012), (0.84, DARK_PLASTIC, 0.016), (0.36, accent, 0.02)):
            across, up = around(0, 2 * share * radius), around(height, 2 * share * radius)
            body.append(cylinder(finish, (face - 0.002, face + front), across, up, axis=0))
    return Build(body=body)


def guitar_amplifier(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a combo: a case with a cloth before its speaker, a row of knobs above it, and a handle on top."""
    x, y, z = spec.size
    top, face = z - 0.035, x / 2 - 0.02
    body: list[Part] = [
        cushion(spec.main(main), (-x / 2, face), (-y / 2, y / 2), (0, top), radius=0.02),
        box(accent, (face, x / 2 - 0.008), around(0, 0.88 * y), (0.06 * z, 0.7 * z)),
        box(GREY_METAL, (face, face + 0.006), around(0, 0.88 * y), (0.74 * z, 0.88 * z)),
        box(BLACK_PLASTIC, around(-0.05 * x, 0.03), around(0, 0.3 * y), (z - 0.012, z)),
        *(box(BLACK_PLASTIC, around(-0.05 * x, 0.03), around(s * 0.14 * y, 0.02), (top - 0.01, z)) for s in (-1, 1)),
    ]
    for k in range(6):
        at = around((k / 5 - 0.5) * 0.7 * y, 0.05 * y)
        body.append(cylinder(BLACK_PLASTIC, (face, x / 2), at, around(0.81 * z, 0.05 * y), axis=0))
    return Build(body=body)


def fitting_cubicle(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a cubicle with a mirror and a hook inside, and a curtain of the accent drawn half across its front."""
    x, y, z = spec.size
    build = booth(spec, main, main)
    post, top = min(0.08, 0.08 * min(x, y)), 0.94 * z
    folds, half = 7, 0.46 * (y - 2 * post)
    start = -y / 2 + post
    build.body += [
        box(MIRROR, (-x / 2 + 0.3 * post, -x / 2 + 0.3 * post + 0.008), around(0, 0.4 * y), (0.2 * z, 0.82 * z)),
        cylinder(IRON, around(x / 2 - post / 2, 0.024), around(0, y - 2 * post), around(top - 0.05, 0.024), axis=1),
    ]
    for k in range(folds):
        depth = x / 2 - post / 2 + (0.012 if k % 2 else -0.012)
        at = around(start + (k + 0.5) * half / folds, half / folds)
        build.body.append(cushion(accent, around(depth, 0.03), at, (0.08 * z, top - 0.04), radius=0.012))
    return build


def cross(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return an upright cross on a stepped foot of the accent."""
    x, y, z = spec.size
    bar, finish = 0.07 * z, spec.main(main)
    return Build(
        body=[
            box(accent, (-x / 2, x / 2), around(0, 0.9 * y), (0, 0.04 * z)),
            box(accent, around(0, 0.7 * x), around(0, 0.6 * y), (0.04 * z, 0.08 * z)),
            box(finish, around(0, bar), around(0, bar), (0.08 * z, z)),
            box(finish, around(0, 0.9 * bar), (-y / 2, y / 2), (0.7 * z, 0.7 * z + bar)),
        ]
    )


def sunbed(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a long frame on legs with a pad of the accent, its head raised at the back."""
    x, y, z = spec.size
    finish, level = spec.main(main), 0.62 * z
    joint = -0.16 * x
    rise = [(joint, level), (joint, level + 0.2 * z), (-x / 2, z), (-x / 2, 0.84 * z)]
    body: list[Part] = [
        *(box(finish, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - 0.05)), (level - 0.07, level)) for s in (-1, 1)),
        *(box(finish, around(k * 0.13 * x, 0.07), around(0, y - 0.1), (level - 0.03, level)) for k in range(-3, 4)),
        cushion(accent, (joint, x / 2), around(0, 0.94 * y), (level, level + 0.2 * z), radius=0.03),
        prism(accent, rise, around(0, 0.94 * y), axis=1),
    ]
    for s in (-1, 1):
        body += [box(finish, around(t * 0.42 * x, 0.05), around(s * (y / 2 - 0.03), 0.05), (0, level)) for t in (-1, 1)]
    pad = top_surface("pad", (joint + 0.05, x / 2 - 0.04), around(0, 0.8 * y), level + 0.2 * z)
    return Build(body=body, surfaces=[pad])


def signals(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a traffic light: a case with three lamps under visors."""
    x, y, z = spec.size
    face, radius = 0.1 * x, min(0.34 * y, 0.13 * z)
    body: list[Part] = [cushion(spec.main(main), (-x / 2, face), (-y / 2, y / 2), (0, z), radius=0.02)]
    for k, colour in enumerate(_SIGNALS):
        middle = (0.82 - 0.32 * k) * z
        lamp = (around(0, 2 * radius), around(middle, 2 * radius))
        body.append(cylinder(Finish(colour, "ceramic"), (face, face + 0.03 * x), *lamp, axis=0))
        body.append(box(BLACK_PLASTIC, (face, x / 2), around(0, 1.9 * radius), around(middle + radius, 0.008)))
    return Build(body=body)


def claw_machine(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a cabinet of glass above, with bright prizes under a claw, and a panel with a stick."""
    x, y, z = spec.size
    finish, base, roof, post = spec.main(main), 0.42 * z, 0.88 * z, 0.04
    back = 0.36 * x
    body: list[Part] = [
        box(finish, (-x / 2, back), (-y / 2, y / 2), (0, base)),
        box(finish, (-x / 2, back), (-y / 2, y / 2), (roof, z)),
        box(PALE_GLASS, (-x / 2, -x / 2 + 0.01), around(0, y - 2 * post), (base, roof)),
        prism(finish, [(back, 0.3 * z), (x / 2, 0.36 * z), (back, base)], around(0, 0.9 * y), axis=1),
        box(BLACK_PLASTIC, (back, back + 0.01), around(-0.24 * y, 0.36 * y), (0.06 * z, 0.2 * z)),
        disc(GREY_METAL, (-0.08 * x, 0), 0.012, (0.72 * z, roof)),
        frustum(GREY_METAL, (-0.08 * x, 0), (0.66 * z, 0.73 * z), 0.1 * y, 0.04 * y),
        disc(Finish(BRIGHT[0], "plastic"), (0.43 * x, -0.12 * y), 0.02, (0.37 * z, 0.43 * z)),
    ]
    for side in (-1, 1):
        rim = (side * y / 2, side * (y / 2 - post))
        body += [box(finish, at, rim, (base, roof)) for at in ((-x / 2, -x / 2 + post), (back - post, back))]
    body += [
        cushion(
            Finish(BRIGHT[k % len(BRIGHT)], "fabric"),
            around((k // 4 - 1) * 0.22 * x - 0.06 * x, 0.2 * x),
            around((k % 4 - 1.5) * 0.22 * y, 0.2 * y),
            (base, base + (0.1 + 0.02 * (k * 3 % 4)) * z),
            radius=0.06,
        )
        for k in range(12)
    ]
    return Build(body=body)


def luggage_cart(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a low deck of the accent on wheels, under two hoops with a bar between them to hang clothes on."""
    x, y, z = spec.size
    finish, tube, wheel = spec.main(main), min(0.03, 0.06 * x), min(0.14, 0.1 * z)
    deck = wheel + 0.06
    ends = (-y / 2 + tube, y / 2 - tube)
    body: list[Part] = [cushion(accent, (-x / 2, x / 2), (-y / 2, y / 2), (deck - 0.04, deck), radius=0.015)]
    for end in ends:
        for s in (-1, 1):
            at = s * (x / 2 - tube)
            body.append(disc(finish, (at, end), tube / 2, (deck, z - tube)))
            body.append(cylinder(BLACK_PLASTIC, around(0.94 * at, wheel), around(0.9 * end, 0.04), (0, wheel), axis=1))
            body.append(disc(GREY_METAL, (0.94 * at, 0.9 * end), 0.02, (wheel / 2, deck - 0.04)))
        body.append(cylinder(finish, around(0, x - tube), around(end, tube), (z - tube, z), axis=0))
    body.append(cylinder(finish, around(0, tube), around(0, y - 3 * tube), (z - tube, z), axis=1))
    carried = ((-x / 2 + 2 * tube, x / 2 - 2 * tube), (-y / 2 + 2 * tube, y / 2 - 2 * tube))
    return Build(body=body, surfaces=[top_surface("deck", *carried, deck, headroom=z - tube - deck)])


def brazier(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a bowl on three legs with coals of the accent in it under a grate."""
    x, y, z = spec.size
    r, finish = min(x, y) / 2, spec.main(main)
    low, rim = 0.4 * z, z - 0.012
    feet = [(0.8 * r * cos(a), 0.8 * r * sin(a)) for a in (0.0, 2 * pi / 3, 4 * pi / 3)]
    return Build(
        body=[
            *(rod(finish, (a, b, 0.012), (0.7 * a, 0.7 * b, low + 0.02), 0.024) for a, b in feet),
            frustum(finish, (0, 0), (low, 0.82 * z), 0.6 * r, r),
            disc(accent, (0, 0), 0.9 * r, (0.82 * z, 0.9 * z)),
            disc(finish, (0, 0), r, (0.9 * z, rim)),
            disc(IRON, (0, 0), 0.94 * r, (rim, z)),
        ],
        surfaces=[top_surface("grate", around(0, 1.3 * r), around(0, 1.3 * r), z, round=True)],
        front="any",
    )
