"""scripts/demo: plays a folder to the end with pictures, and refuses in one line what it cannot play."""

import json
import subprocess

import pytest

RESULTS = ("trajectory.txt", "trajectory_live.txt", "keyframe_trajectory.txt", "timing.csv", "summary.json")
PICTURES = ("trajectory.png", "rviz.png")


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
    assert "scripts/demo [--config" in result.stdout


def test_plays_a_folder_to_the_end(demo, room, tmp_path):
    result = demo("--output", tmp_path / "out", room.folder)
    assert result.returncode == 0, result.stdout + result.stderr
    for name in (*RESULTS, *PICTURES):
        assert (tmp_path / "out" / name).stat().st_size > 0, name
    for name in PICTURES:
        assert (tmp_path / "out" / name).read_bytes().startswith(b"\x89PNG"), name
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert summary["tracked"] > 100  # of 120; a busy machine may drop some
    assert "images tracked" in result.stdout
