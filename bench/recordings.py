# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""Recordings made from others for bench/odometry.py: darkness, gaps and holes put into them, their depth or most of
their frames taken away; and a motorway, which `framewise simulate` has no scene of."""

import pathlib
import shutil

import cv2
import numpy as np

FRAMES_OF_WALL = 200
SHAPE = 480, 640


class Recording:
    """A TUM folder's lists, to be changed and written elsewhere: images stay where they are, new ones are in `new`."""

    def __init__(self, source, folder):
        self.source, self.folder = source.resolve(), folder
        shutil.rmtree(folder, ignore_errors=True)
        (folder / "new").mkdir(parents=True)
        self.rgb, self.depth = self.rows("rgb.txt"), self.rows("depth.txt")

    def rows(self, name):
        file = self.source / name
        lines = file.read_text().splitlines() if file.exists() else []
        return [line.split() for line in lines if not line.startswith("#")]

    def new(self, name, image):
        cv2.imwrite(str(self.folder / "new" / name), image)
        return f"new/{name}"

    def write(self):
        for name in ("camera.yaml", "groundtruth.txt", "simulation.json"):
            shutil.copy(self.source / name, self.folder)
        for name, rows in (("rgb", self.rgb), ("depth", self.depth)):
            if rows:
                (self.folder / name).symlink_to(self.source / name)
                (self.folder / f"{name}.txt").write_text("".join(" ".join(row) + "\n" for row in rows))


def without_depth(source, folder):
    recording = Recording(source, folder)
    recording.depth = []
    recording.write()


def darkened(source, folder, begin, end, color=True, depth=True):
    """Images of zeros from frame `begin` to before `end`."""
    recording = Recording(source, folder)
    if color:
        black = recording.new("color.png", np.zeros((*SHAPE, 3), np.uint8))
        recording.rgb[begin:end] = [[time, black] for time, _ in recording.rgb[begin:end]]
    if depth and recording.depth:
        nothing = recording.new("depth.png", np.zeros(SHAPE, np.uint16))
        recording.depth[begin:end] = [[time, nothing] for time, _ in recording.depth[begin:end]]
    recording.write()


def with_gap(source, folder, begin, end):
    recording = Recording(source, folder)
    del recording.rgb[begin:end]
    del recording.depth[begin:end]
    recording.write()


def behind_wall(source, folder, begin):
    """200 frames of a white wall 1.5 m away before frame `begin`; the camera stands until then."""
    recording, random = Recording(source, folder), np.random.default_rng(1)
    times = [float(time) for time, _ in recording.rgb]
    period = times[1] - times[0]
    deep = recording.new("wall.png", np.full(SHAPE, 7500, np.uint16))
    white = [recording.new(f"wall_{k}.png", np.clip(random.normal(200, 4, (*SHAPE, 3)), 0, 255).astype(np.uint8))
             for k in range(FRAMES_OF_WALL)]
    for rows, images in ((recording.rgb, white), (recording.depth, FRAMES_OF_WALL * [deep])):
        later = [[f"{float(time) + FRAMES_OF_WALL * period:.6f}", name] for time, name in rows[begin:]]
        rows[begin:] = [[f"{times[begin] + k * period:.6f}", image] for k, image in enumerate(images)] + later
    recording.write()
    truth = np.loadtxt(source / "groundtruth.txt")
    stood = truth[truth[:, 0] < times[begin] - period / 2][-1]
    shifted = truth[truth[:, 0] > times[begin] - period / 2] + np.eye(8)[0] * FRAMES_OF_WALL * period
    wait = np.tile(stood, (FRAMES_OF_WALL, 1))
    wait[:, 0] = times[begin] + period * np.arange(FRAMES_OF_WALL)
    np.savetxt(folder / "groundtruth.txt", np.vstack([truth[truth[:, 0] < wait[0, 0] - period / 2], wait, shifted]), "%.9f")


def with_holes(source, folder, share=0.5):
    """Ten ellipses a frame, larger until `share` of the known depths are gone; the farthest tenth goes first."""
    recording = Recording(source, folder)
    for i, (_, name) in enumerate(recording.depth):
        depth, random = cv2.imread(str(source / name), cv2.IMREAD_UNCHANGED), np.random.default_rng(i)
        known = np.count_nonzero(depth)
        if known:
            depth[depth > np.quantile(depth[depth > 0], 0.9)] = 0
        centres, axes, angles = random.uniform((0, 0), (640, 480), (10, 2)), random.uniform(0.3, 1, (10, 2)), random.uniform(0, 180, 10)
        for size in range(20, 400, 10):
            if np.count_nonzero(depth) <= (1 - share) * known:
                break
            for centre, axis, angle in zip(centres, axes, angles):
                cv2.ellipse(depth, tuple(map(int, centre)), tuple(map(int, size * axis)), angle, 0, 360, 0, -1)
        recording.depth[i][1] = recording.new(f"depth_{i:06d}.png", depth)
    recording.write()


