"""data/batches.py: the same batches whatever step one begins at."""

import needs_torch  # noqa: F401
import numpy as np
from tiny_sets import Scenes

from semantic_slam_training.data.augmentation import Augmentation
from semantic_slam_training.data.batches import IdentityPlan, ShuffledPlan, load_batches, load_in_order
from semantic_slam_training.data.input_format import InputFormat
from semantic_slam_training.data.samples import SegmentationSamples


def test_every_image_comes_once_before_any_comes_again():
    keys = [key for batch in ShuffledPlan(5, 2, seed=1, steps=range(5)) for key in batch]
    indices = [index for _, _, index in keys]
    assert sorted(indices[:5]) == sorted(indices[5:]) == list(range(5))
    assert indices[:5] != indices[5:]
    assert [key[:2] for key in keys[:4]] == [(0, 0), (0, 1), (1, 0), (1, 1)]


def test_a_plan_can_begin_anywhere():
    whole = list(ShuffledPlan(5, 2, seed=1, steps=range(10)))
    assert list(ShuffledPlan(5, 2, seed=1, steps=range(6, 10))) == whole[6:]
    assert list(ShuffledPlan(5, 2, seed=2, steps=range(10))) != whole


def test_batches_of_objects_hold_several_crops_of_each():
    identities = np.array([4, 1, 4, 1, 1, 9])
    batches = list(IdentityPlan(identities, objects=2, crops=3, seed=1, steps=range(8)))
    for batch in batches:
        shown = identities[[index for _, _, index in batch]].reshape(2, 3)
        assert (shown == shown[:, :1]).all() and shown[0, 0] != shown[1, 0]
    assert list(IdentityPlan(identities, 2, 3, seed=1, steps=range(5, 8))) == batches[5:]


def test_processes_that_read_change_nothing():
    samples = SegmentationSamples(Scenes(4), InputFormat(64, 48), Augmentation(), seed=3)

    def blobs(workers):
        return [images.numpy() for images, _ in load_batches(samples, ShuffledPlan(4, 2, 1, range(3)), workers)]

    for here, there in zip(blobs(0), blobs(1)):
        assert np.array_equal(here, there)


def test_labels_may_be_coarser_than_images():
    samples = SegmentationSamples(Scenes(1), InputFormat(64, 48), label_stride=2)
    images, labels = samples.collate([samples[0, 0, 0]])
    assert images.shape == (1, 3, 48, 64) and labels.shape == (1, 24, 32)


def test_validation_looks_at_images_all_over_the_set():
    class Recording(Scenes):
        seen = []

        def read(self, index):
            self.seen.append(index)
            return super().read(index)

    batches = list(load_in_order(SegmentationSamples(Recording(10), InputFormat(64, 48)), batch_size=2, most=4))
    assert Recording.seen == [0, 3, 6, 9]
    assert [len(images) for images, _ in batches] == [2, 2]
