# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""`framewise compare` as a user meets it: tables, reasons, and that nothing is lost or taken twice."""

import csv
import json
import shutil
import signal
import subprocess
import time
import unittest

from cli_test import FRAMEWISE, Recording, framewise

FEATURES = "features:\n  - {name: ORB, detector: orb, descriptor: orb, features: 300}\n"
METHODS = "rows:\n  - {name: Kabsch, solver: kabsch}\n  - {name: 5-point, solver: nister-5pt, scale: truth}\n"


def is_clock(name):
    return name.endswith("_ms") or name.startswith("frames_per_second")


class Compare(Recording):
    SIZE = ("--width", 320, "--height", 240)

    def write_grid(self, text=METHODS + FEATURES):
        path = self.work / "grid.yaml"
        path.write_text(text)
        return path

    def arguments(self, *options, grid=None, out=None, data=None):
        return ["compare", *(data or [self.data]), "--grid", grid or self.write_grid(), "--out", out or self.out, *options]

    def compare(self, *options, **where):
        return framewise(*self.arguments("--quiet", *options, **where))

    def done(self, *options, **where):
        result = self.compare(*options, **where)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        return self.results(where.get("out"))

    def results(self, out=None):
        return json.loads(((out or self.out) / "results.json").read_text())

    def table(self, out=None):
        with ((out or self.out) / "table.csv").open(newline="") as file:
            return list(csv.DictReader(file))

    def whole_runs(self, out=None):
        return sorted(path for path in ((out or self.out) / "rows").glob("*/*/*/seed_*") if not path.name.endswith(".part"))


