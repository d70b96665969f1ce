#!/usr/bin/env python3
"""Compares forward and inverse dynamics of random robots with Pinocchio, which reads the same MJCF files.

Usage: random_trees_against_pinocchio.py <dump_dynamics>
Exit: 0 all agree, 1 some differ, 77 Pinocchio is not installed (test is skipped).

Pinocchio's free joint has position and quaternion x y z w, and velocity and acceleration [v; w] of the base's origin
in the base's axes; a is a spatial acceleration, so that the origin's own is a + w x v.
"""
import pathlib
import sys
import tempfile

try:
    import numpy as np
    import pinocchio
    from pinocchio import buildModelFromMJCF  # not there without support for MJCF
except (ImportError, AttributeError) as missing:
    print(f"skipped: {missing}; pip install pin (3 or newer)")
    sys.exit(77)

from comparison import Worst, run
from random_models import make_robots, make_states, rotation, write_states

ROBOTS, STATES = 60, 5
# as for MuJoCo
TOLERANCES = {"base acceleration": 1e-10, "joint accelerations": 1e-10, "inverse dynamics": 1e-12}


class Engine:
    """Pinocchio's answers in our order and frames."""

    def __init__(self, file, robot):
        self.model = buildModelFromMJCF(str(file))
        self.data = self.model.createData()
        self.frames = [self.model.getFrameId(body.name, pinocchio.FrameType.BODY) for body in robot.bodies]
        # joints of one body become one joint of several degrees of freedom
        self.dofs = []
        for body, frame in zip(robot.bodies, self.frames, strict=True):
            first = self.model.idx_vs[self.model.frames[frame].parentJoint]
            self.dofs += [] if body is robot.bodies[0] else [first + k for k in range(len(body.joints))]
        if sorted(self.dofs) != list(range(6, self.model.nv)):
            raise ValueError(f"{file}: Pinocchio finds other degrees of freedom: {self.dofs} of {self.model.nv}")

    def set_state(self, state):
        self.turn = rotation(state.quaternion)
        self.base_velocity = self.turn.T @ state.velocity, self.turn.T @ state.rate
        self.q = np.zeros(self.model.nq)
        self.v = np.zeros(self.model.nv)
        self.torque = np.zeros(self.model.nv)
        w, x, y, z = state.quaternion
        self.q[:7] = [*state.position, x, y, z, w]
        self.v[:6] = np.concatenate(self.base_velocity)
        self.q[[dof + 1 for dof in self.dofs]] = state.q
        self.v[self.dofs] = state.qd
        self.torque[self.dofs] = state.torque
        pinocchio.framesForwardKinematics(self.model, self.data, self.q)
        self.forces = self.joint_forces(state)

    def joint_forces(self, state):
        """The wrenches on the bodies, each in the frame of the joint that carries it."""
        forces = [pinocchio.Force.Zero() for _ in range(self.model.njoints)]
        for number, wrench in zip(self.frames, state.wrenches, strict=True):
            frame = self.model.frames[number]
            turn = self.data.oMf[number].rotation
            local = pinocchio.Force(turn.T @ wrench[3:], turn.T @ wrench[:3])
            forces[frame.parentJoint] += frame.placement.act(local)
        return forces

    def acceleration(self):
        a = pinocchio.aba(self.model, self.data, self.q, self.v, self.torque, self.forces)
        v, w = self.base_velocity
        return np.concatenate([self.turn @ a[3:6], self.turn @ (a[:3] + np.cross(w, v)), a[self.dofs]])

    def inverse(self, state):
        a = np.zeros(self.model.nv)
        v, w = self.base_velocity
        a[:3] = self.turn.T @ state.acceleration[3:6] - np.cross(w, v)
        a[3:6] = self.turn.T @ state.acceleration[:3]
        a[self.dofs] = state.acceleration[6:]
        f = pinocchio.rnea(self.model, self.data, self.q, self.v, a, self.forces)
        return np.concatenate([self.turn @ f[3:6], self.turn @ f[:3], f[self.dofs]])


def compare(robot, folder, dump_dynamics, worst):
    file = robot.write(folder / "robot.xml")
    states = make_states(robot, STATES)
    ours = run(dump_dynamics, file, write_states(folder / "states", robot, states))
    engine = Engine(file, robot)
    for number, (state, mine) in enumerate(zip(states, ours, strict=True)):
        case = f"{robot.name}, {len(robot.joints)} joints, state {number}"
        engine.set_state(state)
        acceleration = engine.acceleration()
        worst.add("base acceleration", case, mine["acceleration"][:6], acceleration[:6])
        worst.add("joint accelerations", case, mine["acceleration"][6:], acceleration[6:])
        worst.add("inverse dynamics", case, mine["forces"], engine.inverse(state))


def main():
    worst = Worst(TOLERANCES)
    with tempfile.TemporaryDirectory() as folder:
        for robot in make_robots(ROBOTS):
            compare(robot, pathlib.Path(folder), sys.argv[1], worst)
    print(f"Pinocchio {pinocchio.__version__}, {ROBOTS} robots in {STATES} states each")
    return worst.report()


if __name__ == "__main__":
    sys.exit(main())
