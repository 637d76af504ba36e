"""The embedded expert: arranges a room by the guidelines of interior layout, in the language every policy speaks."""

import math

import numpy as np

from thinkblox.observe import Observation
from thinkblox.phrases import phrase
from thinkblox.policies.expert.ground import darkens
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.imagine import ELSEWHERE, from_room, from_ties
from thinkblox.policies.expert.judge import HOPELESS, boxes, placement_of, ranked
from thinkblox.policies.expert.situation import Situation
from thinkblox.scene.saying import pose_words
from thinkblox.steps import write_step
from thinkblox.wording import describe_tie

DISTINCT = 0.08
"""Two proposals nearer than this, with the same yaw, are one [m]; a third of the object's size for small things."""


class ExpertPolicy:
    """Proposes by relation and free space, varied by the generator handed in, and says what led to each proposal."""

    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        """Up to `n` texts, the best first; later tries look further down its list."""
        situation = Situation(observation)
        ideas = ranked(situation, from_ties(situation), rng)
        if observation.round or sum(cost < ELSEWHERE for cost, _ in ideas) < n:
            ideas = sorted([*ideas, *ranked(situation, from_room(situation), rng)], key=lambda pair: pair[0])
        if situation.facts.hanging.windows == "no" and situation.asset.mount == "wall":
            ideas = _off_the_glass(situation, ideas)
        chosen = _distinct(situation, ideas, n * (1 + observation.round))
        return [_say(situation, cost, idea) for cost, idea in chosen][-n:]


def _off_the_glass(situation: Situation, ideas: list[tuple[float, Idea]]) -> list[tuple[float, Idea]]:
    """Those that hang over no window, which carries nothing; of what nobody asked for, only those that fit well."""
    if not situation.target.asked:
        return [(cost, idea) for cost, idea in ideas if cost < HOPELESS / 2]
    if not ideas or any(tie.asked and "window" in tie.anchors for tie in situation.target.ties):
        return ideas
    dark = darkens(situation, boxes(situation, [idea for _, idea in ideas]))
    return [pair for pair, share in zip(ideas, dark, strict=True) if share < 1.0]


def _distinct(situation: Situation, ideas: list[tuple[float, Idea]], n: int) -> list[tuple[float, Idea]]:
    """Half of them the best, the other half the best that lie well apart, so that one obstacle does not spoil all."""
    near = min(DISTINCT, max(situation.size[:2]) / 3)
    chosen: list[tuple[float, Idea]] = []
    for apart, most in ((near, (n + 1) // 2), (4 * near, n), (near, n)):
        for cost, idea in ideas:
            if len(chosen) == most:
                break
            if all(math.dist(idea.position, other.position) > apart or idea.yaw != other.yaw for _, other in chosen):
                chosen.append((cost, idea))
    return sorted(chosen, key=lambda pair: pair[0])


def _say(situation: Situation, cost: float, idea: Idea) -> str:
    target = situation.target
    wanted = [describe_tie(tie) for tie in target.ties]
    lines = [
        f"Next is {target.id}, {situation.asset.description}" + (f"; wanted: {', '.join(wanted)}." if wanted else ".")
    ]
    lines.append(f"{idea.why[0].upper()}{idea.why[1:]}.")
    found = pose_words(situation.room, placement_of(situation, idea), beyond=idea.against) if idea.against else ()
    lines.append(f"So it goes {', '.join(phrase(word) for word in (*idea.words, *found))}.")
    if situation.observation.feedback:
        lines.append(f"Before, {situation.observation.feedback[0]}; this place is another.")
    if cost >= HOPELESS:
        lines.append("The room is crowded, and nothing better is free.")
    return write_step(lines, id=target.id, position=idea.position, yaw=idea.yaw, size=idea.size or situation.size)
