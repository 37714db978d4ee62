# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by Blender: the same shining boxes as scene.blend and as model.obj, in the folder given."""

import itertools
import math
import pathlib
import sys

import bpy

folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
BOXES = [  # lowest corner, size, radiance
    ((-4, 6, -3), (8, 0.5, 6), (0.2, 0.3, 0.5)),
    ((-1.2, 2.0, -0.8), (0.9, 0.7, 0.6), (0.8, 0.1, 0.05)),
    ((0.3, 2.6, -0.2), (0.8, 0.5, 1.1), (0.1, 0.6, 0.2)),
    ((-0.5, 3.5, 0.4), (0.6, 0.6, 0.5), (0.9, 0.8, 0.1)),
]
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
obj, mtl, count = ["mtllib model.mtl\n"], [], 0
for k, (low, size, light) in enumerate(BOXES):
    corners = [tuple(l + s * b for l, s, b in zip(low, size, bits)) for bits in itertools.product((0, 1), repeat=3)]
    mesh = bpy.data.meshes.new(f"box{k}")
    mesh.from_pydata(corners, [], FACES)
    material = bpy.data.materials.new(f"light{k}")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    emission, output = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    emission.inputs["Color"].default_value = (*light, 1)
    material.node_tree.links.new(emission.outputs[0], output.inputs["Surface"])
    mesh.materials.append(material)
    scene.collection.objects.link(bpy.data.objects.new(f"box{k}", mesh))
    obj += [f"o box{k}\n"] + [f"v {x} {y} {z}\n" for x, y, z in corners] + [f"usemtl light{k}\n"]
    obj += [f"f {' '.join(str(count + i + 1) for i in face)}\n" for face in FACES]
    mtl.append(f"newmtl light{k}\nKd 0 0 0\nKe {light[0]} {light[1]} {light[2]}\n")
    count += 8
(folder / "model.obj").write_text("".join(obj))
(folder / "model.mtl").write_text("".join(mtl))

camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
scene.collection.objects.link(camera)
scene.camera = camera
camera.data.sensor_width = 36
camera.data.lens = 36 * 525 / 640  # framewise simulate's field of view
camera.rotation_mode = "XYZ"
for frame, place, turn in ((1, (0, -1, 0.1), (90, 0, 0)), (4, (0.3, -0.6, 0.3), (84, 6, 9))):
    camera.location = place
    camera.rotation_euler = [math.radians(a) for a in turn]
    camera.keyframe_insert("location", frame=frame)
    camera.keyframe_insert("rotation_euler", frame=frame)
scene.frame_start, scene.frame_end, scene.render.fps = 1, 4, 10
scene.render.resolution_x, scene.render.resolution_y = 160, 120
scene.render.engine = "CYCLES"
scene.cycles.samples = 16
scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BOX", 1  # as framewise averages a pixel
scene.cycles.use_denoising = False
scene.view_settings.view_transform = "Standard"
scene.render.dither_intensity = 0
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "scene.blend"))
