#!/usr/bin/env python3
"""Makes docs/room.jpg from a simulated recording and a run on it:

    framewise simulate room --frames 600 --out room
    framewise run room --out out
    tools/make_readme_picture.py room out docs/room.jpg

Needs numpy, matplotlib and opencv-python (PyPI).
"""

import json
import pathlib
import sys

import cv2
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


def umeyama_se3(source, target):
    """R, t with R source + t nearest to target."""
    mean_source, mean_target = source.mean(0), target.mean(0)
    u, _, vt = np.linalg.svd((target - mean_target).T @ (source - mean_source))
    rotation = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
    return rotation, mean_target - rotation @ mean_source


def main(data, out, picture):
    data, out = pathlib.Path(data), pathlib.Path(out)
    truth, estimate = np.loadtxt(data / "groundtruth.txt"), np.loadtxt(out / "trajectory.tum")
    run = json.loads((out / "run.json").read_text())
    at_frames = np.stack([np.interp(estimate[:, 0], truth[:, 0], truth[:, k]) for k in (1, 2, 3)], 1)
    rotation, translation = umeyama_se3(estimate[:, 1:4], at_frames)
    aligned = estimate[:, 1:4] @ rotation.T + translation

    frame = sorted((data / "rgb").iterdir())[0].name
    color = cv2.cvtColor(cv2.imread(str(data / "rgb" / frame)), cv2.COLOR_BGR2RGB)
    depth = cv2.imread(str(data / "depth" / frame), cv2.IMREAD_UNCHANGED) / 5000.0

    figure, axes = plt.subplots(1, 3, figsize=(15, 3.9), width_ratios=[4, 4, 4], layout="constrained")
    axes[0].imshow(color)
    axes[0].set_title("colour, as simulated")
    axes[1].imshow(np.where(depth > 0, depth, np.nan), cmap="turbo")
    axes[1].set_title("depth, 0 to %.1f m" % depth.max())
    for axis in axes[:2]:
        axis.axis("off")
    axes[2].plot(truth[:, 1], truth[:, 2], color="tab:red", lw=3, alpha=0.5, label="truth")
    axes[2].plot(aligned[:, 0], aligned[:, 1], color="tab:blue", lw=1, label="framewise run, frame to frame")
    axes[2].set_aspect("equal")
    axes[2].set_xlabel("x (m)")
    axes[2].set_ylabel("y (m)")
    axes[2].legend(loc="best", fontsize=8)
    e = run["evaluation"]
    axes[2].set_title("%d frames, %.1f m: ATE %.0f mm (%.2f %%)" % (
        run["frames"], e["path_length"], 1e3 * e["ate"]["rmse"], 100 * e["ate"]["rmse"] / e["path_length"]))
    figure.savefig(picture, dpi=110, pil_kwargs={"quality": 88})


if __name__ == "__main__":
    main(*sys.argv[1:])
