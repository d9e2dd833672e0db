"""Muon turns kernels evenly, and is one optimiser with AdamW."""

import needs_torch  # noqa: F401
import pytest
import torch

from semantic_slam_training.engine.muon import Muon, MuonAndAdamW, kernels_to_turn, orthogonal
from semantic_slam_training.engine.settings import Settings
from semantic_slam_training.engine.state import parameter_groups
from semantic_slam_training.models.segmentation import build


@pytest.mark.parametrize("shape", [(24, 200), (200, 24), (16, 16)])
def test_singular_values_become_one_in_any_shape(shape):
    torch.manual_seed(1)
    matrix = torch.randn(shape)
    u, _, v = torch.linalg.svd(matrix, full_matrices=False)
    found = orthogonal(matrix)
    assert found.shape == shape
    values = torch.linalg.svdvals(found)
    # As far as five iterations of the published polynomial bring them.
    assert values.min() > 0.3 and values.max() < 1.3
    assert torch.linalg.norm(found - u @ v) < 0.35 * torch.linalg.norm(u @ v)


def test_a_vanished_gradient_is_no_trouble():
    assert torch.equal(orthogonal(torch.zeros(16, 32)), torch.zeros(16, 32))


def test_rows_keep_their_mean_length_and_the_loss_falls():
    torch.manual_seed(1)
    wanted = torch.nn.functional.normalize(torch.randn(16, 40), dim=1)
    kernel = torch.nn.Parameter(torch.randn(16, 40) * 7)
    optimizer = Muon([kernel], lr=0.02)
    losses = []
    for _ in range(200):
        loss = -(torch.nn.functional.normalize(kernel, dim=1) * wanted).sum()
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        losses.append(float(loss))
    assert losses[-1] < 0.95 * -16 < losses[0]
    assert float(kernel.norm()) == pytest.approx(4.0, rel=0.05)  # the root of 16 rows


def test_kernels_that_nothing_normalises_are_left_to_adamw():
    network = build("pspnet_mobilenetv2", 5, 0.5)
    chosen = {id(kernel) for kernel in kernels_to_turn(network)}
    for module in network.modules():
        if isinstance(module, torch.nn.Conv2d) and (module.bias is not None or module.groups > 1):
            assert id(module.weight) not in chosen
    assert chosen


def test_both_parts_go_on_from_what_was_kept():
    def begin():
        torch.manual_seed(3)
        network = torch.nn.Sequential(torch.nn.Conv2d(3, 16, 3, bias=False), torch.nn.BatchNorm2d(16))
        settings = Settings(steps=10, batch_size=1, learning_rate=0.01)
        return network, MuonAndAdamW(network, settings, lambda rest: parameter_groups(rest, 0.02))

    def step(network, optimizer, seed):
        torch.manual_seed(seed)
        optimizer.zero_grad()
        network(torch.randn(2, 3, 8, 8)).pow(3).mean().backward()
        optimizer.step()

    network, optimizer = begin()
    step(network, optimizer, 1)
    kept = optimizer.state_dict()["state"]
    other, going_on = begin()
    other.load_state_dict(network.state_dict())
    going_on.load_state_dict({**going_on.state_dict(), "state": kept})
    step(network, optimizer, 2)
    step(other, going_on, 2)
    for ours, theirs in zip(network.parameters(), other.parameters()):
        assert torch.equal(ours, theirs)
