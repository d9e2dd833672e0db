"""Layers that several networks share. Tensors are batch x channels x height x width.

Only operations that OpenCV 4.6 can run once exported: no ReLU6, no chunk, sizes fixed when traced.
"""

import torch
from torch import nn
from torch.nn import functional


def scaled(channels, width, multiple=4):
    """`channels` times `width`, to the nearest positive multiple of `multiple`."""
    return max(multiple, int(channels * width / multiple + 0.5) * multiple)


def conv_norm(inputs, outputs, kernel=3, stride=1, dilation=1, groups=1):
    """Convolution that keeps the size (at stride 1) and batch normalisation, without activation."""
    padding = dilation * (kernel // 2)
    return nn.Sequential(
        nn.Conv2d(inputs, outputs, kernel, stride, padding, dilation, groups, bias=False),
        nn.BatchNorm2d(outputs))


def conv_norm_relu(*arguments, **options):
    return nn.Sequential(*conv_norm(*arguments, **options), nn.ReLU(inplace=True))


def resize(maps, size):
    """Bilinear, to (height, width)."""
    return functional.interpolate(maps, size=tuple(int(side) for side in size), mode="bilinear",
                                  align_corners=False)


def double_size(maps):
    """Nearest neighbour."""
    return functional.interpolate(maps, scale_factor=2.0, mode="nearest")


def mean_over_bins(maps, bins, dim):
    """Means over `bins` ranges of one dimension, which overlap by a row where they do not divide it."""
    length = int(maps.shape[dim])
    ranges = [(i * length // bins, -((i + 1) * -length // bins)) for i in range(bins)]
    means = [maps.narrow(dim, low, high - low).mean(dim, keepdim=True) for low, high in ranges]
    return torch.cat(means, dim)


def pool_to(maps, bins):
    """Adaptive average pooling to bins x bins.

    OpenCV 4.6 has it only for sizes that `bins` divides; as means over rows, then columns, it is exact
    at any size.
    """
    if torch.onnx.is_in_onnx_export():
        return mean_over_bins(mean_over_bins(maps, bins, 2), bins, 3)
    return functional.adaptive_avg_pool2d(maps, bins)


def initialise(network):
    """He's initialisation (2015) of all convolutions that are followed by a rectifier."""
    for module in network.modules():
        if isinstance(module, (nn.Conv2d, nn.ConvTranspose2d)):
            nn.init.kaiming_normal_(module.weight, mode="fan_out", nonlinearity="relu")
            if module.bias is not None:
                nn.init.zeros_(module.bias)


def parameter_count(network):
    return sum(parameter.numel() for parameter in network.parameters())
