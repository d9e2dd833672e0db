"""YOLOv8: C2f backbone with SPPF, path aggregation, and an anchor-free head that predicts box sides as
distributions (generalised focal loss, Li et al., 2020). Written from the published architecture."""

import math

import torch
from torch import nn
from torch.nn import functional

from semantic_slam_training.errors import TrainingError
from semantic_slam_training.models.layers import conv_norm, double_size

SIZES = {"n": (1 / 3, 0.25), "s": (1 / 3, 0.5)}  # depth and width
STRIDES = (8, 16, 32)
BINS = 16  # of the distribution of a side's distance, in cells
BACKBONE_CHANNELS = (64, 128, 256, 512, 1024)
BACKBONE_DEPTHS = (3, 6, 6, 3)
NECK_DEPTH = 3


def conv(inputs, outputs, kernel=3, stride=1):
    return nn.Sequential(*conv_norm(inputs, outputs, kernel, stride), nn.SiLU(inplace=True))


class Bottleneck(nn.Module):
    """Two 3x3 convolutions, with or without a shortcut around them."""

    def __init__(self, channels, has_shortcut):
        super().__init__()
        self.branch = nn.Sequential(conv(channels, channels), conv(channels, channels))
        self.has_shortcut = has_shortcut

    def forward(self, maps):
        return maps + self.branch(maps) if self.has_shortcut else self.branch(maps)


class C2f(nn.Module):
    """Half of the channels pass a chain of bottlenecks, and every link of it is part of the result."""

    def __init__(self, inputs, outputs, depth, has_shortcut=False):
        super().__init__()
        self.hidden = outputs // 2
        self.split = conv(inputs, 2 * self.hidden, 1)
        self.merge = conv((2 + depth) * self.hidden, outputs, 1)
        self.chain = nn.ModuleList(Bottleneck(self.hidden, has_shortcut) for _ in range(depth))

    def forward(self, maps):
        parts = list(self.split(maps).split((self.hidden, self.hidden), 1))
        for link in self.chain:
            parts.append(link(parts[-1]))
        return self.merge(torch.cat(parts, 1))


