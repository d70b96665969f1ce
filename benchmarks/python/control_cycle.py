#!/usr/bin/env python3
"""What a cycle of control costs: a built-in controller, and classes in Python.

    PYTHONPATH=build/release/python python3 benchmarks/python/control_cycle.py

One kid21 at articulated_dynamics, 1 kHz, a cycle in every step; runs in turns, the least of five each.
Wall time, of the program's report.
"""

import json
import subprocess
import tempfile
from pathlib import Path

from murosimf._program import environment, program

ROUNDS, SECONDS = 5, 4.0

CLASSES = '''
import numpy as np

class Nothing:
    def __call__(self, robot, time):
        pass

class Wave:
    def __call__(self, robot, time):
        robot.joint_target["j_l_upper_arm"] = 0.5 * np.sin(6 * time)

class Player:
    """What the built-in `trajectory` does: all joints from a table, by linear interpolation."""
    times = np.array([0.0, 1.0, 2.0])
    values = np.array([[0.0] * 21, [0.1] * 21, [0.0] * 21])

    def __call__(self, robot, time):
        time %= 2.0
        last = int(time)
        share = time - self.times[last]
        robot.joint_target[:] = self.values[last] + share * (self.values[last + 1] - self.values[last])

class Feedback:
    """PD in Python, with a sensor and the truth."""
    reads = ("joint_position", "joint_velocity", "imu.gyroscope", "position")
    writes = ("joint_target",)
    def __call__(self, robot, time):
        lean = robot.signals["imu.gyroscope"][1]
        robot.joint_target[:] = -0.1 * robot.joint_position - 0.01 * robot.joint_velocity
        robot.joint_target["j_l_foot"] += 0.01 * lean
'''

SCENE = """name = "Cycle"
[[robots]]
name = "robot"
model = "kid21"
level = "articulated_dynamics"
control_rate = 1000
controller = "{controller}"
options = {{{options}}}
"""


def run(folder: Path, controller: str, options: str) -> float:
    """[us] of a cycle"""
    (folder / "cycle.toml").write_text(SCENE.format(controller=controller, options=options))
    arguments = [program(), "run", folder / "cycle.toml", "--duration", SECONDS, "--json", "-", "--libraries"]
    done = subprocess.run(list(map(str, arguments)), capture_output=True, text=True, check=True, env=environment())
    report = json.loads(done.stdout)
    if report["control"]:
        assert not report["control"][0]["ended"], report["control"][0]["ended"]
    name = "trajectory_player" if controller == "trajectory" else "control_software"
    return next(float(one["us_per_call"]) for one in report["algorithms"] if one["name"] == name)


def main() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "cycle.py").write_text(CLASSES)
        rows = "".join(f"{t},{v},{v}\n" for t, v in ((0, 0), (1, 0.1), (2, 0)))
        (folder / "gait.csv").write_text("time [s],j_l_upper_arm [rad],j_r_upper_arm [rad]\n" + rows)
        kinds = {"built-in: trajectory": ("trajectory", 'file = "gait.csv", loop = true')}
        for cls in ("Nothing", "Wave", "Player", "Feedback"):
            kinds[f"class: {cls}"] = ("python", f'class = "cycle:{cls}"')
        least = dict.fromkeys(kinds, float("inf"))
        for _ in range(ROUNDS):
            for kind, (controller, options) in kinds.items():
                least[kind] = min(least[kind], run(folder, controller, options))
    for kind, cost in least.items():
        print(f"{kind:24} {cost:6.2f} us a cycle")


if __name__ == "__main__":
    main()
