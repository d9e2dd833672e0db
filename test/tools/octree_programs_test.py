"""octree_info and octree_convert, on a map that is written here byte by byte."""

import json
import struct

import pytest

LABELS = [(0, "unknown", (120, 120, 120)), (5, "chair", (214, 39, 40)), (7, "table", (255, 127, 14))]
RESOLUTION = 0.1
ORIGIN = 32768  # the key of the voxel from 0 to RESOLUTION


def label_set_hash():
    value = 14695981039346656037
    for label, name, _ in LABELS:
        for byte in bytes([label]) + name.encode() + b"\0":
            value = ((value ^ byte) * 1099511628211) % 2**64
    return value


def node(log_odds, label, children):
    probability = 13106 if label else 0  # 0.8
    return (struct.pack("<f3B", log_odds, 10, 20, 30) + struct.pack("<3H3B", probability, 0, 0, label, 0, 0) +
            bytes([children]))


def subtree(voxels, depth):
    """Nodes of a tree of voxels, {key: (log-odds, label)}, and how many there are."""
    if depth == 16:
        (log_odds, label), = voxels.values()
        return node(log_odds, label, 0), 1
    below = {}
    for key, value in voxels.items():
        child = sum((key[axis] >> (15 - depth) & 1) << axis for axis in range(3))
        below.setdefault(child, {})[key] = value
    data = node(max(log_odds for log_odds, _ in voxels.values()), 0, sum(1 << child for child in below))
    count = 1
    for child in sorted(below):
        nodes, number = subtree(below[child], depth + 1)
        data, count = data + nodes, count + number
    return data, count


@pytest.fixture(name="map_file")
def fixture_map_file(tmp_path):
    voxels = {(ORIGIN + x, ORIGIN, ORIGIN + 7): (2.0, 7) for x in range(6)}
    voxels[(ORIGIN - 10, ORIGIN, ORIGIN)] = (1.0, 5)
    voxels[(ORIGIN + 2, ORIGIN, ORIGIN + 2)] = (-1.5, 0)  # free
    data, count = subtree(voxels, 0)
    legend = "".join(f"# label {label} {name} {r} {g} {b}\n" for label, name, (r, g, b) in LABELS)
    header = (f"# Octomap OcTree file\n# label_set {label_set_hash()}\n{legend}"
              f"id SemanticOcTree\nsize {count}\nres {RESOLUTION}\ndata\n")
    path = tmp_path / "map.ot"
    path.write_bytes(header.encode() + data)
    return path


def test_tells_what_a_map_holds(run_program, map_file):
    result = run_program("octree_info", map_file, "--json")
    assert result.returncode == 0, result.stderr
    info = json.loads(result.stdout)
    assert info["resolution_m"] == RESOLUTION
    assert info["occupied_voxels"] == 7
    assert info["leaves"] == 8
    assert info["label_set_hash"] == label_set_hash()
    assert info["min_m"] == pytest.approx([-1.0, 0.0, 0.0])
    assert info["max_m"] == pytest.approx([0.6, 0.1, 0.8])
    assert [(entry["name"], entry["voxels"]) for entry in info["classes"]] == [("table", 6), ("chair", 1)]
    assert info["classes"][0]["volume_m3"] == pytest.approx(6 * RESOLUTION**3)

    table = run_program("octree_info", map_file)
    assert table.returncode == 0
    assert "chair" in table.stdout


@pytest.mark.parametrize("ending, start", [
    (".ot", b"# Octomap OcTree file\n"),
    (".bt", b"# Octomap OcTree binary file\n"),
    (".ply", b"ply\nformat binary_little_endian 1.0\n"),
    (".pcd", b"# .PCD v0.7"),
    (".png", b"\x89PNG"),
])
def test_writes_what_others_read(run_program, map_file, tmp_path, ending, start):
    out = tmp_path / ("out" + ending)
    result = run_program("octree_convert", map_file, out)
    assert result.returncode == 0, result.stderr
    assert out.read_bytes().startswith(start)


def test_colours_by_class_or_as_seen(run_program, map_file, tmp_path):
    colours = {}
    for mode in ["class", "rgb"]:
        out = tmp_path / f"{mode}.ply"
        assert run_program("octree_convert", map_file, out, "--colour", mode).returncode == 0
        content = out.read_bytes()
        points = content[content.index(b"end_header\n") + 11:]
        colours[mode] = {(point[3:6], point[6]) for point in struct.iter_unpack("<fff3BBf", points)}
        assert len(points) == 7 * 20
    assert colours["class"] == {((214, 39, 40), 5), ((255, 127, 14), 7)}
    assert colours["rgb"] == {((10, 20, 30), 5), ((10, 20, 30), 7)}


def test_does_not_write_over_the_map(run_program, map_file):
    before = map_file.read_bytes()
    result = run_program("octree_convert", map_file, map_file)
    assert result.returncode == 1
    assert "is MAP.ot itself" in result.stderr
    assert map_file.read_bytes() == before


@pytest.mark.parametrize("arguments, word", [(["out.stl"], "must end in"), (["out.ot", "--colour", "heat"], "heat")])
def test_refuses_what_it_cannot_write(run_program, map_file, tmp_path, arguments, word):
    result = run_program("octree_convert", map_file, tmp_path / arguments[0], *arguments[1:])
    assert result.returncode == 1
    assert result.stderr.count("\n") == 1
    assert word in result.stderr
