"""Classes of the scene practice.toml beside this file: an algorithm, a sensor and a referee, none of which is a controller."""

import json

import numpy as np


class Wind:
    """An algorithm: gusts that push the torso of its robot, the same in every run with the same seed."""

    phase = "contact"  # before the motion of this step
    rate = 1000.0  # [Hz]
    writes = ("applied_force",)

    def __init__(self, strength=1.0):
        self.strength = strength  # [N]

    def start(self, robot, time):
        self.random = np.random.default_rng(robot.seed)
        self.gust = np.zeros(3)

    def __call__(self, robot, time):
        self.gust += 0.02 * (self.strength * self.random.normal(size=3) - self.gust)
        robot.applied_force[0, 0, :2] = self.gust[:2]  # of the base: force, then moment

    def save(self):  # what lasts from call to call, for saved states
        return json.dumps([self.random.bit_generator.state, self.gust.tolist()]).encode()

    def load(self, saved):
        state, gust = json.loads(saved)
        self.random = np.random.default_rng()
        self.random.bit_generator.state, self.gust = state, np.array(gust)


class BallRange:
    """A sensor: distance and direction of the ball, up to `longest`; nothing hides the ball from it."""

    rate = 20.0  # [Hz]
    reads = ("position", "ball.position")
    gives = {"distance": "m", "direction": ("rad", ("azimuth",))}

    def __init__(self, longest=3.0):
        self.longest = longest  # [m]

    def __call__(self, robot, time):
        x, y, _ = robot.signals["ball.position"][0] - robot.position[0]
        distance = np.hypot(x, y)
        robot.outputs["distance"] = distance if distance < self.longest else np.nan  # NaN: nothing seen
        robot.outputs["direction"] = np.arctan2(y, x)


class Referee:
    """A referee: puts the ball back when it has left the field, and ends the run after the third time."""

    phase = "observe"  # after the motion of this step
    rate = 50.0
    reads = ("walker.position",)
    writes = ("ball.position", "ball.linear_velocity")

    def __init__(self, half_length=3.0, times=3):
        self.half_length, self.times = half_length, times

    def start(self, scene, time):
        self.outs = 0

    def __call__(self, scene, time):
        ball = scene.commands["ball.position"]
        if abs(ball[0, 0]) < self.half_length:
            return
        self.outs += 1
        print(f"out for the {self.outs}. time")
        ball[0, :2] = scene.signals["walker.position"][0, :2] + (1.0, 0.0)
        scene.commands["ball.linear_velocity"][0] = (2.5, 0.0, 0.0)
        if self.outs == self.times:
            scene.end(f"the ball was out {self.outs} times")

    def save(self):
        return bytes([self.outs])

    def load(self, saved):
        self.outs = saved[0]
