"""What a network wants to see; the same words are in its model card, docs/models.md."""

import dataclasses
import functools

import cv2
import numpy as np

GREY_LEVELS = 255.0
IMAGENET_MEAN = (0.485, 0.456, 0.406)
IMAGENET_STD = (0.229, 0.224, 0.225)


@functools.lru_cache
def number_table(mean, std):
    """1 x 256 x 3, float32: the number that stands for each grey level of each channel."""
    levels = np.arange(256, dtype=np.float32)[:, None] / np.float32(GREY_LEVELS)
    return ((levels - np.float32(mean)) / np.float32(std))[None]


@dataclasses.dataclass(frozen=True)
class InputFormat:
    """Size [px], and how grey levels become numbers: (level / 255 - mean) / std, red first."""

    width: int
    height: int
    mean: tuple = IMAGENET_MEAN
    std: tuple = IMAGENET_STD
    pad: int = 124  # grey level around a letterboxed image

    @property
    def size(self):
        """(width, height)"""
        return self.width, self.height

    def to_blob(self, image):
        """3 x height x width, float32, of height x width x 3, uint8."""
        numbers = cv2.LUT(image, number_table(self.mean, self.std))
        return np.ascontiguousarray(numbers.transpose(2, 0, 1))


def unscaled_input(width, height):
    """YOLO's: red, green and blue 0 to 1, grey padding."""
    return InputFormat(width, height, (0.0, 0.0, 0.0), (1.0, 1.0, 1.0), 114)
