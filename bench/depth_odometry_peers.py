#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""Depth-only odometry, frame to frame, by small_gicp and Open3D, on the frames of bench_depth_odometry.

    pip install small-gicp open3d opencv-python-headless
    bench/depth_odometry_peers.py RECORDING OUT     # a TUM or 7-Scenes recording
    framewise evaluate RECORDING OUT/small_gicp_gicp.tum

Writes one trajectory a method and prints the milliseconds a frame, decoding not counted.
"""

import pathlib
import sys
import time

import cv2
import numpy as np

FREIBURG1 = ((517.3, 516.5, 318.6, 255.3), (0.2624, -0.9531, -0.0054, 0.0026, 1.1633))
SEVEN_SCENES = ((585.0, 585.0, 320.0, 240.0), (0.0,) * 5)


def depth_files(folder):
    """Times, files, metres in one unit and the calibration."""
    if (folder / "depth.txt").exists():
        rows = [line.split() for line in (folder / "depth.txt").read_text().splitlines() if line[:1] not in "#"]
        return [(float(t), folder / name) for t, name in rows], 1 / 5000, FREIBURG1
    files = sorted(folder.glob("*.depth.png"))
    return [(i / 30, name) for i, name in enumerate(files)], 1 / 1000, SEVEN_SCENES


def cloud(name, unit, rays, step=2):
    raw = cv2.imread(str(name), cv2.IMREAD_UNCHANGED)
    z = raw[::step, ::step].astype(np.float64) * unit
    known = (raw[::step, ::step] > 0) & (raw[::step, ::step] < 65535)
    return (rays[::step, ::step] * z[..., None])[known]


def ray_table(calibration):
    (fx, fy, cx, cy), distortion = calibration
    K = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
    pixels = np.stack(np.meshgrid(np.arange(640.0), np.arange(480.0)), -1).reshape(-1, 1, 2)
    xy = cv2.undistortPoints(pixels, K, np.array(distortion)).reshape(480, 640, 2)
    return np.concatenate([xy, np.ones((480, 640, 1))], -1)


def small_gicp_method(kind):
    import small_gicp

    def step(target, source, guess):
        result = small_gicp.align(target[0], source[0], target[1], guess, registration_type=kind,
                                  max_correspondence_distance=0.1, num_threads=2)
        return result.T_target_source

    return lambda points: small_gicp.preprocess_points(points, 0.02, num_threads=2), step


def open3d_method():
    import open3d

    def prepare(points):
        made = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points)).voxel_down_sample(0.02)
        made.estimate_normals(open3d.geometry.KDTreeSearchParamHybrid(0.1, 30))
        return made

    def step(target, source, guess):
        registration = open3d.pipelines.registration
        return registration.registration_icp(source, target, 0.1, guess,
                                             registration.TransformationEstimationPointToPlane()).transformation

    return prepare, step


def main():
    folder, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    methods = {}
    for name, make in {"small_gicp_gicp": lambda: small_gicp_method("GICP"),
                       "small_gicp_plane": lambda: small_gicp_method("PLANE_ICP"),
                       "open3d_plane": open3d_method}.items():
        try:
            methods[name] = make()
        except ImportError as missing:
            print(f"{name}: left out ({missing})")
    frames, unit, calibration = depth_files(folder)
    rays = ray_table(calibration)
    clouds = [cloud(name, unit, rays) for _, name in frames]
    for name, (prepare, align) in methods.items():
        world, previous, lines, start = np.eye(4), None, [], time.perf_counter()
        for (stamp, _), points in zip(frames, clouds):
            current = prepare(points)
            if previous is not None:
                world = world @ align(previous, current, np.eye(4))
            previous = current
            lines.append((stamp, world.copy()))
        ms = 1e3 * (time.perf_counter() - start) / len(frames)
        with open(out / f"{name}.tum", "w") as file:
            for stamp, pose in lines:
                q = quaternion(pose[:3, :3])
                print(stamp, *pose[:3, 3], *q, file=file)
        print(f"{name}: {ms:.1f} ms a frame")


def quaternion(R):
    rotation, _ = cv2.Rodrigues(R)
    angle = np.linalg.norm(rotation)
    axis = rotation.ravel() / angle if angle > 0 else np.zeros(3)
    return (*np.sin(angle / 2) * axis, np.cos(angle / 2))


if __name__ == "__main__":
    main()
