"""evaluate_segmentation, evaluate_detection: a network that is right about one half is half right, and files say so."""

import json
import struct
import zlib

import numpy as np
import pytest

RED, GREEN, GREY = (255, 0, 0), (0, 255, 0), (90, 90, 90)
CHAIR, TV, PLANT = 5, 25, 40  # ids of config/labels.yaml


def write_png(path, pixels):
    """A PNG of 8 bits, grey or colour."""
    height, width = pixels.shape[:2]
    rows = np.column_stack([np.zeros(height, np.uint8), pixels.reshape(height, -1)])

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", width, height, 8, 2 if pixels.ndim == 3 else 0, 0, 0, 0)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows.tobytes()))
                     + chunk(b"IEND", b""))


def halves(left, right):
    """64 x 48 pixels of two colours or ids."""
    image = np.empty((48, 64, *np.shape(left)), np.uint8)
    image[:, :32], image[:, 32:] = left, right
    return image


@pytest.fixture(name="photos")
def fixture_photos(tmp_path):
    """Two images with labels, of which the network is right about one and about half of the other."""
    for name, truth in ("a", (CHAIR, PLANT)), ("b", (CHAIR, TV)):
        write_png(tmp_path / "photos/images" / f"{name}.png", halves(RED, GREEN))
        write_png(tmp_path / "photos/labels" / f"{name}.png", halves(*truth))
    return tmp_path / "photos"


def evaluate(run_program, repository, program, card, *arguments):
    """The result as JSON, and what was printed as a table."""
    call = ("--card", repository / "test/testing/networks" / f"{card}.yaml", *arguments)
    printed, table = run_program(program, *call, "--json"), run_program(program, *call)
    assert (printed.returncode, table.returncode) == (0, 0), printed.stderr + table.stderr
    return json.loads(printed.stdout), table.stdout


def test_segmentation_is_scored_by_pixel(run_program, repository, photos, tmp_path):
    result, table = evaluate(run_program, repository, "evaluate_segmentation", "colour_segmenter", photos, "--output",
                             tmp_path / "out")
    assert result["pixel_accuracy"] == 0.75
    assert result["classes"]["chair"] == {"iou": 1, "precision": 1, "recall": 1, "pixel_share": 0.5}
    assert result["classes"]["plant"]["iou"] == 0.5
    assert result["classes"]["tv"]["iou"] == 0
    assert result["classes"]["wall"]["iou"] is None
    assert result["time"]["images"] == 2
    assert "75.0 %" in table
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "segmentation.json", "confusion.png", "examples.png"}
    assert json.loads((tmp_path / "out/segmentation.json").read_text())["pixel_accuracy"] == 0.75


def test_segmentation_counts_merged_and_ignored_labels_as_training_does(run_program, repository, photos, tmp_path):
    classes = tmp_path / "classes.yaml"
    classes.write_text("classes: [plant]\nmerge: {tv: plant}\n")
    result, _ = evaluate(run_program, repository, "evaluate_segmentation", "colour_segmenter", photos, "--classes",
                         classes)
    assert result["pixels"] == 2 * 48 * 32  # chairs do not count
    assert result["pixel_accuracy"] == 1


def test_detection_is_scored_by_box(run_program, repository, tmp_path):
    photos = tmp_path / "photos"
    (photos / "labels").mkdir(parents=True)
    for name in "ab":
        image = np.full((480, 640, 3), GREY, np.uint8)
        image[240:320, 160:240] = RED  # one cell of the network's grid, which it calls a chair
        write_png(photos / "images" / f"{name}.png", image)
    (photos / "labels/a.txt").write_text(f"0 {200 / 640} {280 / 480} {80 / 640} {80 / 480}\n")
    (photos / "labels/b.txt").write_text("1 0.8 0.8 0.2 0.2\n")
    (photos / "data.yaml").write_text("names: [red block, tv]\nval: images\n")
    result, table = evaluate(run_program, repository, "evaluate_detection", "block_detector", photos, "--output",
                             tmp_path / "out")
    assert result["boxes"] == 2
    assert result["at_threshold"]["precision"] == 0.5
    assert result["at_threshold"]["recall"] == 0.5
    assert result["classes"]["tv"]["ap50"] == 0
    assert result["time"]["images"] == 2
    assert "mAP@0.5" in table
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "detection.json", "confusion.png", "precision_recall.png", "examples.png"}


def test_at_most_so_many_images_are_taken(run_program, repository, photos):
    result, _ = evaluate(run_program, repository, "evaluate_segmentation", "colour_segmenter", photos, "--images", "1")
    assert result["time"]["images"] == 1
