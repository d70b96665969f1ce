"""Many robots, each in a world of its own, that are to walk with velocities that are asked for: one Batch, no processes."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from ..batch import Batch
from .velocity_task import Motion, Rows, VelocityTask, control_steps

episode = 1000  # [control steps] 20 s


class WalkVelocityVector(VectorEnv[Rows, Rows, NDArray[Any]]):
    """As WalkVelocity in `num_envs` worlds, with `threads`. A world that has ended begins again in the next step, whose action
    and reward do not count (AutoresetMode.NEXT_STEP)."""

    metadata = {"autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(self, num_envs: int = 1, level: str = "simplified_dynamics", threads: int = 1, scene: str = "walk",
                 max_episode_steps: int = episode) -> None:
        changes = {"walker.level": level, "walker.controller": "none"}
        self.batch = Batch(scene, num_envs, threads=threads, set=changes, cameras=False)
        self.task = VelocityTask(self.batch.joint_position[0])
        self.num_envs = num_envs
        self.max_episode_steps = max_episode_steps
        self.single_observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (self.task.observations,), np.float32)
        self.single_action_space = gymnasium.spaces.Box(-1, 1, (self.task.joints,), np.float32)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._actions = np.zeros((num_envs, self.task.joints), np.float32)
        self._commands = np.zeros((num_envs, 3))
        self._steps = np.zeros(num_envs, np.int64)
        self._ended = np.zeros(num_envs, np.bool_)

    def reset(self, *, seed: int | list[int | None] | None = None,
              options: dict[str, Any] | None = None) -> tuple[Rows, dict[str, Any]]:
        """`seed`: one number, from which those of all worlds are drawn."""
        if isinstance(seed, list):
            seed = seed[0]
        super().reset(seed=seed)
        self._begin(np.ones(self.num_envs, np.bool_))
        return self.task.observe(self._motion(), self._commands, self._actions), {}

    def step(self, actions: Rows) -> tuple[Rows, NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]]:
        given = np.where(self._ended[:, None], 0, np.asarray(actions, np.float32))
        self.batch.joint_target[:] = self.task.targets(given)
        self.batch.step(control_steps)
        begun = self._ended
        if begun.any():
            self._begin(begun)
            given[begun] = 0
        motion = self._motion()
        rewards = self.task.reward(motion, self._commands, given, self._actions)
        rewards[begun] = 0
        self._actions[:] = given
        self._steps[~begun] += 1
        fallen = motion.fallen & ~begun
        late = (self._steps >= self.max_episode_steps) & ~fallen
        self._ended = fallen | late
        return self.task.observe(motion, self._commands, self._actions), rewards, fallen, late, {}

    def _begin(self, which: NDArray[np.bool_]) -> None:
        self.batch.reset(which, seed=int(self.np_random.integers(2**31)))
        for world in np.flatnonzero(which):
            self._commands[world] = self.task.command(self.np_random)
        self._actions[which] = 0
        self._steps[which] = 0
        self._ended = np.where(which, False, self._ended)

    def _motion(self) -> Motion:
        batch = self.batch
        return Motion(batch.joint_position, batch.joint_velocity, batch.quaternion, batch.linear_velocity, batch.angular_velocity,
                      np.array(batch.fallen))
