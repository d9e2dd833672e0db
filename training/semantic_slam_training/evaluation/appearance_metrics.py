"""How well vectors tell the same object from others."""

import numpy as np


def area_under_curve(positive, negative):
    """Chance that a positive value is above a negative one, ties counted half (Mann and Whitney, 1947)."""
    values, index = np.unique(np.concatenate([positive, negative]), return_inverse=True)
    above = np.bincount(index[:len(positive)], minlength=len(values))
    below = np.bincount(index[len(positive):], minlength=len(values))
    lower = np.cumsum(below) - below
    return float((above * (lower + 0.5 * below)).sum() / (len(positive) * len(negative)))


def separation(vectors, identities):
    """AUC of the cosine of all pairs of crops: the same object against other objects.

    vectors: count x length; identities: count. NaN if there are no pairs of either kind.
    """
    vectors = vectors / np.linalg.norm(vectors, axis=1, keepdims=True).clip(min=1e-12)
    first, second = np.triu_indices(len(vectors), 1)
    cosines = (vectors @ vectors.T)[first, second]
    same = identities[first] == identities[second]
    if same.all() or not same.any():
        return float("nan")
    return area_under_curve(cosines[same], cosines[~same])
