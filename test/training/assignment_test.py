"""losses/assignment.py: which cell finds which object, worked out by hand on a row of cells."""

import needs_torch  # noqa: F401
import pytest
import torch

from semantic_slam_training.losses.assignment import CELLS_PER_OBJECT, Objects, assign, cells_in_optional

CENTRES = torch.tensor([[4.0, 4.0], [12.0, 4.0], [20.0, 4.0], [28.0, 4.0]])


def objects(boxes, classes, present=None):
    present = torch.tensor([[True] * len(boxes) if present is None else present], dtype=torch.bool)
    return Objects(torch.tensor([boxes]).reshape(1, -1, 4), torch.tensor([classes], dtype=torch.int64), present,
                   torch.zeros_like(present))


def predicted(boxes):
    return torch.tensor([boxes])


def test_cells_inside_an_object_find_it_as_well_as_they_fit():
    truth = objects([[0.0, 0.0, 16.0, 8.0]], [1])
    boxes = predicted([[0.0, 0.0, 16.0, 8.0], [0.0, 0.0, 8.0, 8.0], [0.0, 0.0, 16.0, 8.0], [0.0, 0.0, 16.0, 8.0]])
    scores = torch.full((1, 4, 2), 0.25)
    targets = assign(scores, boxes, CENTRES, truth)
    assert targets.foreground.tolist() == [[True, True, False, False]]  # the others' centres are outside
    assert targets.boxes[0, 0].tolist() == [0.0, 0.0, 16.0, 8.0]
    # The best cell gets its overlap, 1; the other the same times (IoU ratio)^6 at equal scores.
    assert targets.scores[0, :, 1].tolist() == pytest.approx([1.0, 0.5 ** 6, 0.0, 0.0], abs=1e-6)
    assert targets.scores[0, :, 0].tolist() == [0.0] * 4


def test_a_better_score_makes_a_better_cell():
    truth = objects([[0.0, 0.0, 16.0, 8.0]], [0])
    boxes = predicted([[0.0, 0.0, 16.0, 8.0]] * 4)
    scores = torch.tensor([[[0.16], [0.64], [0.5], [0.5]]])
    targets = assign(scores, boxes, CENTRES, truth)
    assert targets.scores[0, :, 0].tolist() == pytest.approx([0.5, 1.0, 0.0, 0.0], abs=1e-6)  # roots of the scores


def test_a_cell_that_two_objects_want_goes_to_the_one_it_overlaps_more():
    truth = objects([[0.0, 0.0, 8.0, 8.0], [0.0, 0.0, 16.0, 8.0]], [0, 1])
    boxes = predicted([[0.0, 0.0, 14.0, 8.0], [0.0, 0.0, 16.0, 8.0], [0.0] * 4, [0.0] * 4])
    targets = assign(torch.full((1, 4, 2), 0.5), boxes, CENTRES, truth)
    assert targets.foreground.tolist() == [[True, True, False, False]]
    assert targets.boxes[0, 0].tolist() == [0.0, 0.0, 16.0, 8.0]
    assert targets.scores[0, :, 0].tolist() == [0.0] * 4


def test_padding_finds_nothing():
    truth = objects([[0.0, 0.0, 16.0, 8.0]], [0], present=[False])
    targets = assign(torch.full((1, 4, 1), 0.5), predicted([[0.0, 0.0, 16.0, 8.0]] * 4), CENTRES, truth)
    assert not targets.foreground.any() and float(targets.scores.sum()) == 0.0


def test_cells_in_optional_objects_are_told():
    boxes, kinds = torch.tensor([[[0.0, 0.0, 8.0, 8.0], [16.0, 0.0, 32.0, 8.0]]]), torch.zeros(1, 2, dtype=torch.int64)
    truth = Objects(boxes, kinds, torch.tensor([[True, False]]), torch.tensor([[False, True]]))
    assert cells_in_optional(CENTRES, truth).tolist() == [[False, False, True, True]]


def test_a_batch_without_objects_is_all_background():
    truth = objects([], [])
    targets = assign(torch.full((1, 4, 2), 0.5), torch.zeros(1, 4, 4), CENTRES, truth)
    assert not targets.foreground.any() and targets.scores.shape == (1, 4, 2)


def test_an_object_gets_ten_cells_at_most():
    centres = torch.stack([torch.arange(0.5, 40.0), torch.full((40,), 4.0)], 1)
    truth = objects([[0.0, 0.0, 40.0, 8.0]], [0])
    targets = assign(torch.full((1, 40, 1), 0.5), torch.tensor([0.0, 0.0, 40.0, 8.0]).expand(1, 40, 4), centres, truth)
    assert int(targets.foreground.sum()) == CELLS_PER_OBJECT
