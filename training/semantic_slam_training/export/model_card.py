"""Model cards, docs/models.md, and the files beside them."""

import dataclasses
import hashlib
import json
import textwrap

import yaml

from semantic_slam_training.classes import read_vocabulary
from semantic_slam_training.data.input_format import GREY_LEVELS
from semantic_slam_training.engine.network_spec import APPEARANCE, DETECTION, SEGMENTATION
from semantic_slam_training.errors import TrainingError
from semantic_slam_training.export.onnx_file import INPUT_NAME, OUTPUT_NAMES

LICENCE = "BSD-3-Clause"
HEADS = {
    SEGMENTATION: {"type": "segmentation", "activation": "softmax"},
    DETECTION: {"type": "yolo", "box": "cxcywh", "units": "pixels", "objectness": "none", "transposed": True},
    APPEARANCE: {"type": "reid"},
}


VALIDATED = "Validation in training, images of the network's size:"
MEASURED = "Measured on images that training has not seen, as docs/evaluation.md says:"
# Of an evaluation's numbers per class the one that the card tells.
CLASS_FIGURES = ("iou", "ap50")


@dataclasses.dataclass(frozen=True)
class Figures:
    """How well a network does: numbers by name, or None, and a line on where they come from."""

    source: str
    values: dict


def read_evaluation(path):
    """The content of an evaluation's JSON file."""
    try:
        content = json.loads(path.read_text())
    except (json.JSONDecodeError, UnicodeDecodeError) as error:
        raise TrainingError(f"{path}: not JSON: {error}") from error
    if not isinstance(content, dict) or not flat_figures(content):
        raise TrainingError(f"{path}: not the result of an evaluation: there are no numbers in it")
    return content


def flat_figures(measured):
    """Name -> number of an evaluation: its means, those at the best threshold, and one per class."""
    figures = {name: value for name, value in measured.items() if isinstance(value, float)}
    figures.update(measured.get("at_best_f1") or {})
    for name, of_class in (measured.get("classes") or {}).items():
        figures.update({f"{key}_{name}": of_class[key] for key in CLASS_FIGURES if key in of_class})
    return {name: value for name, value in figures.items() if isinstance(value, float)}


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
    sizes = [f", to step {entry['step']} at {entry['input'][0]}x{entry['input'][1]} px"
             for entry in content["history"] if "input" in entry]
    lines = textwrap.wrap(f"{spec.architecture}{width}, trained from random weights by training/train_{spec.task}.py: "
                          f"{content['step']} steps in {content['seconds'] / 3600:.1f} h on {content['about']}"
                          f"{''.join(sizes)}.", 106)
    if figures.values is None:
        lines.append("Not validated.")
    else:
        lines += [figures.source, *figures_lines(figures.values)]
    return "".join(f"# {line}".rstrip() + "\n" for line in lines)


def write_card(path, name, spec, content, figures, digest):
    """`content`: the checkpoint's."""
    card = yaml.safe_dump(card_content(name, spec, digest), sort_keys=False, default_flow_style=None, width=106)
    path.write_text(comment(spec, content, figures) + card)
