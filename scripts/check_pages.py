#!/usr/bin/env python3
"""Runs the commands of the pages word for word and compares what they print with what the pages quote.

    scripts/check_pages.py [--build build/release] [--update] [--list] PAGE...

A PAGE is a Markdown file, or a folder of scenes or examples whose header comments are read. Commands stand in blocks,
indented or fenced; the lines after a command are what it prints. A line `...` in a quote leaves lines out, spaces do
not count, and neither do wall times. --update writes what is printed now in the place of quoted lines that differ.
Every page has a scratch folder of its own with copies of the repository's data, and the build folder on its PATH and as
build/release.

Comments of HTML before a block, which no reader of the page sees, change how it is run. Words in brackets choose those
commands of the block that begin so.

    <!-- not run (scripts/test): takes half an hour -->           a command that no test can run, and why
    <!-- run with (murosimf run walk): --duration 2 -->           options that make it cheaper, added or replaced
    <!-- each after: murosimf run walk -->                        lines are options; this command stands before each
    <!-- needs (murosimf check): examples/robot.urdf -->          is not run where that is missing
    <!-- before: cp scenes/walk.toml mine.toml -->                what a reader has done before
    <!-- append to: mine.toml -->                                 the block is (a part of) this file
    <!-- then: murosimf run mine.toml -->                        what proves that file right
    <!-- output of: murosimf list levels -->                      the block is what this prints
    <!-- output of (exit 2): murosimf run nosuch -->              the same of a command that fails
    <!-- code of: murosimf/runtime/simulation.cpp -->             C++ of this source, apart from comments and spaces
    <!-- code of no source: how users begin one -->               C++ that is nowhere, and why
    <!-- figures vary: they depend on the driver -->              numbers in the quotes of this block are not compared
"""
import argparse
import difflib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
DATA = ["datasets", "docs", "examples", "lenses", "models", "motions", "murosimf/control_software", "parts", "python", "scenes",
        "servos", "tests/data", "tests/fuzz/seeds"]
COMMAND = re.compile(r"(murosimf\w*|example_\w+|build/release/\S+|scripts/\S+|"
                     r"cmake|ctest|python3|pip|pre-commit|export|xacro)(?= |$)")
MARK = re.compile(r"\s*<!-- (not run|run with|each after|needs|before|append to|then|output of|code of no source|code of|"
                  r"figures vary)"
                  r"(?: \((.*?)\))?: (.*) -->$")
