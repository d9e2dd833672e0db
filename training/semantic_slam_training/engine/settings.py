"""How a network is trained, whatever it is."""

import dataclasses
import math

from semantic_slam_training.errors import TrainingError

OPTIMIZERS = ("muon", "adamw", "sgd")
LEAST_FACTOR = 0.01  # of the learning rate, at the end


@dataclasses.dataclass(frozen=True)
class Settings:
    """Defaults suit two cores; what is None is decided when training begins."""

    steps: int
    batch_size: int
    learning_rate: float
    optimizer: str = "muon"  # or one of OPTIMIZERS
    weight_decay: float = 0.02  # not of biases and normalisation
    warmup_steps: int = 200
    average_decay: float = 0.998  # of the moving average of weights, which is what is kept
    validate_every: int = 1000
    validation_images: int = 200
    checkpoint_every: int = 200
    seed: int = 1
    minutes: float = None  # stop after that time, to go on later
    workers: int = 0  # processes that read images
    threads: int = None
    device: str = None  # cpu or cuda
    precision: str = None  # full or mixed

    def __post_init__(self):
        for name in ("steps", "batch_size", "validate_every", "validation_images", "checkpoint_every"):
            self.check(name, getattr(self, name) >= 1, "1 or more")
        self.check("learning_rate", self.learning_rate > 0, "a positive number")
        self.check("optimizer", self.optimizer in OPTIMIZERS, ", ".join(OPTIMIZERS[:-1]) + f" or {OPTIMIZERS[-1]}")
        self.check("precision", self.precision in (None, "full", "mixed"), "full or mixed")
        self.check("minutes", self.minutes is None or self.minutes > 0, "a positive number")
        self.check("average_decay", 0 <= self.average_decay < 1, "0 or more and below 1")

    def check(self, name, fulfilled, expected):
        if not fulfilled:
            raise TrainingError(f"--{name.replace('_', '-')} {getattr(self, name)}: expected {expected}")

    def rate_at(self, step, moments_since):
        """Learning rate of a step: a cosine over all steps; rising first while the optimiser's moments,
        which begin at the step `moments_since`, mean little."""
        rising = min(1.0, (step - moments_since + 1) / max(self.warmup_steps, 1))
        falling = LEAST_FACTOR + (1 - LEAST_FACTOR) * (1 + math.cos(math.pi * min(step / self.steps, 1.0))) / 2
        return self.learning_rate * rising * falling
