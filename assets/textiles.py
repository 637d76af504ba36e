"""Rugs and mats: thin, walked on, and so without collision."""

from dataclasses import replace

from thinkblox.assets.palette import LINEN, WICKER
from thinkblox.assets.part import Build, Finish, Part
from thinkblox.assets.shapes import around, box, disc, oval, prism
from thinkblox.assets.spec import Spec


def rug(spec: Spec) -> Build:
    """Return a rug with a border and a few stripes, or rings when round."""
    x, y, z = spec.size
    ground = spec.main(spec.choice((LINEN, spec.style.accent, spec.style.fabric)))
    edge = _darker(ground, 0.72)
    light = _lighter(ground)
    if spec.has("round", "oval", "circular"):
        return _loose(
            [
                _round(finish, x * share, y * share, (low * z, high * z))
                for finish, share, low, high in (
                    (edge, 1.0, 0, 0.7),
                    (ground, 0.93, 0.7, 0.85),
                    (light, 0.62, 0.85, 0.92),
                    (ground, 0.55, 0.92, 1.0),
                )
            ]
        )
    border = min(0.09, 0.08 * min(x, y))
    body: list[Part] = [box(edge, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.7 * z))]
    body.append(box(ground, around(0, x - 2 * border), around(0, y - 2 * border), (0.7 * z, 0.9 * z)))
    if spec.rng.random() < 0.5:
        body.append(box(light, around(0, x - 3.4 * border), around(0, y - 3.4 * border), (0.9 * z, 0.95 * z)))
        body.append(box(ground, around(0, x - 4.2 * border), around(0, y - 4.2 * border), (0.95 * z, z)))
    else:
        count = max(3, round(y / 0.34))
        for k in range(count):
            at = (k - (count - 1) / 2) * (y - 2 * border) / count
            body.append(box(light if k % 2 else edge, around(0, x - 2 * border), around(at, 0.03), (0.9 * z, z)))
    return _loose(body)


def _round(finish: Finish, x: float, y: float, z: tuple[float, float]) -> Part:
    if abs(x - y) < 1e-9:
        return disc(finish, (0, 0), x / 2, z)
    return prism(finish, oval(x, y), z, smooth=True)


def _loose(parts: list[Part]) -> Build:
    return Build(body=[replace(p, collide=False) for p in parts])


def _darker(finish: Finish, share: float) -> Finish:
    r, g, b = finish.colour
    return Finish((r * share, g * share, b * share), finish.material)


def _lighter(finish: Finish) -> Finish:
    r, g, b = (1 - 0.55 * (1 - c) for c in finish.colour)
    return Finish((r, g, b), finish.material)


def mat(spec: Spec) -> Build:
    """Return a plain mat with a hem: for baths, doors or yoga."""
    x, y, z = spec.size
    usual = {"door_mat": WICKER, "yoga_mat": Finish(spec.style.accent.colour, "plastic")}.get(
        spec.category, spec.style.accent
    )
    cloth = spec.main(Finish(usual.colour, "fabric" if usual.material == "wood" else usual.material))
    body = [box(_darker(cloth, 0.82), (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.8 * z))]
    body.append(box(cloth, around(0, x - 0.05), around(0, y - 0.05), (0.8 * z, z)))
    return _loose(body)
