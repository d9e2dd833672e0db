"""data/input_format.py: how grey levels become a network's numbers."""

import needs_torch  # noqa: F401
import numpy as np
import pytest

from semantic_slam_training.data.input_format import IMAGENET_MEAN, IMAGENET_STD, InputFormat, unscaled_input


def test_a_blob_has_its_channels_first_and_each_scaled_by_itself():
    image = np.zeros((2, 3, 3), np.uint8)
    image[1, 2] = 255, 51, 0
    blob = InputFormat(3, 2).to_blob(image)
    assert blob.shape == (3, 2, 3) and blob.dtype == np.float32 and blob.flags.c_contiguous
    for channel, level in enumerate((1.0, 0.2, 0.0)):
        expected = (level - IMAGENET_MEAN[channel]) / IMAGENET_STD[channel]
        assert blob[channel, 1, 2] == pytest.approx(expected, rel=1e-6)  # single precision
    assert blob[:, 0, 0] == pytest.approx(-np.array(IMAGENET_MEAN) / IMAGENET_STD, rel=1e-6)


def test_yolo_sees_shares_of_full_brightness():
    assert unscaled_input(1, 1).to_blob(np.array([[[0, 51, 255]]], np.uint8)).ravel().tolist() == pytest.approx([0, 0.2, 1])
