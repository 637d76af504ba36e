"""What 12 instructions ask of a room, chosen and checked by plain geometry that shares nothing with the editor.

Scenes are read here as the JSON that is saved. Angles in degrees, lengths in metres.
"""

import json
import math
from collections import Counter
from collections.abc import Callable, Iterator, Set
from dataclasses import dataclass
from functools import partial
from typing import Any

from shapely import MultiPolygon, Point, Polygon
from shapely.affinity import rotate, translate
from shapely.geometry import box
from shapely.geometry.base import BaseGeometry

Placed = dict[str, Any]
Check = Callable[["Plain", "Plain"], bool]


class Plain:
    """A scene.json as plain values."""

    def __init__(self, data: bytes) -> None:
        whole = json.loads(data)
        self.room = whole["room"]
        self.assets = whole["assets"]
        self.placements: dict[str, Placed] = {p["id"]: p for p in whole["placements"]}

    def __getitem__(self, id: str) -> Placed:
        return self.placements[id]

    def outline(self, id: str) -> Polygon:
        """The footprint."""
        p = self[id]
        flat = box(-p["size"][0] / 2, -p["size"][1] / 2, p["size"][0] / 2, p["size"][1] / 2)
        return translate(rotate(flat, p["yaw"], origin=(0, 0)), *p["position"][:2])

    def gap(self, one: str, other: str) -> float:
        """Distance between footprints."""
        return float(self.outline(one).distance(self.outline(other)))

    def local(self, anchor: str, id: str) -> tuple[float, float]:
        """Where the middle of one is in the frame of another: forward, left."""
        (ax, ay, _), (x, y, _) = self[anchor]["position"], self[id]["position"]
        turn = math.radians(self[anchor]["yaw"])
        dx, dy = x - ax, y - ay
        return dx * math.cos(turn) + dy * math.sin(turn), dy * math.cos(turn) - dx * math.sin(turn)

    def on_top(self, id: str, of: str) -> bool:
        """Whether it stands over another, its base between that one's base and top and on a surface of it."""
        base, low = self[id]["position"][2], self[of]["position"][2]
        heights = [low + s["position"][2] for s in self.assets[self[of]["asset"]].get("surfaces", [])]
        over = bool(self.outline(of).buffer(0.01).contains(Point(*self[id]["position"][:2])))
        return over and any(abs(base - h) < 0.015 for h in heights)

    def riders(self, id: str) -> set[str]:
        """All that rests on it."""
        found = {p["id"] for p in self.placements.values() if p["support"] == id}
        return found | {r for f in found for r in self.riders(f)}

    def walls(self) -> list[tuple[tuple[float, float], tuple[float, float]]]:
        """Start and end of each."""
        floor = [tuple(c) for c in self.room["floor"]]
        return list(zip(floor, floor[1:] + floor[:1], strict=True))

    def standing(self) -> list[Placed]:
        """What stands on the floor and is no rug."""
        return [p for p in self.placements.values() if p["support"] == "floor" and p["size"][2] > 0.1]

    def windows(self) -> Iterator[tuple[Polygon, float, float]]:
        """The floor half a metre before each window, its sill and the yaw into the room."""
        for o in self.room["openings"]:
            if o["kind"] == "window":
                (x0, y0), (x1, y1) = self.walls()[o["wall"]]
                length = math.dist((x0, y0), (x1, y1))
                ax, ay = (x1 - x0) / length, (y1 - y0) / length
                a = (x0 + ax * o["offset"], y0 + ay * o["offset"])
                b = (a[0] + ax * o["width"], a[1] + ay * o["width"])
                zone = Polygon([a, b, (b[0] - ay * 0.5, b[1] + ax * 0.5), (a[0] - ay * 0.5, a[1] + ax * 0.5)])
                yield zone, o["sill"], math.degrees(math.atan2(ax, -ay)) % 360.0

    def unique(self) -> list[Placed]:
        """What is the only one of its kind, the largest first."""
        counts = Counter(p["category"] for p in self.placements.values())
        last = Counter(p["category"].rpartition("_")[2] for p in self.placements.values())
        alone = [
            p for p in self.standing() if counts[p["category"]] == 1 and last[p["category"].rpartition("_")[2]] == 1
        ]
        return sorted(alone, key=lambda p: -p["size"][0] * p["size"][1])

    def free(self, area: BaseGeometry, besides: Set[str] = frozenset()) -> bool:
        """Whether nothing on the floor reaches into an area, and it is in the room."""
        inside = Polygon(self.room["floor"]).buffer(0.005).contains(area)
        return inside and all(
            self.outline(p["id"]).intersection(area).area < 1e-4 for p in self.standing() if p["id"] not in besides
        )


