#!/usr/bin/env python3
"""What a humanoid robot can do, and how surely: perturbed runs of walking, getting up, kicking, diving and of pushes.

    benchmarks/skills.py --program build/release/murosimf
    benchmarks/skills.py --program build/release/murosimf --only get_up kick --levels articulated_dynamics --out skills.json
    benchmarks/skills.py --program build/release/murosimf --controller motions --model spark_nao0
    benchmarks/skills.py --program build/release/murosimf --controller motions --model K1_22dof.xml --only kick --ball 0.28 0.106

Every experiment has --runs runs at each level; run k has its own seed, lean (up to 2 degrees), heading, friction (0.5 to
1.0), and factors of all masses and gains of servos (0.9 to 1.1). Sensors have their noise.

    walk     20 s at 0.1, 0.2, 0.35, 0.45 m/s, 0.15 m/s to the left, 1 rad/s: runs without a fall; their mean speed, of the
             command
    get_up   from front, back, left, right: runs that end standing
    kick     every motion `*kick_*`, with a ball where its foot is (--ball, --side-ball): standing after a ball of more than
             1.5 m/s; mean speed of the ball
    dive     to both sides: torso down within 0.8 s; with `motions` also up again 15 s later
    protect  from a lean of 35 degrees to front, back, left and right: the head's largest deceleration (4 ms) is less than half
             of that of a robot that keeps its stance (not with `motions`); mean deceleration
    push     0.1 s at the torso's center of mass, standing and at 0.15 m/s: the largest impulse, of a ladder of --step
             (0.25 N s), that is survived in all of 8 phases; unperturbed, at the last of --levels only, or at each with
             --all-pushes

Which motions there are, the robot's TOML file says in [motions]; what it does not name is left out. --controller: `walk`
walks only, `keyframes` plays motions only, `motions` does both with the motion engine; without it walk and keyframes, each
what it can.
"""
import argparse
import concurrent.futures
import csv
import json
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

LEVELS = ["simplified_dynamics", "full_dynamics", "articulated_dynamics"]
WALKS = {"0.1 m/s": (0.1, 0, 0), "0.2 m/s": (0.2, 0, 0), "0.35 m/s": (0.35, 0, 0), "0.45 m/s": (0.45, 0, 0),
         "left 0.15 m/s": (0, 0.15, 0), "turn 1 rad/s": (0, 0, 1)}
LYING = {"front": "pitch_deg=90", "back": "pitch_deg=-90", "left": "roll_deg=-90", "right": "roll_deg=90"}
PUSHES = {"forward": (1, 0), "backward": (-1, 0), "left": (0, 1), "right": (0, -1)}
UP = 0.85  # [1] of the height at which it stands: it stands
AIMS, BALL_TO_AIM_AT, BALL_WAY_M = (-60, -30, 0, 30, 60, 90), (0.2, 0.056), 0.5
BALL_SPEED, DOWN_S, STEP_NS, LARGEST_NS, PERIOD_S = 1.5, 0.8, 0.25, 5.0, 0.452
FALLS = {"front": "pitch_deg=35", "back": "pitch_deg=-35", "left": "roll_deg=-35", "right": "roll_deg=35"}
SCENE = """duration = 5.0
[field]
size = "kid_size_2008"
surface = "carpet"
goals = false
[[robots]]
name = "robot"
model = "{model}"
level = "{level}"
controller = "{controller}"
"""


