"""Joints of a robot: arrays with a number for each, and their names."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ._core import Robot as CoreRobot
from ._values import Array, nearest
from .errors import UnknownName

if TYPE_CHECKING:
    _Base = np.ndarray[tuple[int], np.dtype[np.float64]]
else:
    _Base = np.ndarray


class JointArray(_Base):
    """An array of NumPy, (joints,), that takes names of joints, too: `target["j_l_shin"] = 0.4`.

    It is live: it shows the robot now, and what is written to it goes to the robot with the next call.
    """

    _numbers: dict[str, int] | None

    def __array_finalize__(self, array: Any) -> None:
        self._numbers = None  # of slices and results, which are plain arrays

    def _number(self, name: str) -> int:
        known = self._numbers
        if known is None:
            raise UnknownName(f"'{name}': only the robot's own array knows its joints by name, not what is made of it")
        if name not in known:
            raise nearest(name, list(known), "joint")
        return known[name]

    def __getitem__(self, key: Any) -> Any:
        return super().__getitem__(self._number(key) if type(key) is str else key)

    def __setitem__(self, key: Any, value: Any) -> None:
        super().__setitem__(self._number(key) if type(key) is str else key, value)


def joint_array(row: Array, numbers: dict[str, int]) -> JointArray:
    array: JointArray = row.view(JointArray)
    array._numbers = numbers
    return array


@dataclass(frozen=True)
class Joint:
    """What does not change of a joint."""

    name: str
    unit: str  #: "rad" or "m"
    lower: float  #: [unit] range; infinite if the model has none
    upper: float  #: [unit]


class Joints(Mapping[str, Joint]):
    """Joints of a robot by name, in the order of its arrays."""

    def __init__(self, core: CoreRobot) -> None:
        self._joints = {name: Joint(name, unit, lower, upper) for name, unit, lower, upper in core.joints()}
        self.numbers: dict[str, int] = {name: i for i, name in enumerate(self._joints)}  #: name to place in the arrays

    @property
    def names(self) -> list[str]:
        """In the order of the arrays."""
        return list(self._joints)

    @property
    def lower(self) -> Array:
        """(joints,) [rad | m]"""
        return np.array([joint.lower for joint in self._joints.values()])

    @property
    def upper(self) -> Array:
        """(joints,) [rad | m]"""
        return np.array([joint.upper for joint in self._joints.values()])

    def __getitem__(self, name: str) -> Joint:
        if name not in self._joints:
            raise nearest(name, self.names, "joint")
        return self._joints[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._joints)

    def __len__(self) -> int:
        return len(self._joints)

    def __repr__(self) -> str:
        lines = [f"{len(self)} joints"]
        for joint in self._joints.values():
            span = "" if math.isinf(joint.lower) else f"  {joint.lower:+.2f} to {joint.upper:+.2f}"
            lines.append(f"  {self.numbers[joint.name]:3}  {joint.name:24}[{joint.unit}]{span}")
        return "\n".join(lines)
