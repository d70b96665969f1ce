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


def _balls(scenes: list[Scene], ball: bool) -> tuple[Array, Array]:
    if not ball:
        return np.zeros((len(scenes), 0)), np.zeros((len(scenes), 0))
    entities = [scene.entity("ball") for scene in scenes]
    return np.array([each.position for each in entities]), np.array([each.linear_velocity for each in entities])


def motion_of_scene(scene: Scene, ball: bool) -> Motion:
    """One row: of the first robot."""
    robot = scene.robot
    return Motion(np.array(robot.joint_position)[None], np.array(robot.joint_velocity)[None], np.array(robot.position)[None],
                  robot.quaternion[None], np.array(robot.linear_velocity)[None], np.array(robot.angular_velocity)[None],
                  np.array([robot.fallen]), *_balls([scene], ball))


def motion_of_batch(batch: Batch, ball: bool) -> Motion:
    """A row for each world, of its first robot."""
    scenes = [batch[i] for i in range(len(batch))] if ball else []
    return Motion(batch.joint_position, batch.joint_velocity, batch.position, batch.quaternion, batch.linear_velocity,
                  batch.angular_velocity, np.array(batch.fallen),
                  *(_balls(scenes, True) if ball else (np.zeros((len(batch), 0)),) * 2))
