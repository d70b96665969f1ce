#!/usr/bin/env python3
"""Checks the language of comments and pages: the words of docs/glossary.md, and plain technical English.

Names that the last column of the glossary gives up appear nowhere, neither as written there nor in snake_case. In
comments of murosimf/, include/ and apps/ no pronoun of persons stands for data or code. Prints each violation as
file:line: message and exits with 1 if there is one.

    scripts/check_words.py [root of the source tree]
"""
import re
import sys
from pathlib import Path

GLOSSARY = "docs/glossary.md"
CODE = ("murosimf", "include", "apps")
EVERYWHERE = (*CODE, "tests", "examples", "benchmarks", "docs")
PERSONS = re.compile(r"(?<!people )(?<!those )(?<!user )(?<!users )"
                     r"\b(who|whom|whoever|nobody|somebody|everybody|everyone|anybody|someone)\b(?!\()", re.IGNORECASE)
COMMENT = re.compile(r'//.*|/\*.*?\*/')
STRING = re.compile(r'"(?:\\.|[^"\\])*"')


def snake(name):
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def given_up(root):
    """Pattern of the names in the last column, as types and as files, and the words to use by them."""
    instead = {}
    for line in (root / GLOSSARY).read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("| ") and len(cells) == 3 and cells[2] not in ("not", ""):
            for name in cells[2].split(", "):
                instead[name] = instead[snake(name)] = cells[0]
    return re.compile(r"\b(" + "|".join(sorted(instead, key=len, reverse=True)) + r")\b"), instead


def files(root, folders):
    for folder in folders:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in (".h", ".cpp", ".c", ".md", ".py") and "seeds" not in file.parts:
                yield file


def violations(root):
    """Yields (file, line number, message)."""
    pattern, instead = given_up(root)
    for file in files(root, EVERYWHERE):
        name = file.relative_to(root)
        in_code = name.parts[0] in CODE and file.suffix != ".md"
        if name.as_posix() == GLOSSARY:
            continue
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            for found in pattern.findall(line):
                yield name, number, f"'{found}': say {instead[found]} ({GLOSSARY})"
            if in_code:
                for comment in COMMENT.findall(STRING.sub('""', line)):
                    for found in PERSONS.findall(comment):
                        yield name, number, f"'{found}' in a comment: name the thing instead"


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent
    found = list(violations(root))
    for file, number, message in found:
        print(f"{file}:{number}: {message}")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
