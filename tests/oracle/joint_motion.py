"""How joints of an MJCF file move in MuJoCo and here: what comparisons of such motions share."""
import csv
import subprocess
import sys

import mujoco
import numpy as np

STEP = 1e-4  # [s] of MuJoCo
SCENE = """duration = {end}
rate = 1000
[field]
goals = false
[[robots]]
name = "a"
model = "robot.xml"
level = "{level}"
controller = "none"
position = [0, 0, 1]
"""


def in_mujoco(text, joints, times, control=None):
    """Positions of joints at times, row by row; from the first key, if there is one, else with one control for all actuators."""
    model = mujoco.MjModel.from_xml_string(text)
    model.opt.timestep = STEP
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    elif control is not None:
        data.ctrl[:] = control
    rows = []
    for time in times:
        while data.time < time - 0.5 * STEP:
            mujoco.mj_step(model, data)
        rows.append([data.joint(name).qpos[0] for name in joints])
    return np.array(rows)


def logged(program, folder, text, properties, end, keys="", events=(), level="articulated_dynamics"):
    """(times, values by row) of properties of the robot `a`; `keys`: more of its scene, `events`: (time, what to set)."""
    scene, log = folder / "scene.toml", folder / "log.csv"
    (folder / "robot.xml").write_text(text, encoding="utf-8")
    sets = "".join(f'[[events]]\ntime = {time}\nset = ["{what}"]\n' for time, what in events)
    scene.write_text(SCENE.format(end=end, level=level) + keys + sets, encoding="utf-8")
    wanted = [word for name in properties for word in ("--log", f"a.{name}")]
    done = subprocess.run([program, "run", str(scene), *wanted, "--out", str(log)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stderr)
    if "does not act" in done.stdout + done.stderr:
        sys.exit(f"something does not act: {done.stdout}{done.stderr}")
    rows = list(csv.reader(log.read_text(encoding="utf-8").splitlines()))[1:]
    table = np.array([[float(cell) for cell in row] for row in rows])
    return table[:, 0], table[:, 1:1 + len(properties)]


def here(program, folder, text, joints, times, keys="", target=None):
    """Positions of joints at times, row by row; `target`: what to set at the beginning."""
    names = [f"{name}.joint_position" for name in joints]
    at, values = logged(program, folder, text, names, times[-1] + 0.01, keys, [(0, target)] if target else [])
    return np.array([np.interp(times, at, values[:, k]) for k in range(len(joints))]).T


def convert(program, source, out):
    done = subprocess.run([program, "convert", str(source), "--out", str(out), "--force"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stderr)