class Tables(Compare):
    def test_a_row_for_each_method_with_what_run_itself_says(self):
        results = self.done("--repeats", 3, "--seed", 5)
        self.assertEqual([(row["method"], row["features"]) for row in results["rows"]], [("Kabsch", "ORB"), ("5-point", "ORB")])
        for row in results["rows"]:
            self.assertIsNone(row["reason"])
            self.assertEqual((row["repeats"], row["failed"]), (3, 0))
        runs = [json.loads((folder / "run.json").read_text()) for folder in self.whole_runs()]
        self.assertEqual(sorted(run["options"]["seed"] for run in runs), [5, 5, 6, 6, 7, 7])
        for row, solver in zip(results["rows"], ("kabsch", "nister-5pt")):
            own = [run["evaluation"] for run in runs if run["options"]["solver"] == solver]
            middle = lambda values: sorted(values)[1]
            errors = row["errors"]
            self.assertAlmostEqual(errors["ate_m"]["median"], middle(e["ate"]["rmse"] for e in own), 12)
            self.assertAlmostEqual(errors["rpe_translation_mm"]["rmse"]["median"],
                                   1000 * middle(e["rpe"]["translation"]["rmse"] for e in own), 9)
            self.assertAlmostEqual(errors["rpe_rotation_deg"]["rmse"]["median"],
                                   middle(e["rpe"]["rotation_deg"]["rmse"] for e in own), 9)
            low, high = errors["rpe_translation_mm"]["interval"]
            self.assertLess(low, errors["rpe_translation_mm"]["rmse"]["median"])
            self.assertGreater(high, errors["rpe_translation_mm"]["rmse"]["median"])
            for stage in ("load_ms", "features_ms", "match_ms", "solve_ms"):
                self.assertGreater(row["times"][stage], 0)
            rate = row["times"]["frames_per_second"]
            self.assertLess(rate["min"], rate["mean"])
            self.assertLess(rate["mean"], rate["max"])
        static = results["datasets"][0]["static_baseline"]
        self.assertAlmostEqual(static["ate_m"], runs[0]["evaluation"]["static_baseline"]["ate"], 9)
        best = [row for row in results["rows"] if row["errors"]["rpe_translation_mm"]["best"]]
        self.assertEqual(len(best), 1)

    def test_every_table_says_what_its_figures_are_worth_nothing_without(self):
        self.done()
        for name in ("table.md", "table.tex"):
            text = (self.out / name).read_text()
            for words in ("alignment se3", "delta 1 frames", "truth for 12 of 12 frames", "never moved", "Kabsch", "5-point"):
                self.assertIn(words, text, name)
        self.assertIn("\\begin{tabular}", (self.out / "table.tex").read_text())
        self.assertEqual([row["method"] for row in self.table()], ["Kabsch", "5-point"])

    def test_repeats_itself_at_any_number_of_processes_but_for_times(self):
        said = []
        for threads in (1, 2):
            out = self.work / f"out{threads}"
            results = self.done("--repeats", 2, "--threads", threads, out=out)
            for row in results["rows"]:
                del row["times"]
            table = [{name: cell for name, cell in row.items() if not is_clock(name)} for row in self.table(out)]
            said.append((results, table))
        self.assertEqual(said[0], said[1])

    def test_json_is_what_is_written(self):
        result = self.compare("--json")
        self.assertEqual(result.stdout, (self.out / "results.json").read_text())

    def test_published_figures_stand_beside_ours(self):
        data = self.data.rename(self.work / "rgbd_dataset_freiburg3_house")
        published = self.work / "published.csv"
        head = "sequence,solver,translation,ransac_error,feature,ate_rmse_m,rpe_trans_rmse_m,rpe_rot_rmse_deg,outcome\n"
        published.write_text(head + "fr3_house,kabsch,full-3d,point-to-point,ORB,0.5,0.025,1.5,ok\n"
                             "other,nister-5pt,truth,sampson,ORB,9,9,9,ok\n")
        results = self.done("--published", published, data=[data])
        ours, none = (row["published"] for row in results["rows"])
        self.assertEqual(ours, {"ate_m": 0.5, "rpe_translation_mm": 25, "rpe_rotation_deg": 1.5, "outcome": "ok"})
        self.assertIsNone(none)
        self.assertIn("published ATE (m)", (self.out / "table.md").read_text())
        self.assertEqual([row["published_ate_m"] for row in self.table()], ["0.5", "not published"])
        published.write_text("sequence,solver\na,b\n")
        self.refuses(self.compare("--published", published, data=[data]), "published.csv", "translation")

    def test_two_recordings_are_two_sets_of_tables(self):
        other = self.work / "other"
        shutil.copytree(self.data, other)
        results = self.done(data=[self.data, other])
        self.assertEqual([row["dataset"] for row in results["rows"]], ["room", "room", "other", "other"])
        self.assertEqual((self.out / "table.md").read_text().count("Errors on"), 2)
        self.refuses(self.compare(data=[self.data, self.data]), "room", "twice")

    def test_an_archive_is_a_recording(self):
        archive = self.work / "matches.h5"
        self.assertEqual(self.run_data("--archive", archive, "--features", 300).returncode, 0)
        grid = self.write_grid(METHODS)
        results = self.done(data=[archive], grid=grid)
        self.assertIsNone(results["rows"][0]["times"]["features_ms"])
        self.assertEqual(self.table()[0]["features_ms"], "archive given")
        self.assertFalse((self.out / "archives").exists())
        self.refuses(self.compare("--depth-factor", 1000, data=[archive], grid=grid), "matches.h5", "--depth-factor")
        # Matches of other features are not made up.
        result = self.compare(data=[archive], grid=self.write_grid(METHODS + "features: [{detector: akaze}]\n"))
        self.assertEqual(result.returncode, 1)
        self.assertIn("'akaze'", result.stderr)

    def test_built_in_grids_are_those_of_the_publications(self):
        results = self.done("--threads", 0, grid="lab", out=self.work / "lab")
        self.assertEqual(len(results["rows"]), 8)
        results = self.done("--threads", 0, grid="dark", out=self.work / "dark")
        self.assertEqual([(r["method"], r["features"]) for r in results["rows"]],
                         [(m, f) for f in ("SIFT", "AKAZE", "ORB")
                          for m in ("depth as it is", "flexion as published", "depth", "flexion", "normal")])
        results = self.done("--threads", 0, grid="frame-to-frame", out=self.work / "frame")
        self.assertEqual(len(results["rows"]), 51)
        self.assertEqual({r["features"] for r in results["rows"]}, {"AKAZE", "ORB", "SURF"})
        names = [f"{s}.{e}.{solver}" for s in "CS" for e in "ER" for solver in ("Eigensolver", "Kneip", "nister", "eight-point")]
        self.assertEqual([r["method"] for r in results["rows"]][:17], names + ["Kabsch"])
        for row in self.table(self.work / "frame"):
            self.assertNotIn("", row.values())


