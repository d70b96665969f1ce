"""A controller in Python: murosimf run examples/python/controllers/sway.toml --libraries

Stands and sways: shifts its weight from foot to foot by hips and ankles, in time with the options of the scene. While the torso
leans beyond a limit, as the robot's own accelerometer says, it waits.
"""

import numpy as np


class Sway:
    rate = 100.0  # [Hz]
    reads = ("joint_position", "imu.accelerometer")
    writes = ("joint_target",)

    def __init__(self, angle=0.05, frequency=0.5, limit=0.2):
        self.angle, self.frequency, self.limit = angle, frequency, limit  # [rad], [Hz], [rad]

    def start(self, robot, time):
        """The run begins, or begins again."""
        self.rest = robot.joint_target.copy()
        self.phase = 0.0

    def __call__(self, robot, time):
        force = robot.signals["imu.accelerometer"]
        lean = np.arctan2(np.hypot(force[0], force[1]), force[2]) if time > 0.1 else 0.0
        if lean < self.limit:
            self.phase += 2 * np.pi * self.frequency / self.rate
        roll = self.angle * np.sin(self.phase)
        robot.joint_target = self.rest
        for side in "lr":
            robot.joint_target[f"j_{side}_hip_roll"] += roll
            robot.joint_target[f"j_{side}_foot"] -= roll

    def save(self):
        return np.array([self.phase, *self.rest]).tobytes()

    def load(self, saved):
        self.phase, *self.rest = np.frombuffer(saved)
