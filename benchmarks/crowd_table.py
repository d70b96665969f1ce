#!/usr/bin/env python3
"""What a step costs in a crowd of 20 to 200 robots, and whether ten times the robots cost more than ten times as much.

    benchmarks/crowd_table.py --program build/release/murosimf                    prints a table
    benchmarks/crowd_table.py --program build/release/murosimf --out crowd.json   and writes it as JSON
    benchmarks/crowd_table.py --program OLD --program NEW                         both in turns, for a comparison

Robots (kid21, without cameras) walk at two levels. "apart": in rows of twenty, 1 m apart, all the same way. "groups": each
four of them towards their middle, so that they push each other all the time; groups are 2 m apart. "rays": as apart, at
kinematic_walking, and each robot has a laser (1081 rays) and a sonar, ten samples per second. "eyes": the same with a detector
instead, which looks at all others: what it is asked for grows with the square of the robots.
A step is 1 ms long; its time is the processor time of a run less that of a run of 0 s, divided by the number of steps: the
least of several runs of either kind. Other load on the machine counts only by what it takes of the caches.
"""

import argparse
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

COUNTS = [20, 50, 100, 200]
STEPS = 1000  # per second
CASES = [  # arrangement, level, duration [s]
    ("apart", "kinematic_walking", 0.5),
    ("apart", "simplified_dynamics", 0.5),
    ("groups", "kinematic_walking", 0.5),
    ("groups", "simplified_dynamics", 0.5),
    ("rays", "kinematic_walking", 0.2),
    ("eyes", "kinematic_walking", 0.2),
]
RAYS = """  [robots.sensors.laser]
  type = "laser"
  frame = "head"
  rate = 10
  [robots.sensors.sonar]
  type = "sonar"
  frame = "torso"
  rate = 10
"""
EYES = """  [robots.sensors.detector]
  type = "detector"
  frame = "head"
  rate = 10
"""
SENSORS = {"rays": RAYS, "eyes": EYES}


def place(arrangement, i):
    """Position [m] and heading [deg] of robot i."""
    if arrangement != "groups":
        return i % 20, i // 20, 0
    group, corner = divmod(i, 4)
    angle = math.radians(45 + 90 * corner)
    x = 2 * (group % 8) + 0.25 * math.cos(angle)
    y = 2 * (group // 8) + 0.25 * math.sin(angle)
    return round(x, 4), round(y, 4), 45 + 90 * corner - 180


def scene(arrangement, level, robots):
    text = "duration = 1\n[ball]\nposition = [-5, -5]\n"
    for i in range(robots):
        x, y, heading = place(arrangement, i)
        text += (f'[[robots]]\nname = "r{i}"\nmodel = "kid21"\nlevel = "{level}"\ncontroller = "walk"\n'
                 f'command = [0.1, 0, 0]\nposition = [{x}, {y}]\nheading_deg = {heading}\n')
        text += "[robots.sensors]\ncamera = false\n"
        text += SENSORS.get(arrangement, "")
    return text


def run(program, file, duration):
    """Processor time [s] of a run, and the state that it comes to."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, "run", file, "--duration", str(duration), "--no-cameras", "--threads", "1", "--json", "-"],
                          capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(f"crowd_table: {done.stderr.strip()}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, json.loads(done.stdout)["state_hash"]


def measure(programs, case, repetitions, folder):
    """One row per program and number of robots; programs take turns."""
    arrangement, level, duration = case
    rows = []
    for robots in COUNTS:
        file = folder / f"{arrangement}_{robots}.toml"
        file.write_text(scene(arrangement, level, robots))
        longer = duration * max(1, 100 / robots)  # few robots: so that there is something to be measured
        startup, whole, states = [math.inf] * len(programs), [math.inf] * len(programs), set()
        for _ in range(repetitions):
            for k, program in enumerate(programs):
                startup[k] = min(startup[k], run(program, file, 0)[0])
                time, state = run(program, file, longer)
                whole[k] = min(whole[k], time)
                states.add(state)
        if len(states) > 1:
            sys.exit(f"crowd_table: {arrangement}, {level}, {robots} robots: the programs come to different states")
        for k, program in enumerate(programs):
            us = 1e6 * (whole[k] - startup[k]) / (STEPS * longer)
            rows.append({"program": program, "arrangement": arrangement, "level": level, "robots": robots,
                         "startup_s": round(startup[k], 4), "us_per_step": round(us, 2)})
    return rows


def show(programs, case, rows):
    for program in programs:
        us = [row["us_per_step"] for row in rows if row["program"] == program]
        name = f"{program}: " if len(programs) > 1 else ""
        figures = " ".join(f"{value:10.1f}" for value in us)
        print(f"{name}{case[0]:8} {case[1]:20} {figures} {us[-1] / us[0]:10.1f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--program", required=True, action="append")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--only", choices=["apart", "groups", "rays", "eyes"], help="one arrangement")
    parser.add_argument("--out", type=pathlib.Path, help="JSON file to write")
    options = parser.parse_args()
    print(f"{'us per step':29} " + " ".join(f"{count:>10}" for count in COUNTS) + f" {'200 to 20':>10}")
    rows = []
    with tempfile.TemporaryDirectory(prefix="murosimf_crowd_") as name:
        for case in CASES:
            if options.only in (None, case[0]):
                found = measure(options.program, case, options.repetitions, pathlib.Path(name))
                show(options.program, case, found)
                rows += found
    if options.out:
        options.out.write_text(json.dumps({"schema": 1, "rows": rows}, indent=2) + "\n")


if __name__ == "__main__":
    main()
