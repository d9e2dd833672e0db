#!/usr/bin/python3
"""Trains the network that tells objects apart by their looks, on rendered sets; see training/README.md.

Prints progress, validates now and then, and keeps FOLDER/checkpoint.pt. Stopped (Ctrl-C, --minutes), the
same command goes on. export.py makes the network and its card of the checkpoint.
"""

import argparse
import pathlib

from semantic_slam_training.data.augmentation import Augmentation
from semantic_slam_training.data.input_format import InputFormat
from semantic_slam_training.data.samples import AppearanceSamples
from semantic_slam_training.data.sets import open_objects
from semantic_slam_training.engine import arguments as options
from semantic_slam_training.engine.network_spec import APPEARANCE, NetworkSpec
from semantic_slam_training.engine.tasks import AppearanceTask
from semantic_slam_training.engine.trainer import Trainer
from semantic_slam_training.errors import run_command

CLASSES = pathlib.Path(__file__).parent / "classes/appearance.yaml"
# Crops are already about the object: they are shifted and scaled little.
AUGMENTATION = Augmentation(least_scale=0.85, most_scale=1.2)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_data_arguments(parser, CLASSES)
    options.add_run_arguments(parser)
    parser.add_argument("--width", type=float, default=0.5, help="times 32 to 256 channels (default: %(default)s)")
    parser.add_argument("--size", default="96x96", help="of the network's input [px] (default: %(default)s)")
    parser.add_argument("--least-side", type=int, default=32, metavar="PX",
                        help="of an object's box for it to be looked at (default: %(default)s)")
    options.add_setting_arguments(parser, steps=6000, batch_size=32, learning_rate=2e-3, validation_images=1000)
    return parser.parse_args()


def open_sets(arguments):
    """The training set and the one to validate on, or None."""
    training = open_objects(arguments.data, arguments.classes, arguments.least_side)
    held_out = arguments.validation
    return training, held_out and open_objects(held_out, arguments.classes, arguments.least_side)


def main():
    arguments = parse_arguments()
    settings = options.settings_from(arguments)
    frame = InputFormat(*options.size_px(arguments.size))
    training, validation = open_sets(arguments)
    task = AppearanceTask(AppearanceSamples(training, frame, AUGMENTATION, settings.seed),
                          validation and AppearanceSamples(validation, frame), settings)
    identities = int(training.identities.max()) + 1
    spec = NetworkSpec(APPEARANCE, "appearance", arguments.width, (), frame, identities)
    about = options.describe(arguments, f"{len(training)} crops of {identities} objects")
    trainer = Trainer(task, spec, settings, arguments.out, about)
    if arguments.start:
        trainer.start_from(arguments.start)
    trainer.run()


if __name__ == "__main__":
    run_command(main)
