#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""The default odometer on simulated recordings, and on the real ones in ../shared/data where they are: the tables of
docs/odometer.md.

    pip install numpy opencv-python
    bench/odometry.py build/release/bin/framewise FOLDER                    # all groups, a row a recording
    bench/odometry.py build/release/bin/framewise FOLDER race large         # some
    bench/odometry.py build/release/bin/framewise FOLDER -- --shrink false  # with options of framewise run
    bench/odometry.py build/release/bin/framewise FOLDER --ablation         # a row a part of the odometer left out

Recordings that are not in FOLDER are simulated into it first, or made from others (recordings.py; 4 GiB in all). A row
says how many frames were measured, ATE of the causal and the final trajectory, its share of the path, the relative
error a frame and over one second (all pairs), NEES of the steps (mean and median over frames of the mean of its six
numbers; 1 is right) and frames a second with decoding.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import sys

import numpy as np

import recordings as made

KINECT = ["--depth", "kinect", "--photons", 2000]
SEEN = [(kind, seed, noise) for kind, noise in (("kinect", KINECT), ("exact", [])) for seed in (1, 2, 3)]
BLURRED = ["--frames", 90, "--exposure-time", 0.01]
HZ_3, HZ_1_5 = ["--frames", 90, "--rate", 3, *KINECT], ["--frames", 60, "--rate", 1.5, *KINECT]
MINE = ["--headlamp", 12]
REAL = pathlib.Path(__file__).resolve().parents[2] / "shared" / "data"

# group -> recording -> scene and options of framewise simulate; or a folder; or how it is made from another
GROUPS = {
    "room": {f"room_{kind}_{seed}": ["room", "--seed", seed, "--frames", 150, *noise] for kind, seed, noise in SEEN},
    "corridor": {f"corridor_{kind}_{seed}": ["corridor", "--seed", seed, "--frames", 150, *noise]
                 for kind, seed, noise in SEEN},
    "race": {f"race_{kind}_{seed}": ["race", "--seed", seed, *BLURRED, *noise] for kind, seed, noise in SEEN},
    "others": {f"{scene}_kinect_{seed}": [scene, "--seed", seed, *(BLURRED if scene == "race" else ["--frames", 150]), *KINECT]
               for scene in ("room", "corridor", "race") for seed in (21, 22, 23)},
    "large": {"corridor_3hz_12": ["corridor", "--seed", 12, *HZ_3],
              "corridor_3hz_31": ["corridor", "--seed", 31, *HZ_3],
              "mine_3hz_33": ["mine", "--seed", 33, *HZ_3, *MINE],
              "room_1.5hz_11": ["room", "--seed", 11, *HZ_1_5],
              "room_1.5hz_34": ["room", "--seed", 34, *HZ_1_5],
              "room_3hz_35": ["room", "--seed", 35, *HZ_3]},
    "shutter": {"room_shutter_1": ["room", "--seed", 1, "--frames", 150, "--rolling-shutter", 0.02, *KINECT]},
    "standing": {"standing": ["room", "--frames", 1000, "--width", 320, "--height", 240, "--depth", "kinect",
                              "--photons", 1000]},
    "real": {"fr1_rpy": REAL / "tum_fr1_rpy_000_080", "kitchen": REAL / "7scenes_redkitchen_000_150",
             "kitti_07": REAL / "kitti07_160"},
}
GROUPS["holes"] = {f"{name}_holes": (made.with_holes, name) for name in
                   ("corridor_3hz_12", "corridor_3hz_31", "mine_3hz_33", "room_1.5hz_34", "room_3hz_35")}
GROUPS["events"] = {
    "room_black": (made.darkened, "room_kinect_1", 60, 90),
    "corridor_black": (made.darkened, "corridor_kinect_1", 60, 90),
    "room_wall": (made.behind_wall, "room_kinect_1", 60),
    "room_gap": (made.with_gap, "room_kinect_1", 60, 75),
    "corridor_gap": (made.with_gap, "corridor_kinect_1", 60, 75),
    "room_no_depth": (made.darkened, "room_kinect_1", 60, 110, False),
    "corridor_no_depth": (made.darkened, "corridor_kinect_1", 60, 110, False),
    "race_black": (made.darkened, "race_kinect_1", 30, 50),
    "room_black_mono": (made.darkened, "room_kinect_1_mono", 60, 90),
    "room_gap_mono": (made.with_gap, "room_kinect_1_mono", 60, 75),
}
GROUPS["mono"] = {f"{name}_mono": (made.without_depth, name) for name in
                  ("room_kinect_1", "room_kinect_2", "corridor_kinect_1", "corridor_kinect_2", "race_exact_1", "race_exact_3",
                   "corridor_3hz_12", "mine_3hz_33", "room_3hz_35", "room_1.5hz_11", "room_1.5hz_34")}
# speed (m/s), least radius (m), seed
ROADS = {"motorway_30": (30, 700, 1), "motorway_22": (22, 180, 1), "motorway_25": (25, 400, 2),
         "motorway_33": (33, 1000, 3), "motorway_20": (20, 120, 4)}