class Robot:
    """A model, its masses and gains, and the motions that its file names."""

    def __init__(self, program, model):
        self.program, self.model = program, model
        report = json.loads(called([program, "check", model, "--json", "-"], codes=(0, 1)))
        rows = report["tree"]
        self.base = rows[0]["body"]
        self.masses = {row["body"]: row["mass_kg"] for row in rows if row.get("body") and row["mass_kg"] > 0}
        self.gains = {row["joint"]: row["position_gain"] for row in rows if row.get("position_gain", 0) > 0}
        self.torso = max(self.masses, key=self.masses.get)
        self.head = next((body for body in self.masses if "head" in body.lower()), self.torso)
        self.motions = motions_of(model)
        beside = Path(model).resolve().parent
        self.folders = [beside, beside / "motions", Path(__file__).resolve().parent.parent / "motions"]
        self.standing_m = None

    def perturbation(self, run, runs):
        """Overrides of run `run`, the same for every level and experiment."""
        chance = random.Random(run)
        friction = 0.5 + 0.5 * run / max(1, runs - 1)
        heavier, stiffer = (chance.uniform(0.9, 1.1) for _ in range(2))
        changes = [f"seed={run + 1}", f"field.friction={friction:.4g}", "start.jitter_tilt_deg=2", "start.jitter_heading_deg=5"]
        changes += [f"robot.{body}.mass={heavier * mass:.6g}" for body, mass in self.masses.items()]
        return changes + [f"robot.{joint}.servo.position_gain={stiffer * gain:.6g}" for joint, gain in self.gains.items()]


class Run:
    """One run: how it ended, and the base over time."""

    def __init__(self, robot, folder, scene, duration, changes=(), pushes=(), at=(), logs=(), rate=100):
        command = [robot.program, "run", str(scene), "--duration", f"{duration:g}", "--no-cameras", "--json", "-"]
        with tempfile.TemporaryDirectory(dir=folder) as own:
            table = Path(own) / "log.csv"
            command += ["--out", str(table), "--log-rate", f"{rate}"]
            for log in [f"robot.{robot.base}.position", f"robot.{robot.base}.orientation", *logs]:
                command += ["--log", log]
            for option, values in (("--set", changes), ("--push", pushes), ("--at", at)):
                command += [word for value in values for word in (option, value)]
            report = json.loads(called(command))
            with table.open(encoding="utf-8") as file:
                rows = list(csv.reader(file))
        self.names = {name.split(" ")[0]: i for i, name in enumerate(rows[0])}
        self.rows = [[float(cell) for cell in row] for row in rows[1:]]
        self.falls = next(one["falls"] for one in report["entities"] if one["name"] == "robot")
        self.base = f"robot.{robot.base}"

    def column(self, name):
        return [row[self.names[name]] for row in self.rows]

    def heights(self):
        return self.column(f"{self.base}.position.z")

    def turned(self):
        """[rad] about the vertical, all turns counted."""
        angles = [math.atan2(y, x) for x, y in zip(self.column(f"{self.base}.orientation.xx"),
                                                   self.column(f"{self.base}.orientation.yx"), strict=True)]
        return sum(math.remainder(b - a, math.tau) for a, b in zip(angles, angles[1:], strict=False))

    def moved(self, command):
        """[m] along the commanded direction in the robot's own frame: swaying and drifting aside add nothing."""
        x, y = (self.column(f"{self.base}.position.{axis}") for axis in "xy")
        fronts = zip(self.column(f"{self.base}.orientation.xx"), self.column(f"{self.base}.orientation.yx"), strict=True)
        direction = math.atan2(command[1], command[0])
        ways = [math.atan2(front_y, front_x) + direction for front_x, front_y in fronts]
        return sum((x[i + 1] - x[i]) * math.cos(way) + (y[i + 1] - y[i]) * math.sin(way) for i, way in enumerate(ways[:-1]))

    def stands(self, robot):
        return self.heights()[-1] > UP * robot.standing_m and self.column(f"{self.base}.orientation.zz")[-1] > 0.9


