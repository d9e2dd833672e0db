"""Data sets of a few small images, as folders and in memory."""

import cv2
import numpy as np

WALL, CHAIR, SOFA = 1, 5, 6  # ids of config/labels.yaml
WIDTH, HEIGHT = 64, 48


def scene(seed):
    """A bright box on a dark ground: image (red first), box left, top, right, bottom [px]."""
    random = np.random.default_rng(seed)
    image = random.integers(0, 60, (HEIGHT, WIDTH, 3), np.uint8)
    left, top = random.integers(4, 30), random.integers(4, 20)
    box = (int(left), int(top), int(left) + 26, int(top) + 22)
    image[box[1]:box[3], box[0]:box[2]] += np.uint8(150)
    return image, box


def fill(shape, box, inside, outside, kind):
    ids = np.full(shape, outside, kind)
    ids[box[1]:box[3], box[0]:box[2]] = inside
    return ids


class Scenes:
    """Segmentation in memory: the box is of class 1."""

    names = ("wall", "chair")

    def __init__(self, count):
        self.count = count

    def __len__(self):
        return self.count

    def read(self, index):
        image, box = scene(index)
        return image, fill(image.shape[:2], box, 1, 0, np.uint8)


def write_image(path, image):
    path.parent.mkdir(parents=True, exist_ok=True)
    cv2.imwrite(str(path), image if image.ndim == 2 else image[:, :, ::-1])


def yolo_line(label, box):
    left, top, right, bottom = box
    return (f"{label} {(left + right) / 2 / WIDTH:.6f} {(top + bottom) / 2 / HEIGHT:.6f} "
            f"{(right - left) / WIDTH:.6f} {(bottom - top) / HEIGHT:.6f}\n")


def write_rendered(folder, count, first_seed=0, label=CHAIR):
    """A sequence of scenes with every kind of truth; the box is instance 7. Returns the boxes."""
    lists = {"rgb": "", "labels": "", "instances": ""}
    boxes = []
    for number in range(count):
        stamp = f"{number}.500000"
        image, box = scene(first_seed + number)
        boxes.append(box)
        write_image(folder / f"rgb/{stamp}.png", image)  # a .jpg would not be exact
        write_image(folder / f"labels/{stamp}.png", fill(image.shape[:2], box, label, WALL, np.uint8))
        write_image(folder / f"instances/{stamp}.png", fill(image.shape[:2], box, 7, 0, np.uint16))
        (folder / "boxes").mkdir(exist_ok=True)
        (folder / f"boxes/{stamp}.txt").write_text(yolo_line(label, box) + "1 0.5 0.5 1 1\n")
        for kind in lists:
            lists[kind] += f"{stamp} {kind}/{stamp}.png\n"
    for kind, text in lists.items():
        (folder / f"{kind}.txt").write_text("# stamp file\n" + text)
    return boxes


def write_yolo_folder(folder, count):
    """Scenes of class `big chair` in two splits. Returns data.yaml and the boxes."""
    boxes = {}
    for split in ("train", "val"):
        boxes[split] = []
        (folder / "labels" / split).mkdir(parents=True)
        for number in range(count):
            image, box = scene(number)
            boxes[split].append(box)
            write_image(folder / f"images/{split}/{number}.png", image)
            (folder / f"labels/{split}/{number}.txt").write_text(yolo_line(1, box))
    data_file = folder / "data.yaml"
    data_file.write_text("names: [table, big chair]\ntrain: images/train\nval: images/val\n")
    return data_file, boxes
