"""Items of a data set as a network sees them: read, viewed, changed at random, as tensors.

Each item is a pure function of (seed, step, place in the batch), so that training can stop and go on.
"""

import numpy as np
import torch

from semantic_slam_training.classes import IGNORE, OPTIONAL
from semantic_slam_training.data.augmentation import change_light
from semantic_slam_training.data.view import letterbox, random_view, shrink, view_boxes, view_image, view_labels


class Samples:
    """What is common to all: the random view and light of an item.

    `augmentation` None shows each image as a whole and unchanged.
    """

    def __init__(self, dataset, input_format, augmentation=None, seed=0):
        self.dataset = dataset
        self.format = input_format
        self.augmentation = augmentation
        self.seed = seed

    def __getitem__(self, key):
        """`key`: (step, place in the batch, index in the data set)."""
        step, place, index = key
        return self.make(np.random.default_rng([self.seed, step, place]), self.dataset.read(index))

    def show(self, random, image):
        """The input's image, and the view that shows it."""
        size = image.shape[1], image.shape[0]
        if self.augmentation is None:
            view = letterbox(size, self.format.size)
            return view_image(image, view, self.format.size, self.format.pad), view
        view = random_view(random, size, self.format.size, self.augmentation)
        shown = view_image(image, view, self.format.size, self.format.pad)
        return change_light(random, shown, self.augmentation), view

    def make(self, random, item):
        raise NotImplementedError

    def collate(self, items):
        """Tensors of a batch of items."""
        raise NotImplementedError


class SegmentationSamples(Samples):
    """Blobs, batch x 3 x height x width, and class indices, batch x h x w, int64.

    There is a label at every `label_stride`th pixel each way.
    """

    def __init__(self, dataset, input_format, augmentation=None, seed=0, label_stride=1):
        super().__init__(dataset, input_format, augmentation, seed)
        self.label_stride = label_stride

    def make(self, random, item):
        image, labels = item
        shown, view = self.show(random, image)
        size = self.format.width // self.label_stride, self.format.height // self.label_stride
        return self.format.to_blob(shown), view_labels(labels, shrink(view, self.label_stride), size)

    def collate(self, items):
        blobs, labels = zip(*items)
        return torch.from_numpy(np.stack(blobs)), torch.from_numpy(np.stack(labels).astype(np.int64))


LEAST_SHARE_LEFT = 0.3  # of a box's area; what the view cuts more of may be found or not


class DetectionSamples(Samples):
    """Blobs; boxes and classes of each image's objects, see pad_objects(); and class indices, batch x h x w, int64,
    of every `label_stride`th pixel each way, IGNORE where none is known."""

    def __init__(self, dataset, input_format, augmentation=None, seed=0, label_stride=8):
        super().__init__(dataset, input_format, augmentation, seed)
        self.label_stride = label_stride

    def make(self, random, item):
        image, boxes, classes, labels = item
        shown, view = self.show(random, image)
        boxes, shares = view_boxes(boxes, view, self.format.size)
        classes = np.where(shares < LEAST_SHARE_LEFT, OPTIONAL, classes)
        size = self.format.width // self.label_stride, self.format.height // self.label_stride
        if labels is None:
            labels = np.full(size[::-1], IGNORE, np.uint8)
        else:
            labels = view_labels(labels, shrink(view, self.label_stride), size)
        return self.format.to_blob(shown), boxes[shares > 0], classes[shares > 0], labels

    def collate(self, items):
        blobs, boxes, classes, labels = zip(*items)
        labels = torch.from_numpy(np.stack(labels).astype(np.int64))
        return torch.from_numpy(np.stack(blobs)), *pad_objects(boxes, classes), labels


def pad_objects(boxes, classes):
    """Tensors batch x n x 4, batch x n (int64) and, both batch x n (bool), where there is an object that is to be
    found and where one that may be found or not."""
    most = max(len(each) for each in boxes)
    padded = torch.zeros(len(boxes), most, 4), torch.zeros(len(boxes), most, dtype=torch.int64)
    present = torch.zeros(len(boxes), most, dtype=torch.bool)
    optional = torch.zeros(len(boxes), most, dtype=torch.bool)
    for index, (box, kind) in enumerate(zip(boxes, classes)):
        padded[0][index, :len(box)] = torch.from_numpy(box)
        padded[1][index, :len(box)] = torch.from_numpy(kind.clip(0))
        present[index, :len(box)] = torch.from_numpy(kind != OPTIONAL)
        optional[index, :len(box)] = torch.from_numpy(kind == OPTIONAL)
    return *padded, present, optional


class AppearanceSamples(Samples):
    """Blobs of crops, and the numbers of the objects in them, int64."""

    def make(self, random, item):
        image, identity = item
        return self.format.to_blob(self.show(random, image)[0]), identity

    def collate(self, items):
        blobs, identities = zip(*items)
        return torch.from_numpy(np.stack(blobs)), torch.tensor(identities)
