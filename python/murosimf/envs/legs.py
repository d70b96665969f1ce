"""Which joints of a robot are which of its legs', found by its kinematics, so that tasks serve any biped.

A joint moves a sole if its column of the sole's Jacobian is not zero; the angular part of the column is the joint's axis in the
frame of the base at joint angles 0, x forward, y left, z up.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._values import Array
from ..errors import InputError
from ..robot import Robot


@dataclass(frozen=True)
class Leg:
    joints: list[int]  #: all that move this sole and not the other one, from hip to foot
    pitch: list[int]  #: of them hip, knee and ankle that turn about y
    signs: Array  #: (3,) +1 if the axis of such a joint points to the left, else -1
    roll: list[tuple[int, float]]  #: hip and ankle that turn about x, and +1 if the axis points forward, else -1
    yaw: list[tuple[int, float]]  #: of the hip about z, +1 if the axis points up, else -1; empty if it has none


def leg_of(robot: Robot, sole: str, other: str) -> Leg:
    """Raises InputError if the chain to the sole has not three joints that pitch."""
    zero = np.zeros(len(robot.joints))
    columns, others = (robot.kinematics.jacobian(zero, name) for name in (sole, other))
    moved = np.linalg.norm(columns[3:], axis=0) > 0.5
    shared = np.linalg.norm(others[3:], axis=0) > 0.5
    joints = [int(joint) for joint in np.flatnonzero(moved & ~shared)]
    pitch = [joint for joint in joints if abs(columns[4, joint]) > 0.9]
    if len(pitch) != 3:
        raise InputError(f"the leg to '{sole}' has {len(pitch)} joints that pitch, not hip, knee and ankle")
    roll, yaw = ([(joint, float(np.sign(columns[axis, joint]))) for joint in joints if abs(columns[axis, joint]) > 0.9]
                 for axis in (3, 5))
    return Leg(joints, pitch, np.sign(columns[4, pitch]), roll, yaw)


def bend(posture: Array, leg: Leg, angle: Array | float) -> None:
    """Adds to `posture` (..., joints) [rad]: hip by -angle, knee by twice the angle, ankle by -angle: the sole stays level and
    below the hip, and the leg gets shorter if its links are equally long."""
    for joint, sign, share in zip(leg.pitch, leg.signs, (-1.0, 2.0, -1.0), strict=True):
        posture[..., joint] += sign * share * angle


def swing(posture: Array, leg: Leg, forward: Array, left: Array, turned: Array) -> None:
    """Adds to `posture` (n, all joints): the leg as a whole by angles (n,) [rad] forward and to the left, the sole kept level,
    and turned to the left; those for which it has joints."""
    hip, _, ankle = leg.pitch
    posture[:, hip] -= leg.signs[0] * forward
    posture[:, ankle] += leg.signs[2] * forward
    if len(leg.roll) == 2:
        for (joint, sign), share in zip(leg.roll, (1.0, -1.0), strict=True):
            posture[:, joint] += sign * share * left
    if len(leg.yaw) == 1:
        joint, sign = leg.yaw[0]
        posture[:, joint] += sign * turned