@dataclass(frozen=True)
class Case:
    """An instruction for one room, which objects it lets change, and how the result is told."""

    kind: str
    text: str
    may_change: frozenset[str]
    check: Check


def _is_put(id: str, to: str, off: str, before: Plain, after: Plain) -> bool:
    return after.on_top(id, to) and not after.on_top(id, off)


def _is_turned(id: str, before: Plain, after: Plain) -> bool:
    return abs(turn(after[id]["yaw"], before[id]["yaw"]) - 90.0) < 3.0


def _is_closer(one: str, other: str, before: Plain, after: Plain) -> bool:
    return after.gap(one, other) < before.gap(one, other) - 0.015


def words(category: str) -> str:
    """A category as one says it."""
    return category.replace("_", " ")


def cases(room: Plain) -> list[Case]:
    """The instructions of shared/prompts/edits.txt and their kind, with what this room has."""
    made = (add, move, replace, remove, put, swap, rotate_by, closer, centre, corner, more, longer)
    return [case for maker in made if (case := maker(room)) is not None]


def turn(a: float, b: float) -> float:
    """Angle between two yaws."""
    return abs((a - b + 180.0) % 360.0 - 180.0)


def mine(room: Plain, *ids: str) -> frozenset[str]:
    """Objects and all that rests on them."""
    return frozenset(ids).union(*(room.riders(id) for id in ids))


def fronted(room: Plain, p: Placed) -> bool:
    """Whether it has one front."""
    return bool(room.assets[p["asset"]].get("front", "one") == "one")


def beside(room: Plain, id: str, side: float, depth: float) -> Polygon:
    """A square of floor to the left (1) or right (-1) of a thing."""
    p = room[id]
    x, y = -0.2, side * (p["size"][1] / 2 + depth / 2 + 0.02)
    flat = box(x - depth / 2, y - depth / 2, x + depth / 2, y + depth / 2)
    return translate(rotate(flat, p["yaw"], origin=(0, 0)), *p["position"][:2])


def add(room: Plain) -> Case | None:
    for p in room.unique():
        for side, name in ((1.0, "left"), (-1.0, "right")):
            if fronted(room, p) and p["size"][2] < 1.3 and room.free(beside(room, p["id"], side, 0.5)):
                id, old = p["id"], set(room.placements)

                def check(before: Plain, after: Plain, id: str = id, side: float = side, old: set[str] = old) -> bool:
                    new = [q for q in after.placements if q not in old]
                    if len(new) != 1 or after[new[0]]["category"] != "floor_lamp":
                        return False
                    forward, left = after.local(id, new[0])
                    beyond = side * left - after[id]["size"][1] / 2
                    return (
                        beyond > 0
                        and abs(forward) < after[id]["size"][0] / 2 + beyond + 0.05
                        and after.gap(id, new[0]) <= 1.5
                    )

                return Case("add", f"Add a floor lamp to the {name} of the {words(p['category'])}.", frozenset(), check)
    return None


def move(room: Plain) -> Case | None:
    for p in sorted(room.unique(), key=lambda p: p["category"] != "desk"):
        low = [z for z, sill, _ in room.windows() if p["size"][2] < sill]
        if not (0.6 < p["size"][1] < 2.2) or not fronted(room, p):
            continue
        apart = {p["id"]} | room.riders(p["id"])
        if not any(_fits_at(room, zone, p, apart) for zone in low):
            continue
        id = p["id"]

        def check(before: Plain, after: Plain, id: str = id) -> bool:
            outline = after.outline(id)
            for zone, sill, inward in after.windows():
                near = zone.intersection(outline).area > 0.1 * min(zone.area, outline.area)
                if near and after[id]["size"][2] < sill + 0.01 and turn(after[id]["yaw"], inward) <= 45.0:
                    return True
            return False

        text = f"Move the {words(p['category'])} under the window and turn it to face the room."
        return Case("move", text, mine(room, id), check)
    return None


