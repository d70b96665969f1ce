#!/usr/bin/env python3
"""How well a humanoid robot walks with the motion engine: on which grounds, how its feet slide, what it asks of its servos,
and whether it goes on after a fall.

    benchmarks/walking.py --program build/release/murosimf
    benchmarks/walking.py --program build/release/murosimf --only effort chain --levels articulated_dynamics --out walking.json
    benchmarks/walking.py --program build/release/murosimf --model spark_nao0 --speed 0.15

Runs are perturbed as those of skills.py are: run k has its own seed, lean, heading, friction (0.5 to 1.0), masses and gains.

    ground   20 s at --speed on carpet, on artificial grass whose pile leans, on a mat (it gives way by 2 mm under the robot's
             weight), 3 degrees up and down, and over plates of 5 mm (0.2 m long, 0.2 m apart), each reached from 0.5 m of level
             ground. Runs without a fall; their mean speed, of the command; slip: how far a sole's center gets, in the
             horizontal, from where it was when the other foot lost the ground, until that comes back: mean of all steps, and
             what 95 % of them stay below
    effort   at the last of --levels: standing, walking and every motion of the robot's file, each from 1 s before it begins.
             Share of its time in which the busiest servo gives all that it has; mechanical power that servos put into their
             joints (no credit for braking); largest change of a target between two control cycles, of what the servo turns in
             one without load. The worst of all runs
    chain    pushes of 0.1 s at the torso (--hard m/s times the mass) that no step answers, while it walks, to 4 sides at 3
             instants of a step: it falls, protects itself, gets up, and walks on: at least half as fast as it should in the last
             5 of 25 s
"""
import argparse
import concurrent.futures
import json
import math
import os
import shutil
import sys
import tempfile
from pathlib import Path

import skills

WALKS = {"walk forward": (1, 0, 0), "walk to the left": (0, 0.75, 0), "turn": (0, 0, 5), "stand": (0, 0, 0)}  # of --speed
RATE_HZ, CYCLE_S = 200, 0.01
BEGIN_M, LENGTH_M, WIDTH_M, THICK_M = 0.5, 8.0, 8.0, 0.1
SLOPE_DEG, PLATE_M, PLATE_HIGH_M, MAT_M = 3.0, 0.2, 0.005, 0.002
PERIOD_S = 0.47  # of a double step of kid21: only to spread pushes over a step
MODE = {"walk": 0, "protect": 2, "lie": 3, "get up": 4}  # murosimf/locomotion/motion_state.h
SCENE = """duration = 20.0
bodies = [{bodies}]
[field]
size = "kid_size_2023"
surface = "{surface}"
{pile}
goals = false
[[robots]]
name = "robot"
model = "{model}"
level = "{level}"
controller = "motions"
position = [0, 0, {height}]
[[materials]]
pair = ["rubber", "{surface}"]
friction = 0.8
{material}
[[materials]]
pair = ["plastic", "{surface}"]
friction = 0.5
"""


def box(name, size, x, z, pitch_deg=0.0):
    return (f'{{name = "{name}", shape = "box", size = {list(size)}, position = [{x:.6g}, 0, {z:.6g}], '
            f'pitch_deg = {pitch_deg:g}, static = true, material = "carpet"}}')


def slope(up):
    """Bodies of a slope whose upper face begins at BEGIN_M, and the height at which the robot starts."""
    a = math.radians(SLOPE_DEG)
    high = 0.0 if up else LENGTH_M * math.sin(a)
    towards = 1 if up else -1
    x = BEGIN_M + LENGTH_M / 2 * math.cos(a) + towards * THICK_M / 2 * math.sin(a)
    bodies = [box("slope", (LENGTH_M, WIDTH_M, THICK_M), x, -THICK_M * math.cos(a), -towards * SLOPE_DEG)]
    if not up:
        bodies.append(box("platform", (2.0, WIDTH_M, high), BEGIN_M - 1.0, 0))
    return bodies, high


