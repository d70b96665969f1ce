#!/usr/bin/env python3
"""What nodes of ROS 2 cost a run in real time: round trips of services, processor time per robot.

    benchmarks/ros2_load.py --program build/release/murosimf
    benchmarks/ros2_load.py --program build/release/murosimf --robots 11 --seconds 20 --out ros2_load.json

The nodes are Cyclone DDS in this Python (package cyclonedds), as in tests/oracle. Robots walk at simplified_dynamics. Processor
time is that of the simulator's process alone: without --ros2, with it and no reader, with a reader of joint_states and imu of
each robot, and of pictures of one camera at 10 Hz, too. Runs follow each other, so the machine should be calm.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "oracle"))
import ros2_interfaces as si
import ros2_types as ros
from cyclonedds.util import duration
from ros2_peer import Node, wait_for

DOMAIN = 87
SCENE = """
name = "ros2_load"
[field]
size = "kid_size_2023"
[ball]
"""
ROBOT = """
[[robots]]
name = "robot{0}"
model = "kid21"
level = "simplified_dynamics"
position = [{1}, {2}]
"""
CAMERA = "[robots.sensors.camera]\nrate = 10\n"


def processor_time(process):
    """Seconds of all its threads."""
    fields = Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Run:
    def __init__(self, options, folder, ros2, cameras):
        robots = range(options.robots)
        scene = Path(folder) / "ros2_load.toml"
        scene.write_text(SCENE + "".join(ROBOT.format(i, i % 4 - 2, i // 4 - 1) + (CAMERA if i == 0 else "") for i in robots))
        command = [options.program, "run", str(scene), "--speed", "1", "--duration", "1000"]
        self.process = subprocess.Popen(command + ["--ros2", str(DOMAIN)] * ros2 + ["--no-cameras"] * (not cameras),
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()

    def share(self, seconds):
        """Of a core."""
        time.sleep(2)  # it starts
        before, start = processor_time(self.process), time.monotonic()
        time.sleep(seconds)
        return (processor_time(self.process) - before) / (time.monotonic() - start)


class Reading:
    """Takes what comes, in a thread."""

    def __init__(self, robots, pictures):
        node = Node(DOMAIN)
        self.readers = [node.subscribe(f"/robot{i}/{name}", kind) for i in range(robots)
                        for name, kind in (("joint_states", ros.JointState), ("imu", ros.Imu))]
        if pictures:
            self.readers.append(node.subscribe("/robot0/camera/image_raw", ros.Image))
        self.node, self.count, self.ends = node, 0, False
        self.thread = threading.Thread(target=self.take)
        self.thread.start()

    def take(self):
        while not self.ends:
            self.count += sum(len(reader.take(N=100)) for reader in self.readers)
            time.sleep(0.02)

    def end(self):
        self.ends = True
        self.thread.join()
        return self.count


def answered(client, number):
    """Waits for the answer without the pauses of ros2_peer."""
    while True:
        sample = client.reader.take_one(timeout=duration(seconds=5))
        if hasattr(sample, "client") and sample.client == client.id and sample.number == number:
            return


def round_trips(options, folder):
    """Rows of a table, which are printed."""
    rows = []
    with Run(options, folder, True, False) as run:
        node = Node(DOMAIN)
        for name, *values in (("get_simulation_state", 0), ("get_entity_state", "ball")):
            kind, request, answer = si.SERVICES["/" + name]
            client = node.client("/" + name, "simulation_interfaces/srv/" + kind, request, answer)
            if not wait_for(lambda client=client, values=values: client.call(*values, seconds=1), 30):
                sys.exit(f"ros2_load: /{name} does not answer; exit code of the run: {run.process.poll()}")
            times = []
            for _ in range(options.calls):
                start = time.perf_counter()
                answered(client, client.send(*values))
                times.append(1e3 * (time.perf_counter() - start))
            cut = statistics.quantiles(times, n=100)
            print(f"| /{name} | {cut[49]:.2f} ms | {cut[98]:.2f} ms |")
            rows.append({"service": "/" + name, "calls": options.calls, "median_ms": cut[49], "percentile_99_ms": cut[98]})
    return rows


def loads(options, folder):
    """Likewise."""
    base, rows = None, []
    for what, ros2, reads, pictures in (("without --ros2", False, False, False), ("without readers", True, False, False),
                                        ("joint_states and imu are read", True, True, False),
                                        ("without --ros2, one camera", False, False, True),
                                        ("one camera, without readers", True, False, True),
                                        ("the camera is read, too", True, True, True)):
        with Run(options, folder, ros2, pictures) as run:
            reading = Reading(options.robots, pictures) if reads else None
            share = run.share(options.seconds)
            count = reading.end() if reading else 0
        base = share if not ros2 else base
        more, of = (share - base, "camera") if pictures else ((share - base) / options.robots, "robot")
        print(f"| {what} | {100 * share:.1f} % | {100 * more:+.2f} % a {of} | {count} |")
        rows.append({"run": what, "share_of_a_core": share, "more_per_" + of: more, "messages_read": count})
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="build/release/murosimf")
    parser.add_argument("--robots", type=int, default=6)
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--calls", type=int, default=1000)
    parser.add_argument("--out", help="the tables as JSON")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        print(f"| service, {options.calls} calls | median | 99 % |\n|---|---|---|")
        services = round_trips(options, folder)
        print(f"\n| {options.robots} robots | of a core | more than without --ros2 | messages read |\n|---|---|---|---|")
        runs = loads(options, folder)
    if options.out:
        tables = {"robots": options.robots, "seconds": options.seconds, "services": services, "runs": runs}
        Path(options.out).write_text(json.dumps(tables, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
