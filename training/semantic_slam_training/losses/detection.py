"""YOLOv8's loss: cross entropy of the classes, CIoU and distribution focal loss of the boxes."""

import torch
from torch.nn import functional

from semantic_slam_training.losses.assignment import assign, cells_in_optional
from semantic_slam_training.losses.boxes import complete_iou
from semantic_slam_training.models.yolov8 import BINS

BOX_WEIGHT = 7.5
CLASS_WEIGHT = 0.5
DISTRIBUTION_WEIGHT = 1.5
LARGEST_DISTANCE = BINS - 1.01  # [cells]; there must be a bin above


def distances_to(boxes, centres, strides):
    """From cells' centres to the sides of boxes [cells]: ... x cells x 4."""
    distances = torch.cat([centres - boxes[..., :2], boxes[..., 2:] - centres], -1)
    return distances / strides[:, None]


def decode(sides, centres, strides):
    """Boxes [px], batch x cells x 4, of logits batch x cells x 4 x bins."""
    bins = torch.arange(BINS, dtype=sides.dtype, device=sides.device)
    distances = (sides.softmax(-1) * bins).sum(-1) * strides[:, None]
    return torch.cat([centres - distances[..., :2], centres + distances[..., 2:]], -1)


def distribution_focal_loss(sides, distances):
    """Generalised focal loss (Li et al., 2020, eq. 6), averaged over the four sides: one value per cell.

    sides: cells x 4 x bins, logits; distances: cells x 4 [cells], what they are to give.
    """
    distances = distances.clamp(0, LARGEST_DISTANCE)
    below = distances.long()
    share_above = distances - below
    log_likelihoods = sides.log_softmax(-1)
    at_below = log_likelihoods.gather(-1, below[..., None])[..., 0]
    at_above = log_likelihoods.gather(-1, below[..., None] + 1)[..., 0]
    return -(at_below * (1 - share_above) + at_above * share_above).mean(-1)


def detection_loss(sides, scores, objects, centres, strides):
    """The three parts of the loss, weighted, by name. Each is per image's worth of assigned scores. Cells in an
    optional object that find no other may have any score.

    sides: batch x (4 x bins) x cells and scores: batch x classes x cells, as YoloV8 gives them; centres
    [px] and strides [px] as cell_centres() does.
    """
    sides = sides.float().unflatten(1, (4, BINS)).permute(0, 3, 1, 2)
    scores = scores.float().transpose(1, 2)
    boxes = decode(sides, centres, strides)
    targets = assign(scores.detach().sigmoid(), boxes.detach(), centres, objects)
    total = targets.scores.sum().clamp(min=1)
    found = targets.foreground
    weights = targets.scores.sum(-1)[found]
    overlaps = complete_iou(boxes[found], targets.boxes[found])
    wanted = distances_to(targets.boxes, centres, strides)[found]
    judged = found | ~cells_in_optional(centres, objects)
    classes = functional.binary_cross_entropy_with_logits(scores[judged], targets.scores[judged], reduction="sum")
    return {
        "box": BOX_WEIGHT * ((1 - overlaps) * weights).sum() / total,
        "class": CLASS_WEIGHT * classes / total,
        "distribution": DISTRIBUTION_WEIGHT * (distribution_focal_loss(sides[found], wanted) * weights).sum() / total,
    }
