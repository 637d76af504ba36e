"""A random vision-language model of under a million parameters, made here: for tests, and to be trained from nothing.

    from thinkblox.policies.tiny import build_tiny
    build_tiny("tiny")      # then: hf:tiny

It has the architecture, the tokens and the processor of Qwen2.5-VL, and knows nothing.
"""

import math
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from msgspec import Meta

from thinkblox.assets.source import ProceduralAssets
from thinkblox.errors import InputError
from thinkblox.observe import Sight, kinds_of, observe
from thinkblox.plan import Plan
from thinkblox.planning import ExpertPlanner
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.policies.pretrained import quiet
from thinkblox.policies.processors import make_processor
from thinkblox.reading import GrammarBriefer
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at
from thinkblox.steps import Step, parse
from thinkblox.value import Value

PROMPTS = (
    "A bedroom, 4 m by 5 m, with a bed, two nightstands with a lamp on each, a wardrobe and a desk with a chair.",
    "A living room where a sofa faces a TV on a TV stand, with a coffee table on a rug, two armchairs and a plant.",
    "A dining room with a table, six chairs around it, a sideboard with a vase on it, and a pendant lamp above.",
    "A kitchen with a counter, a fridge, a stove, a table with two stools, a clock on the wall and a bowl on it.",
    "An L-shaped office with two desks, a monitor on each, two office chairs, a bookcase full of books and a printer.",
)
"""What the texts are about from which the tokens are learnt, when no others are given."""
SPECIAL = (
    "<|endoftext|>",
    "<|im_start|>",
    "<|im_end|>",
    "<|vision_start|>",
    "<|vision_end|>",
    "<|image_pad|>",
    "<|video_pad|>",
)
_WORDS = (
    r"(?i:'s|'t|'re|'ve|'m|'ll|'d)|[^\r\n\p{L}\p{N}]?\p{L}+|\p{N}| ?[^\s\p{L}\p{N}]+[\r\n]*|\s*[\r\n]+|\s+(?!\S)|\s+"
)
"""How Qwen's tokenizers cut a text before they join bytes to tokens: each digit stands alone."""
_NUMBER = r" ?\p{N}{1,3}\.\p{N}{1,2}"
"""What stands alone before that where numbers are tokens: in metres to the centimetre, or degrees."""
_SPACE = "\u0120"
"""What byte-level tokens have for a space."""
_PATCH = 14
_WAVES = 20
_WAVE_LENGTHS = (0.03, 40.0)
"""By how many waves, and of which lengths [m], the first embeddings of numbers tell how large they are."""
_NOISE = 0.5
"""And which part of them is as random as of other tokens."""
_SPREAD = 5.0
"""Times the usual size of first embeddings, so that a token that is copied stands out among a thousand numbers."""
_TEMPLATE = Path(__file__).with_name("chat_template.jinja")


class TinySize(Value, frozen=True, kw_only=True):
    """The sizes of a model.

    Attributes:
        hidden, layers, heads: of the language model; `hidden` is a multiple of 4 times `heads`.
        feed: how many times `hidden` the feed-forward layers are wide.
        vocabulary: most tokens, the special ones included; fewer where the texts give no more.
        vision_hidden, vision_layers: of the vision tower, which has 4 heads.
        context: longest text and images together [tokens].
        pixels: images are shrunk to at most this many pixels.
        numbers: whether each number below ten of one or two decimals, and each quarter turn, is one token with the
            space before it, whose embedding is at first near those of numbers of about its size; or each digit is one.
    """

    hidden: Annotated[int, Meta(ge=16)] = 96
    layers: Annotated[int, Meta(ge=1)] = 3
    heads: Annotated[int, Meta(ge=2)] = 4
    feed: Annotated[int, Meta(ge=1)] = 4
    vocabulary: Annotated[int, Meta(ge=300)] = 1024
    vision_hidden: Annotated[int, Meta(ge=16)] = 64
    vision_layers: Annotated[int, Meta(ge=1)] = 2
    context: Annotated[int, Meta(ge=256)] = 32768
    pixels: Annotated[int, Meta(ge=784)] = 336 * 336
    numbers: bool = False

    def __post_init__(self) -> None:
        """Raise InputError for sizes that do not go together."""
        if self.hidden % (4 * self.heads) or self.vision_hidden % 16:
            raise InputError(
                f"hidden is {self.hidden} for {self.heads} heads, vision_hidden {self.vision_hidden};"
                f" they must be multiples of {4 * self.heads} and 16"
            )


