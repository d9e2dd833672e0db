"""Overlap of boxes. Boxes are ... x 4: left, top, right, bottom [px]."""

import math

import torch

EPSILON = 1e-7


def areas(boxes):
    """0 where a box is inside out."""
    return (boxes[..., 2:] - boxes[..., :2]).clamp(min=0).prod(-1)


def intersection_over_union(a, b):
    """Of boxes that broadcast against each other."""
    low = torch.maximum(a[..., :2], b[..., :2])
    high = torch.minimum(a[..., 2:], b[..., 2:])
    common = (high - low).clamp(min=0).prod(-1)
    return common / (areas(a) + areas(b) - common + EPSILON)


def aspect_angles(boxes):
    sides = (boxes[..., 2:] - boxes[..., :2]).clamp(min=EPSILON)
    return torch.atan(sides[..., 0] / sides[..., 1])


def complete_iou(a, b):
    """CIoU (Zheng et al., 2020): the overlap less penalties for distance and aspect; -1.5 to 1."""
    overlap = intersection_over_union(a, b)
    hull = torch.maximum(a[..., 2:], b[..., 2:]) - torch.minimum(a[..., :2], b[..., :2])
    offset = (a[..., :2] + a[..., 2:] - b[..., :2] - b[..., 2:]) / 2
    distance = offset.square().sum(-1) / (hull.square().sum(-1) + EPSILON)
    aspect = 4 / math.pi ** 2 * (aspect_angles(a) - aspect_angles(b)).square()
    with torch.no_grad():
        share = aspect / (1 - overlap + aspect + EPSILON)
    return overlap - distance - share * aspect
