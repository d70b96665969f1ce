#!/usr/bin/env python3
"""Goes through Foxglove's live protocol with a running simulation, and decodes what comes with Foxglove's own message types.

Usage: foxglove_live.py <murosimf>
Exit: 0 all as the protocol says, 1 something is not, 77 a package is not installed (test is skipped).
"""
import base64
import json
import math
import struct
import sys
import unittest
from pathlib import Path

try:
    import foxglove_schemas_protobuf.FrameTransforms_pb2 as transforms_pb2
    import foxglove_schemas_protobuf.Log_pb2 as log_pb2
    import foxglove_schemas_protobuf.SceneUpdate_pb2 as scene_pb2
    from google.protobuf import descriptor_pb2
    from websockets.exceptions import ConnectionClosed
    from websockets.sync.client import connect
except ImportError as missing:
    print(f"skipped: {missing}; pip install websockets foxglove-schemas-protobuf")
    sys.exit(77)

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "web"))
from client import Run  # noqa: E402

PROGRAM = sys.argv.pop(1)
PLAY, PAUSE = 0, 1


class Viewer:
    """What Foxglove does when it connects."""

    def __init__(self, run, protocol="foxglove.sdk.v1"):
        self.socket = connect(f"ws://127.0.0.1:{run.port}/?token={run.token}", subprotocols=[protocol], max_size=None)
        self.info = self.text("serverInfo")
        self.channels = {one["topic"]: one for one in self.text("advertise")["channels"]}

    def message(self):
        return self.socket.recv(timeout=30)

    def text(self, op):
        while True:
            message = self.message()
            if isinstance(message, str) and json.loads(message)["op"] == op:
                return json.loads(message)

    def binary(self, opcode, good=lambda message: True):
        while True:
            message = self.message()
            if isinstance(message, bytes) and message[0] == opcode and good(message):
                return message

    def send(self, **what):
        self.socket.send(json.dumps(what))

    def subscribe(self, topic, number):
        self.send(op="subscribe", subscriptions=[{"id": number, "channelId": self.channels[topic]["id"]}])

    def data(self, number):
        """Time [s] and payload of the next message of a subscription."""
        message = self.binary(1, lambda m: struct.unpack_from("<I", m, 1)[0] == number)
        return struct.unpack_from("<Q", message, 5)[0] / 1e9, message[13:]

    def play(self, command, speed=1.0, seek=None, request="1"):
        """The answer: state, time [s], speed, whether it has sought."""
        name = request.encode()
        self.socket.send(struct.pack("<BBfBQI", 3, command, speed, seek is not None, round((seek or 0) * 1e9), len(name)) + name)
        answer = self.binary(5, lambda m: m[19:] == name)
        state, time, speed, sought, _ = struct.unpack_from("<BQfBI", answer, 1)
        return state, time / 1e9, speed, bool(sought)


