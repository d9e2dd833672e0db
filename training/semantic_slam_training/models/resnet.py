"""Residual networks (He et al., 2016) as backbones, dilated in the last stages."""

from torch import nn

from semantic_slam_training.models.layers import conv_norm, conv_norm_relu, scaled

# Blocks per stage and whether they are bottlenecks.
DEPTHS = {"resnet18": ((2, 2, 2, 2), False), "resnet50": ((3, 4, 6, 3), True)}
STAGE_CHANNELS = (64, 128, 256, 512)
BOTTLENECK_EXPANSION = 4


class ResidualBlock(nn.Module):
    """Two 3x3 convolutions, or a bottleneck of three, and a shortcut around them."""

    def __init__(self, inputs, channels, stride=1, dilation=1, bottleneck=False):
        super().__init__()
        outputs = channels * BOTTLENECK_EXPANSION if bottleneck else channels
        if bottleneck:
            self.branch = nn.Sequential(
                conv_norm_relu(inputs, channels, 1), conv_norm_relu(channels, channels, 3, stride, dilation),
                conv_norm(channels, outputs, 1))
        else:
            self.branch = nn.Sequential(
                conv_norm_relu(inputs, channels, 3, stride, dilation),
                conv_norm(channels, channels, 3, 1, dilation))
        same = stride == 1 and inputs == outputs
        self.shortcut = nn.Identity() if same else conv_norm(inputs, outputs, 1, stride)
        self.relu = nn.ReLU(inplace=True)
        self.channels = outputs

    def forward(self, maps):
        return self.relu(self.branch(maps) + self.shortcut(maps))


def stage(inputs, channels, blocks, stride, dilation, bottleneck):
    """Blocks of one stage, the first of which takes the stride."""
    layers = [ResidualBlock(inputs, channels, stride, dilation, bottleneck)]
    for _ in range(blocks - 1):
        layers.append(ResidualBlock(layers[-1].channels, channels, 1, dilation, bottleneck))
    return nn.Sequential(*layers)


class ResNet(nn.Module):
    """Gives the maps of its last two stages, both at 1/8 of the image's size.

    `channels` are those of the two outputs.
    """

    stride = 8

    def __init__(self, depth, width):
        super().__init__()
        blocks, bottleneck = DEPTHS[depth]
        stem = scaled(STAGE_CHANNELS[0], width)
        self.stem = nn.Sequential(conv_norm_relu(3, stem, 7, 2), nn.MaxPool2d(3, 2, 1))
        inputs, stages = stem, []
        for count, channels, stride, dilation in zip(blocks, STAGE_CHANNELS, (1, 2, 1, 1), (1, 1, 2, 4)):
            stages.append(stage(inputs, scaled(channels, width), count, stride, dilation, bottleneck))
            inputs = stages[-1][-1].channels
        self.stages = nn.ModuleList(stages)
        self.channels = (stages[2][-1].channels, stages[3][-1].channels)

    def forward(self, image):
        maps = self.stages[1](self.stages[0](self.stem(image)))
        middle = self.stages[2](maps)
        return middle, self.stages[3](middle)
