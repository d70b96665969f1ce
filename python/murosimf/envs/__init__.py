"""Environments of Gymnasium: `gymnasium.make("murosimf/WalkVelocity-v0")`; many at once: `gymnasium.make_vec` of the same name,
in one Batch. Names: Stand, WalkVelocity, GetUp, Kick, PushRecovery (`murosimf.envs.tasks`). Two teams with a ball:
`murosimf.envs.teams` (needs PettingZoo)."""

from __future__ import annotations

import gymnasium

from .robot_env import RobotEnv
from .robot_vector_env import RobotVectorEnv
from .tasks import tasks

__all__ = ["RobotEnv", "RobotVectorEnv", "register", "tasks"]


def register() -> None:
    """Gymnasium calls it for the installed package; `import murosimf.envs` does, too."""
    for name, task in tasks.items():
        if f"murosimf/{name}-v0" not in gymnasium.registry:
            gymnasium.register(f"murosimf/{name}-v0", entry_point="murosimf.envs.robot_env:RobotEnv",
                               vector_entry_point="murosimf.envs.robot_vector_env:RobotVectorEnv",
                               max_episode_steps=task.episode, kwargs={"task": name})


register()
