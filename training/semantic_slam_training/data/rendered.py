"""Rendered sequences with their truth: folders in TUM's format, as render_sequence writes them.

A folder holds rgb.txt and the images that it lists, and what is asked for of
    labels.txt, labels/*.png        label id of each pixel, 8 bits
    instances.txt, instances/*.png  number of the object that each pixel shows, 16 bits; 0 is none
    looks.txt                       "instance look" of each object; without it each has a look of its own
    boxes/<stamp>.txt               "id cx cy width height visible" a line: id of the label, shares of the image's size,
                                    and which share of the object is visible, which may be left out
Not every image need have them; those without are left out. A set is one such folder, or one that has some below it.
"""

import dataclasses
import os
import pathlib

import numpy as np

from semantic_slam_training.classes import IGNORE, OPTIONAL
from semantic_slam_training.data.box_files import read_boxes
from semantic_slam_training.data.image_files import check_same_size, read_colour, read_ids
from semantic_slam_training.errors import TrainingError


def sequence_folders(root):
    """The folders with an rgb.txt at or below `root`, sorted."""
    return sorted(pathlib.Path(folder) for folder, _, files in os.walk(root, followlinks=True) if "rgb.txt" in files)


def read_list(path):
    """Stamp (as it is written) -> file, of a list such as rgb.txt."""
    try:
        lines = [line.split() for line in path.read_text().splitlines() if line.strip() and line[0] != "#"]
    except FileNotFoundError as error:
        raise TrainingError(f"{path}: there is no such list") from error
    if any(len(words) != 2 for words in lines):
        raise TrainingError(f"{path}: expected two words a line, stamp and file")
    return {stamp: path.parent / name for stamp, name in lines}


def pairs(roots, kind):
    """(image, image of that kind) of all sequences below the roots, where both have one stamp."""
    found = []
    for folder in (folder for root in roots for folder in sequence_folders(root)):
        others = read_list(folder / f"{kind}.txt")
        found += [(image, others[stamp]) for stamp, image in read_list(folder / "rgb.txt").items() if stamp in others]
    if not found:
        raise TrainingError(f"{', '.join(map(str, roots))}: no images with {kind} below it")
    return found


class RenderedSegmentation:
    """Images and the class of each of their pixels."""

    def __init__(self, roots, classes):
        self.names = classes.names
        self._of_label = classes.of_label
        self._pairs = pairs(roots, "labels")

    def __len__(self):
        return len(self._pairs)

    def read(self, index):
        """Colour image, and class indices height x width, uint8, IGNORE where there is none."""
        image_path, labels_path = self._pairs[index]
        image, ids = read_colour(image_path), read_ids(labels_path)
        check_same_size(image_path, image, labels_path, ids)
        return image, self._of_label[ids.clip(max=IGNORE)]


def boxes_file(image):
    return image.parents[1] / "boxes" / f"{image.stem}.txt"


class RenderedDetection:
    """Images and the boxes of the objects in them; with `pixel_classes` also the class of each of their pixels."""

    def __init__(self, roots, classes, pixel_classes=None):
        self.pixel_classes = pixel_classes
        self._labels = dict(pairs(roots, "labels")) if pixel_classes else {}
        self.names = classes.names
        self._of_label = classes.of_label.astype(np.int64)
        self._of_label[sorted(classes.optional)] = OPTIONAL
        self._least_visible_share = classes.least_visible_share
        images = [image for root in roots for folder in sequence_folders(root)
                  for image in read_list(folder / "rgb.txt").values()]
        self._images = [image for image in images if boxes_file(image).exists()]
        if not self._images:
            raise TrainingError(f"{', '.join(map(str, roots))}: no images with boxes below it")

    def __len__(self):
        return len(self._images)

    def read(self, index):
        """Colour image, boxes n x 4 [px] (left, top, right, bottom; float32), class indices n (int64; OPTIONAL for
        what may be found or not), and those of pixels as RenderedSegmentation has them, or None."""
        path = self._images[index]
        image = read_colour(path)
        boxes, ids, visible_shares = read_boxes(boxes_file(path), image.shape)
        if np.any((ids < 0) | (ids > IGNORE)):
            raise TrainingError(f"{boxes_file(path)}: expected ids of labels, 0 to {IGNORE}")
        classes = self._of_label[ids]
        kept = classes != IGNORE
        classes[kept & (visible_shares < self._least_visible_share)] = OPTIONAL
        return image, boxes[kept], classes[kept], self._read_labels(path, image)

    def _read_labels(self, path, image):
        if path not in self._labels:
            return None
        ids = read_ids(self._labels[path])
        check_same_size(path, image, self._labels[path], ids)
        return self.pixel_classes.of_label[ids.clip(max=IGNORE)]


