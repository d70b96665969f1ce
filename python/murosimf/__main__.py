"""python -m murosimf demo [FILE.png | --web], python -m murosimf --version; all else is the program's: python -m murosimf run
walk."""

from __future__ import annotations

import os
import sys

from . import __version__
from ._program import environment, program
from .demo import demo
from .errors import Error


def main(arguments: list[str]) -> int:
    if arguments == ["--version"]:
        print(f"murosimf {__version__}")
        return 0
    try:
        if arguments[:1] == ["demo"]:
            files = [argument for argument in arguments[1:] if argument != "--web"]
            demo(files[0] if files else None, web="--web" in arguments)
            return 0
        if not arguments or arguments[0] in ("-h", "--help"):
            print(__doc__)
            return 0
        os.execve(program(), [program(), *arguments], environment())
    except Error as error:
        print(f"murosimf: {error}", file=sys.stderr)
        return 2


def entry() -> None:
    """The command `murosimf` of the package: the program itself."""
    os.execve(program(), [program(), *sys.argv[1:]], environment())


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
