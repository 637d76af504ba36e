"""Several continuations of one prompt: what it shares with the prompt before, and what they share, is computed once."""

import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.policies.growing import growing_cache, shortened
from thinkblox.policies.token_grammar import TokenGrammar

END = "</answer>"
_PIECE = 512
"""Tokens of a prompt that are computed together after some that are kept."""
_TAIL = 24
"""Tokens in which the end is looked for: none of its characters takes more than a token."""


@dataclass(frozen=True)
class Sampling:
    """How tokens are chosen, and when that ends.

    Attributes:
        temperature: what logits are divided by; 0 takes the likeliest token.
        top_p: only the likeliest tokens with together this probability are drawn from.
        tokens: most tokens of a continuation.
        seconds: when all continuations end, finished or not [s].
    """

    temperature: float
    top_p: float
    tokens: int
    seconds: float


@dataclass
class Counts:
    """What was computed so far: tokens of prompts, those of them that were not computed anew, and tokens made."""

    prompt: int = 0
    reused: int = 0
    made: int = 0


@dataclass
class _Kept:
    """The cache of the last prompt, and its tokens up to its first image: what comes after them is written over."""

    tokens: list[int] = field(default_factory=list)
    cache: Any = None


class Decoder:
    """Continues prompts with one model.

    Attributes:
        counts: what was computed so far.
    """

    def __init__(self, model: Any, tokenizer: Any, *, image_token: int, reuse: bool) -> None:
        """Continue with a model; with `reuse` prompts that begin as the last one did take over what was computed."""
        self._model = model
        self._device = model.device
        self._tokenizer = tokenizer
        self._image_token = image_token
        self._reuse = reuse
        self._kept = _Kept()
        self._ends = _ends(model, tokenizer)
        self._embed = model.get_input_embeddings()
        self._language = model.model.language_model
        self._closing: dict[int, bool] = {}
        self.counts = Counts()

    def continuations(
        self, inputs: Any, seeds: Sequence[int], sampling: Sampling, constraint: TokenGrammar | None = None
    ) -> list[str]:
        """A text for each seed: up to the end of the answer, the end of the turn, or a limit.

        A seed gives the same text whichever others are asked for with it.

        Args:
            inputs: of one prompt, as a processor gives them.
            seeds: of the random choices, one for each text.
            sampling: how tokens are chosen.
            constraint: what the texts must look like.
        """
        import torch

        until = time.monotonic() + sampling.seconds
        with torch.inference_mode():
            logits, cache, position = self._read(inputs)
            branches = _Branches(cache, len(seeds), sampling.tokens, logits.device)
            rows = [_Row(seed, constraint.matcher() if constraint else None) for seed in seeds]
            logits = logits.expand(len(rows), -1)
            going = list(range(len(rows)))
            for _ in range(sampling.tokens):
                tokens = self._choose(logits, [rows[number] for number in going], sampling)
                added = [self._add(rows[number], token) for number, token in zip(going, tokens, strict=True)]
                going = [number for number, goes_on in zip(going, added, strict=True) if goes_on]
                if not going or time.monotonic() >= until:
                    break
                logits = self._step([rows[number].tokens[-1] for number in going], going, branches, position)
                position += 1
        self.counts.made += sum(len(row.tokens) for row in rows)
        return [self._text(row) for row in rows]

    def _read(self, inputs: Any) -> tuple[Any, Any, int]:
        """The logits (1, vocabulary) after a prompt, its cache, and the position of the token that comes next."""
        import torch

        model = self._model
        inputs = inputs.to(self._device)
        ids = inputs["input_ids"]
        grid = inputs.get("image_grid_thw")
        types = (ids == self._image_token).int()
        positions, _ = model.model.get_rope_index(ids, mm_token_type_ids=types, image_grid_thw=grid)
        said = ids[0].tolist()
        text = said.index(self._image_token) if self._image_token in said else len(said)
        known = _common(self._kept.tokens, said[:-1])
        cache, self._kept = shortened(self._kept.cache, known) if known else growing_cache(), _Kept()
        pictures = {} if grid is None else {"pixel_values": inputs["pixel_values"], "image_grid_thw": grid}
        # After something that is kept, attention is computed for what is masked too: so not for all at once.
        bounds = [known, *(range(known + _PIECE, text, _PIECE) if known else ()), len(said)]
        for begin, end in pairwise(bounds):
            out = model(
                input_ids=ids[:, begin:end],
                position_ids=positions[:, :, begin:end],
                past_key_values=cache,
                use_cache=True,
                logits_to_keep=1,
                **(pictures if end == len(said) else {}),
            )
        if self._reuse:
            self._kept = _Kept(said[:text], cache)
        self.counts.prompt += len(said)
        self.counts.reused += known
        return out.logits[:, -1].to(torch.float32), cache, int(positions.max()) + 1

    def _step(self, tokens: list[int], going: list[int], branches: "_Branches", position: int) -> Any:
        """The logits (rows, vocabulary) after one token more in each row that goes on."""
        import torch

        ids = torch.tensor([tokens], device=self._device)
        out = self._language(
            inputs_embeds=self._embed(ids),
            position_ids=torch.full((3, 1, len(tokens)), position, device=self._device),
            attention_mask=branches.grown(going),
            past_key_values=branches.cache,
            use_cache=True,
        )
        return self._model.lm_head(out.last_hidden_state)[0].to(torch.float32)

    def _choose(self, logits: Any, rows: Sequence["_Row"], sampling: Sampling) -> list[int]:
        """A token for each row."""
        import torch

        logits = logits[:, : len(self._tokenizer)]
        if rows[0].matcher is not None:
            allowed = np.stack([row.allowed(logits.shape[1]) for row in rows])
            logits = logits.masked_fill(~torch.from_numpy(allowed).to(logits.device), -torch.inf)
        if sampling.temperature == 0.0:
            return [int(token) for token in logits.argmax(-1).tolist()]
        shares = torch.softmax(logits.double() / sampling.temperature, -1)
        order = None
        if sampling.top_p < 1.0:
            shares, order = torch.sort(shares, dim=-1, descending=True, stable=True)
            shares = shares.masked_fill(shares.cumsum(-1) - shares >= sampling.top_p, 0.0)
        sums = shares.cumsum(-1)
        drawn = torch.tensor([[row.random()] for row in rows], dtype=sums.dtype, device=sums.device) * sums[:, -1:]
        # The first whose sum is above what was drawn; the last that can be drawn where rounding leaves none.
        found = torch.searchsorted(sums, drawn, right=True)
        found = torch.minimum(found, (sums < sums[:, -1:]).sum(-1, keepdim=True))
        return [int(token) for token in (found if order is None else order.gather(1, found))[:, 0].tolist()]

    def _add(self, row: "_Row", token: int) -> bool:
        """Add a token to a row; says whether the row goes on."""
        if token in self._ends:
            return False
        row.tokens.append(token)
        if row.matcher is not None and (not row.matcher.consume_token(token) or row.matcher.is_stopped()):
            return False
        if token not in self._closing:
            self._closing[token] = END[-1] in self._tokenizer.decode([token])
        return not self._closing[token] or END not in self._tokenizer.decode(row.tokens[-_TAIL:])

    def _text(self, row: "_Row") -> str:
        text = str(self._tokenizer.decode(row.tokens))
        head, end, _ = text.partition(END)
        return head + end


