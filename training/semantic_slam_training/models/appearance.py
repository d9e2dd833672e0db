"""A small network that tells objects apart by their looks, for BoT-SORT (Aharon et al., 2022)."""

from torch import nn
from torch.nn import functional

from semantic_slam_training.models.layers import conv_norm_relu, initialise, scaled
from semantic_slam_training.models.resnet import ResidualBlock

CHANNELS = (32, 64, 128, 256)
EMBEDDING = 128


class AppearanceNetwork(nn.Module):
    """For crops of objects, batch x 3 x height x width.

    Gives batch x 128 vectors, to be compared by their cosine; in training the vectors before the last
    normalisation (for distances) and the scores of the identities (Luo et al., 2019).
    """

    def __init__(self, identities, width):
        super().__init__()
        channels = [scaled(count, width) for count in CHANNELS]
        steps = list(zip(channels, channels[1:]))
        self.maps = nn.Sequential(
            conv_norm_relu(3, channels[0], 3, 2), ResidualBlock(channels[0], channels[0]),
            *(ResidualBlock(inputs, outputs, 2) for inputs, outputs in steps))
        self.embedding = nn.Conv2d(channels[-1], EMBEDDING, 1)
        self.neck = nn.BatchNorm2d(EMBEDDING)
        initialise(self)
        self.identities = nn.Linear(EMBEDDING, identities, bias=False)
        nn.init.normal_(self.identities.weight, std=0.001)

    def forward(self, crops):
        embedding = self.embedding(functional.adaptive_avg_pool2d(self.maps(crops), 1))
        vectors = self.neck(embedding).flatten(1)
        return (embedding.flatten(1), self.identities(vectors)) if self.training else vectors
