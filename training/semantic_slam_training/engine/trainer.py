"""The loop over the steps. Training that was stopped goes on as if it had not been."""

import collections
import contextlib
import math
import os
import pathlib
import signal
import time

import torch

from semantic_slam_training.engine import checkpoint
from semantic_slam_training.engine.progress import Progress, duration
from semantic_slam_training.engine.state import TrainingState
from semantic_slam_training.engine.tasks import to_device
from semantic_slam_training.errors import TrainingError

LARGEST_GRADIENT = 10.0  # norm; longer ones are cut
LOSSES_AVERAGED = 50  # steps
BFLOAT16_UNITS = ("amx_bf16", "avx512_bf16")  # of processors, as /proc/cpuinfo names them
PER_CLASS = ("iou_", "ap50_")  # how names of figures of single classes begin


def choose_device(name):
    if name is None:
        name = "cuda" if torch.cuda.is_available() else "cpu"
    if name == "cuda" and not torch.cuda.is_available():
        raise TrainingError("--device cuda: this torch finds no GPU")
    return torch.device(name)


def multiplies_bfloat16(device):
    """Whether the GPU, or the processor by units made for it, does so fast."""
    if device.type == "cuda":
        return torch.cuda.is_bf16_supported()
    cpu_info = pathlib.Path("/proc/cpuinfo")
    flags = cpu_info.read_text().split() if cpu_info.exists() else []
    return any(unit in flags for unit in BFLOAT16_UNITS)


def arithmetic(device, precision):
    """Context in which the losses are computed; `precision` is that of the settings."""
    if precision == "mixed" or (precision is None and multiplies_bfloat16(device)):
        return torch.autocast(device.type, torch.bfloat16)
    return contextlib.nullcontext()


@contextlib.contextmanager
def stop_requests():
    """A list that is no longer empty once the process was asked to end (SIGINT, SIGTERM)."""
    requests = []
    handlers = {number: signal.signal(number, lambda received, _: requests.append(received))
                for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield requests
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)


class Trainer:
    """Trains one network of a task in a folder, where its checkpoint.pt is."""

    def __init__(self, task, spec, settings, folder, about=""):
        """`about`: text on data and settings, for the model card. Goes on from the folder's checkpoint."""
        torch.set_num_threads(settings.threads or len(os.sched_getaffinity(0)))
        self.task, self.settings, self.about = task, settings, about
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.device = choose_device(settings.device)
        self.state = TrainingState(spec, settings, self.device)
        self.progress = None
        self.recent = collections.deque(maxlen=LOSSES_AVERAGED)
        if self.path.exists():
            self.state.restore(self.path)

    @property
    def path(self):
        return self.folder / checkpoint.FULL_NAME

    def start_from(self, path):
        """Begins with the weights and at the step of another checkpoint, unless the folder has one. That may have been
        trained on images of another size."""
        if not self.path.exists():
            self.state.restore(path, other_input=True)

    def run(self):
        """Trains to the last step or until time is up; returns the latest figures of validation."""
        begin, spent = time.monotonic(), self.state.seconds
        self.progress = Progress(self.state.step, self.settings.steps)
        with stop_requests() as requests:
            for batch in self.task.batches(range(self.state.step, self.settings.steps)):
                self.take_step(batch)
                self.state.seconds = spent + time.monotonic() - begin
                self.after_step()
                if requests or self.is_time_up(begin):
                    break
        self.save()
        self.report_end(begin)
        return latest_figures(self.state.history)

    def is_time_up(self, begin):
        return self.settings.minutes is not None and time.monotonic() - begin >= 60 * self.settings.minutes

    def take_step(self, batch):
        state = self.state
        torch.manual_seed(self.settings.seed * 1_000_003 + state.step)  # of dropout
        for group in state.optimizer.param_groups:
            group["lr"] = self.settings.rate_at(state.step, state.moments_since) * group.get("rate_factor", 1.0)
        state.network.train()
        with arithmetic(self.device, self.settings.precision):
            parts = self.task.losses(state.network, to_device(batch, self.device))
        loss = sum(parts.values())
        if not math.isfinite(float(loss)):
            raise TrainingError(f"step {state.step}: the loss is {float(loss)}; try a lower --learning-rate")
        state.optimizer.zero_grad(set_to_none=True)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(state.network.parameters(), LARGEST_GRADIENT)
        state.optimizer.step()
        state.step += 1
        state.update_average(self.settings.average_decay)
        self.recent.append({name: float(part) for name, part in parts.items()})

    def after_step(self):
        step, last = self.state.step, self.settings.steps
        losses = self.recent_losses()
        self.progress.show(step, "  ".join(f"{name} {loss:.3f}" for name, loss in losses.items()))
        if step % LOSSES_AVERAGED == 0:
            self.state.history.append({"step": step, "losses": losses})
        if self.task.validation is not None and (step % self.settings.validate_every == 0 or step == last):
            self.validate()
        if step % self.settings.checkpoint_every == 0:
            self.save()

    def recent_losses(self):
        """Means of the last parts of the loss, by name."""
        return {name: sum(parts[name] for parts in self.recent) / len(self.recent) for name in self.recent[-1]}

    def validate(self):
        with torch.no_grad():
            figures = self.task.validate(self.state.average, self.device)
        self.state.history.append({"step": self.state.step, "figures": figures})
        words = [f"{name} {value:.4f}" for name, value in figures.items() if not name.startswith(PER_CLASS)]
        self.progress.say(f"step {self.state.step}: {'  '.join(words)}")

    def save(self):
        checkpoint.save(self.path, self.state.to_checkpoint(self.about))

    def is_finished(self):
        return self.state.step >= self.settings.steps

    def report_end(self, begin):
        done = "finished" if self.is_finished() else "stopped; the same command goes on"
        self.progress.say(f"{self.path}: step {self.state.step} of {self.settings.steps} after "
                          f"{duration(time.monotonic() - begin)}: {done}")


def latest_figures(history):
    """Of the last validation that a checkpoint's history tells; None if there was none."""
    return next((entry["figures"] for entry in reversed(history) if "figures" in entry), None)
