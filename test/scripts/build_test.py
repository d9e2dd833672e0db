"""scripts/build: what it is asked for."""

import pathlib
import subprocess

import pytest

BUILD = pathlib.Path(__file__).resolve().parents[2] / "scripts/build"


def build(*arguments):
    return subprocess.run([BUILD, *arguments], capture_output=True, text=True, timeout=60)


def test_help_builds_nothing():
    result = build("--help")
    assert result.returncode == 0
    assert "--folder FOLDER" in result.stdout and "set -euo" not in result.stdout


@pytest.mark.parametrize("argument", ["--traget", "all", "-D", "-Wdev"])
def test_an_unknown_argument_is_refused_by_name(argument):
    result = build(argument)
    assert result.returncode == 1
    assert result.stderr.splitlines() == [
        f"build: unknown argument {argument}, expected --folder, --target or -DNAME=VALUE; see --help"]


def test_an_option_without_its_value_is_refused():
    result = build("--folder")
    assert result.returncode != 0 and "--folder needs a value" in result.stderr
