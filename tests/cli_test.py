# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command-line program as a user meets it: what it writes, what it refuses, and that it repeats itself."""

import csv
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import unittest
import zlib

FRAMEWISE = os.environ["FRAMEWISE"]
DATA = pathlib.Path(os.environ.get("FRAMEWISE_DATA", pathlib.Path(__file__).resolve().parents[2] / "shared" / "data"))


def framewise(*arguments):
    return subprocess.run([FRAMEWISE, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def write_png(path, width, height, bits, value):
    """A gray image of one value."""
    row = b"\0" + value.to_bytes(bits // 8, "big") * width
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", width, height, bits, 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(row * height))
                     + chunk(b"IEND", b""))


class Recording(unittest.TestCase):
    """A small simulated recording, made once; every test changes a copy."""

    FRAMES = 12

    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory()
        cls.original = pathlib.Path(cls._folder.name) / "original"
        made = framewise("simulate", "room", "--out", cls.original, "--frames", cls.FRAMES, "--quiet")
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
        self.assertGreaterEqual(run["ransac"]["iterations_per_step"], run["ransac"]["iterations_theory_per_step"])
        self.assertGreater(run["ransac"]["iterations_theory_per_step"], 0)
        self.assertLess(run["evaluation"]["rpe"]["rotation_deg"]["rmse"], 0.1)
        self.assertLess(run["evaluation"]["ate"]["rmse"], 0.02)

    def test_eight_point_takes_its_scale_from_depth_truth_or_nowhere(self):
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
        result = self.run_data()
        self.assertEqual(result.returncode, 0, result.stderr)
        frames = list(csv.DictReader((self.out / "frames.csv").open()))
        self.assertEqual(len(frames), self.FRAMES)
        self.assertEqual([r["status"] for r in frames], ["ok"] * 5 + ["lost"] * 2 + ["ok"] * 5)
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
        self.assertEqual(self.run_data().returncode, 0)
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


@unittest.skipUnless((DATA / "tum_fr1_rpy_000_080").is_dir(), f"no real recordings at {DATA}")
class RealRecording(unittest.TestCase):
    def test_kabsch_on_fr1_rpy_meets_the_bar(self):
        with tempfile.TemporaryDirectory() as folder:
            result = framewise("run", DATA / "tum_fr1_rpy_000_080", "--solver", "kabsch", "--out", folder, "--json")
            self.assertEqual(result.returncode, 0, result.stderr)
            evaluation = json.loads(result.stdout)["evaluation"]
            self.assertEqual(evaluation["matched"], 80)
            self.assertEqual(evaluation["coverage"], 1)
            self.assertLessEqual(evaluation["rpe"]["rotation_deg"]["rmse"], 0.46)
            self.assertLessEqual(evaluation["rpe"]["translation"]["rmse"], 8.6e-3)


if __name__ == "__main__":
    unittest.main()
