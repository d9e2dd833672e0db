"""evaluate_trajectory: agrees with an evaluator that was written independently, in Python."""

import json
import subprocess

import pytest

SAME_AS = {  # our name for a figure, the other's
    "ate_rmse_m": "ate_rmse_m",
    "ate_median_m": "ate_median_m",
    "ate_max_m": "ate_max_m",
    "rpe_trans_rmse_m": "rpe1s_trans_rmse_m",
    "rpe_rot_rmse_deg": "rpe1s_rot_rmse_deg",
    "rpe_pairs": "rpe_pairs",
    "matched": "matched",
    "path_m": "path_m",
}


@pytest.mark.parametrize("trajectory", ["trajectory.txt", "trajectory_live.txt", "keyframe_trajectory.txt"])
@pytest.mark.parametrize("name", ["room", "desk"])
def test_agrees_with_the_independent_evaluator(request, run_program, shared_data, name, trajectory):
    evaluator = shared_data("tools/trajectory_error.py")
    sequence = request.getfixturevalue(name)
    estimate = request.getfixturevalue(f"{name}_replay") / trajectory
    ours = run_program("evaluate_trajectory", sequence.ground_truth, estimate, "--json")
    theirs = subprocess.run(["/usr/bin/python3", evaluator, sequence.ground_truth, estimate, "--json"],
                            capture_output=True, text=True, check=True)
    assert ours.returncode == 0, ours.stderr
    ours, theirs = json.loads(ours.stdout), json.loads(theirs.stdout)
    assert {key: ours[key] for key in SAME_AS} == pytest.approx(
        {key: theirs[name] for key, name in SAME_AS.items()}, abs=1e-6)


def test_draws_a_plot(run_program, room, room_replay, tmp_path):
    plot = tmp_path / "plot.png"
    result = run_program("evaluate_trajectory", room.ground_truth, room_replay / "trajectory.txt", "--plot", plot)
    assert result.returncode == 0, result.stderr
    assert plot.read_bytes().startswith(b"\x89PNG")
    assert "ATE" in result.stdout
