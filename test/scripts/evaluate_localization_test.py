"""scripts/evaluate_localization: what it plays, what it measures, and when it complains."""

import dataclasses
import decimal
import json
import os
import subprocess
import time

import pytest
import yaml

from localization_evaluation import programs, table
from localization_evaluation.errors import EvaluationError
from localization_evaluation.flights import FLIGHTS, other_way_round, rendered
from localization_evaluation.runs import Run, Runs, drop_late
from localization_evaluation.sequences import backwards, camera_file, every_second, open_sequence, pairs

# Colour at 10, 11, ... 14 s; depth 8 ms later, but none at 12 s, and one at 16 s that nothing goes with.
LISTS = {
    "rgb.txt": [("10.000", "rgb/a.jpg"), ("11.000", "rgb/b.jpg"), ("12.000", "rgb/c.jpg"), ("13.000", "rgb/d.jpg"),
                ("14.000", "rgb/e.jpg")],
    "depth.txt": [("10.008", "depth/a.png"), ("11.008", "depth/b.png"), ("13.008", "depth/d.png"),
                  ("14.008", "depth/e.png"), ("16.000", "depth/f.png")],
    "groundtruth.txt": [("9.5", "0 0 0 0 0 0 1"), ("10.5", "1 0 0 0 0 0 1"), ("14.5", "5 0 0 0 0 0 1")],
    "accelerometer.txt": [("9.0", "0 9.8 0"), ("12.25", "0 9.7 0")],
}


@pytest.fixture(name="folder")
def fixture_folder(tmp_path):
    folder = tmp_path / "rgbd_dataset_freiburg1_desk"
    for name, rows in LISTS.items():
        (folder / name.removesuffix(".txt")).mkdir(parents=True)
        (folder / name).write_text("# stamp and more\n" + "".join(f"{stamp} {rest}\n" for stamp, rest in rows))
    (folder / "rgb/a.jpg").write_text("colour")
    return folder


def rows(path):
    return [tuple(line.split(" ", 1)) for line in path.read_text().splitlines() if not line.startswith("#")]


def test_pairs_are_those_of_nearest_stamps(folder):
    assert [(colour[1], depth[1]) for colour, depth in pairs(folder)] == [
        (f"rgb/{name}.jpg", f"depth/{name}.png") for name in "abde"]
    (folder / "depth.txt").write_text("9.995 far\n10.001 near\n11.02 last\n11.9799 too_far\n")
    assert [(colour[1], depth[1]) for colour, depth in pairs(folder)] == [("rgb/a.jpg", "near"), ("rgb/b.jpg", "last")]


def test_backwards_every_stamp_is_mirrored(folder, tmp_path):
    mirrored = backwards(open_sequence(folder), tmp_path / "backwards")
    assert mirrored.name == "rgbd_dataset_freiburg1_desk, backwards"
    assert mirrored.config == open_sequence(folder).config
    for name, before in LISTS.items():  # 24 - t, so that colour begins and ends when it did
        expected = [(24 - decimal.Decimal(stamp), rest) for stamp, rest in reversed(before)]
        assert [(decimal.Decimal(stamp), rest) for stamp, rest in rows(mirrored.path / name)] == expected, name
    assert mirrored.ground_truth == mirrored.path / "groundtruth.txt"
    assert (mirrored.path / "rgb/a.jpg").read_text() == "colour"
    assert [colour[1] for colour, _ in pairs(mirrored.path)] == [f"rgb/{name}.jpg" for name in "edba"]


def test_every_second_pair_is_left(folder, tmp_path):
    thinned = every_second(open_sequence(folder), tmp_path / "every_second")
    assert rows(thinned.path / "rgb.txt") == [LISTS["rgb.txt"][0], LISTS["rgb.txt"][3]]
    assert rows(thinned.path / "depth.txt") == [LISTS["depth.txt"][0], LISTS["depth.txt"][2]]
    for name in ("groundtruth.txt", "accelerometer.txt"):
        assert rows(thinned.path / name) == LISTS[name]
    assert (thinned.path / "rgb/a.jpg").read_text() == "colour"


def test_the_folder_may_be_without_accelerometer(folder, tmp_path):
    (folder / "accelerometer.txt").unlink()
    for make in (backwards, every_second):
        assert not (make(open_sequence(folder), tmp_path / make.__name__).path / "accelerometer.txt").exists()


