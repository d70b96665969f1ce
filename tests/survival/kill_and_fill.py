#!/usr/bin/env python3
"""Nothing that was there is lost: commands are killed (kill -9) at random instants, and run out of space at random sizes.

Every result of a command has an older file of its name first. After a kill each of them is as it was, or the whole new
one; what a run had recorded is found, repaired, and lacks a second of simulated time at most. Without space (a limit of file
sizes, and a small file system of its own where root may mount one) the program is not killed, says its report, and ends with
the exit code 2.

    tests/survival/kill_and_fill.py --program build/release/murosimf --kills 200 --fills 50 --seed 2
"""

import argparse
import hashlib
import json
import os
import pathlib
import pty
import random
import re
import resource
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time

LOST = 1.0  # [s] of simulated time that a killed run may lose
RECORDED = "game.mcap"
PARTS = (RECORDED + ".part", f"linked_{RECORDED}.part")  # where it grows: beside the older one, which a link may lead to


class Wrong(Exception):
    """What a command must not do."""


def words(folder, text):
    return [word.replace("@", str(folder) + "/") for word in text.split()]


# Commands and their results ("@" is the folder of the case). `in.mcap` and `in.csv` are there.
COMMANDS = [
    "run nudge --duration 30 --speed 4 --record @game.mcap",
    "run nudge --duration 60 --record @game.mcap --record-what poses,states,hashes --record-states 2",
    "run three_on_three --no-cameras --duration 20 --record @game.mcap --json @report.json --out @log.csv"
    " --log ball.ball.position",
    "run nudge --duration 3 --json @report.json --log robot.* --out @log.npy --save-state @end.state --save-at 1:@one.state",
    "run walk --duration 2 --picture @field.png --html @game.html --json @report.json",
    "rerun @in.mcap --record @game.mcap --json @report.json",
    "export @in.mcap --csv @table.csv",
    "export @in.mcap --bvh @motion.bvh --robot robot",
    "plot @in.csv --out @plot.png",
    "sweep walk --seeds 1..4 --duration 1 --threads 2 --csv @sweep.csv --summary @means.csv --json @report.json",
    "convert kid21 --out @robot.xml --force",
    "render nudge --time 1 --out @seen.png --size 320x240",
    "render nudge --time 0.2 --duration 1 --size 160x120 --video @seen.mp4",
    "branch @in.mcap --set robot.torso.mass=1.5 --csv @branches.csv --json @report.json",
]


def results_of(command):
    return re.findall(r"(?:--\w[\w-]* |:)@([\w.]+)", command)


def is_whole(file):
    """Whether nothing is missing of a new result, as far as its kind shows."""
    data = file.read_bytes()
    if file.suffix == ".json":
        json.loads(data)
        return True
    if file.suffix == ".png":
        return data.startswith(b"\x89PNG") and data.endswith(b"IEND\xaeB`\x82")
    if file.suffix in (".mcap", ".state"):
        return data.startswith(b"\x89MCAP0\r\n") and data.endswith(b"\x89MCAP0\r\n")
    if file.suffix == ".mp4":
        return b"moov" in data
    if file.suffix == ".npy":
        return data.startswith(b"\x93NUMPY")
    if file.suffix == ".html":
        return data.rstrip().endswith(b"</html>")
    return len(data) > 0 and data.endswith(b"\n")


def old_bytes(name):
    return f"this is an older {name}\n".encode() * 50


