#!/usr/bin/env python3
"""Reads motions of `murosimf export --bvh` with a parser of its own, and compares where every link is with the recording.

Usage: bvh_against_recording.py <murosimf>
Exit: 0 all agree, 1 something differs, 77 a package is not installed (test is skipped).

The recording is read with the official package for MCAP. Forward kinematics of the BVH: a joint's frame in its parent's is its
offset, then the rotations of its channels in the order in which they stand.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy as np
    from mcap.reader import make_reader
    from mcap_protobuf.decoder import DecoderFactory
except ImportError as missing:
    print(f"skipped: {missing}; pip install mcap mcap-protobuf-support foxglove-schemas-protobuf")
    sys.exit(77)

from errors import check, end
from recording_against_official import positions

TOLERANCE = 1e-4  # [m]
# Somebody walks, somebody falls, and bodies of another level; with the robot's name, or where there is only one without.
RUNS = [("walk", "walker", 100, ["--duration", "3"]),
        ("push", "", 100, ["--duration", "3"]),
        ("nudge", "robot", 30, ["--duration", "2", "--set", "robot.level=full_dynamics"])]


class Motion:
    """A BVH file: offsets, parents and channels of joints, and a row of numbers for each frame."""

    def __init__(self, text):
        words = text.split()
        self.names, self.parents, self.offsets, self.channels = [], [], [], []
        i, stack, in_end = 1, [], False
        while words[i] != "MOTION":
            word = words[i]
            if word in ("ROOT", "JOINT"):
                self.names.append(words[i + 1])
                self.parents.append(stack[-1] if stack else -1)
                i += 2
            elif word == "End":
                in_end = True
                i += 2
            elif word == "{":
                stack.append(None if in_end else len(self.names) - 1)
                i += 1
            elif word == "}":
                in_end = False
                stack.pop()
                i += 1
            elif word == "OFFSET":
                if not in_end:
                    self.offsets.append(np.array([float(x) for x in words[i + 1:i + 4]]))
                i += 4
            elif word == "CHANNELS":
                count = int(words[i + 1])
                self.channels.append(words[i + 2:i + 2 + count])
                i += 2 + count
            else:
                raise ValueError(word)
        count, self.period = int(words[i + 2]), float(words[i + 5])
        self.rows = np.array([float(x) for x in words[i + 6:]]).reshape(count, sum(map(len, self.channels)))

    def places(self, frame):
        """[m] in the axes of the robot, by joint."""
        row, poses = list(self.rows[frame]), []
        for parent, offset, channels in zip(self.parents, self.offsets, self.channels, strict=True):
            shift, turn = offset.copy(), np.eye(3)
            for channel in channels:
                value = row.pop(0)
                if channel.endswith("position"):
                    shift["XYZ".index(channel[0])] += value
                else:
                    turn = turn @ about("XYZ".index(channel[0]), np.radians(value))
            r, outer = poses[parent] if parent >= 0 else (np.zeros(3), np.eye(3))
            poses.append((r + outer @ shift, outer @ turn))
        return {name: np.array([r[2], r[0], r[1]]) / 100 for name, (r, _) in zip(self.names, poses, strict=True)}


def about(axis, angle):
    """Turn about an axis."""
    i, k = (axis + 1) % 3, (axis + 2) % 3
    turn = np.eye(3)
    turn[i, i] = turn[k, k] = np.cos(angle)
    turn[i, k], turn[k, i] = -np.sin(angle), np.sin(angle)
    return turn


def compare(program, folder, scene, robot, rate, words):
    """Records and exports a run; how low its root comes [m]."""
    file, out = folder / "run.mcap", folder / "run.bvh"
    subprocess.run([program, "run", scene, "--record", file, "--record-what", "poses", "--record-rate", str(rate), *words],
                   check=True, capture_output=True)
    told = subprocess.run([program, "export", file, "--bvh", out, *(["--robot", robot] if robot else [])],
                          check=True, capture_output=True, text=True)
    motion = Motion(out.read_text(encoding="utf-8"))
    check(abs(motion.period - 1 / rate) < 1e-8, f"{scene}: {motion.period} s a frame")
    worst, frames, lowest = 0, 0, np.inf
    with open(file, "rb") as stream:
        for _, _, message, decoded in make_reader(stream, decoder_factories=[DecoderFactory()]).iter_decoded_messages(["/tf"]):
            places = motion.places(round(message.log_time / 1e9 * rate))
            at = positions(decoded)
            for name, place in places.items():
                wanted = next(r for frame, r in at.items() if frame.split("/")[-1] == name and (robot or "robot") in frame)
                worst = max(worst, np.abs(place - wanted).max())
            frames += 1
            lowest = min(lowest, next(iter(places.values()))[2])
    check(frames == len(motion.rows), f"{scene}: {frames} frames recorded, {len(motion.rows)} in the file")
    check(len(motion.names) > 15, f"{scene}: {motion.names}")
    check(worst < TOLERANCE, f"{scene}: links are up to {1000 * worst:.3f} mm elsewhere; {told.stderr}")
    print(f"{scene}: {frames} frames of {len(motion.names)} links, root down to {lowest:.2f} m, "
          f"largest distance {1000 * worst:.4f} mm")
    return lowest


def main():
    with tempfile.TemporaryDirectory() as name:
        lowest = [compare(sys.argv[1], Path(name), *run) for run in RUNS]
        check(lowest[1] < 0.15, f"nobody fell: {lowest}")
    end()


if __name__ == "__main__":
    main()
