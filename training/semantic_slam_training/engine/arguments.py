"""Command-line options that all training commands share."""

import dataclasses
import os
import pathlib

from semantic_slam_training.engine.settings import Settings
from semantic_slam_training.errors import TrainingError

SIZE_MULTIPLE_PX = 32


def size_px(text):
    """(width, height) of "320x256"."""
    try:
        width, height = (int(side) for side in text.lower().split("x"))
    except ValueError as error:
        raise TrainingError(f"--size {text}: expected WIDTHxHEIGHT") from error
    if min(width, height) < SIZE_MULTIPLE_PX:
        raise TrainingError(f"--size {text}: expected {SIZE_MULTIPLE_PX} px or more each way")
    return width, height


def check_multiple(size, multiple):
    if size[0] % multiple or size[1] % multiple:
        raise TrainingError(f"--size {size[0]}x{size[1]}: expected multiples of {multiple} px for this network")


def add_data_arguments(parser, classes):
    parser.add_argument("--data", required=True, nargs="+", metavar="PATH",
                        help="the training set, see training/README.md")
    parser.add_argument("--validation", nargs="+", metavar="PATH",
                        help="images to measure on; by default the data set's own split for that, if it has one")
    parser.add_argument("--classes", type=pathlib.Path, default=classes, metavar="FILE.yaml",
                        help="which labels are classes (default: %(default)s)")


def add_run_arguments(parser):
    parser.add_argument("--out", required=True, type=pathlib.Path, metavar="FOLDER",
                        help="where checkpoint.pt is; if it is there, training goes on from it")
    parser.add_argument("--start", type=pathlib.Path, metavar="FILE.pt",
                        help="checkpoint to begin with, such as those in models/, if FOLDER has none")


def add_class_balance_argument(parser):
    parser.add_argument("--class-balance", type=float, default=0.25, metavar="EXPONENT",
                        help="classes weigh by frequency to the power of -EXPONENT; 0: alike (default: %(default)s)")


def add_setting_arguments(parser, **defaults):
    """Options for all fields of Settings; `defaults` of those that differ or have none."""
    kinds = {"optimizer": str, "device": str, "precision": str, "minutes": float, "threads": int}
    for field in dataclasses.fields(Settings):
        default = defaults.get(field.name, field.default)
        kind = kinds.get(field.name, type(default))
        words = "" if default is None else " (default: %(default)s)"
        parser.add_argument(f"--{field.name.replace('_', '-')}", type=kind, default=default,
                            metavar=field.name.upper(), help=SETTING_HELP[field.name] + words)


SETTING_HELP = {
    "steps": "length of the whole training, over which the learning rate falls",
    "batch_size": "images a step",
    "learning_rate": "highest learning rate",
    "optimizer": "muon (and AdamW for what is no kernel), adamw or sgd",
    "weight_decay": "decay of weights",
    "warmup_steps": "steps over which the learning rate rises",
    "average_decay": "of the moving average of weights that is kept",
    "validate_every": "steps between validations",
    "validation_images": "images that a validation looks at",
    "checkpoint_every": "steps between checkpoints",
    "seed": "of weights, order and augmentation",
    "minutes": "stop after that time; the same command goes on later",
    "workers": "processes that read images, for GPUs",
    "threads": "cores to compute on (default: all)",
    "device": "cpu or cuda (default: cuda if there is one)",
    "precision": "full, or mixed: convolutions in bfloat16 (default: mixed where the hardware multiplies it)",
}


def settings_from(arguments):
    return Settings(**{field.name: getattr(arguments, field.name) for field in dataclasses.fields(Settings)})


def describe(arguments, amount):
    """Words on data and settings, for the model card. `amount` of data; of its paths only the last two names."""
    data = ", ".join(os.path.join(*pathlib.Path(path).resolve().parts[-2:]) for path in arguments.data)
    return (f"{amount} of {data}; batch {arguments.batch_size}, {arguments.optimizer}, learning rate "
            f"{arguments.learning_rate}, seed {arguments.seed}")
