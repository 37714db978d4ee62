#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes of axes, depth, angles, scale and direction: each made on purpose on a simulated mine without light, and
the error that an evaluation then reports.

    tools/study_axes.py build/release/bin/framewise [FRAMES]

Prints the table of docs/axes.md. Needs numpy.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

OPTICAL_FROM_BLENDER = np.diag([1.0, -1.0, -1.0])  # x right, y down, z forward from x right, y up, z backward
ESSENTIAL = ["--solver", "opencv-essential", "--max-error-px", "1"]


def run(*arguments):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, arguments))}\n{done.stderr}")
    return done.stdout


def rotation_of(q):
    """Of a quaternion x y z w."""
    x, y, z, w = np.asarray(q) / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def quaternion_of(R):
    """x y z w: the eigenvector of Bar-Itzhack, New method for extracting the quaternion from a rotation matrix, 2000."""
    K = np.array([[R[0, 0] - R[1, 1] - R[2, 2], 0, 0, 0], [R[0, 1] + R[1, 0], R[1, 1] - R[0, 0] - R[2, 2], 0, 0],
                  [R[0, 2] + R[2, 0], R[1, 2] + R[2, 1], R[2, 2] - R[0, 0] - R[1, 1], 0],
                  [R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1], np.trace(R)]])
    return np.linalg.eigh(K, UPLO="L")[1][:, -1]


def axis_rotations(angles):
    (sx, sy, sz), (cx, cy, cz) = np.sin(angles), np.cos(angles)
    return (np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]]), np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]]),
            np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]]))


def euler_xyz_of(R):
    """Blender's XYZ: R = Rz Ry Rx."""
    return np.array([np.arctan2(R[2, 1], R[2, 2]), np.arcsin(np.clip(-R[2, 0], -1, 1)), np.arctan2(R[1, 0], R[0, 0])])


def read_poses(path):
    """[(time, R, t)] of world_from_cam."""
    rows = [line.split() for line in path.read_text().splitlines() if line and line[0] != "#"]
    return [(float(r[0]), rotation_of([float(v) for v in r[4:8]]), np.array([float(v) for v in r[1:4]])) for r in rows]


def write_poses(path, poses):
    path.write_text("".join(" ".join(repr(float(v)) for v in (time, *t, *quaternion_of(R))) + "\n" for time, R, t in poses))
    return path


def integrated(poses, change):
    """The trajectory whose steps (R, t), cam1_from_cam2, were changed."""
    world = [poses[0]]
    for (_, R1, t1), (time, R2, t2) in zip(poses, poses[1:]):
        R, t = change(R1.T @ R2, R1.T @ (t2 - t1))
        world.append((time, world[-1][1] @ R, world[-1][1] @ t + world[-1][2]))
    return world


def euler_read_in_the_other_order(R):
    Rx, Ry, Rz = axis_rotations(euler_xyz_of(R @ OPTICAL_FROM_BLENDER.T))
    return Rx @ Ry @ Rz @ OPTICAL_FROM_BLENDER


class Study:
    def __init__(self, framewise, folder, frames):
        self.framewise, self.folder = framewise, folder
        self.data, self.ranges = folder / "mine", folder / "mine_range"
        common = ["simulate", "mine", "--frames", frames, "--width", 320, "--height", 240, "--depth", "kinect", "--quiet"]
        run(framewise, *common, "--out", self.data)
        run(framewise, *common, "--depth-type", "range", "--out", self.ranges)
        self.truth = self.data / "groundtruth.txt"

    def odometry(self, data, name, *options):
        out = self.folder / name
        run(self.framewise, "run", data, "--input", "normal", "--out", out, "--no-report", "--quiet", *options)
        return out / "trajectory.tum"

    def errors(self, truth, estimate, align):
        return json.loads(run(self.framewise, "evaluate", truth, estimate, "--align", align, "--json"))

    def row(self, mistake, truth, estimate):
        ates = [self.errors(truth, estimate, align)["ate"]["rmse"] for align in ("origin", "se3", "sim3")]
        rpe = self.errors(truth, estimate, "se3")["rpe"]
        print(f"| {mistake} | " + " | ".join(f"{ate:.3f}" for ate in ates)
              + f" | {1000 * rpe['translation']['rmse']:.1f} | {rpe['rotation_deg']['rmse']:.3f} |", flush=True)

    def changed_truth(self, name, change):
        return write_poses(self.folder / name, [(time, change(R), t) for time, R, t in read_poses(self.truth)])

    def table(self):
        right = self.odometry(self.data, "right")
        poses = read_poses(right)
        static = self.errors(self.truth, right, "se3")
        print(f"path {static['path_length']:.2f} m, coverage {static['coverage']:.2f}\n")
        print("| mistake | ATE origin, m | ATE SE3, m | ATE Sim3, m | RPE, mm | RPE, deg |\n|---|---|---|---|---|---|")
        self.row("none: surfaces", self.truth, right)
        self.row("truth in Blender's axes", self.changed_truth("blender.tum", lambda R: R @ OPTICAL_FROM_BLENDER), right)
        half = integrated(poses, lambda R, t: (R, OPTICAL_FROM_BLENDER @ t))
        self.row("axes converted in the translations of steps alone", self.truth, write_poses(self.folder / "half.tum", half))
        self.row("truth's Euler angles XYZ read as ZYX", self.changed_truth("euler.tum", euler_read_in_the_other_order), right)
        back = integrated(poses, lambda R, t: (R.T, -R.T @ t))
        self.row("steps the other way round", self.truth, write_poses(self.folder / "back.tum", back))
        self.row("none: depth stored as range", self.truth, self.odometry(self.ranges, "range"))
        as_z = ["--depth-type", "z", "--depth-factor", 65535 / self.greatest_range()]
        self.row("range taken for z", self.truth, self.odometry(self.ranges, "range_as_z", *as_z))
        self.row("none: essential matrix, scale from depth", self.truth,
                 self.odometry(self.data, "essential", *ESSENTIAL, "--scale", "depth"))
        self.row("unit translations taken for metres", self.truth,
                 self.odometry(self.data, "unit", *ESSENTIAL, "--scale", "none"))

    def greatest_range(self):
        lines = (self.ranges / "camera.yaml").read_text().splitlines()
        return next(float(line.split(":")[1]) for line in lines if line.startswith("depth_max"))


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        Study(sys.argv[1], pathlib.Path(folder), sys.argv[2] if len(sys.argv) == 3 else 120).table()


if __name__ == "__main__":
    main()
