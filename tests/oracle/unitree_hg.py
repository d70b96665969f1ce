#!/usr/bin/env python3
"""A low-level program of Unitree against a simulated G1, by Cyclone DDS with types of its own.

Usage: unitree_hg.py MUROSIMF

As the vendor's example does, a program finds the robot at the interface lo, has its motors released, and stands by commands with
gains; it is killed, and another one moves an elbow by a sine. A command with a wrong checksum is ignored and named. Nothing
listens beside 127.0.0.1. It takes eight seconds of real time.
Needs cyclonedds in this Python; without it, it is skipped (exit code 77).
"""

import json
import math
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

try:
    from cyclonedds.core import Policy, Qos
    from cyclonedds.domain import Domain, DomainParticipant
    from cyclonedds.pub import DataWriter
    from cyclonedds.sub import DataReader
    from cyclonedds.topic import Topic
except ImportError as missing:
    print(f"skipped: {missing}; pip install cyclonedds")
    sys.exit(77)

import unitree_types as unitree
from errors import end, errors
from socket_places import socket_places

DOMAIN = 89
DURATION = 12  # [s]
DISCOVERY = "239.255.0.1"
# as unitree_sdk2py configures Cyclone DDS for an interface that it is given
VENDOR = """<CycloneDDS><Domain Id="any"><General><Interfaces>
<NetworkInterface name="lo" priority="default" multicast="default"/></Interfaces></General></Domain></CycloneDDS>"""
JOINTS, ELBOW = 29, 18
# of the robot's file: the vendor's examples have 60 to 100 N m/rad in legs, and the robot hangs in a frame
GAINS = [*[(500, 20)] * 4, (400, 20), (400, 20)] * 2 + [(400, 20)] * 3 + [(40, 1)] * 14
ALL_STATES = Qos(Policy.History.KeepLast(2000))


def expect(what, good, got):
    print(("ok      " if good else "FAILED  ") + what, got)
    if not good:
        errors.append(f"{what}: {got}")


def wait_for(condition, seconds=5.0):
    stop = time.monotonic() + seconds
    while time.monotonic() < stop:
        if value := condition():
            return value
        time.sleep(0.002)
    return None


class Program:
    def __init__(self):
        self.domain = Domain(DOMAIN, VENDOR)
        self.participant = DomainParticipant(DOMAIN)
        self.states = DataReader(self.participant, self.topic("rt/lowstate", unitree.LowState))
        self.commands = DataWriter(self.participant, self.topic("rt/lowcmd", unitree.LowCommand))
        self.state = None

    def topic(self, name, kind):
        return Topic(self.participant, name, kind)

    def look(self):
        """The newest state."""
        for sample in self.states.take(1):
            self.state = sample
        return self.state

    def positions(self):
        self.look()
        return [motor.q for motor in self.state.motor_state[:JOINTS]]

    def write(self, targets, wrong=0):
        command = unitree.LowCommand(mode_machine=self.state.mode_machine)
        for motor, q, (kp, kd) in zip(command.motor_cmd, targets, GAINS, strict=False):
            motor.mode, motor.q, motor.kp, motor.kd = 1, q, kp, kd
        command.crc = unitree.crc_of_command(command) ^ wrong
        self.commands.write(command)


class MotionSwitcher:
    def __init__(self, program):
        self.requests = DataWriter(program.participant, program.topic("rt/api/motion_switcher/request", unitree.Request))
        self.answers = DataReader(program.participant, program.topic("rt/api/motion_switcher/response", unitree.Response))
        self.number = 0
        wait_for(lambda: self.requests.get_publication_matched_status().current_count and
                 self.answers.get_subscription_matched_status().current_count)

    def call(self, api):
        self.number += 1
        request = unitree.Request()
        request.header.identity = unitree.Identity(self.number, api)
        self.requests.write(request)
        answer = wait_for(lambda: next(iter(self.answers.take(1)), None), 1)
        same = answer and (answer.header.identity.id, answer.header.identity.api_id) == (self.number, api)
        return (answer.header.status.code, json.loads(answer.data or "{}")) if same else (None, {})


def stand_for_ever():
    """The program that is killed."""
    program = Program()
    switcher = MotionSwitcher(program)
    wait_for(program.look)
    _, mode = switcher.call(1001)
    released, _ = switcher.call(1003)
    _, none = switcher.call(1001)
    print(json.dumps([mode.get("name"), released, none.get("name")]), flush=True)
    stance = program.positions()
    while True:
        program.write(stance)
        time.sleep(0.002)


def check_states(program):
    state = program.look()
    expect("checksum of a state", state.crc == unitree.crc_of_state(state), hex(state.crc))
    expect("its kind", state.mode_machine == 5 and state.mode_pr == 0, (state.mode_machine, state.mode_pr))
    on = sum(motor.mode for motor in state.motor_state)
    expect("its motors", on == JOINTS, on)
    imu = state.imu_state
    expect("its quaternion", abs(math.hypot(*imu.quaternion) - 1) < 1e-5 and imu.quaternion[0] > 0.99, imu.quaternion)
    expect("gravity", abs(imu.accelerometer[2] - 9.81) < 1, imu.accelerometer)