def of_kitti(source, folder, chosen, black=()):
    """The frames of a KITTI sequence with one camera that `chosen` names, some of them black."""
    shutil.rmtree(folder, ignore_errors=True)
    images = next(path for path in sorted(source.iterdir()) if path.is_dir())
    (folder / images.name).mkdir(parents=True)
    shutil.copy(source / "calib.txt", folder)
    names = sorted(images.iterdir())
    times, poses = ((source / name).read_text().splitlines() for name in ("times.txt", "poses.txt"))
    stands = len(set(chosen)) < len(chosen)  # a frame that is shown again comes later
    (folder / "times.txt").write_text("".join((times[k] if stands else times[i]) + "\n" for k, i in enumerate(chosen)))
    (folder / "poses.txt").write_text("".join(poses[i] + "\n" for i in chosen))
    shape = cv2.imread(str(names[0]), cv2.IMREAD_UNCHANGED).shape
    for k, i in enumerate(chosen):
        image = folder / images.name / f"{k:06d}.png"
        if k in black:
            cv2.imwrite(str(image), np.zeros(shape, np.uint8))
        else:
            image.symlink_to(names[i].resolve())


class Quads:
    """Rectangles of one colour each, as a PLY file."""

    def __init__(self):
        self.corners, self.colors = [], []

    def add(self, corners, color):
        """corners: N x 4 x 3, color: N x 3 of 0 to 1."""
        self.corners.append(corners)
        self.colors.append(np.broadcast_to(color, (len(corners), 3)))

    def write(self, file):
        corners, colors = np.concatenate(self.corners), np.concatenate(self.colors)
        vertices = np.empty(4 * len(corners), [("p", "<f4", 3), ("c", "u1", 3)])
        vertices["p"] = corners.reshape(-1, 3)
        vertices["c"] = np.repeat(np.clip(255 * colors, 0, 255), 4, axis=0)
        faces = np.empty(len(corners), [("n", "u1"), ("v", "<i4", 4)])
        faces["n"], faces["v"] = 4, np.arange(4 * len(corners)).reshape(-1, 4)
        properties = "".join(f"property float {axis}\n" for axis in "xyz") + "".join(
            f"property uchar {name}\n" for name in ("red", "green", "blue"))
        header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n{properties}"
                  f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
        file.write_bytes(header.encode() + vertices.tobytes() + faces.tobytes())


