"""U-Net (Ronneberger et al., 2015), padded so that sizes stay."""

import torch
from torch import nn
from torch.nn import functional

from semantic_slam_training.models.layers import conv_norm_relu, initialise, scaled

CHANNELS = (64, 128, 256, 512, 1024)


def double_convolution(inputs, outputs):
    return nn.Sequential(conv_norm_relu(inputs, outputs), conv_norm_relu(outputs, outputs))


class UNet(nn.Module):
    """Scores of the classes at the image's size, which must be divisible by 16."""

    def __init__(self, classes, width):
        super().__init__()
        channels = [scaled(count, width) for count in CHANNELS]
        steps = list(zip(channels, channels[1:]))
        self.first = double_convolution(3, channels[0])
        self.down = nn.ModuleList(double_convolution(fine, coarse) for fine, coarse in steps)
        self.enlarge = nn.ModuleList(nn.ConvTranspose2d(coarse, fine, 2, 2) for fine, coarse in reversed(steps))
        self.up = nn.ModuleList(double_convolution(2 * fine, fine) for fine, _ in reversed(steps))
        self.head = nn.Conv2d(channels[0], classes, 1)
        initialise(self)

    def forward(self, image):
        maps = self.first(image)
        skipped = []
        for stage in self.down:
            skipped.append(maps)
            maps = stage(functional.max_pool2d(maps, 2))
        for enlarge, stage in zip(self.enlarge, self.up):
            maps = stage(torch.cat([skipped.pop(), enlarge(maps)], 1))
        scores = self.head(maps)
        return [scores] if self.training else scores
