"""The program `murosimf`, which comes with the package: studies run in processes of their own."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .errors import InputError, SimulationError, StateError


def program() -> str:
    """Its file: of the package; in a build folder that beside it; else that on the PATH."""
    here = Path(__file__).parent
    package = Path(os.path.abspath(here))  # in a build folder the files are links
    for file in (package / "bin" / "murosimf", package.parent.parent / "murosimf"):
        if file.is_file() and os.access(file, os.X_OK):
            return str(file)
    found = shutil.which("murosimf")
    if not found:
        raise StateError("the program murosimf is not here: it belongs in the folder bin of the package, or on the PATH")
    return found


def environment() -> dict[str, str]:
    """Of the program: classes in Python take this Python there, too, if it has a shared library (docs/python.md)."""
    library = Path(sysconfig.get_config_var("LIBDIR") or "", sysconfig.get_config_var("INSTSONAME") or "")
    if ".so" not in library.name or not library.is_file():
        return dict(os.environ)
    return {"MUROSIMF_PYTHON": sys.executable, "MUROSIMF_LIBPYTHON": str(library), **os.environ}


def output_of(arguments: Sequence[str]) -> str:
    """What the program prints. Raises InputError with its line for exit code 2, SimulationError for others but 0 and 1."""
    done = subprocess.run([program(), *arguments], capture_output=True, text=True, check=False, env=environment())
    if done.returncode not in (0, 1):
        line = done.stderr.strip().removeprefix("murosimf: ") or f"murosimf ended with {done.returncode}"
        raise (InputError if done.returncode == 2 else SimulationError)(line)
    return done.stdout


def json_of(arguments: Sequence[str]) -> Any:
    """What the program writes with `--json -`. Raises as output_of, and SimulationError where that is nothing."""
    text = output_of([*arguments, "--json", "-"])
    if not text.strip():
        raise SimulationError(f"murosimf {arguments[0]} wrote no result")
    return json.loads(text)
