"""carmen_replay: 2D SLAM on a laser log that this test makes, and on a recorded one."""

import bisect
import math

import pytest

BEAMS = 180


def distance_to_wall(x, y, angle):
    """In a room of 8 m by 5 m about the origin."""
    distances = []
    for place, component, half in ((x, math.cos(angle), 4.0), (y, math.sin(angle), 2.5)):
        if abs(component) > 1e-9:
            distances.append((math.copysign(half, component) - place) / component)
    return min(distances)


def flaser_line(stamp, pose, odometry):
    x, y, theta = pose
    ranges = [distance_to_wall(x, y, theta - math.pi / 2 + i * math.pi / BEAMS) for i in range(BEAMS)]
    words = [f"FLASER {BEAMS}", *(f"{r:.2f}" for r in ranges), "0 0 0",
             *(f"{value:.6f}" for value in odometry), f"{stamp:.6f}", "host", "0.0"]
    return " ".join(words) + "\n"


@pytest.fixture(name="log", scope="module")
def fixture_log(tmp_path_factory):
    """Ahead from (-2, -1), 5 cm a scan; odometry takes it for 6 cm."""
    path = tmp_path_factory.mktemp("carmen") / "room.log"
    path.write_text("".join(flaser_line(100 + 0.1 * i, (-2 + 0.05 * i, -1, 0), (0.06 * i, 0, 0))
                            for i in range(60)))
    return path


def read_trajectory(folder):
    lines = (folder / "trajectory.txt").read_text().splitlines()
    return [tuple(map(float, line.split())) for line in lines if not line.startswith("#")]


def test_corrects_odometry_and_leaves_all_results(run_program, log, tmp_path):
    result = run_program("carmen_replay", log, "--out", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    stamp, x, y, theta = read_trajectory(tmp_path / "out")[-1]
    assert stamp == pytest.approx(105.9)
    # 59 steps of 5 cm, where odometry says 3.54 m; a tenth of a metre is two cells.
    assert x == pytest.approx(2.95, abs=0.1)
    assert y == pytest.approx(0.0, abs=0.05)
    assert theta == pytest.approx(0.0, abs=0.02)
    assert (tmp_path / "out/grid.pgm").read_bytes().startswith(b"P5\n")
    assert "resolution: 0.05" in (tmp_path / "out/grid.yaml").read_text()
    assert (tmp_path / "out/timing.csv").read_text().startswith("stage,count,median_ms,p95_ms\nscan,60,")


def test_gives_the_same_bytes_twice(run_program, log, tmp_path):
    for name in ("a", "b"):
        assert run_program("carmen_replay", log, "--out", tmp_path / name).returncode == 0
    for file in ("trajectory.txt", "grid.pgm", "grid.yaml"):
        assert (tmp_path / "a" / file).read_bytes() == (tmp_path / "b" / file).read_bytes()


def test_follows_a_recorded_scanner(run_program, shared_data, tmp_path):
    """Neighbouring poses against the relations that people checked by hand (Kuemmerle et al., 2009)."""
    folder = shared_data("data/laser2d/fr079")
    result = run_program("carmen_replay", folder / "fr079_noisy_odometry.log", "--out", tmp_path)
    assert result.returncode == 0, result.stderr
    poses = read_trajectory(tmp_path)
    stamps = [pose[0] for pose in poses]

    def pose_at(stamp):
        """The pose at most 50 ms away: at a robot's pace that is 2 cm."""
        after = bisect.bisect(stamps, stamp)
        nearest = min(poses[max(after - 1, 0):after + 1], key=lambda pose: abs(pose[0] - stamp))
        return nearest[1:] if abs(nearest[0] - stamp) < 0.05 else None

    errors = []
    for line in (folder / "fr079.relations").read_text().splitlines():
        first, second, x, y, *_ = map(float, line.split())
        a, b = pose_at(first), pose_at(second)
        # Loops are not closed yet: only what lies a moment apart.
        if a is None or b is None or not 0 < second - first < 3:
            continue
        dx, dy = b[0] - a[0], b[1] - a[1]
        along = math.cos(a[2]) * dx + math.sin(a[2]) * dy
        across = -math.sin(a[2]) * dx + math.cos(a[2]) * dy
        errors.append(math.hypot(along - x, across - y))
    assert len(errors) > 500
    assert sum(errors) / len(errors) < 0.05, "[m]; a cell is 5 cm wide"
