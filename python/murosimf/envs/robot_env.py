"""One robot with a task, as an environment of Gymnasium."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..picture import Picture
from ..scene import Scene
from .motion import Motion, Rows, motion_of_scene
from .tasks import make_task


class RobotEnv(gymnasium.Env[Rows, Rows]):
    """`task`: a name of `murosimf.envs.tasks`; `**settings`: of the task (model, level, rate, soles). `env.unwrapped.task` says
    what observations and actions are."""

    metadata = {"render_modes": ["rgb_array"], "render_fps": 50}

    def __init__(self, task: str, render_mode: str | None = None, **settings: Any) -> None:
        self.task = make_task(task, settings)
        self.scene = Scene.of_text(self.task.scene, cameras=False)
        self.render_mode = render_mode
        self.observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (len(self.task.entries()),), np.float32)
        self.action_space = gymnasium.spaces.Box(-1, 1, (len(self.task.joints),), np.float32)
        self.memory = self.task.memory(1)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Rows, dict[str, Any]]:
        """`options={"command": (0.2, 0, 0)}`: [m/s forward, m/s to the left, rad/s] instead of a random one, for walking."""
        super().reset(seed=seed)
        unknown = set(options or {}) - {"command"}
        if unknown:
            raise InputError(f"unknown option '{min(unknown)}' of reset; known: command")
        self.scene.reset(seed=int(self.np_random.integers(2**31)))
        self.task.begin(self.memory, 0, self.np_random)
        if options and "command" in options:
            self.memory.command[0] = options["command"]
        return self._observation(self._motion()), {"command": self.memory.command[0].copy()}

    def step(self, action: Rows) -> tuple[Rows, float, bool, bool, dict[str, Any]]:
        actions = np.asarray(action, np.float32)[None]
        for _, force in self.task.push(self.memory, self.np_random):
            self.scene.robot.push(force=force, duration=0.1)
        self.scene.robot.joint_target[:] = self.task.targets(actions, self.memory)[0]
        self.scene.step(self.task.steps)
        motion = self._motion()
        reward = float(self.task.reward(motion, self.memory, actions)[0])
        self.memory.action[:] = actions
        self.task.advance(self.memory)
        return self._observation(motion), reward, bool(self.task.ended(motion)[0]), False, {}

    def render(self) -> NDArray[np.uint8] | None:
        """A picture from the side, if render_mode is "rgb_array"."""
        if self.render_mode is None:
            return None
        x, y, _ = self.scene.robot.position
        picture: Picture = self.scene.picture(eye=(x, y - 2, 0.8), look_at=(x, y, 0.25), width=480, height=360)
        return picture.rgb

    def _motion(self) -> Motion:
        return motion_of_scene(self.scene, self.task.ball is not None)

    def _observation(self, motion: Motion) -> Rows:
        row: Rows = self.task.observe(motion, self.memory)[0]
        return row