def _fits_at(room: Plain, zone: Polygon, p: Placed, besides: set[str]) -> bool:
    """Whether the thing fits before a window with its back to it, and half a metre before it is free."""
    (x0, y0), (x1, y1) = list(zone.exterior.coords)[:2]
    length = math.dist((x0, y0), (x1, y1))
    ax, ay = (x1 - x0) / length, (y1 - y0) / length
    depth, half = p["size"][0], p["size"][1] / 2
    for share in (0.5, 0.3, 0.7):
        x, y = x0 + ax * length * share, y0 + ay * length * share
        near, far = 0.02, depth + 0.5
        corners = [(-half, near), (half, near), (half, far), (-half, far)]
        if room.free(Polygon([(x + ax * a - ay * b, y + ay * a + ax * b) for a, b in corners]), besides):
            return True
    return False


SUCCESSORS = {"armchair": "rocking chair", "floor_lamp": "potted plant", "sofa": "loveseat", "wardrobe": "bookcase",
              "coffee_table": "side table", "bookcase": "wardrobe", "office_chair": "stool", "tv_stand": "sideboard",
              "sideboard": "bookcase", "plant": "floor lamp", "bench": "stool", "dresser": "desk",
              "desk": "dresser"}  # fmt: skip


def replace(room: Plain) -> Case | None:
    for p in sorted(room.unique(), key=lambda p: p["category"] != "armchair"):
        if p["category"] in SUCCESSORS and not room.riders(p["id"]):
            id, new = p["id"], SUCCESSORS[p["category"]].replace(" ", "_")
            accepted = {new, "sofa"} if new == "loveseat" else {new, "plant"} if new == "potted_plant" else {new}

            def check(before: Plain, after: Plain, id: str = id, accepted: set[str] = accepted) -> bool:
                there = [
                    q
                    for q in after.placements.values()
                    if q["category"] in accepted and q["asset"] not in before.assets
                ]
                old = before[id]["position"]
                return any(math.dist(q["position"][:2], old[:2]) < 1.2 for q in there) and all(
                    q["asset"] != before[id]["asset"] for q in after.placements.values()
                )

            text = f"Replace the {words(p['category'])} with a {words(new)}."
            return Case("replace", text, frozenset([id]), check)
    return None


def remove(room: Plain) -> Case | None:
    rugs = [p for p in room.placements.values() if p["category"] == "rug"]
    found = rugs if len(rugs) == 1 else [p for p in room.unique() if not room.riders(p["id"])][-1:]
    if not found:
        return None
    id = found[0]["id"]
    text = f"Remove the {words(found[0]['category'])}."
    return Case("remove", text, frozenset([id]), lambda before, after: id not in after.placements)


def put(room: Plain) -> Case | None:
    counts = Counter(p["category"].rpartition("_")[2] for p in room.placements.values())
    carried = [p for p in room.placements.values() if p["support"] in room.placements and not room.riders(p["id"])]
    small = [p for p in carried if counts[p["category"].rpartition("_")[2]] == 1]
    for p in sorted(small, key=lambda p: p["size"][0] * p["size"][1]):
        old = room[p["support"]]
        for q in room.unique():
            surfaces = room.assets[q["asset"]].get("surfaces", [])
            fits = any(
                min(s["size"]) > max(p["size"][:2]) + 0.1 and s.get("headroom") is None and 0.3 < s["position"][2] < 1.1
                for s in surfaces
            )
            seat = any(w in q["category"] for w in ("chair", "sofa", "bed", "bench", "stool"))
            apart = old["category"].rpartition("_")[2] != q["category"].rpartition("_")[2]
            if fits and not seat and apart and q["id"] != old["id"] and not room.riders(q["id"]):
                names = [words(thing["category"]) for thing in (p, q, old)]
                text = f"Put the {names[0]} on the {names[1]}, not on the {names[2]}."
                id, to, off = p["id"], q["id"], old["id"]
                return Case("put", text, frozenset([id]), partial(_is_put, id, to, off))
    return None


