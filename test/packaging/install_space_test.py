"""The installed package works on its own: programs, launch files, messages."""

import os
import shlex
import subprocess

import pytest


@pytest.fixture(name="installed", scope="module")
def fixture_installed(build_folder, tmp_path_factory):
    """Runs a shell command in the environment of an install space."""
    # --prefix would not do: catkin fixes the place of its setup files when it configures.
    destination = tmp_path_factory.mktemp("install")
    subprocess.run(["cmake", "--install", build_folder], env={**os.environ, "DESTDIR": str(destination)},
                   check=True, capture_output=True)
    setup = next(destination.rglob("setup.bash"))

    def run(command):
        script = f"source {shlex.quote(str(setup))} && {command}"
        # A bare environment, so that nothing of the build comes along.
        return subprocess.run(["env", "-i", "PATH=/usr/bin:/bin", f"HOME={destination}", "bash", "-c", script],
                              capture_output=True, text=True, timeout=60, check=False)

    return run


def test_programs_run(installed):
    result = installed("rosrun semantic_slam replay --help")
    assert result.returncode == 0, result.stderr
    assert result.stdout.startswith("usage: replay ")


@pytest.mark.parametrize("launch", ["semantic_slam.launch", "tum_replay.launch bag:=/a.bag", "d455.launch",
                                    "gazebo.launch"])
def test_launch_files_find_what_they_include_and_start(installed, launch):
    result = installed(f"roslaunch --nodes semantic_slam {launch}")
    assert result.returncode == 0, result.stdout + result.stderr
    assert "tracking" in result.stdout


def test_messages_can_be_imported(installed):
    result = installed("python3 -c 'import semantic_slam.msg, semantic_slam.srv'")
    assert result.returncode == 0, result.stderr
