"""FRRN (Pohlen et al., 2017), variant A: a stream of residuals at full size beside a pooled one."""

import torch
from torch import nn
from torch.nn import functional

from semantic_slam_training.models.layers import (
    conv_norm, conv_norm_relu, double_size, initialise, scaled)

FIRST_CHANNELS = 48
RESIDUAL_CHANNELS = 32
# Channels, units and scale of the pooled stream, table 1 of the paper.
ENCODER = ((96, 3, 2), (192, 4, 4), (384, 2, 8), (384, 2, 16))
DECODER = ((192, 2, 8), (192, 2, 4), (96, 2, 2))
OUTER_UNITS = 3  # residual units before and after


class ResidualUnit(nn.Module):
    """At full size."""

    def __init__(self, channels):
        super().__init__()
        self.branch = nn.Sequential(conv_norm_relu(channels, channels), conv_norm(channels, channels))

    def forward(self, maps):
        return maps + self.branch(maps)


class FullResolutionUnit(nn.Module):
    """Takes and gives the pooled stream, at 1/scale, and the residual stream, at full size."""

    def __init__(self, inputs, outputs, residual, scale):
        super().__init__()
        self.scale = scale
        self.branch = nn.Sequential(conv_norm_relu(inputs + residual, outputs), conv_norm_relu(outputs, outputs))
        self.to_residual = nn.Conv2d(outputs, residual, 1)

    def forward(self, pooled, residual):
        pooled = self.branch(torch.cat([pooled, functional.max_pool2d(residual, self.scale)], 1))
        added = functional.interpolate(self.to_residual(pooled), scale_factor=float(self.scale), mode="nearest")
        return pooled, residual + added


class Frrn(nn.Module):
    """Scores of the classes at the image's size, which must be divisible by 16."""

    def __init__(self, classes, width):
        super().__init__()
        first, residual = scaled(FIRST_CHANNELS, width), scaled(RESIDUAL_CHANNELS, width)
        self.first = nn.Sequential(conv_norm_relu(3, first, 5), *(ResidualUnit(first) for _ in range(OUTER_UNITS)))
        self.split = nn.Conv2d(first, residual, 1)
        self.encoder, inputs = self.levels(ENCODER, first, residual, width)
        self.decoder, inputs = self.levels(DECODER, inputs, residual, width)
        self.merge = conv_norm_relu(inputs + residual, first, 1)
        self.last = nn.Sequential(*(ResidualUnit(first) for _ in range(OUTER_UNITS)))
        self.head = nn.Conv2d(first, classes, 1)
        initialise(self)

    @staticmethod
    def levels(table, inputs, residual, width):
        """One list of units per level of `table`, and the channels that the last one gives."""
        levels = nn.ModuleList()
        for channels, count, scale in table:
            outputs = scaled(channels, width)
            widths = [inputs] + [outputs] * (count - 1)
            levels.append(nn.ModuleList(FullResolutionUnit(each, outputs, residual, scale) for each in widths))
            inputs = outputs
        return levels, inputs

    def forward(self, image):
        pooled = self.first(image)
        residual = self.split(pooled)
        for change_size, levels in ((lambda maps: functional.max_pool2d(maps, 2), self.encoder),
                                    (double_size, self.decoder)):
            for units in levels:
                pooled = change_size(pooled)
                for unit in units:
                    pooled, residual = unit(pooled, residual)
        merged = self.merge(torch.cat([double_size(pooled), residual], 1))
        scores = self.head(self.last(merged))
        return [scores] if self.training else scores