def plates():
    return [box(f"plate{k}", (PLATE_M, WIDTH_M, PLATE_HIGH_M), BEGIN_M + (2 * k + 0.5) * PLATE_M, 0) for k in range(16)]


def grounds():
    """Name to surface, extra numbers of its material, bodies, height of the start [m]."""
    return {"carpet": ("carpet", "", [], 0), "grass": ("grass", "friction_anisotropy = 0.15\nstatic_deflection = 0.0002", [], 0),
            "mat": ("carpet", f"static_deflection = {MAT_M}", [], 0),
            "3 degrees up": ("carpet", "", *slope(True)), "3 degrees down": ("carpet", "", *slope(False)),
            "plates of 5 mm": ("carpet", "", plates(), 0)}


def slips(run, feet, soles, weight):
    """[m] of every single support, from 2 s on."""
    first = 2 * RATE_HZ
    force = [run.column(f"robot.{foot}.external_force.fz") for foot in feet]
    places = [list(zip(run.column(f"robot.{sole}.position.x"), run.column(f"robot.{sole}.position.y"), strict=True))
              for sole in soles]
    found = []
    for side in range(2):
        begin = None
        for k in range(first, len(run.rows)):
            alone = force[side][k] > 0.2 * weight and force[1 - side][k] < 0.02 * weight
            if alone and begin is None:
                begin = k
            elif not alone and begin is not None:
                if k - begin >= 0.05 * RATE_HZ:
                    found.append(max(math.dist(places[side][begin], place) for place in places[side][begin:k]))
                begin = None
    return found


def share_below(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))] if values else None


