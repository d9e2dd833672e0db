"""losses/detection.py: whoever makes the loss small finds the object."""

import needs_torch  # noqa: F401
import pytest
import torch

from semantic_slam_training.losses.assignment import Objects
from semantic_slam_training.losses.boxes import intersection_over_union
from semantic_slam_training.losses.detection import decode, detection_loss
from semantic_slam_training.models.yolov8 import BINS, cell_centres

TRUTH = torch.tensor([[[20.0, 12.0, 46.0, 34.0]]])
CENTRES, STRIDES = cell_centres(64, 64)


def one_object():
    return Objects(TRUTH, torch.tensor([[1]]), torch.tensor([[True]]), torch.tensor([[False]]))


def descend(objects, steps):
    """Free outputs of a network for one image, moved down the loss: sides and scores."""
    sides = torch.zeros(1, 4 * BINS, len(CENTRES), requires_grad=True)
    scores = torch.full((1, 2, len(CENTRES)), -4.0, requires_grad=True)
    optimizer = torch.optim.Adam([sides, scores], lr=0.1)
    for _ in range(steps):
        optimizer.zero_grad()
        sum(detection_loss(sides, scores, objects, CENTRES, STRIDES).values()).backward()
        optimizer.step()
    return sides.detach(), scores.detach()


def test_descent_ends_at_the_object():
    sides, scores = descend(one_object(), steps=200)
    likelihoods = scores[0].sigmoid()
    best = int(likelihoods[1].argmax())
    boxes = decode(sides.unflatten(1, (4, BINS)).permute(0, 3, 1, 2), CENTRES, STRIDES)
    assert float(intersection_over_union(boxes[0, best], TRUTH[0, 0])) > 0.9
    assert float(likelihoods[1, best]) > 0.7
    assert float(likelihoods[0].max()) < 0.1  # there is nothing of the other class


def test_without_objects_only_scores_count():
    none = torch.zeros(1, 0, dtype=torch.bool)
    nothing = Objects(torch.zeros(1, 0, 4), torch.zeros(1, 0, dtype=torch.int64), none, none)
    parts = detection_loss(torch.zeros(1, 4 * BINS, len(CENTRES)), torch.zeros(1, 2, len(CENTRES)), nothing, CENTRES,
                           STRIDES)
    assert float(parts["box"]) == float(parts["distribution"]) == 0.0
    # Each of the scores is undecided; nothing is assigned, so they are divided by 1.
    assert float(parts["class"]) == pytest.approx(0.5 * 2 * len(CENTRES) * 0.693147, rel=1e-5)


def test_an_optional_object_may_be_found_or_not():
    optional = Objects(TRUTH, torch.tensor([[0]]), torch.tensor([[False]]), torch.tensor([[True]]))
    inside = ((CENTRES > TRUTH[0, 0, :2]) & (CENTRES < TRUTH[0, 0, 2:])).all(1)
    scores = torch.zeros(1, 2, len(CENTRES), requires_grad=True)
    sum(detection_loss(torch.zeros(1, 4 * BINS, len(CENTRES)), scores, optional, CENTRES, STRIDES).values()).backward()
    assert inside.any() and not scores.grad[:, :, inside].any()
    assert (scores.grad[:, :, ~inside] > 0).all()  # the rest is background
