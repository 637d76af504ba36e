"""The table of categories: what can be asked for, how big and how heavy it is, and what makes it."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any

from thinkblox.assets import (
    appliances,
    bathroom,
    beds,
    desks,
    electronics,
    games,
    lamps,
    panels,
    plants,
    seats,
    shop,
    small,
    storage,
    tables,
    textiles,
    upholstery,
    vessels,
)
from thinkblox.assets.category import Category, Generator
from thinkblox.value import Vec3


def _row(name: str, size: Vec3, mass: float, make: Generator, **more: Any) -> Category:
    noun = more.pop("noun", name.replace("_", " "))
    return Category(name=name, noun=noun, generator=make, size=size, mass=mass, **more)


def _large(name: str, size: Vec3, mass: float, make: Generator, **more: Any) -> Category:
    return _row(name, size, mass, make, large=True, **more)


def _wall(name: str, size: Vec3, mass: float, make: Generator, **more: Any) -> Category:
    return _row(name, size, mass, make, mount="wall", **more)


def _small(name: str, size: Vec3, mass: float, make: Generator, **more: Any) -> Category:
    return _row(name, size, mass, make, **{"mount": "surface", "variation": 0.08} | more)


_BEDS = (
    _large("bed", (2.08, 1.50, 0.95), 70, beds.bed, clearance=0.6, friction=0.6, low=0.75, high=1.3, variants={
        "single": (2.06, 0.98, 0.92), "twin": (2.06, 0.98, 0.92), "small-double": (2.06, 1.28, 0.95), "double": (2.08, 1.48, 0.95),
        "queen": (2.12, 1.64, 1.0), "queen-size": (2.12, 1.64, 1.0), "king": (2.14, 1.90, 1.05), "king-size": (2.14, 1.90, 1.05),
        "super-king": (2.14, 2.06, 1.05), "child": (1.68, 0.82, 0.75)}),
    _large("bunk_bed", (2.08, 1.02, 1.68), 75, beds.bunk_bed, clearance=0.7, friction=0.6, low=0.8, high=1.25, noun="bunk bed"),
    _large("crib", (1.28, 0.70, 0.95), 22, beds.crib, clearance=0.6, low=0.75, high=1.3),
    _large("hospital_bed", (2.15, 0.98, 1.02), 110, beds.hospital_bed, clearance=0.8, friction=0.7, low=0.85, high=1.2),
    _row("nightstand", (0.42, 0.46, 0.55), 14, storage.nightstand, clearance=0.3),
    _large("massage_table", (2.0, 0.7, 0.75), 22, bathroom.massage_table, clearance=0.6, front="one", low=0.8, high=1.3),
)  # fmt: skip

_STORAGE = (
    _large("wardrobe", (0.60, 1.20, 2.05), 65, storage.wardrobe, clearance=0.75, variants={
        "single": (0.58, 0.62, 1.98), "double": (0.60, 1.10, 2.05), "two-door": (0.60, 1.0, 2.0), "three-door": (0.60, 1.5, 2.1), "four-door": (0.60, 2.0, 2.15)}),
    _large("dresser", (0.48, 1.20, 0.82), 45, storage.dresser, clearance=0.75, noun="chest of drawers"),
    _large("bookcase", (0.32, 0.90, 1.95), 30, storage.bookcase, clearance=0.6, high=2.5, variants={"low": (0.32, 1.1, 0.82), "tall": (0.34, 0.9, 2.2)}),
    _large("shelving_unit", (0.42, 1.00, 1.80), 24, storage.shelving_unit, clearance=0.6, noun="shelf unit", variants={"low": (0.42, 1.0, 0.95)}),
    _wall("wall_shelf", (0.24, 0.90, 0.20), 5, storage.wall_shelf, high=4.0, noun="wall shelf", variants={"tall": (0.24, 0.8, 0.75)}),
    _row("shoe_rack", (0.32, 0.80, 0.52), 8, storage.shoe_rack, clearance=0.5),
    _row("coat_rack", (0.50, 0.50, 1.78), 8, panels.coat_rack, front="any", noun="coat stand"),
    _wall("coat_hooks", (0.07, 0.70, 0.12), 1.5, panels.hooks),
    _large("cabinet", (0.42, 0.90, 0.95), 32, storage.cupboard, clearance=0.75, high=2.3, variants={"tall": (0.44, 0.9, 1.9), "low": (0.42, 1.0, 0.7)}),
    _row("bedside_cabinet", (0.46, 0.48, 0.78), 16, storage.cupboard, clearance=0.4, noun="bedside cabinet"),
    _large("sideboard", (0.45, 1.60, 0.80), 45, storage.sideboard, clearance=0.75),
    _large("credenza", (0.45, 1.60, 0.74), 45, storage.credenza, clearance=0.75),
    _large("china_cabinet", (0.42, 1.05, 1.95), 60, storage.china_cabinet, clearance=0.75),
    _large("filing_cabinet", (0.60, 0.46, 1.02), 38, storage.filing_cabinet, clearance=0.75, variants={"low": (0.60, 0.46, 0.70), "tall": (0.62, 0.46, 1.32)}),
    _large("locker", (0.50, 0.96, 1.85), 50, storage.locker, clearance=0.7),
    _large("tool_cabinet", (0.46, 0.70, 0.95), 45, storage.tool_cabinet, clearance=0.75),
    _large("server_rack", (1.00, 0.60, 1.95), 140, storage.server_rack, clearance=1.0, friction=0.6),
    _row("safe", (0.45, 0.45, 0.60), 80, storage.safe, clearance=0.6, friction=0.6),
    _row("toy_box", (0.45, 0.80, 0.46), 11, storage.toy_box, clearance=0.5, noun="toy box"),
    _large("tv_stand", (0.42, 1.60, 0.50), 28, storage.tv_stand, clearance=0.6, noun="TV stand"),
    _large("clothes_rack", (0.50, 1.40, 1.60), 22, shop.clothes_rack, front="two", clearance=0.6),
)  # fmt: skip

_TABLES = (
    _large("dining_table", (0.90, 1.70, 0.75), 34, tables.table, front="two", seats=6, clearance=0.75, high=2.6, variants={
        "long": (0.95, 2.10, 0.75), "small": (0.75, 0.90, 0.75)}),
    _large("kitchen_table", (0.80, 1.20, 0.75), 23, tables.table, front="two", seats=4, clearance=0.75),
    _large("table", (0.80, 1.30, 0.75), 24, tables.table, front="two", seats=4, clearance=0.7, high=2.6, variants={"low": (0.6, 1.0, 0.45), "square": (0.82, 0.82, 0.75)}),
    _large("square_table", (0.80, 0.80, 0.75), 19, tables.table, front="two", seats=4, clearance=0.7),
    _large("coffee_table", (0.60, 1.10, 0.42), 15, tables.coffee_table, front="two", clearance=0.35, variants={"round": (0.80, 0.80, 0.42), "low": (0.6, 1.1, 0.36)}),
    _row("side_table", (0.45, 0.45, 0.55), 7, tables.side_table, front="two", noun="side table"),
    _large("high_table", (0.70, 0.70, 1.08), 20, tables.high_table, front="two", seats=2, clearance=0.6, low=0.7, variants={"long": (0.7, 1.6, 1.08)}),
    _large("console_table", (0.36, 1.20, 0.80), 18, tables.console_table),
    _large("conference_table", (1.20, 2.80, 0.75), 85, tables.conference_table, front="two", seats=8, clearance=0.9, variants={"small": (1.1, 2.0, 0.75)}),
    _large("play_table", (0.60, 0.80, 0.50), 9, tables.table, front="two", seats=0, clearance=0.4, high=1.5),
    _large("display_table", (1.00, 1.60, 0.82), 40, tables.display_table, front="two", clearance=0.9),
    _large("tiered_table", (0.96, 1.50, 0.92), 34, tables.tiered_table, clearance=0.9, noun="tiered table"),
    _large("folding_table", (0.74, 1.80, 0.74), 13, tables.folding_table, front="two", clearance=0.6),
    _large("workbench", (0.68, 1.60, 0.88), 70, tables.workbench, clearance=0.8, friction=0.6),
    _large("desk", (0.68, 1.30, 0.75), 26, desks.desk, clearance=0.9, low=0.6, variants={"small": (0.58, 1.0, 0.75), "long": (0.7, 1.7, 0.75)}),
    _large("corner_desk", (1.50, 1.60, 0.75), 42, desks.corner_desk, clearance=0.6, low=0.75, high=1.5, noun="corner desk"),
    _large("school_desk", (0.50, 0.70, 0.74), 13, desks.school_desk, clearance=0.7, low=0.7, high=1.8),
    _large("teacher_desk", (0.72, 1.40, 0.75), 36, desks.teacher_desk, clearance=0.9, noun="teacher's desk", low=0.7),
    _large("dressing_table", (0.46, 1.00, 1.38), 34, desks.dressing_table, clearance=0.75, low=0.7),
    _large("reception_desk", (0.85, 2.00, 1.12), 75, desks.reception_desk, clearance=1.2, low=0.7),
    _large("counter", (0.62, 1.80, 0.95), 70, shop.counter, clearance=1.0, high=3.0, noun="counter", variants={"long": (0.7, 3.2, 0.92), "buffet": (0.75, 3.0, 0.9), "small": (0.6, 1.2, 0.95)}),
    _large("bar_counter", (0.60, 2.40, 1.10), 90, shop.bar_counter, clearance=0.9, noun="bar"),
    _large("podium", (0.50, 0.62, 1.18), 24, shop.podium, clearance=0.5, noun="lectern"),
    _large("easel", (0.65, 0.62, 1.70), 6, desks.easel, clearance=0.7),
)  # fmt: skip

_SEATS = (
    _row("chair", (0.52, 0.46, 0.84), 6.5, seats.chair, clearance=0.5, low=0.65, high=1.5, variants={"school": (0.50, 0.43, 0.80)}),
    _row("office_chair", (0.64, 0.64, 1.02), 13, seats.office_chair, clearance=0.5, friction=0.4, low=0.75, high=1.35),
    _large("armchair", (0.82, 0.80, 0.82), 26, upholstery.armchair, clearance=0.5, low=0.7, high=1.5),
    _large("rocking_chair", (0.98, 0.64, 0.98), 14, upholstery.rocking_chair, clearance=0.5, low=0.75, high=1.4),
    _large("sofa", (0.92, 2.10, 0.82), 46, upholstery.sofa, clearance=0.5, low=0.65, high=1.5, seats=3, variants={
        "two-seat": (0.90, 1.62, 0.82), "two-seater": (0.90, 1.62, 0.82), "loveseat": (0.90, 1.55, 0.82), "three-seat": (0.92, 2.15, 0.82), "three-seater": (0.92, 2.15, 0.82),
        "four-seat": (0.95, 2.75, 0.82), "four-seater": (0.95, 2.75, 0.82), "corner": (1.65, 2.60, 0.82), "corner-sofa": (1.65, 2.60, 0.82), "l-shaped": (1.65, 2.60, 0.82), "sectional": (1.65, 2.60, 0.82), "small": (0.85, 1.5, 0.80)}),
    _large("bench", (0.42, 1.20, 0.46), 15, seats.bench, front="two", seats=2, clearance=0.4, high=2.2, variants={"park": (0.58, 1.5, 0.85), "backed": (0.56, 1.4, 0.85)}),
    _large("pew", (0.52, 2.00, 0.92), 40, seats.pew, seats=4, clearance=0.5),
    _row("stool", (0.38, 0.38, 0.46), 4, seats.stool, front="any", low=0.6, high=1.8),
    _row("bar_stool", (0.40, 0.40, 0.74), 7, seats.bar_stool, front="one", clearance=0.3, low=0.7, high=1.4, noun="bar stool"),
    _row("ottoman", (0.55, 0.55, 0.42), 9, upholstery.ottoman, front="two"),
    _row("bean_bag", (0.85, 0.85, 0.72), 6, upholstery.bean_bag, friction=0.8),
    _row("child_chair", (0.33, 0.32, 0.56), 2.6, seats.child_chair, clearance=0.3, low=0.7, high=1.5, noun="child's chair"),
    _large("dentist_chair", (1.65, 0.76, 1.75), 150, shop.dentist_chair, clearance=0.6, friction=0.7, low=0.8, high=1.3),
)  # fmt: skip

_APPLIANCES = (
    _large("fridge", (0.68, 0.60, 1.80), 65, appliances.fridge, clearance=0.9, low=0.75, high=1.35, variants={"small": (0.58, 0.55, 0.85), "mini": (0.52, 0.48, 0.55), "double": (0.75, 0.91, 1.8)}),
    _large("display_fridge", (0.80, 1.50, 1.25), 120, appliances.display_fridge, clearance=0.9, low=0.7, high=1.6, variants={"tall": (0.65, 0.70, 1.95), "upright": (0.65, 0.70, 1.95)}),
    _large("vending_machine", (0.80, 0.95, 1.83), 230, appliances.vending_machine, clearance=0.9, low=0.8, high=1.25),
    _large("base_cabinet", (0.62, 0.60, 0.90), 28, storage.base_cabinet, clearance=0.9, high=6.0, low=0.6, variation=0.0, noun="kitchen cabinet", variants={"double": (0.62, 1.2, 0.9), "long": (0.62, 1.8, 0.9)}),
    _wall("wall_cabinet", (0.35, 0.80, 0.70), 18, storage.wall_cabinet, high=3.0, noun="wall cabinet"),
    _large("kitchen_island", (0.95, 1.60, 0.92), 80, storage.kitchen_island, clearance=0.9, low=0.7, noun="kitchen island", variants={"long": (0.95, 2.2, 0.92)}),
    _large("stove", (0.62, 0.60, 0.90), 48, appliances.stove, clearance=0.9, low=0.8, high=1.5, variation=0.0),
    _row("oven", (0.56, 0.595, 0.60), 32, appliances.oven, clearance=0.9, low=0.8, high=1.3, variation=0.0),
    _large("dishwasher", (0.60, 0.60, 0.84), 42, appliances.dishwasher, clearance=0.9, low=0.75, high=1.3, variation=0.0),
    _large("washing_machine", (0.60, 0.60, 0.85), 68, appliances.washing_machine, clearance=0.9, friction=0.6, low=0.75, high=1.3, variation=0.0),
    _large("dryer", (0.60, 0.60, 0.85), 42, appliances.washing_machine, clearance=0.9, friction=0.6, low=0.75, high=1.3, variation=0.0),
    _large("water_dispenser", (0.33, 0.32, 1.25), 17, appliances.water_dispenser, clearance=0.6, low=0.75, high=1.4),
    _small("sink", (0.48, 0.60, 0.46), 6, appliances.sink),
    _small("hob", (0.50, 0.58, 0.05), 8, appliances.hob),
    _small("microwave", (0.40, 0.50, 0.30), 13, appliances.microwave, low=0.7, high=1.5, clearance=0.4),
    _small("kettle", (0.22, 0.15, 0.24), 1.1, appliances.kettle),
    _small("toaster", (0.32, 0.18, 0.19), 1.6, appliances.toaster),
    _small("coffee_machine", (0.36, 0.28, 0.36), 7.5, appliances.coffee_machine),
)  # fmt: skip

_ELECTRONICS = (
    _small("tv", (0.24, 1.23, 0.77), 17, electronics.tv, noun="TV", variants={"large": (0.28, 1.45, 0.9), "small": (0.2, 0.73, 0.49)}),
    _wall("wall_tv", (0.06, 1.23, 0.71), 16, electronics.tv, noun="wall TV"),
    _small("monitor", (0.20, 0.58, 0.44), 5, electronics.monitor),
    _small("laptop", (0.34, 0.33, 0.22), 1.6, electronics.laptop),
    _small("computer", (0.42, 0.20, 0.44), 8, electronics.computer),
    _small("keyboard", (0.14, 0.44, 0.025), 0.7, electronics.keyboard, friction=0.8),
    _small("mouse", (0.115, 0.064, 0.036), 0.1, electronics.mouse, friction=0.8),
    _small("printer", (0.45, 0.44, 0.30), 9, electronics.printer),
    _small("tablet", (0.18, 0.25, 0.008), 0.5, electronics.slab),
    _small("phone", (0.15, 0.072, 0.008), 0.19, electronics.slab),
    _small("telephone", (0.20, 0.20, 0.09), 0.9, small.telephone),
    _small("speaker", (0.24, 0.20, 0.34), 5, electronics.speaker, high=4.0, variants={"tall": (0.3, 0.24, 1.0)}),
    _small("games_console", (0.26, 0.32, 0.07), 3, electronics.games_console),
    _small("cash_register", (0.42, 0.40, 0.34), 9, electronics.cash_register),
    _small("scale", (0.32, 0.34, 0.26), 4, electronics.scale),
    _row("microphone_stand", (0.30, 0.30, 1.50), 4, electronics.microphone_stand),
    _row("fan", (0.40, 0.44, 1.25), 5, small.fan),
    _row("robot_vacuum", (0.34, 0.34, 0.10), 3.5, small.vacuum_robot, front="any"),
)  # fmt: skip

_LAMPS = (
    _row("floor_lamp", (0.42, 0.42, 1.58), 6, lamps.floor_lamp, front="any", noun="floor lamp"),
    _small("table_lamp", (0.28, 0.28, 0.46), 2.2, lamps.table_lamp, front="any", noun="table lamp"),
    _small("desk_lamp", (0.40, 0.18, 0.45), 1.8, lamps.desk_lamp, noun="desk lamp"),
    _row("pendant_lamp", (0.42, 0.42, 0.95), 2.5, lamps.pendant_lamp, mount="ceiling", front="any", high=2.5, noun="pendant lamp"),
    _row("ceiling_lamp", (0.45, 0.45, 0.12), 2.5, lamps.ceiling_lamp, mount="ceiling", front="any", noun="ceiling lamp"),
    _row("chandelier", (0.70, 0.70, 0.80), 8, lamps.chandelier, mount="ceiling", front="any"),
    _wall("wall_lamp", (0.26, 0.18, 0.28), 1.5, lamps.wall_lamp, noun="wall lamp"),
    _small("candle", (0.10, 0.10, 0.16), 0.4, lamps.candle, front="any"),
)  # fmt: skip

_PLANTS = (
    _row("plant", (0.70, 0.70, 1.40), 12, plants.plant, front="any", low=0.4, variants={"small": (0.45, 0.45, 0.7), "tall": (0.75, 0.75, 1.6)}),
    _small("potted_plant", (0.24, 0.24, 0.32), 1.6, plants.potted_plant, front="any", high=2.5, noun="potted plant"),
    _row("flower_bucket", (0.42, 0.42, 0.62), 4.5, plants.flower_bucket, front="any", noun="bucket of flowers"),
    _row("planter", (0.36, 1.00, 0.72), 26, shop.planter, front="two"),
    _small("vase", (0.16, 0.16, 0.30), 1.2, vessels.vase, front="any"),
)  # fmt: skip

_SMALL = (
    _small("bowl", (0.18, 0.18, 0.08), 0.45, vessels.bowl, front="any"),
    _small("fruit_bowl", (0.30, 0.30, 0.18), 1.6, vessels.fruit_bowl, front="any", noun="bowl of fruit"),
    _small("plate", (0.26, 0.26, 0.025), 0.55, vessels.plate, front="any"),
    _small("cup", (0.085, 0.12, 0.095), 0.33, vessels.cup),
    _small("glass", (0.07, 0.07, 0.12), 0.25, vessels.glass, front="any"),
    _small("teapot", (0.24, 0.15, 0.15), 0.8, vessels.teapot),
    _small("bottle", (0.078, 0.078, 0.30), 1.2, vessels.bottle, front="any"),
    _small("jar", (0.095, 0.095, 0.14), 0.7, vessels.jar, front="any"),
    _small("food_tray", (0.40, 0.32, 0.08), 3.0, small.food_tray),
    _small("tray", (0.30, 0.42, 0.045), 0.9, small.tray, front="two"),
    _small("cutlery", (0.22, 0.14, 0.012), 0.15, small.cutlery),
    _small("book", (0.22, 0.15, 0.03), 0.5, small.book),
    _small("book_stack", (0.24, 0.18, 0.16), 2.6, small.book_stack, noun="stack of books"),
    _small("magazine", (0.29, 0.22, 0.02), 0.5, small.magazine, noun="magazines"),
    _small("notebook", (0.21, 0.15, 0.014), 0.3, small.book),
    _small("paper", (0.297, 0.21, 0.02), 0.6, small.paper_stack, noun="stack of paper"),
    _small("pen_holder", (0.09, 0.09, 0.18), 0.3, vessels.pen_holder, front="any"),
    _small("globe", (0.30, 0.30, 0.40), 1.8, vessels.globe),
    _small("toy", (0.22, 0.22, 0.26), 0.5, small.toy),
    _small("box", (0.36, 0.46, 0.32), 4, vessels.box_of_card, front="two", high=2.5),
    _small("basket", (0.34, 0.34, 0.26), 1.2, vessels.basket, front="any"),
    _small("photo_frame", (0.11, 0.16, 0.21), 0.4, small.photo_frame, noun="photo frame"),
    _small("alarm_clock", (0.06, 0.12, 0.14), 0.35, small.alarm_clock),
    _small("trophy", (0.14, 0.14, 0.30), 1.4, vessels.trophy, front="any"),
    _small("aquarium", (0.35, 0.80, 0.48), 65, small.aquarium),
    _small("pillow", (0.42, 0.42, 0.13), 0.6, small.pillow, front="two", friction=0.8),
    _small("blanket", (0.32, 0.42, 0.09), 1.2, small.blanket, friction=0.8),
    _small("towels", (0.30, 0.40, 0.22), 1.6, bathroom.towel_stack, friction=0.8),
    _small("soap_dispenser", (0.10, 0.07, 0.18), 0.4, bathroom.soap_dispenser),
    _row("waste_bin", (0.28, 0.28, 0.36), 1.5, vessels.waste_bin, front="any", noun="waste bin"),
    _row("laundry_basket", (0.44, 0.44, 0.58), 3.0, vessels.basket, front="any", noun="laundry basket"),
    _row("umbrella_stand", (0.24, 0.24, 0.80), 4, vessels.umbrella_stand, front="any"),
    _row("ironing_board", (0.40, 1.30, 0.90), 6, small.ironing_board, front="one", clearance=0.6),
    _row("drying_rack", (0.60, 1.20, 1.05), 4.5, small.drying_rack, front="two"),
    _row("ladder", (0.82, 0.50, 1.30), 7, small.ladder),
)  # fmt: skip

_BATHROOM = (
    _large("bathtub", (0.76, 1.70, 0.64), 75, bathroom.bathtub, clearance=0.7, low=0.75, high=1.3, friction=0.7),
    _large("toilet", (0.68, 0.38, 0.80), 32, bathroom.toilet, clearance=0.6, low=0.8, high=1.25, friction=0.7),
    _large("washbasin", (0.48, 0.65, 0.98), 34, bathroom.washbasin, clearance=0.7, low=0.7, high=1.8),
    _large("shower_cabin", (0.90, 0.90, 2.05), 85, bathroom.shower_cabin, clearance=0.7, friction=0.7, low=0.8, high=1.5),
    _wall("towel_rail", (0.11, 0.60, 0.58), 1.8, panels.towel_rail),
    _wall("toilet_paper", (0.14, 0.13, 0.12), 0.4, bathroom.toilet_paper),
)  # fmt: skip

_WALLS = (
    _wall("whiteboard", (0.08, 1.80, 1.20), 16, panels.whiteboard, high=2.5),
    _wall("blackboard", (0.09, 2.40, 1.20), 30, panels.whiteboard, high=2.0),
    _wall("projector_screen", (0.09, 2.00, 1.35), 10, panels.screen, high=1.8, noun="projection screen"),
    _wall("menu_board", (0.04, 1.20, 0.80), 8, panels.menu_board),
    _wall("picture", (0.03, 0.80, 0.60), 3, panels.picture, low=0.3, variants={"large": (0.03, 1.2, 0.85), "small": (0.025, 0.4, 0.5), "tall": (0.03, 0.6, 0.85)}),
    _wall("poster", (0.015, 0.50, 0.70), 0.8, panels.picture, low=0.4),
    _wall("mirror", (0.03, 0.70, 0.90), 8, panels.mirror, variants={"round": (0.03, 0.75, 0.75), "oval": (0.03, 0.55, 0.85), "tall": (0.03, 0.5, 1.4)}),
    _wall("clock", (0.05, 0.32, 0.32), 0.9, panels.clock),
    _wall("dart_board", (0.05, 0.46, 0.46), 4.5, panels.dart_board, noun="dart board"),
    _wall("curtain", (0.12, 1.80, 2.30), 4, panels.curtain, high=2.2, noun="pair of curtains"),
    _wall("curtain_rail", (0.60, 2.00, 2.05), 6, panels.curtain_rail, high=1.8, noun="privacy curtain"),
    _wall("radiator", (0.12, 1.00, 0.60), 22, panels.radiator),
    _large("fireplace", (0.42, 1.40, 1.12), 150, shop.fireplace, clearance=0.9, friction=0.8),
    _large("room_divider", (0.40, 1.50, 1.75), 14, panels.room_divider, front="two"),
    _row("standing_mirror", (0.48, 0.55, 1.70), 11, panels.standing_mirror, clearance=0.6, noun="standing mirror"),
)  # fmt: skip

_GAMES = (
    _large("pool_table", (1.40, 2.50, 0.82), 220, games.pool_table, front="two", clearance=1.2, low=0.7, high=1.3, friction=0.7),
    _large("table_football", (1.10, 1.42, 0.90), 62, games.table_football, front="two", clearance=0.8, low=0.7, high=1.3),
    _large("table_tennis", (1.55, 2.74, 0.915), 75, games.table_tennis, front="two", clearance=1.2, low=0.7, high=1.2, noun="table-tennis table"),
    _large("arcade_cabinet", (0.85, 0.66, 1.75), 95, games.arcade_cabinet, clearance=0.8, low=0.75, high=1.3),
    _large("piano", (0.62, 1.48, 1.20), 210, games.piano, clearance=0.9, friction=0.7, low=0.8, high=1.3),
    _row("guitar", (0.46, 0.40, 1.08), 4, games.guitar),
    _large("drum_kit", (0.95, 1.60, 1.15), 40, games.drum_kit, clearance=0.7, low=0.8, high=1.3),
    _large("treadmill", (1.75, 0.82, 1.40), 90, games.treadmill, clearance=0.8, friction=0.7, low=0.8, high=1.3),
    _large("exercise_bike", (1.00, 0.54, 1.25), 35, games.exercise_bike, clearance=0.6, friction=0.7, low=0.8, high=1.3),
    _large("weight_bench", (1.35, 1.50, 1.15), 60, seats.weight_bench, clearance=0.6, friction=0.7, low=0.75, high=1.3),
    _row("dumbbell_rack", (0.52, 1.20, 0.80), 90, games.dumbbells, clearance=0.7, friction=0.7, noun="dumbbell rack"),
    _large("bicycle", (1.75, 0.58, 1.05), 14, games.bicycle, low=0.6, high=1.2),
)  # fmt: skip

_TEXTILES = (
    _row("rug", (1.60, 2.30, 0.008), 9, textiles.rug, front="two", flat=True, high=3.0, low=0.3, variants={
        "round": (1.7, 1.7, 0.008), "large": (2.0, 2.9, 0.008), "small": (0.9, 1.4, 0.008)}),
    _row("bath_mat", (0.50, 0.80, 0.008), 1.0, textiles.mat, front="two", flat=True),
    _row("door_mat", (0.45, 0.75, 0.008), 1.5, textiles.mat, front="two", flat=True),
    _row("yoga_mat", (0.62, 1.80, 0.006), 1.2, textiles.mat, front="two", flat=True),
)  # fmt: skip


def _by_name(rows: Iterable[Category]) -> Mapping[str, Category]:
    return MappingProxyType({row.name: row for row in rows})


CATALOGUE: Mapping[str, Category] = _by_name(
    (
        *_BEDS,
        *_STORAGE,
        *_TABLES,
        *_SEATS,
        *_APPLIANCES,
        *_ELECTRONICS,
        *_LAMPS,
        *_PLANTS,
        *_SMALL,
        *_BATHROOM,
        *_WALLS,
        *_GAMES,
        *_TEXTILES,
    )
)
"""Every category by name."""
