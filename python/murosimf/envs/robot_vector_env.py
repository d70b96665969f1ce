"""Many robots with the same task, each in a world of its own: one Batch, no processes."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from ..batch import Batch
from .motion import Motion, Rows, motion_of_batch
from .tasks import make_task


class RobotVectorEnv(VectorEnv[Rows, Rows, NDArray[Any]]):
    """As RobotEnv in `num_envs` worlds, with `threads`. A world that has ended begins again in the next step, whose action and
    reward do not count (AutoresetMode.NEXT_STEP)."""

    metadata = {"autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(self, task: str, num_envs: int = 1, threads: int = 1, max_episode_steps: int | None = None,
                 **settings: Any) -> None:
        self.task = make_task(task, settings)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "task.toml"
            file.write_text(self.task.scene)
            self.batch = Batch(file, num_envs, threads=threads, cameras=False)
        self.num_envs = num_envs
        self.max_episode_steps = self.task.episode if max_episode_steps is None else max_episode_steps
        self.single_observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (len(self.task.entries()),), np.float32)
        self.single_action_space = gymnasium.spaces.Box(-1, 1, (len(self.task.joints),), np.float32)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.memory = self.task.memory(num_envs)
        self._ended = np.zeros(num_envs, np.bool_)

    def reset(self, *, seed: int | list[int | None] | None = None,
              options: dict[str, Any] | None = None) -> tuple[Rows, dict[str, Any]]:
        """`seed`: one number, from which those of all worlds are drawn."""
        if isinstance(seed, list):
            seed = seed[0]
        super().reset(seed=seed)
        self._begin(np.ones(self.num_envs, np.bool_))
        return self.task.observe(self._motion(), self.memory), {}

    def step(self, actions: Rows) -> tuple[Rows, NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]]:
        given = np.where(self._ended[:, None], 0, np.asarray(actions, np.float32))
        for world, force in self.task.push(self.memory, self.np_random):
            self.batch.push(world, force=force, duration=0.1)
        self.batch.joint_target[:] = self.task.targets(given, self.memory)
        self.batch.step(self.task.steps)
        begun = self._ended
        motion = self._motion()
        rewards = self.task.reward(motion, self.memory, given)
        self.memory.action[:] = given
        self.task.advance(self.memory)
        fallen = self.task.ended(motion) & ~begun
        if begun.any():
            self._begin(begun)
            motion = self._motion()
            rewards[begun] = 0
        late = (self.memory.steps >= self.max_episode_steps) & ~fallen & ~begun
        self._ended = fallen | late
        return self.task.observe(motion, self.memory), rewards, fallen, late, {}

    def _begin(self, which: NDArray[np.bool_]) -> None:
        self.batch.reset(which, seed=int(self.np_random.integers(2**31)))
        for world in np.flatnonzero(which):
            self.task.begin(self.memory, int(world), self.np_random)
        self._ended = self._ended & ~which

    def _motion(self) -> Motion:
        return motion_of_batch(self.batch, self.task.ball is not None)
