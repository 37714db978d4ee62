# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scene that Blender renders by tools/blender/export_framewise.py is what framewise simulate renders of the same mesh."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

FRAMEWISE = os.environ["FRAMEWISE"]
HERE = pathlib.Path(__file__).resolve().parent
BLENDER = shutil.which("blender")


def blender(*arguments):
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return subprocess.run([BLENDER, "-b", "--factory-startup", *map(str, arguments)], capture_output=True, text=True,
                          timeout=500, env=environment)


@unittest.skipUnless(BLENDER, "blender is not installed")
class Blender(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls._folder.name)
        cls.exporter = HERE.parent / "tools" / "blender" / "export_framewise.py"
        made = blender("-P", HERE / "blender" / "make_scene.py", "--", cls.folder)
        assert (cls.folder / "scene.blend").exists(), made.stdout + made.stderr
        cls.export = blender(cls.folder / "scene.blend", "-P", cls.exporter, "--", "--out", cls.folder / "blender")

    @classmethod
    def tearDownClass(cls):
        cls._folder.cleanup()

    def test_the_same_mesh_gives_the_same_pixels_and_depth(self):
        self.assertEqual(self.export.returncode, 0, self.export.stdout + self.export.stderr)
        simulated = subprocess.run(
            [FRAMEWISE, "simulate", "--mesh", self.folder / "model.obj", "--path", self.folder / "blender" / "groundtruth.txt",
             "--rate", "10", "--width", "160", "--height", "120",
             "--depth-max", "13", "--out", self.folder / "ours", "--quiet"],
            capture_output=True, text=True)
        self.assertEqual(simulated.returncode, 0, simulated.stderr)
        result = self.folder / "apart.json"
        compared = blender("-P", HERE / "blender" / "compare.py", "--", self.folder / "ours", self.folder / "blender", result)
        self.assertTrue(result.exists(), compared.stdout + compared.stderr)
        frames = json.loads(result.read_text())
        self.assertEqual(len(frames), 4)
        for frame in frames:
            self.assertLess(frame["time_apart"], 1e-6)
            self.assertEqual(frame["colors_apart"], 0, frame)
            self.assertGreater(frame["equal_within_one_level"], 0.9, frame)
            self.assertLess(frame["depth_apart_off_edges"], 1e-3, frame)
            self.assertGreater(frame["depths_within_1_mm"], 0.97, frame)
            self.assertGreater(frame["seen"], 0.5, frame)

    def test_framewise_reads_what_it_exports(self):
        inspected = subprocess.run([FRAMEWISE, "inspect", self.folder / "blender", "--json"], capture_output=True, text=True)
        self.assertEqual(inspected.returncode, 0, inspected.stderr)
        self.assertEqual(json.loads(inspected.stdout)["format"], "tum")
        self.assertIn("no usual mistake", subprocess.run([FRAMEWISE, "inspect", self.folder / "blender"],
                                                         capture_output=True, text=True).stdout)

    def test_refuses_what_makes_no_recording(self):
        for options, word in ((("--start", "9", "--end", "2"), "9 to 2"), (("--camera", "box0"), "box0")):
            refused = blender(self.folder / "scene.blend", "-P", self.exporter, "--", "--out", self.folder / "none", *options)
            self.assertEqual(refused.returncode, 2, refused.stdout + refused.stderr)
            self.assertIn(word, refused.stderr)


if __name__ == "__main__":
    unittest.main()
