# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command-line program as a user meets it: what it writes, what it refuses, and that it repeats itself."""

import csv
import json
import math
import os
import pathlib
import re
import resource
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import unittest
import zipfile
import zlib

FRAMEWISE = os.environ["FRAMEWISE"]
DATA = pathlib.Path(os.environ.get("FRAMEWISE_DATA", pathlib.Path(__file__).resolve().parents[2] / "shared" / "data"))


def framewise(*arguments):
    return subprocess.run([FRAMEWISE, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def write_png(path, width, height, bits, value, color_type=0):
    """An image of one value, or of value(u, v): gray, or as the PNG colour type says (6: red, green, blue, alpha)."""
    at = value if callable(value) else lambda u, v: value
    channels = {0: 1, 2: 3, 6: 4}[color_type]
    rows = [b"\0" + b"".join(at(u, v).to_bytes(bits // 8, "big") * channels for u in range(width)) for v in range(height)]
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", width, height, bits, color_type, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"".join(rows)))
                     + chunk(b"IEND", b""))


def matrix_of(t, q):
    """A pose's 4x4 rows from its position and quaternion x y z w."""
    n = math.hypot(*q)
    x, y, z, w = (value / n for value in q)
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), t[0]],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), t[1]],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), t[2]], [0, 0, 0, 1]]


def quaternion_of(m):
    """x y z w of a rotation, by the largest of them."""
    q = [1 + m[0][0] - m[1][1] - m[2][2], 1 - m[0][0] + m[1][1] - m[2][2], 1 - m[0][0] - m[1][1] + m[2][2],
         1 + m[0][0] + m[1][1] + m[2][2]]
    k = q.index(max(q))
    rows = [[q[0], m[0][1] + m[1][0], m[0][2] + m[2][0], m[2][1] - m[1][2]],
            [m[0][1] + m[1][0], q[1], m[1][2] + m[2][1], m[0][2] - m[2][0]],
            [m[0][2] + m[2][0], m[1][2] + m[2][1], q[2], m[1][0] - m[0][1]],
            [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1], q[3]]]
    return [value / (2 * math.sqrt(q[k])) for value in rows[k]]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def inverse(m):
    """Of a rigid motion."""
    R = [[m[j][i] for j in range(3)] for i in range(3)]
    return [R[i] + [-sum(R[i][k] * m[k][3] for k in range(3))] for i in range(3)] + [[0, 0, 0, 1]]


def quaternion_pose(lines, time):
    """Position and quaternion of the line of a truth that is nearest in time."""
    words = min(lines, key=lambda line: abs(float(line[0]) - time))
    return [float(w) for w in words[1:4]], [float(w) for w in words[4:8]]


class Recording(unittest.TestCase):
    """A small simulated recording, made once; every test changes a copy."""

    FRAMES = 12
    SIZE = ()

    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory()
        cls.original = pathlib.Path(cls._folder.name) / "original"
        made = framewise("simulate", "room", "--out", cls.original, "--frames", cls.FRAMES, *cls.SIZE, "--quiet")
        assert made.returncode == 0, made.stderr

    @classmethod
    def tearDownClass(cls):
        cls._folder.cleanup()

    def setUp(self):
        self.work = pathlib.Path(tempfile.mkdtemp(dir=self._folder.name))
        self.data = self.work / "room"
        shutil.copytree(self.original, self.data)
        self.out = self.work / "out"

    def run_data(self, *options):
        return framewise("run", self.data, "--out", self.out, "--quiet", *options)

    def listed(self, name):
        """The files of a list, comments left out."""
        lines = (self.data / name).read_text().splitlines()
        return [line.split() for line in lines if line and not line.startswith("#")]

    def rewrite(self, name, change):
        lines = (self.data / name).read_text().splitlines()
        (self.data / name).write_text("\n".join(line if line.startswith("#") else change(line) for line in lines) + "\n")

    def refuses(self, result, *words):
        """Exit code 2 and one line that says all of the words."""
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)