class Failures(Compare):
    TWO_POINT = "  - {name: 2-point, solver: two-point, scale: truth}\n"  # its rotation is missing

    def test_a_row_that_fails_says_why_and_the_others_go_on(self):
        results = self.done("--repeats", 2, grid=self.write_grid(METHODS + self.TWO_POINT + FEATURES))
        kabsch, _, failed = results["rows"]
        self.assertIsNone(kabsch["reason"])
        self.assertEqual((failed["repeats"], failed["failed"]), (2, 2))
        self.assertTrue(failed["reason"].startswith("exit code 2: "), failed["reason"])
        self.assertIn("rotation", failed["reason"])
        self.assertIsNone(failed["errors"])
        for row in self.table():
            self.assertNotIn("", row.values())
        self.assertIn("failed [1]", (self.out / "table.md").read_text())
        self.assertIn("[1] exit code 2: ", (self.out / "table.md").read_text())

    def test_where_every_row_fails_so_does_the_comparison(self):
        result = self.compare(grid=self.write_grid("rows:\n" + self.TWO_POINT + FEATURES))
        self.assertEqual(result.returncode, 1)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        self.assertIn("rotation", result.stderr)
        self.assertEqual(self.results()["rows"][0]["failed"], 1)

    def test_an_image_that_cannot_be_read_fails_all_its_rows(self):
        _, file = self.listed("rgb.txt")[8]
        (self.data / file).write_bytes((self.data / file).read_bytes()[:1000])
        result = self.compare()
        self.assertEqual(result.returncode, 1)
        for row in self.results()["rows"]:
            self.assertIn("no matches: exit code 2: ", row["reason"])
            self.assertIn(file, row["reason"])

    def test_without_truth_there_are_reasons_instead_of_errors(self):
        (self.data / "groundtruth.txt").unlink()
        results = self.done()
        self.assertEqual(results["rows"][0]["reason"], "no truth")
        self.assertGreater(results["rows"][0]["measured"]["median"], 0.9)
        self.assertIn("groundtruth.txt", results["rows"][1]["reason"])
        for row in self.table():
            self.assertNotIn("", row.values())

    def test_without_depth_the_rows_that_need_none_go_on(self):
        (self.data / "depth.txt").unlink()
        shutil.rmtree(self.data / "depth")
        results = self.done()
        self.assertIn("no depth images", results["rows"][0]["reason"])
        self.assertIsNone(results["rows"][1]["reason"])

    def test_grids_that_cannot_be_are_refused_in_a_line(self):
        for text, words in (("rows: [\n", ("YAML",)), ("", ("empty grid",)), ("rows: []\n", ("without methods",)),
                            ("row: [{solver: kabsch}]\n", (":1:", "'row'", "rows")),
                            ("rows: [{solver: magic}]\n", (":1:", "'magic'", "expected one of")),
                            ("rows:\n  - {slover: kabsch}\n", (":2:", "'slover'", "option")),
                            ("rows: [{solver: kabsch, scale: centroid}]\n", (":1:", "'centroid'")),
                            ("rows: [{solver: kabsch, min-inliers: many}]\n", (":1:", "min-inliers", "'many'")),
                            ("rows: [{solver: kabsch, seed: 3}]\n", ("'seed'",)),
                            ("rows: [{solver: kabsch, camera: a.yaml}]\n", ("'camera'", "not of the data set")),
                            ("rows: [{solver: kabsch}]\nfeatures: [{detector: none}]\n", ("'none'",))):
            with self.subTest(text):
                self.refuses(self.compare(grid=self.write_grid(text)), "grid.yaml", *words)
                self.assertFalse(self.out.exists())

    def test_wrong_usage_is_refused(self):
        self.refuses(self.compare(grid=self.work / "nothing.yaml"), "nothing.yaml", "no file")
        self.refuses(self.compare(data=[self.work / "nothing"]), "nothing")
        self.refuses(self.compare("--repeats", 0), "repeats")
        self.refuses(self.compare("--threads", -1), "threads")
        self.refuses(self.compare("--published", self.work / "none.csv"), "none.csv")
        self.refuses(framewise("compare", self.data, "--out", self.out), "--grid")
        self.out.write_text("a file")
        self.refuses(self.compare(), "out")


