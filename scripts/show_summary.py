#!/usr/bin/python3
"""Prints what a run has left in a folder, summary.json and timing.csv, as a table."""

import argparse
import csv
import json
import pathlib
import sys


def counts(summary):
    dropped = summary.get("dropped", {})
    causes = ", ".join(f"{count} {cause}" for cause, count in dropped.items() if count)
    yield "images tracked", f"{summary['tracked']}"
    yield "images lost", f"{summary['lost']}"
    yield "images dropped", f"{sum(dropped.values())}" + (f" ({causes})" if causes else "")
    yield "keyframes", f"{summary['keyframes']}"
    yield "map points", f"{summary['map_points']}"


def errors(summary):
    error = summary.get("trajectory_error")
    if error is None:
        yield "trajectory error", "no ground truth"
    elif isinstance(error, str):  # why it could not be told
        yield "trajectory error", error
    else:
        yield "ATE RMSE", (f"{error['ate_rmse_m']:.4f} m, {error['ate_rmse_deg']:.2f} deg "
                           f"({error['matched']} poses, path {error['path_m']:.1f} m)")
        yield "RPE RMSE over 1 s", f"{error['rpe_trans_rmse_m']:.4f} m, {error['rpe_rot_rmse_deg']:.2f} deg"


def table(summary, timings):
    """The lines of the table."""
    for name, value in (*counts(summary), *errors(summary)):
        yield f"{name:<32} {value}"
    yield ""
    yield f"{'stage':<32} {'count':>7} {'median ms':>11} {'95 % ms':>11}"
    for row in timings:
        yield (f"{row['stage']:<32} {row['count']:>7} {float(row['median_ms']):>11.1f} "
               f"{float(row['p95_ms']):>11.1f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    folder = parser.parse_args().folder
    try:
        summary = json.loads((folder / "summary.json").read_text())
        with open(folder / "timing.csv", newline="") as file:
            timings = list(csv.DictReader(file))
    except (OSError, ValueError) as error:
        sys.exit(f"show_summary.py: {error}")
    print("\n".join(table(summary, timings)))


if __name__ == "__main__":
    main()
