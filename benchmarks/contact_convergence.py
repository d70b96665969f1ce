#!/usr/bin/env python3
"""How contact approaches its limit with shorter steps: where things end, against the own run at 16 kHz, and what a step costs.

    benchmarks/contact_convergence.py --program build/release/murosimf
    build/oracle-venv/bin/python benchmarks/contact_convergence.py --program build/release/murosimf --out convergence.json

    toss    cubes of 10 cm and 370 g, thrown with spin: place after 1.2 s
    slide   boxes of 1 kg that slide to rest from 0.5 to 1.4 m/s: place after 1 s
    bounce  balls from 0.3 to 1.2 m: height after 1 s
    stack   ten cubes, the topmost: place after 5 s
    kick    `murosimf run kick`, the ball at five places: its place after 5 s

The error is the median over the variants, in mm, and the microseconds are the median of a step. MuJoCo simulates the first
two and the stack too, if this Python has it: boxes of the same size, mass and friction with the ground, solref of 0.02 s at
every step, against its own run at 16 kHz.
"""
import argparse
import json
import math
import random
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

STEPS_MS = [0.25, 0.5, 1, 2, 5, 10]
REFERENCE_MS = 1 / 16
FRICTION = 0.18


class Box:
    """A cube of 10 cm. Lengths in m, kg, m/s, rad/s."""

    def __init__(self, name, mass, position, velocity=(0, 0, 0), spin=(0, 0, 0)):
        self.name, self.mass, self.position, self.velocity, self.spin = name, mass, position, velocity, spin

    def as_toml(self):
        return (f"[[bodies]]\nname = '{self.name}'\nshape = 'box'\nsize = [0.1, 0.1, 0.1]\nmass = {self.mass}\n"
                f"position = {list(self.position)}\nvelocity = {list(self.velocity)}\nangular_velocity = {list(self.spin)}\n")

    def as_mjcf(self):
        x, y, z = self.position
        return (f"<body pos='{x} {y} {z + 0.05}'><freejoint/><geom type='box' size='.05 .05 .05' mass='{self.mass}' "
                f"friction='{FRICTION} 0 0'/></body>")


class Variant:
    """One run: a scene's file or name with settings, and for MuJoCo its boxes."""

    def __init__(self, scene, duration, watched, settings=(), boxes=()):
        self.scene, self.duration, self.watched, self.settings, self.boxes = scene, duration, watched, list(settings), list(boxes)


def write(folder, name, text):
    file = folder / f"{name}.toml"
    file.write_text(f"name = '{name}'\n{text}", encoding="utf-8")
    return str(file)


def of_boxes(folder, name, boxes, duration):
    text = "[field]\ngoals = false\n[[materials]]\npair = ['plastic', 'carpet']\n" + f"friction = {FRICTION}\n"
    return Variant(write(folder, name, text + "".join(box.as_toml() for box in boxes)), duration, boxes[-1].name, boxes=boxes)


def tosses(folder):
    dice = random.Random(1)
    for i in range(24):
        velocity = [dice.uniform(0.3, 1.2), dice.uniform(-0.3, 0.3), dice.uniform(-0.5, 0.5)]
        box = Box("cube", 0.37, [0, 0, 0.15], velocity, [dice.uniform(-8, 8) for _ in range(3)])
        yield of_boxes(folder, f"toss{i}", [box], 1.2)


def slides(folder):
    for i in range(10):
        yield of_boxes(folder, f"slide{i}", [Box("box", 1, [0, 0, 0], [0.5 + 0.1 * i, 0, 0])], 1)


def bounces(folder):
    for i in range(10):
        text = f"[field]\ngoals = false\n[ball]\nposition = [0, 0, {0.3 + 0.1 * i}]\n"
        yield Variant(write(folder, f"bounce{i}", text), 1, "ball")


def stacks(folder):
    boxes = [Box(f"c{i}", 1, [0.002 * (i % 2), 0, 0.1 * i]) for i in range(10)]
    yield of_boxes(folder, "stack", boxes, 5)


