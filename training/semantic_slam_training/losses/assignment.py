"""Which cells are to find which object: task-aligned assignment (TOOD, Feng et al., 2021)."""

import dataclasses

import torch

from semantic_slam_training.losses.boxes import intersection_over_union

SCORE_POWER = 0.5
OVERLAP_POWER = 6.0
CELLS_PER_OBJECT = 10
EPSILON = 1e-9


@dataclasses.dataclass(frozen=True)
class Objects:
    """The true objects of a batch, padded to as many as the fullest image has.

    boxes: batch x objects x 4 [px], classes: batch x objects (int64); present and optional: batch x objects
    (bool): those that are to be found, and those that may be found or not, whatever their class.
    """

    boxes: torch.Tensor
    classes: torch.Tensor
    present: torch.Tensor
    optional: torch.Tensor


@dataclasses.dataclass(frozen=True)
class Targets:
    """What each cell is to give.

    foreground: batch x cells (bool); boxes: batch x cells x 4 [px] and scores: batch x cells x classes,
    both meaningless or 0 where a cell has no object.
    """

    foreground: torch.Tensor
    boxes: torch.Tensor
    scores: torch.Tensor


def cells_inside(centres, boxes):
    """batch x objects x cells (bool): whether a cell's centre lies in the box."""
    low = centres - boxes[:, :, None, :2]
    high = boxes[:, :, None, 2:] - centres
    return torch.cat([low, high], -1).amin(-1) > EPSILON


def alignment(scores, overlaps, objects):
    """batch x objects x cells: how well a cell's score and box together fit an object."""
    classes = objects.classes[:, :, None].expand(-1, -1, scores.shape[1])
    score_of_class = scores.transpose(1, 2).gather(1, classes)
    return score_of_class.pow(SCORE_POWER) * overlaps.pow(OVERLAP_POWER)


def best_cells(aligned, allowed):
    """Of the allowed cells the 10 best aligned of each object: batch x objects x cells (bool)."""
    count = min(CELLS_PER_OBJECT, aligned.shape[-1])
    ranked = torch.where(allowed, aligned, torch.full_like(aligned, -1.0))
    chosen = torch.zeros_like(allowed).scatter_(-1, ranked.topk(count).indices, True)
    return chosen & allowed


def keep_one_object(chosen, overlaps):
    """A cell that several objects chose goes to the one that its box overlaps most."""
    contested = chosen.sum(1, keepdim=True) > 1
    overlap_of_chosen = torch.where(chosen, overlaps, torch.full_like(overlaps, -1.0))
    winner = torch.zeros_like(chosen).scatter_(1, overlap_of_chosen.argmax(1, keepdim=True), True)
    return torch.where(contested, winner & chosen, chosen)


def soft_scores(aligned, overlaps, chosen):
    """batch x objects x cells: alignment, scaled so that an object's best cell has its best overlap."""
    aligned = aligned * chosen
    best_aligned = aligned.amax(-1, keepdim=True)
    best_overlap = (overlaps * chosen).amax(-1, keepdim=True)
    return aligned * best_overlap / (best_aligned + EPSILON)


def cells_in_optional(centres, objects):
    """batch x cells (bool): whether a cell's centre lies in an object that may be found or not."""
    return (cells_inside(centres, objects.boxes) & objects.optional[:, :, None]).any(1)


@torch.no_grad()
def assign(scores, boxes, centres, objects):
    """Assigns objects to cells.

    scores: batch x cells x classes, probabilities; boxes: batch x cells x 4 [px], both as predicted;
    centres: cells x 2 [px].
    """
    batch, cells, classes = scores.shape
    if objects.boxes.shape[1] == 0:
        return Targets(torch.zeros(batch, cells, dtype=torch.bool, device=scores.device),
                       torch.zeros_like(boxes), torch.zeros_like(scores))
    overlaps = intersection_over_union(objects.boxes[:, :, None], boxes[:, None])
    aligned = alignment(scores, overlaps, objects)
    allowed = cells_inside(centres, objects.boxes) & objects.present[:, :, None]
    chosen = keep_one_object(best_cells(aligned, allowed), overlaps)
    owner = chosen.int().argmax(1)
    foreground = chosen.any(1)
    strength = soft_scores(aligned, overlaps, chosen).amax(1)
    target_scores = torch.zeros_like(scores).scatter_(
        2, objects.classes.gather(1, owner)[:, :, None], strength[:, :, None])
    target_boxes = objects.boxes.gather(1, owner[:, :, None].expand(-1, -1, 4))
    return Targets(foreground, target_boxes, target_scores * foreground[:, :, None])