class _Branches:
    """The continuations of one prompt in one cache of batch size 1: each sees the prompt and its own tokens.

    So the prompt's keys and values are there once, however many go on from it.
    """

    def __init__(self, cache: Any, count: int, tokens: int, device: Any) -> None:
        import torch

        self.cache = cache
        self._count = count
        self._length = cache.get_seq_length()
        self._sees = torch.zeros((count, self._length + count * tokens), dtype=torch.bool, device=device)
        self._sees[:, : self._length] = True

    def grown(self, going: list[int]) -> Any:
        """The mask (1, 1, rows, tokens) for one token more in each row that goes on; None where all see all."""
        if self._count == 1:
            return None
        import torch

        new = torch.arange(self._length, self._length + len(going), device=self._sees.device)
        rows = torch.tensor(going, device=self._sees.device)
        self._sees[rows, new] = True
        self._length += len(going)
        return self._sees[rows, : self._length][None, None]


class _Row:
    """One continuation: its tokens, its own random numbers, and where it stands in the grammar."""

    def __init__(self, seed: int, matcher: Any) -> None:
        self.tokens: list[int] = []
        self.random = np.random.default_rng(seed).random
        self.matcher = matcher

    def allowed(self, vocabulary: int) -> NDArray[np.bool_]:
        """Which tokens may come next."""
        bits = np.frombuffer(self.matcher.compute_bitmask(), np.uint8)
        allowed = np.unpackbits(bits, bitorder="little").astype(np.bool_)
        return np.pad(allowed, (0, max(0, vocabulary - len(allowed))))[:vocabulary]


def _ends(model: Any, tokenizer: Any) -> frozenset[int]:
    """The tokens that end a turn."""
    said = model.generation_config.eos_token_id
    ends = set(said if isinstance(said, list) else [said]) | {tokenizer.eos_token_id, tokenizer.pad_token_id}
    return frozenset(int(token) for token in ends if token is not None)


def _common(one: Sequence[int], other: Sequence[int]) -> int:
    """How many tokens two prompts have in common at their beginning."""
    most = min(len(one), len(other))
    differing = np.flatnonzero(np.asarray(one[:most]) != np.asarray(other[:most]))
    return int(differing[0]) if len(differing) else most
