"""SegNet (Badrinarayanan et al., 2017): a decoder that puts maxima back to where they were."""

from torch import nn
from torch.nn import functional

from semantic_slam_training.models import vgg
from semantic_slam_training.models.layers import conv_norm_relu, double_size, initialise

STEEPNESS = 1e6  # of the mask of maxima: values that lie 1e-6 below one count as less


def mask_of_maxima(maps, pooled):
    """1 where a pixel is the greatest of its 2 x 2, else 0; no gradient. OpenCV 4.6 has no unpooling by index."""
    below = double_size(pooled) - maps
    return functional.relu(1.0 - STEEPNESS * below).detach()


class SegNet(nn.Module):
    """Scores of the classes at the image's size, which must be divisible by 32.

    Maxima are looked for before the rectifier, so that there are no ties.
    """

    def __init__(self, classes, width):
        super().__init__()
        self.encoder = vgg.stages(width, rectify_last=False)
        channels = vgg.stage_channels(width)
        decoder = []
        for inputs, outputs, (_, count) in zip(channels[::-1], [*channels[-2::-1], channels[0]], vgg.STAGES[::-1]):
            decoder.append(nn.Sequential(*(conv_norm_relu(inputs, inputs) for _ in range(count - 1)),
                                         conv_norm_relu(inputs, outputs)))
        self.decoder = nn.ModuleList(decoder)
        self.head = nn.Conv2d(channels[0], classes, 1)
        initialise(self)

    def forward(self, image):
        maps, masks = image, []
        for stage in self.encoder:
            before = stage(maps)
            pooled = functional.max_pool2d(before, 2)
            masks.append(mask_of_maxima(before, pooled))
            maps = functional.relu(pooled)
        for stage, mask in zip(self.decoder, reversed(masks)):
            maps = stage(double_size(maps) * mask)
        scores = self.head(maps)
        return [scores] if self.training else scores
