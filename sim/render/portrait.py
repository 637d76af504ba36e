"""Pictures of single assets on a plain ground, and sheets of many."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from shapely import box

from thinkblox.scene.asset import Asset
from thinkblox.sim.render.camera import framed
from thinkblox.sim.render.interior import add_ground
from thinkblox.sim.render.lighting import lights
from thinkblox.sim.render.materials import linear
from thinkblox.sim.render.picture import Settings, paint
from thinkblox.sim.render.picture_size import check_picture_count, check_picture_size
from thinkblox.sim.render.rays import Tracer
from thinkblox.sim.render.soup import Soup, pose_of

if TYPE_CHECKING:
    from PIL.Image import Image

AZIMUTH = 34.0
"""Where the camera stands, seen from the asset [degrees]: 0 is right before its front."""
ELEVATION = 24.0
MOST_COLUMNS = 100
"""Most pictures in a row of a sheet."""
_PAPER = (0.935, 0.925, 0.905)


def render_asset(asset: Asset, *, size: int = 256) -> "Image":
    """A three-quarter view of one asset from its front, on a plain ground.

    Args:
        asset: what to show.
        size: width and height [pixels].

    Raises:
        InputError: a size that no picture has.
    """
    from PIL import Image

    check_picture_size(size)
    soup = Soup()
    soup.add_asset(asset, pose_of((0.0, 0.0, 0.0), 0.0), 0)
    points = np.concatenate([mesh.vertices for mesh in soup.meshes]).astype(np.float64)
    camera = framed(points, azimuth=AZIMUTH, elevation=ELEVATION, field=24.0, margin=0.09)
    far = 12 * max(asset.size)
    add_ground(soup, box(-far, -far, far, far), -0.001)
    tracer = Tracer(soup.triangles())
    light = lights(tracer, np.array([0.62, -0.38, 0.95], np.float32), gather=24, sun_rays=8)
    paper = np.broadcast_to(np.array(linear(_PAPER), np.float32), (size, size, 3))
    return Image.fromarray(paint(tracer, camera, size, light, Settings(1.0, paper, coarse=1)))


def contact_sheet(assets: Sequence[Asset], *, columns: int = 6, size: int = 192) -> "Image":
    """Assets side by side with their categories and sizes beneath.

    Args:
        assets: what to show, row by row.
        columns: how many in a row.
        size: width and height of each picture [pixels].

    Raises:
        InputError: a size or a number of columns that no picture has.
    """
    from PIL import Image, ImageDraw, ImageFont

    check_picture_size(size)
    check_picture_count(columns, MOST_COLUMNS, "the number of columns")
    text = max(size // 14, 8)
    rows, tall = -(-len(assets) // columns), size + 2 * text + 10
    sheet = Image.new("RGB", (columns * size, max(rows, 1) * tall), tuple(round(255 * c) for c in _PAPER))
    draw, face = ImageDraw.Draw(sheet), ImageFont.load_default(text)
    for i, asset in enumerate(assets):
        left, top = i % columns * size, i // columns * tall
        sheet.paste(render_asset(asset, size=size), (left, top))
        length, width, height = asset.size
        caption = f"{asset.category}\n{length:.2f} x {width:.2f} x {height:.2f} m"
        at = (left + size / 2, top + size + text)
        draw.multiline_text(at, caption, fill=(58, 54, 50), font=face, anchor="mm", align="center", spacing=1)
    return sheet
