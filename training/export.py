#!/usr/bin/python3
"""Makes of a checkpoint what the package runs: NAME.onnx, NAME.names, the model card NAME.yaml, and NAME.pt, a
checkpoint in half precision from which training can go on (--start).

The ONNX file has the weights as NAME.pt has them, so it can be made of that again. Fails if OpenCV does not compute
the same from it as torch. The card tells how the network did in validation, or with --evaluation what
evaluate_segmentation, evaluate_detection or evaluate_appearance.py measured.
"""

import argparse
import pathlib

from semantic_slam_training.engine import checkpoint
from semantic_slam_training.engine.network_spec import NetworkSpec
from semantic_slam_training.engine.trainer import latest_figures
from semantic_slam_training.errors import run_command
from semantic_slam_training.export.model_card import (
    MEASURED, VALIDATED, Figures, flat_figures, read_evaluation, sha256, write_card)
from semantic_slam_training.export.onnx_file import check_agreement, deployed, write_onnx
from semantic_slam_training.models.layers import parameter_count

MODELS = pathlib.Path(__file__).resolve().parents[1] / "models"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkpoint", type=pathlib.Path, metavar="CHECKPOINT.pt")
    parser.add_argument("--name", required=True, help="of the network, such as pspnet_indoor")
    parser.add_argument("--evaluation", type=pathlib.Path, metavar="FILE.json",
                        help="segmentation.json, detection.json or appearance.json of an evaluation of this network")
    parser.add_argument("--out", type=pathlib.Path, default=MODELS, metavar="FOLDER", help="(default: %(default)s)")
    return parser.parse_args()


def load_network(content):
    """The network of a checkpoint, in evaluation mode, and its spec."""
    spec = NetworkSpec.from_dict(content["spec"])
    network = spec.build()
    network.load_state_dict(checkpoint.full_weights(content))
    return deployed(network, spec), spec


def export(content, name, folder, measured=None):
    """Writes the four files; returns a line on them. `measured`: content of an evaluation's JSON file."""
    folder.mkdir(parents=True, exist_ok=True)
    content = checkpoint.half_of(content)
    network, spec = load_network(content)
    onnx = folder / f"{name}.onnx"
    write_onnx(network, spec, onnx)
    difference = check_agreement(network, spec, onnx)
    if spec.classes:
        (folder / f"{name}.names").write_text("".join(f"{each}\n" for each in spec.classes))
    figures = Figures(MEASURED, flat_figures(measured)) if measured else Figures(
        VALIDATED, latest_figures(content["history"]))
    write_card(folder / f"{name}.yaml", name, spec, content, figures, sha256(onnx))
    checkpoint.save(folder / f"{name}.pt", content)
    return (f"{folder / name}.yaml: {parameter_count(network) / 1e6:.2f} M parameters, "
            f"{onnx.stat().st_size / 1e6:.1f} MB, OpenCV differs from torch by {difference:.1g}")


def main():
    arguments = parse_arguments()
    measured = read_evaluation(arguments.evaluation) if arguments.evaluation else None
    print(export(checkpoint.load(arguments.checkpoint), arguments.name, arguments.out, measured))


if __name__ == "__main__":
    run_command(main)
