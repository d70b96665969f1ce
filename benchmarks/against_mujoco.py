#!/usr/bin/env python3
"""Measures what one step of kid21 costs in MuJoCo and at our levels, by turns in one run.

The robot walks or stands on the ground at 1 kHz with the same joint targets from the walk engine: MuJoCo replays them,
our benchmark program runs the engine (100 Hz) in its steps. Both count the processor time of their thread. MuJoCo
takes the ten steps of a control cycle in one call, so that Python costs it 2 or 3 percent (measured against one call
for all steps; mujoco.rollout costs as much). Every round measures everything once; medians and minima are over the
rounds.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = {"walking": (0.2, 0, 0), "standing": (0, 0, 0)}  # [m/s, m/s, rad/s]
# integrator, and whether the joints have their Coulomb friction, which MuJoCo solves as 21 constraints; the file says
# the first of these
VARIANTS = {
    "implicit": ("IMPLICIT", True),
    "implicitfast": ("IMPLICITFAST", True),
    "Euler": ("EULER", True),
    "Euler, frictionless joints": ("EULER", False),
}
WARM = 1.0  # [s] past the start
SHORTEST = 0.3  # [s] of processor time per benchmark of ours


def fail(message):
    sys.exit(f"against_mujoco: {message}")


try:
    import mujoco
    import numpy as np
except ImportError as missing:
    fail(f"{missing}; pip install mujoco")


def run(program, *arguments):
    """The JSON that a program prints."""
    command = [str(program), *map(str, arguments)]
    try:
        output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        return json.loads(output)
    except (OSError, subprocess.CalledProcessError) as error:
        fail(f"{error}; {(getattr(error, 'stderr', None) or '').strip()}".rstrip("; "))
    except json.JSONDecodeError:
        fail(f"{program} printed no JSON; is it the right program?")


class Replay:
    """MuJoCo's robot in one variant with one list of targets."""

    def __init__(self, file, integrator, joint_friction, walk):
        try:
            self.model = mujoco.MjModel.from_xml_path(str(file))
        except ValueError as error:
            fail(f"{file}: {str(error).splitlines()[0]}")
        self.model.opt.integrator = getattr(mujoco.mjtIntegrator, "mjINT_" + integrator)
        if not joint_friction:
            self.model.dof_frictionloss[:] = 0
        self.data = mujoco.MjData(self.model)
        self.walk = walk
        self.steps = round(walk["period"] / self.model.opt.timestep)
        joints = [mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in walk["joints"]]
        if sorted(joints) != sorted(self.model.actuator_trnid[:, 0]):
            fail(f"{file} has other joints or actuators than kid21")
        order = [joints.index(joint) for joint in self.model.actuator_trnid[:, 0]]
        self.targets = np.array(walk["targets"])
        self.controls = np.ascontiguousarray(self.targets[:, order])
        self.positions = self.model.jnt_qposadr[joints]

    def start(self):
        mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[:7] = self.walk["start"]
        self.data.qpos[self.positions] = self.targets[0]

    def cycles(self, controls):
        model, data, steps = self.model, self.data, self.steps
        for control in controls:
            data.ctrl[:] = control
            mujoco.mj_step(model, data, steps)

    def seconds_per_step(self):
        """Processor time, over all targets after the warm-up."""
        self.start()
        warm = round(WARM / self.walk["period"])
        self.cycles(self.controls[:warm])
        begin = time.thread_time()
        self.cycles(self.controls[warm:])
        return (time.thread_time() - begin) / (self.steps * len(self.controls[warm:]))

    def observe(self):
        """Mean number of contacts, distance [m] and whether the robot lies in the end."""
        self.start()
        contacts, place = [], self.data.qpos[:2].copy()
        for control in self.controls:
            self.cycles([control])
            contacts.append(self.data.ncon)
        upright = self.data.xmat[1].reshape(3, 3)[2, 2]
        return statistics.fmean(contacts), float(np.linalg.norm(self.data.qpos[:2] - place)), int(upright < 0.5)


