#!/usr/bin/env python3
"""The vendor's unchanged SDK against a simulated Booster K1.

Usage: booster_sdk.py MUROSIMF [--short]

A program with the SDK has the robot walk and turn by Move, moves its joints by low-level commands, and has it get up after
a fall; what it reads is compared with the simulator's own log. Commands of a wrong size, and a program that is killed, do
not end the run. Nothing listens beside 127.0.0.1. All of it takes four minutes of real time; --short asks, moves an arm and
compares with the log, in a few seconds.
Needs booster-robotics-sdk-python in this Python; without it, or in a build without DDS, it is skipped (exit code 77).
"""

import csv
import json
import math
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from xml.etree import ElementTree

try:
    import booster_robotics_sdk_python as sdk
except ImportError as missing:
    print(f"skipped: {missing}; pip install booster-robotics-sdk-python")
    sys.exit(77)

from errors import end, errors
from socket_places import hex_address, socket_places

DOMAIN = 87
MODEL = Path(__file__).resolve().parents[2] / "models" / "booster_k1.xml"
DISCOVERY = "239.255.0.1"
ARM, LEG = ("Shoulder_Pitch", "Shoulder_Roll", "Elbow_Pitch", "Elbow_Yaw"), (
    "Hip_Pitch", "Hip_Roll", "Hip_Yaw", "Knee_Pitch", "Ankle_Pitch", "Ankle_Roll")
# as the model names them, in the order of the SDK's JointIndexK1
SIDES = ("Left", "Right")
JOINT_NAMES = ["AAHead_yaw", "Head_pitch"] + [f"{side}_{joint}" for limb in (ARM, LEG) for side in SIDES for joint in limb]
JOINT_NAMES = ["A" + name if name.endswith("Shoulder_Pitch") else name for name in JOINT_NAMES]
JOINTS = len(JOINT_NAMES)


def expect(what, good, got):
    print(("ok      " if good else "FAILED  ") + what, got)
    if not good:
        errors.append(f"{what}: {got}")


class Robot:
    """A running simulation of scene `booster`."""

    def __init__(self, program, folder, duration, *more):
        self.log, self.report = Path(folder) / "log.csv", Path(folder) / "report.json"
        logged = ["k1.*.joint_position", "k1.*.odometry"]
        command = [program, "run", "booster", "--booster", str(DOMAIN), "--speed", "1", "--duration", str(duration),
                   "--no-cameras", "--json", str(self.report), "--out", str(self.log), "--log-rate", "500", *more]
        for name in logged:
            command += ["--log", name]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL)

    def end(self):
        code = self.process.wait(120)
        expect("exit code of the run", code == 0, code)
        return json.loads(self.report.read_text()) if self.report.exists() else {}


class Program:
    """What a program sees with the SDK."""

    def __init__(self):
        sdk.ChannelFactory.Instance().Init(DOMAIN, "127.0.0.1")
        self.joints, self.imu, self.stamps, self.odometer, self.fall, self.states, self.battery = [], [], [], [], [], [], []
        self.subscribers = [
            sdk.B1LowStateSubscriber(self.on_low_state),
            sdk.B1OdometerStateSubscriber(lambda m: self.odometer.append((m.x, m.y, m.theta))),
            sdk.B1FallDownStateSubscriber(lambda m: self.fall.append((m.fall_down_state, m.is_recovery_available))),
            sdk.B1RobotStatesSubscriber(lambda m: self.states.append((m.current_mode, m.current_body_control))),
            sdk.B1BatteryStateSubscriber(lambda m: self.battery.append(m.soc)),
        ]
        for subscriber in self.subscribers:
            subscriber.InitChannel()
        self.commands = sdk.B1LowCmdPublisher()
        self.commands.InitChannel()
        self.loco = sdk.B1LocoClient()
        self.loco.Init()

    def on_low_state(self, message):  # it is valid only in here
        self.stamps.append(time.monotonic())
        self.joints.append([motor.q for motor in message.motor_state_serial])
        self.imu.append((list(message.imu_state.rpy), list(message.imu_state.acc)))
        self.parallel = len(message.motor_state_parallel)

    def call(self, name, *arguments, code=0):
        """Calls the service; `code`: expected, 0 is success."""
        begin = time.monotonic()
        result, got = None, 0
        try:
            result = getattr(self.loco, name)(*arguments)
        except RuntimeError as error:
            got = int(str(error).rpartition("=")[2])
        expect(f"{name}{arguments}", got == code, f"code {got} in {1e3 * (time.monotonic() - begin):.2f} ms")
        return result

    def write(self, targets, weight=1.0):
        """With the gains of the model's file."""
        legs = [(350, 7.5), (350, 7.5), (180, 3), (350, 5.5), (250, 5), (250, 5)]
        arms = [(40, 0.5), (50, 1.5), (20, 0.2), (20, 0.2)]
        gains = [(40, 1.5)] * 2 + arms * 2 + legs * 2
        command = sdk.LowCmd()
        command.cmd_type = sdk.LowCmdType.SERIAL
        motors = []
        for q, (kp, kd) in zip(targets, gains, strict=False):  # a command may be too short
            motor = sdk.MotorCmd()
            motor.mode, motor.q, motor.dq, motor.tau, motor.kp, motor.kd, motor.weight = 0, q, 0.0, 0.0, kp, kd, weight
            motors.append(motor)
        command.motor_cmd = motors
        self.commands.Write(command)

    def wait_for_state(self):
        begin = time.monotonic()
        while not (self.joints and self.battery) and time.monotonic() - begin < 10:
            time.sleep(0.001)
        expect("states come", bool(self.joints), f"after {time.monotonic() - begin:.3f} s")
        if not self.joints:
            end()


