"""MobileNetV2 (Sandler et al., 2018) as backbone, with ReLU for ReLU6, which OpenCV 4.6 cannot load."""

from torch import nn

from semantic_slam_training.models.layers import conv_norm, conv_norm_relu, scaled

STEM_CHANNELS = 32
# Expansion, channels, blocks, stride, dilation: the paper's table 2, dilated where it would go to 1/32.
STAGES = ((1, 16, 1, 1, 1), (6, 24, 2, 2, 1), (6, 32, 3, 2, 1), (6, 64, 4, 2, 1), (6, 96, 3, 1, 1),
          (6, 160, 3, 1, 2), (6, 320, 1, 1, 2))
MIDDLE_STAGE = 4  # the last one before the dilated ones


class InvertedResidual(nn.Module):
    """Expands, filters each channel by itself, and projects to few channels again."""

    def __init__(self, inputs, outputs, expansion, stride, dilation):
        super().__init__()
        hidden = inputs * expansion
        expand = [conv_norm_relu(inputs, hidden, 1)] if expansion > 1 else []
        self.branch = nn.Sequential(
            *expand, conv_norm_relu(hidden, hidden, 3, stride, dilation, groups=hidden),
            conv_norm(hidden, outputs, 1))
        self.has_shortcut = stride == 1 and inputs == outputs

    def forward(self, maps):
        return maps + self.branch(maps) if self.has_shortcut else self.branch(maps)


def stage(inputs, outputs, expansion, blocks, stride, dilation):
    """Blocks of one stage, the first of which takes the stride."""
    first = InvertedResidual(inputs, outputs, expansion, stride, dilation)
    rest = [InvertedResidual(outputs, outputs, expansion, 1, dilation) for _ in range(blocks - 1)]
    return nn.Sequential(first, *rest)


class MobileNetV2(nn.Module):
    """Gives the maps of a middle and of the last stage, both at 1/16 of the image's size.

    `channels` are those of the two outputs.
    """

    stride = 16

    def __init__(self, width):
        super().__init__()
        inputs = scaled(STEM_CHANNELS, width, 8)
        layers = [conv_norm_relu(3, inputs, 3, 2)]
        for expansion, channels, blocks, stride, dilation in STAGES:
            outputs = scaled(channels, width, 8)
            layers.append(stage(inputs, outputs, expansion, blocks, stride, dilation))
            inputs = outputs
        self.first = nn.Sequential(*layers[:MIDDLE_STAGE + 2])
        self.last = nn.Sequential(*layers[MIDDLE_STAGE + 2:])
        self.channels = (scaled(STAGES[MIDDLE_STAGE][1], width, 8), inputs)

    def forward(self, image):
        middle = self.first(image)
        return middle, self.last(middle)
