#!/usr/bin/env python3
"""Checks that a newcomer finds every file by its folder: docs/tour.md names all rooms, and tests stand where sources do.

The table of docs/tour.md names the rooms of murosimf/CMakeLists.txt, all of them, in its order. Tests stand in a
folder of the same name. Prints each violation as file:line: message and exits with 1 if there is one; with --table
also how large rooms and the longest files are. Sizes are for people to judge: a limit becomes a target.

    scripts/check_structure.py [--table] [root of the source tree]
"""

import re
import sys
from pathlib import Path

from check_includes import folder_of, folders, sources

cross_cutting = {"apps", "data", "fuzz", "install", "oracle", "physics"}  # tests of no single folder

row = re.compile(r"^\| `([\w/]+)` \|")


def sizes(root, names):
    """Room to (files, lines), and (lines, file) of all files, longest first."""
    found, files = {name: [0, 0] for name in names}, []
    for file in sources(root / "murosimf"):
        room = folder_of(file.relative_to(root / "murosimf").as_posix(), names)
        lines = len(file.read_text(encoding="utf-8").splitlines())
        files.append((lines, file.relative_to(root).as_posix()))
        if room:
            found[room][0] += 1
            found[room][1] += lines
    return found, sorted(files, reverse=True)


def check_tour(root, names):
    """Yields (line number, message) about the table of folders."""
    text = (root / "docs/tour.md").read_text(encoding="utf-8").splitlines()
    begin = next((i for i, line in enumerate(text) if line.startswith("| folder | holds |")), None)
    if begin is None:
        yield 1, "has no table `| folder | holds |`"
        return
    told = [found[1] for line in text[begin:] if (found := row.match(line))]
    if told != list(names):
        missing = [name for name in names if name not in told]
        unknown = [name for name in told if name not in names]
        yield begin + 1, ("the rooms are not those of murosimf/CMakeLists.txt: "
                          f"missing {missing}, unknown {unknown}, or in another order")


def check_tests(root):
    """Yields (folder, message) of tests that mirror nothing."""
    for folder in sorted({file.parent.relative_to(root / "tests").as_posix() for file in sources(root / "tests")}):
        if folder != "." and folder.split("/")[0] not in cross_cutting and not (root / "murosimf" / folder).is_dir():
            yield f"tests/{folder}", "has no folder of this name in murosimf/"


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--table"]
    root = Path(arguments[0]) if arguments else Path(__file__).parent.parent
    names, _ = folders(root)
    if "--table" in sys.argv:
        found, files = sizes(root, names)
        total = sum(lines for _, lines in found.values())
        for name, (count, lines) in found.items():
            print(f"{name:20} {count:4} files {lines:6} lines {100 * lines / total:5.1f} %")
        print(f"{'all':20} {len(files):4} files {total:6} lines, {len(found)} rooms; longest files:")
        for lines, file in files[:5]:
            print(f"{lines:6} {file}")
    messages = [f"docs/tour.md:{number}: {message}" for number, message in check_tour(root, names)]
    messages += [f"{folder}:1: {message}" for folder, message in check_tests(root)]
    for message in messages:
        print(message)
    sys.exit(1 if messages else 0)


if __name__ == "__main__":
    main()