def called(command, codes=(0,)):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in codes:
        sys.exit(f"skills: '{' '.join(command)}' ended with {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def motions_of(model):
    """Name to file, in the order of names, of [motions] in the TOML file beside a robot."""
    for place in (Path(model), Path(__file__).resolve().parent.parent / "models" / model):
        table = place.with_name(place.name if place.suffix == ".toml" else place.stem + ".toml")
        if table.is_file():
            return dict(sorted(tomllib.loads(table.read_text(encoding="utf-8")).get("motions", {}).items()))
    return {}


def motion_duration(motion, folders):
    """[s] `folders`: where motions stand, the first before the others."""
    name = motion if motion.endswith(".toml") else f"{motion}.toml"
    file = next((folder / name for folder in folders if (folder / name).is_file()), None)
    if file is None:
        sys.exit(f"skills: no motion '{motion}' in {', '.join(map(str, folders))}")
    table = tomllib.loads(file.read_text(encoding="utf-8"))
    if "mirror_of" in table:
        return motion_duration(table["mirror_of"], [file.parent, *folders])
    return sum(frame["duration"] for frame in table["frames"])


class Bench:
    def __init__(self, arguments, robot, folder, pool):
        self.arguments, self.robot, self.folder, self.pool = arguments, robot, folder, pool
        self.rows = []
        robot.standing_m = self.run("simplified_dynamics", self.walker(), 1, [], ["robot.command=[0, 0, 0]"]).heights()[-1]

    def walker(self):
        return self.arguments.controller if self.arguments.controller != "keyframes" else "walk"

    def engine(self):
        return self.arguments.controller == "motions"

    def duration(self, motion):
        return motion_duration(motion, self.robot.folders)

    def run(self, level, controller, duration, perturbed, changes=(), **more):
        scene = Path(self.folder) / f"{level}.{controller}.toml"
        if not scene.is_file():
            scene.write_text(SCENE.format(model=self.robot.model, level=level, controller=controller), encoding="utf-8")
        return Run(self.robot, self.folder, scene, duration, [*perturbed, *changes], **more)

    def play(self, name, level, perturbed, afterwards, changes=(), logs=()):
        """A motion from the beginning by `keyframes`, or asked of the engine after a second: the run, and when it starts [s]."""
        motion = self.robot.motions[name]
        if not self.engine():
            return self.run(level, "keyframes", self.duration(motion) + afterwards, perturbed,
                            [f"robot.motion={motion}", *changes], logs=logs), 0.0
        asked = [f"1:robot.play={name}"]
        return self.run(level, "motions", self.duration(motion) + afterwards + 3, perturbed, changes, at=asked, logs=logs), 1.0

    def table(self, experiment, case, one, figure=None):
        """A row for each level: `one(level, perturbation)` says whether a run is good, and a number or None."""
        runs = self.arguments.runs
        for level in self.arguments.levels:
            tasks = [self.pool.submit(one, level, self.robot.perturbation(k, runs)) for k in range(runs)]
            done = [task.result() for task in tasks]
            numbers = [number for _, number in done if number is not None]
            mean = sum(numbers) / len(numbers) if numbers else None
            row = {"experiment": experiment, "case": case, "level": level, "good": sum(good for good, _ in done), "runs": runs}
            self.rows.append(row | ({"figure": figure, "mean": mean} if figure else {}))
            told = f"{mean:.2f} {figure}" if figure and mean is not None else ""
            print(f"| {experiment} | {case} | {level} | {row['good']} of {runs} | {told} |", flush=True)

    def walk(self):
        for case, command in WALKS.items():
            def one(level, perturbed, command=command):
                run = self.run(level, self.walker(), self.arguments.walk_s, perturbed, [f"robot.command={list(command)}"])
                speed = run.turned() if command[2] else run.moved(command)
                wanted = math.hypot(*command) * self.arguments.walk_s
                return run.falls == 0, speed / wanted if run.falls == 0 else None
            self.table("walk", case, one, "of the command")

    def get_up(self):
        for side, lies in LYING.items():
            name = f"get_up_{side}"
            if name not in self.robot.motions:
                continue

            def one(level, perturbed, name=name, lies=lies):
                if self.engine():
                    run = self.run(level, "motions", 15, perturbed, [f"robot.{lies}", "robot.command=[0, 0, 0]"])
                else:
                    run, _ = self.play(name, level, perturbed, 1, [f"robot.{lies}"])
                return run.stands(self.robot), None
            self.table("get up", side, one)

    def kick(self):
        for name in [name for name in self.robot.motions if "kick_" in name]:
            side = -1 if name.endswith("right") else 1
            place = self.arguments.side_ball if name.startswith("side") else self.arguments.ball

            def one(level, perturbed, name=name, place=(place[0], side * place[1])):
                ball = [f"ball={{position=[{place[0]}, {place[1]}], mass=0.3, radius=0.065}}", "start.jitter_heading_deg=1"]
                run, _ = self.play(name, level, perturbed, 1, ball, ["ball.ball.linear_velocity"])
                fastest = max(map(math.hypot, *(run.column(f"ball.ball.linear_velocity.{axis}") for axis in "xy")))
                return fastest > BALL_SPEED and run.stands(self.robot), fastest
            self.table("kick", name, one, "m/s")

    def aim(self):
        x, y = BALL_TO_AIM_AT
        for degrees in AIMS:
            def one(level, perturbed, degrees=degrees):
                direction = math.radians(degrees)
                changes = [f"ball={{position=[{x}, {y}], mass=0.3, radius=0.065}}", "start.jitter_heading_deg=0"]
                run = self.run(level, "motions", 14, perturbed, changes, at=[f"1:robot.kick=[{direction:.6g}, 0, {x}, {y}]"],
                               logs=["ball.ball.position"])
                way = [run.column(f"ball.ball.position.{axis}")[-1] - start for axis, start in zip("xy", (x, y), strict=True)]
                off = math.degrees(abs(math.remainder(math.atan2(way[1], way[0]) - direction, math.tau)))
                kicked = math.hypot(*way) > BALL_WAY_M
                return kicked and run.stands(self.robot), off if kicked else None
            self.table("aim", f"{degrees} deg", one, "deg off")

    def dive(self):
        for name in [name for name in self.robot.motions if name.startswith("dive_")]:
            torso = f"robot.{self.robot.torso}.position"

            def one(level, perturbed, name=name, torso=torso):
                run, start = self.play(name, level, perturbed, 15 if self.engine() else 1, logs=[torso])
                heights = run.column(f"{torso}.z")
                times = [k / 100 for k in range(len(heights)) if heights[k] < 0.4 * heights[0]]
                down = times[0] - start if times else None
                good = down is not None and down <= DOWN_S + 1e-9 and (not self.engine() or run.stands(self.robot))
                return good, down
            self.table("dive", name, one, "s until the torso is down")

    def protect(self):
        for side, leans in FALLS.items():
            if f"protect_{side}" not in self.robot.motions:
                continue

            def peak(level, perturbed, controller, changes, leans=leans):
                """[g] of the head, over 4 ms."""
                head = f"robot.{self.robot.head}.linear_velocity"
                run = self.run(level, controller, 1.5, perturbed, [f"robot.{leans}", *changes], logs=[head], rate=1000)
                v = list(zip(*(run.column(f"{head}.{axis}") for axis in "xyz"), strict=True))
                return max(math.dist(a, b) for a, b in zip(v[10:], v[14:], strict=False)) / 0.004 / 9.81

            def one(level, perturbed, side=side, peak=peak):
                stiff = peak(level, perturbed, "walk", ["robot.command=[0, 0, 0]"])
                soft = peak(level, perturbed, "keyframes", [f"robot.motion={self.robot.motions[f'protect_{side}']}"])
                return soft < 0.5 * stiff, soft
            self.table("protect", side, one, "g at the head")

    def push(self):
        for level in self.arguments.levels if self.arguments.all_pushes else self.arguments.levels[-1:]:
            for speed in (0.0, 0.15):
                found = {way: self.pool.submit(self.largest, level, speed, to) for way, to in PUSHES.items()}
                for way, task in found.items():
                    case = f"{way}, {'standing' if speed == 0 else f'{speed} m/s'}"
                    self.rows.append({"experiment": "push", "case": case, "level": level, "largest_Ns": task.result()})
                    print(f"| push | {case} | {level} | {task.result():.2f} N s | |", flush=True)

    def largest(self, level, speed, to):
        """[N s] survived in all phases."""
        rung = self.arguments.step
        for step in range(1, round(self.arguments.largest / rung) + 1):
            force = [10 * rung * step * axis for axis in to]
            for phase in range(self.arguments.phases):
                begin = 2.5 + PERIOD_S * phase / self.arguments.phases
                push = f"robot.{self.robot.torso}=[{force[0]:g},{force[1]:g},0]@{begin:.3f}..{begin + 0.1:.3f}"
                run = self.run(level, self.walker(), 6, [], [f"robot.command=[{speed}, 0, 0]"], pushes=[push])
                if run.falls > 0:
                    return rung * (step - 1)
        return self.arguments.largest


PLAYED = ["get_up", "kick", "dive", "protect"]
EXPERIMENTS = ["walk", *PLAYED, "aim", "push"]
OF_CONTROLLER = {"": [name for name in EXPERIMENTS if name != "aim"], "walk": ["walk", "push"], "keyframes": PLAYED,
                 "motions": [name for name in EXPERIMENTS if name != "protect"]}


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="murosimf")
    parser.add_argument("--model", default="kid21", help="a name in models/, or a robot file")
    parser.add_argument("--controller", default="", choices=["walk", "motions", "keyframes"])
    parser.add_argument("--only", nargs="+", choices=EXPERIMENTS, help="these experiments")
    parser.add_argument("--levels", nargs="+", choices=LEVELS, default=LEVELS)
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--ball", nargs=2, type=float, default=(0.2, 0.056), metavar=("X", "Y"),
                        help="m, of kick_SIDE: before the robot and to that side")
    parser.add_argument("--side-ball", nargs=2, type=float, default=(0.02, 0.23), metavar=("X", "Y"), help="m, of side_kick_SIDE")
    parser.add_argument("--walk-s", type=float, default=20.0, help="seconds of each walk")
    parser.add_argument("--phases", type=int, default=8, help="instants of a step at which a push begins")
    parser.add_argument("--largest", type=float, default=LARGEST_NS, help="N s: the end of the ladder of pushes")
    parser.add_argument("--step", type=float, default=STEP_NS, help="N s: of that ladder")
    parser.add_argument("--all-pushes", action="store_true", help="push at each level")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--out", help="write the rows to this file, as JSON")
    arguments = parser.parse_args()
    if min(arguments.runs, arguments.phases, arguments.jobs, arguments.walk_s, arguments.largest, arguments.step) <= 0:
        parser.error("--runs, --phases, --jobs, --walk-s, --largest and --step must be above 0")
    if not shutil.which(arguments.program):
        parser.error(f"'{arguments.program}' is no program")
    possible = OF_CONTROLLER[arguments.controller]
    arguments.only = arguments.only or possible
    if wrong := set(arguments.only) - set(possible):
        parser.error(f"controller '{arguments.controller}' does not {wrong.pop()}")
    arguments.controller = arguments.controller or "walk"
    return arguments


def main():
    arguments = arguments_of()
    robot = Robot(arguments.program, arguments.model)
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        bench = Bench(arguments, robot, folder, pool)
        print("| experiment | case | level | good | mean |")
        print("|---|---|---|---|---|")
        for name in EXPERIMENTS:
            if name in arguments.only:
                getattr(bench, name)()
    if arguments.out:
        what = {"model": arguments.model, "controller": arguments.controller, "rows": bench.rows}
        Path(arguments.out).write_text(json.dumps(what, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
