#!/usr/bin/env python3
"""Fails on an include that climbs: a room knows only the rooms DESIGN.md section 1 lets it use."""

import pathlib
import re
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent / "src" / "framewise"

ALLOWED = {
    "geometry": [],
    "solvers": ["geometry"],
    "image": ["geometry"],
    "evaluation": ["geometry"],
    "robust": ["geometry", "solvers"],
    "features": ["geometry", "image"],
    "registration": ["geometry", "solvers", "image"],
    "io": ["geometry", "image"],
    "report": ["geometry", "evaluation"],
    "simulation": ["geometry", "image"],
    "odometry": ["geometry", "solvers", "image", "evaluation", "robust", "features", "registration"],
}
EIGEN_ONLY = {"geometry", "solvers", "robust", "evaluation"}
INCLUDE = re.compile(r'^\s*#include\s+[<"]([^>"]+)[>"]')


def climbing_includes(room: str, path: pathlib.Path) -> list[str]:
    complaints = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        found = INCLUDE.match(line)
        if not found:
            continue
        header = found.group(1)
        parts = header.split("/")
        if parts[0] == "framewise":
            target = parts[1]
            if target != room and target not in ALLOWED[room]:
                complaints.append(f"{path.relative_to(SOURCE)}:{number}: {room} may not use {target} ({header})")
        elif parts[0] in ("opencv2", "tbb", "embree3", "embree4", "fmt") and room in EIGEN_ONLY:
            complaints.append(f"{path.relative_to(SOURCE)}:{number}: {room} needs Eigen alone ({header})")
    return complaints


def main() -> int:
    complaints = []
    for folder in sorted(p for p in SOURCE.iterdir() if p.is_dir()):
        if folder.name not in ALLOWED:
            complaints.append(f"{folder.name}: not a room of DESIGN.md")
            continue
        for path in sorted(folder.rglob("*")):
            if path.suffix in (".h", ".cc", ".inc"):
                complaints += climbing_includes(folder.name, path)
    print("\n".join(complaints) or "rooms: no include climbs")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