class Run(Recording):
    def test_writes_a_line_for_every_frame_and_evaluates_itself(self):
        result = self.run_data()
        self.assertEqual(result.returncode, 0, result.stderr)
        trajectory = [l for l in (self.out / "trajectory.tum").read_text().splitlines() if not l.startswith("#")]
        self.assertEqual(len(trajectory), self.FRAMES)
        for line, (time, _) in zip(trajectory, self.listed("rgb.txt")):
            numbers = [float(word) for word in line.split()]
            self.assertEqual(len(numbers), 8)
            self.assertEqual(numbers[0], float(time))
            self.assertAlmostEqual(math.hypot(*numbers[4:]), 1, 12)
        frames = list(csv.DictReader((self.out / "frames.csv").open()))
        self.assertEqual([row["status"] for row in frames], ["ok"] * self.FRAMES)
        run = json.loads((self.out / "run.json").read_text())
        self.assertEqual(run["evaluation"]["coverage"], 1)
        self.assertEqual(run["options"]["reference"], "map")
        self.assertLess(run["evaluation"]["rpe"]["rotation_deg"]["rmse"], 0.1)
        self.assertLess(run["evaluation"]["ate"]["rmse"], 0.01)
        # What later frames told is written beside it, and judged by itself.
        final = [l for l in (self.out / "trajectory_final.tum").read_text().splitlines() if not l.startswith("#")]
        self.assertEqual(len(final), self.FRAMES)
        self.assertLess(run["evaluation_final"]["ate"]["rmse"], 0.01)
        # The covariance of every step: its 21 numbers, with variances that are positive.
        names = ("rx", "ry", "rz", "tx", "ty", "tz")
        for row in frames[1:]:
            for i, a in enumerate(names):
                self.assertGreater(float(row[f"cov_{a}_{a}"]), 0)
                for b in names[i:]:
                    self.assertTrue(math.isfinite(float(row[f"cov_{a}_{b}"])))

    def test_a_frame_is_related_to_the_one_before_where_a_method_is_chosen(self):
        for options in (("--solver", "kabsch"), ("--reference", "frame"), ("--matcher", "windowed")):
            self.assertEqual(self.run_data(*options).returncode, 0)
            run = json.loads((self.out / "run.json").read_text())
            self.assertEqual(run["options"]["reference"], "frame")
            self.assertGreaterEqual(run["ransac"]["iterations_per_step"], run["ransac"]["iterations_theory_per_step"])
            self.assertGreater(run["ransac"]["iterations_theory_per_step"], 0)
            self.assertLess(run["evaluation"]["ate"]["rmse"], 0.02)
        self.refuses(self.run_data("--reference", "map", "--solver", "p3p"), "solver", "map")

    def test_eight_point_takes_its_scale_from_depth_truth_or_nowhere(self):
        # Half as many frames a second: steps with parallax enough to have a length.
        self.data = self.work / "half"
        made = framewise("simulate", "room", "--out", self.data, "--frames", self.FRAMES, "--rate", 15, "--quiet")
        self.assertEqual(made.returncode, 0, made.stderr)
        for scale in ("depth", "truth", "none"):
            result = self.run_data("--solver", "eight-point", "--scale", scale)
            self.assertEqual(result.returncode, 0, result.stderr)
            frames = list(csv.DictReader((self.out / "frames.csv").open()))
            lengths = [math.hypot(*(float(r[f"step_t{axis}"]) for axis in "xyz")) for r in frames[1:] if r["status"] == "ok"]
            self.assertGreater(len(lengths), self.FRAMES // 2)
            for length in lengths:
                if scale == "none":
                    self.assertAlmostEqual(length, 1, 9)
                else:
                    self.assertLess(length, 0.2)

    def test_rotations_are_judged_where_a_camera_without_depth_only_turned(self):
        self.data = self.work / "turn"
        made = framewise("simulate", "room", "--path", "pure-rotation", "--rate", 15, "--frames", 8, "--width", 320, "--height", 240,
                         "--out", self.data, "--quiet")
        self.assertEqual(made.returncode, 0, made.stderr)
        (self.data / "depth.txt").unlink()
        shutil.rmtree(self.data / "depth")
        self.assertEqual(self.run_data().returncode, 0)
        run = json.loads((self.out / "run.json").read_text())
        self.assertEqual(run["statuses"]["rotation-only"], 7)
        self.assertEqual(run["evaluation"]["coverage"], 1)
        self.assertLess(run["evaluation"]["rpe"]["rotation_deg"]["rmse"], 0.1)
        self.assertEqual(run["evaluation"]["ate"]["rmse"], 0)

    def test_every_solver_follows_the_camera(self):
        for solver in ("eight-point", "seven-point", "nister-5pt", "stewenius-5pt", "kneip-5pt-rotation", "eigensolver"):
            result = self.run_data("--solver", solver, "--scale", "depth")
            self.assertEqual(result.returncode, 0, result.stderr)
            evaluation = json.loads((self.out / "run.json").read_text())["evaluation"]
            self.assertEqual(evaluation["coverage"], 1, solver)
            still = evaluation["static_baseline"]["rpe_rotation_deg"]
            self.assertLess(evaluation["rpe"]["rotation_deg"]["rmse"], 0.6 * still, solver)

    def test_repeats_itself_to_the_byte_at_any_thread_count(self):
        answers = set()
        for threads in (1, 2, 2, 4):
            self.assertEqual(self.run_data("--threads", threads, "--seed", 7).returncode, 0)
            answers.add((self.out / "trajectory.tum").read_bytes())
        self.assertEqual(len(answers), 1)

    def test_a_config_file_says_the_same_as_options(self):
        self.run_data("--solver", "eight-point", "--max-error-px", "2.5")
        typed = (self.out / "trajectory.tum").read_bytes()
        config = self.work / "run.yaml"
        config.write_text("solver: eight-point\nmax-error-px: 2.5\n")
        self.assertEqual(self.run_data("--config", config).returncode, 0)
        self.assertEqual((self.out / "trajectory.tum").read_bytes(), typed)
        config.write_text("solver: eight-point\nmax-eror-px: 2.5\n")
        self.refuses(self.run_data("--config", config), "run.yaml", ":2:", "max-eror-px")

    def test_goes_on_after_frames_that_show_nothing(self):
        for _, file in self.listed("rgb.txt")[5:7]:
            write_png(self.data / file, 640, 480, 8, 90)
        for reference, missed in (("map", "predicted"), ("frame", "lost")):
            result = self.run_data("--reference", reference)
            self.assertEqual(result.returncode, 0, result.stderr)
            frames = list(csv.DictReader((self.out / "frames.csv").open()))
            self.assertEqual(len(frames), self.FRAMES)
            self.assertEqual([r["status"] for r in frames], ["ok"] * 5 + [missed] * 2 + ["ok"] * 5)
            # The gap is bridged: the end is as right as without the loss.
            run = json.loads((self.out / "run.json").read_text())
            self.assertLess(run["evaluation"]["ate"]["max"], 0.05)

    def test_an_association_list_replaces_the_rule_of_time(self):
        self.run_data()
        by_time = (self.out / "trajectory.tum").read_bytes()
        pairs = list(zip(self.listed("rgb.txt"), self.listed("depth.txt")))
        (self.data / "associations.txt").write_text("\n".join(" ".join(c + d) for c, d in pairs) + "\n")
        (self.data / "depth.txt").unlink()
        self.assertEqual(self.run_data().returncode, 0)
        self.assertEqual((self.out / "trajectory.tum").read_bytes(), by_time)

    def test_says_how_far_it_is_in_lines_where_there_is_no_terminal(self):
        result = framewise("run", self.data, "--out", self.out)
        lines = result.stderr.strip().splitlines()
        self.assertLessEqual(len(lines), 10)
        self.assertIn(f"{self.FRAMES} of {self.FRAMES} frames", lines[-1])
        self.assertEqual(framewise("run", self.data, "--out", self.out, "--quiet").stderr, "")

    def test_a_frame_without_depth_says_so(self):
        lines = (self.data / "depth.txt").read_text().splitlines()
        (self.data / "depth.txt").write_text("\n".join(lines[:-1]) + "\n")
        self.assertEqual(self.run_data("--solver", "kabsch").returncode, 0)
        frames = list(csv.DictReader((self.out / "frames.csv").open()))
        self.assertEqual(frames[-1]["status"], "no-depth")

    def test_a_recording_lost_throughout_is_a_failure(self):
        for _, file in self.listed("rgb.txt"):
            write_png(self.data / file, 640, 480, 8, 90)
        result = self.run_data()
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertTrue((self.out / "run.json").exists())

    def test_one_frame_is_a_recording(self):
        first = self.listed("rgb.txt")[0]
        (self.data / "rgb.txt").write_text(" ".join(first) + "\n")
        result = self.run_data()
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_keeps_what_was_computed_before_a_failure(self):
        _, file = self.listed("rgb.txt")[8]
        path = self.data / file
        path.write_bytes(path.read_bytes()[:5000])
        self.refuses(self.run_data(), path.name)
        trajectory = [l for l in (self.out / "trajectory.tum").read_text().splitlines() if not l.startswith("#")]
        self.assertEqual(len(trajectory), 8)


class LostAndFound(Recording):
    """What the default odometer says and does while it sees too little, and after."""

    FRAMES = 30
    SIZE = ("--rate", 15, "--width", 320, "--height", 240)
    AWAY = range(8, 15)  # not quite half a second

    def show(self, name, bits, value, frames):
        for _, file in self.listed(name)[frames.start:frames.stop]:
            write_png(self.data / file, 320, 240, bits, value)

    def drop(self, name, frames):
        kept = [line for i, line in enumerate(self.listed(name)) if i not in frames]
        (self.data / name).write_text("".join(" ".join(line) + "\n" for line in kept))

    def follows(self, expected):
        """Statuses as expected, and where they are ok the camera is where it was."""
        result = self.run_data()
        self.assertEqual(result.returncode, 0, result.stderr)
        frames = list(csv.DictReader((self.out / "frames.csv").open()))
        self.assertEqual([row["status"] for row in frames], expected)
        truth = self.listed("groundtruth.txt")
        estimate = [line.split() for line in (self.out / "trajectory.tum").read_text().splitlines() if line[0] != "#"]
        world_from_first = matrix_of(*quaternion_pose(truth, 0))
        for row in frames:
            if row["status"] != "ok":
                continue
            found = product(world_from_first, matrix_of(*quaternion_pose(estimate, float(row["time"]))))
            expected_pose = matrix_of(*quaternion_pose(truth, float(row["time"])))
            error = math.dist([found[i][3] for i in range(3)], [expected_pose[i][3] for i in range(3)])
            self.assertLess(error, 0.01, row["index"])

    def test_a_covered_lens_is_foretold_and_then_forgotten(self):
        expected = ["predicted" if i in self.AWAY else "ok" for i in range(self.FRAMES)]
        self.show("rgb.txt", 8, 0, self.AWAY)
        self.follows(expected)  # the depth camera still sees
        self.show("depth.txt", 16, 0, self.AWAY)
        self.follows(expected)

    def test_a_white_wall_is_no_place(self):
        wall = range(6, 24)
        self.show("rgb.txt", 8, 230, wall)
        self.show("depth.txt", 16, 7500, wall)
        self.follows(["ok"] * 6 + ["predicted"] * 15 + ["lost"] * 3 + ["ok"] * 6)

    def test_a_gap_of_half_a_second_is_one_long_step(self):
        for name in ("rgb.txt", "depth.txt"):
            self.drop(name, self.AWAY)
        self.follows(["ok"] * (self.FRAMES - len(self.AWAY)))

    def test_depth_that_is_missing_or_empty_is_done_without(self):
        away = range(6, 22)
        self.show("depth.txt", 16, 0, away)
        self.follows(["ok"] * self.FRAMES)
        empty = (self.out / "trajectory.tum").read_bytes()
        self.drop("depth.txt", away)
        self.follows(["ok"] * self.FRAMES)
        self.assertEqual((self.out / "trajectory.tum").read_bytes(), empty)

    def test_what_was_learned_of_the_camera_is_recorded(self):
        self.run_data()
        learned = json.loads((self.out / "run.json").read_text())["learned"]
        self.assertEqual(learned["k1_correction"], 0)  # depth tells how things are without it
        self.assertLess(abs(learned["readout_s"]), 0.005)  # a global shutter
        (self.data / "depth.txt").unlink()
        shutil.rmtree(self.data / "depth")
        self.run_data()
        learned = json.loads((self.out / "run.json").read_text())["learned"]
        self.assertLess(abs(learned["k1_correction"]), 0.05)
        self.run_data("--reference", "frame", "--solver", "nister-5pt", "--scale", "none")
        self.assertNotIn("learned", json.loads((self.out / "run.json").read_text()))

    def test_depth_without_a_list_is_read_by_its_names(self):
        self.assertEqual(self.run_data().returncode, 0)
        listed = (self.out / "trajectory.tum").read_bytes()
        (self.data / "depth.txt").unlink()
        self.assertEqual(self.run_data().returncode, 0)
        self.assertEqual((self.out / "trajectory.tum").read_bytes(), listed)
        first = sorted((self.data / "depth").iterdir())[0]
        first.rename(first.with_name("first.png"))
        self.refuses(self.run_data(), "first.png", "depth.txt")


class Methods(Recording):
    """Solver, measure, scale and RANSAC scheme, on the matches of an archive."""

    SIZE = ("--rate", 15)  # steps that are large beside what rounding does to a choice among samples

    def setUp(self):
        super().setUp()
        self.archive = self.work / "matches.h5"
        result = self.run_data("--archive", self.archive)
        self.assertEqual(result.returncode, 0, result.stderr)

    def solve(self, *options):
        return framewise("run", self.archive, "--out", self.out, "--quiet", *options)

    def frames(self):
        with (self.out / "frames.csv").open() as file:
            return list(csv.DictReader(file))

    def record(self):
        return json.loads((self.out / "run.json").read_text())

    def test_every_row_of_the_published_comparison_follows_the_camera(self):
        for solver in ("eigensolver", "kneip-5pt-rotation", "nister-5pt", "eight-point"):
            for scale in ("centroid", "first-pair"):
                for error in ("bearing-euclidean", "reprojection"):
                    method = ("--solver", solver, "--scale", scale, "--error", error, "--ransac", "two-stage")
                    result = self.solve(*method)
                    self.assertEqual(result.returncode, 0, result.stderr)
                    evaluation = self.record()["evaluation"]
                    self.assertEqual(evaluation["coverage"], 1, method)
                    self.assertEqual(self.record()["statuses"]["ok"], self.FRAMES, method)
                    if error == "bearing-euclidean":
                        continue  # takes parallax for error: it may be worse than standing still
                    still = evaluation["static_baseline"]["rpe_rotation_deg"]
                    self.assertLess(evaluation["rpe"]["rotation_deg"]["rmse"], 0.7 * still, method)

    def test_first_pair_gives_every_step_one_length(self):
        self.assertEqual(self.solve("--solver", "nister-5pt", "--scale", "first-pair", "--ransac", "two-stage").returncode, 0)
        frames = self.frames()
        lengths = {round(math.hypot(*(float(row[f"step_t{axis}"]) for axis in "xyz")), 12) for row in frames[1:]}
        self.assertEqual(len(lengths), 1)

    def test_first_pair_on_a_camera_that_stands_says_that_it_has_no_length(self):
        first = self.listed("rgb.txt")[0][1]
        self.rewrite("rgb.txt", lambda line: f"{line.split()[0]} {first}")
        result = self.run_data("--solver", "nister-5pt", "--scale", "first-pair")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        self.assertIn("no length", result.stderr)
        statuses = [row["status"] for row in self.frames()]
        self.assertEqual(statuses[1:], ["rotation-only"] * (self.FRAMES - 1))

    def test_two_point_takes_its_rotation_from_truth_trajectory_or_gyroscope(self):
        truth = self.data / "groundtruth.txt"
        gyroscope = self.work / "imu.csv"
        self.write_gyroscope(gyroscope)
        for source in ("truth", truth, gyroscope):
            result = self.solve("--solver", "two-point", "--rotation", source)
            self.assertEqual(result.returncode, 0, result.stderr)
            rotation = self.record()["evaluation"]["rpe"]["rotation_deg"]["rmse"]
            self.assertLess(rotation, 1e-6 if source != gyroscope else 0.02, source)

    def write_gyroscope(self, path):
        """Constant rates between the true poses: what a perfect gyroscope would integrate to."""
        poses = [[float(x) for x in line] for line in self.listed("groundtruth.txt")]
        lines = ["#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1]"]
        for a, b in zip(poses, poses[1:]):
            R1, R2 = rotation_of(a[4:]), rotation_of(b[4:])
            R = times(transposed(R1), R2)
            angle = math.acos(min(1, max(-1, (R[0][0] + R[1][1] + R[2][2] - 1) / 2)))
            scale = (angle / (2 * math.sin(angle)) if angle > 1e-9 else 0.5) / (b[0] - a[0])
            rate = [scale * (R[2][1] - R[1][2]), scale * (R[0][2] - R[2][0]), scale * (R[1][0] - R[0][1])]
            # Two samples a stretch, just inside it.
            for time in (a[0] + 1e-5, b[0] - 1e-5):
                lines.append(f"{round(time * 1e9)}," + ",".join(repr(x) for x in rate))
        lines[1] = f"{round(poses[0][0] * 1e9)}," + lines[1].split(",", 1)[1]
        lines[-1] = f"{round(poses[-1][0] * 1e9)}," + lines[-1].split(",", 1)[1]
        path.write_text("\n".join(lines) + "\n")

    def test_two_point_without_a_rotation_is_refused(self):
        self.refuses(self.solve("--solver", "two-point"), "two-point", "--rotation")
        self.refuses(self.solve("--solver", "two-point", "--rotation", "gyro"), "gyroscope")
        self.refuses(self.solve("--solver", "two-point", "--rotation", self.work / "none.txt"), "none.txt")
        self.refuses(self.solve("--solver", "eight-point", "--rotation", "truth"), "two-point")
        elsewhere = self.work / "elsewhere.txt"
        elsewhere.write_text("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n")
        self.refuses(self.solve("--solver", "two-point", "--rotation", elsewhere), "elsewhere.txt", "between any two frames")

    def test_truth_that_covers_half_says_so(self):
        times = [float(line[0]) for line in self.listed("groundtruth.txt")]
        middle = times[len(times) // 2]
        lines = (self.data / "groundtruth.txt").read_text().splitlines()
        kept = [line for line in lines if line.startswith("#") or float(line.split()[0]) <= middle]
        (self.data / "groundtruth.txt").write_text("\n".join(kept) + "\n")
        result = self.run_data("--solver", "nister-5pt", "--scale", "truth")
        self.assertEqual(result.returncode, 0, result.stderr)
        record = self.record()
        self.assertLess(record["evaluation"]["coverage"], 0.7)
        self.assertGreater(record["statuses"]["lost"], self.FRAMES // 3)

    def test_one_frame_and_every_scale(self):
        only = "\n".join((self.data / "rgb.txt").read_text().splitlines()[:3])
        (self.data / "rgb.txt").write_text(only + "\n")
        self.assertEqual(len(self.listed("rgb.txt")), 1)
        for scale in ("depth", "centroid", "first-pair", "truth", "none"):
            result = self.run_data("--solver", "nister-5pt", "--scale", scale)
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_ransac_off_rejects_nothing(self):
        self.assertEqual(self.solve("--solver", "eight-point", "--ransac", "off").returncode, 0)
        for row in self.frames()[1:]:
            self.assertEqual(row["inliers"], row["matches"])

    def test_measures_and_scales_that_do_not_go_with_a_solver_are_refused(self):
        self.refuses(self.solve("--solver", "kabsch", "--error", "sampson"), "error", "point-to-point")
        self.refuses(self.solve("--solver", "two-point", "--rotation", "truth", "--error", "reprojection"), "sampson")
        self.refuses(self.solve("--solver", "p3p", "--scale", "centroid"), "scale", "depth")
        self.refuses(self.solve("--ransac", "sometimes"), "ransac", "two-stage")

    def test_depth_images_alone_tell_the_motion(self):
        shutil.rmtree(self.out)
        for image in ("depth", "normal", "flexion"):
            result = self.run_data("--input", image)
            self.assertEqual(result.returncode, 0, result.stderr)
            evaluation = self.record()["evaluation"]
            self.assertLess(evaluation["ate"]["rmse"], evaluation["static_baseline"]["ate"], image)
        self.refuses(self.run_data("--input", "infrared"), "input", "flexion")


class BadInput(Recording):
    def test_missing_folder(self):
        shutil.rmtree(self.data)
        self.refuses(self.run_data(), "room", "no folder")

    def test_empty_folder(self):
        shutil.rmtree(self.data)
        self.data.mkdir()
        self.refuses(self.run_data(), "rgb.txt")

    def test_empty_list(self):
        (self.data / "rgb.txt").write_text("# color images\n\n")
        self.refuses(self.run_data(), "rgb.txt", "empty")

    def test_listed_file_that_is_missing(self):
        _, file = self.listed("rgb.txt")[3]
        (self.data / file).unlink()
        self.refuses(self.run_data(), "rgb.txt:", file)

    def test_truncated_images(self):
        for name in ("rgb.txt", "depth.txt"):
            with self.subTest(name):
                path = self.data / self.listed(name)[3][1]
                whole = path.read_bytes()
                for size in (0, 10, 1000, len(whole) - 20):
                    path.write_bytes(whole[:size])
                    self.refuses(self.run_data(), path.name)
                path.write_bytes(whole)

    def test_images_of_two_sizes(self):
        _, file = self.listed("rgb.txt")[4]
        write_png(self.data / file, 320, 240, 8, 100)
        self.refuses(self.run_data(), "320 x 240", "640 x 480")

    def test_depth_of_8_bits(self):
        _, file = self.listed("depth.txt")[4]
        write_png(self.data / file, 640, 480, 8, 100)
        self.refuses(self.run_data(), pathlib.Path(file).name, "8 bits", "16-bit")

    def test_calibration_that_makes_no_camera(self):
        camera = (self.data / "camera.yaml").read_text()
        for field, value in (("fx", "0"), ("fx", ".nan"), ("fy", "wide"), ("width", "-640"), ("depth_factor", "0"),
                             ("model", "telescope"), ("distortion", "[1, 2]")):
            with self.subTest(field=field, value=value):
                lines = [l for l in camera.splitlines() if not l.startswith(field + ":")]
                (self.data / "camera.yaml").write_text("\n".join(lines + [f"{field}: {value}"]) + "\n")
                self.refuses(self.run_data(), "camera.yaml", field)

    def test_no_calibration(self):
        (self.data / "camera.yaml").unlink()
        self.refuses(self.run_data(), "--camera")

    def test_times_in_nanoseconds(self):
        self.rewrite("rgb.txt", lambda line: f"{int(float(line.split()[0]) * 1e9)} {line.split()[1]}")
        self.refuses(self.run_data(), "rgb.txt", "seconds")

    def test_times_that_go_back(self):
        lines = (self.data / "rgb.txt").read_text().splitlines()
        (self.data / "rgb.txt").write_text("\n".join(lines + [lines[-1]]) + "\n")
        self.refuses(self.run_data(), "rgb.txt", "increase")

    def test_lists_that_never_match(self):
        self.rewrite("depth.txt", lambda line: f"{float(line.split()[0]) + 1000} {line.split()[1]}")
        self.refuses(self.run_data(), "depth.txt")

    def test_truth_that_does_not_overlap(self):
        self.rewrite("groundtruth.txt", lambda line: " ".join([str(float(line.split()[0]) + 5000)] + line.split()[1:]))
        self.refuses(self.run_data(), "groundtruth.txt", "overlap")

    def test_truth_that_is_not_numbers(self):
        self.rewrite("groundtruth.txt", lambda line: line.replace(line.split()[3], "nan"))
        self.refuses(self.run_data(), "groundtruth.txt:")

    def test_wrong_usage(self):
        self.refuses(self.run_data("--solver", "magic"), "magic")
        self.refuses(self.run_data("--scale", "truth"), "scale")
        self.refuses(self.run_data("--threads", "-1"), "threads")
        self.refuses(framewise("run", self.data), "--out")
        self.refuses(framewise("fly"))
        self.refuses(framewise("simulate", "moon", "--out", self.out), "moon")
        self.refuses(framewise("simulate", "room", "--out", self.out, "--frames", "0"), "frames")

    def test_output_that_cannot_be_written(self):
        self.out.write_text("a file")
        self.refuses(self.run_data(), "out")


class BadDepth(Recording):
    """Odometry from depth alone where depth is none: a status or an error, never a motion that nobody saw."""

    FRAMES = 6
    SIZE = ("--width", 320, "--height", 240)

    def write_depth(self, value, bits=16, frames=slice(None), size=(320, 240)):
        for _, file in self.listed("depth.txt")[frames]:
            write_png(self.data / file, *size, bits, value)

    def run_dark(self, *options):
        return self.run_data("--input", "normal", *options)

    def statuses(self):
        with (self.out / "frames.csv").open(newline="") as file:
            return [row["status"] for row in csv.DictReader(file)]

    def stays(self):
        """No line of the trajectory says a motion, or what is no number."""
        for line in (self.out / "trajectory.tum").read_text().splitlines():
            if not line.startswith("#"):
                self.assertLess(math.hypot(*map(float, line.split()[1:4])), 1e-3, line)

    def test_all_of_it_unknown(self):
        self.write_depth(0)
        for geometry in ("auto", "frame", "none"):
            result = self.run_dark("--geometry", geometry)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn("no motion could be measured", result.stderr)
            self.assertEqual(set(self.statuses()[1:]), {"no-depth"}, geometry)
            self.stays()

    def test_all_of_it_saturated(self):
        self.write_depth(65535)
        camera = (self.data / "camera.yaml").read_text()
        without_maximum = "\n".join(l for l in camera.splitlines() if not l.startswith("depth_max")) + "\n"
        for calibration in (camera, without_maximum):
            (self.data / "camera.yaml").write_text(calibration)
            result = self.run_dark()
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertEqual(set(self.statuses()[1:]), {"no-depth"})
            self.stays()

    def test_some_frames_unknown(self):
        self.write_depth(0, frames=slice(2, 4))
        result = self.run_dark()
        self.assertEqual(result.returncode, 0, result.stderr)
        statuses = self.statuses()
        self.assertEqual(statuses[2:4], ["no-depth"] * 2)
        self.assertEqual((statuses[1], statuses[5]), ("ok", "ok"))

    def test_alternating_sizes(self):
        self.write_depth(5000, frames=slice(1, None, 2), size=(160, 120))
        for image in ("normal", "depth-raw", "auto"):
            self.refuses(self.run_data("--input", image), "160 x 120", "320 x 240")

    def test_8_bits(self):
        self.write_depth(100, bits=8)
        self.refuses(self.run_dark(), "8 bits", "16-bit")

    def test_one_wall_everywhere_frees_directions_and_invents_none(self):
        self.write_depth(10000)
        self.assertIn(self.run_dark().returncode, (0, 1))
        self.assertNotIn("ok", self.statuses()[1:])
        self.stays()


class Archive(Recording):
    def trajectory(self):
        return (self.out / "trajectory.tum").read_bytes()

    def make_archive(self, *options):
        archive = self.work / "matches.h5"
        result = self.run_data("--archive", archive, *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return archive

    def run_archive(self, archive, *options):
        return framewise("run", archive, "--out", self.out, "--quiet", *options)

    def test_solves_again_to_the_byte_without_images(self):
        archive = self.make_archive("--solver", "kabsch", "--seed", 5)
        methods = [("kabsch", "depth"), ("nister-5pt", "depth"), ("nister-5pt", "truth"), ("eight-point", "none")]
        for solver, scale in methods:
            with self.subTest(solver=solver, scale=scale):
                self.run_data("--solver", solver, "--scale", scale, "--seed", 5)
                direct, direct_run = self.trajectory(), json.loads((self.out / "run.json").read_text())
                hidden = self.data.rename(self.work / "hidden")
                for threads in (1, 2):
                    result = self.run_archive(archive, "--solver", solver, "--scale", scale, "--seed", 5, "--threads", threads)
                    self.assertEqual(result.returncode, 0, result.stderr)
                    self.assertEqual(self.trajectory(), direct)
                run = json.loads((self.out / "run.json").read_text())
                self.assertEqual(run["evaluation"], direct_run["evaluation"])
                self.assertEqual(run["dataset"], direct_run["dataset"])
                self.assertEqual(run["archive"]["pairs"], self.FRAMES - 1)
                hidden.rename(self.data)

    def test_has_the_same_bytes_whenever_and_however_it_is_made(self):
        made = set()
        for options in (("--threads", 1), ("--threads", 2), ("--solver", "nister-5pt", "--seed", 3)):
            made.add(self.make_archive(*options).read_bytes())
        self.assertEqual(len(made), 1)

    def test_writing_it_changes_no_trajectory(self):
        self.run_data("--reference", "frame")
        without = self.trajectory()
        self.make_archive()
        self.assertEqual(self.trajectory(), without)

    def test_keeps_the_pairs_that_bridged_a_loss(self):
        for _, file in self.listed("rgb.txt")[5:7]:
            write_png(self.data / file, 640, 480, 8, 90)
        archive = self.make_archive()
        direct = self.trajectory()
        self.assertEqual(self.run_archive(archive).returncode, 0)
        self.assertEqual(self.trajectory(), direct)
        run = json.loads((self.out / "run.json").read_text())
        self.assertEqual(run["archive"]["pairs"], self.FRAMES - 1 + 2)
        self.assertEqual(run["archive"]["missing_pairs"], 0)
        # A method that loses other frames asks for pairs that nobody matched: those frames are lost, and it is said.
        self.assertEqual(self.run_archive(archive, "--min-inliers", 5000).returncode, 1)
        self.assertGreater(json.loads((self.out / "run.json").read_text())["archive"]["missing_pairs"], 0)

    def test_its_matches_keep_the_options_they_were_made_with(self):
        archive = self.make_archive("--features", 400, "--subpixel", "none")
        direct = self.trajectory()
        self.assertEqual(self.run_archive(archive).returncode, 0)
        self.assertEqual(self.trajectory(), direct)
        self.assertEqual(json.loads((self.out / "run.json").read_text())["options"]["features"], 400)
        self.assertEqual(self.run_archive(archive, "--features", 400).returncode, 0)
        self.refuses(self.run_archive(archive, "--features", 500), "matches.h5", "features", "'400'", "'500'")
        config = self.work / "run.yaml"
        config.write_text("subpixel: align\n")
        self.refuses(self.run_archive(archive, "--config", config), "subpixel", "'none'", "'align'")

    def test_what_needs_images_is_refused(self):
        archive = self.make_archive()
        for option, value in (("--camera", self.data / "camera.yaml"), ("--depth-factor", 1000), ("--archive", archive),
                              ("--export-features", self.work / "features")):
            self.refuses(self.run_archive(archive, option, value), "matches.h5", option[2:])

    def test_bad_archives_are_refused(self):
        archive = self.make_archive()
        whole = archive.read_bytes()
        for size in (0, 5, 100, 2000, len(whole) // 2, len(whole) - 1):
            archive.write_bytes(whole[:size])
            self.refuses(self.run_archive(archive), "matches.h5")
        changed = bytearray(whole)
        for at in range(len(whole) // 3, len(whole) // 3 + 64):
            changed[at] ^= 0x5a
        archive.write_bytes(changed)
        self.refuses(self.run_archive(archive), "matches.h5")
        archive.write_text("time x y z\n" * 100)
        self.refuses(self.run_archive(archive), "matches.h5", "HDF5")
        self.refuses(self.run_data("--archive", archive), "matches.h5")
        self.refuses(self.run_data("--archive", self.work / "no" / "folder.h5"), "folder.h5")

    def test_a_run_that_breaks_off_leaves_no_archive(self):
        archive = self.make_archive()
        _, file = self.listed("rgb.txt")[8]
        path = self.data / file
        path.write_bytes(path.read_bytes()[:5000])
        self.refuses(self.run_data("--archive", archive), path.name)
        self.assertEqual(list(self.work.glob("matches*")), [])

    def test_a_full_disk_is_said_in_a_line(self):
        limit = lambda: (signal.signal(signal.SIGXFSZ, signal.SIG_IGN), resource.setrlimit(resource.RLIMIT_FSIZE, (150_000,) * 2))
        result = subprocess.run([FRAMEWISE, "run", str(self.data), "--out", str(self.out), "--quiet", "--archive", str(self.work / "matches.h5")],
                                capture_output=True, text=True, timeout=300, preexec_fn=limit)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        self.assertIn("matches.h5", result.stderr)
        self.assertEqual(list(self.work.glob("matches*")), [])


def rows(numbers, size):
    return [numbers[i:i + size] for i in range(0, len(numbers), size)]


def times(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def transposed(a):
    return [list(row) for row in zip(*a)]


def rotation_of(q):
    x, y, z, w = (c / math.hypot(*q) for c in q)
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]


class Relpose(Recording):
    FIELDS = ["rotation", "translation", "matches", "inliers", "status", "covariance", "euler_deg"]

    def views(self, i, j):
        """Two images of the recording with their depth images."""
        colors, depths = ([self.data / file for _, file in self.listed(name)] for name in ("rgb.txt", "depth.txt"))
        return colors[i], colors[j], depths[i], depths[j]

    def true_motion(self, i, j):
        """R, t of cam2_from_cam1."""
        poses = {line[0]: [float(word) for word in line[1:]] for line in self.listed("groundtruth.txt")}
        poses = [poses[time] for time, _ in self.listed("rgb.txt")]
        (R1, c1), (R2, c2) = ((rotation_of(poses[k][3:]), poses[k][:3]) for k in (i, j))
        back = transposed(R2)
        return times(back, R1), [row[0] for row in times(back, [[a - b] for a, b in zip(c1, c2)])]

    def relpose(self, *arguments):
        return framewise("relpose", *arguments, "--camera", self.data / "camera.yaml")

    def answer(self, *arguments, code=0):
        result = self.relpose(*arguments, "--json")
        self.assertEqual(result.returncode, code, result.stderr)
        answer = json.loads(result.stdout)
        self.assertEqual(list(answer), self.FIELDS)
        return answer

    def angle_deg(self, a, b):
        return math.degrees(math.acos(max(-1, min(1, sum(x * y for x, y in zip(a, b)) / math.hypot(*a) / math.hypot(*b)))))

    def check_rotation(self, answer, R):
        error = times(transposed(rows(answer["rotation"], 3)), R)
        sine = math.hypot(error[2][1] - error[1][2], error[0][2] - error[2][0], error[1][0] - error[0][1]) / 2
        self.assertLess(math.degrees(math.asin(min(1, sine))), 0.1)
        x, y, z = (math.radians(a) for a in answer["euler_deg"])
        Rx = [[1, 0, 0], [0, math.cos(x), -math.sin(x)], [0, math.sin(x), math.cos(x)]]
        Ry = [[math.cos(y), 0, math.sin(y)], [0, 1, 0], [-math.sin(y), 0, math.cos(y)]]
        Rz = [[math.cos(z), -math.sin(z), 0], [math.sin(z), math.cos(z), 0], [0, 0, 1]]
        for found, expected in zip(sum(times(Rz, times(Ry, Rx)), []), answer["rotation"]):
            self.assertAlmostEqual(found, expected, 12)

    def test_finds_the_motion_between_two_images(self):
        image1, image2, _, _ = self.views(0, 10)
        R, t = self.true_motion(0, 10)
        answer = self.answer(image1, image2)
        self.check_rotation(answer, R)
        self.assertAlmostEqual(math.hypot(*answer["translation"]), 1, 12)
        self.assertLess(self.angle_deg(answer["translation"], t), 3)
        self.assertIn(answer["status"], ("ok", "low-parallax"))
        self.assertGreater(answer["inliers"], 50)
        self.assertGreaterEqual(answer["matches"], answer["inliers"])
        covariance = rows(answer["covariance"], 6)
        self.assertEqual(len(covariance), 6)
        for i in range(6):
            self.assertGreater(covariance[i][i], 0)
            for j in range(6):
                self.assertAlmostEqual(covariance[i][j] / math.sqrt(covariance[i][i] * covariance[j][j]),
                                       covariance[j][i] / math.sqrt(covariance[i][i] * covariance[j][j]), 6)

    def test_depth_gives_metres(self):
        image1, image2, depth1, depth2 = self.views(0, 10)
        R, t = self.true_motion(0, 10)
        for options in ((), ("--solver", "nister-5pt")):
            answer = self.answer(image1, image2, "--depth1", depth1, "--depth2", depth2, *options)
            self.check_rotation(answer, R)
            self.assertLess(math.dist(answer["translation"], t), 0.01)

    def test_the_motion_back_is_the_inverse(self):
        image1, image2, depth1, depth2 = self.views(0, 5)
        there = self.answer(image1, image2, "--depth1", depth1, "--depth2", depth2)
        self.check_rotation(there, transposed(rows(self.answer(image2, image1)["rotation"], 3)))

    def test_repeats_itself_and_draws(self):
        image1, image2, _, _ = self.views(0, 5)
        drawing = self.work / "matches.png"
        said = {self.relpose(image1, image2, "--json", "--draw", drawing, "--threads", n).stdout for n in (1, 2)}
        self.assertEqual(len(said), 1)
        width, height = struct.unpack(">II", drawing.read_bytes()[16:24])
        self.assertEqual((width, height), (1280, 480))
        text = self.relpose(image1, image2).stdout
        for word in ("rotation", "translation", "matches", "deg"):
            self.assertIn(word, text)
        self.assertEqual(self.relpose(image1, image2, "--quiet").stdout, "")

    def test_exports_features_as_text(self):
        image1, image2, _, _ = self.views(0, 1)
        for folder in ("a", "b"):
            self.assertEqual(self.relpose(image1, image2, "--export-features", self.work / folder).returncode, 0)
        for name, image in (("image1.txt", image1), ("image2.txt", image2)):
            text = (self.work / "a" / name).read_text()
            self.assertEqual(text, (self.work / "b" / name).read_text())
            head, *lines = text.splitlines()
            self.assertTrue(head.startswith(f"# {image.name}: x y size angle_deg response octave, 32 bytes"), head)
            self.assertGreater(len(lines), 300)
            for line in lines:
                self.assertEqual(len([float(word) for word in line.split()]), 6 + 32)
        self.run_data("--export-features", self.work / "c")
        self.assertEqual(len(list((self.work / "c").iterdir())), self.FRAMES)
        self.assertEqual((self.work / "c" / "frame_000001.txt").read_text(), (self.work / "a" / "image2.txt").read_text())

    def test_images_that_show_nothing_are_lost(self):
        image1, image2, _, depth2 = self.views(0, 1)
        write_png(image2, 640, 480, 8, 0)
        for pair in ((image1, image2), (image2, image1), (image2, image2)):
            answer = self.answer(*pair, "--draw", self.work / "lost.png", "--export-features", self.work / "none", code=1)
            self.assertEqual(answer["status"], "lost")
            self.assertEqual(answer["inliers"], 0)
            for field in ("rotation", "translation", "covariance", "euler_deg"):
                self.assertIsNone(answer[field])
        self.assertEqual(len(self.relpose(image1, image2, "--quiet").stderr.splitlines()), 1)

    def test_images_of_16_bits_and_with_alpha_are_taken_as_gray(self):
        image1, image2, _, _ = self.views(0, 1)
        for bits, color_type in ((16, 0), (16, 2), (8, 6), (16, 6)):
            write_png(image2, 640, 480, bits, 77, color_type)
            self.assertEqual(self.answer(image1, image2, code=1)["status"], "lost")

    def test_depth_that_knows_nothing_says_so(self):
        image1, image2, depth1, depth2 = self.views(0, 1)
        write_png(depth2, 640, 480, 16, 0)
        self.assertEqual(self.answer(image1, image2, "--depth1", depth1, "--depth2", depth2, code=1)["status"], "no-depth")

    def test_bad_input_is_refused(self):
        image1, image2, depth1, depth2 = self.views(0, 1)
        small = self.work / "small.png"
        for size in ((1, 1), (320, 240)):
            write_png(small, *size, 8, 90)
            self.refuses(self.relpose(image1, small), "small.png", "640 x 480")
        write_png(small, 640, 480, 8, 90)
        self.refuses(self.relpose(image1, image2, "--depth1", small, "--depth2", depth2), "small.png", "16-bit")
        self.refuses(self.relpose(image1, image2, "--depth1", depth1), "depth2")
        small.write_bytes(image1.read_bytes()[:3000])
        self.refuses(self.relpose(small, image2), "small.png")
        small.write_text("no image")
        self.refuses(self.relpose(small, image2), "small.png")
        self.refuses(self.relpose(self.work / "nothing.png", image2), "nothing.png")
        self.refuses(self.relpose(image1, image2, "--solver", "kabsch"), "--depth1")
        self.refuses(self.relpose(image1, image2, "--solver", "magic"), "magic")
        self.refuses(self.relpose(image1, image2, "--scale", "truth"), "scale")
        self.refuses(self.relpose(image1, image2, "--draw", self.work / "drawing.nothing"), "drawing.nothing")
        self.refuses(self.relpose(image1, image2, "--export-features", small), "small.png")
        self.refuses(framewise("relpose", image1, image2), "--camera")
        self.refuses(framewise("relpose", image1, image2, "--camera", self.work / "none.yaml"), "none.yaml")


class Evaluate(Recording):
    def test_the_truth_against_itself_is_perfect(self):
        result = framewise("evaluate", self.data / "groundtruth.txt", self.data / "groundtruth.txt", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        answer = json.loads(result.stdout)
        self.assertLess(answer["ate"]["rmse"], 1e-9)
        self.assertLess(answer["rpe"]["rotation_deg"]["max"], 1e-5)
        for key in ("rmse", "mean", "median", "std", "min", "max"):
            self.assertIn(key, answer["ate"])
            self.assertIn(key, answer["rpe"]["translation"])
        for key in ("alignment", "scale", "delta", "unit", "matched", "coverage", "path_length"):
            self.assertIn(key, answer)
        for key in ("ate", "rpe_translation", "rpe_rotation_deg"):
            self.assertIn(key, answer["static_baseline"])

    def test_a_data_set_with_truth_is_a_reference(self):
        self.run_data()
        of_file = framewise("evaluate", self.data / "groundtruth.txt", self.out / "trajectory.tum")
        of_folder = framewise("evaluate", self.data, self.out / "trajectory.tum")
        self.assertEqual(of_file.returncode, 0, of_file.stderr)
        self.assertEqual(of_folder.returncode, 0, of_folder.stderr)
        for text in (of_file.stdout, of_folder.stdout):
            for word in ("ATE", "RPE", "alignment", "coverage", "path", "never moved"):
                self.assertIn(word, text)

    def test_what_cannot_be_evaluated_is_refused(self):
        self.refuses(framewise("evaluate", self.data / "nothing.txt", self.data / "groundtruth.txt"), "nothing.txt")
        (self.work / "empty.txt").write_text("# nothing\n")
        self.refuses(framewise("evaluate", self.data / "groundtruth.txt", self.work / "empty.txt"), "empty.txt")
        self.refuses(framewise("evaluate", self.data / "groundtruth.txt", self.data / "groundtruth.txt", "--align", "x"))
        self.refuses(framewise("evaluate", self.data / "groundtruth.txt", self.data / "groundtruth.txt", "--delta", "0"))

    def trajectory(self, name, poses):
        """A TUM file of (time, x, y, z) without turns."""
        path = self.work / name
        path.write_text("".join(f"{t} {x} {y} {z} 0 0 0 1\n" for t, x, y, z in poses))
        return path

    def test_trajectories_that_make_no_figure_are_refused(self):
        line = [(i, 0.1 * i, 0, 0) for i in range(5)]
        truth = self.trajectory("truth.txt", line)
        for name, poses, words in (("none.txt", [], ("none.txt", "no poses")),
                                   ("one.txt", line[:1], ("expected 2 or more",)),
                                   ("nan.txt", [line[0], (1, "nan", 0, 0)], ("nan.txt:2", "tx", "'nan'")),
                                   ("inf.txt", [line[0], (1, "inf", 0, 0)], ("inf.txt:2", "tx")),
                                   ("later.txt", [(t + 100, x, y, z) for t, x, y, z in line], ("no pose", "in time")),
                                   ("back.txt", line[::-1], ("back.txt:2", "timestamp"))):
            with self.subTest(name):
                self.refuses(framewise("evaluate", truth, self.trajectory(name, poses)), *words)
        self.refuses(framewise("evaluate", truth, self.work), "a folder")
        self.refuses(framewise("evaluate", truth, truth, "--align", "sim3", "--estimate-scale", "0"), "estimate_scale")
        still = self.trajectory("still.txt", [(t, 1, 2, 3) for t, *_ in line])
        self.refuses(framewise("evaluate", truth, still, "--align", "sim3"), "never moves")

    def test_options_that_make_no_sense_are_refused(self):
        truth = self.trajectory("truth.txt", [(i, 0.1 * i, 0, 0) for i in range(5)])
        for options in (("--unit", "furlongs"), ("--pairs", "some"), ("--plane", "xx"), ("--association", "any"),
                        ("--preset", "other"), ("--delta", "0.5"), ("--tolerance", "-1"), ("--max-difference", "-1"),
                        ("--from-time", "3", "--to-time", "1"), ("--metric", "ate"), ("--poses-to-align", "-1"),
                        ("--save-results", self.work / "r.zip", "--metric", "ape"),
                        ("--save-results", self.work / "r.zip", "--metric", "rpe-rotation", "--delta", "9"),
                        ("--times", self.trajectory("times.txt", []))):
            with self.subTest(options):
                self.refuses(framewise("evaluate", truth, truth, *options))

    def test_results_that_cannot_be_written_are_refused(self):
        truth = self.trajectory("truth.txt", [(i, 0.1 * i, 0, 0) for i in range(5)])
        for path in (self.work / "nowhere" / "r.zip", self.work, truth / "r.zip", "/dev/full/r.zip"):
            with self.subTest(path):
                self.refuses(framewise("evaluate", truth, truth, "--save-results", path), str(path), "--save-results")

    def test_results_have_the_same_bytes_every_time_and_are_a_zip_file(self):
        truth = self.trajectory("truth.txt", [(i, 0.1 * i, 0, 0) for i in range(5)])
        first, second = self.work / "a.zip", self.work / "b.zip"
        for path in (first, second):
            done = framewise("evaluate", truth, truth, "--align", "none", "--quiet", "--save-results", path)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual(first.read_bytes(), second.read_bytes())
        with zipfile.ZipFile(first) as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual(json.loads(archive.read("stats.json"))["rmse"], 0)
            self.assertEqual(json.loads(archive.read("info.json"))["est_name"], "truth.txt")
            self.assertEqual({i.filename for i in archive.infolist() if i.filename.endswith(".tum")},
                             {"truth.txt.tum", "reference_truth.txt.tum"})

    def kitti(self, name, count):
        path = self.work / name
        path.write_text("".join(f"1 0 0 {0.1 * i} 0 1 0 0 0 0 1 0\n" for i in range(count)))
        return path

    def test_poses_without_stamps_are_matched_by_their_place_or_take_stamps_from_a_file(self):
        a, b, shorter = self.kitti("a.txt", 5), self.kitti("b.txt", 5), self.kitti("short.txt", 4)
        stamps = self.work / "times.txt"
        stamps.write_text("".join(f"{10 + i}\n" for i in range(5)))
        truth = self.trajectory("truth.txt", [(10 + i, 0.1 * i, 0, 0) for i in range(5)])

        done = framewise("evaluate", a, b, "--align", "none", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["matched"], 5)
        self.refuses(framewise("evaluate", a, shorter), "5 poses", "4")
        self.refuses(framewise("evaluate", a, b, "--unit", "seconds"), "without stamps", "--times")
        self.refuses(framewise("evaluate", truth, b), "b.txt", "without stamps", "--times")
        self.refuses(framewise("evaluate", truth, shorter, "--times", stamps), "times.txt")
        for pair in ((truth, b), (b, truth), (a, b)):
            done = framewise("evaluate", *pair, "--times", stamps, "--delta", "1", "--unit", "seconds", "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(json.loads(done.stdout)["matched"], 5)

    def test_euroc_is_read_too(self):
        truth = self.trajectory("truth.txt", [(10 + i, 0.1 * i, 0, 0) for i in range(5)])
        euroc = self.work / "data.csv"
        euroc.write_text("#timestamp [ns],x,y,z,qw,qx,qy,qz\n"
                         + "".join(f"{(10 + i) * 10**9},{0.1 * i},0,0,1,0,0,0\n" for i in range(5)))
        done = framewise("evaluate", euroc, truth, "--align", "none", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        answer = json.loads(done.stdout)
        self.assertEqual(answer["matched"], 5)
        self.assertLess(answer["ate"]["max"], 1e-12)
        self.assertLess(answer["ate_rotation_deg"]["max"], 1e-6)


def read_png(path):
    """Width, height, bits and the values of a gray PNG."""
    data, place, compressed = path.read_bytes(), 8, b""
    while place < len(data):
        size, = struct.unpack(">I", data[place:place + 4])
        kind, chunk = data[place + 4:place + 8], data[place + 8:place + 8 + size]
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", chunk[:10])
            assert color == 0, "not gray"
        elif kind == b"IDAT":
            compressed += chunk
        place += 12 + size
    raw, step, values, above = zlib.decompress(compressed), bits // 8, [], bytearray(width * bits // 8)
    for v in range(height):
        begin = v * (width * step + 1)
        how, row = raw[begin], bytearray(raw[begin + 1:begin + 1 + width * step])
        for i in range(len(row)):
            left, over = (row[i - step] if i >= step else 0), above[i]
            corner = above[i - step] if i >= step else 0
            paeth = min((left, over, corner), key=lambda c: abs(left + over - corner - c))
            row[i] = (row[i] + (0, left, over, (left + over) // 2, paeth)[how]) & 255
        values += struct.unpack(f">{width}{'H' if bits == 16 else 'B'}", row)
        above = row
    return width, height, bits, values


class Flexion(Recording):
    FRAMES = 3
    WIDTH, HEIGHT = 160, 120
    SIZE = ("--width", WIDTH, "--height", HEIGHT)

    def flexion(self, *options, depth=None):
        return framewise("flexion", depth or self.data / "depth", "--camera", self.data / "camera.yaml", "--out", self.out,
                         "--quiet", *options)

    def images(self):
        return sorted(self.out.glob("*"))

    def test_writes_an_image_for_every_depth_image_under_its_name(self):
        result = self.flexion("--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        names = sorted(path.name for path in (self.data / "depth").iterdir())
        self.assertEqual([path.name for path in self.images()], names)
        record = json.loads(result.stdout)
        self.assertEqual([pathlib.Path(image["output"]).name for image in record["images"]], names)
        self.assertGreater(record["images"][0]["known"], 0.9)
        width, height, bits, values = read_png(self.images()[0])
        self.assertEqual((width, height, bits), (self.WIDTH, self.HEIGHT, 16))
        self.assertEqual(set(values[:width]), {0})  # the border
        self.assertGreater(sorted(values)[len(values) // 2], 30000)

    def test_every_kind_in_every_format(self):
        one = sorted((self.data / "depth").iterdir())[0]
        for kind in ("flexion", "normal", "shaded", "depth"):
            for format, extension in (("16", ".png"), ("8", ".png"), ("float", ".tiff")):
                with self.subTest(kind=kind, format=format):
                    result = self.flexion("--kind", kind, "--format", format, depth=one)
                    self.assertEqual(result.returncode, 0, result.stderr)
                    path = self.out / (one.stem + extension)
                    self.assertTrue(path.exists())
                    if extension == ".png":
                        self.assertEqual(read_png(path)[2], int(format))
                    shutil.rmtree(self.out)

    def test_depth_alone_is_returned_as_it_was(self):
        one = sorted((self.data / "depth").iterdir())[0]
        self.assertEqual(self.flexion("--kind", "depth", depth=one).returncode, 0)
        self.assertEqual(read_png(self.out / one.name), read_png(one))
        # Float metres written by one run are read by another, and say the same.
        self.assertEqual(self.flexion("--kind", "depth", "--format", "float", depth=one).returncode, 0)
        again = self.work / "again"
        tiff = self.out / (one.stem + ".tiff")
        result = framewise("flexion", tiff, "--camera", self.data / "camera.yaml", "--kind", "depth", "--out", again, "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(read_png(again / one.name), read_png(one))

    def test_filling_and_equalising_leave_nothing_black(self):
        holed = self.work / "holed.png"
        write_png(holed, self.WIDTH, self.HEIGHT, 16, lambda u, v: 5000 + 20 * u if (u // 8 + v // 8) % 3 else 0)
        result = self.flexion("--kind", "depth", "--fill", "--clahe", "--json", depth=holed)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(json.loads(result.stdout)["images"][0]["known"], 1)
        self.assertEqual(json.loads(result.stdout)["format"], "8")

    def test_densify_says_which_pixels_were_measured(self):
        width, height = 64, 48
        sparse = self.work / "sparse.png"
        write_png(sparse, width, height, 16, lambda u, v: 2000 if v % 5 == 2 and u % 2 == 0 else 0)
        camera = self.work / "small.yaml"
        camera.write_text(f"width: {width}\nheight: {height}\nfx: 50\nfy: 50\ncx: 32\ncy: 24\ndepth_factor: 1000\n")
        result = framewise("flexion", sparse, "--camera", camera, "--kind", "depth", "--densify", "--masks", "--out", self.out,
                           "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(set(read_png(self.out / "sparse.png")[3]), {2000})
        mask = read_png(self.out / "sparse_mask.png")[3]
        self.assertEqual([v == 255 for v in mask], [v > 0 for v in read_png(sparse)[3]])
        self.assertEqual(set(mask), {128, 255})

    def test_repeats_itself_to_the_byte_at_any_thread_count(self):
        for options in ((), ("--smooth", "4", "--kind", "normal"), ("--densify", "--fill", "--kind", "depth", "--clahe")):
            answers = set()
            for threads in (1, 2, 3):
                self.assertEqual(self.flexion("--threads", threads, *options).returncode, 0)
                answers.add(b"".join(path.read_bytes() for path in self.images()))
            self.assertEqual(len(answers), 1)

    def test_keeps_what_was_computed_before_a_failure(self):
        files = sorted((self.data / "depth").iterdir())
        files[2].write_bytes(files[2].read_bytes()[:4000])
        self.refuses(self.flexion(), files[2].name)
        self.assertEqual([path.name for path in self.images()], [path.name for path in files[:2]])

    def test_says_how_far_it_is_on_standard_error(self):
        result = framewise("flexion", self.data / "depth", "--camera", self.data / "camera.yaml", "--out", self.out)
        self.assertIn(f"{self.FRAMES} of {self.FRAMES}", result.stderr)
        self.assertEqual(self.flexion().stderr, "")

    def test_bad_input(self):
        depth = sorted((self.data / "depth").iterdir())
        self.refuses(self.flexion(depth=self.work / "nothing.png"), "nothing.png", "no file")
        empty = self.work / "empty"
        empty.mkdir()
        self.refuses(self.flexion(depth=empty), "empty", "depth images")
        color = sorted((self.data / "rgb").iterdir())[0]
        self.refuses(self.flexion(depth=color), color.name, "16-bit")
        small = self.work / "small.png"
        write_png(small, 32, 24, 16, 1000)
        self.refuses(self.flexion(depth=small), "small.png", "32 x 24", f"{self.WIDTH} x {self.HEIGHT}")
        whole = depth[0].read_bytes()
        for size in (0, 10, 1000, len(whole) - 20):
            depth[0].write_bytes(whole[:size])
            self.refuses(self.flexion(depth=depth[0]), depth[0].name)
        self.refuses(self.flexion("--camera", self.work / "nothing.yaml"))
        self.refuses(framewise("flexion", depth[1], "--camera", self.work / "nothing.yaml", "--out", self.out), "nothing.yaml")
        self.refuses(framewise("flexion", depth[1], "--camera", self.data / "camera.yaml", "--out", self.data / "depth"),
                     depth[1].name, "overwritten")
        twin = self.work / depth[1].name
        shutil.copy(depth[1], twin)
        self.refuses(framewise("flexion", depth[1], twin, "--camera", self.data / "camera.yaml", "--out", self.out), twin.name)

    def test_wrong_usage(self):
        for options, word in ((("--kind", "curvature"), "kind"), (("--form", "bent"), "form"), (("--format", "12"), "format"),
                              (("--distance", "0"), "distance"), (("--smooth", "-1"), "sigma"), (("--smooth", "99"), "sigma"),
                              (("--clahe", "--format", "16"), "format"), (("--depth-type", "far"), "depth-type"),
                              (("--depth-factor", "0"), "depth-factor"), (("--depth-max", "nan"), "depth-max"),
                              (("--threads", "-1"), "threads"), (("--light", "0", "0", "0", "--kind", "shaded"), "light"),
                              (("--masks",), "densify"), (("--densify", "--densify-reach", "0"), "reach")):
            with self.subTest(options=options):
                self.refuses(self.flexion(*options), word)

    def test_an_image_without_depth_is_black(self):
        nothing = self.work / "nothing.png"
        write_png(nothing, self.WIDTH, self.HEIGHT, 16, 0)
        for options in ((), ("--smooth", "3"), ("--fill",), ("--densify", "--kind", "depth"),
                        ("--kind", "depth", "--fill", "--clahe"), ("--kind", "normal")):
            with self.subTest(options=options):
                result = self.flexion(*options, depth=nothing)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(set(read_png(self.out / "nothing.png")[3]), {0})

    def test_ranges_of_an_equirectangular_scanner(self):
        scan = self.work / "scan.png"
        write_png(scan, 64, 32, 16, 30000)  # a sphere around the scanner
        camera = self.work / "scanner.yaml"
        camera.write_text("model: equirectangular\nwidth: 64\nheight: 32\ntheta_range_deg: [45, 135]\ndepth_max: 20\n")
        result = framewise("flexion", scan, "--camera", camera, "--form", "normalised", "--out", self.out, "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        values = read_png(self.out / "scan.png")[3]
        self.assertGreater(min(v for v in values if v > 0), 65000)
        result = framewise("flexion", scan, "--camera", camera, "--depth-type", "z", "--out", self.out, "--quiet")
        self.refuses(result, "depth_type", "range")


class Datasets(Recording):
    """Recordings that are not in the TUM benchmark's layout, made of one that is."""

    WIDTH, HEIGHT = 320, 240
    SIZE = ("--width", WIDTH, "--height", HEIGHT)

    def poses(self):
        """The truth of each frame as 4x4 rows, world_from_camera."""
        return [matrix_of(*quaternion_pose(self.listed("groundtruth.txt"), float(time))) for time, _ in self.listed("rgb.txt")]

    def make_kitti(self):
        folder = self.work / "07"
        (folder / "image_0").mkdir(parents=True)
        for i, (_, file) in enumerate(self.listed("rgb.txt")):
            shutil.copy(self.data / file, folder / "image_0" / f"{i:06}.png")
        camera = dict(l.split(": ") for l in (self.data / "camera.yaml").read_text().splitlines() if ": " in l)
        (folder / "calib.txt").write_text(f"P0: {camera['fx']} 0 {camera['cx']} 0 0 {camera['fy']} {camera['cy']} 0 0 0 1 0\n")
        (folder / "times.txt").write_text("".join(f"{float(time)}\n" for time, _ in self.listed("rgb.txt")))
        (folder / "poses.txt").write_text("".join(" ".join(map(str, sum(m[:3], []))) + "\n" for m in self.poses()))
        return folder

    def make_seven_scenes(self):
        folder = self.work / "kitchen"
        folder.mkdir()
        camera = (self.data / "camera.yaml").read_text().replace("depth_factor: 5000", "depth_factor: 5000\n")
        (folder / "camera.yaml").write_text(camera)
        for i, ((_, color), (_, depth), pose) in enumerate(zip(self.listed("rgb.txt"), self.listed("depth.txt"), self.poses())):
            shutil.copy(self.data / color, folder / f"frame-{i:06}.color.png")
            shutil.copy(self.data / depth, folder / f"frame-{i:06}.depth.png")
            (folder / f"frame-{i:06}.pose.txt").write_text("\n".join(" ".join(map(str, row)) for row in pose) + "\n")
        return folder

    def inspect(self, folder, *options):
        result = framewise("inspect", folder, "--json", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def test_inspect_says_what_it_recognised_and_why(self):
        for folder, format, why in ((self.data, "tum", "rgb.txt"), (self.make_kitti(), "kitti", "image_0"),
                                    (self.make_seven_scenes(), "7-scenes", "frame-000000.color.png")):
            with self.subTest(format):
                answer = self.inspect(folder)
                self.assertEqual(answer["format"], format)
                self.assertIn(why, answer["recognised_by"])
                self.assertEqual((answer["image"]["width"], answer["image"]["height"]), (self.WIDTH, self.HEIGHT))
                self.assertEqual(answer["frames"]["count"], self.FRAMES)
                self.assertAlmostEqual(answer["frames"]["rate"]["per_second"], 30, 1)
                self.assertEqual(answer["truth"]["coverage"], 1)
                self.assertEqual(answer["warnings"], [])
                text = framewise("inspect", folder).stdout
                self.assertIn(format, text)
                self.assertIn("no usual mistake", text)
                self.assertEqual(framewise("inspect", folder, "--quiet").stdout, "")

    def test_every_layout_gives_the_same_trajectory(self):
        self.assertEqual(self.run_data("--solver", "kabsch").returncode, 0)
        expected = [line.split()[1:] for line in (self.out / "trajectory.tum").read_text().splitlines()[1:]]
        result = framewise("run", self.make_seven_scenes(), "--solver", "kabsch", "--out", self.out, "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([line.split()[1:] for line in (self.out / "trajectory.tum").read_text().splitlines()[1:]], expected)

    def test_a_data_set_of_any_format_is_a_reference(self):
        folder = self.make_kitti()
        result = framewise("run", folder, "--solver", "nister-5pt", "--scale", "truth", "--out", self.out, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        own = json.loads(result.stdout)["evaluation"]
        result = framewise("evaluate", folder, self.out / "trajectory.tum", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertAlmostEqual(json.loads(result.stdout)["ate"]["rmse"], own["ate"]["rmse"], 9)
        self.refuses(framewise("evaluate", self.data / "rgb", self.out / "trajectory.tum"), "no truth")

    def test_without_depth_a_map_is_the_default_and_its_scale_is_its_own(self):
        folder = self.make_kitti()
        for options, reference, alignment in (((), "map", "sim3"), (("--scale", "truth"), "map", "se3"),
                                              (("--solver", "nister-5pt", "--scale", "none"), "frame", "sim3")):
            result = framewise("run", folder, "--out", self.out, "--json", *options)
            self.assertEqual(result.returncode, 0, result.stderr)
            run = json.loads(result.stdout)
            self.assertEqual(run["options"]["reference"], reference)
            self.assertEqual(run["evaluation"]["alignment"], alignment)
        self.refuses(framewise("run", folder, "--out", self.out, "--scale", "first-pair"), "depth")

    def test_a_folder_of_images_needs_a_camera(self):
        images = self.data / "rgb"
        self.refuses(framewise("run", images, "--out", self.out, "--solver", "nister-5pt", "--scale", "none"), "--camera")
        result = framewise("run", images, "--camera", self.data / "camera.yaml", "--solver", "nister-5pt", "--scale", "none",
                           "--out", self.out, "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        warnings = {warning["name"] for warning in self.inspect(images)["warnings"]}
        self.assertEqual(warnings, {"calibration"})

    def test_depth_alone_has_no_colour(self):
        depth = self.data / "depth"
        self.refuses(framewise("inspect", depth), "16-bit", "--depth-factor")
        options = ("--camera", self.data / "camera.yaml", "--depth-factor", "5000")
        self.refuses(framewise("run", depth, "--out", self.out, *options), "colour", "--input")
        answer = self.inspect(depth, *options)
        self.assertEqual(answer["frames"]["with_color"], 0)
        self.assertGreater(answer["depth"]["metres"]["p50"], 1)

    def test_options_of_images_are_refused_for_an_archive(self):
        archive = self.work / "a.h5"
        self.assertEqual(self.run_data("--archive", archive).returncode, 0)
        for option, value in (("--format", "tum"), ("--fps", "10"), ("--depth-type", "z"), ("--register-depth", "false")):
            self.refuses(framewise("run", archive, "--out", self.out, option, value), option[2:], "archive")

    def test_wrong_usage(self):
        for options, words in ((("--format", "kinect"), ("kinect", "euroc")), (("--depth-type", "far"), ("depth-type",)),
                               (("--fps", "0"), ("fps",)), (("--depth-factor", "-1"), ("depth-factor",))):
            self.refuses(framewise("inspect", self.data, *options), *words)

    def test_each_format_refuses_an_empty_folder(self):
        empty = self.work / "empty"
        empty.mkdir()
        self.refuses(framewise("inspect", empty), "rgb.txt", "mav0")
        for format in ("tum", "putkk", "icl-nuim", "7-scenes", "kitti", "kitti-depth", "euroc", "blender", "hololens", "depth",
                       "images", "video"):
            self.refuses(framewise("run", empty, "--format", format, "--out", self.out), "empty")
            self.refuses(framewise("run", self.work / "gone", "--format", format, "--out", self.out), "gone")

    def test_truncated_images_are_named(self):
        for folder, file in ((self.make_kitti(), "image_0/000005.png"), (self.make_seven_scenes(), "frame-000004.depth.png")):
            whole = (folder / file).read_bytes()
            for size in (0, 10, 1000, len(whole) - 20):
                (folder / file).write_bytes(whole[:size])
                solver = ("--solver", "nister-5pt", "--scale", "none") if "image_0" in file else ()
                self.refuses(framewise("run", folder, "--out", self.out, "--quiet", *solver), pathlib.Path(file).name)

    def test_a_calibration_of_another_size(self):
        camera = self.work / "other.yaml"
        camera.write_text((self.data / "camera.yaml").read_text().replace(f"width: {self.WIDTH}", "width: 640"))
        for folder in (self.data, self.make_kitti(), self.make_seven_scenes(), self.data / "rgb"):
            self.refuses(framewise("run", folder, "--camera", camera, "--out", self.out, "--quiet", "--solver", "nister-5pt",
                                   "--scale", "none"), f"{self.WIDTH} x {self.HEIGHT}", f"640 x {self.HEIGHT}")

    def test_one_frame_is_a_recording(self):
        folder = self.make_seven_scenes()
        for path in folder.glob("frame-*"):
            if "000000" not in path.name:
                path.unlink()
        self.assertEqual(framewise("run", folder, "--out", self.out, "--quiet").returncode, 0)
        self.assertEqual(self.inspect(folder)["frames"]["count"], 1)

    def test_a_hundred_thousand_frames_are_listed_in_little_memory(self):
        folder = self.work / "long"
        folder.mkdir()
        for i in range(100_000):
            if i % 10_000 == 0:  # a file has only so many names
                image = folder / f"{i}.png"
                write_png(image, 32, 24, 8, lambda u, v: (37 * u + 11 * v) % 256)
            else:
                os.link(image, folder / f"{i}.png")
        camera = self.work / "small.yaml"
        camera.write_text("width: 32\nheight: 24\nfx: 30\nfy: 30\ncx: 16\ncy: 12\n")
        limit = lambda: resource.setrlimit(resource.RLIMIT_DATA, (400 << 20,) * 2)
        result = subprocess.run([FRAMEWISE, "inspect", str(folder), "--camera", str(camera), "--json"], capture_output=True,
                                text=True, timeout=300, preexec_fn=limit)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(json.loads(result.stdout)["frames"]["count"], 100_000)


class Mistakes(Recording):
    """`inspect` finds each mistake that is made on purpose."""

    FRAMES = 20
    SIZE = ("--width", 320, "--height", 240)

    def warnings(self, *options):
        result = framewise("inspect", self.data, "--json", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return {warning["name"]: warning["text"] for warning in json.loads(result.stdout)["warnings"]}

    def rewrite_poses(self, change):
        """change: 4x4 rows -> 4x4 rows, of every pose of the truth."""
        def line(text):
            words = [float(word) for word in text.split()]
            moved = change(matrix_of(words[1:4], words[4:8]))
            return " ".join(map(repr, [words[0], *[row[3] for row in moved[:3]], *quaternion_of(moved)]))
        self.rewrite("groundtruth.txt", line)

    def test_none_is_found_where_none_was_made(self):
        self.assertEqual(self.warnings(), {})

    def test_quaternions_in_the_other_order(self):
        def w_first(line):
            t, x, y, z, qx, qy, qz, qw = line.split()
            return " ".join([t, x, y, z, qw, qx, qy, qz])
        self.rewrite("groundtruth.txt", w_first)
        self.assertEqual(set(self.warnings()), {"quaternion-order"})

    def test_poses_the_other_way_round(self):
        self.rewrite_poses(inverse)
        self.assertEqual(set(self.warnings()), {"pose-direction"})

    def test_poses_of_a_body(self):
        body_from_camera = [[0, 0, 1, 0], [-1, 0, 0, 0.05], [0, -1, 0, 0], [0, 0, 0, 1]]
        self.rewrite_poses(lambda pose: product(pose, inverse(body_from_camera)))
        warnings = self.warnings()
        self.assertEqual(set(warnings), {"body-frame"})
        self.assertAlmostEqual(float(re.search(r"by (\d+) degrees", warnings["body-frame"])[1]), 120, delta=6)

    def test_quaternions_that_are_none(self):
        def shifted(line):
            t, x, y, z, qx, qy, qz, qw = line.split()
            return " ".join([t, x, y, z, str(2 * float(qx)), qy, qz, qw])
        self.rewrite("groundtruth.txt", shifted)
        self.assertIn("quaternion-length", self.warnings())

    def test_a_wrong_depth_factor(self):
        self.assertIn("depth-factor", self.warnings("--depth-factor", "100", "--depth-max", "500"))
        warnings = self.warnings("--depth-factor", "2000", "--depth-max", "50")
        self.assertEqual(set(warnings), {"depth-factor"})
        self.assertIn("2.5", warnings["depth-factor"])

    def test_depth_that_is_not_registered(self):
        # The simulator's depth is; taken for another camera's, it is moved away by 262 x 0.2 m / 3.5 m = 15 pixels.
        camera = self.work / "unregistered.yaml"
        text = (self.data / "camera.yaml").read_text()
        own = "".join("  " + l + "\n" for l in text.splitlines() if l.split(":")[0] in ("width", "height", "fx", "fy", "cx", "cy"))
        camera.write_text(text + "depth_camera:\n" + own + "  camera_from_depth_camera: [1, 0, 0, 0.2, 0, 1, 0, 0, 0, 0, 1, 0]\n")
        self.assertIn("depth-registered", self.warnings("--camera", camera))

    def test_colour_and_depth_out_of_step(self):
        self.rewrite("depth.txt", lambda line: f"{float(line.split()[0]) + 0.014:.6f} {line.split()[1]}")
        self.assertEqual(set(self.warnings()), {"in-step"})

    def test_lists_that_hardly_match(self):
        lines = (self.data / "depth.txt").read_text().splitlines()
        (self.data / "depth.txt").write_text("\n".join(lines[:2] + lines[2::3]) + "\n")
        self.assertEqual(set(self.warnings()), {"lists-match"})

    def test_lists_that_never_match(self):
        self.rewrite("depth.txt", lambda line: f"{float(line.split()[0]) + 1000} {line.split()[1]}")
        self.refuses(framewise("inspect", self.data), "depth.txt", "within 0.02 s")

    def test_truth_that_covers_half(self):
        lines = (self.data / "groundtruth.txt").read_text().splitlines()
        (self.data / "groundtruth.txt").write_text("\n".join(lines[:3 + (len(lines) - 3) // 2]) + "\n")
        self.assertEqual(set(self.warnings()), {"truth-coverage"})

    def test_stamps_in_other_units(self):
        for name in ("rgb.txt", "depth.txt", "groundtruth.txt"):
            self.rewrite(name, lambda line: " ".join([f"{1e3 * float(line.split()[0]):.3f}"] + line.split()[1:]))
        self.assertIn("milli", self.warnings("--max-truth-gap", "100", "--max-time-difference", "20")["time-unit"])
        for name in ("rgb.txt", "depth.txt", "groundtruth.txt"):
            self.rewrite(name, lambda line: " ".join([f"{1e6 * float(line.split()[0]):.0f}"] + line.split()[1:]))
        self.refuses(framewise("inspect", self.data), "rgb.txt", "nano")

    def test_two_runs_in_one_recording(self):
        def twice(name, later, move=0.0):
            lines = [l.split() for l in (self.data / name).read_text().splitlines() if not l.startswith("#")]
            moved = [[f"{float(l[0]) + later:.6f}", *([str(float(l[1]) + move)] if move else l[1:2]), *l[2:]] for l in lines]
            (self.data / name).write_text("\n".join(" ".join(l) for l in lines + moved) + "\n")
        original = {name: (self.data / name).read_text() for name in ("rgb.txt", "depth.txt", "groundtruth.txt")}
        for later, move, word in ((100, 0, "no frames for"), (0.7, 3.0, "leaps")):
            for name, text in original.items():
                (self.data / name).write_text(text)
                twice(name, later, move if name == "groundtruth.txt" else 0)
            self.assertIn(word, self.warnings()["one-run"])


class Simulate(Recording):
    """The simulator: what it writes is a recording without a mistake, whole or ended early."""

    SMALL = ("--width", 160, "--height", 120, "--frames", 10, "--quiet")
    FRAMES = 2
    SIZE = ("--width", 64, "--height", 48)

    def simulate(self, *options):
        shutil.rmtree(self.out, ignore_errors=True)
        return framewise("simulate", *options, "--out", self.out)

    def expect_no_mistake(self, folder):
        inspected = framewise("inspect", folder)
        self.assertEqual(inspected.returncode, 0, inspected.stderr)
        self.assertIn("no usual mistake was found", inspected.stdout)
        return json.loads(framewise("inspect", folder, "--json").stdout)

    def test_no_scene_has_a_mistake(self):
        for scene in "room", "corridor", "mine", "race", "plane", "sphere-field":
            lamp = 12 if scene == "mine" else 0
            # In fewer pixels, or with less motion, inspect has too little to judge by.
            made = self.simulate(scene, "--width", 320, "--height", 240, "--rate", 10, "--frames", 10, "--quiet",
                                 "--headlamp", lamp, "--seed", 3)
            self.assertEqual(made.returncode, 0, made.stderr)
            self.assertEqual(self.expect_no_mistake(self.out)["frames"]["with_depth"], 10, scene)

    def test_no_sensor_and_no_layout_has_a_mistake(self):
        for layout in "tum", "euroc", "kitti-depth":
            for sensor in "kinect", "tof", "lidar":
                made = self.simulate("plane", *self.SMALL, "--layout", layout, "--depth", sensor, "--imu-rate", 200,
                                     "--photons", 500, "--exposure-time", 0.02, "--blur-samples", 2)
                self.assertEqual(made.returncode, 0, made.stderr)
                found = self.expect_no_mistake(self.out)
                self.assertEqual(found["format"], layout.split("-")[0])
                self.assertEqual(found["frames"]["with_color"], 10)

    def test_our_own_readers_run_on_every_layout(self):
        for layout, solver in ("tum", "kabsch"), ("euroc", "nister-5pt"), ("kitti-depth", "kabsch"):
            self.assertEqual(self.simulate("plane", *self.SMALL, "--layout", layout).returncode, 0)
            ran = framewise("run", self.out, "--solver", solver, *(("--scale", "truth") if layout == "euroc" else ()),
                            "--out", self.work / layout, "--quiet")
            self.assertEqual(ran.returncode, 0, ran.stderr)
            ate = json.loads((self.work / layout / "run.json").read_text())["evaluation"]["ate"]["rmse"]
            self.assertLess(ate, 0.05, layout)

    def test_ranges_come_with_their_maximum(self):
        self.assertEqual(self.simulate("plane", *self.SMALL, "--depth-type", "range", "--depth-max", 20).returncode, 0)
        self.assertIn("depth_max: 20", (self.out / "camera.yaml").read_text())
        self.assertEqual(self.expect_no_mistake(self.out)["camera"]["depth_type"], "range")

    def test_the_same_seed_gives_the_same_bytes_at_any_thread_count(self):
        options = ("plane", *self.SMALL, "--depth", "kinect", "--photons", 300, "--imu-rate", 300, "--rolling-shutter", 0.01)
        everything = lambda: {file.relative_to(self.out): file.read_bytes() for file in self.out.rglob("*") if file.is_file()}
        self.assertEqual(self.simulate(*options, "--threads", 1).returncode, 0)
        one = everything()
        self.assertEqual(self.simulate(*options, "--threads", 2).returncode, 0)
        self.assertEqual(everything(), one)
        self.assertEqual(self.simulate(*options, "--seed", 1).returncode, 0)
        self.assertNotEqual(everything(), one)

    def test_its_record_holds_every_option(self):
        made = self.simulate("plane", *self.SMALL, "--seed", 9, "--depth", "tof", "--imu-rate", 400, "--gamma", 2.2, "--json")
        record = json.loads(made.stdout)
        self.assertEqual(record, json.loads((self.out / "simulation.json").read_text()))
        for name, value in {"scene": "plane", "path": "handheld", "layout": "tum", "frames": 10, "seed": 9, "width": 160,
                            "depth": "tof", "gamma": 2.2, "exposure_time": 0, "depth_noise": 1}.items():
            self.assertEqual(record[name], value, name)
        self.assertEqual(record["imu"]["rate"], 400)

    def test_ctrl_c_leaves_a_shorter_recording(self):
        for layout, listed in ("tum", "rgb.txt"), ("kitti-depth", "image_2"), ("euroc", "mav0/cam0/data.csv"):
            shutil.rmtree(self.out, ignore_errors=True)
            process = subprocess.Popen([FRAMEWISE, "simulate", "plane", "--frames", "200000", "--width", "160", "--height", "120",
                                        "--layout", layout, "--out", self.out, "--imu-rate", "200"],
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
            for _ in range(600):
                there = self.out / listed
                if there.exists() and (len(list(there.iterdir())) if there.is_dir() else len(there.read_text().splitlines())) > 8:
                    break
                time.sleep(0.05)
            process.send_signal(signal.SIGINT)
            said, _ = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 1)
            self.assertIn("ended early", said)
            frames = self.expect_no_mistake(self.out)["frames"]["count"]
            self.assertEqual(json.loads((self.out / "simulation.json").read_text())["frames"], frames)
            self.assertGreater(frames, 4)
            self.assertLess(frames, 200000)

    def test_it_says_how_far_it_is(self):
        made = framewise("simulate", "plane", *self.SMALL[:-1], "--out", self.out)
        self.assertIn("simulate: 10 of 10 frames", made.stderr)
        self.assertIn("Written:", made.stdout)

    def test_the_mine_is_dark_and_says_so(self):
        made = framewise("simulate", "mine", *self.SMALL[:-1], "--out", self.out)
        self.assertEqual(made.returncode, 0)
        self.assertIn("--headlamp", made.stderr)

    def model(self, *lines):
        file = self.work / "model.obj"
        file.write_text("\n".join(lines) + "\n")
        return file

    def test_a_model_in_place_of_a_scene(self):
        tetrahedron = self.model("v 0 0 0", "v 1 0 0", "v 0 1 0", "v 0 0 1", "f 1 3 2", "f 1 2 4", "f 2 3 4", "f 1 4 3")
        made = self.simulate("--mesh", tetrahedron, *self.SMALL)
        self.assertEqual(made.returncode, 0, made.stderr)
        found = self.expect_no_mistake(self.out)
        self.assertEqual(found["frames"]["with_depth"], 10)
        self.assertEqual(json.loads((self.out / "simulation.json").read_text())["mesh"]["file"], str(tetrahedron))

    def test_bad_input(self):
        triangle = self.model("v 0 0 0", "v 1 0 0", "v 0 1 0", "f 1 2 3")
        (self.work / "text.obj").write_text("no model at all, and long enough to be looked at\n" * 4)
        (self.work / "away.txt").write_text("0 0 0 900 0 0 0 1\n1 0 0 901 0 0 0 1\n")
        (self.work / "twice.txt").write_text("0 0 0 0 0 0 0 1\n0 1 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n")
        (self.work / "one.txt").write_text("0 0 0 0 0 0 0 1\n")
        for words, *options in (
                (("moon", "sphere-field"), "moon"), (("scene is ''",),), (("one of the two",), "room", "--mesh", triangle),
                (("none.obj", "no file"), "--mesh", self.work / "none.obj"), (("text.obj",), "--mesh", self.work / "text.obj"),
                (("no face in view", "away.txt"), "--mesh", triangle, "--path", self.work / "away.txt"),
                (("mesh scale",), "--mesh", triangle, "--mesh-scale", 0), (("mesh-up",), "--mesh", triangle, "--mesh-up", "x"),
                (("twice.txt", "1 poses at the time of the one before"), "plane", "--path", self.work / "twice.txt"),
                (("one.txt", "single pose"), "plane", "--path", self.work / "one.txt"),
                (("stroll", "drone-race"), "plane", "--path", "stroll"),
                (("exposure time", "0.2"), "plane", "--exposure-time", 0.2), (("rolling shutter",), "plane", "--rolling-shutter", 1),
                (("frames is 0",), "plane", "--frames", 0), (("rate",), "plane", "--rate", 0), (("bag",), "plane", "--layout", "bag"),
                (("distortion",), "plane", "--layout", "kitti-depth", "--distortion", "0.1,0,0,0"),
                (("no ray",), "plane", "--distortion", "5,5,5,5,5"), (("exposure",), "plane", "--exposure", "inf"),
                (("imu rate",), "plane", "--imu-rate", -1), (("depth noise",), "plane", "--depth-noise", -1)):
            self.refuses(self.simulate(*options), *words)
            self.assertFalse(self.out.exists(), f"{options} left a folder")


@unittest.skipUnless((DATA / "tum_fr1_rpy_000_080").is_dir(), f"no real recordings at {DATA}")
class RealRecording(unittest.TestCase):
    def warnings(self, name, *options):
        result = framewise("inspect", DATA / name, "--json", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return {warning["name"] for warning in json.loads(result.stdout)["warnings"]}

    def test_inspect_finds_in_real_recordings_only_what_is_odd(self):
        self.assertLessEqual(self.warnings("tum_fr1_rpy_000_080"), {"in-step"})
        self.assertEqual(self.warnings("kitti07_160"), set())
        self.assertEqual(self.warnings("7scenes_redkitchen_000_150"), set())
        self.assertIn("depth-registered", self.warnings("7scenes_redkitchen_000_150", "--register-depth", "false"))

    def test_kabsch_on_7_scenes_is_not_worse_than_without_registration_in_published_code(self):
        with tempfile.TemporaryDirectory() as folder:
            result = framewise("run", DATA / "7scenes_redkitchen_000_150", "--solver", "kabsch", "--out", folder, "--json")
            self.assertEqual(result.returncode, 0, result.stderr)
            evaluation = json.loads(result.stdout)["evaluation"]
            self.assertEqual(evaluation["coverage"], 1)
            self.assertLessEqual(evaluation["rpe"]["translation"]["rmse"], 4.84e-3)
            self.assertLessEqual(evaluation["rpe"]["rotation_deg"]["rmse"], 0.215)

    def test_kabsch_on_fr1_rpy_meets_the_bar(self):
        with tempfile.TemporaryDirectory() as folder:
            result = framewise("run", DATA / "tum_fr1_rpy_000_080", "--solver", "kabsch", "--out", folder, "--json")
            self.assertEqual(result.returncode, 0, result.stderr)
            evaluation = json.loads(result.stdout)["evaluation"]
            self.assertEqual(evaluation["matched"], 80)
            self.assertEqual(evaluation["coverage"], 1)
            self.assertLessEqual(evaluation["rpe"]["rotation_deg"]["rmse"], 0.46)
            self.assertLessEqual(evaluation["rpe"]["translation"]["rmse"], 8.6e-3)

    @unittest.skipUnless((DATA / "7scenes_redkitchen_000_150").is_dir(), f"no 7-Scenes at {DATA}")
    def test_two_point_takes_rotations_from_matrices_of_few_digits(self):
        with tempfile.TemporaryDirectory() as folder:
            result = framewise("run", DATA / "7scenes_redkitchen_000_150", "--solver", "two-point", "--rotation", "truth",
                               "--features", 500, "--out", folder, "--json")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertLess(json.loads(result.stdout)["evaluation"]["rpe"]["rotation_deg"]["rmse"], 0.02)


if __name__ == "__main__":
    unittest.main()
