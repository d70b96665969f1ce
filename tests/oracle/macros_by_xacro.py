#!/usr/bin/env python3
"""Robot files with macros, expanded by PyPI's xacro: as the tests of the reader have them, and from the command line.

Usage: macros_by_xacro.py <murosimf> <test_robot_formats>
Exit: 0 all right, 1 something is wrong, 77 xacro is not installed (test is skipped).
"""
import importlib.util
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

if importlib.util.find_spec("xacro") is None:
    print("skipped: pip install xacro")
    sys.exit(77)

ROBOT = """<robot name='r' xmlns:xacro='http://ros.org/wiki/xacro'><xacro:arg name='mass' default='2'/>
<link name='base'><inertial><mass value='$(arg mass)'/>
<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link>
</robot>
"""
# The Python with xacro is the first that programs find.
found = {**os.environ, "PATH": os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])}


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, env=found, check=False)


def main():
    murosimf, tests = sys.argv[1:]
    done = run(tests, "--gtest_filter=Xacro.*")
    wrong = done.returncode != 0 or "SKIPPED" in done.stdout
    if wrong:
        print(done.stdout)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "robot.urdf.xacro"
        file.write_text(ROBOT)
        for given, mass in (([], 2), (["--xacro", "mass:=7"], 7)):
            checked = run(murosimf, "check", str(file), "--json", "-", *given)
            told = json.loads(checked.stdout)["total_mass_kg"] if checked.returncode == 0 else checked.stderr
            print(f"{given}: {told} kg, {mass} is right")
            wrong = wrong or told != mass
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
