#!/usr/bin/env python3
"""Control software in Python, over TCP: a robot walks to the ball.

    pip install ./python
    murosimf run examples/controllers/to_the_ball_tcp.toml --listen 5000 &
    python3 examples/controllers/walk_to_ball.py 5000 left & python3 examples/controllers/walk_to_ball.py 5000 right
"""

import math
import sys

from murosimf_client import Robot, RobotError


def walk(port, name, speed=0.15):
    with Robot(name, port, rate=20, software="walk_to_ball.py") as robot:
        ball = robot.signal("ground_truth.ball_position")  # [m] in the world
        place = robot.signal(f"ground_truth.{name}_position")  # [m]
        heading = robot.signal(f"ground_truth.{name}_heading")  # [rad]
        velocity = robot.command("walk.velocity")  # [m/s, m/s, rad/s] forward, to the left, turning
        arrived = False
        for cycle in robot.cycles():
            if cycle.start:
                arrived = False
            if cycle.start or not ball.samples:
                continue
            x, y = ball.values[0] - place.values[0], ball.values[1] - place.values[1]
            turn = math.remainder(math.atan2(y, x) - heading.values[0], 2 * math.pi)
            if math.hypot(x, y) < 0.25 and not arrived:
                arrived = True
                robot.say("I am at the ball")
            velocity.values[0] = 0.0 if arrived else speed * max(0.0, math.cos(turn))
            velocity.values[2] = 0.0 if arrived else max(-0.7, min(1.5 * turn, 0.7))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: walk_to_ball.py PORT ROBOT")
    try:
        walk(int(sys.argv[1]), sys.argv[2])
    except (RobotError, ValueError) as error:
        sys.exit(f"{sys.argv[2]}: {error}")
