"""data/view.py and augmentation.py: labels and boxes stay with the pixels that they belong to."""

import needs_torch  # noqa: F401
import numpy as np
import pytest

from semantic_slam_training.classes import IGNORE
from semantic_slam_training.data.augmentation import Augmentation, change_light
from semantic_slam_training.data.view import (
    letterbox, random_view, shrink, view_boxes, view_image, view_labels)

WILD = Augmentation(rotation_deg=0.0, least_scale=0.6, most_scale=1.6, shift=0.1)


def box_image(box):
    image = np.zeros((48, 64, 3), np.uint8)
    image[box[1]:box[3], box[0]:box[2]] = 255
    return image


def box_of(image):
    v, u = np.nonzero(image[..., 0] > 127)
    return [u.min(), v.min(), u.max() + 1, v.max() + 1]


def test_letterbox_is_that_of_the_package():
    # 64 x 48 in 48 x 48: scaled by 3/4 to 48 x 36, 6 px above and below.
    view = letterbox((64, 48), (48, 48))
    image = view_image(np.full((48, 64, 3), 200, np.uint8), view, (48, 48), pad=124)
    assert np.all(image[:6] == 124) and np.all(image[42:] == 124)
    assert np.all(image[6:42] == 200)
    # Outer edges of the image lie on the content's.
    boxes, _ = view_boxes(np.array([[0.0, 0.0, 64.0, 48.0]]), view, (48, 48))
    assert boxes[0].tolist() == pytest.approx([0, 6, 48, 42])


@pytest.mark.parametrize("seed", range(6))
def test_boxes_follow_their_pixels(seed):
    box = (20, 12, 44, 30)
    view = random_view(np.random.default_rng(seed), (64, 48), (96, 64), WILD)
    expected = box_of(view_image(box_image(box), view, (96, 64), pad=0))
    boxes, shares = view_boxes(np.array([box], np.float32), view, (96, 64))
    assert shares[0] > 0.5
    assert boxes[0].tolist() == pytest.approx(expected, abs=1.0)  # whole pixels against edges between them


@pytest.mark.parametrize("seed", range(3))
def test_labels_follow_their_pixels(seed):
    image = box_image((20, 12, 44, 30))
    view = random_view(np.random.default_rng(seed), (64, 48), (96, 64), Augmentation())
    labels = view_labels((image[..., 0] > 127).astype(np.uint8), view, (96, 64))
    shown = view_image(image, view, (96, 64), pad=0)[..., 0]
    sure = (labels != IGNORE) & ((shown < 30) | (shown > 225))  # not on an edge
    assert sure.mean() > 0.3  # the image may fill no more than 43 % of the input
    assert ((shown > 127) == (labels == 1))[sure].mean() > 0.99  # the nearest pixel may be the neighbour


def test_labels_of_a_smaller_input_lie_in_the_middle_of_those_they_stand_for():
    # Two halves that meet between pixels 31 and 32; at half the size between 15 and 16.
    labels = (np.arange(64) >= 32).astype(np.uint8) * np.ones((48, 1), np.uint8)
    shrunk = view_labels(labels, shrink(letterbox((64, 48), (64, 48)), 2), (32, 24))
    assert np.array_equal(shrunk, (np.arange(32) >= 16) * np.ones((24, 1)))


def test_what_is_around_the_image_is_ignored():
    labels = view_labels(np.zeros((48, 64), np.uint8), letterbox((64, 48), (96, 96)), (96, 96))
    assert labels[5, 50] == IGNORE and labels[48, 50] == 0


def test_boxes_tell_which_share_of_them_is_left():
    view = letterbox((64, 48), (64, 48))
    boxes = np.array([[-30.0, 10.0, 4.0, 20.0], [-4.0, 10.0, 20.0, 20.0], [5.0, 5.0, 7.0, 30.0]])
    cut, shares = view_boxes(boxes, view, (64, 48))
    assert shares.tolist() == pytest.approx([4 / 34, 20 / 24, 0.0])  # the last is too narrow
    assert cut[1].tolist() == [0, 10, 20, 20]


def test_no_boxes_stay_none():
    cut, shares = view_boxes(np.zeros((0, 4), np.float32), letterbox((64, 48), (64, 48)), (64, 48))
    assert cut.shape == (0, 4) and shares.shape == (0,)


def test_without_augmentation_the_light_stays():
    image = np.random.default_rng(1).integers(0, 256, (8, 8, 3), np.uint8)
    assert np.array_equal(change_light(np.random.default_rng(2), image, Augmentation.none()), image)


def test_the_same_seed_changes_alike():
    image = np.random.default_rng(1).integers(0, 256, (8, 8, 3), np.uint8)
    first, second, other = (change_light(np.random.default_rng(seed), image, Augmentation()) for seed in (3, 3, 4))
    assert np.array_equal(first, second) and not np.array_equal(first, other)
