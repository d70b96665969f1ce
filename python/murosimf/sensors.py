"""What robots feel and see: the last sample of a sensor, the last picture of a camera."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ._core import Camera as CoreCamera
from ._core import Sensor as CoreSensor
from ._values import Array, nearest
from .errors import InputError
from .picture import Picture

Handle = TypeVar("Handle")


class _Device:
    """What sensors and cameras have in common."""

    def __init__(self, core: CoreSensor | CoreCamera) -> None:
        self._device = core

    @property
    def name(self) -> str:
        """In the file of its robot."""
        return self._device.name

    @property
    def period(self) -> float:
        """[s] from sample to sample, from picture to picture"""
        return self._device.period

    @property
    def time(self) -> float:
        """[s] when the last sample that has arrived was taken, when the exposure of the last picture began"""
        return self._device.time()


class Sensor(_Device):
    """The last sample that has arrived, by output: `robot.sensors["imu"]["gyroscope"]`."""

    def __init__(self, core: CoreSensor) -> None:
        super().__init__(core)
        self._core = core
        self._values: Array = core.values()
        self._outputs = {name: (begin, size) for name, _, _, begin, size in core.outputs()}
        #: unit of each output, SI
        self.units: dict[str, str] = {name: unit for name, unit, _, _, _ in core.outputs()}

    @property
    def type(self) -> str:
        """ "imu" """
        return self._core.type

    @property
    def frame(self) -> str:
        """The object that it is mounted on; "": none in particular."""
        return self._core.frame

    @property
    def samples(self) -> int:
        """How many have arrived so far; 0: none, and values are 0 or as at rest."""
        return self._core.samples()

    @property
    def values(self) -> Array:
        """Of all outputs, one after the other; live, NaN: nothing seen."""
        return self._values

    def __getitem__(self, output: str) -> Array:
        """Of one output; live. Raises UnknownName."""
        if output not in self._outputs:
            raise nearest(output, list(self._outputs), f"output of sensor '{self.name}'")
        begin, size = self._outputs[output]
        return self._values[begin : begin + size]

    def read(self) -> dict[str, Array]:
        """A copy of the last sample: numbers by output."""
        return {name: self[name].copy() for name in self._outputs}

    def keep(self, samples: int = 1000) -> None:
        """Keeps so many of the samples that arrive from now on, in calls of `step` and `run`, for `history`; one a step at
        most."""
        if samples < 1:
            raise InputError(f"{samples} samples: at least 1")
        self._core.keep(samples)

    @property
    def history(self) -> NDArray[np.void]:
        """(n,) records of the samples that keep() has kept, a copy: `time` [s], and the numbers of each output. A reset, or a
        state from before, begins anew. Raises StateError if none are kept."""
        numbers = self._core.history()
        fields: list[Any] = [(name, np.float64, (size,)) for name, (_, size) in self._outputs.items()]
        records = np.empty(len(numbers), dtype=[("time", np.float64), *fields])
        records["time"] = numbers[:, 0]
        for name, (begin, size) in self._outputs.items():
            records[name] = numbers[:, 1 + begin : 1 + begin + size]
        return records

    def __repr__(self) -> str:
        outputs = ", ".join(f"{name} ({size}) [{self.units[name]}]" for name, (_, size) in self._outputs.items())
        return f"sensor '{self.name}' ({self.type}, {1 / self.period:g} Hz): {outputs}"


class Camera(_Device):
    """Draws from when it was asked for (`robot.cameras["head"]`), or from the start on, if it is always_on in its file."""

    def __init__(self, core: CoreCamera) -> None:
        super().__init__(core)
        self._core = core

    @property
    def pictures(self) -> int:
        """How many have come so far."""
        return self._core.pictures()

    def picture(self) -> Picture:
        """A copy of the last one, with the layers that the camera has."""
        return Picture(*self._core.picture(), names=self._core.labels())

    def __repr__(self) -> str:
        return f"camera '{self.name}' ({1 / self.period:g} Hz)"


class ByName(Mapping[str, Handle]):
    """Sensors or cameras of a robot by name."""

    def __init__(self, names: Callable[[], list[str]], make: Callable[[str], Handle]) -> None:
        self._names, self._make = names, make

    def __getitem__(self, name: str) -> Handle:
        return self._make(name)

    def __contains__(self, name: object) -> bool:
        return name in self._names()

    def __iter__(self) -> Iterator[str]:
        return iter(self._names())

    def __len__(self) -> int:
        return len(self._names())

    def __repr__(self) -> str:
        return ", ".join(self._names()) or "none"


