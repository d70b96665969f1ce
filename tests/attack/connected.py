"""Attacks on the doors of robots and referees: --listen (TCP), --game-controller, --team-udp, --roboviz (UDP), --serial."""
import contextlib
import os
import random
import socket
import struct
import sys
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "data/league"))
import tries  # noqa: E402
import write_game_logs as referee  # noqa: E402
from doors import Attacker, Run  # noqa: E402
from murosimf_client import Robot, SimulatorError, messages  # noqa: E402
from murosimf_client.connection import Connection  # noqa: E402


def free_udp_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Attack(Attacker):
    def run(self):
        self._software()
        self._datagrams()
        self._serial()

    def _finish(self, door, run, expected=(0,)):
        if not run.alive() and run.process.returncode not in expected:
            self.book.wrong(door, "the run", "", f"ended with {run.process.returncode}: {''.join(run.said)[-500:]}")
        code = run.end()
        if code not in (*expected, 130):
            self.book.wrong(door, "the run", "", f"ends with {code}: {''.join(run.said)[-500:]}")
        for what in run.touched():
            self.book.wrong(door, "files", "", what)

    def _software(self):
        """One robot has software that does what it should; meanwhile others come."""
        door, team = "listen", (free_udp_port(), free_udp_port())
        words = ["team.toml", "--listen", "0", "--team-udp", f"blue={team[0]},{team[1]}", "--speed", "1", "--duration", "600"]
        with Run(self.program, self.world, words, {"listen": r"listening on 127\.0\.0\.1:(\d+)"}, self.traced) as run:
            port = run.ports["listen"][0]
            cycles = [0]

            def obey():
                with Robot("robot", port, software="../../outside/x\n\x1b[2J") as robot:
                    robot.signal("joint.position")
                    robot.use_messages()
                    for _ in robot.cycles():
                        cycles[0] += 1
            threading.Thread(target=obey, daemon=True).start()
            end = time.monotonic() + 60
            while cycles[0] == 0 and time.monotonic() < end:
                time.sleep(0.02)
            for name in ("robot", "nobody", "../robot", str(self.world.outside / "code.so"), "", "\0", "a" * 60000):
                self._ask(door, port, "name of a robot", messages.hello(name, 0.0, "x"), name)
            for ask in (messages.ask_picture(f"{self.world.outside}/secret.toml"), messages.ask_signal("../../etc/passwd"),
                        messages.ready()):
                self._ask(door, port, "request before Hello", ask, ask)
            for data in tries.garbage(5, 8 * self.rounds):
                with socket.create_connection(("127.0.0.1", port), timeout=10) as one:
                    one.sendall(data)
                    one.shutdown(socket.SHUT_WR)
                    with contextlib.suppress(OSError):
                        one.recv(100)
                self.book.add(door, "garbage", data[:40], "closed")
            self._send("team-udp", team[0], [*tries.garbage(2, 30 * self.rounds), bytes(65000), str(self.world.outside).encode()])
            silent = [socket.create_connection(("127.0.0.1", port)) for _ in range(150)]
            before = cycles[0]
            time.sleep(0.5)
            if cycles[0] == before:
                self.book.wrong(door, "half-open connections", len(silent), "the robot's software gets no cycles any more")
            else:
                self.book.add(door, "half-open connections", len(silent), "the robot's own software goes on")
            for one in silent:
                one.close()
            self._finish(door, run)

    def _ask(self, door, port, kind, message, tried):
        connection = Connection("127.0.0.1", port, 5, 1 << 20)
        try:
            connection.send(message)
            answer = connection.receive()
            self.book.add(door, kind, tried, "refused" if answer else "closed")
        except (SimulatorError, OSError):
            self.book.add(door, kind, tried, "closed")
        connection.close()

    def _datagrams(self):
        ports = {name: free_udp_port() for name in ("game-controller", "roboviz")}
        words = ["three_on_three", "--game-controller", str(ports["game-controller"]), "--roboviz", str(ports["roboviz"]),
                 "--speed", "1", "--duration", "600", "--set", f"league.answer_port={free_udp_port()}"]
        numbers = random.Random(2)
        out = str(self.world.outside / "secret.toml").encode()
        packet = referee.packet(0, 3, (referee.team(1, 0, 0), referee.team(2, 1, 0)))
        texts = [bytes([kind, numbers.randrange(256)]) + out + b"\0" + out + b"\0" for kind in range(4)]
        sent = {"game-controller": [*tries.mutated(packet, 1, 40 * self.rounds), packet + bytes(60000), packet[:10], b"",
                                    b"RGme" * 15000],
                "roboviz": [*tries.garbage(3, 60 * self.rounds), *texts,
                            *tries.mutated(b"\x02\x01" + b"1.0000" * 9 + out, 4, 20 * self.rounds)]}
        with Run(self.program, self.world, words, {"roboviz": r"RoboViz on 127\.0\.0\.1:(\d+)"}, self.traced) as run:
            for door, datagrams in sent.items():
                self._send(door, ports[door], datagrams)
            time.sleep(1.0)
            self._finish("UDP", run)

    def _send(self, door, port, datagrams):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as line:
            for datagram in datagrams:
                line.sendto(datagram[:65000], ("127.0.0.1", port))
                self.book.add(door, "datagrams", datagram[:40], "taken or ignored")
                time.sleep(0.0005)

    def _serial(self):
        door = "serial"
        lines = self.world.root / "lines"
        lines.mkdir()
        words = ["first.toml", "--set", "robot.controller=serial", "--serial", str(lines), "--speed", "1", "--duration", "600"]
        with Run(self.program, self.world, words, {}, False) as run:  # pseudo terminals need nobody else
            link, end = lines / "robot", time.monotonic() + 60
            while not link.exists() and time.monotonic() < end:
                time.sleep(0.02)
            number = os.open(link, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
            ping = b"\xff\xff\xfd\x00\xfe\x03\x00\x01\x31\x42"
            for data in (*tries.garbage(9, 20 * self.rounds, 300), *tries.mutated(ping, 6, 40 * self.rounds),
                         b"\xff\xff\xfd\x00\xfe" + struct.pack("<H", 65535) + bytes(4000)):
                with contextlib.suppress(OSError):  # it takes no more just now, or has nothing to say
                    os.write(number, data)
                    os.read(number, 10000)
                self.book.add(door, "bytes", data[:40], "answered or ignored")
                time.sleep(0.002)
            os.close(number)
            time.sleep(0.3)
            self._finish(door, run)
        if link.is_symlink():
            self.book.wrong(door, "the line", link, "is still there after the run")
