"""One run of replay, measured."""

import csv
import dataclasses
import decimal
import json
import pathlib
import tempfile

from localization_evaluation import programs
from localization_evaluation.sequences import pairs, read_rows

MIN_POSES = 3  # fewer cannot be laid on the true trajectory


@dataclasses.dataclass(frozen=True)
class Run:
    """What a run was like. None is what cannot be told: errors of fewer than three poses, a start that never was, and
    what only a run at the sensor's rate has."""

    pairs: int  # of images that the sequence has
    tracked: int
    in_time: int | None  # of these, those whose pose came soon enough after the image's delivery
    lost: int
    dropped: int  # never reached tracking: too late for it, or not readable
    loops: int  # that were closed
    final_ate_m: float | None  # RMSE after correction
    live_ate_m: float | None  # RMSE of the poses as they were published; at the sensor's rate, of those in time
    delay_median_ms: float | None  # from an image's delivery to its pose
    delay_p95_ms: float | None
    median_ms: float  # from an image to its pose, once its turn has come
    p95_ms: float
    cpu_ms: float | None  # per image, of all threads, without decoding
    decoding_ms: float | None  # per image, CPU
    memory_mb: float
    start_s: float | None  # from the first pair of images to the first with a pose


def track(folder, sequence, out, is_realtime, title):
    """Runs replay and returns the memory it took [MB]."""
    options = ("--realtime",) if is_realtime else ()
    return programs.run(folder / "replay", ("--dataset", sequence.path, "--config", sequence.config, "--out", out,
                                            "--stages", "tracking", *options), title)


def pose_lines(trajectory):
    return [line for line in trajectory.read_text().splitlines() if line and not line.startswith("#")]


def error_m(folder, sequence, trajectory):
    """RMSE of a trajectory's positions; None if it is too short."""
    if len(pose_lines(trajectory)) < MIN_POSES:
        return None
    return json.loads(programs.ask(folder / "evaluate_trajectory", sequence.ground_truth, trajectory,
                                   "--json"))["ate_rmse_m"]


def drop_late(trajectory, delays, latest_ms):
    """Takes the poses out of a trajectory that came later than `latest_ms` after their images."""
    with open(delays, newline="", encoding="ascii") as file:
        late = {decimal.Decimal(row["stamp"]) for row in csv.DictReader(file) if float(row["delay_ms"]) > latest_ms}
    kept = [line for line in pose_lines(trajectory) if decimal.Decimal(line.split()[0]) not in late]
    trajectory.write_text("".join(f"{line}\n" for line in kept))


def tracking_ms(path):
    """Median and 95 % of the row of tracking in timing.csv."""
    with open(path, newline="", encoding="ascii") as file:
        row = next(row for row in csv.DictReader(file) if row["stage"] == "tracking")
    return float(row["median_ms"]), float(row["p95_ms"])


def start_s(sequence, trajectory):
    """Of the recording's time; None for bags, whose pairs are not known here, and if no image has a pose."""
    if not sequence.path.is_dir() or not pose_lines(trajectory):
        return None
    (first, _), _ = pairs(sequence.path)[0]
    return float(read_rows(trajectory)[0][0] - first)


def measure(folder, sequence, is_realtime, title):
    """Run of the programs in `folder`."""
    with tempfile.TemporaryDirectory() as work:
        out = pathlib.Path(work)
        memory_mb = track(folder, sequence, out, is_realtime, title)
        summary = json.loads((out / "summary.json").read_text())
        live = summary.get("live", {})
        if live:
            drop_late(out / "trajectory_live.txt", out / "delays.csv", live["latest_ms"])
        dropped, (median_ms, p95_ms) = sum(summary["dropped"].values()), tracking_ms(out / "timing.csv")
        return Run(pairs=summary["images"] + dropped, tracked=summary["tracked"], in_time=live.get("in_time"),
                   lost=summary["lost"], dropped=dropped, loops=summary["loops"],
                   final_ate_m=error_m(folder, sequence, out / "trajectory.txt"),
                   live_ate_m=error_m(folder, sequence, out / "trajectory_live.txt"),
                   delay_median_ms=live.get("delay_median_ms"), delay_p95_ms=live.get("delay_p95_ms"),
                   median_ms=median_ms, p95_ms=p95_ms, cpu_ms=live.get("cpu_ms_per_image"),
                   decoding_ms=live.get("decoding_ms_per_image"), memory_mb=memory_mb,
                   start_s=start_s(sequence, out / "trajectory_live.txt"))


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
