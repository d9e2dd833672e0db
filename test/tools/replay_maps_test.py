"""replay --save-map, --load-map and --localization-only: a map is kept and gone on with."""

import json

import pytest


@pytest.fixture(name="kept", scope="module")
def fixture_kept(replay, room, tmp_path_factory):
    """What a replay of the room has left, and the map that it kept."""
    folder = tmp_path_factory.mktemp("kept")
    out = replay(room, folder / "out", "--stages", "tracking", "--save-map", folder / "room.map")
    return out, folder / "room.map"


def read_summary(out):
    return json.loads((out / "summary.json").read_text())


def count_keyframes(out):
    lines = (out / "keyframe_trajectory.txt").read_text().splitlines()
    return sum(not line.startswith("#") for line in lines)


def test_keeping_the_map_changes_nothing_else(kept, room_replay):
    out, map_file = kept
    assert map_file.stat().st_size > 100_000
    assert (out / "trajectory.txt").read_bytes() == (room_replay / "trajectory.txt").read_bytes()
    assert [path.name for path in map_file.parent.iterdir() if path.is_file()] == ["room.map"]


def test_only_localizing_finds_every_image_and_adds_no_keyframe(replay, room, kept, run_program, tmp_path):
    first, map_file = kept
    out = replay(room, tmp_path / "out", "--stages", "tracking", "--load-map", map_file, "--localization-only")
    summary = read_summary(out)
    assert summary["tracked"] == summary["images"] == 120  # the first one is found at once
    assert (out / "keyframe_trajectory.txt").read_bytes() == (first / "keyframe_trajectory.txt").read_bytes()
    result = run_program("evaluate_trajectory", first / "trajectory.txt", out / "trajectory.txt", "--json")
    # The same images in the same map, without the corrections that followed them then: the noise of a pose.
    assert json.loads(result.stdout)["ate_rmse_m"] < 0.01


def test_going_on_gives_the_same_bytes_again(replay, room, kept, tmp_path):
    first, map_file = kept
    options = ("--stages", "tracking", "--load-map", map_file, "--save-map")
    outs = [replay(room, tmp_path / name, *options, tmp_path / f"{name}.map") for name in ("a", "b")]
    assert (tmp_path / "a.map").read_bytes() == (tmp_path / "b.map").read_bytes()
    assert (outs[0] / "trajectory.txt").read_bytes() == (outs[1] / "trajectory.txt").read_bytes()
    assert read_summary(outs[0])["tracked"] == 120
    assert count_keyframes(outs[0]) >= count_keyframes(first)


def test_refuses_the_map_of_another_camera_in_one_line(run_program, room, kept, tmp_path):
    other = tmp_path / "other.yaml"
    text = room.config.read_text()
    lines = [line if "fx_px" not in line else line.split(":")[0] + ": 400.0" for line in text.splitlines()]
    other.write_text("\n".join(lines) + "\n")
    result = run_program("replay", "--dataset", room.folder, "--config", other, "--stages", "tracking",
                         "--load-map", kept[1], "--out", tmp_path / "out")
    assert result.returncode == 1
    assert len(result.stderr.strip().splitlines()) == 1
    assert str(kept[1]) in result.stderr and "fx 400" in result.stderr