class Case:
    """A command in a folder of its own, with older files in the places of its results."""

    def __init__(self, arguments, command, choose, folder, olds=True):
        self.program, self.command, self.folder, self.choose = arguments.program, command, folder, choose
        self.olds = {}
        for name in ("in.mcap", "in.csv"):
            shutil.copy(arguments.inputs / name, folder / name)
            self.olds[name] = (folder / name).read_bytes()
        for name in results_of(command):
            if not olds or (name == RECORDED and choose.random() < 0.5):
                continue
            self.olds[name] = old_bytes(name)
            self.put(name)

    def put(self, name):
        """As a file, or as a link to one."""
        place = self.folder / name
        if self.choose.random() < 0.2 and name not in ("in.mcap", "in.csv"):
            place.symlink_to("linked_" + name)
            place = self.folder / ("linked_" + name)
        place.write_bytes(self.olds[name])

    def arguments(self):
        return [self.program, *words(self.folder, self.command)]

    def check_files(self):
        """How many are new."""
        new = 0
        for name in dict.fromkeys([*self.olds, *results_of(self.command)]):
            file = self.folder / name
            if name in self.olds:
                if not file.exists():
                    raise Wrong(f"{name} is gone")
                if file.read_bytes() == self.olds[name]:
                    continue
            if not file.exists() or name == RECORDED and name not in self.olds:
                continue
            try:
                whole = is_whole(file)
            except ValueError:
                whole = False
            if not whole:
                raise Wrong(f"{name} is neither the older one nor a whole new one ({file.stat().st_size} bytes)")
            new += 1
        return new

    def recorded(self):
        """What is there of a recording; None: nothing."""
        for name in (*PARTS, RECORDED):
            file = self.folder / name
            if file.exists() and file.read_bytes() != self.olds.get(name) and file.stat().st_size > 0:
                return file
        return None

    def recorded_until(self):
        """[s] Of what is left of the recording, after a repair."""
        file = self.recorded()
        if not file:
            return None
        repaired = subprocess.run([self.program, "repair", file, "--out", self.folder / "whole.mcap"], capture_output=True,
                                  text=True, timeout=120)
        if repaired.returncode != 0:
            if "nothing" in repaired.stderr or file.stat().st_size < 100_000:
                return 0.0
            raise Wrong(f"it cannot be repaired: {repaired.stderr.strip()}")
        return float(re.search(r"up to ([\d.]+) s", repaired.stdout)[1])


def shown_time(text):
    """[s] The simulated time that the last line of progress says."""
    times = re.findall(r"(\d+\.\d+) of \d+\.\d+ s", text)
    return float(times[-1]) if times else 0.0


def run_and_kill(case, after):
    """Kills it `after` seconds; the simulated time that it had shown, and whether it had ended before."""
    ours, its = pty.openpty()
    process = subprocess.Popen(case.arguments(), stdout=subprocess.DEVNULL, stderr=its, stdin=subprocess.DEVNULL)
    os.close(its)
    end, text = time.monotonic() + after, ""
    while time.monotonic() < end and process.poll() is None:
        if select.select([ours], [], [], max(0.0, min(0.02, end - time.monotonic())))[0]:
            try:
                text += os.read(ours, 65536).decode(errors="replace")
            except OSError:
                break
    ended = process.poll() is not None
    process.send_signal(signal.SIGKILL)
    process.wait()
    os.close(ours)
    return shown_time(text), ended


def kill_one(case, statistics):
    after = case.choose.choice([0.1, 0.5, 2, 5]) * case.choose.random()
    shown, ended = run_and_kill(case, after)
    new = case.check_files()
    statistics["ended before"] += ended
    statistics["new files"] += new
    if "--record " not in case.command or ended:
        return
    until = case.recorded_until() or 0.0
    statistics["recordings"] += until > 0
    statistics["most lost [s]"] = max(statistics["most lost [s]"], shown - until)
    if shown - until > LOST:
        raise Wrong(f"{shown} s were simulated, {until} s are recorded")


def limited(size):
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return limit


class SmallDisk:
    """A file system of so many bytes, for root; None if it cannot be mounted."""

    def __init__(self, folder, size):
        self.folder = folder
        made = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", folder], capture_output=True)
        self.there = made.returncode == 0

    def close(self):
        if self.there:
            subprocess.run(["umount", self.folder], check=False)


