"""To walk with a velocity that is asked for.

Actions are residuals: they move targets of the legs' joints around a nominal gait without feedback, with a clock of its own. A
leg bends by `lift` while its half of the clock lasts and swings as far as the command says; what keeps balance, and what corrects
the velocity, is learned.
"""

from __future__ import annotations

import numpy as np

from .._values import Array
from .legs import bend, swing
from .motion import Motion, down, in_base_axes
from .task import Memory, Numbers, Task, control_rate, effort


class WalkVelocity(Task):
    """Rewards are those usual for such tasks (Rudin et al., Learning to Walk in Minutes Using Massively Parallel Deep
    Reinforcement Learning, CoRL 2021, table 2): exponentials of the errors of velocity, less for what tilts, turns and shakes;
    -5 for a fall."""

    fastest = (0.3, 0.1, 0.5)  #: [m/s forward, m/s to the left, rad/s] commands are drawn up to these
    width = 0.15  #: [m/s] error at which the reward has fallen to exp(-1); of turning 0.5 rad/s
    period = 0.48  #: [s] of two steps, near that of kid21's own walk (models/kid21.toml)
    lift = 0.3  #: [rad] of hip and ankle, the knee twice as much

    def more_entries(self) -> list[tuple[str, str]]:
        return [("command.forward", "m/s"), ("command.left", "m/s"), ("command.turning", "rad/s"),
                ("clock.sin", "1"), ("clock.cos", "1")]

    def more_parts(self, motion: Motion, memory: Memory) -> list[Array]:
        return [memory.command, np.sin(memory.phase)[:, None], np.cos(memory.phase)[:, None]]

    def begin(self, memory: Memory, which: int, random: np.random.Generator) -> None:
        super().begin(memory, which, random)
        memory.command[which] = random.uniform(-1, 1, 3) * self.fastest
        memory.phase[which] = random.choice([0.0, np.pi])

    def reference(self, memory: Memory) -> Array:
        targets = super().reference(memory)
        for leg, phase in zip(self.legs, (memory.phase, memory.phase + np.pi), strict=True):
            bend(targets, leg, self.lift * np.clip(np.sin(phase), 0, 1))
            # while it stands, half the period, a foot goes back from +a to -a with the velocity: a = velocity * period / 4
            place = -np.cos(phase) * self.period / 4
            forward, left, turning = memory.command.T * place
            swing(targets, leg, forward / self.height, left / self.height, turning)
        return targets

    def advance(self, memory: Memory) -> None:
        super().advance(memory)
        memory.phase += 2 * np.pi / (self.period * control_rate)

    def reward(self, motion: Motion, memory: Memory, actions: Numbers) -> Array:
        velocity = in_base_axes(motion.quaternion, motion.linear_velocity)[:, :2]
        rates = in_base_axes(motion.quaternion, motion.angular_velocity)
        along = np.exp(-np.sum((velocity - memory.command[:, :2]) ** 2, axis=1) / self.width**2)
        around = np.exp(-(((rates[:, 2] - memory.command[:, 2]) / 0.5) ** 2))
        tilt = np.sum(down(motion)[:, :2] ** 2, axis=1) + 0.01 * np.sum(rates[:, :2] ** 2, axis=1)
        worth: Array = np.where(motion.fallen, -5.0, 0.7 * along + 0.3 * around - tilt - effort(actions, memory))
        return worth
