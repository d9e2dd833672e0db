"""Which images make up the batch of each step, whatever step one begins at."""

import signal

import numpy as np
import torch


class ShuffledPlan:
    """All images in random order, then all again in another. Yields lists of (step, place, index)."""

    def __init__(self, count, batch_size, seed, steps):
        """`steps`: a range."""
        self.count, self.batch_size, self.seed, self.steps = count, batch_size, seed, steps
        self._epoch, self._order = None, None

    def index_at(self, position):
        """Which image stands at a position of the endless sequence."""
        epoch, place = divmod(position, self.count)
        if epoch != self._epoch:
            self._epoch = epoch
            self._order = np.random.default_rng([self.seed, epoch]).permutation(self.count)
        return int(self._order[place])

    def __iter__(self):
        for step in self.steps:
            yield [(step, place, self.index_at(step * self.batch_size + place)) for place in range(self.batch_size)]

    def __len__(self):
        return len(self.steps)


class IdentityPlan:
    """Some objects, and some crops of each, drawn anew for every step."""

    def __init__(self, identities, objects, crops, seed, steps):
        """`identities`: object of each crop; `objects` and `crops` of each: what makes up a batch."""
        order = np.argsort(identities, kind="stable")
        self.crops_of = np.split(order, np.flatnonzero(np.diff(np.asarray(identities)[order])) + 1)
        self.objects, self.crops, self.seed, self.steps = objects, crops, seed, steps

    def indices(self, step):
        random = np.random.default_rng([self.seed, step])
        chosen = random.choice(len(self.crops_of), min(self.objects, len(self.crops_of)), replace=False)
        for object_crops in (self.crops_of[each] for each in chosen):
            yield from random.choice(object_crops, self.crops, replace=len(object_crops) < self.crops)

    def __iter__(self):
        for step in self.steps:
            yield [(step, place, int(index)) for place, index in enumerate(self.indices(step))]

    def __len__(self):
        return len(self.steps)


def leave_signals_to_parent(_):
    """Readers end with the process that started them, not when it is asked to stop after a step."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)


def load_batches(samples, plan, workers=0):
    """Batches of `samples` by `plan`, read by `workers` processes beside this one, in the plan's order."""
    return torch.utils.data.DataLoader(samples, batch_sampler=plan, num_workers=workers, collate_fn=samples.collate,
                                       worker_init_fn=leave_signals_to_parent, pin_memory=torch.cuda.is_available())


def spread(count, most):
    """At most `most` of `count` indices, evenly spread."""
    return np.unique(np.linspace(0, count - 1, min(count, most)).astype(int)) if count else np.array([], int)


def load_in_order(samples, batch_size, most, workers=0):
    """Batches of at most `most` items, evenly spread over the data set."""
    indices = spread(len(samples.dataset), most)
    plan = [[(0, place, int(index)) for place, index in enumerate(part)]
            for part in np.array_split(indices, -(-len(indices) // batch_size))]
    return load_batches(samples, plan, workers)
