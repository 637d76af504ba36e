"""What floors and walls can be made of."""

from typing import Literal

from thinkblox.checked import Share

Laying = Literal[
    "planks",  # boards of wood, along the room
    "parquet",  # squares of five staves, turned by turns
    "herringbone",  # staves at right angles, across the room
    "panels",  # upright boards on a wall
    "tiles",  # square tiles with joints
    "subway",  # low tiles in bond
    "checker",  # square tiles of two colours by turns
    "stone",  # slabs in bond
    "marble",  # large veined slabs
    "terrazzo",  # chips in cement
    "concrete",  # cast in fields
    "linoleum",  # mottled sheet
    "rubber",  # flecked mats
    "carpet",  # cut pile
    "carpet_tiles",  # squares of ribbed carpet, turned by turns
    "brick",  # brickwork in bond
    "paint",  # smooth plaster
    "stripes",  # wallpaper with upright stripes
    "motifs",  # wallpaper with small figures
    "flowers",  # wallpaper with blossoms
]
"""What a surface is made of, and in which pattern."""
Colour = tuple[Share, Share, Share]
"""An sRGB colour."""
