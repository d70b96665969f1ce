#!/usr/bin/env python3
"""The races of benchmarks/peers run with what is installed, do the same work, and refuse bad input in one line.

    tests/benchmarks/race_test.py <folder of the build> [<interpreter that may have MuJoCo>]

What is missing on this machine is named and skipped.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
PEERS = ROOT / "benchmarks/peers"
BUILD = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT / "build/release"
PYTHON = sys.argv[2] if len(sys.argv) > 2 else None

sys.path.insert(0, str(PEERS))
import contest  # noqa: E402
import growth  # noqa: E402
import likeness  # noqa: E402
import running  # noqa: E402

import scenes  # noqa: E402


def race(*arguments):
    options = ["--python", PYTHON] if PYTHON and running.find_python(PYTHON) else []
    command = [sys.executable, PEERS / "race.py", "--build", BUILD, *options, *arguments]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)


def program(name, *arguments):
    return subprocess.run([str(BUILD / name), *map(str, arguments)], capture_output=True, text=True, check=False)


class QuickRace(unittest.TestCase):
    """Once for all tests of this class."""

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            out, chart = pathlib.Path(folder) / "race.json", pathlib.Path(folder) / "race.png"
            cls.done = race("--quick", "--out", out)
            cls.document = json.loads(out.read_text()) if out.is_file() else None
            cls.drawn = race("slope", "--quick", "--out", out, "--chart", chart)
            cls.again = json.loads(out.read_text()) if out.is_file() else None
            cls.picture = chart.read_bytes() if chart.is_file() else b""

    def rows(self, part):
        return self.document["parts"][part]["rows"]

    def others(self, part):
        found = [row for row in self.rows(part) if not row["ours"]]
        if not found:
            self.skipTest(f"no other engine is here: {'; '.join(self.document['missing'])}")
        return found

    def test_every_part_ends(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        for line in self.document["missing"]:
            print(f"missing: {line}")
        for part in ("walk", "squat", "heap", "slope", "worlds", "batch", "games", "growth"):
            self.assertTrue(self.rows(part), part)
            self.assertIn(f"{part}: took", self.done.stdout)

    def test_parts_of_an_earlier_race_stay(self):
        self.assertEqual(self.again["parts"]["walk"], self.document["parts"]["walk"])
        self.assertNotEqual(self.again["parts"]["slope"], self.document["parts"]["slope"])

    def test_robots_of_ours_stand_and_walk(self):
        walk, squat, slope = (self.rows(part)[0]["observed"] for part in ("walk", "squat", "slope"))
        for seen in (walk, squat, slope):
            self.assertEqual(seen["lying"], 0)
            self.assertLess(seen["depth_mm"], 1)
        self.assertGreater(walk["distance_m"], 0.02)
        self.assertAlmostEqual(squat["contacts"], 8, delta=0.5)  # two soles of four corners

    def test_mujoco_does_the_same_work(self):
        rows = [row for part in ("walk", "squat", "slope") for row in self.others(part) if row["engine"].startswith("MuJoCo")]
        if not rows:
            self.skipTest("no MuJoCo")
        for row in rows:
            self.assertEqual(row["differences"], [], f"{row['scene']}: {row['engine']}, {row['setting']}")

    def test_algorithms_find_the_same(self):
        if not self.rows("kernels"):
            self.skipTest("murosimf_peer_kernels is not built")
        for row in self.rows("kernels"):
            self.assertTrue(row["same"], f"{row['engine']}, {row['setting']}")

    def test_fcl_finds_the_same_pairs(self):
        if not self.rows("collision"):
            self.skipTest("murosimf_peer_fcl is not built")
        for row in self.rows("collision"):
            seen = row["observed"]
            for key in ("touching", "on_ground"):
                ours = seen[f"ours_{key}"]
                self.assertLessEqual(abs(seen[key] - ours), 0.05 * ours + 0.5, row["scene"])

    def test_threads_change_no_state(self):
        for row in self.rows("games"):
            self.assertTrue(row["same_state"], row["scene"])

    def test_chart_is_a_picture(self):
        if "no other engine took part" in self.drawn.stderr or "gnuplot" in self.drawn.stderr:
            self.skipTest(self.drawn.stderr.strip())
        self.assertEqual(self.drawn.returncode, 0, self.drawn.stderr)
        self.assertEqual(self.picture[:8], b"\x89PNG\r\n\x1a\n")


class Description(unittest.TestCase):
    """What engines without MJCF are built of, against the file itself."""

    @classmethod
    def setUpClass(cls):
        with scenes.written("slope", 1) as folder:
            done = program("murosimf_peer_describe", folder, 0.05)
            assert done.returncode == 0, done.stderr
            cls.found = json.loads((folder / "description.json").read_text())
        cls.file = xml.etree.ElementTree.parse(ROOT / "models/kid21.xml").getroot()

    def test_masses_and_joints_are_those_of_the_file(self):
        masses = [float(inertial.get("mass")) for inertial in self.file.iter("inertial")]
        joints = {joint.get("name") for joint in self.file.iter("joint") if joint.get("name")}
        self.assertAlmostEqual(sum(link["mass"] for link in self.found["links"]), sum(masses), delta=1e-9)
        self.assertEqual({link["joint"] for link in self.found["links"][1:]}, joints)

    def test_shapes_are_those_of_the_file(self):
        seen = {default.get("class") for default in self.file.iter("default") if default.find("geom[@contype='0']") is not None}
        bodies = sum(geom.get("class") not in seen for body in self.file.iter("body") for geom in body.findall("geom"))
        self.assertEqual(sum(len(link["shapes"]) for link in self.found["links"]), bodies)
        self.assertEqual([shape["kind"] for shape in self.found["statics"]], ["box"])

    def test_servos_are_those_of_the_file(self):
        shin = next(link for link in self.found["links"] if link["joint"] == "j_l_shin")
        for key, value in (("gain", 30), ("damping", 0.909091), ("limit", 6), ("armature", 0.01), ("friction", 0.08)):
            self.assertAlmostEqual(shin[key], value, delta=1e-6)

    def test_targets_are_of_each_cycle_and_joint(self):
        self.assertEqual([len(row) for row in self.found["targets"]], [21] * 5)


class BadInput(unittest.TestCase):
    def refused(self, done, words):
        self.assertNotEqual(done.returncode, 0)
        self.assertNotIn("Traceback", done.stderr)
        self.assertIn(words, done.stderr.strip().splitlines()[-1])

    def test_arguments_of_the_race(self):
        for arguments, words in (
                (["jump"], "unknown part 'jump'"), (["--rounds", "0"], "--rounds"), (["--length", "nan"], "--length"),
                (["--robots", "23"], "--robots"), (["--out", "/no/such/folder/race.json"], "folder"),
                (["walk", "--quick", "--build", "/no/such/build"], "is not there"),
                (["walk", "--quick", "--python", "/no/such/python"], "has no MuJoCo")):
            with self.subTest(arguments):
                self.refused(race(*arguments), words)

    def test_other_files_are_not_overwritten(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "notes.json"
            for text in ("my notes", "[]", '{"schema": "murosimf/run/1"}'):
                out.write_text(text)
                self.refused(race("games", "--quick", "--out", out), "is no document of a race")
                self.assertEqual(out.read_text(), text)

    def test_arguments_of_a_program(self):
        for arguments, words in (
                ([], "usage"), (["/no/such/folder"], "/no/such/folder"), (["/tmp", "--seconds", "long"], "'long'"),
                (["/tmp", "--setting", "best"], "unknown setting 'best'"), (["/tmp", "--seconds"], "needs a value"),
                (["/tmp", "--fast"], "--fast")):
            with self.subTest(arguments):
                self.refused(program("murosimf_peer_murosimf", *arguments), words)
        self.refused(program("murosimf_peer_describe", "/tmp", "-1"), "seconds '-1'")

    def test_descriptions(self):
        with scenes.written("slope", 1) as folder:
            program("murosimf_peer_describe", folder, 0.05)
            file = folder / "description.json"
            good = json.loads(file.read_text())
            for change, words in (({"targets": [[0.0]]}, "targets"), ({"robots": []}, "no joints, robots"),
                                  ({"step": 0}, "steps"), ({"links": "none"}, "type")):
                file.write_text(json.dumps(good | change))
                with self.subTest(change):
                    self.refused(program("murosimf_peer_murosimf", folder), words)
            file.write_text("{")
            self.refused(program("murosimf_peer_murosimf", folder), "description.json")


class Numbers(unittest.TestCase):
    def test_exponent_of_a_power_law(self):
        self.assertAlmostEqual(growth.exponent([(n, 3 * n**1.7) for n in (1, 2, 5, 100)]), 1.7)
        self.assertTrue(math.isnan(growth.exponent([(1, 1), (2, -0.1)])))

    def test_ratios_are_of_the_same_round(self):
        slow, fast = contest.Entrant("a", "", None), contest.Entrant("b", "", None)
        slow.times, fast.times = [2, 12, 9], [1, 4, 9]
        self.assertEqual(contest.ratios(slow, fast), (2, 1, 3))

    def test_other_work_is_named(self):
        did = {"height_m": 0.28, "distance_m": 0.5, "contacts": 4, "tracking_rad": 0.05, "lying": 0, "depth_mm": 1,
               "gap_mm": 0}
        self.assertEqual(likeness.differences("walk", did, did), [])
        fell = did | {"height_m": 0.1, "lying": 1, "gap_mm": 2}
        self.assertEqual(likeness.differences("walk", fell, did), ["height", "lying", "gap"])
        self.assertEqual(likeness.differences("walk", did | {"distance_m": math.nan}, did), ["distance"])

    def test_robots_with_arms_have_so_many_hinges(self):
        for joints in (1, 5, 23, 100):
            robot = xml.etree.ElementTree.fromstring(growth.robot_with(joints))
            self.assertEqual(len(list(robot.iter("joint"))), joints)
            self.assertEqual(len(list(robot.iter("position"))), joints)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
