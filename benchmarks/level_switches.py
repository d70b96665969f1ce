#!/usr/bin/env python3
"""What a change of level in the middle of a push, a kick, a get-up and a crowd does: additional falls, and the jump of the base.

    benchmarks/level_switches.py --program build/release/murosimf
    benchmarks/level_switches.py --program build/release/murosimf --share 0.1 --out level_switches.json push

    push    `murosimf run push`, a ball of 0.8 kg that comes with four speeds: every pair of levels, 14 instants
    kick    `murosimf run kick`: every pair of levels, 56 instants
    get_up  `murosimf run get_up`: every pair of levels with forces, 56 instants; a fall is that it lies in the end
    crowd   `murosimf run three_on_three`, three seeds: each of six robots to each other level, 13 instants

Every run is recorded once as it is; `murosimf branch` goes on from each instant with the change and without. Compared is with
the branch without a change, after 2.5 s (get_up: at 7 s): falls that are more (additional) or fewer. Refused are changes to
kinematic_walking of robots that do not stand. Some falls are those of the new level, which may not withstand what the old
one did: `alone` counts the additional falls of robots that do not fall in a run that has the new level from its beginning,
either. In a crowd any other change makes others meet, too: `by chance` has additional and fewer falls where as often the ball
gets heavier by 0.1 to 1.8 % instead. The jump is how far the base is from where it would have been without the change, a step
of 1 ms after it.
"""
import argparse
import concurrent.futures
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LEVELS = ["kinematic_walking", "simplified_dynamics", "full_dynamics", "articulated_dynamics"]
STEP_S, AFTERWARDS_S = 0.001, 2.5
GET_UP_ENDS_S, LIES_BELOW_M = 7.0, 0.25  # kid21's torso is 0.32 m high where it stands


class Course:
    """One recorded run, and what is changed in it at each of its instants."""

    def __init__(self, experiment, scene, settings, robots, instants, level=None, *, levels=LEVELS, gets_up=False):
        self.experiment, self.scene, self.settings, self.robots, self.instants, self.level = (
            experiment, scene, settings, robots, instants, level)
        self.levels, self.gets_up = levels, gets_up
        self.duration = GET_UP_ENDS_S if gets_up else instants[-1] + AFTERWARDS_S
        self.crowded = len(robots) > 1

    def afterwards(self, instant):
        """[s] from a switch to the judgement."""
        return self.duration - instant if self.gets_up else AFTERWARDS_S


def spread(first, last, count):
    return [round(first + (last - first) * i / (count - 1), 3) for i in range(count)]


def thinned(instants, share):
    count = max(2, round(share * len(instants)))
    return [instants[round(i * (len(instants) - 1) / (count - 1))] for i in range(count)]


def pushes(share):
    for speed in (1.5, 2.0, 2.5, 3.0):
        for level in LEVELS:
            yield Course("push", "push", [f"ball.velocity=[{speed}, 0.0, 0.8]", f"robot.level={level}"], ["robot"],
                         thinned(spread(0.05, 1.35, 14), share), level)


def kicks(share):
    for level in LEVELS:
        yield Course("kick", "kick", [f"robot.level={level}"], ["robot"], thinned(spread(0.05, 2.8, 56), share), level)


def get_ups(share):
    levels = LEVELS[1:]  # kinematic_walking never lies
    for level in levels:
        yield Course("get_up", "get_up", [f"robot.level={level}"], ["robot"], thinned(spread(0.05, 4.45, 56), share), level,
                     levels=levels, gets_up=True)


def crowds(share):
    robots = [f"{team}{number}" for team in ("blue", "red") for number in (1, 2, 3)]
    for seed in (2, 3, 4):
        yield Course("crowd", "three_on_three", [f"seed={seed}"], robots, thinned(spread(1.0, 25.0, 13), share))


EXPERIMENTS = {"push": pushes, "kick": kicks, "get_up": get_ups, "crowd": crowds}


class Refusal(Exception):
    """A level that a robot cannot have at this moment."""

    def __init__(self, change):
        super().__init__(change)
        self.change = change


