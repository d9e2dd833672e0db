"""scripts/show_summary.py: what stands in the table."""

import pytest

from show_summary import table

SUMMARY = {"tracked": 10, "lost": 1, "dropped": {"late": 2, "bad_image": 0}, "keyframes": 3, "map_points": 400}
TIMINGS = [{"stage": "tracking", "count": "11", "median_ms": "20.04", "p95_ms": "31.5"}]


def test_counts_and_timings():
    lines = list(table(SUMMARY, TIMINGS))
    assert lines[0].split() == ["images", "tracked", "10"]
    assert lines[2].split() == ["images", "dropped", "2", "(2", "late)"]
    assert lines[-1].split() == ["tracking", "11", "20.0", "31.5"]


def test_loops_are_told_if_there_were_any():
    lines = [" ".join(line.split()) for line in table({**SUMMARY, "loops": 2}, TIMINGS)]
    assert lines[5] == "loops closed 2"
    for summary in (SUMMARY, {**SUMMARY, "loops": 0}):  # runs of before did not tell
        assert not any(line.startswith("loops") for line in table(summary, TIMINGS))


@pytest.mark.parametrize("error, text", [
    ({"ate_rmse_m": 0.01234, "ate_rmse_deg": 1.5, "matched": 10, "path_m": 4.25,
      "rpe_trans_rmse_m": 0.02, "rpe_rot_rmse_deg": 1.0}, "ATE RMSE 0.0123 m, 1.50 deg (10 poses, path 4.2 m)"),
    ("only 2 poses match", "trajectory error only 2 poses match"),
])
def test_trajectory_error(error, text):
    assert text in [" ".join(line.split()) for line in table({**SUMMARY, "trajectory_error": error}, TIMINGS)]


def test_without_ground_truth():
    assert "trajectory error no ground truth" in [" ".join(line.split()) for line in table(SUMMARY, TIMINGS)]


EVALUATION = {
    "voxels": {"occupied": 2000, "right": 0.875, "without_surface": 0.0625},
    "objects": {"found": 9, "expected": 10, "right_class": 1.0, "extra": 2, "position_mean_m": 0.123,
                "position_max_m": 0.5, "size_mean_m": 0.25, "size_max_m": 1.0},
    "grid": {"free_precision": 1.0, "free_recall": 0.995, "occupied_precision": None, "occupied_recall": 0.75},
    "semantic_grid": None,
}


def test_errors_of_maps():
    lines = [" ".join(line.split()) for line in table(SUMMARY, TIMINGS, EVALUATION)]
    for line in ("voxels with the right label 87.5 % of 2000; besides, 6.2 % are far from any surface",
                 "objects found 9 of 10, 100.0 % of the right class; 2 more that are none",
                 "position, size of objects 0.12 m, 0.25 m off in the mean, 0.50 m, 1.00 m at most",
                 "floor plan, free cells 100.0 % are free, 99.5 % of the free are found",
                 "floor plan, occupied cells - are occupied, 75.0 % of the occupied are found"):
        assert line in lines
    assert not any(line.startswith("semantic grid") for line in lines)


def test_maps_without_objects():
    evaluation = {"voxels": None, "objects": {**EVALUATION["objects"], "found": 0}, "grid": None, "semantic_grid": None}
    lines = list(table(SUMMARY, TIMINGS, evaluation))
    assert any(line.startswith("objects found") for line in lines)
    assert not any(line.startswith("position") for line in lines)
