"""replay: what it leaves, that it leaves the same every time, and how far it is off."""

import json

import pytest

REPRODUCIBLE = ("trajectory.txt", "trajectory_live.txt", "keyframe_trajectory.txt", "summary.json")


@pytest.fixture(name="run", params=["room", "desk"])
def fixture_run(request):
    """A Sequence, and the folder that a replay of it has left."""
    sequence = request.getfixturevalue(request.param)
    return sequence, request.getfixturevalue(f"{request.param}_replay")


def evaluate(run_program, sequence, out, trajectory="trajectory.txt"):
    result = run_program("evaluate_trajectory", sequence.ground_truth, out / trajectory, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def lines(path):
    return [line for line in path.read_text().splitlines() if not line.startswith("#")]


def test_leaves_its_results_and_nothing_half_written(run):
    _, out = run
    assert {path.name for path in out.iterdir()} == {*REPRODUCIBLE, "timing.csv", "trajectory.png"}


@pytest.mark.parametrize("before", [(), ("taskset", "-c", "0")], ids=["again", "on one core"])
def test_leaves_the_same_bytes(run, replay, tmp_path, before):
    sequence, first = run
    second = replay(sequence, tmp_path / "out", before)
    for name in REPRODUCIBLE:
        assert (first / name).read_bytes() == (second / name).read_bytes(), name


def test_timings_have_a_row_per_stage(room_replay):
    header, *rows = lines(room_replay / "timing.csv")
    assert header == "stage,count,median_ms,p95_ms"
    assert rows
    for row in rows:
        stage, count, median_ms, p95_ms = row.split(",")
        assert stage and int(count) > 0 and 0 <= float(median_ms) <= float(p95_ms)


def test_loses_nothing_in_the_room(run_program, room, room_replay):
    summary = json.loads((room_replay / "summary.json").read_text())
    assert summary["tracked"] == summary["images"] == 120
    assert summary["lost"] == 0
    # The room is rendered with the noise of a Kinect, 1 to 2 cm at these distances.
    assert evaluate(run_program, room, room_replay)["ate_rmse_m"] < 0.02


def test_is_within_three_centimetres_on_freiburg1_desk(run_program, desk, desk_replay):
    assert len(lines(desk_replay / "trajectory.txt")) == 573  # one per pair of images: none lost
    errors = evaluate(run_program, desk, desk_replay)
    assert errors["matched"] == 573
    assert errors["ate_rmse_m"] <= 0.03


def test_a_bag_gives_the_same_trajectory_as_its_folder(run_program, replay, room, room_replay, tmp_path):
    bag = tmp_path / "room.bag"
    result = run_program("tum_to_bag", room.folder, bag)
    assert result.returncode == 0, result.stderr
    out = tmp_path / "out"
    result = run_program("replay", "--dataset", bag, "--config", room.config, "--out", out)
    assert result.returncode == 0, result.stderr
    # A bag keeps depth in other units than the PNG files, so the last digits may differ.
    result = run_program("evaluate_trajectory", room_replay / "trajectory.txt", out / "trajectory.txt", "--json")
    errors = json.loads(result.stdout)
    assert errors["matched"] == 120
    assert errors["ate_max_m"] < 0.005
