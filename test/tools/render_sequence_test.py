"""render_sequence: what it renders is a sequence, agrees with itself pixel by pixel, and is the same every time."""

import json

import numpy as np
import pytest
from small_world import HEIGHT, WIDTH, files_of, points_in_world, read_png, read_poses, write_inputs

FLOOR, CHAIR, TABLE = 2, 5, 7
RATE = 10


@pytest.fixture(name="render", scope="module")
def fixture_render(run_program, build_folder, tmp_path_factory):
    """Renders the small room: render(name, option...) returns the folder."""
    if not (build_folder / "devel/lib/semantic_slam/render_sequence").exists():
        pytest.skip("there is no simulator: Embree is not installed")
    folder = tmp_path_factory.mktemp("render")
    write_inputs(folder)

    def render(name, *options, before=()):
        out = folder / name
        result = run_program("render_sequence", folder / "world.yaml", folder / "tour.yaml", out, "--camera",
                             folder / "camera.yaml", "--rate", str(RATE), *options, before=before)
        assert result.returncode == 0, result.stderr
        return out

    return render


@pytest.fixture(name="noisy", scope="module")
def fixture_noisy(render):
    return render("noisy")


@pytest.fixture(name="exact", scope="module")
def fixture_exact(render):
    return render("exact", "--noise", "off")


def stamps(folder):
    return [line.split()[0] for line in (folder / "rgb.txt").read_text().splitlines()[1:]]


def boxes(folder, stamp):
    """Class and edges in pixels, left, top, right, bottom, with the middle of the first pixel at 0."""
    size = np.array([WIDTH, HEIGHT])
    for line in (folder / f"boxes/{stamp}.txt").read_text().splitlines():
        label, *numbers, visible_share = line.split()
        assert 0 < float(visible_share) <= 1
        middle, extent = np.array(numbers, float).reshape(2, 2) * size
        yield int(label), (*(middle - extent / 2 - 0.5), *(middle + extent / 2 - 0.5))


def test_holds_all_of_the_truth(noisy, repository):
    assert len(stamps(noisy)) == len(list((noisy / "depth").iterdir())) == len(read_poses(noisy / "groundtruth.txt"))
    assert (noisy / "world.yaml").read_text() == (noisy.parent / "world.yaml").read_text()
    assert (noisy / "classes.txt").read_text().splitlines()[TABLE] == "table"
    assert len((noisy / "imu.txt").read_text().splitlines()) > 20 * len(stamps(noisy)) - 25  # 200 per second
    objects = json.loads((noisy / "objects.json").read_text())["objects"]
    assert {"table", "chair", "bookshelf", "picture", "lamp"} == {thing["class"] for thing in objects}
    table = next(thing for thing in objects if thing["class"] == "table")
    assert table["position_m"][:2] == pytest.approx([2.6, 1.5], abs=0.01)
    assert table["hollow"] == "full"
    for plan in "flight", "projection":
        assert (noisy / f"floor_plan_{plan}.pgm").read_bytes().startswith(b"P5")
    assert (repository / "config/labels.yaml").exists()


def test_depth_and_labels_agree(exact):
    poses = read_poses(exact / "groundtruth.txt")
    for stamp in stamps(exact)[::6]:
        depth_m = read_png(exact / f"depth/{stamp}.png") / 5000
        labels = read_png(exact / f"labels/{stamp}.png")
        points = points_in_world(depth_m, poses[stamp])
        floor = labels == FLOOR
        assert floor.sum() > 1000
        # Depth is rounded to 0.2 mm, poses to nine decimals.
        assert np.abs(points[floor][:, 2]).max() < 0.001
        table = points[labels == TABLE]
        assert len(table) > 1000
        assert (np.abs(table[:, :2] - [2.6, 1.5]) < [0.5, 0.9]).all()  # 0.9 m x 1.6 m, with a hair to spare


def test_boxes_are_those_of_the_instances(exact):
    for stamp in stamps(exact)[::6]:
        labels = read_png(exact / f"labels/{stamp}.png")
        instances = read_png(exact / f"instances/{stamp}.png")
        assert labels.shape == instances.shape == (HEIGHT, WIDTH)
        found = {label: edges for label, edges in boxes(exact, stamp)}
        assert {CHAIR, TABLE} <= found.keys()
        for label, edges in found.items():
            inside = instances[labels == label]
            instance, = set(inside.tolist())  # there is one of each
            v, u = np.nonzero(instances == instance)
            assert edges == pytest.approx((u.min() - 0.5, v.min() - 0.5, u.max() + 0.5, v.max() + 0.5), abs=0.01)


