"""losses/: values that can be worked out by hand."""

import math

import needs_torch  # noqa: F401
import pytest
import torch

from semantic_slam_training.classes import IGNORE
from semantic_slam_training.losses.appearance import batch_hard_triplet_loss
from semantic_slam_training.losses.boxes import complete_iou, intersection_over_union
from semantic_slam_training.losses.detection import decode, distances_to, distribution_focal_loss
from semantic_slam_training.losses.segmentation import class_weights, cross_entropy, segmentation_loss
from semantic_slam_training.models.yolov8 import BINS


def scores_for(first):
    """1 x 2 x 1 x 2: certain of class 0 by `first` in both pixels."""
    return torch.tensor([[[[first, first]], [[0.0, 0.0]]]])


def test_cross_entropy_leaves_out_ignored_pixels():
    labels = torch.tensor([[[0, IGNORE]]])
    assert float(cross_entropy(scores_for(2.0), labels)) == pytest.approx(math.log(1 + math.exp(-2)), rel=1e-6)


def test_cross_entropy_is_zero_where_all_is_ignored():
    assert float(cross_entropy(scores_for(2.0), torch.full((1, 1, 2), IGNORE))) == 0.0


def test_coarse_scores_are_enlarged():
    labels = torch.zeros(1, 4, 8, dtype=torch.int64)
    assert float(cross_entropy(scores_for(2.0), labels)) == pytest.approx(math.log(1 + math.exp(-2)), rel=1e-5)


def test_auxiliary_heads_count_less():
    labels = torch.zeros(1, 1, 2, dtype=torch.int64)
    parts = segmentation_loss([scores_for(2.0)] * 3, labels)
    assert float(parts["auxiliary"]) == pytest.approx(2 * 0.4 * float(parts["cross_entropy"]), rel=1e-6)


def test_rare_classes_weigh_more_and_pixels_weigh_one_on_average():
    counts = [900, 100, 0]
    weights = class_weights(counts, 0.5)
    assert float(weights[1] / weights[0]) == pytest.approx(3.0, rel=1e-6)  # root of 9
    assert float(weights[0] * 0.9 + weights[1] * 0.1) == pytest.approx(1.0, rel=1e-6)
    assert float(weights[2]) == 1.0
    assert class_weights(counts, 0.0).tolist() == [1.0, 1.0, 1.0]


def test_overlap_of_boxes():
    a = torch.tensor([0.0, 0.0, 10.0, 10.0])
    b = torch.tensor([[0.0, 0.0, 10.0, 10.0], [5.0, 0.0, 15.0, 10.0], [20.0, 0.0, 30.0, 10.0]])
    assert intersection_over_union(a, b).tolist() == pytest.approx([1.0, 50 / 150, 0.0])


def test_complete_iou_punishes_distance_and_aspect():
    a = torch.tensor([0.0, 0.0, 10.0, 10.0])
    moved = torch.tensor([5.0, 0.0, 15.0, 10.0])  # same shape: IoU 1/3, centres 5 apart, hull 15 x 10
    assert float(complete_iou(a, moved)) == pytest.approx(1 / 3 - 25 / 325, abs=1e-6)
    flat = torch.tensor([0.0, 2.5, 10.0, 7.5])  # same centre, twice as wide as high: IoU 1/2
    aspect = 4 / math.pi ** 2 * (math.atan(1) - math.atan(2)) ** 2
    assert float(complete_iou(a, flat)) == pytest.approx(0.5 - aspect ** 2 / (0.5 + aspect), abs=1e-6)


def test_boxes_survive_distances_and_decoding():
    boxes = torch.tensor([[[10.0, 4.0, 40.0, 28.0]]])
    centres, strides = torch.tensor([[20.0, 20.0]]), torch.tensor([8.0])
    distances = distances_to(boxes, centres, strides)
    assert distances[0, 0].tolist() == [1.25, 2.0, 2.5, 1.0]
    sides = torch.full((1, 1, 4, BINS), -50.0)
    for side, distance in enumerate(distances[0, 0].tolist()):
        below = int(distance)
        sides[0, 0, side, below] = math.log(max(1 - distance + below, 1e-20))
        sides[0, 0, side, below + 1] = math.log(max(distance - below, 1e-20))
    assert decode(sides, centres, strides)[0, 0].tolist() == pytest.approx([10, 4, 40, 28], abs=1e-4)


def test_distribution_focal_loss_is_least_between_the_right_bins():
    wanted = torch.full((1, 4), 2.25)
    right = torch.full((1, 4, BINS), -50.0)
    right[..., 2], right[..., 3] = math.log(0.75), math.log(0.25)
    entropy = -(0.75 * math.log(0.75) + 0.25 * math.log(0.25))
    assert float(distribution_focal_loss(right, wanted)) == pytest.approx(entropy, rel=1e-5)
    assert float(distribution_focal_loss(torch.zeros(1, 4, BINS), wanted)) == pytest.approx(math.log(16), rel=1e-5)


def test_triplets_compare_the_farthest_of_the_same_with_the_nearest_other():
    vectors = torch.tensor([[0.0], [3.0], [4.0], [10.0]])
    identities = torch.tensor([0, 0, 1, 1])
    pairs = [(3, 4), (3, 1), (6, 1), (6, 7)]  # farthest same, nearest other, for each
    expected = sum(math.log1p(math.exp(same - other)) for same, other in pairs) / 4
    assert float(batch_hard_triplet_loss(vectors, identities)) == pytest.approx(expected, rel=1e-5)
