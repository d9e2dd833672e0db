"""Muon (Jordan et al., 2024): momentum whose singular values are all made one, for kernels of convolutions."""

import torch
from torch import nn

# Of the quintic that drives singular values towards one, as published.
NEWTON_SCHULZ = (3.4445, -4.7750, 2.0315)
ITERATIONS = 5
MOMENTUM = 0.9
RATE_FACTOR = 25.0  # a kernel's radians a step, over the learning rate of all else
LEAST_ROWS = 16  # below that a kernel has no directions to balance


def orthogonal(matrix):
    """U V' of the matrix's singular value decomposition U S V', but for singular values within 0.6 to 1.2.

    Every iterate is a polynomial of the Gram matrix times the matrix, so that only small matrices are multiplied
    before the end.
    """
    a, b, c = NEWTON_SCHULZ
    if matrix.shape[0] > matrix.shape[1]:
        return orthogonal(matrix.T).T
    matrix = matrix / (matrix.norm() + 1e-7)
    gram = matrix @ matrix.T
    identity = torch.eye(len(gram), dtype=gram.dtype, device=gram.device)
    product = identity
    for _ in range(ITERATIONS):
        polynomial = a * identity + (b * identity + c * gram) @ gram
        product = polynomial @ product
        gram = polynomial @ gram @ polynomial
    return product @ matrix


class Muon(torch.optim.Optimizer):
    """Turns kernels by `lr` radians a step or so, and keeps their rows' mean square length at one: what follows is
    normalised, so that their length means nothing but how fast they turn."""

    def __init__(self, kernels, lr):
        super().__init__(kernels, {"lr": lr})

    @torch.no_grad()
    def step(self):
        for group in self.param_groups:
            for kernel in group["params"]:
                if kernel.grad is not None:
                    self.turn(kernel, group["lr"])

    def turn(self, kernel, rate):
        state = self.state[kernel]
        if not state:
            state["momentum"] = torch.zeros_like(kernel)
        state["momentum"].mul_(MOMENTUM).add_(kernel.grad)
        ahead = kernel.grad + MOMENTUM * state["momentum"]
        kernel.mul_(len(kernel) ** 0.5 / kernel.norm())
        kernel.sub_(rate * orthogonal(ahead.flatten(1)).reshape(kernel.shape))


def kernels_to_turn(network):
    """Of convolutions over all channels whose outputs are normalised."""
    return [module.weight for module in network.modules()
            if isinstance(module, nn.Conv2d) and module.bias is None and module.groups == 1
            and len(module.weight) >= LEAST_ROWS]


class MuonAndAdamW:
    """Muon for the kernels that it suits and AdamW for all other parameters, as one optimiser."""

    def __init__(self, network, settings, groups_of):
        """`groups_of`: gives the groups for AdamW, with their decay, of a list of parameters."""
        kernels = kernels_to_turn(network)
        chosen = {id(kernel) for kernel in kernels}
        others = [each for each in network.parameters() if id(each) not in chosen]
        self.parts = {"muon": Muon([{"params": kernels, "rate_factor": RATE_FACTOR}], settings.learning_rate),
                      "adamw": torch.optim.AdamW(groups_of(others), settings.learning_rate)}

    @property
    def param_groups(self):
        return [group for part in self.parts.values() for group in part.param_groups]

    def zero_grad(self, set_to_none=True):
        for part in self.parts.values():
            part.zero_grad(set_to_none)

    def step(self):
        for part in self.parts.values():
            part.step()

    def state_dict(self):
        return {"state": {name: part.state_dict()["state"] for name, part in self.parts.items()}}

    def load_state_dict(self, content):
        for name, part in self.parts.items():
            part.load_state_dict({**part.state_dict(), "state": content["state"][name]})
