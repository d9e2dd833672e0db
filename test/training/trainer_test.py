"""engine/: losses fall, and training that was stopped goes on as if it had not been."""

import dataclasses

import needs_torch  # noqa: F401
import pytest
import torch
from tiny_sets import Scenes

from semantic_slam_training.data.augmentation import Augmentation
from semantic_slam_training.data.input_format import InputFormat
from semantic_slam_training.data.samples import AppearanceSamples, SegmentationSamples
from semantic_slam_training.engine import checkpoint
from semantic_slam_training.engine.network_spec import APPEARANCE, SEGMENTATION, NetworkSpec
from semantic_slam_training.engine.settings import Settings
from semantic_slam_training.engine.tasks import AppearanceTask, SegmentationTask, Task, to_device
from semantic_slam_training.engine.trainer import Trainer, latest_figures
from semantic_slam_training.errors import TrainingError

FRAME = InputFormat(64, 48)
SPEC = NetworkSpec(SEGMENTATION, "pspnet_resnet18", 0.125, Scenes.names, FRAME)
ONE_STEP = 1e-9  # minutes: time is up after a step


class Objects(Scenes):
    """Each scene is an object of its own."""

    @property
    def identities(self):
        return list(range(self.count))

    def read(self, index):
        return super().read(index)[0], index


def settings(**changes):
    return Settings(**{"steps": 4, "batch_size": 2, "learning_rate": 3e-3, "warmup_steps": 2, "validate_every": 4,
                       "average_decay": 0.5, "threads": 1, "device": "cpu", **changes})


def segmentation_task(chosen, augmentation=None):
    images = Scenes(4)
    return SegmentationTask(SegmentationSamples(images, FRAME, augmentation, chosen.seed),
                            SegmentationSamples(images, FRAME), chosen, torch.ones(2))


def appearance_task(chosen):
    return AppearanceTask(AppearanceSamples(Objects(2), InputFormat(32, 32)), None, chosen)


def trainer(folder, chosen=None, augmentation=None, spec=SPEC):
    chosen = chosen or settings()
    return Trainer(segmentation_task(chosen, augmentation), spec, chosen, folder)


def weights_of(folder):
    content = checkpoint.load(folder / checkpoint.FULL_NAME)
    return {**{f"network.{name}": tensor for name, tensor in content["network"].items()},
            **{f"average.{name}": tensor for name, tensor in content["average"].items()}}


@pytest.mark.parametrize("make_task, spec, steps, share", [
    (segmentation_task, SPEC, 40, 0.7),
    (appearance_task, NetworkSpec(APPEARANCE, "appearance", 0.125, (), InputFormat(32, 32), 2), 10, 0.7),
])
def test_the_loss_on_a_few_images_falls(tmp_path, make_task, spec, steps, share):
    chosen = settings(steps=steps, learning_rate=5e-3, validate_every=1000)
    run = Trainer(make_task(chosen), spec, chosen, tmp_path)

    def loss():
        run.state.network.train()
        batch = next(iter(run.task.batches(range(1))))
        with torch.no_grad():
            return float(sum(run.task.losses(run.state.network, to_device(batch, "cpu")).values()))

    before = loss()
    run.task.validation = None
    run.run()
    assert loss() < share * before


@pytest.mark.parametrize("precision", ["full", "mixed"])
def test_stopping_changes_nothing(tmp_path, precision):
    trainer(tmp_path / "whole", settings(precision=precision), Augmentation()).run()
    for step in range(4):
        run = trainer(tmp_path / "parts", settings(precision=precision, minutes=ONE_STEP), Augmentation())
        assert run.state.step == step
        run.run()
    whole, parts = weights_of(tmp_path / "whole"), weights_of(tmp_path / "parts")
    assert whole.keys() == parts.keys()
    assert all(torch.equal(whole[name], parts[name]) for name in whole)


def test_another_seed_gives_other_weights(tmp_path):
    for seed in (1, 2):
        trainer(tmp_path / str(seed), settings(seed=seed, minutes=ONE_STEP)).run()
    name = "network.backbone.stem.0.0.weight"
    assert not torch.equal(weights_of(tmp_path / "1")[name], weights_of(tmp_path / "2")[name])


