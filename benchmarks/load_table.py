#!/usr/bin/env python3
"""What 1 to 400 robots cost: the time until the first step, and the time of a step.

    benchmarks/load_table.py --program build/release/murosimf                     prints a table
    benchmarks/load_table.py --program build/release/murosimf --out load.json     and writes it as JSON

The robots (kid21, which has a camera and four other sensors) walk in rows, 1 m apart; every camera knows of all others,
so each robot's start-up grows with the number of robots. Nothing is drawn. Start-up is the wall time of a run of 0 s,
of which the least of several counts; a step is 1 ms long and its time that of the report, divided by the number of
steps.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

COUNTS = [1, 2, 5, 10, 20, 50, 100, 200, 400]
STEPS = 1000  # per second


def scene(robots, level):
    text = 'duration = 1\n[ball]\nposition = [-5, -5]\n'
    for i in range(robots):
        text += (f'[[robots]]\nname = "r{i}"\nmodel = "kid21"\nlevel = "{level}"\n'
                 f'controller = "walk"\ncommand = [0.1, 0, 0]\n'
                 f'position = [{i % 20}, {i // 20}]\n')
    return text


def run(program, file, duration):
    start = time.perf_counter()
    done = subprocess.run([program, "run", file, "--duration", str(duration), "--no-cameras", "--json", "-"],
                          capture_output=True, text=True, check=False)
    wall = time.perf_counter() - start
    if done.returncode != 0:
        sys.exit(f"load_table: {done.stderr.strip()}")
    return wall, json.loads(done.stdout)


def measure(program, robots, level, repetitions, folder):
    file = folder / f"{robots}.toml"
    file.write_text(scene(robots, level))
    startup = min(run(program, file, 0)[0] for _ in range(repetitions))
    duration = min(1.0, max(0.05, 10 / robots))
    walls = [run(program, file, duration)[1]["wall_s"] for _ in range(repetitions)]
    us_per_step = round(1e6 * min(walls) / (STEPS * duration), 2)
    return {"robots": robots, "startup_s": round(startup, 4), "us_per_step": us_per_step}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--level", default="kinematic_walking")
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--out", type=pathlib.Path, help="JSON file to write")
    options = parser.parse_args()
    rows = []
    print(f"{'robots':>6} {'start-up [s]':>13} {'step [us]':>10} {'per robot [us]':>15}")
    with tempfile.TemporaryDirectory(prefix="murosimf_load_") as name:
        for robots in COUNTS:
            row = measure(options.program, robots, options.level, options.repetitions, pathlib.Path(name))
            rows.append(row)
            us = row["us_per_step"]
            print(f"{robots:6} {row['startup_s']:13.3f} {us:10.1f} {us / robots:15.2f}", flush=True)
    if options.out:
        options.out.write_text(json.dumps({"schema": 1, "level": options.level, "rows": rows}, indent=2) + "\n")


if __name__ == "__main__":
    main()