def build_tiny(
    folder: str | Path, *, size: TinySize | None = None, seed: int = 0, texts: Iterable[str] | None = None
) -> Path:
    """Make a random model with its tokenizer and processor in a folder; the same arguments give the same bytes.

    Args:
        folder: is made; what it holds of a model is replaced.
        size: how large it is.
        seed: of its weights.
        texts: from which the tokens are learnt; what the expert is shown and says when not given.
    """
    import torch
    from transformers import Qwen2_5_VLForConditionalGeneration

    size = size or TinySize()
    processor = _processor(own_texts() if texts is None else texts, size)
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        model = Qwen2_5_VLForConditionalGeneration(_config(size, processor.tokenizer))
        if size.numbers:
            _order_numbers(model, processor.tokenizer)
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    with quiet():
        model.save_pretrained(folder)
        processor.save_pretrained(folder)
    return folder


def own_texts(prompts: Iterable[str] = PROMPTS) -> Iterator[str]:
    """What the expert is shown and what it answers, step by step, in rooms for these prompts; nothing is measured."""
    for number, prompt in enumerate(prompts):
        yield from _room_texts(prompt, np.random.default_rng(number))


def _room_texts(prompt: str, rng: np.random.Generator) -> Iterator[str]:
    source, planner, expert, sight = ProceduralAssets(), ExpertPlanner(), ExpertPolicy(), Sight(pictures=False)
    brief = GrammarBriefer().brief(prompt)
    room = planner.room(brief, rng)
    plan: Plan = planner.plan(brief, room)
    kinds = kinds_of(plan, source)
    scene = Scene(prompt=prompt, room=room)
    for target in plan.targets:
        asset = source.make(target.category, seed=0, attributes=target.attributes)
        observation = observe(scene, plan, target, asset, kinds=kinds, sizes=source.size_range(target.category))
        answers = expert.propose(observation, 2, rng)
        yield from (message.text for message in observation.chat(sight))
        yield from answers
        step = parse(answers[0]) if answers else None
        if isinstance(step, Step) and step.position is not None and step.yaw is not None:
            placed = placed_at(scene, asset, id=target.id, position=step.position, yaw=step.yaw)
            scene = scene.with_placement(placed, asset)


def _processor(texts: Iterable[str], size: TinySize) -> Any:
    from tokenizers import Regex, Tokenizer, decoders, models, pre_tokenizers, trainers
    from transformers import PreTrainedTokenizerFast
    from transformers.models.qwen2_vl.image_processing_pil_qwen2_vl import Qwen2VLImageProcessorPil

    learnt = Tokenizer(models.BPE())
    learnt.pre_tokenizer = pre_tokenizers.Sequence(
        [
            pre_tokenizers.Split(Regex(f"{_NUMBER}|{_WORDS}" if size.numbers else _WORDS), behavior="isolated"),
            pre_tokenizers.ByteLevel(add_prefix_space=False, use_regex=False),
        ]
    )
    learnt.decoder = decoders.ByteLevel()
    trainer = trainers.BpeTrainer(
        vocab_size=size.vocabulary,
        special_tokens=list(SPECIAL),
        initial_alphabet=sorted(pre_tokenizers.ByteLevel.alphabet()),
        show_progress=False,
    )
    if size.numbers:
        texts = (re.sub(r"\d+\.\d+", " ", text) for text in texts)
    learnt.train_from_iterator(texts, trainer)
    if size.numbers:
        learnt = _with_numbers(learnt)
    tokenizer = PreTrainedTokenizerFast(
        tokenizer_object=learnt,
        eos_token="<|im_end|>",
        pad_token="<|endoftext|>",
        additional_special_tokens=list(SPECIAL[3:]),
        model_max_length=size.context,
    )
    edge = 2 * _PATCH
    images = Qwen2VLImageProcessorPil(size={"shortest_edge": edge * edge, "longest_edge": size.pixels})
    return make_processor("qwen2_5_vl", tokenizer, images, _TEMPLATE.read_text(encoding="utf-8"))


