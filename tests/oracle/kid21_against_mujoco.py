#!/usr/bin/env python3
"""Compares poses of kid21 with those that MuJoCo finds for the same file and the same joint positions.

Usage: kid21_against_mujoco.py <dump_poses> <kid21.xml>
Exit: 0 all agree, 1 some differ, 77 MuJoCo is not installed (test is skipped).
"""
import json
import subprocess
import sys

try:
    import mujoco
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install mujoco")
    sys.exit(77)

# [m], [1], [kg] both sides compute in double; the error is a few roundings along a chain of seven joints
TOLERANCE = 1e-9


def frame(model, data, name):
    """Position and rotation matrix of a joint's body, or of a site, world frame."""
    joint = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name)
    if joint >= 0:
        body = model.jnt_bodyid[joint]
        return data.xpos[body], data.xmat[body]
    site = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, name)
    if site < 0:
        sys.exit(f"MuJoCo knows no joint or site '{name}'")
    return data.site_xpos[site], data.site_xmat[site]


def set_state(model, data, base, q):
    data.qpos[:7] = [*base, 1, 0, 0, 0]
    for name, value in q.items():
        data.qpos[model.jnt_qposadr[mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name)]] = value
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)


def errors(model, data, state):
    """(what, largest difference) of every quantity of one state."""
    for name, pose in state["objects"].items():
        position, matrix = frame(model, data, name)
        yield f"position of {name}", np.abs(position - pose["position"]).max()
        yield f"orientation of {name}", np.abs(matrix - np.ravel(pose["orientation"])).max()
    yield "common center of mass", np.abs(data.subtree_com[1] - state["center_of_mass"]).max()


def main():
    dump_poses, robot = sys.argv[1:3]
    ours = json.loads(subprocess.run([dump_poses, robot], check=True, capture_output=True, text=True).stdout)
    model = mujoco.MjModel.from_xml_path(robot)
    data = mujoco.MjData(model)
    found = [("total mass", abs(model.body_subtreemass[1] - ours["total_mass"]))]
    for state in ours["states"]:
        if len(state["q"]) != model.njnt - 1:
            sys.exit(f"{len(state['q'])} joints here, {model.njnt - 1} in MuJoCo")
        set_state(model, data, ours["base"], state["q"])
        found.extend(errors(model, data, state))
    what, worst = max(found, key=lambda entry: entry[1])
    print(f"{len(found)} quantities in {len(ours['states'])} states, largest difference {worst:.3g} ({what})")
    # written so that NaN fails
    return 0 if all(error <= TOLERANCE for _, error in found) else 1


if __name__ == "__main__":
    sys.exit(main())
