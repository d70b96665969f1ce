#!/usr/bin/env python3
"""Reads bags of `murosimf export --rosbag2` with the package rosbags, and compares them with the recording.

Usage: bags_with_rosbags.py <murosimf>
Exit: 0 all agree, 1 something differs, 77 a package is not installed (test is skipped).

Every message is decoded and encoded again: the bytes must be the same, with the types of Humble and of Jazzy as rosbags has them.
The definitions in the file must be these, too. Joints and sensors are compared with `murosimf export --csv`, the rest with the
recording.
"""
import csv
import subprocess
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

try:
    import numpy as np
    from mcap.reader import make_reader
    from mcap_protobuf.decoder import DecoderFactory
    from rosbags.rosbag2 import Reader
    from rosbags.typesys import Stores, get_types_from_msg, get_typestore
except ImportError as missing:
    print(f"skipped: {missing}; pip install rosbags mcap mcap-protobuf-support foxglove-schemas-protobuf")
    sys.exit(77)

from errors import check, end

ROUNDED = 2**-14  # of the numbers in a recording (docs/recording.md)
WHAT = "poses,scene,joints,contacts,sensors,pictures,drawings,events"
# the camera draws depths and labels; an event: the level changes
SCENE = ["nudge", "--duration", "1", "--at", "0.5:robot.level=full_dynamics",
         "--set", "robot.sensors.camera.depth=true", "--set", "robot.sensors.camera.labels=true"]


def read(bag, store):
    """Messages by topic, as (time [ns], message), decoded and encoded again."""
    types, topics = get_typestore(store), {}
    with Reader(bag) as reader:
        counted = {connection.topic: connection.msgcount for connection in reader.connections}
        for connection, time, raw in reader.messages():
            message = types.deserialize_cdr(raw, connection.msgtype)
            same = bytes(types.serialize_cdr(message, connection.msgtype)) == bytes(raw)
            check(same, f"{connection.topic} at {time}: other bytes when encoded again ({store.name})")
            topics.setdefault(connection.topic, []).append((time, message))
    check(counted == {topic: len(all_of) for topic, all_of in topics.items()}, f"metadata.yaml counts {counted}")
    return topics


def compare_definitions(bag, store):
    """Of the schemas in the file with those of rosbags."""
    types = get_typestore(store)
    with open(next(bag.glob("*.mcap")), "rb") as stream:
        summary = make_reader(stream).get_summary()
    for schema in summary.schemas.values():
        check(schema.encoding == "ros2msg", f"{schema.name}: {schema.encoding}")
        for name, (_, fields) in get_types_from_msg(schema.data.decode(), schema.name).items():
            check(fields == types.fielddefs[name][1], f"{name} has {fields}")
    return len(summary.schemas)


def table(program, recording, pattern):
    """Of `murosimf export`: times [ns] and columns by their names without unit."""
    out = recording.parent / "numbers.csv"
    subprocess.run([program, "export", recording, pattern, "--csv", out], check=True, capture_output=True)
    rows = list(csv.reader(out.open(encoding="utf-8")))
    names = [name.partition(" [")[0] for name in rows[0]]
    values = [[float(cell) if cell else np.nan for cell in row] for row in rows[1:]]
    return [round(1e9 * row[0]) for row in values], {name: [row[i] for row in values] for i, name in enumerate(names)}


def compare_joints(program, recording, topics):
    for topic, column, tolerance in [("joint_states", "joint_position", ROUNDED), ("joint_targets", "joint_target", ROUNDED)]:
        times, columns = table(program, recording, f"robot.*.{column}")
        messages = topics[f"/robot/{topic}"]
        check([time for time, _ in messages] == times, f"{topic}: other times")
        for k, (_, message) in enumerate(messages):
            for name, value in zip(message.name, message.position, strict=True):
                wanted = columns[f"robot.{name}.{column}"][k]
                check(abs(value - wanted) <= tolerance, f"{topic} {name}: {value}, recorded {wanted}")
            check(len(message.velocity) == (len(message.name) if topic == "joint_states" else 0), f"{topic}: velocities")
    return len(messages), len(message.name)


def compare_sensors(program, recording, topics):
    times, columns = table(program, recording, "robot.imu")
    stamps = [message.header.stamp.sec * 10**9 + message.header.stamp.nanosec for _, message in topics["/robot/imu"]]
    check(stamps == times, f"imu: {stamps[:3]} and {times[:3]}")
    for k, (_, message) in enumerate(topics["/robot/imu"]):
        for axis in "xyz":
            for vector, output in [(message.angular_velocity, "gyroscope"), (message.linear_acceleration, "accelerometer")]:
                check(getattr(vector, axis) == columns[f"robot.imu.{output}.{axis}"][k], f"{output} {axis} {k}")
        turn = [getattr(message.orientation, axis) for axis in "wxyz"]
        check(turn == [columns[f"robot.imu.orientation.{axis}"][k] for axis in "wxyz"], f"orientation {k}: {turn}")
        check(message.orientation_covariance[0] == 0, "an orientation that is measured")
    times, columns = table(program, recording, "robot.left_foot")
    for k, (_, message) in enumerate(topics["/robot/left_foot"]):
        labels = [dim.label.partition(" [")[0] for dim in message.layout.dim]
        for label, value in zip(labels, message.data, strict=True):
            check(value == columns[f"robot.left_foot.{label}"][k], f"left_foot {label} {k}: {value}")
    return len(stamps)


def frames_of_links(topics):
    """New names by those of the recording, which are the joints'."""
    urdf = ElementTree.fromstring(topics["/robot/robot_description"][0][1].data)
    return {f"robot/{joint.get('name')}": f"robot/{joint.find('child').get('link')}" for joint in urdf.iter("joint")}


