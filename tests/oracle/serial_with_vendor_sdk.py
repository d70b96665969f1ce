#!/usr/bin/env python3
"""Moves a robot with the vendor's own software, dynamixel-sdk, over its serial line, as a program for the real bus would.

Usage: serial_with_vendor_sdk.py <murosimf>
Exit: 0 all is as on the bus, 1 something is not, 77 the package or pseudo terminals are missing (test is skipped).

Both protocols: pings, reads, writes, registered writes, sync and bulk, errors, reboot and factory reset, and a walk whose joint
targets are sent one hundred times per second.
"""
import csv
import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

try:
    import dynamixel_sdk as sdk
except ImportError as missing:
    print(f"skipped: {missing}; pip install dynamixel-sdk")
    sys.exit(77)
if not os.path.exists("/dev/ptmx"):
    print("skipped: there are no pseudo terminals here")
    sys.exit(77)

from errors import end, errors

sdk.port_handler.LATENCY_TIMER = 200  # [ms] of its time-outs: machines that test are busy
SERVOS = list(range(1, 22))  # of kid21
IMU = 200
MIDDLE, PER_RADIAN = 2048, 4096 / 6.283185307179586
# addresses and sizes: ROBOTIS e-Manual
V1 = {"protocol": 1.0, "torque": 24, "led": 25, "goal": 30, "present": 36, "voltage": 42, "size": 2, "models": {29, 310}}
V2 = {"protocol": 2.0, "torque": 64, "led": 65, "goal": 116, "present": 132, "voltage": 144, "size": 4, "models": {30, 311}}
X = {**V2, "models": {1020}}


def expect(what, got, wanted):
    if got != wanted:
        errors.append(f"{what}: {got}, not {wanted}")


class Robot:
    """A running simulation of kid21 and the vendor's handlers for its line."""

    def __init__(self, program, folder, bus, duration=60, **options):
        self.bus, self.folder, self.report = bus, Path(folder), Path(folder) / "report.json"
        settings = {"controller": "serial", "options.protocol": int(bus["protocol"]), **options}
        command = [program, "run", "walk", "--speed", "1", "--duration", str(duration), "--json", str(self.report),
                   "--serial", folder, "--no-cameras"]
        for key, value in settings.items():
            command += ["--set", f"walker.{key}={value}"]
        self.link = self.folder / "walker"
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        while not self.link.exists():
            if self.process.poll() is not None:
                sys.exit(f"the simulation has ended with {self.process.returncode}")
            time.sleep(0.01)
        self.open()

    def open(self):
        self.port = sdk.PortHandler(str(self.link))
        if not self.port.openPort() or not self.port.setBaudRate(1000000):
            sys.exit("the port cannot be opened")
        self.packets = sdk.PacketHandler(self.bus["protocol"])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.port.closePort()
        if self.process.poll() is None:
            self.process.terminate()
        self.process.wait()

    def bytes_of(self, value, size=None):
        return list(int(value).to_bytes(size or self.bus["size"], "little", signed=value < 0))

    def sync_write(self, address, size, values):
        group = sdk.GroupSyncWrite(self.port, self.packets, address, size)
        for servo, value in values.items():
            assert group.addParam(servo, self.bytes_of(value, size))
        expect("sync write", group.txPacket(), sdk.COMM_SUCCESS)

    def read(self, servo, address, size):
        call = {1: self.packets.read1ByteTxRx, 2: self.packets.read2ByteTxRx, 4: self.packets.read4ByteTxRx}[size]
        value, result, error = call(self.port, servo, address)
        expect(f"reading {address} of {servo}", (result, error), (sdk.COMM_SUCCESS, 0))
        return value

    def positions(self):
        """Of all servos, in one exchange: sync read in 2.0, bulk read in 1.0."""
        address, size = self.bus["present"], self.bus["size"]
        if self.bus["protocol"] == 1.0:
            return self.bulk_read_1(address, size)
        group = sdk.GroupSyncRead(self.port, self.packets, address, size)
        for servo in SERVOS:
            assert group.addParam(servo)
        expect("sync read", group.txRxPacket(), sdk.COMM_SUCCESS)
        return {servo: group.getData(servo, address, size) for servo in SERVOS}

    def bulk_read_1(self, address, size):
        """By the handler of packets: GroupBulkRead of version 4.1.0 fails in protocol 1.0, it passes an argument too many."""
        asked = [number for servo in SERVOS for number in (size, servo, address)]
        expect("bulk read", self.packets.bulkReadTx(self.port, asked, len(asked)), sdk.COMM_SUCCESS)
        positions = {}
        for servo in SERVOS:
            data, result, error = self.packets.readRx(self.port, servo, size)
            expect(f"bulk read of {servo}", (result, error), (sdk.COMM_SUCCESS, 0))
            positions[servo] = int.from_bytes(bytes(data), "little")
        self.port.is_using = False
        return positions


