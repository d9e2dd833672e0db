"""All segmentation networks behind one interface."""

from semantic_slam_training.errors import TrainingError
from semantic_slam_training.models.fcn import fcn8s, fcn16s
from semantic_slam_training.models.frrn import Frrn
from semantic_slam_training.models.icnet import IcNet
from semantic_slam_training.models.pspnet import pspnet_mobilenetv2, pspnet_resnet18, pspnet_resnet50
from semantic_slam_training.models.segnet import SegNet
from semantic_slam_training.models.unet import UNet

NETWORKS = {
    "pspnet_resnet18": pspnet_resnet18,
    "pspnet_resnet50": pspnet_resnet50,
    "pspnet_mobilenetv2": pspnet_mobilenetv2,
    "icnet": IcNet,
    "segnet": SegNet,
    "unet": UNet,
    "frrn": Frrn,
    "fcn16s": fcn16s,
    "fcn8s": fcn8s,
}
FULL_SIZE = ("segnet", "unet", "frrn")  # those whose scores have the image's size
SIZE_MULTIPLE_PX = 32  # of the image's sides, which suits all of them


def build(name, classes, width):
    """A network for images of batch x 3 x height x width.

    It gives scores (logits) of batch x `classes` x h x w, at a stride of its own; in training a list of
    them, those that count first and then those of auxiliary heads. `width` scales the channels that the
    paper has.
    """
    if name not in NETWORKS:
        raise TrainingError(f"network '{name}': expected one of {', '.join(NETWORKS)}")
    return NETWORKS[name](classes, width)
