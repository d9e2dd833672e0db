"""world_to_sdf: the worlds for Gazebo are well-formed, complete, and where the simulator's are."""

import pathlib
import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
import yaml

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
CONFIG = REPOSITORY / "config"
WORLDS = sorted(path.stem for path in (CONFIG / "worlds").glob("*.yaml"))


class Written:
    """What world_to_sdf wrote and said of a world."""

    def __init__(self, name, folder, stdout):
        self.name = name
        self.folder = folder
        self.stdout = stdout
        self.world = ElementTree.parse(folder / "world.sdf").getroot().find("world")

    @property
    def meshes(self):
        """Every mesh that is named, as a path."""
        return [self.folder / uri.text.removeprefix("file://") for uri in self.world.iter("uri")
                if uri.text.startswith("file://")]


@pytest.fixture(name="written", scope="module", params=WORLDS)
def fixture_written(run_program, tmp_path_factory, request):
    folder = tmp_path_factory.mktemp(request.param)
    result = run_program("world_to_sdf", CONFIG / f"worlds/{request.param}.yaml", folder,
                         "--labels", CONFIG / "labels.yaml", "--tour", CONFIG / f"tours/{request.param}.yaml",
                         "--texture-size", "64")
    assert result.returncode == 0, result.stderr
    return Written(request.param, folder, result.stdout)


def lines_of(path, keyword):
    """What follows `keyword` in the lines of a Wavefront file that begin with it."""
    return [line.split(maxsplit=1)[1] for line in path.read_text().splitlines()
            if line.startswith(keyword + " ")]


def corners_of(mesh):
    return np.array([line.split() for line in lines_of(mesh, "v")], dtype=float)


def pose_of(element):
    """Rotation and translation of an element's <pose>: x y z roll pitch yaw, about fixed axes."""
    x, y, z, roll, pitch, yaw = map(float, element.findtext("pose").split())
    (cr, sr), (cp, sp), (cy, sy) = ((np.cos(a), np.sin(a)) for a in (roll, pitch, yaw))
    about_x = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    about_y = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    about_z = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
    return about_z @ about_y @ about_x, np.array([x, y, z])


def test_there_are_worlds():
    assert {"home", "office"} <= set(WORLDS)


def test_every_object_is_a_model_or_an_actor(written):
    models, actors, textures = map(int, re.search(
        r"(\d+) models, (\d+) actors, (\d+) textures", written.stdout).groups())
    assert len(written.world.findall("model")) == models
    assert len(written.world.findall("actor")) == actors
    names = [element.get("name") for element in written.world if element.get("name")]
    assert len(names) == len(set(names))
    furniture = yaml.safe_load((CONFIG / f"worlds/{written.name}.yaml").read_text())["furniture"]
    assert models >= len(furniture) > 20
    assert {piece["name"] for piece in furniture if "name" in piece and "kind" in piece} <= set(names)
    assert len(list((written.folder / "textures").iterdir())) == textures


def test_every_file_that_is_named_exists(written):
    assert written.meshes
    for mesh in set(written.meshes):
        assert mesh.is_file(), mesh
        materials = mesh.parent / lines_of(mesh, "mtllib")[0]
        assert set(lines_of(mesh, "usemtl")) == set(lines_of(materials, "newmtl"))
        for texture in lines_of(materials, "map_Kd"):
            assert (materials.parent / texture).read_bytes().startswith(b"\x89PNG")


def test_models_are_seen_and_run_into_in_the_same_shape(written):
    for model in written.world.findall("model"):
        link = model.find("link")
        mesh = link.findtext("visual/geometry/mesh/uri")
        assert mesh and link.findtext("collision/geometry/mesh/uri") == mesh


def test_triangles_name_corners_that_exist(written):
    for mesh in set(written.meshes):
        count = len(lines_of(mesh, "v"))
        assert len(lines_of(mesh, "vt")) == len(lines_of(mesh, "vn")) == count > 0
        indices = [int(index) for face in lines_of(mesh, "f") for index in re.split("[ /]", face)]
        assert min(indices) == 1 and max(indices) == count


def test_models_fill_the_bounds_of_the_world(written):
    placed = []
    for model in written.world.findall("model"):
        rotation, translation = pose_of(model)
        mesh = written.folder / model.findtext("link/visual/geometry/mesh/uri").removeprefix("file://")
        placed.append(corners_of(mesh) @ rotation.T + translation)
    placed = np.vstack(placed)
    numbers = re.search(r"x, y, z \[m\]: (.*)", written.stdout).group(1)
    bounds = np.array(re.findall(r"-?\d+\.\d+", numbers), dtype=float).reshape(3, 2)
    # Six digits of a position within 100 m, six decimals of an angle on 20 m, three decimals of bounds.
    assert placed.min(axis=0) == pytest.approx(bounds[:, 0], abs=1e-3)
    assert placed.max(axis=0) == pytest.approx(bounds[:, 1], abs=1e-3)


def test_who_walks_comes_back(written):
    actors = written.world.findall("actor")
    assert actors or written.name != "office"  # where somebody walks
    for actor in actors:
        waypoints = actor.findall("script/trajectory/waypoint")
        times = [float(waypoint.findtext("time")) for waypoint in waypoints]
        assert times == sorted(times) and times[0] == 0.0 and times[-1] > 1.0
        assert waypoints[0].findtext("pose") == waypoints[-1].findtext("pose")


def test_lamps_hang_in_the_building(written):
    lamps = [light for light in written.world.findall("light") if light.get("type") == "point"]
    assert len(lamps) >= 2
    for lamp in lamps:
        assert 1.0 < float(lamp.findtext("pose").split()[2]) < 4.0


def test_the_drone_is_a_model_of_the_package(written):
    uri = written.world.findtext("include/uri")
    folder = CONFIG / "gazebo" / uri.removeprefix("model://")
    model_file = ElementTree.parse(folder / "model.config").getroot().findtext("sdf")
    model = ElementTree.parse(folder / model_file).getroot().find("model")
    camera = model.find("link/sensor[@type='depth']/camera")
    # fx = width / (2 tan(field of view / 2)): that of the simulated D455.
    width = int(camera.findtext("image/width"))
    assert width / (2 * np.tan(float(camera.findtext("horizontal_fov")) / 2)) == pytest.approx(384, abs=1e-3)


def test_two_runs_give_the_same_bytes(run_program, tmp_path):
    texts = []
    for name in ("first", "second"):
        result = run_program("world_to_sdf", CONFIG / "worlds/home.yaml", tmp_path / name,
                             "--labels", CONFIG / "labels.yaml", "--texture-size", "64")
        assert result.returncode == 0, result.stderr
        texts.append({path.relative_to(tmp_path / name): path.read_bytes()
                      for path in (tmp_path / name).rglob("*") if path.is_file()})
    assert texts[0] == texts[1]


def test_without_a_tour_there_is_no_drone(run_program, tmp_path):
    result = run_program("world_to_sdf", CONFIG / "worlds/home.yaml", tmp_path,
                         "--labels", CONFIG / "labels.yaml", "--texture-size", "64")
    assert result.returncode == 0, result.stderr
    assert ElementTree.parse(tmp_path / "world.sdf").getroot().find("world/include") is None