def reach(robot, goals):
    """Joints need their time, and the machine may be busy: waits for the positions, not for a time."""
    for _ in range(100):
        positions = robot.positions()
        if all(abs(positions[servo] - goal) <= 2 for servo, goal in goals.items()):
            return
        time.sleep(0.05)
    errors.append(f"the goals {goals} are not reached: {positions}")


def check_bus(robot):
    bus = robot.bus
    models = set()
    for servo in SERVOS:
        model, result, error = robot.packets.ping(robot.port, servo)
        expect(f"ping of {servo}", (result, error), (sdk.COMM_SUCCESS, 0))
        models.add(model)
    expect("model numbers", models, bus["models"])
    expect("ping of the IMU", robot.packets.ping(robot.port, IMU)[1], sdk.COMM_SUCCESS)
    expect("ping of nobody", robot.packets.ping(robot.port, 100)[1], sdk.COMM_RX_TIMEOUT)
    expect("voltage", robot.read(1, bus["voltage"], 1), 120)
    robot.sync_write(bus["torque"], 1, {servo: 1 for servo in SERVOS})
    goals = {servo: MIDDLE + (-1) ** servo * 10 * servo for servo in SERVOS}
    robot.sync_write(bus["goal"], bus["size"], goals)
    reach(robot, goals)
    for servo in (1, 2):
        expect("registered write", robot.packets.regWriteTxRx(robot.port, servo, bus["goal"], bus["size"],
                                                               robot.bytes_of(MIDDLE + 7)), (sdk.COMM_SUCCESS, 0))
    expect("not yet", robot.read(1, bus["goal"], bus["size"]), goals[1])
    expect("action", robot.packets.action(robot.port, sdk.BROADCAST_ID), sdk.COMM_SUCCESS)
    reach(robot, {1: MIDDLE + 7, 2: MIDDLE + 7})


def check_protocol_1(robot):
    write = robot.packets.write2ByteTxRx
    expect("a limit", write(robot.port, 3, 8, 3000), (sdk.COMM_SUCCESS, 0))
    expect("a goal beyond it", write(robot.port, 3, 30, 3500), (sdk.COMM_SUCCESS, sdk.ERRBIT_ANGLE))
    expect("range", robot.packets.write1ByteTxRx(robot.port, 3, 24, 9), (sdk.COMM_SUCCESS, sdk.ERRBIT_RANGE))
    expect("action alone", robot.packets.action(robot.port, 3), sdk.COMM_SUCCESS)
    expect("factory reset", robot.packets.factoryReset(robot.port, 3), (sdk.COMM_SUCCESS, 0))
    expect("who was reset", robot.packets.ping(robot.port, 3)[1], sdk.COMM_RX_TIMEOUT)  # is 1 now


