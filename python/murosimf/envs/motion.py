"""What tasks see of n robots, from one scene or from a batch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._values import Array
from ..batch import Batch
from ..scene import Scene

Rows = NDArray[np.float32]


@dataclass
class Motion:
    """Of n robots, world axes."""

    joint_position: Array  #: (n, joints) [rad]
    joint_velocity: Array  #: (n, joints) [rad/s]
    position: Array  #: (n, 3) [m] of the base
    quaternion: Array  #: (n, 4) of the base, w first
    linear_velocity: Array  #: (n, 3) [m/s] of the base
    angular_velocity: Array  #: (n, 3) [rad/s] of the base
    fallen: NDArray[np.bool_]  #: (n,) the base is tilted over 60 degrees
    ball_position: Array  #: (n, 3) [m]; (n, 0) without a ball
    ball_velocity: Array  #: (n, 3) [m/s]; (n, 0) without a ball


def in_base_axes(quaternion: Array, vectors: Array) -> Array:
    """(n, 3) of world axes: v - 2 w (u x v) + 2 u x (u x v), u the quaternion's vector."""
    w, u = quaternion[:, :1], quaternion[:, 1:]
    once = np.cross(u, vectors)
    turned: Array = vectors - 2 * w * once + 2 * np.cross(u, once)
    return turned


def down(motion: Motion) -> Array:
    """(n, 3) direction of gravity in base axes"""
    return in_base_axes(motion.quaternion, np.broadcast_to([0.0, 0.0, -1.0], (len(motion.quaternion), 3)))


def _no_balls(n: int) -> tuple[Array, Array]:
    return np.zeros((n, 0)), np.zeros((n, 0))


def _ball_of(scene: Scene) -> tuple[Array, Array]:
    ball = scene.entity("ball")
    return np.array(ball.position)[None], np.array(ball.linear_velocity)[None]


def motion_of_scene(scene: Scene, ball: bool) -> Motion:
    """One row: of the first robot."""
    robot = scene.robot
    return Motion(np.array(robot.joint_position)[None], np.array(robot.joint_velocity)[None], np.array(robot.position)[None],
                  robot.quaternion[None], np.array(robot.linear_velocity)[None], np.array(robot.angular_velocity)[None],
                  np.array([robot.fallen]), *(_ball_of(scene) if ball else _no_balls(1)))


def motion_of_batch(batch: Batch, ball: bool) -> Motion:
    """A row for each world, of its first robot."""
    balls = (batch.ball_position, batch.ball_velocity) if ball else _no_balls(len(batch))
    return Motion(batch.joint_position, batch.joint_velocity, batch.position, batch.quaternion, batch.linear_velocity,
                  batch.angular_velocity, np.array(batch.fallen), *balls)
