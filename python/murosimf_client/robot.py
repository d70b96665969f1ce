"""One robot: its signals, its commands, and the cycles in which they are exchanged."""

from dataclasses import dataclass, field

from . import messages
from .connection import Connection, SimulatorError
from .wire import WireError

LONGEST_MESSAGE = 16 * 1024 * 1024  # [byte] of the simulator

RobotInfo = messages.Welcome
TeamMessage = messages.TeamMessage
RobotError = SimulatorError


@dataclass
class Signal:
    """Numbers to read, up to date in each cycle."""

    name: str
    labels: list[str]  # of each number: the joint, or "x"
    values: list[float]
    time: int = 0  # [ns] of simulated time at which they were measured
    samples: int = 0  # that have come so far; 0: there was none yet


@dataclass
class Command:
    """Numbers to set. They hold until they are set again."""

    name: str
    labels: list[str]
    values: list[float] = field(default_factory=list)


@dataclass
class Picture:
    """The last picture of a camera."""

    name: str
    width: int  # [px]
    height: int  # [px]
    format: str  # of pixels: rgb8, bayer_rggb8, ..., 32FC1 [m], 16UC1
    period: float  # [s] of simulated time from one to the next
    content: bytes = b""  # rows from the top, without gaps; empty: there was none yet
    time: int = 0  # [ns] of simulated time at which the exposure of its first row began
    number: int = 0  # of pictures that have come so far


@dataclass
class Cycle:
    now: int  # [ns] of simulated time
    start: bool  # the run begins, or begins again: commands hold before its first step, signals have no numbers yet
    messages: list[TeamMessage] = field(default_factory=list)  # that have arrived from the team since the cycle before


class Robot:
    """The robot `name` of the simulation at (host, port).

    Signals and commands are asked for by name first, then cycles() runs. A thread with several robots calls ready() of each
    before it connects the next, and send() before receive() of another.
    """

    def __init__(self, name, port, host="127.0.0.1", rate=0.0, software="Python", patience=60.0):
        """`rate` [Hz] is wanted, unless the scene says one. `patience` [s]: how long to try to connect."""
        self._signals, self._commands, self._pictures = [], [], []
        self._says, self._sends, self._draws = [], [], []
        self._ready, self._cycle = False, 0
        self._connection = Connection(host, port, patience, LONGEST_MESSAGE)
        try:
            self._send(messages.hello(name, rate, software))
            self.info = self._expect(messages.Welcome)
        except BaseException:
            self.close()
            raise

    def signal(self, name):
        labels = self._asked(messages.ask_signal(name), name).labels
        self._signals.append(Signal(name, labels, [0.0] * len(labels)))
        return self._signals[-1]

    def command(self, name):
        description = self._asked(messages.ask_command(name), name)
        self._commands.append(Command(name, description.labels, description.values))
        return self._commands[-1]

    def picture(self, name):
        """"camera.color", "camera.depth", "camera.labels"."""
        of = self._asked(messages.ask_picture(name), name).picture
        self._pictures.append(Picture(name, of.width, of.height, of.format, of.period))
        return self._pictures[-1]

    def use_messages(self):
        """From now on it hears its team (Cycle.messages), and may send to it."""
        self._asked(messages.ask_messages(), "messages")

    def ready(self):
        """Nothing more is asked for; the first receive() says so, too."""
        if not self._ready:
            self._ready = True
            self._send(messages.ready())

    def receive(self):
        """The next Cycle; None: the run is over."""
        self.ready()
        message = self._receive()
        if isinstance(message, messages.Goodbye):
            return None
        if not isinstance(message, messages.Cycle):
            raise RobotError("the simulator sends no cycle")
        self._cycle = message.cycle
        for signal, sample in zip(self._signals, message.samples, strict=False):
            signal.time, signal.samples, signal.values = sample.time, sample.samples, sample.values
        for come in message.pictures:
            picture = self._pictures[come.picture]
            picture.time, picture.number, picture.content = come.time, come.number, come.content
        return Cycle(message.now, message.start, message.messages)

    def send(self):
        """Answers the cycle with the commands."""
        for command in self._commands:
            if len(command.values) != len(command.labels):
                raise RobotError(f"'{command.name}' has {len(command.labels)} numbers, not {len(command.values)}")
        rows = [command.values for command in self._commands]
        self._send(messages.commands(self._cycle, rows, self._says, self._sends, self._draws))
        self._draws.clear()
        self._says.clear()
        self._sends.clear()

    def cycles(self):
        """Each Cycle until the run is over; what is set in its loop is sent at the end of it."""
        while (cycle := self.receive()) is not None:
            yield cycle
            self.send()

    def say(self, line):
        """A line for the report of the run; sent with the commands."""
        self._says.append(line)

    def send_message(self, content):
        """Bytes to all other robots of the team; sent with the commands."""
        self._sends.append(content)

    def draw(self, group, shapes, of_robot=False):
        """For people who watch: shapes as a group of that name, in the place of the one before; without shapes that is gone.
        Points are in the world, or in the frame of the robot's base. Sent with the commands."""
        self._draws.append(messages.drawing(group, shapes, of_robot))

    def close(self):
        self._connection.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _asked(self, question, name):
        if self._ready:
            raise RobotError(f"'{name}' is asked for after the first cycle, or ready()")
        self._send(question)
        return self._expect(messages.Description)

    def _expect(self, kind):
        message = self._receive()
        if not isinstance(message, kind):
            raise RobotError(f"the simulator does not answer with {kind.__name__}")
        return message

    def _send(self, message):
        self._connection.send(message)

    def _receive(self):
        content = self._connection.receive()
        try:
            message = messages.from_simulator(content)
        except (WireError, TypeError, ValueError) as error:
            raise RobotError(f"the simulator sends what is no message of this protocol: {error}") from error
        if isinstance(message, messages.Refusal):
            raise RobotError(f"the simulator refuses: {message.reason}")
        return message