def motorway(folder, speed, least_radius, seconds=9, rate=10, seed=1):
    """A mesh of a road in bends with lanes, grass, rails, trees and hills, and the poses of a car on it: two files."""
    random, quads = np.random.default_rng(seed), Quads()
    length = speed * seconds + 400
    s = np.arange(-50, length, 0.5)
    heading = np.concatenate([[0], np.cumsum(np.sin(2 * np.pi * s / 390) / least_radius)[:-1] * 0.5])
    road = np.cumsum(np.stack([np.cos(heading), np.sin(heading)], 1) * 0.5, axis=0)

    def at(along, across, height):
        """Points of the world; along (m) of the road, across to its left."""
        centre = np.stack([np.interp(along, s, road[:, k]) for k in (0, 1)], -1)
        angle = np.interp(along, s, heading)
        left = np.stack([-np.sin(angle), np.cos(angle)], -1)
        xy = centre + np.asarray(across)[..., None] * left
        return np.concatenate([xy, np.broadcast_to(np.asarray(height, float)[..., None], xy.shape[:-1] + (1,))], -1)

    def strip(first, last, along_step, across_step, color, spread, bumps=0.0):
        a, c = np.meshgrid(np.arange(s[0], s[-1] - along_step, along_step), np.arange(first, last - 1e-6, across_step))
        a, c = a.ravel(), c.ravel()
        ends = [(0, 0), (1, 0), (1, 1), (0, 1)]
        along, across = (np.stack([base + step * end[k] for end in ends], 1)
                         for k, (base, step) in enumerate(((a, along_step), (c, across_step))))
        height = bumps * (np.sin(1.3 * along + 2 * across) + np.sin(0.7 * along - 1.1 * across))
        quads.add(at(along, across, height), np.array(color) * (1 + spread * random.standard_normal((len(a), 1))))

    def upright(along, across, width, bottom, top, color, along_road=False):
        """Rectangles that stand: across the road, or along it."""
        along, across, bottom, top = (np.asarray(x, float)[:, None] for x in (along, across, bottom, top))
        half = np.asarray(width, float).reshape(-1, 1) / 2 * np.array([-1, 1, 1, -1])
        heights = np.where(np.array([1, 1, 0, 0]), bottom, top)
        quads.add(at(along + half * along_road, across + half * (not along_road), heights), color)

    strip(-8, 8, 0.4, 0.4, (0.3, 0.3, 0.31), 0.08)
    for side in (-1, 1):
        strip(min(side * 8, side * 60), max(side * 8, side * 60), 1.5, 1.5, (0.25, 0.4, 0.15), 0.2, bumps=0.08)
    def paint(across, every, length, width, gray):
        """Lines just above the road."""
        begin = np.arange(s[0], s[-1] - length, every)
        quads.add(np.stack([at(begin + a, np.full_like(begin, across + c), np.full_like(begin, 0.01))
                            for a, c in ((0, -width / 2), (length, -width / 2), (length, width / 2), (0, width / 2))], 1),
                  (gray, gray, gray))

    for across in (-3.75, 0, 3.75):
        paint(across, every=12, length=6, width=0.16, gray=0.85)
    for across in (-7.6, 7.6):
        paint(across, every=2, length=2, width=0.2, gray=0.8)
        begin = np.arange(s[0], s[-1] - 4, 4.0)
        rail = np.full_like(begin, across * 1.25)
        upright(begin + 2, rail, np.full_like(begin, 4.0), np.full_like(begin, 0.45), np.full_like(begin, 0.75),
                0.5 + 0.05 * random.standard_normal((len(begin), 1)) * np.ones(3), along_road=True)
        upright(begin, rail, np.full_like(begin, 0.12), np.zeros_like(begin), np.full_like(begin, 0.75), (0.35, 0.33, 0.3))
    for count, nearest, farthest, tall, color in ((int(length / 5), 13, 55, 9, (0.12, 0.3, 0.1)),
                                                  (int(length / 60), 11, 13, 3.5, (0.2, 0.3, 0.7))):  # trees and signs
        along, side = random.uniform(s[0], s[-1], count), random.choice((-1, 1), count)
        across, height = side * random.uniform(nearest, farthest, count), tall * random.uniform(0.6, 1.2, count)
        for _ in range(40):  # leaves, letters
            up = random.uniform(0.25, 1, count)
            wide = 0.28 * height * np.sqrt(1.05 - up)
            offset = random.uniform(-1, 1, count) * wide
            size = random.uniform(0.3, 0.9, count)
            upright(along + random.uniform(-1, 1, count) * wide * (tall > 5), across + offset, size, height * up, height * up + size,
                    np.array(color) * random.uniform(0.5, 1.8, (count, 1)))
        upright(along, across, 0.05 * height, np.zeros(count), height * 0.5, (0.25, 0.17, 0.1))
    turn = np.linspace(0, 2 * np.pi, 241)
    middle = road.mean(axis=0)
    for distance, top in ((800, 60), (1100, 110)):
        ridge = distance * 0.02 + top * (0.5 + 0.3 * np.sin(5 * turn + distance) + 0.2 * np.sin(23 * turn))
        for low, high in zip(np.linspace(0, 0.9, 10), np.linspace(0.1, 1, 10)):
            ring = np.stack([np.cos(turn), np.sin(turn)], 1) * distance + middle
            corners = np.stack([np.column_stack([ring[:-1], low * ridge[:-1]]), np.column_stack([ring[1:], low * ridge[1:]]),
                                np.column_stack([ring[1:], high * ridge[1:]]), np.column_stack([ring[:-1], high * ridge[:-1]])], 1)
            quads.add(corners, np.array((0.3, 0.38, 0.42)) * random.uniform(0.7, 1.3, (240, 1)))
    folder.mkdir(parents=True, exist_ok=True)
    quads.write(folder / "motorway.ply")
    poses = []
    for time in np.arange(0, seconds, 0.1 / rate):
        along = speed * time
        angle = float(np.interp(along, s, heading))
        x, y, z = at(np.array([along]), np.array([-1.9]), np.array([1.65 + 0.01 * np.sin(9 * time)]))[0]
        forward, left = np.array([np.cos(angle), np.sin(angle), 0]), np.array([-np.sin(angle), np.cos(angle), 0])
        nod = 0.004 * np.sin(7 * time)
        up = np.array([0, 0, 1]) * np.cos(nod) - forward * np.sin(nod)
        forward = forward * np.cos(nod) + np.array([0, 0, 1]) * np.sin(nod)
        poses.append([time, x, y, z, *quaternion(np.stack([-left, -up, forward], 1))])
    np.savetxt(folder / "motorway.txt", poses, "%.9f")
    return folder / "motorway.ply", folder / "motorway.txt"


def quaternion(R):
    """x y z w of a rotation by less than 180 degrees."""
    w = np.sqrt(1 + np.trace(R)) / 2
    return [(R[2, 1] - R[1, 2]) / (4 * w), (R[0, 2] - R[2, 0]) / (4 * w), (R[1, 0] - R[0, 1]) / (4 * w), w]
