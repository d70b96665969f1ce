#!/usr/bin/env python3
"""What longer steps change: walks, kicks, pushes and a heap at each level and contact law, by the length of a step.

    benchmarks/step_sizes.py --program build/release/murosimf
    benchmarks/step_sizes.py --program build/release/murosimf --out step_sizes.json walk kick

Every experiment has some variants, since one run tells little: a kick that comes a step later meets the ball elsewhere. All are
run with steps of 0.25 ms first; what longer steps change of a result is their error. The table has means over the variants, and
how many of them ended otherwise (fell or did not, was frozen; in the heap only: were frozen). Wall time is not measured, so that
other load does not matter.
"""
import argparse
import concurrent.futures
import json
import math
import os
import shutil
import statistics
import subprocess
import sys

LEVELS = ["simplified_dynamics", "full_dynamics", "articulated_dynamics"]
LAWS = ["implicit_stick", "kelvin_voigt", "paper"]
STEPS_MS = [0.5, 1, 2, 5, 10]
REFERENCE_MS = 0.25


class Experiment:
    """One scene, variants of it (lists of --set), and what is measured: entity -> number, in `unit`."""

    def __init__(self, name, scene, duration, robots, variants, measure, unit, scale=1.0):
        self.name, self.scene, self.duration, self.robots = name, scene, duration, robots
        self.variants, self.measure, self.unit, self.scale = variants, measure, unit, scale


def of(report, name):
    return next(entity for entity in report["entities"] if entity["name"] == name)


def robots_of(report):
    return [entity for entity in report["entities"] if entity["model"] not in ("ball", "field")]


def mean_height(report):
    return statistics.mean(robot["position"][2] for robot in robots_of(report))


EXPERIMENTS = [
    Experiment("walk", "walk", 10, "walker",
               [[f"walker.command=[{v}, {w}, {turn}]"] for v, w, turn in
                [(0.1, 0, 0), (0.15, 0, 0), (0.2, 0, 0), (0.1, 0.05, 0), (0.1, 0, 0.3)]],
               lambda report: of(report, "walker")["distance_m"], "% of the way"),
    Experiment("kick", "kick", 5, "robot",
               [[f"ball.position=[{x}, {y}]"] for x, y in
                [(0.20, -0.056), (0.19, -0.056), (0.21, -0.056), (0.20, -0.046), (0.20, -0.066)]],
               lambda report: of(report, "ball")["distance_m"], "% of the ball's way"),
    Experiment("push", "push", 3, "robot",
               [[f"ball.velocity=[{v}, 0.0, 0.8]"] for v in (2.0, 2.5, 3.0, 3.5, 4.0)],
               lambda report: math.hypot(*of(report, "robot")["position"][:2]), "mm of the place", 1000),
    Experiment("heap", "heap", 4, "*", [[], ["seed=2"], ["seed=3"]], mean_height, "mm of the mean height", 1000),
]


def run(program, experiment, variant, level, law, step_ms):
    settings = [*variant, f"rate={1000 / step_ms:g}", f"{experiment.robots}.level={level}",
                f"{experiment.robots}.contact={law}"]
    command = [program, "run", experiment.scene, "--no-cameras", "--duration", str(experiment.duration), "--json", "-"]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"step_sizes: '{' '.join(command)}' ended with {done.returncode}: {done.stderr.strip()}")
    report = json.loads(done.stdout)
    robots = robots_of(report)
    return {"value": experiment.measure(report), "fallen": sum(robot["falls"] > 0 for robot in robots),
            "frozen": sum(robot["frozen"] for robot in robots)}


def compare(experiment, runs, references):
    """Means of what differs from the runs with the shortest steps."""
    errors, otherwise = [], 0
    for one, reference in zip(runs, references, strict=True):
        ends = ["frozen"] if experiment.name == "heap" else ["fallen", "frozen"]
        if any(one[end] != reference[end] for end in ends):
            otherwise += 1
            continue
        error = one["value"] - reference["value"]
        errors.append(abs(100 * error / reference["value"]) if experiment.unit.startswith("%") else abs(experiment.scale * error))
    return {"error": statistics.mean(errors) if errors else None, "otherwise": otherwise, "of": len(runs)}


def rows_of(program, experiment, pool):
    tasks = {}
    for level in LEVELS:
        for law in LAWS:
            for step in [REFERENCE_MS, *STEPS_MS]:
                tasks[level, law, step] = [pool.submit(run, program, experiment, variant, level, law, step)
                                           for variant in experiment.variants]
    for level in LEVELS:
        for law in LAWS:
            references = [task.result() for task in tasks[level, law, REFERENCE_MS]]
            row = {"experiment": experiment.name, "unit": experiment.unit, "level": level, "law": law, "steps": {}}
            for step in STEPS_MS:
                row["steps"][step] = compare(experiment, [task.result() for task in tasks[level, law, step]], references)
            yield row


def cell(result):
    error = "-" if result["error"] is None else f"{result['error']:.2g}"
    return error + (f" ({result['otherwise']} of {result['of']})" if result["otherwise"] else "")


def line(*cells):
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    names = [experiment.name for experiment in EXPERIMENTS]
    parser.add_argument("experiments", nargs="*", metavar="EXPERIMENT", help=", ".join(names) + "; all if not given")
    parser.add_argument("--program", default="murosimf")
    parser.add_argument("--out", help="write JSON to this file")
    arguments = parser.parse_args()
    for name in arguments.experiments:
        if name not in names:
            parser.error(f"no experiment '{name}'; there are {', '.join(names)}")
    if not shutil.which(arguments.program):
        parser.error(f"'{arguments.program}' is no program")
    chosen = [e for e in EXPERIMENTS if not arguments.experiments or e.name in arguments.experiments]
    rows = []
    pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    try:
        for experiment in chosen:
            print(f"\n{experiment.name}: {experiment.unit}\n")
            print(line("level", "law", *[f"{step:g} ms" for step in STEPS_MS]))
            print("|---" * (2 + len(STEPS_MS)) + "|")
            for row in rows_of(arguments.program, experiment, pool):
                rows.append(row)
                print(line(f"`{row['level']}`", f"`{row['law']}`", *map(cell, row["steps"].values())), flush=True)
    finally:
        pool.shutdown(cancel_futures=True)
    if arguments.out:
        with open(arguments.out, "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main()
