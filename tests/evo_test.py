# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
"""Our errors and result files beside those of evo (the version of requirements.txt), on trajectories never seen before.

scripts/install_evo installs evo; without it these tests skip. FRAMEWISE_EVO_SEED=N repeats a pair of trajectories,
FRAMEWISE_EVO_ALL=1 compares every combination of options.
"""

import contextlib
import io
import itertools
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

FRAMEWISE = os.environ["FRAMEWISE"]
SEED = int(os.environ.get("FRAMEWISE_EVO_SEED", random.SystemRandom().randrange(10**9)))
HOME = tempfile.TemporaryDirectory()
os.environ["HOME"] = HOME.name  # evo writes its settings there

try:
    import evo
    import numpy as np
    from evo.core import lie_algebra, metrics, sync
    from evo.core.trajectory import PoseTrajectory3D
    from evo.main_ape import ape
    from evo.main_rpe import rpe
    from evo.tools import file_interface
    from scipy.spatial.transform import Rotation
    WITHOUT = ""
except ImportError as error:
    WITHOUT = f"no evo here ({error}); scripts/install_evo installs it"

RELATIONS = {"translation_part": "translation", "rotation_angle_deg": "rotation", "full_transformation": "full",
             "rotation_part": "rotation-part", "point_distance": "distance",
             "point_distance_error_ratio": "distance-ratio"}
ALIGNMENTS = {"none": {}, "se3": {"align": True}, "sim3": {"align": True, "correct_scale": True},
              "scale": {"correct_scale": True}, "origin": {"align_origin": True}}
DELTAS = {"frames": 3, "metres": 0.9, "degrees": 12, "radians": 0.3}
EVO_UNITS = {"frames": "frames", "metres": "meters", "degrees": "degrees", "radians": "radians"}


def relative_cases():
    """Every unit with every choice of pairs and every alignment, and every relation with each of them; with
    FRAMEWISE_EVO_ALL every combination, which takes three times as long."""
    relations = list(RELATIONS)
    for k, (unit, pairs) in enumerate(itertools.product(DELTAS, ("consecutive", "all"))):
        for a, alignment in enumerate(ALIGNMENTS):
            chosen = relations if "FRAMEWISE_EVO_ALL" in os.environ else [relations[(2 * a + k + j) % 6] for j in (0, 1)]
            for relation in chosen:
                yield relation, unit, pairs, alignment


def random_pair(seed):
    """A wandering camera, and an estimate of it: other stamps, another world, another scale, noise, gaps."""
    rng = np.random.default_rng(seed)
    n = 150
    times = 1.6e9 + np.cumsum(rng.uniform(0.03, 0.05, n))
    positions = np.cumsum(rng.normal(0.02, 0.1, (n, 3)), axis=0)
    turns = [Rotation.from_rotvec(v) for v in rng.normal(0, 0.08, (n, 3))]
    rotations = [Rotation.random(random_state=rng.integers(2**31))]
    for turn in turns[1:]:
        rotations.append(rotations[-1] * turn)
    world, shift, scale = Rotation.random(random_state=rng.integers(2**31)), rng.normal(0, 3, 3), rng.uniform(0.5, 2)
    kept = np.flatnonzero(rng.uniform(size=n) < 0.85)
    estimate = [(times[i] + rng.uniform(-0.004, 0.004), scale * world.apply(positions[i] + rng.normal(0, 0.03, 3)) + shift,
                 world * rotations[i] * Rotation.from_rotvec(rng.normal(0, 0.02, 3))) for i in kept]
    return list(zip(times, positions, rotations)), estimate


def write_tum(path, poses):
    path.write_text("".join(" ".join(repr(float(x)) for x in (t, *p, *r.as_quat())) + "\n" for t, p, r in poses))


def write_kitti(path, poses):
    path.write_text("".join(" ".join(repr(float(x)) for x in np.column_stack([r.as_matrix(), p]).ravel()) + "\n"
                            for _, p, r in poses))