class Live(unittest.TestCase):
    def test_both_names(self):
        with Run(PROGRAM, "walk", "--duration", "60") as run:
            for protocol in ("foxglove.sdk.v1", "foxglove.websocket.v1"):
                viewer = Viewer(run, protocol)
                self.assertEqual(viewer.socket.subprotocol, protocol)
                self.assertIn("Walk", viewer.info["name"])
                self.assertLessEqual({"time", "playbackControl", "parameters", "clientPublish"}, set(viewer.info["capabilities"]))
                self.assertEqual(viewer.info["dataStartTime"], {"sec": 0, "nsec": 0})
                self.assertEqual(viewer.info["dataEndTime"], {"sec": 60, "nsec": 0})
                viewer.socket.close()

    def test_schemas_and_data(self):
        with Run(PROGRAM, "nudge", "--duration", "60") as run:
            viewer = Viewer(run)
            self.assertLessEqual({"/tf", "/scene", "/joints", "/events", "/sensors/robot/imu"}, set(viewer.channels))
            for channel in viewer.channels.values():
                files = descriptor_pb2.FileDescriptorSet.FromString(base64.b64decode(channel["schema"]))
                names = [f"{file.package}.{message.name}" for file in files.file for message in file.message_type]
                self.assertIn(channel["schemaName"], names)
            for number, topic in enumerate(("/tf", "/scene", "/joints"), 1):
                viewer.subscribe(topic, number)
            _, bytes_of_scene = viewer.data(2)
            scene = scene_pb2.SceneUpdate.FromString(bytes_of_scene)
            self.assertTrue(any(entity.frame_id.startswith("robot/") for entity in scene.entities))
            time, bytes_of_poses = viewer.data(1)
            tree = transforms_pb2.FrameTransforms.FromString(bytes_of_poses)
            stamp = tree.transforms[0].timestamp
            self.assertAlmostEqual(stamp.seconds + stamp.nanos / 1e9, time, places=6)
            bases = [one for one in tree.transforms if one.parent_frame_id == "world"]
            base = next(one for one in bases if one.child_frame_id.startswith("robot/"))
            self.assertTrue(0.05 < base.translation.z < 1 and math.isfinite(base.rotation.w))
            frames = {one.child_frame_id for one in tree.transforms}
            self.assertLessEqual({entity.frame_id for entity in scene.entities if entity.frame_id != "world"}, frames)
            later, _ = viewer.data(1)
            self.assertGreater(later, time)
            clock = struct.unpack_from("<Q", viewer.binary(2), 1)[0] / 1e9
            self.assertGreaterEqual(clock, time)
            viewer.send(op="unsubscribe", subscriptionIds=[1, 2])
            viewer.data(3)

    def test_play_bar(self):
        with Run(PROGRAM, "walk", "--duration", "60") as run:
            viewer = Viewer(run)
            viewer.subscribe("/tf", 1)
            while viewer.data(1)[0] < 1:
                pass
            state, stands, _, _ = viewer.play(PAUSE)
            viewer.binary(5, lambda m: m[1] == 1)
            state, time, _, sought = viewer.play(PAUSE, seek=0.5, request="back")
            self.assertEqual((state, sought), (1, True))
            self.assertAlmostEqual(time, 0.5, places=6)
            while abs(viewer.data(1)[0] - 0.5) > 1e-6:
                pass
            _, _, speed, _ = viewer.play(PLAY, speed=4)
            self.assertAlmostEqual(speed, 4)
            while viewer.data(1)[0] <= stands:
                pass

    def test_parameters(self):
        with Run(PROGRAM, "walk", "--duration", "60") as run:
            viewer = Viewer(run)
            viewer.send(op="getParameters", parameterNames=[], id="all")
            values = {one["name"]: one["value"] for one in viewer.text("parameterValues")["parameters"]}
            self.assertEqual(values["walker.level"], "kinematic_walking")
            viewer.send(op="subscribeParameterUpdates", parameterNames=["walker.level"])
            viewer.send(op="setParameters", parameters=[{"name": "walker.level", "value": "simplified_dynamics"}])
            while True:
                told = {one["name"]: one["value"] for one in viewer.text("parameterValues")["parameters"]}
                if told.get("walker.level") == "simplified_dynamics":
                    break
            viewer.send(op="setParameters", parameters=[{"name": "walker.level", "value": "nonsense"}])
            status = viewer.text("status")
            self.assertEqual(status["level"], 2)
            self.assertIn("nonsense", status["message"])

    def test_commands(self):
        with Run(PROGRAM, "walk", "--duration", "60") as run:
            viewer = Viewer(run)
            viewer.subscribe("/events", 9)
            for number, topic, kind in ((5, "/walker/command", "geometry_msgs/Twist"), (6, "/change", "std_msgs/String")):
                viewer.send(op="advertise", channels=[{"id": number, "topic": topic, "encoding": "json", "schemaName": kind}])
            viewer.socket.send(struct.pack("<BI", 1, 5) + b'{"linear": {"x": 0.05, "y": 0}, "angular": {"z": 0.2}}')
            text = log_pb2.Log.FromString(viewer.data(9)[1]).message
            self.assertIn("walker", text)
            viewer.socket.send(struct.pack("<BI", 1, 6) + b'{"data": "walker.level = simplified_dynamics"}')
            while "simplified_dynamics" not in text:
                text = log_pb2.Log.FromString(viewer.data(9)[1]).message
            viewer.socket.send(struct.pack("<BI", 1, 6) + b"no json")
            self.assertIn("JSON", viewer.text("status")["message"])

    def test_nonsense(self):
        with Run(PROGRAM, "walk", "--duration", "60") as run:
            good = Viewer(run)
            too_short = struct.pack("<BI", 1, 5)[:3]
            for what in ("no json", "[]", '{"op": 3}', '{"op": "subscribe"}', b"", b"\x07", b"\x03\x00", too_short):
                bad = Viewer(run)
                bad.socket.send(what)
                with self.assertRaises(ConnectionClosed):
                    while True:
                        bad.message()
            good.subscribe("/tf", 1)
            good.data(1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
