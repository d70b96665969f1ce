#!/usr/bin/env python3
"""Checks the include graph of the library, and the first lines of every header.

Each folder of murosimf/ may include itself and the folders named in `allowed` below, nothing else; programs, tests,
examples and benchmarks may include everything. Every header begins with `/// name.h - what it is for` and has
`#pragma once`. Prints each violation as file:line: message and exits with 1 if there is one.

    scripts/check_includes.py [root of the source tree]
"""

import re
import sys
from pathlib import Path

allowed = {
    "math": set(),
    "model": {"math"},
    "multibody": {"math", "model"},
    "geometry": {"math", "model"},
    "collision": {"math", "model", "geometry"},
    "motion": {"math", "model", "multibody", "geometry", "collision"},
    "sensors": {"math", "model", "geometry", "collision"},
    "control": {"math", "model", "multibody", "geometry", "collision", "motion", "sensors"},
    "identification": {"math", "model", "multibody"},
    "runtime": {"math", "model"},
    "render": {"math", "model", "geometry", "collision", "sensors"},
}
allowed["io"] = set(allowed)
allowed["league"] = set(allowed)

outside = ["apps", "python", "tests", "examples", "benchmarks"]

include_line = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cpp") and p.is_file())


def includes(lines):
    """Yields (line number, path, quoted) of every #include."""
    for number, line in enumerate(lines, 1):
        found = include_line.match(line)
        if found:
            yield number, found[2], found[1] == '"'


def check_include(root, file, folder, path, quoted):
    """The message of what is wrong with one #include in `file`, or None. `folder` is None outside the library."""
    if not path.startswith("murosimf/"):
        if folder is None or not quoted:
            return None
        return f'"{path}": write <{path}> for other libraries and "murosimf/..." for our own headers'
    if not quoted and not file.is_relative_to(root / "examples"):  # examples are written as users write
        return f"<{path}>: our own headers stand in quotes"
    if not (root / path).is_file():
        return f'"{path}" does not exist'
    target = path.split("/")[1]
    if folder is None or target == folder or target in allowed.get(folder, set()):
        return None
    known = ", ".join(["itself"] + [name for name in allowed if name in allowed[folder]])
    return f"murosimf/{folder} may not include murosimf/{target} (only {known})"


def check_header(file, lines):
    """Yields (line number, message) for the first lines of a header."""
    if not lines or not lines[0].startswith(f"/// {file.name} - "):
        yield 1, f"the header begins with `/// {file.name} - what it is for`"
    if "#pragma once" not in (line.strip() for line in lines):
        yield 1, "#pragma once is missing"


def violations(root):
    """Yields (file, line number, message)."""
    library = root / "murosimf"
    files = sources(library) + [file for name in outside for file in sources(root / name)]
    for file in files:
        relative = file.relative_to(root)
        folder = relative.parts[1] if relative.parts[0] == "murosimf" and len(relative.parts) > 2 else None
        lines = file.read_text(encoding="utf-8").splitlines()
        if folder is not None and folder not in allowed:
            yield relative, 1, f"murosimf/{folder} is not in the table of scripts/check_includes.py"
            continue
        for number, path, quoted in includes(lines):
            message = check_include(root, file, folder, path, quoted)
            if message:
                yield relative, number, message
        if file.suffix == ".h":
            yield from ((relative, number, message) for number, message in check_header(file, lines))


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent
    if not (root / "murosimf").is_dir():
        sys.exit(f"check_includes: {root} has no folder murosimf")
    count = 0
    for file, number, message in violations(root):
        print(f"{file}:{number}: {message}")
        count += 1
    if count:
        sys.exit(1)


if __name__ == "__main__":
    main()
