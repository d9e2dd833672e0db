"""Recorded sequences, and others made of them: backwards, and with every second pair of images only."""

import bisect
import dataclasses
import decimal
import os
import pathlib
import re

from localization_evaluation.errors import EvaluationError

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
MAX_GAP_S = decimal.Decimal("0.02")  # colour and depth farther apart are no pair, as for replay
STAMPED = ("rgb.txt", "depth.txt", "groundtruth.txt", "accelerometer.txt")  # the last one is optional


@dataclasses.dataclass(frozen=True)
class Sequence:
    """A folder in the format of the TUM RGB-D benchmark or a bag, its camera's file and its true trajectory."""

    name: str
    path: pathlib.Path
    config: pathlib.Path
    ground_truth: pathlib.Path


def camera_file(path):
    """The calibration of a sequence that names no other: its own, or that of the benchmark's camera in its name."""
    if (path / "camera.yaml").is_file():
        return path / "camera.yaml"
    if camera := re.search(r"(?:freiburg|fr)([123])", path.name):
        return REPOSITORY / f"config/tum_freiburg{camera[1]}.yaml"
    raise EvaluationError(f"the name of {path} does not tell the camera; give --config")


def open_sequence(path, config=None, ground_truth=None):
    """Sequence of a folder or bag, after a look at whether all of it is there."""
    ground_truth = ground_truth or path / "groundtruth.txt"
    if not path.exists():
        raise EvaluationError(f"no such file or folder: {path}")
    if path.is_dir() and not (path / "rgb.txt").is_file():
        raise EvaluationError(f"{path} has no rgb.txt, expected a folder in the format of the TUM RGB-D benchmark")
    config = config or camera_file(path)
    if not config.is_file():
        raise EvaluationError(f"no such file: {config}")
    if not ground_truth.is_file():
        hint = "" if path.is_dir() else "; a bag needs --ground-truth"
        raise EvaluationError(f"no such file: {ground_truth}{hint}")
    name = pathlib.Path(os.path.abspath(path)).name.removesuffix(".bag")
    return Sequence(name, path, config, ground_truth)


def read_rows(path):
    """(stamp, the rest of the line) of every line of a list, in the order of the file."""
    rows = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        stamp, _, rest = line.strip().partition(" ")
        try:
            rows.append((decimal.Decimal(stamp), rest))
        except decimal.InvalidOperation:
            raise EvaluationError(f"{path}:{number}: '{stamp}' is no stamp") from None
    if not rows:
        raise EvaluationError(f"{path} is empty")
    return rows


def write_rows(path, rows):
    path.write_text("".join(f"{stamp} {rest}\n" for stamp, rest in rows))


def pairs(folder):
    """Rows of rgb.txt and depth.txt that belong together, nearest stamps first, one to one; by ascending colour."""
    colour, depth = (sorted(read_rows(folder / name)) for name in ("rgb.txt", "depth.txt"))
    stamps = [stamp for stamp, _ in depth]
    candidates = []
    for i, (stamp, _) in enumerate(colour):
        first = bisect.bisect_left(stamps, stamp - MAX_GAP_S)
        last = bisect.bisect_right(stamps, stamp + MAX_GAP_S)
        candidates += [(abs(stamps[j] - stamp), i, j) for j in range(first, last)]
    partner, taken = {}, set()
    for _, i, j in sorted(candidates):
        if i not in partner and j not in taken:
            partner[i] = j
            taken.add(j)
    return [(colour[i], depth[j]) for i, j in sorted(partner.items())]


def link_images(source, folder):
    folder.mkdir(parents=True)
    for path in source.iterdir():
        if path.is_dir():
            (folder / path.name).symlink_to(path.resolve())


def derived(sequence, name, folder):
    return Sequence(f"{sequence.name}, {name}", folder, sequence.config.resolve(), folder / "groundtruth.txt")


def backwards(sequence, folder):
    """The same with time running back: every stamp t becomes first + last colour stamp - t."""
    link_images(sequence.path, folder)
    colour = [stamp for stamp, _ in read_rows(sequence.path / "rgb.txt")]
    ends = min(colour) + max(colour)
    for name in STAMPED:
        source = sequence.ground_truth if name == "groundtruth.txt" else sequence.path / name
        if source.is_file():
            write_rows(folder / name, sorted((ends - stamp, rest) for stamp, rest in read_rows(source)))
    return derived(sequence, "backwards", folder)


def every_second(sequence, folder):
    """Every second pair of images, from the first on; all of the true trajectory and of the accelerometer."""
    link_images(sequence.path, folder)
    kept = pairs(sequence.path)[::2]
    write_rows(folder / "rgb.txt", [colour for colour, _ in kept])
    write_rows(folder / "depth.txt", [depth for _, depth in kept])
    (folder / "groundtruth.txt").symlink_to(sequence.ground_truth.resolve())
    if (sequence.path / "accelerometer.txt").is_file():
        (folder / "accelerometer.txt").symlink_to((sequence.path / "accelerometer.txt").resolve())
    return derived(sequence, "every second pair", folder)
