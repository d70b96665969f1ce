"""Kinematics and dynamics of a robot's model for any joint positions, apart from what it does in the scene.

`q`, `v`, `a` are (joints,) or (n, joints) in the order of `robot.joints`, [rad | m] and rates; with n rows the results have n
rows, too. Everything stands in the frame of the base, which rests; rotors of motors are left out. Source: Featherstone, Rigid
Body Dynamics Algorithms, 2008.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._core import Kinematics as CoreKinematics
from ._values import Array, numbers, triple
from .errors import InputError


class Frames(NamedTuple):
    """Of one object, or for n rows of joint positions, in the frame of the base."""

    position: Array  #: (3,) or (n, 3) [m]
    quaternion: Array  #: (4,) or (n, 4) w first


class Kinematics:
    """Forward kinematics, Jacobians, mass matrices and inverse dynamics. `q`, `v`, `a` are (joints,) or (n, joints) in the order
    of `robot.joints`, [rad | m] and rates; the frame of the base, which rests, is that of all results."""

    def __init__(self, core: CoreKinematics) -> None:
        self._core = core
        self.joints: int = core.joints()  #: how many

    @property
    def mass(self) -> float:
        """[kg] of the whole robot"""
        return self._core.mass()

    def fk(self, q: ArrayLike, object: str) -> Frames:
        """Where an object of the robot is. Raises UnknownName."""
        rows, one = self._rows(q, "q")
        poses = self._shaped(self._core.poses(rows.ravel(), object), one, 7)
        return Frames(poses[..., :3], poses[..., 3:])

    def center_of_mass(self, q: ArrayLike) -> Array:
        """(3,) or (n, 3) [m] of the whole robot"""
        rows, one = self._rows(q, "q")
        return self._shaped(self._core.centers_of_mass(rows.ravel()), one, 3)

    def jacobian(self, q: ArrayLike, object: str) -> Array:
        """(6, joints) or (n, 6, joints): what joint rates make of the object's origin: linear velocity [m/s], then angular
        [rad/s]."""
        rows, one = self._rows(q, "q")
        return self._shaped(self._core.jacobians(rows.ravel(), object), one, 6, self.joints)

    def mass_matrix(self, q: ArrayLike) -> Array:
        """(6 + joints, 6 + joints), or n of them: the base's angular velocity, its linear velocity, then the joints."""
        rows, one = self._rows(q, "q")
        side = 6 + self.joints
        return self._shaped(self._core.mass_matrices(rows.ravel()), one, side, side)

    def rnea(self, q: ArrayLike, v: ArrayLike, a: ArrayLike, gravity: ArrayLike = (0, 0, -9.81)) -> Array:
        """(joints,) or (n, joints) [N m | N] that the motion takes of the joints, the base held; `gravity` [m/s^2] in the
        base's axes."""
        rows, one = self._rows(q, "q")
        rates, accelerations = (self._rows(row, name)[0] for row, name in ((v, "v"), (a, "a")))
        if not rows.shape == rates.shape == accelerations.shape:
            raise InputError(f"q, v and a have different shapes: {rows.shape}, {rates.shape}, {accelerations.shape}")
        result = self._core.inverse_dynamics(rows.ravel(), rates.ravel(), accelerations.ravel(), triple(gravity, "gravity"))
        return self._shaped(result, one, self.joints)

    def _rows(self, values: ArrayLike, name: str) -> tuple[Array, bool]:
        rows = numbers(values)
        if rows.ndim not in (1, 2) or rows.shape[-1] != self.joints:
            raise InputError(f"{name} takes ({self.joints},) or (n, {self.joints}) numbers, not {rows.shape}")
        return np.atleast_2d(rows), rows.ndim == 1

    @staticmethod
    def _shaped(result: Array, one: bool, *shape: int) -> Array:
        return result.reshape(shape if one else (-1, *shape))
