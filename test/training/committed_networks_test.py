"""models/: what lies beside each card belongs together, and OpenCV computes from it what torch does."""

import pathlib

import needs_torch  # noqa: F401
import export
import pytest
import yaml

from semantic_slam_training.engine import checkpoint
from semantic_slam_training.export.model_card import sha256
from semantic_slam_training.export.onnx_file import check_agreement

MODELS = pathlib.Path(__file__).resolve().parents[2] / "models"
CARDS = sorted(MODELS.glob("*.yaml"))
LARGEST_BYTES = 15e6  # so that a clone stays small


@pytest.fixture(name="card", params=CARDS, ids=lambda path: path.stem)
def fixture_card(request):
    return request.param


def test_the_networks_that_the_package_runs_are_there():
    assert {path.stem for path in CARDS} >= {"pspnet_indoor", "yolov8n_furniture"}


def test_opencv_agrees_with_torch(card):
    network, spec = export.load_network(checkpoint.load(card.with_suffix(".pt")))
    # Of scores, pixels of boxes and vectors: sums in another order differ by rounding, wrong layers by far more.
    assert check_agreement(network, spec, card.with_suffix(".onnx")) < 1e-3


def test_the_card_is_of_that_network(card):
    content = yaml.safe_load(card.read_text())
    spec = export.load_network(checkpoint.load(card.with_suffix(".pt")))[1]
    assert content["file"] == f"{card.stem}.onnx" and content["sha256"] == sha256(card.with_suffix(".onnx"))
    assert (content["input"]["width"], content["input"]["height"]) == spec.input.size
    if spec.classes:
        assert card.with_suffix(".names").read_text().split("\n")[:-1] == list(spec.classes)


def test_files_are_small(card):
    for suffix in (".onnx", ".pt"):
        assert card.with_suffix(suffix).stat().st_size < LARGEST_BYTES
