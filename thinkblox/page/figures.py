"""The pictures of a page: an image with what is drawn on it as SVG, and a legend of what is drawn."""

import base64
import io
from collections.abc import Collection, Iterable, Mapping, Sequence

from thinkblox.page.markup import Markup, element, joined
from thinkblox.sim.render.drawn import Badge, FaultPicture, Mark, Ring, Silhouette
from thinkblox.sim.render.fault_labels import BADGE
from thinkblox.sim.render.faults import Kind

QUALITY = 88
HEAD, HALF = 9.0, 4.0
"""Length and half width of an arrow's head [pixels]."""
LEGEND: dict[str, str] = {
    "faulty": "fails; its number is that of the table",
    "hidden": "the part of it that is hidden, or is not in the picture",
    "overlap": "what two objects both fill",
    "contact": "where two objects touch too deeply",
    "outside": "outside the room, and how far",
    "gap": "hangs free: dashes lead to what lies below it",
    "rest": "where it ends up when it is let go",
    "swing": "what a door or drawer goes through, and is kept from",
    "zone": "a door's or window's zone that should be free",
    "push": "pushes another object",
    "unreachable": "cannot be reached",
    "move": "was moved from there to here to mend a fault",
}


def figure(picture: FaultPicture, rows: Mapping[str, int], cut_off: Collection[str], *, alt: str, says: str) -> Markup:
    """One picture.

    Args:
        picture: the image and what is drawn on it.
        rows: row of every object in the page's table, by id.
        cut_off: ids of objects that cannot be reached.
        alt: what the picture shows, for who does not see it.
        says: its caption.
    """
    left, top, right, bottom = picture.box
    width, height = right - left, bottom - top
    drawn = element(
        "svg",
        *_bodies(picture.outlines, {badge.id for badge in picture.badges}, rows, cut_off),
        *(_mark(mark, rows) for mark in picture.marks),
        *(_text(mark, rows) for mark in picture.marks if mark.text and mark.at is not None),
        *(_badge(badge, rows, cut_off) for badge in picture.badges),
        viewBox=f"{left:g} {top:g} {width:g} {height:g}", xmlns="http://www.w3.org/2000/svg", aria_hidden="true",
    )  # fmt: skip
    image = element("img", src=_data_uri(picture), alt=alt, width=round(width), height=round(height))
    return element("figure", element("div", image, drawn, class_="picture"), element("figcaption", says))


def patterns() -> Markup:
    """The hatchings that the pictures share."""
    hatches = [("outside", "#b3142b", 45), ("swing", "#b25600", -45), ("zone", "#6a2fa5", 0)]
    defined = [
        element(
            "pattern", element("rect", width=7, height=7, fill=colour, fill_opacity="0.12"),
            element("line", x1=0, y1=0, x2=0, y2=7, stroke=colour, stroke_width=2.2),
            id=f"hatch-{name}", width=7, height=7, patternUnits="userSpaceOnUse", patternTransform=f"rotate({turn})",
        )
        for name, colour, turn in hatches
    ]  # fmt: skip
    return element("svg", element("defs", *defined), width=0, height=0, aria_hidden="true", focusable="false")


def _data_uri(picture: FaultPicture) -> str:
    left, top, right, bottom = (round(edge) for edge in picture.box)
    data = io.BytesIO()
    picture.image.crop((left, top, right, bottom)).save(data, "JPEG", quality=QUALITY, subsampling=0, optimize=True)
    return "data:image/jpeg;base64," + base64.b64encode(data.getvalue()).decode()


def _bodies(
    outlines: Iterable[Silhouette], numbered: Collection[str], rows: Mapping[str, int], cut_off: Collection[str]
) -> list[Markup]:
    """The outlines of all objects, those that fail on top."""
    drawn = []
    for outline in sorted(outlines, key=lambda o: o.id in numbered):
        state = ""
        if outline.id in numbered:
            state = " faulty" if outline.id not in cut_off else " cut-off"
        hidden = " hidden" if outline.hidden else ""
        parts = [element("path", class_=f"whole{state}{hidden}", d=_path([outline.hull]))] if outline.hull else []
        if outline.rings:
            parts.append(element("path", class_=f"body{state}", fill_rule="evenodd", d=_path(outline.rings)))
        name = element("title", outline.id)
        drawn.append(element("g", name, *parts, data_n=rows.get(outline.id)))
    return drawn


def _path(rings: Sequence[Ring]) -> str:
    return "".join("M" + "L".join(f"{x:g} {y:g}" for x, y in ring[:-1]) + "Z" for ring in rings if len(ring) > 2)


