"""A scene, built and ready to run."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from html import escape
from os import PathLike
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._values import Assignments, assignments, texts, timed_assignments, triple
from .contacts import RayHit, contact_table, hit_of
from .entity import Entity, _place
from .errors import InputError
from .page import Page
from .picture import Picture
from .recording import Recorder
from .robot import Level, Robot

shapes = ("sphere", "box", "capsule", "cylinder")


class Scene:
    """`Scene("walk", set={"walker.level": "simplified_dynamics"})`.

    A scene is for one thread at a time; several run at the same time in several threads. The same scene, seed and calls give
    the same states, bit for bit, for any number of threads. A call that raises InputError has changed nothing.
    """

    def __init__(self, name: str | PathLike[str], *, seed: int | None = None, set: Assignments = (),
                 events: Mapping[float, Assignments] | Iterable[str] = (), pushes: Iterable[str] = (), threads: int = 1,
                 libraries: bool = False, lenient: bool = False, cameras: bool = True) -> None:
        """A file, or the name of a scene that comes with the package.

        `set`: {"PATH": value} or "PATH=VALUE" as for `murosimf run --set`; `events`: {time: assignments} or "TIME:PATH=VALUE"
        as for --at; `pushes`: "OBJECT=FORCE@BEGIN..END" as for --push; `libraries`: control software that the file names may be
        loaded, and may do what it likes; `lenient`: unknown elements of robot files are warnings; `cameras`: False draws
        nothing.
        """
        options = _options(seed, set, events, pushes, threads, libraries, lenient, cameras)
        self._begin(_core.open_file(os.fspath(name), options))

    @classmethod
    def of_text(cls, toml: str, *, seed: int | None = None, set: Assignments = (),
                events: Mapping[float, Assignments] | Iterable[str] = (), threads: int = 1, lenient: bool = False,
                cameras: bool = True) -> Scene:
        """What a scene file would say (TOML)."""
        return cls._of(_core.open_text(toml, _options(seed, set, events, (), threads, False, lenient, cameras)))

    @classmethod
    def of_robot(cls, model: str | PathLike[str], *, seed: int | None = None, set: Assignments = (), threads: int = 1,
                 lenient: bool = False, cameras: bool = True) -> Scene:
        """A robot alone on the ground, called "robot", at articulated_dynamics and without controller, unless `set` says
        otherwise."""
        return cls._of(_core.open_robot(os.fspath(model), _options(seed, set, (), (), threads, False, lenient, cameras)))

    @classmethod
    def _of(cls, core: _core.Scene) -> Scene:
        scene = cls.__new__(cls)
        scene._begin(core)
        return scene

    def _begin(self, core: _core.Scene) -> None:
        self._core = core
        self._controllers: dict[str, Any] = {}  # in Python, by robot
        self._robots: dict[str, Robot] = {}

    @property
    def name(self) -> str:
        """Its title."""
        return self._core.name()

    @property
    def time(self) -> float:
        """[s] simulated"""
        return self._core.time()

    @property
    def nanoseconds(self) -> int:
        """The same, exactly."""
        return self._core.nanoseconds()

    @property
    def step_length(self) -> float:
        """[s]"""
        return self._core.step_length()

    def step(self, steps: int = 1) -> None:
        """Other threads of Python go on meanwhile, and Ctrl-C ends it between two steps."""
        self._core.step(steps)

    def run(self, seconds: float | None = None, *, until: Callable[[Scene], object] | None = None,
            at_most: float | None = None) -> bool:
        """For so many simulated seconds; or until `until(scene)` is true, asked before every step, but at most so many seconds.
        Whether it came true; True without a condition. An algorithm of the scene file may end it earlier (`ended`): False."""
        if until is None:
            if seconds is None or at_most is not None:
                raise InputError("run(5.0) runs for 5 s, run(until=condition, at_most=20.0) until a condition is true")
            self._core.run(seconds)
            return not self._core.ended()
        if seconds is not None or at_most is None:
            raise InputError("run(until=condition) takes at_most, the seconds after which it ends in any case")
        if not 0 <= at_most <= 3e9:  # NaN would never end
            raise InputError(f"a run of {at_most:g} s: 0 to 3e9 s")
        end = self.nanoseconds + round(at_most * 1e9)
        while not until(self):
            if self.nanoseconds >= end or self._core.ended():
                return False
            self._core.step(1)
        return True

    @property
    def ended(self) -> str:
        """Why an algorithm of the scene file has ended the run: "NAME: reason"; empty: none has."""
        return self._core.ended()

    def reset(self, seed: int | None = None) -> None:
        """Back to the start, without building anything; as a new scene with this seed, if given."""
        self._core.reset(seed)

    def save(self) -> bytes:
        """Everything that decides how the run goes on, for load(), also in another process with the same scene and options."""
        return self._core.save()

    def load(self, state: bytes) -> None:
        """Goes on from there, bit for bit."""
        self._core.load(state)

    def copy(self) -> Scene:
        """Another scene that goes on from the present state. Raises InputError if a robot has a controller in Python."""
        return Scene._of(self._core.copy())

    __copy__ = copy

    def __deepcopy__(self, memo: dict[int, Any]) -> Scene:
        return self.copy()

    @property
    def state_hash(self) -> int:
        """Equal states have equal hashes: that which `murosimf run` prints, as a number."""
        return self._core.state_hash()

    def change(self, changes: Assignments) -> None:
        """{"PATH": value} or "PATH=VALUE" as of events: {"blue1.level": "full_dynamics"}. All of them at once, or none."""
        self._core.change(assignments(changes))

    @property
    def robots(self) -> list[str]:
        """Names, in the order of the scene."""
        return self._core.robots()

    @property
    def entities(self) -> list[str]:
        """Names of robots, ball, bodies and field."""
        return self._core.entities()

    def __getitem__(self, name: str) -> Robot:
        """A robot. Raises UnknownName."""
        robot = self._robots.get(name)
        if robot is None:
            robot = self._robots[name] = Robot(self._core.robot(name), self._controllers)
        return robot

    @property
    def robot(self) -> Robot:
        """The first one of the file."""
        names = self.robots
        if not names:
            raise InputError(f"scene '{self.name}' has no robot")
        return self[names[0]]

    def entity(self, name: str) -> Entity:
        """Ball, body, field or robot. Raises UnknownName."""
        return Entity(self._core.entity(name))

    def add_robot(self, name: str, model: str | PathLike[str], *, position: ArrayLike = (0, 0, 0), heading: float = 0.0,
                  level: Level | str = "articulated_dynamics", controller: str = "none", team: str = "") -> Robot:
        """A robot that comes into the running scene: `position` [m], x and y of the base, z of its lowest point; `heading`
        [rad]."""
        self._core.add_robot(name, os.fspath(model), level, controller, team, triple(position, "a position"), heading)
        return self[name]

    def add_body(self, name: str, shape: Literal["sphere", "box", "capsule", "cylinder"] = "sphere", *,
                 size: ArrayLike = (0.05, 0.05, 0.05), mass: float = 0.1, material: str = "plastic",
                 position: ArrayLike = (0, 0, 0),
                 heading: float = 0.0, velocity: ArrayLike = (0, 0, 0)) -> Entity:
        """A body that comes into the running scene. `size` [m]: sphere: radius in x; box: edges; capsule and cylinder: radius
        in x, length in z; `mass` [kg]; `position` [m] x and y of its middle, z of its lowest point; `velocity` [m/s] world."""
        if shape not in shapes:
            raise InputError(f"unknown shape '{shape}'; known: {', '.join(shapes)}")
        return Entity(self._core.add_body(name, shapes.index(shape), triple(size, "a size"), mass, material,
                                          triple(position, "a position"), heading, triple(velocity, "a velocity")))

    def leave(self, name: str) -> None:
        """Robots, ball and bodies leave, and come back by enter() as they began."""
        self._core.leave(name)

    def enter(self, name: str) -> None:
        """Brings an entity back that has left. Raises UnknownName."""
        self._core.enter(name)

    def contacts(self) -> NDArray[np.void]:
        """(n,) records of the last step, each contact once: `a`, `a_object`, `b`, `b_object` (names; b is the field, or another
        entity), `position` [m], `normal` from b to a, `force` [N] on a, world frame each, and `depth` [m]."""
        return contact_table(*self._core.contacts())

    def cast(self, origin: ArrayLike, direction: ArrayLike, range: float = float("inf"), without: str = "") -> RayHit | None:
        """What a ray meets first: along `direction` (any length but 0) from `origin` [m] up to `range` [m]; `without`: an
        entity that it goes through. None: nothing."""
        return hit_of(self._core.cast(triple(origin, "an origin"), triple(direction, "a direction"), range, without))

    def distance(self, a: str, b: str) -> float | None:
        """[m] between two entities, negative where they overlap; None if one of them has no shapes that collide."""
        return self._core.distance(a, b)

    @property
    def events(self) -> list[tuple[float, str]]:
        """What happened: time [s] and text."""
        return self._core.events()

    @property
    def warnings(self) -> list[str]:
        """Of files and settings, as the program prints them."""
        return self._core.warnings()

    def picture(self, *, eye: ArrayLike = (0, -4, 2), look_at: ArrayLike = (0, 0, 0.3), field_of_view: float = 1.0,
                width: int = 640, height: int = 480) -> Picture:
        """What people would see from `eye` [m]; `field_of_view` [rad] from the left to the right border. Raises InputError
        where the variable MUROSIMF_RENDERER asks for OpenGL and there is none."""
        return Picture(*self._core.picture(triple(eye, "an eye"), triple(look_at, "look_at"), field_of_view, width, height))

    def show(self, *, web: bool = False, speed: float | None = 1.0, port: int = 0) -> Page:
        """Shows this scene, as it goes on, in a browser that this opens; with `web`, gives the link alone. Who looks may play,
        push and change it while no call of the script steps it. `speed` [1]: how many times real time `step` and `run` are at
        most from now on; None: as fast as they can. `port`: 0 takes one that is free. Raises InputError: this build has no
        server, the port is in use."""
        if speed is not None and not 0 < speed <= 1e6:
            raise InputError(f"speed = {speed:g}: above 0, up to 1e6, or None")
        page = Page(self._core, self._core.show(f"127.0.0.1:{port}", speed))
        if not web:
            import webbrowser  # it takes milliseconds to import

            webbrowser.open(page.address)
        return page

    def record(self, file: str | PathLike[str], rate: float = 100.0) -> Recorder:
        """`with scene.record("run.mcap"): scene.run(10)`; `rate` [Hz] of poses, joints and contacts."""
        return Recorder(self, file, rate)

    def _rows(self) -> list[tuple[str, str, str, str]]:
        rows = []
        for name in self.robots:
            robot = self[name]
            # before the first step nothing is asked that would begin the run: it may still be changed
            now = (_place(robot._core), f"{robot.falls} falls") if self.time > 0 else ("", "")
            rows.append((name, robot.level, *now))
        return rows

    def __repr__(self) -> str:
        robots = "\n".join(f"  {name:14}{level:24}{place:28}{falls}".rstrip() for name, level, place, falls in self._rows())
        return f"scene '{self.name}' at {self.time:.3f} s\n{robots}".rstrip()

    def _repr_html_(self) -> str:
        rows = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in self._rows())
        head = "<tr><th>robot</th><th>level</th><th>position</th><th>falls</th></tr>"
        return f"<table><caption>{escape(self.name)} at {self.time:.3f} s</caption>{head}{rows}</table>"


def _options(seed: int | None, set: Assignments, events: Mapping[float, Assignments] | Iterable[str], pushes: Iterable[str],
             threads: int, libraries: bool, lenient: bool, cameras: bool) -> _core.Options:
    pushed = texts(pushes, "a push is 'OBJECT=FORCE@BEGIN..END'")
    return threads, seed, assignments(set), timed_assignments(events), pushed, libraries, lenient, cameras
