"""What all runs come to: medians, the worst, and whether they keep the limits."""

import dataclasses
import statistics

CAPTION = """ATE RMSE is of all positions: final after all corrections, live of each image's pose as tracking gave it.
At the sensor's rate a pose that came more than 33 ms after its image's delivery counts as lost for the live one, and
where two images wait and a third comes, the oldest is dropped. A delay is from the delivery to the pose, the wait for
images before in it; times per image are without that wait. As fast as it goes, the image waits for mapping, and its
time has that in it. CPU is of all threads, over the images that reached tracking. Memory is the largest that was
resident. The start is from the first pair of images to the first with a pose, in the recording's time."""


@dataclasses.dataclass(frozen=True)
class Row:
    """A figure of a Run, and what freiburg1_desk must keep: the most (or, where more is better, the least)."""

    key: str
    title: str
    decimals: int
    median_limit: float | None = None
    worst_limit: float | None = None
    more_is_better: bool = False

    def values(self, realtime):
        return [getattr(run, self.key) for run in realtime]

    def median(self, realtime):
        """None counts as worse than anything, here and below."""
        values = self.values(realtime)
        return None if None in values else statistics.median(values)

    def worst(self, realtime):
        values = self.values(realtime)
        return None if None in values else (min if self.more_is_better else max)(values)

    def is_kept(self, value, limit):
        if limit is None:
            return True
        return value is not None and (value >= limit if self.more_is_better else value <= limit)

    def is_missed(self, realtime):
        return not (self.is_kept(self.median(realtime), self.median_limit)
                    and self.is_kept(self.worst(realtime), self.worst_limit))

    def text(self, value):
        return "-" if value is None else f"{value:.{self.decimals}f}"

    def limits(self):
        sign = "≥" if self.more_is_better else "≤"
        return ", ".join(f"{name} {sign} {limit:g}" for name, limit in
                         (("median", self.median_limit), ("worst", self.worst_limit)) if limit is not None)


ROWS = (Row("final_ate_m", "ATE RMSE, final [m]", 4, 0.0155, 0.0167),
        Row("live_ate_m", "ATE RMSE, live [m]", 4, 0.0175, 0.020),
        Row("tracked", "images tracked", 0, worst_limit=570, more_is_better=True),
        Row("in_time", "poses within 33 ms", 0, worst_limit=570, more_is_better=True),
        Row("lost", "images lost", 0, worst_limit=0),
        Row("dropped", "images dropped", 0),
        Row("loops", "loops closed", 0),
        Row("delay_median_ms", "delay, median [ms]", 1),
        Row("delay_p95_ms", "delay, 95 % [ms]", 1),
        Row("median_ms", "per image, median [ms]", 1, median_limit=10),
        Row("p95_ms", "per image, 95 % [ms]", 1, median_limit=16),
        Row("cpu_ms", "CPU per image, without decoding [ms]", 1, median_limit=22),
        Row("decoding_ms", "CPU per image, decoding [ms]", 1),
        Row("memory_mb", "memory [MB]", 0, worst_limit=180),
        Row("start_s", "start [s]", 2, worst_limit=0.5))


def missed(runs):
    """The Rows whose limits the runs do not keep."""
    return [row for row in ROWS if row.is_missed(runs.realtime)]


def cells(row, runs, is_judged):
    realtime = runs.realtime
    yield from (row.title, row.text(row.median(realtime)), row.text(row.worst(realtime)))
    if is_judged:
        yield row.limits() + (" **missed**" if row.is_missed(realtime) else "")
    yield row.text(getattr(runs.deterministic, row.key))


def markdown(runs, is_judged):
    """The lines of the table of a sequence; with the limits if they are meant for it."""
    count = len(runs.realtime)
    yield f"### {runs.name}"
    yield ""
    yield (f"{runs.deterministic.pairs} pairs of images; {count} run{'s' if count > 1 else ''} at the sensor's rate, "
           "one as fast as it goes")
    yield ""
    heads = ("", "median", "worst", *(("limit",) if is_judged else ()), "as fast as it goes")
    yield "| " + " | ".join(heads) + " |"
    yield "|" + "---|" * len(heads)
    for row in ROWS:
        yield "| " + " | ".join(cells(row, runs, is_judged)) + " |"
    yield ""


def as_json(runs, is_judged):
    return {"sequence": runs.name,
            "realtime": [dataclasses.asdict(run) for run in runs.realtime],
            "deterministic": dataclasses.asdict(runs.deterministic),
            "median": {row.key: row.median(runs.realtime) for row in ROWS},
            "worst": {row.key: row.worst(runs.realtime) for row in ROWS},
            "missed": [row.key for row in missed(runs)] if is_judged else None}
