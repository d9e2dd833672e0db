"""The thirteen convolutions of VGG16 (Simonyan and Zisserman, 2015), with batch normalisation."""

from torch import nn

from semantic_slam_training.models.layers import conv_norm, conv_norm_relu, scaled

STAGES = ((64, 2), (128, 2), (256, 3), (512, 3), (512, 3))  # channels and convolutions


def stage_channels(width):
    return [scaled(channels, width) for channels, _ in STAGES]


def stage(inputs, outputs, convolutions, rectify_last=True):
    """Convolutions of one stage, all at one size."""
    widths = [inputs] + [outputs] * convolutions
    layers = [conv_norm_relu(a, b) for a, b in zip(widths, widths[1:])]
    if not rectify_last:
        layers[-1] = conv_norm(widths[-2], outputs)
    return nn.Sequential(*layers)


def stages(width, rectify_last=True):
    """The five stages; what lies between them (pooling) is up to the network."""
    channels = [3, *stage_channels(width)]
    return nn.ModuleList(stage(a, b, count, rectify_last)
                         for a, b, (_, count) in zip(channels, channels[1:], STAGES))
