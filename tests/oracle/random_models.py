"""Random robots as MJCF files, and random states of them, for comparisons with other engines.

Everything follows from the seed. Numbers are written with all their digits, so that every engine gets the same ones.
Frames of a state: world axes; a force on a body has its moment about the origin of the body's frame.
"""
import dataclasses

import numpy as np


@dataclasses.dataclass
class Body:
    name: str
    joints: list  # names
    elements: list  # XML of joints and inertial
    place: str  # XML attributes pos and quat
    children: list = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class Robot:
    name: str
    bodies: list  # the base first
    actuators: list  # XML
    slides: set  # names of the joints that are no hinges

    @property
    def joints(self):
        return [joint for body in self.bodies for joint in body.joints]

    def write(self, file):
        actuators = "\n".join(self.actuators)
        file.write_text(
            f'<mujoco model="{self.name}">\n<compiler angle="radian"/>\n'
            '<option gravity="0 0 -9.81"><flag contact="disable" energy="enable"/></option>\n'
            f"<worldbody>\n{to_xml(self.bodies[0])}\n</worldbody>\n<actuator>\n{actuators}\n</actuator>\n</mujoco>\n"
        )
        return file


@dataclasses.dataclass
class State:
    position: np.ndarray  # [m] of the base
    quaternion: np.ndarray  # w x y z, base axes to world axes
    velocity: np.ndarray  # [m/s] of the base's origin
    rate: np.ndarray  # [rad/s] of the base
    q: np.ndarray  # [rad | m] by joint, in the order of Robot.joints
    qd: np.ndarray  # [rad/s | m/s]
    torque: np.ndarray  # [N m | N]
    wrenches: np.ndarray  # [N m, N] a row per body
    acceleration: np.ndarray  # [rad/s^2, m/s^2] of the base, then by joint: what inverse dynamics is asked about

    def line(self):
        return " ".join(numbers(np.concatenate([np.ravel(value) for value in vars(self).values()])))


def numbers(values):
    return [repr(float(value)) for value in values]


def attribute(name, values):
    return f'{name}="{" ".join(numbers(values))}"'


def to_xml(body):
    inside = "\n".join(body.elements + [to_xml(child) for child in body.children])
    return f'<body name="{body.name}" {body.place}>\n{inside}\n</body>'


def unit(dice, size):
    vector = dice.normal(size=size)
    return vector / np.linalg.norm(vector)


def rotation(quaternion):
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def inertial(dice):
    """A solid body of 0.1 to 2 kg; its tensor in one of the two ways that MJCF has."""
    mass = dice.uniform(0.1, 2.0)
    square = dice.uniform(0.03, 0.15, 3) ** 2
    principal = mass * (square.sum() - square)
    turn = unit(dice, 4)
    start = f'<inertial mass="{float(mass)!r}" {attribute("pos", dice.uniform(-0.1, 0.1, 3))} '
    if dice.random() < 0.5:
        return start + f'{attribute("diaginertia", principal)} {attribute("quat", turn)}/>'
    tensor = rotation(turn) @ np.diag(principal) @ rotation(turn).T
    entries = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
    return start + attribute("fullinertia", [tensor[entry] for entry in entries]) + "/>"


def axes(dice, count):
    """Directions that are not close to each other: coordinate axes, or one general one."""
    if count == 1 and dice.random() < 0.5:
        return [dice.uniform(0.5, 2.0) * unit(dice, 3)]
    signs = dice.choice([-1.0, 1.0], 3)
    return [sign * axis for sign, axis in zip(signs, dice.permutation(np.eye(3))[:count], strict=False)]


def joint(dice, name, axis, kind, more):
    anchor = attribute("pos", dice.uniform(-0.1, 0.1, 3)) if dice.random() < 0.3 else ""
    return f'<joint name="{name}" type="{kind}" {attribute("axis", axis)} {anchor} {more}/>'


def place(dice):
    turn = attribute("quat", unit(dice, 4)) if dice.random() < 0.5 else ""
    return f'{attribute("pos", dice.uniform(-0.25, 0.25, 3))} {turn}'


