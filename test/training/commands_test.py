"""The commands of training/: from a set to a model card, and one line on what is wrong."""

import importlib
import json
import sys

import needs_torch  # noqa: F401
import pytest
from tiny_sets import write_rendered, write_yolo_folder

from semantic_slam_training.engine import checkpoint
from semantic_slam_training.errors import run_command

COMMANDS = ("train_segmentation", "train_detection", "train_appearance", "export", "compare_segmentation",
            "evaluate_appearance")
QUICK = ("--steps 2 --batch-size 2 --checkpoint-every 1 --validate-every 2 --validation-images 2 --threads 1 "
         "--device cpu").split()


@pytest.fixture(name="run")
def fixture_run(monkeypatch):
    """Runs a command in this process; what it exits with, None if it ends well."""

    def run(name, *arguments):
        monkeypatch.setattr(sys, "argv", [f"{name}.py", *map(str, arguments)])
        try:
            run_command(importlib.import_module(name).main)
        except SystemExit as end:
            return end.code
        return None

    return run


@pytest.fixture(name="rooms")
def fixture_rooms(tmp_path):
    write_rendered(tmp_path / "rooms/a", 3)
    return tmp_path / "rooms"


@pytest.mark.parametrize("name", COMMANDS)
def test_help_says_what_it_does(run, capsys, name):
    assert run(name, "--help") == 0
    assert "usage:" in capsys.readouterr().out


def test_segmentation_from_a_rendered_set_to_a_card(run, rooms, tmp_path, capsys):
    train = ("train_segmentation", "--data", rooms, "--validation", rooms, "--out", tmp_path / "run", "--width", 0.0625,
             "--size", "64x48", *QUICK)
    assert run(*train, "--minutes", 1e-9) is None
    assert "step 1 of 2" in capsys.readouterr().err
    assert run(*train) is None
    assert "step 2 of 2" in capsys.readouterr().err
    assert run("export", tmp_path / "run/checkpoint.pt", "--name", "rooms", "--out", tmp_path / "models") is None
    assert {path.name for path in (tmp_path / "models").iterdir()} == {
        "rooms.onnx", "rooms.names", "rooms.yaml", "rooms.pt"}
    assert run(*train[:6], tmp_path / "next", *train[7:], "--start", tmp_path / "models/rooms.pt") is None


def test_detection_on_a_rendered_set_learns_pixels_too(run, rooms, tmp_path, capsys):
    assert run("train_detection", "--data", rooms, "--out", tmp_path / "run", "--size", "64x64", *QUICK, "--minutes",
               1e-9) is None
    history = checkpoint.load(tmp_path / "run/checkpoint.pt")
    assert history["spec"]["pixel_classes"] == 22
    assert run("export", tmp_path / "run/checkpoint.pt", "--name", "rooms", "--out", tmp_path / "models") is None
    assert "3.01 M parameters" in capsys.readouterr().out  # YOLOv8n's own


def test_detection_on_a_yolo_folder(run, tmp_path, capsys):
    data_file, _ = write_yolo_folder(tmp_path / "photos", 2)
    assert run("train_detection", "--data", data_file, "--out", tmp_path / "run", "--size", "64x64", *QUICK) is None
    assert "map50" in capsys.readouterr().err


def test_appearance_on_a_rendered_set(run, tmp_path, capsys):
    for seed in range(2):
        write_rendered(tmp_path / f"rooms/{seed}", 2, first_seed=seed)
    classes = tmp_path / "all.yaml"
    classes.write_text("classes: [chair]\n")
    rooms = tmp_path / "rooms"
    options = ("--classes", classes, "--width", 0.125, "--size", "32x32", "--least-side", 10)
    assert run("train_appearance", "--data", rooms, "--validation", rooms, "--out", tmp_path / "run", *options,
               *QUICK) is None
    assert "auc" in capsys.readouterr().err
    assert run("export", tmp_path / "run/checkpoint.pt", "--name", "looks", "--out", tmp_path / "models") is None
    evaluate = ("evaluate_appearance", "--card", tmp_path / "models/looks.yaml", "--classes", classes, "--least-side",
                10, "--output", tmp_path / "out", rooms)
    assert run(*evaluate) is None
    assert "4 crops of 2 objects: AUC" in capsys.readouterr().out
    measured = json.loads((tmp_path / "out/appearance.json").read_text())
    assert 0 <= measured["auc"] <= 1
    assert run("export", tmp_path / "models/looks.pt", "--name", "looks", "--out", tmp_path / "models", "--evaluation",
               tmp_path / "out/appearance.json") is None
    card = (tmp_path / "models/looks.yaml").read_text()
    assert f"#   auc: {measured['auc']:.4f}\n" in card and "training has not seen" in card


def test_comparison_leaves_table_and_picture(run, rooms, tmp_path, capsys):
    assert run("compare_segmentation", "--data", rooms, "--validation", rooms, "--out", tmp_path / "out", "--width", 0.06,
               "--size", "64x64", "--networks", "unet", "fcn8s", *QUICK) is None
    assert "| unet |" in capsys.readouterr().out
    for name in ("comparison.json", "comparison.md", "comparison.png"):
        assert (tmp_path / "out" / name).stat().st_size > 0


@pytest.mark.parametrize("line, words", [
    ("train_segmentation --data /nonexistent --out {out}", "/nonexistent: no such folder"),
    ("train_segmentation --data {rooms} --out {out} --size 320", "--size 320: expected WIDTHxHEIGHT"),
    ("train_segmentation --data {rooms} --out {out} --size 100x100", "--size 100x100: expected multiples of 8 px"),
    ("train_segmentation --data {rooms} --out {out} --steps 0", "--steps 0: expected 1 or more"),
    ("train_segmentation --data {rooms} --out {out} --classes /etc/hostname", "/etc/hostname"),
    ("train_detection --data {rooms} --out {out} --size 320x240", "--size 320x240: expected multiples of 32 px"),
    ("export /nonexistent.pt --name x", "/nonexistent.pt: no such checkpoint"),
    ("export /nonexistent.pt --name x --evaluation /etc/hostname", "/etc/hostname: not JSON"),
    ("evaluate_appearance --card /nonexistent.yaml {rooms}", "/nonexistent.yaml"),
    ("evaluate_appearance --card {card} {rooms}", "head: {type: reid}"),
    ("compare_segmentation --data {rooms} --out {out}", "--validation: expected a set to compare on"),
])
def test_what_is_wrong_is_said_in_one_line(run, rooms, tmp_path, repository, line, words):
    card = repository / "config/cards/yolov8n_coco_320x256.yaml"
    name, *arguments = line.format(rooms=rooms, out=tmp_path / "out", card=card).split()
    message = run(name, *arguments)
    assert message.startswith(f"{name}.py: ") and words in message and "\n" not in message


def test_a_broken_image_is_named_whoever_reads_it(run, rooms, tmp_path):
    for path in (rooms / "a/rgb").iterdir():
        path.write_bytes(b"broken")
    boxes = ("train_detection", "--data", rooms, "--out", tmp_path / "out", "--size", "64x64", *QUICK)
    for workers in (0, 1):
        message = run(*boxes, "--workers", workers)
        assert message.startswith(f"train_detection.py: {rooms / 'a/rgb'}") and "\n" not in message
        assert message.endswith("not a readable image")
