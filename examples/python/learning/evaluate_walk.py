#!/usr/bin/env python3
"""A learned walk at two levels of detail and in MuJoCo: the same commands, observations and control, side by side.

    PYTHONPATH=build/release/python build/oracle-venv/bin/python examples/python/learning/evaluate_walk.py out/learn/walk.onnx

Each robot walks for 10 s, or until it falls, with a command of its own; nothing is random but the commands and, here, the posture
at the start. MuJoCo has the model that `murosimf convert` writes, the time constant of contacts of models/kid21.xml, and servos
without a limit of speed, which its format lacks.
"""

import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import gymnasium
import murosimf.envs  # noqa: F401  registers the environments
import numpy as np
from murosimf._program import program
from murosimf.envs.motion import Motion, in_base_axes
from murosimf.envs.tasks import make_task
from onnx_file import OnnxPolicy

steps = 500  # of control, 10 s


def tracked(task, motion, memory):
    """(n,) [m/s] error of the velocity in the plane."""
    velocity = in_base_axes(motion.quaternion, motion.linear_velocity)[:, :2]
    return np.linalg.norm(velocity - memory.command[:, :2], axis=1)


def table_row(returns, lengths, falls, errors):
    return {"episodes": len(returns), "return": round(float(np.mean(returns)), 1),
            "falls_per_minute": round(float(60 * np.sum(falls) / (np.sum(lengths) / 50)), 2),
            "velocity_error": round(float(np.sum(errors) / np.sum(lengths)), 3)}


def here(policy, level, rate, n):
    env = gymnasium.make_vec("murosimf/WalkVelocity-v0", num_envs=n, vectorization_mode="vector_entry_point", level=level,
                             rate=rate).unwrapped
    rows, _ = env.reset(seed=1)
    alive, returns, lengths, errors = np.ones(n, bool), np.zeros(n), np.zeros(n), np.zeros(n)
    for _ in range(steps):
        rows, rewards, fallen, _, _ = env.step(policy(rows))
        errors += alive * tracked(env.task, env._motion(), env.memory)
        returns += alive * rewards
        lengths += alive
        alive &= ~fallen
    return table_row(returns, lengths, ~alive, errors)


def mujoco_model(folder):
    """The converted kid21 on a plane."""
    import mujoco

    file = Path(folder) / "kid21.xml"
    subprocess.run([program(), "convert", "kid21", "--out", str(file)], check=True, capture_output=True)
    spec = mujoco.MjSpec.from_file(str(file))
    spec.option.timestep = 0.001
    for geom in spec.geoms:
        geom.solref[:] = [0.006, 1]  # of models/kid21.xml, which the conversion leaves out: MuJoCo's own 0.02 s is soft
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[50, 50, 0.1], contype=2, conaffinity=1,
                            solref=[0.006, 1])
    return spec.compile()


class MujocoRobot:
    """Joints in the order of the task, the base as the root of the tree."""

    def __init__(self, model, task):
        import mujoco

        self.mujoco, self.model, self.task = mujoco, model, task
        joints = [model.joint(name) for name in task.names]
        self.q, self.v = ([int(getattr(joint, at)[0]) for joint in joints] for at in ("qposadr", "dofadr"))
        self.ctrl = [model.actuator(name).id for name in task.names]
        self.data = mujoco.MjData(model)

    def start(self):
        self.mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[3:7] = [1, 0, 0, 0]
        self.data.qpos[self.q] = self.task.start
        self.data.qpos[2] = 1.0
        self.mujoco.mj_forward(self.model, self.data)
        self.data.qpos[2] -= self._lowest()
        self.mujoco.mj_forward(self.model, self.data)

    def _lowest(self):
        """[m] of the boxes of the feet, which stand level."""
        boxes = [i for i in range(self.model.ngeom) if self.model.geom_type[i] == self.mujoco.mjtGeom.mjGEOM_BOX]
        return min(self.data.geom_xpos[i][2] - self.model.geom_size[i][2] for i in boxes)

    def step(self, targets):
        self.data.ctrl[self.ctrl] = targets
        for _ in range(20):
            self.mujoco.mj_step(self.model, self.data)

    def motion(self):
        d = self.data
        turning = np.zeros(3)
        self.mujoco.mju_rotVecQuat(turning, d.qvel[3:6], d.qpos[3:7])
        upright = 1 - 2 * (d.qpos[4]**2 + d.qpos[5]**2)
        none = np.zeros((1, 0))
        return Motion(d.qpos[self.q][None], d.qvel[self.v][None], d.qpos[None, :3], d.qpos[None, 3:7], d.qvel[None, :3],
                      turning[None], np.array([upright < 0.5]), none, none)  # over 60 degrees


def in_mujoco(policy, n):
    task = make_task("WalkVelocity", {})
    random = np.random.default_rng(1)
    random.integers(2**31)  # what the environment draws first, the seed of its worlds: then commands are the same
    with tempfile.TemporaryDirectory() as folder:
        robot = MujocoRobot(mujoco_model(folder), task)
    rows = [one_in_mujoco(robot, policy, task, random) for _ in range(n)]
    return table_row(*np.array(rows, float).T)


def one_in_mujoco(robot, policy, task, random):
    """(return, steps, fallen, sum of errors)"""
    memory = task.memory(1)
    task.begin(memory, 0, random)
    robot.start()
    total = error = 0.0
    for step in range(steps):
        actions = policy(task.observe(robot.motion(), memory))
        robot.step(task.targets(actions, memory)[0])
        motion = robot.motion()
        total += float(task.reward(motion, memory, actions)[0])
        error += float(tracked(task, motion, memory)[0])
        memory.action[:] = actions
        task.advance(memory)
        if motion.fallen[0]:
            return total, step + 1, 1, error
    return total, steps, 0, error


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("policy", help="ONNX file of train_walk.py, or 'zero': the nominal gait alone")
    parser.add_argument("--robots", type=int, default=32)
    options = parser.parse_args()
    policy = (lambda rows: np.zeros((len(rows), 12), np.float32)) if options.policy == "zero" else OnnxPolicy(options.policy)
    table = {"simplified_dynamics, 500 Hz": here(policy, "simplified_dynamics", 500, options.robots),
             "articulated_dynamics, 1 kHz": here(policy, "articulated_dynamics", 1000, options.robots),
             "MuJoCo, 1 kHz": in_mujoco(policy, options.robots)}
    print(json.dumps(table, indent=2))


if __name__ == "__main__":
    main()