def _mark(mark: Mark, rows: Mapping[str, int]) -> Markup:
    parts = []
    if mark.rings:
        parts.append(element("path", class_=mark.kind, d=_path(mark.rings)))
    parts += [_line("dash", *dash) for dash in mark.dashes]
    for x, y in mark.circles:
        parts += _circle(mark.kind, x, y)
    if mark.arrow is not None:
        parts += _arrow(mark.kind, *mark.arrow)
    return element("g", *parts, data_n=rows.get(mark.id))


def _text(mark: Mark, rows: Mapping[str, int]) -> Markup:
    """What a mark says, drawn over all the marks."""
    x, y = mark.at or (0.0, 0.0)
    return element("text", mark.text, class_="figure-text", x=x, y=y, data_n=rows.get(mark.id))


def _circle(kind: Kind, x: float, y: float) -> list[Markup]:
    if kind == "unreachable":
        slash = _line(kind, (x - 9.2, y + 9.2), (x + 9.2, y - 9.2))
        return [element("circle", class_=kind, cx=x, cy=y, r=13), slash]
    if kind == "contact":
        return [element("circle", class_=kind, cx=x, cy=y, r=5)]
    return [element("circle", class_=f"{kind} ring", cx=x, cy=y, r=9)]


def _arrow(kind: Kind, start: tuple[float, float], end: tuple[float, float]) -> list[Markup]:
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = (dx * dx + dy * dy) ** 0.5
    ux, uy = dx / length, dy / length
    neck = (end[0] - ux * HEAD, end[1] - uy * HEAD)
    head = [end, (neck[0] - uy * HALF, neck[1] + ux * HALF), (neck[0] + uy * HALF, neck[1] - ux * HALF)]
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in head)
    return [_line(f"arrow {kind}", start, neck), element("polygon", class_=f"head {kind}", points=points)]


def _line(kind: str, start: tuple[float, float], end: tuple[float, float]) -> Markup:
    x1, y1, x2, y2 = (round(c, 1) for c in (*start, *end))
    return element("line", class_=kind, x1=x1, y1=y1, x2=x2, y2=y2)


def _badge(badge: Badge, rows: Mapping[str, int], cut_off: Collection[str]) -> Markup:
    (x, y), row = badge.at, rows[badge.id]
    parts = [_line("", badge.at, badge.line_to)] if badge.line_to is not None else []
    parts.append(element("circle", cx=x, cy=y, r=BADGE))
    parts.append(element("text", str(badge.number), x=x, y=y))
    linked = element("a", element("title", badge.id), *parts, href=f"#object-{row}", tabindex=-1)
    return element("g", linked, class_="badge cut-off" if badge.id in cut_off else "badge", data_n=row)


def legend(pictures: Sequence[FaultPicture]) -> Markup:
    """What the signs mean that are in the pictures; nothing when there are none."""
    kinds = {mark.kind for picture in pictures for mark in picture.marks}
    numbered = {badge.id for picture in pictures for badge in picture.badges}
    hidden = any(o.hidden and o.id in numbered for picture in pictures for o in picture.outlines)
    shown = [k for k in LEGEND if k in kinds or (k == "faulty" and numbered) or (k == "hidden" and hidden)]
    if not shown:
        return Markup()
    items = [element("li", _swatch(kind), element("span", LEGEND[kind])) for kind in shown]
    return element("ul", *items, class_="legend", aria_label="What the signs in the pictures mean")


def _swatch(kind: str) -> Markup:
    box = "M4 4H30V18H4Z"
    if kind == "faulty":
        inside = [element("path", class_="body faulty", d=box)]
    elif kind == "hidden":
        inside = [element("path", class_="whole faulty hidden", d=box)]
    elif kind == "unreachable":
        inside = [element("circle", class_=kind, cx=17, cy=11, r=8), _line(kind, (11.4, 16.6), (22.6, 5.4))]
    elif kind == "contact":
        inside = [element("circle", class_=kind, cx=17, cy=11, r=5)]
    elif kind in ("push", "move"):
        inside = _arrow("push" if kind == "push" else "move", (4.0, 11.0), (30.0, 11.0))
    elif kind == "gap":
        inside = [*(_line("dash", (x, 3.0), (x, 19.0)) for x in (8.0, 26.0)), *_arrow("gap", (17.0, 2.0), (17.0, 20.0))]
    else:
        inside = [element("path", class_=kind, d=box)]
    return element("svg", *inside, viewBox="0 0 34 22", aria_hidden="true")


__all__ = ["figure", "joined", "legend", "patterns"]
