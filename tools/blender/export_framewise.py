# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""Renders a Blender scene along its camera's path to a recording that framewise reads: colour, exact z-depth and truth.

    blender -b my_scene.blend -P export_framewise.py -- --out data/my_scene

Layout: TUM's, with depth as EXR in metres, camera.yaml from the camera's lens and sensor, and groundtruth.txt in
optical axes (x right, y down, z forward; Blender's camera looks along -z, y up). Colour is rendered as the scene says;
depth by Cycles through the centre of each pixel. The .blend file stays as it is.
"""

import argparse
import json
import math
import os
import pathlib
import shutil
import sys
import tempfile

import bpy
from mathutils import Matrix

OPTICAL_FROM_BLENDER = Matrix.Diagonal((1, -1, -1, 1))
TRUTH_RATE = 100  # poses a second, at least
FARTHEST = 1000  # m; Blender writes 1e10 where there is nothing


def arguments():
    parser = argparse.ArgumentParser(prog="export_framewise.py")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder to create")
    parser.add_argument("--camera", help="object's name; default: the scene's camera")
    parser.add_argument("--start", type=int, help="first frame; default: the scene's")
    parser.add_argument("--end", type=int, help="last frame; default: the scene's")
    parser.add_argument("--step", type=int, default=1, help="frames from one to the next")
    after = sys.argv.index("--") + 1 if "--" in sys.argv else len(sys.argv)
    return parser.parse_args(sys.argv[after:])


def fail(text):
    """One line, exit code 2."""
    print(f"export_framewise: {text}", file=sys.stderr)
    sys.stderr.flush()
    sys.stdout.flush()
    os._exit(2)


def resolution(scene):
    render = scene.render
    return (render.resolution_x * render.resolution_percentage // 100,
            render.resolution_y * render.resolution_percentage // 100)


def intrinsics(scene, camera):
    """fx fy cx cy in pixels, (0, 0) the centre of the first pixel. Blender's manual, Cameras: sensor fit, shift."""
    data, (width, height) = camera.data, resolution(scene)
    if data.type != "PERSP":
        fail(f"camera '{camera.name}' is of type {data.type}, expected PERSP")
    aspect = scene.render.pixel_aspect_y / scene.render.pixel_aspect_x
    fit = data.sensor_fit
    if fit == "AUTO":
        fit = "HORIZONTAL" if width >= aspect * height else "VERTICAL"
        sensor = data.sensor_width
    else:
        sensor = data.sensor_width if fit == "HORIZONTAL" else data.sensor_height
    across = width if fit == "HORIZONTAL" else aspect * height  # what the sensor covers, in pixels' widths
    fx = data.lens / sensor * across
    return (fx, fx / aspect, 0.5 * (width - 1) - data.shift_x * across,
            0.5 * (height - 1) + data.shift_y * across / aspect)


def camera_yaml(scene, camera):
    width, height = resolution(scene)
    fx, fy, cx, cy = intrinsics(scene, camera)
    return (f"# depth is registered to this camera\nmodel: pinhole\nwidth: {width}\nheight: {height}\n"
            f"fx: {fx!r}\nfy: {fy!r}\ncx: {cx!r}\ncy: {cy!r}\ndistortion: [0, 0, 0, 0, 0]\n"
            f"depth_factor: 1  # EXR holds metres\ndepth_max: {FARTHEST}\n")


def truth_line(camera, time):
    """The pose of the camera as the scene stands: world_from_cam."""
    world_from_cam = camera.evaluated_get(bpy.context.evaluated_depsgraph_get()).matrix_world @ OPTICAL_FROM_BLENDER
    t, q, _ = world_from_cam.decompose()
    return f"{time:.6f} {t.x!r} {t.y!r} {t.z!r} {q.x!r} {q.y!r} {q.z!r} {q.w!r}\n"


class Kept:
    """Sets attributes for a while: (object, name, value)."""

    def __init__(self, *settings):
        self.settings = settings

    def __enter__(self):
        self.before = [(thing, name, getattr(thing, name)) for thing, name, _ in self.settings]
        for thing, name, value in self.settings:
            setattr(thing, name, value)

    def __exit__(self, *_):
        for thing, name, value in reversed(self.before):
            setattr(thing, name, value)


def render_color(scene, file):
    settings = scene.render.image_settings
    with Kept((settings, "file_format", "PNG"), (settings, "color_mode", "RGB"), (settings, "color_depth", "8"),
              (scene.render, "filepath", str(file)), (scene.render, "use_file_extension", False)):
        bpy.ops.render.render(write_still=True)


class DepthTree:
    """The scene's compositor while depth is rendered: one node that writes the z pass as EXR."""

    def __init__(self, scene, folder):
        self.scene, self.was_used = scene, scene.use_nodes
        scene.use_nodes = True
        self.nodes = scene.node_tree.nodes
        self.muted = [node for node in self.nodes if node.bl_idname == "CompositorNodeOutputFile" and not node.mute]
        for node in self.muted:
            node.mute = True
        layers = self.nodes.new("CompositorNodeRLayers")
        layers.layer = bpy.context.view_layer.name
        writer = self.nodes.new("CompositorNodeOutputFile")
        writer.base_path = str(folder)
        writer.format.file_format = "OPEN_EXR"
        writer.format.color_depth = "32"
        writer.format.color_mode = "RGB"  # of equal values: one channel is not offered
        writer.format.exr_codec = "ZIP"
        writer.file_slots[0].path = "z"
        scene.node_tree.links.new(layers.outputs["Depth"], writer.inputs[0])
        self.added = [layers, writer]

    def close(self):
        for node in self.added:
            self.nodes.remove(node)
        for node in self.muted:
            node.mute = False
        self.scene.use_nodes = self.was_used


def render_depth(scene, camera, file):
    """z through the centres of the pixels: one sample, the narrowest filter, nothing blurred."""
    layer, cycles = bpy.context.view_layer, scene.cycles
    with tempfile.TemporaryDirectory() as folder:
        with Kept((scene.render, "engine", "CYCLES"), (layer, "use_pass_z", True), (cycles, "samples", 1),
                  (cycles, "use_adaptive_sampling", False), (cycles, "use_denoising", False), (cycles, "max_bounces", 0),
                  (cycles, "pixel_filter_type", "BOX"), (cycles, "filter_width", 0.01),
                  (scene.render, "use_motion_blur", False), (camera.data.dof, "use_dof", False)):
            tree = DepthTree(scene, folder)
            try:
                bpy.ops.render.render(write_still=False)
            finally:
                tree.close()
        written = sorted(pathlib.Path(folder).glob("z*.exr"))
        if not written:
            fail("Blender wrote no depth, expected Cycles to be there")
        shutil.move(str(written[0]), file)


def set_frame(scene, frame):
    scene.frame_set(math.floor(frame), subframe=frame - math.floor(frame))


def main():
    options, scene = arguments(), bpy.context.scene
    camera = bpy.data.objects.get(options.camera) if options.camera else scene.camera
    if camera is None or camera.type != "CAMERA":
        fail(f"found no camera {options.camera or 'in the scene'}, expected one")
    scene.camera = camera
    start = scene.frame_start if options.start is None else options.start
    end = scene.frame_end if options.end is None else options.end
    if end < start or options.step < 1:
        fail(f"found frames {start} to {end} by {options.step}, expected at least one")
    if (options.out / "rgb.txt").exists():
        fail(f"{options.out / 'rgb.txt'} exists, expected a folder without a recording")
    if scene.unit_settings.scale_length != 1:
        fail(f"the scene's unit scale is {scene.unit_settings.scale_length}, expected 1: depth is in Blender's units")
    calibration = camera_yaml(scene, camera)
    for name in ("rgb", "depth"):
        (options.out / name).mkdir(parents=True, exist_ok=True)
    (options.out / "camera.yaml").write_text(calibration)

    rate = scene.render.fps / scene.render.fps_base
    frames = range(start, end + 1, options.step)
    between = max(1, math.ceil(TRUTH_RATE * options.step / rate))
    colors, depths = ["# color images\n# timestamp filename\n"], ["# depth maps\n# timestamp filename\n"]
    truth = ["# ground truth trajectory\n# world_from_cam, optical axes (x right, y down, z forward)\n",
             "# timestamp tx ty tz qx qy qz qw\n"]
    for frame in frames:
        time = (frame - start) / rate
        set_frame(scene, frame)
        stamp = f"{time:.6f}"
        render_color(scene, (options.out / "rgb" / f"{stamp}.png").resolve())
        render_depth(scene, camera, options.out / "depth" / f"{stamp}.exr")
        colors.append(f"{stamp} rgb/{stamp}.png\n")
        depths.append(f"{stamp} depth/{stamp}.exr\n")
        for k in range(between if frame + options.step <= end else 1):
            set_frame(scene, frame + options.step * k / between)
            truth.append(truth_line(camera, time + options.step * k / between / rate))
        print(f"export_framewise: frame {frame} of {start} to {end}", flush=True)
    (options.out / "rgb.txt").write_text("".join(colors))
    (options.out / "depth.txt").write_text("".join(depths))
    (options.out / "groundtruth.txt").write_text("".join(truth))
    record = {"blender": bpy.app.version_string, "scene": bpy.data.filepath, "camera": camera.name, "start": start,
              "end": end, "step": options.step, "rate": rate / options.step, "frames": len(frames)}
    (options.out / "simulation.json").write_text(json.dumps(record, indent=2) + "\n")


try:
    main()
except SystemExit as end:
    # Blender would go on, and say that all went well.
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(end.code or 0)
except Exception as error:
    fail(f"{type(error).__name__}: {error}")
