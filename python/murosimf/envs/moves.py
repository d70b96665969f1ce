"""Tasks of a single move: to get up, to kick."""

from __future__ import annotations

import numpy as np

from .._values import Array
from .motion import Motion, down, in_base_axes
from .task import Memory, Numbers, Task, effort


class GetUp(Task):
    """To stand up from lying on the back. Half of the reward is for a base that is upright, half for its height (both from 0
    lying to 1 standing, after the stand-up task of Gymnasium, which pays for height): a smooth way up, without key frames.
    Nothing ends an episode but its time."""

    whole_body = True
    reach = 1.8
    ends_by_fall = False

    def pose(self) -> str:
        return "pitch_deg = -90\n"

    def reward(self, motion: Motion, memory: Memory, actions: Numbers) -> Array:
        upright = 0.5 * (1 - down(motion)[:, 2])
        high = np.clip(motion.position[:, 2] / self.height, 0, 1)
        worth: Array = 0.5 * upright + 0.5 * high - effort(actions, memory)
        return worth


class Kick(Task):
    """To kick a ball forward that lies before the right foot, and to stay on the feet. The reward is the ball's speed forward,
    1 for 2 m/s, less its speed sideways, and 0.1 for standing; -5 for a fall."""

    episode = 150
    reach = 0.8
    ball = (0.16, -0.056)

    def more_entries(self) -> list[tuple[str, str]]:
        return ([(f"ball.position.{axis}", "m, from the base in base axes") for axis in "xyz"]
                + [(f"ball.velocity.{axis}", "m/s, in base axes") for axis in "xyz"])

    def more_parts(self, motion: Motion, memory: Memory) -> list[Array]:
        return [in_base_axes(motion.quaternion, motion.ball_position - motion.position),
                in_base_axes(motion.quaternion, motion.ball_velocity)]

    def reward(self, motion: Motion, memory: Memory, actions: Numbers) -> Array:
        speed = 0.5 * (motion.ball_velocity[:, 0] - np.abs(motion.ball_velocity[:, 1]))
        worth: Array = np.where(motion.fallen, -5.0, 0.1 + speed - effort(actions, memory))
        return worth