def test_the_camera_is_told_from_folder_or_name(folder, repository):
    assert camera_file(folder) == repository / "config/tum_freiburg1.yaml"
    assert camera_file(folder.with_name("fr3_office.bag")) == repository / "config/tum_freiburg3.yaml"
    (folder / "camera.yaml").write_text("")
    assert camera_file(folder) == folder / "camera.yaml"


def test_a_tour_the_other_way_round(repository):
    tour = yaml.safe_load((repository / "config/tours/home.yaml").read_text())
    back = other_way_round(tour)
    assert back["max_speed_mps"] == tour["max_speed_mps"]
    for there, then in zip(tour["waypoints"], reversed(back["waypoints"])):
        assert there["position_m"] == then["position_m"]
        assert -180 <= then["yaw_deg"] <= 180
        assert (there["yaw_deg"] - then["yaw_deg"]) % 360 == 180


def write_program(path, text):
    path.parent.mkdir(exist_ok=True)
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


def test_a_flight_is_rendered_once(tmp_path):
    renderer = write_program(tmp_path / "programs/render_sequence", f"""echo "$@" >> {tmp_path}/calls
mkdir "$3" && cd "$3" && touch rgb.txt groundtruth.txt camera.yaml""")
    first = rendered(FLIGHTS[2], renderer, tmp_path / "cache")
    assert rendered(FLIGHTS[2], renderer, tmp_path / "cache") == first
    assert first.name == "home, the other way round"
    assert (first.path / "rgb.txt").exists()
    call, = (tmp_path / "calls").read_text().splitlines()
    assert call.startswith("home ") and "--seed 2" in call
    assert rendered(FLIGHTS[0], renderer, tmp_path / "cache").path != first.path
    assert len(list((tmp_path / "cache").iterdir())) == 2


def test_a_flight_that_fails_leaves_nothing(tmp_path):
    renderer = write_program(tmp_path / "programs/render_sequence",
                             'mkdir "$3"; echo "render_sequence: no" >&2; exit 1')
    with pytest.raises(EvaluationError, match="^render_sequence: no$"):
        rendered(FLIGHTS[0], renderer, tmp_path / "cache")
    assert not list((tmp_path / "cache").iterdir())


def test_load_keeps_cores_busy_and_ends(monkeypatch):
    started, start = [], programs.start
    monkeypatch.setattr(programs, "start", lambda command: started.append(start(command)) or started[-1])
    with programs.load(2):
        time.sleep(0.5)
        assert [process.poll() for process in started] == [None, None]
    assert all(process.returncode is not None for process in started)


def test_tells_the_memory_of_a_program(tmp_path):
    text = "exec /usr/bin/python3 -c 'a = \"x\" * 300000000'"  # 300 MB
    memory_mb = programs.run(write_program(tmp_path / "programs/big", text), (), "big")
    assert 300 < memory_mb < 400  # and Python itself


def test_poses_that_came_late_are_dropped(tmp_path):
    trajectory, delays = tmp_path / "trajectory_live.txt", tmp_path / "delays.csv"
    trajectory.write_text("# stamp ...\n" + "".join(f"{i}.250000 0 0 0 0 0 0 1\n" for i in range(1, 5)))
    delays.write_text("stamp,delay_ms\n1.250000,33.000\n2.250000,33.001\n3.250000,5.0\n4.250000,120\n")
    drop_late(trajectory, delays, 33.0)
    assert [line.split()[0] for line in trajectory.read_text().splitlines()] == ["1.250000", "3.250000"]


GOOD = Run(pairs=573, tracked=573, in_time=573, lost=0, dropped=0, loops=1, final_ate_m=0.0150, live_ate_m=0.0170,
           delay_median_ms=10.0, delay_p95_ms=20.0, median_ms=9.0, p95_ms=15.0, cpu_ms=20.0, decoding_ms=10.0,
           memory_mb=170.0, start_s=0.0)
AS_FAST = dataclasses.replace(GOOD, in_time=None, delay_median_ms=None, delay_p95_ms=None, cpu_ms=None,
                              decoding_ms=None)


def runs(**changed):
    return Runs("desk", [GOOD, GOOD, dataclasses.replace(GOOD, **changed)], AS_FAST)


