"""Losses that draw crops of one object together and those of others apart."""

import torch
from torch.nn import functional

LABEL_SMOOTHING = 0.1


def pairwise_distances(vectors):
    """Euclidean: count x count; the small number keeps the gradient finite where two are equal."""
    differences = vectors[:, None] - vectors[None]
    return (differences.square().sum(-1) + 1e-12).sqrt()


def batch_hard_triplet_loss(vectors, identities):
    """The farthest crop of the same object against the nearest of another, with a soft margin.

    Hermans et al., 2017. vectors: count x length, identities: count (int64).
    """
    distances = pairwise_distances(vectors)
    same = identities[:, None] == identities[None]
    farthest_same = distances.masked_fill(~same, 0.0).amax(1)
    nearest_other = distances.masked_fill(same, torch.inf).amin(1)
    return functional.softplus(farthest_same - nearest_other).mean()


def appearance_loss(vectors, scores, identities):
    """Cross entropy of the identities and the triplet loss, by name."""
    return {
        "identity": functional.cross_entropy(scores.float(), identities, label_smoothing=LABEL_SMOOTHING),
        "triplet": batch_hard_triplet_loss(vectors.float(), identities),
    }
