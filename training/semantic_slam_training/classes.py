"""Which labels of the vocabulary are classes of a network."""

import dataclasses
import pathlib

import numpy as np
import yaml

from semantic_slam_training.errors import TrainingError

IGNORE = 255  # class index of pixels that no loss and no metric looks at
OPTIONAL = -1  # class index of boxes that may be found or not
VOCABULARY_FILE = pathlib.Path(__file__).resolve().parents[2] / "config/labels.yaml"


@dataclasses.dataclass(frozen=True)
class ClassList:
    """Names of a network's classes, in the order of its scores, and the class of each label id.

    `of_label` is uint8 of 256: class index of each id of config/labels.yaml, IGNORE if it is in none.
    `optional`: ids of which a detector may find objects or not: they could as well be of one of the classes.
    `least_visible_share`: objects of which less is visible may be found or not, too.
    """

    names: tuple
    of_label: np.ndarray
    optional: frozenset = frozenset()
    least_visible_share: float = 0.0


def read_yaml(path):
    """The content of a YAML file, which must be a map."""
    try:
        content = yaml.safe_load(pathlib.Path(path).read_text())
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        raise TrainingError(f"{path}: not YAML: {' '.join(str(error).split())}") from error
    if not isinstance(content, dict):
        raise TrainingError(f"{path}: expected a map of keys and values")
    return content


def read_vocabulary(path=VOCABULARY_FILE):
    """Name -> id of every label."""
    return {label["name"]: label["id"] for label in read_yaml(path)["labels"]}


def label_id(path, name, vocabulary):
    if name not in vocabulary:
        raise TrainingError(f"{path}: '{name}' is no label of config/labels.yaml")
    return vocabulary[name]


def read_class_list(path, vocabulary=None):
    """Reads `classes: [names]` and what else there may be: `merge: {label: class}` for labels that count as
    another class, and for objects that may be found or not `optional: [labels]` and `least_visible_share: 0 to 1`."""
    vocabulary = vocabulary or read_vocabulary()
    content = read_yaml(path)
    names = tuple(content.get("classes") or ())
    if not names or len(set(names)) != len(names) or len(names) > IGNORE:
        raise TrainingError(f"{path}: classes: expected 1 to {IGNORE} names, each once")
    of_label = np.full(256, IGNORE, np.uint8)
    for index, name in enumerate(names):
        of_label[label_id(path, name, vocabulary)] = index
    for name, merged_into in (content.get("merge") or {}).items():
        if merged_into not in names:
            raise TrainingError(f"{path}: merge: '{merged_into}' is none of the classes")
        of_label[label_id(path, name, vocabulary)] = names.index(merged_into)
    optional = {name: label_id(path, name, vocabulary) for name in content.get("optional") or ()}
    for name, label in optional.items():
        if of_label[label] != IGNORE:
            raise TrainingError(f"{path}: optional: '{name}' is one of the classes or merged into one")
    share = content.get("least_visible_share", 0.0)
    if not isinstance(share, (int, float)) or not 0 <= share <= 1:
        raise TrainingError(f"{path}: least_visible_share: {share}, expected 0 to 1")
    return ClassList(names, of_label, frozenset(optional.values()), float(share))
