#!/usr/bin/env python3
"""Checks that a newcomer finds every file by its folder: docs/tour.md names all folders, and none grows too large.

The table of docs/tour.md names the folders of murosimf/CMakeLists.txt, all of them, in its order. No folder holds
more than 12 % of the library's lines or 75 files, and no source or header is longer than 350 lines. Tests stand in a
folder of the same name. Prints each violation as file:line: message and exits with 1 if there is one;
with --table also how large all are.

    scripts/check_structure.py [--table] [root of the source tree]
"""

import re
import sys
from pathlib import Path

from check_includes import folder_of, folders, sources

most_share, most_files, most_lines = 0.12, 75, 350
cross_cutting = {"apps", "data", "fuzz", "install", "oracle", "physics"}  # tests of no single folder

row = re.compile(r"^\| `([\w/]+)` \|")


def sizes(root, names):
    """Folder to (files, lines), and (file, lines) of those that are too long."""
    found, long = {name: [0, 0] for name in names}, []
    for file in sources(root / "murosimf"):
        folder = folder_of(file.relative_to(root / "murosimf").as_posix(), names)
        lines = len(file.read_text(encoding="utf-8").splitlines())
        if folder:
            found[folder][0] += 1
            found[folder][1] += lines
        if lines > most_lines:
            long.append((file.relative_to(root), lines))
    return found, long


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
        yield begin + 1, ("the folders are not those of murosimf/CMakeLists.txt: "
                          f"missing {missing}, unknown {unknown}, or in another order")


def check_tests(root, names):
    """Yields (folder, message) of tests that mirror nothing."""
    for folder in sorted({file.parent.relative_to(root / "tests").as_posix() for file in sources(root / "tests")}):
        if folder != "." and folder not in names and folder.split("/")[0] not in cross_cutting:
            yield f"tests/{folder}", "has no folder of this name in murosimf/"


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--table"]
    root = Path(arguments[0]) if arguments else Path(__file__).parent.parent
    names, _ = folders(root)
    found, long = sizes(root, names)
    total = sum(lines for _, lines in found.values())
    if "--table" in sys.argv:
        for name, (files, lines) in found.items():
            print(f"{name:20} {files:4} files {lines:6} lines {100 * lines / total:5.1f} %")
        print(f"{'all':20} {sum(files for files, _ in found.values()):4} files {total:6} lines")
    messages = [f"{file}:{lines}: {lines} lines, more than {most_lines}" for file, lines in long]
    for name, (files, lines) in found.items():
        if lines > most_share * total or files > most_files:
            share = f"{100 * lines / total:.0f} % of all lines"
            messages.append(f"murosimf/{name}:1: {files} files and {share}, too much for one folder")
    messages += [f"docs/tour.md:{number}: {message}" for number, message in check_tour(root, names)]
    messages += [f"{folder}:1: {message}" for folder, message in check_tests(root, names)]
    for message in messages:
        print(message)
    sys.exit(1 if messages else 0)


if __name__ == "__main__":
    main()
