"""Programs of a race: where they are, and one run of one of them."""
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent


class Failure(Exception):
    """A run that cannot be; the message is one line."""


def fail(message):
    sys.exit(f"race: {message}")


def last_line(text):
    lines = text.strip().splitlines()
    return lines[-1] if lines else "it says nothing"


def run(command, cwd=None):
    """The JSON of the last line that a program prints."""
    command = list(map(str, command))
    # one thread for linear algebra, whatever the machine's default is
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    try:
        done = subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True, check=False)
    except OSError as error:
        raise Failure(str(error)) from None
    name = pathlib.Path(command[1] if command[0].endswith(("python", "python3")) else command[0]).name
    if done.returncode != 0:
        raise Failure(f"{name} failed ({done.returncode}): {last_line(done.stderr)}")
    try:
        return json.loads(done.stdout if done.stdout.lstrip().startswith("{\n") else last_line(done.stdout))
    except json.JSONDecodeError:
        raise Failure(f"{name} printed no JSON") from None


class Machine:
    """What is there to race: our build, an interpreter that has MuJoCo."""

    def __init__(self, build, python):
        self.build, self.python = build.resolve(), python
        self.missing = []  # one line each

    def program(self, name):
        file = self.build / name
        return file if file.is_file() else None

    def own(self, name):
        """A program without which there is no race."""
        return self.program(name) or fail(f"{self.build}/{name} is not there; cmake --build {self.build} --target murosimf_peers")

    def miss(self, line):
        if line not in self.missing:
            self.missing.append(line)
            print(f"missing: {line}", flush=True)

    def has_module(self, module):
        if not self.python:
            return False
        return subprocess.run([self.python, "-c", f"import {module}"], capture_output=True, check=False).returncode == 0


def find_python(given):
    """An interpreter with MuJoCo: what was given, or one that a script of ours has made; None if there is none."""
    candidates = [given] if given else [ROOT / "build/peers-venv/bin/python", ROOT / "build/oracle-venv/bin/python", "python3"]
    for candidate in candidates:
        try:
            if subprocess.run([candidate, "-c", "import mujoco"], capture_output=True, check=False).returncode == 0:
                return candidate
        except OSError:
            continue
    return None


def install():
    """Makes build/peers-venv with what the race needs from PyPI."""
    folder = ROOT / "build/peers-venv"
    for command in ([sys.executable, "-m", "venv", folder],
                    [folder / "bin/python", "-m", "pip", "install", "--quiet", "mujoco>=3.1,<5", "numpy>=1.24,<3", "pin>=3,<5"]):
        if subprocess.run(list(map(str, command)), check=False).returncode != 0:
            fail(f"cannot install into {folder}: see above")
