"""An algorithm in Python: murosimf run examples/python/algorithms/new_name.toml --libraries"""


class NewName:
    phase = "contact"  # before the motion of a step: forces; "observe", after it: places and velocities
    rate = 1000.0  # [Hz] calls in a simulated second
    reads = ("linear_velocity",)  # properties of the robot; with a dot those of others: "ball.position"
    writes = ("applied_force",)  # held until the next call

    def __init__(self, damping=2.0):  # options of the scene
        self.damping = damping  # [N s/m]

    def __call__(self, robot, time):
        """One call; `time` [s] is simulated. Force and moment at the base, world axes."""
        robot.applied_force[0, 0] = -self.damping * robot.linear_velocity[0]

    def save(self):
        """What lasts from call to call, as bytes, for states and jumps in time: nothing here."""
        return b""

    def load(self, saved):
        pass
