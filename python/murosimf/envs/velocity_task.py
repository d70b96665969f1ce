"""To walk with a velocity that is asked for: what is seen and what is worth how much, for n robots at once.

Actions are targets of joints around the posture at the start. Rewards are those usual for such tasks (Rudin et al., Learning to
Walk in Minutes Using Massively Parallel Deep Reinforcement Learning, CoRL 2021, table 2): exponentials of the error of the
velocity, less for what shakes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._values import Array

control_steps = 20  # of the simulation, at 1 kHz: 50 Hz
reach = 0.5  # [rad] of a joint's target from the start, for an action of 1
fastest = (0.3, 0.1, 0.5)  # [m/s forward, m/s to the left, rad/s] commands are drawn up to these
tracking_width = 0.1  # [m/s] error at which the reward has fallen to exp(-1); of turning five times as much, in rad/s

Rows = NDArray[np.float32]


@dataclass
class Motion:
    """Of n robots, world axes."""

    joint_position: Array  #: (n, joints) [rad]
    joint_velocity: Array  #: (n, joints) [rad/s]
    quaternion: Array  #: (n, 4) of the base, w first
    linear_velocity: Array  #: (n, 3) [m/s] of the base
    angular_velocity: Array  #: (n, 3) [rad/s] of the base
    fallen: NDArray[np.bool_]  #: (n,)


def in_base_axes(quaternion: Array, vectors: Array) -> Array:
    """(n, 3) of world axes: v - 2 w (u x v) + 2 u x (u x v), u the quaternion's vector."""
    w, u = quaternion[:, :1], quaternion[:, 1:]
    once = np.cross(u, vectors)
    turned: Array = vectors - 2 * w * once + 2 * np.cross(u, once)
    return turned


class VelocityTask:
    def __init__(self, start: Array) -> None:
        self.start = np.array(start)  #: (joints,) [rad]
        self.joints = len(self.start)
        self.observations = 9 + 3 * self.joints

    def targets(self, actions: NDArray[np.floating]) -> Array:
        """(n, joints) [rad] of actions from -1 to 1."""
        targets: Array = self.start + reach * np.clip(np.asarray(actions, dtype=np.float64), -1, 1)
        return targets

    def command(self, random: np.random.Generator) -> Array:
        """(3,)"""
        return random.uniform(-1, 1, 3) * fastest

    def observe(self, motion: Motion, commands: Array, actions: NDArray[np.floating]) -> Rows:
        """(n, observations): down in base axes, angular velocity in base axes, command, joints from the start, their rates,
        last action."""
        down = in_base_axes(motion.quaternion, np.broadcast_to([0.0, 0.0, -1.0], (len(commands), 3)))
        parts = [down, in_base_axes(motion.quaternion, motion.angular_velocity), commands, motion.joint_position - self.start,
                 0.1 * motion.joint_velocity, actions]
        return np.concatenate(parts, axis=1, dtype=np.float32, casting="same_kind")

    def reward(self, motion: Motion, commands: Array, actions: NDArray[np.floating], last: NDArray[np.floating]) -> Array:
        """(n,) at most 1 for each control step, -5 for a fall."""
        linear = in_base_axes(motion.quaternion, motion.linear_velocity)[:, :2] - commands[:, :2]
        turning = in_base_axes(motion.quaternion, motion.angular_velocity)[:, 2] - commands[:, 2]
        along = np.exp(-np.sum(linear**2, axis=1) / tracking_width**2)
        around = np.exp(-((turning / (5 * tracking_width)) ** 2))
        worth = 0.7 * along + 0.3 * around
        shaking = 0.005 * np.sum((actions - last) ** 2, axis=1)
        result: Array = np.where(motion.fallen, -5.0, worth - shaking)
        return result
