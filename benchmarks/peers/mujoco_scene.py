"""A race's scene in MuJoCo: the robot's own file as often as the description says, what stands around, targets."""
import json
import sys

try:
    import mujoco
    import numpy as np
except ImportError as missing:
    sys.exit(f"{missing}; pip install mujoco")

MOST_ROBOTS = 30  # a bit of contype for each
GEOMS = {"sphere": mujoco.mjtGeom.mjGEOM_SPHERE, "box": mujoco.mjtGeom.mjGEOM_BOX, "capsule": mujoco.mjtGeom.mjGEOM_CAPSULE}
INTEGRATORS = {name: f"mjINT_{name.upper()}" for name in ("Euler", "implicitfast", "discrete", "implicit")}


def integrators():
    """Those that this version has, the usual one first."""
    return [name for name, value in INTEGRATORS.items() if hasattr(mujoco.mjtIntegrator, value)]


def robot_without_ground(file):
    robot = mujoco.MjSpec.from_file(str(file))
    robot.njmax = robot.nconmax = -1  # whatever it needs, as for the scene; the race chooses the integrator
    robot.option.integrator = mujoco.mjtIntegrator.mjINT_EULER
    for geom in list(robot.worldbody.geoms):
        robot.delete(geom)
    return robot


def build(file, description):
    """The model: joints and actuators of robot i are called ri_... ."""
    if len(description["robots"]) > MOST_ROBOTS:
        sys.exit(f"more than {MOST_ROBOTS} robots: there is a bit for each")
    spec, option = mujoco.MjSpec(), mujoco.MjSpec.from_file(str(file)).option
    spec.option.timestep, spec.option.cone, spec.option.impratio = description["step"], option.cone, option.impratio
    spec.memory = 1 << 28
    friction = [description["friction"], 0.005, 0.0001]
    contact = {"friction": friction, "solref": [0.006, 1]}  # as the robot's
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[20, 20, 0.1], **contact)
    for shape in description["statics"]:
        spec.worldbody.add_geom(type=GEOMS[shape["kind"]], size=shape["size"], pos=shape["position"], quat=shape["rotation"],
                                **contact)
    for i in range(len(description["robots"])):
        robot, frame = robot_without_ground(file), spec.worldbody.add_frame()
        for body in robot.worldbody.bodies:
            frame.attach_body(body, f"r{i}_", "")
    model = spec.compile()
    model.geom_friction[:] = friction
    keep_parts_of_a_robot_apart(model)
    return model


def keep_parts_of_a_robot_apart(model):
    everything = (1 << MOST_ROBOTS) - 1
    for geom in range(model.ngeom):
        body = model.geom_bodyid[geom]
        if body == 0:
            model.geom_contype[geom], model.geom_conaffinity[geom] = 1 << MOST_ROBOTS, everything
            continue
        robot = int(mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, body).split("_")[0][1:])
        model.geom_contype[geom], model.geom_conaffinity[geom] = 1 << robot, (1 << MOST_ROBOTS) | (everything & ~(1 << robot))


class Race:
    """A model with its state, and the targets of its actuators."""

    def __init__(self, file, description_file, setting):
        self.description = json.loads(description_file.read_text())
        self.model = build(file, self.description)
        self.model.opt.integrator = getattr(mujoco.mjtIntegrator, INTEGRATORS[setting])
        self.data = mujoco.MjData(self.model)
        names = [link["joint"] for link in self.description["links"][1:]]
        self.joints = [self.joint(f"r{i}_{name}") for i in range(len(self.description["robots"])) for name in names]
        order = [self.joints.index(joint) for joint in self.model.actuator_trnid[:, 0]]
        self.targets = np.array(self.description["targets"])
        self.controls = np.ascontiguousarray(self.targets[:, order])
        self.positions = self.model.jnt_qposadr[self.joints]
        free = np.flatnonzero(self.model.jnt_type == mujoco.mjtJoint.mjJNT_FREE)
        self.bases, self.base_bodies = self.model.jnt_qposadr[free], self.model.jnt_bodyid[free]
        self.start()

    def joint(self, name):
        found = mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_JOINT, name)
        if found < 0:
            sys.exit(f"the robot's file has no joint {name.split('_', 1)[1]}")
        return found

    def start(self):
        mujoco.mj_resetData(self.model, self.data)
        for i, robot in enumerate(self.description["robots"]):
            base = self.bases[i]
            self.data.qpos[base:base + 7] = robot["position"] + robot["rotation"]
        self.data.qpos[self.positions] = [q for robot in self.description["robots"] for q in robot["joints"]]
        mujoco.mj_forward(self.model, self.data)

    def control(self, cycle):
        """Of the actuators in a control cycle; the last ones stay."""
        return self.controls[min(cycle, len(self.controls) - 1)]
