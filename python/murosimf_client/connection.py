"""Whole messages over TCP, each preceded by its length: 4 bytes, the most significant one first."""

import contextlib
import socket
import struct
import time


class SimulatorError(Exception):
    """Nobody listens, there is nothing of a name, or the simulator has ended the connection. One line."""


class Connection:
    def __init__(self, host, port, patience, longest):
        """Waits `patience` [s] for somebody to listen: the simulator may start after its clients. `longest` [byte] of what it
        sends."""
        self._socket = _connected(host, port, patience)
        self._longest = longest
        self._incoming = bytearray()

    def send(self, message):
        # closed: why, or that the run is over, is what the simulator has sent before
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):
            self._socket.sendall(struct.pack(">I", len(message)) + message)

    def receive(self):
        (length,) = struct.unpack(">I", self._take(4))
        if length > self._longest:
            raise SimulatorError(f"the simulator announces a message of {length} bytes")
        return self._take(length)

    def close(self):
        self._socket.close()

    def _take(self, count):
        while len(self._incoming) < count:
            try:
                received = self._socket.recv(65536)
            except ConnectionResetError:
                received = b""
            if not received:
                raise SimulatorError("the simulator closed the connection") from None
            self._incoming += received
        taken = bytes(self._incoming[:count])
        del self._incoming[:count]
        return taken


def _connected(host, port, patience):
    end = time.monotonic() + patience
    while True:
        try:
            connection = socket.create_connection((host, port))
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            return connection
        except OSError as error:
            if time.monotonic() >= end:
                raise SimulatorError(f"{host}:{port}: {error.strerror or error}") from error
        time.sleep(0.1)
