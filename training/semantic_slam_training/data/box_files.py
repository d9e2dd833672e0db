"""Boxes in YOLO's text format."""

import numpy as np

from semantic_slam_training.errors import TrainingError


def parse_row(path, number, line):
    """Class, left, top, right, bottom [shares of the image], visible share; of a polygon its bounding box."""
    try:
        first, *values = [float(word) for word in line.split()]
    except ValueError as error:
        raise TrainingError(f"{path}:{number}: '{line.strip()}' are no numbers") from error
    if len(values) in (4, 5):
        x, y, width, height, visible = values if len(values) == 5 else (*values, 1.0)
        return first, x - width / 2, y - height / 2, x + width / 2, y + height / 2, visible
    if len(values) >= 6 and len(values) % 2 == 0:
        return first, min(values[::2]), min(values[1::2]), max(values[::2]), max(values[1::2]), 1.0
    raise TrainingError(f"{path}:{number}: expected class, cx, cy, width, height, or class and a polygon")


def read_boxes(path, shape):
    """Boxes n x 4 [px] (left, top, right, bottom; float32), their classes n (int64), and which share n (float32) of
    each object is visible: a sixth word of a line, which rendered sets have; else 1.

    None if there is no such file: an image without objects. `shape` begins with height and width.
    """
    lines = path.read_text().splitlines() if path.exists() else []
    rows = [parse_row(path, number, line) for number, line in enumerate(lines, 1) if line.strip()]
    table = np.array(rows, np.float64).reshape(-1, 6)
    height, width = shape[:2]
    boxes = table[:, 1:5].clip(0, 1) * (width, height, width, height)
    return boxes.astype(np.float32), table[:, 0].astype(np.int64), table[:, 5].astype(np.float32)