class Row:
    """Times of one program in one scene."""

    def __init__(self, scene, what, contacts, falls):
        self.scene, self.what, self.contacts, self.falls = scene, what, contacts, falls
        self.times = []  # [us]

    median = property(lambda self: statistics.median(self.times))

    def to_json(self):
        return {**vars(self), "median": self.median, "minimum": min(self.times)}


def mujoco_rows(options, targets_program):
    """(row, replay) for every scene and variant."""
    for scene, command in SCENES.items():
        walk = run(targets_program, WARM + options.seconds, *command)
        for name, variant in VARIANTS.items():
            replay = Replay(options.robot, *variant, walk)
            contacts, distance, falls = replay.observe()
            print(f"MuJoCo {name}, {scene}: {contacts:.1f} contacts, went {distance:.2f} m, {falls} falls")
            yield Row(scene, f"MuJoCo {name}", contacts, falls), replay


def measure_ours(benchmarks, rows):
    arguments = [f"--benchmark_min_time={SHORTEST}", "--benchmark_format=json"]
    found = run(benchmarks, f"--benchmark_filter=^({'|'.join(SCENES)})_robot/", *arguments)["benchmarks"]
    if not found:
        fail(f"{benchmarks} has no benchmarks of walking and standing robots")
    for entry in found:
        scene, level = entry["name"].split("_robot/")
        row = rows.setdefault(entry["name"], Row(scene, level, entry["contacts"], int(entry["falls"])))
        row.times.append({"ns": 1e-3, "us": 1.0, "ms": 1e3}[entry["time_unit"]] * entry["cpu_time"])


def measure(options, programs):
    theirs = list(mujoco_rows(options, programs["murosimf_walk_targets"]))
    ours = {}
    for _ in range(options.repetitions):
        for row, replay in theirs:
            row.times.append(1e6 * replay.seconds_per_step())
        measure_ours(programs["murosimf_benchmarks"], ours)
    return [row for row, _ in theirs], list(ours.values())


def print_table(theirs, ours):
    titles = [f"{name} /" for name in VARIANTS]
    print("\n| robot | simulated by | contacts | falls | median, us | min, us | " + " | ".join(titles) + " |")
    print("|---" * (6 + len(titles)) + "|")
    for scene in SCENES:
        base = [row for row in theirs if row.scene == scene]
        for row in base + [row for row in ours if row.scene == scene]:
            ratios = " | ".join(f"{other.median / row.median:.1f}" if row not in theirs else "" for other in base)
            cells = f"{row.contacts:.1f} | {row.falls} | {row.median:.2f} | {min(row.times):.2f}"
            print(f"| {scene} | {row.what} | {cells} | {ratios} |")


def parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release", help="folder of the programs")
    parser.add_argument("--robot", type=pathlib.Path, default=ROOT / "models/kid21.xml")
    parser.add_argument("--repetitions", type=int, default=7, help="rounds")
    parser.add_argument("--seconds", type=float, default=5, help="simulated seconds of MuJoCo per round")
    parser.add_argument("--out", type=pathlib.Path, help="JSON file for the results")
    options = parser.parse_args()
    if options.repetitions < 1 or not 0 < options.seconds < 1000:
        fail("--repetitions must be at least 1, --seconds more than 0 and less than 1000")
    if not options.robot.is_file():
        fail(f"{options.robot} is not there")
    if options.out and not options.out.absolute().parent.is_dir():
        fail(f"the folder of {options.out} is not there")
    return options


def find_programs(folder):
    programs = {name: folder / name for name in ("murosimf_benchmarks", "murosimf_walk_targets")}
    for program in programs.values():
        if not program.is_file():
            fail(f"{program} is not there; cmake --build {folder} --target {' '.join(programs)}")
    return programs


def main():
    options = parse()
    programs = find_programs(options.build)
    print(f"MuJoCo {mujoco.__version__}, {options.repetitions} rounds, load {os.getloadavg()[0]:.1f}")
    theirs, ours = measure(options, programs)
    print_table(theirs, ours)
    if options.out:
        result = {"mujoco": mujoco.__version__, "unit": "us", "rows": [row.to_json() for row in theirs + ours]}
        options.out.write_text(json.dumps(result, indent=2) + "\n")


if __name__ == "__main__":
    main()
