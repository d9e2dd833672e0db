"""How often each class occurs."""

import numpy as np

from semantic_slam_training.classes import IGNORE
from semantic_slam_training.data.batches import spread
from semantic_slam_training.errors import TrainingError

IMAGES_COUNTED = 200  # evenly spread over the set


def count_pixels(dataset):
    """Pixels of each class in some images of a segmentation set, one in 16."""
    counts = np.zeros(IGNORE + 1, np.int64)
    for index in spread(len(dataset), IMAGES_COUNTED):
        counts += np.bincount(dataset.read(int(index))[1][::4, ::4].ravel(), minlength=IGNORE + 1)
    counts = counts[:len(dataset.names)]
    if not counts.any():
        raise TrainingError(f"no pixel of the training set is of a class: {', '.join(dataset.names)}")
    return counts
