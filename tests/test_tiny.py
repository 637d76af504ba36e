import hashlib
import json
import os
import shutil
import subprocess
import sys

import pytest

from thinkblox.chat import Message
from thinkblox.errors import InputError
from thinkblox.policies.chat_format import encode, messages
from thinkblox.policies.pretrained import load_pretrained
from thinkblox.policies.tiny import TinySize, build_tiny, own_texts

pytest.importorskip("torch")
TEXTS = ("A chair stands at (1.25, 2.50).", "<think>\n1. It goes there.\n</think>\n<answer>{}</answer>") * 4
SMALL = TinySize(hidden=16, layers=1, heads=2, vocabulary=320, vision_hidden=16, vision_layers=1)


def digest(folder):
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(folder.iterdir())}


def test_it_has_under_a_million_parameters(tiny_folder):
    read = load_pretrained(tiny_folder, device="cpu")
    assert sum(p.numel() for p in read.model.parameters()) < 1_000_000
    assert type(read.model).__name__ == "Qwen2_5_VLForConditionalGeneration"
    assert not read.model.training


@pytest.mark.slow
def test_the_same_seed_gives_the_same_bytes_in_another_process(tiny_folder, tmp_path):
    code = f"from thinkblox.policies.tiny import build_tiny; build_tiny({str(tmp_path / 'again')!r})"
    environment = {**os.environ, "PYTHONHASHSEED": "7", "OMP_NUM_THREADS": "1"}
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True, env=environment)
    assert digest(tmp_path / "again") == digest(tiny_folder)
    assert done.stdout + done.stderr == ""


def test_another_seed_gives_other_weights_and_the_same_tokens(tmp_path):
    one = digest(build_tiny(tmp_path / "one", size=SMALL, texts=TEXTS))
    other = digest(build_tiny(tmp_path / "other", size=SMALL, texts=TEXTS, seed=1))
    assert {name for name in one if one[name] != other[name]} == {"model.safetensors"}


def test_making_one_leaves_the_random_numbers_of_others_alone(tmp_path):
    import torch

    torch.manual_seed(5)
    before = torch.rand(3)
    torch.manual_seed(5)
    build_tiny(tmp_path, size=SMALL, texts=TEXTS)
    assert torch.equal(torch.rand(3), before)


@pytest.mark.parametrize("sizes", [{"hidden": 60, "heads": 4}, {"vision_hidden": 40}])
def test_sizes_that_do_not_go_together_are_refused(sizes):
    with pytest.raises(InputError, match="multiples of"):
        TinySize(**sizes)


def test_its_tokens_say_every_text_and_each_digit_apart(tiny_folder):
    tokenizer = load_pretrained(tiny_folder, device="cpu").processor.tokenizer
    for text in ("turned to 90.25 degrees, 床 é 😀\n\n  x", next(own_texts(["A room with a chair."]))):
        tokens = tokenizer(text)["input_ids"]
        assert tokenizer.decode(tokens) == text
    pieces = tokenizer.convert_ids_to_tokens(tokenizer("1234")["input_ids"])
    assert pieces == ["1", "2", "3", "4"]


def test_a_folder_as_the_published_ones_are_is_read_alike(tiny_folder, tmp_path):
    """Those keep what prepares images in preprocessor_config.json, and the chat template in chat_template.json."""
    from PIL import Image

    folder = tmp_path / "published"
    shutil.copytree(tiny_folder, folder)
    processor = json.loads((folder / "processor_config.json").read_text())
    images = {**processor["image_processor"], "processor_class": "Qwen2_5_VLProcessor"}
    (folder / "preprocessor_config.json").write_text(json.dumps(images))
    template = (folder / "chat_template.jinja").read_text()
    (folder / "chat_template.json").write_text(json.dumps({"chat_template": template}))
    for name in ("processor_config.json", "chat_template.jinja"):
        (folder / name).unlink()
    chat = (Message("system", ("Be brief.",)), Message("user", ("What is it?", Image.new("RGB", (70, 42), "red"))))
    found = [encode(load_pretrained(name, device="cpu").processor, chat) for name in (tiny_folder, folder)]
    assert all(found[0][key].equal(found[1][key]) for key in ("input_ids", "pixel_values", "image_grid_thw"))


def test_a_chat_is_written_as_qwen_writes_it(tiny_folder):
    processor = load_pretrained(tiny_folder, device="cpu").processor
    chat = (Message("system", ("One.", "Two.")), Message("user", ("What?",)), Message("assistant", ("That.",)))
    said = processor.apply_chat_template(messages(chat), tokenize=False, add_generation_prompt=True)
    assert said == (
        "<|im_start|>system\nOne.\n\nTwo.<|im_end|>\n<|im_start|>user\nWhat?<|im_end|>\n"
        "<|im_start|>assistant\nThat.<|im_end|>\n<|im_start|>assistant\n"
    )


def test_training_reads_a_chat_as_it_is_read_at_run_time(tiny_folder):
    from PIL import Image

    prepare = pytest.importorskip("trl.data_utils").prepare_multimodal_messages
    processor = load_pretrained(tiny_folder, device="cpu").processor
    image = Image.new("RGB", (56, 56), "blue")
    chat = (Message("user", ("Place the <|chair|>.", image, "Thank you.")),)
    rows = [{**row, "content": [{"text": None, **part} for part in row["content"]]} for row in messages(chat)]
    trained = processor.apply_chat_template(
        prepare(rows, [image]), tokenize=True, add_generation_prompt=True, return_dict=True, return_tensors="pt"
    )
    shown = encode(processor, chat)
    assert trained["input_ids"].equal(shown["input_ids"])
    assert trained["pixel_values"].equal(shown["pixel_values"])


@pytest.mark.slow
def test_other_tools_in_the_process_read_it_without_torchvision(tiny_folder):
    code = (
        "from thinkblox.policies.processors import use_without_torchvision\n"
        "use_without_torchvision()\n"
        "from transformers import AutoProcessor\n"
        f"print(type(AutoProcessor.from_pretrained({str(tiny_folder)!r})).__module__)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "thinkblox.policies.processors"


def test_numbers_can_be_one_token_each(tmp_path):
    """With the space before them, whatever else is in the text; what is read is what was said."""
    size = TinySize(hidden=16, layers=1, heads=2, vocabulary=320, vision_hidden=16, vision_layers=1, numbers=True)
    read = load_pretrained(build_tiny(tmp_path, size=size, texts=TEXTS), device="cpu")
    tokenizer = read.processor.tokenizer
    for said in (" 1.25", " 0.0", " 9.9", " 90.0", " 270.0"):
        assert len(tokenizer.encode(f"at ({said},")) == len(tokenizer.encode("at (,")) + 1
    text = '"position": [ 1.25, 0.05, 12.345], at (3.1, -0.07) 180.0 and 7/12'
    assert tokenizer.decode(tokenizer.encode(text)) == text
    weight = read.model.get_input_embeddings().weight
    near, far = (weight[tokenizer.encode(said)[-1]] for said in (" 2.01", " 7.4"))
    here = weight[tokenizer.encode(" 2.0")[-1]]
    assert (here - near).norm() < (here - far).norm()
