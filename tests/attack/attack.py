#!/usr/bin/env python3
"""Attacks every door of a run: nothing outside of what SECURITY.md allows is changed, no other file is read or written.

    tests/attack/attack.py --program build/release/murosimf              # some seconds
    tests/attack/attack.py --program build/release/murosimf --rounds 50  # as much chance as one has time for
    tests/attack/attack.py --program build/release/murosimf --all --door supervise

Prints what was tried and what came of it, and exits with 1 if something happened that must not. Files that nobody may touch are
watched by inotify, and, where strace is installed and may trace, everything that the run opens.
"""
import argparse
import faulthandler
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "python"))
import browsed  # noqa: E402
import connected  # noqa: E402
import supervised  # noqa: E402
from book import Book  # noqa: E402
from canaries import Trace, World, temporary  # noqa: E402

DOORS = {"supervise": supervised.Attack, "web": browsed.Attack, "others": connected.Attack}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", required=True)
    options.add_argument("--rounds", type=int, default=2, help="how much is left to chance")
    options.add_argument("--door", action="append", choices=DOORS, help="only this one; all of them otherwise")
    options.add_argument("--all", action="store_true", help="print each try")
    options.add_argument("--no-strace", action="store_true", help="watch by inotify alone (for sanitizers)")
    given = options.parse_args()
    faulthandler.dump_traceback_later(900, exit=True)
    traced = not given.no_strace and Trace.works()
    print("watched by inotify and strace" if traced else "watched by inotify")
    book = Book()
    program = str(Path(given.program).resolve())
    for name in given.door or DOORS:
        begin = time.monotonic()
        with temporary("attack_") as folder:
            DOORS[name](program, World(folder), book, given.rounds, traced).run()
        print(f"{name}: {time.monotonic() - begin:.1f} s")
    print(book.table(given.all))
    for error in book.errors:
        print(f"WRONG: {error}")
    print(f"{len(book.rows)} tries, {len(book.errors)} of them did what they must not")
    sys.exit(1 if book.errors else 0)


if __name__ == "__main__":
    main()
