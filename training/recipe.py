"""What a dataset is made from: everything that decides its bytes."""

from typing import Annotated, Literal

from msgspec import Meta

from thinkblox.observe import Sight
from thinkblox.training.filters import Filters
from thinkblox.value import Value

RECIPE, RECIPE_VERSION = "recipe.json", 1
Split = Literal["train", "validation", "test"]
SPLITS: tuple[Split, ...] = ("train", "validation", "test")


class Recipe(Value, frozen=True, kw_only=True):
    """How a dataset is made; the same recipe gives the same bytes.

    Attributes:
        version: of what is made by it.
        scenes: rooms, one prompt each.
        seed: every choice follows from it.
        order: in which the objects of a room are placed.
        least: objects that a room must have, at least.
        sight: what the policy is shown.
        worked: whether the reasoning names the free line and the place on it, in numbers as the answer has them.
        filters: what a demonstration must pass.
        held_out: shares of the rooms for validation and for the test.
        block: rooms in one shard: what is done at once, and done again after an interruption.
        prompts: the prompts to use, over and over; sampled when there are none.
    """

    version: int = RECIPE_VERSION
    scenes: Annotated[int, Meta(ge=1, le=10_000_000)]
    seed: Annotated[int, Meta(ge=0, le=2**63 - 1)] = 0
    order: Literal["plan", "size", "random"] = "plan"
    least: Annotated[int, Meta(ge=1)] = 5
    sight: Sight = Sight(size=168, views=1)
    worked: bool = False
    filters: Filters = Filters()
    held_out: tuple[Annotated[float, Meta(ge=0, lt=1)], Annotated[float, Meta(ge=0, lt=1)]] = (0.05, 0.05)
    block: Annotated[int, Meta(ge=1, le=1000)] = 16
    prompts: tuple[str, ...] = ()

    @property
    def shards(self) -> int:
        """How many shards it has."""
        return -(-self.scenes // self.block)

    def scenes_of(self, shard: int) -> range:
        """Numbers of the scenes of a shard."""
        return range(shard * self.block, min((shard + 1) * self.block, self.scenes))

    def split_of(self, scene: int) -> Split:
        """To which split a scene belongs, with all that is made of it."""
        import numpy as np

        drawn = np.random.default_rng((self.seed, scene, 1)).random()
        validation, test = self.held_out
        return "validation" if drawn < validation else "test" if drawn < validation + test else "train"
