"""Rows of the catalogue: plants, small things, wall things and textiles."""

from thinkblox.assets import (
    bathroom,
    fittings,
    household,
    panels,
    plants,
    shop,
    small,
    textiles,
    vessels,
)
from thinkblox.assets.rows import large, row, small_thing, wall

PLANTS = (
    row(
        "plant",
        (0.70, 0.70, 1.40),
        12,
        plants.plant,
        front="any",
        low=0.4,
        variants={"small": (0.45, 0.45, 0.7), "tall": (0.75, 0.75, 1.6)},
    ),
    small_thing(
        "potted_plant", (0.24, 0.24, 0.32), 1.6, plants.potted_plant, front="any", high=2.5, noun="potted plant"
    ),
    row("flower_bucket", (0.42, 0.42, 0.62), 4.5, plants.flower_bucket, front="any", noun="bucket of flowers"),
    row("planter", (0.36, 1.00, 0.72), 26, shop.planter, front="two"),
    small_thing("vase", (0.16, 0.16, 0.30), 1.2, vessels.vase, front="any"),
)

SMALL = (
    small_thing("bowl", (0.18, 0.18, 0.08), 0.45, vessels.bowl, front="any"),
    small_thing("fruit_bowl", (0.30, 0.30, 0.18), 1.6, vessels.fruit_bowl, front="any", noun="bowl of fruit"),
    small_thing("plate", (0.26, 0.26, 0.025), 0.55, vessels.plate, front="any"),
    small_thing("cup", (0.085, 0.12, 0.095), 0.33, vessels.cup),
    small_thing("glass", (0.07, 0.07, 0.12), 0.25, vessels.glass, front="any"),
    small_thing("teapot", (0.24, 0.15, 0.15), 0.8, vessels.teapot),
    small_thing("bottle", (0.078, 0.078, 0.30), 1.2, vessels.bottle, front="any"),
    small_thing("jar", (0.095, 0.095, 0.14), 0.7, vessels.jar, front="any"),
    small_thing("food_tray", (0.40, 0.32, 0.08), 3.0, small.food_tray),
    small_thing("tray", (0.30, 0.42, 0.045), 0.9, small.tray, front="two"),
    small_thing("cutlery", (0.22, 0.14, 0.012), 0.15, small.cutlery),
    small_thing("book", (0.22, 0.15, 0.03), 0.5, small.book),
    small_thing("book_stack", (0.24, 0.18, 0.16), 2.6, small.book_stack, noun="stack of books"),
    small_thing("magazine", (0.29, 0.22, 0.02), 0.5, small.magazine, noun="magazines"),
    small_thing("notebook", (0.21, 0.15, 0.014), 0.3, small.book),
    small_thing("paper", (0.297, 0.21, 0.02), 0.6, small.paper_stack, noun="stack of paper"),
    small_thing("pen_holder", (0.09, 0.09, 0.18), 0.3, vessels.pen_holder, front="any"),
    small_thing("globe", (0.30, 0.30, 0.40), 1.8, vessels.globe),
    small_thing("toy", (0.22, 0.22, 0.26), 0.5, small.toy),
    small_thing("box", (0.36, 0.46, 0.32), 4, vessels.box_of_card, front="two", high=2.5),
    small_thing("basket", (0.34, 0.34, 0.26), 1.2, vessels.basket, front="any"),
    small_thing("photo_frame", (0.11, 0.16, 0.21), 0.4, small.photo_frame, noun="photo frame"),
    small_thing("alarm_clock", (0.06, 0.12, 0.14), 0.35, small.alarm_clock),
    small_thing("trophy", (0.14, 0.14, 0.30), 1.4, vessels.trophy, front="any"),
    small_thing("aquarium", (0.35, 0.80, 0.48), 65, household.aquarium),
    small_thing("pillow", (0.42, 0.42, 0.13), 0.6, small.pillow, front="two", friction=0.8),
    small_thing("blanket", (0.32, 0.42, 0.09), 1.2, small.blanket, friction=0.8),
    small_thing("towels", (0.30, 0.40, 0.22), 1.6, bathroom.towel_stack, friction=0.8),
    small_thing("soap_dispenser", (0.10, 0.07, 0.18), 0.4, bathroom.soap_dispenser),
    row("waste_bin", (0.28, 0.28, 0.36), 1.5, vessels.waste_bin, front="any", noun="waste bin"),
    row("laundry_basket", (0.44, 0.44, 0.58), 3.0, vessels.basket, front="any", noun="laundry basket"),
    row("umbrella_stand", (0.24, 0.24, 0.80), 4, vessels.umbrella_stand, front="any"),
    row("ironing_board", (0.40, 1.30, 0.90), 6, household.ironing_board, front="one", clearance=0.6),
    row("drying_rack", (0.60, 1.20, 1.05), 4.5, household.drying_rack, front="two"),
    row("ladder", (0.82, 0.50, 1.30), 7, household.ladder),
)

WALLS = (
    wall("whiteboard", (0.08, 1.80, 1.20), 16, panels.whiteboard, high=2.5),
    wall("blackboard", (0.09, 2.40, 1.20), 30, panels.whiteboard, high=2.0),
    wall("projector_screen", (0.09, 2.00, 1.35), 10, panels.screen, high=1.8, noun="projection screen"),
    wall("menu_board", (0.04, 1.20, 0.80), 8, panels.menu_board),
    wall(
        "picture",
        (0.03, 0.80, 0.60),
        3,
        panels.picture,
        low=0.3,
        variants={"large": (0.03, 1.2, 0.85), "small": (0.025, 0.4, 0.5), "tall": (0.03, 0.6, 0.85)},
    ),
    wall("poster", (0.015, 0.50, 0.70), 0.8, panels.picture, low=0.4),
    wall(
        "mirror",
        (0.03, 0.70, 0.90),
        8,
        panels.mirror,
        variants={"round": (0.03, 0.75, 0.75), "oval": (0.03, 0.55, 0.85), "tall": (0.03, 0.5, 1.4)},
    ),
    wall("clock", (0.05, 0.32, 0.32), 0.9, panels.clock),
    wall("dart_board", (0.05, 0.46, 0.46), 4.5, panels.dart_board, noun="dart board"),
    wall("curtain", (0.12, 1.80, 2.30), 4, fittings.curtain, high=2.2, noun="pair of curtains"),
    wall("curtain_rail", (0.60, 2.00, 2.05), 6, fittings.curtain_rail, high=1.8, noun="privacy curtain"),
    wall("radiator", (0.12, 1.00, 0.60), 22, fittings.radiator),
    large("fireplace", (0.42, 1.40, 1.12), 150, shop.fireplace, clearance=0.9, friction=0.8),
    large("room_divider", (0.40, 1.50, 1.75), 14, fittings.room_divider, front="two"),
    row("standing_mirror", (0.48, 0.55, 1.70), 11, fittings.standing_mirror, clearance=0.6, noun="standing mirror"),
)

TEXTILES = (
    row(
        "rug",
        (1.60, 2.30, 0.008),
        9,
        textiles.rug,
        front="two",
        flat=True,
        high=3.0,
        low=0.3,
        variants={"round": (1.7, 1.7, 0.008), "large": (2.0, 2.9, 0.008), "small": (0.9, 1.4, 0.008)},
    ),
    row("bath_mat", (0.50, 0.80, 0.008), 1.0, textiles.mat, front="two", flat=True),
    row("door_mat", (0.45, 0.75, 0.008), 1.5, textiles.mat, front="two", flat=True),
    row("yoga_mat", (0.62, 1.80, 0.006), 1.2, textiles.mat, front="two", flat=True),
)
