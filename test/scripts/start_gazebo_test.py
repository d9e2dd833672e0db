"""scripts/start_gazebo: says so where there is no Gazebo."""

import subprocess

import pytest


def test_says_so_without_gazebo(repository, tmp_path):
    if subprocess.run(["rospack", "find", "gazebo_ros"], capture_output=True, check=False).returncode == 0:
        pytest.skip("gazebo_ros is installed")
    result = subprocess.run([repository / "scripts/start_gazebo", "world.yaml", "tour.yaml", "false"],
                            capture_output=True, text=True, cwd=tmp_path, check=False)
    assert result.returncode == 1
    assert result.stderr.count("\n") == 1 and "gazebo_ros is not installed" in result.stderr
