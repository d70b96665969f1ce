#!/usr/bin/env python3
"""Reads the pictures of cameras in a recording with the official packages for MCAP and OpenCV, and compares them with live ones.

Usage: recorded_pictures.py <murosimf>
Exit: 0 all agree, 1 something differs, 77 a package is not installed or nothing can be drawn here (test is skipped).

A picture has to be the one that `render --camera` makes at the instant of its exposure, byte for byte; the calibration, with the
transforms of the camera and of its robot, has to lead from the ball in the world to the pixel in which the ball is seen, as
Foxglove's overlay does. Depths and labels have to be those that `render` writes, and the ground as far away as it is.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import cv2
    import foxglove_schemas_protobuf.CompressedImage_pb2  # noqa: F401
    import foxglove_schemas_protobuf.RawImage_pb2  # noqa: F401
    import numpy as np
    from mcap.reader import make_reader
    from mcap_protobuf.decoder import DecoderFactory
except ImportError as missing:
    print(f"skipped: {missing}; pip install mcap mcap-protobuf-support foxglove-schemas-protobuf opencv-python-headless")
    sys.exit(77)

from errors import check, end
from recording_against_official import check_schemas, positions, rotation

SCENE, CAMERA, BALL, DURATION = "three_on_three", "red2.camera", "ball/ball", 1
# No lens, and one that bends what is seen.
LENSES = [[], ["calibration='wolfgang_amy'"]]


def words(changes):
    """The options that change the camera."""
    return [word for change in changes for word in ("--set", f"red2.sensors.camera.{change}")]


def pose(transform):
    """Place and turn."""
    t = transform.translation
    return np.array([t.x, t.y, t.z]), rotation(transform.rotation)


def frames(message):
    """As positions(), with the turn."""
    poses = {"world": (np.zeros(3), np.eye(3))}
    for transform in message.transforms:
        r, turn = poses[transform.parent_frame_id]
        shift, own = pose(transform)
        poses[transform.child_frame_id] = (r + turn @ shift, turn @ own)
    return poses


def pixel_of(point, bodies, on_link, calibration):
    """Where OpenCV sees a point of the world; nothing behind the camera."""
    r, turn = frames(bodies)[on_link.transforms[0].parent_frame_id]
    shift, own = pose(on_link.transforms[0])
    seen = (turn @ own).T @ (point - (r + turn @ shift))
    if seen[2] <= 0:
        return None
    matrix, lens = np.array(calibration.K).reshape(3, 3), np.array(calibration.D)
    project = cv2.fisheye.projectPoints if calibration.distortion_model == "kannala_brandt" else cv2.projectPoints
    return project(seen.reshape(1, 1, 3), np.zeros(3), np.zeros(3), matrix, lens)[0].reshape(2)


def ball_in(program, folder, time, changes):
    """The middle of the pixels that show the ball at a time: those that another color of it changes."""
    pictures = []
    for color in ("[1,0,0]", "[0,0,1]"):
        file = folder / "ball.png"
        subprocess.run([program, "render", SCENE, "--camera", CAMERA, "--time", str(time), "--out", file, "--set",
                        f"ball.color={color}", *words(changes)], check=True, capture_output=True)
        pictures.append(cv2.imread(str(file)).astype(int))
    rows, columns = np.nonzero(np.abs(pictures[0] - pictures[1]).max(axis=2) > 60)
    return np.array([(columns.min() + columns.max()) / 2, (rows.min() + rows.max()) / 2]) if len(rows) else None


def compare(program, folder, changes):
    """Records a run and looks at all of it; how many pictures were compared with live ones."""
    file, compared = folder / "run.mcap", 0
    run = [program, "run", SCENE, "--duration", str(DURATION), "--record", file, "--record-what", "poses,pictures,hashes"]
    told = subprocess.run([*run, *words(changes)], capture_output=True, text=True, check=True)
    with open(file, "rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        check_schemas(reader.get_summary(), {"CompressedImage", "CameraCalibration", "FrameTransforms"})
        last = {}
        pictures = []
        for _, channel, message, decoded in reader.iter_decoded_messages():
            last[channel.topic] = decoded
            if channel.topic == "/tf":
                last[message.log_time] = decoded
            if channel.topic == "/cameras/tf" and decoded.transforms[0].child_frame_id.startswith("red2/"):
                last["place"] = decoded
            if channel.topic == "/cameras/red2/camera/image":
                pictures.append((decoded, last["/cameras/red2/camera/calibration"], last["place"], last["/tf"]))
    if not pictures:
        print(f"skipped: nothing is drawn here\n{told.stdout}")
        sys.exit(77)
    check(len(pictures) == 20 * DURATION, f"{len(pictures)} pictures in {DURATION} s at 20 Hz")
    check(subprocess.run([program, "rerun", file], capture_output=True, check=False).returncode == 0, f"{changes}: rerun differs")
    for picture, calibration, place, bodies in pictures[::9]:
        time = picture.timestamp.seconds + picture.timestamp.nanos / 1e9
        live = folder / "live.png"
        subprocess.run([program, "render", SCENE, "--camera", CAMERA, "--time", str(time), "--out", live, *words(changes)],
                       check=True, capture_output=True)
        check(live.read_bytes() == picture.data, f"{changes} at {time} s: not the live picture")
        pixels = cv2.imdecode(np.frombuffer(picture.data, np.uint8), cv2.IMREAD_COLOR)
        check(pixels.shape == (calibration.height, calibration.width, 3), f"{changes}: size {pixels.shape}")
        check(np.array_equal(pixels, cv2.imread(str(live))), f"{changes} at {time} s: other pixels")
        compared += 1
        seen = ball_in(program, folder, time, changes) if not any("mosaic" in change for change in changes) else None
        wanted = pixel_of(positions(bodies)[BALL], bodies, place, calibration)
        if seen is not None and wanted is not None:
            check(np.abs(seen - wanted).max() < 2, f"{changes} at {time} s: the ball is at {seen}, calibration says {wanted}")
            print(f"{changes or 'plain'} at {time} s: ball at {seen}, by calibration {wanted.round(2)}")
    return compared


def numbers_of(message):
    """foxglove.RawImage as rows x columns."""
    check(message.encoding == "16UC1" and message.step == 2 * message.width, f"{message.encoding}, step {message.step}")
    return np.frombuffer(message.data, "<u2").reshape(message.height, message.width)


def compare_numbers(program, folder):
    """Depths and labels of a recording against those that `render` writes; depths of the ground against the camera's place."""
    changes, file = ["depth=true", "labels=true"], folder / "numbers.mcap"
    subprocess.run([program, "run", SCENE, "--duration", "0.3", "--record", file, "--record-what", "poses,pictures",
                    *words(changes)], capture_output=True, check=True)
    seen = {}
    with open(file, "rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        check_schemas(reader.get_summary(), {"RawImage"})
        for _, channel, message, decoded in reader.iter_decoded_messages():
            if channel.topic == "/tf":
                seen[message.log_time] = decoded
            elif channel.topic.startswith("/cameras/red2"):
                seen[channel.topic] = (decoded, channel.metadata)
            elif channel.topic == "/cameras/tf" and decoded.transforms[0].child_frame_id.startswith("red2/"):
                seen["place"] = decoded
    depth, labels = seen["/cameras/red2/camera/depth"][0], seen["/cameras/red2/camera/labels"][0]
    taken = depth.timestamp.seconds + depth.timestamp.nanos / 1e9
    table = {row["id"]: row for row in json.loads(seen["/cameras/red2/camera/labels"][1]["labels"])["labels"]}
    pictures = {"depth": numbers_of(depth), "labels": numbers_of(labels)}
    for layer, recorded in pictures.items():
        out = folder / f"{layer}.png"
        subprocess.run([program, "render", SCENE, "--camera", CAMERA, "--time", str(taken), "--layer", layer, "--out", out,
                        *words(changes)], capture_output=True, check=True)
        drawn = cv2.imread(str(out), cv2.IMREAD_UNCHANGED)
        check(drawn.dtype == np.uint16 and np.array_equal(drawn, recorded), f"{layer}: not as render draws it")
    written = json.loads((folder / "labels.labels.json").read_text())["labels"]
    check({row["id"]: row for row in written} == table, "the tables of labels differ")
    kinds = {table[i]["kind"] for i in np.unique(pictures["labels"])}
    check({"scenery"} < kinds, f"nobody is seen: {kinds}")
    ground_distances(seen, depth, pictures, table)


def ground_distances(seen, depth, pictures, table):
    """On the ground a pixel's depth is where its ray meets z = 0."""
    time = min((key for key in seen if isinstance(key, int)), key=lambda t: abs(t - stamp_ns(depth)))
    r, turn = frames(seen[time])[seen["place"].transforms[0].parent_frame_id]
    shift, own = pose(seen["place"].transforms[0])
    eye, axes = r + turn @ shift, turn @ own
    matrix = np.array(seen["/cameras/red2/camera/calibration"][0].K).reshape(3, 3)
    ground = next(i for i, row in table.items() if row["name"] == "ground")
    rows, columns = np.nonzero(pictures["labels"] == ground)
    check(len(rows) > 1000, f"{len(rows)} pixels show the ground")
    rays = axes @ np.linalg.inv(matrix) @ np.stack([columns, rows, np.ones(len(rows))])
    meets = -eye[2] / rays[2] * 1000  # along the optical axis, whose part of a ray is 1
    away = np.abs(pictures["depth"][rows, columns] - meets) / meets
    print(f"ground: {len(rows)} pixels, depths {meets.min():.0f} to {meets.max():.0f} mm, median of differences "
          f"{100 * np.median(away):.3f} %")
    check(np.median(away) < 0.01, f"depths of the ground are {np.median(away)} away")


def stamp_ns(message):
    return message.timestamp.seconds * 10**9 + message.timestamp.nanos


def main():
    with tempfile.TemporaryDirectory() as name:
        compared = sum(compare(sys.argv[1], Path(name), changes) for changes in LENSES)
        compare_numbers(sys.argv[1], Path(name))
    check(compared >= 3 * len(LENSES), f"only {compared} pictures")
    end(f"{compared} pictures, ")


if __name__ == "__main__":
    main()