def test_noise_is_of_depth_and_colour_only(noisy, exact):
    a, b = files_of(noisy), files_of(exact)
    assert a.keys() == b.keys()
    different = {name.split("/")[0] for name in a if a[name] != b[name]}
    assert different == {"rgb", "depth", "imu.txt", "accelerometer.txt"}


def test_the_same_seed_gives_the_same_bytes(render, noisy):
    assert files_of(render("again")) == files_of(noisy)


def test_one_core_gives_the_same_bytes(render, noisy):
    assert files_of(render("one_core", before=["taskset", "--cpu-list", "0"])) == files_of(noisy)


def test_another_seed_gives_other_noise(render, noisy):
    other = files_of(render("seed", "--seed", "2", "--duration", "0.5"))
    same = files_of(noisy)
    name = f"depth/{stamps(noisy)[0]}.png"
    assert other[name] != same[name]


def test_truth_may_be_left_out(render, noisy):
    sparse = render("sparse", "--truth-period", "5", "--duration", "1")
    assert len(stamps(sparse)) == 11
    assert sorted(path.stem for path in (sparse / "labels").iterdir()) == stamps(noisy)[:11:5]


def test_follows_recorded_poses(run_program, noisy, tmp_path):
    out = tmp_path / "followed"
    result = run_program("render_sequence", noisy / "world.yaml", noisy / "groundtruth.txt", out, "--camera",
                         noisy / "camera.yaml", "--rate", str(RATE), "--duration", "0.5")
    assert result.returncode == 0, result.stderr
    followed, flown = read_poses(out / "groundtruth.txt"), read_poses(noisy / "groundtruth.txt")
    first, fifth = sorted(flown)[0], sorted(flown)[4]
    assert sorted(followed)[0] == first
    assert np.allclose(sorted(followed.items())[4][1], flown[fifth], atol=1e-4)


def test_names_mean_files_of_the_package(run_program, noisy, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "home").mkdir()  # is no tour
    result = run_program("render_sequence", noisy / "world.yaml", "home", tmp_path / "out", "--camera",
                         noisy / "camera.yaml", "--rate", "2", "--duration", "0.5")
    assert result.returncode == 0, result.stderr
    assert len(stamps(tmp_path / "out")) == 2


def test_writes_a_bag(render):
    bag = render("flight.bag", "--duration", "0.3")
    assert bag.read_bytes().startswith(b"#ROSBAG")
    assert not (bag.parent / "flight.bag.folder").exists()


def test_replays(run_program, noisy, repository, tmp_path):
    result = run_program("replay", "--dataset", noisy, "--config", noisy / "camera.yaml", "--labels",
                         repository / "config/labels.yaml", "--out", tmp_path, "--segmentation", "truth",
                         "--detection", "truth", "--object-period", "0", "--semantic-period", "0")
    assert result.returncode == 0, result.stderr
    summary = json.loads((tmp_path / "summary.json").read_text())
    assert summary["tracked"] == len(stamps(noisy)) and summary["lost"] == 0
    assert summary["semantic"]["clouds"] == len(stamps(noisy))
    classes = {thing["class"] for thing in json.loads((tmp_path / "objects.json").read_text())["objects"]}
    assert {"table", "bookshelf"} <= classes


@pytest.mark.parametrize("arguments, message", [
    (["nowhere.yaml", "tour.yaml", "out"], "nowhere.yaml"),
    (["world.yaml", "nowhere", "out"], "nowhere"),
    (["world.yaml", "tour.yaml", "noisy"], "holds a sequence already"),
    (["world.yaml", "tour.yaml", "out", "--noise", "some"], "--noise = some, expected on or off"),
    (["world.yaml", "tour.yaml", "out", "--rate", "0"], "--rate = 0"),
])
def test_tells_what_is_wrong(run_program, noisy, arguments, message):
    folder = noisy.parent
    names = [folder / name if not name.startswith("-") and index < 3 else name
             for index, name in enumerate(arguments)]
    result = run_program("render_sequence", *names, "--camera", folder / "camera.yaml")
    assert result.returncode == 1
    assert message in result.stderr
    assert len(result.stderr.splitlines()) == 1
