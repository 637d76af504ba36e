"""Ratings of finished rooms by a vision-language model.

LayoutVLM, whose benchmark the paper uses, published no code for its measures: Pos, Rot and PSA are a reconstruction.
"""

from typing import Annotated

import numpy as np
from msgspec import Meta

from thinkblox.chat import Chat, Message
from thinkblox.errors import NoAnswerError
from thinkblox.evaluation.contenders import NoPolicyError
from thinkblox.players import judging_server
from thinkblox.prompts import filled, one_line
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene
from thinkblox.steps import Rejection, decoded, tagged
from thinkblox.training.picture_judge import JUDGING, judged_views
from thinkblox.value import Value

SIZE = 512
"""Width and height of each picture that is rated [pixels]."""
Points = Annotated[float, Meta(ge=0, le=100)]


class PictureRating(Value, frozen=True, kw_only=True):
    """What a judge says of a room, 0 to 100: whether things are, and face, where the prompt and their use want it."""

    position: Points
    rotation: Points


class RoomRater:
    """Asks a model behind a server.

    Attributes:
        name: of the model.
    """

    def __init__(self, spec: str, *, size: int = SIZE) -> None:
        """Check the specification, "openai:BASE_URL#MODEL"; raises InputError."""
        self._server, self._size = judging_server(spec, asking=JUDGING), size
        self.name = spec.partition("#")[2].strip()

    def check(self) -> None:
        """Ask it once for the rating of an empty room; raises NoPolicyError where it gives none."""
        empty = Scene(prompt="An empty room.", room=rectangle(3.0, 3.0))
        if self.rating(empty) is None:
            raise NoPolicyError(f"the judge {self.name} does not rate: it gave no answer as it was asked to")

    def rating(self, scene: Scene) -> PictureRating | None:
        """Its rating; None where it gives none, or none that can be read.

        Raises:
            UnavailableError: the server is gone.
        """
        try:
            said = self._server.answer(rating_chat(scene, self._size), 1, np.random.default_rng(0))
        except NoAnswerError:
            return None
        parts = tagged(next(iter(said), ""))
        found = parts if isinstance(parts, Rejection) else decoded(parts[1], PictureRating)
        return None if isinstance(found, Rejection) else found


def rating_chat(scene: Scene, size: int) -> Chat:
    """What a judge is asked of a finished room."""
    question = filled("judge_room", prompt=one_line(scene.prompt))
    return (Message("user", (question, *judged_views(scene, size=size, ids=False))),)
