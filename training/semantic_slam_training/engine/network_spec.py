"""All that must be known to build a network and to use it, as it is kept in checkpoints."""

import dataclasses

from semantic_slam_training.data.input_format import InputFormat
from semantic_slam_training.models import segmentation
from semantic_slam_training.models.appearance import AppearanceNetwork
from semantic_slam_training.models.yolov8 import YoloV8

SEGMENTATION, DETECTION, APPEARANCE = "segmentation", "detection", "appearance"


@dataclasses.dataclass(frozen=True)
class NetworkSpec:
    """`architecture`: a name of models.segmentation, yolov8n, yolov8s or appearance; `width` scales channels.

    `classes`: names in the order of the scores; empty for appearance, which has `identities` instead.
    `pixel_classes`: how many classes of pixels a detection network learns beside its own; 0: none.
    """

    task: str
    architecture: str
    width: float
    classes: tuple
    input: InputFormat
    identities: int = 0
    pixel_classes: int = 0

    def build(self):
        if self.task == SEGMENTATION:
            return segmentation.build(self.architecture, len(self.classes), self.width)
        if self.task == DETECTION:
            return YoloV8(len(self.classes), self.architecture.removeprefix("yolov8"), self.pixel_classes)
        return AppearanceNetwork(self.identities, self.width)

    def to_dict(self):
        """Of plain values and lists only."""
        plain = dataclasses.asdict(self)
        plain["classes"] = list(self.classes)
        plain["input"].update(mean=list(self.input.mean), std=list(self.input.std))
        return plain

    @staticmethod
    def from_dict(plain):
        frame = dict(plain["input"], mean=tuple(plain["input"]["mean"]), std=tuple(plain["input"]["std"]))
        return NetworkSpec(**dict(plain, classes=tuple(plain["classes"]), input=InputFormat(**frame)))
