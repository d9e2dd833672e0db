#!/usr/bin/python3
"""Trains YOLOv8 on rendered sets or a folder in YOLO's format; see training/README.md.

Prints progress, validates now and then, and keeps FOLDER/checkpoint.pt. Stopped (Ctrl-C, --minutes), the
same command goes on. export.py makes the network and its card of the checkpoint.
"""

import argparse
import pathlib

from semantic_slam_training.data.augmentation import Augmentation
from semantic_slam_training.data.input_format import unscaled_input
from semantic_slam_training.data.samples import DetectionSamples
from semantic_slam_training.data.sets import open_detection
from semantic_slam_training.engine import arguments as options
from semantic_slam_training.engine.network_spec import DETECTION, NetworkSpec
from semantic_slam_training.engine.runs import validation_roots
from semantic_slam_training.engine.tasks import DetectionTask
from semantic_slam_training.engine.trainer import Trainer
from semantic_slam_training.errors import run_command
from semantic_slam_training.models.yolov8 import SIZES, STRIDES

PIXEL_CLASSES = pathlib.Path(__file__).parent / "classes/indoor.yaml"
CLASSES = pathlib.Path(__file__).parent / "classes/furniture.yaml"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_data_arguments(parser, CLASSES)
    options.add_run_arguments(parser)
    parser.add_argument("--network", choices=[f"yolov8{size}" for size in SIZES], default="yolov8n",
                        help="(default: %(default)s)")
    parser.add_argument("--size", default="384x288", help="of the network's input [px] (default: %(default)s)")
    parser.add_argument("--pixel-classes", type=pathlib.Path, default=PIXEL_CLASSES, metavar="FILE.yaml",
                        help="of rendered sets the network learns what each pixel shows too (default: %(default)s)")
    options.add_setting_arguments(parser, steps=16000, batch_size=8, learning_rate=1e-3)
    return parser.parse_args()


def open_sets(arguments):
    """The training set and the one to validate on, or None."""
    training = open_detection(arguments.data, "train", arguments.classes, arguments.pixel_classes)
    held_out = validation_roots(arguments)
    return training, held_out and open_detection(held_out, "val", arguments.classes)


def main():
    arguments = parse_arguments()
    settings = options.settings_from(arguments)
    size = options.size_px(arguments.size)
    options.check_multiple(size, STRIDES[-1])
    training, validation = open_sets(arguments)
    frame = unscaled_input(*size)
    task = DetectionTask(DetectionSamples(training, frame, Augmentation(), settings.seed),
                         validation and DetectionSamples(validation, frame), settings)
    pixel_classes = len(training.pixel_classes.names) if training.pixel_classes else 0
    spec = NetworkSpec(DETECTION, arguments.network, 1.0, training.names, frame, pixel_classes=pixel_classes)
    trainer = Trainer(task, spec, settings, arguments.out, options.describe(arguments, f"{len(training)} images"))
    if arguments.start:
        trainer.start_from(arguments.start)
    trainer.run()


if __name__ == "__main__":
    run_command(main)
