#!/usr/bin/env python3
"""murosimf run --web from outside: HTTP, the page's WebSocket, which clients may enter, clients that are slow or talk nonsense.

Usage: web_server.py <murosimf>
"""
import base64
import gzip
import json
import re
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request
import zlib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "league"))
import play_with_game_controller  # noqa: E402
from client import Client, Refused, Run, time_of  # noqa: E402

PROGRAM = sys.argv.pop(1)


def get(port, path="/", **headers):
    request = urllib.request.Request(f"http://127.0.0.1:{port}{path}", headers=headers)
    with urllib.request.urlopen(request, timeout=20) as answer:
        return answer.status, answer.headers, answer.read()


class Page(unittest.TestCase):
    def test_page_is_there_and_complete(self):
        with Run(PROGRAM, "walk") as run:
            status, headers, body = get(run.port)
            self.assertEqual(status, 200)
            page = gzip.decompress(body).decode() if headers["Content-Encoding"] == "gzip" else body.decode()
            self.assertIn("<canvas", page)
            self.assertNotRegex(page, r'(src|href)="https?:')
            self.assertIn("frame-ancestors 'none'", headers["Content-Security-Policy"])
            self.assertEqual(headers["X-Frame-Options"], "DENY")

    def test_other_paths_and_methods(self):
        with Run(PROGRAM, "walk") as run:
            for path in ("/nosuch", "/../etc/passwd", "/%2e%2e/etc/passwd"):
                with self.assertRaises(urllib.error.HTTPError) as error:
                    get(run.port, path)
                self.assertIn(error.exception.code, (403, 404))
                error.exception.close()
            with self.assertRaises(urllib.error.HTTPError) as error:
                urllib.request.urlopen(f"http://127.0.0.1:{run.port}/", data=b"x", timeout=20)
            error.exception.close()


