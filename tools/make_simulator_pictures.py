#!/usr/bin/env python3
"""Makes the pictures of docs/simulator.md: a frame of each scene and of each depth sensor as colour, depth and flexion,
and what the camera does to a frame.

    tools/make_simulator_pictures.py build/release/bin/framewise docs

Needs numpy and Pillow (PyPI).
"""

import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image

WIDTH = 260  # of each picture in the row
SCENES = [("room", "handheld"), ("corridor", "walk"), ("mine", "walk"), ("race", "handheld"), ("plane", "handheld"),
          ("sphere-field", "orbit")]
SENSORS = ["exact", "kinect", "tof", "lidar"]
CAMERAS = [("as it is", []), ("motion blur", ["--exposure-time", "0.03"]),
           ("rolling shutter", ["--rolling-shutter", "0.03"]),
           ("few photons", ["--exposure", "0.3", "--photons", "150", "--read-noise", "3"]),
           ("lens", ["--distortion=-0.28,0.06,0,0,0", "--vignetting", "1"])]


def turbo(x):
    """A colour map of numbers 0 to 1: the polynomial fit of Mikhailov, Turbo, 2019."""
    powers = np.stack([x ** k for k in range(6)], -1)
    coefficients = np.array([[0.13572138, 4.61539260, -42.66032258, 132.13108234, -152.94239396, 59.28637943],
                             [0.09140261, 2.19418839, 4.84296658, -14.18503333, 4.27729857, 2.82956604],
                             [0.10667330, 12.64194608, -60.58204836, 110.36276771, -89.90310912, 27.34824973]])
    return (255 * np.clip(powers @ coefficients.T, 0, 1)).astype(np.uint8)


def small(rgb):
    image = Image.fromarray(rgb)
    return np.asarray(image.resize((WIDTH, WIDTH * image.height // image.width), Image.LANCZOS))


def first(folder):
    return sorted(folder.glob("*.png"))[0]


def depth_picture(file):
    raw = np.asarray(Image.open(file)).astype(float)
    seen = raw > 0
    low, high = np.percentile(raw[seen], [1, 99])
    picture = turbo(np.clip((raw - low) / max(1, high - low), 0, 1))
    picture[~seen] = 0
    if seen.mean() < 0.3:  # points: larger, or they are lost in a small picture
        wide = picture.copy()
        for dy, dx in ((0, 1), (1, 0), (1, 1)):
            moved = np.roll(picture, (dy, dx), (0, 1))
            wide = np.where(wide.any(-1, keepdims=True), wide, moved)
        picture = wide
    return small(picture)


class Simulator:
    def __init__(self, framewise, folder):
        self.framewise, self.folder, self.count = framewise, pathlib.Path(folder), 0

    def call(self, *words):
        subprocess.run([self.framewise, *map(str, words), "--quiet"], check=True, stdout=subprocess.DEVNULL)

    def simulate(self, *options):
        self.count += 1
        out = self.folder / str(self.count)
        self.call("simulate", *options, "--frames", 1, "--seed", 2, "--out", out)
        return out

    def row(self, *options, flexion=()):
        out = self.simulate(*options)
        self.call("flexion", out / "depth", "--camera", out / "camera.yaml", "--distance", 3, "--smooth", 2, "--format", 8,
                  *flexion, "--out", out / "flexion")
        gray = np.asarray(Image.open(first(out / "flexion")))
        return np.hstack([small(np.asarray(Image.open(first(out / "rgb")))), depth_picture(first(out / "depth")),
                          small(np.dstack([gray] * 3))])


def save(picture, file):
    Image.fromarray(picture).save(file, quality=82)
    print(file, file.stat().st_size // 1024, "KiB")


def main(framewise, docs):
    docs = pathlib.Path(docs)
    with tempfile.TemporaryDirectory() as folder:
        simulator = Simulator(framewise, folder)
        for scene, path in SCENES:
            lamp = ["--headlamp", 12] if scene == "mine" else []
            save(simulator.row(scene, "--path", path, "--depth-max", 40, *lamp), docs / f"simulator_{scene}.jpg")
        for sensor in SENSORS:
            dense = ["--densify"] if sensor == "lidar" else []
            save(simulator.row("room", "--path", "orbit", "--depth", sensor, flexion=dense), docs / f"simulator_{sensor}.jpg")
        frames = [simulator.simulate("race", "--path", "drone-race", *options) for _, options in CAMERAS]
        save(np.hstack([small(np.asarray(Image.open(first(f / "rgb")))) for f in frames]), docs / "simulator_camera.jpg")


if __name__ == "__main__":
    main(*sys.argv[1:])
