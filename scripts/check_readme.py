#!/usr/bin/env python3
"""Checks that the program in README.md is examples/minimal.cpp, letter by letter, and that files it names exist."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
readme = (root / "README.md").read_text()
example = (root / "examples" / "minimal.cpp").read_text()
errors = []

blocks = re.findall(r"```cpp\n(.*?)```", readme, re.DOTALL)
if blocks != [example]:
    errors.append("README.md: its C++ program is not examples/minimal.cpp")
main_lines = example[example.index("int main"):].count("\n")
if main_lines >= 15:
    errors.append(f"examples/minimal.cpp: main has {main_lines} lines, not under 15")

folders = "docs|murosimf|examples|scripts|models|motions|scenes|servos|tests|benchmarks|apps"
for page in [root / "README.md", *sorted((root / "docs").glob("*.md"))]:
    text = page.read_text()
    names = set(re.findall(rf"`((?:{folders})/[\w./]+)`", text))
    links = set(re.findall(r"\]\(([\w./]+)\)", text))
    missing = {name for name in names if "NAME" not in name and not (root / name).exists()}
    missing |= {link for link in links if not (page.parent / link).exists()}
    for name in sorted(missing):
        errors.append(f"{page.name}: names '{name}', which is not there")

for error in errors:
    print(error)
sys.exit(1 if errors else 0)
