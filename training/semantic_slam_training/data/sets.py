"""Finds out what kind of data set a path is."""

import pathlib

from semantic_slam_training.classes import read_class_list
from semantic_slam_training.data.rendered import (
    RenderedDetection, RenderedObjects, RenderedSegmentation, sequence_folders)
from semantic_slam_training.data.sun_rgbd import SunRgbd, is_sun_rgbd
from semantic_slam_training.data.yolo_folder import YoloFolder
from semantic_slam_training.errors import TrainingError


def check_rendered(roots):
    for root in roots:
        if not pathlib.Path(root).is_dir():
            raise TrainingError(f"{root}: no such folder")
        if not sequence_folders(root):
            raise TrainingError(f"{root}: no rgb.txt in it or below it, so no rendered set; see training/README.md")


def open_segmentation(roots, split, classes_file):
    """`roots`: folders; `split`: train or test, of data sets that have both in one folder."""
    classes = read_class_list(classes_file)
    if len(roots) == 1 and is_sun_rgbd(roots[0]):
        return SunRgbd(roots[0], split, classes)
    check_rendered(roots)
    return RenderedSegmentation(roots, classes)


def is_yolo_folder(root):
    root = pathlib.Path(root)
    return root.suffix in (".yaml", ".yml") or (root / "data.yaml").is_file()


def open_detection(roots, split, classes_file, pixel_classes_file=None):
    """`split`: train or val, of folders with a data.yaml, whose own classes count. `pixel_classes_file`: classes of
    pixels, of rendered sets, to be read too."""
    if len(roots) == 1 and is_yolo_folder(roots[0]):
        root = pathlib.Path(roots[0])
        return YoloFolder(root / "data.yaml" if root.is_dir() else root, split)
    check_rendered(roots)
    pixel_classes = read_class_list(pixel_classes_file) if pixel_classes_file else None
    return RenderedDetection(roots, read_class_list(classes_file), pixel_classes)


def open_objects(roots, classes_file, least_side_px):
    check_rendered(roots)
    return RenderedObjects(roots, read_class_list(classes_file), least_side_px)


def has_both_splits(roots):
    """Whether a data set says itself which images are for validation."""
    return len(roots) == 1 and (is_sun_rgbd(roots[0]) or is_yolo_folder(roots[0]))