OPTIONS = re.compile(r"(--\S+ (?:'[^']*'|\S+) ?)+")
# What a machine may lack: such a command counts as not run.
LACKS = re.compile(r"no pictures by OpenGL|needs the program gnuplot|cannot run 'ffmpeg'|built without|in this build")
# What differs from run to run and from machine to machine.
VARIES = [
    (re.compile(r"\b[\d.]+ us\b"), "# us"),
    (re.compile(r"simulated in [\d.]+ s: [\d.]+ times"), "simulated in # s: # times"),
    (re.compile(r"\(LLVM [\d.]+, \d+ bits\)"), "(LLVM #, # bits)"),
    (re.compile(r"\b[\d.]+ of the cost"), "# of the cost"),
    (re.compile(r" at 127\.0\.0\.1:\d+$"), " at 127.0.0.1:#"),  # a client
    (re.compile(r"^([a-z]+_[a-z]+ \S+) \d+ \d+\.\d\d (?=\d)"), r"\1 # # "),  # rows of murosimf compare --details
    (re.compile(r"^( *[a-z]+_[a-z]+ +cost) \d+\.\d\d "), r"\1 # "),  # of its verdicts
]
TIME_LIMIT = 300  # [s] of one command
# A block in C or C++: a statement, or a line that opens a block of code; TOML, Python and shells have none of them.
CODE = re.compile(r"^(?!\w[\w.-]* = )[^#\n]*(?:;|[)\w] \{|\{[^\"=]*\})(?:\s*(?://|/\*).*)?$", re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


class Block:
    """Consecutive lines of code of a page, and the marks before them."""

    def __init__(self, first, lines, marks):
        self.first, self.lines, self.marks = first, lines, marks

    def mark(self, kind, command=""):
        """What the mark of this kind says of the command, or None."""
        for known, words, text in self.marks:
            if known == kind and (not words or kind == "output of" or command.startswith(words)):
                return text
        return None

    def all(self, kind):
        return [text for known, _, text in self.marks if known == kind]


def goes_on(lines, i, indent):
    """Whether line i belongs to the indented block above it: an empty one does if another one of the block follows."""
    at = i if lines[i].strip() else i + 1
    return at < len(lines) and lines[at].startswith(indent)


def blocks_of(lines, indent):
    """Fenced and indented blocks; of a comment of a source file, lines with the indent."""
    blocks, marks, i = [], [], 0
    while i < len(lines):
        mark = MARK.match(lines[i])
        first = i
        if mark:
            marks.append(mark.groups())
            i += 1
            continue
        if lines[i].startswith("```"):
            i += 1
            while i < len(lines) and not lines[i].startswith("```"):
                i += 1
            blocks.append(Block(first + 1, lines[first + 1 : i], marks))
            marks = []
        elif lines[i].startswith(indent) and lines[i].strip():
            while i + 1 < len(lines) and goes_on(lines, i + 1, indent):
                i += 1
            blocks.append(Block(first, [line[len(indent):] for line in lines[first : i + 1]], marks))
            marks = []
        elif lines[i].strip():
            marks = []
        i += 1
    return blocks


class Call:
    """A command of a page, and the numbers of the lines that quote what it prints."""

    def __init__(self, block, line, written, text, exit_code=0):
        self.block, self.line, self.written, self.text, self.exit_code = block, line, written, text, exit_code
        self.quote = []


def options_changed(command, options):
    """The command with these options, which replace those of the same names."""
    words = re.findall(r"--\S+(?: [^-\s]\S*)?", options)
    for word in words:
        name = word.split()[0]
        if re.search(rf"{name} \S+", command):
            command = re.sub(rf"{name} \S+", lambda _, word=word: word, command, count=1)
        else:
            place = re.match(r"\S+(?: [a-z]\S*)*", command).end()
            command = f"{command[:place]} {word}{command[place:]}"
    return command


def bare(code):
    """C++ without comments and spaces."""
    return re.sub(r"\s+", "", COMMENT.sub("", code))


def misquoted_code(lines, source):
    """The first line of a block up to which the source does not have it, or None. `...` leaves anything out."""
    text, pattern = bare(source), ""
    for line in lines:
        pattern += ".*?".join(re.escape(bare(piece)) for piece in COMMENT.sub("", line).split("..."))
        if not re.search(pattern, text, re.DOTALL):
            return line
    return None


def calls_of(block):
    """Commands of a block, in the order of the page."""
    if block.mark("code of") or block.mark("code of no source"):
        return []
    quoting = next(((words, text) for kind, words, text in block.marks if kind == "output of"), None)
    if quoting:
        exit_code = int(quoting[0].split()[1]) if quoting[0] else 0
        call = Call(block, block.first, quoting[1], quoting[1], exit_code)
        call.quote = [block.first + k for k, line in enumerate(block.lines) if line.strip()]
        return [call]
    calls, i = [], 0
    while i < len(block.lines):
        line, number = block.lines[i], block.first + i
        base = block.mark("each after", line)
        if base and line.startswith("--"):
            written = OPTIONS.match(line).group().rstrip()
            calls.append(Call(block, number, written, f"{base} {written}"))
        elif COMMAND.match(line):
            while line.endswith("\\") and i + 1 < len(block.lines):
                i += 1
                line = f"{line[:-1].rstrip()} {block.lines[i].strip()}"
            calls.append(Call(block, number, line, line))
        elif calls and not base and line.strip() and not line.startswith("#"):
            calls[-1].quote.append(block.first + i)
        i += 1
    for call in calls:
        extra = block.mark("run with", call.written)
        if extra:
            call.text = options_changed(call.text, extra)
    return calls


class Scratch:
    """A folder with copies of the repository's data, in which commands run as they do beside the sources."""

    def __init__(self, build):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="pages."))
        for name in DATA:
            if (ROOT / name).is_dir():
                shutil.copytree(ROOT / name, self.folder / name)
        (self.folder / "build").mkdir()
        (self.folder / "build" / "release").symlink_to(build)
        self.environment = {**os.environ, "PATH": f"{build}:{os.environ['PATH']}", "COLUMNS": "100"}
        self.known = {}  # results by command, for quotes of what has run already
        self.seconds = {}  # by command

    def run(self, command):
        """Exit code and lines of both outputs."""
        began = time.monotonic()
        try:
            done = subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=self.folder, env=self.environment,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, errors="replace", timeout=TIME_LIMIT)
            lines = done.stdout.replace(f"{ROOT}/", "").split("\n")
            result = done.returncode, [line.rstrip() for line in lines if line.strip()]
        except subprocess.TimeoutExpired:
            result = -1, [f"not finished after {TIME_LIMIT} s"]
        self.known[command] = result
        self.seconds[command] = time.monotonic() - began
        return result

    def remove(self):
        shutil.rmtree(self.folder)


