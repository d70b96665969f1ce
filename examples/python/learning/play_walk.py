#!/usr/bin/env python3
"""A learned walk as a controller of a scene: reads the IMU and the joints, writes targets of joints.

    PYTHONPATH=build/release/python python3 examples/python/learning/play_walk.py out/learn/walk.onnx --command 0.2 0 0
"""

import argparse

import numpy as np
from murosimf.envs.motion import Motion
from murosimf.envs.tasks import make_task
from onnx_file import OnnxPolicy

import murosimf as ms


class LearnedWalk:
    """`command`: [m/s forward, m/s to the left, rad/s]. What it sees of the base is what the IMU says, in the trunk's axes, which
    are those of the base while the joint between them is held at 0."""

    rate = 50.0

    def __init__(self, policy, task, command):
        self.policy, self.task, self.command = policy, task, command

    def start(self, robot, time):
        self.memory = self.task.memory(1)
        self.memory.command[0] = self.command

    def __call__(self, robot, time):
        imu = robot.sensors["imu"].read()
        none = np.zeros((1, 3))
        quaternion = imu["orientation"][None]
        motion = Motion(np.array(robot.joint_position)[None], np.array(robot.joint_velocity)[None], none, quaternion, none,
                        in_world_axes(quaternion, imu["gyroscope"][None]), np.zeros(1, bool), none, none)
        actions = self.policy(self.task.observe(motion, self.memory))
        robot.joint_target[:] = self.task.targets(actions, self.memory)[0]
        self.memory.action[:] = actions
        self.task.advance(self.memory)


def in_world_axes(quaternion, vectors):
    """(n, 3) of base axes: v + 2 w (u x v) + 2 u x (u x v), u the quaternion's vector."""
    w, u = quaternion[:, :1], quaternion[:, 1:]
    once = np.cross(u, vectors)
    return vectors + 2 * w * once + 2 * np.cross(u, once)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("policy", help="ONNX file of train_walk.py")
    parser.add_argument("--command", type=float, nargs=3, default=(0.2, 0.0, 0.0))
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--level", default="articulated_dynamics")
    parser.add_argument("--record", help="MCAP file to write")
    options = parser.parse_args()
    task = make_task("WalkVelocity", {"level": options.level})
    scene = ms.Scene("walk", set={"walker.level": options.level, "walker.controller": "none"})
    walker = scene["walker"]
    walker.controller = LearnedWalk(OnnxPolicy(options.policy), task, options.command)
    start = np.array(walker.position)
    if options.record:
        with scene.record(options.record):
            scene.run(options.seconds)
    else:
        scene.run(options.seconds)
    moved = walker.position - start
    print(f"{options.level}: {moved[0]:+.2f} m forward, {moved[1]:+.2f} m to the left in {scene.time:.1f} s, "
          f"{walker.falls} falls")


if __name__ == "__main__":
    main()
