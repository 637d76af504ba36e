"""Any vision-language model of transformers as the model behind a policy, on this machine."""

import math
from pathlib import Path

import numpy as np

from thinkblox.chat import Chat
from thinkblox.errors import InputError, NoAnswerError, UnavailableError
from thinkblox.observe import Sight
from thinkblox.policies.chat_format import encode
from thinkblox.policies.decoding import Counts, Decoder, Sampling
from thinkblox.policies.pretrained import Pretrained, load_pretrained
from thinkblox.policies.token_grammar import TokenGrammar
from thinkblox.value import read_json

PATIENCE = 3
"""After so many chats in a row that are too long for a model it counts as unable to go on."""
SIGHT = "sight.json"
"""In the folder of a model that was trained on our demonstrations: what it was shown."""


class HfModel:
    """A model of the Qwen2.5-VL or Qwen3-VL family that continues chats; one chat at a time.

    Candidates are sampled in one batch, what they share is computed once, and a chat that begins as the last one did
    (the same text, up to its first image) goes on from there.
    """

    def __init__(
        self,
        model: str | Path | Pretrained,
        adapter: str | Path | None = None,
        device: str | None = None,
        *,
        max_new_tokens: int = 1024,
        temperature: float = 0.7,
        top_p: float = 1.0,
        seconds: float = 120.0,
        grammar: str | None = None,
        reuse_prefix: bool = True,
    ) -> None:
        """Read a model.

        Args:
            model: a folder, a repository's id, or one that was read before.
            adapter: a folder or repository with a PEFT adapter for it.
            device: "cpu", "cuda" or "cuda:N"; a GPU where there is one when not given.
            max_new_tokens: the longest answer [tokens].
            temperature: how much candidates differ; with 0 there is but one, the likeliest.
            top_p: candidates are drawn from the likeliest tokens of together this probability.
            seconds: how long the answers to one chat may take; what is not finished by then ends there [s].
            grammar: a Lark grammar for llguidance that every answer follows, as `step_grammar()`.
            reuse_prefix: whether a chat goes on from what it shares with the last one.

        Raises:
            InputError: what is missing or does not fit, and what to do.
        """
        _check(max_new_tokens, temperature, top_p, seconds)
        if isinstance(model, Pretrained) and (adapter is not None or device is not None):
            raise InputError("a model that was read before has its adapter and its device; give its name for others")
        read = model if isinstance(model, Pretrained) else load_pretrained(model, adapter=adapter, device=device)
        self.sight = trained_sight(model)
        self._processor = read.processor
        self._sampling = Sampling(temperature=temperature, top_p=top_p, tokens=max_new_tokens, seconds=seconds)
        tokenizer = read.processor.tokenizer
        self._constraint = TokenGrammar(grammar, tokenizer, len(tokenizer)) if grammar is not None else None
        self._too_long = 0
        self._context = int(read.model.config.get_text_config().max_position_embeddings)
        self._decoder = Decoder(read.model, tokenizer, image_token=read.processor.image_token_id, reuse=reuse_prefix)

    @property
    def counts(self) -> Counts:
        """Tokens of all chats so far."""
        return self._decoder.counts

    def answer(self, chat: Chat, n: int, rng: np.random.Generator) -> list[str]:
        """Up to `n` answers to a conversation, sampled apart; one where the temperature is 0.

        Raises:
            NoAnswerError: the chat is longer than the model can read.
            UnavailableError: and so were those before it.
        """
        if n < 1:
            return []
        inputs = encode(self._processor, chat)
        length = inputs["input_ids"].shape[1]
        if length >= self._context:
            self._too_long += 1
            why = f"the chat has {length} tokens; the model reads fewer than {self._context}"
            if self._too_long < PATIENCE:
                raise NoAnswerError(why)
            raise UnavailableError(
                f"{why}, and the last {self._too_long} were all too long; show it less, or take one that reads more"
            )
        self._too_long = 0
        count = n if self._sampling.temperature > 0.0 else 1
        seeds = [int(seed) for seed in rng.integers(2**63, size=n)][:count]
        return self._decoder.continuations(inputs, seeds, self._sampling, self._constraint)


def trained_sight(model: str | Path | Pretrained) -> Sight | None:
    """What a model was shown in training, where its folder says so.

    Raises:
        InputError: what it says cannot be read.
    """
    file = None if isinstance(model, Pretrained) else Path(model) / SIGHT
    return read_json(file, Sight) if file is not None and file.is_file() else None


def _check(max_new_tokens: int, temperature: float, top_p: float, seconds: float) -> None:
    if max_new_tokens < 1:
        raise InputError(f"max_new_tokens is {max_new_tokens}; it must be at least 1")
    if not 0.0 <= temperature < math.inf:
        raise InputError(f"the temperature is {temperature}; it must be 0 or more")
    if not 0.0 < top_p <= 1.0:
        raise InputError(f"top_p is {top_p}; it must be above 0, and 1 at most")
    if not seconds > 0.0:
        raise InputError(f"{seconds} s are no time to answer in; give more than 0")