def _with_numbers(learnt: Any) -> Any:
    """A tokenizer with a token for each number besides, joined from its digits before anything else is joined."""
    import json

    from tokenizers import Tokenizer

    held = json.loads(learnt.to_str())
    vocabulary, merges = held["model"]["vocab"], []

    def join(*parts: str) -> None:
        vocabulary.setdefault("".join(parts), len(vocabulary))
        merges.append(list(parts))

    for whole in "0123456789":
        join(_SPACE, whole)
        join(f"{_SPACE}{whole}", ".")
        for tenth in "0123456789":
            join(f"{_SPACE}{whole}.", tenth)
            for hundredth in "123456789":
                join(f"{_SPACE}{whole}.{tenth}", hundredth)
    for quarter in ("90", "180", "270"):
        for end in range(1, len(quarter) + 2):
            join(f"{_SPACE}{quarter}.0"[: end + 1], f"{quarter}.0"[end])
    held["model"]["merges"] = merges + held["model"]["merges"]
    return Tokenizer.from_str(json.dumps(held))


def _order_numbers(model: Any, tokenizer: Any) -> None:
    """Let the embeddings of numbers begin as waves of many lengths over their value, so that near ones are alike."""
    import torch

    ids = {token: id for token, id in tokenizer.get_vocab().items() if re.fullmatch(_SPACE + r"\d+\.\d+", token)}
    weight = model.get_input_embeddings().weight.data
    weight *= _SPREAD
    rows = torch.tensor(list(ids.values()))
    values = torch.tensor([float(token[1:]) for token in ids])
    lengths = torch.logspace(*(math.log10(length) for length in _WAVE_LENGTHS), _WAVES)
    phases = 2.0 * math.pi * values[:, None] / lengths
    waves = torch.cat([phases.sin(), phases.cos()], 1) @ torch.randn(2 * _WAVES, weight.shape[1])
    waves *= weight[rows].std() / waves.std()
    weight[rows] = (1.0 - _NOISE**2) ** 0.5 * waves + _NOISE * weight[rows]


def _config(size: TinySize, tokenizer: Any) -> Any:
    from transformers import Qwen2_5_VLConfig

    ids = {token: tokenizer.convert_tokens_to_ids(token) for token in SPECIAL}
    pairs = size.hidden // size.heads // 2
    side = 3 * pairs // 8
    return Qwen2_5_VLConfig(
        text_config={
            "vocab_size": len(tokenizer),
            "hidden_size": size.hidden,
            "intermediate_size": size.feed * size.hidden,
            "num_hidden_layers": size.layers,
            "num_attention_heads": size.heads,
            "num_key_value_heads": size.heads // 2 if size.heads % 2 == 0 else size.heads,
            "max_position_embeddings": size.context,
            # Rotary pairs for time, height and width: half of a head's width in all.
            "rope_parameters": {
                "rope_type": "default",
                "rope_theta": 10000.0,
                "mrope_section": [pairs - 2 * side, side, side],
            },
            "bos_token_id": None,
            "eos_token_id": ids["<|im_end|>"],
            "pad_token_id": ids["<|endoftext|>"],
        },
        vision_config={
            "depth": size.vision_layers,
            "hidden_size": size.vision_hidden,
            "intermediate_size": 2 * size.vision_hidden,
            "num_heads": 4,
            "out_hidden_size": size.hidden,
            "patch_size": _PATCH,
            "spatial_merge_size": 2,
            "temporal_patch_size": 2,
            "window_size": 8 * _PATCH,
            "fullatt_block_indexes": [size.vision_layers - 1],
        },
        image_token_id=ids["<|image_pad|>"],
        video_token_id=ids["<|video_pad|>"],
        vision_start_token_id=ids["<|vision_start|>"],
        vision_end_token_id=ids["<|vision_end|>"],
        tie_word_embeddings=True,
    )
