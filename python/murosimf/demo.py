"""Something that moves at once: `python -m murosimf demo`."""

from __future__ import annotations

import os
from os import PathLike

from ._arguments import checked
from ._program import program
from .scene import Scene


def _save_picture(file: str | PathLike[str], seconds: float) -> None:
    scene = Scene("three_on_three")
    scene.run(seconds)
    scene.picture(eye=(0, -6, 3.5), width=960, height=540).save(file)
    print(f"wrote {os.fspath(file)}: the game after {scene.time:g} s")


@checked
def demo(file: str | PathLike[str] | None = None, *, seconds: float = 10.0, web: bool = False) -> None:
    """The game of three against three: in a window; with `web` in browsers (prints the address); with `file`, and where there is
    no window, as a picture (PNG) after so many simulated seconds."""
    if file is not None:
        _save_picture(file, seconds)
        return
    import subprocess  # it takes milliseconds to import

    shown = ["run", "three_on_three", "--web", "8080"] if web else ["view", "three_on_three"]
    ended = subprocess.run([program(), *shown], check=False).returncode
    if ended == 2 and not web:
        print("there is no window here: a picture instead; python -m murosimf demo --web shows the game in a browser")
        _save_picture("murosimf_demo.png", seconds)
