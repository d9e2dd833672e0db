"""Images on disk. Colour images are height x width x 3, uint8, red first."""

import pathlib

import cv2
import numpy as np

from semantic_slam_training.errors import TrainingError


def read_colour(path):
    image = cv2.imread(str(path), cv2.IMREAD_COLOR)
    if image is None:
        raise TrainingError(f"{path}: not a readable image")
    return cv2.cvtColor(image, cv2.COLOR_BGR2RGB)


def read_ids(path):
    """height x width, uint8 or uint16: ids of labels or instances."""
    image = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    if image is None or image.ndim != 2 or image.dtype not in (np.uint8, np.uint16):
        raise TrainingError(f"{path}: expected a readable grey image of 8 or 16 bits")
    return image


def check_same_size(image_path, image, ids_path, ids):
    if image.shape[:2] != ids.shape:
        raise TrainingError(f"{ids_path}: {ids.shape[1]} x {ids.shape[0]} px, but {image_path} has "
                            f"{image.shape[1]} x {image.shape[0]}")


def images_in(folder):
    """The JPEG and PNG files in a folder, by name; none if it does not exist."""
    return sorted(path for path in pathlib.Path(folder).glob("*") if path.suffix.lower() in (".jpg", ".jpeg", ".png"))
