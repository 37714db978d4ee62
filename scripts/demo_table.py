"""Prints what `framewise run` wrote into run.json of several folders, one line a run."""

import json
import pathlib
import sys


def row(folder: pathlib.Path) -> list[str]:
    run = json.loads((folder / "run.json").read_text())
    e = run["evaluation"]
    return [
        f"{run['options']['solver']}, scale {run['options']['scale']}",
        f"{1000 * e['ate']['rmse']:.1f} mm",
        f"{100 * e['ate']['rmse'] / e['path_length']:.2f} %",
        f"{1000 * e['rpe']['translation']['rmse']:.2f} mm",
        f"{e['rpe']['rotation_deg']['rmse']:.3f} deg",
        f"{e['coverage']:.2f}",
        f"{run['frames_per_second']:.0f}",
    ]


def main() -> None:
    data, *folders = map(pathlib.Path, sys.argv[1:])
    run = json.loads((folders[0] / "run.json").read_text())
    e = run["evaluation"]
    head = ["method", "ATE", "of the path", "RPE", "RPE rotation", "coverage", "frames/s"]
    rows = [head] + [row(folder) for folder in folders]
    widths = [max(len(r[k]) for r in rows) for k in range(len(head))]
    print()
    for r in rows:
        print("  ".join(cell.ljust(width) if k == 0 else cell.rjust(width) for k, (cell, width) in enumerate(zip(r, widths))))
    still = e["static_baseline"]
    print(f"\n{run['frames']} frames, path {e['path_length']:.2f} m; alignment {e['alignment']}, "
          f"RPE over {e['delta']:g} {e['unit']}.")
    print(f"A camera that never moved: ATE {1000 * still['ate']:.0f} mm, RPE {1000 * still['rpe_translation']:.2f} mm, "
          f"{still['rpe_rotation_deg']:.3f} deg.\n")
    print(f"recording    {data}")
    for folder in folders:
        print(f"trajectory   {folder / 'trajectory.tum'}   (frames.csv, run.json beside it)")


if __name__ == "__main__":
    main()