@pytest.mark.parametrize("changed, missed", [
    ({}, []),
    ({"final_ate_m": 0.0166}, []),  # the median keeps its limit
    ({"final_ate_m": 0.0168}, ["final_ate_m"]),
    ({"final_ate_m": None}, ["final_ate_m"]),
    ({"live_ate_m": 0.0201}, ["live_ate_m"]),
    ({"tracked": 570}, []),
    ({"tracked": 569}, ["tracked"]),
    ({"in_time": 570}, []),
    ({"in_time": 569}, ["in_time"]),
    ({"lost": 1}, ["lost"]),
    ({"dropped": 3, "loops": 0}, []),
    ({"median_ms": 99.0, "p95_ms": 99.0, "cpu_ms": 99.0}, []),
    ({"delay_median_ms": 99.0, "delay_p95_ms": 99.0, "decoding_ms": 99.0}, []),
    ({"memory_mb": 181.0, "start_s": None}, ["memory_mb", "start_s"]),
])
def test_limits(changed, missed):
    assert [row.key for row in table.missed(runs(**changed))] == missed


def test_limits_of_medians():
    slow = dataclasses.replace(GOOD, final_ate_m=0.0156, live_ate_m=0.0176, median_ms=10.1, p95_ms=16.1, cpu_ms=22.1)
    assert [row.key for row in table.missed(Runs("desk", [GOOD, slow, slow], AS_FAST))] == [
        "final_ate_m", "live_ate_m", "median_ms", "p95_ms", "cpu_ms"]


def test_the_table_has_median_worst_and_limit():
    lines = list(table.markdown(runs(final_ate_m=0.0168, tracked=571), True))
    assert lines[0] == "### desk"
    assert lines[2] == "573 pairs of images; 3 runs at the sensor's rate, one as fast as it goes"
    assert "| ATE RMSE, final [m] | 0.0150 | 0.0168 | median ≤ 0.0155, worst ≤ 0.0167 **missed** | 0.0150 |" in lines
    assert "| images tracked | 573 | 571 | worst ≥ 570 | 573 |" in lines
    assert "| CPU per image, without decoding [ms] | 20.0 | 20.0 | median ≤ 22 | - |" in lines
    assert {line.count("|") for line in lines if line.startswith("|")} == {6}
    unjudged = list(table.markdown(runs(final_ate_m=None), False))
    assert "| ATE RMSE, final [m] | - | - | 0.0150 |" in unjudged
    assert not any("limit" in line or "missed" in line for line in unjudged)


@pytest.fixture(name="evaluate", scope="module")
def fixture_evaluate(repository):
    def run(*arguments):
        return subprocess.run([repository / "scripts/evaluate_localization", *arguments], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, cwd="/", timeout=600, check=False)

    return run


REPLAY = """while [ "$1" != --out ]; do shift; done
cd "$2"
live='{"in_time": 573, "late": 0, "latest_ms": 33.0, "delay_median_ms": 9, "delay_p95_ms": 15, "cpu_ms_per_image": 20,
"decoding_ms_per_image": 10}'
echo '{"images": 573, "tracked": 573, "lost": 0, "dropped": {}, "loops": 1, "live": '$live'}' > summary.json
printf 'stamp,delay_ms\\n10,9\\n' > delays.csv
printf 'stage,count,median_ms,p95_ms\\ntracking,573,9,15\\n' > timing.csv
for s in 10 11 12 13; do echo "$s 0 0 0 0 0 0 1"; done | tee trajectory.txt > trajectory_live.txt"""


@pytest.mark.parametrize("ate_m, name, code", [
    (0.015, "rgbd_dataset_freiburg1_desk", 0),
    (0.03, "rgbd_dataset_freiburg1_desk", 1),
    (0.03, "rgbd_dataset_freiburg1_desk2", 0),
])
def test_a_missed_limit_is_told_by_the_exit_code(evaluate, folder, tmp_path, ate_m, name, code):
    write_program(tmp_path / "programs/replay", REPLAY)
    write_program(tmp_path / "programs/evaluate_trajectory", f"""echo '{{"ate_rmse_m": {ate_m}}}'""")
    folder = folder.rename(folder.with_name(name))
    result = evaluate(folder, "--programs", tmp_path / "programs", "--runs", "2", "--other-runs", "1", "--no-rendered",
                      "--load", "1")
    assert result.returncode == code, result.stderr
    assert ("**missed**" in result.stdout) == (code == 1)
    assert "kept busy meanwhile: 1." in result.stdout
    assert result.stderr.count("run 2 of 2") == 1  # what it is at


