"""PSPNet (Zhao et al., 2017): pyramid pooling over a dilated backbone; thesis section 3.3.1."""

import torch
from torch import nn

from semantic_slam_training.models.layers import conv_norm_relu, initialise, pool_to, resize
from semantic_slam_training.models.mobilenet import MobileNetV2
from semantic_slam_training.models.resnet import ResNet

PYRAMID_BINS = (1, 2, 3, 6)
DROPOUT = 0.1


class PyramidPooling(nn.Module):
    """Puts beside the maps their means over 1, 4, 9 and 36 parts of the image; twice the channels."""

    def __init__(self, channels):
        super().__init__()
        self.levels = nn.ModuleList(
            conv_norm_relu(channels, channels // len(PYRAMID_BINS), 1) for _ in PYRAMID_BINS)

    def forward(self, maps):
        size = maps.shape[2:]
        means = [resize(level(pool_to(maps, bins)), size) for level, bins in zip(self.levels, PYRAMID_BINS)]
        return torch.cat([maps, *means], 1)


def classifier(inputs, hidden, classes):
    return nn.Sequential(conv_norm_relu(inputs, hidden, 3), nn.Dropout2d(DROPOUT), nn.Conv2d(hidden, classes, 1))


class PspNet(nn.Module):
    """Scores of the classes at the backbone's stride; in training those of the auxiliary head too."""

    def __init__(self, backbone, classes):
        super().__init__()
        middle, last = backbone.channels
        self.backbone = backbone
        self.pyramid = PyramidPooling(last)
        self.head = classifier(2 * last, last // 2, classes)
        self.auxiliary = classifier(middle, max(middle // 4, classes), classes)
        initialise(self)

    def forward(self, image):
        middle, last = self.backbone(image)
        scores = self.head(self.pyramid(last))
        return [scores, self.auxiliary(middle)] if self.training else scores


def pspnet_resnet18(classes, width):
    return PspNet(ResNet("resnet18", width), classes)


def pspnet_resnet50(classes, width):
    return PspNet(ResNet("resnet50", width), classes)


def pspnet_mobilenetv2(classes, width):
    return PspNet(MobileNetV2(width), classes)
