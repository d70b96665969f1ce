"""Runs as MCAP files for Foxglove, Lichtblick, PlotJuggler and `murosimf replay`, and their numbers read back."""

from __future__ import annotations

import os
from dataclasses import dataclass
from os import PathLike
from types import TracebackType
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ._core import Recorder as CoreRecorder
from ._core import Recording as CoreRecording
from ._values import Array

if TYPE_CHECKING:
    from .scene import Scene


class Recorder:
    """`with scene.record("run.mcap"): scene.run(10)`. The file begins with the next step and is whole after finish(), or at the
    end of the block."""

    def __init__(self, scene: Scene, file: str | PathLike[str], rate: float = 100.0) -> None:
        """`rate` [Hz] of poses, joints and contacts; sensors have their own. A reset ends what is recorded."""
        self._core = CoreRecorder(scene._core, os.fspath(file), rate)

    def finish(self) -> None:
        """Writes what is missing."""
        self._core.finish()

    def __enter__(self) -> Recorder:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.finish()


@dataclass(frozen=True)
class Series:
    """A number over time."""

    name: str  #: "walker.j_l_shin.joint_position"
    unit: str  #: SI
    times: Array  #: (n,) [s] ascending
    values: Array  #: (n,)


class Recording:
    """The numbers of a recording."""

    def __init__(self, file: str | PathLike[str]) -> None:
        """Raises InputError: no such file, no recording, or nothing of it can be read."""
        self._core = CoreRecording(os.fspath(file))

    @property
    def names(self) -> list[str]:
        """Of all numbers."""
        return self._core.names()

    def series(self, pattern: str = "") -> list[Series]:
        """Those that a pattern means, with * and ? in its parts; what is left out at the end means all below, "": all."""
        return [Series(*each) for each in self._core.series(pattern)]

    def __getitem__(self, name: str) -> Series:
        """The first that a pattern means."""
        return self.series(name)[0]

    def table(self, pattern: str = "") -> NDArray[np.void]:
        """(n,) records with the field `time` [s], and a field for each number of the pattern, which were recorded at the same
        times: `pandas.DataFrame(recording.table("walker.j_torso.position"))`. Raises InputError if they were not."""
        from .errors import InputError

        found = self.series(pattern)
        times = found[0].times
        for each in found:
            if not np.array_equal(each.times, times):
                raise InputError(f"'{each.name}' and '{found[0].name}' were recorded at different times: take them by series()")
        table = np.empty(len(times), dtype=[("time", np.float64)] + [(each.name, np.float64) for each in found])
        table["time"] = times
        for each in found:
            table[each.name] = each.values
        return table

    def __repr__(self) -> str:
        return f"recording of {len(self.names)} numbers"
