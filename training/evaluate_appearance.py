#!/usr/bin/python3
"""Measures, in OpenCV, how well an appearance network tells objects apart on rendered sets.

Prints the chance that two crops of one object look more alike than crops of two (AUC of the cosines of all pairs).
"""

import argparse
import json
import pathlib

import numpy as np

from semantic_slam_training.classes import read_yaml
from semantic_slam_training.data.batches import load_in_order
from semantic_slam_training.data.input_format import InputFormat
from semantic_slam_training.data.samples import AppearanceSamples
from semantic_slam_training.data.sets import open_objects
from semantic_slam_training.errors import TrainingError, run_command
from semantic_slam_training.evaluation.appearance_metrics import separation
from semantic_slam_training.export.onnx_file import load_in_opencv

CLASSES = pathlib.Path(__file__).parent / "classes/appearance.yaml"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sets", nargs="+", metavar="SET", help="rendered sets, see training/README.md")
    parser.add_argument("--card", required=True, type=pathlib.Path, metavar="CARD.yaml", help="the network's card")
    parser.add_argument("--classes", type=pathlib.Path, default=CLASSES, metavar="FILE.yaml",
                        help="objects that are told apart (default: %(default)s)")
    parser.add_argument("--crops", type=int, default=2000, help="at most, evenly spread (default: %(default)s)")
    parser.add_argument("--least-side", type=int, default=32, metavar="PX",
                        help="of an object's box for it to be looked at (default: %(default)s)")
    parser.add_argument("--output", type=pathlib.Path, metavar="FOLDER", help="write appearance.json there")
    return parser.parse_args()


def read_card(path):
    """The network in OpenCV and what it wants to see."""
    card = read_yaml(path)
    if (card.get("head") or {}).get("type") != "reid":
        raise TrainingError(f"{path}: expected the card of an appearance network, with head: {{type: reid}}")
    frame = card["input"]
    return (load_in_opencv(path.parent / card["file"]),
            InputFormat(frame["width"], frame["height"], tuple(frame["mean"]), tuple(frame["std"]), frame["pad"]))


def embed(net, samples, most):
    """Vectors and object numbers of at most so many crops."""
    vectors, identities = [], []
    for crops, numbers in load_in_order(samples, 1, most):
        net.setInput(crops.numpy())
        vectors.append(net.forward().reshape(1, -1))
        identities.append(numbers.numpy())
    return np.concatenate(vectors), np.concatenate(identities)


def main():
    arguments = parse_arguments()
    if arguments.crops < 2:
        raise TrainingError(f"--crops {arguments.crops}: expected 2 or more")
    net, frame = read_card(arguments.card)
    objects = open_objects(arguments.sets, arguments.classes, arguments.least_side)
    vectors, identities = embed(net, AppearanceSamples(objects, frame), arguments.crops)
    result = {"crops": len(vectors), "objects": len(np.unique(identities)), "auc": separation(vectors, identities)}
    print(f"{result['crops']} crops of {result['objects']} objects: AUC {result['auc']:.4f}")
    if arguments.output:
        arguments.output.mkdir(parents=True, exist_ok=True)
        (arguments.output / "appearance.json").write_text(json.dumps(result, indent=2) + "\n")


if __name__ == "__main__":
    run_command(main)