def fill_one(case, size, on_disk, statistics):
    result = subprocess.run(case.arguments(), capture_output=True, text=True, timeout=300, stdin=subprocess.DEVNULL,
                            preexec_fn=None if on_disk else limited(size))
    if result.returncode not in (0, 2):
        raise Wrong(f"exit code {result.returncode}: {result.stderr.strip()[-300:]}")
    new = case.check_files()
    statistics["new files"] += new
    statistics["exit code 2"] += result.returncode == 2
    missing = [name for name in results_of(case.command) if (case.folder / name).exists() is False or
               (case.folder / name).read_bytes() == case.olds.get(name)]
    if result.returncode == 0 and missing:
        raise Wrong(f"exit code 0 without {missing}")
    if result.returncode == 2 and not result.stderr.strip():
        raise Wrong("exit code 2 without a word")
    started = "is being" not in result.stderr and "cannot run" not in result.stderr
    if case.command.startswith("run") and started and "state hash" not in result.stdout:
        raise Wrong(f"there is no report: {result.stderr.strip()[-300:]}")
    for left in case.folder.rglob("*.part*"):
        if left.name not in PARTS:
            raise Wrong(f"{left.name} is left")


def make_inputs(arguments):
    arguments.inputs.mkdir()
    subprocess.run([arguments.program, "run", "nudge", "--duration", "4", "--record", arguments.inputs / "in.mcap", "--log",
                    "robot.imu", "--out", arguments.inputs / "in.csv"], check=True, stdout=subprocess.DEVNULL)


def can_draw(arguments):
    drawn = subprocess.run([arguments.program, "render", "nudge", "--size", "32x32", "--out", arguments.inputs / "try.png"],
                           capture_output=True)
    return drawn.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="murosimf")
    parser.add_argument("--kills", type=int, default=12, help="commands that are killed")
    parser.add_argument("--fills", type=int, default=8, help="commands that run out of space")
    parser.add_argument("--runs", type=int, help="both: so many kills, and a quarter as many without space")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="commands with this word")
    arguments = parser.parse_args()
    arguments.program = str(pathlib.Path(arguments.program).resolve())
    if arguments.runs:
        arguments.kills, arguments.fills = arguments.runs, arguments.runs // 4
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="murosimf_survival.") as top:
        top = pathlib.Path(top)
        arguments.inputs = top / "inputs"
        make_inputs(arguments)
        draws, video = can_draw(arguments), shutil.which("ffmpeg")
        commands = [one for one in COMMANDS if (not arguments.only or arguments.only in one) and
                    (draws or "render" not in one) and (video or "--video" not in one) and
                    (shutil.which("gnuplot") or not one.startswith("plot"))]
        for kind, count in (("kill", arguments.kills), ("fill", arguments.fills)):
            statistics = {"ended before": 0, "new files": 0, "recordings": 0, "most lost [s]": 0.0, "exit code 2": 0,
                          "on a small disk": 0}
            for number in range(count):
                seed = int(hashlib.sha256(f"{arguments.seed} {kind} {number}".encode()).hexdigest()[:8], 16)
                choose = random.Random(seed)
                command = commands[number % len(commands)] if number < 2 * len(commands) else choose.choice(commands)
                folder = top / f"{kind}_{number}"
                folder.mkdir()
                disk = None
                try:
                    if kind == "kill":
                        kill_one(Case(arguments, command, choose, folder), statistics)
                        continue
                    on_disk = choose.random() < 0.5 and os.geteuid() == 0
                    room = sum((arguments.inputs / name).stat().st_size for name in ("in.mcap", "in.csv")) + 100_000
                    size = choose.choice([0, 3_000, 60_000, 400_000, 1_500_000])
                    if on_disk:
                        disk = SmallDisk(folder, room + size)
                        statistics["on a small disk"] += disk.there
                    case = Case(arguments, command, choose, folder)
                    fill_one(case, size, bool(disk and disk.there), statistics)
                except (Wrong, subprocess.TimeoutExpired) as error:
                    wrong += 1
                    print(f"{kind} {number} (seed {arguments.seed}): {command}: {error}")
                finally:
                    if disk:
                        disk.close()
                    shutil.rmtree(folder)
            print(f"{count} times {kind}: " + ", ".join(f"{name} {value:.3g}" for name, value in statistics.items()))
    print("nothing is lost" if not wrong else f"{wrong} are wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
