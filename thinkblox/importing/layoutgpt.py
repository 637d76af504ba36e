"""LayoutGPT (Feng et al. 2023), https://github.com/weixi-feng/LayoutGPT: run_layoutgpt_3d.py, eval_scene_layout.py.

A list of predictions, one a room::

    [{"query_id": "...", "iter": 0, "prompt": "... Room Size: max length 256px, max width 318px ...",
      "object_list": [["double_bed", {"length": 128.0, "width": 150.0, "height": 70.0,
                                      "left": 64.0, "top": 75.0, "depth": 35.0, "orientation": 90.0}], ...]}]

The axes are those of 3D-FRONT seen as a web page: `left` is x, `top` is z and runs down the page, `depth` is upwards;
all three are of the box's middle. `length` is along x, `width` along z and `height` upwards, in full, before
`orientation`, degrees counter-clockwise as seen from above. At 0 the front faces +z, which is down the page. The origin
is the corner of the room's bounding box at the top left.

Numbers are whole pixels, unless the prompt says metres ("3.50m"); with --normalize metres are short sides as well. So
the file has no scale: `short_side` gives it, else it is worked out from usual sizes of what is in all the rooms of the
file, with a note. In the published samples the rooms' own objects say hardly anything of a scale of their own (of 423
bedrooms, whose short sides differ, one half of a room's objects tells nothing of the other half's: r = 0.1). A base is
its rounded middle less half of its rounded height: what is within a pixel of the floor stands on it. The floor is the
rectangle of the prompt. The true outline, doors and windows are not in the file, nor meshes: these are looked up by
size when the room is drawn.
"""

import re
from collections.abc import Iterable, Sequence
from statistics import median
from typing import Annotated, Any

from msgspec import Meta, structs

from thinkblox.importing.document import Degrees, Document, Foreign, plain
from thinkblox.importing.draft import Item, LayoutDraft, RoomOutline
from thinkblox.importing.frames import OWN_FROM_Y_UP, Y_UP, about
from thinkblox.importing.usual import usual_size

PIXEL, HUNDREDTH = 1.0, 0.01
"""What a number is rounded to [px], [m]: things nearer than this to the floor stand on it."""
_SIZE = re.compile(r"max length ([0-9.]{1,12}) ?(px|m|), ?max width ([0-9.]{1,12}) ?(?:px|m|)(?![\w.])")
Number = Annotated[float, Meta(ge=-1e6, le=1e6)]
Positive = Annotated[float, Meta(gt=0.0, le=1e6)]


class _Box(Foreign, frozen=True, kw_only=True):
    length: Positive
    width: Positive
    height: Positive
    left: Number
    top: Number
    depth: Number
    orientation: Degrees


class _Prediction(Foreign, frozen=True, kw_only=True):
    prompt: str
    object_list: list[tuple[str, _Box]]
    query_id: str | int = ""
    iter: int = 0


def is_layoutgpt(raw: Any) -> bool:
    """Whether a JSON value is a prediction of LayoutGPT's, or a list that begins with one."""
    first = raw[0] if isinstance(raw, list) and raw else raw
    return isinstance(first, dict) and "object_list" in first


def read_layoutgpt(document: Document, *, room: str | None = None, short_side: float | None = None) -> LayoutDraft:
    """Read one prediction; raises InputError naming the file and JSON path of whatever is wrong.

    Args:
        document: the file.
        room: its query_id; may be None where there is only one.
        short_side: of the room [m].
    """
    at, prediction, every = _chosen(document, room)
    length, width, metres, rounded = _room_size(document, at, prediction.prompt)
    notes: tuple[str, ...] = ()
    scale = 1.0
    if not metres:
        scale, notes = _scale(document, at, every, min(length, width), short_side)
    items = tuple(
        _item(kind, _seated(box, rounded), index, f"{at}.object_list[{index}]", scale, width)
        for index, (kind, box) in enumerate(prediction.object_list)
    )
    corners = ((0.0, 0.0), (length * scale, 0.0), (length * scale, width * scale), (0.0, width * scale))
    return LayoutDraft(
        outline=RoomOutline(corners=corners, at=f"{at}.prompt"),
        items=items,
        prompt=prediction.prompt,
        notes=(*notes, "The floor is the rectangle of the prompt; doors and windows are not in the file."),
    )


