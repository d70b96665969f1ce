#!/usr/bin/env python3
"""The Python client: its encoding against protoc's, and robots that it moves against the same behavior in C++.

    python/tests/test_client.py PROGRAM PROTOC WALK_TO_BALL_TCP
"""

import math
import pathlib
import re
import socket
import subprocess
import sys
import threading
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

from murosimf_client import Robot, RobotError, messages, wire  # noqa: E402

PROGRAM, PROTOC, WALK_TO_BALL_TCP = [pathlib.Path(name).resolve() for name in sys.argv[1:4]] or [None] * 3
SCENE = ROOT / "examples/controllers/to_the_ball_tcp.toml"
TIME_LIMIT = 60  # [s]


def protoc(*words, given):
    folder = ROOT / "murosimf/wire"
    return subprocess.run([PROTOC, *words, f"-I{folder}", folder / "robot_protocol.proto"], input=given,
                          stdout=subprocess.PIPE, check=True, timeout=TIME_LIMIT).stdout


def decoded(content):
    text = protoc("--decode=murosimf.wire.FromClient", given=content).decode()
    return " ".join(text.split())


def encoded(text):
    return protoc("--encode=murosimf.wire.ToClient", given=text.encode())


class Encoding(unittest.TestCase):
    """protoc is the judge."""

    def test_what_clients_send(self):
        self.assertEqual(decoded(messages.hello("striker", 62.5, "walk.py")),
                         'hello { version: 1 robot: "striker" rate: 62.5 software: "walk.py" }')
        self.assertEqual(decoded(messages.ask("imu.gyroscope", True)), 'ask { signal: "imu.gyroscope" }')
        self.assertEqual(decoded(messages.ask("joint.target", False)), 'ask { command: "joint.target" }')
        self.assertEqual(decoded(messages.ready()), "ready { }")
        self.assertEqual(decoded(messages.commands(300, [[0.5, -1e-300, math.inf], []], ["one", "two"])),
                         "commands { cycle: 300 rows { values: 0.5 values: -1e-300 values: inf } rows { } "
                         'says: "one" says: "two" }')

    def test_long_messages(self):
        text = decoded(messages.commands(2**63 + 5, [[float(i) for i in range(1000)]], []))
        self.assertIn("cycle: 9223372036854775813 ", text)
        self.assertEqual(re.findall(r"values: (\d+)", text), [str(i) for i in range(1000)])

    def test_what_the_simulator_sends(self):
        read = messages.from_simulator
        self.assertEqual(read(encoded('welcome { robot: "a" team: "b" model: "c" period: 0.05 seed: 18446744073709551615 '
                                      "lock_step: true }")),
                         messages.Welcome("a", "b", "c", 0.05, 2**64 - 1, True))
        self.assertEqual(read(encoded('refusal { reason: "n\\303\\266" }')), messages.Refusal("nö"))
        self.assertEqual(read(encoded('description { labels: "x" labels: "y" values: 1 values: -2.5 }')),
                         messages.Description(["x", "y"], [1.0, -2.5]))
        self.assertEqual(read(encoded("cycle { cycle: 7 start: true now: -3 samples { time: -1 samples: 9 values: 1e300 } "
                                      "samples { } }")),
                         messages.Cycle(7, True, -3, [messages.Sample(-1, 9, [1e300]), messages.Sample()]))
        self.assertEqual(read(encoded("goodbye { }")), messages.Goodbye())

    def test_unknown_fields_are_skipped(self):
        content = encoded("cycle { cycle: 7 }")
        more = wire.field_varint(99, 5) + wire.field_double(98, 1.5) + wire.field_bytes(97, "text")
        self.assertEqual(messages.from_simulator(more + wire.field_bytes(4, wire.field_varint(1, 7) + more)),
                         messages.from_simulator(content))

    def test_what_is_no_message(self):
        whole = encoded("cycle { cycle: 700 now: 5 samples { values: 1 } }")
        for wrong in [b"", b"\x80" * 20, whole[:-1], whole[:1], b"\x1b", wire.field_bytes(4, wire.field_bytes(4, b"\x1a\1x"))]:
            with self.assertRaises(wire.WireError):
                messages.from_simulator(wrong)


class Run:
    """A run of the example scene, with what it prints."""

    def __init__(self, *options):
        self.process = subprocess.Popen([PROGRAM, "run", SCENE, "--listen", "0", "--duration", "10", *options],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.port = int(self.process.stderr.readline().rpartition(":")[2])

    def end(self):
        out, err = self.process.communicate(timeout=TIME_LIMIT)
        return self.process.returncode, out, err

    def state_hash(self):
        code, out, err = self.end()
        assert code == 0, err
        return re.search(r"state hash (\w+)", out)[1]


def in_python(port, robot):
    return [sys.executable, ROOT / "examples/controllers/walk_to_ball.py", str(port), robot]


def in_cpp(port, robot):
    return [WALK_TO_BALL_TCP, str(port), robot]


def hash_of(left, right, *options):
    run = Run(*options)
    environment = {"PYTHONPATH": str(ROOT / "python")}
    clients = [subprocess.Popen([*map(str, make(run.port, robot))], env=environment)
               for make, robot in [(left, "left"), (right, "right")]]
    state_hash = run.state_hash()
    assert [client.wait(TIME_LIMIT) for client in clients] == [0, 0]
    return state_hash


class Walking(unittest.TestCase):
    def test_same_state_in_both_languages(self):
        cpp = hash_of(in_cpp, in_cpp)
        self.assertEqual(hash_of(in_python, in_python), cpp)
        self.assertEqual(hash_of(in_python, in_cpp, "--threads", "2"), cpp)

    def test_robots_in_threads(self):
        run, errors = Run(), []

        def stand(name):
            with Robot(name, run.port) as robot:
                if robot.info.model != "kid21":
                    errors.append(robot.info)
                try:
                    robot.signal("imu.gyroskope")
                except RobotError as error:
                    errors.append(str(error))
                target = robot.command("joint.target")
                for cycle in robot.cycles():
                    target.values[0] = 1e-9 * cycle.now / 100

        threads = [threading.Thread(target=stand, args=[name]) for name in ("left", "right")]
        for thread in threads:
            thread.start()
        run.state_hash()
        for thread in threads:
            thread.join(TIME_LIMIT)
        self.assertEqual(len(errors), 2)
        for error in errors:
            self.assertIn("did you mean 'imu.gyroscope'", error)

    def test_who_is_refused_is_told_why(self):
        run = Run("--set", "defaults.options.wait=1")
        with self.assertRaisesRegex(RobotError, "unknown robot with the controller 'tcp' 'lefd'; did you mean 'left'"):
            Robot("lefd", run.port)
        code, _, err = run.end()
        self.assertEqual(code, 2)
        self.assertRegex(err, r"left: no software has come for it to 127.0.0.1:\d+ within 1 s")

    def test_nobody_listens(self):
        with socket.socket() as unused:
            unused.bind(("127.0.0.1", 0))
            port = unused.getsockname()[1]
        with self.assertRaisesRegex(RobotError, f"127.0.0.1:{port}: "):
            Robot("left", port, patience=0)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    unittest.main(argv=sys.argv[:1])