def swap(room: Plain) -> Case | None:
    alone = room.unique()
    pairs = [(a, b) for n, a in enumerate(alone) for b in alone[n + 1 :]]
    pairs.sort(key=lambda ab: abs(ab[0]["size"][0] - ab[1]["size"][0]) + abs(ab[0]["size"][1] - ab[1]["size"][1]))
    for a, b in pairs:
        if max(a["size"][0] * a["size"][1], b["size"][0] * b["size"][1]) > 3 * min(
            a["size"][0] * a["size"][1], b["size"][0] * b["size"][1]
        ):
            continue
        at_desk = "office_chair" in (a["category"], b["category"])
        if not at_desk and math.dist(a["position"], b["position"]) > 1.0 and fronted(room, a) == fronted(room, b):
            one, other = a["id"], b["id"]

            def check(before: Plain, after: Plain, one: str = one, other: str = other) -> bool:
                reach = 0.5 + (max(before[one]["size"][:2]) + max(before[other]["size"][:2])) / 4
                pairs = ((one, other), (other, one))
                away = [math.dist(after[x]["position"][:2], before[y]["position"][:2]) for x, y in pairs]
                own = [math.dist(after[x]["position"][:2], before[x]["position"][:2]) for x, _ in pairs]
                return all(a <= reach and a < o for a, o in zip(away, own, strict=True))

            text = f"Swap the {words(a['category'])} and the {words(b['category'])}."
            return Case("swap", text, mine(room, one, other), check)
    return None


def rotate_by(room: Plain) -> Case | None:
    for p in sorted(room.unique(), key=lambda p: p["category"] != "bed"):
        if p["size"][0] * p["size"][1] < 2.2 or p["category"] == "bed":
            id = p["id"]
            return Case(
                "rotate",
                f"Rotate the {words(p['category'])} by 90 degrees.",
                mine(room, id),
                partial(_is_turned, id),
            )
    return None


def closer(room: Plain) -> Case | None:
    counts = Counter(p["category"] for p in room.standing())
    stands = [p["id"] for p in room.standing() if p["category"] == "nightstand"]
    beds = [p["id"] for p in room.standing() if p["category"] == "bed"]
    if counts["nightstand"] == 2 and len(beds) == 1 and all(room.gap(s, beds[0]) > 0.03 for s in stands):
        bed = beds[0]
        return Case(
            "closer",
            "Move both nightstands closer to the bed.",
            mine(room, *stands),
            lambda before, after: all(after.gap(s, bed) < before.gap(s, bed) - 0.005 for s in stands),
        )
    alone = room.unique()
    for a in reversed(alone):
        for b in alone:
            gap = room.gap(a["id"], b["id"]) if a is not b else 0.0
            between = MultiPolygon([room.outline(a["id"]), room.outline(b["id"])]).convex_hull
            if 0.3 < gap < 3.0 and room.free(between, {a["id"], b["id"]}):
                one, other = a["id"], b["id"]
                return Case(
                    "closer",
                    f"Move the {words(a['category'])} closer to the {words(b['category'])}.",
                    mine(room, one),
                    partial(_is_closer, one, other),
                )
    return None


def centre(room: Plain) -> Case | None:
    x0, y0, x1, y1 = Polygon(room.room["floor"]).bounds
    if any(min(p["size"][:2]) > min(x1 - x0, y1 - y0) / 3 for p in room.standing()):
        return None  # it is wider than what is left beside the middle

    def check(before: Plain, after: Plain) -> bool:
        floor = Polygon(after.room["floor"])
        (x, y), (x0, y0, x1, y1) = floor.centroid.coords[0], floor.bounds
        w, d = (x1 - x0) / 6 - 0.01, (y1 - y0) / 6 - 0.01
        return after.free(box(x - w, y - d, x + w, y + d))

    return Case("centre", "Rearrange the room so that the centre stays free.", frozenset(room.placements), check)


