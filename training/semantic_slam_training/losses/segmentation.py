"""Cross entropy of class scores, with ignored pixels, class weights and auxiliary heads."""

import numpy as np
import torch
from torch.nn import functional

from semantic_slam_training.classes import IGNORE
from semantic_slam_training.models.layers import resize

AUXILIARY_WEIGHT = 0.4  # PSPNet's


def class_weights(pixel_counts, exponent):
    """Weights that go with frequency to the power of -`exponent`; their mean over all pixels is 1.

    pixel_counts: pixels of each class in the training set. 0 weighs all alike; a class without pixels
    weighs 1.
    """
    counts = np.asarray(pixel_counts, np.float64)
    present = counts > 0
    weights = np.ones_like(counts)
    weights[present] = (counts[present] / counts.sum()) ** -exponent
    weights[present] *= counts.sum() / (weights * counts).sum()
    return torch.tensor(weights, dtype=torch.float32)


def cross_entropy(scores, labels, weights=None):
    """Mean over the pixels that are not ignored; 0 if all are.

    scores: batch x classes x h x w at any stride; labels: batch x height x width, int64.
    """
    scores = resize(scores.float(), labels.shape[1:])
    losses = functional.cross_entropy(scores, labels, weights, ignore_index=IGNORE, reduction="none")
    return losses.sum() / (labels != IGNORE).sum().clamp(min=1)


def segmentation_loss(all_scores, labels, weights=None):
    """The loss of the first scores, and 0.4 of that of each auxiliary head, by name."""
    main, *auxiliary = [cross_entropy(scores, labels, weights) for scores in all_scores]
    parts = {"cross_entropy": main}
    if auxiliary:
        parts["auxiliary"] = AUXILIARY_WEIGHT * sum(auxiliary)
    return parts
