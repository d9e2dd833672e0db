"""evaluate_maps: maps made of the truth are right, shifted ones are not, and what is missing is shown as missing."""

import json
import math
import re
import shutil

import pytest
from small_world import write_inputs

RADIUS = 1.2
FLIGHT_HEIGHT = 1.45  # over table and chair; there the map's z begins


def pose_line(stamp, position, yaw):
    """Of a level camera's optical frame, in TUM's format."""
    half = yaw / 2 - math.pi / 4  # a quarter of a turn from x ahead to the optical frame's z ahead
    return f"{stamp:.6f} {position[0]} {position[1]} {position[2]} " + " ".join(map(str, (
        -math.cos(half) / math.sqrt(2), -math.sin(half) / math.sqrt(2), math.sin(half) / math.sqrt(2),
        math.cos(half) / math.sqrt(2))))


def tour(shift=0.0, height=FLIGHT_HEIGHT):
    """Around the room with a look at its middle."""
    lines = []
    for i in range(60):
        angle = 2 * math.pi * i / 60
        position = (2 + RADIUS * math.cos(angle) + shift, 1.5 + RADIUS * math.sin(angle), height)
        lines.append(pose_line(10 + 0.5 * i, position, angle + math.pi))
    return "\n".join(lines) + "\n"


@pytest.fixture(name="truth", scope="module")
def fixture_truth(run_program, build_folder, tmp_path_factory):
    """The truth of the small room and a tour through it, as render_sequence writes it."""
    if not (build_folder / "devel/lib/semantic_slam/render_sequence").exists():
        pytest.skip("there is no simulator: Embree is not installed")
    folder = tmp_path_factory.mktemp("truth")
    write_inputs(folder)
    (folder / "tour.txt").write_text(tour())
    result = run_program("render_sequence", folder / "world.yaml", folder / "tour.txt", folder / "truth", "--camera",
                         folder / "camera.yaml", "--rate", "2", "--noise", "off", "--truth-period", "100")
    assert result.returncode == 0, result.stderr
    return folder / "truth"


def lowered(text):
    """An object map in a frame that begins at the flight height."""
    objects = json.loads(text)
    for thing in objects["objects"]:
        for key in "min_height_m", "max_height_m":
            thing[key] -= FLIGHT_HEIGHT
        for position in thing["position_m"], thing["box"]["centre_m"]:
            position[2] -= FLIGHT_HEIGHT
    return json.dumps(objects)


@pytest.fixture(name="perfect")
def fixture_perfect(truth, tmp_path):
    """What a perfect run would leave."""
    out = tmp_path / "out"
    out.mkdir()
    (out / "trajectory.txt").write_text(tour(height=0.0))
    (out / "objects.json").write_text(lowered((truth / "objects.json").read_text()))
    for name in "grid", "semantic_grid":
        shutil.copy(truth / "floor_plan_flight.pgm", out / "floor_plan_flight.pgm")
        shutil.copy(truth / "floor_plan_flight.yaml", out / f"{name}.yaml")
    return out


@pytest.fixture(name="evaluate")
def fixture_evaluate(run_program, truth):
    def run(out, *options):
        return run_program("evaluate_maps", truth / "world.yaml", out, "--truth", truth / "groundtruth.txt",
                           "--camera", truth / "camera.yaml", *options)

    return run


def numbers(result):
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def test_perfect_maps_have_no_errors(evaluate, perfect):
    report = numbers(evaluate(perfect, "--json"))
    assert report["trajectory"]["ate_rmse_m"] == pytest.approx(0, abs=1e-6)
    assert report["objects"]["expected"] == report["objects"]["found"] > 2
    assert report["objects"]["missed"] == report["objects"]["extra"] == 0
    assert report["objects"]["right_class"] == 1
    assert report["objects"]["position_max_m"] == pytest.approx(0, abs=1e-3)  # objects.json has 0.1 mm
    for grid in "grid", "semantic_grid":
        assert report[grid] == {"free_precision": 1, "free_recall": 1, "occupied_precision": 1, "occupied_recall": 1}
    assert report["voxels"] is None


def test_shifted_maps_have_errors(evaluate, perfect):
    origin = re.compile(r"origin: \[([-0-9.]+),")
    text = (perfect / "grid.yaml").read_text()
    (perfect / "grid.yaml").write_text(origin.sub(lambda m: f"origin: [{float(m[1]) + 0.3:.6f},", text))
    objects = json.loads((perfect / "objects.json").read_text())
    for thing in objects["objects"]:
        thing["position_m"][0] += 0.3
    objects["objects"][0]["probabilities"] = {"sofa": 1.0}
    (perfect / "objects.json").write_text(json.dumps(objects))
    report = numbers(evaluate(perfect, "--json"))
    assert report["objects"]["position_mean_m"] == pytest.approx(0.3, abs=1e-3)
    assert report["objects"]["right_class"] < 1
    assert report["grid"]["occupied_precision"] < 0.9
    assert report["semantic_grid"]["occupied_precision"] == 1


def test_a_shifted_trajectory_shifts_nothing(evaluate, perfect):
    """The map's frame is where the run began: maps and trajectory move together."""
    (perfect / "trajectory.txt").write_text(tour(shift=5.0, height=0.0))
    report = numbers(evaluate(perfect, "--json"))
    assert report["trajectory"]["ate_rmse_m"] == pytest.approx(0, abs=1e-6)
    assert report["objects"]["found"] == 0  # these did not move with it
    assert report["objects"]["extra"] > 2


def test_what_is_missing_is_a_dash(evaluate, perfect):
    for name in "objects.json", "grid.yaml", "semantic_grid.yaml":
        (perfect / name).unlink()
    result = evaluate(perfect)
    assert result.returncode == 0, result.stderr
    for name in "voxels", "objects", "floor plan", "semantic grid":
        assert re.search(rf"^{name} +-$", result.stdout, re.MULTILINE), result.stdout
    assert "ATE" in result.stdout


def test_draws_a_picture(evaluate, perfect, tmp_path):
    plot = tmp_path / "plot.png"
    assert evaluate(perfect, "--plot", plot).returncode == 0
    assert plot.read_bytes().startswith(b"\x89PNG")


def test_tells_what_is_wrong(evaluate, perfect, tmp_path):
    empty = tmp_path / "empty"
    empty.mkdir()
    for out, options, message in ((empty, (), "trajectory.txt"), (perfect, ("--object-classes", empty / "missing.yaml"), "missing.yaml"),
                                  (perfect, ("--plot", "plot.jpg"), "must end in .png")):
        result = evaluate(out, *options)
        assert result.returncode == 1
        assert message in result.stderr
        assert len(result.stderr.splitlines()) == 1