class SpatialPyramid(nn.Module):
    """SPPF: the maxima of growing neighbourhoods side by side."""

    def __init__(self, channels):
        super().__init__()
        self.reduce = conv(channels, channels // 2, 1)
        self.merge = conv(2 * channels, channels, 1)

    def forward(self, maps):
        parts = [self.reduce(maps)]
        for _ in range(3):
            parts.append(functional.max_pool2d(parts[-1], 5, 1, 2))
        return self.merge(torch.cat(parts, 1))


class Backbone(nn.Module):
    """Gives maps at strides 8, 16 and 32."""

    def __init__(self, channels, depths):
        super().__init__()
        self.stem = conv(3, channels[0], 3, 2)
        self.stages = nn.ModuleList(
            nn.Sequential(conv(a, b, 3, 2), C2f(b, b, depth, has_shortcut=True))
            for a, b, depth in zip(channels, channels[1:], depths))
        self.pyramid = SpatialPyramid(channels[-1])

    def forward(self, image):
        maps, all_maps = self.stem(image), []
        for stage in self.stages:
            maps = stage(maps)
            all_maps.append(maps)
        return all_maps[1], all_maps[2], self.pyramid(maps)


class Neck(nn.Module):
    """Carries what the coarse maps know to the fine ones and back (path aggregation, Liu et al., 2018)."""

    def __init__(self, channels, depth):
        super().__init__()
        fine, middle, coarse = channels
        self.up_middle = C2f(middle + coarse, middle, depth)
        self.up_fine = C2f(fine + middle, fine, depth)
        self.shrink_fine = conv(fine, fine, 3, 2)
        self.down_middle = C2f(fine + middle, middle, depth)
        self.shrink_middle = conv(middle, middle, 3, 2)
        self.down_coarse = C2f(middle + coarse, coarse, depth)

    def forward(self, fine, middle, coarse):
        middle = self.up_middle(torch.cat([double_size(coarse), middle], 1))
        fine = self.up_fine(torch.cat([double_size(middle), fine], 1))
        middle = self.down_middle(torch.cat([self.shrink_fine(fine), middle], 1))
        return fine, middle, self.down_coarse(torch.cat([self.shrink_middle(middle), coarse], 1))


def branch(inputs, hidden, outputs):
    return nn.Sequential(conv(inputs, hidden), conv(hidden, hidden), nn.Conv2d(hidden, outputs, 1))


class Head(nn.Module):
    """Boxes and classes of the cells of three grids, by branches of their own."""

    def __init__(self, channels, classes):
        super().__init__()
        box_hidden = max(16, channels[0] // 4, 4 * BINS)
        class_hidden = max(channels[0], min(classes, 100))
        self.boxes = nn.ModuleList(branch(each, box_hidden, 4 * BINS) for each in channels)
        self.classes = nn.ModuleList(branch(each, class_hidden, classes) for each in channels)
        self.initialise_biases(classes)

    def initialise_biases(self, classes):
        """So that at first about five objects are expected in an image of 640 x 640 pixels."""
        for boxes, scores, stride in zip(self.boxes, self.classes, STRIDES):
            nn.init.constant_(boxes[-1].bias, 1.0)
            nn.init.constant_(scores[-1].bias, math.log(5 / classes / (640 / stride) ** 2))

    @staticmethod
    def in_one_row(maps):
        """batch x channels x cells of all grids, row by row, the finest first."""
        rows = [each.reshape(int(each.shape[0]), int(each.shape[1]), int(each.shape[2]) * int(each.shape[3]))
                for each in maps]
        return torch.cat(rows, 2)

    def forward(self, maps):
        boxes = [layer(each) for layer, each in zip(self.boxes, maps)]
        scores = [layer(each) for layer, each in zip(self.classes, maps)]
        return self.in_one_row(boxes), self.in_one_row(scores)


class YoloV8(nn.Module):
    """For images whose sides are multiples of 32 px.

    Gives logits of the sides' distributions, batch x (4 x 16) x cells, sides in the order left, top,
    right, bottom; and logits of the classes, batch x classes x cells. With `pixel_classes`, in training also
    logits of those, batch x pixel classes x height / 8 x width / 8: what every pixel shows teaches the layers below
    sooner than boxes alone do.
    """

    def __init__(self, classes, size, pixel_classes=0):
        super().__init__()
        if size not in SIZES:
            raise TrainingError(f"size '{size}' of YOLOv8: expected {' or '.join(SIZES)}")
        depth, width = SIZES[size]
        channels = [int(count * width) for count in BACKBONE_CHANNELS]
        depths = [max(1, round(count * depth)) for count in BACKBONE_DEPTHS]
        self.backbone = Backbone(channels, depths)
        self.neck = Neck(channels[2:], max(1, round(NECK_DEPTH * depth)))
        self.head = Head(channels[2:], classes)
        fine = channels[2]
        self.pixels = nn.Sequential(conv(fine, fine), nn.Conv2d(fine, pixel_classes, 1)) if pixel_classes else None

    def forward(self, image):
        maps = self.neck(*self.backbone(image))
        if self.training and self.pixels is not None:
            return *self.head(maps), self.pixels(maps[0])
        return self.head(maps)


def cell_centres(height, width):
    """Centre [px of the input] and stride [px] of each cell, in the order of the outputs: cells x 2, cells."""
    centres, strides = [], []
    for stride in STRIDES:
        v, u = torch.meshgrid(torch.arange(height // stride), torch.arange(width // stride), indexing="ij")
        centres.append((torch.stack([u, v], -1).reshape(-1, 2) + 0.5) * stride)
        strides.append(torch.full((len(centres[-1]),), float(stride)))
    return torch.cat(centres), torch.cat(strides)


class YoloV8Boxes(nn.Module):
    """YOLOv8 with boxes decoded, for images of one size: batch x (4 + classes) x cells.

    Rows are cx, cy, width, height [px of the input], then the classes' probabilities.
    """

    def __init__(self, network, height, width):
        super().__init__()
        self.network = network
        centres, strides = cell_centres(height, width)
        self.register_buffer("centres", centres.T[None].contiguous())  # 1 x 2 x cells
        # As wide as what it is multiplied with: OpenCV 4.6 does not broadcast constants over channels.
        self.register_buffer("strides", strides.expand(1, 2, -1).contiguous())
        self.register_buffer("bins", torch.arange(BINS, dtype=torch.float32).reshape(1, BINS, 1, 1))

    def distances(self, sides):
        """Expected distances [px] from the cell's centre: batch x 2 x cells to left and top, right and bottom."""
        batch, cells = int(sides.shape[0]), int(sides.shape[2])
        likelihoods = sides.reshape(batch, 4, BINS, cells).transpose(1, 2).softmax(1)
        expected = functional.conv2d(likelihoods, self.bins).reshape(batch, 4, cells)
        low, high = expected.split((2, 2), 1)
        return low * self.strides, high * self.strides

    def forward(self, image):
        sides, scores = self.network(image)
        to_low, to_high = self.distances(sides)
        low, high = self.centres - to_low, self.centres + to_high
        return torch.cat([(low + high) * 0.5, high - low, scores.sigmoid()], 1)
