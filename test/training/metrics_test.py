"""evaluation/: figures that can be worked out by hand."""

import needs_torch  # noqa: F401
import numpy as np
import pytest
import torch

from semantic_slam_training.classes import IGNORE
from semantic_slam_training.evaluation.appearance_metrics import area_under_curve, separation
from semantic_slam_training.evaluation.detection_metrics import (
    Boxes, DetectionScore, average_precision, pass_over_optional, select_boxes)
from semantic_slam_training.evaluation.segmentation_metrics import ConfusionMatrix


def test_accuracy_and_overlap_of_pixels():
    matrix = ConfusionMatrix(3)
    matrix.add(np.array([[0, 0, 1, IGNORE]]), np.array([[0, 1, 1, 2]]))
    assert matrix.pixel_accuracy() == pytest.approx(2 / 3)
    assert matrix.class_ious()[:2].tolist() == pytest.approx([1 / 2, 1 / 2])
    assert np.isnan(matrix.class_ious()[2])
    assert matrix.mean_iou() == pytest.approx(1 / 2)


def test_nothing_to_look_at_is_not_a_number():
    assert np.isnan(ConfusionMatrix(2).pixel_accuracy()) and np.isnan(ConfusionMatrix(2).mean_iou())


def test_average_precision_is_the_area_below_the_best_curve():
    # Hits 1, 0, 1 of two objects: precision 1, 1/2, 2/3 at recall 1/2, 1/2, 1.
    assert average_precision(np.array([1, 1 / 2, 2 / 3]), np.array([0.5, 0.5, 1.0])) == pytest.approx(
        0.5 * 1 + 0.5 * 2 / 3)


def found(*rows):
    """Boxes of (left, score, class), 10 px square."""
    return Boxes(torch.tensor([[left, 0.0, left + 10.0, 10.0] for left, _, _ in rows]).reshape(-1, 4),
                 torch.tensor([score for _, score, _ in rows]), torch.tensor([kind for _, _, kind in rows]))


def test_boxes_are_matched_once_and_by_class():
    score = DetectionScore(2)
    truth = torch.tensor([[0.0, 0.0, 10.0, 10.0], [20.0, 0.0, 30.0, 10.0]])
    # A hit, a second box on the same object, one of another class.
    score.add(found((0.0, 0.9, 0), (1.0, 0.8, 0), (20.0, 0.7, 1)), truth, torch.tensor([0, 0]))
    assert score.class_precisions()[0] == pytest.approx(0.5)
    assert np.isnan(score.class_precisions()[1])
    figures = score.metrics()
    assert figures["map50"] == pytest.approx(0.5)
    assert 0.8 < figures["threshold"] <= 0.9  # above the second box
    assert (figures["precision"], figures["recall"]) == (1.0, 0.5)


def test_perfect_boxes_score_one():
    score = DetectionScore(1)
    for _ in range(3):
        score.add(found((5.0, 0.6, 0)), torch.tensor([[5.0, 0.0, 15.0, 10.0]]), torch.tensor([0]))
    figures = score.metrics()
    assert (figures["map50"], figures["precision"], figures["recall"]) == (1.0, 1.0, 1.0)


def test_a_box_on_an_optional_object_is_passed_over():
    truth, optional = torch.tensor([[0.0, 0.0, 10.0, 10.0]]), torch.tensor([[2.0, 0.0, 12.0, 10.0],
                                                                            [40.0, 0.0, 50.0, 10.0]])
    # More on the true object, more on the optional one, far from both, on the second optional one.
    boxes = found((0.5, 0.9, 0), (1.5, 0.8, 0), (20.0, 0.7, 0), (41.0, 0.6, 1))
    assert pass_over_optional(boxes, truth, optional).scores.tolist() == pytest.approx([0.9, 0.7])
    assert len(pass_over_optional(boxes, truth, torch.zeros(0, 4)).scores) == 4
    assert len(pass_over_optional(found(), truth, optional).scores) == 0


def test_an_image_without_objects_or_boxes_does_no_harm():
    score = DetectionScore(1)
    score.add(found(), torch.zeros(0, 4), torch.zeros(0, dtype=torch.int64))
    assert np.isnan(score.metrics()["map50"])


def test_of_boxes_on_one_object_the_best_stands():
    rows = torch.tensor([[10.0, 10.0, 20.0, 20.0, 0.6, 0.1], [10.5, 10.0, 20.0, 20.0, 0.9, 0.2],
                         [10.0, 10.0, 20.0, 20.0, 0.1, 0.7], [50.0, 10.0, 20.0, 20.0, 0.0005, 0.0]]).T
    selected = select_boxes(rows)
    assert selected.scores.tolist() == pytest.approx([0.9, 0.7]) and selected.classes.tolist() == [0, 1]
    assert selected.boxes[0].tolist() == [0.5, 0.0, 20.5, 20.0]


def test_area_under_the_curve_counts_ties_half():
    assert area_under_curve(np.array([3.0, 2.0]), np.array([1.0, 2.0])) == pytest.approx((2 + 1.5) / 4)


def test_separation_of_vectors():
    vectors = np.array([[1.0, 0.0], [2.0, 0.1], [0.0, 1.0], [0.0, 3.0]])
    assert separation(vectors, np.array([0, 0, 1, 1])) == 1.0
    assert separation(vectors, np.array([0, 1, 0, 1])) == pytest.approx(0.25, abs=0.07)  # a tie may fall either way
    assert np.isnan(separation(vectors, np.array([0, 1, 2, 3])))
