#!/usr/bin/env python3
"""Writes the .weights files of this folder: a header, then biases and kernels of the convolution."""

import struct
from pathlib import Path

FOLDER = Path(__file__).parent


def write(name, biases, kernels):
    """kernels[filter][channel] is the weight of every pixel under the kernel, as one list."""
    values = list(biases)
    for channels in kernels:
        for pixels in channels:
            values += pixels
    header = struct.pack("<iiiq", 0, 2, 0, 0)  # version 0.2.0, images seen
    data = struct.pack("<%df" % len(values), *values)
    (FOLDER / name).write_bytes(header + data)


def colour_segmenter():
    # Saturated colours win by 10 in the logarithm, greys of any brightness by 5.
    kernels = [[[10.0], [-10.0], [-10.0]], [[-10.0], [10.0], [-10.0]], [[-10.0], [-10.0], [10.0]],
               [[0.0], [0.0], [0.0]]]
    write("colour_segmenter.weights", [-5.0, -5.0, -5.0, 0.0], kernels)


def block_detector():
    pixels = 8 * 8

    def mean(weight):
        return [weight / pixels] * pixels

    none = [mean(0.0)] * 3
    # Difference of red and blue: 1 for a red block, -1 for a blue one, 0 for anything grey.
    red = [mean(20.0), mean(0.0), mean(-20.0)]
    blue = [mean(-20.0), mean(0.0), mean(20.0)]
    # Objectness exceeds 0.99 for a block and stays below 0.01 for greys; a class without its colour
    # gets e^-10.
    objectness = [mean(10.0), mean(-20.0), mean(10.0)]
    write("block_detector.weights", [0.0, 0.0, 0.0, 0.0, -5.0, -10.0, -10.0],
          [none, none, none, none, objectness, red, blue])


if __name__ == "__main__":
    colour_segmenter()
    block_detector()
