#!/usr/bin/env python3
"""What Python adds: step() for each step against one call for many, joints read and written, a controller in Python, the import.

    PYTHONPATH=build/release/python python benchmarks/python/step_call.py

Times are of the processor, the least of 15 turns each, taken in turns, so that other programs disturb all alike.
"""

import subprocess
import sys
import time

import murosimf as ms


def turns(cases, steps=2000, count=15):
    """The least microseconds per step of each case."""
    least = dict.fromkeys(cases, float("inf"))
    for _ in range(count):
        for name, run in cases.items():
            begin = time.process_time_ns()
            run(steps)
            least[name] = min(least[name], (time.process_time_ns() - begin) / steps / 1000)
    return least


def robot(level):
    scene = ms.Scene.of_robot("kid21", set={"robot.level": level}, cameras=False)
    scene.run(1.0)
    return scene


def cases_of(level):
    inside, calls, reads, control = (robot(level) for _ in range(4))
    q, target = reads.robot.joint_position, reads.robot.joint_target
    rest = target.copy()

    def controller(robot, time):
        robot.joint_target[:] = rest

    controller_object = type("Hold", (), {"rate": 1000.0, "__call__": lambda self, robot, time: controller(robot, time)})()
    control.robot.controller = controller_object

    def by_calls(steps):
        for _ in range(steps):
            calls.step()

    def with_arrays(steps):
        for _ in range(steps):
            target[:] = rest
            reads.step()
            q[3]

    return {
        "steps inside one call": inside.step,
        "step() called for each": by_calls,
        "targets written, step(), a position read": with_arrays,
        "controller in Python at the rate of the steps": control.step,
    }


def import_time():
    code = "import time, numpy\nbegin = time.process_time()\nimport murosimf\nprint(time.process_time() - begin)"
    return min(float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)
               for _ in range(7))


def main():
    for level in ("articulated_dynamics", "simplified_dynamics"):
        least = turns(cases_of(level))
        first = next(iter(least.values()))
        for name, us in least.items():
            print(f"{level:21} {name:46} {us:6.2f} us a step, {us - first:+5.2f} us")
    print(f"import, beyond NumPy: {1000 * import_time():.1f} ms")


if __name__ == "__main__":
    main()
