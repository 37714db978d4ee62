#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""The figures and tables of docs/solver_study.md from what the two programs of the study print. Needs matplotlib.

    bench_study_solvers > grid.csv; bench_study_seed > seed.csv
    tools/plot_solver_study.py grid.csv seed.csv docs
"""

import csv
import pathlib
import statistics
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "framewise"  # the same bytes every time
import matplotlib.pyplot as plt

SOLVERS = ["eight-point", "seven-point", "nister-5pt", "stewenius-5pt", "kneip-5pt-rotation", "eigensolver"]
SCHEMES = ["two-stage/bearing-euclidean", "two-stage/reprojection", "robust"]


def rows_of(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for key, value in row.items():
            try:
                row[key] = float(value)
            except ValueError:
                pass
    return rows


def select(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def median(rows, column):
    values = [row[column] for row in rows if row[column] == row[column]]
    return statistics.median(values) if values else float("nan")


def mean(rows, column):
    return statistics.fmean(row[column] for row in rows)


def markdown(head, lines):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for line in lines:
        print("| " + " | ".join(line) + " |")
    print()


def table_by_inliers(grid):
    """Rotation error and failures over all motions with a step, by inlier share."""
    shares = sorted({row["inlier_percent"] for row in grid}, reverse=True)
    lines = []
    for scheme in SCHEMES:
        for solver in SOLVERS:
            cells = [select(grid, solver=solver, scheme=scheme, scene="depth", noise_px=0.5, rotation_deg=0.4,
                            inlier_percent=share) for share in shares]
            lines.append([scheme, f"`{solver}`"] + [f"{median(c, 'rotation_median_deg'):.3f} / "
                                                    f"{mean(c, 'failure_percent'):.0f}" for c in cells])
    markdown(["scheme", "solver"] + [f"{share:.0f} %" for share in shares], lines)


def table_by_motion(grid, solvers, scheme, column):
    motions = [("standing", 0.0)] + [(m, s) for m in ("sideways", "forward", "mixed") for s in (0.1, 0.5, 1.0, 5.0)]
    lines = []
    for motion, step in motions:
        cells = [[row for row in select(grid, motion=motion, step_percent=step, solver=solver, scheme=scheme, scene="depth",
                                        noise_px=0.5, rotation_deg=0.4) if row["inlier_percent"] >= 70]
                 for solver in solvers]
        lines.append([f"{motion} {step:g} %"] + [f"{median(c, column):.3g}" for c in cells])
    markdown(["motion"] + [f"`{s}`" for s in solvers], lines)


def plot_grid(grid, path):
    """Rotation error against the step, by scheme: one line a solver."""
    steps = [0.1, 0.5, 1.0, 5.0]
    figure, axes = plt.subplots(1, 3, figsize=(10, 3.6), sharey=True, layout="constrained")
    for axis, scheme in zip(axes, SCHEMES):
        for solver in SOLVERS:
            errors = [median([row for row in select(grid, scheme=scheme, solver=solver, scene="depth", noise_px=0.5,
                                                    rotation_deg=0.4, step_percent=step) if row["inlier_percent"] >= 70],
                             "rotation_median_deg") for step in steps]
            axis.plot(steps, errors, marker="o", markersize=3, label=solver)
        axis.axhline(0.4, color="0.5", linestyle=":", label="camera said to stand still")
        axis.set(xscale="log", yscale="log", title=scheme, xlabel="step (% of the depth)")
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("median rotation error (deg)")
    axes[2].legend(fontsize=7)
    figure.savefig(path, metadata={"Date": None})


def plot_kneip(seed, path):
    """What each suspicion costs Kneip's solver, beside the published figures."""
    def rms(experiment, variant, **more):
        return select(seed, experiment=experiment, variant=variant, **more)[0]["rms_deg"]

    small = {"step_percent": 0.7}
    bars = [("framewise, 8 bearings", rms("scheme", "framewise/reprojection", inlier_percent=70.0, **small)),
            ("wrong way round", rms("inverse-convention", "-", rotation_deg=0.4)),
            ("opengv, 5 bearings", rms("scheme", "opengv/reprojection", inlier_percent=70.0, **small)),
            ("opengv, one outlier in 8", rms("residual-outliers", "opengv", parameter=1.0, **small)),
            ("opengv, first solution", rms("choice", "opengv/first", **small)),
            ("opengv, 8 bearings (overrun)", rms("scheme", "opengv overrun/reprojection", inlier_percent=70.0, **small)),
            ("the same over 30 frames", select(seed, experiment="scheme", variant="opengv overrun/reprojection",
                                               inlier_percent=70.0, **small)[0]["figure"])]
    figure, axis = plt.subplots(figsize=(8, 3.2), layout="constrained")
    axis.barh([name for name, _ in bars], [value for _, value in bars], color="tab:blue")
    for low, high, name in ((113.1, 116.1, "published, PUTKK"), (130.9, 132.8, "published, fr3 office")):
        axis.axvspan(low, high, color="tab:red", alpha=0.4)
        axis.text(low - 1, 2, name, rotation=90, fontsize=7, ha="right", va="center")
    axis.axvline(131.8, color="k", linestyle=":", linewidth=1)
    axis.invert_yaxis()
    axis.set(xlabel="RMS rotation error (deg); dotted: rotations drawn at random", xlim=(0, 140))
    figure.savefig(path, metadata={"Date": None})


def table_of_seed(seed, experiment):
    keys = ["variant", "direction", "step_percent", "rotation_deg", "noise_px", "inlier_percent", "parameter", "median_deg",
            "p90_deg", "rms_deg", "failure_percent", "direction_median_deg", "figure"]
    rows = select(seed, experiment=experiment)
    print(f"### {experiment}\n")
    markdown(keys, [[f"{row[k]:.3g}" if isinstance(row[k], float) else str(row[k]) for k in keys] for row in rows])


def main():
    grid, seed = rows_of(sys.argv[1]), rows_of(sys.argv[2])
    docs = pathlib.Path(sys.argv[3])
    plot_grid(grid, docs / "solver_study_grid.svg")
    plot_kneip(seed, docs / "solver_study_kneip.svg")
    print("By inlier share: median of the cells' median rotation errors (deg) / failures (%)\n")
    table_by_inliers(grid)
    for scheme in SCHEMES:
        for column in ("rotation_median_deg", "direction_median_deg"):
            print(f"{scheme}, 70 to 100 % inliers: {column}\n")
            table_by_motion(grid, SOLVERS, scheme, column)
    for scheme, solver in (("5 cm", "kabsch"), ("covariance-weighted", "p3p")):
        print(f"{solver}: rotation\n")
        table_by_motion(grid, [solver], scheme, "rotation_median_deg")
    for experiment in dict.fromkeys(row["experiment"] for row in seed):
        table_of_seed(seed, experiment)


if __name__ == "__main__":
    main()
