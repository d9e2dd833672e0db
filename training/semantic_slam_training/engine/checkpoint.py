"""Checkpoints on disk: tensors, and plain values as JSON, so that loading one runs no code of its own."""

import json
import os
import pathlib
import pickle

import torch

from semantic_slam_training.errors import TrainingError

FORMAT = 1
FULL_NAME = "checkpoint.pt"
TENSORS = ("network", "average", "optimizer", "weights")  # keys of maps that hold tensors


def save(path, content):
    """Whole or not at all."""
    path = pathlib.Path(path)
    partial = path.with_name(path.name + ".part")
    tensors = {key: value for key, value in content.items() if key in TENSORS}
    plain = {key: value for key, value in content.items() if key not in TENSORS}
    torch.save({"format": FORMAT, "plain": json.dumps(plain), **tensors}, partial)
    os.replace(partial, path)


def load(path):
    try:
        content = torch.load(path, map_location="cpu", weights_only=True)
    except FileNotFoundError as error:
        raise TrainingError(f"{path}: no such checkpoint") from error
    except (pickle.UnpicklingError, RuntimeError, EOFError, ValueError, IndexError) as error:
        raise TrainingError(f"{path}: not a checkpoint of this trainer, or cut short") from error
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise TrainingError(f"{path}: not a checkpoint of format {FORMAT}")
    return {**json.loads(content["plain"]), **{key: content[key] for key in TENSORS if key in content}}


def to_half(tensor):
    """Matrices and kernels; vectors, such as the statistics of normalisation, are small and stay as they are."""
    return tensor.half() if tensor.is_floating_point() and tensor.ndim > 1 else tensor


def half_of(content):
    """A checkpoint of the averaged weights alone, in half precision: small, and training can go on from it. One
    that is so already stays as it is."""
    if "weights" in content:
        return content
    kept = {key: content[key] for key in ("spec", "step", "seconds", "about")}
    history = [entry for entry in content["history"] if "losses" not in entry]
    return dict(kept, history=history, weights={name: to_half(tensor) for name, tensor in content["average"].items()})


def full_weights(content):
    """The averaged weights of either kind of checkpoint, in single precision."""
    weights = content["weights"] if "weights" in content else content["average"]
    return {name: tensor.float() if tensor.is_floating_point() else tensor for name, tensor in weights.items()}
