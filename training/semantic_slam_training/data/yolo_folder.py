"""Photos with boxes as YOLO's tools and Roboflow keep them: a data.yaml, images and labels.

    data.yaml          names: [chair, ...]   train: images/train   val: images/val   path: (optional)
    images/train/*.jpg labels/train/*.txt    a box a line: class cx cy width height, shares of the image's size
A split may also be a .txt file that lists images. Labels are where "images" in the path is "labels".
"""

import pathlib

import numpy as np

from semantic_slam_training.classes import read_yaml
from semantic_slam_training.data.box_files import read_boxes
from semantic_slam_training.data.image_files import images_in, read_colour
from semantic_slam_training.errors import TrainingError


def read_names(path, content):
    names = content.get("names")
    if isinstance(names, dict):
        names = [names[key] for key in sorted(names)]
    if not names:
        raise TrainingError(f"{path}: names: expected the classes' names")
    return tuple(str(name) for name in names)


def split_folder(path, content, split):
    """Roboflow writes ../train/images for what lies beside the file, so that is looked for too."""
    name = content.get(split)
    if not isinstance(name, str):
        raise TrainingError(f"{path}: {split}: expected a folder or a list of images")
    base = path.parent / str(content.get("path", "."))
    for candidate in (base / name, path.parent / name, path.parent / name.removeprefix("../")):
        if candidate.exists():
            return candidate
    raise TrainingError(f"{path}: {split}: {base / name} does not exist")


def list_images(source):
    if source.is_dir():
        return images_in(source)
    return [source.parent / line.strip() for line in source.read_text().splitlines() if line.strip()]


def labels_file(image):
    """The last folder called images is called labels."""
    parts = list(image.parts)
    for index in range(len(parts) - 2, -1, -1):
        if parts[index] == "images":
            parts[index] = "labels"
            break
    return pathlib.Path(*parts).with_suffix(".txt")


class YoloFolder:
    """Images and the boxes of the objects in them, of the split `train`, `val` or `test`."""

    pixel_classes = None

    def __init__(self, data_file, split):
        data_file = pathlib.Path(data_file)
        content = read_yaml(data_file)
        self.names = read_names(data_file, content)
        self._images = list_images(split_folder(data_file, content, split))
        if not self._images:
            raise TrainingError(f"{data_file}: {split}: no images in it")

    def __len__(self):
        return len(self._images)

    def read(self, index):
        """Colour image, boxes n x 4 [px] (left, top, right, bottom; float32), class indices n (int64); and None: no
        pixels' classes are known."""
        image = read_colour(self._images[index])
        path = labels_file(self._images[index])
        boxes, classes, _ = read_boxes(path, image.shape)
        if np.any((classes < 0) | (classes >= len(self.names))):
            raise TrainingError(f"{path}: expected classes 0 to {len(self.names) - 1}")
        return image, boxes, classes, None