def called(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    refusal = re.search(r"--set '([^']*\.level=[^']*)'.* stays at ", done.stderr)
    if done.returncode == 2 and refusal:
        raise Refusal(refusal[1])
    if done.returncode != 0:
        sys.exit(f"level_switches: '{' '.join(command)}' ended with {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def settings_of(course, extra=()):
    return [word for setting in [*course.settings, *extra] for word in ("--set", setting)]


def record(program, course, file):
    called([program, "run", course.scene, "--no-cameras", "--duration", f"{course.duration}", *settings_of(course),
            "--record", file, "--record-what", "scene", "events", "states"])


def branches(program, file, instant, duration, changes, results):
    """By change, "" for none: the results by name."""
    command = [program, "branch", file, "--time", f"{instant}", "--duration", f"{duration:g}", "--json", "-"]
    command += [word for change in changes for word in ("--set", change)]
    command += [word for result in results for word in ("--result", result)]
    report = json.loads(called(command))
    names = [name.split(" ")[0] for name in report["results"]]  # without units
    return {branch["change"]: dict(zip(names, branch["results"], strict=True)) for branch in report["branches"]}


def possible(program, file, instant, changes, results):
    """The branches of one step, without those changes that are refused."""
    changes = list(changes)
    while True:
        try:
            return branches(program, file, instant, STEP_S, changes, results)
        except Refusal as refusal:
            changes.remove(refusal.change)


def falls_alone(program, course, level):
    """Falls of a run that has the level from its beginning."""
    report = json.loads(called([program, "run", course.scene, "--no-cameras", "--duration", f"{course.duration}", "--json", "-",
                                *settings_of(course, [f"robot.level={level}"])]))
    robot = next(entity for entity in report["entities"] if entity["name"] == "robot")
    return robot["position"][2] < LIES_BELOW_M if course.gets_up else robot["falls"]


def falls_of(course, branch, robot):
    return branch[f"{robot}.z"] < LIES_BELOW_M if course.gets_up else branch[f"{robot}.falls"]


def more_and_fewer(course, branch, without):
    differences = [falls_of(course, branch, robot) - falls_of(course, without, robot) for robot in course.robots]
    return sum(d > 0 for d in differences), sum(d < 0 for d in differences)


def jump_of(branch, without, robot):
    """[mm]"""
    return 1000 * math.dist(*[[one[f"{robot}.{axis}"] for axis in "xyz"] for one in (branch, without)])


def at_instant(program, course, file, instant, levels, alone):
    """Rows of all switches at this instant."""
    switches = {f"{robot}.level={level}": (robot, level)
                for robot in course.robots for level in course.levels if level != levels[robot]}
    falls = [f"{robot}.{what}" for robot in course.robots for what in ("z" if course.gets_up else "falls", "frozen")]
    nearby = possible(program, file, instant, switches, [f"{robot}.{axis}" for robot in course.robots for axis in "xyz"])
    later = branches(program, file, instant, course.afterwards(instant), [change for change in nearby if change], falls)
    heavier = [f"ball.mass={0.15 * (1 + 0.001 * (i + 1)):g}" for i in range(len(switches))] if course.crowded else []
    nudged = list(branches(program, file, instant, course.afterwards(instant), heavier, falls).values())[1:] if heavier else []
    rows = []
    for i, (change, (robot, level)) in enumerate(switches.items()):
        row = {"experiment": course.experiment, "settings": course.settings, "time": instant, "robot": robot,
               "from": levels[robot], "to": level, "refused": change not in nearby}
        if not row["refused"]:
            more, fewer = more_and_fewer(course, later[change], later[""])
            row |= {"additional": more, "fewer": fewer, "alone": more if level in alone and not alone[level] else 0,
                    "frozen": sum(later[change][f"{name}.frozen"] for name in course.robots),
                    "jump_mm": jump_of(nearby[change], nearby[""], robot)}
        if nudged:
            row["chance_additional"], row["chance_fewer"] = more_and_fewer(course, nudged[i], later[""])
        rows.append(row)
    return rows


def levels_of(course):
    if course.level:
        return {"robot": course.level}
    return {robot: "kinematic_walking" if robot.startswith("blue") else "simplified_dynamics" for robot in course.robots}


def rows_of(program, course, folder, pool):
    file = str(Path(folder) / "course.mcap")
    record(program, course, file)
    alone = {level: falls_alone(program, course, level) for level in course.levels} if course.level else {}
    tasks = [pool.submit(at_instant, program, course, file, instant, levels_of(course), alone) for instant in course.instants]
    return [row for task in tasks for row in task.result()]


def line(*cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def summary(name, rows):
    def total(key):
        return int(sum(row.get(key, 0) for row in rows))

    by_chance = f"{total('chance_additional')} and {total('chance_fewer')}" if name in ("crowd", "all") else "-"
    worst = max(rows, key=lambda row: row.get("jump_mm", 0))
    alone = "-" if name == "crowd" else total("alone")
    totals = [total("refused"), total("additional"), alone, total("fewer")]
    return line(name, len(rows), *totals, by_chance, total("frozen"), f"{worst.get('jump_mm', 0):.2g}",
                f"{worst['from']} to {worst['to']}, {worst['time']:g} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("experiments", nargs="*", metavar="EXPERIMENT", help=", ".join(EXPERIMENTS) + "; all if not given")
    parser.add_argument("--program", default="murosimf")
    parser.add_argument("--share", type=float, default=1.0, help="of the instants, above 0, at most 1")
    parser.add_argument("--out", help="write all switches to this file, as JSON")
    arguments = parser.parse_args()
    for name in arguments.experiments:
        if name not in EXPERIMENTS:
            parser.error(f"no experiment '{name}'; there are {', '.join(EXPERIMENTS)}")
    if not 0 < arguments.share <= 1:
        parser.error(f"--share must be above 0, at most 1, and not {arguments.share:g}")
    if not shutil.which(arguments.program):
        parser.error(f"'{arguments.program}' is no program")
    print(line("", "switches", "refused", "additional falls", "alone", "fewer falls", "by chance", "frozen",
               "largest jump [mm]", "of"))
    print("|---" * 10 + "|")
    everything = []
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for name in arguments.experiments or EXPERIMENTS:
            rows = []
            for course in EXPERIMENTS[name](arguments.share):
                rows += rows_of(arguments.program, course, folder, pool)
            print(summary(name, rows), flush=True)
            everything += rows
    if len(arguments.experiments) != 1:
        print(summary("all", everything))
    if arguments.out:
        Path(arguments.out).write_text(json.dumps(everything, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
