"""One run of replay, measured."""

import csv
import dataclasses
import json
import pathlib
import tempfile

from localization_evaluation import programs
from localization_evaluation.sequences import pairs, read_rows

MIN_POSES = 3  # fewer cannot be laid on the true trajectory


@dataclasses.dataclass(frozen=True)
class Run:
    """What a run was like. None is what cannot be told: errors of fewer than three poses, a start that never was."""

    pairs: int  # of images that the sequence has
    tracked: int
    lost: int
    dropped: int  # never reached tracking: too late for it, or not readable
    loops: int  # that were closed
    final_ate_m: float | None  # RMSE after correction
    live_ate_m: float | None  # RMSE of the poses as they were published
    median_ms: float  # from an image to its pose
    p95_ms: float
    cpu_ms: float  # per image, of all threads
    memory_mb: float
    start_s: float | None  # from the first pair of images to the first with a pose


def track(folder, sequence, out, is_realtime, title):
    """Runs replay and returns its Usage."""
    options = ("--realtime",) if is_realtime else ()
    return programs.run(folder / "replay", ("--dataset", sequence.path, "--config", sequence.config, "--out", out,
                                            "--stages", "tracking", *options), title)


def error_m(folder, sequence, trajectory):
    """RMSE of a trajectory's positions; None if it is too short."""
    poses = [line for line in trajectory.read_text().splitlines() if line and not line.startswith("#")]
    if len(poses) < MIN_POSES:
        return None
    return json.loads(programs.ask(folder / "evaluate_trajectory", sequence.ground_truth, trajectory,
                                   "--json"))["ate_rmse_m"]


def tracking_ms(path):
    """Median and 95 % of the row of tracking in timing.csv."""
    with open(path, newline="", encoding="ascii") as file:
        row = next(row for row in csv.DictReader(file) if row["stage"] == "tracking")
    return float(row["median_ms"]), float(row["p95_ms"])


def start_s(sequence, trajectory):
    """Of the recording's time; None for bags, whose pairs are not known here, and if no image has a pose."""
    poses = [line for line in trajectory.read_text().splitlines() if line and not line.startswith("#")]
    if not sequence.path.is_dir() or not poses:
        return None
    (first, _), _ = pairs(sequence.path)[0]
    return float(read_rows(trajectory)[0][0] - first)


def measure(folder, sequence, is_realtime, title):
    """Run of the programs in `folder`."""
    with tempfile.TemporaryDirectory() as work:
        out = pathlib.Path(work)
        usage = track(folder, sequence, out, is_realtime, title)
        summary = json.loads((out / "summary.json").read_text())
        dropped, (median_ms, p95_ms) = sum(summary["dropped"].values()), tracking_ms(out / "timing.csv")
        return Run(summary["images"] + dropped, summary["tracked"], summary["lost"], dropped, summary["loops"],
                   error_m(folder, sequence, out / "trajectory.txt"),
                   error_m(folder, sequence, out / "trajectory_live.txt"), median_ms, p95_ms,
                   1e3 * usage.cpu_s / max(1, summary["images"]), usage.memory_mb,
                   start_s(sequence, out / "trajectory_live.txt"))


@dataclasses.dataclass(frozen=True)
class Runs:
    """All runs on a sequence; those at the sensor's rate differ from each other."""

    name: str
    realtime: list
    deterministic: Run


def measure_all(folder, sequence, count):
    deterministic = measure(folder, sequence, False, f"{sequence.name}: as fast as it goes")
    realtime = [measure(folder, sequence, True, f"{sequence.name}: at the sensor's rate, run {i + 1} of {count}")
                for i in range(count)]
    return Runs(sequence.name, realtime, deterministic)