def _chosen(document: Document, room: str | None) -> tuple[str, _Prediction, Sequence[_Prediction]]:
    """Where the prediction stands, it, and all of the file."""
    if isinstance(document.raw, dict):
        only = document.typed(_Prediction)
        return "$", only, (only,)
    predictions = document.typed(list[_Prediction])
    ids = [str(each.query_id) for each in predictions]
    if not ids:
        document.fail("$", "the list holds no layout")
    if room is None and len(ids) == 1:
        return "$[0]", predictions[0], predictions
    if room is None or room not in ids:
        document.fail(
            "$", f"{len(ids)} layouts: say which to read (--room); they are {', '.join(map(plain, ids[:20]))}"
        )
    index = ids.index(room)
    return f"$[{index}]", predictions[index], predictions


def _room_size(document: Document, at: str, prompt: str) -> tuple[float, float, bool, float]:
    """Length, width, whether they are metres, and what numbers are rounded to."""
    found = _SIZE.search(prompt)
    if not found:
        document.fail(f"{at}.prompt", "the room's size is missing; it says 'max length 256px, max width 318px'")
    try:
        length, width = float(found[1]), float(found[3])
    except ValueError:
        document.fail(f"{at}.prompt", f"{found[0]!r} holds no numbers")
    if min(length, width) <= 0.0:
        document.fail(f"{at}.prompt", f"a room of {length:g} by {width:g}; both must be positive")
    metres = found[2] == "m"
    return length, width, metres and abs(min(length, width) - 1.0) > 0.005, HUNDREDTH if metres else PIXEL


def _scale(
    document: Document, at: str, predictions: Sequence[_Prediction], short: float, short_side: float | None
) -> tuple[float, tuple[str, ...]]:
    """Metres for one unit of the file, and what to say about it."""
    if short_side is not None:
        return short_side / short, ()
    ratios = _ratios(thing for prediction in predictions for thing in prediction.object_list)
    if not ratios:
        document.fail(
            f"{at}.prompt",
            "lengths are in pixels, and nothing in the file is of a usual size; give the room's short side [m]"
            " (--short-side)",
        )
    scale = median(ratios)
    rooms = "1 room" if len(predictions) == 1 else f"{len(predictions)} rooms"
    note = (
        f"Lengths are in pixels. That the short side is {short * scale:.2f} m was guessed from the usual sizes of"
        f" {len(ratios)} objects in {rooms} of the file; give its true length to be exact."
    )
    return scale, (note,)


def _seated(box: _Box, step: float) -> _Box:
    """The box on the floor, where its numbers are rounded to `step` and it is no further than that from it."""
    rounded = all(abs(2 * value / step - round(2 * value / step)) < 1e-6 for value in (box.depth, box.height))
    base = box.depth - box.height / 2
    return structs.replace(box, depth=box.height / 2) if rounded and abs(base) <= step * (1 + 1e-6) else box


def _ratios(objects: Iterable[tuple[str, _Box]]) -> list[float]:
    """For each object of a usual size, metres for one unit by its volume."""
    found = []
    for kind, box in objects:
        size = usual_size(kind)
        if size:
            found.append(((size[0] * size[1] * size[2]) / (box.length * box.width * box.height)) ** (1 / 3))
    return found


def _item(kind: str, box: _Box, index: int, at: str, scale: float, width: float) -> Item:
    return Item(
        name=f"{kind}_{index}",
        kind=kind,
        at=at,
        position=(box.left * scale, (width - box.top) * scale, box.depth * scale),
        linear=Y_UP @ about("y", box.orientation) @ OWN_FROM_Y_UP.T,
        size=(box.width * scale, box.length * scale, box.height * scale),
    )
