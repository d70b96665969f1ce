#!/usr/bin/env python3
"""The Python client: its encoding against protoc's, and robots that it moves against the same behavior in C++.

    python/tests/test_client.py PROGRAM PROTOC WALK_TO_BALL_TCP
"""

import csv
import math
import os
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import threading
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

from murosimf_client import (  # noqa: E402
    LINE,
    RequestRefused,
    Robot,
    RobotError,
    Shape,
    SimulatorError,
    Supervisor,
    messages,
    supervision,
    wire,
)

PROGRAM, PROTOC, WALK_TO_BALL_TCP = [pathlib.Path(name).resolve() for name in sys.argv[1:4]] or [None] * 3
SCENE = ROOT / "examples/controllers/to_the_ball_tcp.toml"
TIME_LIMIT = 60  # [s]


def protoc(*words, given, file):
    folder = ROOT / "murosimf/network"
    return subprocess.run([PROTOC, *words, f"-I{folder}", folder / file], input=given, stdout=subprocess.PIPE, check=True,
                          timeout=TIME_LIMIT).stdout


def decoded(content, message="FromClient", file="robot_protocol.proto"):
    text = protoc(f"--decode=murosimf.wire.{message}", given=content, file=file).decode()
    return " ".join(text.split())


def encoded(text, message="ToClient", file="robot_protocol.proto"):
    return protoc(f"--encode=murosimf.wire.{message}", given=text.encode(), file=file)


