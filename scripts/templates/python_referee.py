"""A referee in Python: murosimf run examples/python/algorithms/new_name.toml --libraries"""


class NewName:
    phase = "observe"  # after the motion of a step
    rate = 50.0  # [Hz] calls in a simulated second
    reads = ("ball.position",)  # properties, with their entity: scene.signals["ball.position"]
    writes = ()  # likewise: scene.commands["ball.linear_velocity"]

    def __init__(self, way=1.0):  # options of the scene
        self.way = way  # [m]

    def start(self, scene, time):
        """The run begins, or begins again."""
        self.first = scene.signals["ball.position"][0, 0]

    def __call__(self, scene, time):
        """One call; `time` [s] is simulated."""
        if abs(scene.signals["ball.position"][0, 0] - self.first) > self.way:
            scene.end(f"the ball has rolled {self.way:g} m")  # the reports say so, and the exit code is 0

    def save(self):
        """What lasts from call to call, as bytes, for states and jumps in time."""
        return str(self.first).encode()

    def load(self, saved):
        self.first = float(saved)
