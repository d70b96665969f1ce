#!/usr/bin/env python3
"""Compares half a second of flight with that of MuJoCo: servos, damping and gravity on random robots.

Usage: trajectories_against_mujoco.py <dump_trajectory>
Exit: 0 all agree, 1 some differ, 77 MuJoCo is not installed (test is skipped).

MuJoCo takes steps of 0.1 ms with RK4, whose error does not count here. Ours is of first order: half the step must
halve the difference, and what is extrapolated from two steps, 2 x(h/2) - x(h), must come much closer.
"""
import pathlib
import sys
import tempfile

try:
    import mujoco
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install mujoco")
    sys.exit(77)

from comparison import Worst, run
from random_models import make_robot, make_states, rotation, write_states

JOINTS = [3, 4, 6, 8, 10, 12, 14, 16, 18, 20]
STATES = 2
ROWS, ROW_TIME, STEP = 50, 0.01, 1e-4  # [1], [s], [s]
COARSE, FINE = 4000, 8000  # [Hz]
# [m], [rad] or [rad | m]: base position, base orientation, joint positions. Free fall alone gives g h T/2 = 0.6 mm.
TOLERANCES = {
    "at 4 kHz": 1.5e-3,
    "share left, minus 0.5": 0.01,  # of the difference, with half the step
    "extrapolated": 3e-5,
}


def gentle(states):
    """The same robots with less haste: their joints start near their targets."""
    for state in states:
        state.q *= 0.3
        state.qd *= 0.5
        state.torque = state.q + 0.06 * state.torque  # targets
    return states


def reference(file, robot, state):
    """MuJoCo's rows: base position and quaternion, joint positions in our order."""
    model = mujoco.MjModel.from_xml_path(str(file))
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
    model.opt.timestep = STEP
    data = mujoco.MjData(model)
    joints = [model.joint(name) for name in robot.joints]
    order = [joint.id for joint in joints]
    positions = [joint.qposadr[0] for joint in joints]
    data.qpos[:7] = [*state.position, *state.quaternion]
    data.qpos[positions] = state.q
    data.qvel[:6] = [*state.velocity, *(rotation(state.quaternion).T @ state.rate)]
    data.qvel[[joint.dofadr[0] for joint in joints]] = state.qd
    data.ctrl[:] = [state.torque[order.index(joint)] for joint in model.actuator_trnid[:, 0]]
    rows = []
    for _ in range(ROWS):
        mujoco.mj_step(model, data, nstep=round(ROW_TIME / STEP))
        rows.append(np.concatenate([data.qpos[:7], data.qpos[positions]]))
    return np.array(rows)


def difference(ours, theirs):
    """Largest differences of base position [m], base orientation [rad] and joint positions [rad | m]."""
    turn, their_turn = ours[:, 3:7], theirs[:, 3:7]
    same_sign = np.sign((turn * their_turn).sum(axis=1, keepdims=True))
    half_angle = np.linalg.norm(turn - same_sign * their_turn, axis=1)
    return np.array([largest(ours[:, :3] - theirs[:, :3]), 2 * half_angle.max(), largest(ours[:, 7:] - theirs[:, 7:])])


def largest(numbers):
    return np.abs(numbers).max()


def compare(robot, folder, dump_trajectory, worst):
    file = robot.write(folder / "robot.xml")
    states = gentle(make_states(robot, STATES))
    state_file = write_states(folder / "states", robot, states)
    ours = [np.array(run(dump_trajectory, file, state_file, rate)) for rate in (COARSE, FINE)]
    for number, state in enumerate(states):
        case = f"{robot.name}, {len(robot.joints)} joints, state {number}"
        theirs = reference(file, robot, state)
        coarse, fine = (trajectory[number] for trajectory in ours)
        at_coarse, at_fine = difference(coarse, theirs), difference(fine, theirs)
        worst.note("at 4 kHz", case, at_coarse.max())
        worst.note("share left, minus 0.5", case, largest(at_fine / at_coarse - 0.5))
        worst.note("extrapolated", case, difference(2 * fine - coarse, theirs).max())


def main():
    worst = Worst(TOLERANCES)
    with tempfile.TemporaryDirectory() as folder:
        for seed, joints in enumerate(JOINTS):
            compare(make_robot(1000 + seed, joints, servos=True), pathlib.Path(folder), sys.argv[1], worst)
    print(f"MuJoCo {mujoco.__version__}, {len(JOINTS)} robots in {STATES} flights each")
    return worst.report()


if __name__ == "__main__":
    sys.exit(main())