class Maker:
    """Builds one robot; `servos` gives every joint a position actuator and damping."""

    def __init__(self, seed, joints, servos):
        self.dice = np.random.default_rng(seed)
        self.wanted = joints
        self.servos = servos
        # armature makes accelerations tame: some robots have none, some only in places
        self.armature_chance = 1.0 if servos else self.dice.choice([0.0, 0.5, 1.0])
        base = Body("base", [], ["<freejoint/>", inertial(self.dice)], "")
        self.robot = Robot(f"random_{seed}", [base], [], set())

    def make(self):
        while len(self.robot.joints) < self.wanted:
            self.add_body()
        order = []
        stack = [self.robot.bodies[0]]
        while stack:  # as they stand in the file
            order.append(stack.pop())
            stack.extend(reversed(order[-1].children))
        self.robot.bodies = order
        return self.robot

    def add_body(self):
        """Behind the last body, or anywhere; with one joint, or two, or welded."""
        bodies, dice = self.robot.bodies, self.dice
        parent = bodies[-1] if dice.random() < 0.6 else bodies[dice.integers(len(bodies))]
        count = min(int(dice.choice([0, 1, 2], p=[0.1, 0.7, 0.2])), self.wanted - len(self.robot.joints))
        body = Body(f"body_{len(bodies)}", [], [], place(dice))
        for axis in axes(dice, count):
            self.add_joint(body, axis)
        body.elements.append(inertial(dice))
        parent.children.append(body)
        bodies.append(body)

    def add_joint(self, body, axis):
        dice = self.dice
        name = f"joint_{len(self.robot.joints) + len(body.joints)}"
        kind = "slide" if dice.random() < 0.2 else "hinge"
        more = f'armature="{dice.uniform(0.005, 0.05)}" ' if dice.random() < self.armature_chance else ""
        if self.servos:
            more += f'damping="{dice.uniform(0.0, 0.5)}"'
            gains = f'kp="{dice.uniform(5, 40)}" kv="{dice.uniform(0.5, 2)}"'
            limit = dice.uniform(0.5, 3) if dice.random() < 0.3 else 100  # [N m | N] some never get there, some always
            limits = f'forcelimited="true" forcerange="{-limit} {limit}"'
            self.robot.actuators.append(f'<position joint="{name}" {gains} {limits}/>')
        if kind == "slide":
            self.robot.slides.add(name)
        body.joints.append(name)
        body.elements.append(joint(dice, name, axis, kind, more))


def make_robot(seed, joints, servos=False):
    return Maker(seed, joints, servos).make()


def make_robots(count):
    """Robots of 3 to 40 joints."""
    return [make_robot(seed, 3 + seed * 37 // max(1, count - 1)) for seed in range(count)]


def make_states(robot, count, seed=0):
    dice = np.random.default_rng([seed, len(robot.bodies), len(robot.joints)])
    joints, bodies = len(robot.joints), len(robot.bodies)
    reach = np.array([0.3 if name in robot.slides else 3.0 for name in robot.joints])
    states = []
    for _ in range(count):
        pushed = dice.random((bodies, 1)) < 0.5
        states.append(
            State(
                position=dice.uniform(-1, 1, 3),
                quaternion=unit(dice, 4),
                velocity=dice.uniform(-1, 1, 3),
                rate=dice.uniform(-2, 2, 3),
                q=dice.uniform(-1, 1, joints) * reach,
                qd=dice.uniform(-2, 2, joints),
                torque=dice.uniform(-5, 5, joints),
                wrenches=pushed * dice.uniform(-1, 1, (bodies, 6)) * [1, 1, 1, 10, 10, 10],
                acceleration=dice.uniform(-20, 20, 6 + joints),
            )
        )
    return states


def write_states(file, robot, states):
    names = [robot.joints, [body.name for body in robot.bodies]]
    file.write_text("\n".join([" ".join(line) for line in names] + [state.line() for state in states]) + "\n")
    return file
