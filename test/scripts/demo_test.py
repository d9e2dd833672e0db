"""scripts/demo: flies a tour or plays a folder to the end with pictures, and refuses in one line what it cannot."""

import json
import subprocess

import pytest
import yaml

RESULTS = ("trajectory.txt", "trajectory_live.txt", "keyframe_trajectory.txt", "timing.csv", "summary.json")
MAPS = ("semantic_map.ot", "semantic_map.ply", "objects.json", "grid.pgm", "semantic_grid.pgm")
PICTURES = ("trajectory.png", "rviz.png", "map_top.png")


@pytest.fixture(name="demo", scope="module")
def fixture_demo(repository):
    def run(*arguments):
        return subprocess.run([repository / "scripts/demo", *arguments], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, cwd="/", timeout=600, check=False)

    return run


@pytest.mark.parametrize("arguments, word", [
    ("/nonexistent.bag", "/nonexistent.bag"),
    ("/etc/hostname", "not a bag"),
    ("/etc", "rgb.txt"),
    ("--rate 0", "--rate"),
    ("--rate fast", "--rate"),
    ("--config /nonexistent.yaml", "/nonexistent.yaml"),
    ("--speed 1", "--speed"),
    ("{unnamed}", "--config"),
    ("--world moon", "moon"),
    ("--pose guessed", "guessed"),
    ("--labels guessed", "guessed"),
    ("--segmentation /nonexistent.yaml", "/nonexistent.yaml"),
    ("--detection", "--detection"),
    ("--tour /nonexistent.yaml", "/nonexistent.yaml"),
    ("--rate 2", "--rate"),
    ("--world home {unnamed}", "--world"),
])
def test_refuses_in_one_line(demo, tmp_path, arguments, word):
    (tmp_path / "rgb.txt").write_text("")
    result = demo(*arguments.format(unnamed=tmp_path).split())
    assert result.returncode == 1
    assert result.stdout == ""
    assert result.stderr.startswith("demo: ") and result.stderr.count("\n") == 1, result.stderr
    assert word in result.stderr


def test_help_says_how_to_call_it(demo):
    result = demo("--help")
    assert result.returncode == 0
    assert "scripts/demo [--world" in result.stdout and "scripts/demo [--config" in result.stdout


def assert_left(out, names):
    for name in names:
        assert (out / name).stat().st_size > 0, name
        if name.endswith(".png"):
            assert (out / name).read_bytes().startswith(b"\x89PNG"), name


@pytest.mark.parametrize("options, words", [
    ((), "labels and boxes are the renderer's"),
    (("--labels", "networks"), "networks: pspnet_indoor, yolov8n_furniture"),
], ids=("renderer", "networks"))
def test_flies_a_tour_to_the_end(demo, repository, tmp_path, options, words):
    tour = yaml.safe_load((repository / "config/tours/home.yaml").read_text())
    (tmp_path / "tour.yaml").write_text(yaml.safe_dump({**tour, "waypoints": tour["waypoints"][:3]}))
    result = demo("--output", tmp_path / "out", "--tour", tmp_path / "tour.yaml", *options)
    assert result.returncode == 0, result.stdout + result.stderr
    assert_left(tmp_path / "out", (*RESULTS, *MAPS, *PICTURES, "evaluation.json", "evaluation.png"))
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert summary["lost"] == 0
    evaluation = json.loads((tmp_path / "out/evaluation.json").read_text())
    assert evaluation["trajectory"]["ate_rmse_m"] < 0.05  # some seconds in one room
    assert evaluation["voxels"]["occupied"] > 1000
    for expected in (words, "images tracked", "pictures:"):
        assert expected in result.stdout


def test_plays_a_folder_to_the_end(demo, room, tmp_path):
    result = demo("--output", tmp_path / "out", room.folder)
    assert result.returncode == 0, result.stdout + result.stderr
    assert_left(tmp_path / "out", (*RESULTS, *MAPS, *PICTURES, "overview.png"))
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert summary["lost"] == 0
    stamps = [float(line.split()[0]) for line in (tmp_path / "out/trajectory_live.txt").read_text().splitlines()
              if not line.startswith("#")]
    images = [float(line.split()[0]) for line in (room.folder / "rgb.txt").read_text().splitlines()
              if not line.startswith("#")]
    # A busy machine drops images (how many is a matter of its speed), but follows from the beginning to the end.
    assert stamps[0] < images[0] + 1 and stamps[-1] > images[-1] - 1
    assert "images tracked" in result.stdout
