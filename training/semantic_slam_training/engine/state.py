"""What training changes: weights, their moving average, the optimiser's moments, the step."""

import copy

import torch

from semantic_slam_training.engine import checkpoint
from semantic_slam_training.engine.muon import MuonAndAdamW
from semantic_slam_training.engine.network_spec import NetworkSpec
from semantic_slam_training.errors import TrainingError


def parameter_groups(parameters, weight_decay):
    """Weights decay; biases and normalisation do not."""
    parameters = list(parameters)
    return [{"params": [each for each in parameters if each.ndim > 1], "weight_decay": weight_decay},
            {"params": [each for each in parameters if each.ndim <= 1], "weight_decay": 0.0}]


def make_optimizer(network, settings):
    def groups_of(parameters):
        return parameter_groups(parameters, settings.weight_decay)

    if settings.optimizer == "muon":
        return MuonAndAdamW(network, settings, groups_of)
    if settings.optimizer == "sgd":
        return torch.optim.SGD(groups_of(network.parameters()), settings.learning_rate, momentum=0.9, nesterov=True)
    return torch.optim.AdamW(groups_of(network.parameters()), settings.learning_rate)


class TrainingState:
    """Begins at step 0 with random weights of the settings' seed."""

    def __init__(self, spec, settings, device):
        torch.manual_seed(settings.seed)
        self.spec = spec
        self.device = device
        self.network = spec.build().to(device, memory_format=torch.channels_last)
        self.average = copy.deepcopy(self.network).eval()
        self.optimizer = make_optimizer(self.network, settings)
        self.step = 0
        self.moments_since = 0
        self.seconds = 0.0
        self.history = []

    def update_average(self, decay):
        """Moves the average towards the weights; faster while it is young."""
        age = self.step - self.moments_since
        share = 1 - min(decay, (1 + age) / (10 + age))
        with torch.no_grad():
            for average, value in zip(self.average.state_dict().values(), self.network.state_dict().values()):
                if average.is_floating_point():
                    average.lerp_(value, share)
                else:
                    average.copy_(value)

    def to_checkpoint(self, about):
        """`about`: text on data and settings, for the model card."""
        return {"spec": self.spec.to_dict(), "step": self.step, "moments_since": self.moments_since,
                "seconds": self.seconds, "history": self.history, "about": about,
                "network": self.network.state_dict(), "average": self.average.state_dict(),
                "optimizer": self.optimizer.state_dict()["state"]}

    def restore(self, path, other_input=False):
        """Goes on from a full checkpoint as if nothing had been, or from a half one with new moments.

        `other_input`: whether it may have been trained on images of another size.
        """
        content = checkpoint.load(path)
        spec = NetworkSpec.from_dict(content["spec"])
        self.check_spec(path, spec, other_input)
        self.step, self.seconds, self.history = content["step"], content["seconds"], content["history"]
        if spec.input.size != self.spec.input.size:
            self.history.append({"step": self.step, "input": list(spec.input.size)})
        if "weights" in content:
            self.network.load_state_dict(checkpoint.full_weights(content))
            self.average.load_state_dict(checkpoint.full_weights(content))
            self.moments_since = self.step
        else:
            self.network.load_state_dict(content["network"])
            self.average.load_state_dict(content["average"])
            self.optimizer.load_state_dict({**self.optimizer.state_dict(), "state": content["optimizer"]})
            self.moments_since = content["moments_since"]

    def check_spec(self, path, spec, other_input):
        found, wanted = spec.to_dict(), self.spec.to_dict()
        for key, value in wanted.items():
            if found[key] != value and not (other_input and key == "input"):
                raise TrainingError(f"{path}: its network has {key} {found[key]}, but {value} is asked for")
