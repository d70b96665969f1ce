"""Steers a run from outside: murosimf run SCENE --supervise PORT (docs/supervise.md)."""

import os
import pathlib

from . import supervision
from .connection import Connection, SimulatorError
from .wire import WireError

STATE_PART = 60_000  # [byte] of a state in one message
LONGEST_MESSAGE = 256 * 1024 * 1024  # [byte] of the simulator: states are long


class RequestRefused(SimulatorError):
    """What was asked cannot be; the run goes on."""


class Supervisor:
    """The run of the simulation at (host, port). Times and durations are in seconds of simulated time.

    with Supervisor(5001, token="...") as run:
        run.change("blue1.level = full_dynamics")
        run.advance(0.5)
        x, y, z = run.read("ball.ball.position").values
    """

    def __init__(self, port, token=None, host="127.0.0.1", name="Python", patience=60.0):
        """`token`: what the simulator has printed; None: the environment's MUROSIMF_SUPERVISION_TOKEN.
        `patience` [s]: how long to try; the run may not listen yet."""
        if token is None:
            token = os.environ.get("MUROSIMF_SUPERVISION_TOKEN", "")
        self._connection = Connection(host, port, patience, LONGEST_MESSAGE)
        try:
            welcome = self._ask(supervision.hello(token, name), supervision.Welcome)
        except BaseException:
            self.close()
            raise
        self._meet(welcome)

    def status(self):
        return self._plain(supervision.STATUS)

    def pause(self):
        return self._plain(supervision.PAUSE)

    def go_on(self):
        """At or behind the end: without end."""
        return self._plain(supervision.GO_ON)

    def step(self, count=1):
        """Makes so many steps and pauses."""
        return self._status_after(supervision.step(count))

    def advance(self, duration):
        """Goes on for so long and pauses there; waits for that."""
        return self._status_after(supervision.advance(_ns(duration)))

    def run_until(self, end):
        """Where it pauses by itself."""
        return self._status_after(supervision.run_until(_ns(end)))

    def set_speed(self, factor=None):
        """Simulated seconds per wall second; None: as fast as possible."""
        return self._status_after(supervision.speed(factor or 0.0))

    def change(self, *changes):
        """Each PATH = VALUE, as in events of a scene: levels, laws, commands, who is there, properties. All of them, or none."""
        return self._status_after(supervision.change(changes))

    def place(self, entity, x, y, z=0.0, heading=0.0):
        """[m], [rad]: puts a robot, the ball or a body there, upright and at rest; z: of its lowest point."""
        return self.change(f"{entity}.place = [{x!r}, {y!r}, {z!r}, {heading!r}]")

    def push(self, body, force, duration):
        """A force [N] in the world's axes on ENTITY or ENTITY.BODY for so long [s]."""
        x, y, z = force
        return self.change(f"{body}.push = [{x!r}, {y!r}, {z!r}, {duration!r}]")

    def set_level(self, robot, level):
        return self.change(f"{robot}.level = {level}")

    def read(self, *patterns):
        """Numbers by patterns as of --log: sensors and properties, all at one instant."""
        return self._ask(supervision.read(patterns), supervision.Numbers)

    def entities(self):
        return self._ask(supervision.plain(supervision.DESCRIBE), supervision.Scene).entities

    def events(self, first=0):
        """Of the run, from number `first` on; and all warnings."""
        return self._ask(supervision.events(first), supervision.Events)

    def reset(self, seed=None):
        """Back to the start, with another seed if given; goes on or stays paused as before."""
        return self._status_after(supervision.reset(seed))

    def seek(self, time, branch=None):
        """Back, or on, to an instant that was there before, and pauses there. What goes on from there is a new branch.
        `diagnostic` of the answer names external software that has not gone back with it, "" if none."""
        return self._status_after(supervision.seek(_ns(time), branch))

    def branches(self):
        return self._ask(supervision.plain(supervision.BRANCHES), supervision.Branches).branches

    def record(self, on=True):
        """Records the run to the simulator's file (--record FILE --record-on asked), with what was kept before, or no longer."""
        return self._status_after(supervision.record(on))

    def save(self):
        """The state, as bytes."""
        return self._ask(supervision.plain(supervision.SAVE), supervision.SavedState).content

    def save_to(self, file):
        """The state, to a file of this computer, from which another run of the scene goes on: murosimf run SCENE --from FILE."""
        state = self.save()  # nothing is written if it fails
        pathlib.Path(file).write_bytes(state)

    def load(self, state):
        """Goes on from a state (bytes) that save() gave, of this scene, also of another run of it; pauses there."""
        parts = [state[begin : begin + STATE_PART] for begin in range(0, len(state), STATE_PART)] or [b""]
        for part in parts[:-1]:
            self._status_after(supervision.load(part, last=False))
        return self._status_after(supervision.load(parts[-1], last=True))

    def load_from(self, file):
        """The same of a file of this computer: of save_to(), or of murosimf run SCENE --supervise PORT --save-at TIME:FILE."""
        return self.load(pathlib.Path(file).read_bytes())

    def load_scene(self, scene, overrides=(), seed=None, paused=True):
        """Another scene in the place of the present one, whose run ends without results: the name of one that comes with the
        program, or a file in the folders that the run was started with; `overrides`: "PATH=VALUE" as of --set, those that
        docs/supervise.md lists. Other supervisors stay, too."""
        self._meet(self._ask(supervision.load_scene(str(scene), list(overrides), seed, paused), supervision.Welcome))

    def finish(self):
        """Ends the run: the simulator writes its results."""
        self._connection.send(supervision.plain(supervision.FINISH))
        try:
            while not isinstance(self._receive(), supervision.Goodbye):
                pass
        except SimulatorError:
            pass  # it is faster than its answer
        self.close()

    def close(self):
        self._connection.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _meet(self, welcome):
        self.scene, self.seed, self.tick = welcome.scene, welcome.seed, 1e-9 * welcome.tick  # [s] of a step

    def _plain(self, request):
        return self._status_after(supervision.plain(request))

    def _status_after(self, request):
        return self._ask(request, supervision.Status)

    def _ask(self, request, kind):
        self._connection.send(request)
        message = self._receive()
        if isinstance(message, supervision.Refused):
            raise RequestRefused(message.reason)
        if isinstance(message, supervision.Goodbye):
            raise SimulatorError("the run is over")
        if not isinstance(message, kind):
            raise SimulatorError(f"the simulator does not answer with {kind.__name__}")
        return message

    def _receive(self):
        content = self._connection.receive()
        try:
            return supervision.from_simulator(content)
        except (WireError, TypeError, ValueError) as error:
            raise SimulatorError(f"the simulator sends what is no message of this protocol: {error}") from error


def _ns(seconds):
    return round(1e9 * seconds)
