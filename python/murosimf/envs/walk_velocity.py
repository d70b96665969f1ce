"""One robot that is to walk with a velocity that is asked for."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

from ..picture import Picture
from ..scene import Scene
from .velocity_task import Motion, Rows, VelocityTask, control_steps


class WalkVelocity(gymnasium.Env[Rows, Rows]):
    """Observations and actions: velocity_task.py. `level`: a level of detail with dynamics; `scene` has a robot "walker"."""

    metadata = {"render_modes": ["rgb_array"], "render_fps": 50}

    def __init__(self, level: str = "simplified_dynamics", render_mode: str | None = None, scene: str = "walk") -> None:
        self.scene = Scene(scene, set={"walker.level": level, "walker.controller": "none"}, cameras=False)
        self.robot = self.scene["walker"]
        self.task = VelocityTask(self.robot.joint_position)
        self.render_mode = render_mode
        self.observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (self.task.observations,), np.float32)
        self.action_space = gymnasium.spaces.Box(-1, 1, (self.task.joints,), np.float32)
        self._action = np.zeros((1, self.task.joints), np.float32)
        self._command = np.zeros((1, 3))

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Rows, dict[str, Any]]:
        """`options={"command": (0.2, 0, 0)}`: [m/s forward, m/s to the left, rad/s] instead of a random one."""
        super().reset(seed=seed)
        self.scene.reset(seed=int(self.np_random.integers(2**31)))
        drawn = self.task.command(self.np_random)
        self._command[0] = (options or {}).get("command", drawn)
        self._action[:] = 0
        return self._observation(), {"command": self._command[0].copy()}

    def step(self, action: Rows) -> tuple[Rows, float, bool, bool, dict[str, Any]]:
        actions = np.asarray(action, np.float32)[None]
        self.robot.joint_target[:] = self.task.targets(actions)[0]
        self.scene.step(control_steps)
        motion = self._motion()
        reward = float(self.task.reward(motion, self._command, actions, self._action)[0])
        self._action[:] = actions
        return self.task.observe(motion, self._command, self._action)[0], reward, bool(motion.fallen[0]), False, {}

    def render(self) -> NDArray[np.uint8] | None:
        """A picture from the side, if render_mode is "rgb_array"."""
        if self.render_mode is None:
            return None
        x, y, _ = self.robot.position
        picture: Picture = self.scene.picture(eye=(x, y - 2, 0.8), look_at=(x, y, 0.25), width=480, height=360)
        return picture.rgb

    def _motion(self) -> Motion:
        robot = self.robot
        return Motion(np.asarray(robot.joint_position)[None], np.asarray(robot.joint_velocity)[None], robot.quaternion[None],
                      robot.linear_velocity[None], robot.angular_velocity[None], np.array([robot.fallen]))

    def _observation(self) -> Rows:
        row: Rows = self.task.observe(self._motion(), self._command, self._action)[0]
        return row
