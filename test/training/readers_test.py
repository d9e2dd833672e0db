"""data/: the layouts of data sets, and one line on what is wrong with a folder."""

import dataclasses

import needs_torch  # noqa: F401
import numpy as np
import pytest
from tiny_sets import CHAIR, SOFA, WALL, fill, scene, write_image, write_rendered, write_yolo_folder

from semantic_slam_training.classes import IGNORE, OPTIONAL, ClassList
from semantic_slam_training.data.rendered import RenderedDetection, RenderedObjects, RenderedSegmentation
from semantic_slam_training.data.sets import open_detection, open_segmentation
from semantic_slam_training.data.sun_rgbd import SunRgbd, is_sun_rgbd
from semantic_slam_training.data.yolo_folder import YoloFolder
from semantic_slam_training.errors import TrainingError


@pytest.fixture(name="classes")
def fixture_classes():
    of_label = np.full(256, IGNORE, np.uint8)
    of_label[[CHAIR, SOFA]] = 0, 1
    return ClassList(("chair", "sofa"), of_label)


@pytest.fixture(name="rendered")
def fixture_rendered(tmp_path):
    """Two worlds; returns the root and the boxes of the first."""
    boxes = write_rendered(tmp_path / "worlds/a", 2)
    write_rendered(tmp_path / "worlds/b", 1, first_seed=5, label=SOFA)
    return tmp_path / "worlds", boxes


def test_rendered_pixels_have_classes(rendered, classes):
    root, boxes = rendered
    dataset = RenderedSegmentation([root], classes)
    assert len(dataset) == 3
    image, labels = dataset.read(1)
    assert np.array_equal(image, scene(1)[0])
    assert np.array_equal(labels, fill(labels.shape, boxes[1], 0, IGNORE, np.uint8))
    assert 1 in dataset.read(2)[1]


def test_rendered_boxes_of_other_labels_are_left_out(rendered, classes):
    root, boxes = rendered
    image, found, kinds, labels = RenderedDetection([root], classes).read(1)
    assert image.shape == (48, 64, 3)
    assert found.tolist() == [pytest.approx(boxes[1], abs=1e-3)]  # six digits in the file
    assert kinds.tolist() == [0] and labels is None


def test_rendered_boxes_may_come_with_pixels_classes(rendered, classes):
    root, boxes = rendered
    labels = RenderedDetection([root], classes, pixel_classes=classes).read(1)[3]
    assert np.array_equal(labels, fill(labels.shape, boxes[1], 0, IGNORE, np.uint8))


def test_rendered_boxes_of_optional_labels_are_marked(rendered, classes):
    optional = dataclasses.replace(classes, optional=frozenset([WALL]))
    assert RenderedDetection([rendered[0]], optional).read(1)[2].tolist() == [0, OPTIONAL]


def test_rendered_boxes_of_hidden_objects_are_optional(rendered, classes):
    root, _ = rendered
    path = root / "b/boxes/0.500000.txt"
    line = path.read_text().splitlines()[0]
    path.write_text(f"{line} 0.4\n{line} 0.6\n{line}\n")
    wanted = dataclasses.replace(classes, least_visible_share=0.5)
    sets = [RenderedDetection([root], each) for each in (classes, wanted)]
    image = next(index for index in range(len(sets[0])) if len(sets[0].read(index)[1]) == 3)
    assert [each.read(image)[2].tolist() for each in sets] == [[1, 1, 1], [OPTIONAL, 1, 1]]


def test_rendered_images_without_a_file_of_boxes_are_left_out(rendered, classes):
    (rendered[0] / "a/boxes/0.500000.txt").unlink()
    (rendered[0] / "b/boxes/0.500000.txt").write_text("")
    dataset = RenderedDetection([rendered[0]], classes)
    assert [len(dataset.read(index)[1]) for index in range(len(dataset))] == [1, 0]


def test_rendered_objects_that_look_alike_are_one(rendered, classes):
    root, boxes = rendered
    write_image(root / "a/instances/1.500000.png", fill((48, 64), boxes[1], 8, 0, np.uint16))
    assert RenderedObjects([root], classes, least_side_px=10).identities.tolist() == [0, 1, 2]
    (root / "a/looks.txt").write_text("# instance look\n7 3\n8 3\n")
    assert RenderedObjects([root], classes, least_side_px=10).identities.tolist() == [0, 0, 1]
    (root / "a/looks.txt").write_text("7 chair\n")
    with pytest.raises(TrainingError, match="looks.txt: expected two whole numbers"):
        RenderedObjects([root], classes, least_side_px=10)


def test_rendered_objects_are_known_again_within_a_world(rendered, classes):
    root, boxes = rendered
    dataset = RenderedObjects([root], classes, least_side_px=10)
    assert dataset.identities.tolist() == [0, 0, 1]
    crop, identity = dataset.read(0)
    assert identity == 0
    assert crop.shape[0] == pytest.approx(boxes[0][3] - boxes[0][1], abs=9)  # scanned every 4 px, with margin
    assert crop.mean() > 100  # the box is bright


