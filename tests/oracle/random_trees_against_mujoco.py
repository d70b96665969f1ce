#!/usr/bin/env python3
"""Compares forward and inverse dynamics, mass matrix and energies of random robots with MuJoCo.

Usage: random_trees_against_mujoco.py <dump_dynamics>
Exit: 0 all agree, 1 some differ, 77 MuJoCo is not installed (test is skipped).

MuJoCo's free joint has the velocity [v; w] with v in world axes and w in the body's; ours is [w; v] in world axes.
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
from random_models import make_robots, make_states, rotation, write_states

ROBOTS, STATES = 60, 5
# Both sides compute in double. Errors of accelerations grow with the condition of the mass matrix, which is worst for
# long chains without armature.
TOLERANCES = {
    "base acceleration": 1e-10,
    "joint accelerations": 1e-10,
    "inverse dynamics": 1e-12,
    "mass matrix": 1e-12,
    "kinetic energy": 1e-12,
    "potential energy": 1e-12,
}
# For versions of MuJoCo that turn fullinertia into principal moments to about 1e-7 only.
ROUGH = 1e-6


def is_exact():
    """Whether MuJoCo's principal moments and axes make up the tensor of the file again."""
    tensor = np.array([[1.0, 0.1, 0.2], [0.1, 1.5, 0.05], [0.2, 0.05, 1.1]])
    text = " ".join(repr(float(tensor[k])) for k in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)])
    model = mujoco.MjModel.from_xml_string(
        "<mujoco><worldbody><body><freejoint/>"
        f'<inertial pos="0 0 0" mass="1" fullinertia="{text}"/></body></worldbody></mujoco>'
    )
    turn = rotation(model.body_iquat[1])
    return np.abs(turn @ np.diag(model.body_inertia[1]) @ turn.T - tensor).max() < 1e-13


class Engine:
    """MuJoCo's answers in our order and frames."""

    def __init__(self, file, robot):
        self.model = mujoco.MjModel.from_xml_path(str(file))
        self.data = mujoco.MjData(self.model)
        joints = [self.model.joint(name) for name in robot.joints]
        self.positions = [joint.qposadr[0] for joint in joints]
        self.dofs = [joint.dofadr[0] for joint in joints]
        self.bodies = [self.model.body(body.name).id for body in robot.bodies]
        if self.model.nv != 6 + len(joints):
            raise ValueError(f"{file}: MuJoCo finds {self.model.nv} degrees of freedom, not {6 + len(joints)}")

    def set_state(self, state):
        data = self.data
        mujoco.mj_resetData(self.model, data)
        self.turn = rotation(state.quaternion)
        data.qpos[:7] = [*state.position, *state.quaternion]
        data.qvel[:6] = [*state.velocity, *(self.turn.T @ state.rate)]
        data.qpos[self.positions] = state.q
        data.qvel[self.dofs] = state.qd
        data.qfrc_applied[self.dofs] = state.torque
        mujoco.mj_kinematics(self.model, data)
        for body, wrench in zip(self.bodies, state.wrenches, strict=True):
            moment, force = wrench[:3], wrench[3:]
            lever = data.xipos[body] - data.xpos[body]  # MuJoCo pushes at the center of mass
            data.xfrc_applied[body] = [*force, *(moment - np.cross(lever, force))]

    def acceleration(self):
        mujoco.mj_forward(self.model, self.data)
        qacc = self.data.qacc
        return np.concatenate([self.turn @ qacc[3:6], qacc[:3], qacc[self.dofs]])

    def energies(self):
        """Kinetic and potential; the former by hand, since old versions leave it wrong in data.energy."""
        momentum = np.zeros(self.model.nv)
        mujoco.mj_mulM(self.model, self.data, momentum, self.data.qvel)
        return 0.5 * momentum @ self.data.qvel, self.data.energy[0]

    def forces(self, state):
        """Besides those of the state, which MuJoCo's inverse dynamics leaves in."""
        data = self.data
        a = state.acceleration
        data.qacc[:6] = [*a[3:6], *(self.turn.T @ a[:3])]
        data.qacc[self.dofs] = a[6:]
        mujoco.mj_inverse(self.model, data)
        given = np.zeros(self.model.nv)
        for body, wrench in zip(self.bodies, state.wrenches, strict=True):
            mujoco.mj_applyFT(self.model, data, wrench[3:], wrench[:3], data.xpos[body], body, given)
        left = data.qfrc_inverse - given
        return np.concatenate([self.turn @ left[3:6], left[:3], left[self.dofs]])

    def mass_matrix(self):
        M = np.zeros((self.model.nv, self.model.nv))
        for row, unit in zip(M, np.eye(self.model.nv), strict=True):
            mujoco.mj_mulM(self.model, self.data, row, unit)  # how mj_fullM is called changes with the version
        to_ours = np.zeros_like(M)  # our velocity from MuJoCo's
        to_ours[:3, 3:6] = self.turn
        to_ours[3:6, :3] = np.eye(3)
        to_ours[range(6, self.model.nv), self.dofs] = 1
        return to_ours @ M @ to_ours.T  # it is orthogonal


def scaled(ours, theirs):
    """Both matrices in units in which the diagonal is 1, so that no entry hides behind larger ones."""
    root = np.sqrt(np.diag(theirs))
    scale = np.outer(root, root)
    return np.reshape(ours, scale.shape) / scale, theirs / scale


def compare(robot, folder, dump_dynamics, worst):
    file = robot.write(folder / "robot.xml")
    states = make_states(robot, STATES)
    ours = run(dump_dynamics, file, write_states(folder / "states", robot, states))
    engine = Engine(file, robot)
    for number, (state, mine) in enumerate(zip(states, ours, strict=True)):
        case = f"{robot.name}, {len(robot.joints)} joints, state {number}"
        engine.set_state(state)
        acceleration = engine.acceleration()
        kinetic, potential = engine.energies()
        worst.add("base acceleration", case, mine["acceleration"][:6], acceleration[:6])
        worst.add("joint accelerations", case, mine["acceleration"][6:], acceleration[6:])
        worst.add("inverse dynamics", case, mine["forces"], engine.forces(state))
        worst.add("mass matrix", case, *scaled(mine["mass_matrix"], engine.mass_matrix()))
        worst.add("kinetic energy", case, mine["kinetic"], kinetic)
        worst.add("potential energy", case, mine["potential"], potential)


def main():
    worst = Worst(TOLERANCES if is_exact() else dict.fromkeys(TOLERANCES, ROUGH))
    with tempfile.TemporaryDirectory() as folder:
        for robot in make_robots(ROBOTS):
            compare(robot, pathlib.Path(folder), sys.argv[1], worst)
    print(f"MuJoCo {mujoco.__version__}, {ROBOTS} robots in {STATES} states each")
    return worst.report()


if __name__ == "__main__":
    sys.exit(main())
