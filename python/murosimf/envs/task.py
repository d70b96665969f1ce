"""What a robot is to do: scene, observations, actions, rewards and ends of a task, for n robots at once.

Each task says in `entries()` what its observations are, one name with a unit for each number, and in its docstring where its
rewards come from. Control is at 50 Hz. Actions from -1 to 1 move targets of joints around a posture of the task.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from .._values import Array
from ..scene import Scene
from .legs import bend, leg_of
from .motion import Motion, Rows, down, in_base_axes

control_rate = 50  # [Hz]
crouch = 0.35  # [rad] of hip and ankle; the knee twice as much
Numbers = NDArray[np.floating]


@dataclass
class Memory:
    """Of n episodes: what observations and rewards need beside the motion."""

    command: Array  #: (n, 3) [m/s forward, m/s to the left, rad/s turning left]
    phase: Array  #: (n,) [rad] of a gait
    action: Rows  #: (n, actions) the last one
    steps: NDArray[np.int64] = field(init=False)  #: (n,) since the start

    def __post_init__(self) -> None:
        self.steps = np.zeros(len(self.phase), np.int64)


class Task:
    """Base of all tasks. `model`: a robot's file or name; `soles`: names of the frames at the bottoms of its feet."""

    episode = 500  #: [control steps] 10 s
    reach = 0.4  #: [rad] of a target from the posture, for an action of 1
    whole_body = False  #: arms and head take part, or legs alone
    ball: tuple[float, float] | None = None  #: [m] where one lies
    ends_by_fall = True

    def __init__(self, model: str = "kid21", level: str = "simplified_dynamics", rate: int = 1000,
                 soles: tuple[str, str] = ("l_sole", "r_sole")) -> None:
        self.scene = self._scene_text(model, level, rate, jitter=1.0)
        self.steps = rate // control_rate  #: of the simulation for each control step
        robot = Scene.of_text(self._scene_text(model, level, rate, jitter=0.0), cameras=False).robot
        self.names: list[str] = robot.joints.names
        self.legs = [leg_of(robot, soles[0], soles[1]), leg_of(robot, soles[1], soles[0])]
        chosen = range(len(self.names)) if self.whole_body else sorted(self.legs[0].joints + self.legs[1].joints)
        self.joints = np.array(list(chosen))  #: those that act
        self.start = np.array(robot.joint_position)  #: (all joints,) [rad]
        self.posture = self.start.copy()  #: (all joints,) [rad] around which actions move
        for leg in self.legs:
            bend(self.posture, leg, crouch)
        self.height = float(np.mean([-robot.kinematics.fk(self.posture, sole).position[2] for sole in soles]))  #: [m] standing

    def _scene_text(self, model: str, level: str, rate: int, jitter: float) -> str:
        ball = "" if self.ball is None else f"[ball]\nposition = [{self.ball[0]}, {self.ball[1]}]\nmass = 0.15\nradius = 0.065\n"
        return (f'name = "{type(self).__name__}"\nduration = 1000.0\nrate = {rate}\n{ball}[field]\ngoals = false\n'
                f"[start]\njitter_posture_deg = {jitter}\n"
                f'[[robots]]\nname = "robot"\nmodel = "{model}"\nlevel = "{level}"\ncontroller = "none"\n'
                f"sensors = false\n{self.pose()}")

    def pose(self) -> str:
        """Lines of the robot in the scene: how it begins."""
        return ""

    # what is seen

    def entries(self) -> list[tuple[str, str]]:
        """(name, unit) of each number of an observation, in its order."""
        joints = [self.names[joint] for joint in self.joints]
        return ([(f"gravity.{axis}", "1, direction of gravity in base axes") for axis in "xyz"]
                + [(f"angular_velocity.{axis}", "rad/s, of the base in base axes") for axis in "xyz"]
                + [(f"position.{name}", "rad, from the posture") for name in joints]
                + [(f"velocity.{name}", "0.1 rad/s") for name in joints]
                + [(f"action.{name}", "1, the last one") for name in joints] + self.more_entries())

    def more_entries(self) -> list[tuple[str, str]]:
        return []

    def observe(self, motion: Motion, memory: Memory) -> Rows:
        """(n, observations)"""
        parts = [down(motion), in_base_axes(motion.quaternion, motion.angular_velocity),
                 motion.joint_position[:, self.joints] - self.posture[self.joints], 0.1 * motion.joint_velocity[:, self.joints],
                 memory.action, *self.more_parts(motion, memory)]
        return np.concatenate(parts, axis=1, dtype=np.float32, casting="same_kind")

    def more_parts(self, motion: Motion, memory: Memory) -> list[Array]:
        return []

    # what is done

    def memory(self, n: int) -> Memory:
        return Memory(np.zeros((n, 3)), np.zeros(n), np.zeros((n, len(self.joints)), np.float32))

    def begin(self, memory: Memory, which: int, random: np.random.Generator) -> None:
        """Draws what differs from episode to episode."""
        memory.command[which], memory.phase[which], memory.action[which], memory.steps[which] = 0, 0, 0, 0

    def reference(self, memory: Memory) -> Array:
        """(n, all joints) [rad] targets for actions of 0."""
        return np.broadcast_to(self.posture, (len(memory.phase), len(self.posture))).copy()

    def targets(self, actions: Numbers, memory: Memory) -> Array:
        """(n, all joints) [rad] of actions (n, actions) from -1 to 1."""
        targets = self.reference(memory)
        targets[:, self.joints] += self.reach * np.clip(np.asarray(actions, dtype=np.float64), -1, 1)
        return targets

    def advance(self, memory: Memory) -> None:
        """After a control step."""
        memory.steps += 1

    def push(self, memory: Memory, random: np.random.Generator) -> list[tuple[int, Array]]:
        """Robots that are pushed now, with forces (3,) [N] for 0.1 s."""
        return []

    # what it is worth

    def reward(self, motion: Motion, memory: Memory, actions: Numbers) -> Array:
        """(n,) at most about 1 for each control step; `memory.action` is the action before `actions`."""
        raise NotImplementedError

    def ended(self, motion: Motion) -> NDArray[np.bool_]:
        """(n,) for good"""
        return motion.fallen if self.ends_by_fall else np.zeros(len(motion.fallen), np.bool_)


def effort(actions: Numbers, memory: Memory) -> Array:
    """(n,) 0.01 for each action that changes by 1: what shakes wears servos."""
    change: Array = 0.01 * np.sum((np.clip(actions, -1, 1) - np.clip(memory.action, -1, 1)) ** 2, axis=1)
    return change
