"""Model cards, docs/models.md, and the files beside them."""

import hashlib
import textwrap

import yaml

from semantic_slam_training.classes import read_vocabulary
from semantic_slam_training.data.input_format import GREY_LEVELS
from semantic_slam_training.engine.network_spec import APPEARANCE, DETECTION, SEGMENTATION
from semantic_slam_training.export.onnx_file import INPUT_NAME, OUTPUT_NAMES

LICENCE = "BSD-3-Clause"
HEADS = {
    SEGMENTATION: {"type": "segmentation", "activation": "softmax"},
    DETECTION: {"type": "yolo", "box": "cxcywh", "units": "pixels", "objectness": "none", "transposed": True},
    APPEARANCE: {"type": "reid"},
}


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def vocabulary_names(classes):
    """Class -> label, where the label's name is another; "coffee table" is coffee_table."""
    vocabulary = read_vocabulary()
    plain = {name: name.strip().lower().replace(" ", "_").replace("-", "_") for name in classes}
    return {name: label for name, label in plain.items() if name != label and label in vocabulary}


def card_content(name, spec, digest):
    """The card's keys and values, in the order of docs/models.md."""
    frame = spec.input
    content = {
        "file": f"{name}.onnx",
        "sha256": digest,
        "licence": LICENCE,
        "input": {"name": INPUT_NAME, "width": frame.width, "height": frame.height, "colour": "rgb",
                  "scale": round(1 / GREY_LEVELS, 11), "mean": list(frame.mean), "std": list(frame.std),
                  "fit": "letterbox", "pad": frame.pad},
        "outputs": [OUTPUT_NAMES[spec.task]],
        "head": HEADS[spec.task],
    }
    if spec.classes:
        content["labels"] = {"file": f"{name}.names"}
        mapped = vocabulary_names(spec.classes)
        if mapped:
            content["labels"]["map"] = mapped
    return content


def figures_lines(figures):
    """Two figures a line would be hard to read: one each, rounded."""
    return [f"  {name}: {value:.4f}" for name, value in figures.items()]


def comment(spec, content, figures):
    """What was trained on what, for how long, and how well it does."""
    width = f" of width {spec.width:g}" if spec.task != DETECTION else ""
    lines = textwrap.wrap(f"{spec.architecture}{width}, trained from random weights by training/train_{spec.task}.py: "
                          f"{content['step']} steps in {content['seconds'] / 3600:.1f} h on {content['about']}.", 106)
    if figures is None:
        lines.append("Not validated.")
    else:
        lines += ["Validation, images of the network's size:", *figures_lines(figures)]
    return "".join(f"# {line}".rstrip() + "\n" for line in lines)


def write_card(path, name, spec, content, figures, digest):
    """`content`: the checkpoint's; `figures`: its latest validation's, or None."""
    card = yaml.safe_dump(card_content(name, spec, digest), sort_keys=False, default_flow_style=None, width=106)
    path.write_text(comment(spec, content, figures) + card)