@unittest.skipIf(WITHOUT, WITHOUT)
class Evo(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        print(f"evo {evo.__version__}, FRAMEWISE_EVO_SEED={SEED}", flush=True)
        cls._folder = tempfile.TemporaryDirectory()
        cls.work = pathlib.Path(cls._folder.name)
        cls.poses = random_pair(SEED)
        for name, poses in zip(("reference", "estimate"), cls.poses):
            write_tum(cls.work / f"{name}.txt", poses)
        reference, estimate = (file_interface.read_tum_trajectory_file(cls.work / f"{name}.txt")
                               for name in ("reference", "estimate"))
        cls.pair = sync.associate_trajectories(reference, estimate, max_diff=0.01)

    @classmethod
    def tearDownClass(cls):
        cls._folder.cleanup()

    def evos(self, function, **options):
        """evo changes the trajectories it is given: every result comes from a copy."""
        reference, estimate = (PoseTrajectory3D(positions_xyz=t.positions_xyz.copy(), timestamps=t.timestamps.copy(),
                                                orientations_quat_wxyz=t.orientations_quat_wxyz.copy(), name=name)
                               for t, name in zip(self.pair, ("reference.txt", "estimate.txt")))
        with contextlib.redirect_stdout(io.StringIO()):
            return function(reference, estimate, **options)

    def ours(self, *options, files=("reference.txt", "estimate.txt")):
        zip_file = self.work / "ours.zip"
        done = subprocess.run([FRAMEWISE, "evaluate", *(self.work / f for f in files), "--preset", "evo", "--quiet",
                               "--save-results", zip_file, *map(str, options)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return file_interface.load_res_file(zip_file, load_trajectories=True)

    def assert_equal(self, ours, theirs):
        """A result, read from our file, and evo's own: words, figures, arrays and trajectories."""
        self.assertEqual(ours.info, theirs.info)
        self.assertEqual(ours.stats.keys(), theirs.stats.keys())
        for name, value in theirs.stats.items():
            np.testing.assert_allclose(ours.stats[name], value, rtol=1e-9, atol=1e-12, err_msg=name)
        self.assertEqual(ours.np_arrays.keys(), theirs.np_arrays.keys())
        for name, array in theirs.np_arrays.items():
            np.testing.assert_allclose(ours.np_arrays[name], array, rtol=1e-9, atol=1e-11, err_msg=name)
        self.assertEqual(ours.trajectories.keys(), theirs.trajectories.keys())
        for name, trajectory in theirs.trajectories.items():
            np.testing.assert_allclose(ours.trajectories[name].positions_xyz, trajectory.positions_xyz, atol=1e-9)
            np.testing.assert_allclose(np.array(ours.trajectories[name].poses_se3), np.array(trajectory.poses_se3),
                                       atol=1e-9)

    def assert_same_apart_from_transformation(self, ours, theirs):
        """Where it corrects the scale alone, evo files the whole similarity; we file what was applied."""
        applied = ours.np_arrays.pop("alignment_transformation_sim3")
        found = theirs.np_arrays.pop("alignment_transformation_sim3")
        scale = np.cbrt(np.linalg.det(found[:3, :3]))
        np.testing.assert_allclose(applied, np.diag([scale, scale, scale, 1]), rtol=1e-9, atol=1e-12)
        self.assert_equal(ours, theirs)

    def compare(self, alignment, ours, theirs):
        if alignment == "scale":
            self.assert_same_apart_from_transformation(ours, theirs)
        else:
            self.assert_equal(ours, theirs)

    def test_absolute_errors_of_every_relation_and_alignment(self):
        for relation, metric in RELATIONS.items():
            if relation.startswith("point_distance"):
                continue  # the distance of the positions, as the translation; and no ratio
            for alignment, options in ALIGNMENTS.items():
                with self.subTest(seed=SEED, relation=relation, alignment=alignment):
                    name = "ate" if metric == "translation" else f"ate-{metric}"
                    self.compare(alignment, self.ours("--metric", name, "--align", alignment),
                                 self.evos(ape, pose_relation=metrics.PoseRelation[relation], **options))

    def test_relative_errors_of_every_relation_unit_alignment_and_choice_of_pairs(self):
        for relation, unit, pairs, alignment in relative_cases():
            with self.subTest(seed=SEED, relation=relation, unit=unit, pairs=pairs, alignment=alignment):
                theirs = self.evos(rpe, pose_relation=metrics.PoseRelation[relation], delta=float(DELTAS[unit]),
                                   delta_unit=metrics.Unit[EVO_UNITS[unit]], all_pairs=pairs == "all",
                                   **ALIGNMENTS[alignment])
                ours = self.ours("--metric", f"rpe-{RELATIONS[relation]}", "--align", alignment, "--delta", DELTAS[unit],
                                 "--unit", unit, "--pairs", pairs, "--from-first-pose")
                self.compare(alignment, ours, theirs)

    def test_pairs_chosen_on_the_reference_and_few_poses_aligned(self):
        theirs = self.evos(rpe, pose_relation=metrics.PoseRelation.translation_part, delta=1.0,
                           delta_unit=metrics.Unit.meters, rel_delta_tol=0.05, all_pairs=True,
                           pairs_from_reference=True, align=True, n_to_align=40)
        self.assert_equal(self.ours("--metric", "rpe-translation", "--align", "se3", "--poses-to-align", 40, "--unit",
                                    "metres", "--pairs", "all", "--tolerance", 0.05, "--pairs-from-reference"), theirs)

    def test_a_plane(self):
        from evo.core.trajectory import Plane
        theirs = self.evos(ape, pose_relation=metrics.PoseRelation.full_transformation, align=True,
                           project_to_plane=Plane.XZ)
        ours = self.ours("--metric", "ate-full", "--align", "se3", "--plane", "xz")
        self.assert_equal(ours, theirs)

    def test_radians_are_our_degrees(self):
        theirs = self.evos(rpe, pose_relation=metrics.PoseRelation.rotation_angle_rad, delta=1.0,
                           delta_unit=metrics.Unit.frames)
        ours = self.ours("--metric", "rpe-rotation")
        np.testing.assert_allclose(np.deg2rad(ours.np_arrays["error_array"]), theirs.np_arrays["error_array"],
                                   rtol=1e-9, err_msg=f"seed {SEED}")

    def test_poses_without_stamps(self):
        reference, estimate = self.poses[0][:len(self.poses[1])], self.poses[1]
        write_kitti(self.work / "reference.kitti", reference)
        write_kitti(self.work / "estimate.kitti", estimate)
        theirs = ape(*(file_interface.read_kitti_poses_file(self.work / f"{name}.kitti")
                       for name in ("reference", "estimate")), metrics.PoseRelation.translation_part, align=True)
        ours = self.ours("--align", "se3", files=("reference.kitti", "estimate.kitti"))
        self.assertEqual(ours.np_arrays.keys(), theirs.np_arrays.keys())
        np.testing.assert_allclose(ours.np_arrays["error_array"], theirs.np_arrays["error_array"], rtol=1e-9)
        self.assertEqual(set(ours.trajectories), {"reference.kitti", "estimate.kitti"})

    def test_evo_res_opens_our_files(self):
        """The program itself: a table of two of our results."""
        import sys
        tables = self.work / "table.csv"
        for name, alignment in (("a", "se3"), ("b", "sim3")):
            self.ours("--align", alignment)
            (self.work / "ours.zip").rename(self.work / f"{name}.zip")
        run = subprocess.run([sys.executable, "-c", "from evo.cli.entry_points import res; res()", self.work / "a.zip",
                              self.work / "b.zip", "--use_filenames", "--ignore_title", "--no_warnings",
                              "--save_table", tables], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        rows = {pathlib.Path(row.split(",")[0]).name: row for row in tables.read_text().splitlines()[1:]}
        self.assertEqual(rows.keys(), {"a.zip", "b.zip"})
        rmse = file_interface.load_res_file(self.work / "a.zip").stats["rmse"]
        numbers = [float(cell) for cell in rows["a.zip"].split(",")[1:] if cell]
        self.assertLess(min(abs(number - rmse) for number in numbers), 1e-6 * rmse, rows["a.zip"])


if __name__ == "__main__":
    unittest.main()