class Entry(unittest.TestCase):
    def test_pages_from_elsewhere_need_the_token(self):
        with Run(PROGRAM, "walk") as run:
            with self.assertRaises(Refused) as refusal:
                Client(run.port, headers=["Origin: https://evil.example"])
            self.assertIn("403", str(refusal.exception))
            with self.assertRaises(Refused):
                Client(run.port, path="/?token=wrong", headers=["Origin: https://evil.example"])
            Client(run.port, path=f"/?token={run.token}", headers=["Origin: https://app.foxglove.dev"]).close()
            Client(run.port, headers=[f"Origin: http://127.0.0.1:{run.port}"]).close()
            for other in (f"http://localhost:{run.port}", "http://127.0.0.1:3000"):
                with self.assertRaises(Refused):
                    Client(run.port, headers=[f"Origin: {other}"])

    def test_other_computers_need_the_token(self):
        with Run(PROGRAM, "walk", web="0.0.0.0:0") as run:
            with self.assertRaises(urllib.error.HTTPError) as error:
                get(run.port)
            self.assertEqual(error.exception.code, 403)
            error.exception.close()
            self.assertEqual(get(run.port, f"/?token={run.token}")[0], 200)
            with self.assertRaises(Refused):
                Client(run.port)
            Client(run.port, path=f"/?token={run.token}").close()

    def test_port_in_use(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            done = subprocess.run([PROGRAM, "run", "walk", "--web", str(port)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, f"murosimf: --web: 127.0.0.1:{port}: the port is in use\n")

    def test_what_is_no_address(self):
        for where in ("walk", "99999", "nosuch.invalid:80"):
            done = subprocess.run([PROGRAM, "run", "walk", "--web", where], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 2, where)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn("--web", done.stderr)


class Steering(unittest.TestCase):
    def test_a_session(self):
        with Run(PROGRAM, "walk", "--set", "walker.level=simplified_dynamics", "--duration", "60") as run:
            client = Client(run.port)
            scene = client.wait_for(lambda m: isinstance(m, bytes) and m[0] == 3)
            text = json.loads(scene[8:8 + int.from_bytes(scene[4:8], "little")])
            self.assertEqual(text["name"], "Walk")
            first = time_of(client.poses())
            self.assertGreater(time_of(client.poses()), first)

            client.order(do="pause", id=1)
            self.assertNotIn("error", client.answer(1))
            stands = client.state(lambda state: state["paused"])["time"]
            client.order(do="step", steps=10, id=2)
            self.assertNotIn("error", client.answer(2))
            after = client.state(lambda state: state["time"] > stands)
            self.assertAlmostEqual(after["time"], stands + 0.01, places=6)

            client.order(do="change", text="walker.level = full_dynamics", id=3)
            self.assertNotIn("error", client.answer(3))
            walker = next(i for i, one in enumerate(text["entities"]) if one["name"] == "walker")
            client.state(lambda state: state["entities"][walker]["level"] == "full_dynamics")
            client.order(do="change", text="walker.level = nonsense", id=4)
            self.assertIn("nonsense", client.answer(4)["error"])

            client.order(do="speed", speed=None, id=5)
            client.answer(5)
            client.order(do="go_on", id=6)
            client.answer(6)
            client.state(lambda state: state["time"] > stands + 2)
            client.order(do="pause", id=7)
            client.answer(7)
            client.order(do="seek", time=1.5, id=8)
            self.assertNotIn("error", client.answer(8))
            back = client.state(lambda state: state["time"] < stands + 2)
            self.assertTrue(back["paused"])
            self.assertAlmostEqual(back["time"], 1.5, places=6)
            client.order(do="seek", time=500, id=9)
            self.assertIn("error", client.answer(9))
            client.order(do="reset", id=10)
            self.assertNotIn("error", client.answer(10))
            client.state(lambda state: state["time"] == 0)
            client.order(do="speed", speed=-1, id=11)
            self.assertIn("error", client.answer(11))

    def test_pushes(self):
        with Run(PROGRAM, "walk", "--set", "walker.level=simplified_dynamics") as run:
            client = Client(run.port)
            client.poses()
            client.order(do="change", text="walker.torso.push = [20, 0, 0, 0.1]", id=1)
            answer = client.answer(1)
            self.assertNotIn("error", answer)
            client.wait_for(lambda m: isinstance(m, dict) and m["is"] == "lines" and m["lines"])

    def test_numbers(self):
        with Run(PROGRAM, "nudge", "--duration", "60") as run:
            client = Client(run.port)
            client.poses()
            client.order(do="names", entity="robot", id=1)
            names = client.answer(1)["result"]
            self.assertIn("robot.imu.gyroscope.x", names)
            client.order(do="watch", paths=["robot.imu.gyroscope.x", "robot.torso.position.z"], id=2)
            self.assertNotIn("error", client.answer(2))
            values = client.wait_for(lambda m: isinstance(m, dict) and m["is"] == "values")["values"]
            self.assertGreater(values["robot.torso.position.z"], 0.1)
            self.assertIsInstance(values["robot.imu.gyroscope.x"], float)
            client.order(do="watch", paths=["robot.nosuch"], id=3)
            self.assertIn("nosuch", client.answer(3)["error"])

    def test_score(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as referee:
            referee.bind(("127.0.0.1", 0))  # also where robots answer
            port = play_with_game_controller.free_port()
            with Run(PROGRAM, "three_on_three", "--duration", "60", "--no-cameras", "--game-controller", str(port),
                     "--set", f"league.answer_port={referee.getsockname()[1]}") as run:
                client = Client(run.port)
                self.assertIsNone(client.state()["game"])
                for packet in play_with_game_controller.packets():
                    referee.sendto(packet, ("127.0.0.1", port))
                    client.poses()
                game = client.state(lambda state: state["game"] and state["game"]["teams"][0]["score"] == 3)["game"]
                self.assertEqual(game["state"], "playing")
                self.assertEqual(game["teams"][1], {"name": "red", "score": 0})

    def test_end(self):
        with Run(PROGRAM, "walk", "--duration", "0.5", "--json", "-") as run:
            client = Client(run.port)
            end = client.state(lambda state: state["paused"])
            self.assertAlmostEqual(end["time"], 0.5, places=6)
            self.assertIsNone(run.process.poll(), "it stays until Ctrl-C")
            code, output = run.stop()
            self.assertEqual(code, 0)
            report = json.loads(output)
            self.assertIsNone(report["stopped"])
        alone = subprocess.run([PROGRAM, "run", "walk", "--duration", "0.5", "--json", "-"], capture_output=True,
                               check=True, text=True)
        self.assertEqual(json.loads(alone.stdout)["state_hash"], report["state_hash"])


def recording_of(file):
    """What an HTML file says, and how many bytes follow on it."""
    page = file.read_text(encoding="utf-8")
    recording = gzip.decompress(base64.b64decode(re.search(r'id="recording"[^>]*>([^<]*)<', page)[1]))
    size = int.from_bytes(recording[:4], "little")
    return json.loads(recording[4:4 + size]), len(recording) - 4 - size


class Export(unittest.TestCase):
    def test_the_file_is_small_and_the_run_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "game.html")
            words = [PROGRAM, "run", "three_on_three", "--duration", "60", "--json", "-"]
            made = subprocess.run([*words, "--html", file], capture_output=True, check=True, text=True)
            alone = subprocess.run(words, capture_output=True, check=True, text=True)
            self.assertEqual(json.loads(made.stdout)["state_hash"], json.loads(alone.stdout)["state_hash"])
            self.assertLess(file.stat().st_size, 5_000_000)
            text, others = recording_of(file)
        self.assertEqual(text["frames"], 60 * 25 + 1)
        self.assertEqual(others, text["scene_bytes"] + 2 * text["words"] * text["frames"])
        self.assertNotIn("drawings", text)

    def test_what_cannot_be_written(self):
        for words, said in ((["--html", "/nosuch/game.html"], "/nosuch"), (["--html-rate", "9"], "--html"),
                            (["--html", "x.html", "--html-rate", "0"], "frames per second")):
            done = subprocess.run([PROGRAM, "run", "walk", *words], capture_output=True, text=True, check=False)
            self.assertNotEqual(done.returncode, 0, words)
            self.assertIn(said, done.stderr)


def number(value):
    """As agents of the league write it for RoboViz: six characters."""
    return f"{value:.4f}"[:6].encode()


def circle(name, x, y, radius):
    """A packet for RoboViz: an orange circle of the set `name`, which is shown."""
    drawn = bytes([1, 0]) + b"".join(map(number, (x, y, radius, 2))) + bytes([255, 128, 0]) + name + b"\0"
    return drawn + bytes([0, 0]) + name + b"\0"


class Drawings(unittest.TestCase):
    def test_what_is_drawn_for_roboviz(self):
        with Run(PROGRAM, "walk", "--duration", "0.5", "--roboviz", "0", "--json", "-") as run, \
                socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as agent:
            door = re.search(r"RoboViz on 127.0.0.1:(\d+) \(UDP\)", "".join(run.said))
            agent.connect(("127.0.0.1", int(door[1])))
            client, viewer = Client(run.port), Client(run.port, protocol="foxglove.sdk.v1")
            client.poses()
            agent.send(b"nonsense")
            agent.send(circle(b"blue.1.way", 1.5, -0.25, 0.5)[:-3])  # cut off: the circle waits
            agent.send(bytes([0, 0]) + b"blue\0")
            drawn = client.wait_for(lambda m: isinstance(m, dict) and m["is"] == "drawings")["drawings"]
            self.assertEqual([one["by"] for one in drawn], ["roboviz"])
            self.assertEqual([group["name"] for group in drawn[0]["groups"]], ["blue.1.way"])
            shape = drawn[0]["groups"][0]["shapes"][0]
            self.assertEqual((shape["kind"], shape["points"], shape["size"]), ("circle", [[1.5, -0.25, 0.005]], 0.5))
            late = Client(run.port)  # sees it, too
            late.wait_for(lambda m: isinstance(m, dict) and m["is"] == "drawings")
            channel = viewer.wait_for(lambda m: isinstance(m, dict) and m["op"] == "advertise" and any(
                one["topic"] == "/drawings/roboviz" for one in m["channels"]))["channels"][-1]
            viewer.order(op="subscribe", subscriptions=[{"id": 7, "channelId": channel["id"]}])
            message = viewer.wait_for(lambda m: isinstance(m, bytes) and m[0] == 1)
            self.assertIn(b"blue.1.way", message)
            client.state(lambda state: state["paused"])
            for one in (client, viewer, late):
                one.close()
            code, output = run.stop()
        self.assertEqual(code, 0)
        report = json.loads(output)
        self.assertEqual(report["drawings"], {"packets": 3, "ignored": 2})
        alone = subprocess.run([PROGRAM, "run", "walk", "--duration", "0.5", "--json", "-"], capture_output=True, check=True)
        self.assertEqual(report["state_hash"], json.loads(alone.stdout)["state_hash"])
        self.assertIsNone(json.loads(alone.stdout)["drawings"])

    def test_html_file_has_what_was_drawn_at_its_time(self):
        with tempfile.TemporaryDirectory() as folder:
            file, recorded, replayed = (Path(folder, name) for name in ("live.html", "run.mcap", "replayed.html"))
            command = [PROGRAM, "run", "walk", "--duration", "3", "--speed", "1", "--roboviz", "0", "--html", file,
                       "--record", recorded]
            with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as run, \
                    socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as agent:
                agent.connect(("127.0.0.1", int(re.search(r"127.0.0.1:(\d+) \(UDP\)", run.stderr.readline())[1])))
                for packet in (circle(b"way", 1.5, -0.25, 0.5), circle(b"way", 1.75, -0.25, 0.5), bytes([0, 0]) + b"way\0"):
                    time.sleep(0.5)
                    agent.send(packet)
                run.wait(timeout=60)
            subprocess.run([PROGRAM, "replay", recorded, "--html", replayed], capture_output=True, check=True)
            found = [recording_of(one)[0] for one in (file, replayed)]
        frames = []
        for text in found:
            self.assertEqual(text["drawings"]["looks"], [["circle", 0.5, 1, 0.502, 0, 1, "", 1]])
            track, = text["drawings"]["tracks"]
            self.assertEqual([track[key] for key in ("by", "entity", "name", "of_robot")], ["roboviz", -1, "way", False])
            self.assertEqual(track["points"], [[1500, -250, 5], [250, 0, 0], []])
            self.assertEqual(track["looks"], [[0], None, []])
            frames.append([sum(track["frames"][:i + 1]) for i in range(3)])
        live, then = frames
        self.assertLess(max(abs(a - b) for a, b in zip(live, then, strict=True)), 3, f"frames of 40 ms: {frames}")
        self.assertEqual(live, sorted(set(live)))

    def test_port_in_use(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
            taken.bind(("127.0.0.1", 0))
            port = taken.getsockname()[1]
            done = subprocess.run([PROGRAM, "run", "walk", "--roboviz", str(port)], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (2, f"murosimf: --roboviz: 127.0.0.1:{port}: the port is in use\n"))


def is_picture(message):
    return isinstance(message, bytes) and message[0] == 2


def pixels_of(message):
    """Width, height, and red, green, blue of each pixel of a picture for the page."""
    return struct.unpack_from("<HH", message, 2), message[8:]


def read_png(data):
    """The same of a PNG file of 8 bits, with or without opacity."""
    width, height, _, color = struct.unpack_from(">IIBB", data, 16)
    packed, at = b"", 8
    while at < len(data):
        size = int.from_bytes(data[at:at + 4], "big")
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    raw, step = zlib.decompress(packed), {2: 3, 6: 4}[color]
    row, pixels = bytearray(width * step), bytearray()
    for y in range(height):
        kind, line = raw[y * (width * step + 1)], bytearray(raw[y * (width * step + 1) + 1:(y + 1) * (width * step + 1)])
        for i, byte in enumerate(line):
            left, corner = (line[i - step], row[i - step]) if i >= step else (0, 0)
            up = row[i]
            nearest = min((left, up, corner), key=lambda one, sum_=left + up - corner: abs(sum_ - one))
            line[i] = (byte + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
        row = line
        pixels += b"".join(line[i:i + 3] for i in range(0, len(line), step))
    return (width, height), bytes(pixels)


SMALL = ["--set", "blue1.sensors.camera.width=200", "--set", "blue1.sensors.camera.height=150"]


class Cameras(unittest.TestCase):
    """No software in the scene reads this camera."""
    words = ["three_on_three", *SMALL, "--duration", "0.5", "--json", "-"]

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "seen.png")
            words = [PROGRAM, "render", *cls.words[:-4], "--time", "0.5", "--camera", "blue1.camera", "--out", file]
            subprocess.run(words, capture_output=True, check=True)
            cls.rendered = read_png(file.read_bytes())
        alone = subprocess.run([PROGRAM, "run", *cls.words], capture_output=True, check=True, text=True)
        cls.state_hash = json.loads(alone.stdout)["state_hash"]

    def camera_channels(self, viewer):
        """By topic."""
        return {one["topic"]: one for one in viewer.wait_for(
            lambda m: isinstance(m, dict) and m["op"] == "advertise" and any(
                one["topic"].startswith("/cameras/") for one in m["channels"]))["channels"]}

    def assert_rendered(self, picture):
        self.assertEqual(picture[0], self.rendered[0])
        differences = [abs(a - b) for a, b in zip(picture[1], self.rendered[1], strict=True)]
        self.assertLess(sum(differences) / len(differences), 0.1, "of 255")
        self.assertLess(sum(one > 8 for one in differences), 0.001 * len(differences))

    def test_page_sees_any_camera_and_changes_nothing(self):
        with Run(PROGRAM, *self.words) as run:
            client = Client(run.port)
            client.order(do="camera", camera="blue1.camera", id=1)
            self.assertNotIn("error", client.answer(1))
            note = client.wait_for(lambda m: isinstance(m, dict) and m["is"] == "camera")
            self.assertEqual(note, {"is": "camera", "camera": "blue1.camera", "own": False, "trouble": ""})
            client.wait_for(is_picture)
            client.state(lambda state: state["paused"])
            late = Client(run.port)
            late.order(do="camera", camera="blue1.camera", id=1)
            late.wait_for(is_picture)
            time.sleep(1)  # the last picture is of the end
            late.order(do="camera", camera=None, id=2)
            late.answer(2)
            late.order(do="camera", camera="blue1.camera", id=3)
            self.assert_rendered(pixels_of(late.wait_for(is_picture)))
            client.order(do="camera", camera="blue1.camra", id=2)
            self.assertIn("did you mean 'blue1.camera'", client.answer(2)["error"])
            code, output = run.stop()
        self.assertEqual((code, json.loads(output)["state_hash"]), (0, self.state_hash))

    def test_no_picture_comes_when_nobody_looks(self):
        with Run(PROGRAM, "three_on_three", *SMALL, "--duration", "600") as run:
            client = Client(run.port)
            client.order(do="camera", camera="blue1.camera", id=1)
            for _ in range(3):
                client.wait_for(is_picture)
            client.order(do="camera", camera=None, id=2)
            client.answer(2)
            answered = time.monotonic()
            while time.monotonic() < answered + 1.5:
                message = client.wait_for(lambda m: True)
                if time.monotonic() > answered + 0.3:  # one may have been on its way
                    self.assertFalse(is_picture(message))

    def test_foxglove_sees_any_camera(self):
        with Run(PROGRAM, *self.words) as run:
            viewer = Client(run.port, protocol="foxglove.sdk.v1")
            topics = self.camera_channels(viewer)
            self.assertEqual(topics["/cameras/blue1/camera/image"]["schemaName"], "foxglove.CompressedImage")
            page = Client(run.port)
            page.state(lambda state: state["paused"])
            viewer.order(op="subscribe", subscriptions=[
                {"id": number, "channelId": topics[f"/cameras/blue1/camera/{what}"]["id"]}
                for number, what in ((5, "image"), (6, "calibration"))])

            came = {}
            while len(came) < 2:  # in any order
                message = viewer.wait_for(lambda m: isinstance(m, bytes) and m[0] == 1)
                came[int.from_bytes(message[1:5], "little")] = message
            self.assertIn(b"blue1/camera/optical", came[6])
            self.assert_rendered(read_png(came[5][came[5].index(b"\x89PNG"):]))
            code, output = run.stop()
        self.assertEqual((code, json.loads(output)["state_hash"]), (0, self.state_hash))

    def test_recordings_are_looked_at_through_cameras_too(self):
        with tempfile.TemporaryDirectory() as folder:
            file = str(Path(folder, "game.mcap"))
            subprocess.run([PROGRAM, "run", *self.words[:-2], "--record", file], capture_output=True, check=True)
            with Run(PROGRAM, file, command="replay") as replay:
                client = Client(replay.port)
                client.state(lambda state: state["paused"] and state["time"] == 0.5)
                client.order(do="camera", camera="blue1.camera", id=1)
                self.assert_rendered(pixels_of(client.wait_for(is_picture)))

    def test_cameras_need_no_driver(self):
        with Run(PROGRAM, *self.words, **{"__EGL_VENDOR_LIBRARY_FILENAMES": "/dev/null"}) as run:
            client = Client(run.port)
            client.state(lambda state: state["paused"])
            client.order(do="camera", camera="blue1.camera", id=1)
            self.assert_rendered(pixels_of(client.wait_for(is_picture)))


class Clients(unittest.TestCase):
    def test_nonsense_ends_only_who_says_it(self):
        with Run(PROGRAM, "walk", "--duration", "600") as run:
            good = Client(run.port)
            good.poses()
            nonsense = ["no json", "[1,2]", '{"do":7}', '{"do":"fly"}', '{"do":"seek","time":"x"}', '{"do":"seek","time":1e300}',
                        '{"do":"step"}', b"\x00\x01\x02", "x" * (2 << 20), '{"do":"speed"}',
                        "\ud83d".encode("utf-8", "surrogatepass")]
            for what in nonsense:
                bad = Client(run.port)
                bad.send(what)
                with self.assertRaises((ConnectionError, OSError)):
                    for _ in range(2000):
                        bad.receive()
                bad.close()
            for raw in (b"\x00" * 1000, b"GET\r\n\r\n", b"GET / HTTP/9.9\r\nHost\r\n\r\n", b"A" * 100_000):
                with socket.create_connection(("127.0.0.1", run.port), timeout=20) as wire:
                    try:
                        wire.sendall(raw)
                        wire.shutdown(socket.SHUT_WR)
                        while wire.recv(65536):
                            pass
                    except OSError:
                        pass
            frame = Client(run.port)
            frame.socket.sendall(b"\xff\xff" + b"\x00" * 64)  # reserved bits, an opcode that is none
            with self.assertRaises((ConnectionError, OSError)):
                for _ in range(2000):
                    frame.receive()
            before = time_of(good.poses())
            good.wait_for(lambda m: isinstance(m, bytes) and m[0] == 1 and time_of(m) > before + 0.05)
            self.assertIsNone(run.process.poll())

    def test_unknown_protocols_are_refused(self):
        with Run(PROGRAM, "walk") as run:
            for protocol in ("", "nosuch.v1"):
                with self.assertRaises((Refused, ConnectionError, OSError)):
                    Client(run.port, protocol=protocol).receive()

    def test_two_clients_see_the_same_and_one_may_come_again(self):
        with Run(PROGRAM, "three_on_three", "--duration", "600") as run:
            one, two = Client(run.port), Client(run.port)
            one.poses()
            two.poses()
            one.order(do="pause", id=1)
            one.answer(1)
            stands = two.state(lambda state: state["paused"])["time"]
            one.close()
            again = Client(run.port)
            # a client that comes while the run is paused sees it, too
            again.wait_for(lambda m: isinstance(m, bytes) and m[0] == 1 and time_of(m) == stands)
            two.order(do="go_on", id=1)
            again.state(lambda state: not state["paused"] and state["time"] > stands)

    def test_a_slow_client_gets_new_poses_and_stops_nobody(self):
        with Run(PROGRAM, "three_on_three", "--duration", "600") as run:
            slow, fast = Client(run.port, slow=True), Client(run.port)
            fast.poses()
            for _ in range(120):
                latest = time_of(fast.poses())
            seen = [m for m in (slow.receive() for _ in range(12)) if isinstance(m, bytes) and m[0] == 1]
            self.assertLessEqual(len(seen), 4, "it has not said that it has seen any")
            for _ in seen:
                slow.order(do="seen")
            self.assertGreaterEqual(time_of(slow.poses()), latest - 0.1, "the newest, not those that it has missed")


if __name__ == "__main__":
    unittest.main(verbosity=2)
