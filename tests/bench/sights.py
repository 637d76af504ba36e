"""What it costs to show a model each step of a room: CPU time of the whole observation, text and pictures.

python -m tests.bench.sights [--objects N] [--runs N]

The first observation of a room draws its floor and walls, and everything that stands in it; each later one what is new.
"""

import argparse
import statistics
import sys
import time

from thinkblox.episode import Episode
from thinkblox.generate import generate_room
from thinkblox.observe import Observation, Sight
from thinkblox.placing import Effort
from thinkblox.sim.render import layers, metres, views

PROMPT = (
    "A living room, 6 m by 5 m, with a sofa, two armchairs, a coffee table, a rug, a bookcase with ten books, a TV on "
    "a TV stand, two side tables with a lamp on each, a desk with an office chair, a desk lamp and a laptop, three "
    "pictures, four plants, a dining table with six chairs, and four cups and four plates on the dining table."
)
SIGHTS = {
    "three of 336 px": Sight(),
    "two of 168 px": Sight(size=168, views=2),
    "two of 168 px, no target": Sight(size=168, views=2, target=False),
    "text alone": Sight(pictures=False),
}


def forget() -> None:
    """As if nothing had been drawn yet."""
    for kept in (layers.viewpoint, layers._bare, layers._caster, layers._layer, metres.metre_grid, views._openings):
        kept.cache_clear()


def seconds(observation: Observation, sight: Sight) -> float:
    """CPU time of one observation [s]."""
    start = time.process_time()
    observation.chat(sight)
    return time.process_time() - start


def measured(episode: Episode, sight: Sight, objects: int) -> tuple[float, float, float, float]:
    """The first observation of an episode with nothing drawn yet, and one with so many objects; then the mean and the
    largest of all that follow the first, in order [s].
    """
    seen = [decision.observation for decision in episode.decisions()]
    crowded = next(o for o in seen if len(o.layout.placements) >= objects)
    forget()
    alone = seconds(crowded, sight)
    forget()
    first, *rest = [seconds(o, sight) for o in seen]
    return alone, first, statistics.mean(rest), max(rest)


def main() -> int:
    """Print a row for each sight."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--objects", type=int, default=40)
    parser.add_argument("--runs", type=int, default=3)
    options = parser.parse_args()
    episode = generate_room(PROMPT, effort=Effort(restarts=0)).episode
    print(f"{len(episode.scene.placements)} objects; CPU ms of one observation")
    print(f"{'':26} {options.objects} objects, nothing drawn   first   later: mean     max   a second, whole episode")
    seconds(next(episode.decisions()).observation, Sight())
    for name, sight in SIGHTS.items():
        runs = [measured(episode, sight, options.objects) for _ in range(options.runs)]
        alone, first, mean, most = (1000 * min(column) for column in zip(*runs, strict=True))
        count = sum(1 for _ in episode.decisions())
        rate = 1000 * count / (first + mean * (count - 1))
        print(f"{name:26} {alone:25.0f} {first:7.0f} {mean:13.1f} {most:7.1f} {rate:25.1f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
