"""Studies of whole runs: which level is adequate, what many seeds and values give, what is wrong with a robot. They run the
program of the package in processes of their own, and give what it writes as JSON (docs/series.md, docs/levels.md,
docs/robots.md)."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from typing import Any

from ._arguments import checked
from ._program import json_of
from ._values import Assignments, assignments, value_text


@checked
def compare(scene: str | PathLike[str], robot: str, *, levels: Iterable[str] = (), duration: float | None = None,
            seed: int | None = None, set: Assignments = (), repeat: int = 3) -> dict[str, Any]:
    """Runs a scene with the robot at each of the levels (all, if none is given), and says how far they are off the finest and
    what they cost: `compare("walk", "walker")["entries"]`. As `murosimf compare`."""
    arguments = ["compare", os.fspath(scene), "--entity", robot, "--repeat", str(repeat)]
    chosen = list(levels)
    if chosen:
        arguments += ["--levels", ",".join(chosen)]
    arguments += _common(duration, set)
    if seed is not None:
        arguments += ["--seed", str(seed)]
    result: dict[str, Any] = json_of(arguments)
    return result


@checked
def sweep(scene: str | PathLike[str], *, results: Iterable[str], seeds: str | Iterable[int] = "",
          grid: Mapping[str, Sequence[Any]] | None = None, duration: float | None = None, set: Assignments = (),
          threads: int | None = None, runs: str | PathLike[str] | None = None) -> dict[str, Any]:
    """Runs a scene for all seeds ("1..20" or numbers) and all combinations of `grid` ({"walker.command.0": [0.1, 0.2]}),
    `threads` at a time, and gives the numbers of `results` ("walker.distance") at the end of each run, with means and
    intervals. `runs`: a file in which each run is noted when it is done; a sweep that was ended goes on with what is in it. As
    `murosimf sweep`. On more than one machine: Experiment."""
    arguments = sweep_arguments(scene, results=results, seeds=seeds, grid=grid, duration=duration, set=set)
    if threads is not None:
        arguments += ["--threads", str(threads)]
    if runs is not None:
        arguments += ["--runs", os.fspath(runs)]
    table: dict[str, Any] = json_of(arguments)
    return table


def sweep_arguments(scene: str | PathLike[str], *, results: Iterable[str], seeds: str | Iterable[int] = "",
                    grid: Mapping[str, Sequence[Any]] | None = None, duration: float | None = None,
                    set: Assignments = ()) -> list[str]:
    """The command line of `murosimf sweep` for these runs."""
    arguments = ["sweep", os.fspath(scene), *_common(duration, set)]
    text = seeds if isinstance(seeds, str) else ",".join(str(seed) for seed in seeds)
    if text:
        arguments += ["--seeds", text]
    for path, values in (grid or {}).items():
        arguments += ["--grid", f"{path}=" + ",".join(value_text(value) for value in values)]
    for result in results:
        arguments += ["--result", result]
    return arguments


@checked
def check(model: str | PathLike[str], *, lenient: bool = False) -> dict[str, Any]:
    """Reads a robot file and gives what is in it, and what is wrong with it ("findings"). As `murosimf check`."""
    result: dict[str, Any] = json_of(["check", os.fspath(model), *(["--lenient"] if lenient else [])])
    return result


@checked
def fit_servo(logs: Iterable[str | PathLike[str]], out: str | PathLike[str], *, model: str = "m4", servo: str | None = None,
              prior: str | PathLike[str] | None = None, starts: int = 4, windows: float | None = None,
              seed: int = 1) -> dict[str, Any]:
    """Finds the numbers of a servo that explain recordings of it (files, or folders of them), writes them to the file `out`,
    which robots use like any other servo, and gives them ("parameters") with the error of each recording. As
    `murosimf fit-servo`, where the other arguments are explained; it takes seconds to minutes."""
    arguments = ["fit-servo", *(os.fspath(log) for log in logs), "--out", os.fspath(out), "--model", model,
                 "--starts", str(starts), "--seed", str(seed)]
    for option, value in (("--servo", servo), ("--prior", prior), ("--windows", windows)):
        if value is not None:
            arguments += [option, os.fspath(value) if isinstance(value, PathLike) else str(value)]
    result: dict[str, Any] = json_of(arguments)
    return result


@checked
def replay_servo(logs: Iterable[str | PathLike[str]], servo: str | PathLike[str]) -> dict[str, Any]:
    """How far a servo, a type or a file, is off on recordings ("mean_error_rad"). As `murosimf replay-servo`."""
    result: dict[str, Any] = json_of(["replay-servo", *(os.fspath(log) for log in logs), "--servo", os.fspath(servo)])
    return result


def _common(duration: float | None, set: Assignments) -> list[str]:
    arguments = [] if duration is None else ["--duration", repr(float(duration))]
    for each in assignments(set):
        arguments += ["--set", each]
    return arguments
