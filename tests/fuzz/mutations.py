#!/usr/bin/env python3
"""Runs the program on thousands of inputs with errors in them: it may refuse them, in one line, and nothing else.

    tests/fuzz/mutations.py --program build/release/murosimf                 1,000 cases
    tests/fuzz/mutations.py --program build/release/murosimf --cases 50000   some twenty minutes
    tests/fuzz/mutations.py --program build/release/murosimf --only 4711 --keep found   one of them again, and its files

Errors are made in scenes, robots, their tables, motions, parts, servos, lenses, recordings, meshes, tables of numbers
and options. A case fails if the program ends by a signal, takes longer than 20 s, ends with a code that is none of its
own, says something else than one line when it refuses (and lines 'warning: ...'), or leaves a '.part' file behind. The
same seed and number make the same case.
"""

import argparse
import concurrent.futures
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True

from mutated_cases import Cases  # noqa: E402

TIME_LIMIT = 20  # [s]
MEMORY_LIMIT = 4_000_000_000  # [byte] of address space
NEVER = ("terminate called", "Traceback", "AddressSanitizer", "runtime error:", "LeakSanitizer", "Assertion",
         "unexpected:", "out of memory")


def complaint(code, errors):
    """What is wrong with how the program ended; empty if nothing is."""
    for words in NEVER:
        if words in errors:
            return f"it says '{words}'"
    if code < 0:
        return f"signal {-code}"
    if code not in (0, 1, 2):
        return f"exit code {code}"
    lines = [line for line in errors.split("\n") if line and not line.startswith(("warning: ", "libEGL warning: "))]
    most = 0 if code == 0 else 1
    if len(lines) > most or (code == 2 and len(lines) != 1):
        return f"{len(lines)} lines on standard error with exit code {code}"
    if any(not line.startswith("murosimf: ") for line in lines):
        return "its line does not begin with its name"
    return "an empty reason" if "murosimf: \n" in errors else ""


class Outcome:
    def __init__(self, number, complaint, code):
        self.number, self.complaint, self.code = number, complaint, code


class Tester:
    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        self.cases = Cases(options.program)

    def make(self, number):
        return self.cases.make(random.Random(f"{self.options.seed}/{number}"))

    def prepare(self, number):
        arguments, files = self.make(number)
        folder = self.folder / str(number)
        folder.mkdir(parents=True)
        for name, content in files.items():
            (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode("utf-8", "replace"))
        return arguments, folder

    def run(self, number):
        arguments, folder = self.prepare(number)
        try:
            done = subprocess.run([self.options.program, *arguments], cwd=folder, stdin=subprocess.DEVNULL,
                                  capture_output=True, timeout=TIME_LIMIT)
            wrong = complaint(done.returncode, done.stderr.decode(errors="replace"))
            code = done.returncode
        except subprocess.TimeoutExpired:
            wrong, code = f"it takes more than {TIME_LIMIT} s", -1
        if not wrong and any(folder.rglob("*.part")):
            wrong = "a .part file is left"
        if wrong:
            self.keep(folder)
        shutil.rmtree(folder)
        return Outcome(number, wrong, code)

    def keep(self, folder):
        if self.options.keep:
            shutil.copytree(folder, self.options.keep / folder.name, dirs_exist_ok=True)

    def show(self, number):
        """One case in full."""
        arguments, folder = self.prepare(number)
        self.keep(folder)
        print("in", self.options.keep / folder.name if self.options.keep else folder)
        print(" ".join(map(repr, [self.options.program, *arguments])), flush=True)
        done = subprocess.run([self.options.program, *arguments], cwd=folder, stdin=subprocess.DEVNULL,
                              timeout=TIME_LIMIT)
        print("exit code", done.returncode)


def read_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", required=True, type=lambda text: str(pathlib.Path(text).resolve()))
    parser.add_argument("--cases", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seconds", type=float, default=float("inf"), help="begin no case after this time")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the files of cases that fail")
    parser.add_argument("--only", type=int, help="show this case alone")
    parser.add_argument("--no-memory-limit", action="store_true", help="for sanitizers, which reserve terabytes")
    return parser.parse_args()


def run_all(tester, options):
    start = time.monotonic()
    outcomes = []

    def run_in_time(number):
        return tester.run(number) if time.monotonic() - start < options.seconds else None

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for outcome in pool.map(run_in_time, range(options.first, options.first + options.cases)):
            if outcome is None:
                continue
            outcomes.append(outcome)
            if outcome.complaint:
                again = f"--seed {options.seed} --only {outcome.number}"
                print(f"case {outcome.number}: {outcome.complaint}; again: {again}", flush=True)
    return outcomes, time.monotonic() - start


def main():
    options = read_options()
    if not options.no_memory_limit:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with tempfile.TemporaryDirectory(prefix="murosimf_mutations_") as name:
        tester = Tester(options, pathlib.Path(name))
        if options.only is not None:
            tester.show(options.only)
            return 0
        outcomes, wall = run_all(tester, options)
    failed = sum(1 for outcome in outcomes if outcome.complaint)
    refused = sum(1 for outcome in outcomes if outcome.code in (1, 2))
    print(f"mutations: {len(outcomes)} cases of seed {options.seed} in {wall:.0f} s: {refused} refused, "
          f"{len(outcomes) - refused - failed} taken, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
