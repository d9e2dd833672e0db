"""Fully convolutional networks (Long et al., 2015) on VGG16: FCN-16s and FCN-8s."""

from torch import nn
from torch.nn import functional

from semantic_slam_training.models import vgg
from semantic_slam_training.models.layers import conv_norm_relu, initialise, resize, scaled

HIDDEN_CHANNELS = 4096
DROPOUT = 0.5
STAGE_OF_STRIDE = {16: 3, 8: 2}  # the stage of VGG16 whose pooled maps have that stride


class Fcn(nn.Module):
    """Scores of the classes at 1/16 or 1/8 of the image's size; bilinear enlargement is left to the user."""

    def __init__(self, classes, width, stride):
        super().__init__()
        channels = vgg.stage_channels(width)
        hidden = scaled(HIDDEN_CHANNELS, width)
        self.stages = vgg.stages(width)
        self.hidden = nn.Sequential(conv_norm_relu(channels[-1], hidden, 7), nn.Dropout2d(DROPOUT),
                                    conv_norm_relu(hidden, hidden, 1), nn.Dropout2d(DROPOUT))
        self.head = nn.Conv2d(hidden, classes, 1)
        self.first_skipped = STAGE_OF_STRIDE[stride]
        self.skips = nn.ModuleList(nn.Conv2d(count, classes, 1) for count in channels[self.first_skipped:-1])
        initialise(self)

    def forward(self, image):
        maps, pooled = image, []
        for stage in self.stages:
            maps = functional.max_pool2d(stage(maps), 2)
            pooled.append(maps)
        scores = self.head(self.hidden(maps))
        for skip, maps in zip(reversed(self.skips), reversed(pooled[self.first_skipped:-1])):
            scores = resize(scores, maps.shape[2:]) + skip(maps)
        return [scores] if self.training else scores


def fcn16s(classes, width):
    return Fcn(classes, width, 16)


def fcn8s(classes, width):
    return Fcn(classes, width, 8)
