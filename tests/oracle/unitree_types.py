"""Messages of Unitree's humanoids as types of Cyclone DDS, and their checksum, written down anew: not by the code that they test.

Source: unitree_sdk2py/idl/unitree_hg, unitree_sdk2py/idl/unitree_api and unitree_sdk2py/utils/crc.py, version 1.0.1.
"""

import struct
from dataclasses import dataclass, field

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import autoid, final
from cyclonedds.idl.types import array, float32, int16, int32, int64, sequence, uint8, uint32

MOTORS = 35


def zeros(count):
    return field(default_factory=lambda: [0] * count)


def several(kind):
    return field(default_factory=lambda: [kind() for _ in range(MOTORS)])


@dataclass
@final
@autoid("sequential")
class Imu(IdlStruct, typename="unitree_hg.msg.dds_.IMUState_"):
    quaternion: array[float32, 4] = zeros(4)
    gyroscope: array[float32, 3] = zeros(3)
    accelerometer: array[float32, 3] = zeros(3)
    rpy: array[float32, 3] = zeros(3)
    temperature: int16 = 0


@dataclass
@final
@autoid("sequential")
class MotorState(IdlStruct, typename="unitree_hg.msg.dds_.MotorState_"):
    mode: uint8 = 0
    q: float32 = 0
    dq: float32 = 0
    ddq: float32 = 0
    tau_est: float32 = 0
    temperature: array[int16, 2] = zeros(2)
    vol: float32 = 0
    sensor: array[uint32, 2] = zeros(2)
    motorstate: uint32 = 0
    reserve: array[uint32, 4] = zeros(4)


@dataclass
@final
@autoid("sequential")
class LowState(IdlStruct, typename="unitree_hg.msg.dds_.LowState_"):
    version: array[uint32, 2] = zeros(2)
    mode_pr: uint8 = 0
    mode_machine: uint8 = 0
    tick: uint32 = 0
    imu_state: Imu = field(default_factory=Imu)
    motor_state: array[MotorState, MOTORS] = several(MotorState)
    wireless_remote: array[uint8, 40] = zeros(40)
    reserve: array[uint32, 4] = zeros(4)
    crc: uint32 = 0


@dataclass
@final
@autoid("sequential")
class MotorCommand(IdlStruct, typename="unitree_hg.msg.dds_.MotorCmd_"):
    mode: uint8 = 0
    q: float32 = 0
    dq: float32 = 0
    tau: float32 = 0
    kp: float32 = 0
    kd: float32 = 0
    reserve: uint32 = 0


@dataclass
@final
@autoid("sequential")
class LowCommand(IdlStruct, typename="unitree_hg.msg.dds_.LowCmd_"):
    mode_pr: uint8 = 0
    mode_machine: uint8 = 0
    motor_cmd: array[MotorCommand, MOTORS] = several(MotorCommand)
    reserve: array[uint32, 4] = zeros(4)
    crc: uint32 = 0


@dataclass
@final
@autoid("sequential")
class Identity(IdlStruct, typename="unitree_api.msg.dds_.RequestIdentity_"):
    id: int64 = 0
    api_id: int64 = 0


@dataclass
@final
@autoid("sequential")
class Lease(IdlStruct, typename="unitree_api.msg.dds_.RequestLease_"):
    id: int64 = 0


@dataclass
@final
@autoid("sequential")
class Policy(IdlStruct, typename="unitree_api.msg.dds_.RequestPolicy_"):
    priority: int32 = 0
    noreply: bool = False


@dataclass
@final
@autoid("sequential")
class RequestHeader(IdlStruct, typename="unitree_api.msg.dds_.RequestHeader_"):
    identity: Identity = field(default_factory=Identity)
    lease: Lease = field(default_factory=Lease)
    policy: Policy = field(default_factory=Policy)


@dataclass
@final
@autoid("sequential")
class Request(IdlStruct, typename="unitree_api.msg.dds_.Request_"):
    header: RequestHeader = field(default_factory=RequestHeader)
    parameter: str = "{}"
    binary: sequence[uint8] = field(default_factory=list)


@dataclass
@final
@autoid("sequential")
class Status(IdlStruct, typename="unitree_api.msg.dds_.ResponseStatus_"):
    code: int32 = 0


@dataclass
@final
@autoid("sequential")
class ResponseHeader(IdlStruct, typename="unitree_api.msg.dds_.ResponseHeader_"):
    identity: Identity = field(default_factory=Identity)
    status: Status = field(default_factory=Status)


@dataclass
@final
@autoid("sequential")
class Response(IdlStruct, typename="unitree_api.msg.dds_.Response_"):
    header: ResponseHeader = field(default_factory=ResponseHeader)
    data: str = ""
    binary: sequence[uint8] = field(default_factory=list)


def make_table():
    table = []
    for byte in range(256):
        rest = byte << 24
        for _ in range(8):
            rest = (rest << 1 ^ 0x04C11DB7 if rest >> 31 else rest << 1) & 0xFFFFFFFF
        table.append(rest)
    return table


TABLE = make_table()


def crc32(packed):
    """CRC-32/MPEG-2 of words, the highest byte first, without the last one."""
    rest = 0xFFFFFFFF
    for at in range(0, len(packed) - 4, 4):
        for byte in packed[at:at + 4][::-1]:
            rest = (rest << 8) & 0xFFFFFFFF ^ TABLE[rest >> 24 ^ byte]
    return rest


def crc_of_command(command):
    values = [command.mode_pr, command.mode_machine]
    for motor in command.motor_cmd:
        values += [motor.mode, motor.q, motor.dq, motor.tau, motor.kp, motor.kd, motor.reserve]
    return crc32(struct.pack("<2B2x" + "B3x5fI" * MOTORS + "5I", *values, *command.reserve, 0))


def crc_of_state(state):
    imu = state.imu_state
    values = [*state.version, state.mode_pr, state.mode_machine, state.tick, *imu.quaternion, *imu.gyroscope,
              *imu.accelerometer, *imu.rpy, imu.temperature]
    for motor in state.motor_state:
        values += [motor.mode, motor.q, motor.dq, motor.ddq, motor.tau_est, *motor.temperature, motor.vol, *motor.sensor,
                   motor.motorstate, *motor.reserve]
    return crc32(struct.pack("<2I2B2xI13fh2x" + "B3x4f2hf7I" * MOTORS + "40B5I", *values, *state.wireless_remote,
                             *state.reserve, 0))