def plain(line, vary):
    """A line without what may differ."""
    line = " ".join(line.split())
    for pattern, word in VARIES:
        line = pattern.sub(word, line)
    return re.sub(r"-?\d+(\.\d+)?", "#", line) if vary else line


def misquoted(quote, printed, vary):
    """Places in the quote that are not what was printed, each with the line that it should be, or None."""
    errors, at, anywhere = [], 0, False
    plainly = [plain(line, vary) for line in printed]
    for place, line in enumerate(quote):
        if line.strip() == "...":
            anywhere = True
            continue
        wanted = plain(line, vary)
        end = len(printed) if anywhere else min(at + 1, len(printed))
        found = next((k for k in range(at, end) if plainly[k] == wanted), None)
        if found is None:
            rest = plainly[at:] if anywhere else plainly[at : at + 1]
            near = difflib.get_close_matches(wanted, rest, 1, 0.6 if anywhere else 0)
            found = at + rest.index(near[0]) if near else None
            errors.append((place, printed[found] if near else None))
        if found is not None:
            at, anywhere = found + 1, False
    if not errors and quote and not anywhere and at < len(printed):
        errors.append((len(quote), printed[at]))  # the quote ends early, and no "..." says so
    return errors


class Page:
    """A file with commands."""

    def __init__(self, path):
        self.path, self.name = path, str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else str(path)
        self.raw = path.read_text().split("\n")
        self.comment = {".toml": "#", ".cpp": "//"}.get(path.suffix, "")
        lines = self.raw
        if self.comment:  # the comment at the head of the file
            size = next((k for k, line in enumerate(lines) if not line.startswith(self.comment)), len(lines))
            lines = [line[len(self.comment):] for line in lines[:size]]
        self.lines = lines
        self.blocks = blocks_of(lines, "  " if self.comment else "    ")
        if self.comment:
            for block in self.blocks:
                block.lines = [line.lstrip() for line in block.lines]

    def replace(self, number, line):
        head = re.match(rf"{self.comment}\s*", self.raw[number]).group()
        self.raw[number] = head + line

    def save(self):
        self.path.write_text("\n".join(self.raw))