def check_rate(program):
    readers = [DataReader(program.participant, program.topic(name, kind), qos=ALL_STATES)
               for name, kind in (("rt/lowstate", unitree.LowState), ("rt/secondary_imu", unitree.Imu))]
    wait_for(lambda: all(reader.get_subscription_matched_status().current_count for reader in readers))
    time.sleep(0.1)
    [reader.take(2000) for reader in readers]
    begin = time.monotonic()
    time.sleep(0.4)
    for reader in reversed(readers):  # those of the torso are decoded in no time
        waited = time.monotonic() - begin
        count = len(samples := reader.take(2000))
        expect(f"states of {reader.topic.name} a second", 200 < count / waited < 800, f"{count / waited:.0f}")
    ticks = [sample.tick for sample in samples]
    steps = [b - a for a, b in zip(ticks, ticks[1:], strict=False)]
    if len(steps) < 50:
        return expect("states to compare", False, len(steps))
    expect("ms from one to the next", sorted(steps)[len(steps) // 2] == 2, f"largest {max(steps)}")


def check_stand(program, stance):
    state = program.look()
    roll, pitch, _ = state.imu_state.rpy
    expect("stands", abs(roll) < 0.3 and abs(pitch) < 0.3, (roll, pitch))
    off = max(abs(a - b) for a, b in zip(program.positions(), stance, strict=True))
    expect("near its stance", off < 0.15, off)


def check_sine(program, stance):
    """By a program of its own, after the other one was killed."""
    begin, off, written = time.monotonic(), [], 0
    while (t := time.monotonic() - begin) < 1.2:
        targets = list(stance)
        targets[ELBOW] += 0.3 * math.sin(2 * math.pi * t)
        program.write(targets)
        written += 1
        if t > 0.2:
            off.append(abs(program.positions()[ELBOW] - targets[ELBOW]))
        time.sleep(0.001)
    # a process may be held up for a moment; an elbow that does not follow is 0.29 rad off
    typical = sorted(off)[len(off) * 9 // 10] if off else math.inf
    found = f"nine times of ten within {typical:.3f} rad, {written} commands"
    expect("the elbow follows a sine of 0.3 rad", typical < 0.15, found)


def check_checksum(program, stance):
    targets = list(stance)
    for _ in range(100):
        program.write(targets)
        time.sleep(0.005)
    before = program.positions()[ELBOW]
    targets[ELBOW] += 1
    for _ in range(40):
        program.write(targets, wrong=1)
        time.sleep(0.005)
    after = program.positions()[ELBOW]
    expect("commands with a wrong checksum do nothing", abs(after - before) < 0.1, (before, after))


def check_sockets(process):
    found = {place.rpartition(":")[0] for place in socket_places(process)}
    expect("sockets", bool(found) and found <= {"127.0.0.1", DISCOVERY}, sorted(found))


def check_command_line(murosimf):
    for scene, words, why in (("walk", ["--unitree"], "no robot is controlled by low-level programs of Unitree"),
                              ("unitree", ["--unitree", "233"], "a DDS domain is a number from 0 to 232")):
        done = subprocess.run([murosimf, "run", scene, *words, "--duration", "0.1"], capture_output=True, text=True, check=False)
        expect(f"run {scene} {' '.join(words)} is refused", done.returncode == 2 and why in done.stderr, done.stderr.strip())


def main():
    murosimf = sys.argv[1]
    if "--write" in sys.argv:
        stand_for_ever()
    check_command_line(murosimf)
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        run = subprocess.Popen([murosimf, "run", "unitree", "--unitree", str(DOMAIN), "--speed", "1", "--duration", str(DURATION),
                                "--no-cameras", "--json", str(report)], stdout=subprocess.DEVNULL)
        child = subprocess.Popen([sys.executable, __file__, murosimf, "--write"], stdout=subprocess.PIPE, text=True)
        program = Program()
        expect("states come", wait_for(program.look) is not None, program.state and program.state.tick)
        if not program.state:
            run.kill()
            child.kill()
            end()
        modes = json.loads(child.stdout.readline() or "[]")
        expect("motors are released", modes == ["ai", 0, ""], modes)
        stance = program.positions()
        begin = time.monotonic()
        check_states(program)
        check_rate(program)
        time.sleep(max(0, 1.5 - (time.monotonic() - begin)))
        check_stand(program, stance)
        child.send_signal(signal.SIGKILL)
        child.wait()
        tick = program.look().tick
        check_sine(program, stance)
        expect("states come after a program was killed", program.look().tick > tick + 500, program.state.tick - tick)
        check_checksum(program, stance)
        check_stand(program, stance)
        check_sockets(run.pid)
        code = run.wait(60)
        expect("exit code of the run", code == 0, code)
        said = [line["text"] for line in json.loads(report.read_text())["control"][0]["said"]]
        expect("its first line", said[:1] == ["a low-level program has come"], said)
        expect("the wrong checksum is named once", sum("with the CRC 0x" in line for line in said) == 1, said)
    end()


if __name__ == "__main__":
    main()
