# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by Blender, which reads EXR: how far the images of two recordings are apart, as JSON in the last folder given."""

import json
import pathlib
import sys

import bpy

ours, blenders, out = map(pathlib.Path, sys.argv[sys.argv.index("--") + 1:])


def pixels(file, scale):
    """Rows of pixels, each a tuple of three; from below, as Blender has them."""
    image = bpy.data.images.load(str(file))
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    values, n = [scale * value for value in image.pixels[:]], image.channels
    return [[tuple(values[n * (y * width + x):n * (y * width + x) + 3]) for x in range(width)] for y in range(height)]


def listed(folder, name):
    lines = [line.split() for line in (folder / name).read_text().splitlines() if line[0] != "#"]
    return [(float(time), folder / file) for time, file in lines]


def nearby(image, x, y):
    """The pixel and those beside it."""
    return [image[j][i] for j in range(max(0, y - 1), min(len(image), y + 2))
            for i in range(max(0, x - 1), min(len(image[0]), x + 2))]


def is_between(value, others, slack):
    return all(min(o[k] for o in others) - slack <= value[k] <= max(o[k] for o in others) + slack for k in range(3))


frames = []
for (t1, color1), (t2, color2), (_, depth1), (_, depth2) in zip(listed(ours, "rgb.txt"), listed(blenders, "rgb.txt"),
                                                            listed(ours, "depth.txt"), listed(blenders, "depth.txt")):
    a, b, z1, z2 = pixels(color1, 255), pixels(color2, 255), pixels(depth1, 65535 / 5000), pixels(depth2, 1)
    places = [(x, y) for y in range(len(a)) for x in range(len(a[0]))]
    edges = {(x, y) for x, y in places
             if max(z[0] for z in nearby(z2, x, y)) - min(z[0] for z in nearby(z2, x, y)) > 0.1}
    depths = {(x, y): (z1[y][x][0] or 1e10, z2[y][x][0]) for x, y in places}
    # Ours is stored in steps of 0.2 mm.
    apart = {place: abs(p - q) - 1e-4 for place, (p, q) in depths.items()}
    share = lambda condition: sum(map(condition, places)) / len(places)
    frames.append({
        "time_apart": abs(t1 - t2),
        # Beyond what the other has within a pixel, give or take a level; at the border there is no other.
        "colors_apart": sum(not is_between(b[y][x], nearby(a, x, y), 1.5) for x, y in places
                            if 0 < x < len(a[0]) - 1 and 0 < y < len(a) - 1),
        "equal_within_one_level": share(lambda p: max(abs(m - n) for m, n in zip(a[p[1]][p[0]], b[p[1]][p[0]])) < 1.5),
        "depth_apart_off_edges": max(apart[place] for place in places if place not in edges),
        "depths_within_1_mm": share(lambda p: apart[p] < 1e-3),
        "edges": len(edges) / len(places),
        "seen": share(lambda p: depths[p][0] < 100)})
out.write_text(json.dumps(frames))
