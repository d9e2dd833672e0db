"""scripts/describe_network_errors.py: what it says of the simulator's parameters."""

import yaml

from describe_network_errors import describe

PARAMETERS = """
label_errors: {confusion_probability: 0.08, unknown_probability: 0.02, period_s: 1.5, border_wobble_px: 1.5,
               mean_confidence: 0.8}
box_errors: {miss_probability: 0.1, false_positives_per_image: 0.25, confusion_probability: 0.05, jitter_px: 1.0,
             jitter_share: 0.02, mean_confidence: 0.75}
"""


def test_says_the_rates():
    labels, boxes = describe(yaml.safe_load(PARAMETERS))
    assert labels == ("labels: 8 % of things pass for a similar class and 2 % for nothing known, for 1.5 s at a time; "
                      "borders are off by 1.5 px; mean confidence 0.8")
    assert boxes == ("boxes: 10 % are missed and 5 % of a similar class, 0.25 per image are around nothing; edges are "
                     "off by 1 px + 2 % of the size; mean confidence 0.75")


def test_the_package_states_them_all(repository):
    assert len(list(describe(yaml.safe_load((repository / "config/simulator.yaml").read_text())))) == 2
