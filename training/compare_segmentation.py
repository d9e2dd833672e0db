#!/usr/bin/python3
"""Trains six segmentation networks alike, thesis Fig. 4.6, and puts accuracy, size and speed side by side.

All see the same images in the same order, changed alike, for the same number of steps. Leaves comparison.json,
comparison.md and comparison.png in FOLDER. Stopped, the same command goes on.
"""

import argparse
import pathlib

from semantic_slam_training.data.input_format import InputFormat
from semantic_slam_training.engine import arguments as options
from semantic_slam_training.engine.class_balance import count_pixels
from semantic_slam_training.engine.runs import open_segmentation_sets, segmentation_trainer
from semantic_slam_training.engine.trainer import latest_figures
from semantic_slam_training.errors import TrainingError, run_command
from semantic_slam_training.export.comparison import Result, markdown, write_comparison
from semantic_slam_training.export.onnx_file import check_agreement, deployed, opencv_milliseconds, write_onnx
from semantic_slam_training.losses.segmentation import class_weights
from semantic_slam_training.models.layers import parameter_count
from semantic_slam_training.models.segmentation import NETWORKS, SIZE_MULTIPLE_PX

CLASSES = pathlib.Path(__file__).parent / "classes/indoor.yaml"
COMPARED = ("pspnet_resnet18", "icnet", "segnet", "unet", "frrn", "fcn8s")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_data_arguments(parser, CLASSES)
    parser.add_argument("--out", required=True, type=pathlib.Path, metavar="FOLDER",
                        help="for checkpoints and results")
    parser.add_argument("--networks", nargs="+", choices=NETWORKS, default=COMPARED, help="(default: %(default)s)")
    parser.add_argument("--width", type=float, default=0.25, help="times the papers' channels (default: %(default)s)")
    parser.add_argument("--size", default="128x96", help="of the networks' input [px] (default: %(default)s)")
    options.add_class_balance_argument(parser)
    options.add_setting_arguments(parser, steps=600, batch_size=8, learning_rate=2e-3, warmup_steps=50,
                                  average_decay=0.99, validate_every=200, checkpoint_every=100)
    return parser.parse_args()


def measure(trainer, folder):
    """Result of a network that was trained to the end."""
    state = trainer.state
    network, onnx = deployed(state.average, state.spec), folder / "network.onnx"
    write_onnx(network, state.spec, onnx)
    check_agreement(network, state.spec, onnx)
    figures = latest_figures(state.history)
    return Result(state.spec.architecture, figures["pixel_accuracy"], figures["mean_iou"], parameter_count(network),
                  opencv_milliseconds(onnx, state.spec), state.seconds)


def train_all(arguments, settings, sets):
    """Results of all networks; fewer if time was up before."""
    weights = class_weights(count_pixels(sets[0]), arguments.class_balance)
    frame, results = InputFormat(*options.size_px(arguments.size)), []
    for name in arguments.networks:
        print(name)
        trainer = segmentation_trainer(name, arguments.width, frame, sets, settings, weights, arguments.out / name,
                                       options.describe(arguments, f"{len(sets[0])} images"))
        trainer.run()
        if not trainer.is_finished():
            break
        results.append(measure(trainer, arguments.out / name))
    return results


def main():
    arguments = parse_arguments()
    options.check_multiple(options.size_px(arguments.size), SIZE_MULTIPLE_PX)
    sets = open_segmentation_sets(arguments)
    if sets[1] is None:
        raise TrainingError("--validation: expected a set to compare on")
    results = train_all(arguments, options.settings_from(arguments), sets)
    if len(results) == len(arguments.networks):
        write_comparison(arguments.out, results)
        print(markdown(results), end="")


if __name__ == "__main__":
    run_command(main)