def check_protocol_2(robot):
    found, result = robot.packets.broadcastPing(robot.port)
    expect("broadcast ping", (sorted(found), result), (SERVOS, sdk.COMM_SUCCESS))
    write = robot.packets.write4ByteTxRx
    expect("limit", write(robot.port, 3, 116, 5000), (sdk.COMM_SUCCESS, sdk.ERRNUM_DATA_LIMIT))
    expect("range", robot.packets.write1ByteTxRx(robot.port, 3, 64, 9), (sdk.COMM_SUCCESS, sdk.ERRNUM_DATA_RANGE))
    expect("access", robot.packets.write1ByteTxRx(robot.port, 3, 7, 9), (sdk.COMM_SUCCESS, sdk.ERRNUM_ACCESS))
    lights = sdk.GroupBulkWrite(robot.port, robot.packets)
    assert lights.addParam(1, 65, 1, [1]) and lights.addParam(2, 104, 4, robot.bytes_of(50))
    expect("bulk write", lights.txPacket(), sdk.COMM_SUCCESS)
    mixed = sdk.GroupBulkRead(robot.port, robot.packets)
    assert mixed.addParam(2, 104, 4) and mixed.addParam(1, 65, 1) and mixed.addParam(IMU, 0, 2)
    expect("bulk read", mixed.txRxPacket(), sdk.COMM_SUCCESS)
    expect("what it reads", (mixed.getData(2, 104, 4), mixed.getData(1, 65, 1), mixed.getData(IMU, 0, 2)),
           (50, 1, 18765))
    for _ in range(200):  # until the robot is at rest again, leaning as it may
        data, _, _ = robot.packets.readTxRx(robot.port, IMU, 46, 6)
        felt = math.hypot(*struct.unpack("<hhh", bytes(data)))
        if abs(felt - 981) < 40:
            break
    if not abs(felt - 981) < 40:
        errors.append(f"the IMU feels {felt}, not 981 cm/s^2")
    expect("clear", robot.packets.clearMultiTurn(robot.port, 1), (sdk.COMM_SUCCESS, 0))
    check_fast_reads(robot)
    check_indirect_addresses(robot)
    expect("reboot", robot.packets.reboot(robot.port, 1), (sdk.COMM_SUCCESS, 0))
    expect("while it starts", robot.packets.ping(robot.port, 1)[1], sdk.COMM_RX_TIMEOUT)
    time.sleep(1)
    expect("torque after it", robot.read(1, 64, 1), 0)
    expect("factory reset", robot.packets.factoryReset(robot.port, 3, 0x01), (sdk.COMM_SUCCESS, 0))
    time.sleep(1)
    expect("who was reset, at 1 Mbit/s", robot.packets.ping(robot.port, 3)[1], sdk.COMM_RX_TIMEOUT)
    assert robot.port.setBaudRate(57600)
    expect("who was reset", robot.packets.ping(robot.port, 3), (30, sdk.COMM_SUCCESS, 0))
    expect("who was not", robot.packets.ping(robot.port, 4)[1], sdk.COMM_RX_TIMEOUT)
    assert robot.port.setBaudRate(1000000)


def check_fast_reads(robot):
    fast = sdk.GroupSyncRead(robot.port, robot.packets, 116, 4)
    plain = sdk.GroupSyncRead(robot.port, robot.packets, 116, 4)
    for servo in SERVOS:
        assert fast.addParam(servo) and plain.addParam(servo)
    expect("fast sync read", fast.fastSyncRead(), sdk.COMM_SUCCESS)
    expect("sync read", plain.txRxPacket(), sdk.COMM_SUCCESS)
    for servo in SERVOS:
        expect(f"what they read of {servo}", fast.getData(servo, 116, 4), plain.getData(servo, 116, 4))
    bulk = sdk.GroupBulkRead(robot.port, robot.packets)
    assert bulk.addParam(2, 116, 4) and bulk.addParam(1, 0, 2)
    expect("fast bulk read", bulk.fastBulkRead(), sdk.COMM_SUCCESS)
    expect("what it reads", (bulk.getData(2, 116, 4), bulk.getData(1, 0, 2)), (plain.getData(2, 116, 4), 30))


