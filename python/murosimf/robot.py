"""A robot of a scene: its level of detail, joints, commands, motions, sensors and control software."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from html import escape
from typing import Any, Literal, Protocol, TypeAlias, runtime_checkable

from numpy.typing import ArrayLike

from ._core import Robot as CoreRobot
from .entity import Entity, _place
from .errors import ArgumentError
from .joints import JointArray, Joints, joint_array
from .kinematics import Kinematics
from .sensors import ByName, Camera, Sensor

Level: TypeAlias = Literal["kinematic_walking", "simplified_dynamics", "full_dynamics", "articulated_dynamics"]


@runtime_checkable
class Controller(Protocol):
    """Control software in Python: anything that can be called with the robot and the simulated time [s].

    It is called `rate` times per simulated second (an attribute [Hz]; 100 if there is none), between the sensors and the motion
    of its robot. It reads `robot.joint_position`, `robot.joint_velocity` and `robot.sensors`, and writes `robot.joint_target`;
    all else waits for the end of the step, and raises StateError. A method `start(robot, time)`, if there is one, is called
    before the first call and after each reset. What it raises ends the step as the cause of a SimulationError; the robot keeps
    its last targets.
    """

    def __call__(self, robot: Robot, time: float, /) -> None: ...


class Robot(Entity):
    """Arrays of joints are (joints,), in the order of `joints`, live: they show the robot now, and what is written to them goes
    to the robot with the next call. Numbers that a level does not have are NaN."""

    def __init__(self, core: CoreRobot, controllers: dict[str, Any]) -> None:
        super().__init__(core)
        self._core = core
        self._controllers = controllers  # of the scene: keeps them as long as it can be stepped
        self._joints: Joints | None = None
        self._rows: dict[str, JointArray] = {}

    @property
    def level(self) -> str:
        """Level of detail; may be set, also in the middle of a run, and goes on from the present motion."""
        return self._core.level()

    @level.setter
    def level(self, level: Level | str) -> None:
        self._core.set_level(level)

    @property
    def joints(self) -> Joints:
        """Names, units and ranges."""
        if self._joints is None:
            self._joints = Joints(self._core)
        return self._joints

    @property
    def joint_position(self) -> JointArray:
        """(joints,) [rad | m]; live and writable"""
        return self._row("position", self._core.joint_position)

    @joint_position.setter
    def joint_position(self, positions: ArrayLike) -> None:
        self.joint_position[:] = positions

    @property
    def joint_velocity(self) -> JointArray:
        """(joints,) [rad/s | m/s]; live and writable"""
        return self._row("velocity", self._core.joint_velocity)

    @joint_velocity.setter
    def joint_velocity(self, velocities: ArrayLike) -> None:
        self.joint_velocity[:] = velocities

    @property
    def joint_torque(self) -> JointArray:
        """(joints,) [N m | N] of servo and gear; live"""
        return self._row("torque", self._core.joint_torque)

    @property
    def joint_target(self) -> JointArray:
        """(joints,) [rad | m] what control software sets; live and writable, unless a controller of the scene writes it in
        every step: then the next call raises InputError"""
        return self._row("target", self._core.joint_target)

    @joint_target.setter
    def joint_target(self, targets: ArrayLike) -> None:
        self.joint_target[:] = targets

    def _row(self, name: str, fetch: Callable[[], Any]) -> JointArray:
        row = self._rows.get(name)
        if row is None:
            row = self._rows[name] = joint_array(fetch(), self.joints.numbers)
        return row

    def command(self, forward: float, left: float = 0.0, turning: float = 0.0) -> None:
        """[m/s] forward, [m/s] to the left, [rad/s] turning: for controllers that walk. Raises InputError if none of the
        robot's does."""
        self._core.set_command(forward, left, turning)

    @property
    def motions(self) -> list[str]:
        """Of the robot's file, by name."""
        return self._core.motions()

    def play(self, motion: str) -> None:
        """Has the controller `motions` play one. Raises UnknownName, InputError."""
        self._core.play(motion)

    @property
    def falls(self) -> int:
        """How often its base has tilted over 60 degrees so far."""
        return self._core.falls()

    @property
    def fallen(self) -> bool:
        """Whether it lies now."""
        return self._core.fallen()

    @property
    def sensors(self) -> Mapping[str, Sensor]:
        """By name."""
        return ByName(self._core.sensors, lambda name: Sensor(self._core.sensor(name)))

    @property
    def cameras(self) -> Mapping[str, Camera]:
        """By name; each draws from when it was asked for (Camera)."""
        return ByName(self._core.cameras, lambda name: Camera(self._core.camera(name)))

    @property
    def kinematics(self) -> Kinematics:
        """Of its model, for any rows of joint positions."""
        return Kinematics(self._core.kinematics())

    @property
    def controller(self) -> Controller | None:
        """Control software in Python that has the robot (Controller); None: it has none. Raises InputError if a controller of
        the scene writes the joints' targets ("none" does not)."""
        held = self._controllers.get(self.name)
        return held[0] if held else None

    @controller.setter
    def controller(self, controller: Controller | None) -> None:
        if controller is None:
            self._core.set_controller(None, None, 100.0)
            self._controllers.pop(self.name, None)
            return
        if not callable(controller):
            kind = type(controller).__name__
            raise ArgumentError(f"a controller is called as controller(robot, time); {kind} cannot be called")

        def step(time: float) -> None:
            controller(self, time)

        begins = getattr(controller, "start", None)
        start = None if begins is None else lambda time: begins(self, time)
        self._core.set_controller(start, step, float(getattr(controller, "rate", 100.0)))
        self._controllers[self.name] = (controller, start, step)  # the core borrows them

    def _facts(self) -> dict[str, str]:
        # before the first step nothing is asked that would begin the run: it may still be changed
        now = {"position": _place(self._core), "falls": str(self.falls)} if self._core.begun() else {}
        return {
            "level": self.level,
            "joints": str(len(self.joints)),
            **now,
            "sensors": ", ".join(self._core.sensors()) or "none",
            "cameras": ", ".join(self._core.cameras()) or "none",
        }

    def __repr__(self) -> str:
        facts = "\n".join(f"  {name:10}{fact}" for name, fact in self._facts().items())
        return f"robot '{self.name}'\n{facts}"

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><th>{name}</th><td>{escape(fact)}</td></tr>" for name, fact in self._facts().items())
        return f"<table><caption>robot {escape(self.name)}</caption>{rows}</table>"
