#!/usr/bin/python3
"""Says at which rates simulator_node puts errors into the labels and boxes that it publishes in place of networks."""

import argparse
import pathlib
import sys

import yaml


def percent(share):
    return f"{100 * share:g} %"


def describe(parameters):
    """A line on the labels and one on the boxes."""
    labels, boxes = parameters["label_errors"], parameters["box_errors"]
    yield (f"labels: {percent(labels['confusion_probability'])} of things pass for a similar class and "
           f"{percent(labels['unknown_probability'])} for nothing known, for {labels['period_s']:g} s at a time; "
           f"borders are off by {labels['border_wobble_px']:g} px; mean confidence {labels['mean_confidence']:g}")
    yield (f"boxes: {percent(boxes['miss_probability'])} are missed and {percent(boxes['confusion_probability'])} of a "
           f"similar class, {boxes['false_positives_per_image']:g} per image are around nothing; edges are off by "
           f"{boxes['jitter_px']:g} px + {percent(boxes['jitter_share'])} of the size; "
           f"mean confidence {boxes['mean_confidence']:g}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("parameters", type=pathlib.Path, help="simulator_node's, such as config/simulator.yaml")
    path = parser.parse_args().parameters
    try:
        lines = list(describe(yaml.safe_load(path.read_text())))
    except (OSError, yaml.YAMLError, TypeError, KeyError) as error:
        sys.exit(f"describe_network_errors.py: {path}: {error!r}")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