def kicks(_):
    for x, y in [(0.20, -0.056), (0.19, -0.056), (0.21, -0.056), (0.20, -0.046), (0.20, -0.066)]:
        yield Variant("kick", 5, "ball", [f"ball.position=[{x}, {y}]"])


EXPERIMENTS = {"toss": tosses, "slide": slides, "bounce": bounces, "stack": stacks, "kick": kicks}


def run(program, variant, step_ms):
    """End [m] of what is watched, and seconds of a step."""
    command = [program, "run", variant.scene, "--no-cameras", "--duration", str(variant.duration), "--json", "-"]
    for setting in [f"rate={1000 / step_ms:g}", *variant.settings]:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"contact_convergence: '{' '.join(command)}' ended with {done.returncode}: {done.stderr.strip()}")
    report = json.loads(done.stdout)
    end = next(entity["position"] for entity in report["entities"] if entity["name"] == variant.watched)
    return end, report["wall_s"] / (variant.duration * 1000 / step_ms)


def run_mujoco(mujoco, variant, step_ms):
    model = mujoco.MjModel.from_xml_string(
        f"<mujoco><option timestep='{step_ms / 1000}'/><worldbody><geom type='plane' size='9 9 1' friction='{FRICTION} 0 0'/>"
        + "".join(box.as_mjcf() for box in variant.boxes) + "</worldbody></mujoco>")
    data = mujoco.MjData(model)
    for i, box in enumerate(variant.boxes):
        data.qvel[6 * i:6 * i + 6] = [*box.velocity, *box.spin]
    steps = round(variant.duration * 1000 / step_ms)
    start = time.perf_counter()
    for _ in range(steps):
        mujoco.mj_step(model, data)
    return list(data.qpos[-7:-4]), (time.perf_counter() - start) / steps


def row_of(experiment, engine, variants, simulate):
    references = [simulate(variant, REFERENCE_MS)[0] for variant in variants]
    row = {"experiment": experiment, "engine": engine, "error_mm": {}, "us_per_step": {}}
    for step in STEPS_MS:
        runs = [simulate(variant, step) for variant in variants]
        errors = [1000 * math.dist(end, reference) for (end, _), reference in zip(runs, references, strict=True)]
        row["error_mm"][step] = statistics.median(errors)
        row["us_per_step"][step] = 1e6 * statistics.median(seconds for _, seconds in runs)
    return row


def find_mujoco():
    try:
        import mujoco  # pylint: disable=import-outside-toplevel
        return mujoco
    except ImportError:
        print("no MuJoCo in this Python: only our own runs")
        return None


def line(*cells):
    return "| " + " | ".join(cells) + " |"


def show(row):
    for what, digits in [("error_mm", 3), ("us_per_step", 2)]:
        name = "mm" if what == "error_mm" else "us per step"
        print(line(row["experiment"], row["engine"], name, *[f"{value:.{digits}g}" for value in row[what].values()]), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("experiments", nargs="*", metavar="EXPERIMENT", help=", ".join(EXPERIMENTS) + "; all if not given")
    parser.add_argument("--program", default="murosimf")
    parser.add_argument("--out", help="write JSON to this file")
    arguments = parser.parse_args()
    for name in arguments.experiments:
        if name not in EXPERIMENTS:
            parser.error(f"no experiment '{name}'; there are {', '.join(EXPERIMENTS)}")
    if not shutil.which(arguments.program):
        parser.error(f"'{arguments.program}' is no program")
    mujoco = find_mujoco()
    rows = []
    print(line("experiment", "engine", "", *[f"{step:g} ms" for step in STEPS_MS]))
    print("|---" * (3 + len(STEPS_MS)) + "|")
    with tempfile.TemporaryDirectory() as folder:
        for name in arguments.experiments or EXPERIMENTS:
            variants = list(EXPERIMENTS[name](Path(folder)))
            rows.append(row_of(name, "MuRoSimF", variants, lambda variant, step: run(arguments.program, variant, step)))
            show(rows[-1])
            if mujoco and variants[0].boxes:
                rows.append(row_of(name, f"MuJoCo {mujoco.__version__}", variants,
                                   lambda variant, step: run_mujoco(mujoco, variant, step)))
                show(rows[-1])
    if arguments.out:
        Path(arguments.out).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
