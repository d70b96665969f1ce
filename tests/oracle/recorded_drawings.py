#!/usr/bin/env python3
"""Draws for RoboViz while a run is recorded, and reads what the recording has of it with the official packages for MCAP.

Usage: recorded_drawings.py <murosimf>
Exit: 0 all agree, 1 something differs, 77 a package is not installed (test is skipped).

The shapes that are decoded with Foxglove's own types have to be those that were sent, in the order in which they were
sent; the run has the state that it has without them, and `rerun` finds no difference.
"""
import json
import math
import re
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

try:
    import foxglove_schemas_protobuf.SceneUpdate_pb2  # noqa: F401
    from mcap.reader import make_reader
    from mcap_protobuf.decoder import DecoderFactory
except ImportError as missing:
    print(f"skipped: {missing}; pip install mcap mcap-protobuf-support foxglove-schemas-protobuf")
    sys.exit(77)

from errors import check, end
from recording_against_official import check_schemas

RUN = ["three_on_three", "--no-cameras", "--duration", "3", "--json", "-"]
SHOW = bytes([0, 0]) + b"blue.1\0"
RADII = [0.25, 0.5, 0.75]  # [m] one after the other


def number(value):
    """Six characters."""
    return f"{value:.4f}"[:6].encode()


def circle(radius):
    """At (1.5, -0.25), red; it waits to be shown."""
    return bytes([1, 0]) + b"".join(map(number, (1.5, -0.25, radius, 2))) + bytes([255, 0, 0]) + b"blue.1.way\0"


def note(text):
    """At the second robot of the team on the right, green."""
    return bytes([2, 1, 128 + 1, 0, 255, 0]) + text + b"\0"


def record(program, file):
    """The report of a run during which it is drawn."""
    command = [program, "run", *RUN, "--speed", "1", "--roboviz", "0", "--record", file, "--record-what", "poses,drawings,hashes"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run, \
            socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as agent:
        agent.connect(("127.0.0.1", int(re.search(r"127.0.0.1:(\d+) \(UDP\)", run.stderr.readline())[1])))
        for radius in RADII:
            time.sleep(0.3)
            agent.send(circle(radius) + SHOW)
            agent.send(circle(radius) + SHOW)  # the same again
        agent.send(note(b"I have it"))
        time.sleep(0.3)
        agent.send(SHOW)  # nothing
        agent.send(bytes([2, 2, 128 + 1]))
        output = run.communicate()[0]
    check(run.returncode == 0, f"exit code {run.returncode}")
    return json.loads(output)


def messages(file):
    """Decoded, by topic, in the order of time."""
    found = {}
    with open(file, "rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        check_schemas(reader.get_summary(), {"SceneEntity", "SceneEntityDeletion", "FrameTransforms"})
        for _, channel, _, decoded in reader.iter_decoded_messages():
            if channel.topic.startswith("/drawings/"):
                found.setdefault(channel.topic, []).append(decoded)
    return found


def check_circles(updates):
    """All that was shown in the world."""
    shown = [update.entities for update in updates]
    check(all(len(update.deletions) == 1 and update.deletions[0].type == 1 for update in updates), "old ones stay")
    check([len(entities) for entities in shown] == [1] * len(RADII) + [0], f"groups: {[len(e) for e in shown]}")
    for radius, (entity, *_) in zip(RADII, shown, strict=False):
        check((entity.id, entity.frame_id) == ("roboviz/blue.1.way", "world"), f"{entity.id} in {entity.frame_id}")
        line = entity.lines[0]
        check(len(entity.lines) == 1 and (line.color.r, line.color.g, line.color.b) == (1, 0, 0), "it is not red")
        distances = [math.hypot(p.x - 1.5, p.y + 0.25) for p in line.points]
        check(len(distances) > 20 and max(abs(d - radius) for d in distances) < 1e-6, f"no circle of {radius} m: {distances[:3]}")
        shape = json.loads(entity.metadata[0].value)
        check((shape["kind"], shape["size"]) == ("circle", radius), f"metadata: {shape}")


def check_notes(updates):
    """All that was shown at the robot."""
    check([len(update.entities) for update in updates] == [1, 0], f"{len(updates)} notes")
    entity = updates[0].entities[0]
    check(entity.frame_id.startswith("red2/") and entity.frame_locked, f"a note at {entity.frame_id}")
    check([text.text for text in entity.texts] == ["I have it"], "another text")


def check_pictures(program, file, folder, updates):
    """`render` shows each circle from its time on, and nothing before and after."""
    def picture(time, *drawings):
        out = folder / "picture.png"
        made = subprocess.run([program, "render", file, "--time", str(time), "--size", "320x180", "--no-shadows", "--out", out,
                               *drawings], capture_output=True, text=True, check=False)
        return out.read_bytes() if made.returncode == 0 else None

    times = [u.deletions[0].timestamp.seconds + u.deletions[0].timestamp.nanos / 1e9 for u in updates]
    if picture(0) is None:
        print("pictures are not looked at: nothing is drawn here")
        return
    for at, drawn in ((times[0] - 0.02, False), (times[0] + 0.02, True), (times[1] + 0.02, True), (times[-1] + 0.02, False)):
        plain = picture(at)
        check((picture(at, "--drawings", "roboviz/blue.1.way") != plain) == drawn, f"{at} s: drawn or not, unlike the recording")
        check(picture(at, "--drawings", "roboviz/other") == plain, f"{at} s: another group is drawn")
    print(f"pictures around {times} s are as recorded")


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "run.mcap"
        report = record(program, file)
        check(report["drawings"] == {"packets": 2 * len(RADII) + 3, "ignored": 0}, f"packets: {report['drawings']}")
        found = messages(file)
        check(set(found) == {"/drawings/roboviz", "/drawings/roboviz/red2"}, f"topics: {set(found)}")
        check_circles(found["/drawings/roboviz"])
        check_notes(found["/drawings/roboviz/red2"])
        check_pictures(program, file, Path(folder), found["/drawings/roboviz"])
        alone = json.loads(subprocess.run([program, "run", *RUN], capture_output=True, check=True).stdout)
        check(alone["state_hash"] == report["state_hash"], "drawings change the run")
        again = subprocess.run([program, "rerun", file], capture_output=True, text=True, check=False)
        check(again.returncode == 0, f"rerun: {again.stdout}{again.stderr}")
        print(again.stdout, end="")
    end()


if __name__ == "__main__":
    main()
