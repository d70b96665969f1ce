#!/usr/bin/env python3
"""Checks the include graph of the library, and the first lines of every header.

Each folder of murosimf/ may include itself, the folders that stand after its USES in murosimf/CMakeLists.txt, and what
those use, nothing else; a folder may use only what stands above it there. Programs, tests, examples and benchmarks may
include everything. The public headers, include/murosimf/, include each other and the standard library alone (those of
plug-ins, in its folder plugin, also those of the library); of the library only the folder `api`, which implements them,
includes them, as "murosimf/scene.h". No two headers of the library have one name. Every header begins with `/// name.h -
what it is for` and has `#pragma once`. A file that names a property, or what the standard library declares
(scripts/standard_headers.py) or another header of the project (scripts/own_headers.py), includes, directly or not, the
header that has it: precompiled headers and sources that are compiled as one hide that some do not.
Prints each violation as file:line: message and exits with 1 if there is one.

    scripts/check_includes.py [root of the source tree]
"""

import re
import sys
from pathlib import Path

import standard_headers
from own_headers import OwnHeaders

folder_line = re.compile(r"^\s*murosimf_folder\(([\w/]+)((?:\s+[^\s()]+)*)\s*\)", re.MULTILINE)
outside = ["apps", "python", "tests", "examples", "benchmarks"]
public = "include"  # murosimf/*.h in it
public_of_plugins = "include/murosimf/plugin"
implements_public = "api"

property_line = re.compile(r"^inline constexpr Property<[^;{}]*>\s+(\w+)\s*\{", re.MULTILINE)
property_use = re.compile(r"\bproperties::(\w+)")
include_line = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def folders(root):
    """The folders of the library, low to high, with the set of those that each may include; and errors, as text."""
    allowed, errors = {}, []
    for found in folder_line.finditer((root / "murosimf/CMakeLists.txt").read_text(encoding="utf-8")):
        name, words = found[1], found[2].split()
        uses = words[words.index("USES") + 1:] if "USES" in words else []
        for keyword in ("LINKS", "EXCEPT"):
            if keyword in uses:
                uses = uses[:uses.index(keyword)]
        for use in uses:
            if use not in allowed:
                errors.append(f"murosimf/{name} uses {use}, which does not stand above it")
        allowed[name] = set(uses).union(*(allowed.get(use, set()) for use in uses))
    return allowed, errors


def folder_of(path, allowed):
    """The folder of the library in which a path like "formats/mjcf/x.h" stands: the longest that is in the list."""
    parent = path.rpartition("/")[0]
    while parent and parent not in allowed:
        parent = parent.rpartition("/")[0]
    return parent or None


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cpp") and p.is_file())


def includes(lines):
    """Yields (line number, path, quoted) of every #include."""
    for number, line in enumerate(lines, 1):
        found = include_line.match(line)
        if found:
            yield number, found[2], found[1] == '"'


def check_include(root, file, folder, path, quoted, allowed):
    """The message of what is wrong with one #include in `file`, or None. `folder` is None outside the library."""
    if not path.startswith("murosimf/"):
        if file.is_relative_to(root / public) and "." in path:
            return f"<{path}>: a public header includes the standard library alone"
        if folder is None or not quoted:
            return None
        return f'"{path}": write <{path}> for other libraries and "murosimf/..." for our own headers'
    if not quoted and not file.is_relative_to(root / "examples"):  # examples are written as users write
        return f"<{path}>: our own headers stand in quotes"
    is_public = (root / public / path).is_file()
    if not is_public and not (root / path).is_file():
        return f'"{path}" does not exist'
    if file.is_relative_to(root / public_of_plugins):
        return None
    if file.is_relative_to(root / public):
        return None if is_public else f"a public header may not include {path}, which is not installed"
    if is_public:
        return None if folder in (None, implements_public) else f"murosimf/{folder} may not include the public header {path}"
    target = folder_of(path.removeprefix("murosimf/"), allowed)
    if folder is None or target == folder or target in allowed[folder]:
        return None
    known = ", ".join(["itself"] + [name for name in allowed if name in allowed[folder]])
    return f"murosimf/{folder} may not include murosimf/{target} (only {known})"


def check_header(file, lines):
    """Yields (line number, message) for the first lines of a header."""
    if not lines or not lines[0].startswith(f"/// {file.name} - "):
        yield 1, f"the header begins with `/// {file.name} - what it is for`"
    if "#pragma once" not in (line.strip() for line in lines):
        yield 1, "#pragma once is missing"


class Includes:
    """What files include, directly or not: of the project by path, of the standard library as "vector"."""

    def __init__(self, root):
        self.root, self.known = root, {}
        files = [file for name in ["murosimf", public, *outside] for file in sources(root / name)]
        self.own = OwnHeaders({file.relative_to(root).as_posix(): file.read_text(encoding="utf-8") for file in files})
        self.headers_of = {}  # by property
        for header in sources(root / "murosimf"):
            if header.suffix == ".h":
                for name in property_line.findall(header.read_text(encoding="utf-8")):
                    self.headers_of.setdefault(name, set()).add(header.relative_to(root).as_posix())

    def of(self, path):
        if path not in self.known:
            self.known[path] = found = {path}
            file = self.root / public / path
            if not file.is_file():
                file = self.root / path
            lines = file.read_text(encoding="utf-8").splitlines() if file.is_file() else []
            for _, included, quoted in includes(lines):
                if quoted or included.startswith("murosimf/"):
                    beside = Path(path).parent / included  # as those of the bindings for Python
                    found |= self.of(beside.as_posix() if (self.root / beside).is_file() else included)
                elif "." not in included:
                    found.add(included)
        return self.known[path]

    def missing(self, relative, lines):
        """Yields (line number, message) of what the file names without the header that has it."""
        reached = self.of(relative.as_posix())
        for number, line in enumerate(lines, 1):
            for name in property_use.findall(line.partition("//")[0]):
                headers = self.headers_of.get(name, set())
                if headers and not headers & reached:
                    yield number, f"properties::{name} is named, {' or '.join(sorted(headers))} not included"
        yield from standard_headers.missing(reached, lines)
        yield from self.own.missing(relative.as_posix(), {self.file_of(path) for path in reached})

    def file_of(self, path):
        """Where an included header stands in the tree: "murosimf/scene.h" may be public."""
        return f"{public}/{path}" if (self.root / public / path).is_file() else path


def violations(root):
    """Yields (file, line number, message)."""
    reached = Includes(root)
    library = root / "murosimf"
    allowed, errors = folders(root)
    yield from (("murosimf/CMakeLists.txt", 1, error) for error in errors)
    headers = {}
    for file in sources(library) + [file for name in [public, *outside] for file in sources(root / name)]:
        relative = file.relative_to(root)
        folder = None
        if relative.parts[0] == "murosimf":
            folder = folder_of(relative.as_posix().removeprefix("murosimf/"), allowed)
            if folder is None:
                yield relative, 1, f"{relative.parent} is not among the folders of murosimf/CMakeLists.txt"
                continue
        lines = file.read_text(encoding="utf-8").splitlines()
        for number, path, quoted in includes(lines):
            message = check_include(root, file, folder, path, quoted, allowed)
            if message:
                yield relative, number, message
        yield from ((relative, number, message) for number, message in reached.missing(relative, lines))
        if file.suffix == ".h":
            yield from ((relative, number, message) for number, message in check_header(file, lines))
            other = headers.setdefault(file.name, relative) if folder else relative
            if other != relative:
                yield relative, 1, f"{other} has the same name"


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
