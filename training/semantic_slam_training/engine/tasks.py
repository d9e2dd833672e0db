"""What is particular to each kind of network: its batches, its loss, its validation."""

import numpy as np
import torch

from semantic_slam_training.data.batches import IdentityPlan, ShuffledPlan, load_batches, load_in_order
from semantic_slam_training.evaluation.appearance_metrics import separation
from semantic_slam_training.evaluation.detection_metrics import DetectionScore, pass_over_optional, select_boxes
from semantic_slam_training.evaluation.segmentation_metrics import ConfusionMatrix
from semantic_slam_training.losses.appearance import appearance_loss
from semantic_slam_training.losses.assignment import Objects
from semantic_slam_training.losses.detection import detection_loss
from semantic_slam_training.losses.segmentation import cross_entropy, segmentation_loss
from semantic_slam_training.models.layers import resize
from semantic_slam_training.models.yolov8 import YoloV8Boxes, cell_centres


class Task:
    """Batches of images in random order; what else there is, each kind of network says itself."""

    def __init__(self, samples, validation, settings):
        """`validation`: samples without augmentation, or None."""
        self.samples, self.validation, self.settings = samples, validation, settings

    def plan(self, steps):
        return ShuffledPlan(len(self.samples.dataset), self.settings.batch_size, self.settings.seed, steps)

    def batches(self, steps):
        """Of the steps of a range."""
        return load_batches(self.samples, self.plan(steps), self.settings.workers)

    def validation_batches(self):
        return load_in_order(self.validation, self.settings.batch_size, self.settings.validation_images,
                             self.settings.workers)

    def losses(self, network, batch):
        """Parts of the loss by name, of tensors that lie on the network's device."""
        raise NotImplementedError

    def validate(self, network, device):
        """Figures by name, of a network in evaluation mode."""
        raise NotImplementedError


class SegmentationTask(Task):
    """`weights` of the classes, a tensor."""

    def __init__(self, samples, validation, settings, weights):
        super().__init__(samples, validation, settings)
        self.weights = weights

    def losses(self, network, batch):
        images, labels = batch
        return segmentation_loss(network(images), labels, self.weights.to(images.device))

    def validate(self, network, device):
        matrix = ConfusionMatrix(len(self.samples.dataset.names))
        for images, labels in self.validation_batches():
            scores = resize(network(images.to(device)).float(), labels.shape[1:])
            matrix.add(labels.numpy(), scores.argmax(1).cpu().numpy())
        ious = {f"iou_{name}": float(iou) for name, iou in zip(self.samples.dataset.names, matrix.class_ious())}
        return {"pixel_accuracy": matrix.pixel_accuracy(), "mean_iou": matrix.mean_iou(), **ious}


PIXEL_WEIGHT = 2.0  # of the cross entropy of pixels' classes that a detection network learns beside its own


class DetectionTask(Task):
    """Boxes of the input's pixels."""

    def __init__(self, samples, validation, settings):
        super().__init__(samples, validation, settings)
        self.centres, self.strides = cell_centres(samples.format.height, samples.format.width)

    def losses(self, network, batch):
        images, *objects, labels = batch
        sides, scores, *pixel_scores = network(images)
        centres, strides = self.centres.to(images.device), self.strides.to(images.device)
        parts = detection_loss(sides, scores, Objects(*objects), centres, strides)
        if pixel_scores:
            parts["pixels"] = PIXEL_WEIGHT * cross_entropy(pixel_scores[0], labels)
        return parts

    def validate(self, network, device):
        names = self.samples.dataset.names
        decoder = YoloV8Boxes(network, self.samples.format.height, self.samples.format.width).to(device).eval()
        score = DetectionScore(len(names))
        for images, *objects, _ in self.validation_batches():
            for rows, box, kind, present, optional in zip(decoder(images.to(device)).float().cpu(), *objects):
                found = pass_over_optional(select_boxes(rows), box[present], box[optional])
                score.add(found, box[present], kind[present])
        precisions = {f"ap50_{name}": float(value) for name, value in zip(names, score.class_precisions())}
        return {**score.metrics(), **precisions}


class AppearanceTask(Task):
    """Batches of some objects with some crops of each."""

    CROPS_PER_OBJECT = 4

    def plan(self, steps):
        objects = max(2, self.settings.batch_size // self.CROPS_PER_OBJECT)
        return IdentityPlan(self.samples.dataset.identities, objects, self.CROPS_PER_OBJECT, self.settings.seed, steps)

    def losses(self, network, batch):
        crops, identities = batch
        vectors, scores = network(crops)
        return appearance_loss(vectors, scores, identities)

    def validate(self, network, device):
        vectors, identities = [], []
        for crops, numbers in self.validation_batches():
            vectors.append(network(crops.to(device)).float().cpu().numpy())
            identities.append(numbers.numpy())
        return {"auc": separation(np.concatenate(vectors), np.concatenate(identities))}


def to_device(batch, device):
    """All tensors of a batch, images with their channels last."""
    images, *others = [tensor.to(device, non_blocking=True) for tensor in batch]
    return images.contiguous(memory_format=torch.channels_last), *others
