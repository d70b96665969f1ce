"""Many worlds of one scene, stepped together by a pool of threads: what learning needs."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from os import PathLike

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._values import Array, Assignments, triple
from .errors import InputError
from .scene import Scene, _options


class Batch:
    """World i begins with the seed of the scene plus i, and gives the states that a Scene with that seed gives alone, bit for
    bit, for any number of threads. Arrays have a row for each world, of its first robot, and are live: each call that steps or
    resets renews them."""

    def __init__(self, scene: str | PathLike[str], n: int, *, threads: int = 1, seed: int | None = None, set: Assignments = (),
                 events: Mapping[float, Assignments] | Iterable[str] = (), lenient: bool = False, cameras: bool = True) -> None:
        """Of a file or name, as Scene; `threads` is what all worlds share."""
        self._core = _core.open_batch(os.fspath(scene), n, _options(seed, set, events, (), 1, False, lenient, cameras), threads)
        self._worlds: dict[int, Scene] = {}

    def __len__(self) -> int:
        return self._core.size()

    @property
    def joints(self) -> int:
        """How many a robot has."""
        return self._core.joints()

    def __getitem__(self, number: int) -> Scene:
        """One of the worlds, as a scene, which it shares."""
        if not -len(self) <= number < len(self):
            raise IndexError(f"world {number} of a batch of {len(self)}")
        number %= len(self)
        if number not in self._worlds:
            self._worlds[number] = Scene._of(self._core.world(number))
        return self._worlds[number]

    def step(self, steps: int = 1) -> None:
        """Other threads of Python go on meanwhile, and Ctrl-C ends it between two steps of all worlds."""
        self._core.step(steps)

    def reset(self, which: ArrayLike | None = None, *, seed: int | None = None) -> None:
        """Those worlds whose entry of `which` (n,) is true, or all; with `seed` plus their number, if given."""
        chosen = np.empty(0, np.uint8)
        if which is not None:
            chosen = np.ascontiguousarray(np.asarray(which, dtype=bool), dtype=np.uint8)
            if chosen.shape != (len(self),):
                raise InputError(f"reset takes an entry for each of {len(self)} worlds, not an array of shape {chosen.shape}")
        self._core.reset(seed, chosen)

    @property
    def joint_position(self) -> Array:
        """(n, joints) [rad | m]"""
        return self._core.joint_position()

    @property
    def joint_velocity(self) -> Array:
        """(n, joints) [rad/s | m/s]"""
        return self._core.joint_velocity()

    @property
    def joint_target(self) -> Array:
        """(n, joints) [rad | m] as the robots have them, by their controllers or from here: all go to the robots with the next
        step, if one was changed."""
        return self._core.joint_target()

    @joint_target.setter
    def joint_target(self, targets: ArrayLike) -> None:
        self.joint_target[:] = targets

    @property
    def position(self) -> Array:
        """(n, 3) [m] of the base, world frame"""
        return self._core.base_pose()[:, :3]

    @property
    def quaternion(self) -> Array:
        """(n, 4) of the base, w first"""
        return self._core.base_pose()[:, 3:]

    @property
    def linear_velocity(self) -> Array:
        """(n, 3) [m/s] of the base's origin, world axes"""
        return self._core.base_velocity()[:, :3]

    @property
    def angular_velocity(self) -> Array:
        """(n, 3) [rad/s] of the base, world axes"""
        return self._core.base_velocity()[:, 3:]

    @property
    def ball_position(self) -> Array:
        """(n, 3) [m] of the center of the ball, world frame. Raises UnknownName if there is none."""
        return self._core.ball_position()

    @property
    def ball_velocity(self) -> Array:
        """(n, 3) [m/s] of the ball, world axes. Raises UnknownName if there is none."""
        return self._core.ball_velocity()

    def push(self, world: int, object: str = "", *, force: ArrayLike, duration: float, moment: ArrayLike = (0, 0, 0)) -> None:
        """Of the robot of one world, as `Scene.robot.push`; the world stays one of the batch."""
        if not -len(self) <= world < len(self):
            raise IndexError(f"world {world} of a batch of {len(self)}")
        self._core.push(world % len(self), object, triple(force, "a force"), duration, triple(moment, "a moment"))

    @property
    def fallen(self) -> NDArray[np.bool_]:
        """(n,) those that lie"""
        return self._core.fallen()

    def __repr__(self) -> str:
        return f"batch of {len(self)} worlds, {self.joints} joints each"
