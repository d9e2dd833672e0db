"""Random changes of images, thesis section 4.1.2.3: rotated, scaled, flipped, and of other light."""

import dataclasses

import cv2
import numpy as np


@dataclasses.dataclass(frozen=True)
class Augmentation:
    """How far images may be changed; `none()` leaves them as they are."""

    rotation_deg: float = 5.0
    least_scale: float = 0.85
    most_scale: float = 1.6
    shift: float = 0.05  # share of the input's size, besides what scaling leaves to choose
    flip_probability: float = 0.5
    brightness: float = 0.12  # shares of 255 and of 1
    contrast: float = 0.2
    gamma: float = 0.2
    saturation: float = 0.35
    tint: float = 0.06  # of each channel by itself
    blur_probability: float = 0.2
    most_blur_px: float = 1.2
    noise_probability: float = 0.3
    most_noise: float = 8.0  # standard deviation, in grey levels

    @staticmethod
    def none():
        return Augmentation(**{field.name: 1.0 if field.name.endswith("_scale") else 0.0
                               for field in dataclasses.fields(Augmentation)})


def tone_table(random, options):
    """256 x 3, uint8: what becomes of each grey level of each channel."""
    levels = np.linspace(0, 1, 256)[:, None] * np.ones(3)
    levels = levels ** np.exp(random.uniform(-options.gamma, options.gamma))
    levels = levels * (1 + random.uniform(-options.tint, options.tint, 3))
    levels = (levels - 0.5) * (1 + random.uniform(-options.contrast, options.contrast)) + 0.5
    levels = levels + random.uniform(-options.brightness, options.brightness)
    return (levels.clip(0, 1) * 255 + 0.5).astype(np.uint8)


def change_tones(random, image, options):
    return cv2.LUT(image, tone_table(random, options)[None])


def change_saturation(random, image, options):
    share = 1 + random.uniform(-options.saturation, options.saturation)
    grey = cv2.cvtColor(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), cv2.COLOR_GRAY2RGB)
    return cv2.addWeighted(image, share, grey, 1 - share, 0)


def blur(random, image, options):
    sigma = random.uniform(0, options.most_blur_px)
    if random.random() >= options.blur_probability or sigma < 0.1:
        return image
    return cv2.GaussianBlur(image, (0, 0), sigma)


def add_noise(random, image, options):
    deviation = random.uniform(0, options.most_noise)
    if random.random() >= options.noise_probability:
        return image
    noise = random.standard_normal(image.shape, np.float32) * deviation
    return (image + noise).clip(0, 255).astype(np.uint8)


def change_light(random, image, options):
    """Tones, colours, sharpness and noise; same size."""
    for change in (change_saturation, change_tones, blur, add_noise):
        image = change(random, image, options)
    return image
