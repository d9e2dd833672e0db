"""classes.py: which labels are classes, and lists that are wrong."""

import needs_torch  # noqa: F401
import pytest

from semantic_slam_training.classes import IGNORE, read_class_list
from semantic_slam_training.errors import TrainingError

VOCABULARY = {"unknown": 0, "wall": 1, "table": 7, "coffee_table": 38}


def test_labels_become_classes_or_are_ignored(tmp_path):
    path = tmp_path / "classes.yaml"
    path.write_text("classes: [table, wall]\nmerge: {coffee_table: table}\n")
    classes = read_class_list(path, VOCABULARY)
    assert classes.names == ("table", "wall")
    assert classes.of_label[[7, 38, 1, 0, 200]].tolist() == [0, 0, 1, IGNORE, IGNORE]


def test_labels_may_be_optional(tmp_path):
    path = tmp_path / "classes.yaml"
    path.write_text("classes: [coffee_table]\noptional: [table]\n")
    classes = read_class_list(path, VOCABULARY)
    assert classes.optional == {7} and classes.of_label[7] == IGNORE


def test_hidden_objects_may_be_optional(tmp_path):
    path = tmp_path / "classes.yaml"
    path.write_text("classes: [wall]\n")
    assert read_class_list(path, VOCABULARY).least_visible_share == 0.0
    path.write_text("classes: [wall]\nleast_visible_share: 0.5\n")
    assert read_class_list(path, VOCABULARY).least_visible_share == 0.5


@pytest.mark.parametrize("text, words", [
    ("classes: [wall, wall]", "each once"),
    ("classes: []", "1 to 255 names"),
    ("classes: [wal]", "'wal' is no label"),
    ("classes: [wall]\nmerge: {table: tabel}", "'tabel' is none of the classes"),
    ("classes: [wall]\noptional: [tabel]", "'tabel' is no label"),
    ("classes: [wall]\noptional: [wall]", "'wall' is one of the classes"),
    ("classes: [wall]\nleast_visible_share: 1.5", "least_visible_share: 1.5, expected 0 to 1"),
    ("classes: [wall]\nleast_visible_share: half", "least_visible_share: half, expected 0 to 1"),
    ("classes: [wall", "not YAML"),
    ("wall", "expected a map"),
])
def test_a_wrong_list_is_refused_in_one_line(tmp_path, text, words):
    path = tmp_path / "classes.yaml"
    path.write_text(text)
    with pytest.raises(TrainingError) as error:
        read_class_list(path, VOCABULARY)
    assert words in str(error.value) and str(path) in str(error.value) and "\n" not in str(error.value)


@pytest.mark.parametrize("name, count", [("indoor", 22), ("furniture", 6), ("sun_rgbd", 38), ("appearance", 22)])
def test_the_lists_that_come_along_fit_the_vocabulary(repository, name, count):
    assert len(read_class_list(repository / f"training/classes/{name}.yaml").names) == count
