"""Robots, ball, bodies and field: where they are, how they move; properties by their names."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._core import Entity as CoreEntity
from ._values import Array, numbers, quadruple, triple


class Pose(NamedTuple):
    """Of a frame in the world."""

    position: Array  #: (3,) [m]
    quaternion: Array  #: (4,) w first


class Velocity(NamedTuple):
    """Of an object."""

    linear: Array  #: (3,) [m/s] of the origin, world axes
    angular: Array  #: (3,) [rad/s] world axes


class Objects:
    """All objects of an entity at once: arrays with a row for each, in the order of `names`, live and writable.

    A property fetches the array that belongs to the level of now: an array that is kept over a change of level may show what
    was there last, so keep the property, not the array.
    """

    def __init__(self, core: CoreEntity) -> None:
        self._core = core

    @property
    def names(self) -> list[str]:
        """The base first, parents before what hangs on them."""
        return self._core.objects()

    @property
    def position(self) -> Array:
        """(objects, 3) [m] world frame"""
        return self._core.view("position")

    @property
    def orientation(self) -> Array:
        """(objects, 3, 3) axes of the objects to those of the world"""
        return self._core.view("orientation")

    @property
    def linear_velocity(self) -> Array:
        """(objects, 3) [m/s] of the origins, world axes"""
        return self._core.view("linear_velocity")

    @property
    def angular_velocity(self) -> Array:
        """(objects, 3) [rad/s] world axes"""
        return self._core.view("angular_velocity")

    def view(self, property: str) -> Array:
        """Any property whose values are rows of numbers (`murosimf list properties`): (objects,), (objects, n) or (objects, n,
        m)."""
        return self._core.view(property)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        return f"{len(self)} objects of '{self._core.name}': {', '.join(self.names)}"


class Object:
    """An object of an entity: `robot["head"]`."""

    def __init__(self, core: CoreEntity, name: str) -> None:
        self._core, self.name = core, name

    @property
    def pose(self) -> Pose:
        """A copy."""
        position, quaternion = self._core.pose(self.name)
        return Pose(np.array(position), np.array(quaternion))

    @property
    def position(self) -> Array:
        """(3,) [m] world frame, a copy"""
        return self.pose.position

    @property
    def velocity(self) -> Velocity:
        """A copy."""
        linear, angular = self._core.velocity(self.name)
        return Velocity(np.array(linear), np.array(angular))

    def push(self, force: ArrayLike, duration: float, moment: ArrayLike = (0, 0, 0)) -> None:
        """For `duration` [s] from now on, with `force` [N] and `moment` [N m], world axes, at its center of mass."""
        self._core.push(self.name, triple(force, "a force"), duration, triple(moment, "a moment"))

    @property
    def properties(self) -> list[str]:
        """Names of all that it has."""
        return self._core.properties(self.name)

    def unit(self, property: str) -> str:
        """SI; "1" for pure numbers."""
        return self._core.unit(self.name, property)

    def __getitem__(self, property: str) -> Array:
        """Numbers of a property (`murosimf list properties`), a copy; matrices row by row."""
        return self._core.get(self.name, property)

    def __setitem__(self, property: str, values: ArrayLike) -> None:
        """Also constants of the model: mass, center_of_mass, inertia, joint_damping, and of servos, "servo.stall_torque".
        They act from the next step on, as if the scene had been built with them (docs/python.md)."""
        self._core.set(self.name, property, numbers(values).ravel())

    def __repr__(self) -> str:
        return f"object '{self.name}' of '{self._core.name}'"


class Entity:
    """A robot, the ball, a body or the field. It stays valid whatever comes and goes, and keeps the scene's memory."""

    def __init__(self, core: CoreEntity) -> None:
        self._entity = core

    @property
    def name(self) -> str:
        """As in the scene."""
        return self._entity.name

    @property
    def objects(self) -> Objects:
        """All at once, as arrays."""
        return Objects(self._entity)

    def __getitem__(self, name: str) -> Object:
        """One of its objects. Raises UnknownName."""
        if name not in self._entity.objects():
            self._entity.pose(name)  # bodies of the robot's file have names, too; says what is nearest to others
        return Object(self._entity, name)

    @property
    def present(self) -> bool:
        """Whether it is there (Scene.enter, Scene.leave)."""
        return self._entity.present()

    @property
    def frozen(self) -> str:
        """Why it was taken out of the simulation, because its numbers went bad; "": it was not."""
        return self._entity.frozen()

    @property
    def position(self) -> Array:
        """(3,) [m] of the base, world frame; live and writable"""
        row: Array = self._entity.view("position")[0]
        return row

    @position.setter
    def position(self, position: ArrayLike) -> None:
        _, quaternion = self._entity.pose("")
        self._entity.set_pose(triple(position, "a position"), quaternion)

    @property
    def orientation(self) -> Array:
        """(3, 3) axes of the base to those of the world; live"""
        matrix: Array = self._entity.view("orientation")[0]
        return matrix

    @property
    def quaternion(self) -> Array:
        """(4,) the same, w first; a copy"""
        return np.array(self._entity.pose("")[1])

    @quaternion.setter
    def quaternion(self, quaternion: ArrayLike) -> None:
        position, _ = self._entity.pose("")
        self._entity.set_pose(position, quadruple(quaternion, "a quaternion"))

    @property
    def linear_velocity(self) -> Array:
        """(3,) [m/s] of the base's origin, world axes; live and writable"""
        row: Array = self._entity.view("linear_velocity")[0]
        return row

    @linear_velocity.setter
    def linear_velocity(self, velocity: ArrayLike) -> None:
        _, angular = self._entity.velocity("")
        self._entity.set_velocity(triple(velocity, "a velocity"), angular)

    @property
    def angular_velocity(self) -> Array:
        """(3,) [rad/s] of the base, world axes; live and writable"""
        row: Array = self._entity.view("angular_velocity")[0]
        return row

    @angular_velocity.setter
    def angular_velocity(self, velocity: ArrayLike) -> None:
        linear, _ = self._entity.velocity("")
        self._entity.set_velocity(linear, triple(velocity, "a velocity"))

    def place(self, position: ArrayLike, heading: float = 0.0) -> None:
        """As people put a robot or ball down: upright, at rest, its lowest point at the height of `position` [m], turned by
        `heading` [rad]."""
        self._entity.place(triple(position, "a position"), heading)

    def push(self, object: str = "", *, force: ArrayLike, duration: float, moment: ArrayLike = (0, 0, 0)) -> None:
        """For `duration` [s] from now on, with `force` [N] and `moment` [N m], world axes, at the object's center of mass; "":
        the base."""
        self._entity.push(object, triple(force, "a force"), duration, triple(moment, "a moment"))

    @property
    def contact_law(self) -> str:
        """The law of contact with the ground, by its name; may be set."""
        return self._entity.contact_law()

    @contact_law.setter
    def contact_law(self, law: str) -> None:
        self._entity.set_contact_law(law)

    def __repr__(self) -> str:
        return f"'{self.name}' at ({_place(self._entity)})" if self._entity.begun() else f"'{self.name}'"


def _place(core: CoreEntity) -> str:
    (x, y, z), _ = core.pose("")
    return f"{x:.3f}, {y:.3f}, {z:.3f} m"
