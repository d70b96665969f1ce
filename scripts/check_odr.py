#!/usr/bin/env python3
"""Checks the one definition rule: nothing with a name that other files can see is defined twice.

Two inline functions of one name and parameters in two headers, or two classes of one name in two sources, compile and
link; the linker keeps one of the two for all files. No compiler reports it. Examined is what stands at namespace level,
formatted as clang-format does it: types and inline functions of headers and sources, all functions of sources. What
belongs to one source stands in an anonymous namespace. Prints file:line: message for each second definition and exits
with 1 if there is one.

    scripts/check_odr.py [root of the source tree]
"""

import re
import sys
from pathlib import Path

# Files of one program may not clash: the library with each folder of tests; each example and benchmark is a program.
library = "murosimf"
programs = ["apps", "tests/*", "examples/*.cpp", "benchmarks/*.cpp"]
programs_each = ["tests/oracle", "tests/fuzz"]  # folders whose sources are a program each

opens = re.compile(r"^(?:inline )?namespace([\w: ]*)\{")
closes = re.compile(r"^\}\s*// namespace(.*)$")
type_line = re.compile(r"^(?:struct|class|union|enum class|enum struct|enum) (?:alignas\(\S+\) )?"
                       r"(\w+)(?: final)?(?: : [^;]*)?\s*\{")
# a type, a name, an open parenthesis; what follows is read up to the matching one
function_line = re.compile(r"^(?!using |return |typedef |static_assert|TEST|INSTANTIATE|template class|extern )"
                           r"(?:[\w:<>,*&\[\] ]+[ *&])?(\w+|operator\S+)\(")
default = re.compile(r"=[^,]*")


def parameters(text):
    """The types of a parameter list without names and default values, and the text behind it; None: it does not end."""
    depth, part, parts = 1, "", []
    for place, letter in enumerate(text):
        if letter in "(<[{":
            depth += 1
        elif letter in ")>]}":
            depth -= 1
            if depth == 0:
                parts.append(part)
                types = [re.sub(r"(?<=[\w>&*]) ?\b\w+$", "", default.sub("", p).strip()) for p in parts]
                return ",".join(t.replace(" ", "") for t in types), text[place + 1:]
        if letter == "," and depth == 1:
            parts.append(part)
            part = ""
        else:
            part += letter
    return None


def definitions(path):
    """Yields (line number, key) of every definition that other files can see."""
    lines = path.read_text(encoding="utf-8").splitlines()
    spaces = []
    header = path.suffix == ".h"
    template = ""
    for number, line in enumerate(lines, 1):
        if found := opens.match(line):
            spaces.append(found[1].strip())
            continue
        if closes.match(line) and spaces:
            spaces.pop()
            continue
        if "" in spaces or not line or line[0] in " }#/":
            continue
        where = "::".join(spaces)
        if line.startswith("template"):
            template = line
            continue
        of_template, template = template, ""
        if of_template.startswith("template <>") or line.startswith("static "):
            continue
        if found := type_line.match(line):
            yield number, f"{where}::{found[1]}"
            continue
        found = function_line.match(line)
        if not found or "::" in line[:found.end()].split("(")[0].split(" ")[-1]:
            continue
        rest = parameters(" ".join([line[found.end():]] + [text.strip() for text in lines[number:number + 12]]))
        if rest is None:
            continue
        is_definition = re.match(r"\s*(?:const |noexcept |-> [\w:<>&* ]+)*(?:requires .*)?\{", rest[1])
        if is_definition and (not header or "inline" in line or "constexpr" in line or of_template):
            yield number, f"{where}::{found[1]}({rest[0]})" + (f" [{of_template}]" if of_template else "")


def sources(root, pattern):
    """Headers and sources; no_NAME.cpp stands in for NAME.cpp where a library is missing, never beside it."""
    for place in sorted(root.glob(pattern)):
        files = [place] if place.is_file() else sorted(place.rglob("*"))
        yield from (file for file in files if file.suffix in (".h", ".cpp") and not file.name.startswith("no_"))


def groups(root):
    """The files of each program, without the library's."""
    shared = list(sources(root, "tests/*.h"))
    for pattern in programs:
        for place in sorted(root.glob(pattern)):
            name = str(place.relative_to(root))
            if place not in shared and name not in programs_each:
                yield (shared if name.startswith("tests/") else []) + list(sources(root, name))
    for folder in programs_each:
        headers = list(sources(root, f"{folder}/*.h"))
        yield from (headers + [source] for source in sources(root, f"{folder}/*.cpp"))


def clashes(root, files, known):
    """Messages for what `files` define a second time; `known`: key to (file, line), which grows."""
    for file in files:
        for number, key in definitions(file):
            other, line = known.setdefault(key, (file, number))
            if other != file:
                yield f"{file.relative_to(root)}:{number}: '{key}' is defined in {other.relative_to(root)}:{line}, too"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    of_library = {}
    found = list(clashes(root, sources(root, library), of_library))
    for group in groups(root):
        found += clashes(root, group, dict(of_library))
    for clash in found:
        print(clash)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
