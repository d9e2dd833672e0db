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


@pytest.mark.parametrize("error, text", [
    ({"ate_rmse_m": 0.01234, "ate_rmse_deg": 1.5, "matched": 10, "path_m": 4.25,
      "rpe_trans_rmse_m": 0.02, "rpe_rot_rmse_deg": 1.0}, "ATE RMSE 0.0123 m, 1.50 deg (10 poses, path 4.2 m)"),
    ("only 2 poses match", "trajectory error only 2 poses match"),
])
def test_trajectory_error(error, text):
    assert text in [" ".join(line.split()) for line in table({**SUMMARY, "trajectory_error": error}, TIMINGS)]


def test_without_ground_truth():
    assert "trajectory error no ground truth" in [" ".join(line.split()) for line in table(SUMMARY, TIMINGS)]
