"""export/: OpenCV computes what torch does, and the package loads the card."""

import needs_torch  # noqa: F401
import export
import pytest
import torch
import yaml
from torch import nn

from semantic_slam_training.data.input_format import InputFormat, unscaled_input
from semantic_slam_training.engine import checkpoint
from semantic_slam_training.engine.network_spec import APPEARANCE, DETECTION, SEGMENTATION, NetworkSpec
from semantic_slam_training.errors import TrainingError
from semantic_slam_training.export.model_card import sha256, vocabulary_names
from semantic_slam_training.export.onnx_file import check_agreement, deployed, write_onnx
from semantic_slam_training.models import segmentation

NAMES = ("wall", "chair", "coffee table")
SPECS = [NetworkSpec(SEGMENTATION, name, 0.0625, NAMES, InputFormat(96, 64)) for name in segmentation.NETWORKS] + [
    NetworkSpec(DETECTION, "yolov8n", 1.0, NAMES, unscaled_input(96, 64)),
    NetworkSpec(APPEARANCE, "appearance", 0.125, (), InputFormat(64, 64), 5)]
PSPNET, YOLO, LOOKS = SPECS[0], SPECS[-2], SPECS[-1]


def trained(spec):
    """A network whose layers all differ, with statistics of its maps, as after some training.

    Of equal tensors torch exports one, by a node that OpenCV 4.6 does not know; training makes them differ.
    """
    torch.manual_seed(3)
    network = spec.build()
    for module in network.modules():
        if isinstance(module, nn.BatchNorm2d):
            module.momentum = None  # a plain mean over what it sees
            nn.init.uniform_(module.weight, 0.8, 1.2)
        if getattr(module, "bias", None) is not None:
            nn.init.normal_(module.bias, std=0.1)
    with torch.no_grad():
        network.train()(torch.randn(2, 3, spec.input.height, spec.input.width))
    for name, value in network.named_buffers():
        if name.endswith("running_var"):  # of means over whole images of noise hardly any: they would be blown up
            value.clamp_(min=0.1)
    return network.eval()


def content_of(spec):
    """A full checkpoint, as far as export looks at it."""
    return {"spec": spec.to_dict(), "step": 7, "seconds": 3600.0, "about": "2 images of rooms",
            "history": [{"step": 7, "figures": {"mean_iou": 0.5}}], "average": trained(spec).state_dict()}


@pytest.mark.parametrize("spec", SPECS, ids=lambda spec: spec.architecture)
def test_opencv_agrees_with_torch(tmp_path, spec):
    network = deployed(trained(spec), spec)
    write_onnx(network, spec, tmp_path / "network.onnx")
    assert check_agreement(network, spec, tmp_path / "network.onnx") < 1e-3


def test_a_network_that_differs_is_noticed(tmp_path):
    network = deployed(trained(LOOKS), LOOKS)
    write_onnx(network, LOOKS, tmp_path / "network.onnx")
    nn.init.constant_(network.neck.bias, 5.0)
    with pytest.raises(TrainingError, match="gives other results than torch"):
        check_agreement(network, LOOKS, tmp_path / "network.onnx")


def test_the_card_says_what_the_package_must_know(tmp_path):
    line = export.export(content_of(PSPNET), "indoor", tmp_path)
    assert "M parameters" in line and "\n" not in line
    text = (tmp_path / "indoor.yaml").read_text()
    assert "7 steps in 1.0 h on 2 images of rooms" in text.replace("\n# ", " ")  # lines are wrapped
    assert "#   mean_iou: 0.5000\n" in text
    card = yaml.safe_load(text)
    assert card["sha256"] == sha256(tmp_path / "indoor.onnx")
    assert card["input"] == {"name": "image", "width": 96, "height": 64, "colour": "rgb", "scale": 0.00392156863,
                             "mean": [0.485, 0.456, 0.406], "std": [0.229, 0.224, 0.225], "fit": "letterbox",
                             "pad": 124}
    assert card["head"] == {"type": "segmentation", "activation": "softmax"}
    assert card["labels"] == {"file": "indoor.names", "map": {"coffee table": "coffee_table"}}
    assert (tmp_path / "indoor.names").read_text() == "wall\nchair\ncoffee table\n"


def test_the_checkpoint_beside_the_card_can_be_exported_again(tmp_path):
    export.export(content_of(LOOKS), "looks", tmp_path)
    half = checkpoint.load(tmp_path / "looks.pt")
    assert all(tensor.dtype == torch.float16 for tensor in half["weights"].values() if tensor.ndim > 1)
    export.export(half, "again", tmp_path)
    assert sha256(tmp_path / "again.onnx") == sha256(tmp_path / "looks.onnx")
    assert "labels" not in yaml.safe_load((tmp_path / "again.yaml").read_text())


def test_the_card_tells_what_an_evaluation_measured(tmp_path):
    measured = {"images": 3, "map50": 0.75, "at_best_f1": {"threshold": 0.4, "precision": 0.9, "recall": None},
                "classes": {"wall": {"iou": 0.5, "recall": 0.6}, "chair": {"iou": None}}}
    export.export(content_of(LOOKS), "looks", tmp_path, measured)
    comment = [line for line in (tmp_path / "looks.yaml").read_text().splitlines() if line.startswith("#   ")]
    assert comment == ["#   map50: 0.7500", "#   threshold: 0.4000", "#   precision: 0.9000", "#   iou_wall: 0.5000"]


def test_names_are_mapped_to_the_vocabulary_where_they_differ():
    assert vocabulary_names(["chair", "Coffee Table", "night-stand", "spaceship"]) == {
        "Coffee Table": "coffee_table", "night-stand": "night_stand"}


def test_the_package_runs_what_was_exported(tmp_path, room, run_program, repository):
    export.export(content_of(PSPNET), "indoor", tmp_path / "models")
    export.export(content_of(YOLO), "furniture", tmp_path / "models")
    sequence = tmp_path / "sequence"
    sequence.mkdir()
    for name in ("rgb", "depth"):
        (sequence / name).symlink_to(room.folder / name)
        lines = (room.folder / f"{name}.txt").read_text().splitlines(keepends=True)
        (sequence / f"{name}.txt").write_text("".join(lines[:6]))
    result = run_program("replay", "--dataset", sequence, "--config", room.config, "--labels",
                         repository / "config/labels.yaml", "--out", tmp_path / "out", "--segmentation",
                         tmp_path / "models/indoor.yaml", "--detection", tmp_path / "models/furniture.yaml")
    assert result.returncode == 0, result.stderr
