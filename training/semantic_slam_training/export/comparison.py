"""A table and a picture of networks side by side."""

import dataclasses
import json

import cv2
import numpy as np


@dataclasses.dataclass(frozen=True)
class Result:
    """Of one network. Accuracies are shares; `milliseconds` of one run in OpenCV."""

    network: str
    pixel_accuracy: float
    mean_iou: float
    parameters: int
    milliseconds: float
    training_seconds: float


def best_first(results):
    return sorted(results, key=lambda result: -result.pixel_accuracy)


def markdown(results):
    """The table's lines."""
    lines = ["| network | pixel accuracy | mean IoU | parameters [M] | OpenCV [ms] | training [s] |",
             "|---|---|---|---|---|---|"]
    for result in best_first(results):
        lines.append(f"| {result.network} | {result.pixel_accuracy:.3f} | {result.mean_iou:.3f} "
                     f"| {result.parameters / 1e6:.2f} | {result.milliseconds:.1f} | {result.training_seconds:.0f} |")
    return "\n".join(lines) + "\n"


ROW_PX = 34
NAME_PX = 190
COLUMN_PX = 190
BAR_PX = 110
INK = (40, 40, 40)
# Field, title, colour (BGR), how its value is written.
COLUMNS = (("pixel_accuracy", "pixel accuracy", (180, 119, 31), "{:.3f}"),
           ("mean_iou", "mean IoU", (14, 127, 255), "{:.3f}"),
           ("parameters", "parameters", (44, 160, 44), "{:.3g} M"),
           ("milliseconds", "OpenCV", (120, 120, 120), "{:.1f} ms"))


def write_text(picture, text, left, baseline):
    cv2.putText(picture, text, (left, baseline), cv2.FONT_HERSHEY_SIMPLEX, 0.45, INK, 1, cv2.LINE_AA)


def draw_column(picture, results, left, column):
    """Bars as long as the values, the longest of full length."""
    field, title, colour, form = column
    write_text(picture, title, left, ROW_PX - 12)
    values = [getattr(result, field) for result in results]
    for row, value in enumerate(values, 1):
        top = row * ROW_PX
        length = int(BAR_PX * value / max(*values, 1e-9)) if len(values) > 1 else BAR_PX
        cv2.rectangle(picture, (left, top + 6), (left + length, top + ROW_PX - 8), colour, cv2.FILLED)
        shown = value / 1e6 if field == "parameters" else value
        write_text(picture, form.format(shown), left + length + 6, top + ROW_PX - 12)


def draw(results):
    """A picture (BGR) with a row of bars for each network."""
    results = best_first(results)
    size = (ROW_PX * (len(results) + 1) + 10, NAME_PX + COLUMN_PX * len(COLUMNS) + 10, 3)
    picture = np.full(size, 255, np.uint8)
    for row, result in enumerate(results, 1):
        write_text(picture, result.network, 10, row * ROW_PX + ROW_PX - 12)
    for index, column in enumerate(COLUMNS):
        draw_column(picture, results, NAME_PX + COLUMN_PX * index, column)
    return picture


def write_comparison(folder, results):
    """comparison.json, .md and .png."""
    plain = [dataclasses.asdict(result) for result in best_first(results)]
    (folder / "comparison.json").write_text(json.dumps(plain, indent=2) + "\n")
    (folder / "comparison.md").write_text(markdown(results))
    cv2.imwrite(str(folder / "comparison.png"), draw(results))
