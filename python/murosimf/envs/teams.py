"""Two teams that play with a ball, as a parallel environment of PettingZoo: `murosimf.envs.teams.Teams(3)`.

Agents are robots that walk by a controller of the simulator; what they decide, at 10 Hz, is where to walk.
"""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray
from pettingzoo import ParallelEnv  # type: ignore[import-untyped,import-not-found,unused-ignore]

from .._values import Array
from ..errors import InputError
from ..scene import Scene
from .motion import Rows

decision_rate = 10  # [Hz]
fastest = np.array([0.3, 0.15, 1.0])  # [m/s forward, m/s to the left, rad/s] for actions of 1
half_length, half_width, half_goal = 3.0, 2.0, 0.75  # [m] of the field kid_size_2008: laws of the Humanoid League 2008
goal_reward = 10.0


def _scene_text(robots: int, level: str) -> str:
    lines = ['name = "Teams"\nduration = 10000.0\n[start]\njitter_position = 0.3\njitter_heading_deg = 30.0\n'
             '[field]\nsize = "kid_size_2008"\nsurface = "carpet"\n[ball]\nposition = [0.0, 0.0]\nradius = 0.065\nmass = 0.15\n'
             '[[teams]]\nname = "blue"\n[[teams]]\nname = "red"\n']
    for team, side, heading in (("blue", -1, 0), ("red", 1, 180)):
        for number in range(robots):
            y = 1.2 * (number - (robots - 1) / 2)
            lines.append(f'[[robots]]\nname = "{team}{number + 1}"\nteam = "{team}"\nmodel = "kid21"\nlevel = "{level}"\n'
                         f'controller = "walk"\nposition = [{side * 1.2}, {y}]\nheading_deg = {heading}\n')
    return "".join(lines)


class Teams(ParallelEnv[str, Rows, Rows]):  # type: ignore[misc,unused-ignore]
    """`robots` of each team: agents blue1, ..., red1, ... Blue attacks towards positive x.

    Action (3,) from -1 to 1: velocity forward, to the left and turning left, in parts of `fastest`. Observation, float32, all
    lengths in the axes of the robot (x forward, y left): ball (2) [m], its velocity (2) [m/s], middle of the goal that is
    attacked (2) and of the own one (2) [m], then mates (2 each) and opponents (2 each) [m] in the order of their names, and 1 if
    the robot lies. Reward of all of a team: metres that the ball has moved towards the goal that is attacked, and 10 for a goal,
    -10 for one against. A goal or a ball that leaves the field ends the episode for all; `seconds` cut it short.
    """

    metadata = {"name": "murosimf_teams_v0", "render_modes": ["rgb_array"], "render_fps": decision_rate}

    def __init__(self, robots: int = 3, level: str = "kinematic_walking", seconds: float = 60.0,
                 render_mode: str | None = None) -> None:
        if not 1 <= robots <= 4:
            raise InputError(f"a team has 1 to 4 robots, not {robots}")
        self.scene = Scene.of_text(_scene_text(robots, level), cameras=False)
        self.render_mode = render_mode
        self.possible_agents = self.scene.robots
        self.agents: list[str] = []
        self.decisions = round(seconds * decision_rate)
        size = 8 + 2 * (2 * robots - 1) + 1
        self.observation_spaces = {name: gymnasium.spaces.Box(-np.inf, np.inf, (size,), np.float32)
                                   for name in self.possible_agents}
        self.action_spaces = {name: gymnasium.spaces.Box(-1, 1, (3,), np.float32) for name in self.possible_agents}
        self._steps = round(1 / (decision_rate * self.scene.step_length))
        self._random = np.random.default_rng()
        self._decided = 0

    def observation_space(self, agent: str) -> gymnasium.spaces.Space[Rows]:
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> gymnasium.spaces.Space[Rows]:
        return self.action_spaces[agent]

    def reset(self, seed: int | None = None,
              options: dict[str, Any] | None = None) -> tuple[dict[str, Rows], dict[str, dict[str, Any]]]:
        """`options` are not used."""
        if seed is not None:
            self._random = np.random.default_rng(seed)
        self.scene.reset(seed=int(self._random.integers(2**31)))
        self.agents = list(self.possible_agents)
        self._decided = 0
        return self._observations(), {name: {} for name in self.agents}

    def step(self, actions: dict[str, Rows]) -> tuple[dict[str, Rows], dict[str, float], dict[str, bool], dict[str, bool],
                                                      dict[str, dict[str, Any]]]:
        for name, action in actions.items():
            forward, left, turning = np.clip(np.asarray(action, np.float64), -1, 1) * fastest
            self.scene[name].command(float(forward), float(left), float(turning))
        before = self._ball()[0]
        self.scene.step(self._steps)
        self._decided += 1
        x, y = self._ball()
        scored = goal(x, y)
        worth = {"blue": x - before + goal_reward * scored, "red": before - x - goal_reward * scored}
        over = abs(x) > half_length or abs(y) > half_width
        late = self._decided >= self.decisions and not over
        observations, names = self._observations(), self.agents
        if over or late:
            self.agents = []
        return (observations, {name: float(worth[name.rstrip("1234")]) for name in names}, dict.fromkeys(names, bool(over)),
                dict.fromkeys(names, late), {name: {"goal": scored} for name in names})

    def render(self) -> NDArray[np.uint8] | None:
        """A picture of the field, if render_mode is "rgb_array"."""
        if self.render_mode is None:
            return None
        return self.scene.picture(eye=(0, -5, 4), look_at=(0, 0, 0), width=640, height=480).rgb

    def _ball(self) -> tuple[float, float]:
        x, y, _ = self.scene.entity("ball").position
        return float(x), float(y)

    def _observations(self) -> dict[str, Rows]:
        places = {name: np.array(self.scene[name].position[:2]) for name in self.possible_agents}
        ball = self.scene.entity("ball")
        return {name: self._observation(name, places, np.array(ball.position[:2]), np.array(ball.linear_velocity[:2]))
                for name in self.agents}

    def _observation(self, name: str, places: dict[str, Array], ball: Array, velocity: Array) -> Rows:
        robot, team = self.scene[name], name.rstrip("1234")
        forward = np.array(robot.orientation[:2, 0])
        forward /= max(float(np.linalg.norm(forward)), 1e-9)
        axes = np.array([forward, [-forward[1], forward[0]]])  # rows: forward, left
        attacked = np.array([half_length if team == "blue" else -half_length, 0.0])
        mates = [place for other, place in places.items() if other.startswith(team) and other != name]
        opponents = [place for other, place in places.items() if not other.startswith(team)]
        points = np.array([ball, attacked, -attacked, *mates, *opponents]) - places[name]
        seen = points @ axes.T
        return np.concatenate([seen[0], axes @ velocity, seen[1:].ravel(), [float(robot.fallen)]], dtype=np.float32,
                              casting="same_kind")


def goal(x: float, y: float) -> int:
    """1 if a ball at (x, y) [m] is in the goal that blue attacks, -1 if in the other one, else 0."""
    return int(np.sign(x)) if abs(x) > half_length and abs(y) < half_goal else 0
