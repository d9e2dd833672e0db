"""Pixel accuracy and intersection over union of class indices."""

import numpy as np

from semantic_slam_training.classes import IGNORE


class ConfusionMatrix:
    """Counts pixels by true (row) and predicted (column) class; ignored ones not at all."""

    def __init__(self, classes):
        self.counts = np.zeros((classes, classes), np.int64)

    def add(self, truth, predicted):
        """Arrays of one shape with class indices; `truth` may hold IGNORE."""
        counted = truth != IGNORE
        classes = len(self.counts)
        pairs = truth[counted].astype(np.int64) * classes + predicted[counted]
        self.counts += np.bincount(pairs, minlength=classes ** 2).reshape(classes, classes)

    def pixel_accuracy(self):
        """NaN without pixels."""
        total = self.counts.sum()
        return float(np.trace(self.counts) / total) if total else float("nan")

    def class_ious(self):
        """Per class; NaN for those that are neither true nor predicted anywhere."""
        correct = np.diag(self.counts)
        union = self.counts.sum(0) + self.counts.sum(1) - correct
        return np.divide(correct, union, out=np.full(len(correct), np.nan), where=union > 0)

    def mean_iou(self):
        """Over the classes that occur in the truth; NaN without any."""
        present = self.counts.sum(1) > 0
        return float(self.class_ious()[present].mean()) if present.any() else float("nan")
