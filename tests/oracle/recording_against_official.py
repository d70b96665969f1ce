#!/usr/bin/env python3
"""Reads a recording with the official packages for MCAP and Protocol Buffers, and compares it with the log of the same run.

Usage: recording_against_official.py <murosimf>
Exit: 0 all agree, 1 something differs, 77 a package is not installed (test is skipped).

The types of messages are compared, field by field, with those that Foxglove's own package has. Poses are put together from
the transforms of links as viewers do it, and compared with the log's, as are joints and samples of sensors.
"""
import csv
import importlib
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import foxglove_schemas_protobuf.FrameTransforms_pb2  # noqa: F401
    import numpy as np
    from google.protobuf import descriptor_pb2
    from mcap.reader import make_reader
    from mcap_protobuf.decoder import DecoderFactory
except ImportError as missing:
    print(f"skipped: {missing}; pip install mcap mcap-protobuf-support foxglove-schemas-protobuf")
    sys.exit(77)

from errors import check, end

# Half a step of what is recorded, and for poses of what adds up along a leg of 0.5 m with seven joints.
JOINT, VELOCITY, LEG = 2.0**-15, 2.0**-6, 2.5e-4


def record(program, folder, scene, log, *words):
    """The recording of a run, its log as {name: {time: value}}, and the report."""
    file, table = folder / "run.mcap", folder / "run.csv"
    command = [program, "run", scene, "--record", file, "--out", table, "--json", "-", *words]
    for name in log:
        command += ["--log", name]
    report = json.loads(subprocess.run(command, capture_output=True, check=True, text=True).stdout)
    with open(table, encoding="utf-8") as rows:
        lines = list(csv.reader(rows))
    series = {name.split(" [")[0]: {} for name in lines[0][1:]}
    for line in lines[1:]:
        for name, value in zip(series, line[1:], strict=True):
            if value:
                series[name][round(float(line[0]) * 1e9)] = float(value)
    return file, series, report


def fields(message):
    """What tells two types of messages apart."""
    names = lambda e: [(v.name, v.number) for v in e.value]  # noqa: E731
    return ([(f.name, f.number, f.type, f.label, f.type_name, f.proto3_optional) for f in message.field],
            [(e.name, names(e)) for e in message.enum_type])


def check_schemas(summary, wanted=frozenset({"FrameTransform", "SceneEntity", "JointState", "Log"})):
    """Compares every type of Foxglove's with that of its own package."""
    seen = set()
    for schema in summary.schemas.values():
        check(schema.encoding == "protobuf", f"{schema.name}: encoding")
        files = descriptor_pb2.FileDescriptorSet.FromString(schema.data)
        known = set()
        for file in files.file:
            check(known.issuperset(file.dependency), f"{file.name} comes before what it needs")
            known.add(file.name)
            for message in file.message_type:
                if file.package != "foxglove":
                    continue
                seen.add(message.name)
                official = descriptor_pb2.DescriptorProto()
                module = importlib.import_module(f"foxglove_schemas_protobuf.{message.name}_pb2")
                module.DESCRIPTOR.message_types_by_name[message.name].CopyToProto(official)
                check(fields(message) == fields(official), f"{message.name} is not Foxglove's")
    check(wanted <= seen, f"few types: {seen}")


def rotation(q):
    """Of a quaternion, as a matrix."""
    w, x, y, z = np.array([q.w, q.x, q.y, q.z]) / math.hypot(q.w, q.x, q.y, q.z)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def positions(message):
    """In the world, by frame."""
    poses = {"world": (np.zeros(3), np.eye(3))}
    for t in message.transforms:
        r, turn = poses[t.parent_frame_id]
        shift = np.array([t.translation.x, t.translation.y, t.translation.z])
        poses[t.child_frame_id] = (r + turn @ shift, turn @ rotation(t.rotation))
    return {name: r for name, (r, _) in poses.items()}


def compare(file, series, robot, frame, sensor):
    """Messages with what the log says; how many numbers that were, by topic."""
    counts = {}

    def number(topic, time, name, value, tolerance):
        wanted = series[name].get(time)
        if wanted is None:
            return
        counts[topic] = counts.get(topic, 0) + 1
        check(abs(value - wanted) <= tolerance, f"{name} at {time / 1e9} s: {value}, not {wanted}")

    with open(file, "rb") as stream:
        for _, channel, message, decoded in make_reader(stream, decoder_factories=[DecoderFactory()]).iter_decoded_messages():
            time = message.log_time
            if channel.topic == "/tf":
                at = positions(decoded)[f"{robot}/{frame}"]
                for axis, value in zip("xyz", at, strict=True):
                    number("/tf", time, f"{robot}.{frame}.position.{axis}", value, LEG)
            elif channel.topic == "/joints":
                for joint in decoded.joints:
                    name = joint.name.split("/")[1]
                    if f"{robot}.{name}.joint_position" in series:
                        number("/joints", time, f"{robot}.{name}.joint_position", joint.position, JOINT)
                        number("/joints", time, f"{robot}.{name}.joint_velocity", joint.velocity, VELOCITY)
            elif channel.topic == f"/sensors/{robot}/{sensor}":
                taken = decoded.timestamp.seconds * 10**9 + decoded.timestamp.nanos
                for axis in "xyz":
                    number(channel.topic, taken, f"{robot}.{sensor}.gyroscope.{axis}",
                           getattr(decoded, f"gyroscope_{axis}"), 0)
    return counts


def main():
    with tempfile.TemporaryDirectory() as name:
        log = ["robot.j_l_foot.position", "robot.j_l_shin.joint_position", "robot.j_l_shin.joint_velocity", "robot.imu"]
        what = "poses,scene,joints,contacts,sensors,events,hashes"
        file, series, report = record(sys.argv[1], Path(name), "nudge", log, "--duration", "2", "--record-what", what)
        with open(file, "rb") as stream:
            reader = make_reader(stream, validate_crcs=True)
            summary = reader.get_summary()
            attached = {a.name: a.data for a in reader.iter_attachments()}
            metadata = {m.name: m.metadata for m in reader.iter_metadata()}
        check_schemas(summary)
        counts = compare(file, series, "robot", "j_l_foot", "imu")
        print(counts)
        check(counts.get("/tf", 0) >= 3 * 199 and counts.get("/joints", 0) >= 2 * 199, f"few numbers: {counts}")
        check(counts.get("/sensors/robot/imu", 0) >= 3 * 300, f"few samples: {counts}")
        check(json.loads(attached["report.json"])["state_hash"] == report["state_hash"], "another report")
        check("--record-what" in metadata["murosimf"]["command_line"], "no command line")
        check(any(path.endswith("nudge.toml") for path in metadata["files"]), f"no scene in {metadata['files']}")
        topics = {c.topic: summary.statistics.channel_message_counts.get(i, 0) for i, c in summary.channels.items()}
        check(topics["/tf"] == 201 and topics["/state_hash"] == 3 and topics["/scene"] >= 1, f"counts: {topics}")
    end()


if __name__ == "__main__":
    main()
