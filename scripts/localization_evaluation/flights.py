"""Rendered flights through the simulated worlds. Rendering takes minutes, so they are kept."""

import dataclasses
import hashlib
import pathlib
import tempfile

import yaml

from localization_evaluation import programs
from localization_evaluation.sequences import REPOSITORY, open_sequence

CONFIG = REPOSITORY / "config"
INPUTS = ("simulator.yaml", "simulated_d455.yaml", "labels.yaml")  # what else decides on the images
NO_TRUTH = "1000000"  # labels and boxes of the first image only


@dataclasses.dataclass(frozen=True)
class Flight:
    """A world and a tour of the package; the other way round, the tour leads from its end to its beginning."""

    name: str
    world: str
    is_other_way_round: bool = False
    seed: int = 1  # of the noise


FLIGHTS = (Flight("home", "home"), Flight("office", "office"),
           Flight("home, the other way round", "home", is_other_way_round=True, seed=2))


def other_way_round(tour):
    """A tour from its last waypoint to its first; the camera looks ahead again."""
    waypoints = [{**waypoint, "yaw_deg": (waypoint["yaw_deg"] + 360) % 360 - 180}
                 for waypoint in reversed(tour["waypoints"])]
    return {**tour, "waypoints": waypoints}


def tour_text(flight):
    text = (CONFIG / f"tours/{flight.world}.yaml").read_text()
    return yaml.safe_dump(other_way_round(yaml.safe_load(text))) if flight.is_other_way_round else text


def digest(flight, tour):
    """Differs if the flight would look different now."""
    texts = [tour, str(flight.seed), (CONFIG / f"worlds/{flight.world}.yaml").read_text(),
             *((CONFIG / name).read_text() for name in INPUTS)]
    return hashlib.sha256("\n".join(texts).encode()).hexdigest()[:8]


def rendered(flight, program, cache):
    """The flight's Sequence; rendered by `program` if `cache` does not hold it."""
    tour = tour_text(flight)
    folder = cache / f"{flight.name.replace(', ', '_').replace(' ', '_')}-{digest(flight, tour)}"
    if not folder.is_dir():
        cache.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=cache) as work:
            tour_file, images = pathlib.Path(work, "tour.yaml"), pathlib.Path(work, "images")
            tour_file.write_text(tour)
            programs.run(program, (flight.world, tour_file, images, "--seed", str(flight.seed),
                                   "--truth-period", NO_TRUTH),
                         f"rendering {flight.name}", lambda seconds: count_images(images))
            images.rename(folder)
    return dataclasses.replace(open_sequence(folder), name=flight.name)


def count_images(folder):
    return f"{sum(1 for _ in (folder / 'rgb').glob('*'))} images"
