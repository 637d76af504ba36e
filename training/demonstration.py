"""A demonstration: what a policy saw, and a text that was measured to be good. Made from saved episodes."""

from collections import Counter
from collections.abc import Iterator

from thinkblox.chat import Chat
from thinkblox.episode import Decision, Episode
from thinkblox.observe import Sight
from thinkblox.scene.scene import Scene
from thinkblox.steps import Step, parse
from thinkblox.training.filters import Filters, fault_of
from thinkblox.training.working import worked_out
from thinkblox.value import Value


class Demonstration(Value, frozen=True, kw_only=True):
    """One step of an episode as something to learn from.

    Attributes:
        decision: its number among the decisions of its episode, from 0.
        id: the object that was placed.
        category: what it is.
        text: the reasoning and the answer.
        prompt: the prompt of the room.
        room: the type of the room.
    """

    decision: int
    id: str
    category: str
    text: str
    prompt: str
    room: str


def demonstrations(
    episode: Episode, filters: Filters, *, worked: bool, refused: "Counter[str]"
) -> Iterator[tuple[Demonstration, Decision]]:
    """What can be learned from an episode; of the rest `refused` counts why not.

    Args:
        episode: how a room came about.
        filters: what a demonstration must pass.
        worked: with numbers in whole centimetres, and with the sums that lead from the reasoning to the answer.
        refused: is added to.
    """
    for number, decision in enumerate(episode.decisions()):
        done = decision.round
        if done.chosen is None:
            continue
        tried, scene = done.tries[done.chosen], scene_of(decision)
        fault = fault_of(scene, tried.text, tried.verdict, filters)
        if fault is not None:
            refused[fault] += 1
            continue
        text, step = tried.text, parse(tried.text)
        if worked and isinstance(step, Step) and tried.placement is not None:
            text = worked_out(decision.observation, step, tried.placement)
        yield (
            Demonstration(
                decision=number,
                id=done.id,
                category=episode.plan.target(done.id).category,
                text=text,
                prompt=episode.prompt,
                room=episode.plan.brief.room_type,
            ),
            decision,
        )


def scene_of(decision: Decision) -> Scene:
    """What stood in the room when a decision was made."""
    shown: tuple[Scene, object] = decision.observation.__dict__["shown"]
    return shown[0]


def shown(decision: Decision, sight: Sight) -> Chat:
    """What the policy was shown, by the very code that shows it at run time."""
    return decision.observation.chat(sight)
