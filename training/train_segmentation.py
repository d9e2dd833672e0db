#!/usr/bin/python3
"""Trains a segmentation network on rendered sets or SUN RGB-D; see training/README.md.

Prints progress, validates now and then, and keeps FOLDER/checkpoint.pt. Stopped (Ctrl-C, --minutes), the
same command goes on. export.py makes the network and its card of the checkpoint.
"""

import argparse
import pathlib

from semantic_slam_training.data.input_format import InputFormat
from semantic_slam_training.engine import arguments as options
from semantic_slam_training.engine.class_balance import count_pixels
from semantic_slam_training.engine.runs import open_segmentation_sets, segmentation_trainer
from semantic_slam_training.errors import run_command
from semantic_slam_training.losses.segmentation import class_weights
from semantic_slam_training.models.segmentation import NETWORKS, SIZE_MULTIPLE_PX

CLASSES = pathlib.Path(__file__).parent / "classes/indoor.yaml"
PSPNET_MULTIPLE_PX = 8


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_data_arguments(parser, CLASSES)
    options.add_run_arguments(parser)
    parser.add_argument("--network", choices=NETWORKS, default="pspnet_resnet18", help="(default: %(default)s)")
    parser.add_argument("--width", type=float, default=0.375, help="times the paper's channels (default: %(default)s)")
    parser.add_argument("--size", default="320x240", help="of the network's input [px] (default: %(default)s)")
    options.add_class_balance_argument(parser)
    options.add_setting_arguments(parser, steps=16000, batch_size=8, learning_rate=2e-3)
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    settings = options.settings_from(arguments)
    size = options.size_px(arguments.size)
    is_pspnet = arguments.network.startswith("pspnet")
    options.check_multiple(size, PSPNET_MULTIPLE_PX if is_pspnet else SIZE_MULTIPLE_PX)
    sets = open_segmentation_sets(arguments)
    weights = class_weights(count_pixels(sets[0]), arguments.class_balance)
    trainer = segmentation_trainer(arguments.network, arguments.width, InputFormat(*size), sets, settings, weights,
                                   arguments.out, options.describe(arguments, f"{len(sets[0])} images"))
    if arguments.start:
        trainer.start_from(arguments.start)
    trainer.run()


if __name__ == "__main__":
    run_command(main)
