"""scripts/check_core_is_ros_free.sh: the core includes no ROS header, and the check would notice."""

import pathlib
import shutil
import subprocess

import pytest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/check_core_is_ros_free.sh"


def test_the_core_includes_no_ros_header():
    result = subprocess.run([SCRIPT], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr


@pytest.mark.parametrize("include", ["<ros/ros.h>", "<sensor_msgs/Image.h>", '"semantic_slam_ros/topics.h"'])
def test_the_check_notices_one(tmp_path, include):
    (tmp_path / "scripts").mkdir()
    (tmp_path / "src/semantic_slam/common").mkdir(parents=True)
    (tmp_path / "src/semantic_slam/common/stamp.h").write_text(f"#include {include}\n")
    copy = shutil.copy(SCRIPT, tmp_path / "scripts")
    result = subprocess.run([copy], capture_output=True, text=True, check=False)
    assert result.returncode == 1
    assert "stamp.h" in result.stdout
