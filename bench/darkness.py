#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""From daylight to black: odometry from colour, from depth, and from whichever `--input auto` chooses, on simulated
recordings that differ in light alone.

    bench/darkness.py build/release/bin/framewise [SCENE [SEED [FRAMES]]]

The level is the number of electrons in a pixel that is just white. A Kinect's depth sees as well at every level.
Prints one row a level: RMSE of ATE (SE3) and of RPE (one frame), and the share of frames in which auto took colour.
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile

LEVELS = (None, 10000, 1000, 300, 100, 30, 10, 3, 1, 0.3)  # None: no noise
READ_NOISE = 2  # electrons, of reading a pixel


def run(*arguments):
    """Exit code 1 is a recording that was lost throughout: it has its figures all the same."""
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{' '.join(map(str, arguments))}\n{done.stderr}")


def errors(framewise, data, out, method):
    """ATE (m), RPE (mm, deg), share of frames whose features are colour's."""
    run(framewise, "run", data, "--out", out, "--input", method, "--no-report", "--quiet")
    evaluation = json.loads((out / "run.json").read_text())["evaluation"]
    with (out / "frames.csv").open(newline="") as file:
        inputs = [row["input"] for row in csv.DictReader(file)]
    rpe = evaluation["rpe"]
    return (evaluation["ate"]["rmse"], 1000 * rpe["translation"]["rmse"], rpe["rotation_deg"]["rmse"],
            inputs.count("color") / len(inputs))


def main():
    if not 2 <= len(sys.argv) <= 5:
        sys.exit(__doc__)
    framewise, scene, seed, frames = (sys.argv[1:] + ["room", "0", "60"][len(sys.argv) - 2:])
    print(f"{scene}, seed {seed}, {frames} frames\n")
    print("| electrons | colour: mm, deg, ATE m | depth | auto | auto / better: mm, deg, ATE | auto took colour |")
    print("|---|---|---|---|---|---|")
    for level in LEVELS:
        with tempfile.TemporaryDirectory() as folder:
            data = pathlib.Path(folder) / "data"
            noise = ["--photons", level, "--read-noise", READ_NOISE] if level else []
            run(framewise, "simulate", scene, "--seed", seed, "--frames", frames, "--width", 320, "--height", 240,
                "--depth", "kinect", *noise, "--out", data, "--quiet")
            color, depth, auto = (errors(framewise, data, pathlib.Path(folder) / method, method)
                                  for method in ("color", "normal", "auto"))
        cells = [f"{mm:.2f}, {deg:.3f}, {ate:.4f}" for ate, mm, deg, _ in (color, depth, auto)]
        ratios = [auto[k] / min(color[k], depth[k]) for k in (1, 2, 0)]
        print(f"| {level or 'no noise'} | {' | '.join(cells)} | {', '.join(f'{r:.2f}' for r in ratios)} | {auto[3]:.0%} |",
              flush=True)


if __name__ == "__main__":
    main()