@dataclasses.dataclass(frozen=True)
class Crop:
    """Where an object is seen: file, box (left, top, right, bottom) [px], and a number of what it looks like."""

    path: pathlib.Path
    box: tuple
    identity: int


SCAN_STEP_PX = 4  # objects are looked for at every fourth pixel
CROP_MARGIN = 0.05  # of the box's sides


def object_boxes(instances, labels, of_label, least_side_px):
    """Instance number -> box of objects of the classes that are large enough."""
    step = SCAN_STEP_PX
    seen, wanted = instances[::step, ::step], of_label[labels[::step, ::step]] != IGNORE
    boxes = {}
    for number in np.unique(seen[wanted & (seen > 0)]):
        v, u = np.nonzero(seen == number)
        box = (u.min() * step, v.min() * step, (u.max() + 1) * step, (v.max() + 1) * step)
        if min(box[2] - box[0], box[3] - box[1]) >= least_side_px:
            boxes[int(number)] = tuple(int(side) for side in box)
    return boxes


def read_looks(path):
    """Instance number -> number of its look; empty if there is no such file."""
    if not path.exists():
        return {}
    try:
        return dict(map(int, line.split()) for line in path.read_text().splitlines() if line.strip() and line[0] != "#")
    except ValueError as error:
        raise TrainingError(f"{path}: expected two whole numbers a line, instance and look") from error


class RenderedObjects:
    """Crops of objects; those of one object in one world are of one identity, and so are those of its twins, from which
    no picture tells it apart."""

    def __init__(self, roots, classes, least_side_px):
        self.crops = []
        self._identity_of = {}
        for root in roots:
            for folder in sequence_folders(root):
                self._scan(folder, classes.of_label, least_side_px)
        if not self.crops:
            raise TrainingError(f"{', '.join(map(str, roots))}: no objects of the classes in images below it")

    def _scan(self, folder, of_label, least_side_px):
        labels, instances = read_list(folder / "labels.txt"), read_list(folder / "instances.txt")
        looks = read_looks(folder / "looks.txt")
        for stamp, image in read_list(folder / "rgb.txt").items():
            if stamp in labels and stamp in instances:
                boxes = object_boxes(read_ids(instances[stamp]), read_ids(labels[stamp]), of_label, least_side_px)
                for number, box in boxes.items():
                    look = (folder, looks.get(number, -number))
                    identity = self._identity_of.setdefault(look, len(self._identity_of))
                    self.crops.append(Crop(image, box, identity))

    def __len__(self):
        return len(self.crops)

    @property
    def identities(self):
        """The object's number of each crop."""
        return np.array([crop.identity for crop in self.crops])

    def read(self, index):
        """The colour image of one object with a small margin, and its number."""
        crop = self.crops[index]
        image = read_colour(crop.path)
        left, top, right, bottom = crop.box
        across, down = int((right - left) * CROP_MARGIN), int((bottom - top) * CROP_MARGIN)
        return image[max(top - down, 0):bottom + down, max(left - across, 0):right + across], crop.identity
