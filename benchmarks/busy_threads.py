#!/usr/bin/env python3
"""Are two threads worth it where other programs run? Times of whole runs with one and with two threads, by turns.

    benchmarks/busy_threads.py --program build/release/murosimf
    benchmarks/busy_threads.py --program build/release/murosimf --rounds 9 --out busy.json three_on_three eleven_a_side

Others are programs that keep a core busy: none, one, two; `one core` has none, and the runs may use one core only (taskset). Each
round runs every scene with one thread, with all (`--threads`), and with all sharing every wave out whether that pays or not
(MUROSIMF_SHARE_WAVES=always). What is compared is wall time, so the machine should be calm; medians of the rounds, and ratios of
medians. The exit code is 1 if all threads are slower than `--least` times one thread somewhere.
"""
import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys

SCENES = ["three_on_three", "eleven_a_side"]
SITUATIONS = {"calm": 0, "one other": 1, "two others": 2, "one core": 0}
WAYS = ["one thread", "all threads", "sharing always"]


def run(options, scene, way, situation):
    """How many times real time."""
    command = [options.program, "run", scene, "--no-cameras", "--duration", str(options.duration), "--json", "-",
               "--threads", "1" if way == "one thread" else str(options.threads)]
    if situation == "one core":
        command = ["taskset", "-c", str(min(os.sched_getaffinity(0))), *command]
    environment = {name: value for name, value in os.environ.items() if name != "MUROSIMF_SHARE_WAVES"}
    if way == "sharing always":
        environment["MUROSIMF_SHARE_WAVES"] = "always"
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    if done.returncode != 0:
        sys.exit(f"busy_threads: '{' '.join(command)}' ended with {done.returncode}: {done.stderr.strip()}")
    return json.loads(done.stdout)["real_time_factor"]


class Others:
    """Programs that do nothing but take time."""

    def __init__(self, count):
        self.count, self.programs = count, []

    def __enter__(self):
        loop = [sys.executable, "-c", "while True: pass"]
        self.programs = [subprocess.Popen(loop) for _ in range(self.count)]

    def __exit__(self, *_):
        for program in self.programs:
            program.kill()
            program.wait()


def measure(options, scene, situation):
    speeds = {way: [] for way in WAYS}
    with Others(SITUATIONS[situation]):
        for number in range(options.rounds):
            order = WAYS if number % 2 == 0 else WAYS[::-1]
            for way in order:
                speeds[way].append(run(options, scene, way, situation))
    row = {way: statistics.median(speeds[way]) for way in WAYS}
    return {"scene": scene, "others": situation, **row, "ratio": row["all threads"] / row["one thread"],
            "ratio_always": row["sharing always"] / row["one thread"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="all of " + ", ".join(SCENES) + " if none is given")
    parser.add_argument("--program", default="build/release/murosimf")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--duration", type=float, default=2, help="simulated seconds of each run")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--situation", action="append", choices=SITUATIONS, help="several; all if not given")
    parser.add_argument("--least", type=float, default=0, help="ratio below which the exit code is 1")
    parser.add_argument("--out", help="write all figures to this file (JSON)")
    options = parser.parse_args()
    if shutil.which(options.program) is None:
        sys.exit(f"busy_threads: {options.program} is not there: build it first (scripts/build_preset release)")
    situations = options.situation or list(SITUATIONS)
    if "one core" in situations and shutil.which("taskset") is None:
        sys.exit("busy_threads: 'one core' needs the program taskset (Debian and Ubuntu: util-linux)")
    rows = []
    print("| scene | others | one thread | all | ratio | sharing always | ratio |\n|---|---|---|---|---|---|---|")
    for scene in options.scenes or SCENES:
        for situation in situations:
            row = measure(options, scene, situation)
            rows.append(row)
            print(f"| {scene} | {situation} | {row['one thread']:.1f} | {row['all threads']:.1f} | {row['ratio']:.2f} | "
                  f"{row['sharing always']:.1f} | {row['ratio_always']:.2f} |", flush=True)
    if options.out:
        with open(options.out, "w", encoding="utf-8") as file:
            json.dump({"threads": options.threads, "duration_s": options.duration, "rows": rows}, file, indent=1)
    sys.exit(1 if any(row["ratio"] < options.least for row in rows) else 0)


if __name__ == "__main__":
    main()
