"""SUN RGB-D (Song et al., 2015): 10 335 photos with 37 classes and "left out"; 5285 train, 5050 test.

Two layouts of the 37-class labels are read. Ids in the PNG files are those of config/labels.yaml.

As its archives unpack (github.com/ankurhanda/sunrgbd-meta-data), where the labels of the test photos
come first, so those of training begin with img-005051.png:
    SUNRGBD-train_images/*.jpg   SUNRGBD-test_images/*.jpg   sunrgbd_train_test_labels/*.png
As reorganised (github.com/chrischoy/SUN_RGBD):
    image/{train,test}/*.jpg   label37/{train,test}/*.png
Photos and labels belong together in the order of their names.
"""

import pathlib

from semantic_slam_training.classes import IGNORE
from semantic_slam_training.data.image_files import check_same_size, images_in, read_colour, read_ids
from semantic_slam_training.errors import TrainingError

ARCHIVE_LABELS = "sunrgbd_train_test_labels"
REORGANISED_LABELS = "label37"


def is_sun_rgbd(root):
    return any((pathlib.Path(root) / name).is_dir() for name in (ARCHIVE_LABELS, REORGANISED_LABELS))


def archive_files(root, split):
    images = images_in(root / f"SUNRGBD-{split}_images")
    labels = images_in(root / ARCHIVE_LABELS)
    tests = len(images_in(root / "SUNRGBD-test_images"))
    return images, labels[:tests] if split == "test" else labels[tests:]


def reorganised_files(root, split):
    return images_in(root / "image" / split), images_in(root / REORGANISED_LABELS / split)


class SunRgbd:
    """Photos and the class of each of their pixels, of the split `train` or `test`."""

    def __init__(self, root, split, classes):
        root = pathlib.Path(root)
        files = archive_files if (root / ARCHIVE_LABELS).is_dir() else reorganised_files
        images, labels = files(root, split)
        if not images or len(images) != len(labels):
            raise TrainingError(f"{root}: {len(images)} photos and {len(labels)} label images of the split {split}; "
                                "expected equally many")
        self.names = classes.names
        self._of_label = classes.of_label
        self._pairs = list(zip(images, labels))

    def __len__(self):
        return len(self._pairs)

    def read(self, index):
        """Colour image, and class indices height x width, uint8, IGNORE where there is none."""
        image_path, labels_path = self._pairs[index]
        image, ids = read_colour(image_path), read_ids(labels_path)
        check_same_size(image_path, image, labels_path, ids)
        return image, self._of_label[ids.clip(max=IGNORE)]
