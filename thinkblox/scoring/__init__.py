"""Scoring a room by the published guidelines of interior layout, without physics: a pure function of what stands.

The terms are those of Merrell et al. 2011, "Interactive Furniture Layout Using Interior Design Guidelines" (clearance,
circulation, pairwise distance and angle, conversation, balance, alignment, emphasis) and of Yu et al. 2011, "Make it
Home" (accessibility, visibility); the figures are those of the handbooks (Neufert, Architects' Data; Time-Saver
Standards). It is guidance on taste and use; whether a room can stand as it is, is for `thinkblox.verify`.
"""

from thinkblox.errors import InputError
from thinkblox.room_score import RoomScore, ScorePart
from thinkblox.scene.arrangement import Arrangement
from thinkblox.scoring.balance import balance
from thinkblox.scoring.circulation import circulation
from thinkblox.scoring.clearance import clearance
from thinkblox.scoring.company import conversation, distances, emphasis
from thinkblox.scoring.rating import Rating
from thinkblox.scoring.standing import Standing
from thinkblox.scoring.walls import alignment, daylight

WEIGHTS = {
    "clearance": 2.0,
    "circulation": 2.0,
    "distances": 1.5,
    "conversation": 1.0,
    "balance": 0.75,
    "alignment": 1.0,
    "emphasis": 1.0,
    "daylight": 0.75,
}
"""What each part counts for in the total: first that a room can be used, then how it looks."""
_PARTS = (clearance, circulation, distances, conversation, balance, alignment, emphasis, daylight)


def score(scene: Arrangement) -> RoomScore:
    """Score a room by published interior guidelines.

    Args:
        scene: a room and what stands in it, with or without categories that are known; what a thing is called decides
            which guidelines speak of it, so that a room of unknown things has fewer parts that count.

    Returns:
        The parts, each from 0 to 1 with the numbers that made it, and their mean weighted by WEIGHTS over the parts
        that have something to speak of; a total of None where no object stands in the room.

    Raises:
        InputError: it is no scene.
    """
    if not isinstance(scene, Arrangement):
        raise InputError(f"a {type(scene).__name__} cannot be scored; give a Scene, as of load_scene")
    standing = Standing(scene)
    parts = tuple(_part(rate.__name__, rate(standing)) for rate in _PARTS)
    rated = [(part.score, part.weight) for part in parts if part.score is not None]
    weight = sum(weight for _, weight in rated)
    total = sum(score * weight for score, weight in rated) / weight if rated and scene.placements else None
    return RoomScore(total=None if total is None else round(total, 4), parts=parts)


def _part(name: str, rating: Rating) -> ScorePart:
    score = None if rating.score is None else round(min(max(rating.score, 0.0), 1.0), 4)
    numbers = {key: round(float(value), 4) + 0.0 for key, value in rating.numbers.items()}
    return ScorePart(name=name, score=score, weight=WEIGHTS[name], numbers=numbers, worst=rating.worst)


__all__ = ["WEIGHTS", "score"]
