"""Environments of Gymnasium: `gymnasium.make("murosimf/WalkVelocity-v0")`; many at once: `gymnasium.make_vec` of the same name,
in one Batch."""

from __future__ import annotations

import gymnasium

from .walk_velocity import WalkVelocity
from .walk_velocity_vector import WalkVelocityVector

__all__ = ["WalkVelocity", "WalkVelocityVector", "register"]

episode = 1000  # [control steps] 20 s


def register() -> None:
    """Gymnasium calls it for the installed package; `import murosimf.envs` does, too."""
    name = "murosimf/WalkVelocity-v0"
    if name not in gymnasium.registry:
        gymnasium.register(name, entry_point="murosimf.envs.walk_velocity:WalkVelocity", max_episode_steps=episode,
                           vector_entry_point="murosimf.envs.walk_velocity_vector:WalkVelocityVector")


register()
