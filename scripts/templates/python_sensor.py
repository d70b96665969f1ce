"""A sensor in Python: murosimf run examples/python/algorithms/new_name.toml --libraries"""


class NewName:
    rate = 50.0  # [Hz] samples in a simulated second
    reads = ("position",)  # of the robot; with a dot those of others: "ball.position" is robot.signals["ball.position"]
    gives = {"height": "m"}  # outputs with their units; {"force": ("N", ("x", "y", "z"))} has three numbers

    def __init__(self, offset=0.0):  # options of the scene
        self.offset = offset  # [m]

    def __call__(self, robot, time):
        """One sample; `time` [s] is simulated. Control software reads it as new_name.height."""
        robot.outputs["height"] = robot.position[0, 2] + self.offset