def test_small_objects_are_left_out(rendered, classes):
    with pytest.raises(TrainingError, match="no objects of the classes"):
        RenderedObjects([rendered[0]], classes, least_side_px=40)


def write_labels(folder, names, first_id=0):
    for number, name in enumerate(names):
        write_image(folder / name, np.full((48, 64), first_id + number, np.uint8))


def write_photos(folder, names):
    for name in names:
        write_image(folder / name, scene(0)[0])


def test_sun_rgbd_as_unpacked_has_labels_of_tests_first(tmp_path, classes):
    write_photos(tmp_path / "SUNRGBD-train_images", ["img-000001.png", "img-000002.png"])
    write_photos(tmp_path / "SUNRGBD-test_images", ["img-000001.png"])
    write_labels(tmp_path / "sunrgbd_train_test_labels", [f"img-00000{number}.png" for number in (1, 2, 3)], CHAIR - 1)
    assert is_sun_rgbd(tmp_path)
    train, test = SunRgbd(tmp_path, "train", classes), SunRgbd(tmp_path, "test", classes)
    assert (len(train), len(test)) == (2, 1)
    assert test.read(0)[1].max() == IGNORE  # the label before chair
    assert [int(train.read(index)[1].max()) for index in range(2)] == [0, 1]


def test_sun_rgbd_as_reorganised(tmp_path, classes):
    for split, label in (("train", CHAIR), ("test", SOFA)):
        write_photos(tmp_path / "image" / split, ["img-000001.png"])
        write_labels(tmp_path / "label37" / split, ["img37labels-000001.png"], label)
    assert int(SunRgbd(tmp_path, "train", classes).read(0)[1].max()) == 0
    assert int(SunRgbd(tmp_path, "test", classes).read(0)[1].max()) == 1


def test_sun_rgbd_with_labels_missing_is_refused(tmp_path, classes):
    write_photos(tmp_path / "image/train", ["img-000001.png", "img-000002.png"])
    write_labels(tmp_path / "label37/train", ["img37labels-000001.png"])
    with pytest.raises(TrainingError, match="2 photos and 1 label images of the split train"):
        SunRgbd(tmp_path, "train", classes)


def test_yolo_folder(tmp_path):
    data_file, boxes = write_yolo_folder(tmp_path, 2)
    dataset = YoloFolder(data_file, "val")
    assert dataset.names == ("table", "big chair") and len(dataset) == 2
    image, found, kinds, labels = dataset.read(1)
    assert np.array_equal(image, scene(1)[0])
    assert found.tolist() == [pytest.approx(boxes["val"][1], abs=1e-3)] and kinds.tolist() == [1]
    assert labels is None


def test_yolo_folder_with_a_polygon_and_without_a_file(tmp_path):
    data_file, _ = write_yolo_folder(tmp_path, 2)
    (tmp_path / "labels/train/0.txt").write_text("0 0.25 0.25 0.75 0.25 0.5 0.5\n")
    (tmp_path / "labels/train/1.txt").unlink()
    dataset = YoloFolder(data_file, "train")
    assert dataset.read(0)[1].tolist() == [[16, 12, 48, 24]]
    assert dataset.read(1)[1].shape == (0, 4)


@pytest.mark.parametrize("text, words", [
    ("1 0.5 0.5 0.2\n", "0.txt:1: expected class, cx, cy"),
    ("1 0.5 x 0.2 0.2\n", "are no numbers"),
    ("2 0.5 0.5 0.2 0.2\n", "expected classes 0 to 1"),
])
def test_a_wrong_box_is_refused_by_file_and_line(tmp_path, text, words):
    data_file, _ = write_yolo_folder(tmp_path, 1)
    (tmp_path / "labels/train/0.txt").write_text(text)
    with pytest.raises(TrainingError, match=words):
        YoloFolder(data_file, "train").read(0)


def test_an_image_cut_short_is_refused_by_name(rendered, classes):
    path = rendered[0] / "a/rgb/0.500000.png"
    path.write_bytes(path.read_bytes()[:20])
    with pytest.raises(TrainingError, match="0.500000.png: not a readable image"):
        RenderedSegmentation([rendered[0]], classes).read(0)


def test_labels_of_another_size_are_refused(rendered, classes):
    write_image(rendered[0] / "a/labels/0.500000.png", np.full((24, 32), WALL, np.uint8))
    with pytest.raises(TrainingError, match="32 x 24 px, but .* has 64 x 48"):
        RenderedSegmentation([rendered[0]], classes).read(0)


def test_kinds_of_sets_are_told_apart(rendered, tmp_path, repository):
    indoor = repository / "training/classes/indoor.yaml"
    assert len(open_segmentation([rendered[0]], "train", indoor)) == 3
    data_file, _ = write_yolo_folder(tmp_path / "yolo", 1)
    assert open_detection([data_file.parent], "val", None).names == ("table", "big chair")
    with pytest.raises(TrainingError, match="no rgb.txt in it or below it"):
        open_segmentation([tmp_path / "yolo"], "train", indoor)
    with pytest.raises(TrainingError, match="no such folder"):
        open_segmentation([tmp_path / "nowhere"], "train", indoor)