class Bench:
    def __init__(self, arguments, robot, folder, pool):
        self.arguments, self.robot, self.folder, self.pool = arguments, robot, folder, pool
        self.rows = []
        report = json.loads(skills.called([robot.program, "check", robot.model, "--json", "-"], codes=(0, 1)))
        self.soles = report["soles"][:2]
        self.mass, self.weight = report["total_mass_kg"], 9.81 * report["total_mass_kg"]
        self.rates = {row["joint"]: row["no_load_speed"] for row in report["tree"] if row.get("no_load_speed", 0) > 0}
        self.feet = self.find_feet()

    def run(self, level, ground, duration, perturbed, changes=(), **more):
        surface, material, bodies, height = grounds()[ground]
        scene = Path(self.folder) / f"{level}.{ground.replace(' ', '_')}.toml"
        if not scene.is_file():
            scene.write_text(SCENE.format(model=self.robot.model, level=level, surface=surface, material=material,
                                          pile="friction_direction = [0.8, 0.6]" if surface == "grass" else "",
                                          bodies=", ".join(bodies), height=height), encoding="utf-8")
        friction = [f"materials.rubber.{surface}.friction={change.partition('=')[2]}" for change in perturbed
                    if change.startswith("field.friction=")]
        others = [change for change in perturbed if not change.startswith("field.friction=")]
        return skills.Run(self.robot, self.folder, scene, duration, [*others, *friction, *changes], rate=RATE_HZ, **more)

    def find_feet(self):
        """The two bodies that carry it while it stands, in the order of the soles."""
        run = self.run("full_dynamics", "carpet", 1, [], ["robot.command=[0, 0, 0]"], logs=[
            *(f"robot.{body}.{what}" for body in self.robot.masses for what in ("external_force", "position")),
            *(f"robot.{sole}.position" for sole in self.soles)])
        last = {name: run.rows[-1][at] for name, at in run.names.items()}
        carried = sorted(self.robot.masses, key=lambda body: last[f"robot.{body}.external_force.fz"])[-2:]
        return [min(carried, key=lambda body: abs(last[f"robot.{body}.position.y"] - last[f"robot.{sole}.position.y"]))
                for sole in self.soles]

    def told(self, row, *cells):
        self.rows.append(row)
        print(f"| {' | '.join(str(cell) for cell in cells)} |", flush=True)

    def perturbed(self):
        return [self.robot.perturbation(k, self.arguments.runs) for k in range(self.arguments.runs)]

    def ground(self):
        print("| ground | level | no fall | of the command | slip, mean | 95 % below |\n|---|---|---|---|---|---|")
        logs = [f"robot.{foot}.external_force" for foot in self.feet] + [f"robot.{sole}.position" for sole in self.soles]
        speed, seconds = self.arguments.speed, self.arguments.walk_s

        def one(level, name, perturbed):
            run = self.run(level, name, seconds, perturbed, [f"robot.command=[{speed}, 0, 0]"], logs=logs)
            return run.falls, run.moved((speed, 0)) / (speed * seconds), slips(run, self.feet, self.soles, self.weight)

        for name in self.arguments.grounds:
            for level in self.arguments.levels:
                done = [task.result() for task in [self.pool.submit(one, level, name, p) for p in self.perturbed()]]
                up = [one for one in done if one[0] == 0]
                of_command = sum(ratio for _, ratio, _ in up) / len(up) if up else 0.0
                slip = [1000 * value for _, _, values in up for value in values]
                mean = sum(slip) / len(slip) if slip else math.nan
                most = share_below(slip, 0.95) if slip else math.nan
                self.told({"experiment": "ground", "ground": name, "level": level, "speed": speed, "good": len(up),
                           "runs": len(done), "of_command": of_command, "slip_mm": mean, "slip_95_mm": most},
                          name, level, f"{len(up)} of {len(done)}", f"{of_command:.2f}", f"{mean:.1f} mm", f"{most:.1f} mm")

    def skills_of(self):
        """Name, changes, events, when it begins and how long it takes [s]."""
        speed = self.arguments.speed
        found = [(name, [f"robot.command={[speed * axis for axis in way]}"], [], 1.0, 10.0) for name, way in WALKS.items()]
        still = ["robot.command=[0, 0, 0]"]
        for name, motion in self.robot.motions.items():
            lasts = skills.motion_duration(motion, self.robot.folders) + 1.0
            if name.startswith("get_up_"):
                lies = skills.LYING.get(name.removeprefix("get_up_"))
                if lies:
                    found.append((name, [*still, f"robot.{lies}"], [], 0.0, lasts + 1.0))
            else:
                found.append((name, still, [f"1:robot.play={name}"], 1.0, lasts))
        return found

    def effort(self):
        level = self.arguments.levels[-1]
        print("| skill | servos at their end | power | change of a target |\n|---|---|---|---|")
        logs = [f"robot.{name}" for name in ("joint_torque", "joint_velocity", "joint_target")]
        logs += [f"robot.{joint}.saturated_time" for joint in self.rates]

        def one(changes, events, begin, lasts, perturbed):
            return self.effort_of(self.run(level, "carpet", begin + lasts, perturbed, changes, at=events, logs=logs), begin)

        for name, *how in self.skills_of():
            done = [task.result() for task in [self.pool.submit(one, *how, p) for p in self.perturbed()]]
            at_end, watts, change, joint = *(max(one[k] for one in done) for k in range(3)), max(done)[3]
            self.told({"experiment": "effort", "skill": name, "level": level, "at_end": at_end, "joint": joint, "power_W": watts,
                       "target_change": change}, name, f"{joint} {100 * at_end:.0f} %", f"{watts:.1f} W", f"{100 * change:.0f} %")

    def effort_of(self, run, begin):
        first, seconds = round(begin * RATE_HZ), (len(run.rows) - 1) / RATE_HZ - begin
        work, change, at_end, busiest = 0.0, 0.0, 0.0, ""
        for joint, rate in self.rates.items():
            torque, velocity, target, saturated = (run.column(f"robot.{joint}.{name}")[first:] for name in (
                "joint_torque", "joint_velocity", "joint_target", "saturated_time"))
            work += sum(max(0.0, t * v) for t, v in zip(torque, velocity, strict=True)) / RATE_HZ
            cycle = round(CYCLE_S * RATE_HZ)
            moved = max(abs(b - a) for a, b in zip(target, target[cycle:], strict=False))
            change = max(change, moved / (rate * CYCLE_S))
            share = (saturated[-1] - saturated[0]) / seconds
            if share >= at_end:
                at_end, busiest = share, joint
        return at_end, work / seconds, change, busiest

    def chain(self):
        print("| push | level | falls | protects itself | gets up | walks on |\n|---|---|---|---|---|---|")
        for level in self.arguments.levels:
            for way, to in skills.PUSHES.items():
                found = [self.pool.submit(self.chain_of, level, to, phase) for phase in range(3)]
                counts = [sum(part) for part in zip(*(task.result() for task in found), strict=True)]
                self.told({"experiment": "chain", "push": way, "level": level, "runs": 3, "falls": counts[0],
                           "protects": counts[1], "gets_up": counts[2], "walks_on": counts[3]},
                          way, level, *(f"{count} of 3" for count in counts))

    def chain_of(self, level, to, phase):
        begin, lasts = 3 + PERIOD_S * phase / 3, 25
        force = [10 * self.arguments.hard * self.mass * axis for axis in to]
        push = f"robot.{self.robot.torso}=[{force[0]:g},{force[1]:g},0]@{begin:.3f}..{begin + 0.1:.3f}"
        run = self.run(level, "carpet", lasts, [], [f"robot.command=[{self.arguments.speed}, 0, 0]"], pushes=[push],
                       logs=[f"robot.{self.robot.base}.motion_state"])
        modes = run.column(f"{run.base}.motion_state.0")
        end = list(zip(run.column(f"{run.base}.position.x"), run.column(f"{run.base}.position.y"), strict=True))[-5 * RATE_HZ:]
        way = sum(math.dist(end[k], end[k + RATE_HZ // 2]) for k in range(0, len(end) - RATE_HZ // 2, RATE_HZ // 2))
        walks = MODE["walk"] == modes[-1] and all(mode == MODE["walk"] for mode in modes[-5 * RATE_HZ:])
        return (run.falls > 0, MODE["protect"] in modes, MODE["get up"] in modes,
                run.falls > 0 and walks and way > 0.5 * 5 * self.arguments.speed)


EXPERIMENTS = ["ground", "effort", "chain"]


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="murosimf")
    parser.add_argument("--model", default="kid21", help="a name in models/, or a robot file")
    parser.add_argument("--only", nargs="+", choices=EXPERIMENTS, default=EXPERIMENTS, help="these experiments")
    parser.add_argument("--grounds", nargs="+", choices=list(grounds()), default=list(grounds()), help="these grounds")
    parser.add_argument("--levels", nargs="+", choices=skills.LEVELS, default=skills.LEVELS)
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--speed", type=float, default=0.2, help="m/s")
    parser.add_argument("--walk-s", type=float, default=20.0, help="seconds of each walk on a ground")
    parser.add_argument("--hard", type=float, default=2.0, help="m/s: impulse of a push after which it falls, by the mass")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--out", help="write the rows to this file, as JSON")
    arguments = parser.parse_args()
    if min(arguments.runs, arguments.jobs, arguments.speed, arguments.hard) <= 0 or arguments.walk_s <= 2:
        parser.error("--runs, --jobs, --speed and --hard must be above 0, and --walk-s above 2")
    if not shutil.which(arguments.program):
        parser.error(f"'{arguments.program}' is no program")
    return arguments


def main():
    arguments = arguments_of()
    robot = skills.Robot(arguments.program, arguments.model)
    if not robot.masses:
        sys.exit(f"walking: '{arguments.model}' has no masses")
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        bench = Bench(arguments, robot, folder, pool)
        for name in EXPERIMENTS:
            if name in arguments.only:
                getattr(bench, name)()
                print()
    if arguments.out:
        what = {"model": arguments.model, "rows": bench.rows}
        Path(arguments.out).write_text(json.dumps(what, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