def test_figures_are_kept_with_the_weights(tmp_path):
    figures = trainer(tmp_path).run()
    assert 0 <= figures["mean_iou"] <= 1 and 0 <= figures["pixel_accuracy"] <= 1
    assert latest_figures(checkpoint.load(tmp_path / checkpoint.FULL_NAME)["history"]) == figures


def test_a_half_checkpoint_is_small_and_training_goes_on_from_it(tmp_path):
    trainer(tmp_path / "first", settings(steps=8, minutes=ONE_STEP)).run()
    full = checkpoint.load(tmp_path / "first" / checkpoint.FULL_NAME)
    checkpoint.save(tmp_path / "half.pt", checkpoint.half_of(full))
    half_size, full_size = (path.stat().st_size for path in (tmp_path / "half.pt", tmp_path / "first/checkpoint.pt"))
    assert half_size < full_size / 5  # 2 of 16 bytes a weight, and file overhead
    run = trainer(tmp_path / "second", settings(steps=8))
    run.start_from(tmp_path / "half.pt")
    assert run.state.step == run.state.moments_since == 1
    for name, value in run.state.network.state_dict().items():
        assert torch.allclose(value.float(), full["average"][name].float(), rtol=1e-3, atol=1e-4)  # 11 bits
    run.run()
    assert run.is_finished()


def test_training_may_begin_on_images_of_another_size(tmp_path):
    trainer(tmp_path / "small", settings(minutes=ONE_STEP)).run()
    larger = dataclasses.replace(SPEC, input=InputFormat(96, 64))
    run = trainer(tmp_path / "large", spec=larger)
    run.start_from(tmp_path / "small/checkpoint.pt")
    assert run.state.step == 1
    run.run()
    content = checkpoint.half_of(checkpoint.load(tmp_path / "large/checkpoint.pt"))
    assert {"step": 1, "input": [64, 48]} in content["history"]
    with pytest.raises(TrainingError, match="its network has input"):
        trainer(tmp_path / "large")


def test_a_checkpoint_of_another_network_is_refused(tmp_path):
    trainer(tmp_path, settings(minutes=ONE_STEP)).run()
    wider = NetworkSpec(SEGMENTATION, "pspnet_resnet18", 0.25, Scenes.names, FRAME)
    with pytest.raises(TrainingError, match="its network has width 0.125, but 0.25 is asked for"):
        trainer(tmp_path, spec=wider)


@pytest.mark.parametrize("content", [b"", b"text", b"PK\x03\x04 cut short"])
def test_what_is_no_checkpoint_is_refused(tmp_path, content):
    path = tmp_path / "checkpoint.pt"
    path.write_bytes(content)
    with pytest.raises(TrainingError, match="not a checkpoint of this trainer, or cut short"):
        checkpoint.load(path)


def test_a_loss_that_is_no_number_ends_training(tmp_path):
    class Broken(Task):
        """Its loss is not a number."""

        def losses(self, network, batch):
            return {"nothing": network(batch[0])[0].sum() * float("nan")}

    chosen = settings()
    run = Trainer(Broken(SegmentationSamples(Scenes(2), FRAME), None, chosen), SPEC, chosen, tmp_path)
    with pytest.raises(TrainingError, match="step 0: the loss is nan; try a lower --learning-rate"):
        run.run()


def test_the_rate_rises_and_falls():
    chosen = settings(steps=100, learning_rate=1.0, warmup_steps=10)
    assert chosen.rate_at(0, 0) == pytest.approx(0.1, abs=1e-3)
    assert chosen.rate_at(50, 0) == pytest.approx(0.505, abs=1e-6)
    assert chosen.rate_at(100, 0) == pytest.approx(0.01)
    assert chosen.rate_at(50, 50) == pytest.approx(0.0505, abs=1e-6)  # moments are new again


@pytest.mark.parametrize("changes, words", [
    ({"steps": 0}, "--steps 0: expected 1 or more"),
    ({"learning_rate": -1.0}, "--learning-rate -1.0: expected a positive number"),
    ({"optimizer": "adam"}, "--optimizer adam: expected muon, adamw or sgd"),
    ({"average_decay": 1.0}, "--average-decay 1.0"),
    ({"precision": "half"}, "--precision half: expected full or mixed"),
])
def test_wrong_settings_are_refused(changes, words):
    with pytest.raises(TrainingError, match=words):
        settings(**changes)
