"""replay: what it leaves, that it leaves the same every time, and how far it is off."""

import json

import pytest

TRACKING = {"trajectory.txt", "trajectory_live.txt", "keyframe_trajectory.txt", "trajectory.png", "summary.json"}
GRID = {"grid.pgm", "grid.yaml", "semantic_grid.png", "semantic_grid.pgm", "semantic_grid.yaml"}
SEMANTIC = {"semantic_map.ot", "semantic_map_colour.ot", "semantic_map.bt", "semantic_map.ply", "map_top.png",
            "overview.png"}
OBJECTS = {"objects.json"}


@pytest.fixture(name="run", params=["room", "desk"])
def fixture_run(request):
    """A Sequence, the folder that a replay of it has left, replay's options, and the files it should leave."""
    sequence = request.getfixturevalue(request.param)
    out = request.getfixturevalue(f"{request.param}_replay")
    if request.param == "room":
        return sequence, out, (), TRACKING | GRID
    return sequence, out, request.getfixturevalue("networks"), TRACKING | GRID | SEMANTIC | OBJECTS


def evaluate(run_program, sequence, out, trajectory="trajectory.txt"):
    result = run_program("evaluate_trajectory", sequence.ground_truth, out / trajectory, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def lines(path):
    return [line for line in path.read_text().splitlines() if not line.startswith("#")]


def test_leaves_its_results_and_nothing_half_written(run):
    _, out, _, files = run
    assert {path.name for path in out.iterdir()} == files | {"timing.csv"}


@pytest.mark.parametrize("before", [(), ("taskset", "-c", "0")], ids=["again", "on one core"])
def test_leaves_the_same_bytes(run, replay, tmp_path, before):
    sequence, first, options, files = run
    second = replay(sequence, tmp_path / "out", *options, before=before)
    for name in files:
        assert (first / name).read_bytes() == (second / name).read_bytes(), name


def test_without_other_stages_tracking_is_alone(replay, room, room_replay, tmp_path):
    out = replay(room, tmp_path / "out", "--stages", "tracking")
    assert {path.name for path in out.iterdir()} == TRACKING | {"timing.csv"}
    assert (out / "trajectory.txt").read_bytes() == (room_replay / "trajectory.txt").read_bytes()


def test_timings_have_a_row_per_stage(room_replay):
    header, *rows = lines(room_replay / "timing.csv")
    assert header == "stage,count,median_ms,p95_ms"
    assert rows
    for row in rows:
        stage, count, median_ms, p95_ms = row.split(",")
        assert stage and int(count) > 0 and 0 <= float(median_ms) <= float(p95_ms)


def test_at_the_sensors_rate_it_tells_how_late_poses_were(replay, room, tmp_path):
    out = replay(room, tmp_path / "out", "--stages", "tracking", "--realtime")
    assert {path.name for path in out.iterdir()} == TRACKING | {"timing.csv", "delays.csv"}
    summary = json.loads((out / "summary.json").read_text())
    live = summary["live"]
    assert live["in_time"] + live["late"] == summary["tracked"] > 0
    assert 0 < live["delay_median_ms"] <= live["delay_p95_ms"]
    assert live["cpu_ms_per_image"] > 0 and live["decoding_ms_per_image"] > 0
    header, *rows = lines(out / "delays.csv")
    assert header == "stamp,delay_ms"
    delays = {stamp: float(delay_ms) for stamp, delay_ms in (row.split(",") for row in rows)}
    assert list(delays) == [line.split()[0] for line in lines(out / "trajectory_live.txt")]
    assert sum(delay_ms <= live["latest_ms"] for delay_ms in delays.values()) == live["in_time"]
    assert "live" not in json.loads((replay(room, tmp_path / "fast", "--stages", "tracking") /
                                     "summary.json").read_text())


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


def test_a_bag_gives_the_same_trajectory_as_its_folder(run_program, room, room_replay, tmp_path):
    bag = tmp_path / "room.bag"
    result = run_program("tum_to_bag", room.folder, bag)
    assert result.returncode == 0, result.stderr
    out = tmp_path / "out"
    result = run_program("replay", "--dataset", bag, "--config", room.config, "--stages", "tracking",
                         "--out", out)
    assert result.returncode == 0, result.stderr
    # A bag keeps depth in other units than the PNG files, so the last digits may differ.
    result = run_program("evaluate_trajectory", room_replay / "trajectory.txt", out / "trajectory.txt", "--json")
    errors = json.loads(result.stdout)
    assert errors["matched"] == 120
    assert errors["ate_max_m"] < 0.005


def test_the_desk_is_in_its_maps(desk_replay):
    summary = json.loads((desk_replay / "summary.json").read_text())
    assert summary["semantic"]["clouds"] == summary["semantic"]["images"] > 90  # of 20 s, one every 0.2 s
    assert summary["grid"]["images"] > 180  # one every 0.1 s
    objects = json.loads((desk_replay / "objects.json").read_text())["objects"]
    # What stands on the desk and the network knows well.
    assert {"tv", "keyboard", "books"} <= {thing["class"] for thing in objects}