def compare_recorded(recording, topics):
    """Poses, pictures, calibrations and lines with the messages of the recording."""
    seen = {"/tf": 0, "/cameras/robot/camera/image": 0, "/events": 0}
    places = {(time, one.child_frame_id): one for time, message in topics["/tf"] for one in message.transforms}
    pictures = {time: message for time, message in topics["/robot/camera/image/compressed"]}
    names = frames_of_links(topics)
    with open(recording, "rb") as stream:
        for _, channel, message, decoded in make_reader(stream, decoder_factories=[DecoderFactory()]).iter_decoded_messages():
            time = message.log_time
            if channel.topic in ("/tf", "/cameras/tf"):
                for one in decoded.transforms:
                    told = places[time, names.get(one.child_frame_id, one.child_frame_id)]
                    check(told.header.frame_id == names.get(one.parent_frame_id, one.parent_frame_id),
                          f"{one.child_frame_id} hangs on {told.header.frame_id}")
                    move, turn = told.transform.translation, told.transform.rotation
                    far = max(abs(getattr(move, axis) - getattr(one.translation, axis)) for axis in "xyz")
                    check(far == 0, f"{one.child_frame_id} is {far} m elsewhere")
                    wanted = np.array([one.rotation.x, one.rotation.y, one.rotation.z, one.rotation.w])
                    wanted /= np.linalg.norm(wanted)
                    cosine = abs(np.dot(wanted, [turn.x, turn.y, turn.z, turn.w]))
                    check(cosine > 1 - 1e-9, f"{one.child_frame_id} is turned: {cosine}")
                    seen["/tf"] += 1
            elif channel.topic == "/cameras/robot/camera/image":
                check(bytes(pictures[time].data) == decoded.data and pictures[time].format == "png", "another picture")
                seen[channel.topic] += 1
            elif channel.topic == "/events":
                check(any(decoded.message == line.msg and line.level == 20 for _, line in topics["/rosout"]), decoded.message)
                seen[channel.topic] += 1
    check(seen["/tf"] > 1000 and seen["/cameras/robot/camera/image"] > 5 and seen["/events"] > 0, f"{seen}")
    for topic in ("depth", "labels"):
        image = topics[f"/robot/camera/{topic}"][0][1]
        check(image.encoding == "16UC1" and len(image.data) == 2 * image.width * image.height, f"{topic}: {image.encoding}")
    info = topics["/robot/camera/camera_info"][0][1]
    check(info.k[0] > 0 and info.p[0] == info.k[0], f"camera_info: {info.k}")
    check(info.distortion_model == "plumb_bob", info.distortion_model)
    clock = [message.clock.sec * 10**9 + message.clock.nanosec for _, message in topics["/clock"]]
    check(clock == sorted(set(clock)), "time goes on")
    return seen


def compare_description(bag, topics):
    """One message, kept, before all others; its links are the frames of /tf."""
    (time, message), = topics["/robot/robot_description"]
    first = min(one for messages in topics.values() for one, _ in messages)
    check(time == first, f"described at {time}, the bag begins at {first}")
    links = {f"robot/{link.get('name')}" for link in ElementTree.fromstring(message.data).iter("link")}
    frames = {one.child_frame_id for _, told in topics["/tf"] for one in told.transforms}
    check(len(links & frames) > 10, f"links {sorted(links)[:3]}, frames {sorted(frames)[:3]}")
    with Reader(bag) as reader:
        kept = {one.topic: one.ext.offered_qos_profiles for one in reader.connections}
    profile, = kept.pop("/robot/robot_description")
    check(profile.durability.name == "TRANSIENT_LOCAL" and profile.reliability.name == "RELIABLE", f"offered {profile}")
    check(not any(kept.values()), f"others are offered by default: {kept}")
    return len(links & frames)


def compare_markers(topics):
    """The scene has bodies; arrows of contacts come and go, and as many are shown as the last message has."""
    kinds = {marker.type for _, message in topics["/scene"] for marker in message.markers}
    check(kinds >= {1, 4}, f"the scene has markers {kinds}")
    shown = set()
    for _, message in topics["/contact_forces"]:
        for marker in message.markers:
            shown = shown | {marker.id} if marker.action == 0 else shown - {marker.id}
        check(shown == set(range(len(shown))), f"arrows {shown}")
    return kinds


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        recording, bag = Path(name) / "run.mcap", Path(name) / "bag"
        subprocess.run([program, "run", *SCENE, "--record", recording, "--record-what", WHAT], check=True, capture_output=True)
        told = subprocess.run([program, "export", recording, "--rosbag2", bag], check=True, capture_output=True, text=True)
        print(told.stdout.strip().partition(": ")[2])
        for store in (Stores.ROS2_HUMBLE, Stores.ROS2_JAZZY):
            topics = read(bag, store)
            count = sum(map(len, topics.values()))
            print(f"{store.name}: {count} messages of {len(topics)} topics, {compare_definitions(bag, store)} types")
        print("joints: {} messages of {}".format(*compare_joints(program, recording, topics)))
        print(f"imu: {compare_sensors(program, recording, topics)} samples")
        print(f"recorded: {compare_recorded(recording, topics)}; markers {compare_markers(topics)}")
        print(f"description: {compare_description(bag, topics)} links")
        again = subprocess.run([program, "export", recording, "--rosbag2", bag], capture_output=True, text=True)
        check(again.returncode == 2 and "exists" in again.stderr, f"an older bag: {again.stderr}")
    end()


if __name__ == "__main__":
    main()
