"""Sweeps beyond one process: a manifest that lists all runs, shards that any scheduler runs, and one table in the end."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

from ._program import json_of, output_of
from ._values import Assignments
from .errors import InputError, StateError
from .studies import sweep_arguments


class Experiment:
    """The runs of a manifest (docs/series.md), which stands in a file that all machines see. What is done is beside it, in a
    folder of its name: `push.json`, `push.runs`. Runs that were killed are repeated; the table is a function of the manifest and
    the finished runs, of any shard."""

    def __init__(self, manifest: str | PathLike[str]) -> None:
        """Raises InputError: there is no such file, it is no manifest, or it was changed since it was written."""
        self.manifest = Path(manifest).absolute()
        json_of(["sweep", str(self.manifest), "--merge"])  # which checks it
        import json  # it takes milliseconds to import

        #: {"seed": 3, "set": ["walker.command.0=0.1"]} of each run
        self.runs: list[dict[str, Any]] = json.loads(self.manifest.read_text())["runs"]

    @classmethod
    def plan(cls, manifest: str | PathLike[str], scene: str | PathLike[str], *, results: Iterable[str],
             seeds: str | Iterable[int] = "", grid: Mapping[str, Sequence[Any]] | None = None, duration: float | None = None,
             set: Assignments = ()) -> Experiment:
        """Writes a manifest of the runs that sweep() would do with these, and runs nothing. The same again changes nothing.
        Raises InputError: the scene, a value or a result is wrong, or the file is there and is another experiment's."""
        arguments = sweep_arguments(scene, results=results, seeds=seeds, grid=grid, duration=duration, set=set)
        output_of([*arguments, "--manifest", os.fspath(manifest)])
        return cls(manifest)

    def run(self, shard: str | None = None, *, threads: int | None = None) -> None:
        """Does what is missing, `threads` runs at a time: all of it; of `shard` "3/8" every eighth run from the third on; of
        "any/8" those eighths in turn that no process works on. Waits for a process that works on the same shard. Raises
        InputError if files of the scene are not those of the manifest any more."""
        arguments = ["sweep", str(self.manifest), *(["--shard", shard] if shard is not None else [])]
        output_of([*arguments, *(["--threads", str(threads)] if threads is not None else [])])

    def table(self, *, partial: bool = False) -> dict[str, Any]:
        """As of sweep(): runs, and means with intervals. Raises StateError if runs are missing, unless it may be `partial`;
        InputError if a file of finished runs belongs to another manifest."""
        table: dict[str, Any] = json_of(["sweep", str(self.manifest), "--merge"])
        missing = len(self) - len(table["runs"])
        if missing > 0 and not partial:
            raise StateError(f"{missing} of {len(self)} runs of '{self.manifest}' are missing")
        return table

    @property
    def missing(self) -> int:
        """How many runs are not done."""
        return len(self) - len(self.table(partial=True)["runs"])

    def shards(self, count: int) -> list[str]:
        """ "1/8" to "8/8" for run(), for a scheduler."""
        if count < 1:
            raise InputError(f"an experiment has 1 shard at least, not {count}")
        return [f"{number}/{count}" for number in range(1, count + 1)]

    def __len__(self) -> int:
        return len(self.runs)

    def __repr__(self) -> str:
        return f"experiment '{self.manifest}': {len(self) - self.missing} of {len(self)} runs are done"


def run_shard(manifest: str, shard: str, threads: int = 1) -> str:
    """A task for schedulers: to run it again, also while an earlier try goes on, does nothing twice. Returns the shard."""
    Experiment(manifest).run(shard, threads=threads)
    return shard