class Encoding(unittest.TestCase):
    """protoc is the judge."""

    def test_what_clients_send(self):
        self.assertEqual(decoded(messages.hello("striker", 62.5, "walk.py")),
                         'hello { version: 1 robot: "striker" rate: 62.5 software: "walk.py" }')
        self.assertEqual(decoded(messages.ask_signal("imu.gyroscope")), 'ask { signal: "imu.gyroscope" }')
        self.assertEqual(decoded(messages.ask_command("joint.target")), 'ask { command: "joint.target" }')
        self.assertEqual(decoded(messages.ask_picture("camera.color")), 'ask { picture: "camera.color" }')
        self.assertEqual(decoded(messages.ask_messages()), "ask { messages: true }")
        self.assertEqual(decoded(messages.ready()), "ready { }")
        self.assertEqual(decoded(messages.commands(300, [[0.5, -1e-300, math.inf], []], ["one", "two"])),
                         "commands { cycle: 300 rows { values: 0.5 values: -1e-300 values: inf } rows { } "
                         'says: "one" says: "two" }')
        self.assertEqual(decoded(messages.commands(1, [], [], [b"a\0\xff"])),
                         'commands { cycle: 1 sends: "a\\000\\377" }')

    def test_drawings(self):
        drawing = messages.drawing("way", [Shape(LINE, [(0, 0, 0), (1, 2, 3)], 0.5, (1, 0, 0), "x")], True)
        self.assertEqual(decoded(messages.commands(1, [], [], [], [drawing])),
                         'commands { cycle: 1 draws { group: "way" of_robot: true shapes { kind: LINE points: 0 points: 0 '
                         'points: 0 points: 1 points: 2 points: 3 size: 0.5 color: 1 color: 0 color: 0 text: "x" } } }')

    def test_what_supervisors_send(self):
        def seen(content):
            return decoded(content, "FromSupervisor", "supervision.proto")

        self.assertEqual(seen(supervision.hello("secret", "me")), 'hello { version: 1 token: "secret" name: "me" }')
        for number, name in {supervision.STATUS: "status", supervision.PAUSE: "pause", supervision.GO_ON: "go_on",
                             supervision.DESCRIBE: "describe", supervision.BRANCHES: "branches", supervision.SAVE: "save",
                             supervision.FINISH: "finish"}.items():
            self.assertEqual(seen(supervision.plain(number)), f"{name} {{ }}")
        self.assertEqual(seen(supervision.step(7)), "step { count: 7 }")
        self.assertEqual(seen(supervision.speed(0.5)), "speed { factor: 0.5 }")
        self.assertEqual(seen(supervision.advance(5)), "advance { duration: 5 }")
        self.assertEqual(seen(supervision.run_until(5)), "run_until { end: 5 }")
        self.assertEqual(seen(supervision.change(["a", "b"])), 'change { changes: "a" changes: "b" }')
        self.assertEqual(seen(supervision.read(["a", "b"])), 'read { patterns: "a" patterns: "b" }')
        self.assertEqual(seen(supervision.events(3)), "events { first: 3 }")
        self.assertEqual(seen(supervision.reset(None)), "reset { }")
        self.assertEqual(seen(supervision.reset(9)), "reset { seed: 9 }")
        self.assertEqual(seen(supervision.seek(-1, None)), "seek { time: -1 }")
        self.assertEqual(seen(supervision.load(b"ab", last=True)), 'load { content: "ab" last: true }')
        self.assertEqual(seen(supervision.load_scene("walk", ["a=1"], 3, paused=True)),
                         'load_scene { scene: "walk" overrides: "a=1" seed: 3 paused: true }')
        self.assertEqual(seen(supervision.record(True)), "record { on: true }")
        self.assertEqual(seen(supervision.record(False)), "record { }")
        self.assertEqual(seen(supervision.seek(5, 0)), "seek { time: 5 branch: 0 }")

    def test_what_supervisors_are_sent(self):
        def read(text):
            return supervision.from_simulator(encoded(text, "ToSupervisor", "supervision.proto"))

        status = supervision.Status(1, 2, True, 0.5, 0.25, 3, 4, 5, 6, 7, 8, False, "so")
        text = ("time: 1 end: 2 paused: true speed: 0.5 factor: 0.25 jumps: 3 branch: 4 first: 5 last: 6 events: 7 warnings: 8 "
                'recorded: false diagnostic: "so"')
        self.assertEqual(read(f"status {{ {text} }}"), status)
        self.assertEqual(read(f'welcome {{ scene: "s" seed: 1 tick: 2 status {{ {text} }} }}'),
                         supervision.Welcome("s", 1, 2, status))
        self.assertEqual(read('refused { reason: "no" }'), supervision.Refused("no"))
        self.assertEqual(read('numbers { time: 5 names: "a" values: 1.5 }'), supervision.Numbers(5, ["a"], [1.5]))
        self.assertEqual(read('description { entities { name: "a" model: "b" level: "c" contact: "d" controller: "e" team: "f" '
                              'present: true objects: "g" objects: "h" } }'),
                         supervision.Scene([supervision.Entity("a", "b", "c", "d", "e", "f", True, ["g", "h"])]))
        self.assertEqual(read('events { events { time: 1 text: "a" } warnings: "b" }'),
                         supervision.Events([supervision.Event(1, "a")], ["b"]))
        self.assertEqual(read('branches { branches { number: 1 parent: 0 begin: 2 end: 3 commands { time: 2 text: "a" } } '
                              "branches { } }"),
                         supervision.Branches([supervision.Branch(1, 0, 2, 3, [supervision.Event(2, "a")]),
                                               supervision.Branch()]))
        self.assertEqual(read('state { time: 1 content: "\\000" }'), supervision.SavedState(1, b"\0"))
        self.assertEqual(read("goodbye { }"), supervision.Goodbye())

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
        self.assertEqual(read(encoded('description { picture { width: 640 height: 480 format: "rgb8" period: 0.05 } }')),
                         messages.Description(picture=messages.PictureFormat(640, 480, "rgb8", 0.05)))
        self.assertEqual(read(encoded('cycle { messages { content: "\\000x" sender: "blue1" sent: 5 } messages { } '
                                      'pictures { picture: 1 time: 7 number: 3 content: "\\377" } }')),
                         messages.Cycle(messages=[messages.TeamMessage(b"\0x", "blue1", 5), messages.TeamMessage()],
                                        pictures=[messages.ComePicture(1, 7, 3, b"\xff")]))
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

    def __init__(self, *options, duration=10):
        self.process = subprocess.Popen([PROGRAM, "run", SCENE, "--listen", "0", "--duration", str(duration), *options],
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

    def test_leds_gains_and_limits(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "leds.csv")
            logged = ["left.*.robot_led", *(f"left.j_head.servo_{what}" for what in ("led", "position_gain", "torque_limit"))]
            run = Run("--set", "defaults.level=articulated_dynamics", *(word for name in logged for word in ("--log", name)),
                      "--out", file, duration=0.3)

            def shine(name):
                with Robot(name, run.port) as robot:
                    leds, led = robot.command("joint.led"), robot.command("robot.led")
                    gains, limits = robot.command("joint.position_gain"), robot.command("joint.torque_limit")
                    head = gains.labels.index("j_head")
                    before.append((gains.values[head], limits.values[head]))
                    for cycle in robot.cycles():
                        if cycle.now < 10**8:
                            continue
                        leds.values[leds.labels.index("j_head")] = 0.5
                        led.values[:] = [1.0, 0.25, 0.0]
                        gains.values[head] = before[0][0] / 2
                        limits.values[head] = before[0][1] / 4

            before = []
            threads = [threading.Thread(target=shine, args=[name]) for name in ("left", "right")]
            for thread in threads:
                thread.start()
            code, _, err = run.end()
            self.assertEqual(code, 0, err)
            for thread in threads:
                thread.join(TIME_LIMIT)
            with open(file, newline="") as table:
                rows = list(csv.DictReader(table))

            def numbers(row):
                return [float(value) for name, value in row.items() if name != "time [s]"]

            (gain, limit), _ = before
            self.assertGreater(min(gain, limit), 0)
            self.assertEqual(numbers(rows[0]), [0, 0, 0, 0, gain, limit])
            self.assertEqual(numbers(rows[-1]), [1, 0.25, 0, 0.5, gain / 2, limit / 4])

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


class SupervisedRun:
    """A run of a walk that begins paused."""

    def __init__(self, *options):
        self.process = subprocess.Popen([PROGRAM, "run", "walk", "--set", "walker.level=simplified_dynamics", "--supervise",
                                         "0", "--paused", *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.port, self.token = re.search(r":(\d+), token (\w+)", self.process.stderr.readline()).groups()

    def supervisor(self):
        return Supervisor(int(self.port), self.token)

    def end(self):
        out, err = self.process.communicate(timeout=TIME_LIMIT)
        return self.process.returncode, out, err


class Supervising(unittest.TestCase):
    def test_a_run_that_is_steered_is_that_of_the_same_events(self):
        run = SupervisedRun()
        with run.supervisor() as supervisor:
            self.assertEqual(supervisor.tick, 0.001)
            self.assertEqual(supervisor.advance(1.0).time, 10**9)
            supervisor.push("walker.torso", [0, 20, 0], 0.1)
            supervisor.advance(1.0)
            there = supervisor.read("walker.torso.position").values
            supervisor.seek(1.5)
            supervisor.advance(0.5)
            self.assertEqual(supervisor.read("walker.torso.position").values, there)
            supervisor.place("walker", 1.0, 0.5, heading=0.25)
            supervisor.set_level("walker", "full_dynamics")
            supervisor.advance(1.0)
            self.assertIn("walker", [entity.name for entity in supervisor.entities()])
            self.assertGreaterEqual(len(supervisor.events().events), 3)
            self.assertTrue(supervisor.status().paused)
            with self.assertRaisesRegex(RequestRefused, "walker"):
                supervisor.change("wolker.level = full_dynamics")
            supervisor.finish()
        code, out, err = run.end()
        self.assertEqual((code, err), (0, ""))
        same = subprocess.run([PROGRAM, "run", "walk", "--set", "walker.level=simplified_dynamics", "--duration", "3", "--at",
                               "1:walker.torso.push=[0, 20, 0, 0.1]", "--at", "2:walker.place=[1.0, 0.5, 0.0, 0.25]", "--at",
                               "2:walker.level=full_dynamics"], stdout=subprocess.PIPE, text=True, check=True,
                              timeout=TIME_LIMIT).stdout
        self.assertEqual(re.search(r"state hash (\w+)", out)[1], re.search(r"state hash (\w+)", same)[1])

    def test_what_is_recorded_of_a_steered_run_is_repeated(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "steered.mcap")
            run = SupervisedRun("--record", file, "--at", "1:walker.command=[0.05, 0, 0]")
            with run.supervisor() as supervisor:
                supervisor.push("walker", [0, 5, 0], 0.05)  # before the first step
                supervisor.advance(1.0)  # at a second, when hashes are recorded and the scene has an event of its own
                supervisor.push("walker.torso", [0, 20, 0], 0.1)
                supervisor.change("walker.command = [0.1, 0, 0.2]")
                supervisor.advance(0.7345)
                supervisor.set_level("walker", "articulated_dynamics")
                supervisor.advance(0.5)
                supervisor.set_level("walker", "simplified_dynamics")
                supervisor.place("walker", 1.0, 0.5, heading=0.25)
                supervisor.advance(0.7655)
                supervisor.place("walker", -1.0, 0.5)  # after the last step
                supervisor.finish()
            code, out, err = run.end()
            self.assertEqual((code, err), (0, ""))
            again = subprocess.run([PROGRAM, "rerun", file], capture_output=True, text=True, timeout=TIME_LIMIT)
            self.assertIn("no difference", again.stdout, again.stderr)
            self.assertEqual((again.returncode, again.stderr), (0, ""))

    def test_records_what_is_asked_for(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "asked.mcap")
            run = SupervisedRun("--record", file, "--record-on", "asked,fall", "--keep", "0.2")
            with run.supervisor() as supervisor:
                self.assertIs(supervisor.advance(1.0).recorded, False)
                self.assertIs(supervisor.record().recorded, True)
                supervisor.push("walker.torso", [0, 2, 0], 0.1)
                supervisor.advance(0.5)
                self.assertIs(supervisor.record(False).recorded, False)
                supervisor.advance(1.0)
                supervisor.finish()
            self.assertEqual(run.end()[::2], (0, ""))
            again = subprocess.run([PROGRAM, "rerun", file], capture_output=True, text=True, timeout=TIME_LIMIT)
            self.assertIn("no difference", again.stdout, again.stderr)
            begin, end = map(float, re.search(r"from (\S+) s to (\S+) s", again.stdout).groups())
            self.assertTrue(0.6 <= begin <= 0.8 and 1.4 <= end <= 1.7, again.stdout)
        run = SupervisedRun()
        with run.supervisor() as supervisor:
            self.assertIsNone(supervisor.status().recorded)
            with self.assertRaisesRegex(RequestRefused, "--record-on asked"):
                supervisor.record()
            supervisor.finish()
        run.end()

    def test_another_run_goes_on_from_a_saved_state(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "one.state")
            run = SupervisedRun()
            with run.supervisor() as supervisor:
                supervisor.advance(1.0)
                supervisor.save_to(file)
                supervisor.finish()
            run.end()
            walk = [PROGRAM, "run", "walk", "--set", "walker.level=simplified_dynamics", "--duration", "2"]
            hashes = [re.search(r"state hash (\w+)", subprocess.run([*walk, *more], capture_output=True, text=True, check=True,
                                                                    timeout=TIME_LIMIT).stdout)[1]
                      for more in ([], ["--from", file])]
            self.assertEqual(*hashes)
            run = SupervisedRun()
            with run.supervisor() as supervisor:
                supervisor.advance(0.3)
                with self.assertRaisesRegex(RequestRefused, "of_a_supervisor.state"):
                    supervisor.load(b"no state")
                self.assertEqual(supervisor.load_from(file).time, 10**9)
                supervisor.advance(1.0)
                supervisor.finish()
            self.assertEqual(re.search(r"state hash (\w+)", run.end()[1])[1], hashes[0])

    def test_other_scenes_take_the_place_of_the_run(self):
        run = SupervisedRun()
        with run.supervisor() as supervisor, run.supervisor() as other:
            supervisor.advance(0.3)
            self.assertNotEqual(other.read("walker.torso.position").time, 0)
            with self.assertRaisesRegex(RequestRefused, "nosuch"):
                supervisor.load_scene("nosuch")
            with self.assertRaisesRegex(RequestRefused, "wolker"):
                supervisor.load_scene("walk", ["wolker.level=full_dynamics"])
            with tempfile.TemporaryDirectory() as elsewhere:
                robot = '[[robots]]\nname = "robot"\nmodel = "kid21"\n'
                for name, text in (("scene.toml", robot), ("secret.toml", 'key = "CANARY"\n')):
                    with open(os.path.join(elsewhere, name), "w", encoding="utf-8") as file:
                        file.write(text)
                    with self.assertRaisesRegex(RequestRefused, "no file") as refused:
                        supervisor.load_scene(os.path.join(elsewhere, name))
                    self.assertNotIn("CANARY", str(refused.exception))
                for settings in (["walker.library=" + elsewhere], ["walker.controller=library"], ["walker.model=" + elsewhere]):
                    with self.assertRaisesRegex(RequestRefused, "walker"):
                        supervisor.load_scene("walk", settings)
            self.assertEqual(supervisor.advance(0.1).time, 4 * 10**8)
            files = len(os.listdir(f"/proc/{run.process.pid}/fd"))
            for _ in range(5):
                for scene in ("nudge", "walk"):
                    supervisor.load_scene(scene, seed=3)
            self.assertLessEqual(len(os.listdir(f"/proc/{run.process.pid}/fd")), files + 2)
            self.assertEqual(other.read("walker.torso.position").time, 0)  # of this walker, not of the first one
            with self.assertRaisesRegex(RequestRefused, "seed"):
                supervisor.load_scene("walk", seed=2**63)
            supervisor.load_scene("nudge", ["robot.level=simplified_dynamics"], seed=3)
            self.assertEqual((supervisor.seed, other.status().time), (3, 0))
            other.advance(1.0)
            supervisor.finish()
        out = run.end()[1]
        same = subprocess.run([PROGRAM, "run", "nudge", "--set", "robot.level=simplified_dynamics", "--seed", "3", "--duration",
                               "1"], stdout=subprocess.PIPE, text=True, check=True, timeout=TIME_LIMIT).stdout
        self.assertEqual(re.search(r"state hash (\w+)", out)[1], re.search(r"state hash (\w+)", same)[1])

    def test_who_does_not_know_the_token_is_refused(self):
        run = SupervisedRun()
        with self.assertRaisesRegex(SimulatorError, "it does not know the token"):
            Supervisor(int(run.port), "another")
        run.supervisor().finish()
        self.assertRegex(run.end()[2], r"supervisor 127.0.0.1:\d+ was refused: it does not know the token")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    unittest.main(argv=sys.argv[:1])
