"""Average precision of boxes, thesis eq. (4.7), and precision and recall, eq. (4.8)."""

import dataclasses

import numpy as np
import torch

from semantic_slam_training.losses.boxes import intersection_over_union

MATCH_IOU = 0.5
SUPPRESSION_IOU = 0.7
LEAST_SCORE = 0.001
MOST_CANDIDATES = 300


@dataclasses.dataclass(frozen=True)
class Boxes:
    """Found in one image: boxes n x 4 [px], scores n, classes n; the highest score first."""

    boxes: torch.Tensor
    scores: torch.Tensor
    classes: torch.Tensor


def suppress(boxes, classes):
    """Indices of boxes, sorted by falling score, that no better one of their class overlaps by over 0.7."""
    overlaps = intersection_over_union(boxes[:, None], boxes[None])
    rivals = ((overlaps > SUPPRESSION_IOU) & (classes[:, None] == classes[None])).numpy()
    kept = np.ones(len(boxes), bool)
    for index in range(len(boxes)):
        if kept[index]:
            kept[index + 1:] &= ~rivals[index, index + 1:]
    return torch.from_numpy(np.flatnonzero(kept))


def select_boxes(rows):
    """Of one image's output, (4 + classes) x cells as YoloV8Boxes gives it, the boxes that stand."""
    scores, classes = rows[4:].max(0)
    order = scores.argsort(descending=True, stable=True)[:MOST_CANDIDATES]
    order = order[scores[order] > LEAST_SCORE]
    centres, sizes = rows[:2, order].T, rows[2:4, order].T
    boxes = torch.cat([centres - sizes / 2, centres + sizes / 2], 1)
    kept = suppress(boxes, classes[order])
    return Boxes(boxes[kept], scores[order][kept], classes[order][kept])


def best_overlaps(boxes, others):
    """The intersection over union of each box with the one of the others that it overlaps most; 0 without any."""
    if len(others) == 0:
        return torch.zeros(len(boxes))
    return intersection_over_union(boxes[:, None], others[None]).amax(1)


def pass_over_optional(found, true_boxes, optional_boxes):
    """Without the boxes that show an object which may be found or not, rather than one that is to be found."""
    optional = best_overlaps(found.boxes, optional_boxes)
    kept = (optional < MATCH_IOU) | (optional <= best_overlaps(found.boxes, true_boxes))
    return Boxes(found.boxes[kept], found.scores[kept], found.classes[kept])


def match(found, true_boxes):
    """Whether each found box, in order, takes a true one that no better has taken: bool array."""
    taken = np.zeros(len(true_boxes), bool)
    hits = np.zeros(len(found), bool)
    if len(true_boxes) == 0:
        return hits
    overlaps = intersection_over_union(found[:, None], true_boxes[None]).numpy()
    for index, row in enumerate(overlaps):
        best = int(np.where(taken, -1.0, row).argmax())
        if not taken[best] and row[best] >= MATCH_IOU:
            taken[best] = hits[index] = True
    return hits


def precision_recall(scores, hits, truths):
    """Scores, precision and recall down to each score, the highest first. `truths`: number of true boxes."""
    order = np.argsort(-scores, kind="stable")
    true_positives = np.cumsum(hits[order])
    found = np.arange(1, len(order) + 1)
    return scores[order], true_positives / found, true_positives / max(truths, 1)


def average_precision(precision, recall):
    """Area below the curve, made monotonous (PASCAL VOC 2010)."""
    envelope = np.maximum.accumulate(precision[::-1])[::-1]
    return float(np.sum(np.diff(recall, prepend=0.0) * envelope))


class DetectionScore:
    """Collects found and true boxes image by image."""

    def __init__(self, classes):
        self.truths = np.zeros(classes, np.int64)
        self.scores = [[] for _ in range(classes)]
        self.hits = [[] for _ in range(classes)]

    def add(self, found, true_boxes, true_classes):
        """`found` as select_boxes() gives it; the truth: n x 4 [px] and n class indices."""
        for index in range(len(self.truths)):
            mine = found.classes == index
            truth = true_boxes[true_classes == index]
            self.truths[index] += len(truth)
            self.scores[index].append(found.scores[mine].numpy())
            self.hits[index].append(match(found.boxes[mine], truth))

    def curve(self, index):
        return precision_recall(np.concatenate(self.scores[index]), np.concatenate(self.hits[index]),
                                self.truths[index])

    def class_precisions(self):
        """Average precision at IoU 0.5 per class; NaN without true boxes."""
        return np.array([average_precision(*self.curve(index)[1:]) if count else np.nan
                         for index, count in enumerate(self.truths)])

    def operating_point(self):
        """Score threshold that is best for all classes together by F1, with precision and recall there."""
        present = np.flatnonzero(self.truths)
        thresholds = np.linspace(0.05, 0.95, 91)
        rates = np.array([self.rates_at(index, thresholds) for index in present])  # classes x 2 x thresholds
        precision, recall = rates.mean(0)
        best = int(np.argmax(2 * precision * recall / np.maximum(precision + recall, 1e-9)))
        return float(thresholds[best]), float(precision[best]), float(recall[best])

    def rates_at(self, index, thresholds):
        """Precision and recall of a class at each threshold; precision is 1 where nothing is found."""
        scores, precision, recall = self.curve(index)
        found = np.searchsorted(-scores, -thresholds, side="right")
        return np.r_[1.0, precision][found], np.r_[0.0, recall][found]

    def metrics(self):
        if not self.truths.any():
            return {"map50": float("nan"), "precision": float("nan"), "recall": float("nan"), "threshold": 0.5}
        threshold, precision, recall = self.operating_point()
        return {"map50": float(np.nanmean(self.class_precisions())), "precision": precision, "recall": recall,
                "threshold": threshold}
