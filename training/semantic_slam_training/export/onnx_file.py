"""ONNX files for OpenCV 4.6, and whether it computes the same from them as torch."""

import time
import warnings

import cv2
import numpy as np
import torch

from semantic_slam_training.engine.network_spec import DETECTION
from semantic_slam_training.errors import TrainingError
from semantic_slam_training.models.yolov8 import YoloV8Boxes

OPSET = 12
INPUT_NAME = "image"
OUTPUT_NAMES = {"segmentation": "scores", "detection": "boxes", "appearance": "vector"}
TOLERANCE = 1e-3  # of scores (logits), boxes [px] and vectors
TIMED_RUNS = 10


def deployed(network, spec):
    """What is exported of a network: with boxes decoded, in evaluation mode."""
    if spec.task == DETECTION:
        network.pixels = None  # of use in training only
        network = YoloV8Boxes(network, spec.input.height, spec.input.width)
    return network.cpu().eval()


def write_onnx(network, spec, path):
    """A network of a fixed input size, 1 x 3 x height x width."""
    image = torch.zeros(1, 3, spec.input.height, spec.input.width)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # sizes become constants, as they should
        torch.onnx.export(network, image, str(path), opset_version=OPSET, do_constant_folding=True,
                          input_names=[INPUT_NAME], output_names=[OUTPUT_NAMES[spec.task]])


def random_blob(spec):
    """Values like those of images, by a fixed seed."""
    pixels = np.random.default_rng(1).integers(0, 256, (spec.input.height, spec.input.width, 3), np.uint8)
    return spec.input.to_blob(pixels)[None]


def load_in_opencv(path):
    try:
        return cv2.dnn.readNetFromONNX(str(path))
    except cv2.error as error:
        raise TrainingError(f"{path}: OpenCV {cv2.__version__} cannot load it: {error.err}") from error


def check_agreement(network, spec, path):
    """Largest difference of OpenCV's output and torch's, for one image. Too large: TrainingError."""
    blob = random_blob(spec)
    with torch.no_grad():
        expected = network(torch.from_numpy(blob)).numpy()
    net = load_in_opencv(path)
    net.setInput(blob)
    given = net.forward()
    difference = float(np.abs(given - expected).max()) if given.shape == expected.shape else np.inf
    if not difference <= TOLERANCE:  # so that NaN is refused
        raise TrainingError(f"{path}: OpenCV {cv2.__version__} gives other results than torch: {difference:.2g}, "
                            f"expected {TOLERANCE} or less")
    return difference


def opencv_milliseconds(path, spec):
    """Median time of a run in OpenCV [ms], on all cores."""
    net, blob, times = load_in_opencv(path), random_blob(spec), []
    for _ in range(TIMED_RUNS + 1):
        net.setInput(blob)
        begin = time.perf_counter()
        net.forward()
        times.append(1000 * (time.perf_counter() - begin))
    return float(np.median(times[1:]))  # the first allocates
