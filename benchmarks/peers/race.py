#!/usr/bin/env python3
"""Races our program against other engines, by turns in one run, and says whether all did the same work.

    cmake --build build/release --target murosimf_peers murosimf_benchmarks
    benchmarks/peers/race.py --install                          once: MuJoCo and Pinocchio into build/peers-venv
    benchmarks/peers/race.py --out race.json --chart race.png   everything, an hour or less
    benchmarks/peers/race.py walk heap --rounds 3               only these parts
    benchmarks/peers/race.py walk --engines mujoco --robots 22
    benchmarks/peers/race.py --quick                            does it run at all? a minute

Engines that are not there are named in one line, and the others run. Times are processor time of the process where one thread
works, so that other load on the machine counts only by what it takes of caches and clock rates; wall time where all threads work
(worlds, games). Ratios are of runs in the same round. docs/performance.md says what is fair in them and what is not.
"""
import argparse
import json
import os
import pathlib
import platform
import time

import batches
import chart
import collision
import games
import growth
import kernels
import pictures
import steps
import worlds
from running import ROOT, Machine, fail, find_python, install

SCHEMA = "murosimf/race/1"
PARTS = {
    "walk": steps.part("walk", [1, 10, 22]),
    "squat": steps.part("squat", [1, 10, 22]),
    "heap": steps.part("heap", [10, 22]),
    "slope": steps.part("slope", [1]),
    "worlds": worlds.part,
    "batch": batches.part,
    "kernels": kernels.part,
    "collision": collision.part,
    "cameras": pictures.part,
    "games": games.part,
    "growth": growth.part,
}


def parse(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0], epilog=f"parts: {', '.join(PARTS)}")
    parser.add_argument("parts", nargs="*", metavar="part", help="what to race; nothing: all")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release", help="folder of our programs")
    parser.add_argument("--python", help="has MuJoCo; else build/peers-venv, build/oracle-venv, python3 are tried")
    parser.add_argument("--install", action="store_true", help="MuJoCo and Pinocchio from PyPI to build/peers-venv, then stop")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--length", type=float, default=1, help="times the usual simulated time of a run")
    parser.add_argument("--robots", type=int, action="append", help="in the scenes of walk, squat and heap (again: several)")
    parser.add_argument("--engines", nargs="+", metavar="WORD", help="only engines whose names have one of these, and ours")
    parser.add_argument("--quick", action="store_true", help="one short round of little: does it run?")
    parser.add_argument("--out", type=pathlib.Path, help="JSON file to write; parts that it has and that are not raced now stay")
    parser.add_argument("--chart", type=pathlib.Path, help="PNG file to write (gnuplot)")
    options = parser.parse_args(arguments)
    unknown = [part for part in options.parts if part not in PARTS]
    if unknown:
        parser.error(f"unknown part '{unknown[0]}'; known: {', '.join(PARTS)}")
    if not 1 <= options.rounds <= 1000 or not 0.01 <= options.length <= 1000:
        parser.error("--rounds must be 1 to 1000, --length 0.01 to 1000")
    if any(not 1 <= count <= 22 for count in options.robots or []):
        parser.error("--robots must be 1 to 22")
    for file in (options.out, options.chart):
        if file and not file.absolute().parent.is_dir():
            parser.error(f"the folder of {file} is not there")
    if options.quick:
        options.rounds, options.length = 1, 1
    return options


def earlier_parts(file):
    """Of a race that was written to the file before."""
    if not file or not file.exists():
        return {}
    try:
        document = json.loads(file.read_text())
        if document["schema"] == SCHEMA:
            return document["parts"]
    except (OSError, ValueError, KeyError, TypeError):
        pass
    return fail(f"{file} is no document of a race: it stays as it is")


def processor():
    try:
        lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor()


def main():
    options = parse()
    if options.install:
        return install()
    python = find_python(options.python)
    if options.python and not python:
        fail(f"{options.python} has no MuJoCo: pip install mujoco")
    machine = Machine(options.build, python)
    about = {"processor": processor(), "threads": os.cpu_count(), "load": os.getloadavg()[0], "rounds": options.rounds}
    print(f"{about['processor']}, {about['threads']} threads, load {about['load']:.1f}, {options.rounds} rounds", flush=True)
    document = {"schema": SCHEMA, "machine": about, "parts": earlier_parts(options.out), "missing": machine.missing}
    for name in options.parts or PARTS:
        begin = time.perf_counter()
        rows = PARTS[name](machine, options)
        seconds = time.perf_counter() - begin
        document["parts"][name] = {"rows": rows, "took_s": round(seconds, 1)}
        print(f"\n{name}: took {seconds:.0f} s", flush=True)
        if options.out:  # after each part: an hour's work is not lost
            options.out.write_text(json.dumps(document, indent=1) + "\n")
    if options.chart:
        chart.draw(document, options.chart)


if __name__ == "__main__":
    main()
