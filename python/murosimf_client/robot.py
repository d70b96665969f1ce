"""One robot: its signals, its commands, and the cycles in which they are exchanged."""

import contextlib
import socket
import struct
import time
from dataclasses import dataclass, field

from . import messages
from .wire import WireError

LONGEST_MESSAGE = 16 * 1024 * 1024  # [byte] of the simulator

RobotInfo = messages.Welcome


class RobotError(Exception):
    """Nobody listens, there is nothing of a name, or the simulator has ended the connection. One line."""


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
class Cycle:
    now: int  # [ns] of simulated time
    start: bool  # the run begins, or begins again: commands hold before its first step, signals have no numbers yet


class Robot:
    """The robot `name` of the simulation at (host, port).

    Signals and commands are asked for by name first, then cycles() runs. A thread with several robots calls ready() of each
    before it connects the next, and send() before receive() of another.
    """

    def __init__(self, name, port, host="127.0.0.1", rate=0.0, software="Python", patience=60.0):
        """`rate` [Hz] is wanted, unless the scene says one. `patience` [s]: nobody may listen yet."""
        self._signals, self._commands, self._says = [], [], []
        self._ready, self._cycle = False, 0
        self._incoming = bytearray()
        self._socket = _connected(host, port, patience)
        try:
            self._send(messages.hello(name, rate, software))
            self.info = self._expect(messages.Welcome)
        except BaseException:
            self.close()
            raise

    def signal(self, name):
        return self._asked(Signal, name, self._signals)

    def command(self, name):
        return self._asked(Command, name, self._commands)

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
        return Cycle(message.now, message.start)

    def send(self):
        """Answers the cycle with the commands."""
        for command in self._commands:
            if len(command.values) != len(command.labels):
                raise RobotError(f"'{command.name}' has {len(command.labels)} numbers, not {len(command.values)}")
        self._send(messages.commands(self._cycle, [command.values for command in self._commands], self._says))
        self._says.clear()

    def cycles(self):
        """Each Cycle until the run is over; what is set in its loop is sent at the end of it."""
        while (cycle := self.receive()) is not None:
            yield cycle
            self.send()

    def say(self, line):
        """A line for the report of the run; sent with the commands."""
        self._says.append(line)

    def close(self):
        self._socket.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _asked(self, kind, name, rows):
        if self._ready:
            raise RobotError(f"'{name}' is asked for after the first cycle, or ready()")
        self._send(messages.ask(name, kind is Signal))
        description = self._expect(messages.Description)
        rows.append(kind(name, description.labels, description.values or [0.0] * len(description.labels)))
        return rows[-1]

    def _expect(self, kind):
        message = self._receive()
        if not isinstance(message, kind):
            raise RobotError(f"the simulator does not answer with {kind.__name__}")
        return message

    def _send(self, message):
        # closed: why, or that the run is over, is what the simulator has sent before
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):
            self._socket.sendall(struct.pack(">I", len(message)) + message)

    def _take(self, count):
        while len(self._incoming) < count:
            try:
                received = self._socket.recv(65536)
            except ConnectionResetError:
                received = b""
            if not received:
                raise RobotError("the simulator closed the connection") from None
            self._incoming += received
        taken = bytes(self._incoming[:count])
        del self._incoming[:count]
        return taken

    def _receive(self):
        (length,) = struct.unpack(">I", self._take(4))
        if length > LONGEST_MESSAGE:
            raise RobotError(f"the simulator announces a message of {length} bytes")
        try:
            message = messages.from_simulator(self._take(length))
        except (WireError, TypeError, ValueError) as error:
            raise RobotError(f"the simulator sends what is no message of this protocol: {error}") from error
        if isinstance(message, messages.Refusal):
            raise RobotError(f"the simulator refuses: {message.reason}")
        return message


def _connected(host, port, patience):
    """The simulator may start after its clients."""
    end = time.monotonic() + patience
    while True:
        try:
            connection = socket.create_connection((host, port))
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            return connection
        except OSError as error:
            if time.monotonic() >= end:
                raise RobotError(f"{host}:{port}: {error.strerror or error}") from error
        time.sleep(0.1)
