#!/usr/bin/python3
"""That scripts/compare_with finds what differs: comparison.py MAGMPM SCRIPTS.

A comparison that finds nothing proves nothing unless it is known to find something: here the smallest
of changes of a scene, of every kind of column and of the frames.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

MAGMPM, SCRIPTS = (os.path.abspath(path) for path in sys.argv[1:3])
sys.path.insert(0, SCRIPTS)

from comparison import frames, statistics # pylint: disable=wrong-import-position


class Comparison(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def compare(self, scene, *options):
        return subprocess.run([os.path.join(SCRIPTS, "compare_with"), "--reference", MAGMPM,
                               "--program", MAGMPM, "--keep-build", self.folder,
                               "--scenes", scene, *options], capture_output=True, text=True)

    def test_the_same_program_computes_the_same(self):
        outcome = self.compare("rest_2d")
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)
        self.assertIn("to the last bit", outcome.stdout)

    def test_a_slightly_different_scene_is_found(self):
        # Gravity a part in 1e9 larger; gravity that is 1e-14 off has the same rows to 1e-12.
        outcome = self.compare("rest_2d", "--set", "Gravity=0, -1.000000001")
        self.assertEqual(outcome.returncode, 1, outcome.stdout + outcome.stderr)
        self.assertIn("momentum y [kg/s]: ", outcome.stdout)
        self.assertIn("1 of 1 scenes differ: rest_2d", outcome.stdout)
        outcome = self.compare("rest_2d", "--set", "Gravity=0, -1.00000000000001")
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)
        self.assertNotIn("to the last bit", outcome.stdout)

    def test_a_run_that_fails_or_gets_longer_is_found(self):
        self.assertEqual(self.compare("rest_2d", "--set", "Gravity=0").returncode, 1)
        outcome = self.compare("rest_2d", "--set", "Rest/Time=0.01")
        self.assertEqual(outcome.returncode, 1)
        self.assertRegex(outcome.stdout, r"\d+ rows, there were \d+")

    def table(self, text):
        with open(os.path.join(self.folder, "statistics.csv"), "w", encoding="utf-8") as file:
            file.write(text)
        return statistics.Table(self.folder)

    def test_each_kind_of_column(self):
        # Counts and words are equal or not; components are measured by the largest of them; what is
        # zero has to stay zero; a column may be new, but not go; wall times do not count.
        head = "step,limit of dt,v x [m/s],v y [m/s],zero [J],wall time: P2G [s]\n"
        rows = ["%d,%s,%s,%s,%s,%s\n"] * 2
        def written(step=2, limit="elastic", x="1e-9", y="5", zero="0", wall="3", heading=head):
            return self.table(heading + "1,elastic,0,-10,0,7\n" +
                              rows[1] % (step, limit, x, y, zero, wall))
        old = written()
        def is_same(**changes):
            return statistics.compare(old, written(**changes), 1e-12).is_same
        self.assertTrue(is_same())
        self.assertTrue(is_same(wall="4"))
        self.assertTrue(is_same(x="1.009e-9"))
        self.assertFalse(is_same(x="1.02e-9"))
        self.assertFalse(is_same(y="nan"))
        self.assertFalse(is_same(zero="1e-30"))
        self.assertFalse(is_same(step=3))
        self.assertFalse(is_same(limit="viscous"))
        self.assertFalse(is_same(heading=head.replace("zero [J]", "nought [J]")))
        self.assertTrue(statistics.compare(old, self.table(
            head[:-1] + ",new [J]\n1,elastic,0,-10,0,7,1\n2,elastic,1e-9,5,0,3,1\n"), 1e-12).is_same)

    def test_frames(self):
        # A bit of the last particle's velocity, a frame that is missing.
        self.compare("smeared_2d")
        runs = os.path.join(self.folder, "runs")
        program = os.path.join(runs, os.listdir(runs)[0])
        old = next(os.path.join(program, name) for name in os.listdir(program)
                   if name.startswith("smeared_2d-"))
        new = os.path.join(self.folder, "new")
        shutil.copytree(old, new)
        self.assertTrue(frames.compare(old, new).is_same)
        self.assertGreater(len(frames.record(os.path.join(new, "particles.pvd"))), 2)
        record = os.path.join(new, "particles.pvd")
        last = frames.pieces(os.path.join(new, frames.record(record)[-1][1]))[0]
        found = frames.arrays(last)
        self.assertIn(("PointData", "velocity [m/s]"), found)
        with open(last, "r+b") as file:
            content = file.read()
            velocity = found[("PointData", "velocity [m/s]")].tobytes()
            file.seek(content.index(velocity) + 4 * 3 + 2)
            byte = content[file.tell()]
            file.write(bytes([byte ^ 64]))
        report = frames.compare(old, new)
        self.assertFalse(report.is_same)
        self.assertIn("particles.pvd: velocity [m/s]", report.lines[1])
        shutil.copy(os.path.join(old, os.path.relpath(last, new)), last)
        self.assertTrue(frames.compare(old, new).is_same)
        with open(record, encoding="utf-8") as file:
            lines = file.readlines()
        with open(record, "w", encoding="utf-8") as file:
            file.writelines(line for line in lines if line != [one for one in lines
                                                               if "DataSet" in one][-1])
        self.assertFalse(frames.compare(old, new).is_same)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