class Check:
    """Runs pages, counts and reports."""

    def __init__(self, options):
        self.options, self.ran, self.left_out, self.errors, self.updated = options, [], [], 0, 0
        self.scratch = Scratch(options.build)

    def complain(self, page, number, text):
        self.errors += 1
        print(f"{page.name}:{number + 1}: {text}")

    def why_not(self, call):
        """Why the page says that a command is not run."""
        reason = call.block.mark("not run", call.written)
        needed = call.block.mark("needs", call.written)
        if not reason and needed and not (self.scratch.folder / needed).exists() and not shutil.which(needed):
            reason = f"needs {needed}, which is not there"
        return reason

    def page(self, page):
        for block in page.blocks:
            self.unseen(page, block, "before")
            for name in block.all("append to"):
                with (self.scratch.folder / name).open("a") as file:
                    file.write("\n".join(["", *block.lines, ""]))
            self.unseen(page, block, "then")
            self.code(page, block)
            for call in calls_of(block):
                self.call(page, call)
        if self.options.update:
            page.save()

    def unseen(self, page, block, kind):
        for command in block.all(kind) if not self.options.list else []:
            code, printed = self.scratch.run(command)
            if code:
                self.complain(page, block.first, f"'{command}', {kind} this block, fails: {' '.join(printed[-3:])}")

    def code(self, page, block):
        """C++ of a page stands in a source, word for word."""
        name = block.mark("code of")
        if name:
            file = ROOT / name
            wrong = misquoted_code(block.lines, file.read_text()) if file.is_file() else block.lines[0]
            if wrong is not None:
                self.complain(page, block.first, f"{name} does not have, or not there: {wrong.strip()}")
        elif page.path.suffix == ".md" and not block.marks and not calls_of(block) and CODE.search("\n".join(block.lines)):
            self.complain(page, block.first, "C++ without a mark `code of: FILE` that says where it stands")

    def call(self, page, call):
        reason = self.why_not(call)
        if self.options.list or reason:
            if reason:
                self.left_out.append(f"{page.name}:{call.line + 1}: {call.written}: {reason}")
            else:
                self.ran.append(call)
            return
        code, printed = self.scratch.known.get(call.text) or self.scratch.run(call.text)
        lacking = [line for line in printed if LACKS.search(line)]
        if code and code != call.exit_code and lacking:
            self.left_out.append(f"{page.name}:{call.line + 1}: {call.written}: {lacking[0]}")
            return
        self.ran.append(call)
        if code != call.exit_code:
            said = " ".join(printed[-3:])
            self.complain(page, call.line, f"'{call.text}' ends with {code}, not {call.exit_code}: {said}")
        elif not (lacking and code == 0):  # what is drawn or not may change the lines
            self.compare(page, call, printed)

    def compare(self, page, call, printed):
        quote = [page.lines[number].strip() for number in call.quote]
        for place, line in misquoted(quote, printed, call.block.mark("figures vary") is not None):
            if place == len(quote):
                self.complain(page, call.quote[-1], f"'{call.text}' prints more, and no '...' says so: {line}")
            elif line is not None and self.options.update:
                page.replace(call.quote[place], line)
                self.updated += 1
            else:
                self.complain(page, call.quote[place],
                              f"quotes    {quote[place]}\n    but '{call.text}' prints    {line}")

    def words(self, page):
        """Commands named in a sentence: the subcommand and its options exist."""
        for number, line in enumerate(page.lines):
            for words in re.findall(r"`murosimf ([a-z][^`]*)`", line):
                name = words.split()[0]
                ask = f"murosimf {name} --help"
                code, text = self.scratch.known.get(ask) or self.scratch.run(ask)
                text = "\n".join(text)
                unknown = [option for option in re.findall(r"--[a-z-]+", words) if option not in text]
                if code or unknown:
                    what = f"option: {unknown[0]}" if unknown else "command"
                    self.complain(page, number, f"`murosimf {words}`: no such {what}")

    def report(self):
        for line in self.left_out:
            print(f"not run: {line}")
        counts = f"{len(self.ran)} commands run, {len(self.left_out)} not"
        print(f"{counts}, {self.errors} errors, {self.updated} lines updated")
        slowest = sorted(self.scratch.seconds.items(), key=lambda item: -item[1])
        for command, seconds in slowest[:self.options.times]:
            print(f"{seconds:8.1f} s  {command}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="folder of the programs")
    parser.add_argument("--update", action="store_true", help="rewrite quoted lines that are printed otherwise now")
    parser.add_argument("--times", type=int, default=0, metavar="N", help="say which N commands took longest")
    parser.add_argument("--list", action="store_true", help="run nothing, only count")
    parser.add_argument("pages", type=pathlib.Path, nargs="*", help="default: all")
    options = parser.parse_args()
    options.build = options.build.resolve()
    everything = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(ROOT.glob("docs/*.md")),
                  ROOT / "scenes", ROOT / "examples"]
    paths = [path.resolve() for path in options.pages] or everything
    files = [file for path in paths for file in (sorted(path.glob("*.[ct][po][pm]*")) if path.is_dir() else [path])]
    errors = 0
    for path in paths:
        check = Check(options)
        try:
            for file in [file for file in files if file == path or (path.is_dir() and file.parent == path)]:
                page = Page(file)
                if not options.list:
                    check.words(page)
                check.page(page)
        finally:
            check.scratch.remove()
        print(f"{path.name}: ", end="")
        check.report()
        errors += check.errors
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