GROUPS["motorway"] = {f"{name}_mono": (made.without_depth, name) for name in ROADS}
GROUPS["kitti"] = {f"kitti_{every}_{first}": (made.of_kitti, "kitti_07", range(first, 160, every))
                   for every, first in ((2, 0), (3, 0), (4, 0), (4, 2), (5, 0), (5, 2), (6, 0), (7, 0), (8, 0))}
GROUPS["kitti"] |= {"kitti_from_48": (made.of_kitti, "kitti_07", range(48, 160)),
                    "kitti_stands": (made.of_kitti, "kitti_07", [*range(50), *40 * [50], *range(51, 120)]),
                    "kitti_10_black": (made.of_kitti, "kitti_07", range(160), range(60, 70)),
                    "kitti_30_black": (made.of_kitti, "kitti_07", range(160), range(60, 90))}

ABLATION = {
    "the default": [],
    "reference: the frame before": ["--solver", "kabsch"],
    "reference: the last keyframe alone": ["--newest-keyframes", 1, "--other-keyframes", 0],
    "prior: none": ["--shrink", "false"],
    "weighting: depth of one frame alone": ["--fuse", "false"],
    "refinement: no planes": ["--plane-reach-px", 0],
    "refinement: looked for once": ["--look-again-px", 1000],
    "window: never": ["--adjust", "never"],
    "window: always": ["--adjust", "always"],
    "rolling shutter: none": ["--unskew", "false"],
    "late depth: none": ["--follow-delay", "false"],
}
ABLATION_GROUPS = ("fr1_rpy", "kitchen", "room", "corridor", "race", "large")


def command(*arguments):
    """What it prints. Exit code 1 is a recording of which nothing was measured: it has its files all the same."""
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{' '.join(map(str, arguments))}\n{done.stderr}")
    return done.stdout


def standing_still(folder):
    """A file of poses that are all the same: looking along the room."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "standing_still.txt"
    file.write_text("".join(f"{time} 4.5 2.9 1.5 0.34 0.68 -0.58 -0.29\n" for time in range(40)))
    return file


def options_of_road(folder, name):
    speed, least_radius, seed = ROADS[name]
    mesh, path = made.motorway(folder / f"{name}_mesh", speed, least_radius, seed=seed)
    return ["--mesh", mesh, "--path", path, "--rate", 10, "--photons", 2000, "--width", 1240, "--height", 376,
            "--depth-max", 200]


def recording(framewise, folder, name):
    """Its folder, made first where that is needed; None where a real one it needs is not there."""
    data = folder / name
    made_by = None if name in ROADS else next(group[name] for group in GROUPS.values() if name in group)
    if isinstance(made_by, pathlib.Path):
        return made_by if made_by.is_dir() else None
    if isinstance(made_by, tuple):
        make, source, *arguments = made_by
        source = recording(framewise, folder, source)
        if source and not data.exists():
            make(source, data, *arguments)
        return source and data
    if not (data / "simulation.json").exists():
        path = ["--path", standing_still(folder)] if name == "standing" else []
        command(framewise, "simulate", *(made_by or options_of_road(folder, name)), *path, "--out", data, "--quiet")
    return data


def recordings(framewise, folder, group):
    for name in GROUPS[group]:
        if data := recording(framewise, folder, name):
            yield name, data
        else:
            print(f"{name}: skipped, {REAL} lacks what it is made of", file=sys.stderr)


def rotations(quaternions):
    x, y, z, w = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return np.moveaxis(np.array(rows), 2, 0)


def steps(trajectory):
    """Rotation and translation of cam1_from_cam2 of each two poses that follow one another (N x 8 in TUM's order)."""
    R, p = rotations(trajectory[:, 4:8]), trajectory[:, 1:4]
    inverse = np.swapaxes(R[:-1], 1, 2)
    return inverse @ R[1:], np.einsum("nij,nj->ni", inverse, p[1:] - p[:-1])


def rotation_vectors(R):
    sines = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], 1) / 2
    sine = np.linalg.norm(sines, axis=1)
    angle = np.arctan2(sine, (np.trace(R, axis1=1, axis2=2) - 1) / 2)
    return sines * np.where(sine > 1e-12, angle / np.maximum(sine, 1e-12), 1)[:, None]