def corner(room: Plain) -> Case | None:
    zones = [zone for zone, _, _ in room.windows()]
    if not zones:
        return None
    points = [tuple(c) for c in room.room["floor"]]

    def near(scene: Plain, id: str, reach: float) -> bool:
        away = {c: min(z.distance(Point(c)) for z in zones) for c in points}
        second = sorted(away.values())[1] + 0.01  # of corners that are as near, any is "the corner by the window"
        nearest = (c for c in points if away[c] <= second)
        return any(math.dist(scene[id]["position"][:2], c) < reach for c in nearest)

    def check(before: Plain, after: Plain) -> bool:
        seats = [
            q["id"] for q in after.placements.values() if "armchair" in q["category"] and near(after, q["id"], 1.6)
        ]
        lamps = [q["id"] for q in after.placements.values() if "lamp" in q["category"]]
        return any(after.gap(s, lamp) < 0.6 for s in seats for lamp in lamps)

    around = [id for id in room.placements if near(room, id, 1.9)]
    text = "Rearrange only the corner by the window into a reading corner."
    return Case("corner", text, mine(room, *around) if around else frozenset(), check)


def more(room: Plain) -> Case | None:
    tables = [p for p in room.unique() if p["category"] == "dining_table"]
    old = set(room.placements)
    if tables:
        table = tables[0]["id"]
        seats = [p for p in room.standing() if "chair" in p["category"] and room.gap(p["id"], table) < 0.4]
        around = 2 * (tables[0]["size"][0] + tables[0]["size"][1])
        fits = int(around / 0.75) - len(seats)
        count, said = (4, "four") if fits >= 4 else (2, "two") if fits >= 2 else (0, "")
        if count and seats:

            def check(before: Plain, after: Plain, table: str = table, count: int = count) -> bool:
                new = [q for q in after.placements if q not in old]
                return len(new) == count and all(
                    "chair" in after[q]["category"] and after.gap(q, table) < 0.45 and _faces(after, q, table)
                    for q in new
                )

            return Case("more", f"Add {said} more chairs around the dining table.", frozenset(), check)
    for p in room.unique():
        if fronted(room, p) and (
            room.free(beside(room, p["id"], 1.0, 0.55)) or room.free(beside(room, p["id"], -1.0, 0.55))
        ):
            id = p["id"]

            def next_to(before: Plain, after: Plain, id: str = id) -> bool:
                new = [q for q in after.placements if q not in old]
                return len(new) == 1 and "stool" in after[new[0]]["category"] and after.gap(new[0], id) <= 0.55

            return Case("more", f"Add a stool next to the {words(p['category'])}.", frozenset(), next_to)
    return None


def _faces(room: Plain, id: str, other: str) -> bool:
    """Whether a line ahead of it meets the other."""
    (x, y, _), yaw = room[id]["position"], math.radians(room[id]["yaw"])
    ahead = Point(x + 0.5 * math.cos(yaw), y + 0.5 * math.sin(yaw))
    return bool(room.outline(other).distance(ahead) < 0.15)


def longer(room: Plain) -> Case:
    x0, y0, x1, y1 = Polygon(room.room["floor"]).bounds
    old = max(x1 - x0, y1 - y0)

    def check(before: Plain, after: Plain) -> bool:
        a0, b0, a1, b1 = Polygon(after.room["floor"]).bounds
        same = all(
            _middle(before, i) == _middle(after, i) or before.room["openings"][i]["wall"] in _moved(before, after)
            for i in range(len(before.room["openings"]))
        )
        return abs(max(a1 - a0, b1 - b0) - old - 1.0) < 1e-6 and same

    hung = frozenset(p["id"] for p in room.placements.values() if p["support"].endswith(("east_wall", "north_wall")))
    text = "Make the room one metre longer and keep everything else where it is."
    return Case("longer", text, hung, check)


def _moved(before: Plain, after: Plain) -> set[int]:
    """Walls both of whose ends have moved."""
    pairs = zip(before.walls(), after.walls(), strict=True)
    return {n for n, ((a, b), (c, d)) in enumerate(pairs) if a != c and b != d}


def _middle(room: Plain, number: int) -> tuple[float, float]:
    o = room.room["openings"][number]
    (x0, y0), (x1, y1) = room.walls()[o["wall"]]
    share = (o["offset"] + o["width"] / 2) / math.dist((x0, y0), (x1, y1))
    return round(x0 + (x1 - x0) * share, 5), round(y0 + (y1 - y0) * share, 5)