def median(values):
    return sorted(values)[len(values) // 2] if values else math.nan


def check_sockets(process):
    """All sockets are on 127.0.0.1, or hear the group of DDS's discovery, which only the loopback interface has joined."""
    found = {place.rpartition(":")[0] for place in socket_places(process)}
    expect("sockets", bool(found) and found <= {"127.0.0.1", DISCOVERY}, sorted(found))
    interface, joined = "", set()
    for line in Path(f"/proc/{process}/net/igmp").read_text().splitlines()[1:]:
        fields = line.split()
        if fields[0].isdigit():
            interface = fields[1]
        elif hex_address(fields[0]) == DISCOVERY:
            joined.add(interface)
    expect("interfaces that hear DDS's discovery", joined <= {"lo"}, sorted(joined))


def check_questions(program):
    mode = program.call("GetMode")
    expect("mode at the start", mode and mode.mode == sdk.RobotMode.kPrepare, mode and mode.mode)
    status = program.call("GetStatus")
    expect("its body control", status and status.current_body_control == sdk.BodyControl.kPrepare,
           status and status.current_body_control)
    info = program.call("GetRobotInfo")
    expect("its model", info and info.model == "K1", info and info.model)
    program.call("Move", 0.3, 0.0, 0.0, code=409)
    program.call("Dance", sdk.DanceId.kNewYear, code=501)
    program.call("GetUp", code=409)
    frame = program.call("GetFrameTransform", sdk.Frame.kBody, sdk.Frame.kLeftFoot)
    expect("its left foot", frame and frame.position.z < -0.3 and frame.position.y > 0.02, frame and frame.to_json_str())


def heading_and_way(program, seconds):
    before = program.odometer[-1]
    time.sleep(seconds)
    after = program.odometer[-1]
    return math.hypot(after[0] - before[0], after[1] - before[1]), math.remainder(after[2] - before[2], 2 * math.pi)


def check_walk(program):
    program.call("ChangeMode", sdk.RobotMode.kWalking)
    program.call("ResetOdometry")
    time.sleep(0.2)
    expect("odometry after the reset", math.hypot(*program.odometer[-1][:2]) < 0.02, program.odometer[-1])
    program.call("Move", 0.15, 0.0, 0.0)
    begin = time.monotonic()
    while time.monotonic() - begin < 40 and program.odometer[-1][0] < 2:  # it keeps its course by its odometry
        _, y, heading = program.odometer[-1]
        program.loco.Move(0.15, 0.0, max(-0.5, min(0.5, -heading - 0.5 * y)))
        time.sleep(0.1)
    expect("walks 2 m forward", program.odometer[-1][0] >= 2, f"in {time.monotonic() - begin:.1f} s: {program.odometer[-1]}")
    program.call("Move", 0.0, 0.0, 0.5)
    _, turn = heading_and_way(program, 4)
    expect("turns", turn > 1, f"{turn:.2f} rad in 4 s")
    program.call("Move", 0.0, 0.0, 0.0)
    program.call("RotateHead", 0.3, -0.4)
    time.sleep(2)
    expect("turns its head", math.dist(program.joints[-1][:2], (-0.4, 0.3)) < 0.05, program.joints[-1][:2])
    trips = []
    for _ in range(200):
        begin = time.monotonic()
        program.loco.Move(0.0, 0.0, 0.0)
        trips.append(time.monotonic() - begin)
        time.sleep(0.003)
    print(f"Move, 200 calls: median {1e3 * median(trips):.2f} ms, worst {1e3 * max(trips):.2f} ms")
    expect("stands", program.fall[-1][0] == sdk.FallDownStateType.IS_READY, program.fall[-1])


def check_low_level(program):
    """Stands in custom mode, with the gains of the vendor's file for legs, and moves its arms."""
    program.call("ChangeMode", sdk.RobotMode.kPrepare)
    time.sleep(1.5)
    stance = list(program.joints[-1])
    program.call("ChangeMode", sdk.RobotMode.kCustom)
    program.call("GetMode")
    trips = []
    for i in range(200):
        targets = list(stance)
        targets[4] = targets[8] = stance[4] + 0.4 * math.sin(0.03 * i)
        count, begin = len(program.stamps), time.monotonic()
        program.write(targets)
        while len(program.stamps) <= count and time.monotonic() - begin < 0.2:
            time.sleep(0.0001)
        trips.append(time.monotonic() - begin)
        time.sleep(0.008)
    print(f"command to next state, 200: median {1e3 * median(trips):.2f} ms")
    expect("the elbow follows", abs(program.joints[-1][4] - targets[4]) < 0.1, (program.joints[-1][4], targets[4]))
    for _ in range(60 * 50):
        program.write(stance)
        time.sleep(0.02)
    expect("stands in custom mode for a minute", program.fall[-1][0] == sdk.FallDownStateType.IS_READY, program.fall[-1])
    program.write([0.0] * 5)  # a command for another robot
    time.sleep(0.2)
    expect("its sequences are full", len(program.joints[-1]) == program.parallel == JOINTS, len(program.joints[-1]))


def check_other_calls(program):
    """In soccer mode: head, odometry, arms of the program's own, kick, lying down."""
    program.call("ChangeMode", sdk.RobotMode.kSoccer)
    time.sleep(1)
    program.call("RotateHeadWithTime", 0.2, 0.4, 300)
    program.call("ResetOdometryTo", 1.0, 2.0, 0.5)
    time.sleep(0.5)
    expect("its head", math.dist(program.joints[-1][:2], (0.4, 0.2)) < 0.05, program.joints[-1][:2])
    expect("its odometry", math.dist(program.odometer[-1], (1, 2, 0.5)) < 0.02, program.odometer[-1])
    program.call("MoveCommand", 0.1, 0.0, 0.0)
    time.sleep(2)
    program.call("Move", 0.0, 0.0, 0.0)
    expect("it walks to where it looks", program.odometer[-1][0] > 1.05 and program.odometer[-1][1] > 2.02, program.odometer[-1])
    program.call("UpperBodyCustomControl", True)
    targets = list(program.joints[-1])
    targets[4] += 0.5
    for _ in range(100):
        program.write(targets)
        time.sleep(0.01)
    expect("its elbow", abs(program.joints[-1][4] - targets[4]) < 0.05, (program.joints[-1][4], targets[4]))
    program.call("UpperBodyCustomControl", False)
    program.call("Shoot")
    time.sleep(5)
    expect("stands after a kick", program.fall[-1][0] == sdk.FallDownStateType.IS_READY, program.fall[-1])
    program.call("VisualKick", False)
    program.call("WaveHand", sdk.HandAction.kHandOpen)
    time.sleep(1.5)
    expect("raises its right arm", program.joints[-1][7] < 0.4, program.joints[-1][7])
    time.sleep(3)
    program.call("SwitchGait", sdk.GaitType.kHalfBodyHumanlikeGait, code=501)
    program.call("LieDown")
    time.sleep(5)
    expect("lies", program.fall[-1][0] == sdk.FallDownStateType.HAS_FALLEN, program.fall[-1])
    program.call("Move", 0.1, 0.0, 0.0, code=409)
    program.call("GetUpWithMode", sdk.RobotMode.kSoccer)
    begin = time.monotonic()
    while time.monotonic() - begin < 15 and program.fall[-1][0] != sdk.FallDownStateType.IS_READY:
        time.sleep(0.05)
    expect("got up", program.fall[-1][0] == sdk.FallDownStateType.IS_READY, f"{time.monotonic() - begin:.1f} s")
    time.sleep(0.5)
    expect("is in soccer mode", program.states[-1] == (4, 5), program.states[-1])


def check_fall(program):
    program.call("ChangeMode", sdk.RobotMode.kDamping)
    time.sleep(4)
    expect("falls when it is limp", program.fall[-1] == (sdk.FallDownStateType.HAS_FALLEN, True), program.fall[-1])
    program.call("GetUp")
    begin = time.monotonic()
    while time.monotonic() - begin < 15 and program.fall[-1][0] != sdk.FallDownStateType.IS_READY:
        time.sleep(0.05)
    expect("gets up", program.fall[-1][0] == sdk.FallDownStateType.IS_READY, f"{time.monotonic() - begin:.1f} s")
    time.sleep(1)
    expect("walks then", program.states[-1] == (2, 3), program.states[-1])


def short_program():
    program = Program()
    program.wait_for_state()
    time.sleep(1)
    check_questions(program)
    program.call("ChangeMode", sdk.RobotMode.kCustom)
    targets = list(program.joints[-1])
    targets[4] += 0.3
    for _ in range(50):
        program.write(targets)
        time.sleep(0.02)
    expect("the elbow follows", abs(program.joints[-1][4] - targets[4]) < 0.05, (program.joints[-1][4], targets[4]))
    return program


def main_program():
    program = Program()
    program.wait_for_state()
    time.sleep(1)
    count, begin = len(program.stamps), time.monotonic()
    check_questions(program)
    check_walk(program)
    rate = (len(program.stamps) - count) / (time.monotonic() - begin)
    print(f"LowState at {rate:.1f} Hz")
    check_low_level(program)
    check_other_calls(program)
    check_fall(program)
    return program


def check_log(robot, program):
    """Every position that was sent is a row of the simulator's own log."""
    with robot.log.open() as file:
        names, *rows = list(csv.reader(file))
    place = {name.split(".")[1]: i for i, name in enumerate(names) if ".joint_position" in name}
    # the log names a joint by the body that it moves
    model = ElementTree.parse(MODEL)
    bodies = {joint.get("name"): body.get("name") for body in model.iter("body") for joint in body.findall("joint")}
    columns = [place[bodies[joint]] if bodies[joint] in place else place[joint] for joint in JOINT_NAMES]
    log = [[float(row[i]) for i in columns] for row in rows]
    expect("joints in the log", len(columns) == JOINTS, len(columns))
    worst = 0.0
    for joints in program.joints[500:-500:997]:
        worst = max(worst, min(max(abs(a - b) for a, b in zip(joints, row, strict=True)) for row in log))
    expect("positions are those of the log", worst < 2e-6, worst)


def write_for_ever():
    """A program that is killed while it commands the robot."""
    program = Program()
    program.wait_for_state()
    program.loco.ChangeMode(sdk.RobotMode.kCustom)
    stance = list(program.joints[-1])
    print("commands", flush=True)
    while True:
        program.write(stance)
        time.sleep(0.002)


def check_kill(program, folder):
    robot = Robot(program, folder, 8)
    child = subprocess.Popen([sys.executable, __file__, program, "--write"], stdout=subprocess.PIPE, text=True)
    while "commands" not in child.stdout.readline():
        if child.poll() is not None:
            break
    time.sleep(1)
    child.send_signal(signal.SIGKILL)
    child.wait()
    report = robot.end()
    said = [line["text"] for line in report["control"][0]["said"]]
    print(said)
    expect("its first line", said[:1] == ["a program with the robot's SDK has come"], said[:1])


def main():
    program = sys.argv[1]
    if "--write" in sys.argv:
        write_for_ever()
    short = "--short" in sys.argv
    with tempfile.TemporaryDirectory() as folder:
        robot = Robot(program, folder, 8 if short else 190)
        seen = short_program() if short else main_program()
        check_sockets(robot.process.pid)
        robot.end()
        check_log(robot, seen)
        if not short:
            check_kill(program, folder)
    end()


if __name__ == "__main__":
    main()
