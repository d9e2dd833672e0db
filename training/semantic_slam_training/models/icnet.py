"""ICNet (Zhao et al., 2018): the deep layers see a small image, and finer ones mend the edges."""

from torch import nn
from torch.nn import functional

from semantic_slam_training.models.layers import (
    conv_norm, conv_norm_relu, initialise, pool_to, resize, scaled)
from semantic_slam_training.models.pspnet import PYRAMID_BINS
from semantic_slam_training.models.resnet import ResNet

DETAIL_CHANNELS = (32, 32, 64)
FUSION_CHANNELS = 128


class CascadeFeatureFusion(nn.Module):
    """Adds coarse maps, resized, to fine ones. Gives the sum, and scores of the coarse ones."""

    def __init__(self, coarse, fine, channels, classes):
        super().__init__()
        self.coarse = conv_norm(coarse, channels, 3, dilation=2)
        self.fine = conv_norm(fine, channels, 1)
        self.auxiliary = nn.Conv2d(coarse, classes, 1)

    def forward(self, coarse, fine):
        coarse = resize(coarse, fine.shape[2:])
        return functional.relu(self.coarse(coarse) + self.fine(fine)), self.auxiliary(coarse)


class IcNet(nn.Module):
    """Scores of the classes at 1/4 of the image's size; in training coarser ones of the cascade too."""

    def __init__(self, classes, width):
        super().__init__()
        self.backbone = ResNet("resnet18", width)
        detail = [scaled(channels, width) for channels in DETAIL_CHANNELS]
        self.detail = nn.Sequential(*(conv_norm_relu(inputs, outputs, 3, 2)
                                      for inputs, outputs in zip([3, *detail], detail)))
        middle = self.backbone.stages[1][-1].channels
        channels = scaled(FUSION_CHANNELS, width)
        self.coarse_fusion = CascadeFeatureFusion(self.backbone.channels[1], middle, channels, classes)
        self.fine_fusion = CascadeFeatureFusion(channels, detail[-1], channels, classes)
        self.head = nn.Conv2d(channels, classes, 1)
        initialise(self)

    def deep_maps(self, middle):
        """The last stages and the pyramid, on maps of half the size: 1/32 of the image's."""
        _, *deep = self.backbone.stages[1:]
        maps = functional.avg_pool2d(middle, 2, ceil_mode=False)
        for stage in deep:
            maps = stage(maps)
        return maps + sum(resize(pool_to(maps, bins), maps.shape[2:]) for bins in PYRAMID_BINS)

    def forward(self, image):
        half = functional.avg_pool2d(image, 2)
        middle = self.backbone.stages[1](self.backbone.stages[0](self.backbone.stem(half)))
        maps, coarse_scores = self.coarse_fusion(self.deep_maps(middle), middle)
        maps, middle_scores = self.fine_fusion(maps, self.detail(image))
        height, width = maps.shape[2:]
        scores = self.head(resize(maps, (2 * height, 2 * width)))
        return [scores, middle_scores, coarse_scores] if self.training else scores
