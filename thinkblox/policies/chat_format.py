"""How a chat is handed to a model of transformers: the same in training and at run time."""

from itertools import groupby
from typing import TYPE_CHECKING, Any

from thinkblox.chat import Chat, Message

if TYPE_CHECKING:
    from PIL.Image import Image


def messages(chat: Chat) -> list[dict[str, Any]]:
    """A chat as transformers and TRL take it: each content a list of texts, and of {"type": "image"} where one is seen.

    What looks like a special token is no longer one: whoever writes a prompt speaks for nobody else.
    """
    return [{"role": message.speaker, "content": _content(message)} for message in chat]


def images(chat: Chat) -> list["Image"]:
    """The images of a chat, in the order of their places."""
    return [image for message in chat for image in message.images]


def encode(processor: Any, chat: Chat) -> Any:
    """The tensors of a chat that is to be continued: input_ids (1, length), and of its images what the model takes."""
    text = processor.apply_chat_template(messages(chat), tokenize=False, add_generation_prompt=True)
    return processor(text=[text], images=images(chat) or None, return_tensors="pt")


def _content(message: Message) -> list[dict[str, Any]]:
    content: list[dict[str, Any]] = []
    for is_text, parts in groupby(message.parts, key=lambda part: isinstance(part, str)):
        if is_text:
            said = "\n\n".join(part for part in parts if isinstance(part, str))
            content.append({"type": "text", "text": said.replace("<|", "< |")})
        else:
            content += [{"type": "image"} for _ in parts]
    return content
