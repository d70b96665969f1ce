#!/usr/bin/env python3
"""Does scripts/instruction_counts notice a workload that became 5 % slower, and not one that changed by 2 %?

    tests/guard/slower_workload.py PROGRAM

Slower is a run of more steps than the table knows. Exits with 77 (skipped) where nothing can be counted.
"""

import contextlib
import importlib.machinery
import importlib.util
import io
import shutil
import sys
from pathlib import Path

root = Path(__file__).resolve().parent.parent.parent
steps = 500


def load(script):
    loader = importlib.machinery.SourceFileLoader(script.name, str(script))
    sys.dont_write_bytecode = True
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(script.name, loader))
    loader.exec_module(module)
    return module


def main():
    program = Path(sys.argv[1]).resolve()
    guard = load(root / "scripts/instruction_counts")
    try:
        guard.environment(program)
    except guard.Unable as reason:
        print(f"nothing is counted: {reason}")
        return guard.skipped
    if not shutil.which("valgrind"):
        print("nothing is counted: valgrind is not here")
        return guard.skipped

    def count(more):
        return guard.count(program, True, ["run", "walk", "--duration", str(steps * (1 + more) / 1000)])

    known = {"walk": count(0)}
    errors = []

    def expect(name, found, code, words=""):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            exit_code = guard.compare(found, known, "here")
        if exit_code != code or words not in said.getvalue():
            errors.append(f"{name}: exit code {exit_code}, not {code}, saying '{said.getvalue().strip()}'")

    expect("the same", {"walk": count(0)}, 0, "1 workloads within 3 % of the table")
    expect("2 % more steps", {"walk": count(0.02)}, 0)
    expect("5 % more steps", {"walk": count(0.05)}, 1, "% more than")
    expect("5 % fewer steps", {"walk": count(-0.05)}, 1, "% fewer than")
    expect("a new workload", {"trot": 1000}, 1, "trot: it is not in the table")
    expect("a workload that does not run", {"walk": None}, 1)
    with contextlib.suppress(RuntimeError):
        guard.count(program, True, ["run", "no_such_scene"])
        errors.append("a scene that is not there was counted")
    with contextlib.suppress(RuntimeError):
        guard.count(program, True, ["list", "scenes"])
        errors.append("what never steps was counted")
    print("\n".join(errors) or "a workload that became 5 % slower is noticed")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
