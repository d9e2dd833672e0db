"""models/: shapes of what each network gives, and the layers that stand in for what OpenCV lacks."""

import needs_torch  # noqa: F401
import pytest
import torch
from torch.nn import functional

from semantic_slam_training.errors import TrainingError
from semantic_slam_training.models import segmentation
from semantic_slam_training.models.appearance import AppearanceNetwork
from semantic_slam_training.models.layers import mean_over_bins, parameter_count, scaled
from semantic_slam_training.models.segnet import mask_of_maxima
from semantic_slam_training.models.yolov8 import BINS, YoloV8, YoloV8Boxes, cell_centres

# Stride of the scores, and how many heads there are in training.
SHAPES = {"pspnet_resnet18": (8, 2), "pspnet_resnet50": (8, 2), "pspnet_mobilenetv2": (16, 2), "icnet": (4, 3),
          "segnet": (1, 1), "unet": (1, 1), "frrn": (1, 1), "fcn16s": (16, 1), "fcn8s": (8, 1)}


def test_all_networks_are_looked_at():
    assert SHAPES.keys() == segmentation.NETWORKS.keys()


@pytest.mark.parametrize("name", SHAPES)
def test_scores_have_the_shape_of_the_image_at_a_stride(name):
    stride, heads = SHAPES[name]
    network = segmentation.build(name, classes=5, width=0.0625)
    images = torch.zeros(2, 3, 64, 96)
    assert [tuple(scores.shape[:2]) for scores in network.train()(images)] == [(2, 5)] * heads
    assert network.eval()(images).shape == (2, 5, 64 // stride, 96 // stride)


def test_an_unknown_network_is_refused_by_name():
    with pytest.raises(TrainingError, match="network 'vgg': expected one of pspnet_resnet18"):
        segmentation.build("vgg", 5, 1.0)


@pytest.mark.parametrize("channels, width, expected", [(64, 0.5, 32), (64, 0.25, 16), (8, 0.01, 4), (48, 1.0, 48)])
def test_channels_are_scaled_to_multiples(channels, width, expected):
    assert scaled(channels, width) == expected


@pytest.mark.parametrize("bins", [1, 2, 3, 6])
def test_means_over_bins_are_adaptive_pooling(bins):
    maps = torch.rand(1, 4, 15, 20, generator=torch.Generator().manual_seed(1))
    separable = mean_over_bins(mean_over_bins(maps, bins, 2), bins, 3)
    # Sums of up to 300 floats in another order.
    assert torch.allclose(separable, functional.adaptive_avg_pool2d(maps, bins), atol=1e-6)


def test_maxima_are_marked_once_per_square():
    maps = torch.tensor([[[[1.0, 2.0, 5.0, 4.0], [3.0, 0.0, 4.5, 4.9]]]])
    mask = mask_of_maxima(maps, functional.max_pool2d(maps, 2))
    assert mask.tolist() == [[[[0, 0, 1, 0], [1, 0, 0, 0]]]]


def test_yolov8_tells_pixels_in_training_only():
    network = YoloV8(2, "n", pixel_classes=5)
    images = torch.zeros(2, 3, 64, 96)
    assert network.train()(images)[2].shape == (2, 5, 8, 12)
    assert len(network.eval()(images)) == 2
    assert len(YoloV8(2, "n").train()(images)) == 2


@pytest.mark.parametrize("size, published", [("n", 3_157_200), ("s", 11_166_560)])
def test_yolov8_is_as_large_as_published(size, published):
    # The published count includes the 16 constants of the distribution.
    assert parameter_count(YoloV8(80, size)) + BINS == published


def test_cells_go_row_by_row_from_fine_to_coarse():
    centres, strides = cell_centres(height=32, width=64)
    assert len(centres) == len(strides) == 4 * 8 + 2 * 4 + 1 * 2
    assert centres[0].tolist() == [4, 4] and centres[1].tolist() == [12, 4] and centres[8].tolist() == [4, 12]
    assert centres[-1].tolist() == [48, 16] and strides[-1] == 32


def test_boxes_are_decoded_about_the_cells():
    class Certain(torch.nn.Module):
        """All sides are 2 cells from the centre."""

        def forward(self, image):
            sides = torch.full((1, 4 * BINS, 42), -50.0)
            sides[:, 2::BINS] = 50.0
            return sides, torch.zeros(1, 3, 42)

    rows = YoloV8Boxes(Certain(), height=32, width=64)(torch.zeros(1, 3, 32, 64))
    assert rows.shape == (1, 7, 42)
    assert rows[0, :, 9].tolist() == pytest.approx([12, 12, 32, 32, 0.5, 0.5, 0.5])  # exact up to exp(-100)
    assert rows[0, 2:4, -1].tolist() == pytest.approx([128, 128])


def test_appearance_gives_vectors_and_in_training_scores():
    network = AppearanceNetwork(identities=9, width=0.125)
    vectors, scores = network.train()(torch.zeros(3, 3, 32, 32))
    assert vectors.shape == (3, 128) and scores.shape == (3, 9)
    assert network.eval()(torch.zeros(3, 3, 32, 32)).shape == (3, 128)
