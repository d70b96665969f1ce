#!/usr/bin/env python3
"""Robots that `murosimf convert` writes, in other programs: URDF in Pinocchio, MJCF in MuJoCo.

Mass matrices in random postures, base at the origin: of the written URDF by Pinocchio, of the written MJCF by MuJoCo,
against those of the file that both were made from, by MuJoCo or Pinocchio. Armatures are taken away: URDF has none. The
written MJCF, on a floor and from its key, then steps for a second: it has actuators, nothing becomes NaN, and a robot
whose actuators all hold their places does not fall.

Usage: written_robots.py <murosimf> <folder of models> <folder of data> [files ...]     (with files: these alone)
Exit: 0 all agree, 1 some differ, 77 MuJoCo or Pinocchio is not installed (test is skipped).
"""
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import mujoco
    import numpy as np
    import pinocchio
except ImportError as missing:
    print(f"skipped: {missing}; pip install mujoco pin")
    sys.exit(77)

from comparison import Worst

STATES = 10
OWN = ["models/kid21.xml", "models/quadruped.xml", "models/car.xml", "models/booster_k1.xml",
       *(f"models/spark_nao{i}.xml" for i in range(5)),
       "examples/data/robot.urdf"]
TEAMS = ["booster_k1/K1_22dof.urdf", "booster_k1/K1_22dof.xml", "wolfgang_op/wolfgang_description/urdf/robot.urdf"]
TOLERANCES = {
    "mass matrix of URDF": 1e-9,  # [kg m^2], six digits more than its entries need
    "mass matrix of MJCF": 1e-7,  # [kg m^2] MuJoCo finds principal axes to about 1e-8
}
SCENE = """<mujoco><include file="{robot}"/><option timestep="0.001"/>
<worldbody><geom type="plane" size="9 9 1"/></worldbody></mujoco>"""


def convert(program, source, out):
    done = subprocess.run([program, "convert", str(source), "--out", str(out), "--force"], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{source}: {done.stderr.strip()}")
    return out


class InMujoco:
    def __init__(self, file):
        self.model = mujoco.MjModel.from_xml_path(str(file))
        self.data = mujoco.MjData(self.model)
        kinds = {i: self.model.jnt_type[i] for i in range(self.model.njnt)}
        self.free = [i for i, kind in kinds.items() if kind == mujoco.mjtJoint.mjJNT_FREE]
        self.joints = {mujoco.mj_id2name(self.model, mujoco.mjtObj.mjOBJ_JOINT, i): i for i in kinds if i not in self.free}

    def mass_matrix(self, positions):
        model, data = self.model, self.data
        data.qpos[:7] = [0, 0, 0, 1, 0, 0, 0]
        for name, i in self.joints.items():
            data.qpos[model.jnt_qposadr[i]] = positions[name]
        mujoco.mj_forward(model, data)
        full = np.zeros((model.nv, model.nv))
        try:
            mujoco.mj_fullM(model, data, full)  # MuJoCo 4
        except TypeError:
            mujoco.mj_fullM(model, full, data.qM)
        full -= np.diag(model.dof_armature)
        order = list(range(6)) + [model.jnt_dofadr[self.joints[name]] for name in sorted(self.joints)]
        return full[np.ix_(order, order)]


class InPinocchio:
    def __init__(self, file):
        self.model = pinocchio.buildModelFromUrdf(str(file), pinocchio.JointModelFreeFlyer())
        self.data = self.model.createData()
        self.joints = {name: i for i, name in enumerate(self.model.names) if i > 1}

    def mass_matrix(self, positions):
        model, q = self.model, pinocchio.neutral(self.model)
        for name, i in self.joints.items():
            a, value = model.joints[i].idx_q, positions[name]
            q[a:a + model.joints[i].nq] = [value] if model.joints[i].nq == 1 else [np.cos(value), np.sin(value)]
        pinocchio.crba(model, self.data, q)
        upper = np.triu(self.data.M)
        full = upper + np.triu(upper, 1).T - np.diag(model.armature)
        order = list(range(6)) + [model.joints[self.joints[name]].idx_v for name in sorted(self.joints)]
        return full[np.ix_(order, order)]


def compare(worst, kind, name, found, expected, random):
    if sorted(found.joints) != sorted(expected.joints):
        raise RuntimeError(f"{name}: joints {sorted(set(found.joints) ^ set(expected.joints))} are in one file only")
    for _ in range(STATES):
        positions = {joint: random.uniform(-1.5, 1.5) for joint in found.joints}
        difference = found.mass_matrix(positions) - expected.mass_matrix(positions)
        worst.note(kind, name, np.max(np.abs(difference)))


def stand(robot, file, name):
    scene = file.with_name("scene_" + file.name)
    scene.write_text(SCENE.format(robot=file.name), encoding="utf-8")
    model = mujoco.MjModel.from_xml_path(str(scene))
    data = mujoco.MjData(model)
    if model.nu == 0:
        raise RuntimeError(f"{name}: no actuators")
    mujoco.mj_resetDataKeyframe(model, data, 0)
    heights = []
    for _ in range(1000):
        mujoco.mj_step(model, data)
        heights.append(data.qpos[2])
    if not np.isfinite(data.qpos).all() or data.warning[mujoco.mjtWarning.mjWARN_BADQACC].number > 0:
        raise RuntimeError(f"{name}: MuJoCo's state is no number")
    holds = (model.actuator_biasprm[:, 1] < 0).all()
    if holds and heights[-1] < 0.9 * heights[0]:
        raise RuntimeError(f"{name}: falls from {heights[0]:.3f} m to {heights[-1]:.3f} m")
    return f"{model.nu} actuators, base {heights[0]:.3f} m high, {heights[-1]:.3f} m after 1 s"


def check(worst, program, source, folder, random):
    name = source.name
    urdf = InPinocchio(convert(program, source, folder / "robot.urdf"))
    mjcf_file = convert(program, source, folder / "robot_mjcf.xml")
    mjcf = InMujoco(mjcf_file)
    original = InPinocchio(source) if source.suffix == ".urdf" else InMujoco(source)
    compare(worst, "mass matrix of URDF", name, urdf, original, random)
    compare(worst, "mass matrix of MJCF", name, mjcf, original, random)
    print(f"{name}: {stand(mjcf, mjcf_file, name)}")


def main():
    program, models, data = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    sources = [models.parent / file for file in OWN] + [data / "robots" / file for file in TEAMS]
    sources = [Path(file) for file in sys.argv[4:]] or [path for path in sources if path.exists()]
    worst, failed = Worst(TOLERANCES), 0
    for source in sources:
        with tempfile.TemporaryDirectory() as folder:
            try:
                check(worst, program, source, Path(folder), np.random.default_rng(1))
            except (RuntimeError, ValueError) as error:
                failed += 1
                print(f"FAILED {source}: {error}")
    return max(worst.report(), int(failed > 0))


if __name__ == "__main__":
    sys.exit(main())