class Resuming(Compare):
    REPEATS = ("--repeats", 12, "--threads", 1)

    def started(self):
        """A comparison at work, when its first rows are whole."""
        process = subprocess.Popen([FRAMEWISE, *map(str, self.arguments("--quiet", *self.REPEATS))], stderr=subprocess.PIPE, text=True)
        end = time.monotonic() + 120
        while not self.whole_runs():
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), end)
            time.sleep(0.002)
        return process

    def files(self):
        return {path: path.stat().st_mtime_ns for folder in self.whole_runs() for path in folder.iterdir()}

    def test_kill_9_loses_what_is_under_way_and_nothing_else(self):
        process = self.started()
        process.kill()
        process.wait()
        process.stderr.close()
        time.sleep(0.3)  # a child would go on writing
        before, runs = self.files(), self.whole_runs()
        self.assertLess(len(runs), 24)
        self.assertFalse((self.out / "results.json").exists())
        for folder in runs:
            for name in ("run.json", "frames.csv", "trajectory.tum", "record.json"):
                self.assertIn(folder / name, before)
        time.sleep(0.3)
        self.assertEqual(self.files(), before)

        results = self.done(*self.REPEATS)
        after = self.files()
        for path, changed in before.items():
            self.assertEqual(after[path], changed, path)
        self.assertEqual(len(self.whole_runs()), 24)
        self.assertEqual(list(self.out.glob("**/*.part")), [])
        undisturbed = self.done(*self.REPEATS, out=self.work / "undisturbed")
        for answer in (results, undisturbed):
            for row in answer["rows"]:
                del row["times"]
        self.assertEqual(results, undisturbed)

    def test_a_signal_ends_the_children_and_leaves_what_is_whole(self):
        for kind in (signal.SIGINT, signal.SIGTERM):
            process = self.started()
            process.send_signal(kind)
            _, errors = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 1)
            self.assertEqual(len(errors.strip().splitlines()), 1, errors)
            self.assertIn("the same command goes on", errors)
            before = self.files()
            time.sleep(0.2)
            self.assertEqual(self.files(), before)
            shutil.rmtree(self.out)

    def test_what_is_done_is_not_done_again_and_more_is_added(self):
        self.done("--repeats", 2)
        before = self.files()
        self.done("--repeats", 2)
        self.assertEqual(self.files(), before)
        results = self.done("--repeats", 3)
        after = self.files()
        self.assertEqual({path: after[path] for path in before}, before)
        self.assertEqual(results["rows"][0]["repeats"], 3)
        # Another recording of the same name is other work.
        self.rewrite("groundtruth.txt", lambda line: " ".join([line.split()[0], str(float(line.split()[1]) + 1)] + line.split()[2:]))
        self.done("--repeats", 2)
        self.assertEqual(len(self.whole_runs()), 10)

    def test_a_torn_record_is_done_again(self):
        self.done()
        record = self.whole_runs()[0] / "record.json"
        whole = record.read_text()
        for torn in ("", whole[:40], "[]", whole.replace('"seed": 0', '"seed": 1')):
            record.write_text(torn)
            self.done()
            self.assertEqual(record.read_text(), whole)

    def test_two_comparisons_do_not_share_a_folder(self):
        process = self.started()
        self.refuses(self.compare(*self.REPEATS), "out", "another comparison")
        process.terminate()
        process.communicate()


if __name__ == "__main__":
    unittest.main()