def test_measures_the_room(evaluate, room, build_folder, tmp_path):
    result = evaluate(room.folder, "--programs", build_folder / "devel/lib/semantic_slam", "--runs", "1",
                      "--other-runs", "1", "--no-rendered", "--output", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert [line for line in result.stdout.splitlines() if line.startswith("#")] == [
        "### room", "### room, backwards", "### room, every second pair"]
    written = json.loads((tmp_path / "out/localization.json").read_text())
    assert written["load"] == 0
    assert [each["deterministic"]["pairs"] for each in written["sequences"]] == [120, 120, 60]
    for each in written["sequences"]:
        deterministic, (realtime,) = each["deterministic"], each["realtime"]
        assert deterministic["dropped"] == deterministic["lost"] == 0
        assert deterministic["tracked"] == deterministic["pairs"]
        # The room has the noise of a Kinect, 1 to 2 cm at these distances.
        assert deterministic["final_ate_m"] < 0.03 and deterministic["live_ate_m"] < 0.03
        assert deterministic["start_s"] == 0
        assert realtime["pairs"] == deterministic["pairs"]
        assert 0 <= realtime["in_time"] <= realtime["tracked"]
        assert 0 < realtime["delay_median_ms"] <= realtime["delay_p95_ms"]
        assert realtime["cpu_ms"] > 0 and realtime["decoding_ms"] > 0
        for run in (deterministic, realtime):
            assert 0 < run["median_ms"] <= run["p95_ms"]
            assert 10 < run["memory_mb"] < 1000
        assert each["median"] == each["worst"] and each["missed"] is None


@pytest.mark.parametrize("arguments, words", [
    ("/nonexistent", "no such file or folder: /nonexistent"),
    ("/etc", "/etc has no rgb.txt"),
    ("{tmp}/unnamed", "--config"),
    ("{tmp}/fr1.bag", "--ground-truth"),
    ("{folder} --config /nonexistent.yaml", "/nonexistent.yaml"),
    ("{folder} --ground-truth /nonexistent.txt", "/nonexistent.txt"),
    ("{folder} --runs 0", "--runs"),
    ("{folder} --other-runs many", "many"),
    ("{folder} --load -1", "--load"),
    ("{folder} --speed 2", "--speed"),
    ("{folder} --programs /nonexistent --no-rendered", "/nonexistent/replay"),
    ("{bad} --no-rendered", "groundtruth.txt:1"),
])
def test_refuses_in_one_line(evaluate, folder, tmp_path, arguments, words):
    (tmp_path / "unnamed").mkdir()
    (tmp_path / "unnamed/rgb.txt").write_text("")
    (tmp_path / "fr1.bag").write_text("")
    bad = tmp_path / "bad/fr1"
    os.makedirs(bad)
    for name in LISTS:
        (bad / name).write_text("no list\n" if name == "groundtruth.txt" else (folder / name).read_text())
    result = evaluate(*arguments.format(tmp=tmp_path, folder=folder, bad=bad).split())
    assert result.returncode == 1
    assert result.stdout == ""
    told = [line for line in result.stderr.splitlines() if not line.endswith("as fast as it goes")]  # what it was at
    assert len(told) == 1 and told[0].startswith("evaluate_localization: "), result.stderr
    assert words in told[0]


def test_what_replay_refuses_is_passed_on(evaluate, folder, tmp_path):
    write_program(tmp_path / "programs/replay", 'echo "replay: too dark" >&2; exit 1')
    result = evaluate(folder, "--programs", tmp_path / "programs", "--no-rendered")
    assert result.returncode == 1
    assert result.stderr.splitlines()[-1] == "evaluate_localization: replay: too dark"


def test_what_runs_ends_with_it(repository, folder, tmp_path):
    pid_file = tmp_path / "pid"
    write_program(tmp_path / "programs/replay",
                  f"echo $$ > {pid_file}.new; mv {pid_file}.new {pid_file}; exec sleep 60")
    with subprocess.Popen([repository / "scripts/evaluate_localization", folder, "--programs", tmp_path / "programs",
                           "--no-rendered"], stderr=subprocess.PIPE, text=True) as process:
        for _ in range(300):
            if pid_file.exists():
                break
            time.sleep(0.1)
        process.terminate()
        assert process.communicate(timeout=30)[1].endswith("evaluate_localization: interrupted\n")
    with pytest.raises(ProcessLookupError):
        os.kill(int(pid_file.read_text()), 0)


def test_help_says_how_to_call_it(evaluate):
    result = evaluate("--help")
    assert result.returncode == 0
    assert result.stdout.startswith("usage: evaluate_localization")
