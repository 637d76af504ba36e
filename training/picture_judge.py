"""A vision-language model behind a server that judges rendered rooms."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from thinkblox.chat import Chat, Message
from thinkblox.players import judging_server
from thinkblox.policies.openai_server import Asking
from thinkblox.scene.scene import Scene

if TYPE_CHECKING:
    from PIL.Image import Image

JUDGING = Asking(temperature=0.0, tokens=1024, seconds=60.0, retries=2, at_once=8)
"""How a judge is asked: a batch of 64 that it leaves unanswered is given up after eight minutes, at most."""
_TRIAL = "Is this picture empty? Answer with one word, Yes or No."


class PictureJudge:
    """Says how likely it is that what pictures show is as it should be.

    Attributes:
        name: of the model, for logs and tables.
    """

    def __init__(self, spec: str, *, asking: Asking = JUDGING) -> None:
        """Check the specification, "openai:BASE_URL#MODEL"; nothing is asked yet. Raises InputError."""
        self._model = judging_server(spec, asking=asking)
        self.name = spec.partition("#")[2].strip()

    def check(self) -> None:
        """Ask it once, before hours are spent.

        Raises:
            InputError: it is not there, cannot see, or gives no probabilities.
        """
        from PIL import Image

        self._model.probability((Message("user", (_TRIAL, Image.new("RGB", (64, 64), "white"))),), "Yes")

    def approvals(self, chats: Sequence[Chat]) -> list[float | None]:
        """exp(logprob "Yes") for each chat, asked together; None where the server failed for one.

        Raises:
            UnavailableError: the server is gone, gives no probabilities, or fails for all, time and again.
        """
        return self._model.probabilities(chats, "Yes")


def judged_views(scene: Scene, *, size: int, ids: bool) -> tuple["Image", "Image"]:
    """What a judge of a room is shown: it from above, and from over a corner."""
    from thinkblox.sim.render.views import Marking, room_views

    views = room_views(scene, size=size, count=2, marking=Marking(grid=False, ids=ids, fronts=ids))
    return views[0].picture, views[1].picture
