#!/usr/bin/python3
"""Prints what a run has left in a folder as a table: summary.json, timing.csv, and evaluation.json where the truth was
known (evaluate_maps --json)."""

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
    if loops := summary.get("loops"):
        yield "loops closed", f"{loops}"


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


def percent(share):
    return "-" if share is None else f"{100 * share:.1f} %"


def map_errors(evaluation):
    """How far the maps are from the world; what was not made is left out."""
    if voxels := evaluation["voxels"]:
        yield "voxels with the right label", (f"{percent(voxels['right'])} of {voxels['occupied']}; besides, "
                                              f"{percent(voxels['without_surface'])} are far from any surface")
    if objects := evaluation["objects"]:
        yield "objects found", (f"{objects['found']} of {objects['expected']}, {percent(objects['right_class'])} of the "
                                f"right class; {objects['extra']} more that are none")
    if objects and objects["found"]:
        yield "position, size of objects", (f"{objects['position_mean_m']:.2f} m, {objects['size_mean_m']:.2f} m off in "
                                            f"the mean, {objects['position_max_m']:.2f} m, "
                                            f"{objects['size_max_m']:.2f} m at most")
    for name, key in (("floor plan", "grid"), ("semantic grid", "semantic_grid")):
        if grid := evaluation[key]:
            yield f"{name}, free cells", (f"{percent(grid['free_precision'])} are free, "
                                          f"{percent(grid['free_recall'])} of the free are found")
            yield f"{name}, occupied cells", (f"{percent(grid['occupied_precision'])} are occupied, "
                                              f"{percent(grid['occupied_recall'])} of the occupied are found")


def table(summary, timings, evaluation=None):
    """The lines of the table."""
    for name, value in (*counts(summary), *errors(summary), *(map_errors(evaluation) if evaluation else ())):
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
        evaluation = folder / "evaluation.json"
        evaluation = json.loads(evaluation.read_text()) if evaluation.exists() else None
    except (OSError, ValueError) as error:
        sys.exit(f"show_summary.py: {error}")
    print("\n".join(table(summary, timings, evaluation)))


if __name__ == "__main__":
    main()
