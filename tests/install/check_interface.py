#!/usr/bin/env python3
"""Looks at an installed library from outside: its headers, how much a program reads of them, what the shared library exports.

    check_interface.py PREFIX PROGRAM.cpp [COMPILER]

Prints the figures. Exits with 1, and says why, if a header is installed that is none of the interface, if a public header
includes one that is not, if PROGRAM.cpp reads 10,000 lines of ours or more, or if libmurosimf.so exports another name than
those of murosimf::v0.
"""

import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

most_lines = 10_000
exported = re.compile(r"^_Z(N|NK|TIN|TSN|TVN)8murosimf2v0")
included = re.compile(r'^\s*#\s*include\s*[<"](murosimf/[^>"]+)[>"]', re.MULTILINE)
for_software = {"murosimf/control_software/murosimf_controller.h", "murosimf/network/robot_client.h"}  # has doors of its own


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def check_headers(include):
    public = {file.relative_to(include).as_posix() for file in (include / "murosimf").rglob("*.h")}
    plugin = {file.relative_to(include / "murosimf-plugin").as_posix() for file in (include / "murosimf-plugin").rglob("*.h")}
    front = {name for name in public if name.count("/") == 1}
    print(f"headers: {len(front)} public, {len(public - front)} for control software, {len(plugin)} for plug-ins")
    yield from (f"{name} is no header of the interface" for name in sorted(public - front - for_software))
    yield from (f"{name} is missing" for name in sorted(for_software - public) if "client" not in name)
    if not front:
        yield "there are no public headers"
    for name in sorted(front):
        for other in included.findall((include / name).read_text(encoding="utf-8")):
            if other not in front:
                yield f"{name} includes {other}"
    for name in sorted(plugin):
        for other in included.findall((include / "murosimf-plugin" / name).read_text(encoding="utf-8")):
            if other not in plugin:
                yield f"murosimf-plugin/{name} includes {other}, which is not installed"


def check_program(include, program, compiler):
    """Lines of ours that the compiler reads, and how long it takes."""
    command = [compiler, "-std=c++20", f"-I{include}"]
    listed = run(*command, "-M", program).replace("\\\n", " ").split()
    ours = [Path(file) for file in listed if Path(file).is_relative_to(include)]
    lines = sum(len(file.read_text(encoding="utf-8").splitlines()) for file in ours)
    times = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(3):
            begin = resource.getrusage(resource.RUSAGE_CHILDREN)
            run(*command, "-c", program, "-o", f"{folder}/program.o")
            end = resource.getrusage(resource.RUSAGE_CHILDREN)
            times.append(end.ru_utime + end.ru_stime - begin.ru_utime - begin.ru_stime)
    print(f"{Path(program).name}: {len(ours)} headers of ours with {lines} lines; {min(times):.2f} s of a processor to compile")
    if not 0 < lines < most_lines:
        yield f"{program} reads {lines} lines of ours, not less than {most_lines}"


def check_symbols(library):
    names = [line.split()[-1] for line in run("nm", "-D", "--defined-only", library).splitlines()]
    names = [name.partition("@")[0] for name in names if not name.startswith("MUROSIMF_")]
    print(f"{library.name}: {len(names)} names exported")
    if not names:
        yield "libmurosimf.so exports nothing"
    yield from (f"libmurosimf.so exports {name}" for name in names if not exported.match(name))


def check_soname(library, version):
    soname = re.search(r"SONAME.*\[(.+)\]", run("readelf", "-d", library))
    wanted = "libmurosimf.so." + ".".join(version.split(".")[:2])
    if not soname or soname[1] != wanted:
        yield f"the soname is {soname and soname[1]}, not {wanted}"


def main():
    prefix, program = Path(sys.argv[1]), sys.argv[2]
    compiler = sys.argv[3] if len(sys.argv) > 3 else "c++"
    include = prefix / "include"
    library = next(prefix.glob("lib*/**/libmurosimf.so"))
    version = "".join(re.findall(r"MUROSIMF_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", (include / "murosimf/version.h").read_text()))
    errors = [*check_headers(include), *check_program(include, program, compiler), *check_symbols(library),
                *check_soname(library, ".".join(version))]
    for error in errors:
        print(error, file=sys.stderr)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
