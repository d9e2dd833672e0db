"""What the Python tests share: the built programs, a rendered room, recorded data where there is any."""

import dataclasses
import os
import pathlib
import subprocess

import pytest

REPOSITORY = pathlib.Path(__file__).resolve().parents[1]
TIMEOUT_S = 900  # a program that takes longer hangs


@dataclasses.dataclass(frozen=True)
class Sequence:
    """A recorded RGB-D sequence with ground truth, in TUM's folder format, and its camera's file."""

    folder: pathlib.Path
    config: pathlib.Path

    @property
    def ground_truth(self):
        return self.folder / "groundtruth.txt"


@pytest.fixture(name="repository", scope="session")
def fixture_repository():
    return REPOSITORY


@pytest.fixture(name="build_folder", scope="session")
def fixture_build_folder():
    """The build under test: $SEMANTIC_SLAM_BUILD, or build."""
    return pathlib.Path(os.environ.get("SEMANTIC_SLAM_BUILD", REPOSITORY / "build")).resolve()


@pytest.fixture(name="run_program", scope="session")
def fixture_run_program(build_folder):
    """Runs one of the package's programs to its end: run_program("replay", "--help", before=["nice"])."""

    def run(name, *arguments, before=()):
        program = build_folder / "devel/lib/semantic_slam" / name
        return subprocess.run([*before, program, *arguments], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=TIMEOUT_S, check=False)

    return run


@pytest.fixture(name="shared_data", scope="session")
def fixture_shared_data():
    """Finds what is kept beside the repository or in $SEMANTIC_SLAM_SHARED; skips the test without it."""
    root = pathlib.Path(os.environ.get("SEMANTIC_SLAM_SHARED", REPOSITORY.parent / "shared"))

    def find(name):
        path = root / name
        if not path.exists():
            pytest.skip(f"{name} is not there; set SEMANTIC_SLAM_SHARED to test it")
        return path

    return find


@pytest.fixture(name="room", scope="session")
def fixture_room(run_program, tmp_path_factory):
    """Four seconds of the textured room."""
    folder = tmp_path_factory.mktemp("room") / "room"
    result = run_program("render_textured_room", folder, "--seconds", "4")
    assert result.returncode == 0, result.stderr
    return Sequence(folder, folder / "camera.yaml")


@pytest.fixture(name="desk", scope="session")
def fixture_desk(shared_data):
    """TUM's freiburg1_desk."""
    return Sequence(shared_data("data/tum/rgbd_dataset_freiburg1_desk"),
                    REPOSITORY / "config/tum_freiburg1.yaml")


@pytest.fixture(name="networks", scope="session")
def fixture_networks(shared_data):
    """Options of replay that give it a segmentation and a detection network; skips without them."""
    shared_data("models/deeplabv3p_mnv2_ade20k32")
    shared_data("models/yolov8n_coco")
    cards = REPOSITORY / "config/cards"
    return ("--segmentation", cards / "deeplabv3p_mnv2_ade20k32_320x240.yaml",
            "--detection", cards / "yolov8n_coco_320x256.yaml")


@pytest.fixture(name="replay", scope="session")
def fixture_replay(run_program):
    """Replays a Sequence into a folder and returns that folder."""

    def run(sequence, out, *options, before=()):
        result = run_program("replay", "--dataset", sequence.folder, "--config", sequence.config,
                             "--labels", REPOSITORY / "config/labels.yaml", "--out", out, *options, before=before)
        assert result.returncode == 0, result.stderr
        return out

    return run


@pytest.fixture(name="room_replay", scope="session")
def fixture_room_replay(replay, room, tmp_path_factory):
    """What needs no network."""
    return replay(room, tmp_path_factory.mktemp("room_replay") / "out")


@pytest.fixture(name="desk_replay", scope="session")
def fixture_desk_replay(replay, desk, networks, tmp_path_factory):
    """Every stage."""
    return replay(desk, tmp_path_factory.mktemp("desk_replay") / "out", *networks)
