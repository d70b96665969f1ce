"""A WebSocket client of a few lines (RFC 6455), which can also say what it must not; and murosimf run --web as a process."""
import base64
import json
import os
import re
import signal
import socket
import struct
import subprocess
import threading
import time


class Refused(Exception):
    """The server did not open a WebSocket; the text is its answer's first line."""


class Client:
    """Connects at once. `slow`: a small window for what comes."""

    def __init__(self, port, path="/", protocol="murosimf.v1", headers=(), host="127.0.0.1", slow=False):
        self.socket = socket.socket()
        if slow:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        self.socket.settimeout(20)
        self.socket.connect((host, port))
        self.buffer = b""
        self.latest = None  # state that has come
        key = base64.b64encode(os.urandom(16)).decode()
        lines = [f"GET {path} HTTP/1.1", f"Host: {host}:{port}", "Upgrade: websocket", "Connection: Upgrade",
                 f"Sec-WebSocket-Key: {key}", "Sec-WebSocket-Version: 13", *headers]
        if protocol:
            lines.append(f"Sec-WebSocket-Protocol: {protocol}")
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode())
        head = self.until(b"\r\n\r\n").decode()
        if " 101 " not in head.split("\r\n", maxsplit=1)[0]:
            raise Refused(head.split("\r\n", maxsplit=1)[0])
        self.head = head

    def until(self, end):
        while end not in self.buffer:
            more = self.socket.recv(65536)
            if not more:
                raise Refused(f"closed: {self.buffer[:80]!r}")
            self.buffer += more
        found, self.buffer = self.buffer.split(end, 1)
        return found

    def take(self, count):
        while len(self.buffer) < count:
            more = self.socket.recv(1 << 20)
            if not more:
                raise ConnectionError("the server closed the connection")
            self.buffer += more
        found, self.buffer = self.buffer[:count], self.buffer[count:]
        return found

    def send(self, data, opcode=None):
        binary = isinstance(data, bytes)
        payload = data if binary else data.encode()
        head = bytes([0x80 | (opcode if opcode is not None else 2 if binary else 1)])
        size = len(payload)
        head += bytes([0x80 | size]) if size < 126 else (
            bytes([0x80 | 126]) + struct.pack(">H", size) if size < 65536 else bytes([0x80 | 127]) + struct.pack(">Q", size))
        mask = os.urandom(4)
        self.socket.sendall(head + mask + bytes(c ^ mask[i % 4] for i, c in enumerate(payload)))

    def order(self, **what):
        self.send(json.dumps(what))

    def receive(self):
        """A whole message, text or bytes; ConnectionError with code and reason when the server closes."""
        parts, kind = b"", 0
        while True:
            first, second = self.take(2)
            size = second & 127
            if size == 126:
                size = struct.unpack(">H", self.take(2))[0]
            elif size == 127:
                size = struct.unpack(">Q", self.take(8))[0]
            payload = self.take(size)
            opcode = first & 15
            if opcode == 8:
                code = struct.unpack(">H", payload[:2])[0] if len(payload) >= 2 else 0
                raise ConnectionError(code, payload[2:].decode())
            if opcode in (9, 10):
                continue
            kind, parts = opcode or kind, parts + payload
            if first & 0x80:
                return parts.decode() if kind == 1 else parts

    def wait_for(self, good, seconds=30):
        """The first message for which good(message) is true; JSON is parsed; poses are acknowledged."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            message = self.receive()
            if isinstance(message, bytes) and message[0] == 1:
                self.order(do="seen")
            if isinstance(message, str):
                message = json.loads(message)
                if message.get("is") == "state":
                    self.latest = message["state"]
            if good(message):
                return message
        raise TimeoutError("it did not come")

    def answer(self, number):
        return self.wait_for(lambda m: isinstance(m, dict) and m.get("id") == number)

    def state(self, good=lambda state: True):
        """The latest one, which may have come while something else was waited for, or the first one to come that is good."""
        if self.latest is not None and good(self.latest):
            return self.latest
        return self.wait_for(lambda m: isinstance(m, dict) and m["is"] == "state" and good(m["state"]))["state"]

    def poses(self):
        return self.wait_for(lambda m: isinstance(m, bytes) and m[0] == 1)

    def close(self):
        self.socket.close()


class Run:
    """murosimf run SCENE --web: ends with the block."""

    def __init__(self, program, *words, web="0", command="run", **environment):
        self.process = subprocess.Popen([program, command, *words, "--web", web], stderr=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True, env={**os.environ, **environment})
        self.said = []
        while True:
            line = self.process.stderr.readline()
            if not line:
                raise RuntimeError("".join(self.said))
            self.said.append(line)
            found = re.search(r"ws://([^/]*):(\d+)/\?token=(\w+)", line)
            if found:
                self.port, self.token = int(found[2]), found[3]
                break
        self.reader = threading.Thread(target=lambda: self.said.extend(self.process.stderr), daemon=True)
        self.reader.start()

    def stop(self):
        """Exit code and standard output after Ctrl-C."""
        self.process.send_signal(signal.SIGINT)
        output = self.process.stdout.read()
        return self.process.wait(timeout=60), output

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()


def time_of(poses):
    """[s] of a message of poses."""
    return struct.unpack_from("<d", poses, 8)[0]
