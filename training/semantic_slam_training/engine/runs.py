"""Puts together what one training run of a segmentation network needs."""

from semantic_slam_training.data.augmentation import Augmentation
from semantic_slam_training.data.samples import SegmentationSamples
from semantic_slam_training.data.sets import has_both_splits, open_segmentation
from semantic_slam_training.engine.network_spec import SEGMENTATION, NetworkSpec
from semantic_slam_training.engine.tasks import SegmentationTask
from semantic_slam_training.engine.trainer import Trainer
from semantic_slam_training.models.segmentation import FULL_SIZE

COARSE_LABEL_STRIDE = 2  # of labels that coarse scores learn from: the loss takes a third of a step's time else


def validation_roots(arguments):
    """What --validation names, else the data set itself if it has a split for that, else None."""
    return arguments.validation or (arguments.data if has_both_splits(arguments.data) else None)


def open_segmentation_sets(arguments):
    """The training set and the one to validate on, or None."""
    training = open_segmentation(arguments.data, "train", arguments.classes)
    held_out = validation_roots(arguments)
    return training, held_out and open_segmentation(held_out, "test", arguments.classes)


def segmentation_trainer(architecture, width, frame, sets, settings, weights, folder, about):
    """`sets` as open_segmentation_sets() gives them; `weights` of the classes; `frame`: an InputFormat."""
    training, validation = sets
    label_stride = 1 if architecture in FULL_SIZE else COARSE_LABEL_STRIDE
    task = SegmentationTask(SegmentationSamples(training, frame, Augmentation(), settings.seed, label_stride),
                            validation and SegmentationSamples(validation, frame), settings, weights)
    spec = NetworkSpec(SEGMENTATION, architecture, width, training.names, frame)
    return Trainer(task, spec, settings, folder, about)
