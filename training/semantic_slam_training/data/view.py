"""Where a network's input shows an image: affine maps, 2 x 3, from pixels of the image to those of the
input, by pixel centres."""

import math

import cv2
import numpy as np

from semantic_slam_training.classes import IGNORE

LEAST_SIDE_PX = 3.0


def compose(linear, image_size, input_size, offset):
    """A view of which `linear` (2 x 2) turns and scales about the image's centre, then shifted [px]."""
    centre = (np.array(image_size) - 1) / 2
    target = (np.array(input_size) - 1) / 2 + offset
    return np.column_stack([linear, target - linear @ centre])


def letterbox(image_size, input_size):
    """The image as a whole, in the middle; sizes are (width, height)."""
    scale = min(target / source for source, target in zip(image_size, input_size))
    return compose(np.eye(2) * scale, image_size, input_size, np.zeros(2))


def random_view(random, image_size, input_size, options):
    """Turned, scaled, shifted and flipped at random, as the options allow."""
    fitted = min(target / source for source, target in zip(image_size, input_size))
    scale = fitted * math.exp(random.uniform(math.log(options.least_scale), math.log(options.most_scale)))
    angle = math.radians(random.uniform(-options.rotation_deg, options.rotation_deg))
    mirror = -1.0 if random.random() < options.flip_probability else 1.0
    turned = scale * np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    slack = np.abs(np.array(image_size) * scale - np.array(input_size)) / 2
    shift = np.array(input_size) * options.shift
    offset = random.uniform(-1, 1, 2) * (slack + shift)
    return compose(turned @ np.diag([mirror, 1.0]), image_size, input_size, offset)


def shrink(view, stride):
    """The same view in an input that is `stride` times smaller."""
    return np.column_stack([view[:, :2] / stride, (view[:, 2] + 0.5) / stride - 0.5])


def view_image(image, view, input_size, pad):
    """Bilinear; `pad` is the grey level around the image."""
    return cv2.warpAffine(image, view, input_size, flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT,
                          borderValue=(pad, pad, pad))


def view_labels(labels, view, input_size):
    """The nearest pixel's; IGNORE around the image."""
    return cv2.warpAffine(labels, view, input_size, flags=cv2.INTER_NEAREST, borderMode=cv2.BORDER_CONSTANT,
                          borderValue=IGNORE)


def corners(boxes):
    """n x 4 x 2."""
    left, top, right, bottom = boxes.T
    return np.stack([np.stack([left, top], 1), np.stack([right, top], 1), np.stack([right, bottom], 1),
                     np.stack([left, bottom], 1)], 1)


def view_boxes(boxes, view, input_size):
    """Boxes around the turned ones, cut at the input's edges, and which share of each is left; 0 if that is too small.

    Edges of boxes count from the outer edge of the first pixel, half a pixel from its centre.
    """
    moved = (corners(boxes) - 0.5) @ view[:, :2].T + view[:, 2] + 0.5
    whole = np.concatenate([moved.min(1), moved.max(1)], 1)
    cut = whole.clip(0, np.tile(input_size, 2))
    sides, whole_sides = cut[:, 2:] - cut[:, :2], whole[:, 2:] - whole[:, :2]
    shares = sides.prod(1) / whole_sides.prod(1).clip(min=1e-6)
    return cut.astype(np.float32), np.where(sides.min(1, initial=np.inf) >= LEAST_SIDE_PX, shares, 0.0)