def nees_of_steps(data, out):
    """A step's squared error over its covariance, over its six numbers, of each simulated frame that is `ok`."""
    if not (data / "simulation.json").exists() or not (data / "depth.txt").exists():
        return []
    truth, estimate = np.loadtxt(data / "groundtruth.txt"), np.loadtxt(out / "trajectory.tum", ndmin=2)
    nearest = np.abs(truth[:, 0][None, :] - estimate[:, 0][:, None]).argmin(axis=1)
    (true_R, true_t), (R, t) = steps(truth[nearest]), steps(estimate)
    errors = np.hstack([rotation_vectors(np.swapaxes(R, 1, 2) @ true_R), true_t - t])
    with (out / "frames.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))[1:]
    names = [name for name in rows[0] if name.startswith("cov_")]
    values = []
    for row, error in zip(rows, errors, strict=True):
        if row["status"] == "ok" and row[names[0]]:
            covariance = np.zeros((6, 6))
            covariance[np.triu_indices(6)] = [float(row[name]) for name in names]
            covariance += np.triu(covariance, 1).T
            values.append(error @ np.linalg.solve(covariance, error) / 6)
    return values


def measure(framewise, folder, name, data, options):
    out = folder / "out" / name
    command(framewise, "run", data, "--out", out, "--no-report", "--quiet", *options)
    run = json.loads((out / "run.json").read_text())
    causal, final = run["evaluation"], run.get("evaluation_final") or run["evaluation"]
    has_depth = run["dataset"]["frames_with_depth"] > 0
    slow = name in GROUPS["large"] or name in GROUPS["holes"]
    second = [] if not has_depth or slow else command(
        framewise, "evaluate", data, out / "trajectory.tum", "--delta", 1, "--unit", "seconds", "--pairs", "all", "--json")
    return {"run": run, "ate": causal["ate"]["rmse"], "final": final["ate"]["rmse"], "path": causal["path_length"],
            "rpe": causal["rpe"], "second": json.loads(second)["rpe"] if second else None,
            "nees": nees_of_steps(data, out)}


def mm_deg(rpe):
    return f"{1000 * rpe['translation']['rmse']:.2f}, {rpe['rotation_deg']['rmse']:.3f}" if rpe else ""


def table(framewise, folder, groups, options):
    print("| recording | measured | ATE mm: causal, final | of the path | a frame: mm, deg | a second | NEES: mean, median | frames a second |")
    print("|---|---|---|---|---|---|---|---|")
    for group in groups:
        rows = []
        for name, data in recordings(framewise, folder, group):
            row = measure(framewise, folder, name, data, options)
            rows.append(row)
            statuses = ", ".join(f"{count} {status}" for status, count in row["run"]["statuses"].items() if count)
            nees = f"{np.mean(row['nees']):.2f}, {np.median(row['nees']):.2f}" if row["nees"] else ""
            print(f"| {name} | {statuses} | {1000 * row['ate']:.2f}, {1000 * row['final']:.2f} "
                  f"| {row['ate'] / row['path'] if row['path'] else 0:.4%} | {mm_deg(row['rpe'])} | {mm_deg(row['second'])} | {nees} "
                  f"| {row['run']['frames_per_second']:.1f} |", flush=True)
        if len(rows) > 1 and group not in ("real", "events"):
            print(f"| **{group}**, geometric means | | {1000 * geometric_mean(rows, 'ate'):.2f}, "
                  f"{1000 * geometric_mean(rows, 'final'):.2f} | | {1000 * mean_step(rows, 'translation'):.2f}, "
                  f"{mean_step(rows, 'rotation_deg'):.4f} | | {mean_nees(rows)} | |")


def geometric_mean(rows, key):
    return float(np.exp(np.mean([np.log(row[key]) for row in rows])))


def mean_step(rows, key):
    return float(np.exp(np.mean([np.log(row["rpe"][key]["rmse"]) for row in rows])))


def mean_nees(rows):
    means = [np.mean(row["nees"]) for row in rows if row["nees"]]
    return f"{np.mean(means):.2f}" if means else ""


def ablation(framewise, folder):
    """Geometric means of ATE in mm, and how many frames were not measured; with the step's error of a real one."""
    print(f"| | {' | '.join(ABLATION_GROUPS)} |\n|---|{'---|' * len(ABLATION_GROUPS)}")
    for part, options in ABLATION.items():
        cells = []
        for group in ABLATION_GROUPS:
            listed = dict(recordings(framewise, folder, group if group in GROUPS else "real"))
            chosen = listed if group in GROUPS else {name: data for name, data in listed.items() if name == group}
            rows = [measure(framewise, folder, name, data, options) for name, data in chosen.items()]
            missed = sum(row["run"]["frames"] * (1 - row["run"]["measured"]) for row in rows)
            cell = f"{1000 * geometric_mean(rows, 'ate'):.2f}" if rows else ""
            cells.append(cell + (f", {mm_deg(rows[0]['rpe'])}" if rows and group not in GROUPS else "") +
                         (f"; {missed:.0f} not measured" if round(missed) else ""))
        print(f"| {part} | {' | '.join(cells)} |", flush=True)


def main():
    arguments, options = sys.argv[1:], []
    if "--" in arguments:
        arguments, options = arguments[:arguments.index("--")], arguments[arguments.index("--") + 1:]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("framewise", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("groups", nargs="*", help=", ".join(GROUPS))
    parser.add_argument("--ablation", action="store_true")
    given = parser.parse_args(arguments)
    if unknown := [group for group in given.groups if group not in GROUPS]:
        parser.error(f"{unknown[0]} is none of {', '.join(GROUPS)}")
    if given.ablation:
        ablation(given.framewise, given.folder)
    else:
        table(given.framewise, given.folder, given.groups or GROUPS, options)


if __name__ == "__main__":
    main()