def check_indirect_addresses(robot):
    for i, address in enumerate((132, 133, 134, 135, 65)):
        expect("indirect address", robot.packets.write2ByteTxRx(robot.port, 5, 168 + 2 * i, address), (sdk.COMM_SUCCESS, 0))
    present = robot.read(5, 132, 4)
    through = robot.read(5, 224, 4)
    if not abs(present - through) <= 30:  # it may move
        errors.append(f"through indirect addresses the position is {through}, not {present}")
    expect("indirect data", robot.packets.write1ByteTxRx(robot.port, 5, 228, 1), (sdk.COMM_SUCCESS, 0))
    expect("LED", robot.read(5, 65, 1), 1)


def check_easy_sdk(robot):
    """The vendor's easy SDK makes motors of all that it finds."""
    try:
        from dynamixel_easy_sdk import Connector
    except ImportError:
        return
    robot.port.closePort()
    connector = Connector(str(robot.link), 1000000)
    expect("motors of the easy SDK", [motor.id for motor in connector.createAllMotors()], SERVOS)
    connector._port_handler.closePort()
    robot.open()


def check_reopening(robot):
    for _ in range(3):
        robot.port.closePort()
        robot.open()
        expect("ping after opening again", robot.packets.ping(robot.port, 5)[1], sdk.COMM_SUCCESS)


def walked(report):
    return next(entity["distance_m"] for entity in json.loads(report.read_text())["entities"] if entity["name"] == "walker")


def check_walk(program, folder):
    """The joint targets of the simulator's own walk, sent over the line, go as far."""
    table, report = Path(folder) / "targets.csv", Path(folder) / "walk.json"
    duration = 4
    subprocess.run([program, "run", "walk", "--duration", str(duration), "--json", str(report), "--no-cameras", "--log",
                    "walker.*.joint_target", "--out", str(table)], check=True, stdout=subprocess.DEVNULL)
    with table.open() as file:
        rows = list(csv.reader(file))
    columns = {name.split(".")[1]: i for i, name in enumerate(rows[0]) if i > 0}  # by the object that the joint moves
    joints = [columns.get(joint, columns.get(joint.removeprefix("j_"))) for joint in joints_of(program)]
    with Robot(program, folder, V2, duration + 1) as robot:
        robot.sync_write(64, 1, {servo: 1 for servo in SERVOS})
        begin = time.monotonic()
        for row in rows[1:]:
            time.sleep(max(0.0, begin + float(row[0]) - time.monotonic()))
            robot.sync_write(116, 4, {servo: round(MIDDLE + PER_RADIAN * float(row[i]))
                                      for servo, i in zip(SERVOS, joints, strict=True)})
            robot.positions()
        robot.process.wait()
        if not walked(robot.report) > 0.5 * walked(report):
            errors.append(f"it walks {walked(robot.report)} m over the line, {walked(report)} m without")
        print(f"walked {walked(robot.report):.2f} m over the line, {walked(report):.2f} m without")


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        for bus, own in ((V1, check_protocol_1), (V2, check_protocol_2)):
            with Robot(program, folder, bus) as robot:
                check_bus(robot)
                check_reopening(robot)
                if bus is V2:
                    check_easy_sdk(robot)
                own(robot)
        (Path(folder) / "x.csv").write_text(
            "joint,id,servo\n" + "".join(f"{joint},{i + 1},xm430_w350\n" for i, joint in enumerate(joints_of(program))))
        with Robot(program, folder, X, **{"options.bus": f"{folder}/x.csv"}) as robot:
            check_bus(robot)
        check_walk(program, folder)
    end()


def joints_of(program):
    """In the order of the ids."""
    report = subprocess.run([program, "check", "kid21"], check=True, stdout=subprocess.PIPE, text=True)
    bodies = report.stdout.partition("limb behind")[0]
    return re.findall(r"\bj_\w+", bodies)


if __name__ == "__main__":
    main()
