"""replay on a recording that was cut and joined: the lens is covered for two seconds, and uncovered elsewhere."""

import json

import cv2
import numpy as np
import pytest

COVERED_S = 2.0
PERIOD_S = 1 / 30
GAP_S = 0.5  # between two pieces, besides the time that the lens is covered


def read_list(path):
    """(stamp, the rest) of each line."""
    lines = [line.split(maxsplit=1) for line in path.read_text().splitlines() if line.strip() and line[0] != "#"]
    return [(float(stamp), rest) for stamp, rest in lines]


def write_list(path, entries):
    path.write_text("".join(f"{stamp:.6f} {rest}\n" for stamp, rest in sorted(entries)))


class Cut:
    """A folder in TUM's format that is made of pieces of another one, with nothing to be seen between them."""

    def __init__(self, source, folder):
        self.source, self.folder = source, folder
        for name in ("rgb", "depth"):
            (folder / name).mkdir(parents=True)
        self.lists = {name: [] for name in ("rgb", "depth", "groundtruth")}
        self.now = 1000.0
        self.pieces = []  # begin and end of each, by the new clock
        self.size = None

    def add_piece(self, begin_s, end_s):
        """What was recorded from `begin_s` to `end_s` after the first image."""
        first = read_list(self.source / "rgb.txt")[0][0]
        shift = self.now - (first + begin_s)
        for name, entries in self.lists.items():
            for stamp, rest in read_list(self.source / f"{name}.txt"):
                if begin_s <= stamp - first < end_s:
                    entries.append((stamp + shift, self.link(name, rest)))
        self.pieces.append((self.now, self.now + end_s - begin_s))
        self.now += end_s - begin_s + GAP_S

    def link(self, name, rest):
        if name == "groundtruth":
            return rest
        target = self.folder / name / f"{len(self.lists[name])}{(self.source / rest).suffix}"
        target.symlink_to(self.source / rest)
        return f"{name}/{target.name}"

    def cover(self):
        if self.size is None:
            self.size = cv2.imread(str(self.source / read_list(self.source / "rgb.txt")[0][1])).shape[:2]
            cv2.imwrite(str(self.folder / "black.png"), np.zeros((*self.size, 3), np.uint8))
            cv2.imwrite(str(self.folder / "no_depth.png"), np.zeros(self.size, np.uint16))
        for index in range(int(COVERED_S / PERIOD_S)):
            self.lists["rgb"].append((self.now + index * PERIOD_S, "black.png"))
            self.lists["depth"].append((self.now + index * PERIOD_S, "no_depth.png"))
        self.now += COVERED_S

    def write(self):
        for name, entries in self.lists.items():
            write_list(self.folder / f"{name}.txt", entries)


def stamps_in(path, piece):
    return [stamp for stamp, _ in read_list(path) if piece[0] <= stamp < piece[1]]


@pytest.fixture(name="replay_cut")
def fixture_replay_cut(desk, run_program, tmp_path):
    """Replays pieces of freiburg1_desk; returns the cut, the results' folder and the trajectory's errors."""

    def run(*pieces):
        cut = Cut(desk.folder, tmp_path / "cut")
        for index, piece in enumerate(pieces):
            if index > 0:
                cut.cover()
            cut.add_piece(*piece)
        cut.write()
        out = tmp_path / "out"
        result = run_program("replay", "--dataset", cut.folder, "--config", desk.config, "--stages", "tracking", "--out",
                             out)
        assert result.returncode == 0, result.stderr
        errors = run_program("evaluate_trajectory", cut.folder / "groundtruth.txt", out / "trajectory.txt", "--json")
        assert errors.returncode == 0, errors.stderr
        return cut, out, json.loads(errors.stdout)

    return run


def test_a_known_place_is_found_within_a_second(replay_cut):
    cut, out, errors = replay_cut((0, 6), (2, 5))
    found = stamps_in(out / "trajectory.txt", cut.pieces[1])
    assert found[0] - cut.pieces[1][0] < 1.0
    assert errors["ate_rmse_m"] < 0.03  # one map, as exact as an uncut recording
    assert json.loads((out / "summary.json").read_text())["lost"] >= int(COVERED_S / PERIOD_S) - 1


def test_an_unknown_place_begins_a_map_that_is_joined_later(replay_cut):
    """The second piece begins where the first has not been, and comes to where it has."""
    cut, out, errors = replay_cut((0, 2.5), (6, 19))
    live = stamps_in(out / "trajectory_live.txt", cut.pieces[1])
    assert live[0] - cut.pieces[1][0] < 2.0  # a second in sight of the unknown, and half of one to spare
    first, second = (stamps_in(out / "trajectory.txt", piece) for piece in cut.pieces)
    assert len(first) > 50 and len(second) > 300  # both are in the joined map; the first has depth after 0.6 s only
    assert errors["ate_rmse_m"] < 0.03
