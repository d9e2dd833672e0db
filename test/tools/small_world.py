"""What the tests of the simulator's programs share: a room, a camera, a short tour, and how to read what was rendered."""

import pathlib
import struct
import zlib

import numpy as np

WORLD = """\
rooms:
  - {name: room, from: [0, 0], to: [4, 3], floor: {pattern: parquet}, walls: {pattern: brick}}
furniture:
  - {kind: table, name: table, at: [2.6, 1.5]}
  - {kind: chair, name: chair, at: [2.6, 2.4], yaw_deg: -90}
  - {kind: bookshelf, wall: room/north, along_m: 2.0}
  - {kind: poster, wall: room/east, along_m: 1.5, z_m: 1.0, size_m: [0.004, 0.7, 1.0]}
  - {kind: ceiling_lamp, at: [2, 1.5]}
"""

WIDTH, HEIGHT, FOCAL = 320, 240, 192.0
CAMERA = f"""\
camera: {{width_px: {WIDTH}, height_px: {HEIGHT}, fx_px: {FOCAL}, fy_px: {FOCAL}, cx_px: {(WIDTH - 1) / 2},
  cy_px: {(HEIGHT - 1) / 2}}}
dataset: {{depth_png_factor: 5000}}
"""

TOUR = """\
waypoints:
  - {position_m: [0.7, 1.3, 1.2], yaw_deg: 10, hold_s: 0.3}
  - {position_m: [1.0, 1.5, 1.2], yaw_deg: 20}
"""


def write_inputs(folder):
    """Leaves world.yaml, camera.yaml and tour.yaml in a folder."""
    for name, text in ("world", WORLD), ("camera", CAMERA), ("tour", TOUR):
        (folder / f"{name}.yaml").write_text(text)


def read_png(path):
    """A grey PNG of 8 or 16 bits as an array."""
    data = path.read_bytes()
    position, pixels = 8, b""
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        body = data[position + 8:position + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
            assert colour == 0 and depth in (8, 16)
        elif kind == b"IDAT":
            pixels += body
        position += 12 + length
    return unfiltered(zlib.decompress(pixels), width, height, depth // 8)


def unfiltered(data, width, height, size):
    """Takes back the filters of a PNG's rows (section 9 of its specification)."""
    rows = np.frombuffer(data, np.uint8).reshape(height, 1 + width * size)
    above = np.zeros((width, size), int)
    image = np.empty((height, width, size), np.uint8)
    for v in range(height):
        row = rows[v, 1:].reshape(width, size).astype(int)
        above = undo_filter(rows[v, 0], row, above) % 256
        image[v] = above
    return image[..., 0] if size == 1 else image[..., 0] * np.uint16(256) + image[..., 1]


def undo_filter(kind, row, above):
    if kind == 0:
        return row
    if kind == 2:
        return row + above
    if kind == 1:
        return np.cumsum(row, axis=0)
    result, left, corner = row.copy(), np.zeros(row.shape[1], int), np.zeros(row.shape[1], int)
    for u, up in enumerate(above):
        if kind == 3:
            predicted = (left + up) // 2
        else:
            near = [np.abs(up - corner), np.abs(left - corner), np.abs(left + up - 2 * corner)]
            predicted = np.where((near[0] <= near[1]) & (near[0] <= near[2]), left,
                                 np.where(near[1] <= near[2], up, corner))
        left, corner = (result[u] + predicted) % 256, up
        result[u] = left
    return result


def read_poses(path):
    """T_world_camera by stamp, as 3 x 4 arrays, of a file in TUM's format."""
    poses = {}
    for line in path.read_text().splitlines():
        if line.startswith("#"):
            continue
        stamp, *numbers = line.split()
        x, y, z, qx, qy, qz, qw = map(float, numbers)
        rotation = [[1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy - qz * qw), 2 * (qx * qz + qy * qw)],
                    [2 * (qx * qy + qz * qw), 1 - 2 * (qx * qx + qz * qz), 2 * (qy * qz - qx * qw)],
                    [2 * (qx * qz - qy * qw), 2 * (qy * qz + qx * qw), 1 - 2 * (qx * qx + qy * qy)]]
        poses[stamp] = np.column_stack([rotation, [x, y, z]])
    return poses


def points_in_world(depth_m, pose):
    """Where the pixels of a depth image are: height x width x 3."""
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    in_camera = np.stack([(u - (WIDTH - 1) / 2) / FOCAL, (v - (HEIGHT - 1) / 2) / FOCAL, np.ones_like(u)], axis=-1)
    return (in_camera * depth_m[..., None]) @ pose[:, :3].T + pose[:, 3]


def files_of(folder):
    """The content of every file below a folder."""
    return {path.relative_to(folder).as_posix(): path.read_bytes()
            for path in pathlib.Path(folder).rglob("*") if path.is_file()}
