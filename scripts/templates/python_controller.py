"""A controller in Python: murosimf run examples/python/controllers/new_name.toml --libraries"""

import numpy as np


class NewName:
    rate = 100.0  # [Hz] calls in a simulated second
    reads = ("joint_position",)  # properties: robot.joint_position; sensors: "imu.gyroscope" is robot.signals["imu.gyroscope"]
    writes = ("joint_target",)  # properties; commands: "walk.velocity" is robot.commands["walk.velocity"]

    def __init__(self, angle=0.8):  # options of the scene
        self.angle = angle  # [rad]

    def start(self, robot, time):
        """The run begins, or begins again: the first targets."""
        robot.joint_target["j_l_upper_arm"] = 0.0

    def __call__(self, robot, time):
        """One cycle; `time` [s] is simulated."""
        robot.joint_target["j_l_upper_arm"] = self.angle * np.sin(6 * time)

    def save(self):
        """What lasts from call to call, as bytes, for snapshots and jumps in time: nothing here."""
        return b""

    def load(self, saved):
        pass
