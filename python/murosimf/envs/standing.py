"""To stand, and to stay standing when pushed."""

from __future__ import annotations

import numpy as np

from .._values import Array
from .motion import Motion, down
from .task import Memory, Numbers, Task, effort


class Stand(Task):
    """To stay upright at a height and at rest. The reward is a product of tolerances, as in the stand tasks of the DeepMind
    Control Suite (Tassa et al., arXiv:1801.00690, appendix on rewards): upright, high, at rest; -5 for a fall."""

    def reward(self, motion: Motion, memory: Memory, actions: Numbers) -> Array:
        upright = np.clip(-down(motion)[:, 2], 0, 1)
        high = np.exp(-(((motion.position[:, 2] - self.height) / 0.05) ** 2))
        at_rest = np.exp(-np.sum(motion.linear_velocity**2, axis=1) / 0.2**2)
        worth: Array = np.where(motion.fallen, -5.0, upright * high * (0.5 + 0.5 * at_rest) - effort(actions, memory))
        return worth


class PushRecovery(Stand):
    """As Stand, and every 2 s a push of 0.1 s in a random direction of the plane meets the base, of up to `force` [N]. It may
    step: place is worth nothing."""

    force = 30.0  #: [N]: 3 N s, or 0.7 m/s for kid21's mass of 4.3 kg
    every = 100  #: [control steps]

    def push(self, memory: Memory, random: np.random.Generator) -> list[tuple[int, Array]]:
        pushes: list[tuple[int, Array]] = []
        for world in np.flatnonzero(memory.steps % self.every == self.every // 2):
            angle, force = random.uniform(-np.pi, np.pi), random.uniform(0, self.force)
            pushes.append((int(world), force * np.array([np.cos(angle), np.sin(angle), 0.0])))
        return pushes
