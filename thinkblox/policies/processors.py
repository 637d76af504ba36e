"""Processors of Qwen's vision-language models without their half for videos, which alone needs torchvision."""

from functools import cache
from typing import Any

FAMILIES = {
    "qwen2_5_vl": ("qwen2_5_vl", "Qwen2_5_VLProcessor"),
    "qwen3_vl": ("qwen3_vl", "Qwen3VLProcessor"),
}
"""Of each family of models, by the name in its config.json, the module of transformers and its processor in there."""


@cache
def processor_class(family: str) -> Any:
    """The processor of a family, for texts and images; it is saved and read under the name of the ordinary one."""
    from importlib import import_module

    from transformers.processing_utils import ProcessorMixin

    module, name = FAMILIES[family]
    ordinary = getattr(import_module(f"transformers.models.{module}.processing_{module}"), name)

    # ProcessorMixin asks for every part that __init__ names; without its name there, no video processor is wanted.
    def begin(self: Any, image_processor: Any = None, tokenizer: Any = None, chat_template: Any = None) -> None:
        tokens = {
            "image": "image_pad",
            "video": "video_pad",
            "vision_start": "vision_start",
            "vision_end": "vision_end",
        }
        for part, token in tokens.items():
            setattr(self, f"{part}_token", f"<|{token}|>")
            setattr(self, f"{part}_token_id", tokenizer.convert_tokens_to_ids(f"<|{token}|>"))
        ProcessorMixin.__init__(self, image_processor, tokenizer, chat_template=chat_template)

    return type(name, (ordinary,), {"__init__": begin, "__module__": __name__})


def make_processor(family: str, tokenizer: Any, image_processor: Any, chat_template: str) -> Any:
    """A processor of its parts."""
    return processor_class(family)(image_processor=image_processor, tokenizer=tokenizer, chat_template=chat_template)


def read_processor(family: str, name: str) -> Any:
    """The processor that was saved with a model, in a folder or a repository; raises what transformers raises."""
    from transformers import AutoTokenizer
    from transformers.models.qwen2_vl.image_processing_pil_qwen2_vl import Qwen2VLImageProcessorPil

    read = processor_class(family).get_processor_dict(name)[0]
    tokenizer = AutoTokenizer.from_pretrained(name)
    image_processor = Qwen2VLImageProcessorPil.from_pretrained(name)
    return make_processor(family, tokenizer, image_processor, read.get("chat_template") or tokenizer.chat_template)


def use_without_torchvision() -> None:
    """Make transformers' own loaders, in this process, take these processors for the ordinary ones."""
    from importlib import import_module

    for family, (module, name) in FAMILIES.items():
        setattr(import_module(f"transformers.models.{module}"), name, processor_class(family))
