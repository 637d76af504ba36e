"""The groups that categories can belong to, by which reader, planner and expert speak of many at once."""

from collections.abc import Mapping
from types import MappingProxyType

GROUPS: Mapping[str, str] = MappingProxyType(
    {
        # What the reader and the habits speak of.
        "beds": "people sleep in it",
        "lounges": "one leans back in it",
        "desks": "one sits at its front and works",
        "tables": "people sit or gather around it",
        "low_tables": "stands before or beside a sofa",
        "meal_tables": "people sit around it to eat or to talk",
        "counters": "one stands or sits at it and is served",
        "basins": "one washes one's hands at it",
        "worktops": "a kitchen's work is done on it",
        "boards": "many look at what is shown on it",
        "storage": "things are kept in it, and it carries more on top",
        "shelves": "things stand on its shelves",
        "plants": "a plant",
        "seats": "one sits on it at a table, or next to others",
        "wallpieces": "hangs on a wall",
        "lamps": "gives light",
        "small": "lies or stands on other things",
        "fitted": "is named with what it is part of or stands in line with",
        "ceiling": "hangs from the ceiling",
        "surfaces": "carries other things",
        "lengthwise": "its length is the long way, from its front to its back",
        "upright": "a length that is said of it is its height",
        "covers": "lies flat on the floor",
        "tops": "carries things on top, though that is not what it is for",
        "built_in": "is let into a worktop",
        "screens": "its size is the diagonal; people watch it",
        "chairs": "it is drawn up to a table where only the table is named",
        "meal_seats": "one for each of the people, four to a table where nobody says how many",
        "own_bed": "one for each who sleeps in a room",
        "takes_built_in": "a sink or hob can be let into it",
        "large_tables": "too large to be brought in for one small thing, where nobody dines or shows",
        "fills_shelves": "shelves full of it are described, not asked for",
        "takes_books": "can be full of books",
        # What the planner speaks of.
        "long_sides": "several sit at its long side",
        "watched": "still looks for those who watch it where it is only said to be on the wall",
        "played_around": "needs wide floor all around for a game",
        "lined_up": "stands in rows with seats behind",
        "sat_before": "needs floor before it for those who sit or stand there",
        # What the expert speaks of.
        "seating": "people sit on it",
        "lain_on": "people lie on it: they get in from its sides",
        "foot_rugs": "a rug under it reaches out at its foot",
        "lounged_at": "lounge seats gather around it",
        "stands_free": "may stand away from the walls when nothing says where",
        "amid_room": "stands away from the walls: what hangs on a wall is near it rather than beside it",
        "in_corners": "likes corners",
        "focal": "looks best centred on its wall",
        "walled": "is built to a wall: it stands close up to it, and never before a window",
        "sat_around": "people sit or play all around it: a wall close up to it is in their way",
        "cases": "can stand side by side with its like without a gap",
        "drawn_aside": "is drawn aside by whoever passes",
        "from_aisles": "is used from the aisle between its rows",
        "staff_side": "turns its working side to the person behind a counter",
    }
)
"""Every group, and what belongs to it."""
